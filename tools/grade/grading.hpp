#pragma once
// One submission's verdicts, and what makes them fair: a function that doesn't compile costs no other one its points, and
// one that only calls a wrong one is told so.

#include "check/judge.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace course {

/// What comes out for one file.
struct Outcomes {
    std::optional<Verdict> unbuilt = {};         ///< why nothing of the file can be judged
    std::vector<Verdict> verdicts = {};          ///< else one for each test, in the order of the file
    std::vector<Verdict> taken_out = {};         ///< why functions that are no exercise's: `main`, a broken helper
    std::map<std::string, Verdict> without = {}; ///< functions that don't compile, by exercise, each with why
    std::map<std::string, std::string> because_of = {}; ///< "5.6" -> "5.4": right with ours in the place of the other
    std::string our_trouble =
        {}; ///< why there's no verdict, or one that doesn't count: the grader's or the machine's fault
};

/// Judges a file as `check` does. If it doesn't compile because of a function of an exercise, it's judged without that
/// one, and without a `main`; a helper that doesn't compile throws instead. A function that fails is judged with
/// ours instead of those that it calls, and that fail as well.
/// @param name  by which the student knows the file
Outcomes outcomes_of(const Workspace &workspace, const Section &section, const std::string &name,
                     const std::string &text, unsigned seed);

/// The same as text, and back; nothing if it's cut off or of another form.
std::string to_text(const Outcomes &outcomes);
std::optional<Outcomes> outcomes_from(const std::string &text);

} // namespace course
