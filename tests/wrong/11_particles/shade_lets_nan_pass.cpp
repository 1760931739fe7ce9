// 11.2: "not a number" is compared, which is always false, and so it lives
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<int> shade(double age, double life, int shades) {
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age < 0 || life <= 0) throw std::invalid_argument{"age or life"};
    if (age >= life) return {};
    return std::min(int(age / life * shades), shades - 1);
}

} // namespace particles
