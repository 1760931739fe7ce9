#include "section_test.hpp"

#include "motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

using motion::Integrators, motion::Motion, motion::PointMass, motion::Sample, motion::Screen, motion::State;
using namespace motion::subject; // px_per_second, uniform_motion, ... to_screen: the student's

// An answer is right to twelve digits of the largest term in its sum, unless it's said below; with numbers closer to 0
// than 1e-100, other than 0 itself, to fewer.

// --------------------------------------------------------------------------------------------------- 1.1 px_per_second

//> Worked example: pixels
TEST_CASE("4 px per frame at 30 frames per second are 120 px/s", "[1.1]") {
    CHECK_THAT(px_per_second(4, 30), IsNear(120.0, rounding)); // 4 px/frame · 30 frame/s
}

//> More pixels
TEST_CASE("more frames per second or more pixels per frame mean a higher speed; to the left it is negative", "[1.1]") {
    CHECK_THAT(px_per_second(4, 60), IsNear(240.0, rounding));
    CHECK_THAT(px_per_second(8, 60), IsNear(480.0, rounding));
    CHECK_THAT(px_per_second(8, 30), IsNear(240.0, rounding));
    CHECK_THAT(px_per_second(-4, 30), IsNear(-120.0, rounding));
    CHECK_THAT(px_per_second(2.5, 24), IsNear(60.0, rounding));
    CHECK_THAT(px_per_second(3, 0.5), IsNear(1.5, rounding)); // a frame every two seconds
    CHECK_THAT(px_per_second(0, 30), IsNear(0.0));
}

//>
TEST_CASE("the speed is the distance covered in one second, added up frame by frame", "[1.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double px = dice.real(-20, 20);
        const int frames = dice.whole(1, 240);
        double distance = 0;
        for (int frame = 0; frame < frames; ++frame) distance += px;

        CHECK_THAT(px_per_second(px, frames), IsNear(distance, 1e-11)); // 240 roundings of 5000 px
    }
}

TEST_CASE("px_per_second allows numbers up to ±1e5 and close to 0, and its answer may be larger", "[1.1]") {
    CHECK_THAT(px_per_second(1e5, 1e5), IsNear(1e10, rounding));
    CHECK_THAT(px_per_second(-1e5, 1e5), IsNear(-1e10, rounding));
    CHECK_THAT(px_per_second(1e-10, 1e5), IsNear(1e-5, rounding));
    CHECK_THAT(px_per_second(1e5, 1e-10), IsNear(1e-5, rounding)); // a frame every 300 years
    CHECK_THAT(px_per_second(1e5, 1e-300), IsNear(0.0, rounding)); // very few, but more than none
}

//> Refused
TEST_CASE("0 frames per second or fewer are refused", "[1.1]") {
    CHECK_REFUSED(px_per_second(4, 0), "no frames per second");
    CHECK_REFUSED(px_per_second(4, -30), "-30 frames per second");
    CHECK_REFUSED(px_per_second(4, -1e-300), "-1e-300 frames per second");
    CHECK_REFUSED(px_per_second(0, 0), "no frames per second, and nothing that moves");
    px_per_second(4, 30); // good input is still answered
}

//>
// -------------------------------------------------------------------------------------------------- 1.2 uniform_motion

//> Worked example: uniform motion
TEST_CASE("30 s at 4 m/s are a displacement of 120 m, from any start", "[1.2]") {
    CHECK_THAT(uniform_motion({200, 80}, {4, 0}, 30), IsNear(Vec2{320, 80}, rounding).since("200 + 4 · 30 = 320"));
    CHECK_THAT(uniform_motion({0, 0}, {4, 0}, 30), IsNear(Vec2{120, 0}, rounding));
    CHECK_THAT(uniform_motion({200, 80}, {0, -4}, 30), IsNear(Vec2{200, -40}, rounding).since("80 - 4 · 30 = -40"));
}

//> Both components
TEST_CASE("x and y move independently of each other, for negative t too", "[1.2]") {
    CHECK_THAT(uniform_motion({1, -2}, {3, 0.5}, 4), IsNear(Vec2{13, 0}, rounding).since("x: 1 + 12, y: -2 + 2"));
    CHECK_THAT(uniform_motion({1, -2}, {3, 0.5}, -4), IsNear(Vec2{-11, -4}, rounding).since("x: 1 - 12, y: -2 - 2"));
    CHECK_THAT(uniform_motion({1, -2}, {-3, 0.5}, 0.5), IsNear(Vec2{-0.5, -1.75}, rounding)); // half a second
    CHECK_THAT(uniform_motion({1, -2}, {3, 0.5}, 0), IsNear(Vec2{1, -2}));
    CHECK_THAT(uniform_motion({1, -2}, {0, 0}, 9), IsNear(Vec2{1, -2}));
    CHECK_THAT(uniform_motion({0, 0}, {3, 0.5}, -4), IsNear(Vec2{-12, -2}, rounding));
}

//>
TEST_CASE("moving for t and then for some more time leads to the same place as moving for both at once", "[1.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 start = dice.point(-100, 100), velocity = dice.point(-20, 20);
        const double t = dice.real(-10, 10), more = dice.real(-10, 10);

        const Vec2 after_t = uniform_motion(start, velocity, t);
        const Vec2 at_once = uniform_motion(start, velocity, t + more);

        CHECK_THAT(uniform_motion(after_t, velocity, more), IsNear(at_once, 1e-9)); // twelve digits of 300 m
    }
}

TEST_CASE("the displacement points along the velocity, and its length is speed times time", "[1.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 direction = dice.direction();
        const double speed = dice.real(0, 50), t = dice.real(-10, 10);
        const Vec2 start = dice.point(-100, 100);

        const Vec2 displacement = uniform_motion(start, speed * direction, t) - start;

        const double across = displacement.x() * direction.y() - displacement.y() * direction.x();
        CHECK_THAT(displacement.dot(direction), IsNear(speed * t, 1e-9).of("distance along the velocity [m]"));
        CHECK_THAT(across, IsNear(0.0, 1e-9).of("distance to the side of it [m]")); // twelve digits of 500 m
    }
}

//> Erratum E1.9
TEST_CASE("erratum E1.9: 3 miles take longer at 80 miles per hour than at 90", "[1.2]") {
    const double at_90 = 3.0 / 90 * 60, at_80 = 3.0 / 80 * 60;                               // in minutes: 2 and 2.25
    CHECK_THAT(uniform_motion({0, 0}, {90.0 / 60, 0}, at_90), IsNear(Vec2{3, 0}, rounding)); // in miles per minute
    CHECK_THAT(uniform_motion({0, 0}, {80.0 / 60, 0}, at_80), IsNear(Vec2{3, 0}, rounding));

    // In the two minutes that it takes at 90, the slower car gets only 2.67 miles.
    CHECK_THAT(uniform_motion({0, 0}, {80.0 / 60, 0}, at_90), IsNear(Vec2{8.0 / 3, 0}, rounding));
}

//>
TEST_CASE("uniform_motion allows numbers up to ±1e5 and close to 0, and its answer may be larger", "[1.2]") {
    const Vec2 far{1e5, -1e5}, far_away{1e10 + 1e5, -1e10 - 1e5};
    CHECK_THAT(uniform_motion(far, far, 1e5), IsNear(far_away, rounding));
    CHECK_THAT(uniform_motion(-far, far, -1e5), IsNear(Vec2{-far_away}, rounding));
    CHECK_THAT(uniform_motion(-far, -far, 1e5), IsNear(Vec2{-far_away}, rounding));

    CHECK_THAT(uniform_motion({0, 0}, far, 1e-10), IsNear(Vec2{1e-5, -1e-5}, rounding));
    CHECK_THAT(uniform_motion({0, 0}, {1e-10, -1e-10}, 1e5), IsNear(Vec2{1e-5, -1e-5}, rounding));
    CHECK_THAT(uniform_motion({0, 0}, {5, 1e-7}, 1e5), IsNear(Vec2{5e5, 0.01}, rounding));
    CHECK_THAT(uniform_motion({0.1, 0.7}, {0.3, -0.9}, 1000), IsNear(Vec2{300.1, -899.3}, rounding));
}

