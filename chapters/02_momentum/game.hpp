#pragma once
// The game of this chapter, as it grows: carts on a rail. The program and the demo run it.
#include "../01_motion/motion.hpp"
#include "momentum.hpp"

namespace momentum {

//> A cart on the rail
/// A cart, and where it is.
struct RailCart {
    double x{}; ///< its middle [m]
    Cart cart;
};

//> The frame loop: a cart that is pulled
/// One frame of the game: these forces act on the cart for `dt` seconds. It stays on the rail.
inline void next_frame(RailCart &it, const std::vector<Vec2> &forces, double dt) {
    const Vec2 acceleration = acceleration_due_to(forces, it.cart.mass);
    const motion::State now{{it.x, 0}, {it.cart.velocity, 0}};
    const motion::State next = motion::accelerated_motion(now, acceleration, dt);
    it.x = next.position.x();
    it.cart.velocity = next.velocity.x();
}

//> The frame loop: two carts
constexpr double cart_length = 1; ///< [m]

/// One frame of the game: two carts roll for `dt` seconds, and when they touch, they collide.
inline void next_frame(RailCart &left, RailCart &right, double dt) {
    left.x += dt * left.cart.velocity;
    right.x += dt * right.cart.velocity;
    if (right.x - left.x > cart_length) return; // they don't touch
    const Velocities after = elastic_collision(left.cart, right.cart);
    left.cart.velocity = after.a;
    right.cart.velocity = after.b;
}

//> The frame loop: from rubber to clay
/// The same for carts of any material.
inline void next_frame(RailCart &left, RailCart &right, double restitution, double dt) {
    left.x += dt * left.cart.velocity;
    right.x += dt * right.cart.velocity;
    if (right.x - left.x > cart_length) return;
    const Velocities after = collide(left.cart, right.cart, restitution);
    left.cart.velocity = after.a;
    right.cart.velocity = after.b;
}

//> A body on the rail
/// A body on the rail, as long as a cart: a cart, or a wall.
struct RailBody {
    double x{}; ///< its middle [m]
    Body body;
};

//> Two neighbours
/// Two neighbours that approach each other push each other apart.
inline void push_apart(Body &left, Body &right, double restitution) {
    const double j = impulse(left, right, restitution);
    left.velocity -= j * left.inverse_mass;
    right.velocity += j * right.inverse_mass;
}

//> The frame loop: between walls
/// One frame of the game, for all bodies on the rail, from left to right.
inline void next_frame(std::vector<RailBody> &row, double restitution, double dt) {
    for (RailBody &it : row) it.x += dt * it.body.velocity;
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
        if (row[i + 1].x - row[i].x <= cart_length) push_apart(row[i].body, row[i + 1].body, restitution);
}

//> The frame loop: a row of carts
/// One frame of the game: all carts roll for `dt` seconds; then neighbours that touch collide, group by group.
inline void next_frame(std::vector<RailCart> &row, double dt) {
    for (RailCart &it : row) it.x += dt * it.cart.velocity;
    for (std::size_t first = 0, end = 0; first < row.size(); first = end) {
        std::vector<Cart> group{row[first].cart};
        for (end = first + 1; end < row.size() && row[end].x - row[end - 1].x <= cart_length; ++end)
            group.push_back(row[end].cart);
        const std::vector<double> after = newtons_cradle(group);
        for (std::size_t i = first; i < end; ++i) row[i].cart.velocity = after[i - first];
    }
}
//>
} // namespace momentum
