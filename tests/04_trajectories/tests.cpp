#include "section_test.hpp"

#include "trajectories.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using motion::State;
using trajectories::LoopRanges;
using namespace trajectories::subject; // launch_velocity, time_of_flight, ... drag_step: the student's

constexpr double degree = std::numbers::pi / 180;

// An answer is right to twelve digits: 4.1's of `speed`, and any other of the largest term in its sum, which for a
// shell fired downwards is what it'd be if it were fired upwards just as fast. Nine digits will do for 4.5, 4.7, 4.8
// and 4.9, of the largest number in the answer. Fewer will do where 4.7's target is nearly as high as the apex, where
// 4.8's is nearer than a thousandth of speed² / g or nearly out of reach, and with numbers closer to 0 than 1e-9,
// other than 0 itself.
// In 4.10 it's twelve digits of the largest number that goes into a step, or comes out of it.
// On a border, up to rounding, either side's answer is right: in 4.7 a number or nothing, in 4.8 none, one or two
// angles; where doubles hold every number on the way, one, or the same one twice. In 4.5 a point within 1e-9 s, or a 1e-9th
// of the flight, of the landing may be there or left out: then the landing stands twice, or once.

namespace {

const State from_the_ground{{0, 0}, {15, 20}}; // with g = 10 m/s² it lands after 4 s, 60 m away
const State from_a_cliff{{0, 25}, {15, 20}};   // after 5 s, 75 m away

State upwards(Dice &dice) {
    const Vec2 at{dice.real(-50, 50), dice.real(0, 100)};
    return {at, {dice.real(-30, 30), dice.real(1, 30)}};
}

/// Up or down, from 1 to 100 m above the ground.
State anywhere(Dice &dice) {
    const Vec2 at{dice.real(-50, 50), dice.real(1, 100)};
    return {at, dice.point(-30, 30)};
}

State at_degrees(double speed, double angle_deg) {
    return {{0, 0}, {speed * std::cos(angle_deg * degree), speed * std::sin(angle_deg * degree)}};
}

/// Where a shell is if there is no ground [m].
Vec2 flown(const State &muzzle, double g, double t) {
    return {muzzle.position.x() + muzzle.velocity.x() * t,
            muzzle.position.y() + muzzle.velocity.y() * t - g * t * t / 2};
}

/// How long it is in the air [s].
double landing_time(const State &muzzle, double g) {
    const double up = muzzle.velocity.y();
    return (up + std::sqrt(up * up + 2 * g * muzzle.position.y())) / g;
}

} // namespace

// ------------------------------------------------------------------------------------------------- 4.1 launch_velocity

//> Worked example: 60 degrees
TEST_CASE("at 20 m/s and 60° a shell flies at 10 m/s to the right and 17.32 m/s up", "[4.1]") {
    CHECK_THAT(launch_velocity(20, 60),
               IsNear(Vec2{10, std::sqrt(300)}, rounding).since("half of 20 is 10, and 10² + 300 = 20²"));
}

//> Right, up, left, down
TEST_CASE("at 0° a shell flies to the right, at 90° straight up, at 180° to the left, at -90° straight down", "[4.1]") {
    CHECK_THAT(launch_velocity(20, 0), IsNear(Vec2{20, 0}, rounding));
    CHECK_THAT(launch_velocity(20, 90), IsNear(Vec2{0, 20}, 20 * rounding));
    CHECK_THAT(launch_velocity(20, 180), IsNear(Vec2{-20, 0}, 20 * rounding));
    CHECK_THAT(launch_velocity(20, -90), IsNear(Vec2{0, -20}, 20 * rounding));
}

//> Whole numbers
TEST_CASE("at 25 m/s, 53.13° are 15 m/s to the right and 20 m/s up, and 36.87° the other way round", "[4.1]") {
    CHECK_THAT(launch_velocity(25, 53.13010235415598), IsNear(Vec2{15, 20}, rounding));
    CHECK_THAT(launch_velocity(25, 36.86989764584402), IsNear(Vec2{20, 15}, rounding));
    CHECK_THAT(launch_velocity(25, -36.86989764584402), IsNear(Vec2{20, -15}, rounding));
}

//> As long as the speed
TEST_CASE("the velocity is as long as the speed, at every angle", "[4.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double speed = dice.real(0, 100);

        const Vec2 velocity = launch_velocity(speed, dice.real(-360, 360));

        CHECK_THAT(std::hypot(velocity.x(), velocity.y()), IsNear(speed, rounding).of("length of the velocity [m/s]"));
    }
}

//> The dial, read back
TEST_CASE("the direction of the velocity, measured in degrees, is what the dial showed", "[4.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double angle_deg = dice.real(-179, 179);

        const Vec2 velocity = launch_velocity(dice.real(1, 100), angle_deg);

        CHECK_THAT(std::atan2(velocity.y(), velocity.x()) / degree, IsNear(angle_deg, rounding).of("direction [°]"));
    }
}

//>
TEST_CASE("at 90° minus an angle the two components change places", "[4.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double angle_deg = dice.real(-90, 180);

        const Vec2 steep = launch_velocity(25, 90 - angle_deg), flat = launch_velocity(25, angle_deg);

        CHECK_THAT(Vec2(steep.y(), steep.x()), IsNear(flat, 1e-11).of("components, swapped [m/s]"));
    }
}

TEST_CASE("twice the speed doubles both components, and without speed there are none", "[4.1]") {
    const Vec2 once = launch_velocity(20, 35);
    CHECK_THAT(launch_velocity(40, 35), IsNear(Vec2{2 * once}, rounding));
    CHECK_THAT(launch_velocity(0, 35), IsNear(Vec2{0, 0}));
}

TEST_CASE("a full turn more, or two less, changes nothing", "[4.1]") {
    CHECK_THAT(launch_velocity(20, 420), IsNear(Vec2{10, std::sqrt(300)}, rounding));
    CHECK_THAT(launch_velocity(20, -660), IsNear(Vec2{10, std::sqrt(300)}, rounding));
}

TEST_CASE("speeds and angles up to 1e5 are allowed, and tiny ones", "[4.1]") {
    CHECK_THAT(launch_velocity(1e5, 60), IsNear(Vec2{5e4, 5e4 * std::sqrt(3)}, rounding));
    CHECK_THAT(launch_velocity(1, 1e5 - 260), IsNear(Vec2{std::cos(20 * degree), std::sin(20 * degree)}, rounding));
    CHECK_THAT(launch_velocity(1, -1e5), IsNear(Vec2{std::cos(80 * degree), std::sin(80 * degree)}, rounding));
    CHECK_THAT(launch_velocity(2e-9, 60).x() * 1e9, IsNear(1.0, rounding).of("velocity to the right [1e-9 m/s]"));
    CHECK_THAT(launch_velocity(1, 1e-8).y() * 1e8, IsNear(degree, rounding).of("velocity upwards [1e-8 m/s]"));
}

TEST_CASE("a negative speed is refused by launch_velocity", "[4.1]") {
    CHECK_REFUSED(launch_velocity(-20, 60));
    CHECK_REFUSED(launch_velocity(-1e-300, 60));
    launch_velocity(20, 60); // good input is still answered
}

// -------------------------------------------------------------------------------------------------- 4.2 time_of_flight

//> Worked example: up and down
TEST_CASE("fired from the ground at (15, 20) m/s, with g = 10 m/s², a shell lands after 4 s", "[4.2]") {
    // 20 m/s upwards are gone after 2 s; down again takes 2 s, too
    CHECK_THAT(time_of_flight({{0, 0}, {15, 20}}, 10), IsNear(4.0, rounding));
}

//> Worked example: from a cliff
TEST_CASE("fired from a cliff of 25 m at (15, 20) m/s, with g = 10 m/s², it lands after 5 s", "[4.2]") {
    CHECK_THAT(time_of_flight({{0, 25}, {15, 20}}, 10),
               IsNear(5.0, rounding)
                   .since("it hits the ground at √(20² + 2 · 10 · 25) = 30 m/s, and from 20 up to 30 down are 50 m/s"));
}

//> Sideways
TEST_CASE("how fast it moves to the side, and where the muzzle is along the ground, do not matter", "[4.2]") {
    for (const double sideways : {0.0, 1.0, 300.0, -15.0})
        CHECK_THAT(time_of_flight({{7 * sideways, 0}, {sideways, 20}}, 10), IsNear(4.0, rounding));
}

//> Aimed level, aimed down
TEST_CASE("fired level from 20 m it lands after 2 s, as if dropped; at 20 m/s down from 25 m after 1 s", "[4.2]") {
    CHECK_THAT(time_of_flight({{0, 20}, {15, 0}}, 10), IsNear(2.0, rounding));
    CHECK_THAT(time_of_flight({{0, 25}, {15, -20}}, 10), IsNear(1.0, rounding));
    CHECK_THAT(time_of_flight({{0, 20}, {300, 0}}, 1.6), IsNear(5.0, rounding)); // on the Moon
}

//> On the ground
TEST_CASE("from the ground, aimed level or down, it has landed after 0 s", "[4.2]") {
    CHECK_THAT(time_of_flight({{0, 0}, {15, 0}}, 10), IsNear(0.0));
    CHECK_THAT(time_of_flight({{0, 0}, {15, -20}}, 10), IsNear(0.0, rounding));
    CHECK_THAT(time_of_flight({{0, 0}, {0, -3.3}}, 9.8), IsNear(0.0, rounding));
}

