// Section 12, time-based motion. Replace a whole `throw ...;` with your own code, save, and look:  ./course check 12
// The lines above each `throw` refuse numbers that make no sense; leave them as they are.

#include "time_based_motion.hpp"

#include <algorithm>
#include <cmath>

namespace time_based_motion {

static void require_dt(double dt) { course::require(dt >= 0 && dt <= 1, "dt [s] must be from 0 to 1", dt); }

// 12.1 core
Ship fly(const Ship &ship, double dt) {
    require_dt(dt);
    throw course::NotYet{"how far does the ship fly in one second, and how far in dt?"};
}

static void require_clock(const Clock &clock) {
    for (const double time : {clock.last, clock.dt, clock.skipped}) require_time(time);
}

// 12.2 core
Clock tick(const Clock &clock, double now) {
    require_clock(clock);
    require_time(now);
    throw course::NotYet{"how much time passed since the frame before?"};
}

static void require_spare(double spare) {
    course::require(spare >= 0 && spare <= 1, "spare time [s] must be from 0 to 1", spare);
}

// 12.3 core
Due due_steps(double spare, double dt, double step) {
    require_spare(spare);
    require_dt(dt);
    course::require(step >= 0.001 && step <= 1, "a step [s] must be from 0.001 to 1", step);
    throw course::NotYet{"how much time is there in all, and how many steps can you cut from it?"};
}

static void require_game(const Game &game) {
    require_clock(game.clock);
    require_spare(game.spare);
}

// 12.4 core
Game next_frame(Game game, double seconds, bool jump) {
    require_game(game);
    require_time(seconds);
    throw course::NotYet{"how long is this frame, and how many steps are due?"};
}

// 12.5 stretch
Vec2 follow(const Vec2 &camera, const Vec2 &target, double half_life, double dt) {
    course::require(half_life >= 0.001, "half-life [s] must be at least 0.001", half_life);
    require_dt(dt);
    throw course::NotYet{"how much of the distance is left after one half-life, after two, and after none?"};
}

static void require_track(const Ship &ship, double length, double dt) {
    course::require(length >= 1, "the track [px] must be at least 1 long", length);
    course::require(ship.x >= 0 && ship.x < length, "the ship must be on the track, x [px]", ship.x);
    course::require(ship.speed >= 0, "speed [px/s] must not be negative", ship.speed);
    require_dt(dt);
}

// 12.6 stretch
Wrapped wrap(const Ship &ship, double length, double dt) {
    require_track(ship, length, dt);
    throw course::NotYet{"where would the ship be if the track went on, and how many tracks is that?"};
}

static void require_schedule(const Schedule &now) {
    course::require(!now.jobs.empty(), "there must be a job, jobs", 0);
    for (const Job &job : now.jobs) {
        course::require(job.rate >= 1 && job.rate <= 1000, "a rate [1/s] must be from 1 to 1000", job.rate);
        course::require(job.cost >= 0.0001 && job.cost <= 1, "a cost [s] must be from 0.0001 to 1", job.cost);
        course::require(job.done >= 0 && job.done <= 1e8, "a count must be from 0 to 1e8", job.done);
    }
}

// 12.7 challenge
Schedule run_frame(Schedule now, double dt, double budget) {
    require_schedule(now);
    require_dt(dt);
    course::require(budget >= 0 && budget <= 1, "a budget [s] must be from 0 to 1", budget);
    throw course::NotYet{"which job is due next, and when?"};
}

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

// 12.8 challenge
Vec2 seen_at(const std::vector<Packet> &packets, double time) {
    require_packets(packets);
    require_time(time);
    throw course::NotYet{"which two packets were sent around the moment that you show?"};
}

} // namespace time_based_motion
