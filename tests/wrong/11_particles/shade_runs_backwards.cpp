// 11.2: from the last shade to the first
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life) return {};
    return shades - 1 - std::min(int(age / life * shades), shades - 1);
}

} // namespace particles
