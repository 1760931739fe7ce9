#include "segment_intersection.hpp"

#include <algorithm>
#include <cmath>

namespace segment_intersection {

//> Solution: a determinant
/// The signed area of the parallelogram that a and b span [m²]: positive if b points to the left of a.
static double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

//> Solution 7.1: where two lines intersect
std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall) {
    const Vec2 a = motion.end - motion.start;
    const Vec2 b = wall.end - wall.start;
    const Vec2 gap = wall.start - motion.start;

    const double d = det(a, b);
    if (std::abs(d) <= parallel_tolerance * a.norm() * b.norm()) return {};

    const double t = det(gap, b) / d;
    const double s = det(gap, a) / d;
    return LineIntersection{t, s, motion.start + t * a};
}

//> Solution: are they apart?
/// Positive if `point` lies to the left of `line`, negative if to the right, 0 if on it.
static double side(const Segment &line, const Vec2 &point) { return det(line.end - line.start, point - line.start); }

/// Whether both ends of `other` lie on one side of `line`, and neither of them on it.
static bool on_one_side(const Segment &line, const Segment &other) {
    const double u = side(line, other.start);
    const double v = side(line, other.end);
    return (u > 0 && v > 0) || (u < 0 && v < 0);
}

/// Whether there is a gap between the range from a to b and the range from c to d.
static bool gap_between(double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
}

static bool apart(const Segment &first, const Segment &second) {
    if (gap_between(first.start.x(), first.end.x(), second.start.x(), second.end.x())) return true;
    if (gap_between(first.start.y(), first.end.y(), second.start.y(), second.end.y())) return true;
    return on_one_side(first, second) || on_one_side(second, first);
}

//> Solution 7.2: do they meet?
bool segments_intersect(const Segment &first, const Segment &second) {
    return !apart(first, second); // then they share a point
}

//> Solution 7.3: what they have in common
std::vector<Vec2> common_points(const Segment &first, const Segment &second) {
    if (apart(first, second)) return {};

    const Vec2 a = first.end - first.start;
    const Vec2 b = second.end - second.start;
    const double square = a.squaredNorm();
    if (square == 0) return {first.start};

    const double d = det(a, b);
    if (std::abs(d) > parallel_tolerance * a.norm() * b.norm()) { // they cross, between the ends of both
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

/// The first wall that reflects the ball within `time`. `winding` is 1 if the corners run anticlockwise, else -1.
static std::optional<Hit> next_wall(const Ball &ball, const std::vector<Vec2> &room, double winding, double time) {
    std::optional<Hit> first;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 wall = room[(i + 1) % room.size()] - room[i];
        const double length = wall.norm();
        const Vec2 along = wall / length;
        const Vec2 inward = winding * Vec2{-along.y(), along.x()};

        const double closing = -ball.velocity.dot(inward);
        const double distance = (ball.position - room[i]).dot(inward);
        if (closing <= 0 || distance < -contact_tolerance) continue; // not approaching, or coming from outside

        const double t = std::max(0.0, distance / closing);
        if (t > time || (first && t >= first->time)) continue;
        const double s = (ball.position + t * ball.velocity - room[i]).dot(along);
        if (s >= -contact_tolerance && s <= length + contact_tolerance) first = Hit{t, inward, closing};
    }
    return first;
}

//> Solution 7.4: a ball in a room
Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt) {
    course::require(dt >= 0, "dt [s] must not be negative", dt);
    course::require(room.size() >= 3, "the number of corners must be three or more", double(room.size()));
    for (std::size_t i = 0; i < room.size(); ++i)
        course::require(room[i] != room[(i + 1) % room.size()], "the length of a wall [m] must be positive", 0);

    double area = 0; // twice the room's, positive if its corners run anticlockwise
    for (std::size_t i = 0; i < room.size(); ++i) area += det(room[i] - room[0], room[(i + 1) % room.size()] - room[0]);

    Ball now = ball;
    for (int bounces = 0; bounces < max_bounces; ++bounces) {
        const auto hit = next_wall(now, room, area < 0 ? -1 : 1, dt);
        now.position += (hit ? hit->time : dt) * now.velocity;
        if (!hit) break;
        now.velocity += 2 * hit->closing * hit->inward;
        dt -= hit->time; // the rest of the frame
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

//> Solution 7.5: the time of impact
std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall) {
    course::require(radius >= 0, "radius [m] must not be negative", radius);

    const Vec2 path = motion.end - motion.start;
    const Vec2 away = motion.start - nearest(wall, motion.start);
    if (path.dot(away) >= 0) return {}; // a wall is convex: what is not getting closer now never will

    double t = away.norm() <= radius ? 0 : 2; // 2: not within this motion
    if (t > 0) {
        // the side: a line, one radius in front of the wall
        const Vec2 along = wall.end - wall.start;
        const double sign = det(along, motion.start - wall.start) < 0 ? -1 : 1;
        const double height = sign * det(along, motion.start - wall.start) - radius * along.norm();
        const double closing = -sign * det(along, path); // both times the wall's length
        if (closing > 0 && height >= 0) {
            const double s = (motion.start + height / closing * path - wall.start).dot(along);
            if (s >= 0 && s <= along.squaredNorm()) t = height / closing;
        }
        // the ends: a circle around each
        for (const Vec2 &end : {wall.start, wall.end}) {
            const Vec2 from = motion.start - end;
            const double root = path.squaredNorm() * radius * radius - std::pow(det(path, from), 2);
            const double ahead = -path.dot(from);
            if (ahead > 0 && root >= 0)
                t = std::min(t, (from.squaredNorm() - radius * radius) / (ahead + std::sqrt(root)));
        }
    }
    if (t > 1) return {};
    const Vec2 centre = motion.start + t * path;
    return Impact{t, centre, nearest(wall, centre)};
}

//> Solution 7.6: a sign you can trust
int orientation(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start;
    const Vec2 b = second.end - second.start;

    const double left = a.x() * b.y();
    const double right = a.y() * b.x();
    const double doubt = 5e-16 * (std::abs(left) + std::abs(right)) + 1e-301; // four and a half roundings
    const double d = left - right;
    return d > doubt ? 1 : d < -doubt ? -1 : 0;
}
//>
} // namespace segment_intersection
