#include "section_test.hpp"

#include "time_based_motion.hpp"

#include <algorithm>
#include <cmath>

using time_based_motion::Clock;
using time_based_motion::delay;
using time_based_motion::Due;
using time_based_motion::Game;
using time_based_motion::Job;
using time_based_motion::longest_guess;
using time_based_motion::Packet;
using time_based_motion::Runner;
using time_based_motion::Schedule;
using time_based_motion::Ship;
using time_based_motion::step_time;
using time_based_motion::Wrapped;
using namespace time_based_motion::subject; // fly, tick, ... seen_at: the student's

namespace {

// Nine digits will do. Where something is exactly due, or exactly at an end, a test has numbers that a computer keeps
// exactly, such as 1/64, or 12/120 and 1/10, which are one fraction. Elsewhere no test comes near such a border.
constexpr double digits = 1e-9;

/// This number, one of those that a call is given, must be what a clock shows.
template <class Call> void check_refused(double &number, const char *name, const Call &call) {
    const double good = number;
    for (const double bad : {infinity, -infinity, std::nan(""), 1.00001e10, -1.00001e10}) {
        number = bad;
        CHECK_REFUSED(call(), name);
    }
    number = good;
}

} // namespace

// ------------------------------------------------------------------------------------------------------------- 12.1 fly

//> Worked example: a frame of a 60 Hz screen
TEST_CASE("flies 2 px in a frame of 1/60 s, at 120 px/s", "[12.1]") {
    CHECK_THAT(fly({0, 120}, 1.0 / 60), IsNear(Ship{2, 120}, digits)); // 120 px/s * 1/60 s
}

//> A longer frame
TEST_CASE("flies twice as far in a frame that's twice as long", "[12.1]") {
    CHECK_THAT(fly({0, 120}, 1.0 / 30), IsNear(Ship{4, 120}, digits));
    CHECK_THAT(fly({0, 120}, 0.25), IsNear(Ship{30, 120}, digits));
    CHECK_THAT(fly({0, 120}, 0.5), IsNear(Ship{60, 120}, digits));
}

//> From where it is
TEST_CASE("starts from where the ship is, and keeps its speed", "[12.1]") {
    CHECK_THAT(fly({500, 120}, 0.5), IsNear(Ship{560, 120}, digits));
    CHECK_THAT(fly({-500, 40}, 0.25), IsNear(Ship{-490, 40}, digits));
}

//> To the left
TEST_CASE("flies to the left when its speed is negative", "[12.1]") {
    CHECK_THAT(fly({500, -120}, 0.5), IsNear(Ship{440, -120}, digits));
    CHECK_THAT(fly({10, -120}, 0.5), IsNear(Ship{-50, -120}, digits));
}

//> Nowhere
TEST_CASE("stays where it is in a frame of 0 s, and at speed 0", "[12.1]") {
    CHECK_THAT(fly({500, 120}, 0), IsNear(Ship{500, 120}, digits));
    CHECK_THAT(fly({500, 0}, 0.5), IsNear(Ship{500, 0}, digits));
}

//> Across the screen
TEST_CASE("gets across 800 px in 400 frames of 1/60 s, which is 6.667 s", "[12.1]") {
    Ship ship{0, 120};
    for (int frame = 1; frame <= 400; ++frame) ship = fly(ship, 1.0 / 60);
    CHECK_THAT(ship.x, IsNear(800.0, digits).of("x after 400 frames [px]"));
}

namespace {

/// The ship after so many frames of equal lengths, which take so long in all.
Ship flown(Ship ship, int frames, double time) {
    for (int i = 0; i < frames; ++i) ship = fly(ship, time / frames);
    return ship;
}

} // namespace

//> A 144 Hz screen
TEST_CASE("is at 120 px after one second at 144 frames a second, not at 144 px", "[12.1]") {
    CHECK_THAT(flown({0, 120}, 144, 1).x, IsNear(120.0, digits).of("x after 144 frames [px]")); // of 0.8333 px
}

//> A 1000 Hz screen
TEST_CASE("flies 0.12 px a frame at 1000 frames a second, and doesn't stand still", "[12.1]") {
    CHECK_THAT(fly({0, 120}, 0.001), IsNear(Ship{0.12, 120}, digits));
    CHECK_THAT(flown({0, 120}, 1000, 1).x, IsNear(120.0, digits).of("x after 1000 frames [px]"));
}

//> On any screen
TEST_CASE("flies as far in one frame as in 30, 60 or 144 that take as long", "[12.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const Ship ship{dice.real(-500, 500), dice.real(-300, 300)};
        const double time = dice.real(0.1, 1);
        const double once = fly(ship, time).x;
        for (const int frames : {30, 60, 144})
            CHECK_THAT(flown(ship, frames, time).x, IsNear(once, digits).of("x after these frames [px]"));
    }
}

//> Pixels a millisecond
TEST_CASE("flies 0.09 px in 3 ms at 30 px/s: 0.03 px a millisecond", "[12.1]") {
    CHECK_THAT(fly({0, 30}, 0.003), IsNear(Ship{0.09, 30}, digits));
    CHECK_THAT(fly({0, 30}, 1), IsNear(Ship{30, 30}, digits)); // 1000 ms
}

//> There and back
TEST_CASE("comes back to where it was when it flies the other way for as long", "[12.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Ship ship{dice.real(-500, 500), dice.real(-300, 300)};
        const double dt = dice.real(0, 1);
        const double there = fly(ship, dt).x;
        CHECK_THAT(there - ship.x, IsNear(ship.speed * dt, digits).of("how far it flew [px]"));
        CHECK_THAT(fly({there, -ship.speed}, dt).x, IsNear(ship.x, digits).of("x when it's back [px]"));
    }
}