// ---------------------------------------------------------------------------------------------- 1.3 accelerated_motion

//> Table 13.2
const std::array<double, 6> table_13_2{50, 55, 62, 71, 82, 95}; // 50 + 4 t + t²

TEST_CASE("Table 13.2: from 50 m at 4 m/s with 2 m/s², the positions are 50, 55, 62, 71, 82, 95 m", "[1.3]") {
    for (int t = 0; t <= 5; ++t) {
        const double x = table_13_2[std::size_t(t)], v = 4 + 2.0 * t;
        CHECK_THAT(accelerated_motion({{50, 0}, {4, 0}}, {2, 0}, t), IsNear(State{{x, 0}, {v, 0}}, rounding));
        CHECK_THAT(accelerated_motion({{0, 50}, {0, 4}}, {0, 2}, t),
                   IsNear(State{{0, x}, {0, v}}, rounding)); // upwards
    }
}

//> Table 13.1
TEST_CASE("Table 13.1: from rest with 2 m/s², the velocity is 0, 2, 4, 6, 8, 10 m/s", "[1.3]") {
    const std::array<double, 6> velocity{0, 2, 4, 6, 8, 10}; // 2 t
    for (int t = 0; t <= 5; ++t) {
        const State after = accelerated_motion({{0, 0}, {0, 0}}, {2, 0}, t);
        CHECK_THAT(after.velocity, IsNear(Vec2{velocity[std::size_t(t)], 0}, rounding).of("velocity [m/s]"));
    }
}

//> By hand: thrown up
TEST_CASE("a stone thrown up at 7 m/s under 10 m/s² is 2.4 m up after 0.6 s, still rising at 1 m/s", "[1.3]") {
    CHECK_THAT(accelerated_motion({{1, 0}, {3, 7}}, {0, -10}, 0.6),
               IsNear(State{{2.8, 2.4}, {3, 1}}, rounding)
                   .since("it rises (7 + 1)/2 = 4 m/s · 0.6 s, and moves 3 m/s · 0.6 s sideways"));
    // it falls past the same height at the same speed, 0.2 s later
    CHECK_THAT(accelerated_motion({{1, 0}, {3, 7}}, {0, -10}, 0.8), IsNear(State{{3.4, 2.4}, {3, -1}}, rounding));
    // and was 2 m below, and faster, before
    CHECK_THAT(accelerated_motion({{1, 0}, {3, 7}}, {0, -10}, -0.2), IsNear(State{{0.4, -1.6}, {3, 9}}, rounding));
    // a stone at rest at its highest point was rising before
    CHECK_THAT(accelerated_motion({{1, 5}, {0, 0}}, {0, -10}, -0.2), IsNear(State{{1, 4.8}, {0, 2}}, rounding));
}

//>
TEST_CASE("at t = 0 nothing has changed", "[1.3]") {
    CHECK_THAT(accelerated_motion({{1, -2}, {3, 7}}, {5, -6}, 0), IsNear(State{{1, -2}, {3, 7}}));
}

TEST_CASE("without acceleration the velocity stays the same, and the motion is uniform", "[1.3]") {
    CHECK_THAT(accelerated_motion({{1, -2}, {3, 0.5}}, {0, 0}, 4), IsNear(State{{13, 0}, {3, 0.5}}, rounding));
    CHECK_THAT(accelerated_motion({{1, -2}, {0, 0}}, {0, 0}, 4), IsNear(State{{1, -2}, {0, 0}}, rounding));
}

//> Average and energy
TEST_CASE("the square of the speed grows by twice the acceleration times the displacement", "[1.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double t = dice.real(-10, 10);

        const State after = accelerated_motion(start, acceleration, t);

        const Vec2 displacement = after.position - start.position;
        const Vec2 average = (start.velocity + after.velocity) / 2;
        CHECK_THAT(after.velocity, IsNear(Vec2{start.velocity + t * acceleration}, 1e-9).of("velocity [m/s]"));
        CHECK_THAT(displacement, IsNear(Vec2{average * t}, 1e-9).of("displacement [m]")); // twelve digits of 700 m
        // Multiplied by m/2, this says: the kinetic energy grows by the work, force times displacement.
        const double gained = after.velocity.squaredNorm() - start.velocity.squaredNorm();
        CHECK_THAT(2 * acceleration.dot(displacement),
                   IsNear(gained, 1e-7)
                       .of("twice the acceleration times the displacement [m²/s²]")); // twelve digits of 3e4 m²/s²
    }
}

//>
TEST_CASE("two flights, one after the other, are the same as one long flight", "[1.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double t = dice.real(-5, 5), more = dice.real(-5, 5);

        const State after_t = accelerated_motion(start, acceleration, t);
        const State at_once = accelerated_motion(start, acceleration, t + more);

        CHECK_THAT(accelerated_motion(after_t, acceleration, more), IsNear(at_once, 1e-9)); // twelve digits of 700 m
    }
}

TEST_CASE("after its velocity is reversed, a body flies back to where it started", "[1.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double t = dice.real(0, 10);

        const State there = accelerated_motion(start, acceleration, t);
        const State home = accelerated_motion({there.position, -there.velocity}, acceleration, t);

        CHECK_THAT(home, IsNear(State{start.position, -start.velocity}, 1e-9)); // twelve digits of 700 m
    }
}

//> Erratum E1.5
TEST_CASE("erratum E1.5: Table 13.1 shows an acceleration of 2 m/s², not a constant velocity of 2 m/s", "[1.3]") {
    for (int t = 1; t <= 5; ++t) {
        // As announced, a constant velocity of 2 m/s: positions 2, 4, 6, 8, 10 m.
        CHECK_THAT(accelerated_motion({{0, 0}, {2, 0}}, {0, 0}, t), IsNear(State{{2.0 * t, 0}, {2, 0}}, rounding));
        // As printed, the velocities 2, 4, 6, 8, 10 m/s: an acceleration of 2 m/s², as the table's title says.
        CHECK_THAT(accelerated_motion({{0, 0}, {0, 0}}, {2, 0}, t),
                   IsNear(State{{1.0 * t * t, 0}, {2.0 * t, 0}}, rounding));
    }
}

//> Erratum E1.6
TEST_CASE("erratum E1.6: in Table 13.2 the changes are 5, 7, 9, 11, 13, and only their change is always 2", "[1.3]") {
    const auto x = [](int t) { return accelerated_motion({{50, 0}, {4, 0}}, {2, 0}, t).position.x(); };
    const std::array<double, 5> change{5, 7, 9, 11, 13};
    for (int t = 1; t <= 5; ++t)
        CHECK_THAT(x(t) - x(t - 1), IsNear(change[std::size_t(t - 1)], 1e-9).of("change of x [m]"));
    for (int t = 1; t <= 4; ++t)
        CHECK_THAT((x(t + 1) - x(t)) - (x(t) - x(t - 1)), IsNear(2.0, 1e-9).of("change of the change [m]"));
}

