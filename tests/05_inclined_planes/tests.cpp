#include "section_test.hpp"

#include "inclined_planes.hpp"

#include <array>
#include <cmath>
#include <numbers>

using inclined_planes::Box;
using inclined_planes::Pulled;
using inclined_planes::Spring;
using inclined_planes::UpAndBack;
using namespace inclined_planes::subject; // stopping_distance, apply_friction, ... stick_slip_step: the student's

constexpr double degree = std::numbers::pi / 180;

namespace {

// An answer is right to twelve digits of the largest term in its sum; with numbers closer to 0 than 1e-9, other than 0
// itself, fewer will do. Nearer than 1e-9 to the angle where a box just holds, either is right, as it is in 5.8 where it's
// just held, up to rounding. `critical_angle` is right to 1e-9 rad for a mu_s below 0.01 or above 100, and near the
// critical angle the square of `back` is right to twelve digits of the square of `speed`.

const Box crate{10, 0.5, 0.3};         // with g = 10 m/s² it weighs 100 N
const double gentle = std::asin(0.28); // 16.26°, its cosine is 0.96: a board of 25 m, raised by 7 m
const double steep = std::asin(0.6);   // 36.87°, its cosine is 0.8: a board of 5 m, raised by 3 m
const double quarter_turn = std::numbers::pi / 2;

Box random_box(Dice &dice) {
    const double mu_k = dice.real(0, 1);
    return {dice.real(0.1, 100), mu_k + dice.real(0, 1), mu_k};
}

} // namespace

// ----------------------------------------------------------------------------------------------- 5.1 stopping_distance

//> Worked example: nine metres
TEST_CASE("at 6 m/s, losing 2 m/s each second, a puck stops after 9 m", "[5.1]") {
    CHECK_THAT(stopping_distance(6, 2), IsNear(9.0, rounding)); // 3 s, at 3 m/s on average
}

//> To the left
TEST_CASE("at -6 m/s, to the left, it stops after -9 m", "[5.1]") {
    CHECK_THAT(stopping_distance(-6, 2), IsNear(-9.0, rounding));
    CHECK_THAT(stopping_distance(-3, 2), IsNear(-2.25, rounding));
}

//> Twice as fast
TEST_CASE("twice the speed needs four times the distance, half the deceleration twice", "[5.1]") {
    CHECK_THAT(stopping_distance(12, 2), IsNear(36.0, rounding));
    CHECK_THAT(stopping_distance(6, 1), IsNear(18.0, rounding));
    CHECK_THAT(stopping_distance(3, 2), IsNear(2.25, rounding));
}

//> At rest
TEST_CASE("a puck that rests stays where it is", "[5.1]") { CHECK_THAT(stopping_distance(0, 2), IsNear(0.0)); }

//> Where it is halfway
TEST_CASE("slowed down evenly, it is there when its velocity is 0", "[5.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double deceleration = dice.real(0.1, 20), time = dice.real(0.1, 10), to = dice.sign();

        const double there = stopping_distance(to * deceleration * time, deceleration);

        CHECK_THAT(there, IsNear(to * deceleration * time * time / 2, 1e-11));
    }
}

//> To the left and to the right
TEST_CASE("to the left it gets as far as to the right", "[5.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double speed = dice.real(0, 50), deceleration = dice.real(0.1, 20);

        const double right = stopping_distance(speed, deceleration), left = stopping_distance(-speed, deceleration);

        CHECK_THAT(left, IsNear(-right, rounding).of("to the left [m]"));
    }
}

//> In frames
TEST_CASE("at 16 px per frame, losing 1 in each, it stops after 128 px; the printed loop moves it by 136", "[5.1]") {
    CHECK_THAT(stopping_distance(16, 1), IsNear(128.0, rounding));
    int moved = 0;
    for (int velocity = 16; velocity > 0; --velocity) moved += velocity;
    CHECK_THAT(moved - stopping_distance(16, 1),
               IsNear(8.0, rounding).of("the loop's error: half of the velocity [px]"));
}

//>
TEST_CASE("speeds up to 1e5 are allowed, weak and strong friction, and small numbers", "[5.1]") {
    CHECK_THAT(stopping_distance(1e5, 1e5), IsNear(5e4, rounding));
    CHECK_THAT(stopping_distance(-1e5, 0.5), IsNear(-1e10, rounding));
    CHECK_THAT(stopping_distance(-1e5, 5e-9), IsNear(-1e18, rounding));
    CHECK_THAT(stopping_distance(2e-9, 2e-9) * 1e9, IsNear(1.0, rounding).of("distance [1e-9 m]"));
    CHECK_THAT(stopping_distance(-1e-4, 1e5) * 1e13, IsNear(-0.5, rounding).of("distance [1e-13 m]"));
}

TEST_CASE("no friction or a negative one is refused by stopping_distance", "[5.1]") {
    CHECK_REFUSED(stopping_distance(6, 0));
    CHECK_REFUSED(stopping_distance(6, -2));
    CHECK_REFUSED(stopping_distance(0, 0));
    stopping_distance(6, 2); // good input is still answered
}

// -------------------------------------------------------------------------------------------------- 5.2 apply_friction

//> Worked example: to the right
TEST_CASE("at 6 m/s, losing 2 m/s each second, a puck has 5 m/s half a second later", "[5.2]") {
    CHECK_THAT(apply_friction(6, 2, 0.5), IsNear(5.0, rounding));
}

//> Worked example: to the left
TEST_CASE("at -6 m/s, to the left, it has -5 m/s half a second later: friction slows it down, too", "[5.2]") {
    CHECK_THAT(apply_friction(-6, 2, 0.5), IsNear(-5.0, rounding));
}

//> The last frame
TEST_CASE("at 0.75 m/s it stops within half a second: it has 0 m/s then, exactly, and never turns back", "[5.2]") {
    CHECK_THAT(apply_friction(0.75, 2, 0.5), IsNear(0.0)); // friction could take 1 m/s, but there are only 0.75
    CHECK_THAT(apply_friction(-0.75, 2, 0.5), IsNear(0.0));
}

//> A puck that rests
TEST_CASE("a puck that rests stays at rest", "[5.2]") {
    CHECK_THAT(apply_friction(0, 2, 0.5), IsNear(0.0));
    CHECK_THAT(apply_friction(0, 1e5, 1e5), IsNear(0.0));
}

//> Just stopped
TEST_CASE("a speed of exactly deceleration times dt is used up exactly", "[5.2]") {
    CHECK_THAT(apply_friction(1, 2, 0.5), IsNear(0.0));
    CHECK_THAT(apply_friction(-1, 2, 0.5), IsNear(0.0));
}

//> Frame by frame
TEST_CASE("after any number of frames of any length it is as fast as the time says, and never turns back", "[5.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const double start = dice.real(-10, 10), deceleration = dice.real(0.1, 5);
        double velocity = start, time = 0;
        for (int frame = 0; frame < 60; ++frame) {
            const double dt = dice.real(0, 0.2);
            velocity = apply_friction(velocity, deceleration, dt);
            time += dt;
            const double speed = std::max(0.0, std::abs(start) - deceleration * time);
            CHECK_THAT(velocity, IsNear(std::copysign(speed, start), 1e-11).of("velocity after some frames [m/s]"));
        }
    }
}

