#include "section_test.hpp"

#include "nt_collisions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

using nt_collisions::Ball;
using nt_collisions::Components;
using nt_collisions::Disc;
using nt_collisions::Pair;
using nt_collisions::Positions;
using nt_collisions::Velocities;
using namespace nt_collisions::subject; // decompose, exchange, ... close_pairs: the student's

namespace {

// An answer is right to twelve digits of the largest number that goes in, or of 1 if that is larger. Two centres
// closer together than 1e-60 m may count as the same point, and a relative speed, a radius, a mass or an inverse mass
// below 1e-20 as 0. After a collision of two masses, one digit fewer may be right for each factor of ten by which one
// is larger than the other; with masses below 1e-9 kg any answer may be right to fewer. At a time of impact the
// distance of the centres is the sum of the radii, to nine digits of the largest coordinate, or of that sum if it's
// larger; or to six, if the largest coordinate is more than a thousand times that sum. Balls that would graze each
// other as exactly as that may touch or not. A pair whose distance differs from `distance` by less than 1e-12 of the
// largest number that goes in, or of 1 if that is larger, may be among the close ones or not.

constexpr double pi = std::numbers::pi;

Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vec2 quarter_turned(const Vec2 &v) { return {-v.y(), v.x()}; }
Vec2 turned(const Vec2 &v, double angle) { return v.x() * at_angle(angle) + v.y() * quarter_turned(at_angle(angle)); }

/// A ball with a radius of 0.5 m, and of 1 kg if a test does not say otherwise.
Ball ball(const Vec2 &position, const Vec2 &velocity, double mass = 1) { return {position, velocity, 0.5, mass}; }

double energy(const Vec2 &velocity, double mass) { return mass * velocity.squaredNorm() / 2; } // [J]

/// Two balls somewhere that touch, and `normal` from a to b.
struct Meeting {
    Ball a, b;
    Vec2 normal;
    double approach() const { return (a.velocity - b.velocity).dot(normal); }
};
Meeting meeting(Dice &dice) {
    const Vec2 at = dice.point(-5, 5), normal = dice.direction();
    return {{at, dice.point(-10, 10), dice.real(0.2, 1), dice.real(0.5, 8)},
            {at + dice.real(0.5, 3) * normal, dice.point(-10, 10), dice.real(0.2, 1), dice.real(0.5, 8)},
            normal};
}
/// The same, and they approach each other.
Meeting collision(Dice &dice) {
    Meeting all = meeting(dice);
    if (all.approach() < 0) std::swap(all.a.velocity, all.b.velocity);
    return all;
}

/// What a header says of a number with this name: the least and the largest that is answered, and what is refused.
struct Range {
    double least, largest;
    std::vector<double> refused;
};
Range range_of(const std::string &name) {
    const auto below = [](double least) { return std::nextafter(least, -infinity); };
    if (name == "restitution") return {0, 1, {below(0), std::nextafter(1, infinity)}};
    if (name == "distance") return {0.001, 1e5, {below(0.001)}};
    if (name.ends_with("inverse_mass")) return {0, 1e5, {below(0)}};
    if (name.ends_with("radius") || name.ends_with("mass")) return {1e-20, 1e5, {0}};
    return {-1e5, 1e5, {}};
}

/// Each number of these arguments is answered at both ends of its range, and refused just beyond.
template <auto F> void check_the_ends(const course::Remote<F> &exercise, typename course::Remote<F>::Given arguments) {
    const auto check = [&](double &number, const std::string &name) {
        const Range range = range_of(name);
        const double good = number;
        for (const double end : {range.least, range.largest}) {
            number = end;
            std::apply(exercise, arguments);
        }
        for (const double bad : range.refused) {
            number = bad;
            CHECK_REFUSED(std::apply(exercise, arguments), name + ", just beyond its range");
        }
        number = good;
    };
    const auto names = exercise.argument_names();
    std::size_t i = 0;
    std::apply([&](auto &...argument) { (course::for_each_number(argument, names[i++], check), ...); }, arguments);
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

//> Anywhere on the table
TEST_CASE("where on the table the two balls are does not matter", "[8.1]") {
    CHECK_THAT(decompose({5, 0}, {2, 7}, {2.8, 7.6}), IsNear(Components{4, -3}, 1e-11));
    CHECK_THAT(decompose({5, 0}, {-4, -3}, {0, 0}), IsNear(Components{4, -3}, rounding));
}

//> The other way round
TEST_CASE("with a and b exchanged, both components change their signs", "[8.1]") {
    CHECK_THAT(decompose({5, 0}, {0.8, 0.6}, {0, 0}), IsNear(Components{-4, 3}, rounding));
    CHECK_THAT(decompose({3, 2}, {1, 0}, {0, 0}), IsNear(Components{-3, -2}, rounding));
}

//> Along n, along t, at rest
TEST_CASE("what moves along the line of centres has no tangential component, what moves across it no normal one",
          "[8.1]") {
    CHECK_THAT(decompose({4, 3}, {0, 0}, {0.8, 0.6}), IsNear(Components{5, 0}, rounding));
    CHECK_THAT(decompose({-3, 4}, {0, 0}, {0.8, 0.6}), IsNear(Components{0, 5}, rounding));
    CHECK_THAT(decompose({0, 0}, {0, 0}, {0.8, 0.6}), IsNear(Components{0, 0}, rounding));
}

//> By angles
TEST_CASE("the components are the speed times the cosine and the sine of the angle from the line of centres", "[8.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double line = dice.real(-pi, pi), from_it = dice.real(-pi, pi), speed = dice.real(0, 10);
        const Vec2 a = dice.point(-5, 5), b = a + dice.real(0.5, 20) * at_angle(line);

        const Components got = decompose(speed * at_angle(line + from_it), a, b);

        CHECK_THAT(got.normal, IsNear(speed * std::cos(from_it), 1e-11).of("normal component [m/s]"));
        CHECK_THAT(got.tangential, IsNear(speed * std::sin(from_it), 1e-11).of("tangential component [m/s]"));
    }
}

//> And back
TEST_CASE("put together again, the two components are the velocity", "[8.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 velocity = dice.point(-10, 10), a = dice.point(-5, 5), n = dice.direction();

        const Components got = decompose(velocity, a, a + dice.real(0.5, 20) * n);

        CHECK_THAT(Vec2{got.normal * n + got.tangential * quarter_turned(n)},
                   IsNear(velocity, 1e-11).of("n times the normal component, plus t times the tangential one [m/s]"));
    }
}

//> Erratum E8.6
TEST_CASE("erratum E8.6: <-y, x> is a quarter turn anticlockwise, not clockwise: to the left of (1, 0) is up",
          "[8.1]") {
    CHECK_THAT(decompose({0, 5}, {0, 0}, {1, 0}), IsNear(Components{0, 5}, rounding)); // clockwise, it would be -5
}

//> Erratum E8.9
TEST_CASE("erratum E8.9: with both centres at one point, n is 0/0 as printed; decompose refuses them", "[8.1]") {
    const double printed = 0.0 / Vec2{0, 0}.norm();
    CHECK_THAT(std::isnan(printed), IsTrue("0/0 is not a number"));
    CHECK_REFUSED(decompose({5, 0}, {2, 7}, {2, 7}), "the same point twice");
}

//>
TEST_CASE("velocities and centres up to 1e5 are allowed, and tiny ones", "[8.1]") {
    CHECK_THAT(decompose({1e5, 0}, {0, 0}, {0.8, 0.6}), IsNear(Components{8e4, -6e4}, rounding));
    CHECK_THAT(decompose({1e5, 1e5}, {-1e5, -1e5}, {1e5, 1e5}), IsNear(Components{1e5 * std::sqrt(2), 0}, 1e-7));
    CHECK_THAT(decompose({-1e5, 1e5}, {1e5, -1e5}, {-1e5, 1e5}), IsNear(Components{1e5 * std::sqrt(2), 0}, 1e-7));
    CHECK_THAT(decompose({-1e5, -1e5}, {0, 0}, {1, -1}), IsNear(Components{0, -1e5 * std::sqrt(2)}, 1e-7));
    CHECK_THAT(decompose({1e5, 1e5}, {0, 0}, {1, -1}), IsNear(Components{0, 1e5 * std::sqrt(2)}, 1e-7));
    CHECK_THAT(decompose({-1e5, -1e5}, {0, 0}, {1, 1}), IsNear(Components{-1e5 * std::sqrt(2), 0}, 1e-7));
    CHECK_THAT(decompose({5e-10, 0}, {0, 0}, {0.8, 0.6}), IsNear(Components{4e-10, -3e-10}, rounding));
    CHECK_THAT(decompose({1, 9e-12}, {0, 0}, {1, 0}), IsNear(Components{1, 9e-12}, rounding));
    CHECK_THAT(decompose({9e-12, 1}, {0, 0}, {1, 0}), IsNear(Components{9e-12, 1}, rounding));
    CHECK_THAT(decompose({5, 0}, {0, 0}, {8e-10, 6e-10}), IsNear(Components{4, -3}, rounding));
    CHECK_THAT(decompose({5, 0}, {0, 0}, {1.2e-60, 1.6e-60}), IsNear(Components{3, -4}, rounding));
    CHECK_THAT(decompose({5, 0}, {0.5, 0.5}, {0.5, 0.5 + std::ldexp(1, -50)}), IsNear(Components{0, -5}, rounding));
    CHECK_THAT(decompose({5, 0}, {0, 0}, {1, 1e-10}), IsNear(Components{5, -5e-10}, rounding)); // nearly level
    CHECK_THAT(decompose({5, 0}, {0, 0}, {1e-10, 1}), IsNear(Components{5e-10, -5}, rounding)); // nearly upright
    CHECK_THAT(decompose({5, 1e-10}, {0, 0}, {1, 0}), IsNear(Components{5, 1e-10}, rounding));  // nearly along it
    CHECK_THAT(decompose({5, 0}, {0, 0}, {0.999, 0}), IsNear(Components{5, 0}, rounding));
    CHECK_THAT(decompose({5, 0}, {0, 0}, {1 + 5e-10, 0}), IsNear(Components{5, 0}, rounding));
    CHECK_THAT(decompose({5, 0}, {0, 0}, {-8e4, 6e4}), IsNear(Components{-4, -3}, rounding));
    CHECK_THAT(decompose({3, 2}, {1, 1}, {0, 1}), IsNear(Components{-3, -2}, rounding)); // b straight to the left of a
    CHECK_THAT(decompose({3, 2}, {1, 1}, {1, 0}), IsNear(Components{-2, 3}, rounding));  // and straight below it
}

