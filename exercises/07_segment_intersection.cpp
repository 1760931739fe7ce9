// Section 7, Segment intersection. Replace a whole `throw ...;` by your own code, save, and see:  ./course check 7
// Bad input is refused in one line:
//     course::require_range(motion.start, motion.end, wall.start, wall.end);
//     course::require(dt >= 0, "dt [s] must not be negative", dt);

#include "segment_intersection.hpp"

#include <algorithm>
#include <cmath>

namespace segment_intersection {

// 7.1 core
std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    throw course::NotYet{"start from the two vectors along the segments, and from their determinant"};
}

// 7.2 core
bool meet(const Segment &first, const Segment &second) {
    throw course::NotYet{"on which side of the first do the ends of the second lie, and the other way round?"};
}

// 7.3 stretch
std::vector<Vec2> shared(const Segment &first, const Segment &second) {
    throw course::NotYet{"if they lie on one line, where along the first do the ends of the second come?"};
}

// 7.4 stretch
Mover bounce(const Mover &mover, const std::vector<Vec2> &room, double dt) {
    throw course::NotYet{"which of the walls ahead is first? Go there, turn, and go on with the time that is left"};
}

// 7.5 challenge
std::optional<Touch> first_touch(const Segment &motion, double radius, const Segment &wall) {
    throw course::NotYet{"where may the centre not go? Draw all points that are one radius away from the wall"};
}

// 7.6 challenge
int turn(const Segment &first, const Segment &second) {
    throw course::NotYet{"by how much can a computed determinant be off? Below that, do not claim a sign"};
}

} // namespace segment_intersection
