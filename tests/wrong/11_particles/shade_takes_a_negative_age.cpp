// 11.2: before its start it shows shade 0
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life) return {};
    return std::min(int(age / life * shades), shades - 1);
}

} // namespace particles
