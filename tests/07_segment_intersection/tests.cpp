#include "section_test.hpp"

#include "segment_intersection.hpp"

#include "exact.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

using segment_intersection::Ball, segment_intersection::Impact, segment_intersection::LineIntersection;
using segment_intersection::Segment, segment_intersection::max_bounces;
using namespace segment_intersection::subject; // the student's six functions

// Answers are right to 1e-12, or to 1e-12 of their size where that's more than 1. Nearly parallel lines, a graze, many
// bounces, and numbers that differ by many powers of ten lose more, and each test allows for it. A segment shorter than
// 1e-60 m may count as a single point. 7.2's answer, and the number of points in 7.3's, are exact for whole-number
// coordinates up to ±1000; with others, a touch or a gap within rounding may go either way. So may a graze in 7.5, and a
// point that meets only an end of a wall.

const Segment motion{.start = {4, 7}, .end = {16, 3}}; // the worked example
const Segment wall{.start = {1, 1}, .end = {17, 10}};

namespace {

const std::optional<LineIntersection> nowhere;
const std::optional<Impact> never;

double det(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }
Segment reversed(const Segment &s) { return {s.end, s.start}; }
Segment moved(const Segment &s, double scale, const Vec2 &by) { return {scale * s.start + by, scale * s.end + by}; }

} // namespace

// -------------------------------------------------------------------------------------------------- 7.1 intersect_lines

//> Worked example
TEST_CASE("the worked example: the lines intersect at (379/43, 232/43), with t = 69/172 and s = 21/43", "[7.1]") {
    const LineIntersection want{69.0 / 172, 21.0 / 43, {379.0 / 43, 232.0 / 43}};
    CHECK_THAT(intersect_lines({{4, 7}, {16, 3}}, {{1, 1}, {17, 10}}), IsNear(want, rounding));
}

//> Built through a known point
TEST_CASE("random segments built through a known point intersect there, with the t and s they were built with",
          "[7.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 point = dice.point(-50, 50), along = dice.direction(), across = dice.direction();
        const double sine = std::abs(det(along, across));
        if (sine < 1e-3) continue; // nearly parallel: another test
        const Vec2 a = dice.real(0.1, 30) * along, b = dice.real(0.1, 30) * across;
        const double t = dice.real(-3, 4), s = dice.real(-3, 4); // within the segments, and beyond their ends

        const auto found = intersect_lines({point - t * a, point + (1 - t) * a}, {point - s * b, point + (1 - s) * b});

        // A coordinate near 200 is off by 3e-14, which is 3e-13 of a segment of 0.1; the angle makes it more, and so does
        // a product of two coordinates, in formulas other than ours.
        CHECK_THAT(found, IsNear(LineIntersection{t, s, point}, 1e-10 / sine));
    }
}

//>
TEST_CASE("swapping motion and wall swaps t and s, and leaves the point where it is", "[7.1]") {
    CHECK_THAT(intersect_lines(wall, motion),
               IsNear(LineIntersection{21.0 / 43, 69.0 / 172, {379.0 / 43, 232.0 / 43}}, rounding));
}

TEST_CASE("reversing a segment turns t into 1 - t (or s into 1 - s), and leaves the point where it is", "[7.1]") {
    const Vec2 point{379.0 / 43, 232.0 / 43};
    CHECK_THAT(intersect_lines(reversed(motion), wall),
               IsNear(LineIntersection{103.0 / 172, 21.0 / 43, point}, rounding));
    CHECK_THAT(intersect_lines(motion, reversed(wall)),
               IsNear(LineIntersection{69.0 / 172, 22.0 / 43, point}, rounding));
}

TEST_CASE("moving or scaling both segments leaves t and s as they are", "[7.1]") {
    const double scale = GENERATE(1e-6, 0.02, -3.0, 700.0);
    const Vec2 by = GENERATE(Vec2{0, 0}, Vec2{-31, 17}, Vec2{2000, -5000});

    const auto found = intersect_lines(moved(motion, scale, by), moved(wall, scale, by));

    const Vec2 point = scale * Vec2{379.0 / 43, 232.0 / 43} + by;
    const double lost = 1e-15 * by.norm() / std::abs(scale); // what moving a small segment far away rounds off
    CHECK_THAT(found, IsNear(LineIntersection{69.0 / 172, 21.0 / 43, point}, rounding + 10 * lost));
}

TEST_CASE("horizontal and vertical walls are hit from either side", "[7.1]") {
    CHECK_THAT(intersect_lines({{2, 5}, {8, -3}}, {{3, 1}, {11, 1}}),
               IsNear(LineIntersection{0.5, 0.25, {5, 1}}, rounding)
                   .since("(2, 5) + t (6, -8) is at y = 1 for t = 1/2, and x = 5 is 2 of the 8 m along the wall"));
    CHECK_THAT(intersect_lines({{8, -3}, {2, 5}}, {{3, 1}, {11, 1}}),
               IsNear(LineIntersection{0.5, 0.25, {5, 1}}, rounding));
    CHECK_THAT(intersect_lines({{2, 5}, {8, -3}}, {{3.5, 0}, {3.5, 4}}),
               IsNear(LineIntersection{0.25, 0.75, {3.5, 3}}, rounding)
                   .since("(2, 5) + t (6, -8) is at x = 3.5 for t = 1/4, and y = 3 is 3 of the 4 m along the wall"));
    CHECK_THAT(intersect_lines({{0, 2}, {9, 2}}, {{3, 7}, {3, -3}}),
               IsNear(LineIntersection{1.0 / 3, 0.5, {3, 2}}, rounding));
}

TEST_CASE("t and s are 0 or 1 at the ends of a segment, and beyond them the lines go on", "[7.1]") {
    CHECK_THAT(intersect_lines({{2, 3}, {6, 11}}, {{2, 3}, {7, 1}}), IsNear(LineIntersection{0, 0, {2, 3}}, rounding));
    CHECK_THAT(intersect_lines({{2, 3}, {6, 11}}, {{9, 4}, {6, 11}}),
               IsNear(LineIntersection{1, 1, {6, 11}}, rounding));
    CHECK_THAT(intersect_lines({{0, 0}, {1, 1}}, {{3, 0}, {0, 3}}),
               IsNear(LineIntersection{1.5, 0.5, {1.5, 1.5}}, rounding));
    CHECK_THAT(intersect_lines({{5, 5}, {7, 7}}, {{3, 0}, {1, 2}}),
               IsNear(LineIntersection{-1.75, 0.75, {1.5, 1.5}}, rounding));
}

TEST_CASE("parallel lines have no intersection, whatever their scale; nor have single points", "[7.1]") {
    const double scale = GENERATE(1.0, 1e-9, 1e-3, 0.1, 1.0 / 3, 5e3);

    const auto scaled = [&](const Segment &s) { return moved(s, scale, {0, 0}); };

    const Segment first = scaled({{0, 0}, {4, 2}});
    CHECK_THAT(intersect_lines(first, scaled({{1, 1}, {7, 4}})), IsNear(nowhere));
    CHECK_THAT(intersect_lines(first, scaled({{7, 4}, {1, 1}})), IsNear(nowhere));
    CHECK_THAT(intersect_lines(first, scaled({{2, 1}, {8, 4}})), IsNear(nowhere)); // on one line
    CHECK_THAT(intersect_lines(scaled({{1, 3}, {2, 6}}), scaled({{7, 1}, {10, 10}})), IsNear(nowhere));
    CHECK_THAT(intersect_lines(scaled({{2, 0}, {2, 5}}), scaled({{7, 1}, {7, 9}})),
               IsNear(nowhere)); // vertical: no slope
    CHECK_THAT(intersect_lines(scaled({{2, 0}, {2, 5}}), scaled({{7, 9}, {7, 1}})), IsNear(nowhere));
    CHECK_THAT(intersect_lines(scaled({{2, 0}, {2, 5}}), scaled({{2, 4}, {2, 9}})), IsNear(nowhere));
    CHECK_THAT(intersect_lines(scaled({{0, 3}, {4, 3}}), scaled({{9, 5}, {1, 5}})), IsNear(nowhere)); // horizontal
    CHECK_THAT(intersect_lines(scaled({{0, 0}, {5e-4, 15}}), scaled({{0, 0}, {3e-4, 9}})), IsNear(nowhere)); // steep
    CHECK_THAT(intersect_lines({{3, 5}, {3, 5}}, scaled(wall)), IsNear(nowhere));
    CHECK_THAT(intersect_lines(scaled(motion), {{3, 5}, {3, 5}}), IsNear(nowhere));
    CHECK_THAT(intersect_lines({{3, 5}, {3, 5}}, {{3, 5}, {3, 5}}), IsNear(nowhere));
    CHECK_THAT(intersect_lines(first, scaled({{2, 1}, {2, 1}})), IsNear(nowhere)); // a point on the other line
    CHECK_THAT(intersect_lines(scaled({{2, 1}, {2, 1}}), first), IsNear(nowhere));
}

TEST_CASE("lines count as parallel up to a sine of 1e-12, and intersect above it", "[7.1]") {
    const Vec2 along = GENERATE(Vec2{1, 0}, Vec2{0, -1}, Vec2{1, 1}, Vec2{-3, 2});
    const auto crossed_at = [&](double sine) {
        const Vec2 b = along + sine * Vec2{-along.y(), along.x()};
        return intersect_lines({-along, along}, {-b, b});
    };

    for (const double sine : {1e-14, 3e-13, -3e-13, 8e-13, -8e-13}) CHECK_THAT(crossed_at(sine), IsNear(nowhere));
    for (const double sine : {1.3e-12, -1.3e-12, 3e-12, -3e-12, 1e-11}) // a rounding of 1e-16, by the sine
        CHECK_THAT(crossed_at(sine), IsNear(LineIntersection{0.5, 0.5, {0, 0}}, 1e-2));
}

TEST_CASE("perpendicular segments intersect, however short, down to 1e-60 m", "[7.1]") {
    for (const double size : {1e5, 1e-3, 1e-10, 1e-16, 1e-40, 1e-60}) { // [m]
        CHECK_THAT(intersect_lines({{-size, 0}, {size, 0}}, {{0, -size}, {0, size}}),
                   IsNear(LineIntersection{0.5, 0.5, {0, 0}}, 1e-9)); // a rounding of 1e5 is 1e-11
        CHECK_THAT(intersect_lines({{0, 0}, {1e5, 0}}, {{0, 0}, {0, size}}),
                   IsNear(LineIntersection{0, 0, {0, 0}}, rounding));
        CHECK_THAT(intersect_lines({{0, 0}, {size, 0}}, {{0, 0}, {0, 1e5}}),
                   IsNear(LineIntersection{0, 0, {0, 0}}, rounding));
    }
}

TEST_CASE("a t or s very close to 0 or 1 is not rounded to it", "[7.1]") {
    const double share = GENERATE(5e-10, -5e-10, 1 - 5e-10, 1 + 5e-10, 1 + 5e-7);
    const Segment level{{0, 0}, {1, 0}}, vertical{{share, -1}, {share, 1}};
    CHECK_THAT(intersect_lines(level, vertical), IsNear(LineIntersection{share, 0.5, {share, 0}}, rounding));
    CHECK_THAT(intersect_lines(vertical, level), IsNear(LineIntersection{0.5, share, {share, 0}}, rounding));
}

TEST_CASE("lines may intersect far beyond ±1e5, many lengths away from either segment", "[7.1]") {
    CHECK_THAT(intersect_lines({{0, 0}, {1e5, 1}}, {{0, 50}, {1e5, 50}}),
               IsNear(LineIntersection{50, 50, {5e6, 50}}, rounding));
    // a formula may lose how far a millionth of a metre goes in 90 km, but not that they cross
    const Segment short_one{{0, 0}, {1e-6, 0}}, distant{{9e4, -1}, {9e4, 1}};
    CHECK_THAT(intersect_lines(short_one, distant), IsNear(LineIntersection{9e10, 0.5, {9e4, 0}}, 1e-3));
    CHECK_THAT(intersect_lines(distant, short_one), IsNear(LineIntersection{0.5, 9e10, {9e4, 0}}, 1e-3));
}