//>
TEST_CASE("rejects a dt that isn't from 0 to 1 s", "[12.1]") {
    for (const double bad : {-1e-9, -0.5, 1.0001, 16.0}) CHECK_REFUSED(fly({0, 120}, bad), "dt isn't from 0 to 1 s");
    CHECK_THAT(fly({1e5, 1e5}, 1), IsNear(Ship{2e5, 1e5}, digits)); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------------ 12.2 tick

//> Worked example: an ordinary frame
TEST_CASE("makes a frame 0.125 s long when the clock showed 7 s and shows 7.125 s", "[12.2]") {
    CHECK_THAT(tick({true, 7, 0, 0}, 7.125), IsNear(Clock{true, 7.125, 0.125, 0}, digits));
}

//> Ordinary frames
TEST_CASE("makes each frame as long as what passed since the one before", "[12.2]") {
    Clock clock{true, 100, 0.2, 0};
    for (const double dt : {0.016, 0.033, 0.007, 0.1, 0.0, 0.24}) {
        clock = tick(clock, clock.last + dt);
        CHECK_THAT(clock.dt, IsNear(dt, digits).of("dt [s]"));
    }
}

//> Nothing is forgotten
TEST_CASE("keeps what was skipped before, in a frame that skips nothing", "[12.2]") {
    CHECK_THAT(tick({true, 40, 0.25, 3.5}, 40.0625), IsNear(Clock{true, 40.0625, 0.0625, 3.5}, digits));
}

//> The first frame
TEST_CASE("makes the first frame 0 s long, on a machine that was switched on a day ago", "[12.2]") {
    CHECK_THAT(tick({}, 86400), IsNear(Clock{true, 86400, 0, 0}, digits));
    CHECK_THAT(tick({}, 0.1), IsNear(Clock{true, 0.1, 0, 0}, digits));
    CHECK_THAT(tick({}, -5), IsNear(Clock{true, -5, 0, 0}, digits));
    CHECK_THAT(tick({}, 0), IsNear(Clock{true, 0, 0, 0}, digits));
    CHECK_THAT(tick({false, 5, 0.1, 2}, 5.125), IsNear(Clock{true, 5.125, 0, 2}, digits)); // there was none before
}

//> The second frame
TEST_CASE("makes the second frame as long as what passed since the first", "[12.2]") {
    const Clock first = tick({}, 86400);
    CHECK_THAT(tick(first, 86400.125), IsNear(Clock{true, 86400.125, 0.125, 0}, digits));
    CHECK_THAT(tick({true, 0, 0, 0}, 0.125), IsNear(Clock{true, 0.125, 0.125, 0}, digits));
}

//> A clock that's set back
TEST_CASE("makes a frame 0 s long, and skips nothing, when the clock goes back by an hour", "[12.2]") {
    CHECK_THAT(tick({true, 5000, 0.016, 1}, 1400), IsNear(Clock{true, 1400, 0, 1}, digits));
    CHECK_THAT(tick({true, 5000, 0.016, 0}, 4999.9), IsNear(Clock{true, 4999.9, 0, 0}, digits));
}

//> And goes on
TEST_CASE("goes on from the new time after the clock went back", "[12.2]") {
    const Clock back = tick({true, 5000, 0.016, 1}, 1400);
    CHECK_THAT(tick(back, 1400.125), IsNear(Clock{true, 1400.125, 0.125, 1}, digits));
}

//> A tab that slept
TEST_CASE("makes a frame 0.25 s long and skips 1.75 s, when 2 s passed", "[12.2]") {
    CHECK_THAT(tick({true, 30, 0.016, 0}, 32), IsNear(Clock{true, 32, 0.25, 1.75}, digits));
    CHECK_THAT(tick({true, 30, 0.016, 5}, 32), IsNear(Clock{true, 32, 0.25, 6.75}, digits)); // 5 s before
}

//> The longest frame
TEST_CASE("skips nothing when exactly 0.25 s passed, and a hair when it's a hair more", "[12.2]") {
    CHECK_THAT(tick({true, 30, 0, 2}, 30.25), IsNear(Clock{true, 30.25, 0.25, 2}, digits));
    CHECK_THAT(tick({true, 30, 0, 2}, 30.25 + 1.0 / 1024),
               IsNear(Clock{true, 30.25 + 1.0 / 1024, 0.25, 2 + 1.0 / 1024}, digits));
}

//> All three
TEST_CASE("takes 0 s, 0.25 s, 0 s and 0.1 s when the clock shows 100, 102, 101 and 101.1 s", "[12.2]") {
    Clock clock;
    clock = tick(clock, 100);
    CHECK_THAT(clock, IsNear(Clock{true, 100, 0, 0}, digits).of("at 100 s"));
    clock = tick(clock, 102);
    CHECK_THAT(clock, IsNear(Clock{true, 102, 0.25, 1.75}, digits).of("at 102 s"));
    clock = tick(clock, 101);
    CHECK_THAT(clock, IsNear(Clock{true, 101, 0, 1.75}, digits).of("at 101 s"));
    clock = tick(clock, 101.1);
    CHECK_THAT(clock, IsNear(Clock{true, 101.1, 0.1, 1.75}, digits).of("at 101.1 s"));
}

//> Erratum E12.1
TEST_CASE("erratum E12.1: counts drawing, too: 5 ms of work and 28.333 ms of it fly 300 px in 10 s, not 45 px",
          "[12.2]") {
    const double work = 0.005, drawing = 0.085 / 3; // 33.333 ms a frame, at 30 px/s
    Clock clock{true, 100, 0, 0};
    double x = 0;
    for (int frame = 1; frame <= 300; ++frame) {
        clock = tick(clock, 100 + frame * (work + drawing));
        x += 30 * clock.dt;
    }
    CHECK_THAT(x, IsNear(300.0, digits).of("x after 300 frames, at 30 px/s [px]"));
    CHECK_THAT(300 * work * 30, IsNear(45.0, digits).of("x, if the work alone counted [px]"));
}

//> What the game did, and what it skipped
TEST_CASE("accounts for all the time: frames and skipped time add up to what passed", "[12.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const double start = dice.real(-1000, 1000);
        Clock clock{true, start, 0.1, 0};
        double played = 0;
        for (int frame = 0; frame < 20; ++frame) {
            clock = tick(clock, clock.last + (dice.whole(0, 3) == 0 ? dice.real(0, 9) : dice.real(0, 0.25)));
            CHECK_THAT(clock.dt, IsAtMost(0.25).of("dt [s]"));
            CHECK_THAT(clock.dt, IsAtLeast(0).of("dt [s]"));
            played += clock.dt;
            CHECK_THAT(played + clock.skipped,
                       IsNear(clock.last - start, digits).of("all frames and skipped time [s]"));
        }
    }
}

//>
TEST_CASE("rejects a clock, or a time, beyond ±1e10 s", "[12.2]") {
    Clock clock{true, 7, 0.125, 1};
    double now = 7.5;
    const auto ask = [&] { tick(clock, now); };
    check_refused(clock.last, "clock.last", ask);
    check_refused(clock.dt, "clock.dt", ask);
    check_refused(clock.skipped, "clock.skipped", ask);
    check_refused(now, "now", ask);
    CHECK_THAT(tick({true, -1e5, 0, 0}, 1e5), IsNear(Clock{true, 1e5, 0.25, 199999.75}, digits)); // good input
}

// ------------------------------------------------------------------------------------------------------- 12.3 due_steps

//> Worked example: not enough for a step
TEST_CASE("takes no step of 20 ms when a 10 ms frame comes to 5 ms, and keeps 15 ms", "[12.3]") {
    CHECK_THAT(due_steps(0.005, 0.01, 0.02), IsNear(Due{0, 0.015}, digits));
}

//> 64 Hz
TEST_CASE("takes one step of 1/64 s in each frame of a 64 Hz screen, and keeps what it had", "[12.3]") {
    CHECK_THAT(due_steps(0, 1.0 / 64, 1.0 / 64), IsNear(Due{1, 0}, digits));
    CHECK_THAT(due_steps(1.0 / 256, 1.0 / 64, 1.0 / 64), IsNear(Due{1, 1.0 / 256}, digits));
}

//> Worked example: two steps
TEST_CASE("takes two steps of 20 ms when a 40 ms frame comes to 5 ms, and keeps 5 ms", "[12.3]") {
    CHECK_THAT(due_steps(0.005, 0.04, 0.02), IsNear(Due{2, 0.005}, digits).since("5 + 40 = 45 = 2 · 20 + 5 ms"));
}

//> Sixteen steps
TEST_CASE("takes 16 steps of 1/64 s in a frame of 0.25 s", "[12.3]") {
    CHECK_THAT(due_steps(0, 0.25, 1.0 / 64), IsNear(Due{16, 0}, digits));
    CHECK_THAT(due_steps(1.0 / 128, 0.25, 1.0 / 64), IsNear(Due{16, 1.0 / 128}, digits));
}

//> Exactly due
TEST_CASE("takes a step that's exactly due, and none that's a hair too early", "[12.3]") {
    CHECK_THAT(due_steps(0.25, 0.25, 0.5), IsNear(Due{1, 0}, digits));
    CHECK_THAT(due_steps(0.25, 0.25 - 1.0 / 1024, 0.5), IsNear(Due{0, 0.5 - 1.0 / 1024}, digits));
    CHECK_THAT(due_steps(0.5, 1, 0.5), IsNear(Due{3, 0}, digits));
    CHECK_THAT(due_steps(1, 1, 1), IsNear(Due{2, 0}, digits));
}

//> Nothing came
TEST_CASE("keeps what was left in a frame of 0 s, or takes the steps that were left", "[12.3]") {
    CHECK_THAT(due_steps(0, 0, 0.02), IsNear(Due{0, 0}, digits));
    CHECK_THAT(due_steps(0.015, 0, 0.02), IsNear(Due{0, 0.015}, digits));
    CHECK_THAT(due_steps(0.5, 0, 0.125), IsNear(Due{4, 0}, digits));
}

//> Nothing was left
TEST_CASE("takes seven steps of 20 ms in a frame of 150 ms, when nothing was left, and keeps 10 ms", "[12.3]") {
    CHECK_THAT(due_steps(0, 0.15, 0.02), IsNear(Due{7, 0.01}, digits));
}

