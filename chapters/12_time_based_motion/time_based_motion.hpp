#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 12: the same game on every screen.
/// Times are in seconds. Numbers that go in are within ±1e5; what a clock shows may be up to ±1e10, since the one on the
/// wall counts from 1970. How many digits must be right stands with the tests.
namespace time_based_motion {

using course::Vec2;

//>
/// Refuses what no clock shows.
inline void require_time(double t) { course::require(std::abs(t) <= 1e10, "a time [s] must lie within ±1e10", t); }

//> A ship
struct Ship {
    double x{};     ///< [px]
    double speed{}; ///< [px/s]; negative: to the left
    COURSE_FIELDS("px, px/s", x, speed)
};

//> Fly
/// The ship at the end of a frame that took dt [s].
/// @throws std::invalid_argument if dt isn't from 0 to 1.
Ship fly(const Ship &ship, double dt);

//> A clock
/// What a game remembers of the time.
struct Clock {
    bool started = false; ///< whether there was a frame before
    double last{};        ///< what the machine's clock showed in that frame [s]
    double dt{};          ///< how long this frame takes in the game [s]
    double skipped{};     ///< how long, in all, the game stood still while the machine's clock went on [s]
    COURSE_FIELDS(", s, s, s", started, last, dt, skipped)
};
constexpr double longest_frame = 0.25; ///< [s]

//> Tick
/// The clock in the next frame, when the machine's clock shows `now` [s]. The frame takes as long as has passed since the
/// one before, but `longest_frame` at most: what's beyond is skipped. It takes 0 s if it's the first frame, or if the
/// machine's clock went backwards; neither skips anything.
/// @throws std::invalid_argument if a time is not within ±1e10.
Clock tick(const Clock &clock, double now);

//> Due steps
struct Due {
    int steps{};    ///< how many steps to take in this frame
    double spare{}; ///< the time that's left for the next frame, less than a step [s]
    COURSE_FIELDS("1, s", steps, spare)
};

/// How many whole steps fit into `spare` and `dt` together, and what's left after them.
/// @param spare  what the frame before left [s], 0 to 1
/// @param dt     how long this frame takes [s], 0 to 1
/// @param step   how long a step takes [s], 0.001 to 1
/// @throws std::invalid_argument if one of them is beyond these limits.
Due due_steps(double spare, double dt, double step);

//> A runner
struct Runner {
    Vec2 place{0, 0}; ///< how far it ran, and how high its feet are above the ground [m]
    double climb{};   ///< velocity upwards [m/s]
    COURSE_FIELDS("m, m/s", place, climb)
};
constexpr double step_time = 1.0 / 64;                         ///< [s]
constexpr double run_speed = 6, jump_speed = 6, gravity = -16; ///< [m/s], [m/s], [m/s²]

/// The runner one step later. It jumps only from the ground.
/// @param dt  how long the step takes [s]; in a game, always the same
inline Runner step(Runner now, bool jump, double dt = step_time) {
    if (jump && now.place.y() == 0) now.climb = jump_speed;
    now.climb += dt * gravity;
    now.place += dt * Vec2{run_speed, now.climb};
    if (now.place.y() <= 0) now.place.y() = now.climb = 0; // landed
    return now;
}

//> A game
struct Game {
    Clock clock;
    double spare{};          ///< time that no step has used yet [s]
    Runner before, now;      ///< after the step before the last one, and after the last one
    bool jump_waits = false; ///< whether *jump* was pressed since the last step
    Vec2 shown{0, 0};        ///< where the runner is drawn [m]
    COURSE_FIELDS(", s, , , , m", clock, spare, before, now, jump_waits, shown)
};

//> Next frame
/// The game one frame later. The clock ticks, and as many steps are taken as are due, each of them `step_time` long. Then
/// the runner is drawn between its last two places: from the one before towards the last, by as much of the way as
/// `spare` is of a step. A press of *jump* waits for the next step, and that step uses it up.
/// @param seconds  what the machine's clock shows
/// @param jump     whether *jump* was pressed in this frame
/// @throws std::invalid_argument if `spare` isn't from 0 to 1, or a clock's time is not within ±1e10.
Game next_frame(Game game, double seconds, bool jump);

//> Follow
/// Where the camera is one frame later. In each half-life it moves half of what's left to its target.
/// @param half_life  [s], at least 0.001
/// @param dt         [s], 0 to 1
/// @throws std::invalid_argument if one of them is beyond these limits.
Vec2 follow(const Vec2 &camera, const Vec2 &target, double half_life, double dt);

//> Wrapped
struct Wrapped {
    Ship ship;      ///< at the end of the frame
    int laps{};     ///< how often it flew over the end in this frame
    double since{}; ///< how long before the end of the frame it last did so [s]; 0 when `laps` is 0
    COURSE_FIELDS(", 1, s", ship, laps, since)
};

//> Wrap
/// A ship on a track, at the end of a frame that took dt [s]. The track goes from 0 to `length` [px], and where it ends, it
/// starts again: x is at least 0 and less than `length`, and nothing that the ship flew is lost.
/// @param ship  on the track, with a speed from 0
/// @throws std::invalid_argument if the track isn't 1 px long or more, if the ship isn't on it or flies to the left,
///         or if dt isn't from 0 to 1.
Wrapped wrap(const Ship &ship, double length, double dt);

//> A job
/// Something that a game does so many times a second: physics, say, or thinking.
struct Job {
    int rate{};    ///< how often it's due in a second, 1 to 1000: at 1/rate, 2/rate, 3/rate ... [1/s]
    double cost{}; ///< how long the machine needs for it each time [s], 0.0001 to 1
    int done{};    ///< how often it ran so far, 0 to 1e8
    COURSE_FIELDS("1/s, s, 1", rate, cost, done)
};

//> A schedule
struct Schedule {
    double time{}; ///< in the game [s]
    double lost{}; ///< how much time, in all, was lost because the machine was too slow [s]
    std::vector<Job> jobs;
    std::vector<int> ran; ///< which jobs ran in this frame, in order; 0 is the first one of `jobs`
    COURSE_FIELDS("s, s, , 1", time, lost, jobs, ran)
};

//> Run frame
/// The schedule one frame later. What's due up to time + dt runs, in the order of the moments when it's due; at the same
/// moment, in the order of `jobs`. But all costs of a frame together are at most `budget`, unless the first one alone is
/// more. When the next one doesn't fit, the game stops at the moment it's due, where the next frame goes on; the time
/// from there to time + dt is lost. Time never goes back.
/// @param dt      [s], 0 to 1
/// @param budget  how long the machine may work in this frame [s], 0 to 1
/// @throws std::invalid_argument if there's no job, or if a rate, a cost, a count, dt or the budget is beyond its limits.
Schedule run_frame(Schedule now, double dt, double budget);

//> A packet
/// What a friend's machine sent you.
struct Packet {
    double sent{}; ///< when [s]
    Vec2 place;    ///< where the friend's ship was at that moment [m]
    COURSE_FIELDS("s, m", sent, place)
};
constexpr double delay = 0.1;          ///< [s]
constexpr double longest_guess = 0.25; ///< [s]

//> Seen at
/// Where your screen shows the friend's ship at a time [s]: where it was `delay` before. Between two packets it flew straight
/// and steadily. Before the first packet it's where that one says. After the last one it goes on as it did between the last
/// two, for `longest_guess` at most, and waits there. If there's only one packet, it's where that one says.
/// @param packets  in any order, and perhaps twice; those that aren't the same were sent at least 1 ms apart
/// @throws std::invalid_argument if there's no packet, if two that aren't the same were sent less than 1 ms apart, or a
///         time is not within ±1e10.
Vec2 seen_at(const std::vector<Packet> &packets, double time);

//>
/// Exercises that see a clock take its time, too.
constexpr double largest_number(std::string_view exercise) {
    return exercise == "12.2" || exercise == "12.4" || exercise == "12.8" ? 1e10 : course::largest;
}

namespace subject {
COURSE_EXERCISE("12.1", core, time_based_motion, fly, "ship, dt [s]", "")
COURSE_EXERCISE("12.2", core, time_based_motion, tick, "clock, now [s]", "")
COURSE_EXERCISE("12.3", core, time_based_motion, due_steps, "spare [s], dt [s], step [s]", "")
COURSE_EXERCISE("12.4", core, time_based_motion, next_frame, "game, seconds [s], jump", "")
COURSE_EXERCISE("12.5", stretch, time_based_motion, follow, "camera [m], target [m], half_life [s], dt [s]", "m")
COURSE_EXERCISE("12.6", stretch, time_based_motion, wrap, "ship, length [px], dt [s]", "")
COURSE_EXERCISE("12.7", challenge, time_based_motion, run_frame, "now, dt [s], budget [s]", "")
COURSE_EXERCISE("12.8", challenge, time_based_motion, seen_at, "packets, time [s]", "m")
} // namespace subject
} // namespace time_based_motion
