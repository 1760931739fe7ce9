// 1.7: the second difference, as if the looks were a second apart
#include "motion.hpp"

namespace motion {

Law law_of_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require_range(first.t, first.x, second.t, second.x, third.t, third.x);
    course::require(first.t != second.t, "the times [s] must differ", first.t);
    course::require(second.t != third.t, "the times [s] must differ", second.t);
    course::require(third.t != first.t, "the times [s] must differ", third.t);
    const double a = (third.x - second.x) - (second.x - first.x);
    const double v_0 = second.x - first.x - a * (first.t + second.t) / 2;
    return {first.x - first.t * (v_0 + a * first.t / 2), v_0, a};
}

} // namespace motion
