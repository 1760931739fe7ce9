// 1.7: three equations, solved as a matrix
#include "motion.hpp"

#include <Eigen/LU>

namespace motion {

Motion fit_motion(const Sample &first, const Sample &second, const Sample &third) {
    course::require(first.t != second.t, "the times [s] must differ", first.t);
    course::require(second.t != third.t, "the times [s] must differ", second.t);
    course::require(third.t != first.t, "the times [s] must differ", third.t);
    Eigen::Matrix3d m;
    m << 1, first.t, first.t * first.t / 2, 1, second.t, second.t * second.t / 2, 1, third.t, third.t * third.t / 2;
    const Eigen::Vector3d law = m.partialPivLu().solve(Eigen::Vector3d{first.x, second.x, third.x});
    return {law[0], law[1], law[2]};
}

} // namespace motion