//> Erratum E1.8
TEST_CASE("erratum E1.8: 2 px/frame² are 1800 px/s² at 30 frames per second", "[1.3]") {
    const State in_frames = accelerated_motion({{0, 0}, {0, 0}}, {2, 0}, 30); // t in frames: a second
    CHECK_THAT(in_frames.position, IsNear(Vec2{900, 0}, rounding).of("position [px]"));

    const State in_seconds = accelerated_motion({{0, 0}, {0, 0}}, {2 * 30 * 30, 0}, 1);
    CHECK_THAT(in_seconds.position, IsNear(Vec2{900, 0}, rounding).of("position [px]"));
    // As px/frame, which the printed comment says, it would count only 30 times, and the missile would creep.
    const State creeping = accelerated_motion({{0, 0}, {0, 0}}, {2 * 30, 0}, 1);
    CHECK_THAT(creeping.position, IsNear(Vec2{30, 0}, rounding).of("position [px]"));
}

//> Erratum E1.11
TEST_CASE("erratum E1.11: the displacement comes from the whole velocity, not only from the gained part", "[1.3]") {
    // The strip below v = 4 + 2 t, from 0 to 3: a rectangle of 4 · 3 and a triangle of 6 · 3 / 2.
    const State after = accelerated_motion({{50, 0}, {4, 0}}, {2, 0}, 3);
    CHECK_THAT(after.position.x() - 50, IsNear(12.0 + 9, 1e-9).of("displacement [m]")); // the printed "integral" is 9

    const State from_rest = accelerated_motion({{50, 0}, {0, 0}}, {2, 0}, 3);
    CHECK_THAT(from_rest.position.x() - 50, IsNear(9.0, 1e-9).of("displacement [m]")); // right only from rest
}

//>
TEST_CASE("accelerated_motion allows numbers up to ±1e5 and close to 0, and its answer may be larger", "[1.3]") {
    const Vec2 far{1e5, -1e5}, sooner = (1e5 + 1e10 + 5e14) * Vec2{1, -1}, before = (1e5 - 1e10 + 5e14) * Vec2{1, -1};
    CHECK_THAT(accelerated_motion({far, far}, far, 1e5), IsNear(State{sooner, (1e5 + 1e10) * Vec2{1, -1}}, rounding));
    CHECK_THAT(accelerated_motion({far, far}, far, -1e5), IsNear(State{before, (1e5 - 1e10) * Vec2{1, -1}}, rounding));
    CHECK_THAT(accelerated_motion({-far, -far}, -far, 1e5),
               IsNear(State{-sooner, (1e5 + 1e10) * Vec2{-1, 1}}, rounding));

    const Vec2 close{1e-10, -1e-10};
    CHECK_THAT(accelerated_motion({{0, 0}, far}, {0, 0}, 1e-10), IsNear(State{{1e-5, -1e-5}, far}, rounding));
    CHECK_THAT(accelerated_motion({{0, 0}, close}, {0, 0}, 1e5), IsNear(State{{1e-5, -1e-5}, close}, rounding));
    CHECK_THAT(accelerated_motion({{0, 0}, {0, 0}}, close, 1e5), IsNear(State{{0.5, -0.5}, {1e-5, -1e-5}}, rounding));
}

// -------------------------------------------------------------------------------------------------- 1.4 centre_of_mass

const std::optional<Vec2> no_centre;

namespace {

std::vector<PointMass> random_bodies(Dice &dice, int count) {
    std::vector<PointMass> bodies;
    for (int i = 0; i < count; ++i) bodies.push_back({dice.point(-50, 50), dice.real(0.1, 10)});
    return bodies;
}

} // namespace

//> Worked example: centre of mass
const std::vector<PointMass> three{{{0, 0}, 1}, {{4, 0}, 1}, {{0, 3}, 2}};

TEST_CASE("1 kg at (0, 0), 1 kg at (4, 0) and 2 kg at (0, 3) balance at (1, 1.5)", "[1.4]") {
    CHECK_THAT(centre_of_mass(three),
               IsNear(Vec2{1, 1.5}, rounding).since("x: (1 · 0 + 1 · 4 + 2 · 0) / 4, y: (1 · 0 + 1 · 0 + 2 · 3) / 4"));
}

//> A seesaw
TEST_CASE("two bodies balance nearer to the heavier one", "[1.4]") {
    CHECK_THAT(centre_of_mass({{{2, 7}, 3}, {{6, -1}, 3}}),
               IsNear(Vec2{4, 3}, rounding).since("equal masses balance in the middle"));
    CHECK_THAT(centre_of_mass({{{2, 7}, 9}, {{6, -1}, 3}}),
               IsNear(Vec2{3, 5}, rounding).since("at 3 to 1 it's a quarter of the way"));
    CHECK_THAT(centre_of_mass({{{2, 7}, 3}, {{6, -1}, 9}}), IsNear(Vec2{5, 1}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 0}, {{6, -1}, 9}}), IsNear(Vec2{6, -1}, rounding)); // no mass at (2, 7)
}

//>
TEST_CASE("a single body is its own centre of mass", "[1.4]") {
    CHECK_THAT(centre_of_mass({{{2, 7}, 0.25}}), IsNear(Vec2{2, 7}, rounding));
    CHECK_THAT(centre_of_mass({{{-6, -1}, 1e4}}), IsNear(Vec2{-6, -1}, rounding));
}

TEST_CASE("bodies at the same position all count, and a body without mass changes nothing", "[1.4]") {
    CHECK_THAT(centre_of_mass({{{2, 7}, 1}, {{2, 7}, 1}, {{5, 1}, 1}}), IsNear(Vec2{3, 5}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 1}, {{2, 7}, 3}, {{6, -1}, 4}}), IsNear(Vec2{4, 3}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 3}, {{6, -1}, 3}, {{9, 9}, 0}}), IsNear(Vec2{4, 3}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 3}, {{6, -1}, 3}, {{9, 9}, -0.0}}), IsNear(Vec2{4, 3}, rounding));
}

//> It balances
TEST_CASE("masses times displacements from the centre of mass add up to zero, in x and in y", "[1.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto bodies = random_bodies(dice, dice.whole(1, 9));

        const Vec2 centre = centre_of_mass(bodies).value();

        Vec2 balance{0, 0};
        for (const PointMass &body : bodies) balance += body.mass * (body.position - centre);
        CHECK_THAT(balance,
                   IsNear(Vec2{0, 0}, 1e-8).of("sum of masses times arms [m kg]")); // twelve digits of 4500 m kg
    }
}

//>
TEST_CASE("several bodies can be replaced by one at their centre of mass with all their mass", "[1.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto group = random_bodies(dice, dice.whole(1, 4)), others = random_bodies(dice, dice.whole(0, 4));
        double mass = 0;
        for (const PointMass &body : group) mass += body.mass;
        auto all = others, few = others;
        all.insert(all.begin() + dice.whole(0, int(others.size())), group.begin(), group.end());

        few.push_back({centre_of_mass(group).value(), mass});

        const Vec2 of_all = centre_of_mass(all).value();
        CHECK_THAT(centre_of_mass(few), IsNear(of_all, 1e-9));
    }
}

TEST_CASE("order and unit of the masses do not matter, and moved bodies take their centre of mass along", "[1.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto bodies = random_bodies(dice, dice.whole(1, 9));
        const Vec2 by = dice.point(-100, 100);
        const double unit = dice.real(0.01, 100);
        auto others = bodies;
        for (PointMass &body : others) body.mass *= unit, body.position += by;
        std::reverse(others.begin(), others.end());
        std::rotate(others.begin(), others.begin() + dice.whole(0, int(others.size()) - 1), others.end());

        const Vec2 centre = centre_of_mass(bodies).value();

        CHECK_THAT(centre_of_mass(others), IsNear(Vec2{centre + by}, 1e-9)); // twelve digits of 150 m
    }
}

