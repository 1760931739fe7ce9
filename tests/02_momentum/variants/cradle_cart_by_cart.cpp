// 2.6: each cart joins a row in which all collisions to its left are over
#include "momentum.hpp"

namespace momentum {

static void settle(const std::vector<Cart> &carts, std::vector<double> &velocities, std::size_t count) {
    if (count < 2) return;
    settle(carts, velocities, count - 1);
    const std::size_t a = count - 2, b = count - 1;
    while (velocities[a] - velocities[b] > 1e-12) { // more than rounding
        const double j =
            2 * (velocities[a] - velocities[b]) * carts[a].mass * carts[b].mass / (carts[a].mass + carts[b].mass);
        velocities[a] -= j / carts[a].mass;
        velocities[b] += j / carts[b].mass;
        settle(carts, velocities, count - 1);
    }
}

std::vector<double> newtons_cradle(const std::vector<Cart> &carts) {
    std::vector<double> velocities;
    for (const Cart &cart : carts) {
        course::require(cart.mass > 0, "mass [kg] must be positive", cart.mass);
        velocities.push_back(cart.velocity);
    }
    settle(carts, velocities, velocities.size());
    return velocities;
}

} // namespace momentum
