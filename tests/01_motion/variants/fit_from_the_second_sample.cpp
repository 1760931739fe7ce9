// 1.7: everything measured from the second sample, and then moved to t = 0
#include "motion.hpp"

namespace motion {

Motion fit_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require(first.t != second.t, "the times [s] must differ", first.t);
    course::require(second.t != third.t, "the times [s] must differ", second.t);
    course::require(third.t != first.t, "the times [s] must differ", third.t);
    const double before = first.t - second.t, after = third.t - second.t;
    const double v_before = (first.x - second.x) / before, v_after = (third.x - second.x) / after;
    const double a = 2 * (v_after - v_before) / (after - before);
    const double v = v_before - a * before / 2; // at the second look
    return {second.x - v * second.t + a * second.t * second.t / 2, v - a * second.t, a};
}

} // namespace motion
