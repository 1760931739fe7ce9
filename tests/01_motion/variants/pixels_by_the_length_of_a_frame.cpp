// 1.1: divided by the length of a frame
#include "motion.hpp"

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    const double seconds_per_frame = 1 / frames_per_second;
    return px_per_frame / seconds_per_frame;
}

} // namespace motion
