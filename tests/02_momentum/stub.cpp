// Section 2, Momentum. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 2
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "momentum.hpp"

#include <algorithm>
#include <cmath>

namespace momentum {

// 2.1 core
Vec2 acceleration_due_to(const std::vector<Vec2> &forces, double mass) {
    course::require(mass > 0, "mass [kg] must be positive", mass);
    throw course::NotYet{"add up all forces in a loop; what does the sum do to 1 kg, and to 2 kg?"};
}

static void require_cart(const Cart &cart) { course::require(cart.mass > 0, "mass [kg] must be positive", cart.mass); }

// 2.2 core
Velocities elastic_collision(const Cart &a, const Cart &b) {
    require_cart(a);
    require_cart(b);
    throw course::NotYet{"at which velocity do both move while they are squeezed together most? And then?"};
}

// 2.3 core
Velocities collide(const Cart &a, const Cart &b, double restitution) {
    require_cart(a);
    require_cart(b);
    course::require(0 <= restitution && restitution <= 1, "restitution must be from 0 to 1", restitution);
    throw course::NotYet{
        "squeezed together, both have the same velocity; how hard do they push each other apart then?"};
}

// 2.4 stretch
CentreOfMassFrame centre_of_mass_frame(const Cart &a, const Cart &b) {
    require_cart(a);
    require_cart(b);
    throw course::NotYet{"how fast is the centre of mass, and how fast is each cart, seen from there?"};
}

// 2.5 stretch
double impulse(const Body &a, const Body &b, double restitution) {
    for (const Body &body : {a, b})
        course::require(body.inverse_mass >= 0, "inverse mass [1/kg] must not be negative", body.inverse_mass);
    course::require(0 <= restitution && restitution <= 1, "restitution must be from 0 to 1", restitution);
    throw course::NotYet{"by how much does an impulse of 1 N s change the velocity of a, of b, and their difference?"};
}

// 2.6 challenge
std::vector<double> newtons_cradle(const std::vector<Cart> &carts) {
    for (const Cart &cart : carts) require_cart(cart);
    throw course::NotYet{
        "which neighbours approach each other? Let the leftmost of these pairs collide, and look again"};
}

} // namespace momentum