TEST_CASE("nearly parallel lines still intersect, whatever their scale", "[7.1]") {
    const double scale = GENERATE(1e-6, 1.0, 1e4);
    const double sine = GENERATE(1e-3, -1e-6, 1e-9); // a thousand times what counts as parallel

    // along (3, 4) through (2, 1), and turned by the angle: both are halfway there
    const Vec2 a{3, 4}, b = a + sine * Vec2{-4, 3}, point{2, 1};
    const Segment first{point - a, point + a}, second{point - b, point + b};
    const auto found = intersect_lines(moved(first, scale, {0, 0}), moved(second, scale, {0, 0}));

    const double tolerance = 1e-14 / std::abs(sine); // the angle closes, the error grows
    CHECK_THAT(found, IsNear(LineIntersection{0.5, 0.5, scale * point}, tolerance));
}

TEST_CASE("each call stands alone: nothing is remembered from the call before", "[7.1]") {
    const LineIntersection want{69.0 / 172, 21.0 / 43, {379.0 / 43, 232.0 / 43}};
    CHECK_THAT(intersect_lines(motion, wall), IsNear(want, rounding));
    CHECK_THAT(intersect_lines({{0, 0}, {4, 2}}, {{1, 1}, {7, 4}}), IsNear(nowhere));
    CHECK_THAT(intersect_lines(motion, wall), IsNear(want, rounding));
}

//> Erratum E7.1
TEST_CASE("erratum E7.1: the printed t and s belong to a wall that ends at (18, 11), not (17, 10)", "[7.1]") {
    // As printed, (17, 10) is where (16, 9) must be: the wall's end in place of its displacement.
    const double printed_s = (4.0 * (4 - 1) + 12 * (7 - 1)) / (17 * 4 + 12 * 10);  // 84/188, printed as .44
    const double printed_t = (17.0 * (7 - 1) - 10 * (4 - 1)) / (17 * 4 + 12 * 10); // 72/188, printed as .383
    CHECK_THAT(printed_t, IsNear(0.383, 0.0005));

    const Vec2 elsewhere{404.0 / 47, 257.0 / 47}; // on the line from (1, 1) by (17, 10)
    CHECK_THAT(intersect_lines(motion, {{1, 1}, {18, 11}}),
               IsNear(LineIntersection{printed_t, printed_s, elsewhere}, rounding));
    CHECK_THAT(intersect_lines(motion, wall),
               IsNear(LineIntersection{69.0 / 172, 84.0 / 172, {379.0 / 43, 232.0 / 43}}, rounding));
}

//> Erratum E7.2
TEST_CASE("erratum E7.2: the motion starts at (4, 7); from the printed (7, 7) it leads elsewhere", "[7.1]") {
    const Vec2 as_printed = Vec2{7, 7} + 0.44 * Vec2{12, -4};
    CHECK_THAT(as_printed, IsNear(Vec2{12.28, 5.24}, rounding)); // and not the (9.28, 5.24) that is printed behind it

    const LineIntersection found = intersect_lines(motion, wall).value();
    const Vec2 point = Vec2{4, 7} + found.t * Vec2{12, -4};
    CHECK_THAT(found.point, IsNear(point, rounding).of("the point, against the start and t times the motion [m]"));
}

//> Erratum E7.3
TEST_CASE("erratum E7.3: t belongs to the motion; with s in its place, the point is not on the wall", "[7.1]") {
    const Vec2 by_s = Vec2{4, 7} + 21.0 / 43 * Vec2{12, -4}; // printed with .44, which is its s
    CHECK_THAT(by_s, IsNear(Vec2{9.860, 5.047}, 0.0005));
    CHECK_THAT(1 + 9.0 / 16 * (by_s.x() - 1), IsNear(5.984, 0.0005)); // the wall, at this x: .94 m higher

    const Vec2 by_t = Vec2{4, 7} + 69.0 / 172 * Vec2{12, -4};
    CHECK_THAT(1 + 9.0 / 16 * (by_t.x() - 1), IsNear(by_t.y(), rounding));
    CHECK_THAT(intersect_lines(motion, wall), IsNear(LineIntersection{69.0 / 172, 21.0 / 43, by_t}, rounding));
}

//> Erratum E7.4
TEST_CASE("erratum E7.4: the printed point (9.28, 5.24) is half a metre away from the intersection", "[7.1]") {
    const Vec2 printed{9.28, 5.24};
    CHECK_THAT(1 + 9.0 / 16 * (printed.x() - 1), IsNear(5.6575, rounding)); // the wall, at this x: .42 m higher

    const LineIntersection found = intersect_lines(motion, wall).value();
    CHECK_THAT((found.point - printed).norm(), IsNear(0.491, 0.0005).of("distance from the printed point [m]"));
}

//>
TEST_CASE("coordinates of exactly ±1e5 are accepted", "[7.1]") {
    const auto found = intersect_lines({{-1e5, -1e5}, {1e5, 1e5}}, {{1e5, -1e5}, {-1e5, 1e5}});
    CHECK_THAT(found,
               IsNear(LineIntersection{0.5, 0.5, {0, 0}}, 1e-9)); // 1e5, and four digits more than a rounding of it
}

// ----------------------------------------------------------------------------------------------- 7.2 segments_intersect

//> Yes or no
TEST_CASE("segments may miss each other although their lines intersect", "[7.2]") {
    CHECK_THAT(segments_intersect(motion, wall), IsNear(true));
    CHECK_THAT(segments_intersect({{0, 0}, {1, 1}}, {{3, 0}, {0, 3}}), IsNear(false)); // the first ends too early
    CHECK_THAT(segments_intersect({{3, 0}, {0, 3}}, {{0, 0}, {1, 1}}), IsNear(false)); // the second does
    CHECK_THAT(segments_intersect({{5, 5}, {2, 2}}, {{3, 0}, {0, 3}}), IsNear(false)); // the first starts too late
    CHECK_THAT(segments_intersect({{0, 0}, {2, 2}}, {{3, 0}, {0, 3}}), IsNear(true));
    CHECK_THAT(segments_intersect({{0, 0}, {6, 1}}, {{7, 2}, {6, 7}}),
               IsNear(false)); // neither reaches the other's line
}

//> Erratum E7.5
TEST_CASE("erratum E7.5: the ends belong to a segment, so touching counts as intersecting", "[7.2]") {
    // one end in the middle of the other: s or t is 0 or 1, which "(0..1)" leaves out and "0 <= t <= 1" lets in
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{2, 1}, {5, 0}}), IsNear(true)); // s = 0
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{5, 0}, {2, 1}}), IsNear(true)); // s = 1
    CHECK_THAT(segments_intersect({{2, 1}, {5, 0}}, {{0, 0}, {4, 2}}), IsNear(true)); // t = 0
    CHECK_THAT(segments_intersect({{5, 0}, {2, 1}}, {{0, 0}, {4, 2}}), IsNear(true)); // t = 1
    CHECK_THAT(segments_intersect({{1, 3}, {4, 2}}, {{4, 2}, {7, 9}}), IsNear(true)); // end to end: both
}

//> Erratum E7.6
TEST_CASE("erratum E7.6: parallel segments intersect if they overlap or touch, although the determinant is zero",
          "[7.2]") {
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{1, 1}, {7, 4}}), IsNear(false)); // side by side
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{6, 3}, {8, 4}}), IsNear(false)); // one line, and a gap
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{8, 4}, {6, 3}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{6, 3}, {4, 2}}), IsNear(true));   // one line, end to end
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{6, 3}, {2, 1}}), IsNear(true));   // one line, and an overlap
    CHECK_THAT(segments_intersect({{0, 0}, {4, 2}}, {{-2, -1}, {6, 3}}), IsNear(true)); // one within the other
    CHECK_THAT(segments_intersect({{-2, -1}, {6, 3}}, {{0, 0}, {4, 2}}), IsNear(true));
    CHECK_THAT(segments_intersect({{0, 5}, {0, 2}}, {{0, 3}, {0, 9}}), IsNear(true));   // one above the other
    CHECK_THAT(segments_intersect({{0, 5}, {0, 4}}, {{0, 3}, {0, -9}}), IsNear(false)); // a gap in y only
    CHECK_THAT(segments_intersect({{0, 3}, {0, -9}}, {{0, 5}, {0, 4}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 1}, {4, 1}}, {{6, 1}, {8, 1}}), IsNear(false)); // a gap in x only
    CHECK_THAT(segments_intersect({{6, 1}, {8, 1}}, {{0, 1}, {4, 1}}), IsNear(false));
}

//>
TEST_CASE("a segment of length 0 intersects exactly what it lies on", "[7.2]") {
    const Segment line{{0, 0}, {4, 2}};
    CHECK_THAT(segments_intersect({{2, 1}, {2, 1}}, line), IsNear(true));
    CHECK_THAT(segments_intersect(line, {{2, 1}, {2, 1}}), IsNear(true));
    CHECK_THAT(segments_intersect(line, {{4, 2}, {4, 2}}), IsNear(true));
    CHECK_THAT(segments_intersect(line, {{3, 1}, {3, 1}}), IsNear(false)); // within its box, beside the line
    CHECK_THAT(segments_intersect(line, {{6, 3}, {6, 3}}), IsNear(false)); // on its line, beyond the end
    CHECK_THAT(segments_intersect({{6, 3}, {6, 3}}, line), IsNear(false));
    CHECK_THAT(segments_intersect({{2, 1}, {2, 1}}, {{2, 1}, {2, 1}}), IsNear(true));
    CHECK_THAT(segments_intersect({{2, 1}, {2, 1}}, {{2, 3}, {2, 3}}), IsNear(false));
    CHECK_THAT(segments_intersect({{2, 1}, {2, 1}}, {{5, 1}, {5, 1}}), IsNear(false));
}

TEST_CASE("segments can be apart even if their bounding boxes overlap", "[7.2]") {
    CHECK_THAT(segments_intersect({{0, 0}, {10, 10}}, {{1, 0}, {9, 1}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 0}, {10, 10}}, {{6, 4}, {9, 1}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 10}, {10, 0}}, {{1, 2}, {4, 3}}), IsNear(false));
}

namespace {

/// The unit of a grid [m]: 64, 1, and smaller ones down to 1e-60.
double grid_unit(Dice &dice) {
    constexpr std::array exponents{6, 0, -20, -40, -100, -199};
    return std::ldexp(1.0, exponents[std::size_t(dice.whole(0, exponents.size() - 1))]);
}

} // namespace

//> Against an independent method
// Two segments are apart if and only if their projections on some axis leave a gap between them, and if there is such a
// separating axis, then it is one of these. Everything here is a whole number, so nothing is rounded.
bool separating_axis_exists(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    for (const Vec2 &axis : {Vec2{1, 0}, Vec2{0, 1}, a, b, Vec2{-a.y(), a.x()}, Vec2{-b.y(), b.x()}}) {
        const auto [low_1, high_1] = std::minmax({first.start.dot(axis), first.end.dot(axis)});
        const auto [low_2, high_2] = std::minmax({second.start.dot(axis), second.end.dot(axis)});
        if (high_1 < low_2 || high_2 < low_1) return true;
    }
    return false;
}

TEST_CASE("exact on whole-number coordinates, for thousands of random pairs that cross, touch, overlap or miss",
          "[7.2]") {
    const int size = GENERATE(2, 5, 1000); // on a small one they touch and overlap often
    Dice dice;
    for (int i = 0; i < course::cases(30000); ++i) {
        const double unit = grid_unit(dice); // [m], from 1e-60 to 64
        const Segment first{dice.grid(-size, size), dice.grid(-size, size)};
        const Segment second{dice.grid(-size, size), dice.grid(-size, size)};

        const bool got = segments_intersect(moved(first, unit, {0, 0}), moved(second, unit, {0, 0}));
        CHECK_THAT(got, IsNear(!separating_axis_exists(first, second)));
    }
}

