// 11.2: the last change of shade before this age, found by bisection
#include "particles.hpp"

namespace particles {

std::optional<int> shade_index(double age, double life, int shades) {
    if (age < 0 || life <= 0 || shades < 1) throw std::invalid_argument{"no such life"};
    if (age >= life) return {};
    int low = 0, high = shades; // it shows `low` or a later one, and none from `high` on
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        (life * (double(middle) / shades) <= age ? low : high) = middle;
    }
    return low;
}

} // namespace particles
