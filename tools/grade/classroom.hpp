#pragma once
// GitHub Classroom: what its students' repositories need, so that a push shows them their points.

#include "check/catalogue.hpp"
#include "grade/points.hpp"

#include <string>
#include <vector>

namespace course {

/// A workflow that checks each exercise by itself, by the tests of the repository that was handed out.
/// @param handed_out  that repository on GitHub: "owner/name"
/// @throws UserError if that's no name of a repository
std::string classroom_workflow(const Section &section, const std::vector<Exercise> &exercises, const Worth &worth,
                               const std::string &handed_out);

/// What HANDOUT.md says more to a class on GitHub.
std::string classroom_notes(const Section &section);

} // namespace course