//> It ends
TEST_CASE("once it has stopped it stays, for a thousand frames, to the last digit", "[5.2]") {
    for (const double start : {6.0, -6.0, 0.1, -1e-3}) {
        double velocity = start;
        for (int frame = 0; frame < 1400; ++frame) {
            velocity = apply_friction(velocity, 2, 1.0 / 60);
            if (frame >= 200) CHECK_THAT(velocity, IsNear(0.0).of("velocity after it has stopped [m/s]"));
        }
    }
}

//> No time, no friction
TEST_CASE("in no time nothing changes, and on ice without friction neither", "[5.2]") {
    for (const double velocity : {6.0, -6.0, 0.0, 1e-3}) {
        CHECK_THAT(apply_friction(velocity, 2, 0), IsNear(velocity));
        CHECK_THAT(apply_friction(velocity, 0, 0.5), IsNear(velocity));
    }
}

//> Erratum E5.4
TEST_CASE("erratum E5.4: friction as -1, and subtracted, makes 17 of 16 px per frame; it has 15", "[5.2]") {
    const double printed = 16 - -1;
    CHECK_THAT(apply_friction(16, 1, 1), IsNear(15.0));
    CHECK_THAT(printed - apply_friction(16, 1, 1), IsNear(2.0).of("the printed formula's excess [px/frame]"));
}

//> Erratum E5.5
TEST_CASE("erratum E5.5: from 16.5 px per frame the printed loop ends at -0.5 px per frame; it stops at 0", "[5.2]") {
    double velocity = 16.5, printed = 16.5;
    while (printed > 0) {
        velocity = apply_friction(velocity, 1, 1);
        printed -= 1;
    }
    CHECK_THAT(velocity, IsNear(0.0).of("velocity after 17 frames [px/frame]"));
    CHECK_THAT(printed, IsNear(-0.5).of("as printed [px/frame]"));
}

//> Erratum E5.6
TEST_CASE("erratum E5.6: gravity drives a resting thing backwards, friction does not", "[5.2]") {
    const double as_gravity = 0 - 1 * 60.0; // 1 m/s², for a minute
    CHECK_THAT(apply_friction(0, 1, 60), IsNear(0.0));
    CHECK_THAT(as_gravity, IsNear(-60.0).of("as gravity acts [m/s]"));
}

//>
TEST_CASE("numbers up to 1e5 are allowed, and tiny ones", "[5.2]") {
    CHECK_THAT(apply_friction(1e5, 1e5, 0.5), IsNear(5e4, rounding));
    CHECK_THAT(apply_friction(-1e5, 0.5, 1e5), IsNear(-5e4, rounding));
    CHECK_THAT(apply_friction(1e5, 1e5, 1e5), IsNear(0.0));
    CHECK_THAT(apply_friction(-3e-9, 2e-9, 0.5) * 1e9, IsNear(-2.0, rounding).of("velocity [1e-9 m/s]"));
    CHECK_THAT(apply_friction(1e-8, 2, 0.5), IsNear(0.0));
    CHECK_THAT(apply_friction(6, 2, 1e-8), IsNear(6 - 2e-8, rounding));
    for (const double to : {1, -1}) {
        CHECK_THAT(apply_friction(to * (1 - 1e-13), 2, 0.5), IsNear(0.0)); // not a bit backwards
        CHECK_THAT(apply_friction(to * (1 + 5e-10), 2, 0.5), IsNear(to * 5e-10, rounding));
    }
}

TEST_CASE("a negative deceleration or dt is refused by apply_friction", "[5.2]") {
    CHECK_REFUSED(apply_friction(6, -2, 0.5));
    CHECK_REFUSED(apply_friction(6, 2, -0.5));
    CHECK_REFUSED(apply_friction(0, -1e-300, 0.5));
    CHECK_REFUSED(apply_friction(6, 2, -1e-9));
    apply_friction(6, 2, 0.5); // good input is still answered
}

// ---------------------------------------------------------------------------------------------------- 5.3 normal_force

//> Worked example: five metres, raised by three
TEST_CASE("a box of 10 kg presses with 80 N on a board of 5 m whose end is 3 m high", "[5.3]") {
    CHECK_THAT(normal_force(10, std::asin(3.0 / 5), 10), IsNear(80.0, 1e-11)); // 4/5 of 100 N
}

//> Worked example: level
TEST_CASE("on a level board it presses with its whole weight, 100 N", "[5.3]") {
    CHECK_THAT(normal_force(10, 0, 10), IsNear(100.0, rounding));
    CHECK_THAT(normal_force(2, 0, 9.8), IsNear(19.6, rounding));
}

//> The steeper, the less
TEST_CASE("with 10 kg: 86.6 N at 30°, 70.7 N at 45°, 50 N at 60°, nothing at 90°", "[5.3]") {
    CHECK_THAT(normal_force(10, 30 * degree, 10), IsNear(std::sqrt(7500), 1e-11));
    CHECK_THAT(normal_force(10, 45 * degree, 10), IsNear(std::sqrt(5000), 1e-11));
    CHECK_THAT(normal_force(10, 60 * degree, 10), IsNear(50.0, 1e-11));
    CHECK_THAT(normal_force(10, quarter_turn, 10), IsNear(0.0, 1e-11));
    CHECK_THAT(normal_force(10, quarter_turn - 5e-5, 10), IsNear(100 * std::sin(5e-5), 1e-9));
}

//> As long as the weight
TEST_CASE("with the pull down the board, as two sides of a triangle, it makes the weight", "[5.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double mass = dice.real(0.1, 100), angle = dice.real(0, quarter_turn), g = dice.real(1, 20);
        const double weight = mass * g;

        const double normal = normal_force(mass, angle, g);

        CHECK_THAT(std::hypot(normal, weight * std::sin(angle)), IsNear(weight, rounding).of("weight [N]"));
        CHECK_THAT(normal, IsAtLeast(-1e-9).of("normal force [N]"));
    }
}

//> Twice the mass
TEST_CASE("twice the mass, or twice the g, presses twice as hard", "[5.3]") {
    CHECK_THAT(normal_force(20, steep, 10), IsNear(160.0, 1e-11));
    CHECK_THAT(normal_force(10, steep, 20), IsNear(160.0, 1e-11));
    CHECK_THAT(normal_force(10, steep, 1.5), IsNear(12.0, 1e-11)); // on the Moon, nearly
}

//> Erratum E5.7
TEST_CASE("erratum E5.7: m g is right on level ground only; 10 kg at 30° press with 84.87 N, not 98 N", "[5.3]") {
    CHECK_THAT(normal_force(10, 30 * degree, 9.8), IsNear(84.870489570875, 1e-11));
    CHECK_THAT(normal_force(10, 0, 9.8), IsNear(98.0, rounding));
}

//>
TEST_CASE("masses and g up to 1e5 are allowed, and small ones", "[5.3]") {
    CHECK_THAT(normal_force(1e5, steep, 1e5), IsNear(8e9, rounding));
    CHECK_THAT(normal_force(1e-8, steep, 1e-8) * 1e16, IsNear(0.8, rounding).of("normal force [1e-16 N]"));
    CHECK_THAT(normal_force(1e5, 1e-9, 1e5), IsNear(1e10, rounding));
    CHECK_THAT(normal_force(10, 9e-5, 10), IsNear(100 * (1 - 4.05e-9), rounding)); // cos x is nearly 1 - x²/2
}

