// Run by root it would give the machine a name and a time, take its memory on disk away, and stop it. What it asks for
// here changes nothing, should it be granted.
#include "rest.hpp"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <iostream>
#include <linux/capability.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &, const Segment &) { return {}; }

} // namespace segment_intersection

namespace {

void tell(const char *what, bool done) {
    std::cout << what << ": " << (done ? "done" : std::strerror(errno)) << std::endl;
}

bool has_capabilities() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct sets[_LINUX_CAPABILITY_U32S_3] = {};
    ::syscall(SYS_capget, &header, sets);
    for (const auto &set : sets)
        if ((set.effective | set.permitted | set.inheritable) != 0) return true;
    return false;
}

const bool tried = [] {
    utsname names{};
    ::uname(&names);
    timespec now{0, -1}; // no time at all
    std::cout << "capabilities: " << (has_capabilities() ? "some" : "none") << std::endl;
    tell("name", ::sethostname(names.nodename, std::strlen(names.nodename)) == 0);
    tell("time", ::syscall(SYS_clock_settime, CLOCK_REALTIME, &now) == 0);
    tell("swap", ::syscall(SYS_swapoff, nullptr) == 0);
    tell("stop", ::syscall(SYS_reboot, 1, 2, 3, nullptr) == 0); // without its magic numbers
    tell("module", ::syscall(SYS_init_module, nullptr, 0, "") == 0);
    return true;
}();

} // namespace
