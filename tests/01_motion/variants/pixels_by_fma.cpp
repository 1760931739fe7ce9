// 1.1: the same product, by fma
#include "motion.hpp"

#include <cmath>

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    return std::fma(px_per_frame, frames_per_second, 0.0);
}

} // namespace motion
