#pragma once
#include "particles.hpp"

#include <cmath>
#include <cstdint>
#include <random>

/// The firework that grows from part to part of the chapter.
namespace particles {

//> The frame loop
/// One frame of the show: every spark takes a step, the dead free their slots, and the newborn get one.
inline void next_frame(Pool &pool, const std::vector<Particle> &newborn, const World &world, double dt) {
    for (auto &slot : pool)
        if (slot) slot = step(*slot, world, dt); // "nothing" from `step` makes the slot free
    for (const Particle &spark : newborn)
        if (const auto slot = free_slot(pool)) pool[*slot] = spark; // if the pool is full, this spark is lost
}

//> Three sparks
/// Three sparks from one place: up to the left, straight up, and up to the right.
inline std::vector<Particle> three_sparks(const Vec2 &place) {
    std::vector<Particle> sparks;
    for (const double sideways : {-3.0, 0.0, 3.0})
        sparks.push_back({.position = place, .velocity = {sideways, 8}, .age = 0, .life = 1.5});
    return sparks;
}

//> Random numbers
/// Random numbers, at least 0 and less than 1, the same on every machine: C++ specifies this generator bit by bit. It
/// leaves to each library how std::uniform_real_distribution makes fractions of them, so we do that ourselves, and
/// round nothing.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine{seed} {}
    double one() { return std::ldexp(double(engine() >> 11), -53); } // its upper 53 bits, times 2^-53
    std::vector<double> many(int count) {
        std::vector<double> numbers;
        for (int i = 0; i < count; ++i) numbers.push_back(one());
        return numbers;
    }

  private:
    std::mt19937_64 engine;
};

//> A burst
/// One spark for each velocity, from where the rocket is. Every spark inherits the rocket's velocity.
inline std::vector<Particle> burst(const Particle &rocket, const std::vector<Vec2> &velocities, double life) {
    std::vector<Particle> sparks;
    for (const Vec2 &velocity : velocities)
        sparks.push_back({.position = rocket.position, .velocity = rocket.velocity + velocity, .age = 0, .life = life});
    return sparks;
}

//> A first try at all directions
/// Random velocities: along x and along y, anything from `-speed` to `speed`.
inline std::vector<Vec2> box_burst(Random &random, int count, double speed) {
    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const double x = 2 * random.one() - 1, y = 2 * random.one() - 1; // from -1 to 1
        velocities.push_back(speed * Vec2{x, y});
    }
    return velocities;
}

//> An engine
/// The emitter at the tail of a rocket. Its sparks get only a tenth of the rocket's velocity, because the gas leaves
/// backwards.
inline Emitter engine_of(const Particle &rocket) {
    return {.position = rocket.position,
            .velocity = 0.1 * rocket.velocity,
            .offset = 0.1,
            .jitter = 0.5,
            .min_life = 0.2,
            .max_life = 0.6};
}

//> A trail
/// What the rocket emits in a frame of `dt`: 30 sparks per second, however long a frame is.
inline std::vector<Particle> trail(const Particle &rocket, Emission &emission, Random &random, double dt) {
    emission = emission_count(30, emission.remainder, dt);
    std::vector<Particle> sparks;
    for (int i = 0; i < emission.count; ++i) sparks.push_back(emit(engine_of(rocket), random.many(5)));
    return sparks;
}

//> A step among walls
/// A step in a world with walls, which give back half of the speed.
inline std::optional<Particle> step(Particle particle, const World &world, const std::vector<Wall> &walls, double dt) {
    particle.velocity += dt * Vec2{world.wind, -world.gravity}; // as before
    const Particle moved = move_and_collide(particle, walls, 0.5, dt);
    return step(moved, world, 0); // with dt = 0 it doesn't move, but if it's dead, this is nothing
}

//> The frame loop without gaps
/// One frame of the show with a pool that has no gaps.
inline void next_frame(std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity,
                       const World &world, double dt) {
    for (Particle &spark : pool) {
        const auto next = step(spark, world, dt);
        if (next) spark = *next;
        else spark.age = spark.life; // dead: removed below
    }
    pool = compact_pool(pool, newborn, capacity);
}

//> A rocket for the show
/// It waits, takes off from the street to the left of this place, and bursts there, into so many sparks.
inline Rocket rocket_to(const Vec2 &place, double wait, int sparks, const Rules &rules, Random &random) {
    const double rise = std::sqrt(2 * place.y() / rules.gravity); // [s]
    const Vec2 velocity{1.5, rules.gravity * rise};
    return {wait, {place.x() - rise * velocity.x(), 0}, velocity, random.many(2 * sparks)};
}

//> The frame loop: a whole show
/// One frame of the game: what the player has fired takes its place in the queue, and the show goes on.
inline void next_frame(Show &show, const std::vector<Rocket> &fired, const Rules &rules, double dt) {
    show.rockets.insert(show.rockets.end(), fired.begin(), fired.end());
    show = run_show(show, rules, dt);
}
//>
} // namespace particles