TEST_CASE("a mass or g of 0 or less, or an angle below 0° or above 90°, is refused", "[5.3]") {
    CHECK_REFUSED(normal_force(0, steep, 10));
    CHECK_REFUSED(normal_force(-10, steep, 10));
    CHECK_REFUSED(normal_force(10, steep, 0));
    CHECK_REFUSED(normal_force(10, steep, -10));
    CHECK_REFUSED(normal_force(10, -0.1, 10));
    CHECK_REFUSED(normal_force(10, -1e-15, 10));
    CHECK_REFUSED(normal_force(10, 1.6, 10));
    CHECK_REFUSED(normal_force(10, std::nextafter(quarter_turn, 2), 10));
    CHECK_REFUSED(normal_force(10, 30, 10), "30, which are degrees");
    normal_force(10, steep, 10); // good input is still answered
}

// -------------------------------------------------------------------------------------------- 5.4 incline_acceleration

//> Worked example: it holds
TEST_CASE("on a board of 25 m, raised by 7 m, a box with mu_s 0.5 stays: 28 N pull, and 48 N can hold", "[5.4]") {
    CHECK_THAT(incline_acceleration({10, 0.5, 0.3}, std::asin(7.0 / 25), 10), IsNear(0.0));
}

//> Worked example: it slides
TEST_CASE("on a board of 5 m, raised by 3 m, it slides: 60 N pull, mu_k 0.3 takes 24 N, and 10 kg get 3.6 m/s²",
          "[5.4]") {
    CHECK_THAT(incline_acceleration({10, 0.5, 0.3}, std::asin(3.0 / 5), 10), IsNear(3.6, rounding));
}

//> Worked example: between the two
TEST_CASE("put down on a board of 13 m, raised by 5 m, 13 kg stay: 50 N pull, and mu_s 0.5 can hold 60 N", "[5.4]") {
    // mu_k 0.3 would be only 36 N, but it does not slide
    CHECK_THAT(incline_acceleration({13, 0.5, 0.3}, std::asin(5.0 / 13), 10), IsNear(0.0));
    for (const double angle_deg : {17.0, 20.0, 26.0, 26.56})
        CHECK_THAT(incline_acceleration(crate, angle_deg * degree, 10), IsNear(0.0));
}

//> The mass drops out
TEST_CASE("a box of 20 kg slides as one of 10 kg does, and so does one of 1 g", "[5.4]") {
    for (const double mass : {20.0, 1.0, 1e-3, 1e5})
        CHECK_THAT(incline_acceleration({mass, 0.5, 0.3}, steep, 10), IsNear(3.6, rounding));
}

//> Level
TEST_CASE("on a level board nothing slides, on ice neither", "[5.4]") {
    CHECK_THAT(incline_acceleration(crate, 0, 10), IsNear(0.0));
    CHECK_THAT(incline_acceleration({10, 0, 0}, 0, 10), IsNear(0.0));
}

//> Ice, and a wall
TEST_CASE("without friction it slides with g sin θ, and along an upright board it falls with g", "[5.4]") {
    CHECK_THAT(incline_acceleration({10, 0, 0}, steep, 10), IsNear(6.0, rounding));
    CHECK_THAT(incline_acceleration({10, 0, 0}, gentle, 10), IsNear(2.8, rounding));
    CHECK_THAT(incline_acceleration(crate, quarter_turn, 10), IsNear(10.0, rounding));
    CHECK_THAT(incline_acceleration({10, 1e5, 1e5}, 89 * degree, 10), IsNear(0.0));
}

//> Just so
TEST_CASE("just below the critical angle it stays, and just above it slides", "[5.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        Box box = random_box(dice);
        box.mass = std::pow(10, dice.real(-3, 5));
        box.mu_s += 0.01;
        const double critical = std::atan(box.mu_s), g = dice.real(1, 20);

        CHECK_THAT(incline_acceleration(box, critical - 1.5e-9, g), IsNear(0.0));
        CHECK_THAT(incline_acceleration(box, critical + 1.5e-9, g), IsAbove(0));
    }
}

//> At 45 degrees
TEST_CASE("at 45° a mu_s of 1 just holds it", "[5.4]") {
    CHECK_THAT(incline_acceleration({10, 1.00000001, 0.5}, 45 * degree, 10),
               IsNear(0.0)); // at 1 itself, rounding may decide
}

//> By energy
TEST_CASE("after sliding down 1 m, the height lost is kinetic energy, and heat by friction", "[5.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Box box = random_box(dice);
        const double g = dice.real(1, 20), angle = dice.real(std::atan(box.mu_s) + 0.001, quarter_turn);

        const double a = incline_acceleration(box, angle, g);

        const double kinetic = box.mass * a;                           // of v² = 2 a · 1 m
        const double heat = box.mu_k * box.mass * g * std::cos(angle); // friction, times 1 m
        CHECK_THAT((kinetic + heat) / box.mass,
                   IsNear(g * std::sin(angle), rounding).of("g times the height lost [J/kg]"));
    }
}

//> Erratum E5.1
TEST_CASE("erratum E5.1: at 10° mu_s 0.5 holds a box; with the printed sum of forces it climbs at 3.12 m/s²", "[5.4]") {
    const double printed = 9.8 * (std::sin(10 * degree) - 0.5 * std::cos(10 * degree));
    CHECK_THAT(incline_acceleration({10, 0.5, 0.3}, 10 * degree, 9.8), IsNear(0.0));
    CHECK_THAT(printed, IsNear(-3.1238058, 1e-6).of("as printed [m/s²]"));
}

//> Erratum E5.12
TEST_CASE("erratum E5.12: at 3° a mu of 0.1 holds; the printed loop climbs 1242 px in 1000 frames", "[5.4]") {
    const double printed = std::sin(3 * degree) - 0.1 * std::cos(3 * degree); // [px/frame²]
    double y = 0, velocity = 0;
    for (int frame = 0; frame < 1000; ++frame) {
        y += velocity;
        velocity += std::sin(3 * degree) * printed;
    }
    CHECK_THAT(incline_acceleration({1, 0.1, 0.1}, 3 * degree, 1), IsNear(0.0));
    CHECK_THAT(y, IsNear(-1242.0, 1e-1).of("y of the printed loop, down the screen [px]"));
}

//> Erratum E5.13
TEST_CASE("erratum E5.13: one average mu of 0.4 takes a third of the acceleration at 30°, 1.51 for 2.35 m/s²",
          "[5.4]") {
    CHECK_THAT(incline_acceleration({10, 0.5, 0.3}, 30 * degree, 9.8), IsNear(2.353885, 1e-6));
    CHECK_THAT(incline_acceleration({10, 0.4, 0.4}, 30 * degree, 9.8), IsNear(1.505180, 1e-6));
}

//> The printed anchors
TEST_CASE("at 30°, with mu 0.1, 0.2, 0.3 and g = 9.8 m/s², it slides at 4.05, 3.20, 2.35 m/s²", "[5.4]") {
    CHECK_THAT(incline_acceleration({10, 0.1, 0.1}, 30 * degree, 9.8), IsNear(4.051295, 1e-6));
    CHECK_THAT(incline_acceleration({10, 0.2, 0.2}, 30 * degree, 9.8), IsNear(3.202590, 1e-6));
    CHECK_THAT(incline_acceleration({10, 0.3, 0.3}, 30 * degree, 9.8), IsNear(2.353885, 1e-6));
    CHECK_THAT(incline_acceleration({10, 0.5, 0.5}, 45 * degree, 9.8), IsNear(3.464823, 1e-6));
}