namespace {

/// Steps of 1/64 s in so many frames of equal lengths, which take one second. It starts half a step early, so that no step
/// falls due exactly at the end of a frame.
struct Second {
    int steps = 0, frames_without = 0;
    double spare = 1.0 / 128;
};
Second second_of(int frames) {
    Second all;
    for (int i = 0; i < frames; ++i) {
        const Due due = due_steps(all.spare, 1.0 / frames, 1.0 / 64);
        all.steps += due.steps;
        all.spare = due.spare;
        if (due.steps == 0) ++all.frames_without;
    }
    return all;
}

} // namespace

//> 144 Hz and 64 steps
TEST_CASE("takes 64 steps of 1/64 s in a second of 144 frames, and none in 80 of them", "[12.3]") {
    const Second all = second_of(144);
    CHECK_THAT(all.steps, IsNear(64).of("steps"));
    CHECK_THAT(all.frames_without, IsNear(80).of("frames without a step")); // 144 - 64
}

//> Steps on any screen
TEST_CASE("takes 64 steps a second on every screen, from 10 to 1000 frames a second", "[12.3]") {
    for (const int frames : {10, 30, 60, 144, 240, 1000}) {
        const Second all = second_of(frames);
        CHECK_THAT(all.steps, IsNear(64).of("steps in a second of " + std::to_string(frames) + " frames"));
        CHECK_THAT(all.spare, IsNear(1.0 / 128, digits).of("what's left of it [s]"));
    }
}

//> Nothing is lost
TEST_CASE("loses no time: the steps and the new spare time add up to the old spare time and the frame", "[12.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double step = dice.real(0.005, 0.2), spare = step * dice.real(0, 1), dt = dice.real(0, 1);
        const double off = std::remainder(spare + dt, step);
        if (std::abs(off) < 1e-7) continue; // a border
        const Due due = due_steps(spare, dt, step);
        CHECK_THAT(due.steps * step + due.spare, IsNear(spare + dt, digits).of("steps and what's left [s]"));
        CHECK_THAT(due.spare, IsBelow(step).of("what's left [s]"));
        CHECK_THAT(due.spare, IsAtLeast(0).of("what's left [s]"));
    }
}

//> Frame after frame
TEST_CASE("takes as many steps in many frames of any length as fit into all their time", "[12.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const double step = dice.real(0.005, 0.05);
        double time = 0, spare = 0;
        int steps = 0;
        for (int frame = 0; frame < 50; ++frame) {
            const double dt = dice.real(0, 0.1);
            time += dt;
            const Due due = due_steps(spare, dt, step);
            spare = due.spare;
            steps += due.steps;
            if (std::abs(std::remainder(time, step)) < 1e-7) continue; // a border
            CHECK_THAT(steps, IsNear(int(std::floor(time / step))).of("steps in all these frames"));
        }
    }
}

//> Many steps
TEST_CASE("takes 1000 steps of 1 ms in a frame of 1 s", "[12.3]") {
    CHECK_THAT(due_steps(0.0005, 1, 0.001), IsNear(Due{1000, 0.0005}, digits));
}

//>
TEST_CASE("rejects a spare time or a dt that isn't from 0 to 1 s, and a step below 0.001 s", "[12.3]") {
    for (const double bad : {-1e-9, -0.5, 1.0001}) {
        CHECK_REFUSED(due_steps(bad, 0.04, 0.02), "spare isn't from 0 to 1 s");
        CHECK_REFUSED(due_steps(0.005, bad, 0.02), "dt isn't from 0 to 1 s");
    }
    for (const double bad : {0.0, -0.02, 0.0009, 1.0001})
        CHECK_REFUSED(due_steps(0.005, 0.04, bad), "a step isn't from 0.001 to 1 s");
    due_steps(1, 1, 0.0010001); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 12.4 next_frame

namespace {

/// A game that runs since the machine's clock showed 0 s.
Game running() { return {{true, 0, 0, 0}, 0, {}, {}, false, {0, 0}}; }

/// How high the runner is so many steps after it left the ground [m]. Its velocity was 6 - 16/64 m/s in the first step, and
/// lost 16/64 m/s in each one more.
double height_after(int steps) {
    return steps >= 0 && steps <= 47 ? (24 * steps - steps * (steps + 1) / 2) / 256.0 : 0;
}

/// A game on a screen of so many frames a second, with one frame more at each moment when jump is pressed. Nothing happens
/// exactly when a step is due, if those moments and the end are halfway between two steps.
Game played(int frames, const std::vector<double> &presses, double until) {
    std::vector<std::pair<double, bool>> moments;
    for (int i = 1; i < until * frames; ++i) moments.emplace_back(double(i) / frames, false);
    for (const double press : presses) moments.emplace_back(press, true);
    std::sort(moments.begin(), moments.end());
    Game game = running();
    for (const auto &[seconds, jump] : moments) game = next_frame(game, seconds, jump);
    return next_frame(game, until, false);
}

} // namespace

//> Worked example: one step
TEST_CASE("takes one step in a frame of 1/64 s, and shows where the runner was before it", "[12.4]") {
    const Game then = next_frame(running(), 1.0 / 64, false);
    CHECK_THAT(then, IsNear(Game{{true, 1.0 / 64, 1.0 / 64, 0}, 0, {}, {{6.0 / 64, 0}, 0}, false, {0, 0}}, digits));
}

//> Between two steps
TEST_CASE("shows the runner halfway between its last two places when half a step is left", "[12.4]") {
    const Game then = next_frame(running(), 3.0 / 128, false);
    CHECK_THAT(then.spare, IsNear(1.0 / 128, digits).of("spare [s]"));
    CHECK_THAT(then.shown, IsNear(Vec2{3.0 / 64, 0}, digits).of("shown [m]")); // between 0 and 6/64 m
}

//> The first frame of a game
TEST_CASE("takes no step in the first frame, whatever the machine's clock shows", "[12.4]") {
    CHECK_THAT(next_frame({}, 5000, false), IsNear(Game{{true, 5000, 0, 0}, 0, {}, {}, false, {0, 0}}, digits));
    CHECK_THAT(next_frame({}, 5000, true),
               IsNear(Game{{true, 5000, 0, 0}, 0, {}, {}, true, {0, 0}}, digits)); // it waits
}

//> Three steps
TEST_CASE("takes three steps in a frame of 3/64 s, and jumps in the first of them", "[12.4]") {
    const Game then = next_frame(running(), 3.0 / 64, true);
    CHECK_THAT(then.now, IsNear(Runner{{18.0 / 64, height_after(3)}, 5.25}, digits).of("now"));
    CHECK_THAT(then.before, IsNear(Runner{{12.0 / 64, height_after(2)}, 5.5}, digits).of("before"));
    CHECK_THAT(then.shown, IsNear(then.before.place, digits).of("shown [m]"));
}

//> A press that has to wait
TEST_CASE("keeps a press that comes in a frame without a step, until there's one", "[12.4]") {
    const Game waits = next_frame(running(), 1.0 / 256, true);
    CHECK_THAT(waits.jump_waits, IsTrue("the press waits"));
    CHECK_THAT(waits.now, IsNear(Runner{}, digits).of("now, without a step"));
    CHECK_THAT(next_frame(waits, 2.0 / 256, true).jump_waits, IsTrue("it waits when jump is pressed again, too"));
    const Game still = next_frame(waits, 2.0 / 256, false);
    CHECK_THAT(still.jump_waits, IsTrue("the press still waits after another frame without a step"));
    const Game jumps = next_frame(still, 5.0 / 256, false);
    CHECK_THAT(jumps.now, IsNear(Runner{{6.0 / 64, height_after(1)}, 5.75}, digits).of("now, with a step"));
    CHECK_THAT(jumps.jump_waits, IsNear(false).of("whether the press still waits"));
}

//> One press
TEST_CASE("counts one press once, even when three steps are due", "[12.4]") {
    Game falling = running();
    falling.now = {{0, 1.0 / 256}, -6}; // lands in the first of them, which gets the press
    const Game then = next_frame(falling, 3.0 / 64, true);
    CHECK_THAT(then.now, IsNear(Runner{{18.0 / 64, 0}, 0}, digits).of("now"));
    CHECK_THAT(then.jump_waits, IsNear(false).of("whether the press still waits"));
}

//> How high
TEST_CASE("jumps 69/64 m high, at 30, 64, 144 and 240 frames a second", "[12.4]") {
    for (const int frames : {30, 64, 144, 240}) {
        const Game top = played(frames, {1.0 / 128}, 24.5 / 64); // 24 steps up: from then on, it falls
        CHECK_THAT(top.now.place.y(), IsNear(69.0 / 64).of("height after 24 steps [m]"));
        CHECK_THAT(top.now.climb, IsNear(0.0).of("velocity upwards after 24 steps [m/s]"));
    }
}

//> The same game
TEST_CASE("plays the same game at 30, 64, 144 and 240 frames a second, to the last bit", "[12.4]") {
    // jumps in step 1; a press in the air doesn't count; jumps again in step 65, and is on its way down in step 100
    const std::vector<double> presses{1.0 / 128, 20.5 / 64, 64.5 / 64};
    for (const int frames : {30, 64, 144, 240}) {
        const Game then = played(frames, presses, 100.5 / 64);
        CHECK_THAT(then.now, IsNear(Runner{{600.0 / 64, height_after(36)}, -3}).of("now"));
        CHECK_THAT(then.before, IsNear(Runner{{594.0 / 64, height_after(35)}, -2.75}).of("before"));
    }
}

//> One step late
TEST_CASE("shows the runner one step behind the clock, in every frame", "[12.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(200); ++i) {
        Game game = running();
        for (int frame = 0; frame < 50; ++frame) {
            game = next_frame(game, game.clock.last + dice.real(0, 0.05), dice.whole(0, 5) == 0);
            const double x = std::max(0.0, 6 * (game.clock.last - step_time)); // at 6 m/s, since 0 s
            CHECK_THAT(game.shown.x(), IsNear(x, digits).of("x that's shown [m]"));
        }
    }
}

