#pragma once
// Bugs to hunt: mutants, each put into a file of its own, for the student to find and mend.

#include "base/workspace.hpp"

#include <string>
#include <vector>

namespace course {

/// One of them, as tests/bugs.txt has it.
struct Bug {
    std::string exercise = {};            ///< "8.3"
    std::string name = {};                ///< of the wrong answer
    std::string broken = {};              ///< a law: the name of a test that is red with it
    std::string place = {};               ///< how the demo begins where the bug is seen; "": as at the exercise
    std::vector<std::string> laws = {};   ///< those to choose from, by name: `broken`, and others that stay green
    std::vector<std::string> others = {}; ///< wrong answers that it could be, too, for the site
};

/// Those of a section, from obvious to mean.
/// @throws UserError if this course is one without our answers
std::vector<Bug> bugs_of(const Workspace &workspace, const Section &section);

/// A bug with all that a file needs to be compiled.
struct BuggyCode {
    std::string text;  ///< the section's header, helpers that are called, and the function itself
    std::string claim; ///< what somebody did who made this mistake: "you divide by the other ball's mass"
};

/// What somebody may have done who made this mistake, by the alphabet: "you divide by the other ball's mass".
struct Causes {
    std::vector<std::string> all;
    std::size_t right = 0; ///< which of them it is
};
/// @throws std::runtime_error if there's no such wrong answer
Causes causes_of(const Workspace &workspace, const Section &section, const Bug &bug);

/// @throws std::runtime_error if there's no such wrong answer, or it doesn't fit the solution
BuggyCode code_of(const Workspace &workspace, const Section &section, const Bug &bug);

} // namespace course
