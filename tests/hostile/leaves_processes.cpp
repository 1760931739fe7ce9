// Starts daemons, and fails its tests: they must be gone, whether a test has passed or not.
#include "rest.hpp"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <unistd.h>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &, const Segment &) { return {}; }

} // namespace segment_intersection

namespace {

void tell(const char *what, bool done) {
    std::cout << what << ": " << (done ? "done" : std::strerror(errno)) << std::endl;
}

const bool tried = [] {
    for (int i = 0; i < 3; ++i)
        if (::fork() == 0) {
            ::setsid();
            if (::fork() != 0) ::_exit(0);
            for (int file = 0; file < 100; ++file) ::close(file);
            ::sleep(1000);
        }
    tell("vfork", ::vfork() == 0 ? (::_exit(0), true) : errno == 0);
    tell("session", ::setsid() > 0);
    return true;
}();

} // namespace