//> Twice as fast
TEST_CASE("on level ground, twice the speed or half the g makes it fly twice as long", "[4.2]") {
    CHECK_THAT(time_of_flight({{0, 0}, {30, 40}}, 10), IsNear(8.0, rounding));
    CHECK_THAT(time_of_flight({{0, 0}, {15, 20}}, 5), IsNear(8.0, rounding));
    CHECK_THAT(time_of_flight({{0, 0}, {15, 7}}, 2), IsNear(7.0, rounding));
}

//> The height at that time
TEST_CASE("at that time it is on the ground, and before that above it", "[4.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const State muzzle = anywhere(dice);
        const double g = dice.real(1, 20);

        const double t = time_of_flight(muzzle, g);

        CHECK_THAT(t, IsAtLeast(0).of("time of flight [s]"));
        CHECK_THAT(flown(muzzle, g, t).y(), IsNear(0.0, 1e-9).of("height at that time [m]")); // of thousands of metres
        CHECK_THAT(flown(muzzle, g, 0.9 * t).y(), IsAbove(0).of("height a little earlier [m]"));
    }
}

//> Erratum E4.1
TEST_CASE("erratum E4.1: at 20 m/s and 60° a shell flies for 3.53 s; the printed formula has sin θ twice", "[4.2]") {
    const double t = time_of_flight({{0, 0}, {10, std::sqrt(300)}}, 9.8);
    CHECK_THAT(t, IsNear(3.5347976, 1e-7));
    CHECK_THAT(t * std::sin(60 * degree), IsNear(3.0612245, 1e-7).of("as printed [s]"));
}

//>
TEST_CASE("heights and velocities up to 1e5 are allowed, small ones, and a weak or strong g", "[4.2]") {
    CHECK_THAT(time_of_flight({{1e5, 1e5}, {1e5, 0}}, 1e5), IsNear(std::sqrt(2.0), rounding));
    CHECK_THAT(time_of_flight({{-1e5, 1e5}, {0, -1e5}}, 1), IsNear(0.9999950000499994, 1e-6)); // of 200001
    CHECK_THAT(time_of_flight({{0, 0}, {0, 1e5}}, 1e-3), IsNear(2e8, rounding));
    CHECK_THAT(time_of_flight({{0, 2e-9}, {5, 0}}, 4e-9), IsNear(1.0, rounding));
    CHECK_THAT(time_of_flight({{0, 1e-3}, {5, 1e3}}, 10), IsNear(200.000001, rounding)); // 1000.00001 m/s down
    CHECK_THAT(time_of_flight({{0, 0}, {5, 1e-8}}, 5) * 1e8, IsNear(0.4, rounding).of("time of flight [1e-8 s]"));
}

TEST_CASE("a muzzle below the ground, or a g of 0 or less, is refused by time_of_flight", "[4.2]") {
    CHECK_REFUSED(time_of_flight({{0, -1}, {15, 20}}, 10));
    CHECK_REFUSED(time_of_flight({{0, -1e-300}, {15, 20}}, 10));
    CHECK_REFUSED(time_of_flight({{0, 25}, {15, 20}}, 0));
    CHECK_REFUSED(time_of_flight({{0, 25}, {15, 20}}, -10));
    time_of_flight(from_a_cliff, 10); // good input is still answered
}

// ----------------------------------------------------------------------------------------------------------- 4.3 range

//> Worked example: level ground
TEST_CASE("fired from the ground at (15, 20) m/s, with g = 10 m/s², a shell lands 60 m away", "[4.3]") {
    CHECK_THAT(range({{0, 0}, {15, 20}}, 10), IsNear(60.0, rounding)); // 15 m/s for 4 s
}

//> Worked example: 75 m
TEST_CASE("fired from a cliff of 25 m at (15, 20) m/s, with g = 10 m/s², it lands 75 m away", "[4.3]") {
    CHECK_THAT(range({{0, 25}, {15, 20}}, 10), IsNear(75.0, rounding)); // 15 m/s for 5 s
    CHECK_THAT(range({{0, 25}, {15, -20}}, 10), IsNear(15.0, rounding));
}

//> From the muzzle
TEST_CASE("the range counts from the muzzle, wherever along the ground that is", "[4.3]") {
    for (const double x : {40.0, -60.0, 1234.0}) CHECK_THAT(range({{x, 0}, {15, 20}}, 10), IsNear(60.0, rounding));
}

//> To the left
TEST_CASE("fired to the left, the range is negative; straight up it is 0", "[4.3]") {
    CHECK_THAT(range({{0, 0}, {-15, 20}}, 10), IsNear(-60.0, rounding));
    CHECK_THAT(range({{0, 0}, {0, 20}}, 10), IsNear(0.0, rounding));
}

//> Two angles
TEST_CASE("on level ground an angle and 90° minus that angle have the same range", "[4.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double angle_deg = dice.real(0, 90), speed = dice.real(1, 50), g = dice.real(1, 20);

        const double flat = range(at_degrees(speed, angle_deg), g), steep = range(at_degrees(speed, 90 - angle_deg), g);

        CHECK_THAT(steep, IsNear(flat, 1e-11).of("range at 90° minus the angle [m]"));
    }
}

//> The farthest on level ground
TEST_CASE("on level ground the range is farthest at 45°: speed²/g, and less by 1 - cos(2 d) at d degrees off",
          "[4.3]") {
    CHECK_THAT(range(at_degrees(25, 45), 10), IsNear(62.5, rounding));
    for (const double d : {0.1, 1.0, 15.0, 44.0, -0.1, -30.0})
        CHECK_THAT(range(at_degrees(25, 45 + d), 10), IsNear(62.5 * std::cos(2 * d * degree), rounding));
}

//> The farthest from a cliff
TEST_CASE("from a cliff of 25 m, at 25 m/s, 36.7° reach 83.85 m, and 45° only 81.64 m", "[4.3]") {
    State muzzle = at_degrees(25, 36.699225200489);
    muzzle.position.y() = 25;
    CHECK_THAT(range(muzzle, 10), IsNear(2.5 * std::sqrt(1125), 1e-11)); // speed / g · √(speed² + 2 g h)
    State steeper = at_degrees(25, 45);
    steeper.position.y() = 25;
    CHECK_THAT(range(steeper, 10), IsNear(81.639110927, 1e-9));
}

//> Twice the speed
TEST_CASE("on level ground twice the speed reaches four times as far", "[4.3]") {
    CHECK_THAT(range({{0, 0}, {30, 40}}, 10), IsNear(240.0, rounding));
    CHECK_THAT(range({{0, 0}, {7.5, 10}}, 10), IsNear(15.0, rounding));
}

//> Where it comes down
TEST_CASE("a shell that has flown that far along the ground is on the ground", "[4.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        State muzzle = anywhere(dice);
        muzzle.velocity.x() = dice.sign() * dice.real(1, 30);
        const double g = dice.real(1, 20);

        const double there = range(muzzle, g);

        const double t = there / muzzle.velocity.x();
        CHECK_THAT(t, IsAtLeast(0).of("range / velocity to the right [s]"));
        CHECK_THAT(flown(muzzle, g, t).y(), IsNear(0.0, 1e-9).of("height there [m]"));
    }
}

//> Erratum E4.2
TEST_CASE("erratum E4.2: at 20 m/s and 60° it lands at 35.35 m; printed is 17.67 m, where it is highest", "[4.3]") {
    const double there = range({{0, 0}, {10, std::sqrt(300)}}, 9.8);
    CHECK_THAT(there, IsNear(35.347976, 1e-7));
    const double printed = 20 * std::cos(60 * degree) * (20 * std::sin(60 * degree) / 9.8); // with the time up
    CHECK_THAT(there / printed, IsNear(2.0, rounding).of("range, of the printed one [1]"));
}

//>
TEST_CASE("aimed level or down from the ground, it lands where it is", "[4.3]") {
    CHECK_THAT(range({{3, 0}, {15, 0}}, 10), IsNear(0.0));
    CHECK_THAT(range({{3, 0}, {15, -20}}, 10), IsNear(0.0, 1e-11));
}

TEST_CASE("positions and velocities up to 1e5 are allowed, and small ones; ranges may be larger", "[4.3]") {
    CHECK_THAT(range({{0, 0}, {1e5, 1e5}}, 10), IsNear(2e9, rounding));
    CHECK_THAT(range({{-1e5, 1e5}, {1e5, 0}}, 1e5), IsNear(1e5 * std::sqrt(2.0), rounding));
    CHECK_THAT(range({{0, 0}, {1e-4, 1e-4}}, 2) * 1e8, IsNear(1.0, rounding).of("range [1e-8 m]"));
    CHECK_THAT(range({{0, 2e-9}, {5, 0}}, 4e-9), IsNear(5.0, rounding)); // after 1 s
    CHECK_THAT(range({{0, 0}, {2e-9, 2e-9}}, 4e-9) * 1e9, IsNear(2.0, rounding).of("range [1e-9 m]"));
    CHECK_THAT(range({{0, 1e-3}, {1, 1e3}}, 10), IsNear(200.000001, rounding));
}