//> In a frame without a step
TEST_CASE("moves on by 1/24 m in each frame at 144 frames a second, with and without a step", "[12.4]") {
    Game game = next_frame(running(), 3.0 / 128, false); // at 6 m/s: 6 m in 144 frames
    for (int frame = 1; frame <= 144; ++frame) {
        const double x = game.shown.x();
        game = next_frame(game, 3.0 / 128 + frame / 144.0, false);
        CHECK_THAT(game.shown.x() - x, IsNear(1.0 / 24, digits).of("how far it's moved on the screen [m]"));
    }
}

//> Down to the ground
TEST_CASE("never shows the runner below the ground, nor above where it was", "[12.4]") {
    for (const int frames : {50, 150, 1000}) {
        Game game = running();
        for (int frame = 1; frame <= frames; ++frame) {
            game = next_frame(game, double(frame) / frames, frame == 1);
            CHECK_THAT(game.shown.y(), IsAtLeast(-digits).of("height that's shown [m]"));
            CHECK_THAT(
                game.shown.y(),
                IsAtMost(std::max(game.before.place.y(), game.now.place.y()) + digits).of("height that's shown [m]"));
        }
    }
}

//> Two seconds later
TEST_CASE("goes on by 16 steps, 1.5 m, when 2 s passed", "[12.4]") {
    const Game then = next_frame(running(), 2, false);
    CHECK_THAT(then.clock, IsNear(Clock{true, 2, 0.25, 1.75}, digits).of("clock"));
    CHECK_THAT(then.now, IsNear(Runner{{1.5, 0}, 0}, digits).of("now"));
    Game late = running();
    late.spare = 0.01; // what was left before a long frame is still left after it
    late = next_frame(late, 0.25 + late.clock.last, false);
    CHECK_THAT(late.spare, IsNear(0.01, digits).of("spare [s]"));
    CHECK_THAT(late.shown.x() - late.before.place.x(), IsNear(0.01 * 6, digits).of("how far along it's shown [m]"));
}

//> Back by an hour
TEST_CASE("stands still in a frame in which the machine's clock goes back", "[12.4]") {
    const Game game = played(144, {1.0 / 128}, 20.5 / 64);
    Game want = game;
    want.clock = {true, 0.1, 0, 0};
    CHECK_THAT(next_frame(game, 0.1, false), IsNear(want, digits));
}

//>
TEST_CASE("rejects a spare time that isn't from 0 to 1 s, and what no clock shows", "[12.4]") {
    Game game = running();
    for (const double bad : {-1e-9, 1.0001}) {
        game.spare = bad;
        CHECK_REFUSED(next_frame(game, 0.1, false), "spare isn't from 0 to 1 s");
    }
    game = running();
    double seconds = 0.1;
    const auto ask = [&] { next_frame(game, seconds, false); };
    check_refused(game.clock.last, "game.clock.last", ask);
    check_refused(game.clock.dt, "game.clock.dt", ask);
    check_refused(game.clock.skipped, "game.clock.skipped", ask);
    check_refused(seconds, "seconds", ask);
    game.spare = 1;
    next_frame(game, 0.1, true); // good input is still answered
}

// ---------------------------------------------------------------------------------------------------------- 12.5 follow

namespace {

/// What's left of one metre after one second, in so many frames.
double left_after_a_second(int frames, double half_life) {
    Vec2 camera{1, 0};
    for (int i = 0; i < frames; ++i) camera = follow(camera, {0, 0}, half_life, 1.0 / frames);
    return camera.x();
}

} // namespace

//> Worked example: one half-life
TEST_CASE("moves 4 m of 8 m in 0.2 s, with a 0.2 s half-life", "[12.5]") {
    CHECK_THAT(follow({0, 0}, {8, 0}, 0.2, 0.2), IsNear(Vec2{4, 0}, digits));
    CHECK_THAT(follow({0.004, 0}, {0, 0}, 0.2, 0.2), IsNear(Vec2{0.002, 0}, digits)); // the last millimetres, too
}

//> Worked example: two and three
TEST_CASE("leaves 2 m of 8 m after two half-lives, and 1 m after three", "[12.5]") {
    CHECK_THAT(follow({0, 0}, {8, 0}, 0.2, 0.4), IsNear(Vec2{6, 0}, digits));
    CHECK_THAT(follow({0, 0}, {8, 0}, 0.2, 0.6), IsNear(Vec2{7, 0}, digits));
}

//> Half a half-life
TEST_CASE("leaves 1/√2 of the way after half a half-life, since two of them leave 1/2", "[12.5]") {
    CHECK_THAT(follow({8, 0}, {0, 0}, 0.2, 0.1), IsNear(Vec2{8 / std::sqrt(2), 0}, digits));
}

//> From any side
TEST_CASE("comes from any side: from (3, -4) it's halfway to (-1, 4) at (1, 0)", "[12.5]") {
    CHECK_THAT(follow({3, -4}, {-1, 4}, 0.5, 0.5), IsNear(Vec2{1, 0}, digits));
    CHECK_THAT(follow({-1, 4}, {3, -4}, 0.5, 1), IsNear(Vec2{2, -2}, digits)); // three quarters of the way
}

//> No time
TEST_CASE("stays where it is in a frame of 0 s", "[12.5]") {
    CHECK_THAT(follow({3, -4}, {-1, 4}, 0.5, 0), IsNear(Vec2{3, -4}, digits));
}

//> There
TEST_CASE("stays at its target, once it's there", "[12.5]") {
    CHECK_THAT(follow({3, -4}, {3, -4}, 0.5, 0.25), IsNear(Vec2{3, -4}, digits));
    CHECK_THAT(follow({0, 0}, {0, 0}, 0.1, 1), IsNear(Vec2{0, 0}, digits));
}

