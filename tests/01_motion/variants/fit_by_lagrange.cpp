// 1.7: three parabolas, each zero at two of the samples
#include "motion.hpp"

namespace motion {

Motion fit_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require(first.t != second.t, "the times [s] must differ", first.t);
    course::require(second.t != third.t, "the times [s] must differ", second.t);
    course::require(third.t != first.t, "the times [s] must differ", third.t);
    Motion law{0, 0, 0};
    const auto add = [&](const Sample &here, double t_1, double t_2) {
        const double weight = here.x / ((here.t - t_1) * (here.t - t_2));
        law.x_0 += weight * t_1 * t_2;
        law.v_0 -= weight * (t_1 + t_2);
        law.a += 2 * weight;
    };
    add(first, second.t, third.t);
    add(second, third.t, first.t);
    add(third, first.t, second.t);
    return law;
}

} // namespace motion
