#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <vector>

/// Section 2: what forces do to a cart, and what two carts do to each other.
/// The carts roll on a straight rail, so their velocities are numbers: positive to the right, negative to the left.
/// Each number that goes in must be within ±1e5, both ends included; an answer may be larger.
/// An answer is right to twelve digits of the largest velocity that it is made of, or of the sizes of all forces added up
/// (of a thousand at most), unless its function says otherwise.
/// After a collision, one digit fewer may be right for each factor of ten by which one mass is larger than the other;
/// with masses below 1e-9 kg any answer may be right to fewer.
namespace momentum {

using course::Vec2;

//> Acceleration due to forces
/// The acceleration of a body while all of these forces act on it together [m/s²]. Without forces it is (0, 0).
/// @param forces  [N], any number of them
/// @param mass    [kg], more than 0
/// @throws std::invalid_argument if `mass` is not positive, or a number is not within ±1e5.
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
/// The velocities of cart a and cart b after they have collided elastically, with cart a on the left of cart b.
/// Carts that do not approach each other do not collide: their velocities stay as they are.
/// @throws std::invalid_argument if a mass is not positive, or a number is not within ±1e5.
Velocities elastic_collision(const Cart &a, const Cart &b);

//> Collision with restitution
/// The velocities of cart a and cart b after they have collided, with cart a on the left of cart b.
/// Carts that do not approach each other do not collide: their velocities stay as they are.
/// @param restitution  the speed at which they part, divided by that at which they approached [1], from 0 to 1
/// @throws std::invalid_argument if a mass is not positive, `restitution` is not within 0 to 1, or a number is not
///         within ±1e5.
Velocities collide(const Cart &a, const Cart &b, double restitution);

//> Seen from the centre of mass
/// Two carts, as seen by somebody who moves along with their centre of mass.
struct CentreOfMassFrame {
    double velocity{}; ///< of the centre of mass, seen from the rail [m/s]
    double a{};        ///< velocity of cart a, seen from the centre of mass [m/s]
    double b{};        ///< velocity of cart b, seen from the centre of mass [m/s]
    double energy{};   ///< kinetic energy of both, seen from the centre of mass [J]
    COURSE_FIELDS("m/s, m/s, m/s, J", velocity, a, b, energy)
};

//> Centre-of-mass frame
/// Two carts, seen from their centre of mass, whether they approach each other or not.
/// `a` and `b` are right to twelve digits of the difference of the two velocities, and `energy` to its first eleven
/// digits, however fast the centre of mass is.
/// @throws std::invalid_argument if a mass is not positive, or a number is not within ±1e5.
CentreOfMassFrame centre_of_mass_frame(const Cart &a, const Cart &b);

//> A body that may be immovable
/// Anything on the rail: a cart, or a wall at its end.
struct Body {
    double inverse_mass{}; ///< 1 divided by its mass [1/kg], not negative; 0 if nothing can move it
    double velocity{};     ///< [m/s]: positive to the right, negative to the left
    COURSE_FIELDS("1/kg, m/s", inverse_mass, velocity)
};

//> Impulse
/// The impulse that two bodies exert on each other when they collide, with body a on the left of body b [N s]: it pushes a
/// to the left and b to the right. 0 if they do not approach each other, or if nothing can move either of them.
/// Its first twelve digits are right if each inverse mass is 0, or 1e-9 per kg or more.
/// @param restitution  the speed at which they part, divided by that at which they approached [1], from 0 to 1
/// @throws std::invalid_argument if an inverse mass is negative, `restitution` is not within 0 to 1, or a number is not
///         within ±1e5.
double impulse(const Body &a, const Body &b, double restitution);

//> Newton's cradle
/// The velocities of carts in a row, after all of their collisions [m/s].
/// The gaps between them are so small that all of this happens in one moment. All collisions are elastic, and of two carts
/// each: whenever neighbours approach each other, the leftmost such pair collides next, until there is none. An approach
/// slower than 1e-12 of the largest speed may be left alone: rounding can bring one about again and again, without end.
/// Right to ten digits of the largest velocity for up to ten carts with masses from 0.1 to 10 kg, and for up to a hundred
/// of equal mass. For other rows fewer digits may be right, and with a very light cart between heavy ones it may take hours.
/// @param carts  from left to right, any number of them
/// @throws std::invalid_argument if a mass is not positive, or a number is not within ±1e5. A velocity that grows beyond
///         ±1e5 in a collision may be refused, too.
std::vector<double> newtons_cradle(const std::vector<Cart> &carts);

//> The exercises
namespace subject {
COURSE_EXERCISE("2.1", core, momentum, acceleration_due_to, "forces [N], mass [kg]", "m/s²")
COURSE_EXERCISE("2.2", core, momentum, elastic_collision, "a, b", "")
COURSE_EXERCISE("2.3", core, momentum, collide, "a, b, restitution [1]", "")
COURSE_EXERCISE("2.4", stretch, momentum, centre_of_mass_frame, "a, b", "")
COURSE_EXERCISE("2.5", stretch, momentum, impulse, "a, b, restitution [1]", "N s")
COURSE_EXERCISE("2.6", challenge, momentum, newtons_cradle, "carts", "m/s")
} // namespace subject
//>
} // namespace momentum
