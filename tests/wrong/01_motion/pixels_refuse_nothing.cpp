// 1.1: nothing is refused
#include "motion.hpp"

namespace motion {

double px_per_second(double px_per_frame, double frames_per_second) { return px_per_frame * frames_per_second; }

} // namespace motion
