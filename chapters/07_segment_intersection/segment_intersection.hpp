#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 7: where, and whether, straight motions and walls meet.
/// Numbers that go in are within ±1e5; an answer may be larger.
/// Twelve digits must be right; where fewer will do, the tests say.
namespace segment_intersection {

using course::Vec2;

//> A segment
/// The straight piece between two points, both ends included. Shorter than 1e-60 m, it may count as a single point.
struct Segment {
    Vec2 start; ///< [m]
    Vec2 end;   ///< [m]
    COURSE_FIELDS("m, m", start, end)
};

//> A line intersection
/// The point where two lines intersect, and how far along each of them it is.
struct LineIntersection {
    double t{}; ///< parameter along the motion [1]: 0 at its start, 1 at its end
    double s{}; ///< parameter along the wall [1]: 0 at its start, 1 at its end
    Vec2 point; ///< [m]
    COURSE_FIELDS("1, 1, m", t, s, point)
};

//> Where two lines intersect
/// Where the line through `motion` intersects the line through `wall`, even when that's beyond their ends.
/// Nothing when the lines are parallel, or when one of the two segments is a single point.
std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall);

//> Parallel, within rounding
/// Two lines count as parallel when the sine of the angle between them, |det(a, b)| / (|a| |b|), is at most this.
inline constexpr double parallel_tolerance = 1e-12;

//> Do they meet?
/// Whether two segments have a point in common. Their ends belong to them, so touching counts. With whole numbers up to
/// ±1000 that's exact. With decimals, rounding may make a gap of a touch: of a hundred points that `intersect_lines`
/// returns for segments that cross, ours finds eight on both.
bool segments_intersect(const Segment &first, const Segment &second);

//> What they have in common
/// The points that two segments have in common [m]: none, one, or both ends of the piece where they overlap, in the
/// order `first` runs through them. What counts as touching is as in `segments_intersect`.
std::vector<Vec2> common_points(const Segment &first, const Segment &second);

//> A ball
/// A ball so small that it counts as a point.
struct Ball {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    COURSE_FIELDS("m, m/s", position, velocity)
};

//> A ball in a room
/// The ball `dt` seconds later, in a room with smooth, elastic walls. Each wall it gets to reverses the normal part of
/// its velocity, and the ball flies on for the time that's left. A wall only acts on a ball that's on it or inside, and
/// approaches it; from outside, a ball flies in through it. In a corner both walls act, one after the other in either
/// order, until the ball approaches neither. At a wall exactly at the end of `dt`, either velocity will do.
/// @param room  its corners in order, either way round: a wall joins each to the next, and the last to the first. No
///              two walls may cross, and nobody checks that.
/// @param dt    [s], not negative
/// @throws std::invalid_argument if there are fewer than three corners, if one equals the next, or if `dt` is negative.
Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt);

//> On a wall, and for how long
/// A ball this near to a wall, or to its end, is on it [m].
inline constexpr double contact_tolerance = 1e-9;

/// After this many bounces in one call, the ball stays where it is until the time's up, and keeps its velocity.
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
/// A wall that's a single point is a post; a disc of radius 0 is a point. Nothing when it never touches the wall. When
/// it touches or overlaps the wall at its start: t = 0 if its centre is getting closer, and nothing if it isn't.
/// @param radius  [m], not negative
/// @throws std::invalid_argument if the radius is negative.
std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall);

//> Orientation
/// Which side of `first` the second segment points to, by the sign of D = a.x b.y - a.y b.x [m²], where a and b are
/// their displacements: 1 for left, -1 for right, 0 when they're parallel, or too close to parallel to tell.
/// D is the exact value for the eight numbers as they're stored. Never the wrong sign when |D| > 1e-300 m², and 0 only
/// when |D| <= 1e-15 (|a.x b.y| + |a.y b.x|) + 1e-300 m².
int orientation(const Segment &first, const Segment &second);

//>
namespace subject {
COURSE_EXERCISE("7.1", core, segment_intersection, intersect_lines, "motion [m], wall [m]", "")
COURSE_EXERCISE("7.2", core, segment_intersection, segments_intersect, "first [m], second [m]", "")
COURSE_EXERCISE("7.3", stretch, segment_intersection, common_points, "first [m], second [m]", "m")
COURSE_EXERCISE("7.4", stretch, segment_intersection, move_and_bounce, "ball, room [m], dt [s]", "")
COURSE_EXERCISE("7.5", challenge, segment_intersection, time_of_impact, "motion [m], radius [m], wall [m]", "")
COURSE_EXERCISE("7.6", challenge, segment_intersection, orientation, "first [m], second [m]", "1")
} // namespace subject
} // namespace segment_intersection
