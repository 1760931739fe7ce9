// Section 11, Particles. Replace a whole `throw ...;` by your own code, save, and see:  ./course check 11
// Bad input is refused in lines like these; the first function has its line already:
//     course::require_range(age, life);
//     course::require(age >= 0, "age [s] must not be negative", age);

#include "particles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace particles {

// 11.1 core
std::optional<Pool> start(const Pool &pool, const Particle &particle) {
    require_particle(particle);
    throw course::NotYet{"which slot is free? Copy the pool, and put the particle there"};
}

// 11.2 core
std::optional<int> shade(double age, double life, int shades) {
    throw course::NotYet{"what share of its life is over? And when is all of it?"};
}

// 11.3 core
std::optional<Particle> step(const Particle &particle, const World &world, double dt) {
    throw course::NotYet{"copy the particle, and change the copy's velocity first"};
}

// 11.4 stretch
std::vector<Vec2> ring(int count, double speed, double first) {
    throw course::NotYet{"which angle lies between two neighbours?"};
}

// 11.5 stretch
std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest) {
    throw course::NotYet{"which share of the disc is inside half of its radius?"};
}

// 11.6 stretch
Particle trail(const Emitter &emitter, const std::vector<double> &chances) {
    throw course::NotYet{"make a number from -1 to 1 of a chance"};
}

// 11.7 stretch
Due due(double rate, double carry, double dt) {
    throw course::NotYet{"how many are due, with all that was carried? Take the whole ones, and carry the rest"};
}

// 11.8 challenge
Particle fly(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt) {
    throw course::NotYet{"which of the walls ahead is first? Go there, turn, and go on with the time that is left"};
}

// 11.9 challenge
std::vector<Particle> renew(const std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity) {
    throw course::NotYet{"who can fill a gap, so that nobody else has to move?"};
}

} // namespace particles
