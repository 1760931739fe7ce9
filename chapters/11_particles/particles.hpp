#pragma once
#include "../07_segment_intersection/segment_intersection.hpp"
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 11: particles, many small things that are spawned, move, change colour and die. Numbers that go in are
/// within ±1e5, but for counts; an answer may be larger. Twelve digits must be right; where fewer will do, the tests say.
namespace particles {

using course::Vec2;

//> A particle
/// A point that moves, grows older, and dies.
struct Particle {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    double age{};  ///< how long it's been alive [s], not negative
    double life{}; ///< how old it gets [s], more than 0: as soon as `age` reaches it, the particle is dead
    COURSE_FIELDS("m, m/s, s, s", position, velocity, age, life)
};

//>
/// Refuses a particle that makes no sense. A dead one does.
/// @throws std::invalid_argument if its age is negative, or its life is not positive.
inline void require_particle(const Particle &particle) {
    course::require(particle.age >= 0, "age [s] must not be negative", particle.age);
    course::require(particle.life > 0, "life [s] must be positive", particle.life);
}

//> A pool
/// A fixed number of slots. Each holds a particle, or nothing: then it's free.
using Pool = std::vector<std::optional<Particle>>;

//> A free slot
/// The number of a slot that's free; if several are, any one of them will do. Nothing if none is: the pool doesn't grow,
/// and no other particle has to go. A dead one keeps its slot until the game makes it free.
std::optional<int> free_slot(const Pool &pool);

//> Life and colour
/// Which of the shades 0, 1, … `shades` - 1 a particle shows at this age. Each is shown for the same part of its life.
/// Nothing when the particle is dead: its age has reached its life.
/// @param age     [s], not negative
/// @param life    how old it gets [s], more than 0; not the time for one shade
/// @param shades  how many, at least 1; there may be a billion, so don't loop over them
/// @throws std::invalid_argument if one of these is out of its range.
std::optional<int> shade_index(double age, double life, int shades);

//> The world
/// What pulls on all particles, and the picture: a particle outside it is dead.
struct World {
    double gravity{}; ///< downwards [m/s²]; negative: upwards
    double wind{};    ///< to the right, an acceleration too [m/s²]; negative: to the left
    double width{};   ///< of the picture [m], more than 0; x = 0 belongs to it, x = `width` doesn't
    double height{};  ///< of the picture [m], more than 0; y = 0 belongs to it, y = `height` doesn't
    COURSE_FIELDS("m/s², m/s², m, m", gravity, wind, width, height)
};

//> A step
/// The particle `dt` later, by one step of semi-implicit Euler: first its velocity changes, then its position, by the
/// new velocity; and it's `dt` older. Nothing if it's dead after the step: outside the picture, or at the end of its
/// life. Where it was before doesn't matter.
/// @param dt  [s], not negative
/// @throws std::invalid_argument if the particle or the world makes no sense, or `dt` is negative.
std::optional<Particle> step(const Particle &particle, const World &world, double dt);

//> A ring
/// Velocities in all directions, each as fast as `speed` [m/s]: once around, anticlockwise, with the same angle from
/// each to the next.
/// @param count  how many, not negative; 0 gives an empty list
/// @param speed  [m/s], not negative
/// @param first  the angle of the first one [rad]; 0 is to the right
/// @throws std::invalid_argument if `count` or `speed` is negative.
std::vector<Vec2> ring_burst(int count, double speed, double first);

//>
/// @throws std::invalid_argument if one of them is less than 0, is 1 or more, or is not a number.
inline void require_random_numbers(const std::vector<double> &random_numbers) {
    for (const double number : random_numbers)
        course::require(number >= 0 && number < 1, "a random number must be at least 0 and less than 1", number);
}

//> A disc
/// Velocities, spread evenly over a disc of radius `max_speed` [m/s]: equal areas hold equal numbers of them.
/// @param random_numbers  a pair for each velocity, each at least 0 and less than 1. The first sets the speed: 0 gives
///                        0, and a larger number a larger speed. The second sets the angle: 0 is to the right, and up
///                        to 1 it goes evenly once around, anticlockwise.
/// @param max_speed       [m/s], not negative
/// @throws std::invalid_argument if one of these is out of its range, or a random number has no partner.
std::vector<Vec2> disc_burst(const std::vector<double> &random_numbers, double max_speed);

//> An emitter
/// Something that leaves a trail of particles, as a rocket does.
struct Emitter {
    Vec2 position;     ///< [m]
    Vec2 velocity;     ///< [m/s]
    double offset{};   ///< along each axis, a particle starts at most this far from it [m], not negative
    double jitter{};   ///< along each axis, a particle is at most this much faster or slower [m/s], not negative
    double min_life{}; ///< of a particle [s], more than 0
    double max_life{}; ///< of a particle [s], at least `min_life`
    COURSE_FIELDS("m, m/s, m, m/s, s, s", position, velocity, offset, jitter, min_life, max_life)
};

//> Emit
/// One newborn particle of the trail. It has the emitter's velocity, and the random numbers vary it.
/// @param random_numbers  five, each at least 0 and less than 1: for the position's x and y, the velocity's x and y,
///                        and the life. From 0 to 1, each goes evenly from its smallest value to its largest.
/// @throws std::invalid_argument if the emitter makes no sense, or there aren't five random numbers in that range.
Particle emit(const Emitter &emitter, const std::vector<double> &random_numbers);

//> How many this frame?
/// How many particles a frame emits.
struct Emission {
    int count{};        ///< whole particles
    double remainder{}; ///< the part of a particle left for the next frame [1], at least 0 and less than 1
    COURSE_FIELDS("1, 1", count, remainder)
};

//> Emission count
/// How many particles a frame of `dt` emits at `rate` per second. Nothing is lost: `count` plus the new remainder is
/// the old remainder plus what this frame adds. So however you slice the time into frames, the total is `rate` times
/// the time, give or take one.
/// @param rate       [1/s], not negative
/// @param remainder  what the frame before left over [1], at least 0 and less than 1
/// @param dt         [s], not negative, and `rate` times `dt` is at most 1e6
/// @throws std::invalid_argument if one of these is out of its range.
Emission emission_count(double rate, double remainder, double dt);

//> A wall
/// A segment of section 7, at least 1e-3 m long. Walk from its start to its end: particles that come from your left
/// bounce off it, and those from your right pass through.
using Wall = segment_intersection::Segment;

//> Two limits
/// Within this distance of a wall, or of its end, a particle is on it [m]. The same number is a speed, too [m/s]: a wall
/// acts on a particle that comes at it faster than this.
inline constexpr double contact_tolerance = 1e-9;

/// After so many bounces in one call, a particle stays where it is, and keeps the velocity of its last bounce.
inline constexpr int max_bounces = 1000;

//>
/// @throws std::invalid_argument if the wall is shorter than 1e-3 m.
inline void require_wall(const Wall &wall) {
    const double length = (wall.end - wall.start).norm();
    course::require(length >= 1e-3, "a wall's length [m] must be at least 1e-3", length);
}

//> Move and collide
/// The particle `dt` later, and `dt` older. It flies straight, bounces off each wall that it hits, and flies on.
/// A bounce reverses the part of the velocity along the wall's normal, times `restitution`, and keeps the rest.
/// A wall acts only on a particle that moves from the wall's left to its right.
/// Rounding may have left it a little beyond the wall: up to `contact_tolerance`, and while it still moves to the right,
/// it bounces at once. It never skips a wall, however long `dt` is.
/// Where it hits two walls at once, both act, in either order, until it approaches neither.
/// @param restitution  from 0 to 1 [1]
/// @param dt           [s], not negative
/// @throws std::invalid_argument if the particle or a wall makes no sense, or one of these is out of its range.
Particle move_and_collide(const Particle &particle, const std::vector<Wall> &walls, double restitution, double dt);

//> A pool without gaps
/// The pool without its dead particles, and with as many of the newborn as fit. If n particles survive, those in the
/// first n places stay there, and the others move into the gaps, in any order. Of a b c d e f, let a, d and f be dead:
/// three survive, b and c stay, and e moves, which gives e b c. Behind them come the newborn, unchanged and in their
/// order, until there are `capacity` particles in all.
/// @param pool      at most `capacity` particles; those whose age has reached their life are dead
/// @param capacity  at least the pool's size; it may be far more than memory has room for
/// @throws std::invalid_argument if a particle makes no sense, or `capacity` is less than the pool's size.
std::vector<Particle> compact_pool(const std::vector<Particle> &pool, const std::vector<Particle> &newborn,
                                   int capacity);

//> A rocket
/// It waits, takes off, and bursts as soon as it no longer rises.
struct Rocket {
    double wait{};                      ///< until it takes off [s], not negative; 0: it's in the air
    Vec2 position;                      ///< where it is, or takes off [m]; the street is at y = 0, and it's never below
    Vec2 velocity;                      ///< its own, or the one it takes off with [m/s]
    std::vector<double> random_numbers; ///< a pair for each of its sparks, as `disc_burst` takes them
    COURSE_FIELDS("s, m, m/s, 1", wait, position, velocity, random_numbers)
};

//> A show
struct Show {
    std::vector<Rocket> rockets;  ///< those that haven't burst yet
    std::vector<Particle> sparks; ///< those that glow, in any order
    int shown{};                  ///< how many sparks have found a place so far
    int lost{};                   ///< how many haven't
    int most{};                   ///< the most that have glowed at one time so far
    COURSE_FIELDS(", , 1, 1, 1", rockets, sparks, shown, lost, most)
};

/// What stays the same from frame to frame.
struct Rules {
    double gravity{}; ///< downwards [m/s²], more than 0
    int places{};     ///< so many sparks can glow at one time, not negative
    double speed{};   ///< the most that a burst adds to a spark's velocity [m/s], not negative
    double life{};    ///< of each spark [s], more than 0
    COURSE_FIELDS("m/s², 1, m/s, s", gravity, places, speed, life)
};

//>
/// @throws std::invalid_argument if one of these makes no sense.
inline void require_show(const Show &show, const Rules &rules, double dt) {
    for (const auto &[wait, position, velocity, random_numbers] : show.rockets) {
        course::require(wait >= 0, "wait [s] must not be negative", wait);
        course::require(position.y() >= 0, "a rocket must not be below the street", position.y());
        require_random_numbers(random_numbers);
        course::require(random_numbers.size() % 2 == 0, "random numbers must come in pairs",
                        double(random_numbers.size()));
    }
    for (const Particle &spark : show.sparks) {
        require_particle(spark);
        course::require(spark.position.y() >= 0, "a spark must not be below the street", spark.position.y());
    }
    course::require(rules.gravity > 0, "gravity [m/s²] must be positive", rules.gravity);
    course::require(int(show.sparks.size()) <= rules.places, "places must not be fewer than the sparks", rules.places);
    course::require(int(show.sparks.size()) <= show.most, "most must not be less than the sparks", show.most);
    course::require(rules.speed >= 0, "speed [m/s] must not be negative", rules.speed);
    course::require(rules.life > 0, "life [s] must be positive", rules.life);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
}

//> Run a show
/// The show `dt` later, and the same at any frame rate: within `dt`, things happen when they're due, one after the
/// other, and what's due at its very end has happened. Rockets in the air and sparks fall freely, on exact parabolas.
///
/// A rocket bursts at the moment when it no longer rises, at take-off if it doesn't rise at all. Then it's gone, and in
/// its place are sparks of age 0, each with the rocket's velocity plus one of its `disc_burst`, in that order, as long as
/// there are places; the others are lost.
///
/// A spark goes out, and frees its place, at the moment when its age reaches its life, or when it falls below the street.
///
/// At the same moment, sparks go out first, and then rockets burst, the first in the list first. Those that haven't
/// burst keep their order.
/// @param dt  [s], not negative
/// @throws std::invalid_argument if the show or the rules make no sense, or `dt` is negative.
Show run_show(Show now, const Rules &rules, double dt);

//>
namespace subject {
COURSE_EXERCISE("11.1", core, particles, free_slot, "pool", "1")
COURSE_EXERCISE("11.2", core, particles, shade_index, "age [s], life [s], shades", "1")
COURSE_EXERCISE("11.3", core, particles, step, "particle, world, dt [s]", "")
COURSE_EXERCISE("11.4", stretch, particles, ring_burst, "count, speed [m/s], first [rad]", "m/s")
COURSE_EXERCISE("11.5", stretch, particles, disc_burst, "random_numbers [1], max_speed [m/s]", "m/s")
COURSE_EXERCISE("11.6", stretch, particles, emit, "emitter, random_numbers [1]", "")
COURSE_EXERCISE("11.7", stretch, particles, emission_count, "rate [1/s], remainder [1], dt [s]", "")
COURSE_EXERCISE("11.8", challenge, particles, move_and_collide, "particle, walls, restitution [1], dt [s]", "")
COURSE_EXERCISE("11.9", challenge, particles, compact_pool, "pool, newborn, capacity", "")
COURSE_EXERCISE("11.10", challenge, particles, run_show, "now, rules, dt [s]", "")
} // namespace subject
//>
} // namespace particles