TEST_CASE("centres at one point are refused by decompose", "[8.1]") {
    CHECK_REFUSED(decompose({5, 0}, {0, 0}, {0, 0}));
    CHECK_REFUSED(decompose({0, 0}, {1, 1}, {1, 1}));
    check_the_ends(decompose, {Vec2{5, 0}, Vec2{0, 0}, Vec2{0.8, 0.6}});
    decompose({5, 0}, {0, 0}, {0.8, 0.6}); // good input is still answered
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
    CHECK_THAT(exchange(ball({0, 0}, {2, 3}), ball({0, 1}, {1, -2})), IsNear(Velocities{{2, -2}, {1, 3}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({0.8, 0.6}, {0.4, -2.2})),
               IsNear(Velocities{{1, -3}, {4.4, 0.8}}, rounding)
                   .since("along n = (0.8, 0.6) they move at 4 and -1 m/s, across it at -3 and -2"));
}

//> On their way apart
TEST_CASE("balls that are on their way apart keep their velocities, even while they overlap", "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {-3, 2}), ball({0.9, 0}, {2, 1})), IsNear(Velocities{{-3, 2}, {2, 1}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {-5, 0}), ball({0.8, 0.6}, {0, 0})),
               IsNear(Velocities{{-5, 0}, {0, 0}}, rounding));
}

//> In the same direction
TEST_CASE("a faster ball catches up with a slower one in front of it; a slower one does not", "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {3, 0}), ball({1, 0}, {1, 0})), IsNear(Velocities{{1, 0}, {3, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {1, 0}), ball({1, 0}, {3, 0})), IsNear(Velocities{{1, 0}, {3, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {-1, 0}), ball({1, 0}, {-3, 0})), IsNear(Velocities{{-3, 0}, {-1, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {-3, 0}), ball({1, 0}, {-1, 0})), IsNear(Velocities{{-3, 0}, {-1, 0}}, rounding));
}

//> Past each other
TEST_CASE("balls that slide past each other, or rest, or move alike, keep their velocities", "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {0, 3}), ball({1, 0}, {0, -2})), IsNear(Velocities{{0, 3}, {0, -2}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {0, 0}), ball({1, 0}, {0, 0})), IsNear(Velocities{{0, 0}, {0, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {3, 2}), ball({1, 0}, {3, 2})), IsNear(Velocities{{3, 2}, {3, 2}}, rounding));
}

//> Positions and velocities only
TEST_CASE("neither distance, nor radius, nor mass matters", "[8.2]") {
    const Velocities want{{1.8, -2.4}, {3.2, 2.4}};
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({4, 3}, {0, 0})), IsNear(want, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({0.2, 0.15}, {0, 0})), IsNear(want, rounding));
    CHECK_THAT(exchange({{0, 0}, {5, 0}, 0.1, 1}, {{0.8, 0.6}, {0, 0}, 3, 1}), IsNear(want, rounding));
    CHECK_THAT(exchange({{0, 0}, {5, 0}, 0.5, 2}, {{0.8, 0.6}, {0, 0}, 0.5, 7}), IsNear(want, rounding));
    CHECK_THAT(exchange(ball({2, 7}, {5, 0}), ball({2.8, 7.6}, {0, 0})), IsNear(want, 1e-11));
}

//> Labels exchanged
TEST_CASE("with a and b exchanged, the answers are exchanged", "[8.2]") {
    CHECK_THAT(exchange(ball({0.8, 0.6}, {0, 0}), ball({0, 0}, {5, 0})),
               IsNear(Velocities{{3.2, 2.4}, {1.8, -2.4}}, rounding));
    CHECK_THAT(exchange(ball({1, 0}, {-2, 1}), ball({0, 0}, {3, 2})), IsNear(Velocities{{3, 1}, {-2, 2}}, rounding));
}

//> At a right angle
TEST_CASE("where one ball rests, the two leave at a right angle, wherever they touch", "[8.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double line = dice.real(-pi, pi), from_it = dice.real(-1.5, 1.5), speed = dice.real(0.5, 10);

        const Velocities after = exchange(ball({0, 0}, speed * at_angle(line + from_it)), ball(at_angle(line), {0, 0}));

        CHECK_THAT(after.b, IsNear(Vec2{speed * std::cos(from_it) * at_angle(line)}, 1e-11).of("velocity of b [m/s]"));
        CHECK_THAT(after.a.dot(after.b), IsNear(0.0, 1e-9).of("dot product of the two velocities"));
    }
}

//> What stays the same
TEST_CASE("the sum of both velocities and that of their squares stay, for all that approach", "[8.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const auto [a, b, n] = collision(dice);

        const Velocities after = exchange(a, b);

        const Vec2 t = quarter_turned(n);
        CHECK_THAT(Vec2{after.a + after.b}, IsNear(Vec2{a.velocity + b.velocity}, 1e-11).of("sum of both [m/s]"));
        CHECK_THAT(after.a.squaredNorm() + after.b.squaredNorm(),
                   IsNear(a.velocity.squaredNorm() + b.velocity.squaredNorm(), 1e-11).of("sum of the squares [m²/s²]"));
        CHECK_THAT(after.a.dot(n), IsNear(b.velocity.dot(n), 1e-11).of("normal component of a [m/s]"));
        CHECK_THAT(after.a.dot(t), IsNear(a.velocity.dot(t), 1e-11).of("tangential component of a [m/s]"));
        CHECK_THAT(after.b.dot(t), IsNear(b.velocity.dot(t), 1e-11).of("tangential component of b [m/s]"));
    }
}

//> Twice
TEST_CASE("asked again with the answer, it changes nothing: the balls are on their way apart", "[8.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        auto [a, b, n] = meeting(dice);
        const Velocities once = exchange(a, b);
        a.velocity = once.a - 1e-9 * n; // apart by more than rounding
        b.velocity = once.b + 1e-9 * n;
        CHECK_THAT(exchange(a, b), IsNear(Velocities{a.velocity, b.velocity}, rounding));
    }
}

//> Erratum E8.5
TEST_CASE("erratum E8.5: the velocity after the collision is not along n, only its change is", "[8.2]") {
    const Vec2 n{0.8, 0.6}, t{-0.6, 0.8}, before{5, 0};
    const Velocities after = exchange(ball({0, 0}, before), ball({0.8, 0.6}, {0, 0}));
    CHECK_THAT(after.a.dot(t), IsNear(-3.0, rounding).of("tangential component of a [m/s]"));
    CHECK_THAT(Vec2{after.a - before}, IsNear(Vec2{-4 * n}, rounding).of("change of a's velocity [m/s]"));
}

//> Erratum E8.10
TEST_CASE("erratum E8.10: without asking whether they approach, balls that overlap are turned in every frame",
          "[8.2]") {
    Ball a = ball({0, 0}, {-1, 0}), b = ball({0.5, 0}, {1, 0});
    double printed_gap = 0.5, printed_speed = 2; // at which they part, as the printed code has it
    for (int frame = 0; frame < 30; ++frame) {
        const Velocities after = exchange(a, b);
        a.velocity = after.a, b.velocity = after.b;
        a.position += a.velocity / 60, b.position += b.velocity / 60;
        if (printed_gap < 1) printed_speed = -printed_speed;
        printed_gap += printed_speed / 60;
    }
    CHECK_THAT((b.position - a.position).norm(), IsNear(1.5, 1e-9).of("distance after half a second [m]"));
    CHECK_THAT(printed_gap, IsNear(0.5, 1e-9).of("distance after half a second, as printed [m]"));
}

//> Erratum E8.11
TEST_CASE("erratum E8.11: a collision changes velocities only; the printed code also moves the balls again", "[8.2]") {
    const Ball a = ball({0, 0}, {3, 0});
    Ball b = ball({1, 0}, {0, 0});
    b.velocity = exchange(a, b).b;
    double printed_x = b.position.x();
    for (int frame = 0; frame < 10; ++frame) {
        b.position += b.velocity / 60;
        printed_x += 2 * b.velocity.x() / 60;
    }
    CHECK_THAT(b.position.x(), IsNear(1.5, 1e-11).of("x of b after ten frames [m]"));
    CHECK_THAT(printed_x, IsNear(2.0, 1e-11).of("x of b after ten frames, moved twice in each [m]"));
}

