#pragma once
#include "judge/protocol/verdict.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace course {

/// What came of judging a file.
struct JudgeResult {
    std::optional<Verdict> unbuilt;    ///< why the file does not compile or link; then no test ran
    std::vector<Verdict> verdicts;     ///< exactly one for each test that was asked for, in the order of their file
    std::vector<std::string> warnings; ///< of the compiler: "exercises/07_….cpp:12: unused variable 'x'"

    bool all_passed() const { return !unbuilt && !verdicts.empty() && std::ranges::all_of(verdicts, &Verdict::passed); }
    bool our_fault() const { ///< a test has no verdict
        return std::ranges::any_of(verdicts, [](const Verdict &v) { return v.kind == Outcome::no_verdict; });
    }
};

} // namespace course
