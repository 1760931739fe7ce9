// 11.2: age times shades, then divided by life
#include "particles.hpp"

#include <cmath>

namespace particles {

std::optional<int> shade_index(double age, double life, int shades) {
    if (age < 0 || life <= 0 || shades < 1) throw std::invalid_argument{"no such life"};
    if (!(age < life)) return {};
    const double passed = std::floor(age * shades / life);
    return passed < shades ? int(passed) : shades - 1;
}

} // namespace particles