//>
TEST_CASE("masses, coefficients and g up to 1e5 are allowed, and small ones", "[5.4]") {
    CHECK_THAT(incline_acceleration({1e5, 0.5, 0.3}, steep, 1e5), IsNear(3.6e4, rounding));
    CHECK_THAT(incline_acceleration({10, 1e5, 0}, 1.5, 10), IsNear(0.0));
    CHECK_THAT(incline_acceleration({1e-6, 0.5, 0.3}, steep, 1e-8) * 1e9, IsNear(3.6, rounding).of("a [1e-9 m/s²]"));
    CHECK_THAT(incline_acceleration({10, 0, 0}, 1e-8, 10) * 1e7, IsNear(1.0, rounding).of("a [1e-7 m/s²]"));
    CHECK_THAT(incline_acceleration({10, 1e-8, 1e-8}, steep, 10), IsNear(6 - 8e-8, rounding));
    CHECK_THAT(incline_acceleration({10, 0.5, 0}, steep, 10), IsNear(6.0, rounding));
    CHECK_THAT(incline_acceleration({10, 1e5, 1e5}, quarter_turn, 10), IsNear(10.0, 1e-9));
    CHECK_THAT(incline_acceleration({10, 2000, 1500}, std::atan(2500), 10),
               IsNear(1e4 / std::hypot(1, 2500), 1e-9)); // 2500 - 1500 = 1000, times the cosine, times g
}

TEST_CASE("a mu_s below mu_k, a negative mu_k, and what normal_force refuses, is refused", "[5.4]") {
    CHECK_REFUSED(incline_acceleration({10, 0.3, 0.5}, steep, 10));
    CHECK_REFUSED(incline_acceleration({10, 0.3, std::nextafter(0.3, 1)}, 0, 10));
    CHECK_REFUSED(incline_acceleration({10, 0.5, -0.1}, steep, 10));
    CHECK_REFUSED(incline_acceleration({10, 0.5, -1e-9}, 0, 10));
    CHECK_REFUSED(incline_acceleration({0, 0.5, 0.3}, steep, 10));
    CHECK_REFUSED(incline_acceleration({-10, 0.5, 0.3}, steep, 10));
    CHECK_REFUSED(incline_acceleration(crate, -0.1, 10));
    CHECK_REFUSED(incline_acceleration(crate, -1e-15, 10));
    CHECK_REFUSED(incline_acceleration(crate, 30, 10), "30, which are degrees");
    CHECK_REFUSED(incline_acceleration(crate, std::nextafter(quarter_turn, 2), 10));
    CHECK_REFUSED(incline_acceleration(crate, steep, 0));
    CHECK_REFUSED(incline_acceleration(crate, gentle, -10));
    incline_acceleration(crate, steep, 10); // good input is still answered
}

// -------------------------------------------------------------------------------------------------- 5.5 critical_angle

//> Worked example: 3 up for 4 along
TEST_CASE("with mu_s 0.75, a board of 5 m holds a box as long as its end is at most 3 m high", "[5.5]") {
    CHECK_THAT(critical_angle(0.75), IsNear(std::asin(3.0 / 5), rounding)); // 60 N pull, and 0.75 of 80 N hold
}

//> Worked example: 0.5
TEST_CASE("with mu_s 0.5 the critical angle is 26.57°, with 1 it is 45°, without friction 0°", "[5.5]") {
    CHECK_THAT(critical_angle(0.5) / degree, IsNear(26.56505117707799, 1e-11).of("critical angle [°]"));
    CHECK_THAT(critical_angle(1) / degree, IsNear(45.0, 1e-11).of("critical angle [°]"));
    CHECK_THAT(critical_angle(0), IsNear(0.0));
}

//> Erratum E5.12: the book's number
TEST_CASE("with mu_s 0.1 the critical angle is 5.71°, with 0.3 it is 16.70°", "[5.5]") {
    CHECK_THAT(critical_angle(0.1) / degree, IsNear(5.710593137, 1e-8).of("critical angle [°]"));
    CHECK_THAT(critical_angle(0.3) / degree, IsNear(16.699244234, 1e-8).of("critical angle [°]"));
}

//> Pull and hold are equal there
TEST_CASE("at this angle the pull down the board is mu_s times the normal force", "[5.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double mu_s = dice.real(0.01, 3);

        const double angle = critical_angle(mu_s);

        CHECK_THAT(98 * std::sin(angle), IsNear(mu_s * 98 * std::cos(angle), 1e-11).of("pull of 98 N of weight [N]"));
        CHECK_THAT(angle, IsAtLeast(0));
        CHECK_THAT(angle, IsAtMost(quarter_turn));
    }
}

//> Rough
TEST_CASE("a mu_s above 1 holds at more than 45°: with 2 at 63.43°", "[5.5]") {
    CHECK_THAT(critical_angle(2) / degree, IsNear(63.43494882292201, 1e-11).of("critical angle [°]"));
    CHECK_THAT(critical_angle(1e5), IsNear(quarter_turn - 1e-5, 1e-9)); // tan(π/2 - x) is 1/x
    CHECK_THAT(critical_angle(1e-6) * 1e6, IsNear(1.0, 1e-3).of("critical angle [1e-6 rad]"));
}

//> Erratum E5.13: the angle
TEST_CASE("erratum E5.13: an average mu of 0.4 lets it slip at 21.8° already, and not at 26.6°", "[5.5]") {
    CHECK_THAT(critical_angle(0.5) / degree, IsNear(26.565051, 1e-6).of("critical angle of 0.5 [°]"));
    CHECK_THAT(critical_angle(0.4) / degree, IsNear(21.801409, 1e-6).of("critical angle of 0.4 [°]"));
}

//>
TEST_CASE("a negative mu_s is refused by critical_angle", "[5.5]") {
    CHECK_REFUSED(critical_angle(-0.1));
    CHECK_REFUSED(critical_angle(-1e-300));
    critical_angle(0.5); // good input is still answered
}

// -------------------------------------------------------------------------------------------------- 5.6 table_friction

//> Worked example: it does not turn
TEST_CASE("at (3, 4) m/s, losing 2 m/s each second, a puck has (2.4, 3.2) m/s half a second later", "[5.6]") {
    CHECK_THAT(table_friction({3, 4}, 2, 0.5), IsNear(Vec2{2.4, 3.2}, rounding)); // 5 m/s become 4 m/s
}

//> At rest on the table
TEST_CASE("a puck that rests on the table stays at rest", "[5.6]") {
    CHECK_THAT(table_friction({0, 0}, 2, 0.5), IsNear(Vec2{0, 0}));
    CHECK_THAT(table_friction({0, 0}, 0, 0.5), IsNear(Vec2{0, 0}));
    CHECK_THAT(table_friction({0, 0}, 2, 0), IsNear(Vec2{0, 0}));
}

//> The last frame on the table
TEST_CASE("at (0.3, -0.4) m/s it stops within half a second, exactly", "[5.6]") {
    CHECK_THAT(table_friction({0.3, -0.4}, 2, 0.5), IsNear(Vec2{0, 0}));
    CHECK_THAT(table_friction({-0.6, 0.7}, 2, 0.5), IsNear(Vec2{0, 0})); // 0.92 m/s, of the 1 m/s that it would lose
}

//> Longer than one of its components
TEST_CASE("at (0.6, 8) m/s, losing 4 m/s, it still moves to the right", "[5.6]") {
    const double speed = std::hypot(0.6, 8.0);
    CHECK_THAT(table_friction({0.6, 8}, 4, 1), IsNear(Vec2{(speed - 4) / speed * Vec2{0.6, 8}}, rounding));
    CHECK_THAT(table_friction({0.8, 0.8}, 2, 0.5).x(),
               IsNear(0.8 - std::sqrt(0.5), rounding).of("velocity to the right [m/s]"));
}