TEST_CASE("a muzzle below the ground, or a g of 0 or less, is refused by range", "[4.3]") {
    CHECK_REFUSED(range({{0, -1}, {15, 20}}, 10));
    CHECK_REFUSED(range({{0, -1e-300}, {0, 0}}, 10));
    CHECK_REFUSED(range({{0, 25}, {15, 20}}, 0));
    CHECK_REFUSED(range({{0, 25}, {15, 20}}, -10));
    range(from_a_cliff, 10); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------------ 4.4 apex

//> Worked example: 20 m high
TEST_CASE("fired from the ground at (15, 20) m/s, with g = 10 m/s², a shell is highest at (30, 20) m", "[4.4]") {
    // it rises for 2 s: 15 m/s to the right, and upwards 10 m/s on average
    CHECK_THAT(apex({{0, 0}, {15, 20}}, 10), IsNear(Vec2{30, 20}, rounding));
}

//> From somewhere else
TEST_CASE("fired from (10, 25) m at (15, 20) m/s, it is highest at (40, 45) m", "[4.4]") {
    CHECK_THAT(apex({{10, 25}, {15, 20}}, 10), IsNear(Vec2{40, 45}, rounding));
    CHECK_THAT(apex({{-100, -60}, {15, 20}}, 10), IsNear(Vec2{-70, -40}, rounding));
}

//> Straight up, to the left
TEST_CASE("straight up at 20 m/s it reaches 20 m above the muzzle; to the left the apex is on the left", "[4.4]") {
    CHECK_THAT(apex({{3, 1}, {0, 20}}, 10), IsNear(Vec2{3, 21}, rounding));
    CHECK_THAT(apex({{0, 0}, {-15, 20}}, 10), IsNear(Vec2{-30, 20}, rounding));
    CHECK_THAT(apex({{0, 0}, {15, 20}}, 5), IsNear(Vec2{60, 40}, rounding));
}

//> Level
TEST_CASE("aimed level, it is highest at the muzzle", "[4.4]") {
    CHECK_THAT(apex({{10, 25}, {15, 0}}, 10), IsNear(Vec2{10, 25}));
}

//> Aimed down
TEST_CASE("aimed down from (10, 25) m, it is highest at the muzzle, not behind it", "[4.4]") {
    CHECK_THAT(apex({{10, 25}, {15, -20}}, 10), IsNear(Vec2{10, 25}));
    CHECK_THAT(apex({{10, 25}, {-15, -0.01}}, 10), IsNear(Vec2{10, 25}));
    CHECK_THAT(apex({{10, 25}, {0, -20}}, 10), IsNear(Vec2{10, 25}));
    CHECK_THAT(apex({{10, -25}, {15, -20}}, 10), IsNear(Vec2{10, -25})); // in a valley
}

//> In the middle
TEST_CASE("the apex is in the middle: just as far beyond it, the shell is as high as the muzzle again", "[4.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const State muzzle = upwards(dice);
        const double g = dice.real(1, 20);

        const Vec2 top = apex(muzzle, g);

        const Vec2 again = flown(muzzle, g, 2 * muzzle.velocity.y() / g);
        CHECK_THAT(2 * top.x() - muzzle.position.x(), IsNear(again.x(), 1e-11).of("as far beyond the apex [m]"));
    }
}

//> Nothing is higher
TEST_CASE("no other point of the flight is as high as the apex", "[4.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const State muzzle = upwards(dice);
        const double g = dice.real(1, 20), rise = muzzle.velocity.y() / g;

        const double top = apex(muzzle, g).y();

        CHECK_THAT(flown(muzzle, g, rise).y(), IsNear(top, 1e-10).of("height when it rises no more [m]"));
        for (const double other : {0.0, 0.5, 0.99, 1.01, 1.7})
            CHECK_THAT(flown(muzzle, g, other * rise).y(), IsBelow(top).of("height at another time [m]"));
    }
}

//> Energy
TEST_CASE("what it rises, times 2 g, is the square of its vertical velocity", "[4.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const State muzzle = upwards(dice);
        const double g = dice.real(1, 20);

        const double rise = apex(muzzle, g).y() - muzzle.position.y();

        const double square = muzzle.velocity.y() * muzzle.velocity.y();
        CHECK_THAT(2 * g * rise, IsNear(square, 1e-10).of("2 g times the rise [m²/s²]"));
    }
}

//> Erratum E4.3
TEST_CASE("erratum E4.3: gravity takes from the velocity upwards, until it is 0 at the apex, after 1.77 s", "[4.4]") {
    const double up = std::sqrt(300), t = apex({{0, 0}, {10, up}}, 9.8).x() / 10;
    CHECK_THAT(t, IsNear(1.767399, 1e-6).of("time to the apex [s]"));
    CHECK_THAT(up - 9.8 * t, IsNear(0.0, 1e-11).of("velocity upwards at the apex [m/s]"));
    CHECK_THAT(up + 9.8 * t, IsNear(2 * up, rounding).of("the same with the printed sign [m/s]"));
}

//>
TEST_CASE("positions and velocities up to 1e5 are allowed, and small ones; the apex may lie beyond", "[4.4]") {
    CHECK_THAT(apex({{1e5, 1e5}, {1e5, 1e5}}, 10), IsNear(Vec2{1e9 + 1e5, 5e8 + 1e5}, rounding));
    CHECK_THAT(apex({{-1e5, -1e5}, {0, 1e5}}, 1e5), IsNear(Vec2{-1e5, -5e4}, rounding));
    CHECK_THAT(apex({{0, 0}, {1e-4, 1e-4}}, 1).y() * 1e8, IsNear(0.5, rounding).of("height of the apex [1e-8 m]"));
    CHECK_THAT(apex({{0, 0}, {5, 2e-9}}, 2e-9), IsNear(Vec2{5, 1e-9}, rounding)); // after 1 s
}

TEST_CASE("a g of 0 or less is refused by apex", "[4.4]") {
    CHECK_REFUSED(apex({{0, 25}, {15, 20}}, 0));
    CHECK_REFUSED(apex({{0, 25}, {15, -20}}, 0)); // aimed down, too
    CHECK_REFUSED(apex({{0, 25}, {15, 20}}, -10));
    apex(from_a_cliff, 10); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 4.5 dotted_arc

//> Worked example: four points
TEST_CASE("from the ground at (15, 20) m/s, 1.5 s apart: four points, the last where it lands", "[4.5]") {
    const std::vector<Vec2> arc = dotted_arc({{0, 0}, {15, 20}}, 10, 1.5);
    CHECK_THAT(arc, HasSize(4).of("points"));
    CHECK_THAT(arc, IsNear(std::vector<Vec2>{{0, 0}, {22.5, 18.75}, {45, 15}, {60, 0}}, rounding)); // after 4 s
}

//> Worked example: five points
TEST_CASE("from (10, 25) m at (15, 20) m/s, 1.5 s apart: five points, the last where it lands", "[4.5]") {
    const std::vector<Vec2> arc = dotted_arc({{10, 25}, {15, 20}}, 10, 1.5);
    CHECK_THAT(arc, HasSize(5).of("points"));
    CHECK_THAT(arc, IsNear(std::vector<Vec2>{{10, 25}, {32.5, 43.75}, {55, 40}, {77.5, 13.75}, {85, 0}}, rounding));
}

//> In the air
TEST_CASE("from a cliff, the points in the air begin at the muzzle, and are dt apart in time", "[4.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const State muzzle = anywhere(dice);
        const double g = dice.real(1, 20), t = landing_time(muzzle, g), dt = dice.real(0.05, 0.3) * t;

        const std::vector<Vec2> arc = dotted_arc(muzzle, g, dt);

        for (std::size_t k = 0; double(k) * dt < t - 1e-8; ++k) {
            CHECK_THAT(int(arc.size()), IsAbove(double(k)).of("points"));
            CHECK_THAT(arc[k], IsNear(flown(muzzle, g, double(k) * dt), 1e-9).of("one of the points [m]"));
        }
    }
}

//> Not below the ground
TEST_CASE("no point is below the ground", "[4.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const State muzzle = anywhere(dice);
        const double g = dice.real(1, 20), dt = dice.real(0.05, 2);

        const std::vector<Vec2> arc = dotted_arc(muzzle, g, dt);

        CHECK_THAT(arc.size(), IsAtLeast(1).of("number of points"));
        for (const Vec2 &point : arc) CHECK_THAT(point.y(), IsAtLeast(-1e-9).of("height of a point [m]"));
    }
}

//> The last point
TEST_CASE("the last point is where the shell lands, and it comes at most dt after the one before", "[4.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        State muzzle = anywhere(dice);
        if (muzzle.velocity.y() > 1 && dice.whole(0, 1) == 0) muzzle.position.y() = 0;
        const double g = dice.real(1, 20), t = landing_time(muzzle, g), dt = dice.real(0.05, 1.2) * t;

        const std::vector<Vec2> arc = dotted_arc(muzzle, g, dt);

        const double whole = std::floor(t / dt);
        if (t - whole * dt < 1e-6 || (whole + 1) * dt - t < 1e-6) continue;
        CHECK_THAT(arc, HasSize(std::size_t(whole) + 2).of("points"));
        CHECK_THAT(arc.back(), IsNear(Vec2{flown(muzzle, g, t).x(), 0}, 1e-9).of("the last point [m]"));
    }
}

//> Straight up
TEST_CASE("straight up from the ground, all points are above the muzzle, and the last is at it", "[4.5]") {
    const std::vector<Vec2> arc = dotted_arc({{3, 0}, {0, 20}}, 10, 1.5);
    CHECK_THAT(arc, HasSize(4).of("points"));
    CHECK_THAT(arc, IsNear(std::vector<Vec2>{{3, 0}, {3, 18.75}, {3, 15}, {3, 0}}, rounding));
}

//> Long steps
TEST_CASE("if dt is longer than the flight, there are two points: the muzzle, and where it lands", "[4.5]") {
    const std::vector<Vec2> arc = dotted_arc({{0, 0}, {15, 20}}, 10, 100);
    CHECK_THAT(arc, HasSize(2).of("points"));
    CHECK_THAT(arc, IsNear(std::vector<Vec2>{{0, 0}, {60, 0}}, rounding));
    CHECK_THAT(dotted_arc({{0, 25}, {15, -20}}, 10, 1.1), IsNear(std::vector<Vec2>{{0, 25}, {15, 0}}, rounding));
}

