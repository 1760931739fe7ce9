// 7.2: only the boxes are asked, so near misses count as hits
// It is how the chapter begins: boxes part most segments. They prove nothing for those that they do not part.
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    for (const int axis : {0, 1}) {
        const auto [low_1, high_1] = std::minmax({first.start[axis], first.end[axis]});
        const auto [low_2, high_2] = std::minmax({second.start[axis], second.end[axis]});
        if (high_1 < low_2 || high_2 < low_1) return false;
    }
    return true;
}

} // namespace segment_intersection
