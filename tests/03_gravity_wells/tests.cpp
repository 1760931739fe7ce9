#include "section_test.hpp"

#include "gravity_wells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using gravity_wells::Fall, gravity_wells::Integrators;
using motion::PointMass, motion::State;
using namespace gravity_wells::subject; // gravity, time_to_fall, ... fly_lander: the student's

// An answer is right to twelve digits of the largest term in its sum; time_to_fall of something thrown downwards, to as
// many decimal places as if it were thrown upwards. kepler_position is right to nine digits of `semi_major`, for
// eccentricities up to 0.99 and up to a hundred turns before or after t = 0. With points closer to each other than 1e-9 m,
// but not the same, or with other numbers that small, an answer may be right to fewer.

namespace {

/// A body of 0.1 to 100 kg, somewhere within 50 m.
PointMass random_body(Dice &dice) { return {dice.point(-50, 50), dice.real(0.1, 100)}; }

} // namespace

// --------------------------------------------------------------------------------------------------------- 3.1 gravity

//> Worked example: 8 m from a black hole
TEST_CASE("a ship of 2 kg, 8 m to the right of a black hole of 800 kg, is pulled to the left with 25 N", "[3.1]") {
    CHECK_THAT(gravity({{8, 0}, 2}, {{0, 0}, 800}, 1),
               IsNear(Vec2{-25, 0}, rounding).since("2 kg · 800 kg / (8 m)² = 1600 / 64 = 25 N"));
}

//> Twice as far
TEST_CASE("twice as far away the pull is a quarter, and at half the distance four times as strong", "[3.1]") {
    CHECK_THAT(gravity({{16, 0}, 2}, {{0, 0}, 800}, 1), IsNear(Vec2{-6.25, 0}, rounding));
    CHECK_THAT(gravity({{4, 0}, 2}, {{0, 0}, 800}, 1), IsNear(Vec2{-100, 0}, rounding));
    CHECK_THAT(gravity({{0, -0.5}, 2}, {{0, 0}, 800}, 1), IsNear(Vec2{0, 6400}, rounding));
}

//> At an angle
TEST_CASE("the pull points from the ship to the hole: from (3, 4), 64 N pull with (-38.4, -51.2) N", "[3.1]") {
    CHECK_THAT(gravity({{3, 4}, 2}, {{0, 0}, 800}, 1),
               IsNear(Vec2{-38.4, -51.2}, rounding).since("it's 5 m away: 1600 / 25 = 64 N, along (-3, -4) / 5"));
    CHECK_THAT(gravity({{-4, 3}, 2}, {{0, 0}, 800}, 1), IsNear(Vec2{51.2, -38.4}, rounding));
}

//> At one metre
TEST_CASE("at a distance of 1 m the pull is G times both masses, in every direction", "[3.1]") {
    CHECK_THAT(gravity({{1, 0}, 2}, {{0, 0}, 3}, 1), IsNear(Vec2{-6, 0}, rounding));
    CHECK_THAT(gravity({{0, 1}, 2}, {{0, 0}, 3}, 1), IsNear(Vec2{0, -6}, rounding));
    CHECK_THAT(gravity({{-0.6, 0.8}, 2}, {{0, 0}, 3}, 1), IsNear(Vec2{3.6, -4.8}, rounding));
    CHECK_THAT(gravity({{-1, 0}, 5}, {{0, 0}, 3}, 0.5), IsNear(Vec2{7.5, 0}, rounding));
}

//> Equal and opposite
TEST_CASE("two bodies pull on each other equally hard, in opposite directions", "[3.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const PointMass a = random_body(dice), b = random_body(dice);

        const Vec2 pull = gravity(a, b, 2);

        CHECK_THAT(gravity(b, a, 2), IsNear(Vec2{-pull}, rounding));
    }
}

//> Somewhere else
TEST_CASE("if both bodies are moved by the same displacement, the pull stays as it is", "[3.1]") {
    CHECK_THAT(gravity({{18, -7}, 2}, {{10, -7}, 800}, 1), IsNear(Vec2{-25, 0}, rounding));
    CHECK_THAT(gravity({{-97, 44}, 2}, {{-100, 40}, 800}, 1), IsNear(Vec2{-38.4, -51.2}, rounding));
}

//> Masses
TEST_CASE("the pull grows with either mass and with G, and without one of them there is none", "[3.1]") {
    CHECK_THAT(gravity({{8, 0}, 6}, {{0, 0}, 800}, 1), IsNear(Vec2{-75, 0}, rounding));
    CHECK_THAT(gravity({{8, 0}, 2}, {{0, 0}, 400}, 1), IsNear(Vec2{-12.5, 0}, rounding));
    CHECK_THAT(gravity({{8, 0}, 2}, {{0, 0}, 800}, 3), IsNear(Vec2{-75, 0}, rounding));
    CHECK_THAT(gravity({{8, 0}, 0}, {{0, 0}, 800}, 1), IsNear(Vec2{0, 0}));
    CHECK_THAT(gravity({{8, 0}, 2}, {{0, 0}, 0}, 1), IsNear(Vec2{0, 0}));
    CHECK_THAT(gravity({{8, 0}, 2}, {{0, 0}, 800}, 0), IsNear(Vec2{0, 0}));
}

//> Shells
TEST_CASE("times the distance squared, the pull is the same everywhere, and it has no part across", "[3.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const PointMass a = random_body(dice), b = random_body(dice);
        const double r = std::hypot(b.position.x() - a.position.x(), b.position.y() - a.position.y());
        const Vec2 along = (b.position - a.position) / r, across{-along.y(), along.x()};
        if (r < 0.1) continue;

        const Vec2 pull = gravity(a, b, 2);

        const double all = 2 * a.mass * b.mass; // at 1 m [N]
        CHECK_THAT(pull.dot(along) * r * r, IsNear(all, 1e-11).of("pull times distance squared [N m²]"));
        CHECK_THAT(pull.dot(across) * r * r / all, IsNear(0.0, rounding).of("part of the pull across [1]"));
    }
}

//> Erratum E3.1
TEST_CASE("erratum E3.1: two people of 70 kg, 1 m apart, pull with 3.27e-7 N, and the Earth with 685.94 N", "[3.1]") {
    const Vec2 between_people = gravity({{0, 0}, 70}, {{1, 0}, 70}, 6.67e-11);
    CHECK_THAT(between_people.x() * 1e7, IsNear(3.2683, 1e-9).of("pull between two people [1e-7 N]"));
    // in units of 1000 km, 1000 s and 1e24 kg, G is 66.7, and forces on kilograms are still in newtons
    const Vec2 of_the_earth = gravity({{0, 6.38}, 70}, {{0, 0}, 5.98}, 66.7);
    CHECK_THAT(of_the_earth.y(), IsNear(-685.936164, 1e-9).of("weight of a person [N]"));
}

//> Erratum E3.2
TEST_CASE("erratum E3.2: a person of 70 kg weighs 154 pounds, not 155, at 4.45 N for each pound", "[3.1]") {
    const Vec2 weight = gravity({{0, 6.38}, 70}, {{0, 0}, 5.98}, 66.7);
    CHECK_THAT(-weight.y() / 4.45, IsNear(154.143, 1e-5).of("weight of a person [pounds]"));
}

//> Erratum E3.4
TEST_CASE("erratum E3.4: a refrigerator and a baseball fall with exactly the same acceleration", "[3.1]") {
    const PointMass earth{{0, 0}, 5.98};
    for (const double mass : {100.0, 0.145}) {
        const Vec2 acceleration = gravity({{0, 6.38}, mass}, earth, 66.7) / mass;
        CHECK_THAT(acceleration, IsNear(Vec2{0, -9.79908806}, 1e-9).of("acceleration [m/s²]"));
    }
}

//> Erratum E3.6
TEST_CASE("erratum E3.6: a ship that flies at the hole in each frame hits it; one whose velocity is pulled, orbits",
          "[3.1]") {
    const PointMass hole{{0, 0}, 800};
    const double dt = 1e-3;
    Vec2 printed{8, 0}; // straight towards the hole, at 10 m/s
    int frames = 0;
    for (; printed.norm() > 10 * dt && frames < 5000; ++frames) printed -= 10 * dt * printed.normalized();
    CHECK_THAT(frames * dt, IsNear(0.8, 0.01).of("time until it hits the hole [s]"));

    PointMass ship{{8, 0}, 2};
    Vec2 velocity{0, 10};
    for (int frame = 0; frame < 5000; ++frame) { // once around takes 5.03 s
        velocity += dt / ship.mass * gravity(ship, hole, 1);
        ship.position += dt * velocity;
        CHECK_THAT(ship.position.norm(), IsNear(8.0, 0.01).of("distance from the hole [m]"));
    }
    // but close to the hole the pull has no limit: at a centimetre it is 10 000 times that at a metre
    CHECK_THAT(gravity({{1, 0}, 2}, hole, 1), IsNear(Vec2{-1600, 0}, rounding));
    CHECK_THAT(gravity({{0.01, 0}, 2}, hole, 1), IsNear(Vec2{-1.6e7, 0}, rounding));
}

//> Erratum E3.8
TEST_CASE("erratum E3.8: one metre higher up, g differs in the seventh digit, not in the 23rd", "[3.1]") {
    const PointMass earth{{0, 0}, 5.98};
    const double low = -gravity({{0, 6.38}, 1}, earth, 66.7).y(), high = -gravity({{0, 6.380001}, 1}, earth, 66.7).y();
    CHECK_THAT((low - high) / low * 1e7, IsNear(3.1348, 1e-4).of("loss of g in one metre [1e-7 of g]"));
}

//>
TEST_CASE("positions and masses up to ±1e5 are allowed, bodies far apart, close together, and tiny masses", "[3.1]") {
    CHECK_THAT(gravity({{-1e5, 0}, 1e5}, {{1e5, 0}, 1e5}, 1e5), IsNear(Vec2{25000, 0}, rounding));
    CHECK_THAT(gravity({{1e5, -1e5}, 1e5}, {{1e5, 1e5}, 1e5}, 1e5), IsNear(Vec2{0, 25000}, rounding));
    CHECK_THAT(gravity({{1e5, 1e5}, 1e5}, {{-1e5, -1e5}, 1e5}, 1e5),
               IsNear(Vec2{-std::sqrt(78125000), -std::sqrt(78125000)}, rounding)); // 12500 N, at 45°
    CHECK_THAT(gravity({{1e-6, 0}, 2}, {{0, 0}, 800}, 1), IsNear(Vec2{-1.6e15, 0}, rounding));
    CHECK_THAT(Vec2{1e30 * gravity({{3e4, 4e4}, 1e-9}, {{0, 0}, 1e-9}, 1e-3)},
               IsNear(Vec2{-0.24, -0.32}, rounding).of("pull [1e-30 N]"));
    CHECK_THAT(Vec2{gravity({{0, 0}, 2}, {{0, -2e-9}, 3}, 1e-9) / 1.5e9},
               IsNear(Vec2{0, -1}, rounding).of("pull [1.5e9 N]"));
}