//>
TEST_CASE("if it lands after exactly two dt, the landing may stand there once or twice", "[4.5]") {
    const std::vector<Vec2> arc = dotted_arc({{0, 0}, {15, 20}}, 10, 2);
    CHECK_THAT(arc.size(), IsAtLeast(3).of("number of points"));
    CHECK_THAT(arc.size(), IsAtMost(4).of("number of points"));
    for (std::size_t i = 0; i < arc.size(); ++i)
        CHECK_THAT(arc[i], IsNear(i == 0 ? Vec2{0, 0} : i == 1 ? Vec2{30, 20} : Vec2{60, 0}, 1e-9).of("a point [m]"));
}

//> Erratum E4.5
TEST_CASE("erratum E4.5: a loop that begins at the bottom, and runs while above it, makes no step", "[4.5]") {
    const double bottom = 479;
    int steps = 0;
    for (double y = bottom; y < bottom; y -= 17) ++steps; // as printed, with y downwards
    CHECK_THAT(steps, IsAtMost(0).of("steps of the printed loop"));
    CHECK_THAT(dotted_arc({{0, 0}, {10, std::sqrt(300)}}, 1, 1), HasSize(36).of("points"));
}

//> Erratum E4.6
TEST_CASE("erratum E4.6: with y downwards, a velocity of +V sin θ fires into the ground; -V sin θ flies for 36 frames",
          "[4.5]") {
    const double up = std::sqrt(300);
    const auto frames = [](double velocity) { // y downwards, with g = 1; the bottom of the screen is at 479
        int count = 0;
        double y = 479;
        do {
            y += velocity++;
            ++count;
        } while (y < 479);
        return double(count);
    };
    CHECK_THAT(frames(up), IsNear(1.0).of("frames of the loop as printed"));
    CHECK_THAT(frames(-up), IsNear(36.0).of("frames of the loop with a minus sign"));
    const std::vector<Vec2> arc = dotted_arc({{0, 0}, {10, up}}, 1, 1); // y upwards
    CHECK_THAT(arc, HasSize(36).of("points"));
    CHECK_THAT(arc.back(), IsNear(Vec2{20 * up, 0}, rounding).of("where it lands [px]"));
}

//> One point
TEST_CASE("from the ground, aimed level or down, the muzzle is the only point", "[4.5]") {
    CHECK_THAT(dotted_arc({{3, 0}, {15, 0}}, 10, 0.5), IsNear(std::vector<Vec2>{{3, 0}}, rounding));
    CHECK_THAT(dotted_arc({{3, 0}, {15, -20}}, 10, 0.5), IsNear(std::vector<Vec2>{{3, 0}}, rounding));
}

//>
TEST_CASE("points may be up to ±1e5 away, and there may be 10 000 of them", "[4.5]") {
    const State far_out{{-9e4, 4e4}, {7e3, 1e4}};
    const std::vector<Vec2> arc = dotted_arc(far_out, 1e3, 0.0201);
    CHECK_THAT(arc, HasSize(1166).of("points"));
    CHECK_THAT(arc[1000], IsNear(flown(far_out, 1e3, 20.1), 1e-9).of("point number 1000 [m]"));
    const State slow{{0, 0}, {1, 39.0625}}; // in the air for 156.25 s
    const std::vector<Vec2> longest = dotted_arc(slow, 0.5, 0.015626);
    CHECK_THAT(longest, HasSize(10001).of("points"));
    CHECK_THAT(longest[9999], IsNear(flown(slow, 0.5, 9999 * 0.015626), 1e-9).of("point number 9999 [m]"));
    const std::vector<Vec2> as_many = dotted_arc(slow, 0.5, 0.015625); // 10 000 dt, or by rounding a little more
    CHECK_THAT(as_many.size(), IsAtLeast(10001).of("number of points"));
    CHECK_THAT(as_many.back(), IsNear(Vec2{156.25, 0}, 1e-9).of("the last point [m]"));
    CHECK_THAT(dotted_arc({{1e5, 1e5}, {-1e5, 0}}, 5e4, 1e5), IsNear(std::vector<Vec2>{{1e5, 1e5}, {-1e5, 0}}, 1e-9));
    CHECK_THAT(dotted_arc({{0, 0}, {1, 1e5}}, 1e5, 1e5), IsNear(std::vector<Vec2>{{0, 0}, {2, 0}}, 1e-9));
    CHECK_THAT(dotted_arc({{0, 0}, {1, 2e-5}}, 1e-5, 1.5), HasSize(4).of("points, with a weak g"));
    CHECK_THAT(dotted_arc({{0, 0}, {1, 2e-4}}, 10, 1.5e-5), HasSize(4).of("points, with a small dt"));
    CHECK_THAT(dotted_arc(from_the_ground, 10, 2 - 2.5e-9), HasSize(4).of("points, one 5e-9 s before it lands"));
}

TEST_CASE("a muzzle below the ground, a g or dt of 0 or less, or a dt too short, is refused by dotted_arc", "[4.5]") {
    CHECK_REFUSED(dotted_arc({{0, -1}, {15, 20}}, 10, 0.5));
    CHECK_REFUSED(dotted_arc(from_a_cliff, 0, 0.5));
    CHECK_REFUSED(dotted_arc(from_a_cliff, -10, 0.5));
    CHECK_REFUSED(dotted_arc(from_a_cliff, 10, 0));
    CHECK_REFUSED(dotted_arc(from_a_cliff, 10, -0.5));
    CHECK_REFUSED(dotted_arc({{0, 0}, {15, 0}}, 10, 0));        // even if it does not fly
    CHECK_REFUSED(dotted_arc(from_the_ground, 10, 0.00039999)); // in the air for 4 s
    dotted_arc(from_a_cliff, 10, 0.5);                          // good input is still answered
}

// --------------------------------------------------------------------------------------------------- 4.6 range_in_wind

//> Worked example: a head wind
TEST_CASE("from the ground at (15, 20) m/s, against a wind of 2 m/s², a shell lands 44 m away, not 60", "[4.6]") {
    CHECK_THAT(range_in_wind({{0, 0}, {15, 20}}, 10, -2), IsNear(44.0, rounding));  // 4 s: 60 m - 2 · 4² / 2 m
    CHECK_THAT(range_in_wind({{0, 25}, {15, 20}}, 10, -2), IsNear(50.0, rounding)); // 5 s: 75 m - 2 · 5² / 2 m
}

//> A tail wind
TEST_CASE("with a wind of 2 m/s² from behind it lands 76 m away, and without wind 60 m", "[4.6]") {
    CHECK_THAT(range_in_wind({{0, 0}, {15, 20}}, 10, 2), IsNear(76.0, rounding));
    CHECK_THAT(range_in_wind({{0, 0}, {15, 20}}, 10, 0), IsNear(60.0, rounding));
}

//> Behind the cannon
TEST_CASE("a strong wind brings it back: against 10 m/s² it lands 20 m behind the muzzle", "[4.6]") {
    CHECK_THAT(range_in_wind({{0, 0}, {15, 20}}, 10, -10), IsNear(-20.0, rounding));
    CHECK_THAT(range_in_wind({{0, 0}, {0, 20}}, 10, 3), IsNear(24.0, rounding)); // straight up
}

//> Both ways
TEST_CASE("fired to the left, the same wind pushes the other way: everything is mirrored", "[4.6]") {
    CHECK_THAT(range_in_wind({{0, 0}, {-15, 20}}, 10, -2), IsNear(-76.0, rounding));
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const State muzzle = anywhere(dice), mirrored{muzzle.position, {-muzzle.velocity.x(), muzzle.velocity.y()}};
        const double g = dice.real(1, 20), wind = dice.real(-5, 5);

        const double there = range_in_wind(muzzle, g, wind), mirror = range_in_wind(mirrored, g, -wind);

        CHECK_THAT(mirror, IsNear(-there, 1e-10).of("range in the mirror [m]"));
    }
}

//> In a thousand steps
TEST_CASE("it lands where a thousand small steps with the wind take it, after the same time as without", "[4.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const State muzzle = anywhere(dice);
        const double g = dice.real(1, 20), wind = dice.real(-5, 5), dt = landing_time(muzzle, g) / 1000;
        double x = 0, velocity = muzzle.velocity.x();
        for (int step = 0; step < 1000; ++step) {
            x += dt * (velocity + dt / 2 * wind);
            velocity += dt * wind;
        }
        CHECK_THAT(range_in_wind(muzzle, g, wind), IsNear(x, 1e-9));
    }
}

//> Erratum E4.8
TEST_CASE("erratum E4.8: the printed wind opposes only what flies to the right; to the left it pushes on", "[4.6]") {
    const double right = range_in_wind({{0, 0}, {10, std::sqrt(300)}}, 9.8, -0.5);
    const double left = range_in_wind({{0, 0}, {-10, std::sqrt(300)}}, 9.8, -0.5);
    CHECK_THAT(right, IsNear(32.224277, 1e-7).of("range to the right [m]"));
    CHECK_THAT(left, IsNear(-38.471674, 1e-7).of("range to the left [m]"));
    CHECK_THAT(range_in_wind({{0, 0}, {10, std::sqrt(300)}}, 9.8, -10), IsNear(-27.125994, 1e-7));
}

//>
TEST_CASE("where the muzzle is along the ground does not matter, and on the ground the wind moves nothing", "[4.6]") {
    CHECK_THAT(range_in_wind({{40, 0}, {15, 20}}, 10, -2), IsNear(44.0, rounding));
    CHECK_THAT(range_in_wind({{3, 0}, {15, -20}}, 10, 5), IsNear(0.0, 1e-11));
}

