// Writes to another exercise of the student, to the program with the tests, and to where everybody may write.
#include "rest.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &, const Segment &) { return {}; }

} // namespace segment_intersection

namespace {

void tell(const char *what, bool done) {
    std::cout << what << ": " << (done ? "done" : std::strerror(errno)) << std::endl;
}

const bool tried = [] {
    char self[4096] = {};
    if (::readlink("/proc/self/exe", self, sizeof self - 1) < 0) return false;
    const std::string path = self, build = path.substr(0, path.rfind("/loop/")), root = build + "/../..";
    tell("exercise", ::open((root + "/exercises/01_motion.cpp").c_str(), O_WRONLY | O_APPEND) >= 0);
    tell("list of tests", ::open((build + "/catalogue/07_segment_intersection.json").c_str(), O_WRONLY) >= 0);
    tell("mode", ::chmod((build + "/tests/07_segment_intersection").c_str(), 0) == 0);
    tell("/tmp", ::open("/tmp/written-by-an-exercise", O_CREAT | O_WRONLY, 0644) >= 0);
    return true;
}();

} // namespace