//> Nothing to divide by
TEST_CASE("two bodies at the same point do not pull on each other, and the answer is (0, 0)", "[3.1]") {
    CHECK_THAT(gravity({{0, 0}, 2}, {{0, 0}, 800}, 1), IsNear(Vec2{0, 0}));
    CHECK_THAT(gravity({{3, -4}, 2}, {{3, -4}, 800}, 1), IsNear(Vec2{0, 0}));
}

//>
TEST_CASE("a negative mass or G is refused by gravity", "[3.1]") {
    CHECK_REFUSED(gravity({{8, 0}, -2}, {{0, 0}, 800}, 1));
    CHECK_REFUSED(gravity({{8, 0}, 2}, {{0, 0}, -800}, 1));
    CHECK_REFUSED(gravity({{8, 0}, 2}, {{0, 0}, 800}, -1));
    CHECK_REFUSED(gravity({{0, 0}, 2}, {{0, 0}, -1e-300}, 1)); // even at the same point
    gravity({{8, 0}, 2}, {{0, 0}, 800}, 1);                    // good input is still answered
}

// ---------------------------------------------------------------------------------------------------- 3.2 time_to_fall

//> Worked example: thrown upwards
TEST_CASE("thrown upwards at 10 m/s from 15 m, with g = 10 m/s², it reaches the floor after 3 s", "[3.2]") {
    CHECK_THAT(time_to_fall(15, 10, 10),
               IsNear(3.0, rounding)
                   .since("it hits the floor at √(10² + 2 · 10 · 15) = 20 m/s, and from 10 up to 20 down are 30 m/s"));
}

//> Dropped
TEST_CASE("what is dropped falls 5, 20 and 45 m in 1, 2 and 3 s, with g = 10 m/s²", "[3.2]") {
    CHECK_THAT(time_to_fall(5, 0, 10), IsNear(1.0, rounding));
    CHECK_THAT(time_to_fall(20, 0, 10), IsNear(2.0, rounding));
    CHECK_THAT(time_to_fall(45, 0, 10), IsNear(3.0, rounding));
}

//> Thrown downwards
TEST_CASE("thrown downwards at 10 m/s from 15 m, with g = 10 m/s², it reaches the floor after 1 s", "[3.2]") {
    CHECK_THAT(time_to_fall(15, -10, 10), IsNear(1.0, rounding).since("from 10 down to 20 down are 10 m/s"));
    CHECK_THAT(time_to_fall(40, -10, 10),
               IsNear(2.0, rounding)
                   .since("it hits the floor at √(100 + 800) = 30 m/s, and from 10 down to 30 down are 20 m/s"));
}

//> From the floor
TEST_CASE("thrown upwards from the floor at 10 m/s, with g = 10 m/s², it is back after 2 s", "[3.2]") {
    CHECK_THAT(time_to_fall(0, 10, 10), IsNear(2.0, rounding));
    CHECK_THAT(time_to_fall(0, 7, 2), IsNear(7.0, rounding));
}

//> On the floor
TEST_CASE("what is on the floor and does not move upwards reaches it after 0 s", "[3.2]") {
    CHECK_THAT(time_to_fall(0, 0, 10), IsNear(0.0, rounding));
    CHECK_THAT(time_to_fall(0, -10, 10), IsNear(0.0, rounding));
    CHECK_THAT(time_to_fall(0, -3, 9.8), IsNear(0.0, rounding));
}

//> The height at that time
TEST_CASE("after that time, height + velocity t - g t²/2 is 0, and halfway there it is not below the floor", "[3.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const double height = dice.real(0, 100), velocity = dice.real(-30, 30), g = dice.real(1, 20);
        const auto height_at = [&](double t) { return height + velocity * t - g * t * t / 2; };

        const double t = time_to_fall(height, velocity, g);

        CHECK_THAT(t, IsAtLeast(0).of("time to fall [s]"));
        CHECK_THAT(height_at(t), IsNear(0.0, 1e-9).of("height at that time [m]")); // made of thousands of metres
        CHECK_THAT(height_at(t / 2), IsAtLeast(0).of("height after half of that time [m]"));
    }
}

//>
TEST_CASE("thrown upwards it takes 2 v/g longer than thrown downwards at the same speed", "[3.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const double height = dice.real(0, 100), speed = dice.real(0, 30), g = dice.real(1, 20);

        const double up = time_to_fall(height, speed, g), down = time_to_fall(height, -speed, g);

        CHECK_THAT(up - down, IsNear(2 * speed / g, 1e-10).of("how much longer it takes upwards [s]"));
    }
}

//> Erratum E3.9
TEST_CASE("erratum E3.9: in 3 s something falls 44.1 m and reaches 29.4 m/s: two formulas, not one", "[3.2]") {
    const double t = time_to_fall(44.1, 0, 9.8);
    CHECK_THAT(t, IsNear(3.0, rounding));
    CHECK_THAT(9.8 * t, IsNear(29.4, rounding).of("velocity downwards [m/s]")); // not ½ · 9.8 · t², which is 44.1
    CHECK_THAT(time_to_fall(0, 29.4, 9.8), IsNear(6.0, rounding));              // 3 s up, 3 s down
}

//>
TEST_CASE("heights and velocities up to 1e5 are allowed, tiny ones, and a weak or strong g", "[3.2]") {
    CHECK_THAT(time_to_fall(1e5, 0, 1e5), IsNear(std::sqrt(2.0), rounding));
    CHECK_THAT(time_to_fall(1e5, -1e5, 1), IsNear(0.9999950000499994, 1e-6)); // twelve digits of 200001
    CHECK_THAT(time_to_fall(1e5, 1e5, 1), IsNear(200000.99999500005, rounding));
    CHECK_THAT(time_to_fall(0, 1e5, 1e-3), IsNear(2e8, rounding));
    CHECK_THAT(time_to_fall(2e-9, 0, 1) * 1e5, IsNear(std::sqrt(40.0), rounding).of("time to fall [1e-5 s]"));
    CHECK_THAT(time_to_fall(0, 1e-8, 5) * 1e8, IsNear(0.4, rounding).of("time to fall [1e-8 s]"));
    CHECK_THAT(time_to_fall(3.75e-9, 5e-7, 1e-4), IsNear(0.015, rounding)); // it hits the floor at 1e-6 m/s
    CHECK_THAT(time_to_fall(3.75e-9, -5e-7, 1e-4), IsNear(0.005, rounding));
    CHECK_THAT(time_to_fall(1e5, 0, 2e-9), IsNear(1e7, rounding));
}

TEST_CASE("a negative height, or a g of 0 or less, is refused by time_to_fall", "[3.2]") {
    CHECK_REFUSED(time_to_fall(-1, 0, 10));
    CHECK_REFUSED(time_to_fall(-1e-300, 0, 10));
    CHECK_REFUSED(time_to_fall(5, 0, 0));
    CHECK_REFUSED(time_to_fall(5, 0, -10));
    time_to_fall(15, 10, 10); // good input is still answered
}

// --------------------------------------------------------------------------------------------------- 3.3 fall_and_land

//> Worked example: a landing
TEST_CASE("within a frame of 4 s it lands after 3 s, at 20 m/s: thrown upwards at 10 m/s from 15 m", "[3.3]") {
    CHECK_THAT(fall_and_land({15, 10, 0}, 10, 4), IsNear(Fall{0, -20, 3}, rounding));
}

//> Still in the air
TEST_CASE("in the air it falls on: after 1 s at a height of 20 m and at rest, after 2 s at 15 m and 10 m/s", "[3.3]") {
    CHECK_THAT(fall_and_land({15, 10, 0}, 10, 1), IsNear(Fall{20, 0, 1}, rounding));
    CHECK_THAT(fall_and_land({15, 10, 0}, 10, 2), IsNear(Fall{15, -10, 2}, rounding));
    CHECK_THAT(fall_and_land({100, 0, 0}, 8, 0.5), IsNear(Fall{99, -4, 0.5}, rounding));
}

//> The clock
TEST_CASE("the time goes on from where it was, in the air and on landing", "[3.3]") {
    CHECK_THAT(fall_and_land({20, 0, 1}, 10, 1), IsNear(Fall{15, -10, 2}, rounding));
    CHECK_THAT(fall_and_land({15, -10, 2}, 10, 1.5), IsNear(Fall{0, -20, 3}, rounding));
    CHECK_THAT(fall_and_land({15, -10, 2}, 10, 1), IsNear(Fall{0, -20, 3}, rounding)); // just at the end of the frame
}

//> At any frame rate
TEST_CASE("it lands at the same time and speed at 1, 10, 60 and 144 frames per second", "[3.3]") {
    for (const double dt : {1.0, 0.1, 1.0 / 60, 1.0 / 144}) {
        Fall now{15, 10, 0};
        for (int frame = 0; frame * dt < 3.1; ++frame) {
            now = fall_and_land(now, 10, dt);
            CHECK_THAT(now.height, IsAtLeast(-1e-9).of("height [m]"));
            now.height = std::max(0.0, now.height); // less is rounding
        }
        CHECK_THAT(now, IsNear(Fall{0, -20, 3}, 1e-9).of("the fall after 3.1 s"));
    }
}

//> Lying there
TEST_CASE("what lies on the floor, or has just hit it, stays as it is, and its time, too", "[3.3]") {
    CHECK_THAT(fall_and_land({0, 0, 5}, 10, 0.5), IsNear(Fall{0, 0, 5}, rounding));
    CHECK_THAT(fall_and_land({0, -20, 3}, 10, 0.5), IsNear(Fall{0, -20, 3}, rounding));
    CHECK_THAT(fall_and_land({0, -3.3, 1}, 9.8, 2), IsNear(Fall{0, -3.3, 1}, rounding));
}

//> Upwards from the floor
TEST_CASE("what leaves the floor upwards flies, and lands again at the speed at which it left", "[3.3]") {
    CHECK_THAT(fall_and_land({0, 10, 0}, 10, 0.5), IsNear(Fall{3.75, 5, 0.5}, rounding));
    CHECK_THAT(fall_and_land({0, 10, 0}, 10, 5), IsNear(Fall{0, -10, 2}, rounding));
}

