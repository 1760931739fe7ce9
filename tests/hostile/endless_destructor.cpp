// Never comes to an end: the destructor of a global variable would run when all is answered.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &, const Segment &) { return {}; }

} // namespace segment_intersection

namespace {

struct Endless {
    ~Endless() {
        for (;;) {}
    }
} endless;

} // namespace
