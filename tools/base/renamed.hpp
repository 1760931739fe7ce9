#pragma once
// Names that a section had before: chapters/NN_slug/renamed.txt, a line `old new` for each; # begins a comment.

#include <string>
#include <string_view>
#include <vector>

namespace course {

struct Renamed {
    std::string before, now; ///< `now` is empty unless the line holds exactly two names
    int line = 0;            ///< from 1
};

/// What is in the text of a renamed.txt.
std::vector<Renamed> read_renamed(std::string_view text);

/// The new names of those of these names that are old ones, as one sentence; "" if none is.
std::string explain_renamed(const std::vector<std::string> &names, const std::vector<Renamed> &renamed);

} // namespace course