//>
TEST_CASE("fast, slow and distant balls, and those that hardly approach or hardly touch off centre", "[8.2]") {
    CHECK_THAT(exchange(ball({0, 0}, {1e5, 0}), ball({0.8, 0.6}, {0, 0})),
               IsNear(Velocities{{3.6e4, -4.8e4}, {6.4e4, 4.8e4}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {1e5, 1e5}), ball({1, 1}, {-1e5, -1e5})),
               IsNear(Velocities{{-1e5, -1e5}, {1e5, 1e5}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {-1e5, 1e5}), ball({1, 1}, {-1e5, -1e5})),
               IsNear(Velocities{{-2e5, 0}, {0, 0}}, 1e-7)); // larger than what goes in
    CHECK_THAT(exchange(ball({0, 0}, {-1e5, -1e5}), ball({-1, 1}, {1e5, -1e5})),
               IsNear(Velocities{{0, -2e5}, {0, 0}}, 1e-7));
    CHECK_THAT(exchange(ball({0, 0}, {1e5, 1e5}), ball({1, -1}, {-1e5, 1e5})),
               IsNear(Velocities{{0, 2e5}, {0, 0}}, 1e-7));
    CHECK_THAT(exchange(ball({0, 0}, {1e5, 1e5}), ball({-1, 1}, {1e5, -1e5})),
               IsNear(Velocities{{2e5, 0}, {0, 0}}, 1e-7));
    CHECK_THAT(exchange(ball({0, 0}, {5e-10, 0}), ball({0.8, 0.6}, {0, 0})),
               IsNear(Velocities{{1.8e-10, -2.4e-10}, {3.2e-10, 2.4e-10}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {9e-12, 0}), ball({1, 0}, {0, 0})),
               IsNear(Velocities{{0, 0}, {9e-12, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({8e-10, 6e-10}, {0, 0})),
               IsNear(Velocities{{1.8, -2.4}, {3.2, 2.4}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({1.6e-60, 1.2e-60}, {0, 0})),
               IsNear(Velocities{{1.8, -2.4}, {3.2, 2.4}}, rounding));
    CHECK_THAT(exchange(ball({-1e5, 1e5}, {1, 0}), ball({1e5, 1e5}, {-1, 0})),
               IsNear(Velocities{{-1, 0}, {1, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {3 + 1e-9, 0}), ball({1, 0}, {3, 0})),
               IsNear(Velocities{{3, 0}, {3 + 1e-9, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {3 - 1e-9, 0}), ball({1, 0}, {3, 0})),
               IsNear(Velocities{{3 - 1e-9, 0}, {3, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({1, 1e-10}, {0, 0})),
               IsNear(Velocities{{0, -5e-10}, {5, 5e-10}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({1e-10, 1}, {0, 0})),
               IsNear(Velocities{{5, -5e-10}, {0, 5e-10}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({0.999, 0}, {0, 0})), IsNear(Velocities{{0, 0}, {5, 0}}, rounding));
    CHECK_THAT(exchange(ball({0, 0}, {5, 0}), ball({1 + 5e-10, 0}, {0, 0})),
               IsNear(Velocities{{0, 0}, {5, 0}}, rounding));
    CHECK_THAT(exchange(ball({-1e5, -1e5}, {1, 1}), ball({1e5, 1e5}, {-1, -1})),
               IsNear(Velocities{{-1, -1}, {1, 1}}, rounding));
    for (const Vec2 &n : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) // b to the right of a, above, left, below
        CHECK_THAT(exchange(ball({1, 1}, {3, 2}), ball(Vec2{1, 1} + n, Vec2{3, 2} - 4 * n)),
                   IsNear(Velocities{Vec2{3, 2} - 4 * n, {3, 2}}, rounding));
    for (const auto &[radius, other] : {std::pair{0.01, 100.0}, std::pair{100.0, 0.01}})
        CHECK_THAT(exchange({{0, 0}, {5, 0}, radius, 1}, {{0.8, 0.6}, {0, 0}, other, 1}),
                   IsNear(Velocities{{1.8, -2.4}, {3.2, 2.4}}, rounding));
}

TEST_CASE("centres at one point, or a radius or a mass that is not positive, are refused", "[8.2]") {
    const Ball a = ball({0, 0}, {5, 0}), b = ball({0.8, 0.6}, {0, 0});
    CHECK_REFUSED(exchange(a, a), "the same ball twice");
    for (const double bad : {0.0, -1e-9, -1.0}) {
        CHECK_REFUSED(exchange({{0, 0}, {5, 0}, bad, 1}, b), "the radius of a is not positive");
        CHECK_REFUSED(exchange({{0, 0}, {5, 0}, 0.5, bad}, b), "the mass of a is not positive");
        CHECK_REFUSED(exchange(a, {{0.8, 0.6}, {0, 0}, bad, 1}), "the radius of b is not positive");
        CHECK_REFUSED(exchange(a, {{0.8, 0.6}, {0, 0}, 0.5, bad}), "the mass of b is not positive");
    }
    check_the_ends(exchange, {a, b});
    exchange(a, b); // good input is still answered
}

// ----------------------------------------------------------------------------------------------- 8.3 resolve_collision

//> Worked example: 2 kg against 3 kg
TEST_CASE("2 kg at (3, 1) and 3 kg at (-1, -1) m/s, restitution 0.8: (0.408, -2.456) and (0.728, 1.304)", "[8.3]") {
    const Ball a = ball({0, 0}, {3, 1}, 2), b = ball({0.6, 0.8}, {-1, -1}, 3);
    CHECK_THAT(resolve_collision(a, b, 0.8),
               IsNear(Velocities{{0.408, -2.456}, {0.728, 1.304}}, rounding)
                   .since("they approach at 2.6 - (-1.4) = 4 m/s, and the impulse is 1.8 · 4 · 2 · 3 / 5 = 8.64 N s"));
}

//> Head on, with restitution
TEST_CASE("head on, 2 kg at 4 m/s against 3 kg at -2 m/s, it is the collision of two carts", "[8.3]") {
    const Ball a = ball({0, 0}, {4, 0}, 2), b = ball({1, 0}, {-2, 0}, 3);
    CHECK_THAT(resolve_collision(a, b, 1), IsNear(Velocities{{-3.2, 0}, {2.8, 0}}, rounding));
    CHECK_THAT(resolve_collision(a, b, 0.75), IsNear(Velocities{{-2.3, 0}, {2.2, 0}}, rounding));
    CHECK_THAT(resolve_collision(a, b, 0.5), IsNear(Velocities{{-1.4, 0}, {1.6, 0}}, rounding));
    CHECK_THAT(resolve_collision(a, b, 0.25), IsNear(Velocities{{-0.5, 0}, {1, 0}}, rounding));
    CHECK_THAT(resolve_collision(a, b, 0), IsNear(Velocities{{0.4, 0}, {0.4, 0}}, rounding));
}

//> Equal and elastic
TEST_CASE("equal and elastic balls exchange their normal components", "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {5, 0}), ball({0.8, 0.6}, {0, 0}), 1),
               IsNear(Velocities{{1.8, -2.4}, {3.2, 2.4}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 2}, 4), ball({1, 0}, {-2, 1}, 4), 1),
               IsNear(Velocities{{-2, 2}, {3, 1}}, rounding));
}

//> Equal and half elastic
TEST_CASE("with restitution 0.5, a ball at (5, 0) keeps (2.6, -1.8), and an equal one at rest gets (2.4, 1.8)",
          "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {5, 0}), ball({0.8, 0.6}, {0, 0}), 0.5),
               IsNear(Velocities{{2.6, -1.8}, {2.4, 1.8}}, rounding).since("the impulse is 1.5 · 4 / 2 = 3 N s"));
}

//> Apart, with masses
TEST_CASE("balls of any mass that are on their way apart, or slide past each other, keep their velocities", "[8.3]") {
    const double restitution = GENERATE(0.0, 0.8, 1.0);
    CHECK_THAT(resolve_collision(ball({0, 0}, {-3, 2}, 2), ball({0.9, 0}, {2, 1}, 3), restitution),
               IsNear(Velocities{{-3, 2}, {2, 1}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {-3, -1}, 2), ball({0.6, 0.8}, {1, 1}, 3), restitution),
               IsNear(Velocities{{-3, -1}, {1, 1}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {1, 0}, 2), ball({1, 0}, {3, 0}, 3), restitution),
               IsNear(Velocities{{1, 0}, {3, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {0, 3}, 2), ball({1, 0}, {0, -2}, 3), restitution),
               IsNear(Velocities{{0, 3}, {0, -2}}, rounding));
}

//> Clay
TEST_CASE("with restitution 0 the two have the same normal component afterwards, and keep their tangential ones",
          "[8.3]") {
    CHECK_THAT(
        resolve_collision(ball({0, 0}, {4, 1}, 2), ball({1, 0}, {-2, -3}, 3), 0),
        IsNear(Velocities{{0.4, 1}, {0.4, -3}}, rounding).since("along n both end at (2 · 4 - 3 · 2) / 5 = 0.4 m/s"));
}

//> Heavy and light
TEST_CASE("a light ball turns back from a heavy one, and a heavy one hardly notices a light one", "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 1), ball({1, 0}, {0, 0}, 3), 1),
               IsNear(Velocities{{-2, 1}, {2, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 3), ball({1, 0}, {0, 0}, 1), 1),
               IsNear(Velocities{{2, 1}, {6, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 1e-3), ball({1, 0}, {0, 0}, 1e3), 0.5),
               IsNear(Velocities{{-2, 1}, {0, 0}}, 1e-5));
}

//> Labels and masses exchanged
TEST_CASE("with a and b exchanged, the answers are exchanged, whatever their masses", "[8.3]") {
    const Ball a = ball({0, 0}, {3, 1}, 2), b = ball({0.6, 0.8}, {-1, -1}, 3);
    CHECK_THAT(resolve_collision(b, a, 0.8), IsNear(Velocities{{0.728, 1.304}, {0.408, -2.456}}, rounding));
}

//> Neither distance nor radius
TEST_CASE("neither distance nor radius matters, nor where on the table it is", "[8.3]") {
    const Velocities want{{0.408, -2.456}, {0.728, 1.304}};
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 1}, 2), ball({3, 4}, {-1, -1}, 3), 0.8), IsNear(want, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 1}, 2), ball({0.3, 0.4}, {-1, -1}, 3), 0.8), IsNear(want, rounding));
    CHECK_THAT(resolve_collision({{-3, -4}, {3, 1}, 0.1, 2}, {{0, 0}, {-1, -1}, 7, 3}, 0.8), IsNear(want, rounding));
}

//> Masses count by their ratio
TEST_CASE("both masses a hundred times as large give the same velocities", "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 1}, 200), ball({0.6, 0.8}, {-1, -1}, 300), 0.8),
               IsNear(Velocities{{0.408, -2.456}, {0.728, 1.304}}, rounding));
}

//> Momentum
TEST_CASE("the sum of momentum stays the same in every collision, whatever the restitution", "[8.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const auto [a, b, n] = collision(dice);
        const Velocities after = resolve_collision(a, b, dice.real(0, 1));
        CHECK_THAT(Vec2{a.mass * after.a + b.mass * after.b},
                   IsNear(Vec2{a.mass * a.velocity + b.mass * b.velocity}, 1e-10).of("sum of momentum [kg m/s]"));
    }
}

//> Restitution
TEST_CASE("the normal speed at which they part is the restitution times that at which they approached", "[8.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Meeting balls = collision(dice);
        const double restitution = dice.real(0, 1);
        const Velocities after = resolve_collision(balls.a, balls.b, restitution);
        CHECK_THAT((after.b - after.a).dot(balls.normal),
                   IsNear(restitution * balls.approach(), 1e-10).of("normal speed at which they part [m/s]"));
    }
}

