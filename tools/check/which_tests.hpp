#pragma once
// Which tests judge a file, and with which ones it was handed out: in the same words wherever somebody may compare.

#include "base/workspace.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace course {

/// SHA-256 of what a section's tests are written in, 64 digits: the same on every machine, and in a handout.
std::string hash_of_tests(const Workspace &workspace, const Section &section);

struct WhichTests {
    std::string digits, version; ///< the first of that hash; of the course: "5f3a2b1c9d0e", "0.9.0"
};
WhichTests which_tests(const std::string &hash, const std::string &version);

/// "version 0.9.0 of the course, tests 5f3a2b1c9d0e"
std::string words_for(const WhichTests &tests);

/// The last line of an exercise's file in a handout, with its end: "// Handed out with tests 5f3a2b1c9d0e (0.9.0)."
std::string stamp_of(const WhichTests &tests);

/// What the last of such lines says. A student may have changed it: in any other form it's none.
std::optional<WhichTests> stamp_in(std::string_view text);

/// Without that line, if it's the last one of all.
std::string without_stamp(std::string text);

} // namespace course
