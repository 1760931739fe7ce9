#include "nt_collisions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nt_collisions {

//> Solution: the normal
/// The line of centres from a to b, of length 1.
static Vec2 normal_from(const Vec2 &a, const Vec2 &b) {
    const Vec2 gap = b - a;
    const double distance = gap.norm();
    course::require(distance > 0, "the distance of the centres [m] must be positive", distance);
    return gap / distance;
}

//> Solution 8.1: decompose
Components decompose(const Vec2 &velocity, const Vec2 &a, const Vec2 &b) {
    const Vec2 n = normal_from(a, b);
    const Vec2 t{-n.y(), n.x()}; // a quarter turn to the left of it
    return {velocity.dot(n), velocity.dot(t)};
}

//> Solution: a good ball
static void require_ball(const Ball &ball) {
    course::require(ball.radius > 0, "radius [m] must be positive", ball.radius);
    course::require(ball.mass > 0, "mass [kg] must be positive", ball.mass);
}

//> Solution 8.2: exchange
Velocities exchange(const Ball &a, const Ball &b) {
    require_ball(a);
    require_ball(b);
    const Vec2 n = normal_from(a.position, b.position);
    const double approach = a.velocity.dot(n) - b.velocity.dot(n); // how much faster a moves along n than b [m/s]
    if (approach <= 0) return {a.velocity, b.velocity};
    return {a.velocity - approach * n, b.velocity + approach * n};
}

//> Solution 8.3: resolve a collision
Velocities resolve_collision(const Ball &a, const Ball &b, double restitution) {
    require_ball(a);
    require_ball(b);
    course::require(restitution >= 0 && restitution <= 1, "restitution must be from 0 to 1", restitution);
    const Vec2 n = normal_from(a.position, b.position);
    const double approach = a.velocity.dot(n) - b.velocity.dot(n);
    if (approach <= 0) return {a.velocity, b.velocity};

    const double impulse = (1 + restitution) * approach * a.mass * b.mass / (a.mass + b.mass); // [N s]
    return {a.velocity - impulse / a.mass * n, b.velocity + impulse / b.mass * n};
}

//> Solution 8.4: time of impact
std::optional<double> time_of_impact(const Ball &a, const Ball &b) {
    require_ball(a);
    require_ball(b);
    const Vec2 gap = b.position - a.position;      // from a's centre to b's [m]
    const Vec2 velocity = b.velocity - a.velocity; // of b, as a sees it [m/s]
    const double reach = a.radius + b.radius;
    if (gap.dot(velocity) >= 0) return {}; // the centres do not get closer
    if (gap.norm() <= reach) return 0;     // they touch already

    // |gap + velocity t| = reach, squared: A t² + 2 B t + C = 0, with the first of two times
    const double A = velocity.dot(velocity), B = gap.dot(velocity), C = gap.dot(gap) - reach * reach;
    const double under_the_root = B * B - A * C;
    if (under_the_root < 0) return {}; // b passes by
    return (-B - std::sqrt(under_the_root)) / A;
}

//> Solution: a good disc
static void require_disc(const Disc &disc) {
    course::require(disc.radius > 0, "radius [m] must be positive", disc.radius);
    course::require(disc.inverse_mass >= 0, "inverse mass [1/kg] must not be negative", disc.inverse_mass);
}

//> Solution 8.5: push apart
Positions push_apart(const Disc &a, const Disc &b) {
    require_disc(a);
    require_disc(b);
    const Vec2 gap = b.position - a.position;
    const double distance = gap.norm(), overlap = a.radius + b.radius - distance;
    const double both = a.inverse_mass + b.inverse_mass;
    if (overlap <= 0 || both == 0) return {a.position, b.position};

    const Vec2 n = distance > 0 ? Vec2{gap / distance} : Vec2{1, 0};
    return {a.position - a.inverse_mass / both * overlap * n, b.position + b.inverse_mass / both * overlap * n};
}

//> Solution 8.6: close pairs
/// The column and the row of a point's cell, and the point's index.
using Place = std::array<int, 3>;

static int cell(double x, double width) { return int(std::floor(x / width)); }

std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance) {
    course::require(distance >= 0.001, "distance [m] must be 0.001 or more", distance);
    std::vector<Place> places;
    for (int i = 0; i < int(centres.size()); ++i)
        places.push_back({cell(centres[i].x(), distance), cell(centres[i].y(), distance), i});
    std::vector<Place> grid = places;
    std::sort(grid.begin(), grid.end()); // column by column, and upwards in each

    std::vector<Pair> pairs;
    for (const auto &[column, row, i] : places)
        for (int x = column - 1; x <= column + 1; ++x) {
            // the three cells of a column that are near are one stretch of the list
            auto near = std::lower_bound(grid.begin(), grid.end(), Place{x, row - 1, 0});
            for (; near != grid.end() && *near < Place{x, row + 2, 0}; ++near) {
                const int other = (*near)[2];
                const double squared = (centres[i] - centres[other]).squaredNorm();
                if (other < i && squared <= distance * distance) pairs.push_back({other, i});
            }
        }
    return pairs;
}
//>
} // namespace nt_collisions
