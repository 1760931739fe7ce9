#include "section_test.hpp"

#include "nt_collisions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using nt_collisions::Ball;
using nt_collisions::Components;
using nt_collisions::Disc;
using nt_collisions::Pair;
using nt_collisions::Positions;
using nt_collisions::Velocities;
using namespace nt_collisions::subject; // decompose, exchange, ... close_pairs: the student's

namespace {

/// Balls of 1 kg and a radius of 0.5 m, unless a test says otherwise.
Ball ball(const Vec2 &position, const Vec2 &velocity, double mass = 1) { return {position, velocity, 0.5, mass}; }

/// In the order of their indices.
std::vector<Pair> sorted(std::vector<Pair> pairs) {
    std::ranges::sort(pairs, {}, [](const Pair &pair) { return std::pair{pair.first, pair.second}; });
    return pairs;
}

} // namespace

// ------------------------------------------------------------------------------------------------------- 8.1 decompose

//> Worked example: two components
TEST_CASE("with b to the right of a by 0.8 m and above by 0.6 m, (5, 0) m/s is 4 along n and -3 along t", "[8.1]") {
    CHECK_THAT(decompose({5, 0}, {0, 0}, {0.8, 0.6}), IsNear(Components{4, -3}, rounding)); // 5 · 0.8, and 5 · -0.6
}

//> Side by side
TEST_CASE("with b to the right of a, the components are those along x and along y", "[8.1]") {
    CHECK_THAT(decompose({3, 2}, {0, 0}, {1, 0}), IsNear(Components{3, 2}, rounding));
    CHECK_THAT(decompose({3, 2}, {0, 0}, {0, 1}), IsNear(Components{2, -3}, rounding)); // b above a: left is -x
}

//> Any distance
TEST_CASE("how far apart the centres are does not matter", "[8.1]") {
    CHECK_THAT(decompose({5, 0}, {0, 0}, {4, 3}), IsNear(Components{4, -3}, rounding));     // five times as far
    CHECK_THAT(decompose({5, 0}, {0, 0}, {0.4, 0.3}), IsNear(Components{4, -3}, rounding)); // half as far
}

// -------------------------------------------------------------------------------------------------------- 8.2 exchange

//> Worked example: an equal ball at rest
TEST_CASE("at (5, 0) m/s, with n = (0.8, 0.6), a ball gives (3.2, 2.4) to one at rest, and keeps (1.8, -2.4)",
          "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({0.8, 0.6}, {0, 0})),
               IsNear(Velocities{{1.8, -2.4}, {3.2, 2.4}}, rounding)); // 4 m/s along n goes over
}

//> Head on
TEST_CASE("head on, two balls exchange their velocities", "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {3, 0}), ball({1, 0}, {-2, 0})), IsNear(Velocities{{-2, 0}, {3, 0}}, rounding));
}

//> Both move
TEST_CASE("where both move, the normal components change places, and the tangential ones stay", "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {3, 2}), ball({1, 0}, {-2, 1})), IsNear(Velocities{{-2, 2}, {3, 1}}, rounding));
}

// ----------------------------------------------------------------------------------------------- 8.3 resolve_collision

//> Worked example: 2 kg against 3 kg
TEST_CASE("2 kg at (3, 1) and 3 kg at (-1, -1) m/s, restitution 0.8: (0.408, -2.456) and (0.728, 1.304)", "[8.3]") {
    // They approach at 2.6 - (-1.4) = 4 m/s; the impulse is 1.8 · 4 · 2 · 3 / 5 = 8.64 N s
    const Ball a = ball({0, 0}, {3, 1}, 2), b = ball({0.6, 0.8}, {-1, -1}, 3);
    CHECK_THAT(resolve_collision(a, b, 0.8), IsNear(Velocities{{0.408, -2.456}, {0.728, 1.304}}, rounding));
}

//> Head on, with restitution
TEST_CASE("head on, it is the collision of two carts", "[8.3]") {
    const Ball a = ball({0, 0}, {4, 0}, 2), b = ball({1, 0}, {-2, 0}, 3);
    CHECK_THAT(resolve_collision(a, b, 0.5), IsNear(Velocities{{-1.4, 0}, {1.6, 0}}, rounding));
    CHECK_THAT(resolve_collision(a, b, 0), IsNear(Velocities{{0.4, 0}, {0.4, 0}}, rounding));
}

//> Equal and elastic
TEST_CASE("equal and elastic balls exchange their normal components", "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {5, 0}), ball({0.8, 0.6}, {0, 0}), 1),
               IsNear(Velocities{{1.8, -2.4}, {3.2, 2.4}}, rounding));
}

// -------------------------------------------------------------------------------------------------- 8.4 time_of_impact

//> Worked example: 0.64 s
TEST_CASE("at (5, 0) m/s, from (0, 0), a ball touches one that rests at (4, 0.6) after 0.64 s", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 0.6}, {0, 0})), IsNear(0.64, 1e-8));
}

//> Both move, at an angle
TEST_CASE("from (0, 0) at (3, 1) m/s, and from (3, 2) at (-1, -1) m/s, two balls touch after 0.6 s", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 1}, 2), ball({3, 2}, {-1, -1}, 3)), IsNear(0.6, 1e-8));
}

//> Passing by
TEST_CASE("balls that pass by each other never touch", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 1.1}, {0, 0})), IsNear(std::optional<double>{}));
}

// ------------------------------------------------------------------------------------------------------ 8.5 push_apart

//> Worked example: an overlap of 0.2 m
TEST_CASE("two equal discs that overlap by 0.2 m are moved by 0.1 m each", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{0.8, 0}, 0.5, 1}), IsNear(Positions{{-0.1, 0}, {0.9, 0}}, rounding));
}

//> Twice the mass
TEST_CASE("the one with twice the mass moves half as far", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 0.5}, {{0.7, 0}, 0.5, 1}), IsNear(Positions{{-0.1, 0}, {0.9, 0}}, rounding));
}

//> A post
TEST_CASE("a post stays, and the ball moves all the way", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 0}, {{0.8, 0}, 0.5, 1}), IsNear(Positions{{0, 0}, {1, 0}}, rounding));
}

// ----------------------------------------------------------------------------------------------------- 8.6 close_pairs

//> Worked example: four points
TEST_CASE("of four points, the two pairs that are no farther apart than 1 m are found", "[8.6]") {
    // 0 and 1 are 0.9 m apart, 1 and 3 are 0.5 m apart, and 2 is far from all
    CHECK_THAT(sorted(close_pairs({{0.2, 0.5}, {1.1, 0.5}, {5, 5}, {1.1, 1}}, 1)),
               IsNear(std::vector<Pair>{{0, 1}, {1, 3}}).of("the pairs, sorted"));
}

//> Nobody near
TEST_CASE("without points, with one, and with two that are too far apart, there are no pairs", "[8.6]") {
    CHECK_THAT(close_pairs({}, 1), HasSize(0));
    CHECK_THAT(close_pairs({{3, 4}}, 1), HasSize(0));
    CHECK_THAT(close_pairs({{0, 0}, {3, 4}}, 4.9), HasSize(0));
}

//> Across the edges of cells
TEST_CASE("points in neighbouring cells are found, to the side, above, and across a corner", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{0.9, 0.9}, {1.1, 0.9}, {0.9, 1.1}, {1.1, 1.1}}, 1)),
               IsNear(std::vector<Pair>{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}).of("the pairs, sorted"));
}