TEST_CASE("12 000 bodies, numbers up to ±1e5 and a light body beside a heavy one are allowed", "[1.4]") {
    const Vec2 far{1e5, 1e5};
    CHECK_THAT(centre_of_mass({{far, 1e5}, {-far, 1e5}, {{1e5, -1e5}, 2e4}}), IsNear(Vec2{1e5 / 11, -1e5 / 11}, 1e-9));
    CHECK_THAT(centre_of_mass({{{0, 0}, 9e4}, {{10, 0}, 1e4}}), IsNear(Vec2{1, 0}, rounding));
    CHECK_THAT(centre_of_mass({{{0, 0}, 1}, {far, 1e-12}}), IsNear(Vec2{1e-7, 1e-7}, rounding)); // 1e-19 of it is less

    std::vector<PointMass> row; // at 1, 2, 3, ... m along x
    for (int x = 1; x <= 12000; ++x) row.push_back({{double(x), -2}, 1e5});
    CHECK_THAT(centre_of_mass(row), IsNear(Vec2{6000.5, -2}, 1e-9)); // 12 000 roundings

    CHECK_THAT(centre_of_mass(three), IsNear(Vec2{1, 1.5}, rounding)); // and nothing of them is remembered
}

//> Erratum E1.1
TEST_CASE("erratum E1.1: three bodies make three terms; the printed sum has four", "[1.4]") {
    // From i = 0 to n there are n + 1 terms. Whatever comes after the list counts too: say, 4 kg at (9, 9).
    std::vector<PointMass> four = three;
    four.push_back({{9, 9}, 4});
    CHECK_THAT(centre_of_mass(four), IsNear(Vec2{5, 5.25}, rounding)); // (4 + 36)/8, (6 + 36)/8

    CHECK_THAT(centre_of_mass(three), IsNear(Vec2{1, 1.5}, rounding));
}

//> No mass, no centre
TEST_CASE("without any mass there is no centre of mass; a tiny mass is enough", "[1.4]") {
    CHECK_THAT(centre_of_mass({}), IsNear(no_centre));
    CHECK_THAT(centre_of_mass(three), IsNear(Vec2{1, 1.5}, rounding));
    CHECK_THAT(centre_of_mass({}), IsNear(no_centre)); // nothing is remembered from the call before
    CHECK_THAT(centre_of_mass({{{2, 7}, 0}}), IsNear(no_centre));
    CHECK_THAT(centre_of_mass({{{2, 7}, 0}, {{6, -1}, 0}}), IsNear(no_centre));
    CHECK_THAT(centre_of_mass({{{2, 7}, 1e-9}, {{6, -1}, 3e-9}}), IsNear(Vec2{5, 1}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 1e-100}, {{6, -1}, 3e-100}}), IsNear(Vec2{5, 1}, rounding));
}

//>
TEST_CASE("a negative mass is refused, whichever body has it", "[1.4]") {
    for (const std::size_t which : {0u, 1u, 2u})
        for (const double mass : {-0.5, -1e-300}) { // the others weigh more
            auto bodies = three;
            bodies[which].mass = mass;
            CHECK_REFUSED(centre_of_mass(bodies));
        }
    CHECK_REFUSED(centre_of_mass({{{1, 2}, 3}, {{4, 5}, -3}}), "masses of 3 kg and -3 kg");
    std::vector<PointMass> many(200, {{1, 2}, 3});
    many.back().mass = -6;
    CHECK_REFUSED(centre_of_mass(many), "199 bodies of 3 kg, and one of -6 kg");
}

// ------------------------------------------------------------------------------------------------------------ 1.5 step_all

namespace {

Integrators all_at(const State &state) { return {state, state, state}; }

} // namespace

//> Side by side
TEST_CASE("Table 13.2 in steps of 1: explicit Euler lags behind, semi-implicit runs ahead, exact is right", "[1.5]") {
    const std::array<double, 5> slow{54, 60, 68, 78, 90}, fast{56, 64, 74, 86, 100}, exact{55, 62, 71, 82, 95};
    Integrators now = all_at({{50, 0}, {4, 0}});
    for (std::size_t n = 0; n < 5; ++n) {
        now = step_all(now, {2, 0}, 1);
        const Vec2 velocity{6 + 2.0 * double(n), 0};       // in all three
        const Integrators want{{{slow[n], 0}, velocity},   // the old velocity: 4, 6, 8, ...
                               {{fast[n], 0}, velocity},   // the new one: 6, 8, 10, ...
                               {{exact[n], 0}, velocity}}; // the average: 5, 7, 9, ...
        CHECK_THAT(now, IsNear(want, rounding));
    }
}

//> Own states
TEST_CASE("in one step of 0.5 s, each integrator moves on from its own state", "[1.5]") {
    const Integrators before{{{1, 2}, {3, -4}}, {{-5, 6}, {-7, 8}}, {{9, -1}, {2, 5}}};
    const Integrators want{{{2.5, 0}, {8, -7}},                          // moves at (3, -4)
                           {{-6, 8.5}, {-2, 5}},                         // at (-2, 5)
                           {{11.25, 0.75}, {7, 2}}};                     // at (4.5, 3.5)
    CHECK_THAT(step_all(before, {10, -6}, 0.5), IsNear(want, rounding)); // each gains (5, -3) m/s
}

//> Errors
TEST_CASE("after n steps the two Eulers are off by n a dt²/2, one behind and one ahead", "[1.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double time = dice.real(0.1, 5); // [s]
        const Vec2 truth = start.position + time * start.velocity + time * time / 2 * acceleration;
        const int steps = dice.whole(1, 20);
        for (const int n : {steps, 2 * steps}) {
            const double dt = time / n;
            Integrators now = all_at(start);
            for (int k = 0; k < n; ++k) now = step_all(now, acceleration, dt);

            const Vec2 error = n * dt * dt / 2 * acceleration; // = time dt/2 · a: half the step, half the error
            const Vec2 velocity = start.velocity + time * acceleration; // of all three
            const Integrators want{{truth - error, velocity}, {truth + error, velocity}, {truth, velocity}};
            CHECK_THAT(now, IsNear(want, 1e-8)); // twelve digits of 250 m, 40 times
        }
    }
}

//> Slopes
TEST_CASE("a hundredth of the step is a hundredth of the error; the exact step has only rounding errors", "[1.5]") {
    const auto errors = [](int n) { // after 5 s in n steps, from (0, 0) at (3, 7) m/s, under (0, -9.8) m/s²
        Integrators now = all_at({{0, 0}, {3, 7}});
        for (int k = 0; k < n; ++k) now = step_all(now, {0, -9.8}, 5.0 / n);
        const Vec2 truth{15, 35 - 122.5};
        return std::array{(now.explicit_euler.position - truth).norm(), (now.semi_implicit.position - truth).norm(),
                          (now.exact.position - truth).norm()};
    };
    const auto coarse = errors(7), fine = errors(700); // a hundredth of the step
    for (const std::size_t euler : {0u, 1u})
        CHECK_THAT(std::log10(coarse[euler] / fine[euler]) / 2, IsNear(1.0, 1e-6).of("slope"));
    CHECK_THAT(coarse[2], IsBelow(1e-9).of("error of 7 exact steps [m]")); // each has twelve digits of 100 m
    CHECK_THAT(fine[2], IsBelow(1e-7).of("error of 700 exact steps [m]"));
}

