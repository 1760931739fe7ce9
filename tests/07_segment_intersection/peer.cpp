// needs CGAL CGAL::CGAL libcgal-dev
// CGAL computes with exact fractions here, so all of the difference is our rounding. So do the tests of 7.6, with numbers
// of their own.
#include "../peers/peer.hpp"
#include "../exact.hpp"
#include "segment_intersection.hpp"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/version.h>

#include <boost/variant/get.hpp>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

using course::Vec2;
using namespace segment_intersection;
using course::worse, course::difference;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;

namespace {

constexpr int pairs = 100000; // in each comparison

Exact::Point_2 exact(const Vec2 &point) { return {point.x(), point.y()}; }
Exact::Segment_2 exact(const Segment &segment) { return {exact(segment.start), exact(segment.end)}; }
double distance(const Vec2 &got, const Exact::Point_2 &want) {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(exact(got), want)));
}
double distance(const Exact::Segment_2 &a, const Exact::Segment_2 &b) {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(a, b)));
}

/// Where on the segment's line a point of it is: 0 at the start, 1 at the end.
double parameter(const Exact::Segment_2 &segment, const Exact::Point_2 &point) {
    return CGAL::to_double((point - segment.source()) * segment.to_vector() / segment.squared_length());
}

Segment anywhere(Dice &dice) { return {dice.point(-100, 100), dice.point(-100, 100)}; }
/// On few whole numbers, so that many pairs touch, overlap or are parallel.
Segment on_grid(Dice &dice, int size) { return {dice.grid(-size, size), dice.grid(-size, size)}; }

constexpr double sine_of_6_degrees = 0.10452846;

bool far_from_parallel(const Segment &first, const Segment &second) {
    const Vec2 a = first.end - first.start, b = second.end - second.start;
    return std::abs(a.x() * b.y() - a.y() * b.x()) > sine_of_6_degrees * a.norm() * b.norm();
}

/// Pairs of lines that cross at 6° or more, and how far `differ` finds our point of intersection from the exact one.
template <class Differ> double for_crossing_lines(Dice &dice, Differ differ) {
    double largest = 0;
    for (int i = 0; i < pairs;) {
        const Segment motion = anywhere(dice), wall = anywhere(dice);
        if (!far_from_parallel(motion, wall)) continue;
        const auto want = CGAL::intersection(exact(motion).supporting_line(), exact(wall).supporting_line());
        const auto got = intersect_lines(motion, wall);
        largest = worse(differ(motion, wall, got.value(), boost::get<Exact::Point_2>(*want)), largest);
        ++i;
    }
    return largest;
}

double compare_parameters(Dice &dice) {
    return for_crossing_lines(dice, [](const Segment &motion, const Segment &wall, const auto &got, const auto &want) {
        return worse(difference(got.t, parameter(exact(motion), want)),
                     difference(got.s, parameter(exact(wall), want)));
    });
}

double compare_points(Dice &dice) {
    return for_crossing_lines(dice, [](const Segment &, const Segment &, const auto &got, const auto &want) {
        return distance(got.point, want) / std::max(1.0, got.point.norm());
    });
}

double compare_meetings(Dice &dice) {
    int others = 0;
    for (int i = 0; i < pairs; ++i) {
        const int size = i % 2 == 0 ? 5 : 1000;
        const Segment first = on_grid(dice, size), second = on_grid(dice, size);
        others += segments_intersect(first, second) != CGAL::do_intersect(exact(first), exact(second));
    }
    return others;
}

/// The points that CGAL finds: none, one, or the ends of a piece.
std::vector<Exact::Point_2> exact_common_points(const Segment &first, const Segment &second) {
    const auto common = CGAL::intersection(exact(first), exact(second));
    if (!common) return {};
    if (const auto *point = boost::get<Exact::Point_2>(&*common)) return {*point};
    const auto &piece = boost::get<Exact::Segment_2>(*common);
    if (piece.is_degenerate()) return {piece.source()};
    const bool forwards = (piece.target() - piece.source()) * exact(first).to_vector() > 0;
    return forwards ? std::vector{piece.source(), piece.target()} : std::vector{piece.target(), piece.source()};
}

double compare_numbers_of_common_points(Dice &dice) {
    int others = 0;
    for (int i = 0; i < pairs; ++i) {
        const Segment first = on_grid(dice, 5), second = on_grid(dice, 5);
        others += common_points(first, second).size() != exact_common_points(first, second).size();
    }
    return others;
}

