#pragma once
// The game of this chapter, as it grows: screens, a tab that sleeps, runners, cactuses, cameras, laps, a busy machine, and
// a friend. All of it takes values: nothing in here looks at a clock.
#include "../chance.hpp"
#include "time_based_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace time_based_motion {

//> A screen
/// A screen, and the ship that's seen on it.
struct Screen {
    double frame{}; ///< how long each of its frames takes [s]
    double shown{}; ///< when the last one ended [s]
    Ship ship;
};

//> The frame loop: three screens
/// Each screen has frames of its own, and shows all that end by this time [s]. In each of them its ship flies.
inline void next_frames(std::array<Screen, 3> &screens, double time) {
    for (Screen &screen : screens)
        for (; screen.shown + screen.frame <= time; screen.shown += screen.frame)
            screen.ship = fly(screen.ship, screen.frame);
}

//> Two ships
/// One flies by your clock, and one by the plain difference of two times.
struct Tab {
    Clock clock;
    Ship ship, raw;
};

//> The frame loop: a tab that sleeps
/// One frame of the game, when the machine's clock shows `now` [s].
inline Tab next_frame(Tab tab, double now) {
    tab.raw.x += tab.raw.speed * (now - tab.clock.last); // however long ago that was
    tab.clock = tick(tab.clock, now);
    tab.ship.x += tab.ship.speed * tab.clock.dt;
    return tab;
}

//> A lane
struct Lane {
    Runner runner;
    double spare{};   ///< time that no step has used yet [s]
    double highest{}; ///< how high it got so far [m]
};

//> The frame loop: whole steps
/// One frame that takes dt [s]: as many steps as are due. `jump` is whether the key is down.
inline Lane next_frame(Lane lane, double dt, bool jump) {
    const Due due = due_steps(lane.spare, dt, step_time);
    lane.spare = due.spare;
    for (int i = 0; i < due.steps; ++i) {
        lane.runner = step(lane.runner, jump);
        lane.highest = std::max(lane.highest, lane.runner.place.y());
    }
    return lane;
}

//> Cactuses
struct Cactus {
    double x{}, height{}; ///< [m]
};
constexpr double half_width = 0.15; ///< of every cactus [m]

/// The cactus with this number, from 0: 6.5 to 13 m behind the one before.
inline Cactus cactus(unsigned seed, int number) {
    const auto another = 2 * unsigned(number);
    return {6 + 9.75 * number + 3.25 * course::chance(seed, another), 0.45 + 0.3 * course::chance(seed, another + 1)};
}

//> Ouch
/// Whether the way between two places, which the runner's feet went in one step, leads through a cactus.
inline bool hits(const Vec2 &from, const Vec2 &to, unsigned seed) {
    const auto height_at = [&](double x) {
        const double part = to.x() > from.x() ? (x - from.x()) / (to.x() - from.x()) : 1;
        return from.y() + part * (to.y() - from.y());
    };
    for (int number = std::max(0, int((from.x() - 10) / 9.75)); cactus(seed, number).x < to.x() + 1; ++number) {
        const auto [x, height] = cactus(seed, number);
        const double enters = std::max(from.x(), x - half_width), leaves = std::min(to.x(), x + half_width);
        if (enters <= leaves && std::min(height_at(enters), height_at(leaves)) < height) return true;
    }
    return false;
}

//> A run
struct Run {
    Game game;
    unsigned seed{}; ///< of the cactuses
    double best{};   ///< how far the best run got so far [m]
    int falls{};     ///< how often a cactus was hit
};

//> The frame loop: run and jump
/// One frame of the game: yours, and what stands in the way of each of its steps.
inline void next_frame(Run &run, double seconds, bool jump) {
    Runner runner = run.game.now;
    jump = jump || run.game.jump_waits;
    run.game = next_frame(run.game, seconds, jump);
    const double to = run.game.now.place.x();
    run.best = std::max(run.best, to);
    for (int i = 0; i < 16 && runner.place.x() < to - 0.01; ++i, jump = false) {
        const Vec2 from = runner.place;
        runner = step(runner, jump);
        if (!hits(from, runner.place, run.seed)) continue;
        run.game = {}; // from the start, past the same cactuses
        ++run.falls;
        return;
    }
}

//> Two cameras
struct Cameras {
    Vec2 tenth{0, 0}; ///< goes a tenth of what's left in each frame [m]
    Vec2 ours{0, 0};  ///< goes half of what's left in each half-life [m]
};

//> The frame loop: two cameras
/// One frame that takes dt [s]. The first camera doesn't ask how long.
inline Cameras next_frame(Cameras cameras, const Vec2 &target, double half_life, double dt) {
    cameras.tenth += 0.1 * (target - cameras.tenth);
    cameras.ours = follow(cameras.ours, target, half_life, dt);
    return cameras;
}

//> A racer
struct Racer {
    Ship ship;
    double crossed{}; ///< when it last crossed the line [s]
    double lap{};     ///< how long its last lap took [s]
    int laps{};       ///< how many it flew
};

//> The frame loop: laps
/// A frame of dt [s] that ends at `end` [s], on a track that's so long [px].
inline void next_frame(Racer &racer, double length, double end, double dt) {
    const Wrapped wrapped = wrap(racer.ship, length, dt);
    racer.ship = wrapped.ship;
    if (wrapped.laps == 0) return;
    const double crossed = end - wrapped.since;
    racer.lap = (crossed - racer.crossed) / wrapped.laps;
    racer.crossed = crossed;
    racer.laps += wrapped.laps;
}

//> Thrown away
/// The same without a thought: the ship goes back to 0, and crossed the line when the frame ended.
inline void next_frame_without_rest(Racer &racer, double length, double end, double dt) {
    racer.ship.x += dt * racer.ship.speed;
    if (racer.ship.x < length) return;
    racer.ship.x = 0;
    racer.lap = end - racer.crossed;
    racer.crossed = end;
    ++racer.laps;
}

//> A machine
struct Machine {
    Schedule game;
    double frame = 1.0 / 60; ///< how long its next frame takes [s]
    double work{};           ///< how long it worked in the last one [s]
};

//> The frame loop: a busy machine
/// One frame. What's due in it is the time that the frame before took; and a frame takes as long as the work in it, but
/// at least a 60th of a second. With a budget of 1 s, that's the loop that ends in a spiral.
inline void next_frame(Machine &machine, double budget) {
    machine.game = run_frame(machine.game, std::min(machine.frame, 1.0), budget);
    machine.work = 0;
    for (const int job : machine.game.ran) machine.work += machine.game.jobs[std::size_t(job)].cost;
    machine.frame = std::max(1.0 / 60, machine.work);
}

//> On the line
/// A packet, and when it arrives [s].
struct Sent {
    Packet packet;
    double arrives{};
};

//> The frame loop: a friend
/// One frame, at a time [s]: what arrived by then is all you know, and you see where the ship was a tenth of a second ago.
inline Vec2 next_frame(const std::vector<Sent> &line, double time) {
    std::vector<Packet> received;
    for (const Sent &each : line)
        if (each.arrives <= time) received.push_back(each.packet);
    return seen_at(received, time);
}

//> The newest packet
/// Where the newest packet that arrived says that the friend's ship was [m].
inline Vec2 newest(const std::vector<Sent> &line, double time) {
    Packet found{-1, {0, 0}};
    for (const Sent &each : line)
        if (each.arrives <= time && each.packet.sent > found.sent) found = each.packet;
    return found.place;
}
//>
} // namespace time_based_motion