//>
TEST_CASE("two exact steps are the same as one of double length; two Euler steps are not", "[1.5]") {
    const Integrators start = all_at({{1, 2}, {3, -4}});
    const Integrators two = step_all(step_all(start, {10, -6}, 0.5), {10, -6}, 0.5), one = step_all(start, {10, -6}, 1);
    CHECK_THAT(two.exact, IsNear(one.exact, 1e-9).of("the exact state after two steps"));
    // half the error, and the errors of the one step are a/2
    const Vec2 of_explicit = two.explicit_euler.position - one.explicit_euler.position;
    const Vec2 of_semi_implicit = two.semi_implicit.position - one.semi_implicit.position;
    CHECK_THAT(of_explicit, IsNear(Vec2{2.5, -1.5}, 1e-9).of("explicit Euler: two steps minus one [m]"));
    CHECK_THAT(of_semi_implicit, IsNear(Vec2{-2.5, 1.5}, 1e-9).of("semi-implicit Euler: two steps minus one [m]"));
}

TEST_CASE("without acceleration all three integrators agree, and a step of 0 s changes nothing", "[1.5]") {
    const State start{{1, 2}, {3, -4}}, later{{2.5, 0}, {3, -4}};
    CHECK_THAT(step_all(all_at(start), {0, 0}, 0.5), IsNear(all_at(later), rounding));

    const Integrators before{{{1, 2}, {3, -4}}, {{-5, 6}, {-7, 8}}, {{9, -1}, {2, 5}}};
    const Integrators after{{{2.5, 0}, {3, -4}}, {{-8.5, 10}, {-7, 8}}, {{10, 1.5}, {2, 5}}}; // each from its own
    CHECK_THAT(step_all(before, {0, 0}, 0.5), IsNear(after, rounding));
    CHECK_THAT(step_all(before, {10, -6}, 0), IsNear(before));
    CHECK_THAT(step_all(before, {10, -6}, -0.0), IsNear(before));
}

//> Erratum E1.7
TEST_CASE("erratum E1.7: the printed loop is n a/2 px ahead; subtracting a/2 at the start fixes it", "[1.5]") {
    // velocity += acceleration, then x += velocity: that is the semi-implicit Euler with dt = 1 frame.
    Integrators printed = all_at({{50, 0}, {4, 0}});
    State fixed{{50, 0}, {4 - 2.0 / 2, 0}};
    for (int n = 1; n <= 5; ++n) {
        printed = step_all(printed, {2, 0}, 1);
        CHECK_THAT(printed.semi_implicit.position.x(),
                   IsNear(table_13_2[std::size_t(n)] + n * 2.0 / 2, rounding).of("x as printed [px]"));

        fixed = step_all(all_at(fixed), {2, 0}, 1).semi_implicit;
        CHECK_THAT(fixed.position.x(), IsNear(table_13_2[std::size_t(n)], rounding).of("x, fixed [px]"));
    }
}

//>
TEST_CASE("from rest the printed loop gives 2, 6, 12, 20, 30, where 1, 4, 9, 16, 25 is right", "[1.5]") {
    Integrators now = all_at({{0, 0}, {0, 0}});
    for (int n = 1; n <= 5; ++n) {
        now = step_all(now, {0, 2}, 1);
        const Vec2 velocity{0, 2.0 * n}; // in all three
        const Integrators want{
            {{0, double(n * (n - 1))}, velocity}, {{0, double(n * (n + 1))}, velocity}, {{0, double(n * n)}, velocity}};
        CHECK_THAT(now, IsNear(want, rounding));
    }
}

TEST_CASE("step_all allows numbers up to ±1e5 and close to 0, and its answer may be larger", "[1.5]") {
    const Vec2 far{1e5, -1e5}, faster = (1e5 + 1e10) * Vec2{1, -1};
    const Vec2 slow = (1e5 + 1e10) * Vec2{1, -1}, fast = slow + 1e15 * Vec2{1, -1}, exact = slow + 5e14 * Vec2{1, -1};
    const Integrators after{{slow, faster}, {fast, faster}, {exact, faster}};
    const Integrators other_way{{-slow, -faster}, {-fast, -faster}, {-exact, -faster}};
    CHECK_THAT(step_all(all_at({far, far}), far, 1e5), IsNear(after, rounding));
    CHECK_THAT(step_all(all_at({-far, -far}), -far, 1e5), IsNear(other_way, rounding));

    const Vec2 close{1e-10, -1e-10};
    CHECK_THAT(step_all(all_at({{0, 0}, far}), {0, 0}, 1e-10), IsNear(all_at({{1e-5, -1e-5}, far}), rounding));
    CHECK_THAT(step_all(all_at({{0, 0}, close}), {0, 0}, 1e5), IsNear(all_at({{1e-5, -1e-5}, close}), rounding));
    const Vec2 gained{1e-5, -1e-5};
    CHECK_THAT(step_all(all_at({{0, 0}, {0, 0}}), close, 1e5),
               IsNear(Integrators{{{0, 0}, gained}, {{1, -1}, gained}, {{0.5, -0.5}, gained}}, rounding));
}

TEST_CASE("a negative dt is refused", "[1.5]") {
    const Integrators moving = all_at({{1, 2}, {3, 4}}), resting = all_at({{1, 2}, {0, 0}});
    for (const double back : {-0.1, -1e-300}) {
        CHECK_REFUSED(step_all(moving, {5, 6}, back));
        CHECK_REFUSED(step_all(moving, {0, 0}, back));
        CHECK_REFUSED(step_all(resting, {0, 0}, back)); // even if nothing moves
    }
}

// -------------------------------------------------------------------------------------------------------- 1.6 centroid

using Corners = std::vector<Vec2>;

//> An L
TEST_CASE("an L of 3 m² around (0.5, 1.5) and 2 m² around (2, 0.5) has its centroid at (1.1, 1.1)", "[1.6]") {
    const Corners l{{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}};
    CHECK_THAT(centroid(l),
               IsNear(Vec2{1.1, 1.1}, rounding).since("x: (3 · 0.5 + 2 · 2) / 5, y: (3 · 1.5 + 2 · 0.5) / 5"));
    CHECK_THAT(centroid({l.rbegin(), l.rend()}), IsNear(Vec2{1.1, 1.1}, rounding)); // the other way round
}

//> Simple plates
TEST_CASE("a triangle's centroid is the mean of its corners; a rectangle's is where the diagonals cross", "[1.6]") {
    CHECK_THAT(centroid({{0, 0}, {6, 0}, {0, 3}}), IsNear(Vec2{2, 1}, rounding));
    CHECK_THAT(centroid({{0, 0}, {0, 3}, {6, 0}}), IsNear(Vec2{2, 1}, rounding));
    CHECK_THAT(centroid({{7, -4}, {9, -1}, {-1, 2}}), IsNear(Vec2{5, -1}, rounding));
    CHECK_THAT(centroid({{1, 2}, {5, 2}, {5, 4}, {1, 4}}), IsNear(Vec2{3, 3}, rounding));
    CHECK_THAT(centroid({{-1, -2}, {-5, -2}, {-5, -4}, {-1, -4}}), IsNear(Vec2{-3, -3}, rounding));
    // a square of 1 m² around (1.5, 0.5), and beside it two triangles of 0.5 m² each, 1/3 m up
    CHECK_THAT(centroid({{3, 0}, {2, 1}, {1, 1}, {0, 0}}), IsNear(Vec2{1.5, 5.0 / 12}, rounding));
}

