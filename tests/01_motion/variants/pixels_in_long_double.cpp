// 1.1: in long double
#include "motion.hpp"

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require(frames_per_second > 0, "frames_per_second must be positive", frames_per_second);
    return double(static_cast<long double>(px_per_frame) * frames_per_second);
}

} // namespace motion