TEST_CASE("winds and velocities up to 1e5 are allowed, and small ones; ranges may be larger", "[4.6]") {
    CHECK_THAT(range_in_wind({{0, 0}, {1e5, 1e5}}, 10, 1e5), IsNear(2e13 + 2e9, rounding));
    CHECK_THAT(range_in_wind({{0, 1e5}, {0, 0}}, 1e5, -1e5), IsNear(-1e5, rounding));
    CHECK_THAT(range_in_wind({{1e5, 0}, {15, 20}}, 10, -2), IsNear(44.0, rounding));
    CHECK_THAT(range_in_wind({{0, 2e-9}, {5, 0}}, 4e-9, 2), IsNear(6.0, rounding)); // after 1 s
    CHECK_THAT(range_in_wind({{0, 0}, {0, 2e-9}}, 4e-9, 4e-9) * 1e9, IsNear(2.0, rounding).of("range [1e-9 m]"));
    CHECK_THAT(range_in_wind({{0, 1e-3}, {1, 1e3}}, 10, 0), IsNear(200.000001, rounding));
}

TEST_CASE("a muzzle below the ground, or a g of 0 or less, is refused by range_in_wind", "[4.6]") {
    CHECK_REFUSED(range_in_wind({{0, -1}, {15, 20}}, 10, 2));
    CHECK_REFUSED(range_in_wind({{0, -1e-300}, {15, 20}}, 10, 2));
    CHECK_REFUSED(range_in_wind(from_a_cliff, 0, 2));
    CHECK_REFUSED(range_in_wind(from_a_cliff, -10, 2));
    range_in_wind(from_a_cliff, 10, -2); // good input is still answered
}

// ------------------------------------------------------------------------------------------------- 4.7 range_at_height

//> Worked example: a terrace
TEST_CASE("from the ground at (15, 20) m/s, a shell comes down to a terrace of 15 m 45 m away", "[4.7]") {
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 15),
               IsNear(45.0, rounding)
                   .since("it passes there at √(20² - 2 · 10 · 15) = 10 m/s: from 20 up to 10 down is 3 s, at 15 m/s"));
    CHECK_THAT(range_at_height({{0, 0}, {-15, 20}}, 10, 15), IsNear(-45.0, rounding));
}

//> A valley
TEST_CASE("to a valley 25 m below it flies 75 m, and to its own height 60 m", "[4.7]") {
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, -25), IsNear(75.0, rounding));
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 0), IsNear(60.0, rounding));
    CHECK_THAT(range_at_height({{0, 25}, {15, -20}}, 10, 0), IsNear(15.0, rounding)); // aimed down
}

//> Only the difference
TEST_CASE("only the difference of the two heights counts, and where the muzzle is does not matter", "[4.7]") {
    CHECK_THAT(range_at_height({{40, 85}, {15, 20}}, 10, 100), IsNear(45.0, rounding));
    CHECK_THAT(range_at_height({{-7, -40}, {15, 20}}, 10, -25), IsNear(45.0, rounding));
}

//> Too high
TEST_CASE("a terrace above the apex is not reached, and the answer is nothing", "[4.7]") {
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 25), IsNear(std::optional<double>{}));
    CHECK_THAT(range_at_height({{0, 50}, {15, 0}}, 10, 50.001), IsNear(std::optional<double>{}));
}

//> In the past
TEST_CASE("aimed down, a shell never comes to a height above the muzzle: before the shot does not count", "[4.7]") {
    CHECK_THAT(range_at_height({{0, 0}, {15, -20}}, 10, 15), IsNear(std::optional<double>{}));
    CHECK_THAT(range_at_height({{0, 0}, {-15, -1}}, 10, 0.01), IsNear(std::optional<double>{}));
}

//> At its own height
TEST_CASE("at the muzzle's own height the answer is 0 if it is aimed level or down", "[4.7]") {
    CHECK_THAT(range_at_height({{5, 30}, {15, -20}}, 10, 30), IsNear(0.0));
    CHECK_THAT(range_at_height({{5, 30}, {15, 0}}, 10, 30), IsNear(0.0));
}

//> Just below the apex
TEST_CASE("a millimetre below the apex it comes down, a millimetre above it there is nothing", "[4.7]") {
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 19.999), IsNear(30.212132034, 1e-9));
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 20.001), IsNear(std::optional<double>{}));
}

//> The demo's terraces
TEST_CASE("a terrace that begins 30 m away is reached at 60° if it is 20 m high, and at 64° if it is 24 m high",
          "[4.7]") {
    CHECK_THAT(range_at_height(at_degrees(25, 60), 10, 20).value(), IsAtLeast(30).of("where it comes down [m]"));
    CHECK_THAT(range_at_height(at_degrees(25, 64), 10, 24).value(), IsAtLeast(30).of("where it comes down [m]"));
}

//> On its way down
TEST_CASE("where the answer says, the shell is at that height, and not on its way up", "[4.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        State muzzle = anywhere(dice);
        muzzle.velocity.x() = dice.sign() * dice.real(1, 30);
        const double g = dice.real(1, 20), up = muzzle.velocity.y();
        const double highest = muzzle.position.y() + (up > 0 ? up * up / (2 * g) : 0);
        const double height = highest - dice.real(0.01, 100);

        const double t = range_at_height(muzzle, g, height).value() / muzzle.velocity.x();

        CHECK_THAT(t, IsAtLeast(0).of("range / velocity to the right [s]"));
        CHECK_THAT(flown(muzzle, g, t).y(), IsNear(height, 1e-9).of("height there [m]"));
        CHECK_THAT(up - g * t, IsAtMost(1e-9).of("velocity upwards there [m/s]"));
    }
}

//>
TEST_CASE(
    "heights and velocities up to ±1e5 are allowed, small ones, a shot straight up, and a height close to the apex",
    "[4.7]") {
    CHECK_THAT(range_at_height({{0, 1e5}, {1, 0}}, 4, -1e5), IsNear(std::sqrt(1e5), 1e-11));
    CHECK_THAT(range_at_height({{0, -1e5}, {1, 3000}}, 20, 1e5), IsNear(200.0, 1e-11)); // it passes at 1000 m/s
    CHECK_THAT(range_at_height({{0, -1e5}, {1, 1e3}}, 20, 1e5), IsNear(std::optional<double>{}));
    CHECK_THAT(range_at_height({{1e5, 1e5}, {1e5, 1e5}}, 1e5, 1e5), IsNear(2e5, 1e-9));
    CHECK_THAT(range_at_height({{0, 0}, {2e-9, 0}}, 4e-9, -2e-9).value() * 1e9,
               IsNear(2.0, 1e-9).of("answer [1e-9 m]"));
    CHECK_THAT(range_at_height({{3, 0}, {0, 20}}, 10, 15), IsNear(0.0, rounding));            // straight up
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 20 - 1e-8), IsNear(30.0006708, 1e-6)); // just below the apex
    CHECK_THAT(range_at_height({{0, 0}, {15, 20}}, 10, 20 + 1e-8), IsNear(std::optional<double>{}));
}

TEST_CASE("a g of 0 or less is refused by range_at_height", "[4.7]") {
    CHECK_REFUSED(range_at_height(from_a_cliff, 0, 15));
    CHECK_REFUSED(range_at_height(from_a_cliff, -10, 15));
    range_at_height(from_a_cliff, 10, 15); // good input is still answered
}

// --------------------------------------------------------------------------------------------------- 4.8 launch_angles

//> Worked example: two angles
TEST_CASE("at 25 m/s, a target 60 m away is hit at 36.87° and at 53.13°", "[4.8]") {
    CHECK_THAT(launch_angles(25, {60, 0}, 10), HasSize(2).of("angles"));
    CHECK_THAT(launch_angles(25, {60, 0}, 10), IsNear(std::vector{36.86989764584402, 53.13010235415598}, 1e-9));
}

//> Up on a terrace, down in a valley
TEST_CASE("at 25 m/s, a target at (45, 15) m is hit at 53.13° and 55.30°, one at (75, -25) m at 18.43° and 53.13°",
          "[4.8]") {
    CHECK_THAT(launch_angles(25, {45, 15}, 10), IsNear(std::vector{53.13010235415598, 55.30484646876603}, 1e-9));
    CHECK_THAT(launch_angles(25, {75, -25}, 10), IsNear(std::vector{18.43494882292201, 53.13010235415598}, 1e-9));
}

//> Out of reach
TEST_CASE("out of reach there is no angle: 62.6 m away, 25 m/s reach 62.5 m", "[4.8]") {
    CHECK_THAT(launch_angles(25, {62.6, 0}, 10), HasSize(0).of("angles"));
    CHECK_THAT(launch_angles(25, {62.5 + 1e-8, 0}, 10), HasSize(0).of("angles"));
    CHECK_THAT(launch_angles(25, {1, 31.3}, 10), HasSize(0).of("angles"));
    CHECK_THAT(launch_angles(0, {10, 10}, 10), HasSize(0).of("angles"));
    CHECK_THAT(launch_angles(0, {10, -10}, 10), HasSize(0).of("angles"));
    CHECK_THAT(launch_angles(25, {62.4, 0}, 10), HasSize(2).of("angles"));
}

//> As far as it reaches
TEST_CASE("exactly as far as it reaches, it is hit at 45°; a little nearer there are two angles", "[4.8]") {
    CHECK_THAT(launch_angles(25, {62.5 - 1e-8, 0}, 10), HasSize(2).of("angles"));
    auto angles = launch_angles(25, {62.5, 0}, 10);                      // doubles hold every number on the way
    if (angles.size() == 2 && angles[0] == angles[1]) angles.pop_back(); // the same one twice
    CHECK_THAT(angles, IsNear(std::vector{45.0}, 1e-5).of("angles [°]"));
}