//>
TEST_CASE("a frame of 0 s changes nothing", "[3.3]") {
    CHECK_THAT(fall_and_land({15, 10, 2}, 10, 0), IsNear(Fall{15, 10, 2}, rounding));
    CHECK_THAT(fall_and_land({15, -10, 2}, 10, 0), IsNear(Fall{15, -10, 2}, rounding));
    CHECK_THAT(fall_and_land({0, 10, 2}, 10, 0), IsNear(Fall{0, 10, 2}, rounding));
}

//> Energy
TEST_CASE("v²/2 + g h is the same after a frame as before, whether it lands or not", "[3.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Fall now{dice.real(0, 100), dice.real(-30, 30), dice.real(0, 10)};
        const double g = dice.real(1, 20), dt = dice.real(0, 5);
        const auto energy = [&](const Fall &it) { return it.velocity * it.velocity / 2 + g * it.height; };

        const Fall after = fall_and_land(now, g, dt);

        CHECK_THAT(after.height, IsAtLeast(-1e-9).of("height [m]"));
        CHECK_THAT(energy(after), IsNear(energy(now), 1e-10).of("energy of each kilogram [J]"));
        CHECK_THAT(now.velocity - g * (after.time - now.time), IsNear(after.velocity, 1e-11).of("velocity [m/s]"));
        CHECK_THAT(after.time - now.time, IsAtMost(dt + 1e-12).of("time that has passed [s]"));
    }
}

//>
TEST_CASE("exactly at the border: a frame that ends just before the landing, and one that ends just after it",
          "[3.3]") {
    CHECK_THAT(fall_and_land({20, 0, 0}, 10, 1.99), IsNear(Fall{0.1995, -19.9, 1.99}, 1e-11));
    CHECK_THAT(fall_and_land({20, 0, 0}, 10, 2.01), IsNear(Fall{0, -20, 2}, rounding));
    CHECK_THAT(fall_and_land({20, 0, 0}, 10, 2 - 2.5e-10), IsNear(Fall{5e-9, -20 + 2.5e-9, 2 - 2.5e-10}, 1e-11));
    CHECK_THAT(fall_and_land({20, 0, 0}, 10, 2 + 2.5e-10), IsNear(Fall{0, -20, 2}, 1e-11));
    CHECK_THAT(fall_and_land({0.001, -1, 0}, 10, 0.1),
               IsNear(Fall{0, -1.0099504938362078, 0.00099504938362078}, rounding));
    CHECK_THAT(fall_and_land({5e-7, -0.001, 1}, 10, 5e-5), IsNear(Fall{4.375e-7, -0.0015, 1.00005}, rounding));
    CHECK_THAT(fall_and_land({0, 5e-9, 0}, 0.2, 5e-9), IsNear(Fall{0, 4e-9, 5e-9}, rounding));
}

TEST_CASE("a frame that is just as long as the fall ends on the floor, at a height of exactly 0", "[3.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Fall now{dice.real(0.1, 100), dice.real(-30, 30), 0};
        const double g = dice.real(1, 20), v = now.velocity, impact = std::sqrt(v * v + 2 * g * now.height);
        const double t = (v + impact) / g;
        // only where other ways to compute it agree to the last digit: which of them yours is doesn't matter
        if (t != v / g + impact / g || t != 2 * now.height / (impact - v)
            || t != v / g + std::sqrt(v / g * (v / g) + 2 * now.height / g))
            continue;
        CHECK_THAT(fall_and_land(now, g, t).height, IsNear(0.0).of("height [m]"));
    }
    CHECK_THAT(fall_and_land({15, 10, 0}, 10, 4).height, IsNear(0.0).of("height [m]"));
}

//> Erratum E3.11
TEST_CASE("erratum E3.11: after 20 frames of 1 px per frame more it has fallen 200 px; the printed loop has 190",
          "[3.3]") {
    int printed = 0, velocity = 0; // with y downwards: move, then accelerate
    for (int frame = 0; frame < 20; ++frame) printed += velocity++;
    CHECK_THAT(double(printed), IsNear(190.0)); // 20 · 19 / 2

    const Fall ours = fall_and_land({479, 0, 0}, 1, 20);
    CHECK_THAT(479 - ours.height, IsNear(200.0, rounding).of("fallen [px]")); // 20² / 2
}

//> Erratum E3.12
TEST_CASE("erratum E3.12: the printed loop ends 17 px below the bottom; a fall of 479 px takes 30.95 frames", "[3.3]") {
    int printed = 0, velocity = 0, frames = 0;
    for (; printed < 479; ++frames) printed += velocity++;
    CHECK_THAT(double(frames), IsNear(32.0));
    CHECK_THAT(double(printed), IsNear(496.0));

    Fall ours{479, 0, 0};
    for (int frame = 0; frame < 32; ++frame) {
        ours = fall_and_land(ours, 1, 1);
        ours.height = std::max(0.0, ours.height); // less is rounding
    }
    CHECK_THAT(ours.height, IsNear(0.0, 1e-10).of("height at the end [px]"));
    CHECK_THAT(ours.time, IsNear(30.951575081, 1e-10).of("time in the air [frames]"));
}

//>
TEST_CASE("fall_and_land allows heights, velocities and times up to 1e5, and long frames", "[3.3]") {
    CHECK_THAT(fall_and_land({1e5, 0, 1e5}, 1e5, 1), IsNear(Fall{5e4, -1e5, 100001}, rounding));
    CHECK_THAT(fall_and_land({99999.75, -99999.5, -54321.25}, 10, 0.125),
               IsNear(Fall{87499.734375, -100000.75, -54321.125}, rounding));
    CHECK_THAT(fall_and_land({1e5, 0, 0}, 2e-9, 1e5), IsNear(Fall{99990, -2e-4, 1e5}, rounding));
    CHECK_THAT(fall_and_land({5, 0, -1e5}, 10, 1e5), IsNear(Fall{0, -10, -99999}, rounding));
    CHECK_THAT(fall_and_land({0, 1e5, 0}, 1e-3, 1e5), IsNear(Fall{1e10 - 5e6, 1e5 - 100, 1e5}, rounding));
}

TEST_CASE("a negative height or dt, or a g of 0 or less, is refused by fall_and_land", "[3.3]") {
    CHECK_REFUSED(fall_and_land({-1, 0, 0}, 10, 1));
    CHECK_REFUSED(fall_and_land({15, 10, 0}, 0, 1));
    CHECK_REFUSED(fall_and_land({15, 10, 0}, -10, 1));
    CHECK_REFUSED(fall_and_land({15, 10, 0}, 10, -1));
    CHECK_REFUSED(fall_and_land({15, 10, 0}, 10, -1e-300));
    fall_and_land({15, 10, 0}, 10, 1); // good input is still answered
}

// -------------------------------------------------------------------------------------------- 3.4 circular_orbit_speed

//> Worked example: a circle
TEST_CASE("around a black hole of 800 kg, at 8 m, a ship circles at 10 m/s", "[3.4]") {
    CHECK_THAT(circular_orbit_speed(800, 8, 1),
               IsNear(10.0, rounding).since("it's pulled with 800 / 64 = 12.5 m/s², and 10² / 8 is 12.5, too"));
}

//> Nearer and farther
TEST_CASE("at 2 m it circles at 20 m/s, at 32 m at 5 m/s: four times as far, half as fast", "[3.4]") {
    CHECK_THAT(circular_orbit_speed(800, 2, 1), IsNear(20.0, rounding));
    CHECK_THAT(circular_orbit_speed(800, 32, 1), IsNear(5.0, rounding));
    CHECK_THAT(circular_orbit_speed(800, 16, 1), IsNear(std::sqrt(50.0), rounding));
}

//>
TEST_CASE("four times the mass, or four times G, needs twice the speed; without them the speed is 0", "[3.4]") {
    CHECK_THAT(circular_orbit_speed(3200, 8, 1), IsNear(20.0, rounding));
    CHECK_THAT(circular_orbit_speed(200, 8, 4), IsNear(10.0, rounding));
    CHECK_THAT(circular_orbit_speed(800, 8, 0.25), IsNear(5.0, rounding));
    CHECK_THAT(circular_orbit_speed(0, 8, 1), IsNear(0.0, rounding));
    CHECK_THAT(circular_orbit_speed(800, 8, 0), IsNear(0.0, rounding));
}

//> Kepler's third law
TEST_CASE("the square of the time for one turn grows as the cube of the radius", "[3.4]") {
    Dice dice;
    const double turn = 2 * std::numbers::pi * 8 / circular_orbit_speed(800, 8, 1); // [s]
    for (int i = 0; i < course::cases(5000); ++i) {
        const double times = dice.real(0.1, 50), radius = 8 * times;

        const double longer = 2 * std::numbers::pi * radius / circular_orbit_speed(800, radius, 1) / turn;

        CHECK_THAT(longer * longer, IsNear(times * times * times, 1e-11).of("square of the ratio of the times [1]"));
    }
}

//> Flown
TEST_CASE("a ship that starts at that speed stays at its distance for ten turns", "[3.4]") {
    const double speed = circular_orbit_speed(300, 7, 2), mu = 600, dt = 0.002; // it takes 4.7 s to get around
    Vec2 position{7, 0}, velocity{0, speed};
    for (int i = 0; i < 24000; ++i) { // each step: half of the pull, the motion, the other half
        velocity -= dt / 2 * mu / std::pow(position.norm(), 3) * position;
        position += dt * velocity;
        velocity -= dt / 2 * mu / std::pow(position.norm(), 3) * position;
        if (i % 1000 == 0) CHECK_THAT(position.norm(), IsNear(7.0, 1e-4).of("distance from the hole [m]"));
    }
}

//> Around the Earth
TEST_CASE("around the Earth: 7.9 km/s just above the ground, 1.02 km/s where the Moon is", "[3.4]") {
    // in units of 1000 km, 1000 s and 1e24 kg, where G is 66.7
    CHECK_THAT(circular_orbit_speed(5.98, 6.38, 66.7), IsNear(7.90680, 1e-5));
    CHECK_THAT(circular_orbit_speed(5.98, 384.4, 66.7), IsNear(1.01864, 1e-5));
}