//> Erratum E1.3
TEST_CASE("erratum E1.3: an extra corner on a side moves the mean of the corners, but not the centroid", "[1.6]") {
    const Vec2 mean = (Vec2{0, 0} + Vec2{1, 0} + Vec2{2, 0} + Vec2{2, 2} + Vec2{0, 2}) / 5;
    CHECK_THAT(mean, IsNear(Vec2{1, 0.8}, rounding)); // as printed: weights at the corners

    CHECK_THAT(centroid({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}), IsNear(Vec2{1, 1}, rounding));
    CHECK_THAT(centroid({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), IsNear(Vec2{1, 1}, rounding));
}

//>
namespace {

/// A plate that can all be seen from (0, 0), its corners by growing angle; and its centroid, from slices around (0, 0).
struct Plate {
    Corners corners;
    Vec2 middle;
};

Plate random_plate(Dice &dice) {
    const int count = dice.whole(3, 12);
    Plate plate{{}, {0, 0}};
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + dice.real(-0.1, 0.1)) / count;
        plate.corners.push_back(dice.real(1, 5) * Vec2{std::cos(angle), std::sin(angle)});
    }
    double area = 0;
    for (std::size_t i = 0; i < plate.corners.size(); ++i) {
        const Vec2 &p = plate.corners[i], &q = plate.corners[(i + 1) % plate.corners.size()];
        const double slice = p.norm() * q.norm() * std::sin(std::acos(p.dot(q) / p.norm() / q.norm())) / 2;
        area += slice;
        plate.middle += slice * (p + q) / 3;
    }
    plate.middle /= area;
    return plate;
}

} // namespace

TEST_CASE("a jagged plate has the centroid of its slices, listed from any corner, either way round", "[1.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto [corners, middle] = random_plate(dice);
        const Vec2 by = dice.point(-100, 100);
        Corners other = corners;
        for (Vec2 &corner : other) corner += by;
        std::rotate(other.begin(), other.begin() + dice.whole(0, int(other.size()) - 1), other.end());
        if (dice.whole(0, 1) == 1) std::reverse(other.begin(), other.end());

        // The arc cosine of the slices is worth some 1e-14; coordinates near 100, squared, cost other formulas more.
        CHECK_THAT(centroid(other), IsNear(Vec2{middle + by}, 1e-9));
    }
}

TEST_CASE("two halves of a plate balance where the whole plate does, with their areas as masses", "[1.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        // a triangle, cut from one corner to somewhere on the opposite side: the areas are as the parts of that side
        const Vec2 top = dice.point(-10, 10), left = dice.point(-10, 10), right = dice.point(-10, 10);
        const Vec2 a = left - top, b = right - top;
        if (std::abs(a.x() * b.y() - a.y() * b.x()) < 1) continue; // thin: another test
        const double share = dice.real(0.1, 0.9);
        const Vec2 foot = left + share * (right - left);

        const Vec2 of_left = centroid({top, left, foot}), of_right = centroid({foot, right, top});

        // thin ones have a thousandth of their square: three digits fewer
        CHECK_THAT(centroid({top, left, right}), IsNear(Vec2{share * of_left + (1 - share) * of_right}, 1e-8));
    }
}

// A square with sides between 1 cm and 10 m is right to 1e-9 m, even far from the origin; a smaller one at the origin, to
// 1e-9 of its side; of a thin plate, fewer digits are.
TEST_CASE("the centroid of a small square is right to 1e-9 m, however far away and however turned", "[1.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 middle = dice.point(-99000, 99000);
        const double side = std::pow(10, dice.real(-2, 1));                                     // from 1 cm to 10 m
        const Vec2 half = side * std::sqrt(0.5) * dice.direction(), other{-half.y(), half.x()}; // of its diagonals

        const Vec2 found = centroid({middle - half, middle - other, middle + half, middle + other});

        CHECK_THAT(Vec2{found - middle}, IsNear(Vec2{0, 0}, 1e-9).of("distance from its centre [m]"));
    }
}

TEST_CASE("a thousand corners, corners up to ±1e5, repeated corners and tiny plates are allowed", "[1.6]") {
    CHECK_THAT(centroid({{-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}}), IsNear(Vec2{0, 0}, 1e-7));
    for (const double side : {1e-3, 1e-7, 1e-30, 1e-90}) {
        const Vec2 middle = centroid({{0, 0}, {side, 0}, {side, side}, {0, side}}) / side;
        CHECK_THAT(middle, IsNear(Vec2{0.5, 0.5}, 1e-9).of("centre, in units of the side"));
        const Vec2 third = centroid({{0, 0}, {side, 0}, {0, side}}) / side;
        CHECK_THAT(third, IsNear(Vec2{1.0 / 3, 1.0 / 3}, 1e-9).of("centroid of half of it, in units of the side"));
    }

    Corners many; // a square of a metre, with a thousand corners on its lower side
    for (int i = 0; i < 1000; ++i) many.push_back({i / 999.0, 0});
    many.insert(many.end(), {{1, 1}, {0, 1}});
    CHECK_THAT(centroid(many), IsNear(Vec2{0.5, 0.5}, 1e-9));

    Corners square{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}; // the last one in the middle of a side
    for (std::size_t i = 0; i < square.size(); ++i) {
        std::rotate(square.begin(), square.begin() + 1, square.end());
        CHECK_THAT(centroid(square), IsNear(Vec2{1, 1}, rounding));
        Corners again = square;
        again.push_back(square.front());
        CHECK_THAT(centroid(again), IsNear(Vec2{1, 1}, rounding)); // back where it began
        again = square;
        again.insert(again.begin() + 1, 2, square[1]);
        CHECK_THAT(centroid(again), IsNear(Vec2{1, 1}, rounding)); // its second corner three times
    }
    // two squares that touch at (1, 1); and a square of 16 m² with a hole of 1 m², and a slit that leads to it
    CHECK_THAT(centroid({{0, 0}, {1, 0}, {1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}, {0, 1}}),
               IsNear(Vec2{1.7, 1.7}, rounding)); // (1 · 0.5 + 4 · 2) / 5
    CHECK_THAT(centroid({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}),
               IsNear(Vec2{30.5 / 15, 30.5 / 15}, rounding)); // (16 · 2 - 1 · 1.5) / 15
}

TEST_CASE("fewer than three corners, or corners on one line, are refused", "[1.6]") {
    CHECK_REFUSED(centroid({}));
    CHECK_REFUSED(centroid({{1, 2}}));
    CHECK_REFUSED(centroid({{1, 2}, {3, 4}}));
    CHECK_REFUSED(centroid({{1, 2}, {1, 2}, {1, 2}}));
    CHECK_REFUSED(centroid({{0, 0}, {2, 1}, {6, 3}}));
    CHECK_REFUSED(centroid({{0, 0}, {6, 3}, {2, 1}, {4, 2}})); // back and forth
    CHECK_REFUSED(centroid({{5, 0}, {5, 3}, {5, -2}}));
    CHECK_REFUSED(centroid({{0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}})); // but for a rounding
    CHECK_REFUSED(centroid({{1e5, 0}, {-1e5, 0}, {0, 1e-9}}));     // 2.5e-15 of its length²
    centroid({{0, 0}, {2, 0}, {0, 2}});                            // good input is still answered
}

