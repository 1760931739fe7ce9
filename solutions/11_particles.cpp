#include "particles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace particles {

//> Solution 11.1: start
std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i]) {
            Pool after = pool;
            after[i] = particle;
            return after;
        }
    return {};
}

//> Solution 11.2: life and colour
std::optional<int> shade(double age, double life, int shades) {
    course::require_range(age, life);
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be 1 or more", shades);

    if (age >= life) return {};
    return std::min(int(age / life * shades), shades - 1); // the last: a rounding must not make one more
}

//> Solution 11.3: a step
std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    course::require_range(world.gravity, world.wind, world.width, world.height, dt);
    course::require(world.width > 0, "width [m] must be positive", world.width);
    course::require(world.height > 0, "height [m] must be positive", world.height);
    course::require(dt >= 0, "dt [s] must not be negative", dt);

    Particle next = particle;
    next.velocity += dt * Vec2{world.wind, -world.gravity};
    next.position += dt * next.velocity; // the new one: semi-implicit
    next.age += dt;

    const bool seen = next.position.x() >= 0 && next.position.x() < world.width && next.position.y() >= 0
                      && next.position.y() < world.height;
    if (!seen || next.age >= next.life) return {};
    return next;
}

//> Solution: a direction
/// Of length 1, at this angle from the x axis [rad].
static Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

//> Solution 11.4: a ring
std::vector<Vec2> ring(int count, double speed, double first) {
    course::require_range(speed, first);
    course::require(count >= 0, "count must not be negative", count);
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);

    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const double turn = double(i) / count; // of a whole one
        velocities.push_back(speed * direction(first + 2 * std::numbers::pi * turn));
    }
    return velocities;
}

//> Solution: chances
static void require_chances(const std::vector<double> &chances) {
    for (const double chance : chances)
        course::require(chance >= 0 && chance < 1, "a chance must be in [0, 1)", chance);
}

//> Solution 11.5: an explosion
std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest) {
    require_chances(chances);
    course::require_range(fastest);
    course::require(chances.size() % 2 == 0, "the number of chances must be even", double(chances.size()));
    course::require(fastest >= 0, "fastest [m/s] must not be negative", fastest);

    std::vector<Vec2> velocities;
    for (std::size_t i = 0; i < chances.size(); i += 2) {
        const double speed = fastest * std::sqrt(chances[i]); // areas grow with the square
        velocities.push_back(speed * direction(2 * std::numbers::pi * chances[i + 1]));
    }
    return velocities;
}

//> Solution 11.6: a trail
/// From -1 to 1.
static double either_way(double chance) { return 2 * chance - 1; }

Particle trail(const Emitter &emitter, const std::vector<double> &chances) {
    const auto &[position, velocity, offset, jitter, shortest, longest] = emitter;
    course::require_range(position, velocity, offset, jitter, shortest, longest);
    require_chances(chances);
    course::require(chances.size() == 5, "the number of chances must be 5", double(chances.size()));
    course::require(offset >= 0, "offset [m] must not be negative", offset);
    course::require(jitter >= 0, "jitter [m/s] must not be negative", jitter);
    course::require(shortest > 0, "the shortest life [s] must be positive", shortest);
    course::require(longest >= shortest, "the longest life [s] must not be less than the shortest", longest);

    return {.position = position + offset * Vec2{either_way(chances[0]), either_way(chances[1])},
            .velocity = velocity + jitter * Vec2{either_way(chances[2]), either_way(chances[3])},
            .age = 0,
            .life = shortest + (longest - shortest) * chances[4]};
}

//> Solution 11.7: how many are due?
Due due(double rate, double carry, double dt) {
    course::require_range(rate, carry, dt);
    course::require(rate >= 0, "rate [1/s] must not be negative", rate);
    course::require(carry >= 0 && carry < 1, "carry must be in [0, 1)", carry);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(rate * dt <= 1e6, "rate times dt must be at most 1e6", rate * dt);

    const double all = carry + rate * dt;
    const double whole = std::floor(all);
    return {.count = int(whole), .carry = all - whole};
}

//> Solution 11.8: the next wall
namespace {
struct Hit {
    double time;    ///< from now [s]
    Vec2 normal;    ///< of the wall, to its left, of length 1
    double closing; ///< speed towards the wall [m/s]
};
} // namespace

/// In how many seconds the particle reaches the wall's line, and where on the wall that is, from 0 to 1.
/// All is seen from the particle, and at a quarter of its size, for section 7 takes no number beyond ±1e5.
static std::optional<segment_intersection::Crossing> reach(const Particle &particle, const Wall &wall) {
    const Vec2 &here = particle.position;
    return segment_intersection::crossing({.start = {0, 0}, .end = particle.velocity / 4}, // one second of its path
                                          {.start = (wall.start - here) / 4, .end = (wall.end - here) / 4});
}

/// The first wall that turns the particle within `time`.
static std::optional<Hit> next_wall(const Particle &particle, const std::vector<Wall> &walls, double time) {
    std::optional<Hit> first;
    for (const Wall &wall : walls) {
        const Vec2 way = wall.end - wall.start;
        const double length = way.norm();
        const Vec2 normal = Vec2{-way.y(), way.x()} / length;
        const double closing = -particle.velocity.dot(normal);
        const auto met = reach(particle, wall);
        if (!met || closing <= touching || met->t * closing < -touching) continue; // flies along, leaves, or is behind

        const double t = std::max(0.0, met->t);
        if (t > time || (first && t >= first->time)) continue;
        const double along = met->s * length;
        if (along >= -touching && along <= length + touching) first = Hit{t, normal, closing};
    }
    return first;
}

//> Solution 11.8: walls
Particle fly(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    require_particle(particle);
    course::require_range(restitution, dt);
    course::require(restitution >= 0 && restitution <= 1, "restitution must be from 0 to 1", restitution);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    for (const Wall &wall : walls) {
        course::require_range(wall.start, wall.end);
        const Vec2 way = wall.end - wall.start;
        course::require(way.norm() >= 1e-3, "a wall's length [m] must be 1e-3 or more", way.norm());
    }

    Particle now = particle;
    now.age += dt;
    for (int bounces = 0; bounces < most_bounces; ++bounces) {
        const auto hit = next_wall(now, walls, dt);
        now.position += (hit ? hit->time : dt) * now.velocity;
        if (!hit) break;
        now.velocity += (1 + restitution) * hit->closing * hit->normal;
        dt -= hit->time;
    }
    return now;
}

//> Solution 11.9: a pool without gaps
std::vector<Particle> renew(const std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity) {
    for (const Particle &particle : pool) require_particle(particle);
    for (const Particle &particle : newborn) require_particle(particle);
    course::require(capacity >= 0, "capacity must not be negative", capacity);
    const auto most = std::size_t(capacity);
    course::require(pool.size() <= most, "capacity must not be less than the pool holds", capacity);

    std::vector<Particle> after = pool;
    for (std::size_t i = 0; i < after.size();) {
        if (after[i].age < after[i].life) {
            ++i;
        } else {
            after[i] = after.back(); // it may be dead as well, so i stays
            after.pop_back();
        }
    }
    for (std::size_t i = 0; i < newborn.size() && after.size() < most; ++i) after.push_back(newborn[i]);
    return after;
}
//>
} // namespace particles