//> Straight lines
TEST_CASE("along one axis it is what 5.2 says", "[5.6]") {
    CHECK_THAT(table_friction({6, 0}, 2, 0.5), IsNear(Vec2{5, 0}, rounding));
    CHECK_THAT(table_friction({-6, 0}, 2, 0.5), IsNear(Vec2{-5, 0}, rounding));
    CHECK_THAT(table_friction({0, -6}, 2, 0.5), IsNear(Vec2{0, -5}, rounding));
    CHECK_THAT(table_friction({0, 0.75}, 2, 0.5), IsNear(Vec2{0, 0}));
}

//> In every direction
TEST_CASE("in every direction it loses the same speed, and keeps its direction", "[5.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 along = dice.direction();
        const double speed = dice.real(1, 20), loss = dice.real(0, 0.9);

        const Vec2 after = table_friction(speed * along, 2 * loss, 0.5);

        CHECK_THAT(after, IsNear(Vec2{(speed - loss) * along}, rounding));
    }
}

//> Turned
TEST_CASE("turned first and slowed down then, or the other way round, is the same", "[5.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Vec2 velocity = dice.point(-5, 5), turned{-velocity.y(), velocity.x()};
        const double deceleration = dice.real(0, 10), dt = dice.real(0, 1);

        const Vec2 slowed = table_friction(velocity, deceleration, dt);

        CHECK_THAT(table_friction(turned, deceleration, dt), IsNear(Vec2{-slowed.y(), slowed.x()}, rounding));
    }
}

//> On a straight line until it rests
TEST_CASE("frame by frame it stays on a straight line, stops after speed² / 2a, and stays", "[5.6]") {
    Vec2 velocity{3, 4}, at{0, 0};
    for (int frame = 0; frame < 300; ++frame) { // 2.5 s are 250 frames
        const Vec2 after = table_friction(velocity, 2, 0.01);
        at += (velocity + after) / 2 * 0.01;
        velocity = after;
        CHECK_THAT(at.x() * 4 - at.y() * 3, IsNear(0.0, 1e-9).of("how far it is off its line, times 5 [m]"));
        if (frame > 250) CHECK_THAT(velocity, IsNear(Vec2{0, 0}).of("velocity after it has stopped [m/s]"));
    }
    CHECK_THAT(at, IsNear(Vec2{3.75, 5}, 1e-9).of("where it rests [m]")); // 6.25 m away: 25/4
}

//> Erratum E5.5: per axis
TEST_CASE("erratum E5.5: taken from each component, friction turns (3, 4) to (2, 3), and takes 1.39 m/s for 1",
          "[5.6]") {
    const Vec2 after = table_friction({3, 4}, 1, 1), per_axis{3 - 1, 4 - 1};
    CHECK_THAT(std::atan2(after.y(), after.x()) / degree, IsNear(53.13010235, 1e-6).of("direction [°]"));
    CHECK_THAT(std::atan2(per_axis.y(), per_axis.x()) / degree, IsNear(56.30993247, 1e-6).of("per axis [°]"));
    CHECK_THAT(5 - per_axis.norm(), IsNear(1.3944487, 1e-6).of("lost per axis [m/s]"));
}

//>
TEST_CASE("velocities up to 1e5 are allowed on the table, and tiny ones", "[5.6]") {
    CHECK_THAT(table_friction({-6e4, 8e4}, 1e5, 0.5), IsNear(Vec2{-3e4, 4e4}, rounding));
    CHECK_THAT(table_friction({6e4, 8e4}, 1e5, 1e5), IsNear(Vec2{0, 0}));
    CHECK_THAT(Vec2{table_friction({6e-9, -8e-9}, 1e-8, 0.5) * 1e9},
               IsNear(Vec2{3, -4}, rounding).of("velocity [1e-9 m/s]"));
    CHECK_THAT(table_friction({3, 4}, 5, 1e-8), IsNear(Vec2{3 - 3e-8, 4 - 4e-8}, rounding));
    const Vec2 direction{-0.6, 0.8};
    CHECK_THAT(table_friction((1 - 1e-13) * direction, 2, 0.5), IsNear(Vec2{0, 0})); // not a bit backwards
    CHECK_THAT(table_friction((1 + 5e-10) * direction, 2, 0.5), IsNear(Vec2{5e-10 * direction}, rounding));
}

TEST_CASE("a negative deceleration or dt is refused by table_friction", "[5.6]") {
    CHECK_REFUSED(table_friction({3, 4}, -2, 0.5));
    CHECK_REFUSED(table_friction({3, 4}, 2, -0.5));
    CHECK_REFUSED(table_friction({0, 0}, -2, 0.5));
    CHECK_REFUSED(table_friction({3, 4}, -1e-9, 0.5));
    CHECK_REFUSED(table_friction({3, 4}, 2, -1e-9));
    table_friction({3, 4}, 2, 0.5); // good input is still answered
}

// ----------------------------------------------------------------------------------------------------- 5.7 up_and_back

//> Worked example: half as fast
TEST_CASE("with mu_k 0.45, 9.6 m/s up a board of 3 in 5 get 4.8 m far, and come back at 4.8 m/s", "[5.7]") {
    CHECK_THAT(up_and_back({10, 0.5, 0.45}, 9.6, std::asin(3.0 / 5), 10),
               IsNear(UpAndBack{4.8, 4.8}, rounding)
                   .since("up, 6 + 0.45 · 8 = 9.6 m/s² brake it for 1 s; back, 6 - 3.6 = 2.4 m/s² pull for 2 s"));
}

//> Worked example: it stays
TEST_CASE("on a board of 7 in 25, with mu_k 0.3, 5.68 m/s get 2.84 m far, and the box stays there", "[5.7]") {
    CHECK_THAT(
        up_and_back({10, 0.5, 0.3}, 5.68, std::asin(7.0 / 25), 10),
        IsNear(UpAndBack{2.84, 0}, rounding).since("up, 2.8 + 0.3 · 9.6 = 5.68 m/s² brake it, so it rests after 1 s"));
}

//> It stays, since it rests
TEST_CASE("between the angles of mu_k and mu_s it stays, although it would go on sliding if it slid", "[5.7]") {
    const UpAndBack got = up_and_back(crate, 5, 20 * degree, 10);
    CHECK_THAT(got.back, IsNear(0.0).of("speed back [m/s]"));
    CHECK_THAT(got.up,
               IsNear(12.5 / (10 * (std::sin(20 * degree) + 0.3 * std::cos(20 * degree))), rounding).of("way up [m]"));
    CHECK_THAT(up_and_back({10, 0.5, 0}, 5.6, gentle, 10), IsNear(UpAndBack{5.6, 0}, rounding));
    for (const Box &box : {crate, Box{1e5, 0.5, 0.45}}) {
        const double critical = std::atan(0.5);
        CHECK_THAT(up_and_back(box, 5, critical - 1.5e-9, 10).back, IsNear(0.0).of("speed back [m/s]"));
        CHECK_THAT(up_and_back(box, 5, critical + 1.5e-9, 10).back, IsAbove(0).of("speed back [m/s]"));
    }
}

//> Without friction
TEST_CASE("without friction it comes back as fast as it began", "[5.7]") {
    CHECK_THAT(up_and_back({10, 0, 0}, 6, steep, 10), IsNear(UpAndBack{3, 6}, rounding));
    CHECK_THAT(up_and_back({10, 0, 0}, 6, quarter_turn, 10), IsNear(UpAndBack{1.8, 6}, rounding));
    CHECK_THAT(up_and_back({10, 0, 0}, 6, 1e-6, 10), IsNear(UpAndBack{1.8e6, 6}, rounding));
}

