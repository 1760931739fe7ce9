// 1.1: what runs to the left is refused
#include "motion.hpp"

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) {
    course::require_range(px_per_frame, frames_per_second);
    course::require(px_per_frame >= 0 && frames_per_second > 0, "both must be positive", px_per_frame);
    return px_per_frame * frames_per_second;
}

} // namespace motion
