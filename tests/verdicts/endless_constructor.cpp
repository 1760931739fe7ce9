// A loop before main.
#include "rest.hpp"

namespace segment_intersection {

struct Slow {
    Slow() {
        for (volatile int i = 0; i < 10;) static_cast<void>(this);
    }
} slow;

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    return right_answer(motion, wall);
}

} // namespace segment_intersection
