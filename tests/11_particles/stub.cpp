// Section 11, Particles. Replace a whole line `throw course::NotYet{...};` by your own code, save, and see:
//     ./course check 11
// The lines above it are written for you: they refuse input that makes no sense. Leave them as they are.

#include "particles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace particles {

// 11.1 core
std::optional<int> free_slot(const Pool &pool) {
    throw course::NotYet{"what's the number of the first slot that isn't taken?"};
}

// 11.2 core
std::optional<int> shade_index(double age, double life, int shades) {
    course::require(age >= 0, "age [s] must not be negative", age);
    course::require(life > 0, "life [s] must be positive", life);
    course::require(shades >= 1, "shades must be at least 1", shades);
    throw course::NotYet{"what fraction of its life is over?"};
}

// 11.3 core
std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    require_particle(particle);
    course::require(world.width > 0, "width [m] must be positive", world.width);
    course::require(world.height > 0, "height [m] must be positive", world.height);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    throw course::NotYet{"copy the particle, and change the copy's velocity first"};
}

// 11.4 stretch
std::vector<Vec2> ring_burst(int count, double speed, double first) {
    course::require(count >= 0, "count must not be negative", count);
    course::require(speed >= 0, "speed [m/s] must not be negative", speed);
    throw course::NotYet{"what is the angle between two neighbours?"};
}

// 11.5 stretch
std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed) {
    require_random_numbers(random_numbers);
    course::require(random_numbers.size() % 2 == 0, "random numbers must come in pairs", double(random_numbers.size()));
    course::require(max_speed >= 0, "max_speed [m/s] must not be negative", max_speed);
    throw course::NotYet{"what fraction of the disc lies inside half of its radius?"};
}

// 11.6 stretch
Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers) {
    const auto &[position, velocity, offset, jitter, min_life, max_life] = emitter;
    require_random_numbers(random_numbers);
    course::require(random_numbers.size() == 5, "there must be 5 random numbers", double(random_numbers.size()));
    course::require(offset >= 0, "offset [m] must not be negative", offset);
    course::require(jitter >= 0, "jitter [m/s] must not be negative", jitter);
    course::require(min_life > 0, "min_life [s] must be positive", min_life);
    course::require(max_life >= min_life, "max_life [s] must not be less than min_life", max_life);
    throw course::NotYet{"turn a random number into one from -1 to 1"};
}

// 11.7 stretch
Emission emission_count(double rate, double remainder, double dt) {
    course::require(rate >= 0, "rate [1/s] must not be negative", rate);
    course::require(remainder >= 0 && remainder < 1, "remainder must be at least 0 and less than 1", remainder);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(rate * dt <= 1e6, "rate times dt must be at most 1e6", rate * dt);
    throw course::NotYet{"how many particles are there, together with the remainder? Emit the whole ones"};
}

// 11.8 challenge
Particle move_and_collide(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    require_particle(particle);
    course::require(restitution >= 0 && restitution <= 1, "restitution must be from 0 to 1", restitution);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    for (const Wall &wall : walls) require_wall(wall);
    throw course::NotYet{"which wall does it hit first? Go there, bounce, and go on for the time that is left"};
}

// 11.9 challenge
std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity) {
    for (const Particle &particle : pool) require_particle(particle);
    for (const Particle &particle : newborn) require_particle(particle);
    course::require(capacity >= 0, "capacity must not be negative", capacity);
    course::require(pool.size() <= std::size_t(capacity), "capacity must not be less than the pool holds", capacity);
    throw course::NotYet{"which particle can fill a gap, so that no other has to move?"};
}

// 11.10 challenge
Show run_show(Show now, const Rules &rules, double dt) {
    require_show(now, rules, dt);
    throw course::NotYet{"which rocket bursts first, and what has happened to the sparks by then?"};
}

} // namespace particles