//> Erratum E12.2
TEST_CASE("erratum E12.2: leaves the same in 30 frames as in 60, where 0.99 a frame leaves 0.740 and 0.547", "[12.5]") {
    CHECK_THAT(std::pow(0.99, 30), IsNear(0.7397, 1e-4).of("0.99, thirty times"));
    CHECK_THAT(std::pow(0.99, 60), IsNear(0.5472, 1e-4).of("0.99, sixty times, not half of that"));
    const double half_life = std::log(0.5) / (60 * std::log(0.99)); // of 0.99 a frame at 60 frames a second
    for (const int frames : {30, 60, 144})
        CHECK_THAT(left_after_a_second(frames, half_life),
                   IsNear(std::pow(0.99, 60), digits).of("what's left of 1 m [m]"));
}

//> Two frames for one
TEST_CASE("gets as far in frames of any length as in one that takes as long", "[12.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 start = dice.point(-9, 9), target = dice.point(-9, 9);
        const double half_life = dice.real(0.02, 2);
        Vec2 camera = start;
        double time = 0;
        for (int frame = 0; frame < 5; ++frame) {
            const double dt = dice.real(0, 0.2);
            camera = follow(camera, target, half_life, dt);
            time += dt;
        }
        CHECK_THAT(follow(start, target, half_life, time), IsNear(camera, digits));
    }
}

//> Straight there
TEST_CASE("goes straight to its target, and never past it", "[12.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 camera = dice.point(-9, 9), target = dice.point(-9, 9);
        const Vec2 then = follow(camera, target, dice.real(0.02, 2), dice.real(0, 1));
        const double way = (then - camera).norm(), left = (target - then).norm();
        CHECK_THAT(way + left, IsNear((target - camera).norm(), digits).of("the way to it and on to the target [m]"));
    }
}

//> Somewhere else
TEST_CASE("moves along when camera and target are moved by the same arrow", "[12.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 camera = dice.point(-9, 9), target = dice.point(-9, 9), arrow = dice.point(-99, 99);
        const double half_life = dice.real(0.02, 2), dt = dice.real(0, 1);
        const Vec2 here = follow(camera, target, half_life, dt);
        CHECK_THAT(follow(camera + arrow, target + arrow, half_life, dt), IsNear(Vec2{here + arrow}, digits));
    }
}

//> Very short, and very long
TEST_CASE("is at its target after a thousand half-lives, and hardly moves in a thousandth of one", "[12.5]") {
    CHECK_THAT(follow({3, -4}, {-1, 4}, 0.001, 1), IsNear(Vec2{-1, 4}, digits));
    CHECK_THAT(follow({1e5, 1e5}, {-1e5, -1e5}, 0.001, 1), IsNear(Vec2{-1e5, -1e5}, digits));
    const double ln2 = 0.69314718056; // 2^-x is nearly 1 - x ln 2, if x is small
    CHECK_THAT(follow({1, 0}, {0, 0}, 1e5, 1).x(), IsNear(1 - 1e-5 * ln2 + 2.4e-11, digits).of("x [m]"));
    CHECK_THAT(follow({1, 0}, {0, 0}, 100, 0.1).x(), IsNear(1 - 1e-3 * ln2 + 2.4e-7, digits).of("x [m]"));
}

//>
TEST_CASE("rejects a half-life below 0.001 s, and a dt that isn't from 0 to 1 s", "[12.5]") {
    for (const double bad : {0.0, -0.5, 0.0009})
        CHECK_REFUSED(follow({3, -4}, {-1, 4}, bad, 0.25), "half-life below 0.001 s");
    for (const double bad : {-1e-9, 1.0001})
        CHECK_REFUSED(follow({3, -4}, {-1, 4}, 0.5, bad), "dt isn't from 0 to 1 s");
    follow({3, -4}, {-1, 4}, 0.0010001, 1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------------ 12.6 wrap

//> Worked example: 10 px beyond
TEST_CASE("is at 10 px after 795 px and 0.3 s at 50 px/s, and flew over the end 0.2 s ago", "[12.6]") {
    CHECK_THAT(wrap({795, 50}, 800, 0.3),
               IsNear(Wrapped{{10, 50}, 1, 0.2}, digits)
                   .since("795 + 50 · 0.3 = 810, which is 10 px into the next lap, and these took 10 / 50 s"));
}

//> Not yet
TEST_CASE("flies on to 795 px, and over no end, from 780 px", "[12.6]") {
    CHECK_THAT(wrap({780, 50}, 800, 0.3), IsNear(Wrapped{{795, 50}, 0, 0}, digits));
    CHECK_THAT(wrap({0, 50}, 800, 0.3), IsNear(Wrapped{{15, 50}, 0, 0}, digits));
}

//> Exactly at the end
TEST_CASE("is at 0 px, one lap on, when it gets exactly to the end", "[12.6]") {
    CHECK_THAT(wrap({750, 50}, 800, 1), IsNear(Wrapped{{0, 50}, 1, 0}, digits));
    CHECK_THAT(wrap({6, 8}, 16, 0.25), IsNear(Wrapped{{8, 8}, 0, 0}, digits)); // halfway isn't the end
    CHECK_THAT(wrap({0, 16}, 4, 0.75), IsNear(Wrapped{{0, 16}, 3, 0}, digits));
}

//> Several laps
TEST_CASE("flies two laps in one frame, and says how long ago the last one ended", "[12.6]") {
    CHECK_THAT(wrap({1, 10}, 4, 1), IsNear(Wrapped{{3, 10}, 2, 0.3}, digits).since("1 + 10 · 1 = 11 = 2 · 4 + 3"));
}

//> No lap
TEST_CASE("stays where it is at speed 0, and in a frame of 0 s", "[12.6]") {
    CHECK_THAT(wrap({799, 0}, 800, 1), IsNear(Wrapped{{799, 0}, 0, 0}, digits));
    CHECK_THAT(wrap({0, 0}, 800, 0.5), IsNear(Wrapped{{0, 0}, 0, 0}, digits));
    CHECK_THAT(wrap({799, 50}, 800, 0), IsNear(Wrapped{{799, 50}, 0, 0}, digits));
}

//> On a slow machine
TEST_CASE("ends its lap after 16 s in frame 54 of 0.3 s, not after 54 frames, which are 16.2 s", "[12.6]") {
    Ship ship{0, 50};
    for (int frame = 1; frame <= 54; ++frame) {
        const Wrapped then = wrap(ship, 800, 0.3);
        CHECK_THAT(then.laps, IsNear(frame == 54 ? 1 : 0).of("laps in frame " + std::to_string(frame)));
        if (frame == 54) CHECK_THAT(54 * 0.3 - then.since, IsNear(16.0, digits).of("when it flew over the end [s]"));
        ship = then.ship;
    }
}

//> On any machine
TEST_CASE("takes 16 s a lap in frames of 10, 33, 100, 300 and 700 ms", "[12.6]") {
    for (const double dt : {0.01, 0.033, 0.1, 0.3, 0.7}) {
        Ship ship{1.23, 50}; // it's at the end after 15.9754 s: never exactly in one of these frames
        double want = 15.9754;
        for (int frame = 1; want < 50; ++frame) {
            const Wrapped then = wrap(ship, 800, dt);
            ship = then.ship;
            if (then.laps == 0 && frame * dt < want) continue;
            CHECK_THAT(frame * dt - then.since, IsNear(want, digits).of("when it flew over the end [s]"));
            want += 16;
        }
    }
}

namespace {

/// A ship on a track, and a frame: it's nowhere near an end, then.
struct Lap {
    Ship ship;
    double length, dt;
};
Lap lap(Dice &dice) {
    for (;;) {
        const double length = dice.real(1, 900);
        const Lap any{{length * dice.real(0, 1), dice.real(1, 3000)}, length, dice.real(0, 1)};
        if (std::abs(std::remainder(any.ship.x + any.dt * any.ship.speed, length)) > 1e-6) return any;
    }
}

} // namespace

//> Laps and the rest
TEST_CASE("loses nothing that it flew: its laps and its x add up to where it was and how far it flew", "[12.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const auto [ship, length, dt] = lap(dice);
        const Wrapped then = wrap(ship, length, dt);
        CHECK_THAT(then.laps * length + then.ship.x,
                   IsNear(ship.x + ship.speed * dt, digits).of("laps times length, and x [px]"));
        CHECK_THAT(then.ship.x, IsBelow(length).of("x [px]"));
        CHECK_THAT(then.ship.x, IsAtLeast(0).of("x [px]"));
        CHECK_THAT(then.ship.speed, IsNear(ship.speed, digits).of("speed [px/s]"));
    }
}

//> When it was
TEST_CASE("was exactly at an end as long ago as it says", "[12.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const auto [ship, length, dt] = lap(dice);
        const Wrapped then = wrap(ship, length, dt);
        if (then.laps == 0) {
            CHECK_THAT(then.since, IsNear(0.0, digits).of("since, without a lap [s]"));
            continue;
        }
        const double from_start = ship.x + ship.speed * (dt - then.since); // on a track that goes on
        CHECK_THAT(from_start,
                   IsNear(then.laps * length, digits).of("how far it was from the start, that long ago [px]"));
    }
}

