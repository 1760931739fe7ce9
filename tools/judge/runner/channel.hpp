#pragma once
// How a call leaves the tests: what an exercise is, and who answers for it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// What a COURSE_EXERCISE line says, and how to read the bytes of a call.
struct ExerciseLine {
    std::string_view section;   ///< the namespace
    std::string_view number;    ///< "7.2"
    std::string_view tier;      ///< core, stretch, challenge
    std::string_view function;  ///< the name
    std::string_view arguments; ///< names and units: "motion [m], wall [m]"
    std::string_view unit;      ///< of the result
    std::vector<std::string> (*describe_arguments)(const ExerciseLine &, std::string_view bytes);
    std::string (*describe_result)(const ExerciseLine &, std::string_view bytes);
    std::uint32_t index = 0; ///< the place in the section's header
};

/// Those of the section, in the order of the header.
inline std::vector<const ExerciseLine *> &exercise_lines() {
    static std::vector<const ExerciseLine *> all;
    return all;
}

/// Those of the sections that it builds on.
inline std::vector<const ExerciseLine *> &earlier_exercise_lines() {
    static std::vector<const ExerciseLine *> all;
    return all;
}

/// Makes the call in the student's code, wherever that runs, and gives back the bytes of the result, until the next call.
/// @throws NotYet, std::invalid_argument  as the student's code does
/// @throws CaseOver  if there will be no result; the verdict has been noted
std::string_view call(const ExerciseLine &exercise, std::string arguments);

/// Ends the running test case: the verdict stands. It is no std::exception, so that no test takes it for an answer.
struct CaseOver {};

/// The result's bytes were not a value of that type, or one of a size that no answer has.
[[noreturn]] void answered_nonsense(bool too_large = false);

/// The unit of the last call's answer, if these are its bytes.
std::optional<std::string_view> unit_of_answer(std::string_view bytes);

/// A check compares something else than the answer of the last call, and does not name it: the test's own mistake.
void refuse_nameless();

/// What differs, in the words of a verdict; see note_mismatch.
struct Mismatch {
    std::string label;           ///< what was compared: "sum of all velocities"; empty for the answer of the last call
    std::string yours, expected; ///< with the path to the field that differs: "point.x = 3 m"
    std::string tolerance;       ///< "1e-12", or empty where there is none
    bool not_a_number = false;
    std::string whole = {}; ///< all of the struct that is expected, where one field of it differs
    std::string since = {}; ///< how that is worked out: "1600 / 64 = 25 N"
    double off = 1;         ///< relative error of a number
};
void note_mismatch(const Mismatch &mismatch);

/// The student's code accepted input that it must refuse: the input, "dt is negative", or the name of one number and the
/// value that it had. The case goes on, and the verdict lists all of them.
void note_accepted(const std::string &input, const std::string &value = {});

/// The input of the running test case is large: working code may take so many seconds of computing, where others have
/// one. To be called before the exercise.
void allow(double seconds);

/// How many generated cases to run: `full` of them under `./course test`, a hundredth in a student's check.
int cases(int full);

} // namespace course
