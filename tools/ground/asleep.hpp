#pragma once
// What /proc tells of a process that was started. Systems without it know of no children, and of nobody asleep.

#include <fstream>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace course {

/// Processes whose parent this one is by now.
inline std::vector<pid_t> children_of(pid_t process) {
    const std::string id = std::to_string(process);
    std::ifstream list{"/proc/" + id + "/task/" + id + "/children"};
    std::vector<pid_t> all;
    for (pid_t child = 0; list >> child;) all.push_back(child);
    return all;
}

/// Whether it neither computes nor waits for a core or a disk, at this moment.
inline bool is_asleep(pid_t process) {
    std::string line;
    std::getline(std::ifstream{"/proc/" + std::to_string(process) + "/stat"}, line);
    const std::size_t name_ends = line.rfind(") "); // see proc(5)
    return name_ends != line.npos && std::string_view{"STt"}.find(line[name_ends + 2]) != std::string_view::npos;
}

} // namespace course
