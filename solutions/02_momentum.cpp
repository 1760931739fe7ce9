#include "momentum.hpp"

#include <algorithm>
#include <cmath>

namespace momentum {

//> Solution 2.1: net force, and acceleration
Vec2 acceleration_due_to(const std::vector<Vec2> &forces, double mass) {
    course::require(mass > 0, "mass [kg] must be positive", mass);
    Vec2 net_force{0, 0};
    for (const Vec2 &force : forces) net_force += force;
    return net_force / mass;
}

//> Solution: good carts
static void require_cart(const Cart &cart) { course::require(cart.mass > 0, "mass [kg] must be positive", cart.mass); }

//> Solution: their common velocity
/// The velocity of two carts while they are squeezed together most [m/s], and of their centre of mass at any time.
static double common_velocity(const Cart &a, const Cart &b) {
    return (a.mass * a.velocity + b.mass * b.velocity) / (a.mass + b.mass);
}

//> Solution 2.2: elastic collision
Velocities elastic_collision(const Cart &a, const Cart &b) {
    require_cart(a);
    require_cart(b);
    if (a.velocity <= b.velocity) return {a.velocity, b.velocity};
    const double common = common_velocity(a, b);
    return {common + (common - a.velocity), common + (common - b.velocity)};
}

//> Solution 2.3: collision with restitution
Velocities collide(const Cart &a, const Cart &b, double restitution) {
    require_cart(a);
    require_cart(b);
    course::require(0 <= restitution && restitution <= 1, "restitution must be from 0 to 1", restitution);
    if (a.velocity <= b.velocity) return {a.velocity, b.velocity};
    const double common = common_velocity(a, b);
    return {common + restitution * (common - a.velocity), common + restitution * (common - b.velocity)};
}

//> Solution 2.4: seen from the centre of mass
CentreOfMassFrame centre_of_mass_frame(const Cart &a, const Cart &b) {
    require_cart(a);
    require_cart(b);
    const double total = a.mass + b.mass, approach = a.velocity - b.velocity;
    const double seen_a = b.mass / total * approach, seen_b = -a.mass / total * approach;
    const double energy = (a.mass * seen_a * seen_a + b.mass * seen_b * seen_b) / 2;
    return {common_velocity(a, b), seen_a, seen_b, energy};
}

//> Solution 2.5: impulse
double impulse(const Body &a, const Body &b, double restitution) {
    for (const Body &body : {a, b})
        course::require(body.inverse_mass >= 0, "inverse mass [1/kg] must not be negative", body.inverse_mass);
    course::require(0 <= restitution && restitution <= 1, "restitution must be from 0 to 1", restitution);

    const double approach = a.velocity - b.velocity;         // [m/s]
    const double response = a.inverse_mass + b.inverse_mass; // how much of it each N s takes away [1/kg]
    if (approach <= 0 || response == 0) return 0;
    return (1 + restitution) * approach / response;
}

//> Solution 2.6: Newton's cradle
std::vector<double> newtons_cradle(const std::vector<Cart> &carts) {
    for (const Cart &cart : carts) require_cart(cart);
    double fastest = 0; // [m/s]
    for (const Cart &cart : carts) fastest = std::max(fastest, std::abs(cart.velocity));
    const double rounding = 1e-12 * fastest; // an approach as slow as that may be nothing but rounding

    std::vector<Cart> row = carts;
    for (std::size_t i = 0; i + 1 < row.size();) {
        if (row[i].velocity - row[i + 1].velocity <= rounding) {
            ++i; // this pair and all to its left have no reason to collide
            continue;
        }
        const Velocities after = elastic_collision(row[i], row[i + 1]);
        row[i].velocity = after.a;
        row[i + 1].velocity = after.b;
        if (i > 0) --i; // only the pair to its left can have become one that approaches
    }
    std::vector<double> velocities;
    for (const Cart &cart : row) velocities.push_back(cart.velocity);
    return velocities;
}
//>
} // namespace momentum