//> Level ground
TEST_CASE("on level ground it is a puck: it gets as far as 5.1 says, and stays", "[5.7]") {
    CHECK_THAT(up_and_back({10, 0.5, 0.2}, 6, 0, 10), IsNear(UpAndBack{9, 0}, rounding));
    CHECK_THAT(up_and_back({10, 0.2, 0.2}, 6, 0, 10), IsNear(UpAndBack{9, 0}, rounding));
    CHECK_THAT(up_and_back({10, 1e5, 1e5}, 4, 0, 1e-5), IsNear(UpAndBack{8, 0}, 1e-11));
    CHECK_THAT(up_and_back({10, 1e-8, 1e-8}, 1e-3, 0, 10), IsNear(UpAndBack{5, 0}, rounding));
}

//> The mass drops out again
TEST_CASE("a heavier box gets as far, and comes back as fast", "[5.7]") {
    for (const double mass : {1e-3, 20.0, 1e5})
        CHECK_THAT(up_and_back({mass, 0.5, 0.45}, 9.6, steep, 10), IsNear(UpAndBack{4.8, 4.8}, rounding));
}

//> The energy that is lost
TEST_CASE("what is missing of its energy, friction took: twice mu_k times the normal force times the way", "[5.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Box box = random_box(dice);
        const double g = dice.real(1, 20), speed = dice.real(0.1, 20);
        const double angle = dice.real(std::atan(box.mu_s) + 0.01, quarter_turn);

        const auto [up, back] = up_and_back(box, speed, angle, g);

        const double lost = box.mass * (speed * speed - back * back) / 2;
        CHECK_THAT(lost, IsNear(2 * box.mu_k * box.mass * g * std::cos(angle) * up, 1e-9).of("energy lost [J]"));
        CHECK_THAT(up * (g * std::sin(angle) + box.mu_k * g * std::cos(angle)),
                   IsNear(speed * speed / 2, 1e-11).of("up, times what is against it [J/kg]"));
    }
}

//> Erratum E5.12: up
TEST_CASE("erratum E5.12: at 30°, with mu 0.2, 5 m/s get 1.89 m up, not 3.90 m, and come back at 3.48 m/s", "[5.7]") {
    const UpAndBack got = up_and_back({10, 0.2, 0.2}, 5, 30 * degree, 9.8);
    CHECK_THAT(got.up, IsNear(1.8947, 1e-4).of("up [m]"));
    CHECK_THAT(got.back, IsNear(3.4836, 1e-4).of("back [m/s]"));
    const double printed = 9.8 * (std::sin(30 * degree) - 0.2 * std::cos(30 * degree)); // friction still upwards
    CHECK_THAT(25 / (2 * printed), IsNear(3.9031, 1e-4).of("up, with the printed acceleration [m]"));
}

//>
TEST_CASE("not pushed at all, it stays, or slides from where it is", "[5.7]") {
    CHECK_THAT(up_and_back(crate, 0, gentle, 10), IsNear(UpAndBack{0, 0}));
    CHECK_THAT(up_and_back(crate, 0, steep, 10), IsNear(UpAndBack{0, 0}));
}

TEST_CASE("speeds up to 1e5 are allowed up the board, and small ones", "[5.7]") {
    CHECK_THAT(up_and_back({10, 0.5, 0.45}, 1e5, steep, 10), IsNear(UpAndBack{1e10 / 19.2, 5e4}, rounding));
    CHECK_THAT(up_and_back({1e5, 0.5, 0.45}, 9.6, steep, 1e5), IsNear(UpAndBack{4.8e-4, 4.8}, rounding));
    CHECK_THAT(up_and_back({1e-8, 0.5, 0.45}, 9.6, steep, 1e-8), IsNear(UpAndBack{4.8e9, 4.8}, rounding));
    CHECK_THAT(up_and_back({10, 20, 10}, 5, std::atan(40), 10).back,
               IsNear(std::sqrt(15), 1e-11).of("speed back [m/s]")); // 30/50 of 25
    // without friction even 1e-8 rad are a slope that it comes down
    CHECK_THAT(up_and_back({10, 0, 0}, 1e-3, 1e-8, 10), IsNear(UpAndBack{5, 1e-3}, rounding));
    const double slow = up_and_back({10, 0.75, 0.75}, 5, steep + 2e-9, 10).back;
    CHECK_THAT(slow * slow, IsNear(25 * 2e-9 / 0.96, 1e-10).of("square of the speed back [m²/s²]"));
    const UpAndBack small = up_and_back({10, 0.5, 0.45}, 9.6e-8, steep, 10);
    CHECK_THAT(small.up * 1e16, IsNear(4.8, rounding).of("up [1e-16 m]"));
    CHECK_THAT(small.back * 1e8, IsNear(4.8, rounding).of("back [1e-8 m/s]"));
}

TEST_CASE("a negative speed, a box that nothing stops, and what incline_acceleration refuses, is refused", "[5.7]") {
    CHECK_REFUSED(up_and_back(crate, -5, steep, 10));
    CHECK_REFUSED(up_and_back({10, 0, 0}, 5, 0, 10));
    CHECK_REFUSED(up_and_back({10, 0.5, 0}, 5, 0, 10));
    CHECK_REFUSED(up_and_back({10, 0.5, 0}, 0, 0, 10));
    CHECK_REFUSED(up_and_back(crate, -1e-9, steep, 10));
    CHECK_REFUSED(up_and_back({10, 0.3, 0.5}, 5, steep, 10));
    CHECK_REFUSED(up_and_back({10, 0.3, std::nextafter(0.3, 1)}, 5, steep, 10));
    CHECK_REFUSED(up_and_back({10, 0.5, -0.1}, 5, steep, 10));
    CHECK_REFUSED(up_and_back({10, 0.5, -1e-9}, 5, steep, 10));
    CHECK_REFUSED(up_and_back({0, 0.5, 0.3}, 5, steep, 10));
    CHECK_REFUSED(up_and_back({-10, 0.5, 0.3}, 5, steep, 10));
    CHECK_REFUSED(up_and_back(crate, 5, -1e-15, 10));
    CHECK_REFUSED(up_and_back(crate, 5, 30, 10), "30, which are degrees");
    CHECK_REFUSED(up_and_back(crate, 5, std::nextafter(quarter_turn, 2), 10));
    CHECK_REFUSED(up_and_back(crate, 5, steep, 0));
    CHECK_REFUSED(up_and_back(crate, 5, steep, -10));
    up_and_back(crate, 5, steep, 10); // good input is still answered
}

// ------------------------------------------------------------------------------------------------- 5.8 stick_slip_step

namespace {
const Box block{2, 0.5, 0.3}; // with g = 10 m/s² static friction holds 10 N, kinetic friction is 6 N
const Spring spring{20, 0.2}; // 10 N at a stretch of 0.5 m

/// What a box does in theory, once it has begun to slip from rest.
struct Cycle {
    double stick, slip; ///< how long it rests, and how long it slips, each time [s]
    double jump;        ///< how far it gets each time [m]
};
Cycle cycle_of(const Box &box, const Spring &pulling, double g) {
    const double amplitude = (box.mu_s - box.mu_k) * box.mass * g / pulling.stiffness;
    const double omega = std::sqrt(pulling.stiffness / box.mass);
    const double slip = 2 / omega * (std::numbers::pi - std::atan(amplitude * omega / pulling.speed));
    return {2 * amplitude / pulling.speed, slip, pulling.speed * slip + 2 * amplitude};
}

double energy(const Pulled &state) {
    return block.mass * state.velocity * state.velocity / 2 + spring.stiffness * state.stretch * state.stretch / 2;
}
} // namespace

