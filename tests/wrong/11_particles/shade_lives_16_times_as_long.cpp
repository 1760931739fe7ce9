// 11.2: life is the time of one shade, as in the source: 1440 frames in place of 90
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life * shades) return {};
    return std::min(int(age / life), shades - 1);
}

} // namespace particles
