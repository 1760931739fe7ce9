// 1.7: equal times: infinity
#include "motion.hpp"

namespace motion {

Law law_of_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require_range(first.t, first.x, second.t, second.x, third.t, third.x);
    const double v_12 = (second.x - first.x) / (second.t - first.t);
    const double v_23 = (third.x - second.x) / (third.t - second.t);
    const double a = 2 * (v_23 - v_12) / (third.t - first.t);
    const double v_0 = v_12 - a * (first.t + second.t) / 2;
    return {first.x - first.t * (v_0 + a * first.t / 2), v_0, a};
}

} // namespace motion