//>
TEST_CASE("exact on whole numbers up to ±1000, for the narrowest gaps and the slightest touches", "[7.2]") {
    const double unit = GENERATE(64.0, 1.0, 0x1p-199); // [m]
    const auto grid = [&](const Segment &s) { return moved(s, unit, {0, 0}); };
    // Along (1999, 2000), with a corner at (1998, 1999): no triangle on this grid is flatter.
    const Segment steep = grid({{-1000, -1000}, {999, 1000}});
    CHECK_THAT(segments_intersect(steep, grid({{998, 999}, {-1000, 1000}})), IsNear(false));
    CHECK_THAT(segments_intersect(grid({{998, 999}, {-1000, 1000}}), steep), IsNear(false));
    CHECK_THAT(segments_intersect(steep, grid({{998, 999}, {1000, -1000}})), IsNear(true));
    CHECK_THAT(segments_intersect(steep, grid({{-999, -999}, {1000, -1000}})), IsNear(false));
    CHECK_THAT(segments_intersect(steep, grid({{-999, -999}, {-1000, 1000}})), IsNear(true));
    CHECK_THAT(segments_intersect(steep, grid({{-1000, -1000}, {998, 999}})), IsNear(true)); // nearly parallel
    // on one line
    CHECK_THAT(segments_intersect(grid({{-1000, 7}, {0, 7}}), grid({{1, 7}, {1000, 7}})), IsNear(false));
    CHECK_THAT(segments_intersect(grid({{-1000, 7}, {0, 7}}), grid({{1000, 7}, {0, 7}})), IsNear(true));
    CHECK_THAT(segments_intersect(grid({{7, 0}, {7, 1000}}), grid({{7, -1}, {7, -1000}})), IsNear(false));
    CHECK_THAT(segments_intersect(grid({{7, 0}, {7, 1000}}), grid({{7, 0}, {7, -1000}})), IsNear(true));
}

TEST_CASE("an end anywhere along the other segment touches it, in whole-number coordinates", "[7.2]") {
    for (int place = 0; place <= 49; ++place) {
        const Vec2 end{3.0 * place, 7.0 * place}; // a t of place/49, which is rounded
        CHECK_THAT(segments_intersect({{0, 0}, {147, 343}}, {end, {400, 11}}), IsNear(true));
        CHECK_THAT(segments_intersect({{-400, 11}, end}, {{147, 343}, {0, 0}}), IsNear(true));
    }
}

TEST_CASE("random segments with any coordinates intersect if and only if t and s are both between 0 and 1", "[7.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 point = dice.point(-50, 50), along = dice.direction(), across = dice.direction();
        if (std::abs(det(along, across)) < 1e-3) continue; // nearly parallel ones have their own tests
        const Vec2 a = dice.real(0.1, 30) * along, b = dice.real(0.1, 30) * across;
        const double t = dice.real(-1, 2), s = dice.real(-1, 2);
        const auto end = [](double x) { return std::min(std::abs(x), std::abs(1 - x)); };
        if (end(t) < 1e-6 || end(s) < 1e-6) continue; // a rounding might decide

        const bool within = t > 0 && t < 1 && s > 0 && s < 1;
        CHECK_THAT(segments_intersect({point - t * a, point + (1 - t) * a}, {point - s * b, point + (1 - s) * b}),
                   IsNear(within));
    }
}

TEST_CASE("segments on one line with a wide gap between them are apart, whatever the scale", "[7.2]") {
    const double scale = GENERATE(0.1, 1.0 / 3, 0.7e-6, 1234.567);
    const Vec2 along = GENERATE(Vec2{1, 3}, Vec2{-7, 2}, Vec2{5, 11}, Vec2{3, -4});
    const Segment first{0 * along, scale * along}, second{2 * scale * along, 3 * scale * along};

    CHECK_THAT(segments_intersect(first, second), IsNear(false));
    CHECK_THAT(segments_intersect(second, first), IsNear(false));
    CHECK_THAT(segments_intersect(reversed(first), second), IsNear(false));
    CHECK_THAT(segments_intersect(first, reversed(second)), IsNear(false));
}

TEST_CASE("a gap of a ten-billionth of a metre still separates segments of ten metres", "[7.2]") {
    const double gap = GENERATE(1e-3, 1e-6, 1e-10); // [m], between numbers of size ten, which are rounded at 2e-15
    CHECK_THAT(segments_intersect({{0, 0}, {8, 6}}, {{4 - gap, 3 + gap}, {2, 9}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 0}, {8, 6}}, {{4 + gap, 3 - gap}, {2, 9}}), IsNear(true));
    CHECK_THAT(segments_intersect({{4 - gap, 3 + gap}, {2, 9}}, {{0, 0}, {8, 6}}), IsNear(false));
    CHECK_THAT(segments_intersect({{4 + gap, 3 - gap}, {2, 9}}, {{0, 0}, {8, 6}}), IsNear(true));
    CHECK_THAT(segments_intersect({{0, 0}, {8, 6}}, {{8 + gap, 6 + gap}, {9, 2}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 0}, {8, 0}}, {{8 + gap, 0}, {9, 0}}), IsNear(false)); // on one line
    CHECK_THAT(segments_intersect({{0, 0}, {8, 0}}, {{8 - gap, 0}, {9, 0}}), IsNear(true));
    CHECK_THAT(segments_intersect({{0, 9}, {0, 8 + gap}}, {{0, 0}, {0, 8}}), IsNear(false));
    CHECK_THAT(segments_intersect({{0, 9}, {0, 8 - gap}}, {{0, 0}, {0, 8}}), IsNear(true));
}

TEST_CASE("coordinates of exactly ±1e5 are accepted", "[7.2]") {
    CHECK_THAT(segments_intersect({{-1e5, -1e5}, {1e5, 1e5}}, {{1e5, -1e5}, {-1e5, 1e5}}), IsNear(true));
    CHECK_THAT(segments_intersect({{-1e5, -1e5}, {1e5, -1e5}}, {{1e5, 1e5}, {-1e5, 1e5}}), IsNear(false));
}

// ---------------------------------------------------------------------------------------------------- 7.3 common_points

using Points = std::vector<Vec2>;

//> Nothing, a point, a piece
TEST_CASE("two segments have nothing, a point, or a piece with two ends in common", "[7.3]") {
    const Segment first{{0, 0}, {4, 2}};
    CHECK_THAT(common_points(motion, wall), IsNear(Points{{379.0 / 43, 232.0 / 43}}, rounding));
    CHECK_THAT(common_points(first, {{5, 0}, {6, 7}}), IsNear(Points{}));
    CHECK_THAT(common_points(first, {{1, 1}, {7, 4}}), IsNear(Points{}));                 // parallel
    CHECK_THAT(common_points(first, {{6, 3}, {8, 4}}), IsNear(Points{}));                 // on one line
    CHECK_THAT(common_points(first, {{2, 1}, {5, 0}}), IsNear(Points{{2, 1}}, rounding)); // an end touches
    CHECK_THAT(common_points(first, {{6, 3}, {4, 2}}), IsNear(Points{{4, 2}}, rounding)); // end to end, on one line
    CHECK_THAT(common_points(first, {{6, 3}, {2, 1}}), IsNear(Points{{2, 1}, {4, 2}}, rounding)); // as the first runs
    CHECK_THAT(common_points(first, {{-2, -1}, {6, 3}}), IsNear(Points{{0, 0}, {4, 2}}, rounding));
    CHECK_THAT(common_points(first, {{3, 1.5}, {1, 0.5}}), IsNear(Points{{1, 0.5}, {3, 1.5}}, rounding));
    CHECK_THAT(common_points(first, first), IsNear(Points{{0, 0}, {4, 2}}, rounding));
    CHECK_THAT(common_points(first, reversed(first)), IsNear(Points{{0, 0}, {4, 2}}, rounding));
}

//>
TEST_CASE("the ends of a common piece come in the order of the first segment, whichever way the second runs", "[7.3]") {
    const Segment first{{7, -3}, {7, 9}}, second{{7, 2}, {7, 20}}; // vertical: x tells nothing
    CHECK_THAT(common_points(first, second), IsNear(Points{{7, 2}, {7, 9}}, rounding));
    CHECK_THAT(common_points(first, reversed(second)), IsNear(Points{{7, 2}, {7, 9}}, rounding));
    CHECK_THAT(common_points(reversed(first), second), IsNear(Points{{7, 9}, {7, 2}}, rounding));
    CHECK_THAT(common_points(reversed(second), first), IsNear(Points{{7, 9}, {7, 2}}, rounding));
    CHECK_THAT(common_points({{9, 4}, {-3, 4}}, {{5, 4}, {20, 4}}),
               IsNear(Points{{9, 4}, {5, 4}}, rounding)); // horizontal: nor does y
}

TEST_CASE("a segment of length 0 has itself in common with what it lies on, and nothing with anything else", "[7.3]") {
    const Segment line{{0, 0}, {4, 2}}, point{{2, 1}, {2, 1}}, beside{{3, 1}, {3, 1}}, beyond{{6, 3}, {6, 3}};
    CHECK_THAT(common_points(point, line), IsNear(Points{{2, 1}}, rounding));
    CHECK_THAT(common_points(line, point), IsNear(Points{{2, 1}}, rounding));
    CHECK_THAT(common_points(point, point), IsNear(Points{{2, 1}}, rounding));
    CHECK_THAT(common_points(line, beside), IsNear(Points{}));
    CHECK_THAT(common_points(beside, line), IsNear(Points{}));
    CHECK_THAT(common_points(line, beyond), IsNear(Points{}));
    CHECK_THAT(common_points(beyond, line), IsNear(Points{}));
    CHECK_THAT(common_points(point, beside), IsNear(Points{}));
}

namespace {

/// Whether `point` lies on `segment`: exact for whole numbers.
bool on(const Segment &segment, const Vec2 &point) {
    return det(segment.end - segment.start, point - segment.start) == 0
           && (segment.start - point).dot(segment.end - point) <= 0;
}

/// The common points of two segments with whole-number coordinates: the ends that lie on the other segment. If there is
/// none, they cross where the first is divided in the ratio of its ends' distances from the second.
Points common_points_by_ends(const Segment &first, const Segment &second) {
    Points ends;
    for (const Vec2 &end : {first.start, first.end})
        if (on(second, end)) ends.push_back(end);
    for (const Vec2 &end : {second.start, second.end})
        if (on(first, end)) ends.push_back(end);
    if (!ends.empty()) {
        const Vec2 along = first.end - first.start;
        const auto by_place = [&](const Vec2 &p, const Vec2 &q) { return p.dot(along) < q.dot(along); };
        const auto [low, high] = std::minmax_element(ends.begin(), ends.end(), by_place);
        return *low == *high ? Points{*low} : Points{*low, *high};
    }
    if (separating_axis_exists(first, second)) return {};
    const Vec2 b = second.end - second.start;
    const double start = std::abs(det(b, first.start - second.start)), end = std::abs(det(b, first.end - second.start));
    return {(end * first.start + start * first.end) / (start + end)};
}

} // namespace

TEST_CASE("exact count on whole-number coordinates, for thousands of random pairs of segments", "[7.3]") {
    const int size = GENERATE(1, 2, 5, 1000);
    Dice dice;
    for (int i = 0; i < course::cases(30000); ++i) {
        const double unit = grid_unit(dice);
        const Segment first{dice.grid(-size, size), dice.grid(-size, size)};
        const Segment second{dice.grid(-size, size), dice.grid(-size, size)};

        Points points = common_points(moved(first, unit, {0, 0}), moved(second, unit, {0, 0}));

        for (Vec2 &point : points) point /= unit;
        // of coordinates up to 1000, a rounding of 1e-13, and an angle down to 1e-7 that makes a million of it
        const double tolerance = size > 9 ? 1e-6 : rounding;
        CHECK_THAT(points, IsNear(common_points_by_ends(first, second), tolerance).of("points, in units of the grid"));
    }
}

TEST_CASE("the narrowest angle on whole numbers up to ±1000 gives one point, the shortest overlap a piece", "[7.3]") {
    const double unit = GENERATE(64.0, 1.0, 0x1p-199); // [m]
    const auto counted_in_units = [&](const Segment &first, const Segment &second) {
        Points points = common_points(moved(first, unit, {0, 0}), moved(second, unit, {0, 0}));
        for (Vec2 &point : points) point /= unit;
        return points;
    };
    const auto are = [](const Points &want) { return IsNear(want, 1e-6).of("points, in units of the grid"); };
    // along (1999, 2000) and (1998, 1999), from one corner: a sine of 1.25e-7
    const Segment steep{{-1000, -1000}, {999, 1000}}, steeper{{-1000, -1000}, {998, 999}};
    CHECK_THAT(counted_in_units(steep, steeper), are({{-1000, -1000}}));
    CHECK_THAT(counted_in_units(reversed(steeper), steep), are({{-1000, -1000}}));
    CHECK_THAT(counted_in_units({{-1000, 7}, {1000, 7}}, {{999, 7}, {1000, 7}}), are({{999, 7}, {1000, 7}}));
    CHECK_THAT(counted_in_units({{7, 1000}, {7, 0}}, {{7, 1}, {7, -1000}}), are({{7, 1}, {7, 0}}));
    CHECK_THAT(counted_in_units({{0, 0}, {-1000, -1000}}, {{1000, 1000}, {-1, -1}}), are({{0, 0}, {-1, -1}}));
}