//> Tangential components
TEST_CASE("each of the two keeps its tangential component", "[8.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const auto [a, b, n] = collision(dice);
        const Velocities after = resolve_collision(a, b, dice.real(0, 1));
        const Vec2 t = quarter_turned(n);
        CHECK_THAT(after.a.dot(t), IsNear(a.velocity.dot(t), 1e-10).of("tangential component of a [m/s]"));
        CHECK_THAT(after.b.dot(t), IsNear(b.velocity.dot(t), 1e-10).of("tangential component of b [m/s]"));
    }
}

//> Energy
TEST_CASE("of the kinetic energy, (1 - e²) times the part that is in the approach is lost", "[8.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Meeting balls = collision(dice);
        const auto &[a, b, n] = balls;
        const double e = dice.real(0, 1), reduced_mass = 1 / (1 / a.mass + 1 / b.mass);
        const double loss = (1 - e * e) * reduced_mass * balls.approach() * balls.approach() / 2;

        const Velocities after = resolve_collision(a, b, e);

        CHECK_THAT(energy(after.a, a.mass) + energy(after.b, b.mass),
                   IsNear(energy(a.velocity, a.mass) + energy(b.velocity, b.mass) - loss, 1e-10)
                       .of("kinetic energy afterwards [J]"));
    }
}

//> From a moving train
TEST_CASE("seen from a moving train, it is the same collision", "[8.3]") {
    const Vec2 train = GENERATE(Vec2{10, 0}, Vec2{-10, 3});
    const Ball a = ball({0, 0}, Vec2{3, 1} - train, 2), b = ball({0.6, 0.8}, Vec2{-1, -1} - train, 3);
    CHECK_THAT(resolve_collision(a, b, 0.8),
               IsNear(Velocities{Vec2{0.408, -2.456} - train, Vec2{0.728, 1.304} - train}, rounding * 10));
}

//> With the head tilted
TEST_CASE("turned by any angle, or seen in a mirror, it is the same collision", "[8.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const double angle = dice.real(-pi, pi), mirror = dice.sign();
        const auto seen = [&](const Vec2 &v) { return turned({v.x(), mirror * v.y()}, angle); };
        const Ball a = ball({0, 0}, seen({3, 1}), 2), b = ball(seen({0.6, 0.8}), seen({-1, -1}), 3);
        CHECK_THAT(resolve_collision(a, b, 0.8),
                   IsNear(Velocities{seen({0.408, -2.456}), seen({0.728, 1.304})}, 1e-11));
    }
}

//> Asked twice
TEST_CASE("asked again with the answer, it changes nothing: the balls are on their way apart", "[8.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        auto [a, b, n] = meeting(dice);
        const Velocities once = resolve_collision(a, b, dice.real(0, 1));
        a.velocity = once.a - 1e-9 * n; // apart by more than rounding
        b.velocity = once.b + 1e-9 * n;
        CHECK_THAT(resolve_collision(a, b, dice.real(0, 1)), IsNear(Velocities{a.velocity, b.velocity}, rounding));
    }
}

//> Erratum E8.1
TEST_CASE("erratum E8.1: as printed, e is -1 for elastic balls; with an e of 1 they would go through each other",
          "[8.3]") {
    const Velocities after = resolve_collision(ball({0, 0}, {4, 0}, 2), ball({1, 0}, {-2, 0}, 3), 1);
    const double printed = (after.b.x() - after.a.x()) / (-2 - 4);
    CHECK_THAT(printed, IsNear(-1.0, rounding).of("restitution, as printed [1]"));
}

//> Erratum E8.2
TEST_CASE("erratum E8.2: with a restitution below 1 the sum of momentum stays, and a ball may leave faster", "[8.3]") {
    const Velocities after = resolve_collision(ball({0, 0}, {2, 0}), ball({1, 0}, {0, 0}), 0.5);
    CHECK_THAT(after.a.x() + after.b.x(), IsNear(2.0, rounding).of("sum of momentum along x [kg m/s]"));
    CHECK_THAT(after.a.x(), IsNear(0.5, rounding).of("velocity of a along x, where elastic balls leave 0 [m/s]"));
}

//> Erratum E8.3
TEST_CASE("erratum E8.3: the printed v_bf has (m_a - e m_b) and a minus; with e = 0.5, b would leave at 2.6 m/s",
          "[8.3]") {
    const double e = 0.5, m_a = 2, m_b = 3, v_ai = 4, v_bi = -2;
    const double printed = ((e + 1) * m_a * v_ai - v_bi * (m_a - e * m_b)) / (m_a + m_b);
    CHECK_THAT(printed, IsNear(2.6, rounding).of("velocity of b, as printed [m/s]"));
    CHECK_THAT(resolve_collision(ball({0, 0}, {v_ai, 0}, m_a), ball({1, 0}, {v_bi, 0}, m_b), e).b.x(),
               IsNear(1.6, rounding).of("velocity of b [m/s]"));
}

//> Erratum E8.4
TEST_CASE("erratum E8.4: the code's comment has (m_a - e m_b) and a plus; with e = 0.5, b would leave at 2.2",
          "[8.3]") {
    const double e = 0.5, m_a = 2, m_b = 3, v_ai = 4, v_bi = -2;
    const double printed = ((e + 1) * m_a * v_ai + v_bi * (m_a - e * m_b)) / (m_a + m_b);
    CHECK_THAT(printed, IsNear(2.2, rounding).of("velocity of b, as in the comment [m/s]"));
    CHECK_THAT(resolve_collision(ball({0, 0}, {v_ai, 0}, m_a), ball({1, 0}, {v_bi, 0}, m_b), e).b.x(),
               IsNear(1.6, rounding).of("velocity of b [m/s]"));
}

//>
TEST_CASE("however slowly balls approach, they bounce as fast ones do: no speed is too small to count", "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {5e-10, 0}), ball({0.8, 0.6}, {0, 0}), 0.5),
               IsNear(Velocities{{2.6e-10, -1.8e-10}, {2.4e-10, 1.8e-10}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {9e-12, 0}), ball({1, 0}, {0, 0}), 1),
               IsNear(Velocities{{0, 0}, {9e-12, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {3 + 1e-9, 0}, 2), ball({1, 0}, {3, 0}, 2), 1),
               IsNear(Velocities{{3, 0}, {3 + 1e-9, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {3 - 1e-9, 0}, 2), ball({1, 0}, {3, 0}, 2), 1),
               IsNear(Velocities{{3 - 1e-9, 0}, {3, 0}}, rounding));
}

TEST_CASE("very different masses, and fast balls", "[8.3]") {
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 1e-3), ball({1, 0}, {-2, 3}, 1e3), 0),
               IsNear(Velocities{{-2 + 6e-6, 1}, {-2 + 6e-6, 3}}, 1e-6));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 1e5), ball({1, 0}, {-2, 3}, 1e-3), 1),
               IsNear(Velocities{{4, 1}, {10, 3}}, 1e-4));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 1e-9), ball({1, 0}, {-2, 3}, 1e-9), 0.5),
               IsNear(Velocities{{-0.5, 1}, {2.5, 3}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 1e5), ball({1, 0}, {-2, 3}, 1e5), 0.5),
               IsNear(Velocities{{-0.5, 1}, {2.5, 3}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 1}, 2), ball({1, 0}, {-2, 3}, 2 + 1e-9), 0.5),
               IsNear(Velocities{{-0.5, 1}, {2.5, 3}}, 1e-8));
    CHECK_THAT(resolve_collision(ball({0, 0}, {1e5, 0}), ball({1, 0}, {-1e5, 0}, 3), 1),
               IsNear(Velocities{{-2e5, 0}, {0, 0}}, 1e-7)); // larger than what goes in
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 1}, 2), ball({6e-10, 8e-10}, {-1, -1}, 3), 0.8),
               IsNear(Velocities{{0.408, -2.456}, {0.728, 1.304}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 1}, 2), ball({1.2e-60, 1.6e-60}, {-1, -1}, 3), 0.8),
               IsNear(Velocities{{0.408, -2.456}, {0.728, 1.304}}, rounding));
    CHECK_THAT(resolve_collision(ball({-1e5, 1e5}, {4, 0}, 2), ball({1e5, 1e5}, {-2, 0}, 3), 0.5),
               IsNear(Velocities{{-1.4, 0}, {1.6, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 0}, 2), ball({0.999, 0}, {-2, 0}, 3), 0.5),
               IsNear(Velocities{{-1.4, 0}, {1.6, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 0}, 2), ball({1 + 5e-10, 0}, {-2, 0}, 3), 0.5),
               IsNear(Velocities{{-1.4, 0}, {1.6, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 0}, 2), ball({1, 0}, {-2, 0}, 3), 1e-10),
               IsNear(Velocities{{0.4 - 3.6e-10, 0}, {0.4 + 2.4e-10, 0}}, 1e-11));
    CHECK_THAT(resolve_collision(ball({0, 0}, {4, 0}, 2), ball({1, 0}, {-2, 0}, 3), 1 - 1e-10),
               IsNear(Velocities{{-3.2 + 3.6e-10, 0}, {2.8 - 2.4e-10, 0}}, 1e-11));
    CHECK_THAT(resolve_collision(ball({0, 0}, {0, 0}, 2), ball({1, 0}, {0, 0}, 3), 1),
               IsNear(Velocities{{0, 0}, {0, 0}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {0, 0}, 2), ball({1, 0}, {-5, 0}, 3), 0.5),
               IsNear(Velocities{{-4.5, 0}, {-2, 0}}, rounding));            // a rests
    for (const Vec2 &n : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) // b to the right of a, above, left, below
        CHECK_THAT(resolve_collision(ball({1, 1}, {3, 2}, 2), ball(Vec2{1, 1} + n, Vec2{3, 2} - 5 * n, 3), 1),
                   IsNear(Velocities{Vec2{3, 2} - 6 * n, Vec2{3, 2} - n}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {5, 0}, 2), ball({1, 1e-10}, {0, 0}, 3), 1), // nearly level
               IsNear(Velocities{{-1, -6e-10}, {4, 4e-10}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {5, 0}, 2), ball({1e-10, 1}, {0, 0}, 3), 1), // nearly upright
               IsNear(Velocities{{5, -6e-10}, {0, 4e-10}}, rounding));
    CHECK_THAT(resolve_collision(ball({0, 0}, {3, 1}, 1e-9), ball({0.6, 0.8}, {-1, -1}, 1.5e-9), 0.8),
               IsNear(Velocities{{0.408, -2.456}, {0.728, 1.304}}, rounding)); // light ones, and nearly of one mass
    CHECK_THAT(resolve_collision(ball({0, 0}, {0, 1e5}, 1e5), ball({0, 1}, {0, 0}, 1e5), 0),
               IsNear(Velocities{{0, 5e4}, {0, 5e4}}, 1e-11));
    CHECK_THAT(resolve_collision(ball({0, 0}, {1e5, 0}, 9), ball({1, 0}, {-1e5, 0}, 1), 1),
               IsNear(Velocities{{6e4, 0}, {2.6e5, 0}}, 1e-11)); // larger than twice what goes in
    CHECK_THAT(resolve_collision(ball({0, 0}, {1e5, 1e5}), ball({1, 1}, {-1e5, -1e5}), 1),
               IsNear(Velocities{{-1e5, -1e5}, {1e5, 1e5}}, 1e-11));
    CHECK_THAT(resolve_collision(ball({-1e5, -1e5}, {1, 1}), ball({1e5, 1e5}, {-1, -1}), 1),
               IsNear(Velocities{{-1, -1}, {1, 1}}, rounding));
    for (const double times : {20.0, 2000.0, 2e5, 2e10}) { // one ball is so many times as heavy as the other
        const Ball light = ball({0, 0}, {4, 1}, 1e-9), heavy = ball({1, 0}, {-2, 3}, times * 1e-9);
        const double share = 1 / (times + 1); // of both masses that is in the light one
        const Vec2 light_after{-5 + 9 * share, 1}, heavy_after{-2 + 9 * share, 3};
        const double tolerance = times * 1e-11; // a digit fewer for each factor of ten
        CHECK_THAT(resolve_collision(light, heavy, 0.5), IsNear(Velocities{light_after, heavy_after}, tolerance));
        CHECK_THAT(resolve_collision(heavy, light, 0.5), IsNear(Velocities{heavy_after, light_after}, tolerance));
        CHECK_THAT(resolve_collision(ball({0, 0}, {6, -2}, 1e-9), ball({1, 0}, {0, 0}, times * 1e-9), 0.5),
                   IsNear(Velocities{{-3 + 9 * share, -2}, {9 * share, 0}}, tolerance)); // the heavy one rests
    }
}