//>
TEST_CASE("circular_orbit_speed allows numbers up to 1e5, and small ones", "[3.4]") {
    CHECK_THAT(circular_orbit_speed(1e5, 1e5, 1e5), IsNear(std::sqrt(1e5), rounding));
    CHECK_THAT(circular_orbit_speed(1e5, 2e-8, 1e5), IsNear(std::sqrt(50.0) * 1e8, rounding));
    CHECK_THAT(circular_orbit_speed(1e-9, 1e4, 1e-9) * 1e11, IsNear(1.0, rounding).of("speed [1e-11 m/s]"));
}

TEST_CASE("a negative mass or G, or a radius of 0 or less, is refused", "[3.4]") {
    CHECK_REFUSED(circular_orbit_speed(-800, 8, 1));
    CHECK_REFUSED(circular_orbit_speed(800, 8, -1));
    CHECK_REFUSED(circular_orbit_speed(-800, 8, -1));
    CHECK_REFUSED(circular_orbit_speed(800, 0, 1));
    CHECK_REFUSED(circular_orbit_speed(800, -8, 1));
    CHECK_REFUSED(circular_orbit_speed(0, -1e-300, 1));
    circular_orbit_speed(800, 8, 1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 3.5 orbit_step

namespace {

/// Position times velocity across it, for each kilogram [m²/s].
double angular_momentum(const State &ship) {
    return ship.position.x() * ship.velocity.y() - ship.position.y() * ship.velocity.x();
}

/// Kinetic and potential energy in a well, for each kilogram [J].
double energy_in_well(const State &ship, double mu) {
    return ship.velocity.squaredNorm() / 2 - mu / ship.position.norm();
}

/// A ship that neither falls into the well nor escapes from it.
State random_ship(Dice &dice, double mu) {
    const Vec2 outwards = dice.direction(), across{-outwards.y(), outwards.x()};
    const double r = dice.real(1, 20), circular = std::sqrt(mu / r);
    return {r * outwards, circular * (dice.real(-0.3, 0.3) * outwards + dice.sign() * dice.real(0.7, 1.2) * across)};
}

} // namespace

//> Worked example: one step
TEST_CASE("8 m from a well of 800 m³/s², at 10 m/s across, a step of 0.1 s leads to (7.875, 1) m", "[3.5]") {
    CHECK_THAT(orbit_step({{8, 0}, {0, 10}}, 800, 0.1),
               IsNear(State{{7.875, 1}, {-1.25, 10}}, rounding)
                   .since("it's pulled with 800 / 64 = 12.5 m/s², and at (-1.25, 10) m/s it moves by (-0.125, 1)"));
    CHECK_THAT(orbit_step({{3, 4}, {2, 1}}, 800, 0.5),
               IsNear(State{{-0.8, -1.9}, {-7.6, -11.8}}, rounding)
                   .since("it's pulled with 800 / 25 = 32 m/s², along (-0.6, -0.8), for 0.5 s"));
}

//> Round and round
TEST_CASE("a ship on a circle of 8 m is still between 7.8 and 8.2 m away after a turn, in steps of 1/60 s", "[3.5]") {
    State ship{{8, 0}, {0, 10}};
    for (int frame = 0; frame < 302; ++frame) { // 5.03 s
        ship = orbit_step(ship, 800, 1.0 / 60);
        CHECK_THAT(ship.position.norm(), IsAtLeast(7.8).of("distance from the well [m]"));
        CHECK_THAT(ship.position.norm(), IsAtMost(8.2).of("distance from the well [m]"));
    }
}

//> Angular momentum
TEST_CASE("angular momentum stays the same in every step, whatever its length, up to rounding", "[3.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const double mu = dice.real(1, 1000);
        const State ship = random_ship(dice, mu);

        const State after = orbit_step(ship, mu, dice.real(0, 0.2));

        const double size = ship.position.norm() * ship.velocity.norm();
        CHECK_THAT((angular_momentum(after) - angular_momentum(ship)) / size,
                   IsNear(0.0, 1e-11).of("change of angular momentum, relative [1]"));
    }
}

//> A long ellipse
TEST_CASE("on a long ellipse, angular momentum stays to eleven digits for 600 steps, and energy to a tenth", "[3.5]") {
    State ship{{12, 0}, {0, 5}}; // a long ellipse: at 10 m/s it would escape at 16 m
    const double momentum = angular_momentum(ship), energy = energy_in_well(ship, 800);
    for (int frame = 0; frame < 600; ++frame) {
        ship = orbit_step(ship, 800, 1.0 / 120);
        if (frame % 20 != 0) continue;
        CHECK_THAT(angular_momentum(ship) / momentum,
                   IsNear(1.0, 1e-11).of("angular momentum, of that at the start [1]"));
        CHECK_THAT(energy_in_well(ship, 800) / energy, IsNear(1.0, 0.1).of("energy, of that at the start [1]"));
    }
}

//>
TEST_CASE("without a well, or in a step of 0 s, nothing is pulled", "[3.5]") {
    CHECK_THAT(orbit_step({{8, -3}, {2, 10}}, 0, 0.5), IsNear(State{{9, 2}, {2, 10}}, rounding));
    CHECK_THAT(orbit_step({{8, -3}, {2, 10}}, 800, 0), IsNear(State{{8, -3}, {2, 10}}, rounding));
}

//> Through the middle
TEST_CASE("in the middle of the well nothing pulls, and the ship flies on", "[3.5]") {
    CHECK_THAT(orbit_step({{0, 0}, {2, -4}}, 800, 0.5), IsNear(State{{1, -2}, {2, -4}}, rounding));
    CHECK_THAT(orbit_step({{0, 0}, {0, 0}}, 800, 0.5), IsNear(State{{0, 0}, {0, 0}}));
}

//>
TEST_CASE("turned by any angle, or seen in a mirror, the step is the same", "[3.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const State ship = random_ship(dice, 300);
        const Vec2 turn = dice.direction();
        const auto turned = [&](const Vec2 &v) {
            return Vec2{turn.x() * v.x() - turn.y() * v.y(), -(turn.y() * v.x() + turn.x() * v.y())};
        };

        const State after = orbit_step(ship, 300, 0.05);
        const State seen = orbit_step({turned(ship.position), turned(ship.velocity)}, 300, 0.05);

        CHECK_THAT(seen, IsNear(State{turned(after.position), turned(after.velocity)}, 1e-10));
    }
}

//>
TEST_CASE("orbit_step allows numbers up to 1e5, long steps, and ships far away or near the middle", "[3.5]") {
    CHECK_THAT(orbit_step({{1e5, 0}, {-1e5, 1e5}}, 1e5, 1), IsNear(State{{-1e-5, 1e5}, {-1e5 - 1e-5, 1e5}}, rounding));
    CHECK_THAT(orbit_step({{0, -1e5}, {1e5, -1e5}}, 1e5, 1),
               IsNear(State{{1e5, 1e-5 - 2e5}, {1e5, 1e-5 - 1e5}}, rounding));
    CHECK_THAT(orbit_step({{0, 2e-9}, {0, 0}}, 1e-9, 0.001), IsNear(State{{0, 2e-9 - 250}, {0, -2.5e5}}, rounding));
    CHECK_THAT(orbit_step({{3e-9, 0}, {2e-9, -4e-9}}, 0, 1), IsNear(State{{5e-9, -4e-9}, {2e-9, -4e-9}}, rounding));
    const Vec2 corner{-1e5, 1e5}, gained = -0.25 * std::sqrt(2.0) * corner / 1e5; // 5e-6 m/s² for 1e5 s, at 45°
    CHECK_THAT(orbit_step({corner, {0, 0}}, 1e5, 1e5), IsNear(State{corner + 1e5 * gained, gained}, rounding));
    CHECK_THAT(orbit_step({{4, 0}, {0, 0}}, 800, 1e3), IsNear(State{{-5e7 + 4, 0}, {-5e4, 0}}, rounding));
}

TEST_CASE("a negative mu or dt is refused by orbit_step", "[3.5]") {
    CHECK_REFUSED(orbit_step({{8, 0}, {0, 10}}, -800, 0.1));
    CHECK_REFUSED(orbit_step({{8, 0}, {0, 10}}, 800, -0.1));
    orbit_step({{8, 0}, {0, 10}}, 800, 0.1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------ 3.6 softened_gravity

//> Worked example: softened by 3 m
TEST_CASE("4 m from a well of 1000 m³/s² that is softened by 3 m, the pull is 32 m/s²", "[3.6]") {
    CHECK_THAT(softened_gravity({4, 0}, 1000, 3),
               IsNear(Vec2{-32, 0}, rounding).since("√(4² + 3²) = 5 m, and 1000 · 4 / 5³ = 32 m/s²"));
    CHECK_THAT(softened_gravity({0, -3}, 1000, 4),
               IsNear(Vec2{0, 24}, rounding).since("√(3² + 4²) = 5 m, and 1000 · 3 / 5³ = 24 m/s²"));
}

//> Far away
TEST_CASE("far away, softening makes no difference: at 100 m, softened by 1 cm, the pull is that of 1/r²", "[3.6]") {
    const double mu = 1e4, epsilon = 0.01;
    const Vec2 far{60, 80}; // 100 m away
    CHECK_THAT(softened_gravity(far, mu, epsilon), IsNear(Vec2{-0.6, -0.8}, 1e-7));
}

//> In the middle
TEST_CASE("in the middle of a softened well nothing pulls, and close to it, little", "[3.6]") {
    CHECK_THAT(softened_gravity({0, 0}, 1000, 3), IsNear(Vec2{0, 0}));
    // 1000 · 0.001 / 2³
    CHECK_THAT(softened_gravity({0.001, 0}, 1000, 2), IsNear(Vec2{-0.125, 0}, 1e-6));
    CHECK_THAT(softened_gravity({0, -0.001}, 1000, 2), IsNear(Vec2{0, 0.125}, 1e-6));
}

//> At most
TEST_CASE("the strongest pull is 2 mu / (3 √3 epsilon²), where r is epsilon / √2", "[3.6]") {
    const double strongest = 2 * 1000 / (3 * std::sqrt(3.0) * 4); // 96.225 m/s²
    CHECK_THAT(softened_gravity({std::sqrt(2.0), 0}, 1000, 2), IsNear(Vec2{-strongest, 0}, 1e-11));
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const Vec2 pull = softened_gravity(dice.point(-5, 5), 1000, 2);

        CHECK_THAT(pull.norm(), IsAtMost(strongest * (1 + 1e-12)).of("strength of the pull [m/s²]"));
    }
}

//> The slope of a potential
TEST_CASE("the pull is the slope of -mu / √(r² + epsilon²), so a ship that falls keeps its energy", "[3.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        const double mu = dice.real(1, 1000), epsilon = dice.real(0.5, 5), h = 1e-4;
        const Vec2 at = dice.point(-10, 10);
        const auto potential = [&](double x, double y) { return -mu / std::sqrt(x * x + y * y + epsilon * epsilon); };

        const Vec2 pull = softened_gravity(at, mu, epsilon);

        const Vec2 slope{(potential(at.x() + h, at.y()) - potential(at.x() - h, at.y())) / (2 * h),
                         (potential(at.x(), at.y() + h) - potential(at.x(), at.y() - h)) / (2 * h)};
        CHECK_THAT(Vec2{(pull + slope) * epsilon * epsilon / mu},
                   IsNear(Vec2{0, 0}, 1e-6).of("difference, of the largest pull [1]"));
    }
}

