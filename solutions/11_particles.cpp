#include "particles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace particles {

//> Solution 11.1: a free slot
std::optional<int> free_slot(const Pool &pool) {
    for (int i = 0; i < int(pool.size()); ++i)
        if (!pool[i]) return i;
    return {};
}

//> Solution 11.2: life and colour
std::optional<int> shade_index(double age, double life, int shades) {
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be at least 1", shades);

    if (age >= life) return {};
    return int(age / life * shades);
}

//> Solution 11.3: a step
std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    course::require(world.width > 0, "width [m] must be positive", world.width);
    course::require(world.height > 0, "height [m] must be positive", world.height);
    course::require(dt >= 0, "dt [s] must not be negative", dt);

    Particle next = particle;
    next.velocity += dt * Vec2{world.wind, -world.gravity};
    next.position += dt * next.velocity; // the new one: semi-implicit
    next.age += dt;

    const bool inside = next.position.x() >= 0 && next.position.x() < world.width && next.position.y() >= 0
                        && next.position.y() < world.height;
    if (!inside || next.age >= next.life) return {};
    return next;
}

//> Solution: a direction
/// The vector of length 1 at this angle from the x axis [rad].
static Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

//> Solution 11.4: a ring
std::vector<Vec2> ring_burst(int count, double speed, double first) {
    course::require(count >= 0, "count must not be negative", count);
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);

    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const double turn = double(i) / count; // as a fraction of a full turn
        velocities.push_back(speed * direction(first + 2 * std::numbers::pi * turn));
    }
    return velocities;
}

//> Solution 11.5: a disc
std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed) {
    require_random_numbers(random_numbers);
    course::require(random_numbers.size() % 2 == 0, "random numbers must come in pairs", double(random_numbers.size()));
    course::require(max_speed >= 0, "max_speed [m/s] must not be negative", max_speed);

    std::vector<Vec2> velocities;
    for (std::size_t i = 0; i < random_numbers.size(); i += 2) {
        const double speed = max_speed * std::sqrt(random_numbers[i]); // areas grow with the square
        velocities.push_back(speed * direction(2 * std::numbers::pi * random_numbers[i + 1]));
    }
    return velocities;
}

//> Solution 11.6: emit
/// From -1 to 1.
static double either_way(double number) { return 2 * number - 1; }

Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers) {
    const auto &[position, velocity, offset, jitter, min_life, max_life] = emitter;
    require_random_numbers(random_numbers);
    course::require(random_numbers.size() == 5, "there must be 5 random numbers", double(random_numbers.size()));
    course::require(offset >= 0, "offset [m] must not be negative", offset);
    course::require(jitter >= 0, "jitter [m/s] must not be negative", jitter);
    course::require(min_life > 0, "min_life [s] must be positive", min_life);
    course::require(max_life >= min_life, "max_life [s] must not be less than min_life", max_life);

    const auto &r = random_numbers;
    return {.position = position + offset * Vec2{either_way(r[0]), either_way(r[1])},
            .velocity = velocity + jitter * Vec2{either_way(r[2]), either_way(r[3])},
            .age = 0,
            .life = min_life + (max_life - min_life) * r[4]};
}

//> Solution 11.7: emission count
Emission emission_count(double rate, double remainder, double dt) {
    course::require(rate >= 0, "rate [1/s] must not be negative", rate);
    course::require(remainder >= 0 && remainder < 1, "remainder must be at least 0 and less than 1", remainder);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(rate * dt <= 1e6, "rate times dt must be at most 1e6", rate * dt);

    const double all = remainder + rate * dt;
    const double whole = std::floor(all);
    return {.count = int(whole), .remainder = all - whole};
}

//> Solution 11.8: the next wall
namespace {
struct Hit {
    double time;     ///< from now [s]
    Vec2 normal;     ///< of the wall, to its left, of length 1
    double approach; ///< speed towards the wall [m/s]
};
} // namespace

/// In how many seconds the particle reaches the wall's line, and where on the wall that is, from 0 to 1.
/// Everything is measured from the particle: far from the origin, the way it goes in a second would lose digits.
static std::optional<segment_intersection::LineIntersection> reach(const Particle &particle, const Wall &wall) {
    const Vec2 &here = particle.position;
    const Wall way{{0, 0}, particle.velocity}; // of a second
    const Wall ahead{wall.start - here, wall.end - here};
    return segment_intersection::intersect_lines(way, ahead);
}