TEST_CASE("a plate with an area of 1e-11 of its length² has a centroid; below 1e-13 it counts as a line", "[1.6]") {
    // the thinner the plate, the more a rounding of 1e-16 m counts
    CHECK_THAT(centroid({{0, 0}, {4, 0}, {4, 1e-6}, {0, 1e-6}}), IsNear(Vec2{2, 5e-7}, 1e-8));
    CHECK_THAT(centroid({{0, 0}, {4, 0}, {4, 1e-9}, {0, 1e-9}}), IsNear(Vec2{2, 5e-10}, 1e-5));

    const double enough = 1.05e-11, too_little = 0.95e-13;                                           // of 1 m²
    CHECK_THAT(centroid({{0, 0}, {1, 0}, {1, enough}, {0, enough}}), IsNear(Vec2{0.5, 0}, 1e-3));    // flat
    CHECK_THAT(centroid({{0, 0}, {0, -1}, {enough, -1}, {enough, 0}}), IsNear(Vec2{0, -0.5}, 1e-3)); // upright
    CHECK_REFUSED(centroid({{0, 0}, {1, 0}, {1, too_little}, {0, too_little}}));
    CHECK_REFUSED(centroid({{0, 0}, {0, 1}, {too_little, 1}, {too_little, 0}}));
    CHECK_REFUSED(centroid({{0, 0}, {0, too_little}, {1, too_little}, {1, 0}}));

    const double flat = std::ldexp(1, -26); // a long diagonal, and a third corner that is this far above it
    CHECK_REFUSED(centroid({{0, 0}, {65536, 65536}, {32768, 32768 + flat}})); // 6e-14
    CHECK_THAT(centroid({{0, 0}, {65536, 65536}, {32768, 32768 + 256 * flat}}), IsNear(Vec2{32768, 32768}, 1e-3));

    // The longest distance between corners counts, not the sides and not the outline.
    Corners many;
    for (int x = 0; x <= 50; ++x) many.push_back({double(x), 0});
    for (int x = 50; x >= 0; --x) many.push_back({double(x), 4e-12}); // 8e-14
    CHECK_REFUSED(centroid(many));
    const double h = 3.5e-12; // the area is (2 · 0.5 + 4 · 0.55) h = 1.12e-11 m²
    CHECK_THAT(centroid({{0, 0}, {1, h}, {0.1, 2 * h}, {1, 3 * h}, {0.1, 4 * h}, {1, 5 * h}, {0, 6 * h}}),
               IsNear(Vec2{161.0 / 480, 0}, 1e-3));
}

// --------------------------------------------------------------------------------------------------- 1.7 fit_motion

//> By hand: three samples
// Each number of a motion is right to 1e-8, or to 1e-8 of itself if it's larger than 1, for positions within ±1000 m and
// times within ±10 s that are at least half a second apart. With times closer together or farther from 0, fewer digits are.
constexpr double fit_tolerance = 1e-8;

TEST_CASE("6, 11 and 27 m after 1, 2 and 4 s come from 3 m, 2 m/s and 2 m/s²", "[1.7]") {
    // 5 m/s on average from 1 to 2 s, so 5 m/s at 1.5 s; 8 m/s on average from 2 to 4 s, so 8 m/s at 3 s
    CHECK_THAT(fit_motion({1, 6}, {2, 11}, {4, 27}),
               IsNear(Motion{3, 2, 2}, fit_tolerance)
                   .since("a = (8 - 5) / (3 - 1.5) = 2, v_0 = 5 - 2 · 1.5 = 2, x_0 = 6 - 2 · 1 - 2/2 · 1² = 3"));
}

//> Three rows of a table
TEST_CASE("any three rows of Table 13.2, in any order, give 50 m, 4 m/s and 2 m/s²", "[1.7]") {
    const auto row = [&](int t) { return Sample{double(t), table_13_2[std::size_t(t)]}; };
    for (int i = 0; i <= 5; ++i)
        for (int j = 0; j <= 5; ++j)
            for (int k = 0; k <= 5; ++k)
                if (i != j && j != k && k != i)
                    CHECK_THAT(fit_motion(row(i), row(j), row(k)), IsNear(Motion{50, 4, 2}, fit_tolerance));
}

//> Made backwards
TEST_CASE("a random motion is recovered from any three samples of it", "[1.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Motion want{dice.real(-100, 100), dice.real(-20, 20), dice.real(-10, 10)};
        const auto sample = [&](double t) { return Sample{t, want.x_0 + t * (want.v_0 + t * want.a / 2)}; };
        const double t_1 = dice.real(-10, 10), t_2 = dice.real(-10, 10), t_3 = dice.real(-10, 10);
        if (std::min({std::abs(t_1 - t_2), std::abs(t_2 - t_3), std::abs(t_3 - t_1)}) < 0.5) continue;

        // A sample is off by 1e-13 m, of 800; divided by two gaps of 0.5 s and seen from 10 s away: 1e-10, and room.
        CHECK_THAT(fit_motion(sample(t_1), sample(t_2), sample(t_3)), IsNear(want, fit_tolerance));
    }
}

//>
TEST_CASE("any three samples within ±1000 m and ±10 s, half a second apart, are fitted to 1e-8", "[1.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        std::array<Sample, 3> samples;
        for (Sample &sample : samples) sample = {dice.real(-10, 10), dice.real(-1000, 1000)};
        if (i % 2 == 0) { // close together, and far from 0
            for (std::size_t k = 0; k < 3; ++k) samples[k].t = 9 + 0.5 * double(k);
            std::rotate(samples.begin(), samples.begin() + dice.whole(0, 2), samples.end());
        }
        // Lagrange: the parabola that is 1 at one of the times and 0 at the other two, times the sample's position
        Motion want{0, 0, 0};
        double gap = infinity;
        for (std::size_t k = 0; k < 3; ++k) {
            const double t = samples[k].t, u = samples[(k + 1) % 3].t, w = samples[(k + 2) % 3].t;
            const double weight = samples[k].x / ((t - u) * (t - w));
            want.x_0 += weight * u * w;
            want.v_0 -= weight * (u + w);
            want.a += 2 * weight;
            gap = std::min(gap, std::abs(t - u));
        }
        if (gap < 0.5) continue;

        CHECK_THAT(fit_motion(samples[0], samples[1], samples[2]), IsNear(want, fit_tolerance));
    }
}

TEST_CASE("a resting body has no velocity, a uniform motion no acceleration", "[1.7]") {
    CHECK_THAT(fit_motion({1, -4}, {2, -4}, {4, -4}), IsNear(Motion{-4, 0, 0}, fit_tolerance));
    CHECK_THAT(fit_motion({-1, 9}, {2, 3}, {4, -1}), IsNear(Motion{7, -2, 0}, fit_tolerance));
    CHECK_THAT(fit_motion({0, 5}, {0.5, 4}, {-2, -11}), IsNear(Motion{5, 0, -8}, fit_tolerance));
}

TEST_CASE("samples may be hundredths of a second apart, or less", "[1.7]") {
    // x = 5 - 3 t + 4 t²; a rounding of 1e-15 m, by two gaps of 0.01 s
    CHECK_THAT(fit_motion({0.50, 4.5}, {0.51, 4.5104}, {0.53, 4.5336}), IsNear(Motion{5, -3, 8}, 1e-6));
    CHECK_THAT(fit_motion({0, 0}, {1e-4, 1e-4}, {1, 1}), IsNear(Motion{0, 1, 0}, 1e-6));
    std::array<Sample, 3> close{Sample{0, 0}, Sample{1, 1}, Sample{1e-10, 1e-10}};
    for (int i = 0; i < 3; ++i) {
        std::rotate(close.begin(), close.begin() + 1, close.end());
        CHECK_THAT(fit_motion(close[0], close[1], close[2]), IsNear(Motion{0, 1, 0}, 1e-3));
    }
}

TEST_CASE("each call stands alone: the same times with other positions give another motion", "[1.7]") {
    CHECK_THAT(fit_motion({1, 6}, {2, 11}, {4, 27}), IsNear(Motion{3, 2, 2}, fit_tolerance));
    CHECK_THAT(fit_motion({1, 6}, {2, 11}, {4, 21}), IsNear(Motion{1, 5, 0}, fit_tolerance));
    CHECK_THAT(fit_motion({1, 6}, {2, 9}, {4, 21}), IsNear(Motion{5, 0, 2}, fit_tolerance));
}

