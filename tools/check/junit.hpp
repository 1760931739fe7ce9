#pragma once
#include "check/catalogue.hpp"
#include "judge/protocol/verdict.hpp"

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
    std::vector<std::pair<std::string, std::string>> also = {}; ///< further properties
};

std::string course_version(); ///< as `course --version` says it

/// The verdicts as JUnit has them: a suite for each section, a case for each test, whose class is the exercise.
std::string junit(const std::vector<Report> &reports);

/// What happened, in one line: as a test's message in such a file.
std::string in_one_line(const Verdict &verdict);

} // namespace course
