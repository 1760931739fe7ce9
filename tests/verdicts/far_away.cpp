// Reads what lies gigabytes away from its own memory.
#include "rest.hpp"

#include <memory>

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &) {
    const auto numbers = std::make_unique<double[]>(4);
    volatile long far = 1L << 34;
    return LineIntersection{numbers[static_cast<std::size_t>(far)], 0, motion.start};
}

} // namespace segment_intersection