//> Through the target
TEST_CASE("at each angle the shell goes through the target, and the smaller angle comes first", "[4.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double speed = dice.real(5, 50), g = dice.real(1, 20), reach = speed * speed / g;
        const double x = dice.real(0.01, 1.5) * reach, highest = reach / 2 - x * x / (2 * reach);
        const Vec2 target{x, highest - dice.real(0.01, 2) * reach};

        const std::vector<double> angles = launch_angles(speed, target, g);

        CHECK_THAT(angles, HasSize(2).of("angles"));
        CHECK_THAT(angles[0], IsBelow(angles[1]).of("the first angle [°]"));
        for (const double angle_deg : angles) {
            CHECK_THAT(std::abs(angle_deg), IsBelow(90).of("size of an angle [°]"));
            const State muzzle = at_degrees(speed, angle_deg);
            const double y = flown(muzzle, g, x / muzzle.velocity.x()).y();
            CHECK_THAT((y - target.y()) / reach, IsNear(0.0, 1e-8).of("how far it misses, of speed²/g [1]"));
        }
    }
}

//> Their sum
TEST_CASE("both angles add up to 90° plus the angle at which one sees the target", "[4.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 target{dice.real(5, 40), dice.real(-30, 5)};

        const std::vector<double> angles = launch_angles(30, target, 9.8);

        CHECK_THAT(angles, HasSize(2).of("angles"));
        const double seen = std::atan2(target.y(), target.x()) / degree;
        CHECK_THAT(angles[0] + angles[1] - 90, IsNear(seen, 1e-9).of("sum of both angles, minus 90° [°]"));
    }
}

//> The border of what it reaches
TEST_CASE("there are two angles below the curve y = v²/2g - g x²/2v², and none above it", "[4.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double x = dice.real(1, 80), border = 31.25 - x * x / 125, away = dice.real(0.01, 20);
        CHECK_THAT(launch_angles(25, {x, border + away}, 10), HasSize(0).of("angles"));
        CHECK_THAT(launch_angles(25, {x, border - away}, 10), HasSize(2).of("angles"));
    }
}

//>
TEST_CASE("where a shell that is fired level comes down, one angle is 0°; far below, one is close to -90°", "[4.8]") {
    CHECK_THAT(launch_angles(25, {25, -5}, 10), IsNear(std::vector{0.0, 78.69006752597979}, 1e-9));
    CHECK_THAT(launch_angles(25, {10, -90}, 10), IsNear(std::vector{-80.56915018534404, 86.90934193125395}, 1e-9));
}

TEST_CASE("speeds and targets up to 1e5 are allowed, and near ones", "[4.8]") {
    CHECK_THAT(launch_angles(1e3, {1e5, 0}, 5), IsNear(std::vector{15.0, 75.0}, 1e-9));
    CHECK_THAT(launch_angles(1e5, {1e5, 1e5}, 1e5), IsNear(std::vector<double>{}));
    CHECK_THAT(launch_angles(1e5, {1e5, -1e5}, 1e5), IsNear(std::vector{-22.5, 67.5}, 1e-9));
    CHECK_THAT(launch_angles(1e-4, {5e-9, 0}, 1), IsNear(std::vector{15.0, 75.0}, 1e-9));
    CHECK_THAT(launch_angles(2e-4, {5, 0}, 4e-9), IsNear(std::vector{15.0, 75.0}, 1e-9));
    const double flat = std::asin(0.0016) / 2 / degree; // 0.1 m away, of 62.5
    const std::vector<double> near = launch_angles(25, {0.1, 0}, 10);
    CHECK_THAT(near, IsNear(std::vector{flat, 90 - flat}, 1e-8));
    CHECK_THAT(near[0] / flat, IsNear(1.0, 1e-9).of("the flat angle, of the right one [1]"));
    CHECK_THAT(launch_angles(25, {1e-3, 0}, 10), IsNear(std::vector{0.000458366, 89.999541634}, 1e-6));
    CHECK_THAT(launch_angles(25, {1e-5, 0}, 10), HasSize(2).of("angles, very near"));
    CHECK_THAT(launch_angles(25, {1, 0.1}, 10), HasSize(2).of("angles, near and upwards"));
}

TEST_CASE("a negative speed, a target that is not to the right, or g <= 0, is refused by launch_angles", "[4.8]") {
    CHECK_REFUSED(launch_angles(-25, {60, 0}, 10));
    CHECK_REFUSED(launch_angles(25, {0, 10}, 10));
    CHECK_REFUSED(launch_angles(25, {-60, 0}, 10));
    CHECK_REFUSED(launch_angles(25, {60, 0}, 0));
    CHECK_REFUSED(launch_angles(25, {60, 0}, -10));
    launch_angles(25, {60, 0}, 10); // good input is still answered
}

// ----------------------------------------------------------------------------------------------- 4.9 frame_loop_ranges

//> Worked example: frames of a second
TEST_CASE("from the ground at (15, 20) m/s, in frames of 1 s: 75 m, 45 m and 60 m", "[4.9]") {
    // heights: 0, 20, 30, 30, 20, 0 m by explicit Euler; 0, 10, 10, 0 m by semi-implicit; 0, 15, 20, 15, 0 m exactly
    CHECK_THAT(frame_loop_ranges({{0, 0}, {15, 20}}, 10, 1), IsNear(LoopRanges{75, 45, 60}, rounding));
}

//> Worked example: between two frames
TEST_CASE("from (10, 25) m the last frame is cut, and the ranges are 87.5 m, 62.5 m and 75 m", "[4.9]") {
    // explicit Euler: from 25 m to -5 m in frame 6, so 5/6 of it; semi-implicit: from 5 m to -25 m in frame 5, so 1/6
    CHECK_THAT(frame_loop_ranges({{10, 25}, {15, 20}}, 10, 1), IsNear(LoopRanges{87.5, 62.5, 75}, rounding));
}

//> A straight line
TEST_CASE("with frames of 1.5 s the exact loop falls short, by its last straight line: 57.86 m", "[4.9]") {
    // from (45, 15) m after 3 s to (67.5, -11.25) m after 4.5 s
    CHECK_THAT(frame_loop_ranges({{0, 0}, {15, 20}}, 10, 1.5).exact,
               IsNear(45 + 22.5 * 15 / 26.25, rounding).of("exact [m]"));
}

//> At three frame rates
TEST_CASE("at 20 m/s and 60°, frames of 0.1, 0.01 and 0.001 s come nearer and nearer to 35.348 m", "[4.9]") {
    const State muzzle{{0, 0}, {10, std::sqrt(300)}};
    CHECK_THAT(frame_loop_ranges(muzzle, 9.8, 0.1), IsNear(LoopRanges{36.3418, 34.3414, 35.3416}, 1e-5));
    CHECK_THAT(frame_loop_ranges(muzzle, 9.8, 0.01), IsNear(LoopRanges{35.4479, 35.2479, 35.3479}, 1e-5));
    CHECK_THAT(frame_loop_ranges(muzzle, 9.8, 0.001), IsNear(LoopRanges{35.3580, 35.3380, 35.34798}, 1e-5));
}

//> Half of the step
TEST_CASE("with half of dt, both Eulers are half as wrong; the exact loop misses by less than a chord does", "[4.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const State muzzle = upwards(dice);
        const double g = dice.real(1, 20), t = landing_time(muzzle, g), dt = muzzle.velocity.y() / g / 40;
        const double x = muzzle.velocity.x(), there = x * t, impact = g * t - muzzle.velocity.y();
        if (t > 500 * dt) continue;
        const LoopRanges coarse = frame_loop_ranges(muzzle, g, dt), fine = frame_loop_ranges(muzzle, g, dt / 16);

        const auto in_frames = [&](double landed, double length) { return (landed - there) / (x * length); };
        const double chord = g * dt * dt / 8;              // how far a straight line is below the arc [m]
        const double ratio = muzzle.velocity.y() / impact; // how much of half a frame an Euler gains each way
        CHECK_THAT(in_frames(coarse.explicit_euler, dt),
                   IsNear((1 + ratio) / 2, 0.05).of("explicit_euler's error, in frames [1]"));
        CHECK_THAT(in_frames(fine.explicit_euler, dt / 16),
                   IsNear((1 + ratio) / 2, 0.01).of("explicit_euler's error with finer frames, in frames [1]"));
        CHECK_THAT(in_frames(coarse.semi_implicit, dt),
                   IsNear(-(1 + ratio) / 2, 0.05).of("semi_implicit's error, in frames [1]"));
        CHECK_THAT(std::abs(coarse.exact - there),
                   IsAtMost(std::abs(x) * chord / impact * 1.1).of("how far exact is off [m]"));
    }
}

//> The Eulers are exact for another shot
TEST_CASE("explicit Euler does exactly what a shell does that is fired g dt/2 faster upwards", "[4.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const State muzzle = upwards(dice);
        const double g = dice.real(1, 20), dt = dice.real(0.02, 0.6) * muzzle.velocity.y() / g;
        State faster = muzzle, slower = muzzle;
        faster.velocity.y() += g * dt / 2;
        slower.velocity.y() -= g * dt / 2;
        if (slower.velocity.y() <= g * dt) continue;

        const LoopRanges ranges = frame_loop_ranges(muzzle, g, dt);

        CHECK_THAT(frame_loop_ranges(faster, g, dt).exact, IsNear(ranges.explicit_euler, 1e-9).of("exact, faster [m]"));
        CHECK_THAT(frame_loop_ranges(slower, g, dt).exact, IsNear(ranges.semi_implicit, 1e-9).of("exact, slower [m]"));
    }
}