TEST_CASE("a restitution that is not from 0 to 1 is refused", "[8.3]") {
    const Ball a = ball({0, 0}, {3, 1}, 2), b = ball({0.6, 0.8}, {-1, -1}, 3);
    for (const double bad : {-1.0, -1e-9, std::nextafter(1, 2), 1.2, 80.0}) {
        CHECK_REFUSED(resolve_collision(a, b, bad));
        CHECK_REFUSED(resolve_collision(b, a, bad));
    }
    CHECK_REFUSED(resolve_collision(ball({0, 0}, {-3, 0}), ball({1, 0}, {3, 0}), 1.2),
                  "a restitution of 1.2, with balls that part");
    resolve_collision(a, b, 0), resolve_collision(a, b, 1); // good input is still answered
    resolve_collision(a, b, 1e-300);
}

TEST_CASE("centres at one point, or a radius or a mass that is not positive, are refused", "[8.3]") {
    const Ball a = ball({0, 0}, {3, 1}, 2), b = ball({0.6, 0.8}, {-1, -1}, 3);
    CHECK_REFUSED(resolve_collision(a, a, 0.8), "the same ball twice");
    for (const double bad : {0.0, -1e-9, -1.0}) {
        CHECK_REFUSED(resolve_collision({{0, 0}, {3, 1}, bad, 2}, b, 0.8), "the radius of a is not positive");
        CHECK_REFUSED(resolve_collision({{0, 0}, {3, 1}, 0.5, bad}, b, 0.8), "the mass of a is not positive");
        CHECK_REFUSED(resolve_collision(a, {{0.6, 0.8}, {-1, -1}, bad, 3}, 0.8), "the radius of b is not positive");
        CHECK_REFUSED(resolve_collision(a, {{0.6, 0.8}, {-1, -1}, 0.5, bad}, 0.8), "the mass of b is not positive");
    }
    check_the_ends(resolve_collision, {a, b, 0.8});
    resolve_collision(a, b, 0.8); // good input is still answered
}

// -------------------------------------------------------------------------------------------------- 8.4 time_of_impact

constexpr double in_time =
    1e-8; // of worked examples [s]: what an error of 4e-9 m makes at a metre per second, and more

const std::optional<double> never{};

/// How far the edges are apart at this time; negative: they overlap.
static double gap_at(double time, const Ball &a, const Ball &b) {
    return (b.position - a.position + time * (b.velocity - a.velocity)).norm() - a.radius - b.radius;
}

//> Worked example: 0.64 s
TEST_CASE("at (5, 0) m/s, from (0, 0), a ball touches one that rests at (4, 0.6) after 0.64 s", "[8.4]") {
    // 0.64 s later it is at (3.2, 0), from where (0.8, 0.6) leads to the other: 1 m, the sum of the radii
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 0.6}, {0, 0})), IsNear(0.64, in_time));
}

//> Both move, at an angle
TEST_CASE("from (0, 0) at (3, 1) m/s, and from (3, 2) at (-1, -1) m/s, two balls touch after 0.6 s", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 1}, 2), ball({3, 2}, {-1, -1}, 3)), IsNear(0.6, in_time));
}

//> Passing by
TEST_CASE("balls that pass by each other never touch", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 1.1}, {0, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, -7}, {0, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 0}), ball({3, 0}, {0, 3})), IsNear(never)); // it is gone by then
}

//> Straight at each other
TEST_CASE("head on, the gap closes at the sum of both speeds, or at their difference", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 0}), ball({7, 0}, {0, 0})), IsNear(2.0, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 0}), ball({7, 0}, {-1, 0})), IsNear(1.5, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 0}), ball({7, 0}, {1, 0})), IsNear(3.0, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {0, -1}), ball({0, 7}, {0, -3})), IsNear(3.0, in_time));
}

//> Their radii
TEST_CASE("the centres are as far apart as both radii together when the balls touch", "[8.4]") {
    CHECK_THAT(time_of_impact({{0, 0}, {3, 0}, 0.25, 1}, {{7, 0}, {0, 0}, 0.75, 1}), IsNear(2.0, in_time));
    CHECK_THAT(time_of_impact({{0, 0}, {3, 0}, 1, 1}, {{7, 0}, {0, 0}, 3, 1}), IsNear(1.0, in_time));
    CHECK_THAT(time_of_impact({{0, 0}, {5, 0}, 0.5, 1}, {{4, 1.1}, {0, 0}, 0.7, 1}).has_value(),
               IsTrue("a ball of 0.7 m is hit where one of 0.5 m would not be"));
}

//> Away from each other
TEST_CASE("balls that move away from each other, or alike, or rest, never touch", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {-5, 0}), ball({4, 0.6}, {0, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {-3, -1}), ball({3, 2}, {1, 1})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {1, 0}), ball({4, 0}, {3, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 2}), ball({4, 0.6}, {5, 2})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {0, 0}), ball({4, 0.6}, {0, 0})), IsNear(never));
}

//> In contact now
TEST_CASE("balls that touch or overlap now: 0 s if their centres get closer, and otherwise never", "[8.4]") {
    const double x = GENERATE(1.0, 0.999, 0.9, 0.1); // they touch, or overlap by a millimetre, or more
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 1}), ball({x, 0}, {-1, 1})), IsNear(0.0, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 9}), ball({x, 0}, {0, -9})), IsNear(0.0, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {-3, 1}), ball({x, 0}, {1, 1})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {0, 3}), ball({x, 0}, {0, -1})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {2, 3}), ball({x, 0}, {2, 3})), IsNear(never));
}

//> A millimetre decides
TEST_CASE("a ball that comes a millimetre too far to the side does not touch, one a millimetre nearer does", "[8.4]") {
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 1.001}, {0, 0})), IsNear(never));
    const Ball a = ball({0, 0}, {5, 0}), b = ball({4, 0.999}, {0, 0});
    CHECK_THAT(gap_at(time_of_impact(a, b).value(), a, b), IsNear(0.0, 4e-9).of("gap between the edges [m]"));
    CHECK_THAT(time_of_impact(a, b), IsNear((4 - std::sqrt(1 - 0.999 * 0.999)) / 5, 1e-7));
}

//> No gap, and none before
TEST_CASE("at the answer's time there is no gap, before it there is one, and the balls approach", "[8.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 from = dice.point(-10, 10), side = dice.direction();
        const double radius = dice.real(0.1, 1), other = dice.real(0.1, 1), away = dice.real(1.05, 8);
        const Vec2 to_b = away * (radius + other) * side;
        const double aim = dice.real(-0.99, 0.99) * std::asin(1 / away); // within the angle at which b is seen
        const Vec2 drift = dice.point(-5, 5), towards = turned(side, aim);
        const Ball a{from, drift + dice.real(0.5, 5) * towards, radius, dice.real(0.5, 8)};
        const Ball b{from + to_b, drift, other, dice.real(0.5, 8)};

        const double time = time_of_impact(a, b).value();

        CHECK_THAT(gap_at(time, a, b), IsNear(0.0, 1e-8).of("gap between the edges at that time [m]"));
        for (const double part : {0.25, 0.5, 0.9})
            CHECK_THAT(gap_at(part * time, a, b), IsAbove(0).of("gap between the edges before that time [m]"));
        const Vec2 apart = b.position - a.position + time * (b.velocity - a.velocity);
        CHECK_THAT(apart.dot(a.velocity - b.velocity), IsAbove(0).of("speed at which they approach then, by metres"));
    }
}

