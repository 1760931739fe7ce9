// 7.2: yes, whatever is asked
#include "segment_intersection.hpp"

namespace segment_intersection {

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    return true;
}

} // namespace segment_intersection
