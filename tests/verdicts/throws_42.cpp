// An exception that is a number.
#include "rest.hpp"

namespace segment_intersection {

std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    throw 42;
}

} // namespace segment_intersection