//> Erratum E4.7
TEST_CASE("erratum E4.7: fired at 10 px per frame, it is back after 20 frames; the printed loop takes 21", "[4.9]") {
    CHECK_THAT(frame_loop_ranges({{0, 0}, {1, 10}}, 1, 1), IsNear(LoopRanges{21, 19, 20}, rounding));
}

//>
TEST_CASE("fired to the left the ranges are negative, and where the muzzle is does not matter", "[4.9]") {
    CHECK_THAT(frame_loop_ranges({{40, 25}, {-15, 20}}, 10, 1), IsNear(LoopRanges{-87.5, -62.5, -75}, rounding));
    CHECK_THAT(frame_loop_ranges({{-9, 25}, {0, 20}}, 10, 1), IsNear(LoopRanges{0, 0, 0}, rounding));
}

TEST_CASE("flights up to ±1e5 are allowed, of up to 10 000 frames, small ones, and dt just short enough", "[4.9]") {
    const LoopRanges ranges = frame_loop_ranges({{-9e4, 0}, {1e4, 1e4}}, 1250, 0.0016002);
    CHECK_THAT(ranges.exact, IsNear(1.6e5, 1e-6).of("exact [m]"));
    CHECK_THAT(ranges.explicit_euler, IsNear(1.6e5 + 16.002, 1e-6).of("explicit_euler [m]"));
    CHECK_THAT(frame_loop_ranges({{0, 0}, {15, 20}}, 10, 1.999).semi_implicit,
               IsNear(30.0000075, 1e-8).of("semi_implicit [m]"));
    const LoopRanges longest{156.265625, 156.234375, 156.25}; // explicit Euler's takes 10 001 frames
    CHECK_THAT(frame_loop_ranges({{0, 0}, {1, 39.0625}}, 0.5, 0.015625), IsNear(longest, 1e-9));
    CHECK_THAT(frame_loop_ranges({{1e5, 0}, {-1e5, 5e4}}, 1e5, 0.25), IsNear(LoopRanges{-1.25e5, -7.5e4, -1e5}, 1e-9));
    CHECK_THAT(frame_loop_ranges({{0, 0}, {0.1, 0.4}}, 2e-6, 1e5), IsNear(LoopRanges{5e4, 3e4, 4e4}, 1e-9));
    CHECK_THAT(frame_loop_ranges({{0, 0}, {0.15, 0.2}}, 1e5, 1.5e-6).exact * 1e8, // as in frames of 1.5 s
               IsNear(45 + 22.5 * 15 / 26.25, 1e-9).of("exact [1e-8 m]"));
}

TEST_CASE("a muzzle below the ground or not aimed up, g <= 0, or a bad dt: frame_loop_ranges refuses", "[4.9]") {
    CHECK_REFUSED(frame_loop_ranges({{0, -1}, {15, 20}}, 10, 0.1));
    CHECK_REFUSED(frame_loop_ranges({{0, 25}, {15, 0}}, 10, 0.1));
    CHECK_REFUSED(frame_loop_ranges({{0, 25}, {15, -20}}, 10, 0.1));
    CHECK_REFUSED(frame_loop_ranges(from_a_cliff, 0, 0.1));
    CHECK_REFUSED(frame_loop_ranges(from_a_cliff, -10, 0.1));
    CHECK_REFUSED(frame_loop_ranges(from_a_cliff, 10, 0));
    CHECK_REFUSED(frame_loop_ranges(from_a_cliff, 10, -0.1));
    CHECK_REFUSED(frame_loop_ranges(from_a_cliff, 10, 2));             // just too long
    CHECK_REFUSED(frame_loop_ranges(from_the_ground, 10, 0.00039999)); // in the air for 4 s
    frame_loop_ranges(from_a_cliff, 10, 0.1);                          // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 4.10 drag_step

namespace {

constexpr double shell_drag = 0.025; // with g = 10, as fast as it falls in the end is 20 m/s

/// In moderate air, or a little or a lot of it.
struct Flow {
    State shell;
    double g, drag;
    Vec2 wind;
    double dt;

    explicit Flow(Dice &dice)
        : shell{dice.point(-50, 50), dice.point(-30, 30)},
          g{dice.real(0, 20)},
          drag{std::pow(10, dice.real(-3, 1))},
          wind{dice.point(-15, 15)},
          dt{dice.real(0.001, 0.5)} {}

    Vec2 relative() const { return shell.velocity - wind; }
    State step() const { return drag_step(shell, g, drag, wind, dt); }
};

State after(State shell, double g, double drag, const Vec2 &wind, double t, int steps) {
    for (int i = 0; i < steps; ++i) shell = drag_step(shell, g, drag, wind, t / steps);
    return shell;
}

/// A thousand steps of fourth order.
State by_runge_kutta(State shell, double g, double drag, const Vec2 &wind, double t) {
    const double h = t / 1000;
    const auto pull = [&](const Vec2 &velocity) -> Vec2 {
        return Vec2{0, -g} - drag * (velocity - wind).norm() * (velocity - wind);
    };
    for (int i = 0; i < 1000; ++i) {
        const Vec2 v = shell.velocity, a = pull(v), b = pull(v + h / 2 * a), c = pull(v + h / 2 * b),
                   d = pull(v + h * c);
        shell.position += h * v + h * h / 6 * (a + b + c);
        shell.velocity += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return shell;
}

/// How fast a body falls after a time, when it's dropped in still air [m/s], and how far [m]: in closed form.
double fall_speed(double g, double drag, double t) { return std::sqrt(g / drag) * std::tanh(std::sqrt(g * drag) * t); }
double fall_depth(double g, double drag, double t) { return std::log(std::cosh(std::sqrt(g * drag) * t)) / drag; }

} // namespace

//> Worked example: a step in still air
TEST_CASE("at (15, 20) m/s in still air, with 0.025 1/m and g = 10, after 0.4 s it does (12, 12.8) m/s", "[4.10]") {
    CHECK_THAT(drag_step({{0, 0}, {15, 20}}, 10, shell_drag, {0, 0}, 0.4),
               IsNear(State{{5.4, 6.56}, {12, 12.8}}, rounding)
                   .since("25 m/s · 0.025 1/m · 0.4 s = 0.25, and (15, 20 − 4) / 1.25 = (12, 12.8)"));
}

//> Worked example: a step in a head wind
TEST_CASE("at (10, 20) m/s, against a wind of 5 m/s, it meets the same air, and does (7, 12.8) m/s after 0.4 s",
          "[4.10]") {
    CHECK_THAT(drag_step({{3, 2}, {10, 20}}, 10, shell_drag, {-5, 0}, 0.4),
               IsNear(State{{6.4, 8.56}, {7, 12.8}}, rounding)
                   .since("relative to the air it's (15, 20) m/s before and (12, 12.8) m/s after"));
}

//> No air
TEST_CASE("without drag it flies the parabola of the vacuum, whichever wind blows", "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        Flow flow{dice};
        flow.drag = 0;

        const State end = flow.step();

        CHECK_THAT(end.position, IsNear(flown(flow.shell, flow.g, flow.dt), 1e-10).of("position [m]"));
        CHECK_THAT(end.velocity,
                   IsNear(Vec2{flow.shell.velocity + flow.dt * Vec2{0, -flow.g}}, 1e-10).of("velocity [m/s]"));
    }
    CHECK_THAT(drag_step({{0, 0}, {15, 20}}, 10, 1e-9, {0, 0}, 1), IsNear(State{{15, 15}, {15, 10}}, 1e-6));
}

//> Terminal velocity
TEST_CASE("whatever falls at √(g / drag) in still air goes on at just that speed, in steps of any length", "[4.10]") {
    CHECK_THAT(drag_step({{0, 0}, {0, -20}}, 10, shell_drag, {0, 0}, 0.1),
               IsNear(State{{0, -2}, {0, -20}}, rounding).since("0.025 · 20² = 10: the air takes what g adds"));
    CHECK_THAT(drag_step({{0, 0}, {0, -20}}, 10, shell_drag, {0, 0}, 30), IsNear(State{{0, -600}, {0, -20}}, rounding));
    CHECK_THAT(drag_step({{0, 0}, {0, -1}}, 10, 10, {0, 0}, 0.5), IsNear(State{{0, -0.5}, {0, -1}}, rounding));
    CHECK_THAT(drag_step({{0, 0}, {6, -18}}, 10, shell_drag, {6, 2}, 0.5), // in a wind that also rises
               IsNear(State{{3, -9}, {6, -18}}, rounding));
}

//> In the end
TEST_CASE("however it starts, in the end it falls at √(g / drag), and drifts with the wind", "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(200); ++i) {
        Flow flow{dice};
        flow.g = dice.real(1, 20);
        flow.drag = std::pow(10, dice.real(-2, 1));
        const double terminal = std::sqrt(flow.g / flow.drag);
        flow.dt = dice.real(0.2, 2) * terminal / flow.g;

        const State end = after(flow.shell, flow.g, flow.drag, flow.wind, 200 * flow.dt, 200);

        CHECK_THAT(end.velocity, IsNear(Vec2{flow.wind - Vec2{0, terminal}}, 1e-9).of("velocity in the end [m/s]"));
    }
}

//> The wind is a frame that moves
TEST_CASE("seen from a train, with a wind and a velocity that are both less by the train's, it's the same flight",
          "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Flow flow{dice};
        Flow seen = flow;
        const Vec2 train = dice.point(-30, 30);
        seen.shell.velocity -= train;
        seen.wind -= train;

        const State end = flow.step(), there = seen.step();

        CHECK_THAT(there.velocity + train, IsNear(end.velocity, 1e-10).of("velocity, seen from the train [m/s]"));
        CHECK_THAT(there.position + flow.dt * train,
                   IsNear(end.position, 1e-10).of("position, seen from the train [m]"));
    }
}