TEST_CASE("an overlap or an angle well above rounding decides how many points there are", "[7.3]") {
    const double small = GENERATE(1e-3, 1e-6, 1e-9, 3e-12); // [m], between numbers of size one; or a sine
    CHECK_THAT(common_points({{0, 0}, {1, 0}}, {{1 - small, 0}, {2, 0}}),
               IsNear(Points{{1 - small, 0}, {1, 0}}, 1e-15));
    CHECK_THAT(common_points({{0, 0}, {1, 0}}, {{1 + small, 0}, {2, 0}}), IsNear(Points{}));
    CHECK_THAT(common_points({{0, 0}, {1, 0}}, {{0.5 + small, 0}, {0.5, 0}}),
               IsNear(Points{{0.5, 0}, {0.5 + small, 0}}, 1e-15));
    CHECK_THAT(common_points({{-1, 0}, {1, 0}}, {{-1, -small}, {1, small}}), IsNear(Points{{0, 0}}, 1e-2));
    CHECK_THAT(common_points({{0, 0}, {1, 0}}, {{small, -1}, {small, 1}}),
               IsNear(Points{{small, 0}}, 1e-15)); // near an end
    CHECK_THAT(common_points({{-1e5, 0}, {1e5, 0}}, {{-small, -small}, {small, small}}), IsNear(Points{{0, 0}}, 1e-9));
}

TEST_CASE("random segments built through a known point have that point in common", "[7.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 point = dice.point(-50, 50), along = dice.direction(), across = dice.direction();
        const double sine = std::abs(det(along, across));
        if (sine < 1e-3) continue;
        const Vec2 a = dice.real(0.1, 30) * along, b = dice.real(0.1, 30) * across;
        const double t = dice.real(1e-6, 1 - 1e-6), s = dice.real(1e-6, 1 - 1e-6);

        const auto points = common_points({point - t * a, point + (1 - t) * a}, {point - s * b, point + (1 - s) * b});

        CHECK_THAT(points, IsNear(Points{point}, 1e-10 / sine)); // as in 7.1
    }
}

TEST_CASE("segments on one line with a wide gap between them have nothing in common, whatever the scale", "[7.3]") {
    const double scale = GENERATE(0.1, 1.0 / 3, 0.7e-6, 1234.567);
    const Vec2 along = GENERATE(Vec2{1, 3}, Vec2{-7, 2}, Vec2{5, 11}, Vec2{3, -4});

    const Segment first{0 * along, scale * along}, second{2 * scale * along, 3 * scale * along};

    CHECK_THAT(common_points(first, second), IsNear(Points{}));
    CHECK_THAT(common_points(second, first), IsNear(Points{}));
    CHECK_THAT(common_points(reversed(first), second), IsNear(Points{}));
    CHECK_THAT(common_points(first, reversed(second)), IsNear(Points{}));
}

TEST_CASE("on one line, whatever number of points rounding leads to, each of them lies on both segments", "[7.3]") {
    const auto far_from = [](const Segment &segment,
                             const Vec2 &point) { // the detour by way of the point [m]: 0 on the segment
        return (point - segment.start).norm() + (segment.end - point).norm() - (segment.end - segment.start).norm();
    };
    Dice dice;
    for (int i = 0; i < course::cases(50000); ++i) {
        const Vec2 from = dice.point(-9, 9), along = dice.direction();
        std::array<double, 4> places{};
        for (std::size_t k = 0; k < 4; ++k) places[k] = 3 * double(k) + dice.real(1, 3); // a metre apart, or more
        const auto place = [&](std::size_t k) -> Vec2 { return from + places[k] * along; };
        const bool overlap = dice.whole(0, 1) == 1;
        Segment first{place(0), place(overlap ? 2 : 1)}, second{place(overlap ? 1 : 2), place(3)};
        if (dice.whole(0, 1) == 1) std::swap(first, second);
        if (dice.whole(0, 1) == 1) first = reversed(first);
        if (dice.whole(0, 1) == 1) second = reversed(second);

        const Points points = common_points(first, second);

        CHECK_THAT(points.size(), IsAtMost(overlap ? 2 : 0).of("number of points"));
        for (const Vec2 &point : points) {
            CHECK_THAT(far_from(first, point), IsBelow(1e-11).of("distance of a point from the first segment [m]"));
            CHECK_THAT(far_from(second, point), IsBelow(1e-11).of("distance of a point from the second segment [m]"));
        }
    }
}

TEST_CASE("coordinates of exactly ±1e5 are accepted", "[7.3]") {
    CHECK_THAT(common_points({{-1e5, -1e5}, {1e5, 1e5}}, {{1e5, -1e5}, {-1e5, 1e5}}), IsNear(Points{{0, 0}}, 1e-9));
    CHECK_THAT(common_points({{-1e5, 1e5}, {1e5, 1e5}}, {{1e5, 1e5}, {-1e5, 1e5}}),
               IsNear(Points{{-1e5, 1e5}, {1e5, 1e5}}, rounding));
}

// -------------------------------------------------------------------------------------------------- 7.4 move_and_bounce

namespace {

/// How far `p` is outside of a room whose corners run anticlockwise [m]; 0 inside.
double outside(const Vec2 &p, const std::vector<Vec2> &corners) {
    bool in = false;
    double nearest = infinity;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()], along = b - a;
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / along.y() * along.x()) in = !in;
        const double s = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - s * along).norm());
    }
    return in ? 0 : nearest;
}

// Seven corners, no two walls alike; at (6.5, 3.5) one points into the room.
const std::vector<Vec2> cave{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};

} // namespace

//> Two bounces by hand
// A floor of 20 m, a wall that leans in along (-9, 12), and two more.
const std::vector<Vec2> room{{0, 0}, {20, 0}, {11, 12}, {2, 8}};

TEST_CASE("the worked examples: the ball bounces off a wall, and moves on for the rest of the time", "[7.4]") {
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, room, 3),
               IsNear(Ball{{10, 1.5}, {2, 1.5}}, rounding)
                   .since("it falls 3 m at 1.5 m/s, so it's at (8, 0) after 2 s, and rises for 1 s"));

    CHECK_THAT(
        move_and_bounce({{9, 2}, {5, 0}}, room, 2.1),
        IsNear(Ball{{18.22, 1.04}, {-1.4, -4.8}}, rounding)
            .since("it meets the wall after 9.5/5 = 1.9 s, and (5, 0) + 8 (-0.8, -0.6) = (-1.4, -4.8), for 0.2 s"));
}

//>
TEST_CASE("a wall ends at its corners: the ball passes through the line beyond them", "[7.4]") {
    // (6, 3) is a corner that points into the room: its walls' lines go on through the free space on either side
    const std::vector<Vec2> bay{{0, 0}, {12, 0}, {12, 9}, {6, 3}, {1, 9}};
    CHECK_THAT(move_and_bounce({{1, 2}, {4, 0}}, bay, 2), IsNear(Ball{{9, 2}, {4, 0}}, rounding)); // below the corner
    CHECK_THAT(move_and_bounce({{2, 4}, {4, 0}}, bay, 1.0 / 3), IsNear(Ball{{10.0 / 3, 4}, {4, 0}}, rounding));
    CHECK_THAT(move_and_bounce({{11, 6}, {-4, 0}}, bay, 1),
               IsNear(Ball{{9, 4}, {0, -4}}, rounding)); // (9, 6), then down
    CHECK_THAT(move_and_bounce({{11, 6}, {-4, 0}}, bay, 2.25),
               IsNear(Ball{{9, 1}, {0, 4}}, rounding)); // the floor, and up 1 m
}

TEST_CASE("a ball bounces off several walls in one call, one after the other", "[7.4]") {
    // Into the corner (20, 0). It meets the floor after 2 s, at (19, 0), and goes on with (3, 1). The leaning wall is
    // x + 0.75 y = 20: 19 + 3 t + 0.75 t = 20 after 4/15 s more, at (19.8, 4/15). Its normal is (-0.8, -0.6), the part
    // of (3, 1) along it is -3: (3, 1) + 6 (-0.8, -0.6) = (-1.8, -2.6). That meets the floor again, after 4/39 s.
    const double to_wall = 34.0 / 15, to_floor = 4.0 / 39;
    const Vec2 on_wall{19.8, 4.0 / 15};
    const double left = 3 - to_wall - to_floor;
    const Ball want{{on_wall.x() - 1.8 * (3 - to_wall), 2.6 * left}, {-1.8, 2.6}};

    CHECK_THAT(move_and_bounce({{13, 2}, {3, -1}}, room, 3), IsNear(want, rounding));

    // Two walls are on the way to the left, and the nearer one counts: after 2 m the ball turns down, to the floor.
    const std::vector<Vec2> bay{{0, 0}, {12, 0}, {12, 9}, {6, 3}, {1, 9}};
    CHECK_THAT(move_and_bounce({{11, 6}, {-4, 0}}, bay, 3), IsNear(Ball{{9, 4}, {0, 4}}, rounding));
}

//> Erratum E7.8
TEST_CASE("erratum E7.8: a ball that leaves a wall is not turned back into it", "[7.4]") {
    // At t = 0 it is on the floor, halfway along: s and t are "in the range", and the printed test makes it (4, -2).
    CHECK_THAT(move_and_bounce({{10, 0}, {4, 2}}, room, 0.5), IsNear(Ball{{12, 1}, {4, 2}}, rounding));
    CHECK_THAT(move_and_bounce({{10, -1e-12}, {4, 2}}, room, 0.5),
               IsNear(Ball{{12, 1}, {4, 2}}, 1e-11)); // nor by a rounding

    CHECK_THAT(move_and_bounce({{10, 0}, {4, -2}}, room, 0.5),
               IsNear(Ball{{12, 1}, {4, 2}}, rounding)); // outwards: at once
    CHECK_THAT(move_and_bounce({{10, -1e-12}, {4, -2}}, room, 0.5), IsNear(Ball{{12, 1}, {4, 2}}, 1e-11));
    CHECK_THAT(move_and_bounce({{10, 0}, {4, 0}}, room, 0.5),
               IsNear(Ball{{12, 0}, {4, 0}}, rounding)); // along: neither
}

//>
TEST_CASE("the corners of a room may run either way round, and start anywhere", "[7.4]") {
    std::vector<Vec2> corners = room;
    if (GENERATE(true, false)) std::reverse(corners.begin(), corners.end());
    std::rotate(corners.begin(), corners.begin() + GENERATE(0, 1, 2, 3), corners.end());

    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, corners, 3), IsNear(Ball{{10, 1.5}, {2, 1.5}}, rounding));
    CHECK_THAT(move_and_bounce({{9, 2}, {5, 0}}, corners, 2.1), IsNear(Ball{{18.22, 1.04}, {-1.4, -4.8}}, rounding));
    CHECK_THAT(move_and_bounce({{10, 0}, {4, 2}}, corners, 0.5), IsNear(Ball{{12, 1}, {4, 2}}, rounding));
    CHECK_THAT(move_and_bounce({{10, 0}, {4, -2}}, corners, 0.5), IsNear(Ball{{12, 1}, {4, 2}}, rounding));
}

TEST_CASE("the corners of a non-convex room may run either way round, too", "[7.4]") {
    std::vector<Vec2> corners = cave;
    if (GENERATE(true, false)) std::reverse(corners.begin(), corners.end());
    std::rotate(corners.begin(), corners.begin() + GENERATE(range(0, 7)), corners.end());

    const Ball start{{2, 3}, {2.3, 1.1}};
    const Ball want = move_and_bounce(start, cave, 20);
    CHECK_THAT(move_and_bounce(start, corners, 20), IsNear(want, 1e-10)); // 50 m, and a few dozen walls
}

