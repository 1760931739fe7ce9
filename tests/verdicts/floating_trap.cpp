// Turns floating-point traps on, and sets one off.
#include "rest.hpp"

#include <cfenv>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &) {
    feenableexcept(FE_DIVBYZERO);
    const double zero = motion.start.x() - motion.start.x();
    return LineIntersection{1 / zero, 0, motion.start};
}

} // namespace segment_intersection
