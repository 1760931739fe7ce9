// A function of the same name, for other things.
#include "rest.hpp"

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Vec2 &motion, const Vec2 &wall) { return right_answer({motion, wall}, {wall, motion}); }

} // namespace segment_intersection
