// 11.2: seven digits: a border comes too early, and two thousand million shades are not told apart
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life) return {};
    return std::min(int(std::min(float(age) / float(life) * float(shades), 2e9f)), shades - 1);
}

} // namespace particles