//> A plunge
TEST_CASE("a ship that falls straight through a softened well swings back and forth, and stays finite", "[3.6]") {
    State ship{{10, 0}, {0, 0}};
    for (int frame = 0; frame < 600; ++frame) {
        ship.velocity += softened_gravity(ship.position, 1000, 2) / 60;
        ship.position += ship.velocity / 60;
        CHECK_THAT(ship.position.norm(), IsAtMost(11.0).of("distance from the well [m]"));
    }
}

//>
TEST_CASE("a well without strength does not pull; one twice as strong pulls twice as hard", "[3.6]") {
    CHECK_THAT(softened_gravity({4, 0}, 0, 3), IsNear(Vec2{0, 0}));
    CHECK_THAT(softened_gravity({4, 0}, 2000, 3), IsNear(Vec2{-64, 0}, rounding));
    CHECK_THAT(softened_gravity({-2.4, 3.2}, 1000, 3), IsNear(Vec2{19.2, -25.6}, rounding)); // also 4 m away
}

TEST_CASE("softened_gravity allows positions and mu up to 1e5, and a small epsilon", "[3.6]") {
    CHECK_THAT(Vec2{1e14 * softened_gravity({1e5, 0}, 1e-4, 1e-3)},
               IsNear(Vec2{-1, 0}, rounding).of("pull [1e-14 m/s²]"));
    CHECK_THAT(softened_gravity({0, 3e4}, 1e5, 4e4) * 1e5, IsNear(Vec2{0, -2.4}, rounding).of("pull [1e-5 m/s²]"));
    CHECK_THAT(Vec2{softened_gravity({-1e5, -1e5}, 1e5, 1e5) * 1e5},
               IsNear(Vec2{1 / std::sqrt(27.0), 1 / std::sqrt(27.0)}, rounding).of("pull [1e-5 m/s²]"));
    CHECK_THAT(Vec2{softened_gravity({-3e-9, 0}, 1, 4e-9) / 2.4e16},
               IsNear(Vec2{1, 0}, rounding).of("pull [2.4e16 m/s²]"));
    CHECK_THAT(softened_gravity({1, 0}, 1e5, 3), IsNear(Vec2{-std::sqrt(1e7), 0}, rounding));
    const double nearly_one = std::pow(1 + 5e-5 * 5e-5, -1.5); // r and epsilon differ by a factor of 20 000
    CHECK_THAT(softened_gravity({60, 80}, 1e4, 0.005), IsNear(Vec2{nearly_one * Vec2{-0.6, -0.8}}, rounding));
    CHECK_THAT(softened_gravity({0, 1e-4}, 8e4, 2), IsNear(Vec2{0, -nearly_one}, rounding));
}

TEST_CASE("a negative mu, or an epsilon of 0 or less, is refused", "[3.6]") {
    CHECK_REFUSED(softened_gravity({4, 0}, -1000, 3));
    CHECK_REFUSED(softened_gravity({4, 0}, 1000, 0));
    CHECK_REFUSED(softened_gravity({4, 0}, 1000, -3));
    softened_gravity({4, 0}, 1000, 3); // good input is still answered
}

// -------------------------------------------------------------------------------------------------------- 3.7 step_all

namespace {

Integrators all_from(const State &ship) { return {ship, ship, ship, ship}; }

constexpr State Integrators::*each_of_four[]{&Integrators::explicit_euler, &Integrators::semi_implicit,
                                             &Integrators::leapfrog, &Integrators::runge_kutta};

/// How far from where it should be each of the four is after a quarter of a turn on an ellipse, in so many steps [m].
std::array<double, 4> errors_after_a_quarter(int steps) {
    Integrators now = all_from({{0.5, 0}, {0, std::sqrt(3.0)}}); // semi-major axis 1 m, eccentricity 0.5, mu 1 m³/s²
    for (int i = 0; i < steps; ++i) now = step_all(now, 1, std::numbers::pi / 2 / steps);
    const Vec2 want{-0.93513086, 0.77974089};
    std::array<double, 4> errors{};
    for (std::size_t k = 0; k < 4; ++k) errors[k] = ((now.*each_of_four[k]).position - want).norm();
    return errors;
}

} // namespace

//> Worked example: one step of two
TEST_CASE("explicit Euler moves at the old velocity, to (8, 1) m; semi-implicit Euler to (7.875, 1) m", "[3.7]") {
    // both gain (-1.25, 0) m/s in 0.1 s, as in 3.5
    const Integrators after = step_all(all_from({{8, 0}, {0, 10}}), 800, 0.1);
    CHECK_THAT(after.explicit_euler, IsNear(State{{8, 1}, {-1.25, 10}}, rounding).of("explicit_euler"));
    CHECK_THAT(after.semi_implicit, IsNear(State{{7.875, 1}, {-1.25, 10}}, rounding).of("semi_implicit"));
}

//> Leapfrog
TEST_CASE("a leapfrog step of 0.4 s, from rest at 8 m: half of a pull, then 1 m nearer, then half of the pull there",
          "[3.7]") {
    // at rest at 8 m: half of a step of 0.4 s gives -2.5 m/s, which moves it to 7 m; there it is pulled with 800/49 m/s²
    const Integrators after = step_all(all_from({{8, 0}, {0, 0}}), 800, 0.4);
    CHECK_THAT(after.leapfrog, IsNear(State{{7, 0}, {-2.5 - 0.2 * 800 / 49, 0}}, rounding).of("leapfrog"));
}

//> Runge and Kutta
TEST_CASE("a Runge–Kutta step of 0.4 s, from rest at 8 m, with its four slopes worked out by hand", "[3.7]") {
    // k1: 0 m/s, -12.5 m/s²; k2, at 8 m and -2.5 m/s: -12.5; k3, at 7.5 m and -2.5 m/s: -800/56.25; k4, at 7 m: -800/49
    const Integrators after = step_all(all_from({{8, 0}, {0, 0}}), 800, 0.4);
    const double k3 = -800 / 56.25, k4 = -800.0 / 49;
    const State want{{8 + 0.4 / 6 * (2 * -2.5 + 2 * -2.5 + 0.4 * k3), 0},
                     {0.4 / 6 * (-12.5 + 2 * -12.5 + 2 * k3 + k4), 0}};
    CHECK_THAT(after.runge_kutta, IsNear(want, rounding).of("runge_kutta"));
}

//> Each from its own state
TEST_CASE("each of the four starts from its own state", "[3.7]") {
    const State a{{8, 0}, {0, 10}}, b{{3, 4}, {2, 1}}, c{{-5, 2}, {1, 9}}, d{{6, -7}, {-3, -8}};
    const Integrators after = step_all({a, b, c, d}, 800, 0.1);
    CHECK_THAT(after.explicit_euler, IsNear(step_all(all_from(a), 800, 0.1).explicit_euler).of("explicit_euler"));
    CHECK_THAT(after.semi_implicit, IsNear(step_all(all_from(b), 800, 0.1).semi_implicit).of("semi_implicit"));
    CHECK_THAT(after.leapfrog, IsNear(step_all(all_from(c), 800, 0.1).leapfrog).of("leapfrog"));
    CHECK_THAT(after.runge_kutta, IsNear(step_all(all_from(d), 800, 0.1).runge_kutta).of("runge_kutta"));
}

//> Orders
TEST_CASE("with steps half as long, the error after a quarter of a turn is 2, 2, 4 and 16 times smaller", "[3.7]") {
    const std::array<double, 4> long_steps = errors_after_a_quarter(200), short_steps = errors_after_a_quarter(400);
    constexpr double want[]{2, 2, 4, 16};
    constexpr const char *names[]{"explicit_euler: ratio of the errors [1]", "semi_implicit: ratio of the errors [1]",
                                  "leapfrog: ratio of the errors [1]", "runge_kutta: ratio of the errors [1]"};
    for (std::size_t k = 0; k < 3; ++k) CHECK_THAT(long_steps[k] / short_steps[k], IsNear(want[k], 0.03).of(names[k]));
    // 50 and 100 steps: more, and only the eight digits of the place where it should be would be seen
    CHECK_THAT(errors_after_a_quarter(25)[3] / errors_after_a_quarter(50)[3], IsNear(want[3], 0.2).of(names[3]));
}

//> Energy out of nothing
TEST_CASE("on a long ellipse explicit Euler gains energy in every turn; leapfrog gives it back", "[3.7]") {
    Integrators now = all_from({{0.5, 0}, {0, std::sqrt(3.0)}});
    for (int i = 0; i < 200; ++i) now = step_all(now, 1, 2 * std::numbers::pi / 200);
    CHECK_THAT(energy_in_well(now.explicit_euler, 1) + 0.5,
               IsNear(0.2007, 1e-4).of("explicit_euler: energy gained [J]"));
    CHECK_THAT(energy_in_well(now.leapfrog, 1) + 0.5, IsNear(0.0, 1e-3).of("leapfrog: energy gained [J]"));
    CHECK_THAT(energy_in_well(now.runge_kutta, 1) + 0.5, IsNear(0.0, 1e-4).of("runge_kutta: energy gained [J]"));
}

//> Back again
TEST_CASE("if its velocity is turned round, leapfrog flies back the way it came, to where it started", "[3.7]") {
    Integrators now = all_from({{8, 0}, {0, 7}});
    for (int i = 0; i < 50; ++i) now = step_all(now, 800, 0.02);
    CHECK_THAT((now.leapfrog.position - Vec2{8, 0}).norm(), IsAtLeast(2).of("leapfrog: distance from the start [m]"));
    now.leapfrog.velocity *= -1;
    for (int i = 0; i < 50; ++i) now = step_all(now, 800, 0.02);
    CHECK_THAT(now.leapfrog, IsNear(State{{8, 0}, {0, -7}}, 1e-9).of("leapfrog"));
}

