#include "segment_intersection.hpp"

#include <algorithm>
#include <cmath>

namespace segment_intersection {

//> Solution: a determinant
/// The area of the parallelogram that a and b span [m²], positive if b points to the left of a.
static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

//> Solution 7.1: where two lines cross
std::optional<Crossing> crossing(const Segment &motion, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end);
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = wall.start - motion.start;

    const double d = det(a, b);
    if (std::abs(d) <= parallel * a.norm() * b.norm()) return {}; // the lengths make it a sine, whatever the scale

    const double t = det(gap, b) / d;
    const double s = det(gap, a) / d;
    return Crossing{t, s, motion.start + t * a};
}

//> Solution: are they apart?
/// Positive if `point` lies to the left of `line`, negative to the right, zero on it.
static double side(const Segment &line, const Vec2 &point) { return det(line.end - line.start, point - line.start); }

/// Whether both ends of `other` lie on one side of `line`, and neither on it.
static bool one_sided(const Segment &line, const Segment &other) {
    const auto [low, high] = std::minmax({side(line, other.start), side(line, other.end)});
    return low > 0 || high < 0;
}

/// Whether the two intervals on one axis leave a gap.
static bool gap_along(int axis, const Segment &first, const Segment &second) {
    const auto [low_1, high_1] = std::minmax({first.start[axis], first.end[axis]});
    const auto [low_2, high_2] = std::minmax({second.start[axis], second.end[axis]});
    return high_1 < low_2 || high_2 < low_1;
}

/// The boxes are no mere trick: they alone can part two segments that lie on one line.
static bool apart(const Segment &first, const Segment &second) {
    return gap_along(0, first, second) || gap_along(1, first, second) || one_sided(first, second)
           || one_sided(second, first);
}

//> Solution 7.2: do they meet?
bool meet(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    return !apart(first, second);
}

//> Solution 7.3: what they share
std::vector<Vec2> shared(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    if (apart(first, second)) return {};

    const Vec2 a = first.end - first.start;
    const Vec2 b = second.end - second.start;
    const double square = a.squaredNorm();
    if (square == 0) return {first.start};

    const double d = det(a, b);
    if (std::abs(d) > parallel * a.norm() * b.norm()) { // they cross, and within both
        const double t = det(second.start - first.start, b) / d;
        return {first.start + std::clamp(t, 0.0, 1.0) * a};
    }
    const double t_1 = (second.start - first.start).dot(a) / square; // where along the first the second starts,
    const double t_2 = (second.end - first.start).dot(a) / square;   // and ends
    const double enter = std::max(0.0, std::min(t_1, t_2));
    const double leave = std::min(1.0, std::max(t_1, t_2));
    if (enter >= leave) return {first.start + enter * a};
    return {first.start + enter * a, first.start + leave * a};
}

//> Solution 7.4: the next wall
namespace {
struct Hit {
    double time;    ///< from now [s]
    Vec2 inward;    ///< the wall's unit normal, into the room
    double closing; ///< speed towards the wall [m/s]
};
} // namespace

/// The first wall that turns the mover within `time`. `turn` is 1 if the room's corners run anticlockwise, else -1.
static std::optional<Hit> next_wall(const Mover &mover, const std::vector<Vec2> &room, double turn, double time) {
    std::optional<Hit> first;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 wall = room[(i + 1) % room.size()] - room[i];
        const double length = wall.norm();
        const Vec2 along = wall / length;
        const Vec2 inward = turn * Vec2{-along.y(), along.x()};

        const double closing = -mover.velocity.dot(inward);
        const double distance = (mover.position - room[i]).dot(inward);
        if (closing <= 0 || distance < -touching) continue; // it flies away from it, or along it, or comes from outside

        const double t = std::max(0.0, distance / closing);
        if (t > time || (first && t >= first->time)) continue;
        const double s = (mover.position + t * mover.velocity - room[i]).dot(along);
        if (s >= -touching && s <= length + touching) first = Hit{t, inward, closing};
    }
    return first;
}

//> Solution 7.4: a point in a room
Mover bounce(const Mover &mover, const std::vector<Vec2> &room, double dt) {
    course::require_range(mover.position, mover.velocity, room, dt);
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));

    double area = 0; // twice the room's, positive if its corners run anticlockwise
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 &next = room[(i + 1) % room.size()];
        course::require(room[i] != next, "the length of a wall [m] must be positive", 0);
        area += det(room[i] - room[0], next - room[0]);
    }

    Mover now = mover;
    for (int bounces = 0; bounces < most_bounces; ++bounces) {
        const auto hit = next_wall(now, room, area < 0 ? -1 : 1, dt);
        now.position += (hit ? hit->time : dt) * now.velocity;
        if (!hit) break;
        now.velocity += 2 * hit->closing * hit->inward;
        dt -= hit->time; // what is left is flown, not forgotten
    }
    return now;
}

//> Solution 7.5: the nearest point
/// The point of `wall` that is nearest to `point`.
static Vec2 nearest(const Segment &wall, const Vec2 &point) {
    const Vec2 along = wall.end - wall.start;
    const double square = along.squaredNorm();
    if (square == 0) return wall.start;
    return wall.start + std::clamp((point - wall.start).dot(along) / square, 0.0, 1.0) * along;
}

//> Solution 7.5: a disc meets a wall
std::optional<Touch> first_touch(const Segment &motion, double radius, const Segment &wall) {
    course::require_range(motion.start, motion.end, wall.start, wall.end, radius);
    course::require(radius >= 0, "radius [m] must not be negative", radius);

    const Vec2 way = motion.end - motion.start;
    const Vec2 away = motion.start - nearest(wall, motion.start);
    if (way.dot(away) >= 0) return {}; // no hollow in a wall: what is not coming nearer now never will

    double t = away.norm() <= radius ? 0 : 2; // 2: not within this motion
    if (t > 0) {
        // the side: a line, one radius before the wall
        const Vec2 along = wall.end - wall.start;
        const double turn = det(along, motion.start - wall.start) < 0 ? -1 : 1;
        const double height = turn * det(along, motion.start - wall.start) - radius * along.norm();
        const double closing = -turn * det(along, way); // both times the wall's length
        if (closing > 0 && height >= 0) {
            const double s = (motion.start + height / closing * way - wall.start).dot(along);
            if (s >= 0 && s <= along.squaredNorm()) t = height / closing;
        }
        // the ends: a circle round each
        for (const Vec2 &end : {wall.start, wall.end}) {
            const Vec2 from = motion.start - end;
            const double root = way.squaredNorm() * radius * radius - std::pow(det(way, from), 2);
            const double ahead = -way.dot(from);
            if (ahead > 0 && root >= 0)
                t = std::min(t, (from.squaredNorm() - radius * radius) / (ahead + std::sqrt(root)));
        }
    }
    if (t > 1) return {};
    const Vec2 centre = motion.start + t * way;
    return Touch{t, centre, nearest(wall, centre)};
}

//> Solution 7.6: which way does it turn?
int turn(const Segment &first, const Segment &second) {
    course::require_range(first.start, first.end, second.start, second.end);
    const Vec2 a = first.end - first.start;
    const Vec2 b = second.end - second.start;

    const double left = a.x() * b.y();
    const double right = a.y() * b.x();
    const double doubt = 5e-16 * (std::abs(left) + std::abs(right)) + 1e-301; // four and a half roundings; see the text
    const double d = left - right;
    return d > doubt ? 1 : d < -doubt ? -1 : 0;
}
//>
} // namespace segment_intersection
