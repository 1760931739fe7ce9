// 11.2: rounded to the nearest: the first and the last shade are shown for half of their time
#include "particles.hpp"

#include <algorithm>
#include <cmath>

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life) return {};
    return std::min(int(std::lround(age / life * shades)), shades - 1);
}

} // namespace particles