TEST_CASE("a room may have three corners or three hundred, and may pass through one point twice", "[7.4]") {
    // 3 x + 4 y = 36 is reached after 5/8 s; its normal is (-0.6, -0.8), the part of (4, 3) along it is -4.8
    std::vector<Vec2> triangle{{0, 0}, {12, 0}, {0, 9}};
    if (GENERATE(true, false)) std::reverse(triangle.begin(), triangle.end());
    CHECK_THAT(move_and_bounce({{3, 3}, {4, 3}}, triangle, 1), IsNear(Ball{{4.84, 3.12}, {-1.76, -4.68}}, rounding));

    std::vector<Vec2> corridor; // 150 m, in walls of 1 m
    for (int x = 0; x <= 150; ++x) corridor.push_back({double(x), 0});
    for (int x = 150; x >= 0; --x) corridor.push_back({double(x), 10});
    CHECK_THAT(move_and_bounce({{7.5, 5}, {0, 1}}, corridor, 7), IsNear(Ball{{7.5, 8}, {0, -1}}, rounding));
    CHECK_THAT(move_and_bounce({{7.5, 5}, {-1, 0}}, corridor, 10),
               IsNear(Ball{{2.5, 5}, {1, 0}}, rounding)); // the last wall

    const std::vector<Vec2> two_squares{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}, {0, 4}};
    CHECK_THAT(move_and_bounce({{2, 2}, {1, 0}}, two_squares, 3), IsNear(Ball{{3, 2}, {-1, 0}}, rounding));
}

TEST_CASE("a room may be a micrometre wide, and a wall may be even shorter", "[7.4]") {
    std::vector<Vec2> corners = room;
    if (GENERATE(true, false)) std::reverse(corners.begin(), corners.end());
    const double scale = GENERATE(1e-3, 1e-6);
    for (Vec2 &corner : corners) corner *= scale;
    const Ball after = move_and_bounce({{4 * scale, 3 * scale}, {2 * scale, -1.5 * scale}}, corners, 3);
    CHECK_THAT(after.position / scale, IsNear(Vec2{10, 1.5}, 1e-9).of("position, in units of the room's scale"));

    // level into a chamfer at 45 degrees, and straight up
    const double h = GENERATE(0x1p-11, 0x1p-23); // [m], which no sum rounds
    const std::vector<Vec2> chamfered{{0, 0}, {8 - h, 0}, {8, h}, {8, 6}, {0, 6}};
    CHECK_THAT(move_and_bounce({{4, h / 2}, {1, 0}}, chamfered, 5 - h / 2),
               IsNear(Ball{{8 - h / 2, 1 + h / 2}, {0, 1}}, 1e-9));

    const std::vector<Vec2> nearly_double{{0, 0}, {20, 0}, {20, 1e-13}, {11, 12}, {2, 8}}; // near, but not equal
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, nearly_double, 3), IsNear(Ball{{10, 1.5}, {2, 1.5}}, rounding));
}

TEST_CASE("a fast ball bounces within a nanosecond, and a slow one after hours", "[7.4]") {
    const double left = GENERATE(5e-7, 5e-10); // [s] after the bounce, or in all
    CHECK_THAT(move_and_bounce({{4, 3}, {0, -1e5}}, room, 3e-5 + left),
               IsNear(Ball{{4, 1e5 * left}, {0, 1e5}}, rounding));
    CHECK_THAT(move_and_bounce({{4, 3}, {1e5, 0}}, room, left), IsNear(Ball{{4 + 1e5 * left, 3}, {1e5, 0}}, rounding));
    CHECK_THAT(move_and_bounce({{4, 3}, {0, -1e5}}, room, 3e-5 - left), // so long before it would bounce
               IsNear(Ball{{4, 1e5 * left}, {0, -1e5}}, rounding));

    const double speed = GENERATE(5e-4, 5e-7, 5e-10, 5e-13); // [m/s]: at the floor after 1e4 s
    CHECK_THAT(move_and_bounce({{4, 1e4 * speed}, {0, -speed}}, room, 1.5e4),
               IsNear(Ball{{4, 0.5e4 * speed}, {0, speed}}, 1e-10));
    // nearly along the floor, which it reaches halfway
    CHECK_THAT(move_and_bounce({{4, 2e-9}, {8, -4e-9}}, room, 1), IsNear(Ball{{12, 2e-9}, {8, 4e-9}}, rounding));
}

TEST_CASE("the position and velocity of the answer may be beyond ±1e5", "[7.4]") {
    CHECK_THAT(move_and_bounce({{1e5, 30}, {1e5, 0}}, room, 1e5),
               IsNear(Ball{{1.00001e10, 30}, {1e5, 0}}, rounding)); // outside
    // at the leaning wall after 9.5/1.75e5 s; the part of (1e5, 1e5) along its normal is -1.4e5
    CHECK_THAT(move_and_bounce({{9, 2}, {1e5, 1e5}}, room, 6e-5),
               IsNear(Ball{{13.72, 7.04}, {-1.24e5, -0.68e5}}, 1e-10));
}

TEST_CASE("numbers of exactly ±1e5 are accepted", "[7.4]") {
    const std::vector<Vec2> world{{-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}};
    CHECK_THAT(move_and_bounce({{0, 9e4}, {1e5, -1e5}}, world, 1.5), IsNear(Ball{{5e4, -6e4}, {-1e5, -1e5}}, rounding));
    CHECK_THAT(move_and_bounce({{-1e5, 1e5}, {0, 0}}, world, 1e5), IsNear(Ball{{-1e5, 1e5}, {0, 0}}, rounding));
}

TEST_CASE("each call stands alone: the room of the call before is forgotten", "[7.4]") {
    const Ball want{{10, 1.5}, {2, 1.5}};
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, room, 3), IsNear(want, rounding));
    static_cast<void>(move_and_bounce({{2, 3}, {2.3, 1.1}}, cave, 3));
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, room, 3), IsNear(want, rounding));
}

TEST_CASE("far from any wall the ball moves straight on; at rest, or in no time, it stays where it is", "[7.4]") {
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, room, 1.5), IsNear(Ball{{7, 0.75}, {2, -1.5}}, rounding));
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, room, 0), IsNear(Ball{{4, 3}, {2, -1.5}}, rounding));
    CHECK_THAT(move_and_bounce({{4, 3}, {2, -1.5}}, room, -0.0), IsNear(Ball{{4, 3}, {2, -1.5}}, rounding));
    CHECK_THAT(move_and_bounce({{4, 3}, {0, 0}}, room, 5e4), IsNear(Ball{{4, 3}, {0, 0}}, rounding));
    CHECK_THAT(move_and_bounce({{10, 0}, {0, 0}}, room, 5e4),
               IsNear(Ball{{10, 0}, {0, 0}}, rounding)); // on the floor, too
}

TEST_CASE("in a corner both walls act, so a ball comes straight back out of a right angle", "[7.4]") {
    const std::vector<Vec2> hall{{0, 0}, {20, 0}, {20, 9}, {7, 13}, {0, 11}};
    CHECK_THAT(move_and_bounce({{12, 4}, {4, -2}}, hall, 3), IsNear(Ball{{16, 2}, {-4, 2}}, 1e-8)); // touching is 1e-9
    CHECK_THAT(move_and_bounce({{3, 6}, {-1, -2}}, hall, 4), IsNear(Ball{{1, 2}, {1, 2}}, 1e-8));
    CHECK_THAT(move_and_bounce({{20, 0}, {4, -2}}, hall, 1),
               IsNear(Ball{{16, 2}, {-4, 2}}, 1e-8)); // it starts there, outwards
    CHECK_THAT(move_and_bounce({{20, 0}, {-4, -2}}, hall, 1),
               IsNear(Ball{{16, 2}, {-4, 2}}, 1e-8)); // outwards for one of them
    CHECK_THAT(move_and_bounce({{20, 0}, {-4, 2}}, hall, 1), IsNear(Ball{{16, 2}, {-4, 2}}, 1e-8)); // inwards: let go
    CHECK_THAT(move_and_bounce({{20, 0}, {-4, 0}}, hall, 1), IsNear(Ball{{16, 0}, {-4, 0}}, 1e-8)); // along one: let go
    CHECK_THAT(move_and_bounce({{10, 0}, {4, 0}}, hall, 4),
               IsNear(Ball{{14, 0}, {-4, 0}}, 1e-8)); // slides into it, and back
}

TEST_CASE("a ball from outside flies in through the wall, and bounces where it would leave the room", "[7.4]") {
    CHECK_THAT(move_and_bounce({{7, -3}, {0.5, 2}}, room, 2), IsNear(Ball{{8, 1}, {0.5, 2}}, rounding));
    CHECK_THAT(move_and_bounce({{4, -1}, {0, 2}}, {{0, 0}, {8, 0}, {8, 4}, {0, 4}}, 3),
               IsNear(Ball{{4, 3}, {0, -2}}, rounding));
    CHECK_THAT(move_and_bounce({{4, -11}, {0, 2}}, {{0, 0}, {8, 0}, {8, 4}, {0, 4}}, 8),
               IsNear(Ball{{4, 3}, {0, -2}}, rounding)); // from farther away
    CHECK_THAT(move_and_bounce({{7, -3}, {2, -1}}, room, 5),
               IsNear(Ball{{17, -8}, {2, -1}}, rounding)); // away: for ever
    CHECK_THAT(move_and_bounce({{-4, 30}, {9, 0}}, room, 5), IsNear(Ball{{41, 30}, {9, 0}}, rounding)); // past it
}

TEST_CASE("a ball that is outside by less than contact_tolerance counts as being on the wall", "[7.4]") {
    CHECK_THAT(move_and_bounce({{10, -8e-10}, {4, 2}}, room, 0.5), IsNear(Ball{{12, 1}, {4, 2}}, 2e-9));
    CHECK_THAT(move_and_bounce({{10, -8e-10}, {4, -2}}, room, 0.5), IsNear(Ball{{12, 1}, {4, 2}}, 2e-9));
    // Almost along the floor: 0.2 s earlier its height was 0, but it was still to the left of the floor's end.
    CHECK_THAT(move_and_bounce({{0.5, -8e-10}, {4, -4e-9}}, room, 2), IsNear(Ball{{8.5, 8e-9}, {4, 4e-9}}, 2e-10));
}

TEST_CASE("a ball that is farther outside than contact_tolerance is not held back by the wall", "[7.4]") {
    const double off = GENERATE(1e-3, 1e-7, 2e-9); // [m], more than touching
    CHECK_THAT(move_and_bounce({{10, -off}, {4, -2}}, room, 0.5),
               IsNear(Ball{{12, -off - 1}, {4, -2}}, rounding));                                                 // away
    CHECK_THAT(move_and_bounce({{10, -off}, {4, 2}}, room, 0.5), IsNear(Ball{{12, 1 - off}, {4, 2}}, rounding)); // in
    // past the tip of the corner that points into the room
    CHECK_THAT(move_and_bounce({{5, 3.5 - off}, {2, 0}}, cave, 1.5), IsNear(Ball{{8, 3.5 - off}, {2, 0}}, rounding));
    // of a room a thousand times smaller too
    std::vector<Vec2> small_room = room;
    for (Vec2 &corner : small_room) corner *= 1e-3;
    CHECK_THAT(move_and_bounce({{0.01, -off}, {0.004, -2}}, small_room, 0.5),
               IsNear(Ball{{0.012, -off - 1}, {0.004, -2}}, rounding));
}

TEST_CASE("contact_tolerance is in metres: a ball passes 5 micrometres beside a wall of 10 km", "[7.4]") {
    // 5e-6 m beside the corner that points into the room: thousands of times the tolerance, and 5e-10 of the wall
    const std::vector<Vec2> l{{0, 0}, {2e4, 0}, {2e4, 1e4}, {1e4, 1e4}, {1e4, 2e4}, {0, 2e4}};
    const double beside = 1e4 - 5e-6;
    CHECK_THAT(move_and_bounce({{9990, beside}, {2, 0}}, l, 10), IsNear(Ball{{10010, beside}, {2, 0}}, rounding));
    CHECK_THAT(move_and_bounce({{beside, 9990}, {0, 2}}, l, 10), IsNear(Ball{{beside, 10010}, {0, 2}}, rounding));
}

//> No escape
TEST_CASE("in a hundred thousand frames the ball never leaves the room, and keeps its speed", "[7.4]") {
    Ball ball{.position = {2, 3}, .velocity = {2.3, 1.1}};
    Dice dice;
    for (int frame = 0; frame < course::cases(100000); ++frame) {
        ball = move_and_bounce(ball, cave, dice.real(0, 2)); // up to five metres, and several walls

        CHECK_THAT(outside(ball.position, cave), IsBelow(1e-9).of("distance outside of the room [m]"));
        CHECK_THAT(ball.velocity.norm(),
                   IsNear(std::hypot(2.3, 1.1), 1e-9).of("speed [m/s]")); // two roundings a bounce, 1e5 bounces
    }
}

