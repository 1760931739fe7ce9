#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 2: what forces do to a cart, and what two carts do to each other.
/// The carts roll on a straight rail, so their velocities are numbers: positive to the right, negative to the left.
/// Numbers that go in are within ±1e5; an answer may be larger.
/// Twelve digits must be right; where fewer will do, the tests say.
namespace momentum {

using course::Vec2;

//> Acceleration due to forces
/// The acceleration of a body while all these forces act on it together [m/s²]: (0, 0) when there are none.
/// @param forces  [N], any number of them
/// @param mass    [kg], more than 0
/// @throws std::invalid_argument if `mass` is not positive.
Vec2 acceleration_due_to(const std::vector<Vec2> &forces, double mass);

//> A cart
/// A cart on the rail.
struct Cart {
    double mass{};     ///< [kg], more than 0
    double velocity{}; ///< [m/s]: positive to the right, negative to the left
    COURSE_FIELDS("kg, m/s", mass, velocity)
};

//> Two velocities
/// The velocities of two carts.
struct Velocities {
    double a{}; ///< [m/s]
    double b{}; ///< [m/s]
    COURSE_FIELDS("m/s, m/s", a, b)
};

//> Elastic collision
/// The velocities of carts a and b after an elastic collision. Cart a is on the left.
/// Carts that don't approach each other don't collide: they keep their velocities.
/// @throws std::invalid_argument if a mass is not positive.
Velocities elastic_collision(const Cart &a, const Cart &b);

//> Collision with restitution
/// The velocities of carts a and b after a collision. Cart a is on the left.
/// Carts that don't approach each other don't collide: they keep their velocities.
/// @param restitution  how fast they part, divided by how fast they approached each other [1], from 0 to 1
/// @throws std::invalid_argument if a mass is not positive, or `restitution` is not within 0 to 1.
Velocities collide(const Cart &a, const Cart &b, double restitution);

//> Seen from the centre of mass
/// Two carts, as you see them when you ride along with their centre of mass.
struct CentreOfMassFrame {
    double velocity{}; ///< of the centre of mass, seen from the rail [m/s]
    double a{};        ///< velocity of cart a, seen from the centre of mass [m/s]
    double b{};        ///< velocity of cart b, seen from the centre of mass [m/s]
    double energy{};   ///< kinetic energy of both, seen from the centre of mass [J]
    COURSE_FIELDS("m/s, m/s, m/s, J", velocity, a, b, energy)
};

//> Centre-of-mass frame
/// Two carts, seen from their centre of mass, whether they approach each other or not. However fast it goes, `a` and
/// `b` are right to twelve digits of the difference of both velocities, and `energy` to its first eleven.
/// @throws std::invalid_argument if a mass is not positive.
CentreOfMassFrame centre_of_mass_frame(const Cart &a, const Cart &b);

//> A body that may be immovable
/// Anything on the rail: a cart, or a wall at its end.
struct Body {
    double inverse_mass{}; ///< 1 divided by its mass [1/kg], not negative; 0 when nothing can move it
    double velocity{};     ///< [m/s]: positive to the right, negative to the left
    COURSE_FIELDS("1/kg, m/s", inverse_mass, velocity)
};

//> Impulse
/// The impulse with which two bodies push each other apart when they collide [N s]. Body a is on the left. The impulse
/// is 0 when they don't approach each other, or when nothing can move either of them.
/// @param restitution  how fast they part, divided by how fast they approached each other [1], from 0 to 1
/// @throws std::invalid_argument if an inverse mass is negative, or `restitution` is not within 0 to 1.
double impulse(const Body &a, const Body &b, double restitution);

//> Newton's cradle
/// The velocities of carts in a row when all is over [m/s]. They nearly touch, so that takes only a moment. They
/// collide elastically, two at a time: the leftmost neighbours that approach each other go next, until none do. An
/// approach slower than 1e-12 of the largest speed may be left alone, since rounding can bring one about forever.
/// Light carts between heavy ones take long: 1e5, 1e-5 and 1e5 kg collide 222 144 times, and 1e5, 1e-5, 1e5, 1e-5 and
/// 1e5 kg more than 400 million times.
/// @param carts  from left to right, any number of them
/// @throws std::invalid_argument if a mass is not positive.
std::vector<double> newtons_cradle(const std::vector<Cart> &carts);

//>
namespace subject {
COURSE_EXERCISE("2.1", core, momentum, acceleration_due_to, "forces [N], mass [kg]", "m/s²")
COURSE_EXERCISE("2.2", core, momentum, elastic_collision, "a, b", "")
COURSE_EXERCISE("2.3", core, momentum, collide, "a, b, restitution [1]", "")
COURSE_EXERCISE("2.4", stretch, momentum, centre_of_mass_frame, "a, b", "")
COURSE_EXERCISE("2.5", stretch, momentum, impulse, "a, b, restitution [1]", "N s")
COURSE_EXERCISE("2.6", challenge, momentum, newtons_cradle, "carts", "m/s")
} // namespace subject
} // namespace momentum
