// 1.1: no frames a second are not refused
#include "motion.hpp"

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require_range(px_per_frame, frames_per_second);
    course::require(frames_per_second >= 0, "frames_per_second must not be negative", frames_per_second);
    return px_per_frame * frames_per_second;
}

} // namespace motion