//> Ten frames for one
TEST_CASE("gets to the same place, with as many laps, in ten frames as in one that takes as long", "[12.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const auto [ship, length, dt] = lap(dice);
        const Wrapped once = wrap(ship, length, dt);
        Ship now = ship;
        int laps = 0;
        bool border = false;
        for (int frame = 1; frame <= 10; ++frame) {
            border = std::abs(std::remainder(ship.x + frame * dt / 10 * ship.speed, length)) < 1e-6;
            if (border) break;
            const Wrapped then = wrap(now, length, dt / 10);
            now = then.ship;
            laps += then.laps;
        }
        if (border) continue;
        CHECK_THAT(now.x, IsNear(once.ship.x, digits).of("x after ten frames [px]"));
        CHECK_THAT(laps, IsNear(once.laps).of("laps in ten frames"));
    }
}

//> A short track
TEST_CASE("flies 100,000 laps of a 1 px track in a second", "[12.6]") {
    CHECK_THAT(wrap({0.5, 1e5}, 1, 1), IsNear(Wrapped{{0.5, 1e5}, 100000, 5e-6}, digits));
}

//> From the very end
TEST_CASE("starts anywhere on the track, as near to the end as there's a number", "[12.6]") {
    CHECK_THAT(wrap({std::nextafter(800.0, 0.0), 50}, 800, 0.3), IsNear(Wrapped{{15, 50}, 1, 0.3}, digits));
    CHECK_THAT(wrap({0, 50}, 800, 1), IsNear(Wrapped{{50, 50}, 0, 0}, digits));
}