//> Aimed beside it
TEST_CASE("aimed past the edge, or away, two balls never touch", "[8.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 from = dice.point(-10, 10), side = dice.direction();
        const double radius = dice.real(0.1, 1), other = dice.real(0.1, 1), away = dice.real(1.05, 8);
        const double seen_from = std::asin(1 / away), aim = dice.sign() * dice.real(1.01 * seen_from, pi);
        const Vec2 drift = dice.point(-5, 5);
        const Ball a{from, drift + dice.real(0.5, 5) * turned(side, aim), radius, 1};
        const Ball b{from + away * (radius + other) * side, drift, other, 1};
        CHECK_THAT(time_of_impact(a, b), IsNear(never));
    }
}

//> From either ball, from any train
TEST_CASE("with a and b exchanged, from a moving train, and for any masses, the time is the same", "[8.4]") {
    const Ball a = ball({0, 0}, {3, 1}, 2), b = ball({3, 2}, {-1, -1}, 3);
    CHECK_THAT(time_of_impact(b, a), IsNear(0.6, in_time));
    const Vec2 train{-10, 3}, platform{20, -7};
    CHECK_THAT(time_of_impact(ball(platform, Vec2{3, 1} - train), ball(platform + Vec2{3, 2}, Vec2{-1, -1} - train)),
               IsNear(0.6, 1e-7));
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 1}, 1e5), ball({3, 2}, {-1, -1}, 1e-9)), IsNear(0.6, in_time));
}

//> Through it in one frame
TEST_CASE("a ball that would be beyond the other one a frame later touches it within the frame", "[8.4]") {
    const Ball a = ball({0, 0}, {600, 0}), b = ball({5, 0}, {0, 0}); // in 1/60 s it moves by 10 m
    CHECK_THAT(time_of_impact(a, b), IsNear(4.0 / 600, in_time));
}

//> Erratum E8.8
TEST_CASE("erratum E8.8: the printed balls meet at 1.5 radii, a quarter of a diameter inside each other", "[8.4]") {
    const Ball a = ball({0, 0}, {1, 0}), b = ball({3, 0}, {0, 0});
    const double time = time_of_impact(a, b).value(), printed = 3 - 1.5 * a.radius;
    CHECK_THAT(time, IsNear(2.0, in_time).of("time of contact [s]"));
    CHECK_THAT(gap_at(printed, a, b), IsNear(-0.25, rounding).of("gap at the printed time of contact [m]"));
}

//>
TEST_CASE("tiny balls far away, slow ones, fast ones that move nearly alike, and balls on their way for long",
          "[8.4]") {
    const auto exact = [](const Ball &a, const Ball &b, double tolerance) {
        const double time = time_of_impact(a, b).value();
        const Vec2 speed = b.velocity - a.velocity, apart = b.position - a.position + time * speed;
        CHECK_THAT(gap_at(time, a, b), IsNear(0.0, tolerance).of("gap between the edges at that time [m]"));
        CHECK_THAT(apart.dot(speed) / speed.norm(),
                   IsAtMost(tolerance).of("how far beyond the nearest point it is [m]"));
    };
    exact({{0, 0}, {1, 0}, 1e-3, 1}, {{1e5, 0}, {0, 0}, 1e-3, 1}, 0.1);
    exact({{0, 0}, {1e5, 0}, 5, 1}, {{1e4, 9.9}, {-1e5, 0}, 5, 1}, 1e-5);
    exact({{-1e5, -1e5}, {1e5, 1e5}, 100, 1}, {{1e5, 1e5}, {-1e5, -1e5}, 150, 1}, 1e-4);
    exact({{-1e5, -1e5}, {1, 1}, 100, 1}, {{1e5, 1e5}, {-1, -1}, 150, 1}, 1e-4);
    exact({{0, 0}, {1e5, 7}, 0.5, 1}, {{10, 0.3}, {1e5 - 1e-3, 7}, 0.5, 1}, 1e-8);
    exact({{0, 0}, {1e5, 7}, 0.5, 1}, {{10, 0.3}, {std::nextafter(1e5, 0), 7}, 0.5, 1}, 1e-8);
    exact({{0, 0}, {1e-9, 0}, 0.5, 1}, {{10, 0.3}, {-1e-9, 0}, 0.5, 1}, 1e-8);
    exact({{0, 0}, {1e-20, 0}, 0.5, 1}, {{10, 0.3}, {0, 0}, 0.5, 1}, 1e-8);
    exact({{0, 0}, {1e-9, 0}, 1e-9, 1}, {{5e-9, 1e-9}, {0, 0}, 1e-9, 1}, 1e-17);
    exact({{0, 0}, {2, 0}, 1e5, 1}, {{1e5, 1e5}, {0, 0}, 1e4, 1}, 1e-4);
    exact(ball({0, 0}, {3, 0}), ball({1 + 1e-6, 0}, {0, 0}), 1e-9);
    exact(ball({0, 0}, {1e5, 0}), ball({1 + 1e-8, 0}, {0, 0}), 1e-9);
    exact({{0, 0}, {1, 0}, 1e-10, 1}, {{1e-9, 0}, {0, 0}, 1e-10, 1}, 1e-17);
    exact({{-1e5, 0}, {1, 0}, 1e5, 1}, {{1e5, 1e5}, {0, 0}, 1e5, 1}, 1e-4);
    // along x or along y only, from another row or column
    CHECK_THAT(time_of_impact(ball({0, 0}, {0, 3}), ball({0.6, 4}, {0, 0})), IsNear(3.2 / 3, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {2, 3}), ball({-0.6, 4}, {2, 0})), IsNear(3.2 / 3, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {3, 2}), ball({4, 0.6}, {0, 2})), IsNear(3.2 / 3, in_time));
    CHECK_THAT(time_of_impact({{0, 0}, {1e-20, 0}, 0.5, 1}, {{3, 0}, {0, 0}, 0.5, 1}), IsNear(2e20, 1e-8));
    CHECK_THAT(time_of_impact({{0, 0}, {1e-5, 0}, 0.5, 1}, {{11, 0}, {0, 0}, 0.5, 1}), IsNear(1e6, 1e-8));
    CHECK_THAT(time_of_impact(ball({0, 0}, {-1e-9, 0}), ball({3, 0}, {0, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {1e5, 0}), ball({3, 0}, {1e5, 1e-9})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {1e5, 0}), ball({-3, 0}, {0, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({2, 2}, {3, 1}), ball({2, 2}, {-1, -1})), IsNear(never)); // at one point already
    CHECK_THAT(time_of_impact(ball({0, 0}, {1e-9, 0}), ball({0.9, 0}, {0, 0})), IsNear(0.0, in_time));
    CHECK_THAT(time_of_impact(ball({0, 0}, {-1e-9, 0}), ball({0.9, 0}, {0, 0})), IsNear(never));
    for (const double overlap : {5e-4, 5e-7, 5e-10}) // no negative time, however shallow it is
        CHECK_THAT(time_of_impact(ball({0, 0}, {1e-9, 0}), ball({1 - overlap, 0}, {0, 0})), IsNear(0.0));
    CHECK_THAT(time_of_impact(ball({0, 0}, {1, 0}), ball({1e-10, 0}, {0, 0})), IsNear(0.0)); // hardly apart
    CHECK_THAT(time_of_impact(ball({0, 0}, {1, 0}), ball({1e-55, 0}, {0, 0})), IsNear(0.0));
    CHECK_THAT(time_of_impact({{0, 0}, {1, 0}, 0.5, 1}, {{0.5, 0}, {0, 0}, 2, 1}), IsNear(0.0)); // one in the other
    CHECK_THAT(time_of_impact({{0, 0}, {1, 0}, 2, 1}, {{0.5, 0}, {0, 0}, 0.5, 1}), IsNear(0.0));
    CHECK_THAT(time_of_impact({{0, 0}, {-1, 0}, 0.5, 1}, {{0.5, 0}, {0, 0}, 2, 1}), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {5e-4, 0}), ball({10, 1.4}, {0, 0})), IsNear(never)); // slowly past it
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 1 + 1e-6}, {0, 0})), IsNear(never));
    CHECK_THAT(time_of_impact(ball({0, 0}, {5, 0}), ball({4, 1 - 1e-6}, {0, 0})),
               IsNear((4 - std::sqrt(1 - (1 - 1e-6) * (1 - 1e-6))) / 5, 1e-6));
}

TEST_CASE("a radius or a mass that is not positive is refused by time_of_impact", "[8.4]") {
    const Ball a = ball({0, 0}, {5, 0}), b = ball({4, 0.6}, {0, 0});
    for (const double bad : {0.0, -1e-9, -1.0}) {
        CHECK_REFUSED(time_of_impact({{0, 0}, {5, 0}, bad, 1}, b), "the radius of a is not positive");
        CHECK_REFUSED(time_of_impact({{0, 0}, {5, 0}, 0.5, bad}, b), "the mass of a is not positive");
        CHECK_REFUSED(time_of_impact(a, {{4, 0.6}, {0, 0}, bad, 1}), "the radius of b is not positive");
        CHECK_REFUSED(time_of_impact(a, {{4, 0.6}, {0, 0}, 0.5, bad}), "the mass of b is not positive");
    }
    check_the_ends(time_of_impact, {a, b});
    check_the_ends(time_of_impact, {a, ball({4, 0.6}, {5, 0})}); // at rest, as seen from each other
    time_of_impact(a, b);                                        // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 8.5 push_apart

//> Worked example: an overlap of 0.2 m
TEST_CASE("two equal discs that overlap by 0.2 m are moved by 0.1 m each", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{0.8, 0}, 0.5, 1}), IsNear(Positions{{-0.1, 0}, {0.9, 0}}, rounding));
}

//> Twice the mass
TEST_CASE("the one with twice the mass moves half as far", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 0.5}, {{0.7, 0}, 0.5, 1}), IsNear(Positions{{-0.1, 0}, {0.9, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{0.7, 0}, 0.5, 0.5}), IsNear(Positions{{-0.2, 0}, {0.8, 0}}, rounding));
}

//> A post
TEST_CASE("a post stays, and the ball moves all the way", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 0}, {{0.8, 0}, 0.5, 1}), IsNear(Positions{{0, 0}, {1, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 3}, {{0.8, 0}, 0.5, 0}), IsNear(Positions{{-0.2, 0}, {0.8, 0}}, rounding));
}

