// 1.1: the frames divided by the pixels
#include "motion.hpp"

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require_range(px_per_frame, frames_per_second);
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    return frames_per_second / px_per_frame;
}

} // namespace motion