TEST_CASE("fit_motion allows numbers up to ±1e5 and tiny accelerations, and its answer may be larger", "[1.7]") {
    // thrice ±1e5 m: what is at 1e5 m at 0 s and at 1e5 s, and was at -1e5 m at -1e5 s, has slowed down
    std::array<Sample, 3> samples{Sample{-1e5, -1e5}, Sample{0, 1e5}, Sample{1e5, 1e5}};
    std::array<Sample, 3> mirrored{Sample{1e5, -1e5}, Sample{0, 1e5}, Sample{-1e5, 1e5}};
    for (int i = 0; i < 3; ++i) {
        std::rotate(samples.begin(), samples.begin() + 1, samples.end());
        std::rotate(mirrored.begin(), mirrored.begin() + 1, mirrored.end());
        CHECK_THAT(fit_motion(samples[0], samples[1], samples[2]), IsNear(Motion{1e5, 1, -2e-5}, fit_tolerance));
        CHECK_THAT(fit_motion(mirrored[0], mirrored[1], mirrored[2]), IsNear(Motion{1e5, -1, -2e-5}, fit_tolerance));
    }
    CHECK_THAT(fit_motion({-1e5, 500}, {0, 0}, {1e5, 500}).a * 1e7, IsNear(1.0, 1e-6).of("a [1e-7 m/s²]"));
    CHECK_THAT(fit_motion({-1e5, 0.5}, {0, 0}, {1e5, 0.5}).a * 1e10, IsNear(1.0, 1e-6).of("a [1e-10 m/s²]"));

    CHECK_THAT(fit_motion({1, 1e5}, {2, -1e5}, {3, 1e5}), IsNear(Motion{7e5, -8e5, 4e5}, fit_tolerance));
    CHECK_THAT(fit_motion({0, 1e5}, {1e-3, -1e5}, {2e-3, 1e5}), IsNear(Motion{1e5, -4e8, 4e11}, fit_tolerance));
}

TEST_CASE("two samples at the same time are refused, whichever two, even if they agree", "[1.7]") {
    const Sample one{1, 6}, two{2, 11}, four{4, 27};
    for (const Sample &again : {Sample{1, 6}, Sample{1, 7}}) {
        CHECK_REFUSED(fit_motion(one, again, four));
        CHECK_REFUSED(fit_motion(one, two, again));
        CHECK_REFUSED(fit_motion(two, one, again));
        CHECK_REFUSED(fit_motion(one, again, one));
    }
    CHECK_REFUSED(fit_motion({0, 6}, {-0.0, 7}, four));
    fit_motion(one, two, four); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------- 1.8 to_screen

namespace {

/// 640 by 360 px, 32 by 18 m: from (-6, -4) to (26, 14).
const Screen wide{{640, 360}, {10, 5}, 20};

Screen random_screen(Dice &dice) {
    const Vec2 size{dice.real(100, 2000), dice.real(100, 2000)}, centre = dice.point(-100, 100);
    return {size, centre, dice.real(1, 100)};
}

} // namespace

//> Worked example: a place on a screen
TEST_CASE("4 m to the right of what's in the middle and 3 m above it is at (400, 120) px", "[1.8]") {
    CHECK_THAT(to_screen({14, 8}, wide),
               IsNear(Vec2{400, 120}, rounding).since("4 · 20 px to the right of 320 px, and 3 · 20 px above 180 px"));
}

//> The middle
TEST_CASE("what the screen looks at is in its middle, wherever that is and however large a metre is", "[1.8]") {
    CHECK_THAT(to_screen({10, 5}, wide), IsNear(Vec2{320, 180}, rounding));
    CHECK_THAT(to_screen({-7, 250}, {{640, 360}, {-7, 250}, 3}), IsNear(Vec2{320, 180}, rounding));
    CHECK_THAT(to_screen({0, 0}, {{200, 500}, {0, 0}, 50}), IsNear(Vec2{100, 250}, rounding));
}

//> The corners
TEST_CASE("its upper left corner, (0, 0) px, shows (-6, 14) m, and its lower right one (26, -4) m", "[1.8]") {
    CHECK_THAT(to_screen({-6, 14}, wide), IsNear(Vec2{0, 0}, rounding));
    CHECK_THAT(to_screen({26, -4}, wide), IsNear(Vec2{640, 360}, rounding));
    CHECK_THAT(to_screen({26, 14}, wide), IsNear(Vec2{640, 0}, rounding));
    CHECK_THAT(to_screen({-6, -4}, wide), IsNear(Vec2{0, 360}, rounding));
}

//> Beyond the edges
TEST_CASE("a place beyond the edges gets a pixel, too: negative ones on the left and above", "[1.8]") {
    CHECK_THAT(to_screen({-16, 15}, wide), IsNear(Vec2{-200, -20}, rounding));
    CHECK_THAT(to_screen({30, -9}, wide), IsNear(Vec2{720, 460}, rounding));
}

//> Zoom
TEST_CASE("with twice the pixels to a metre, everything is twice as far from the middle of the screen", "[1.8]") {
    CHECK_THAT(to_screen({14, 8}, {{640, 360}, {10, 5}, 40}), IsNear(Vec2{480, 60}, rounding));
    CHECK_THAT(to_screen({14, 8}, {{640, 360}, {10, 5}, 0.5}), IsNear(Vec2{322, 178.5}, rounding)); // a map
}

//> The camera moves
TEST_CASE("when the camera moves 1 m to the right and 2 m up, a place moves 20 px to the left and 40 px down",
          "[1.8]") {
    CHECK_THAT(to_screen({14, 8}, {{640, 360}, {11, 7}, 20}), IsNear(Vec2{380, 160}, rounding));
}

//> A ship that climbs
TEST_CASE("from place to place, x on the screen grows with x, and y falls as y rises, by px_per_m", "[1.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const Screen screen = random_screen(dice);
        const Vec2 from = dice.point(-100, 100), to = dice.point(-100, 100);

        const Vec2 there = to_screen(to, screen), here = to_screen(from, screen);

        const Vec2 way = to - from, wanted{screen.px_per_m * way.x(), -screen.px_per_m * way.y()};
        CHECK_THAT(there - here, IsNear(wanted, 1e-9).of("way on the screen [px]"));
    }
}

//> And back
TEST_CASE("counted back from its pixel, a place is where it was", "[1.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const Screen screen = random_screen(dice);
        const Vec2 place = dice.point(-100, 100), corner = screen.size / screen.px_per_m / 2; // from the middle [m]

        const Vec2 pixel = to_screen(place, screen);

        const Vec2 back{screen.centre.x() - corner.x() + pixel.x() / screen.px_per_m,
                        screen.centre.y() + corner.y() - pixel.y() / screen.px_per_m};
        CHECK_THAT(back, IsNear(place, 1e-9).of("place in the world [m]"));
    }
}

//>
TEST_CASE("to_screen allows places up to 1e5, and few and many pixels to a metre", "[1.8]") {
    CHECK_THAT(to_screen({1e5, -1e5}, {{640, 360}, {0, 0}, 1e-3}), IsNear(Vec2{420, 280}, rounding));
    CHECK_THAT(to_screen({1e5, 1e5}, {{640, 360}, {99999, 99999}, 1e5}), IsNear(Vec2{100320, -99820}, 1e-4));
}

TEST_CASE("a px_per_m of 0 or less is refused", "[1.8]") {
    CHECK_REFUSED(to_screen({14, 8}, {{640, 360}, {10, 5}, 0}));
    CHECK_REFUSED(to_screen({14, 8}, {{640, 360}, {10, 5}, -20}));
    CHECK_REFUSED(to_screen({10, 5}, {{640, 360}, {10, 5}, 0}), "no pixels to a metre, for what's in the middle");
    to_screen({14, 8}, wide); // good input is still answered
}