//> Many frames and one
TEST_CASE("two hundred short frames lead to the same place as one long one", "[7.4]") {
    const Vec2 velocity = GENERATE(Vec2{2.3, 1.1}, Vec2{-0.7, 2.9}, Vec2{-3.1, -0.4}, Vec2{0, 1.7}, Vec2{1.9, 0});
    const Ball at_once = move_and_bounce({{2, 3}, velocity}, cave, 30);

    Ball frame_by_frame{{2, 3}, velocity};
    for (int frame = 0; frame < 200; ++frame) frame_by_frame = move_and_bounce(frame_by_frame, cave, 0.15);

    // two hundred roundings of 1e-15 over 100 m
    CHECK_THAT(at_once, IsNear(frame_by_frame, 1e-9).of("the ball after one long frame"));
}

TEST_CASE("a ball with its velocity reversed returns to where it started", "[7.4]") {
    const Vec2 velocity = GENERATE(Vec2{2.3, 1.1}, Vec2{-0.7, 2.9}, Vec2{-3.1, -0.4}, Vec2{0, 1.7}, Vec2{1.9, 0});
    const double dt = GENERATE(0.7, 3.0, 60.0);

    const Ball there = move_and_bounce({{2, 3}, velocity}, cave, dt);
    const Ball home = move_and_bounce({there.position, -there.velocity}, cave, dt);

    CHECK_THAT(home, IsNear(Ball{{2, 3}, -velocity}, 1e-9));
}

//>
TEST_CASE("in a rectangle the ball ends where the mirror-image construction puts it", "[7.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Vec2 size = dice.point(1, 9), velocity = dice.point(-5, 5);
        const Vec2 start = size.cwiseProduct(dice.point(0.01, 0.99));
        const double dt = dice.real(0, 20);

        Ball want;
        bool near_wall = false; // a rounding decides whether it has turned
        for (int axis : {0, 1}) {
            const double way = start[axis] + velocity[axis] * dt, room_twice = 2 * size[axis];
            const double rest = way - room_twice * std::floor(way / room_twice);
            want.position[axis] = std::min(rest, room_twice - rest);
            want.velocity[axis] = rest < size[axis] ? velocity[axis] : -velocity[axis];
            near_wall = near_wall || std::min(want.position[axis], size[axis] - want.position[axis]) < 1e-6;
        }
        if (near_wall) continue;

        const Vec2 low{-3, 5}; // the rectangle's corner
        want.position += low;
        const std::vector<Vec2> box{low, low + Vec2{size.x(), 0}, low + size, low + Vec2{0, size.y()}};
        CHECK_THAT(move_and_bounce({low + start, velocity}, box, dt),
                   IsNear(want, 1e-10)); // 100 m, and some 200 bounces
    }
}

TEST_CASE("turning, mirroring, moving or scaling everything does the same to the answer", "[7.4]") {
    const Vec2 across = GENERATE(Vec2{0.8, -0.6}, Vec2{-0.8, 0.6}); // turned, or mirrored
    const double scale = GENERATE(0.01, 3.0, 500.0);
    const auto there = [&](const Vec2 &v) -> Vec2 { return scale * (v.x() * Vec2{0.6, 0.8} + v.y() * across); };
    const Vec2 by{70, -20};
    std::vector<Vec2> corners = cave;
    for (Vec2 &corner : corners) corner = there(corner) + by;

    const Ball plain = move_and_bounce({{2, 3}, {2.3, 1.1}}, cave, 20);
    const Ball after = move_and_bounce({there({2, 3}) + by, there({2.3, 1.1})}, corners, 20);

    CHECK_THAT(after.position,
               IsNear(Vec2{there(plain.position) + by}, 1e-9).of("position, against the one in the cave [m]"));
    CHECK_THAT(after.velocity, IsNear(there(plain.velocity), 1e-9).of("velocity, against the one in the cave [m/s]"));
}

TEST_CASE("a ball that hits the tip of a corner stays inside the room, at its full speed", "[7.4]") {
    const Vec2 from = GENERATE(Vec2{2, 3}, Vec2{6.5, 1}, Vec2{9, 2}, Vec2{4, 4}, Vec2{9, 5});
    const Vec2 tip{6.5, 3.5};
    const double speed = GENERATE(0.5, 3.0, 40.0);
    const Vec2 velocity = speed * (tip - from).normalized();

    const double there = (tip - from).norm() / speed;
    const Ball after = move_and_bounce({from, velocity}, cave, there + 0.1 / speed);

    CHECK_THAT(outside(after.position, cave), IsBelow(1e-9).of("distance outside of the room [m]"));
    CHECK_THAT(after.velocity.norm(), IsNear(speed, rounding).of("speed [m/s]"));
    CHECK_THAT((after.position - tip).norm(), IsNear(0.1, 1e-8).of("distance from the tip [m]")); // it did not stay
}

TEST_CASE("a ball aimed exactly at a corner does not leave the room; a corner of 60° mirrors it", "[7.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 corner = room[std::size_t(dice.whole(0, 3))], from = dice.point(3, 7);
        const Vec2 velocity = dice.real(0.5, 2) * (corner - from); // there after half a second to two

        const Ball after = move_and_bounce({from, velocity}, room, 2.5);

        CHECK_THAT(outside(after.position, room), IsBelow(1e-8).of("distance outside of the room [m]"));
        CHECK_THAT(after.velocity.norm(), IsNear(velocity.norm(), 1e-10).of("speed [m/s]"));
    }

    // In one of 60° it meets three walls, one after the other: it flies in at 18° from the floor, and comes out at 42°.
    const std::vector<Vec2> corner_60{{0, 0}, {8, 0}, {4, 4 * std::sqrt(3)}};
    const Vec2 bisector{std::sqrt(3) / 2, 0.5}, mirrored = 2 * Vec2{3, 1}.dot(bisector) * bisector - Vec2{3, 1};
    CHECK_THAT(move_and_bounce({{3, 1}, {-3, -1}}, corner_60, 2), IsNear(Ball{mirrored, mirrored}, 1e-8));

    // In one of 45° it meets four, and comes out as it came.
    const std::vector<Vec2> corner_45{{0, 0}, {8, 0}, {8, 8}};
    CHECK_THAT(move_and_bounce({{3, 1}, {-3, -1}}, corner_45, 2), IsNear(Ball{{3, 1}, {3, 1}}, 1e-8));
}

TEST_CASE("after max_bounces bounces in one call the ball stays where it is, with its velocity", "[7.4]") {
    // 5 m to the right wall, then 999 times 8 m back and forth: 79.97 ms, in which it rises by 0.7997 m
    const std::vector<Vec2> shaft{{0, 0}, {8, 1}, {8, 6}, {0, 4}};
    const double dt = GENERATE(0.08, 0.1, 1.0, 1e5);
    CHECK_THAT(max_bounces, IsNear(1000).of("max_bounces"));
    CHECK_THAT(move_and_bounce({{3, 2}, {1e5, 10}}, shaft, dt), IsNear(Ball{{0, 2.7997}, {1e5, 10}}, 1e-8));
}

TEST_CASE("a ball that flies into a very sharp corner comes out again", "[7.4]") {
    // an angle of 0.02: some 150 bounces, at once or in little steps
    const std::vector<Vec2> needle{{0, 0}, {50, -0.5}, {53, 0}, {50, 0.5}};
    const Ball after = move_and_bounce({{40, 0.1}, {-20, 0.3}}, needle, 4.2);
    CHECK_THAT(outside(after.position, needle), IsBelow(1e-9).of("distance outside of the room [m]"));
    CHECK_THAT(after.velocity.norm(), IsNear(std::hypot(20, 0.3), 1e-9).of("speed [m/s]"));
    CHECK_THAT(after.velocity.x(), IsAbove(15).of("velocity along x [m/s]")); // it has turned
    CHECK_THAT(after.position.x(), IsAbove(20).of("x [m]"));                  // and is far out

    const Ball stuck = move_and_bounce({{40, 0}, {-20, 0}}, needle, 3); // exactly into the tip, which is 2 s away
    CHECK_THAT(outside(stuck.position, needle), IsBelow(1e-8).of("distance outside of the room [m]"));
    CHECK_THAT(stuck.velocity.norm(), IsNear(20.0, 1e-9).of("speed [m/s]"));
}

TEST_CASE("an impossible room or a negative time is refused", "[7.4]") {
    const Ball good{{4, 3}, {2, -1.5}};
    const std::vector<Vec2> two_corners{{0, 0}, {20, 0}}, twice{{0, 0}, {20, 0}, {20, 0}, {2, 8}};
    CHECK_REFUSED(move_and_bounce(good, {}, 1), "a room without corners");
    CHECK_REFUSED(move_and_bounce(good, {{0, 0}}, 1), "a room of one corner");
    CHECK_REFUSED(move_and_bounce(good, two_corners, 1), "a room of two corners");
    CHECK_REFUSED(move_and_bounce(good, twice, 1), "a corner that equals the next");
    CHECK_REFUSED(move_and_bounce(good, {{0, 0}, {20, 0}, {11, 12}, {0, 0}}, 1), "a last corner that equals the first");
    CHECK_REFUSED(move_and_bounce(good, room, -0.1), "dt = -0.1 s");
    CHECK_REFUSED(move_and_bounce(good, room, -5e-324), "dt = -5e-324 s");

    const Ball resting{{4, 3}, {0, 0}};
    CHECK_REFUSED(move_and_bounce(resting, two_corners, 1), "a ball at rest in a room of two corners");
    CHECK_REFUSED(move_and_bounce(resting, twice, 1), "a ball at rest, and a corner that equals the next");
    CHECK_REFUSED(move_and_bounce(resting, room, -0.1), "a ball at rest, and dt = -0.1 s");
    CHECK_REFUSED(move_and_bounce(good, two_corners, 0), "no time in a room of two corners");
    CHECK_REFUSED(move_and_bounce(good, twice, 0), "no time, and a corner that equals the next");
}

// --------------------------------------------------------------------------------------------------- 7.5 time_of_impact

const Segment ground{.start = {0, 0}, .end = {20, 0}};

//> Side and end
TEST_CASE("a disc touches a wall when its centre is one radius away", "[7.5]") {
    CHECK_THAT(time_of_impact({{0, 3}, {4, -1}}, 1, ground),
               IsNear(Impact{0.5, {2, 1}, {2, 0}}, rounding)
                   .since("it falls 4 m in all, and 1 m above the ground it has fallen 2 m"));
    CHECK_THAT(time_of_impact({{0, 3}, {8, 3}}, 2.5, {{7, -4}, {7, 1.5}}),
               IsNear(Impact{0.625, {5, 3}, {7, 1.5}}, rounding)
                   .since("the wall ends 1.5 m lower, and 2.5² = 1.5² + 2²: 2 m before it, at x = 5 of 8"));
}

//> Erratum E7.9
TEST_CASE("erratum E7.9: a disc touches a wall that its centre never reaches", "[7.5]") {
    // from 1.5 m to 0.5 m above the ground: a point does not reach it, a disc of radius 1 m touches halfway
    CHECK_THAT(time_of_impact({{0, 1.5}, {8, 0.5}}, 1, ground), IsNear(Impact{0.5, {4, 1}, {4, 0}}, rounding));
}

//>
TEST_CASE("a wall is touched from either side, at either end, whichever way it runs", "[7.5]") {
    const Segment leaning = GENERATE(Segment{{2, 1}, {14, 10}}, Segment{{14, 10}, {2, 1}}); // along (4, 3), 15 m long
    const Vec2 along{0.8, 0.6}, up{-0.6, 0.8}, middle{8, 5.5};

    // from 6 m above the middle, straight down 8 m: 2 m before it after half of that
    CHECK_THAT(time_of_impact({middle + 6 * up, middle - 2 * up}, 2, leaning),
               IsNear(Impact{0.5, middle + 2 * up, middle}, rounding));
    CHECK_THAT(time_of_impact({middle - 6 * up, middle + 2 * up}, 2, leaning),
               IsNear(Impact{0.5, middle - 2 * up, middle}, rounding));
    // along its line, from 5 m before an end, 10 m far: 2 m before that end after 3 of them
    CHECK_THAT(time_of_impact({Vec2{2, 1} - 5 * along, Vec2{2, 1} + 5 * along}, 2, leaning),
               IsNear(Impact{0.3, Vec2{2, 1} - 2 * along, {2, 1}}, rounding));
    CHECK_THAT(time_of_impact({Vec2{14, 10} + 5 * along, Vec2{14, 10} - 5 * along}, 2, leaning),
               IsNear(Impact{0.3, Vec2{14, 10} + 2 * along, {14, 10}}, rounding));
}

