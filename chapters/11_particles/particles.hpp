#pragma once
#include "../07_segment_intersection/segment_intersection.hpp"
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 11: many small things that start, move, glow and go out.
///
/// What goes in lies within ±1e5, both ends included; what comes out may be larger. Numbers that are computed are right
/// to 1e-12, or to 1e-12 of the largest number that goes into them where that is more than 1. After n terms, bounces or
/// added angles it is n times that.
namespace particles {

using course::Vec2;

//> A particle
/// A point that moves, ages, and goes out.
struct Particle {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    double age{};  ///< since it started [s], not negative
    double life{}; ///< all of its life [s], positive: as soon as `age` has reached it, the particle is dead
    COURSE_FIELDS("m, m/s, s, s", position, velocity, age, life)
};

//> What goes in
/// Refuses a particle with a number that is not within ±1e5 (which itself is allowed), with a negative age, or with a
/// life that is not positive. One that is dead is not refused.
/// @throws std::invalid_argument naming the number; "not a number" is none.
inline void require_particle(const Particle &particle) {
    course::require_range(particle.position, particle.velocity, particle.age, particle.life);
    course::require(particle.age >= 0, "age [s] must not be negative", particle.age);
    course::require(particle.life > 0, "life [s] must be positive", particle.life);
}

//> A pool
/// A fixed number of slots. Each holds a particle, or nothing: then it is free.
using Pool = std::vector<std::optional<Particle>>;

/// The pool with `particle` in a slot that was free, whichever you like, and every other slot as it was.
/// Nothing if no slot is free: the pool neither grows, nor gives up a particle for another one.
/// The particle goes in as it is; those in the pool are not looked at.
/// @throws std::invalid_argument as `require_particle` says
std::optional<Pool> start(const Pool &pool, const Particle &particle);

//> Life and colour
/// Which of the shades 0, 1, … `shades` - 1 a particle shows. They follow each other through its life, all equally long.
/// Nothing as soon as it is dead: `age` has reached `life`.
/// Where a rounding decides between two neighbouring shades, either is right.
/// @param age     [s], not negative
/// @param life    all of it [s], positive; not the life of one shade
/// @param shades  any whole number from 1; with two billion of them, a loop over all would take seconds
/// @throws std::invalid_argument if a parameter is not as it must be, or if `age` or `life` is not a number within ±1e5.
std::optional<int> shade(double age, double life, int shades);

//> A step
/// What acts on all particles, and the picture: a particle outside of it is dead.
struct World {
    double gravity{}; ///< downwards [m/s²]; negative: upwards
    double wind{};    ///< to the right, an acceleration as well [m/s²]; negative: to the left
    double width{};   ///< of the picture [m], positive; 0 belongs to it, `width` does not
    double height{};  ///< of the picture [m], positive; 0 belongs to it, `height` does not
    COURSE_FIELDS("m/s², m/s², m, m", gravity, wind, width, height)
};

/// The particle one step of `dt` later. The scheme is semi-implicit: first the velocity changes, then the position, by
/// the new velocity. Then it is `dt` older. Nothing if it is dead by then: outside of the picture, or at its life's end.
/// Where it was before does not matter. Where a rounding decides whether it is dead, either is right.
/// @param dt  [s], not negative
/// @throws std::invalid_argument as `require_particle` says, if the picture's width or height is not positive, if `dt`
///         is negative, or if anything is not a number within ±1e5.
std::optional<Particle> step(const Particle &particle, const World &world, double dt);

//> A ring
/// The velocities [m/s] of particles that leave in all directions: all as fast as `speed`, and with the same angle from
/// each to the next. In order, against the clock; the first one in the direction `first`.
/// @param count  how many, not negative; 0: an empty list
/// @param speed  [m/s], not negative
/// @param first  [rad]; 0 is to the right
/// @throws std::invalid_argument if `count` or `speed` is negative, or if `speed` or `first` is not a number within ±1e5.
std::vector<Vec2> ring(int count, double speed, double first);

//> An explosion
/// Velocities [m/s], spread evenly over a disc of the radius `fastest`: equal areas get equal shares.
/// @param chances  numbers from 0 up to, but without, 1: two for each velocity, one pair after the other. The first of
///                 a pair makes its speed: 0 makes 0, and more makes more. The second makes its angle: 0 is to the
///                 right, and in equal steps it goes once round, against the clock.
/// @param fastest  [m/s], not negative
/// @throws std::invalid_argument if the number of chances is odd, if one is outside of [0, 1), if `fastest` is negative
///         or not a number within ±1e5.
std::vector<Vec2> explosion(const std::vector<double> &chances, double fastest);

//> An emitter
/// What leaves a trail of particles behind, as a rocket does.
struct Emitter {
    Vec2 position;     ///< [m]
    Vec2 velocity;     ///< [m/s]
    double offset{};   ///< along each axis, particles start at most so far from it [m], not negative
    double jitter{};   ///< along each axis, they are at most so much faster or slower than it [m/s], not negative
    double shortest{}; ///< life [s], positive
    double longest{};  ///< life [s], at least `shortest`
    COURSE_FIELDS("m, m/s, m, m/s, s, s", position, velocity, offset, jitter, shortest, longest)
};

/// A particle of the trail, of age 0. It inherits the emitter's velocity, and adds to it what chance says.
/// @param chances  five numbers from 0 up to, but without, 1: for the position's x and y, the velocity's x and y, and
///                 the life. In equal steps each goes from the smallest value there is to the largest.
/// @throws std::invalid_argument if there are not five chances, if one is outside of [0, 1), if a field is not as it
///         must be, or if anything is not a number within ±1e5.
Particle trail(const Emitter &emitter, const std::vector<double> &chances);

//> How many are due?
/// How many particles a frame starts.
struct Due {
    int count{};    ///< whole ones
    double carry{}; ///< what is left of one for the next frame [1], from 0 up to, but without, 1
    COURSE_FIELDS("1, 1", count, carry)
};

/// How many particles of `rate` a second are due in a frame of `dt`. No part of one is lost: `count` and the new carry
/// are together what was carried and what the frame adds. So in any time they are within one of `rate` times it,
/// however it is cut into frames. Where a rounding decides whether one is whole, either is right.
/// @param rate   [1/s], not negative
/// @param carry  what the frame before has left [1], from 0 up to, but without, 1
/// @param dt     [s], not negative
/// @throws std::invalid_argument if a parameter is not as it must be, or not a number within ±1e5, or if `rate` times
///         `dt` is more than 1e6.
Due due(double rate, double carry, double dt);

//> Walls
/// A segment of section 7, 1e-3 m long or more. It turns what comes from its left side, seen as you walk from start to
/// end; what comes from its right passes.
using Wall = segment_intersection::Segment;

/// On a wall, or at its end, means: no farther from it than this [m]. And a particle approaches a wall if it is faster
/// than this towards it [m/s]; else it flies along.
inline constexpr double touching = 1e-9;

/// After so many bounces in one call a particle stays where it is until the call's time is over. It keeps the velocity
/// that its last bounce has given it.
inline constexpr int most_bounces = 1000;

/// The particle `dt` later and older. It flies straight on until it meets a wall: there the part of its velocity along
/// the wall's normal changes its sign and becomes `restitution` times as large, and it flies on for the time that is
/// left. No wall is jumped over, however long `dt` is. What is within `touching` of a wall, on either side, and
/// approaches it in the direction of its right side, bounces at once.
/// Where two walls are met at once, both act, in either order, until it approaches neither.
/// Whether a wall that is met in the very last instant, or within `touching` of its end, or that is `parallel` to the
/// particle's path as section 7 says, has turned it is left open.
/// @param walls        as many as you like
/// @param restitution  [1], from 0 to 1
/// @param dt           [s], not negative
/// @throws std::invalid_argument as `require_particle` says, if a wall is shorter than 1e-3 m, if a parameter is not as
///         it must be, or if anything is not a number within ±1e5.
Particle fly(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt);

//> A pool without gaps
/// The pool without its dead, and with as many newborn as fit.
/// Of n that live, whoever stands in one of the first n places stays there; the others move into the gaps, in any
/// order. Of a b c d e f let a, d and f be dead: then three live, b and c stay, and e moves, which makes e b c.
/// Behind them stand the newborn in their order, as they are, until there are `capacity` in all.
/// @param pool      at most `capacity` particles; dead are those whose age has reached their life
/// @param capacity  not negative; it may be far more than memory has room for
/// @throws std::invalid_argument for any particle as `require_particle` says, or if the capacity is negative, or less
///         than what is in the pool.
std::vector<Particle> renew(const std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity);

//> The exercises
namespace subject {
COURSE_EXERCISE("11.1", core, particles, start, "pool, particle", "")
COURSE_EXERCISE("11.2", core, particles, shade, "age [s], life [s], shades", "1")
COURSE_EXERCISE("11.3", core, particles, step, "particle, world, dt [s]", "")
COURSE_EXERCISE("11.4", stretch, particles, ring, "count, speed [m/s], first [rad]", "m/s")
COURSE_EXERCISE("11.5", stretch, particles, explosion, "chances [1], fastest [m/s]", "m/s")
COURSE_EXERCISE("11.6", stretch, particles, trail, "emitter, chances [1]", "")
COURSE_EXERCISE("11.7", stretch, particles, due, "rate [1/s], carry [1], dt [s]", "")
COURSE_EXERCISE("11.8", challenge, particles, fly, "particle, walls, restitution [1], dt [s]", "")
COURSE_EXERCISE("11.9", challenge, particles, renew, "pool, newborn, capacity", "")
} // namespace subject
//>
} // namespace particles
