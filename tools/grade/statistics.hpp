#pragma once
// Statistics of a class: how points are spread, how each test went, and who is wrong alike.

#include "grade/graded.hpp"

#include <optional>
#include <string>
#include <vector>

namespace course {

/// A quarter of the class has `lower` points or less, half of it the median or less, a quarter `upper` or more.
struct Quartiles {
    double lower = 0, median = 0, upper = 0;
};
/// Nothing of nobody. What lies between two students is on the line between them.
std::optional<Quartiles> quartiles(std::vector<double> points);

/// Whether the instructor has taken a test out of the grade.
bool is_void(const GradedClass &graded, const std::string &claim);

/// The verdict that says most about a wrong exercise: the first red one of a test that counts. One on a function that's
/// not started comes last, since it says nothing else. Null if there is none.
const Verdict *telling_verdict(const GradedClass &graded, const GradedExercise &exercise);

/// The words that are most frequent.
struct MostCommon {
    std::string words;
    std::size_t times = 0;
};

/// How a test went, among all students who were judged.
struct TestOfClass {
    KnownTest test;
    bool is_void = false;
    std::size_t judged = 0, answered = 0, passed = 0; ///< answered: started, and it compiles
    MostCommon failure;                               ///< of those who answered
};
std::vector<TestOfClass> how_tests_went(const GradedClass &graded);

/// The most frequent of known mistakes in this exercise.
MostCommon commonest_mistake(const GradedClass &graded, const std::string &exercise);

/// Students with functions that give the same wrong values.
struct Alike {
    Exercise exercise;
    std::vector<std::string> ids;
    std::size_t failed = 0;    ///< tests of it
    Verdict verdict;           ///< the one that says most
    std::string mistake;       ///< if it's a known one
    bool is_same_file = false; ///< byte for byte
};
/// Groups of at least two, the largest first. A value that is 0 or false comes out of everything that computes nothing,
/// so it makes no group, and neither does an exercise that's wrong because of another.
std::vector<Alike> equal_wrong_answers(const GradedClass &graded);

} // namespace course
