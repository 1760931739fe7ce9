#pragma once
#include "loop/catalogue.hpp"
#include "verdict/shared/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace course {

/// What was judged in one section, for a machine to read.
struct Report {
    Section section;
    std::string file; ///< that was judged
    unsigned seed = 0;
    std::vector<Exercise> exercises;
    std::vector<KnownTest> tests;   ///< each has its case in the report, whatever happened
    std::optional<Verdict> unbuilt; ///< why the file does not compile or link: then all tests fail of it
    std::vector<Verdict> verdicts;
};

/// The verdicts as JUnit has them: a suite for each section, a case for each test, whose class is the exercise.
std::string junit(const std::vector<Report> &reports);

} // namespace course
