#pragma once
#include "../course.hpp"
#include "../interface.hpp"

#include <optional>
#include <vector>

/// Section 7: where, and whether, two straight ways meet.
/// A number that goes in must lie within ±1e5, both ends included; an answer may be larger.
/// An answer is right to 1e-12, or to 1e-12 of its size where that is more than 1. Nearly parallel lines, a graze, many
/// bounces, and numbers that differ by many powers of ten lose more, and the tests allow for it.
namespace segment_intersection {

using course::Vec2;

//> A segment
/// A straight way from one point to another; both ends belong to it. It may be a single point, and one that is shorter
/// than 1e-60 m may count as one.
struct Segment {
    Vec2 start; ///< [m]
    Vec2 end;   ///< [m]
    COURSE_FIELDS("m, m", start, end)
};

//> Where two lines cross
/// Where a motion crosses the line of a wall.
struct LineIntersection {
    double t{}; ///< how much of the motion is over [1]: 0 at its start, 1 at its end
    double s{}; ///< how far along the wall [1]: 0 at its start, 1 at its end
    Vec2 point; ///< [m]
    COURSE_FIELDS("1, 1, m", t, s, point)
};

/// Two lines count as parallel if the sine of the angle between them is at most this.
inline constexpr double parallel_tolerance = 1e-12;

/// Where the line through `motion` crosses the line through `wall`; lines go on beyond the ends of their segments.
/// Nothing if the lines are parallel, or if one of the two segments is a point.
/// @throws std::invalid_argument if a number is not within ±1e5.
std::optional<LineIntersection> intersect_lines(const Segment &motion, const Segment &wall);

//> Do they meet?
/// Whether two segments have a point in common. Ends belong to them, so touching is meeting.
/// On a grid (whole numbers from -1000 to 1000, all times one power of two, 1e-60 or more) the answer is exact.
/// Off it, where a gap or an overlap is no wider than a rounding, either answer is right.
/// @throws std::invalid_argument if a number is not within ±1e5.
bool segments_intersect(const Segment &first, const Segment &second);

//> What they share
/// What two segments have in common: nothing, one point, or the two ends of the piece on which they overlap,
/// in the order in which `first` runs through them [m].
/// How many points there are is exact on a grid, as for `segments_intersect`. Off it, a rounding may decide.
/// @throws std::invalid_argument if a number is not within ±1e5.
std::vector<Vec2> common_points(const Segment &first, const Segment &second);

//> A point in a room
/// A point that flies straight on until a wall turns it.
struct Ball {
    Vec2 position; ///< [m]
    Vec2 velocity; ///< [m/s]
    COURSE_FIELDS("m, m/s", position, velocity)
};

/// On a wall, or at its end, means: no farther from it than this [m]. So no corner leaks.
inline constexpr double contact_tolerance = 1e-9;

/// After so many bounces in one call a ball stays where it is, with the velocity it has then, until the time is over.
inline constexpr int max_bounces = 1000;

/// The ball `dt` seconds later, in a room with smooth elastic walls. At a wall the part of its velocity along the
/// wall's normal changes its sign, and it flies on for the time that is left.
///
/// Only a wall that it approaches from inside turns it. A ball on a wall is inside: flying inwards or along, it
/// is let go; flying outwards, it bounces at once. From outside it flies in, through the wall.
/// In a corner both walls act, one after the other in either order, until it approaches neither.
/// Whether a wall that is reached in the very last instant has turned it already is left open.
/// @param room  its corners in order, either way round; a wall joins each to the next, and the last to the first.
///              Walls that cross each other are not looked for.
/// @param dt    [s], not negative
/// @throws std::invalid_argument if there are fewer than three corners, if one equals the next, if `dt` is negative,
///         or if anything is not a number within ±1e5.
Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &room, double dt);

//> A disc meets a wall
/// The instant at which a moving disc first touches a wall.
struct Impact {
    double t{};  ///< how much of the motion is over [1], from 0 to 1
    Vec2 centre; ///< of the disc, then [m]
    Vec2 point;  ///< of the wall, where the disc touches it [m]
    COURSE_FIELDS("1, m, m", t, centre, point)
};

/// When and where a disc, whose centre makes the way `motion`, first touches a wall: its side or one of its ends.
/// A wall that is a point is a post; a disc of radius 0 is a point.
/// A disc that touches the wall, or overlaps it, as it starts: t = 0 if its centre is coming nearer to the wall.
/// Nothing if it stays clear of the wall, or starts by leaving it or keeping its distance.
/// Where a graze is decided by a rounding, either answer is right. A point that meets only an end of a wall grazes it.
/// @param radius  [m], not negative
/// @throws std::invalid_argument if the radius is negative, or anything is not a number within ±1e5.
std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall);

//> Which way does it turn?
/// The sign of the determinant D = a.x b.y - a.y b.x [m²] of two segments, a and b being their end minus their start:
/// 1 if `second` points to the left of `first`, -1 if to the right, 0 if parallel or too close to tell.
/// It is 0 only if |D| <= 1e-15 (|a.x b.y| + |a.y b.x|) + 1e-300 m², and never the wrong sign of a |D| above 1e-300 m².
/// @throws std::invalid_argument if a number is not within ±1e5.
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
