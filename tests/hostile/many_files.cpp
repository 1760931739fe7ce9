// Fills the machine's memory with files that have no name, and threads.
#include "rest.hpp"

#include <cerrno>
#include <cstring>
#include <iostream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &, const Segment &) { return {}; }

} // namespace segment_intersection

namespace {

void tell(const char *what, bool done) {
    std::cout << what << ": " << (done ? "done" : std::strerror(errno)) << std::endl;
}

const bool tried = [] {
    tell("file in memory", ::memfd_create("much", 0) >= 0);
    rlimit more{1 << 20, 1 << 20};
    tell("more files", ::setrlimit(RLIMIT_NOFILE, &more) == 0);
    return true;
}();

} // namespace