//> Along the line of centres
TEST_CASE("discs are moved along the line of centres, wherever they are", "[8.5]") {
    CHECK_THAT(push_apart({{2, 7}, 0.5, 1}, {{2.3, 7.4}, 0.5, 1}),
               IsNear(Positions{{1.85, 6.8}, {2.45, 7.6}}, 1e-11).since("n = (0.6, 0.8), and they overlap by 0.5 m"));
    CHECK_THAT(push_apart({{0, 0}, 3, 1}, {{3, 4}, 4, 3}), IsNear(Positions{{-0.3, -0.4}, {3.9, 5.2}}, rounding));
    CHECK_THAT(push_apart({{0, 0.8}, 0.5, 1}, {{0, 0}, 0.5, 1}), IsNear(Positions{{0, 0.9}, {0, -0.1}}, rounding));
}

//> Where they are
TEST_CASE("discs that do not overlap, or just touch, stay where they are", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{1.2, 0}, 0.5, 1}), IsNear(Positions{{0, 0}, {1.2, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{9, 40}, 0.5, 1}), IsNear(Positions{{0, 0}, {9, 40}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{1, 0}, 0.5, 1}), IsNear(Positions{{0, 0}, {1, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 2, 1}, {{3, 4}, 3, 1}), IsNear(Positions{{0, 0}, {3, 4}}, rounding));
}

//> Two posts
TEST_CASE("two posts stay where they are, even if they overlap", "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 0.5, 0}, {{0.8, 0}, 0.5, 0}), IsNear(Positions{{0, 0}, {0.8, 0}}, rounding));
    CHECK_THAT(push_apart({{2, 7}, 0.5, 0}, {{2, 7}, 0.5, 0}), IsNear(Positions{{2, 7}, {2, 7}}, rounding));
}

//> At one point
TEST_CASE("with both centres at one point, a is moved to the left and b to the right, by their inverse masses",
          "[8.5]") {
    CHECK_THAT(push_apart({{2, 7}, 0.5, 1}, {{2, 7}, 0.5, 1}), IsNear(Positions{{1.5, 7}, {2.5, 7}}, rounding));
    CHECK_THAT(push_apart({{2, 7}, 0.5, 1}, {{2, 7}, 0.5, 3}), IsNear(Positions{{1.75, 7}, {2.75, 7}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 0}, {{0, 0}, 0.5, 1}), IsNear(Positions{{0, 0}, {1, 0}}, rounding));
}

//> Discs exchanged
TEST_CASE("with a and b exchanged, the answers are exchanged", "[8.5]") {
    CHECK_THAT(push_apart({{0.7, 0}, 0.5, 1}, {{0, 0}, 0.5, 0.5}), IsNear(Positions{{0.9, 0}, {-0.1, 0}}, rounding));
    CHECK_THAT(push_apart({{3, 4}, 4, 3}, {{0, 0}, 3, 1}), IsNear(Positions{{3.9, 5.2}, {-0.3, -0.4}}, rounding));
}

//> Touching, and in balance
TEST_CASE("afterwards they just touch, on the same line, and their centre of mass has not moved", "[8.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 at = dice.point(-10, 10), n = dice.direction();
        const double mass_a = dice.real(0.5, 8), mass_b = dice.real(0.5, 8);
        const Disc a{at, dice.real(0.2, 1), 1 / mass_a}, rough{at, dice.real(0.2, 1), 1 / mass_b};
        const double touching = a.radius + rough.radius;
        const Disc b{at + dice.real(0.05, 0.99) * touching * n, rough.radius, rough.inverse_mass};

        const Positions after = push_apart(a, b);

        CHECK_THAT((after.b - after.a).norm(), IsNear(touching, 1e-10).of("distance of the centres afterwards [m]"));
        CHECK_THAT((after.b - after.a).dot(n), IsNear(touching, 1e-10).of("the same, along the line of centres [m]"));
        CHECK_THAT(Vec2{(mass_a * after.a + mass_b * after.b) / (mass_a + mass_b)},
                   IsNear(Vec2{(mass_a * a.position + mass_b * b.position) / (mass_a + mass_b)}, 1e-10)
                       .of("centre of mass afterwards [m]"));
    }
}

//> Pushed twice
TEST_CASE("asked again with the answer, it moves nothing any more", "[8.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        Disc a{dice.point(-1, 1), dice.real(0.2, 1), dice.real(0, 3)};
        Disc b{dice.point(-1, 1), dice.real(0.2, 1), dice.real(0.1, 3)};
        const Positions once = push_apart(a, b);
        a.position = once.a, b.position = once.b;
        CHECK_THAT(push_apart(a, b), IsNear(once, 1e-11));
    }
}

//>
TEST_CASE("large, tiny, distant and very different discs, overlaps by a hair, and centres that are hardly apart",
          "[8.5]") {
    CHECK_THAT(push_apart({{0, 0}, 1e5, 1}, {{1e5, 0}, 1e5, 1}), IsNear(Positions{{-5e4, 0}, {1.5e5, 0}}, rounding));
    CHECK_THAT(push_apart({{-1e5, 0}, 0.5, 1}, {{-1e5, 0}, 0.5, 1}),
               IsNear(Positions{{-1e5 - 0.5, 0}, {-1e5 + 0.5, 0}}, rounding)); // beyond what goes in
    CHECK_THAT(push_apart({{0, 0}, 1, 0}, {{0, 0}, 1e5, 1}), IsNear(Positions{{0, 0}, {100001, 0}}, rounding));
    CHECK_THAT(push_apart({{-1e5, -1e5}, 0.5, 1}, {{1e5, 1e5}, 0.5, 1}),
               IsNear(Positions{{-1e5, -1e5}, {1e5, 1e5}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 5e-10, 1}, {{8e-10, 0}, 5e-10, 1}),
               IsNear(Positions{{-1e-10, 0}, {9e-10, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{0, 8e-10}, 0.5, 1}),
               IsNear(Positions{{0, -0.5 + 4e-10}, {0, 0.5 + 4e-10}}, rounding)); // not to the left and right
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{-8e-60, 6e-60}, 0.5, 1}),
               IsNear(Positions{{0.4, -0.3}, {-0.4, 0.3}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{1 - 1e-9, 0}, 0.5, 1}),
               IsNear(Positions{{-5e-10, 0}, {1 - 5e-10, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{1 + 1e-9, 0}, 0.5, 1}),
               IsNear(Positions{{0, 0}, {1 + 1e-9, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1}, {{1 - 9e-12, 0}, 0.5, 0}),
               IsNear(Positions{{-9e-12, 0}, {1 - 9e-12, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1e-3}, {{0.8, 0}, 0.5, 0}), IsNear(Positions{{-0.2, 0}, {0.8, 0}}, rounding));
    CHECK_THAT(push_apart({{2, 7}, 0.5, 1}, {{2, 7}, 0.5, 0}), IsNear(Positions{{1, 7}, {2, 7}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 1e5, 9e-12}, {{0, 0}, 1e5, 1}),
               IsNear(Positions{{-1.8e-6, 0}, {2e5 - 1.8e-6, 0}}, 1e-7));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1e-5}, {{0.8, 0}, 0.5, 1e5}),
               IsNear(Positions{{-2e-11, 0}, {1 - 2e-11, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1e-20}, {{0.8, 0}, 0.5, 1e-20}),
               IsNear(Positions{{-0.1, 0}, {0.9, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 0.5, 1e5}, {{0.8, 0}, 0.5, 1e5}), IsNear(Positions{{-0.1, 0}, {0.9, 0}}, rounding));
    CHECK_THAT(push_apart({{0, 0}, 5, 1}, {{1, 0}, 0.5, 1}), IsNear(Positions{{-2.25, 0}, {3.25, 0}}, rounding));
}

TEST_CASE("a radius that is not positive, or a negative inverse mass, is refused", "[8.5]") {
    const Disc a{{0, 0}, 0.5, 1}, b{{0.8, 0}, 0.5, 1};
    for (const double bad : {0.0, -1e-9, -1.0}) {
        CHECK_REFUSED(push_apart({{0, 0}, bad, 1}, b), "the radius of a is not positive");
        CHECK_REFUSED(push_apart(a, {{0.8, 0}, bad, 1}), "the radius of b is not positive");
    }
    for (const double bad : {-1e-9, -1.0}) {
        CHECK_REFUSED(push_apart({{0, 0}, 0.5, bad}, b), "the inverse mass of a is negative");
        CHECK_REFUSED(push_apart(a, {{0.8, 0}, 0.5, bad}), "the inverse mass of b is negative");
    }
    CHECK_REFUSED(push_apart({{0, 0}, 0.5, -1}, {{9, 0}, 0.5, 1}), "a negative inverse mass, far from the other");
    check_the_ends(push_apart, {a, b});
    check_the_ends(push_apart, {Disc{{0, 0}, 0.5, 0}, Disc{{0.8, 0}, 0.5, 0}}); // two posts
    push_apart(a, b);                                                           // good input is still answered
}

// ----------------------------------------------------------------------------------------------------- 8.6 close_pairs

/// In the order of their indices.
static std::vector<Pair> sorted(std::vector<Pair> pairs) {
    std::ranges::sort(pairs, {}, [](const Pair &pair) { return std::pair{pair.first, pair.second}; });
    return pairs;
}
static auto IsPairs(const std::vector<Pair> &want) { return IsNear(want).of("the pairs, sorted"); }

/// Each with each.
static std::vector<Pair> all_close_pairs(const std::vector<Vec2> &points, double distance) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            if ((points[i] - points[j]).norm() <= distance) pairs.push_back({int(i), int(j)});
    return pairs;
}

//> Worked example: four points
TEST_CASE("of four points, the two pairs that are no farther apart than 1 m are found", "[8.6]") {
    // 0 and 1 are 0.9 m apart, 1 and 3 are 0.5 m apart, and 2 is far from all
    CHECK_THAT(sorted(close_pairs({{0.2, 0.5}, {1.1, 0.5}, {5, 5}, {1.1, 1}}, 1)), IsPairs({{0, 1}, {1, 3}}));
}