//>
TEST_CASE("rejects a track below 1 px, a ship off the track or flying left, and a bad dt", "[12.6]") {
    for (const double bad : {0.0, 0.999, -800.0}) CHECK_REFUSED(wrap({0, 50}, bad, 0.3), "a track below 1 px");
    for (const double bad : {800.0, 801.0, -1e-9})
        CHECK_REFUSED(wrap({bad, 50}, 800, 0.3), "a ship that isn't on the track");
    CHECK_REFUSED(wrap({795, -1e-9}, 800, 0.3), "a ship that flies to the left");
    for (const double bad : {-1e-9, 1.0001}) CHECK_REFUSED(wrap({795, 50}, 800, bad), "dt isn't from 0 to 1 s");
    wrap({0, 50}, 1, 1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------- 12.7 run_frame

namespace {

void check_frame(const Schedule &then, double time, double lost, const std::vector<int> &ran,
                 const std::vector<int> &done) {
    CHECK_THAT(then.ran, IsNear(ran).of("ran"));
    CHECK_THAT(then.jobs, HasSize(done.size()).of("jobs"));
    for (std::size_t i = 0; i < done.size(); ++i)
        CHECK_THAT(then.jobs[i].done, IsNear(done[i]).of("jobs[" + std::to_string(i) + "].done"));
    CHECK_THAT(then.time, IsNear(time, digits).of("time [s]"));
    CHECK_THAT(then.lost, IsNear(lost, digits).of("lost [s]"));
}

/// Physics, 4 times a second, costs 3 ms each time; thinking, twice a second, 5 ms.
const std::vector<Job> physics_and_thinking{{4, 0.003, 0}, {2, 0.005, 0}};

} // namespace

//> Worked example: all of it fits
TEST_CASE("runs physics four times in a second and thinking twice, in the order in which they're due", "[12.7]") {
    // physics at 0.25 s and 0.5 s, thinking at 0.5 s, physics at 0.75 s and 1 s, thinking at 1 s
    check_frame(run_frame({0, 0, physics_and_thinking, {}}, 1, 1), 1, 0, {0, 0, 1, 0, 0, 1}, {4, 2});
}

//> Nothing's due
TEST_CASE("goes on, and runs nothing, in a frame in which nothing is due", "[12.7]") {
    check_frame(run_frame({0, 0, physics_and_thinking, {}}, 0.2, 1), 0.2, 0, {}, {0, 0});
    check_frame(run_frame({1, 0.5, {{4, 0.003, 4}, {2, 0.005, 2}}, {0, 1, 1}}, 0.2, 1), 1.2, 0.5, {}, {4, 2});
    check_frame(run_frame({1, 0, {{4, 0.003, 4}}, {0}}, 0, 1), 1, 0, {}, {4});
}

//> Worked example: it doesn't fit
TEST_CASE("stops the game at 0.75 s when the fourth run doesn't fit into 12 ms, and loses 0.25 s", "[12.7]") {
    // physics 3 ms, physics 6 ms, thinking 11 ms, and one more physics would make it 14 ms: that's due at 0.75 s
    for (const double budget : {0.012, 0.0115, 0.0135}) // and 14.5 ms are enough
        check_frame(run_frame({0, 0, physics_and_thinking, {}}, 1, budget), 0.75, 0.25, {0, 0, 1}, {2, 1});
    check_frame(run_frame({0, 0, physics_and_thinking, {}}, 1, 0.0145), 1, 0, {0, 0, 1, 0}, {3, 1});
}

//> The next frame
TEST_CASE("goes on in the next frame where it stopped, and runs what didn't fit first", "[12.7]") {
    const Schedule stopped{0.75, 0.25, {{4, 0.003, 2}, {2, 0.005, 1}}, {0, 0, 1}};
    check_frame(run_frame(stopped, 0.125, 0.012), 0.875, 0.25, {0}, {3, 1});
    check_frame(run_frame(stopped, 0.5, 0.012), 1.25, 0.25, {0, 0, 1}, {4, 2}); // 3 + 3 + 5 ms; 14 don't fit
}

//> As in a list
TEST_CASE("runs what's due at the same moment in the order of the list: 12/120 s and 1/10 s are one", "[12.7]") {
    const std::vector<int> physics_first{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    check_frame(run_frame({0, 0, {{120, 0.001, 0}, {10, 0.001, 0}}, {}}, 0.105, 1), 0.105, 0, physics_first, {12, 1});
    const std::vector<int> thinking_first{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1};
    check_frame(run_frame({0, 0, {{10, 0.001, 0}, {120, 0.001, 0}}, {}}, 0.105, 1), 0.105, 0, thinking_first, {1, 12});
    std::vector<int> second; // the same ten times
    for (int i = 0; i < 10; ++i) second.insert(second.end(), thinking_first.begin(), thinking_first.end());
    check_frame(run_frame({0.002, 0, {{10, 0.001, 0}, {120, 0.001, 0}}, {}}, 1, 1), 1.002, 0, second, {10, 120});
}

//> In order
TEST_CASE("runs four jobs of any rates in the order in which they're due", "[12.7]") {
    struct Moment {
        int count, rate, job;
    };
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        std::vector<Job> jobs;
        for (int job = 0; job < 4; ++job) jobs.push_back({dice.whole(1, 200), 0.0001, 0});
        const double end = dice.real(0.5, 1);
        std::vector<Moment> all;
        std::vector<int> done(4, 0), ran;
        bool border = false;
        for (int job = 0; job < 4; ++job)
            for (int count = 1; count <= 200; ++count) {
                const double due = double(count) / jobs[job].rate;
                if (std::abs(due - end) < 1e-7) border = true;
                if (due < end) all.push_back({count, jobs[job].rate, job}), ++done[job];
            }
        if (border) continue;
        std::stable_sort(all.begin(), all.end(), [](const Moment &one, const Moment &other) {
            return one.count * other.rate < other.count * one.rate; // whole numbers: no rounding
        });
        for (const Moment &each : all) ran.push_back(each.job);
        check_frame(run_frame({0, 0, jobs, {}}, end, 1), end, 0, ran, done);
    }
}

//> One always runs
TEST_CASE("runs one job in each frame, even if that alone is more than the budget", "[12.7]") {
    check_frame(run_frame({0, 0, {{4, 0.5, 0}}, {}}, 0.375, 0.01), 0.375, 0, {0}, {1});
    check_frame(run_frame({0, 0, {{4, 0.5, 0}}, {}}, 0.375, 0), 0.375, 0, {0}, {1});
    check_frame(run_frame({0, 0, {{4, 0.5, 0}}, {}}, 0.875, 0.01), 0.5, 0.375, {0}, {1}); // and no second one
}

//> Exactly
TEST_CASE("fills the budget exactly when it can, and runs what's due exactly at the frame's end", "[12.7]") {
    const std::vector<Job> job{{8, 1.0 / 128, 0}};
    check_frame(run_frame({0, 0, job, {}}, 0.9375, 3.0 / 128), 0.5, 0.4375, {0, 0, 0}, {3});
    check_frame(run_frame({0, 0, job, {}}, 0.375, 3.0 / 128), 0.375, 0, {0, 0, 0}, {3});
    check_frame(run_frame({0, 0, job, {}}, 0.5, 3.0 / 128), 0.5, 0, {0, 0, 0}, {3}); // the fourth one is next
}

//> No overtaking
TEST_CASE("stops at the first job that doesn't fit, even if a cheaper one behind it would", "[12.7]") {
    // due: 0.25 s: 10 ms; 0.5 s: 20 ms; then 5 ms for the second job is too much. The third costs 1 ms.
    const std::vector<Job> jobs{{4, 0.01, 0}, {2, 0.005, 0}, {2, 0.001, 0}};
    check_frame(run_frame({0, 0, jobs, {}}, 1, 0.022), 0.5, 0.5, {0, 0}, {2, 0, 0});
}

//> Never back
TEST_CASE("never turns time back, even if a job that's behind doesn't fit", "[12.7]") {
    // due at 0.25, 0.5, 0.75 s, and so on; it's 1 s already, and two of them fit
    check_frame(run_frame({1, 0, {{4, 0.003, 0}}, {}}, 0.25, 0.007), 1, 0.25, {0, 0}, {2});
    check_frame(run_frame({1, 2, {{4, 0.003, 0}}, {}}, 0.125, 0.5), 1.125, 2, {0, 0, 0, 0}, {4}); // all four fit
}

//> Played and lost
TEST_CASE("accounts for all the time: what the game played and what it lost add up to all frames", "[12.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        Schedule now{0, 0, {{dice.whole(1, 200), dice.real(0.001, 0.02), 0}, {dice.whole(1, 30), 0.005, 0}}, {}};
        double all = 0;
        for (int frame = 0; frame < 20; ++frame) {
            const double dt = dice.real(0, 0.1), before = now.time;
            const int done = now.jobs[0].done + now.jobs[1].done;
            now = run_frame(now, dt, 0.016);
            all += dt;
            CHECK_THAT(now.time + now.lost, IsNear(all, digits).of("played and lost [s]"));
            CHECK_THAT(now.time, IsAtLeast(before).of("time [s]"));
            CHECK_THAT(int(now.ran.size()),
                       IsNear(now.jobs[0].done + now.jobs[1].done - done).of("runs in this frame"));
            double cost = 0;
            for (const int job : now.ran) cost += now.jobs.at(std::size_t(job)).cost;
            if (now.ran.size() > 1) CHECK_THAT(cost, IsAtMost(0.016 + digits).of("what all runs cost [s]"));
        }
    }
}

//> Half speed
TEST_CASE("goes on at half speed when a 12 ms job, 120 times a second, has a budget of 16 ms", "[12.7]") {
    Schedule now{0, 0, {{120, 0.012, 0}}, {}};
    for (int frame = 1; frame <= 60; ++frame) {
        now = run_frame(now, 1.0 / 60, 0.016);
        // one run fits into a frame, and the game stops where the next one is due
        check_frame(now, (frame + 1) / 120.0, (frame - 1) / 120.0, {0}, {frame});
    }
}

//> Eight hours
TEST_CASE("runs 120 times a second even after 8 hours: neither 119 times nor 121", "[12.7]") {
    check_frame(run_frame({28799, 0, {{120, 0.0001, 3455880}}, {}}, 1, 1), 28800, 0, std::vector<int>(120, 0),
                {3456000});
    check_frame(run_frame({28799.999, 0, {{120, 0.0001, 3455999}}, {}}, 0.002, 1), 28800.001, 0, {0}, {3456000});
}

//>
TEST_CASE("rejects an empty list, and a rate, cost, count, dt or budget beyond its limits", "[12.7]") {
    CHECK_REFUSED(run_frame({0, 0, {}, {}}, 0.5, 0.012), "no job");
    for (const int bad : {0, -4, 1001})
        CHECK_REFUSED(run_frame({0, 0, {{4, 0.003, 0}, {bad, 0.003, 0}}, {}}, 0.5, 0.012), "a rate");
    for (const double bad : {0.0, -0.003, 0.00009, 1.0001})
        CHECK_REFUSED(run_frame({0, 0, {{4, bad, 0}}, {}}, 0.5, 0.012), "a cost");
    for (const int bad : {-1, 100000001})
        CHECK_REFUSED(run_frame({0, 0, {{4, 0.003, bad}}, {}}, 0.5, 0.012), "a count");
    for (const double bad : {-1e-9, 1.0001}) {
        CHECK_REFUSED(run_frame({0, 0, physics_and_thinking, {}}, bad, 0.012), "dt isn't from 0 to 1 s");
        CHECK_REFUSED(run_frame({0, 0, physics_and_thinking, {}}, 0.5, bad), "a budget isn't from 0 to 1 s");
    }
    run_frame({0, 0, {{1000, 1, 0}, {1, 1, 100000000}}, {}}, 1, 1); // good input is still answered
}

// --------------------------------------------------------------------------------------------------------- 12.8 seen_at

namespace {

/// So many packets in order, at most 0.3 s apart.
std::vector<Packet> flight(Dice &dice, int count) {
    std::vector<Packet> packets{{dice.real(-5, 5), dice.point(-9, 9)}};
    while (int(packets.size()) < count)
        packets.push_back({packets.back().sent + dice.real(0.02, 0.3), dice.point(-9, 9)});
    return packets;
}
/// The same ones as they may come in.
std::vector<Packet> shuffled(Dice &dice, std::vector<Packet> packets) {
    for (std::size_t i = packets.size(); i > 1; --i)
        std::swap(packets[i - 1], packets[std::size_t(dice.whole(0, int(i) - 1))]);
    return packets;
}
/// A moment between a bit before the first packet and long after the last one is seen.
double moment(Dice &dice, const std::vector<Packet> &in_order) {
    return dice.real(in_order.front().sent - 0.5, in_order.back().sent + 1);
}

} // namespace

//> Worked example: halfway
TEST_CASE("shows the ship halfway between two packets, 0.1 s after it was there", "[12.8]") {
    const std::vector<Packet> packets{{0, {0, 0}}, {1, {10, 4}}};
    CHECK_THAT(seen_at(packets, 0.6), IsNear(Vec2{5, 2}, digits)); // where it was at 0.5 s
}

//> Where they say
TEST_CASE("shows the ship where each packet says, 0.1 s after it was sent", "[12.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const std::vector<Packet> packets = flight(dice, dice.whole(2, 9));
        for (const Packet &packet : packets)
            CHECK_THAT(seen_at(packets, packet.sent + delay), IsNear(packet.place, digits));
    }
}

