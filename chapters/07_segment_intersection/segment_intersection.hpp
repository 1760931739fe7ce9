#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 7: where, and whether, straight motions and walls meet.
/// Every number that goes in must lie within ±1e5, both ends included; an answer may be larger.
/// Answers are right to 1e-12, or to 1e-12 of their size where that is more than 1. Nearly parallel lines, a graze, many
/// bounces, and numbers that differ by many powers of ten lose more, and the tests allow for it. A segment shorter than
/// 1e-60 m may count as a single point.
namespace segment_intersection {

using course::Vec2;

//> A segment
/// The straight piece between two points, both ends included.
struct Segment {
    Vec2 start; ///< [m]
    Vec2 end;   ///< [m]
    COURSE_FIELDS("m, m", start, end)
};

//> Where two lines intersect
/// The point at which two lines intersect, and where along each of them it lies.
struct LineIntersection {
    double t{}; ///< parameter along the motion [1]: 0 at its start, 1 at its end
    double s{}; ///< parameter along the wall [1]: 0 at its start, 1 at its end
    Vec2 point; ///< [m]
    COURSE_FIELDS("1, 1, m", t, s, point)
};

/// Where the line through `motion` intersects the line through `wall`, even if that is beyond their ends.
/// Nothing if the lines are parallel, or if one of the two segments is a single point.
/// @throws std::invalid_argument if a coordinate is not within ±1e5.
std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall);

//> Parallel, within rounding
/// Two lines count as parallel if the sine of the angle between them, |det(a, b)| / (|a| |b|), is at most this.
inline constexpr double parallel_tolerance = 1e-12;

//> Do they meet?
/// Whether two segments have a point in common. Their ends belong to them, so touching counts.
/// Exact for whole-number coordinates up to ±1000. For others, a touch or a gap within rounding may go either way.
/// @throws std::invalid_argument if a coordinate is not within ±1e5.
bool segments_intersect(const Segment &first, const Segment &second);

//> What they have in common
/// The points that two segments have in common: none, one, or the two ends of the piece on which they overlap,
/// in the order in which `first` runs through them [m].
/// Their number is exact for whole-number coordinates up to ±1000. For others, rounding may decide it.
/// @throws std::invalid_argument if a coordinate is not within ±1e5.
std::vector<Vec2> common_points(const Segment &first, const Segment &second);

//> A ball
/// A ball so small that it counts as a point.
struct Ball {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    COURSE_FIELDS("m, m/s", position, velocity)
};

//> A ball in a room
/// The ball `dt` seconds later, in a room with smooth, elastic walls. Each wall that it reaches reverses the normal part
/// of its velocity, and the ball moves on for the rest of the time.
/// A wall acts only on a ball that is on it or inside, and approaches it; a ball from outside flies in through it.
/// In a corner both walls act, one after the other in either order, until the ball approaches neither.
/// If the ball reaches a wall exactly at the end of `dt`, its velocity may be the one before or after the bounce.
/// @param room  its corners in order, either way round; a wall joins each to the next, and the last to the first.
///              No two walls may cross; this is not checked.
/// @param dt    [s], not negative
/// @throws std::invalid_argument if there are fewer than three corners, if one equals the next, if `dt` is negative,
///         or if a number is not within ±1e5.
Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt);

//> On a wall, and for how long
/// A ball is on a wall, or at its end, if it is no farther from it than this [m].
inline constexpr double contact_tolerance = 1e-9;

/// After this many bounces in one call, the ball stays where it is until the time is over, and keeps its velocity.
inline constexpr int max_bounces = 1000;

//> An impact
/// When and where a moving disc first touches a wall.
struct Impact {
    double t{};  ///< parameter along the motion [1], from 0 to 1
    Vec2 centre; ///< of the disc at that moment [m]
    Vec2 point;  ///< of the wall, where the disc touches it [m]
    COURSE_FIELDS("1, m, m", t, centre, point)
};

//> Time of impact
/// When and where a disc whose centre moves along `motion` first touches a wall, at its side or at one of its ends.
/// A wall that is a single point is a post; a disc of radius 0 is a point.
/// If the disc touches or overlaps the wall at its start: t = 0 if its centre is getting closer to the wall, and nothing
/// if it is not. Nothing if it never touches the wall.
/// A graze that is decided by rounding may go either way; so may a point that meets only an end of a wall.
/// @param radius  [m], not negative
/// @throws std::invalid_argument if the radius is negative, or if a number is not within ±1e5.
std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall);

//> Orientation
/// The sign of D = a.x b.y - a.y b.x [m²], where a and b are the displacements of the two segments: 1 if `second` points
/// to the left of `first`, -1 if to the right, and 0 if they are parallel, or too close to parallel to tell.
/// Never the wrong sign if |D| > 1e-300 m², and 0 only if |D| <= 1e-15 (|a.x b.y| + |a.y b.x|) + 1e-300 m²,
/// where D is the exact value for the eight numbers as they are stored.
/// @throws std::invalid_argument if a coordinate is not within ±1e5.
int orientation(const Segment &first, const Segment &second);

//> The exercises
namespace subject {
COURSE_EXERCISE("7.1", core, segment_intersection, intersect_lines, "motion [m], wall [m]", "")
COURSE_EXERCISE("7.2", core, segment_intersection, segments_intersect, "first [m], second [m]", "")
COURSE_EXERCISE("7.3", stretch, segment_intersection, common_points, "first [m], second [m]", "m")
COURSE_EXERCISE("7.4", stretch, segment_intersection, move_and_bounce, "ball, room [m], dt [s]", "")
COURSE_EXERCISE("7.5", challenge, segment_intersection, time_of_impact, "motion [m], radius [m], wall [m]", "")
COURSE_EXERCISE("7.6", challenge, segment_intersection, orientation, "first [m], second [m]", "1")
} // namespace subject
//>
} // namespace segment_intersection