//> Nobody near
TEST_CASE("without points, with one, and with two that are too far apart, there are no pairs", "[8.6]") {
    CHECK_THAT(close_pairs({}, 1), HasSize(0));
    CHECK_THAT(close_pairs({{3, 4}}, 1), HasSize(0));
    CHECK_THAT(close_pairs({{0, 0}, {3, 4}}, 4.9), HasSize(0));
    CHECK_THAT(close_pairs({{0.1, 0.1}, {0.9, 0.9}}, 1), HasSize(0)); // in one cell, and 1.13 m apart
}

//> Across the edges of cells
TEST_CASE("points in neighbouring cells are found, to the side, above, and across a corner", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{0.9, 0.9}, {1.1, 0.9}, {0.9, 1.1}, {1.1, 1.1}}, 1)),
               IsPairs({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
    CHECK_THAT(sorted(close_pairs({{1.1, 0.9}, {0.9, 1.1}}, 1)), IsPairs({{0, 1}}));
    CHECK_THAT(sorted(close_pairs({{0.9, 1.1}, {1.1, 0.9}}, 1)), IsPairs({{0, 1}}));
}

//> Left of zero and below it
TEST_CASE("points with negative coordinates are found, and pairs on either side of 0", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{-0.3, -0.3}, {0.3, 0.3}, {-5.9, -7.2}, {-6.1, -6.9}}, 1)),
               IsPairs({{0, 1}, {2, 3}}));
    CHECK_THAT(sorted(close_pairs({{-0.8, 0.2}, {0.8, 0.2}, {0, -0.3}}, 1)), IsPairs({{0, 2}, {1, 2}}));
}

//> A centimetre, a hundred metres
TEST_CASE("the distance may be a centimetre or a hundred metres", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{0, 0}, {0.008, 0}, {0.012, 0}}, 0.01)), IsPairs({{0, 1}, {1, 2}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {80, 0}, {120, 0}}, 100)), IsPairs({{0, 1}, {1, 2}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {2, 0}, {5, 0}}, 2.5)), IsPairs({{0, 1}}));
}

//> At the same place
TEST_CASE("points at the same place are a pair, and three of them are three", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{3, 4}, {3, 4}, {3, 4}}, 1)), IsPairs({{0, 1}, {0, 2}, {1, 2}}));
    CHECK_THAT(close_pairs(std::vector<Vec2>(500, {3, 4}), 1), HasSize(124750)); // 500 · 499 / 2
}

//> Each once
TEST_CASE("each pair is there once, the smaller index first, in whatever order the points come", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{2.9, 0}, {2.1, 0}, {1.4, 0}, {0.6, 0}}, 1)), IsPairs({{0, 1}, {1, 2}, {2, 3}}));
    CHECK_THAT(sorted(close_pairs({{1.4, 0}, {2.9, 0}, {0.6, 0}, {2.1, 0}}, 1)), IsPairs({{0, 2}, {0, 3}, {1, 3}}));
    CHECK_THAT(sorted(close_pairs({{0.9, 0.9}, {0.1, 0.9}, {0.4, 0.5}}, 1)), IsPairs({{0, 1}, {0, 2}, {1, 2}}));
}

//> Each with each
TEST_CASE("comparing each point with each finds the same pairs, for crowds and for a few", "[8.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const double distance = dice.real(0.2, 3), half = dice.real(0.5, 12);
        const Vec2 middle = dice.point(-20, 20);
        std::vector<Vec2> points;
        for (int count = dice.whole(0, 120); count > 0; --count) points.push_back(middle + dice.point(-half, half));
        CHECK_THAT(sorted(close_pairs(points, distance)), IsPairs(all_close_pairs(points, distance)));
    }
}

//> On a lattice
TEST_CASE("on a lattice of 1 m, points have four neighbours within 1.2 m, and eight within 1.5 m", "[8.6]") {
    std::vector<Vec2> points;
    for (int x = -5; x < 5; ++x)
        for (int y = -5; y < 5; ++y) points.push_back({double(x), double(y)});
    CHECK_THAT(close_pairs(points, 1.2), HasSize(180)); // 90 side by side, and 90 one above the other
    CHECK_THAT(close_pairs(points, 1.5), HasSize(342)); // and two times 81 across a corner
    CHECK_THAT(close_pairs(points, 0.9), HasSize(0));
}

//> Asked again
TEST_CASE("an answer does not depend on what was asked before", "[8.6]") {
    CHECK_THAT(close_pairs({{0, 0}, {0.5, 0}, {0.5, 0.5}}, 1), HasSize(3));
    CHECK_THAT(close_pairs({{0, 0}, {0.5, 0}}, 1), HasSize(1));
    CHECK_THAT(close_pairs({{0, 0}, {0.5, 0}}, 0.4), HasSize(0));
    CHECK_THAT(close_pairs({}, 1), HasSize(0));
}

//>
TEST_CASE("far-flung points, large and small distances, and distances that differ from it by a hair", "[8.6]") {
    CHECK_THAT(sorted(close_pairs({{-1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}, {1e5, 1e5 - 0.0005}}, 0.001)),
               IsPairs({{1, 3}}));
    CHECK_THAT(sorted(close_pairs({{-99999, 0}, {99999, 0}, {0, 0}, {0, 99999}}, 1e5)),
               IsPairs({{0, 2}, {1, 2}, {2, 3}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {0.004, 0}, {0.006, 0}}, 0.005)), IsPairs({{0, 1}, {1, 2}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {1 - 1e-9, 0}, {0, 1 + 1e-9}}, 1)), IsPairs({{0, 1}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {1 - 5e-12, 0}, {0, 1 + 5e-12}}, 1)), IsPairs({{0, 1}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {0.6, 0.8 - 1e-9}, {-0.6, -0.8 - 1e-9}}, 1)), IsPairs({{0, 1}}));
    CHECK_THAT(sorted(close_pairs({{0, 0}, {1e-9, 0}, {0, 1e-60}}, 1)), IsPairs({{0, 1}, {0, 2}, {1, 2}}));
    CHECK_THAT(sorted(close_pairs({{3, 3}, {2 + 1e-9, 3}, {3, 4 - 1e-9}, {2 - 1e-9, 3}}, 1)),
               IsPairs({{0, 1}, {0, 2}, {1, 3}}));

    std::vector<Vec2> lonely; // a pair every hundred metres, from one end of the range to the other
    for (int i = 0; i < 2000; ++i)
        for (const double x : {0.5, 0.75}) lonely.push_back({-1e5 + 99 + 100 * i + x, 1e5 - 100 * i});
    const auto far_apart = [](const Pair &pair) { return pair.first % 2 == 0 && pair.second == pair.first + 1; };
    const std::vector<Pair> pairs = close_pairs(lonely, 1);
    CHECK_THAT(pairs, HasSize(2000));
    CHECK_THAT(std::ranges::all_of(pairs, far_apart), IsTrue("each pair is the two points at one place"));

    Dice dice;
    std::vector<Vec2> crowd; // in 2 cm, far out; no two of them are nearly a millimetre apart
    for (int i = 0; i < 400; ++i) crowd.push_back(Vec2{9e4, -9e4} + std::ldexp(1, -14) * dice.grid(0, 327));
    CHECK_THAT(sorted(close_pairs(crowd, 0.001)), IsPairs(all_close_pairs(crowd, 0.001)));
}

struct Carpet {
    int side; // points in a row
    Vec2 corner;
    double step, distance;
};

/// Numbers from 0 to `count` - 1, in any order.
static std::vector<int> shuffled(int count, Dice &dice) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    for (int i = count - 1; i > 0; --i) std::swap(numbers[i], numbers[dice.whole(0, i)]);
    return numbers;
}

//> A hundred thousand
TEST_CASE("a carpet of a hundred thousand balls is done within four seconds", "[8.6]") {
    course::allow(4);                           // comparing each with each takes far longer
    const auto [side, corner, step, distance] = // the second far out, with the smallest cells
        GENERATE(Carpet{317, {0, 0}, 0.7, 0.75}, Carpet{80, {9e4, 9e4}, 9e-4, 1e-3});
    Dice dice;
    std::vector<int> index; // of the ball at each place: each row is shuffled
    for (int row = 0; row < side; ++row)
        for (const int column : shuffled(side, dice)) index.push_back(row * side + column);
    std::vector<Vec2> points(index.size());
    std::vector<Pair> want;
    for (int place = 0; place < side * side; ++place) {
        const int column = place % side, row = place / side;
        points[index[place]] = corner + step * (Vec2{column, row} + dice.point(-0.007, 0.007));
        if (column > 0) want.push_back({index[place - 1], index[place]});
        if (row > 0) want.push_back({index[place - side], index[place]});
    }
    for (Pair &pair : want)
        if (pair.first > pair.second) std::swap(pair.first, pair.second);

    const std::vector<Pair> pairs = sorted(close_pairs(points, distance)); // across a corner, it is farther
    CHECK_THAT(pairs, HasSize(2 * side * (side - 1)).of("the pairs, sorted"));
    CHECK_THAT(pairs, IsPairs(sorted(want)));
}

//> In one line
TEST_CASE("forty thousand in one line, in any direction, are done within two seconds", "[8.6]") {
    constexpr int count = 40'000;
    course::allow(2);
    const Vec2 step = GENERATE(Vec2{0.7, 0}, Vec2{0, 0.7}, Vec2{0.5, 0.5}, Vec2{-0.5, 0.5});
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) points.push_back((i - count / 2) * step);
    for (const double far : {-6e4, 6e4}) points.push_back(far * quarter_turned(step)); // two more, far to either side
    CHECK_THAT(close_pairs(points, 0.75), HasSize(count - 1));
}

//>
TEST_CASE("a distance of less than a millimetre is refused by close_pairs", "[8.6]") {
    for (const double bad : {0.000999, 1e-9, 0.0, -1.0}) CHECK_REFUSED(close_pairs({{0, 0}, {0.5, 0}}, bad));
    CHECK_REFUSED(close_pairs({}, 0), "no points, and a distance of 0");
    check_the_ends(close_pairs, {std::vector<Vec2>{{3, 4}}, 1.0});
    check_the_ends(close_pairs, {std::vector<Vec2>(9, {3, 4}), 1.0});
    CHECK_THAT(close_pairs({{0, 0}, {0.0005, 0}}, 0.001), HasSize(1)); // good input is still answered
}
