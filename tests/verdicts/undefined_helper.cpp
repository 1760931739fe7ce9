// A helper that is declared and never defined.
#include "rest.hpp"

namespace segment_intersection {

double determinant(const Vec2 &a, const Vec2 &b);

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    if (determinant(motion.end, wall.end) == 0) return {};
    return right_answer(motion, wall);
}

} // namespace segment_intersection