double compare_common_points(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < pairs; ++i) {
        const Segment first = on_grid(dice, 5), second = on_grid(dice, 5);
        const auto got = common_points(first, second);
        const auto want = exact_common_points(first, second);
        if (got.size() != want.size()) continue; // which is counted above
        for (std::size_t k = 0; k < want.size(); ++k) largest = worse(distance(got[k], want[k]), largest);
    }
    return largest;
}

/// How far from its radius the disc is from the wall when it should touch it, having been no nearer before; and how many
/// metres too near it comes if it should never touch it.
double compare_impacts(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < pairs; ++i) {
        const Segment motion = anywhere(dice), wall = anywhere(dice);
        const double radius = dice.real(0, 50);
        if (distance({exact(motion.start), exact(motion.start)}, exact(wall)) <= radius) continue;
        const auto got = time_of_impact(motion, radius, wall);
        const double nearest = distance({exact(motion.start), exact(got ? got->centre : motion.end)}, exact(wall));
        largest = worse(got ? std::abs(nearest - radius) : radius - nearest, largest);
    }
    return largest;
}

/// Displacements that are nearly parallel, by a few units in the last place of one coordinate.
double compare_orientations(Dice &dice) {
    int others = 0;
    for (int i = 0; i < pairs; ++i) {
        const Segment first = anywhere(dice);
        const Vec2 end = first.end + dice.real(0.1, 1) * (first.end - first.start);
        const Segment second{first.start, {end.x() * (1 + dice.whole(-4, 4) * 0x1p-52), end.y()}};
        const int got = orientation(first, second);
        others += got != 0 && got != CGAL::orientation(exact(first).to_vector(), exact(second).to_vector());
    }
    return others;
}

/// Between 2^(power-1) and 2^power, of 53 bits.
double about(Dice &dice, int power) {
    return std::ldexp(dice.sign() * (dice.real(0.5, 1) + dice.real(0, 0x1p-28)), power);
}

/// Two factors, each from 5e-324 to 1e300, of a product whose digits a double can still tell.
std::pair<double, double> factors(Dice &dice) {
    const int power = dice.whole(-1073, 997), of_product = dice.whole(-900, 900);
    return {about(dice, power), about(dice, std::clamp(of_product - power, -1073, 997))};
}

/// Takes the same away from both, until nothing is left.
bool is_same(course::Exact got, CGAL::Exact_rational want) {
    while (got.sign() == CGAL::sign(want)) {
        if (got.sign() == 0) return true;
        const double most = CGAL::to_double(want);
        const auto order = got <=> course::Exact{most};
        if ((order > 0) - (order < 0) != CGAL::compare(want, CGAL::Exact_rational{most})) return false;
        got = got - course::Exact{most};
        want -= most;
    }
    return false;
}

/// a b - c d + e, where the products may be nearly the same, or nowhere near.
double compare_exact_numbers(Dice &dice) {
    using Theirs = CGAL::Exact_rational;
    using course::Exact;
    int others = 0;
    for (int i = 0; i < pairs; ++i) {
        const auto [a, b] = factors(dice);
        auto [c, d] = factors(dice);
        if (i % 2 == 0) std::tie(c, d) = std::pair{std::nextafter(b, dice.sign()), std::nextafter(a, dice.sign())};
        const double e = about(dice, dice.whole(-1073, 997));
        others += !is_same(Exact{a} * Exact{b} - Exact{c} * Exact{d} + Exact{e},
                           Theirs{a} * Theirs{b} - Theirs{c} * Theirs{d} + Theirs{e});
    }
    return others;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv, "Compared with CGAL " CGAL_VERSION_STR " in exact fractions, 100000 random pairs each",
        {{"intersect_lines, at 6° or more: t and s", compare_parameters},
         {"intersect_lines, at 6° or more: the point [m]", compare_points},
         {"segments_intersect, on whole numbers: other answers", compare_meetings},
         {"common_points, on whole numbers: other numbers of points", compare_numbers_of_common_points},
         {"common_points, on whole numbers: a point [m]", compare_common_points},
         {"time_of_impact: distance from the wall less the radius [m]", compare_impacts},
         {"orientation, nearly parallel: the opposite sign", compare_orientations},
         {"exact numbers of the tests, from 5e-324 to 1e300: other results", compare_exact_numbers}});
}
