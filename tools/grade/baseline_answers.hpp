#pragma once
// Answers that compute nothing, and pass some tests all the same: points begin above what they earn.

#include "base/workspace.hpp"
#include "check/catalogue.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace course {

/// A whole file of such answers: the stub, where each function ends with `return {};`, say, as far as that compiles.
struct Trivial {
    std::string name; ///< "return {}"
    std::string text;
};
std::vector<Trivial> trivial_answers(const Workspace &workspace, const Section &section);

/// Which tests each trivial answer passes, by exercise: their places among the tests of the exercise, from 1.
using Baselines = std::map<std::string, std::set<std::vector<std::size_t>>>;

/// What comes out of them today. @throws UserError if one can't be judged
Baselines measure_baselines(const Workspace &workspace, const Section &section, unsigned seed = 2026);

} // namespace course
