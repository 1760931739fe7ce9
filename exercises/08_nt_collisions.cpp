// Section 8, n–t collisions. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 8
// The lines above each `throw` refuse numbers that make no sense; leave them as they are.

#include "nt_collisions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nt_collisions {

static void require_centres(const Vec2 &a, const Vec2 &b) {
    const double distance = (b - a).norm();
    course::require(distance > 0, "the distance of the centres [m] must be positive", distance);
}

// 8.1 core
Components decompose(const Vec2 &velocity, const Vec2 &a, const Vec2 &b) {
    require_centres(a, b);
    throw course::NotYet{"which way does the line from a to b point, as a vector of length 1?"};
}

static void require_ball(const Ball &ball) {
    course::require(ball.radius > 0, "radius [m] must be positive", ball.radius);
    course::require(ball.mass > 0, "mass [kg] must be positive", ball.mass);
}

static void require_two_balls(const Ball &a, const Ball &b) {
    require_ball(a);
    require_ball(b);
    require_centres(a.position, b.position);
}

// 8.2 core
Velocities exchange(const Ball &a, const Ball &b) {
    require_two_balls(a, b);
    throw course::NotYet{"how fast does each ball move along the line of centres?"};
}

// 8.3 core
Velocities resolve_collision(const Ball &a, const Ball &b, double restitution) {
    require_two_balls(a, b);
    course::require(restitution >= 0 && restitution <= 1, "restitution must be from 0 to 1", restitution);
    throw course::NotYet{"how fast do the balls approach each other, along the line of centres?"};
}

// 8.4 stretch
std::optional<double> time_of_impact(const Ball &a, const Ball &b) {
    require_ball(a);
    require_ball(b);
    throw course::NotYet{"where is b, and how fast does it move, as a sees it?"};
}

static void require_disc(const Disc &disc) {
    course::require(disc.radius > 0, "radius [m] must be positive", disc.radius);
    course::require(disc.inverse_mass >= 0, "inverse mass [1/kg] must not be negative", disc.inverse_mass);
}

// 8.5 stretch
Positions push_apart(const Disc &a, const Disc &b) {
    require_disc(a);
    require_disc(b);
    throw course::NotYet{"how many metres do the discs overlap?"};
}

// 8.6 challenge
std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance) {
    course::require(distance >= 0.001, "distance [m] must be 0.001 or more", distance);
    throw course::NotYet{"in which cell of the grid is each point, and in which cells can its neighbours be?"};
}

} // namespace nt_collisions