TEST_CASE("scaling everything leaves t as it is, for horizontal and vertical walls", "[7.5]") {
    const double scale = GENERATE(1.0, 1e-5, 1e-11);
    const auto at = [&](const Vec2 &start, const Vec2 &end, double radius, const Segment &edge) {
        return time_of_impact(moved({start, end}, scale, {0, 0}), scale * radius, moved(edge, scale, {0, 0}));
    };
    CHECK_THAT(at({0, 3}, {4, -1}, 1, ground), IsNear(Impact{0.5, scale * Vec2{2, 1}, scale * Vec2{2, 0}}, rounding));
    CHECK_THAT(at({0, 3}, {8, 3}, 2.5, {{7, -4}, {7, 1.5}}),
               IsNear(Impact{0.625, scale * Vec2{5, 3}, scale * Vec2{7, 1.5}}, rounding));
    CHECK_THAT(at({0, 3}, {8, 3}, 1, {{7, 9}, {7, -9}}),
               IsNear(Impact{0.75, scale * Vec2{6, 3}, scale * Vec2{7, 3}}, rounding));
    CHECK_THAT(at({9, 3}, {1, 3}, 0.4, {{7, 9}, {7, -9}}),
               IsNear(Impact{0.2, scale * Vec2{7.4, 3}, scale * Vec2{7, 3}}, rounding));
}

TEST_CASE("a wall shorter than a micrometre is touched at its end or at its side", "[7.5]") {
    const double length = GENERATE(5e-7, 5e-11, 5e-13); // [m]
    const Segment hair{{6, 0}, {6, length}};
    CHECK_THAT(time_of_impact({{0, length}, {10, length}}, 1, hair),
               IsNear(Impact{0.5, {5, length}, {6, length}}, rounding));
    CHECK_THAT(time_of_impact({{0, length / 2}, {10, length / 2}}, 0, hair),
               IsNear(Impact{0.6, {6, length / 2}, {6, length / 2}}, rounding));
    CHECK_THAT(time_of_impact({{0, 9.5e4}, {0, 8.5e4}}, 9e4, {{-length, 0}, {length, 0}}),
               IsNear(Impact{0.5, {0, 9e4}, {0, 0}}, 1e-10)); // by a disc that is 180 km wide
}

TEST_CASE("an impact counts up to the very end of the motion, and not after", "[7.5]") {
    const double before = GENERATE(1e-3, 5e-7, 5e-10, 5e-12); // a fraction of the motion
    CHECK_THAT(time_of_impact({{5, 2}, {5, 1 - before}}, 1, ground),
               IsNear(Impact{1 / (1 + before), {5, 1}, {5, 0}}, rounding));
    CHECK_THAT(time_of_impact({{5, 2}, {5, 1 + before}}, 1, ground), IsNear(never));
    CHECK_THAT(time_of_impact({{5, 2}, {5, 1}}, 1, ground), IsNear(Impact{1, {5, 1}, {5, 0}}, rounding));
}

TEST_CASE("a disc touches a post that it passes just within its radius, and misses one just outside", "[7.5]") {
    const double gap = GENERATE(1e-6, 1e-8, 1e-10); // [m]; the length within the circle is the root of it
    const Segment post{{5, 0}, {5, 0}};
    const double to_post = std::sqrt(gap * (2 - gap)), y = 1 - gap;
    CHECK_THAT(time_of_impact({{0, y}, {10, y}}, 1, post),
               IsNear(Impact{0.5 - to_post / 10, {5 - to_post, y}, {5, 0}}, 1e-9));
    CHECK_THAT(time_of_impact({{0, 1 + gap}, {10, 1 + gap}}, 1, post), IsNear(never));
}

TEST_CASE("a small disc touches a wall right up to its ends, and just misses it beyond them", "[7.5]") {
    const double beside = GENERATE(1e-2, 1e-6), radius = 1e-9; // [m]
    for (const double x : {beside, 20 - beside})
        CHECK_THAT(time_of_impact({{x, 6}, {x, -2}}, radius, ground), IsNear(Impact{0.75, {x, radius}, {x, 0}}, 1e-9));
    for (const double x : {-beside, 20 + beside})
        CHECK_THAT(time_of_impact({{x, 6}, {x, -2}}, radius, ground), IsNear(never));

    const double small = GENERATE(1e-5, 1e-8, 1e-11); // [m]
    CHECK_THAT(time_of_impact({{2, 0.5}, {2, -0.5}}, small, ground),
               IsNear(Impact{0.5 - small, {2, small}, {2, 0}}, rounding));
}

TEST_CASE("a disc that moves by less than a micrometre can still touch", "[7.5]") {
    const double length = GENERATE(1e-7, 1e-13, 1e-40); // [m]
    CHECK_THAT(time_of_impact({{2, 0.5 * length}, {2, -0.5 * length}}, 0.25 * length, ground),
               IsNear(Impact{0.25, {2, 0.25 * length}, {2, 0}}, rounding));
}

TEST_CASE("each call stands alone: the impact and the radius of the call before are forgotten", "[7.5]") {
    CHECK_THAT(time_of_impact({{0, 1.001}, {0, -0.999}}, 1, ground), IsNear(Impact{5e-4, {0, 1}, {0, 0}}, rounding));
    CHECK_THAT(time_of_impact({{0, 3}, {8, 3}}, 2.5, {{7, -4}, {7, 1.5}}),
               IsNear(Impact{0.625, {5, 3}, {7, 1.5}}, rounding));
    CHECK_THAT(time_of_impact({{2, 3}, {2, -1}}, 2, ground), IsNear(Impact{0.25, {2, 2}, {2, 0}}, rounding));
    CHECK_THAT(time_of_impact({{2, 3}, {2, -1}}, 1, ground), IsNear(Impact{0.5, {2, 1}, {2, 0}}, rounding));
}

TEST_CASE("numbers of exactly ±1e5 are accepted", "[7.5]") {
    CHECK_THAT(time_of_impact({{1e5, 1e5}, {1e5, -1e5}}, 1e5, {{-1e5, -1e5}, {1e5, -1e5}}),
               IsNear(Impact{0.5, {1e5, 0}, {1e5, -1e5}}, 1e-9));
    CHECK_THAT(time_of_impact({{0, 1e5}, {0, -1e5}}, 1e5, {{-1e5, -1e5}, {1e5, -1e5}}),
               IsNear(Impact{0.5, {0, 0}, {0, -1e5}}, 1e-9));
}

TEST_CASE("a disc that stops short of a wall, or passes it, does not touch it", "[7.5]") {
    CHECK_THAT(time_of_impact({{3, 9}, {5, 1.1}}, 1, ground), IsNear(never));      // stops 10 cm too early
    CHECK_THAT(time_of_impact({{-9, 1.1}, {30, 1.1}}, 1, ground), IsNear(never));  // passes above it
    CHECK_THAT(time_of_impact({{-9, 2}, {-1.1, 0}}, 1, ground), IsNear(never));    // stops before its end
    CHECK_THAT(time_of_impact({{22, 6}, {22, -6}}, 1, ground), IsNear(never));     // falls beside its end
    CHECK_THAT(time_of_impact({{20.8, 6}, {21.7, -6}}, 1, ground), IsNear(never)); // so, though near to it at first
    CHECK_THAT(time_of_impact({{5, 2}, {6, 9}}, 1, ground), IsNear(never));        // leaves
    CHECK_THAT(time_of_impact({{5, 2}, {5, 2}}, 1, ground), IsNear(never));        // rests
}

TEST_CASE("a disc that falls past the end of a wall touches that end with its side", "[7.5]") {
    // 0.6 m beside the end, radius 1: 0.8 m above it, having fallen 5.2 of 8 m
    CHECK_THAT(time_of_impact({{20.6, 6}, {20.6, -2}}, 1, ground),
               IsNear(Impact{0.65, {20.6, 0.8}, {20, 0}}, rounding));
    CHECK_THAT(time_of_impact({{-0.6, 6}, {-0.6, -2}}, 1, ground), IsNear(Impact{0.65, {-0.6, 0.8}, {0, 0}}, rounding));
    CHECK_THAT(time_of_impact({{20.6, -6}, {20.6, 2}}, 1, ground),
               IsNear(Impact{0.65, {20.6, -0.8}, {20, 0}}, rounding));
}

TEST_CASE("a disc never jumps over a wall, however fast it is", "[7.5]") {
    CHECK_THAT(time_of_impact({{5, 9e4}, {5, -9e4}}, 0.5, ground),
               IsNear(Impact{89999.5 / 180000, {5, 0.5}, {5, 0}}, 1e-10));
}

TEST_CASE("a disc in contact at the start has t = 0 if it gets closer, and no impact if it leaves or slides", "[7.5]") {
    const double height = GENERATE(1.0, 0.25, -0.5, -1.0); // touching, or overlapping, above and below
    const double away = height > 0 ? 1 : -1;

    CHECK_THAT(time_of_impact({{5, height}, {7, height - 3 * away}}, 1, ground),
               IsNear(Impact{0, {5, height}, {5, 0}}, rounding));
    CHECK_THAT(time_of_impact({{5, height}, {7, height + 3 * away}}, 1, ground), IsNear(never));
    CHECK_THAT(time_of_impact({{5, height}, {7, height}}, 1, ground), IsNear(never));
    CHECK_THAT(time_of_impact({{5, height}, {5, height}}, 1, ground), IsNear(never));
}

TEST_CASE("a disc that overlaps by a hair has t = 0, and one a hair away has t just above 0", "[7.5]") {
    const double small = GENERATE(1e-6, 1e-9, 1e-12); // [m]
    CHECK_THAT(time_of_impact({{5, 1 - small}, {7, -2}}, 1, ground),
               IsNear(Impact{0, {5, 1 - small}, {5, 0}}, rounding));
    CHECK_THAT(time_of_impact({{5, 0.5}, {7, 0.5 - small}}, 1, ground), IsNear(Impact{0, {5, 0.5}, {5, 0}}, rounding));
    CHECK_THAT(time_of_impact({{5, 0.5}, {7, 0.5 + small}}, 1, ground), IsNear(never));
    CHECK_THAT(time_of_impact({{5, 1 + small}, {5, small - 1}}, 1, ground),
               IsNear(Impact{small / 2, {5, 1}, {5, 0}}, 1e-13));
}

TEST_CASE("a disc with its centre on the wall cannot get closer, so there is no impact", "[7.5]") {
    CHECK_THAT(time_of_impact({{5, 0}, {7, -3}}, 1, ground), IsNear(never));
    CHECK_THAT(time_of_impact({{5, 0}, {9, 0}}, 1, ground), IsNear(never));
}

TEST_CASE("a disc that overlaps an end of a wall, or a post, is judged by its distance from that point", "[7.5]") {
    CHECK_THAT(time_of_impact({{20.3, 0.4}, {19, 0.4}}, 1, ground),
               IsNear(Impact{0, {20.3, 0.4}, {20, 0}}, rounding)); // nearer
    CHECK_THAT(time_of_impact({{20.3, 0.4}, {24, -0.4}}, 1, ground),
               IsNear(never)); // down, but away: 0.3 · 3.7 > 0.4 · 0.8

    const Segment post{{5, 5}, {5, 5}};
    CHECK_THAT(time_of_impact({{4, 5}, {6, 5}}, 2, post), IsNear(Impact{0, {4, 5}, {5, 5}}, rounding)); // overlaps
    CHECK_THAT(time_of_impact({{4, 5}, {6, 5}}, 1, post), IsNear(Impact{0, {4, 5}, {5, 5}}, rounding)); // touches
    CHECK_THAT(time_of_impact({{4, 5}, {3, 6}}, 2, post), IsNear(never));                               // leaves
    CHECK_THAT(time_of_impact({{4, 5}, {4, 6}}, 1, post), IsNear(never));                               // slides
}

