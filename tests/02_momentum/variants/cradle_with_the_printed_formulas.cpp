// 2.6: the two formulas of the text, in a loop that ends when no pair has collided
#include "momentum.hpp"

#include <cmath>

namespace momentum {

std::vector<double> newtons_cradle(const std::vector<Cart> &carts) {
    std::vector<double> m, v;
    for (std::size_t i = 0; i < carts.size(); i++) {
        course::require(carts[i].mass > 0, "mass [kg] must be positive", carts[i].mass);
        m.push_back(carts[i].mass);
        v.push_back(carts[i].velocity);
    }
    bool collided = true;
    while (collided) {
        collided = false;
        for (std::size_t i = 1; i < v.size() && !collided; i++) {
            if (v[i - 1] > v[i] + 1e-13 * std::abs(v[i])) {
                const double total = m[i - 1] + m[i];
                const double left = (2 * m[i] * v[i] + v[i - 1] * (m[i - 1] - m[i])) / total;
                const double right = (2 * m[i - 1] * v[i - 1] - v[i] * (m[i - 1] - m[i])) / total;
                v[i - 1] = left;
                v[i] = right;
                collided = true;
            }
        }
    }
    return v;
}

} // namespace momentum
