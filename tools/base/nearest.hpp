#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// How many letters must be put in, left out, changed, or swapped with their neighbour, to make one word the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that needs the fewest changes, whatever the case of its letters; the earlier one of two. Empty if
/// there is none, or none has anything in common with the word.
std::string nearest(std::string_view word, const std::vector<std::string> &candidates);

/// " Did you mean `list`?", or nothing if no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string> &candidates);

} // namespace course
