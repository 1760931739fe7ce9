// 11.2: how many times does the time of one shade fit into the age?
#include "particles.hpp"

#include <algorithm>
#include <cmath>

namespace particles {

std::optional<int> shade_index(double age, double life, int shades) {
    if (age < 0 || life <= 0 || shades < 1) throw std::invalid_argument{"no such life"};
    if (age >= life) return std::nullopt;
    return int(std::min(std::floor(age / (life / shades)), shades - 1.0));
}

} // namespace particles
