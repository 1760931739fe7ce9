#pragma once
// How it went for a reader, as a text that may be sent to whoever writes the course: no code, no name, nothing of the machine.

#include "check/progress_store.hpp"

#include <map>
#include <string>
#include <vector>

namespace course {

/// A line for each exercise that was checked: how many checks, whether it's green by now, the minutes between the checks, how
/// many hints were open, and the mistakes that were named.
/// @param attempts  of each exercise in the order in which they were made
/// @param hints     how many are open, by the exercise's number
std::string feedback(const std::vector<Attempt> &attempts, const std::map<std::string, int> &hints,
                     const std::string &version);

} // namespace course