//>
TEST_CASE("leapfrog and semi-implicit Euler keep the angular momentum, up to rounding", "[3.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        const State ship = random_ship(dice, 300);

        const Integrators after = step_all(all_from(ship), 300, dice.real(0, 0.2));

        const double size = ship.position.norm() * ship.velocity.norm();
        CHECK_THAT((angular_momentum(after.leapfrog) - angular_momentum(ship)) / size,
                   IsNear(0.0, 1e-11).of("leapfrog: change of angular momentum, relative [1]"));
        CHECK_THAT((angular_momentum(after.semi_implicit) - angular_momentum(ship)) / size,
                   IsNear(0.0, 1e-11).of("semi_implicit: change of angular momentum, relative [1]"));
    }
}

//>
TEST_CASE("without a well, in a step of 0 s, and in the middle of the well, all four fly straight on", "[3.7]") {
    const State flying{{8, -3}, {2, 10}}, further{{9, 2}, {2, 10}}, middle{{0, 0}, {0, 0}};
    for (const auto which : each_of_four) {
        CHECK_THAT(step_all(all_from(flying), 0, 0.5).*which, IsNear(further, rounding).of("one of the four"));
        CHECK_THAT(step_all(all_from(flying), 800, 0).*which, IsNear(flying, rounding).of("one of the four"));
        CHECK_THAT(step_all(all_from(middle), 800, 0.5).*which, IsNear(middle, rounding).of("one of the four"));
    }
    // the last two are pulled when they have left it: leapfrog at 2 m; Runge–Kutta at 1 m, three times
    const Integrators left = step_all(all_from({{0, 0}, {4, 0}}), 8, 0.5);
    CHECK_THAT(left.explicit_euler, IsNear(State{{2, 0}, {4, 0}}, rounding).of("explicit_euler"));
    CHECK_THAT(left.semi_implicit, IsNear(State{{2, 0}, {4, 0}}, rounding).of("semi_implicit"));
    CHECK_THAT(left.leapfrog, IsNear(State{{2, 0}, {3.5, 0}}, rounding).of("leapfrog"));
    CHECK_THAT(left.runge_kutta, IsNear(State{{4.0 / 3, 0}, {2.0 / 3, 0}}, rounding).of("runge_kutta"));
}

TEST_CASE("step_all allows numbers up to 1e5 and small ones, and answers beyond them", "[3.7]") {
    const Integrators after = step_all(all_from({{1e5, -1e5}, {1e5, 1e5}}), 0, 1e5);
    const Integrators slow = step_all(all_from({{4e-9, 0}, {2e-9, 0}}), 0, 1);
    for (const auto which : each_of_four) {
        CHECK_THAT(after.*which, IsNear(State{{1e10 + 1e5, 1e10 - 1e5}, {1e5, 1e5}}, rounding).of("one of the four"));
        CHECK_THAT(slow.*which, IsNear(State{{6e-9, 0}, {2e-9, 0}}, rounding).of("one of the four"));
    }
    for (const auto &[r, mu, dt] : {std::array{4.0, 1e5, 1e3}, std::array{2e-9, 1e-9, 1e-3}}) {
        // from rest; half a step later it is so far away that nothing pulls on it any more
        const double fast = mu / (r * r) * dt, far = fast * dt;
        const Integrators fallen = step_all(all_from({{0, r}, {0, 0}}), mu, dt);
        CHECK_THAT(fallen.explicit_euler, IsNear(State{{0, r}, {0, -fast}}, rounding).of("explicit_euler"));
        CHECK_THAT(fallen.semi_implicit, IsNear(State{{0, r - far}, {0, -fast}}, rounding).of("semi_implicit"));
        CHECK_THAT(fallen.leapfrog, IsNear(State{{0, r - far / 2}, {0, -fast / 2}}, rounding).of("leapfrog"));
        CHECK_THAT(fallen.runge_kutta, IsNear(State{{0, r - far / 3}, {0, -fast / 2}}, rounding).of("runge_kutta"));
    }
}

TEST_CASE("in other units, and turned by 90°, a step is the same: far away, and close to the well", "[3.7]") {
    Dice dice;
    const auto turned = [](const Vec2 &v) { return Vec2{-v.y(), v.x()}; };
    for (int i = 0; i < course::cases(3000); ++i) {
        const State ship{dice.point(-20, 20), dice.point(-40, 40)};
        const double mu = dice.real(1, 50), dt = dice.real(0.1, 10);

        const Integrators want = step_all(all_from(ship), mu, dt);

        CHECK_THAT(
            want.explicit_euler,
            IsNear(State{ship.position + dt * ship.velocity, want.semi_implicit.velocity}, 1e-11).of("explicit_euler"));
        // powers of two, which round nothing: about 100 km away; at some km/s; less than a micrometre away
        for (const auto &[metre, second] :
             {std::array{0x1p12, 0x1p13}, std::array{0x1p-6, 0x1p-13}, std::array{0x1p-26, 0x1p-26}}) {
            const State seen{turned(ship.position) * metre, turned(ship.velocity) * metre / second};
            const Integrators got =
                step_all(all_from(seen), mu * metre * metre * metre / (second * second), dt * second);
            for (const auto which : each_of_four) {
                const State &moved = got.*which;
                CHECK_THAT((State{moved.position / metre, moved.velocity / metre * second}),
                           IsNear(State{turned((want.*which).position), turned((want.*which).velocity)}, 1e-9)
                               .of("one of the four, turned, in the first units"));
            }
        }
    }
}

TEST_CASE("a negative mu or dt is refused by step_all", "[3.7]") {
    const Integrators good = all_from({{8, 1}, {2, 10}});
    CHECK_REFUSED(step_all(good, -800, 0.1));
    CHECK_REFUSED(step_all(good, 800, -0.1));
    step_all(good, 800, 0.1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------- 3.8 kepler_position

//> Worked example: a quarter of a circle
TEST_CASE("on a circle of 8 m around 800 m³/s², a quarter of a turn takes 0.4 π s", "[3.8]") {
    // 10 m/s, so once around in 2 π · 8 / 10 s
    const double quarter = 0.4 * std::numbers::pi;
    CHECK_THAT(kepler_position(8, 0, 800, quarter), IsNear(Vec2{0, 8}, 1e-9));
    CHECK_THAT(kepler_position(8, 0, 800, -quarter), IsNear(Vec2{0, -8}, 1e-9));
    CHECK_THAT(kepler_position(8, 0, 800, 2 * quarter), IsNear(Vec2{-8, 0}, 1e-9));
}

//> The ends of the ellipse
TEST_CASE("it starts at the near end of the ellipse, and is at the far end half a turn later", "[3.8]") {
    CHECK_THAT(kepler_position(8, 0.5, 800, 0), IsNear(Vec2{4, 0}, 1e-9));
    CHECK_THAT(kepler_position(8, 0.5, 800, 0.8 * std::numbers::pi), IsNear(Vec2{-12, 0}, 1e-8));
    CHECK_THAT(kepler_position(8, 0.5, 800, 1.6 * std::numbers::pi), IsNear(Vec2{4, 0}, 1e-8));
}

//> A quarter of the time
TEST_CASE("after a quarter of the time it is well beyond a quarter of the angle: near the well it is fast", "[3.8]") {
    const double quarter = std::numbers::pi / 2; // for an ellipse of 1 m and mu = 1 m³/s²
    CHECK_THAT(kepler_position(1, 0.5, 1, quarter), IsNear(Vec2{-0.93513086, 0.77974089}, 1e-8));
    CHECK_THAT(kepler_position(1, 0.5, 1, -quarter), IsNear(Vec2{-0.93513086, -0.77974089}, 1e-8));
    for (const int turns : {-7, -1, 1, 3}) // and at the same place some turns before or after
        CHECK_THAT(kepler_position(1, 0.5, 1, quarter + turns * 2 * std::numbers::pi),
                   IsNear(Vec2{-0.93513086, 0.77974089}, 1e-8));
}

//> On the ellipse
TEST_CASE("it is always on the ellipse: its distances from both foci add up to 2 semi_major", "[3.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const double a = dice.real(0.5, 20), e = dice.real(0, 0.95);

        const Vec2 at = kepler_position(a, e, dice.real(1, 1000), dice.real(-20, 20));

        const double from_other_focus = std::hypot(at.x() + 2 * a * e, at.y());
        CHECK_THAT((at.norm() + from_other_focus) / (2 * a), IsNear(1.0, 1e-8).of("sum of the distances / 2 a [1]"));
    }
}

//> Equal areas
TEST_CASE("the line from the well to the ship sweeps over the same area in equal times", "[3.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double a = dice.real(0.5, 20), e = dice.real(0, 0.9), mu = dice.real(1, 1000);
        const double turn = 2 * std::numbers::pi * std::sqrt(a * a * a / mu), t = dice.real(0, 1) * turn;

        const Vec2 now = kepler_position(a, e, mu, t), soon = kepler_position(a, e, mu, t + 1e-4 * turn);

        const double area = (now.x() * soon.y() - now.y() * soon.x()) / 2;
        const double whole = std::numbers::pi * a * a * std::sqrt(1 - e * e);
        CHECK_THAT(area / whole * 1e4, IsNear(1.0, 1e-2).of("area swept, of its share of the ellipse [1]"));
    }
}

//>
TEST_CASE("a ship that is moved in small steps is where Kepler says", "[3.8]") {
    Vec2 position{4, 0}, velocity{0, std::sqrt(800.0 * 3 / 8)}; // semi_major 8 m, eccentricity 0.5
    const double dt = 1e-4;
    for (int i = 1; i <= 40000; ++i) { // each step: half of the pull, the motion, the other half
        velocity -= dt / 2 * 800 / std::pow(position.norm(), 3) * position;
        position += dt * velocity;
        velocity -= dt / 2 * 800 / std::pow(position.norm(), 3) * position;
        if (i % 1000 == 0) CHECK_THAT(kepler_position(8, 0.5, 800, i * dt), IsNear(position, 1e-4));
    }
}