//> Worked example: it sticks
TEST_CASE("at rest, pulled with 8 N of the 10 N that hold it, a box stays, and the spring is stretched further",
          "[5.8]") {
    // a stretch of 0.4 m is 8 N; in half a second the spring's end moves on by 0.1 m
    CHECK_THAT(stick_slip_step({1, 0, 0.4}, block, spring, 10, 0.5), IsNear(Pulled{1, 0, 0.5}, rounding));
}

//> Worked example: it slips
TEST_CASE("at rest, pulled with 12 N, it slips: less 6 N of friction, 2 kg get 3 m/s² to the right", "[5.8]") {
    // 0.3 m/s after a tenth of a second; then it moves by 0.03 m, and the spring's end by 0.02 m
    CHECK_THAT(stick_slip_step({1, 0, 0.6}, block, spring, 10, 0.1), IsNear(Pulled{1.03, 0.3, 0.59}, rounding));
}

//> Worked example: it goes on
TEST_CASE("moving at 0.9 m/s, pulled with 8 N, it goes on: what would hold it at rest does not stop it", "[5.8]") {
    CHECK_THAT(
        stick_slip_step({1, 0.9, 0.4}, block, spring, 10, 0.1),
        IsNear(Pulled{1.1, 1, 0.32}, rounding).since("(8 N - 6 N) / 2 kg = 1 m/s²: 1 m/s after a tenth of a second"));
    // nor does it matter how slow it is, or which way it goes
    CHECK_THAT(stick_slip_step({1, 5e-4, 0.4}, block, spring, 10, 0.1),
               IsNear(Pulled{1.01005, 0.1005, 0.40995}, rounding));
    CHECK_THAT(stick_slip_step({1, -5e-4, 0.4}, block, spring, 10, 0.1),
               IsNear(Pulled{1.00995, 0.0995, 0.41005}, rounding));
    CHECK_THAT(stick_slip_step({1, 2e-9, 0.4}, block, spring, 10, 0.1),
               IsNear(Pulled{1.01 + 2e-10, 0.1 + 2e-9, 0.41 - 2e-10}, rounding));
}

//> Worked example: it stops
TEST_CASE("moving at 0.2 m/s with a slack spring, it stops within a tenth of a second, exactly", "[5.8]") {
    // 6 N of friction take 0.3 m/s, but there are only 0.2
    const Pulled got = stick_slip_step({1, 0.2, 0}, block, spring, 10, 0.1);
    CHECK_THAT(got.velocity, IsNear(0.0).of("velocity [m/s]"));
    CHECK_THAT(got, IsNear(Pulled{1, 0, 0.02}, rounding));
}

//> A spring that pushes
TEST_CASE("a spring that is pressed together pushes: everything is the same to the left", "[5.8]") {
    const Spring other_way{20, -0.2};
    CHECK_THAT(stick_slip_step({-1, 0, -0.4}, block, other_way, 10, 0.5), IsNear(Pulled{-1, 0, -0.5}, rounding));
    CHECK_THAT(stick_slip_step({-1, 0, -0.6}, block, other_way, 10, 0.1), IsNear(Pulled{-1.03, -0.3, -0.59}, rounding));
    CHECK_THAT(stick_slip_step({1, 0.2, -0.4}, block, spring, 10, 0.1),
               IsNear(Pulled{1, 0, -0.38}, rounding)); // both brake
}

//> Mirrored
TEST_CASE("mirrored, it does the mirrored", "[5.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Pulled before{dice.real(-5, 5), dice.whole(0, 1) * dice.real(-2, 2), dice.real(-1, 1)};
        const double dt = dice.real(0, 0.1);

        const Pulled after = stick_slip_step(before, block, spring, 10, dt);

        const Pulled mirrored = stick_slip_step({-before.position, -before.velocity, -before.stretch}, block,
                                                {spring.stiffness, -spring.speed}, 10, dt);
        CHECK_THAT(mirrored, IsNear(Pulled{-after.position, -after.velocity, -after.stretch}, rounding));
    }
}

//> The spring's end
TEST_CASE("position and stretch together grow by what the spring's end has moved", "[5.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Pulled before{dice.real(-5, 5), dice.whole(0, 1) * dice.real(-2, 2), dice.real(-1, 1)};
        const double dt = dice.real(0, 0.1), speed = dice.real(-1, 1);

        const Pulled after = stick_slip_step(before, random_box(dice), {dice.real(1, 50), speed}, 10, dt);

        const double moved = after.position + after.stretch - before.position - before.stretch;
        CHECK_THAT(moved, IsNear(speed * dt, rounding).of("how far the spring's end has moved [m]"));
    }
}

//> The times
TEST_CASE("in small frames it sticks for 2 s, slips for 1.187 s, and gets 0.637 m further each time", "[5.8]") {
    const Cycle want = cycle_of(block, spring, 10);
    CHECK_THAT(want.stick, IsNear(2.0, rounding).of("by the formula: it sticks for [s]"));
    Pulled now{0, 0, 0.5 - 1e-9};
    const double dt = 2e-3;
    std::vector<double> begins, positions; // of each slip
    double stuck = 0;
    for (int frame = 0; frame < 5500; ++frame) {
        const Pulled next = stick_slip_step(now, block, spring, 10, dt);
        if (now.velocity == 0 && next.velocity != 0) {
            begins.push_back(frame * dt);
            positions.push_back(now.position);
        }
        if (next.velocity == 0 && begins.size() == 2) stuck += dt;
        now = next;
    }
    CHECK_THAT(begins, HasSize(4).of("slips in 11 s"));
    CHECK_THAT(begins[2] - begins[1], IsNear(want.stick + want.slip, 1e-2).of("from one slip to the next [s]"));
    CHECK_THAT(stuck, IsNear(want.stick, 1e-2).of("sticks for [s]"));
    CHECK_THAT(positions[2] - positions[1], IsNear(want.jump, 5e-3).of("jump [m]"));
}

//> The energy
TEST_CASE("in small frames, what the pulling hand puts in is kinetic energy, the spring's, and friction's heat",
          "[5.8]") {
    const double dt = 2e-3;
    Pulled now{0, 0, 0};
    double hand = 0, heat = 0;
    for (int frame = 0; frame < 2000; ++frame) { // 4 s: it sticks for 2.5 s, then slips for 1.19 s
        const Pulled next = stick_slip_step(now, block, spring, 10, dt);
        hand += spring.stiffness * (now.stretch + next.stretch) / 2 * spring.speed * dt;
        heat += 6 * std::abs(next.position - now.position);
        now = next;
    }
    CHECK_THAT(heat, IsAbove(1).of("heat by friction [J]"));
    CHECK_THAT(hand - heat, IsNear(energy(now), 1e-2).of("energy of box and spring [J]"));
}

//> Half the frame
TEST_CASE("half the frame halves the error of the time at which it stops", "[5.8]") {
    const Cycle want = cycle_of(block, spring, 10);
    std::vector<double> errors;
    for (const double dt : {0.01, 0.005, 0.0025}) {
        Pulled now{0, 0, 0.5 + 1e-9};
        double slipped = 0;
        do {
            now = stick_slip_step(now, block, spring, 10, dt);
            slipped += dt;
        } while (now.velocity > 0 && slipped < 5);
        errors.push_back(std::abs(slipped - want.slip));
        CHECK_THAT(errors.back(), IsAtMost(3 * dt).of("error of the time for which it slips [s]"));
    }
}