TEST_CASE("a post is touched from every side, and a disc of radius 0 is a point", "[7.5]") {
    const Segment post{{6, 2}, {6, 2}};
    CHECK_THAT(time_of_impact({{-2, 2}, {8, 2}}, 3, post), IsNear(Impact{0.5, {3, 2}, {6, 2}}, rounding));
    CHECK_THAT(time_of_impact({{0, -2}, {18, -2}}, 5, post),
               IsNear(Impact{1.0 / 6, {3, -2}, {6, 2}}, rounding)
                   .since("the post is 4 m higher, and 5² = 3² + 4²: 3 m before it"));
    CHECK_THAT(time_of_impact({{0, -4}, {18, -4}}, 5, post), IsNear(never));
    CHECK_THAT(time_of_impact({{6, 9.5e4}, {6, 8.5e4}}, 9e4 - 2, post), IsNear(Impact{0.5, {6, 9e4}, {6, 2}}, 1e-10));
    CHECK_THAT(time_of_impact({{5, 6}, {5, -2}}, 0, ground), IsNear(Impact{0.75, {5, 0}, {5, 0}}, rounding));
    CHECK_THAT(time_of_impact({{5, 6}, {5, -2}}, -0.0, ground), IsNear(Impact{0.75, {5, 0}, {5, 0}}, rounding));
    CHECK_THAT(time_of_impact({{5, 6}, {5, 2}}, 0, ground), IsNear(never));
    CHECK_THAT(time_of_impact({{21, 6}, {21, -2}}, 0, ground), IsNear(never));
}

namespace {

Vec2 nearest(const Segment &s, const Vec2 &p) {
    const Vec2 along = s.end - s.start;
    return s.start
           + (along.isZero() ? 0 : std::clamp((p - s.start).dot(along) / along.squaredNorm(), 0.0, 1.0)) * along;
}

} // namespace

TEST_CASE("the time of impact agrees with a search by bisection", "[7.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Segment way{dice.point(-10, 10), dice.point(-10, 10)}, edge{dice.point(-6, 6), dice.point(-6, 6)};
        const double radius = dice.real(0, 4);
        const auto clearance = [&](double t) {
            const Vec2 centre = way.start + t * (way.end - way.start);
            return (centre - nearest(edge, centre)).norm() - radius;
        };
        if (clearance(0) < 1e-6) continue; // it has tests of its own

        // The distance falls first and then grows: thirds find where it is least, halves where it is one radius.
        double low = 0, high = 1;
        for (int step = 0; step < 200; ++step) {
            const double third = (high - low) / 3;
            if (clearance(low + third) < clearance(high - third)) high -= third;
            else low += third;
        }
        const double least = clearance(low);
        if (std::abs(least) < 1e-4) continue; // nearly a graze: the time hangs on the root of a rounding

        const auto impact = time_of_impact(way, radius, edge);
        if (least > 0) {
            CHECK_THAT(impact, IsNear(never));
            continue;
        }
        double before = 0, after = low;
        for (int step = 0; step < 60; ++step)
            (clearance((before + after) / 2) > 0 ? before : after) = (before + after) / 2;
        const Vec2 centre = way.start + after * (way.end - way.start);
        // A rounding of 1e-15, a hundredfold where it nearly grazes (the root of 1e-4), and room.
        CHECK_THAT(impact, IsNear(Impact{after, centre, nearest(edge, centre)}, 1e-9));
    }
}

TEST_CASE("a negative radius is refused", "[7.5]") {
    const Segment post{{6, 2}, {6, 2}}, leaving{{5, 2}, {6, 9}};
    CHECK_REFUSED(time_of_impact(motion, -0.1, ground), "radius = -0.1 m");
    CHECK_REFUSED(time_of_impact(motion, -5e-324, ground), "radius = -5e-324 m");
    CHECK_REFUSED(time_of_impact(motion, -0.1, post), "radius = -0.1 m at a post");
    CHECK_REFUSED(time_of_impact(leaving, -0.1, ground), "radius = -0.1 m of a disc that leaves");
    CHECK_REFUSED(time_of_impact(post, -0.1, ground), "radius = -0.1 m of a disc at rest");
}

// ------------------------------------------------------------------------------------------------------ 7.6 orientation

//> Left and right
TEST_CASE("left is 1, right is -1, parallel is 0", "[7.6]") {
    CHECK_THAT(orientation({{2, 5}, {5, 6}}, {{7, 1}, {8, 4}}), IsNear(1));    // (3, 1), (1, 3): 9 - 1
    CHECK_THAT(orientation({{7, 1}, {8, 4}}, {{2, 5}, {5, 6}}), IsNear(-1));   // (1, 3), (3, 1): 1 - 9
    CHECK_THAT(orientation({{2, 5}, {5, 6}}, {{8, 4}, {7, 1}}), IsNear(-1));   // (3, 1), (-1, -3)
    CHECK_THAT(orientation({{2, 5}, {5, 6}}, {{0, 0}, {6, 2}}), IsNear(0));    // (3, 1), (6, 2)
    CHECK_THAT(orientation({{2, 5}, {5, 6}}, {{6, 2}, {0, 0}}), IsNear(0));    // (3, 1), (-6, -2)
    CHECK_THAT(orientation({{2, 5}, {5, 6}}, {{4, 4}, {4, 4}}), IsNear(0));    // a point has no direction
    CHECK_THAT(orientation({{0, 0}, {7, 0}}, {{0, 0}, {0, 1e-9}}), IsNear(1)); // small is not parallel
    CHECK_THAT(orientation({{0, 0}, {7, 0}}, {{3, 0}, {-9, -1e-9}}), IsNear(-1));
}

//> Where rounding flips the sign
TEST_CASE("where the rounded determinant has the wrong sign, the answer is 0 or the right sign", "[7.6]") {
    // On paper both go (2.5, 2.9). In the computer 3.7 - 0.8 is not 2.9: the plain formula gives D = 8.9e-16, left,
    // but these eight numbers, as they are stored, have D = -8.9e-17 exactly: right.
    CHECK_THAT(orientation({{1, 1}, {3.5, 3.9}}, {{0.7, 0.8}, {3.2, 3.7}}), IsAtMost(0));
}

//> Against the exact determinant
struct Determinant {
    course::Exact d;         ///< as it is for the numbers as they are stored
    course::Exact tolerance; ///< below which 0 is allowed
};

Determinant exact(const Segment &first, const Segment &second) {
    using course::Exact;
    const auto minus = [](double end, double start) { return Exact{end} - Exact{start}; };
    const Exact left = minus(first.end.x(), first.start.x()) * minus(second.end.y(), second.start.y());
    const Exact right = minus(first.end.y(), first.start.y()) * minus(second.end.x(), second.start.x());
    return {left - right, Exact{1e-15} * (abs(left) + abs(right)) + Exact{1e-300}};
}

TEST_CASE("nearly parallel segments never get the wrong sign, nor a 0 where the sign can be told", "[7.6]") {
    const double scale = GENERATE(1.0, 0x1p-30, 0x1p13);
    Dice dice;
    for (int i = 0; i < course::cases(100000) / 3; ++i) {
        // Every direction; and those whose numbers are just above 1, where a rounding is worst.
        const Vec2 along = i % 2 == 0 ? dice.point(-1, 1) : Vec2{dice.sign() * dice.real(1, 1.06), dice.real(1, 1.06)};
        const Vec2 turned = along + std::ldexp(dice.real(-1, 1), -dice.whole(46, 56)) * Vec2{-along.y(), along.x()};
        const Vec2 start_1 = dice.point(-0.1, 0.1), start_2 = dice.point(-0.1, 0.1); // digits that a difference loses
        const Vec2 end_1 = start_1 + dice.real(1, 1.03) * along,
                   end_2 = start_2 + dice.sign() * dice.real(1, 1.03) * turned;
        const Segment first{scale * start_1, scale * end_1}, second{scale * start_2, scale * end_2};
        const auto [d, tolerance] = exact(first, second);

        const int got = orientation(first, second);

        if (got != 0 || abs(d) > tolerance) CHECK_THAT(got, IsNear(d.sign()));
    }
}

//>
TEST_CASE("the sign is that of the exact determinant, from 1e-60 m to 1e5 m", "[7.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double size_1 = std::ldexp(1.0, -dice.whole(-16, 199)), size_2 = std::ldexp(1.0, -dice.whole(-16, 199));
        const Segment first{{0, 0}, size_1 * dice.point(-1, 1)}, second{{0, 0}, size_2 * dice.point(-1, 1)};
        const auto [d, tolerance] = exact(first, second);

        if (abs(d) > tolerance) CHECK_THAT(orientation(first, second), IsNear(d.sign()));
    }
}

TEST_CASE("four of the worst cases: 0 is allowed up to 1e-15 of the exact D, not of the computed one", "[7.6]") {
    // Computed, D is 2.2e-16 of its two products together; these eight numbers, as they are stored, have -2.3e-17 of them.
    const Segment first{{0.0066887441641682033, 0.035824353454739041}, {1.0085581351620307, 1.0543505924393419}};
    const Segment second{{-0.047818887578320146, -0.040134572186612497}, {0.93427171066482462, 0.9582840364250792}};
    CHECK_THAT(orientation(first, second), IsAtMost(0));
    CHECK_THAT(orientation(second, first), IsAtLeast(0));

    // Computed, it is 3.1e-16 of them, truly -6e-20: all six roundings go the same way, so 3e-16 is not enough.
    const double h = 1.1099519740820352e-16; // nearly half a rounding of a number above 1
    const Segment up{{h, -h}, {1.0363408603774193, 1.043475314830111}};
    const Segment down{{-h, h}, {1.023184982690287, 1.0302288684761123}};
    CHECK_THAT(orientation(up, down), IsAtMost(0));
    CHECK_THAT(orientation(down, up), IsAtLeast(0));

    // Computed, it is 7.4e-16 of them, but truly 1.004e-15: no longer too close to tell. A doubt of all of the header's
    // 1e-15 gives 0 here; of the 1e-15, a good third is what the roundings can have taken away.
    const Segment third{{0.016757470922215703, 0.026790244964310109}, {1.0390542163852641, 1.0430544560098016}};
    const Segment fourth{{-0.010648782619675397, 0.032056641416541437}, {1.0278831682168375, 1.064460254502831}};
    CHECK_THAT(orientation(third, fourth), IsNear(1));
    CHECK_THAT(orientation(fourth, third), IsNear(-1));

    // In the 64 bits that a long double has on some machines, D is 5e-20 of them; truly it is -4e-20.
    const double k = 5.4196873734474373e-20;
    const Segment left{{k, -k}, {1.009469358584476, 1.022237463350789}};
    const Segment right{{-k, k}, {1.035790392257265, 1.0488914142266945}};
    CHECK_THAT(orientation(left, right), IsAtMost(0));
    CHECK_THAT(orientation(right, left), IsAtLeast(0));
}

TEST_CASE("along an axis both products are tiny, and so is the range in which 0 is allowed", "[7.6]") {
    CHECK_THAT(orientation({{0, 0}, {1, 1e-9}}, {{0, 0}, {1, 1.0000001e-9}}), IsNear(1)); // D = 1e-16, of 2e-9
    CHECK_THAT(orientation({{0, 0}, {1e-9, 1}}, {{0, 0}, {1.0000001e-9, 1}}), IsNear(-1));
    for (const double d : {1e-12, 1e-30, 1e-100, 1e-200, 1e-250, 1e-290, 1.5e-300}) { // [m²]
        CHECK_THAT(orientation({{0, 0}, {1, 0}}, {{0, 0}, {1, d}}), IsNear(1));
        CHECK_THAT(orientation({{0, 0}, {0, 1}}, {{0, 0}, {d, 1}}), IsNear(-1));
    }
}

TEST_CASE("short segments far from the origin have the same orientation as near it", "[7.6]") {
    const Segment level{{9e4, 9e4}, {9e4 + 0x1p-10, 9e4}}, vertical{{-9e4, 9e4}, {-9e4, 9e4 + 0x1p-10}};
    CHECK_THAT(orientation(level, vertical), IsNear(1));
    CHECK_THAT(orientation(vertical, level), IsNear(-1));
}

TEST_CASE("coordinates of exactly ±1e5 are accepted", "[7.6]") {
    CHECK_THAT(orientation({{-1e5, -1e5}, {1e5, 1e5}}, {{1e5, -1e5}, {-1e5, 1e5}}), IsNear(1));
    CHECK_THAT(orientation({{1e5, 1e5}, {-1e5, -1e5}}, {{1e5, -1e5}, {-1e5, 1e5}}), IsNear(-1));
}
