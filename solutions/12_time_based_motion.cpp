#include "time_based_motion.hpp"

#include <algorithm>
#include <cmath>

namespace time_based_motion {

//> Solution: a good frame
static void require_dt(double dt) { course::require(dt >= 0 && dt <= 1, "dt [s] must be from 0 to 1", dt); }

//> Solution 12.1: fly
Ship fly(const Ship &ship, double dt) {
    require_dt(dt);
    return {ship.x + dt * ship.speed, ship.speed};
}

//> Solution: a good clock
static void require_clock(const Clock &clock) {
    for (const double time : {clock.last, clock.dt, clock.skipped}) require_time(time);
}

//> Solution 12.2: tick
Clock tick(const Clock &clock, double now) {
    require_clock(clock);
    require_time(now);
    const double passed = clock.started ? std::max(0.0, now - clock.last) : 0;
    const double dt = std::min(passed, longest_frame);
    return {true, now, dt, clock.skipped + (passed - dt)};
}

//> Solution: good times
static void require_spare(double spare) {
    course::require(spare >= 0 && spare <= 1, "spare time [s] must be from 0 to 1", spare);
}

//> Solution 12.3: due steps
Due due_steps(double spare, double dt, double step) {
    require_spare(spare);
    require_dt(dt);
    course::require(step >= 0.001 && step <= 1, "a step [s] must be from 0.001 to 1", step);
    Due due{0, spare + dt};
    for (; due.spare >= step; due.spare -= step) ++due.steps;
    return due;
}

//> Solution: a good game
static void require_game(const Game &game) {
    require_clock(game.clock);
    require_spare(game.spare);
}

//> Solution 12.4: one frame of the game
Game next_frame(Game game, double seconds, bool jump) {
    require_game(game);
    require_time(seconds);
    game.clock = tick(game.clock, seconds);
    const Due due = due_steps(game.spare, game.clock.dt, step_time);
    game.spare = due.spare;
    if (jump) game.jump_waits = true;
    for (int i = 0; i < due.steps; ++i) {
        game.before = game.now;
        game.now = step(game.now, game.jump_waits);
        game.jump_waits = false;
    }
    const double part = game.spare / step_time;
    game.shown = game.before.place + part * (game.now.place - game.before.place);
    return game;
}

//> Solution 12.5: follow
Vec2 follow(const Vec2 &camera, const Vec2 &target, double half_life, double dt) {
    course::require(half_life >= 0.001, "half-life [s] must be at least 0.001", half_life);
    require_dt(dt);
    return target + std::exp2(-dt / half_life) * (camera - target);
}

//> Solution: a good track
static void require_track(const Ship &ship, double length, double dt) {
    course::require(length >= 1, "the track [px] must be at least 1 long", length);
    course::require(ship.x >= 0 && ship.x < length, "the ship must be on the track, x [px]", ship.x);
    course::require(ship.speed >= 0, "speed [px/s] must not be negative", ship.speed);
    require_dt(dt);
}

//> Solution 12.6: wrap
Wrapped wrap(const Ship &ship, double length, double dt) {
    require_track(ship, length, dt);
    const double flown = ship.x + dt * ship.speed, x = std::fmod(flown, length);
    const int laps = int(std::lround((flown - x) / length));
    return {{x, ship.speed}, laps, laps > 0 ? x / ship.speed : 0};
}

//> Solution: a good schedule
static void require_schedule(const Schedule &now) {
    course::require(!now.jobs.empty(), "there must be a job, jobs", 0);
    for (const Job &job : now.jobs) {
        course::require(job.rate >= 1 && job.rate <= 1000, "a rate [1/s] must be from 1 to 1000", job.rate);
        course::require(job.cost >= 0.0001 && job.cost <= 1, "a cost [s] must be from 0.0001 to 1", job.cost);
        course::require(job.done >= 0 && job.done <= 1e8, "a count must be from 0 to 1e8", job.done);
    }
}

//> Solution 12.7: one frame of a schedule
/// When a job is due next [s]. As a fraction, so that 12/120 and 1/10 are the same number.
static double due_at(const Job &job) { return double(job.done + 1) / job.rate; }

static Job &next_of(std::vector<Job> &jobs) { // the first one, of those that are due at the same moment
    return *std::min_element(jobs.begin(), jobs.end(),
                             [](const Job &one, const Job &other) { return due_at(one) < due_at(other); });
}

Schedule run_frame(Schedule now, double dt, double budget) {
    require_schedule(now);
    require_dt(dt);
    course::require(budget >= 0 && budget <= 1, "a budget [s] must be from 0 to 1", budget);
    const double end = now.time + dt;
    double worked = 0;
    now.ran.clear();
    for (;;) {
        Job &job = next_of(now.jobs);
        if (due_at(job) > end) {
            now.time = end;
            return now;
        }
        if (!now.ran.empty() && worked + job.cost > budget) {
            now.time = std::max(now.time, due_at(job));
            now.lost += end - now.time;
            return now;
        }
        worked += job.cost;
        ++job.done;
        now.ran.push_back(int(&job - now.jobs.data()));
    }
}

//> Solution: good packets
static bool earlier(const Packet &one, const Packet &other) { return one.sent < other.sent; }

static void require_packets(std::vector<Packet> packets) {
    course::require(!packets.empty(), "there must be a packet, packets", 0);
    for (const Packet &packet : packets) require_time(packet.sent);
    std::sort(packets.begin(), packets.end(), earlier);
    for (std::size_t i = 1; i < packets.size(); ++i) {
        const double apart = packets[i].sent - packets[i - 1].sent;
        const bool same = apart == 0 && packets[i].place == packets[i - 1].place;
        course::require(same || apart > 0.001 - 1e-6, "two packets must be the same, or sent 0.001 s apart, [s]",
                        apart);
    }
}

//> Solution 12.8: seen at
Vec2 seen_at(const std::vector<Packet> &packets, double time) {
    require_packets(packets);
    require_time(time);
    std::vector<Packet> all = packets;
    std::sort(all.begin(), all.end(), earlier);
    all.erase(std::unique(all.begin(), all.end(), [](auto &one, auto &other) { return one.sent == other.sent; }),
              all.end());
    const double then = time - delay;
    if (then <= all.front().sent || all.size() == 1) return all.front().place;
    auto next = std::find_if(all.begin(), all.end(), [&](const Packet &packet) { return packet.sent > then; });
    if (next == all.end()) --next; // after the last one: from the last two
    const Packet &from = *(next - 1), &to = *next;
    const double until = std::min(then, all.back().sent + longest_guess);
    return from.place + (until - from.sent) / (to.sent - from.sent) * (to.place - from.place);
}
//>
} // namespace time_based_motion