/// The first wall that reflects the particle within `time`.
static std::optional<Hit> next_wall(const Particle &particle, const std::vector<Wall> &walls, double time) {
    std::optional<Hit> first;
    for (const Wall &wall : walls) {
        const Vec2 along = wall.end - wall.start;
        const double length = along.norm();
        const Vec2 normal = Vec2{-along.y(), along.x()} / length;
        const double approach = -particle.velocity.dot(normal);
        const auto met = reach(particle, wall);
        // it moves along the wall, moves away from it, or has it behind
        if (!met || approach <= contact_tolerance || met->t * approach < -contact_tolerance) continue;

        const double t = std::max(0.0, met->t);
        if (t > time || (first && t >= first->time)) continue;
        const double place = met->s * length;
        if (place >= -contact_tolerance && place <= length + contact_tolerance) first = Hit{t, normal, approach};
    }
    return first;
}

//> Solution 11.8: walls
Particle move_and_collide(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    require_particle(particle);
    course::require(restitution >= 0 && restitution <= 1, "restitution must be from 0 to 1", restitution);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    for (const Wall &wall : walls) require_wall(wall);

    Particle now = particle;
    now.age += dt;
    for (int bounces = 0; bounces < max_bounces; ++bounces) {
        const auto hit = next_wall(now, walls, dt);
        now.position += (hit ? hit->time : dt) * now.velocity;
        if (!hit) break;
        now.velocity += (1 + restitution) * hit->approach * hit->normal;
        dt -= hit->time;
    }
    return now;
}

//> Solution 11.9: a pool without gaps
std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity) {
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
            after[i] = after.back(); // it may be dead too, so i stays
            after.pop_back();
        }
    }
    for (std::size_t i = 0; i < newborn.size() && after.size() < most; ++i) after.push_back(newborn[i]);
    return after;
}

//> Solution 11.10: until the next burst
/// How long a rocket has until it bursts [s].
static double until_burst(const Rocket &rocket, double gravity) {
    return rocket.wait + std::max(0.0, rocket.velocity.y() / gravity);
}

/// Free fall for so long.
static void fall(Vec2 &position, Vec2 &velocity, double gravity, double time) {
    position += time * velocity - Vec2{0, gravity * time * time / 2};
    velocity.y() -= gravity * time;
}

/// All that happens while no rocket bursts: they fly, and sparks go out.
static void pass(Show &show, const Rules &rules, double time) {
    for (auto &[wait, position, velocity, random_numbers] : show.rockets) {
        fall(position, velocity, rules.gravity, std::max(0.0, time - wait));
        wait = std::max(0.0, wait - time);
    }
    for (auto &[position, velocity, age, life] : show.sparks) {
        fall(position, velocity, rules.gravity, time);
        age = position.y() < 0 ? std::max(age, life) : age + time; // out, once it's below the street
    }
    show.sparks = compact_pool(show.sparks, {}, rules.places);
}

//> Solution 11.10: a whole show
static void burst(Show &show, const Rocket &rocket, const Rules &rules) {
    std::vector<Particle> newborn;
    for (const Vec2 &velocity : disc_burst(rocket.random_numbers, rules.speed))
        newborn.push_back({rocket.position, rocket.velocity + velocity, 0, rules.life});
    const int before = int(show.sparks.size());
    show.sparks = compact_pool(show.sparks, newborn, rules.places);
    const int glow = int(show.sparks.size());
    show.shown += glow - before;
    show.lost += int(newborn.size()) - (glow - before);
    show.most = std::max(show.most, glow);
}

Show run_show(Show now, const Rules &rules, double dt) {
    require_show(now, rules, dt);
    const auto earlier = [&](const Rocket &a, const Rocket &b) {
        return until_burst(a, rules.gravity) < until_burst(b, rules.gravity);
    };
    while (true) {
        const auto first = std::min_element(now.rockets.begin(), now.rockets.end(), earlier);
        const bool none = first == now.rockets.end();
        const double time = none ? std::numeric_limits<double>::infinity() : until_burst(*first, rules.gravity);
        pass(now, rules, std::min(time, dt));
        if (time > dt) return now;
        burst(now, *first, rules);
        now.rockets.erase(first);
        dt -= time;
    }
}
//>
} // namespace particles