//>
TEST_CASE("with mu_s and mu_k equal it creeps after the spring's end, and the spring stays at mu_k m g", "[5.8]") {
    Pulled now{0, 0, 0.29};
    const Box even{2, 0.3, 0.3};
    for (int frame = 0; frame < 2000; ++frame) now = stick_slip_step(now, even, {20, 0.01}, 10, 5e-3);
    CHECK_THAT(now.stretch, IsNear(0.3, 1e-2).of("stretch [m]"));
}

TEST_CASE("moving at 0.9 m/s against a pull of 2 N, it goes on: the spring takes 0.1 m/s, friction 0.3 m/s", "[5.8]") {
    // pressed together by 0.1 m, the spring pushes back with 20 N/m · 0.1 m = 2 N: 2 kg lose 1 m/s in a second.
    // Friction of 0.3 · 20 N = 6 N takes 3 m/s more: after a tenth of a second, 0.9 - 0.4 = 0.5 m/s are left. The box moves
    // on by 0.05 m, and the spring's end by 0.02 m: the stretch is -0.1 + 0.02 - 0.05 = -0.13 m
    CHECK_THAT(stick_slip_step({1, 0.9, -0.1}, block, spring, 10, 0.1), IsNear(Pulled{1.05, 0.5, -0.13}, rounding));
    CHECK_THAT(stick_slip_step({1, 2, 0}, block, spring, 10, 0.1),
               IsNear(Pulled{1.17, 1.7, -0.15}, rounding)
                   .since("a slack spring does nothing, and friction takes 3 m/s²: 1.7 m/s are left after 0.1 s"));
    const Spring other_way{20, -0.2};
    CHECK_THAT(stick_slip_step({-1, -0.9, 0.1}, block, other_way, 10, 0.1),
               IsNear(Pulled{-1.05, -0.5, 0.13}, rounding));
    CHECK_THAT(stick_slip_step({-1, -2, 0}, block, other_way, 10, 0.1), IsNear(Pulled{-1.17, -1.7, 0.15}, rounding));
}

TEST_CASE("the pull when the frame starts decides: 9.8 N hold, although the spring has 10.2 N when it ends", "[5.8]") {
    CHECK_THAT(stick_slip_step({1, 0, 0.49}, block, spring, 10, 0.1), IsNear(Pulled{1, 0, 0.51}, rounding));
    // 10 N are not larger than 0.5 · 20 N, and doubles hold all of these
    CHECK_THAT(stick_slip_step({1, 0, 0.5}, block, spring, 10, 0.1), IsNear(Pulled{1, 0, 0.52}, rounding));
    CHECK_THAT(stick_slip_step({1, 0, -0.5}, block, spring, 10, 0.1), IsNear(Pulled{1, 0, -0.48}, rounding));
    CHECK_THAT(stick_slip_step({1, 0, 0.51}, block, {20, -0.2}, 10, 0.1), // 10.2 N slip, with 9.8 N at its end
               IsNear(Pulled{1.021, 0.21, 0.469}, rounding));
}

TEST_CASE("in no time nothing moves, on ice the spring has its way, and numbers up to 1e5 are allowed", "[5.8]") {
    CHECK_THAT(stick_slip_step({1, 0.9, 0.4}, block, spring, 10, 0), IsNear(Pulled{1, 0.9, 0.4}, rounding));
    CHECK_THAT(stick_slip_step({1, 0, 0.1}, {2, 0, 0}, spring, 10, 0.1), IsNear(Pulled{1.01, 0.1, 0.11}, rounding));
    CHECK_THAT(stick_slip_step({-1e5, 0, 1e5}, {1e5, 1e5, 0}, {1, 1e5}, 10, 0.5),
               IsNear(Pulled{-1e5, 0, 1.5e5}, rounding));
    CHECK_THAT(stick_slip_step({0, 0, 1e-8}, {1e-8, 0.5, 0.3}, {20, 0.2}, 10, 0.1).velocity,
               IsNear(1.7, rounding).of("velocity [m/s]"));
    for (const double to : {1, -1}) { // to the right, then to the left
        CHECK_THAT(stick_slip_step({to * 1e5, 0, -to * 1e5}, {1e5, 1e5, 0}, {1e5, to * 1e5}, 1e5, 1e5), // it holds
                   IsNear(Pulled{to * 1e5, 0, to * (1e10 - 1e5)}, rounding));
        CHECK_THAT(stick_slip_step({0, 0, to}, {2, 1e5, 1e5}, {20, to}, 1, 10),
                   IsNear(Pulled{0, 0, to * 11}, rounding));
        CHECK_THAT(stick_slip_step({to * 1e5, to * 1e5, 0}, {2, 0, 0}, {20, 0}, 10, 10), // on ice
                   IsNear(Pulled{to * 1.1e6, to * 1e5, -to * 1e6}, rounding));
        CHECK_THAT(stick_slip_step({0, 0, to * 1e5}, {1e5, 0.5, 0.3}, {1e5, 0}, 10, 0.1), // 1e10 N slip
                   IsNear(Pulled{to * 999.97, to * 9999.7, to * (1e5 - 999.97)}, rounding));
        const Pulled small = stick_slip_step({0, 0, to}, {1e-8, 1e-8, 1e-8}, {1e-8, to * 1e-8}, 1e-8, 1e-8);
        CHECK_THAT(small.velocity * 1e8, IsNear(to, rounding).of("velocity [1e-8 m/s]")); // 1 m/s² for 1e-8 s
    }
    // pulled with hardly more than 10 N, with hardly less although it slipped before, turning round
    CHECK_THAT(stick_slip_step({1, 0, 0.5 + 1e-10}, block, spring, 10, 0.1), IsNear(Pulled{1.02, 0.2, 0.5}, 1e-9));
    CHECK_THAT(stick_slip_step({1, 0, 0.5 - 1e-10}, block, spring, 10, 0.1), // although it slipped before
               IsNear(Pulled{1, 0, 0.52 - 1e-10}, rounding));
    CHECK_THAT(stick_slip_step({1, 0.2, 0.25}, block, spring, 10, 0.1), IsNear(Pulled{1.015, 0.15, 0.255}, rounding));
    // against its motion: -0.1 + 0.49 is 0.39 m/s, less 0.3
    CHECK_THAT(stick_slip_step({1, -0.1, 0.49}, block, spring, 10, 0.1), IsNear(Pulled{1.009, 0.09, 0.501}, rounding));
}

TEST_CASE("a box, a spring, a g or a dt that makes no sense is refused", "[5.8]") {
    const Pulled rest{1, 0, 0.4};
    CHECK_REFUSED(stick_slip_step(rest, {2, 0.3, 0.5}, spring, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, {2, 0.5, -0.3}, spring, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, {2, 0.3, std::nextafter(0.3, 1)}, spring, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, {2, 0.5, -1e-9}, spring, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, {0, 0.5, 0.3}, spring, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, {-2, 0.5, 0.3}, spring, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, block, {0, 0.2}, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, block, {-20, 0.2}, 10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, block, spring, 0, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, block, spring, -10, 0.1));
    CHECK_REFUSED(stick_slip_step(rest, block, spring, 10, -0.1));
    CHECK_REFUSED(stick_slip_step(rest, block, spring, 10, -1e-9));
    stick_slip_step(rest, block, spring, 10, 0.1); // good input is still answered
}
