// 1.7: half the acceleration
#include "motion.hpp"

namespace motion {

Law law_of_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require_range(first.t, first.x, second.t, second.x, third.t, third.x);
    course::require(first.t != second.t, "the times [s] must differ", first.t);
    course::require(second.t != third.t, "the times [s] must differ", second.t);
    course::require(third.t != first.t, "the times [s] must differ", third.t);
    const double v_12 = (second.x - first.x) / (second.t - first.t);
    const double v_23 = (third.x - second.x) / (third.t - second.t);
    const double a = (v_23 - v_12) / (third.t - first.t);
    const double v_0 = v_12 - a * (first.t + second.t) / 2;
    return {first.x - first.t * (v_0 + a * first.t / 2), v_0, a};
}

} // namespace motion
