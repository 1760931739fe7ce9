// 11.2: nothing keeps a rounding from shade number 16 of 16
#include "particles.hpp"

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life) return {};
    return int(age * shades / life);
}

} // namespace particles
