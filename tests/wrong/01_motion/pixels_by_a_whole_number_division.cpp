// 1.1: a frame takes 1 / frames of a second, in whole numbers: 0
#include "motion.hpp"

#include <algorithm>

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require_range(px_per_frame, frames_per_second);
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    return px_per_frame / std::max(1, 1 / int(frames_per_second + 1));
}

} // namespace motion