//> It blows what stands still
TEST_CASE("a wind sets going what stands still, and what drifts with it meets no drag", "[4.10]") {
    CHECK_THAT(drag_step({{0, 0}, {0, 0}}, 0, 0.1, {10, 0}, 1),
               IsNear(State{{2.5, 0}, {5, 0}}, rounding)
                   .since("relative to the air it's at (-10, 0) m/s, and −10 / (1 + 0.1 · 10 · 1) = −5"));
    CHECK_THAT(drag_step({{0, 0}, {10, 0}}, 10, 0.1, {10, 0}, 1), IsNear(State{{10, -5}, {10, -10}}, rounding));
}

//> Round the compass
TEST_CASE("without g no direction is special: turn the shell and the wind, and the step is turned", "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Flow flow{dice};
        flow.g = 0;
        Flow turned = flow;
        const Vec2 x = dice.direction(), y{-x.y(), x.x()};
        const auto turn = [&](const Vec2 &v) -> Vec2 { return v.x() * x + v.y() * y; };
        turned.shell = {turn(flow.shell.position), turn(flow.shell.velocity)};
        turned.wind = turn(flow.wind);

        const State end = flow.step();

        CHECK_THAT(turned.step().velocity, IsNear(turn(end.velocity), 1e-10).of("velocity, turned [m/s]"));
        CHECK_THAT(turned.step().position, IsNear(turn(end.position), 1e-10).of("position, turned [m]"));
    }
}

//> Never round
TEST_CASE("without g it keeps its direction relative to the air, however strong the drag, and only slows down",
          "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Flow flow{dice};
        flow.g = 0;
        flow.drag = std::pow(10, dice.real(-3, 4));

        const Vec2 before = flow.relative(), now = flow.step().velocity - flow.wind;

        CHECK_THAT(before.dot(now), IsAtLeast(0).of("relative velocity before · relative velocity after [m²/s²]"));
        CHECK_THAT(now.norm(), IsAtMost(before.norm() * (1 + 1e-12)).of("relative speed after the step [m/s]"));
    }
}

//> Energy in air
TEST_CASE("while it falls relative to the air, its energy relative to the air never grows", "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Flow flow{dice};
        const Vec2 before = flow.relative();
        if (before.y() > 0) continue;

        const State end = flow.step();

        const Vec2 now = end.velocity - flow.wind, way = end.position - flow.shell.position - flow.dt * flow.wind;
        const double gained = (now.squaredNorm() - before.squaredNorm()) / 2 + flow.g * way.y();
        CHECK_THAT(gained, IsAtMost(1e-9).of("kinetic and potential energy gained, for each kilogram [J/kg]"));
    }
}

//> Confetti at 25 m/s
TEST_CASE("a piece of confetti at 25 m/s, with 10 1/m and frames of 1/60 s, never gets faster, and soon does 1 m/s",
          "[4.10]") {
    State piece{{0, 0}, {15, 20}};
    for (int frame = 1; frame <= 300; ++frame) {
        const double before = piece.velocity.norm();
        piece = drag_step(piece, 10, 10, {0, 0}, 1.0 / 60);
        CHECK_THAT(piece.velocity.norm(), IsAtMost(std::max(before, 1.001)).of("speed after one more frame [m/s]"));
    }
    CHECK_THAT(piece.velocity, IsNear(Vec2{0, -1}, 1e-9).of("velocity after 5 s [m/s]"));
}

//> Exact, without g
TEST_CASE("without g, one long step slows it down as many short ones do, and as v / (1 + drag v t)", "[4.10]") {
    CHECK_THAT(drag_step({{0, 0}, {20, 0}}, 0, 0.1, {0, 0}, 2).velocity,
               IsNear(Vec2{4, 0}, rounding).of("velocity [m/s]"));
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        Flow flow{dice};
        flow.g = 0;

        const Vec2 once = flow.step().velocity;

        CHECK_THAT(after(flow.shell, 0, flow.drag, flow.wind, flow.dt, 20).velocity,
                   IsNear(once, 1e-10).of("velocity after 20 short steps [m/s]"));
    }
}

//> Dropped, in closed form
TEST_CASE("dropped in still air it falls as tanh has it, and with half of dt it's a quarter as wrong", "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(200); ++i) {
        const double g = dice.real(1, 20), terminal = dice.real(1, 40), drag = g / (terminal * terminal);
        const double t = dice.real(0.5, 2) * terminal / g;
        const Vec2 there{0, -fall_depth(g, drag, t)}, speed{0, -fall_speed(g, drag, t)};
        const auto error = [&](int steps) -> Vec2 {
            const State end = after({{0, 0}, {0, 0}}, g, drag, {0, 0}, t, steps);
            return {(end.velocity - speed).norm() / terminal, (end.position - there).norm() / -there.y()};
        };
        const Vec2 coarse = error(50), fine = error(100);

        CHECK_THAT(coarse.x(), IsAtMost(1e-3).of("how far its velocity is off, of √(g / drag) [1]"));
        CHECK_THAT(coarse.y(), IsAtMost(1e-3).of("how far its depth is off, of the depth [1]"));
        CHECK_THAT(fine.x() / coarse.x(),
                   IsNear(0.25, 0.01).of("error of the velocity with half of dt, of that before [1]"));
        CHECK_THAT(fine.y() / coarse.y(),
                   IsNear(0.25, 0.01).of("error of the depth with half of dt, of that before [1]"));
    }
}

//> Half of dt in wind
TEST_CASE("a shot in wind is where Runge-Kutta has it, and with half of dt it's half as wrong", "[4.10]") {
    for (const Vec2 &wind : {Vec2{0, 0}, Vec2{-5, 0}, Vec2{-10, 0}, Vec2{8, 3}}) {
        const State muzzle{{0, 0}, {15, 20}};
        const State there = by_runge_kutta(muzzle, 10, shell_drag, wind, 2);
        const auto error = [&](int steps) -> Vec2 {
            const State end = after(muzzle, 10, shell_drag, wind, 2, steps);
            return {(end.velocity - there.velocity).norm(), (end.position - there.position).norm()};
        };
        const Vec2 coarse = error(50), fine = error(100);

        CHECK_THAT(fine.x(), IsAtMost(0.1).of("how far its velocity is off after 2 s [m/s]"));
        CHECK_THAT(fine.y(), IsAtMost(0.1).of("how far its position is off after 2 s [m]"));
        CHECK_THAT(fine.x() / coarse.x(),
                   IsNear(0.5, 0.02).of("error of the velocity with half of dt, of that before [1]"));
        CHECK_THAT(fine.y() / coarse.y(),
                   IsNear(0.5, 0.02).of("error of the position with half of dt, of that before [1]"));
    }
}

//>
TEST_CASE("a wind from the right does to a shell to the right what one from the left does to its mirror image",
          "[4.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Flow flow{dice};
        Flow mirrored = flow;
        for (Vec2 *each : {&mirrored.shell.position, &mirrored.shell.velocity, &mirrored.wind}) each->x() = -each->x();

        const State end = flow.step(), there = mirrored.step();

        CHECK_THAT(there.velocity, IsNear(Vec2{-end.velocity.x(), end.velocity.y()}, 1e-10).of("velocity [m/s]"));
        CHECK_THAT(there.position, IsNear(Vec2{-end.position.x(), end.position.y()}, 1e-10).of("position [m]"));
    }
}

TEST_CASE("drag_step takes numbers up to ±1e5, no g, and a shell that stands still in still air", "[4.10]") {
    CHECK_THAT(drag_step({{3, 4}, {0, 0}}, 0, 1e5, {0, 0}, 1e5), IsNear(State{{3, 4}, {0, 0}}, rounding));
    CHECK_THAT(drag_step({{3, 4}, {0, 0}}, 10, 10, {0, 0}, 0.5), IsNear(State{{3, 2.75}, {0, -5}}, rounding));
    CHECK_THAT(drag_step({{-1e5, 1e5}, {1e5, 0}}, 0, 1e5, {0, 0}, 1e-5),
               IsNear(State{{-1e5 + 0.50000499995, 1e5}, {0.99999000009999900001, 0}}, 1e-9));
    CHECK_THAT(drag_step({{0, 0}, {-1e5, 0}}, 0, 1e5, {1e5, 0}, 1e5).velocity,
               IsNear(Vec2{1e5, 0}, 1e-9).of("velocity [m/s]"));
    CHECK_THAT(drag_step({{0, 0}, {1e5, 1e5}}, 1e5, 0, {-1e5, 1e5}, 2), IsNear(State{{2e5, 0}, {1e5, -1e5}}, 1e-9));
}

TEST_CASE("a negative g or drag, or a dt of 0 or less, is refused by drag_step", "[4.10]") {
    const State shell{{0, 0}, {15, 20}};
    CHECK_REFUSED(drag_step(shell, -10, shell_drag, {0, 0}, 0.1));
    CHECK_REFUSED(drag_step(shell, 10, -shell_drag, {0, 0}, 0.1));
    CHECK_REFUSED(drag_step(shell, 10, shell_drag, {0, 0}, 0));
    CHECK_REFUSED(drag_step(shell, 10, shell_drag, {0, 0}, -0.1));
    CHECK_REFUSED(drag_step(shell, 10, 0, {0, 0}, 0), "dt = 0, without any drag");
    drag_step(shell, 10, shell_drag, {0, 0}, 0.1); // good input is still answered
}
