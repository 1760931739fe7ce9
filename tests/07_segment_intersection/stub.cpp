// Section 7, Segment intersection. Replace a whole `throw ...;` with your own code, save, and see:  ./course check 7
// Lines above a `throw` refuse numbers that make no sense; leave them as they are.

#include "segment_intersection.hpp"

#include <algorithm>
#include <cmath>

namespace segment_intersection {

// 7.1 core
std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    throw course::NotYet{"begin with the two displacements, and their determinant"};
}

// 7.2 core
bool segments_intersect(const Segment &first, const Segment &second) {
    throw course::NotYet{"where do their lines intersect, and are t and s both between 0 and 1, ends included?"};
}

// 7.3 stretch
std::vector<Vec2> common_points(const Segment &first, const Segment &second) {
    throw course::NotYet{"if both lie on one line, at which t of the first does the second start, and end?"};
}

// 7.4 stretch
Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    for (std::size_t i = 0; i < room.size(); ++i)
        course::require(room[i] != room[(i + 1) % room.size()], "the length of a wall [m] must be positive", 0);
    throw course::NotYet{"which wall comes first? Move there, reflect the velocity, and go on with the rest of dt"};
}

// 7.5 challenge
std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall) {
    course::require(radius >= 0, "radius [m] must not be negative", radius);
    throw course::NotYet{"where can the centre not be? Draw all points that are one radius away from the wall"};
}

// 7.6 challenge
int orientation(const Segment &first, const Segment &second) {
    throw course::NotYet{"by how much can the computed determinant be off? Only beyond that is its sign certain"};
}

} // namespace segment_intersection
