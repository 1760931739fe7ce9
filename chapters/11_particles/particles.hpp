#pragma once
#include "../07_segment_intersection/segment_intersection.hpp"
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 11: particles, many small things that are spawned, move, change colour and die.
///
/// Numbers that go in, other than counts, are within ±1e5, which itself is allowed; numbers that come out may be larger.
/// Computed numbers are right to 1e-12, or to 1e-12 of the largest number that goes into them if that is more than 1.
/// After n terms, bounces or added angles the limit is n times that.
///
/// Input that is not as a function describes it is refused, by every function, with a std::invalid_argument that names
/// it: a number beyond ±1e5 or not a number, a bad particle (`require_particle`), random number or wall, and whatever
/// breaks a limit that is given with a parameter.
namespace particles {

using course::Vec2;

//> A particle
/// A point that moves, grows older, and dies.
struct Particle {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    double age{};  ///< time since it was spawned [s], not negative
    double life{}; ///< its whole lifetime [s], positive: as soon as `age` reaches it, the particle is dead
    COURSE_FIELDS("m, m/s, s, s", position, velocity, age, life)
};

//> Refusing a particle
/// Refuses a particle with a number that is not within ±1e5, with a negative age, or with a life that is not positive.
/// A dead particle is not refused.
/// @throws std::invalid_argument naming the number; "not a number" is refused as well.
inline void require_particle(const Particle &particle) {
    course::require_range(particle.position, particle.velocity, particle.age, particle.life);
    course::require(particle.age >= 0, "age [s] must not be negative", particle.age);
    course::require(particle.life > 0, "life [s] must be positive", particle.life);
}

//> A pool
/// A fixed number of slots. Each slot holds a particle, or nothing: then it is free.
using Pool = std::vector<std::optional<Particle>>;

//> Spawn
/// The pool with `particle` in one slot that was free (any of them), and with every other slot as it was.
/// Nothing if no slot is free: the pool does not grow, and no particle is removed to make room.
/// The particle is stored unchanged; those already in the pool are not checked.
std::optional<Pool> spawn(const Pool &pool, const Particle &particle);

//> Life and colour
/// Which of the shades 0, 1, … `shades` - 1 a particle shows at this age. Each is shown for the same part of its life.
/// Nothing once the particle is dead: `age` has reached `life`.
/// Where rounding decides between two of these, either is right; `shades` itself is never an answer.
/// @param age     [s], not negative
/// @param life    the whole lifetime [s], positive; not the time for one shade
/// @param shades  how many, at least 1; there may be a billion, so do not loop over them
std::optional<int> shade_index(double age, double life, int shades);

//> The world
/// What acts on all particles, and the picture: a particle outside it is dead.
struct World {
    double gravity{}; ///< downwards [m/s²]; negative: upwards
    double wind{};    ///< to the right, an acceleration too [m/s²]; negative: to the left
    double width{};   ///< of the picture [m], positive; x = 0 belongs to it, x = `width` does not
    double height{};  ///< of the picture [m], positive; y = 0 belongs to it, y = `height` does not
    COURSE_FIELDS("m/s², m/s², m, m", gravity, wind, width, height)
};

//> A step
/// The particle one step of `dt` later. The scheme is semi-implicit Euler: first the velocity changes, then the position
/// changes by the new velocity. The particle is then `dt` older.
/// Nothing if it is dead after the step: outside the picture, or at the end of its life. Where it was before the step
/// does not matter. Where rounding decides whether it is dead, either is right.
/// @param dt  [s], not negative
std::optional<Particle> step(const Particle &particle, const World &world, double dt);

//> A ring
/// Velocities [m/s] in all directions: all of them as fast as `speed`, once round, with the same angle from each to the
/// next, anticlockwise, starting at the angle `first`.
/// @param count  how many, not negative; 0 gives an empty list
/// @param speed  [m/s], not negative
/// @param first  [rad]; 0 is to the right
std::vector<Vec2> ring_burst(int count, double speed, double first);

//> Refusing random numbers
/// @throws std::invalid_argument if one of the numbers is less than 0, is 1 or more, or is not a number
inline void require_random_numbers(const std::vector<double> &random_numbers) {
    for (const double number : random_numbers)
        course::require(number >= 0 && number < 1, "a random number must be at least 0 and less than 1", number);
}

//> A disc
/// Velocities [m/s], spread evenly over a disc of radius `max_speed`: equal areas hold equal numbers of them.
/// @param random_numbers  at least 0 and less than 1, and in pairs, one pair for each velocity. The first of a pair
///                        sets the speed: 0 gives 0, and a larger number a larger speed. The second sets the
///                        angle: 0 is to the right, and up to 1 it goes evenly once round, anticlockwise.
/// @param max_speed       [m/s], not negative
std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed);