//>
TEST_CASE("on ellipses as long as 0.99 it starts fast, and is found again after a hundred turns", "[3.8]") {
    const double turn = 2 * std::numbers::pi; // for an ellipse of 1 m and mu = 1 m³/s²
    CHECK_THAT(kepler_position(1, 0.99, 1, turn / 2), IsNear(Vec2{-1.99, 0}, 1e-8));
    CHECK_THAT(kepler_position(1, 0.99, 1, 100 * turn), IsNear(Vec2{0.01, 0}, 1e-8));
    CHECK_THAT(kepler_position(1, 0.99, 1, -100 * turn), IsNear(Vec2{0.01, 0}, 1e-8));
    for (int k = 1; k < 200; ++k) { // an angle E first, then the time at which it is there
        const double angle = k * std::numbers::pi / 100, e = 0.99;
        const Vec2 want{std::cos(angle) - e, std::sqrt(1 - e * e) * std::sin(angle)};
        CHECK_THAT(kepler_position(1, e, 1, angle - e * std::sin(angle) + (k - 100) * turn), IsNear(want, 1e-9));
    }
    // from E = M, Newton's method wanders for more than a thousand steps at these times; by bisection, with 40 digits
    CHECK_THAT(kepler_position(1, 0.99, 1, -0.073202524545436354),
               IsNear(Vec2{-0.25340228877113, -0.095408248359702}, 1e-9));
    CHECK_THAT(kepler_position(1, 0.99, 1, 471.30970232433822),
               IsNear(Vec2{-0.247374679986423, 0.0944738160449083}, 1e-9));
    CHECK_THAT(Vec2{kepler_position(1e5, 0.2, 1e5, 0) / 1e5}, IsNear(Vec2{0.8, 0}, 1e-9).of("position [1e5 m]"));
    const double long_one = 0.8 / std::sin(1.8); // 1e5 s before it is nearest, the angle E is -1.8
    CHECK_THAT(Vec2{kepler_position(1e5, long_one, 1e5, -1e5) / 1e5},
               IsNear(Vec2{std::cos(1.8) - long_one, -std::sqrt(1 - long_one * long_one) * std::sin(1.8)}, 1e-9)
                   .of("position [1e5 m]"));
    CHECK_THAT(Vec2{kepler_position(4e-9, 0, 1e-9, std::numbers::pi * 4e-9) / 4e-9},
               IsNear(Vec2{0, 1}, 1e-9).of("position [4e-9 m]"));
    CHECK_THAT(kepler_position(1, 5e-7, 1, 1.8 - 5e-7 * std::sin(1.8)),
               IsNear(Vec2{std::cos(1.8) - 5e-7, std::sin(1.8)}, 1e-9));
    // beyond that it need not be as exact
    CHECK_THAT(kepler_position(1, 0.999, 1, turn / 2), IsNear(Vec2{-1.999, 0}, 1e-6));
    CHECK_THAT(kepler_position(1, 0.5, 1, 1000 * turn), IsNear(Vec2{0.5, 0}, 1e-6));
}

TEST_CASE("a size, mu or eccentricity that no ellipse has is refused", "[3.8]") {
    CHECK_REFUSED(kepler_position(0, 0.5, 800, 1));
    CHECK_REFUSED(kepler_position(-8, 0.5, 800, 1));
    CHECK_REFUSED(kepler_position(8, -0.1, 800, 1));
    CHECK_REFUSED(kepler_position(8, 1, 800, 1));
    CHECK_REFUSED(kepler_position(8, 1.5, 800, 1));
    CHECK_REFUSED(kepler_position(8, 0.5, 0, 1));
    CHECK_REFUSED(kepler_position(8, 0.5, -800, 1));
    kepler_position(8, 0.5, 800, 1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 3.9 fly_lander

namespace {

using gravity_wells::Controls, gravity_wells::Lander;

constexpr double moon = 1.6; // [m/s²]
constexpr Controls nothing, burning{true, 0};

/// Its flight with the same controls, in frames of `dt`.
Lander flown(Lander now, const Controls &controls, double pad, double g, double time, int frames) {
    for (int i = 0; i < frames; ++i) now = fly_lander(now, controls, pad, g, time / frames);
    return now;
}

/// High above the ground and without much fuel, at any speed.
Lander random_lander(Dice &dice) {
    return {{{dice.real(-20, 20), dice.real(1, 40)}, dice.point(-4, 4)}, dice.real(0, 3), false, false};
}

Controls random_controls(Dice &dice) { return {dice.whole(0, 1) == 1, dice.whole(-1, 1)}; }

/// How close to landing and crashing a touch may come for a test: rounding may decide beyond that.
bool is_a_close_call(const Lander &down, double pad) {
    const double speed = down.state.velocity.norm(), off = std::abs(down.state.position.x() - pad);
    return std::abs(speed - gravity_wells::soft) < 1e-6 || std::abs(off - gravity_wells::half_pad) < 1e-6;
}

} // namespace

//> Worked example: nobody steers
TEST_CASE("falls from 20 m in 5 s when nobody steers, and crashes at 8 m/s", "[3.9]") {
    const Lander now{{{0, 20}, {0, 0}}, 9};
    CHECK_THAT(fly_lander(now, nothing, 0, moon, 2), IsNear(Lander{{{0, 16.8}, {0, -3.2}}, 9}, rounding));
    CHECK_THAT(fly_lander(now, nothing, 0, moon, 6), IsNear(Lander{{{0, 0}, {0, -8}}, 9, false, true}, rounding));
}

//> The engine
TEST_CASE("rises with its engine on, by 4.5 - 1.6 = 2.9 m/s each second, and burns 1 s of fuel", "[3.9]") {
    CHECK_THAT(fly_lander({{{0, 10}, {0, 0}}, 9}, burning, 0, moon, 2),
               IsNear(Lander{{{0, 15.8}, {0, 5.8}}, 7}, rounding));
}

//> Just enough
TEST_CASE("where g is 4.5 m/s², its engine just holds it: it hovers, or sinks at a steady 1 m/s", "[3.9]") {
    CHECK_THAT(fly_lander({{{0, 10}, {0, 0}}, 9}, burning, 0, 4.5, 2), IsNear(Lander{{{0, 10}, {0, 0}}, 7}, rounding));
    CHECK_THAT(fly_lander({{{0, 3}, {0, -1}}, 4}, burning, 0, 4.5, 5),
               IsNear(Lander{{{0, 0}, {0, -1}}, 1, true, false}, rounding));
    CHECK_THAT(fly_lander({{{0, 0}, {0, 0}}, 4}, burning, 0, 4.5, 5),
               IsNear(Lander{{{0, 0}, {0, 0}}, 4, true, false})); // it stands, and isn't lifted
}

TEST_CASE("on the Earth, its engine is too weak: it falls by 5.3 m/s more each second", "[3.9]") {
    CHECK_THAT(fly_lander({{{0, 10}, {0, 0}}, 9}, burning, 0, 9.8, 1),
               IsNear(Lander{{{0, 7.35}, {0, -5.3}}, 8}, rounding));
}

//> The jets
TEST_CASE("its jets push it aside by 1 m/s each second, left and right, without fuel", "[3.9]") {
    CHECK_THAT(fly_lander({{{1, 30}, {0, 0}}, 2}, {false, 1}, 0, moon, 2),
               IsNear(Lander{{{3, 26.8}, {2, -3.2}}, 2}, rounding));
    CHECK_THAT(fly_lander({{{1, 30}, {0.5, 0}}, 0}, {false, -1}, 0, moon, 2),
               IsNear(Lander{{{0, 26.8}, {-1.5, -3.2}}, 0}, rounding));
}

//> Out of fuel
TEST_CASE("with fuel for 1 s, its engine stops in the middle of a frame of 2 s, and it falls", "[3.9]") {
    const Lander now{{{0, 10}, {0, 0}}, 1};
    CHECK_THAT(fly_lander(now, burning, 0, moon, 2), IsNear(Lander{{{0, 13.55}, {0, 1.3}}, 0}, rounding));
    CHECK_THAT(fly_lander(now, burning, 0, moon, 1), IsNear(Lander{{{0, 11.45}, {0, 2.9}}, 0}, rounding));
    CHECK_THAT(fly_lander({{{0, 10}, {0, 0}}, 0}, burning, 0, moon, 1),
               IsNear(Lander{{{0, 9.2}, {0, -1.6}}, 0}, rounding));
    CHECK_THAT(fly_lander(now, {true, 1}, 0, moon, 2), IsNear(Lander{{{2, 13.55}, {2, 1.3}}, 0}, rounding));
}

//> A soft landing
TEST_CASE("lands on its pad from 1 m, at 1.79 m/s, and crashes from 1.3 m, at 2.04 m/s", "[3.9]") {
    CHECK_THAT(fly_lander({{{5, 1}, {0, 0}}, 0}, nothing, 5, moon, 3),
               IsNear(Lander{{{5, 0}, {0, -std::sqrt(3.2)}}, 0, true, false}, rounding));
    CHECK_THAT(fly_lander({{{5, 1.3}, {0, 0}}, 0}, nothing, 5, moon, 3),
               IsNear(Lander{{{5, 0}, {0, -std::sqrt(4.16)}}, 0, false, true}, rounding));
}

TEST_CASE("what it drifts sideways counts, too: 1.5 m/s down and 1.5 m/s aside are 2.12 m/s, a crash", "[3.9]") {
    CHECK_THAT(fly_lander({{{0, 0.1}, {1.5, -1.4}}, 0}, nothing, 0, 1.45, 1),
               IsNear(Lander{{{0.1034482758620689, 0}, {1.5, -1.5}}, 0, false, true}, 1e-9));
    CHECK_THAT(fly_lander({{{0, 0.1}, {-1.2, -1.4}}, 0}, nothing, 0, 1.45, 1),
               IsNear(Lander{{{-0.0827586206896552, 0}, {-1.2, -1.5}}, 0, true, false}, 1e-9));
}

//> Beside the pad
TEST_CASE("lands as far as 3 m from the middle of the pad, and crashes beside it, on either side", "[3.9]") {
    for (const double side : {-1.0, 1.0}) {
        for (const double off : {0.0, 2.9, 2.999})
            CHECK_THAT(fly_lander({{{10 + side * off, 0.5}, {0, 0}}, 0}, nothing, 10, moon, 2),
                       IsNear(Lander{{{10 + side * off, 0}, {0, -std::sqrt(1.6)}}, 0, true, false}, rounding));
        for (const double off : {3.001, 3.1, 20.0})
            CHECK_THAT(fly_lander({{{10 + side * off, 0.5}, {0, 0}}, 0}, nothing, 10, moon, 2),
                       IsNear(Lander{{{10 + side * off, 0}, {0, -std::sqrt(1.6)}}, 0, false, true}, rounding));
    }
}

//> It's over
TEST_CASE("changes nothing any more once it has landed or crashed, whatever the controls", "[3.9]") {
    const Lander landed{{{1, 0}, {0.3, -1}}, 5, true, false}, crashed{{{9, 0}, {0, -7}}, 5, false, true};
    const Lander set_down{{{-20, 0}, {0, 0}}, 5, true, false}, wreck{{{1, 0}, {0, 0}}, 5, false, true}; // long ago
    for (const Lander &down : {landed, crashed, set_down, wreck})
        for (const Controls &controls : {nothing, burning, Controls{true, 1}, Controls{false, -1}})
            for (const double dt : {0.0, 0.5, 100.0}) CHECK_THAT(fly_lander(down, controls, 0, moon, dt), IsNear(down));
}

//> Touching with the engine on
TEST_CASE("from 1 m at 5 m/s down, its engine is too late: it touches after 0.213 s, at 4.38 m/s", "[3.9]") {
    const double speed = std::sqrt(19.2), time = (5 - speed) / 2.9;
    CHECK_THAT(fly_lander({{{0, 1}, {0, -5}}, 3}, burning, 0, moon, 1),
               IsNear(Lander{{{0, 0}, {0, -speed}}, 3 - time, false, true}, rounding));
}

TEST_CASE("from 1 m at 2 m/s down, its engine is in time: it rises again 0.31 m above the ground", "[3.9]") {
    CHECK_THAT(fly_lander({{{0, 1}, {0, -2}}, 3}, burning, 0, moon, 1),
               IsNear(Lander{{{0, 0.45}, {0, 0.9}}, 2}, rounding));
    CHECK_THAT(fly_lander({{{0, 1}, {0, -2}}, 3}, burning, 0, moon, 2),
               IsNear(Lander{{{0, 2.8}, {0, 3.8}}, 1}, rounding));
}

//> On the ground
TEST_CASE("on the ground it touches at once, unless it moves up, or its engine is about to lift it", "[3.9]") {
    const Lander standing{{{0, 0}, {0, 0}}, 3};
    CHECK_THAT(fly_lander(standing, nothing, 0, moon, 1), IsNear(Lander{{{0, 0}, {0, 0}}, 3, true, false}));
    CHECK_THAT(fly_lander(standing, burning, 0, 9.8, 1), IsNear(Lander{{{0, 0}, {0, 0}}, 3, true, false}));
    CHECK_THAT(fly_lander(standing, burning, 0, moon, 1), IsNear(Lander{{{0, 1.45}, {0, 2.9}}, 2}, rounding));
    CHECK_THAT(fly_lander({{{0, 0}, {0, 4}}, 0}, nothing, 0, moon, 1),
               IsNear(Lander{{{0, 3.2}, {0, 2.4}}, 0}, rounding));
    CHECK_THAT(fly_lander({{{0, 0}, {0, 4}}, 0}, nothing, 0, moon, 9),
               IsNear(Lander{{{0, 0}, {0, -4}}, 0, false, true}, rounding));
    CHECK_THAT(fly_lander({{{0, 0}, {0, -3}}, 3}, burning, 0, moon, 1),
               IsNear(Lander{{{0, 0}, {0, -3}}, 3, false, true}));
}

TEST_CASE("a hop that its last drop of fuel makes ends in the same frame, on the ground", "[3.9]") {
    // 0.5 s up at 2.9 m/s² are 0.3625 m and 1.45 m/s; it falls from there at 1.6 m/s²
    const double speed = std::sqrt(1.45 * 1.45 + 3.2 * 0.3625);
    CHECK_THAT(fly_lander({{{0, 0}, {0, 0}}, 0.5}, burning, 0, moon, 9),
               IsNear(Lander{{{0, 0}, {0, -speed}}, 0, true, false}, rounding));
}

//> A flight on any screen
TEST_CASE("ends at the same place, speed and fuel at 1, 10, 60 and 144 frames a second", "[3.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Lander start = random_lander(dice);
        const double pad = dice.real(-20, 20);
        for (const int rate : {10, 60, 144}) {
            Dice same = dice;
            Lander slow = start, fast = start;
            for (int second = 0; second < 8; ++second) {
                const Controls controls = random_controls(same);
                slow = fly_lander(slow, controls, pad, moon, 1);
                fast = flown(fast, controls, pad, moon, 1, rate);
            }
            if (is_a_close_call(slow, pad)) continue;
            CHECK_THAT(fast,
                       IsNear(slow, 1e-9).of("lander after 8 s, at " + std::to_string(rate) + " frames a second"));
        }
        random_lander(dice); // all three have used the same controls
    }
}

//> Cut in two
TEST_CASE("a frame cut in two comes to the same as the whole frame, wherever it's cut", "[3.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Lander start = random_lander(dice);
        const Controls controls = random_controls(dice);
        const double pad = start.state.position.x(), dt = dice.real(0, 6), part = dice.real(0, dt);

        const Lander whole = fly_lander(start, controls, pad, moon, dt);

        if (is_a_close_call(whole, pad)) continue;
        CHECK_THAT(fly_lander(fly_lander(start, controls, pad, moon, part), controls, pad, moon, dt - part),
                   IsNear(whole, 1e-9).of("lander after both parts"));
    }
}

