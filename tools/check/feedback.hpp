#pragma once
// How it went for a reader, as a text that may be sent to whoever writes the course: no code, no name, nothing of the machine.

#include <map>
#include <string>
#include <vector>

namespace course {

/// One check of one exercise.
struct Attempt {
    std::string number;    ///< "7.2"
    std::string state;     ///< as in ExerciseState of check/progress_store.hpp
    std::string mistake{}; ///< what the reader did, as the verdict said; "" if it named nothing
    std::string when{};    ///< UTC, "2026-11-21T10:04:55Z"
};

/// A line for each exercise that was checked: how many checks, whether it's green by now, the minutes between the checks, how
/// many hints were open, and the mistakes that were named.
/// @param attempts  of each exercise in the order in which they were made
/// @param hints     how many are open, by the exercise's number
std::string feedback(const std::vector<Attempt> &attempts, const std::map<std::string, int> &hints,
                     const std::string &version);

} // namespace course