//> An emitter
/// Something that leaves a trail of particles, as a rocket does.
struct Emitter {
    Vec2 position;     ///< [m]
    Vec2 velocity;     ///< [m/s]
    double offset{};   ///< along each axis, a particle is spawned at most this far from it [m], not negative
    double jitter{};   ///< along each axis, a particle is at most this much faster or slower [m/s], not negative
    double min_life{}; ///< of a particle [s], positive
    double max_life{}; ///< of a particle [s], at least `min_life`
    COURSE_FIELDS("m, m/s, m, m/s, s, s", position, velocity, offset, jitter, min_life, max_life)
};

//> Emit
/// One particle of the trail, of age 0. It inherits the emitter's velocity; the random numbers vary it.
/// @param random_numbers  five, at least 0 and less than 1: for the position's x and y, the velocity's x and y, and the
///                        life. As a number goes from 0 to 1, its quantity goes evenly from its smallest value to its largest.
Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers);

//> How many this frame?
/// How many particles a frame emits.
struct Emission {
    int count{};        ///< whole particles
    double remainder{}; ///< the fraction of a particle left for the next frame [1], at least 0 and less than 1
    COURSE_FIELDS("1, 1", count, remainder)
};

//> Emission count
/// How many particles a frame of length `dt` emits at `rate` per second. No fraction is lost: `count` plus the new
/// remainder is the old remainder plus what this frame adds. So over any time the counts add up to `rate` times that
/// time, to within one, however it is cut into frames. Where rounding decides whether a particle is whole, either is
/// right.
/// @param rate       [1/s], not negative
/// @param remainder  what the frame before left over [1], at least 0 and less than 1
/// @param dt         [s], not negative, and `rate` times `dt` at most 1e6
Emission emission_count(double rate, double remainder, double dt);

//> A wall
/// A segment of section 7, at least 1e-3 m long. It reflects particles that come from its left side, as seen when
/// walking from its start to its end; particles that come from its right side pass through.
using Wall = segment_intersection::Segment;

//> Two limits
/// A particle is on a wall, or at its end, if it is within this distance of it [m]. It approaches a wall if it moves
/// towards it faster than this [m/s]; otherwise it moves along it.
inline constexpr double contact_tolerance = 1e-9;

/// After this many bounces in one call a particle stays where it is until the call's time is over, and keeps the
/// velocity that its last bounce gave it.
inline constexpr int max_bounces = 1000;

//> Refusing a wall
/// @throws std::invalid_argument if the wall is shorter than 1e-3 m, or if a number is not within ±1e5
inline void require_wall(const Wall &wall) {
    course::require_range(wall.start, wall.end);
    const double length = (wall.end - wall.start).norm();
    course::require(length >= 1e-3, "a wall's length [m] must be at least 1e-3", length);
}

//> Move and collide
/// The particle `dt` later, and `dt` older. It moves straight on until it hits a wall; there the part of its velocity
/// along the wall's normal is reversed and multiplied by `restitution`, and it moves on for the time that is left.
/// It never skips a wall, however long `dt` is. If it is within `contact_tolerance` of a wall, on either side, and
/// moves towards its right side, it bounces at once. Where it hits two walls at once, both act, in either order, until
/// it approaches neither. Three cases are left open, and either answer is right: a wall that it reaches at the very end
/// of `dt`, one that it meets within `contact_tolerance` of an end, and one so nearly parallel to its path that
/// `intersect_lines` returns nothing.
/// @param restitution  [1], from 0 to 1
/// @param dt           [s], not negative
Particle move_and_collide(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt);

//> A pool without gaps
/// The pool without its dead particles, and with as many of the newborn as fit.
/// If n particles survive, those in the first n places stay there; the others move into the gaps, in any order. Of
/// a b c d e f let a, d and f be dead: three survive, b and c stay, and e moves, which gives e b c.
/// Behind them come the newborn, unchanged and in their order, until there are `capacity` particles in all.
/// @param pool      at most `capacity` particles; those whose age has reached their life are dead
/// @param capacity  at least the pool's size; it may be far more than memory has room for
std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity);

//> The exercises
namespace subject {
COURSE_EXERCISE("11.1", core, particles, spawn, "pool, particle", "")
COURSE_EXERCISE("11.2", core, particles, shade_index, "age [s], life [s], shades", "1")
COURSE_EXERCISE("11.3", core, particles, step, "particle, world, dt [s]", "")
COURSE_EXERCISE("11.4", stretch, particles, ring_burst, "count, speed [m/s], first [rad]", "m/s")
COURSE_EXERCISE("11.5", stretch, particles, disc_burst, "random_numbers [1], max_speed [m/s]", "m/s")
COURSE_EXERCISE("11.6", stretch, particles, emit, "emitter, random_numbers [1]", "")
COURSE_EXERCISE("11.7", stretch, particles, emission_count, "rate [1/s], remainder [1], dt [s]", "")
COURSE_EXERCISE("11.8", challenge, particles, move_and_collide, "particle, walls, restitution [1], dt [s]", "")
COURSE_EXERCISE("11.9", challenge, particles, compact_pool, "pool, newborn, capacity", "")
} // namespace subject
//>
} // namespace particles