//> Just as long as the fall
TEST_CASE("ends no frame below the ground, not by rounding either, when a frame is as long as the fall", "[3.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const double height = dice.real(0.1, 20), speed = dice.real(0, 4), g = dice.real(1, 9);
        const double t = (std::sqrt(speed * speed + 2 * g * height) - speed) / g; // until it touches [s]
        for (const double dt : {std::nextafter(t, 0), t, std::nextafter(t, 9)}) {
            const Lander after = fly_lander({{{0, height}, {0, -speed}}, 0}, nothing, 0, g, dt);
            CHECK_THAT(after.state.position.y(), IsAtLeast(0).of("height [m]"));
            CHECK_THAT(fly_lander(after, nothing, 0, g, 1).state.position.y(), IsNear(0.0).of("height in the end [m]"));
        }
    }
}

//> Impulse
TEST_CASE("in the air, its velocity changes by what engine, jets and gravity give in the time they act", "[3.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Lander start = random_lander(dice);
        const Controls controls = random_controls(dice);
        const double dt = dice.real(0, 6), g = dice.real(0.5, 9);

        const Lander after = fly_lander(start, controls, 0, g, dt);

        const double burnt = start.fuel - after.fuel; // [s]
        CHECK_THAT(after.fuel, IsAtLeast(0).of("fuel [s]"));
        CHECK_THAT(after.state.position.y(), IsAtLeast(0).of("height [m]"));
        if (!controls.engine) CHECK_THAT(burnt, IsNear(0.0).of("burnt with the engine off [s]"));
        if (after.landed || after.crashed) continue;
        if (controls.engine) CHECK_THAT(burnt, IsNear(std::min(dt, start.fuel), 1e-12).of("burnt [s]"));
        const Vec2 gain = after.state.velocity - start.state.velocity;
        CHECK_THAT(gain, IsNear(Vec2{controls.jets * dt, 4.5 * burnt - g * dt}, 1e-11).of("change of velocity [m/s]"));
    }
}

//> Energy of a flight
TEST_CASE("with its engine and its jets off, v²/2 + g h stays as it is, down to the touch", "[3.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Lander start = random_lander(dice);
        const double g = dice.real(0.5, 9);
        const auto energy = [&](const Lander &it) {
            return it.state.velocity.squaredNorm() / 2 + g * it.state.position.y();
        };

        const Lander after = fly_lander(start, nothing, 0, g, dice.real(0, 9));

        CHECK_THAT(energy(after), IsNear(energy(start), 1e-10).of("energy of each kilogram [J]"));
        if (after.landed || after.crashed)
            CHECK_THAT(after.state.position.y(), IsNear(0.0).of("height on the ground [m]"));
    }
}

//> In a mirror
TEST_CASE("with left and right swapped it's the same flight, in a mirror", "[3.9]") {
    const auto mirror = [](Lander it) {
        it.state.position.x() *= -1;
        it.state.velocity.x() *= -1;
        return it;
    };
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const Lander start = random_lander(dice);
        const Controls controls = random_controls(dice);
        const double pad = dice.real(-20, 20), dt = dice.real(0, 9);

        const Lander seen = fly_lander(mirror(start), {controls.engine, -controls.jets}, -pad, moon, dt);

        CHECK_THAT(mirror(seen), IsNear(fly_lander(start, controls, pad, moon, dt), 1e-9).of("lander, in a mirror"));
    }
}

//>
TEST_CASE("fly_lander allows places, speeds and fuel up to 1e5, and frames of 0 s and of a day", "[3.9]") {
    CHECK_THAT(fly_lander({{{1e5, 1e5}, {-1e3, 0}}, 1e5}, burning, 0, 4.5, 86400),
               IsNear(Lander{{{1e5 - 86400e3, 1e5}, {-1e3, 0}}, 13600}, rounding));
    CHECK_THAT(fly_lander({{{0, 5}, {1, -2}}, 2}, {true, 1}, 0, moon, 0),
               IsNear(Lander{{{0, 5}, {1, -2}}, 2}, rounding));
    CHECK_THAT(fly_lander({{{0, 5}, {0, 0}}, 2}, nothing, 0, 10, 1e5),
               IsNear(Lander{{{0, 0}, {0, -10}}, 2, false, true}, rounding));
}

TEST_CASE("rejects a lander below the ground, negative fuel or time, jets of 2, and a g of 0 or less", "[3.9]") {
    const Lander now{{{0, 5}, {0, 0}}, 2};
    CHECK_REFUSED(fly_lander({{{0, -1e-3}, {0, 0}}, 2}, nothing, 0, moon, 1));
    CHECK_REFUSED(fly_lander({{{0, 5}, {0, 0}}, -1e-3}, nothing, 0, moon, 1));
    CHECK_REFUSED(fly_lander(now, nothing, 0, moon, -1e-3));
    CHECK_REFUSED(fly_lander(now, {false, 2}, 0, moon, 1));
    CHECK_REFUSED(fly_lander(now, {false, -2}, 0, moon, 1));
    CHECK_REFUSED(fly_lander(now, nothing, 0, 0, 1));
    CHECK_REFUSED(fly_lander(now, nothing, 0, -1.6, 1));
    CHECK_REFUSED(fly_lander({{{0, 0}, {0, -1}}, 2, false, true}, nothing, 0, moon, -1)); // on the ground, too
    fly_lander(now, nothing, 0, moon, 1); // good input is still answered
}