//> Between two
TEST_CASE("moves the ship straight and steadily from each packet's place to the next", "[12.8]") {
    const std::vector<Packet> waited{{0, {0, 0}}, {1, {0, 0}}, {2, {4, 6}}};
    CHECK_THAT(seen_at(waited, 0.6), IsNear(Vec2{0, 0}, digits));
    CHECK_THAT(seen_at(waited, 1.6), IsNear(Vec2{2, 3}, digits));
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const std::vector<Packet> packets = flight(dice, dice.whole(2, 9));
        const std::size_t at = std::size_t(dice.whole(1, int(packets.size()) - 1));
        const Packet &from = packets[at - 1], &to = packets[at];
        const double part = dice.real(0, 1); // of the time, and of the way
        const Vec2 want = (1 - part) * from.place + part * to.place;
        CHECK_THAT(seen_at(packets, delay + (1 - part) * from.sent + part * to.sent), IsNear(want, 1e-8));
    }
}

//> Before the first one
TEST_CASE("waits where the first packet says, until 0.1 s after that was sent", "[12.8]") {
    const std::vector<Packet> packets{{3, {4, 2}}, {3.1, {5, 2}}, {3.2, {5, 3}}};
    for (const double time : {-1e5, 0.0, 2.9, 3.05, 3.0999})
        CHECK_THAT(seen_at(packets, time), IsNear(Vec2{4, 2}, digits));
}

//> After the last one
TEST_CASE("goes on for 0.25 s after the last packet, as between the last two", "[12.8]") {
    const std::vector<Packet> packets{{3, {4, 2}}, {3.1, {5, 2}}, {3.3, {5, 3}}}; // 5 m/s upwards
    CHECK_THAT(seen_at(packets, 3.5), IsNear(Vec2{5, 3.5}, digits));              // 0.1 s after the last one
    CHECK_THAT(seen_at(packets, 3.6), IsNear(Vec2{5, 4}, digits));
    CHECK_THAT(seen_at(packets, 3.64), IsNear(Vec2{5, 4.2}, digits));
}

//> And waits
TEST_CASE("waits where it got to, when no packet comes for more than 0.25 s", "[12.8]") {
    const std::vector<Packet> packets{{3, {4, 2}}, {3.1, {5, 2}}, {3.3, {5, 3}}};
    for (const double time : {3.65, 3.66, 4.0, 99.0, 1e5})
        CHECK_THAT(seen_at(packets, time), IsNear(Vec2{5, 4.25}, digits));
}

//> One packet
TEST_CASE("shows the ship at its only packet's place, at any time, even if that came twice", "[12.8]") {
    for (const double time : {-9.0, 3.0, 3.1, 3.2, 3.3, 9.0}) {
        CHECK_THAT(seen_at({{3, {4, 2}}}, time), IsNear(Vec2{4, 2}, digits));
        CHECK_THAT(seen_at({{3, {4, 2}}, {3, {4, 2}}}, time), IsNear(Vec2{4, 2}, digits));
    }
}

//> In any order
TEST_CASE("shows the same in whatever order the packets come in", "[12.8]") {
    CHECK_THAT(seen_at({{1, {10, 4}}, {0, {0, 0}}}, 0.6), IsNear(Vec2{5, 2}, digits));
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const std::vector<Packet> packets = flight(dice, dice.whole(2, 9));
        const double time = moment(dice, packets);
        const Vec2 want = seen_at(packets, time);
        CHECK_THAT(seen_at(shuffled(dice, packets), time), IsNear(want, digits));
    }
}

//> Sent twice
TEST_CASE("shows the same when packets come twice, the last one, too", "[12.8]") {
    const std::vector<Packet> twice{{0, {0, 0}}, {1, {10, 4}}, {0, {0, 0}}, {1, {10, 4}}};
    CHECK_THAT(seen_at(twice, 0.6), IsNear(Vec2{5, 2}, digits));
    CHECK_THAT(seen_at(twice, 1.2), IsNear(Vec2{11, 4.4}, digits)); // 0.1 s after the last one
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const std::vector<Packet> packets = flight(dice, dice.whole(2, 9));
        const double time = moment(dice, packets);
        std::vector<Packet> more = packets;
        more.push_back(packets.back());
        for (const Packet &packet : packets)
            if (dice.whole(0, 1) == 0) more.push_back(packet);
        const Vec2 want = seen_at(packets, time);
        CHECK_THAT(seen_at(shuffled(dice, more), time), IsNear(want, digits));
    }
}

//> Lost ones
TEST_CASE("shows a ship that flies straight and steadily where it was, even if packets are lost", "[12.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 start = dice.point(-9, 9), velocity = dice.point(-9, 9);
        std::vector<Packet> packets;
        for (int k = 0; k <= 20; ++k)
            if (k == 0 || k == 20 || dice.whole(0, 1) == 0) packets.push_back({0.1 * k, start + 0.1 * k * velocity});
        const double then = dice.real(0, 2.249); // 0.249 s after the last one
        CHECK_THAT(seen_at(packets, then + delay), IsNear(Vec2{start + then * velocity}, 1e-8));
    }
}

//> No jumps
TEST_CASE("never lets the ship jump: in a ten-thousandth of a second it moves a tiny bit at most", "[12.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const std::vector<Packet> packets = flight(dice, 4);
        double fastest = 0;
        for (std::size_t k = 1; k < 4; ++k)
            fastest = std::max(fastest, (packets[k].place - packets[k - 1].place).norm()
                                            / (packets[k].sent - packets[k - 1].sent));
        std::vector<double> moments{packets.back().sent + delay + longest_guess};
        for (const Packet &packet : packets) moments.push_back(packet.sent + delay);
        for (const double time : moments) {
            const Vec2 before = seen_at(packets, time - 5e-5), after = seen_at(packets, time + 5e-5);
            CHECK_THAT((after - before).norm(), IsAtMost(1e-4 * fastest + 1e-8).of("how far it moves [m]"));
        }
    }
}

//> Elsewhere, and at another time
TEST_CASE("moves along when all places are moved by an arrow, and all times by an hour", "[12.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const std::vector<Packet> packets = flight(dice, dice.whole(1, 9));
        const double time = moment(dice, packets);
        const Vec2 arrow = dice.point(-99, 99), here = seen_at(packets, time);
        std::vector<Packet> moved = packets;
        for (Packet &packet : moved) packet = {packet.sent + 3600, packet.place + arrow};
        CHECK_THAT(seen_at(moved, time + 3600), IsNear(Vec2{here + arrow}, 1e-7)); // hours have fewer digits left
    }
}

//>
TEST_CASE("rejects an empty list, two packets that differ and were sent within 1 ms, and what no clock shows",
          "[12.8]") {
    std::vector<Packet> packets{{3, {4, 2}}, {3.1, {5, 2}}};
    double time = 3.2;
    const auto ask = [&] { seen_at(packets, time); };
    for (Packet &packet : packets) check_refused(packet.sent, "a packet's sent", ask);
    check_refused(time, "time", ask);
    CHECK_REFUSED(seen_at({}, 3.2), "no packet");
    CHECK_REFUSED(seen_at({{3, {4, 2}}, {3, {4, 2.5}}}, 3.2), "two places at one time");
    CHECK_REFUSED(seen_at({{3, {4, 2}}, {3.0005, {5, 2}}}, 3.2), "0.5 ms apart");
    CHECK_REFUSED(seen_at({{3, {4, 2}}, {4, {5, 2}}, {3.0005, {4, 2}}}, 3.2), "0.5 ms apart, not side by side");
    seen_at({{3, {4, 2}}, {3.001, {5, 2}}}, 3.2); // good input is still answered
}
