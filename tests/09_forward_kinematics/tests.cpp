#include "section_test.hpp"

#include "forward_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using forward_kinematics::Crane;
using forward_kinematics::ElbowAndHand;
using forward_kinematics::Frame;
using forward_kinematics::Handles;
using forward_kinematics::Link;
using forward_kinematics::Pose;
using forward_kinematics::Site;
using namespace forward_kinematics::subject; // two_links, compose, ... over_the_wall: the student's

namespace {

constexpr double pi = std::numbers::pi;
// An answer is right to ten digits of the largest number that goes in, or of 1 if that is larger; fewer will do where
// angles add up to more than 1000 rad. What is answered for axes that are not of length 1 and at a right angle is free.
constexpr double digits = 1e-9;  // of numbers below 10
constexpr double of_one = 1e-10; // where none is larger than 1, or than the answer
constexpr double chained = 1e-7; // where answers go in again, or a test computes with them

constexpr double degrees(double angle) { return angle * pi / 180; } // [rad]

Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vec2 quarter_turned(const Vec2 &v) { return {-v.y(), v.x()}; }

Link link(Dice &dice) { return {dice.real(0.2, 3), dice.real(-4, 4)}; }
std::vector<Link> arm(Dice &dice, int count) {
    std::vector<Link> links;
    while (int(links.size()) < count) links.push_back(link(dice));
    return links;
}

Frame frame(double angle, const Vec2 &origin) { return {at_angle(angle), quarter_turned(at_angle(angle)), origin}; }
Frame frame(Dice &dice) { return frame(dice.real(-pi, pi), dice.point(-5, 5)); }

/// Where each joint is, by complex numbers: a link is multiplied by all turns before it.
std::vector<Vec2> walked(const Vec2 &base, const std::vector<Link> &links) {
    std::vector<Vec2> points{base};
    std::complex<double> at{base.x(), base.y()}, turn{1, 0};
    for (const Link &each : links) {
        turn *= std::polar(1.0, each.angle);
        at += each.length * turn;
        points.emplace_back(at.real(), at.imag());
    }
    return points;
}

/// For each link, the way from its joint to the hand, a quarter turn to the left.
std::vector<Vec2> columns(const std::vector<Link> &links) {
    std::vector<Vec2> all = walked({0, 0}, links);
    const Vec2 hand = all.back();
    all.pop_back();
    for (Vec2 &each : all) each = quarter_turned(hand - each);
    return all;
}

} // namespace

// ------------------------------------------------------------------------------------------------------- 9.1 two_links

//> Worked example: 3 m and 5 m
TEST_CASE("finds the hand of 3 m at 45° and 5 m bent another 90°: at (-1.414, 5.657)", "[9.1]") {
    // 3 / √2 each way; the second link points to 135°, which is -5 / √2 along x and 5 / √2 along y
    const ElbowAndHand want{Vec2{3, 3} / std::sqrt(2), Vec2{-2, 8} / std::sqrt(2)};
    CHECK_THAT(two_links({3, degrees(45)}, {5, degrees(90)}), IsNear(want, digits));
}

//> First link level
TEST_CASE("points the second link at its own angle when the first is level", "[9.1]") {
    CHECK_THAT(two_links({3, 0}, {5, degrees(90)}), IsNear(ElbowAndHand{{3, 0}, {3, 5}}, digits));
    CHECK_THAT(two_links({3, 0}, {5, degrees(30)}),
               IsNear(ElbowAndHand{{3, 0}, {3 + 5 * std::sqrt(0.75), 2.5}}, digits));
}

//> Straight
TEST_CASE("makes one straight line of an arm that isn't bent", "[9.1]") {
    CHECK_THAT(two_links({3, 0}, {5, 0}), IsNear(ElbowAndHand{{3, 0}, {8, 0}}, digits));
    CHECK_THAT(two_links({3, degrees(90)}, {5, 0}), IsNear(ElbowAndHand{{0, 3}, {0, 8}}, digits));
    CHECK_THAT(two_links({5, std::atan2(4, 3)}, {10, 0}), IsNear(ElbowAndHand{{3, 4}, {9, 12}}, digits));
}

//> Folded
TEST_CASE("folds the second link back over the first when it bends half a turn", "[9.1]") {
    CHECK_THAT(two_links({3, 0}, {5, pi}), IsNear(ElbowAndHand{{3, 0}, {-2, 0}}, digits));
    CHECK_THAT(two_links({5, 0}, {5, -pi}), IsNear(ElbowAndHand{{5, 0}, {0, 0}}, digits));
}

//> Level, bent by any angle
TEST_CASE("puts the hand on a circle about the elbow", "[9.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Link first{dice.real(0, 3), 0}, second = link(dice);
        const Vec2 elbow{first.length, 0};
        CHECK_THAT(two_links(first, second),
                   IsNear(ElbowAndHand{elbow, elbow + second.length * at_angle(second.angle)}, digits));
    }
}

//> The opening's arm
TEST_CASE("finds the hand of 3 m at 30° and 2 m bent another 45°: at (3.116, 3.432)", "[9.1]") {
    const double root3 = std::sqrt(3), root2 = std::sqrt(2), root6 = std::sqrt(6); // 75°: (√6 ∓ √2) / 4
    CHECK_THAT(two_links({3, degrees(30)}, {2, degrees(45)}),
               IsNear(ElbowAndHand{{1.5 * root3, 1.5}, {1.5 * root3 + (root6 - root2) / 2, 1.5 + (root6 + root2) / 2}},
                      digits));
}

//> Up, and back
TEST_CASE("levels the second link when the angles cancel (clockwise is negative)", "[9.1]") {
    CHECK_THAT(two_links({3, degrees(90)}, {5, degrees(-90)}), IsNear(ElbowAndHand{{0, 3}, {5, 3}}, digits));
    CHECK_THAT(two_links({3, degrees(-90)}, {5, degrees(90)}), IsNear(ElbowAndHand{{0, -3}, {5, -3}}, digits));
    CHECK_THAT(two_links({3, degrees(30)}, {5, degrees(60)}),
               IsNear(ElbowAndHand{{3 * std::sqrt(0.75), 1.5}, {3 * std::sqrt(0.75), 6.5}}, digits));
}

//> No length
TEST_CASE("lets a link without length bend the arm all the same", "[9.1]") {
    CHECK_THAT(two_links({0, degrees(90)}, {5, degrees(90)}), IsNear(ElbowAndHand{{0, 0}, {-5, 0}}, digits));
    CHECK_THAT(two_links({3, degrees(90)}, {0, 1}), IsNear(ElbowAndHand{{0, 3}, {0, 3}}, digits));
    CHECK_THAT(two_links({0, 1}, {0, 2}), IsNear(ElbowAndHand{{0, 0}, {0, 0}}, digits));
}

//> A triangle
TEST_CASE("keeps each link's length, and the hand's distance obeys the law of cosines", "[9.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Link first = link(dice), second = link(dice);
        const double a = first.length, b = second.length;

        const auto [elbow, hand] = two_links(first, second);

        CHECK_THAT(elbow.norm(), IsNear(a, digits).of("length of the first link [m]"));
        CHECK_THAT((hand - elbow).norm(), IsNear(b, digits).of("length of the second link [m]"));
        CHECK_THAT(hand.squaredNorm(), IsNear(a * a + b * b + 2 * a * b * std::cos(second.angle), chained)
                                           .of("squared distance of the hand from the first joint [m²]"));
        CHECK_THAT(elbow.x() * hand.y() - elbow.y() * hand.x(),
                   IsNear(a * b * std::sin(second.angle), chained).of("determinant of elbow and hand [m²]"));
    }
}

//> By complex numbers
TEST_CASE("agrees with a product of complex numbers", "[9.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Link first = link(dice), second = link(dice);
        const std::vector<Vec2> want = walked({0, 0}, {first, second});
        CHECK_THAT(two_links(first, second), IsNear(ElbowAndHand{want[1], want[2]}, digits));
    }
}

//> Whole turns
TEST_CASE("doesn't care about whole turns more or less", "[9.1]") {
    const int turns = GENERATE(-100, -1, 1, 3);
    const ElbowAndHand want{Vec2{3, 3} / std::sqrt(2), Vec2{-2, 8} / std::sqrt(2)};
    CHECK_THAT(two_links({3, degrees(45) + turns * 2 * pi}, {5, degrees(90)}), IsNear(want, chained));
    CHECK_THAT(two_links({3, degrees(45)}, {5, degrees(90) + turns * 2 * pi}), IsNear(want, chained));
}

//> Erratum E9.1
TEST_CASE("erratum E9.1: gets to the hand by the second link's length and angle, not by the first one's", "[9.1]") {
    const ElbowAndHand got = two_links({3, degrees(45)}, {5, degrees(90)});
    const Vec2 printed = got.elbow + 3 * at_angle(degrees(45)); // "from the elbow, by the first length and angle"
    CHECK_THAT((got.hand - printed).norm(), IsNear(std::sqrt(34), digits).of("hand's distance from the printed [m]"));
}

//> Erratum E9.3
TEST_CASE("erratum E9.3: rounds the hand's height to 5.657 m; the printed 5.656 is cut off", "[9.1]") {
    const double y = two_links({3, degrees(45)}, {5, degrees(90)}).hand.y();
    CHECK_THAT(std::round(1000 * y), IsNear(5657.0).of("y of the hand, in whole millimetres"));
    CHECK_THAT(std::floor(1000 * y), IsNear(5656.0).of("y of the hand, cut off at a millimetre"));
}

//>
TEST_CASE("takes lengths and angles up to 1e5, and tiny ones", "[9.1]") {
    CHECK_THAT(two_links({1e5, 0}, {1e5, pi}), IsNear(ElbowAndHand{{1e5, 0}, {0, 0}}, 1e-5));
    CHECK_THAT(two_links({1e5, degrees(90)}, {1e5, degrees(-90)}).hand, IsNear(Vec2{1e5, 1e5}, of_one).of("hand [m]"));
    const Vec2 far = at_angle(std::fmod(1e5, 2 * pi));
    CHECK_THAT(two_links({1, 1e5}, {1, -1e5}), IsNear(ElbowAndHand{far, far + Vec2{1, 0}}, 1e-5));
    CHECK_THAT(two_links({1, -1e5}, {1, 1e5}).hand, IsNear(Vec2{far.x() + 1, -far.y()}, 1e-5).of("hand [m]"));
    CHECK_THAT(two_links({3e-9, 0}, {5e-9, degrees(90)}).hand, IsNear(Vec2{3e-9, 5e-9}, 2 * of_one).of("hand [m]"));
    CHECK_THAT(two_links({3, 1e-7}, {5, 0}), IsNear(ElbowAndHand{{3, 3e-7}, {8, 8e-7}}, digits));
    CHECK_THAT(two_links({3, 0}, {5, 1e-7}), IsNear(ElbowAndHand{{3, 0}, {8, 5e-7}}, digits));
    CHECK_THAT(two_links({3, 9e-4}, {5, 0}), IsNear(ElbowAndHand{3 * at_angle(9e-4), 8 * at_angle(9e-4)}, digits));
    CHECK_THAT(two_links({3, 0}, {5, 7}), IsNear(ElbowAndHand{{3, 0}, Vec2{3, 0} + 5 * at_angle(7)}, digits));
    CHECK_THAT(two_links({3, -7}, {5, 0}).elbow, IsNear(Vec2{3 * at_angle(-7)}, digits).of("elbow [m]"));
    CHECK_THAT(two_links({0.001, 0}, {0.001, 0}), IsNear(ElbowAndHand{{0.001, 0}, {0.002, 0}}, digits));
    CHECK_THAT(two_links({1, 5e-5}, {1, 0}), IsNear(ElbowAndHand{at_angle(5e-5), 2 * at_angle(5e-5)}, of_one));
    CHECK_THAT(two_links({1, 1e-8}, {1, 0}), IsNear(ElbowAndHand{{1, 1e-8}, {2, 2e-8}}, of_one));
    CHECK_THAT(two_links({5, 3e-9}, {5, 0}), IsNear(ElbowAndHand{{5, 1.5e-8}, {10, 3e-8}}, of_one));
    CHECK_THAT(two_links({5, 9e-10}, {5, 0}), IsNear(ElbowAndHand{{5, 4.5e-9}, {10, 9e-9}}, of_one));
    CHECK_THAT(two_links({9e-10, 0.5}, {0, 0}).elbow, IsNear(Vec2{9e-10 * at_angle(0.5)}, of_one).of("elbow [m]"));
    CHECK_THAT(two_links({20, 0.7}, {30, 0.4}),
               IsNear(ElbowAndHand{20 * at_angle(0.7), 20 * at_angle(0.7) + 30 * at_angle(1.1)}, digits));
    CHECK_THAT(two_links({6e4, 0.7}, {2e4, 0.4}),
               IsNear(ElbowAndHand{6e4 * at_angle(0.7), 6e4 * at_angle(0.7) + 2e4 * at_angle(1.1)}, digits));
    CHECK_THAT(two_links({1e5, 900}, {0, 0}).elbow, IsNear(Vec2{1e5 * at_angle(900)}, digits).of("elbow [m]"));
    CHECK_THAT(two_links({1, 900}, {1, 900}).hand, IsNear(Vec2{at_angle(900) + at_angle(1800)}, 1e-6).of("hand [m]"));
    CHECK_THAT(two_links({1, 6e4}, {1, 6e4}).hand, IsNear(Vec2{at_angle(6e4) + at_angle(12e4)}, 1e-5).of("hand [m]"));
    CHECK_THAT(two_links({3, 0.5}, {5, 0.5}).elbow, IsNear(Vec2{3 * at_angle(0.5)}, digits).of("elbow [m]"));
    CHECK_THAT(two_links({4, 0.5}, {5, 0.5}).elbow, IsNear(Vec2{4 * at_angle(0.5)}, digits).of("elbow [m]"));
}

TEST_CASE("rejects a negative length", "[9.1]") {
    for (const double bad : {-1e-9, -3.0, -1e5}) {
        CHECK_REFUSED(two_links({bad, 1}, {5, 1}), "the first length is negative");
        CHECK_REFUSED(two_links({3, 1}, {bad, 1}), "the second length is negative");
    }
    two_links({3, 0.5}, {5, 1}); // good input is still answered
}

// --------------------------------------------------------------------------------------------------------- 9.2 compose

//> Worked example: a turned and moved frame
TEST_CASE("puts (2, 1) of a leaning torso at (3, 1) where it belongs: at (4, 3)", "[9.2]") {
    // two along (0.8, 0.6), and one along (-0.6, 0.8), from (3, 1): (3 + 1.6 - 0.6, 1 + 1.2 + 0.8)
    CHECK_THAT(compose({{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, {{1, 0}, {0, 1}, {2, 1}}),
               IsNear(Frame{{0.8, 0.6}, {-0.6, 0.8}, {4, 3}}, digits));
}

//> Not turned
TEST_CASE("adds up the origins of frames that aren't turned", "[9.2]") {
    CHECK_THAT(compose({{1, 0}, {0, 1}, {3, 1}}, {{1, 0}, {0, 1}, {2, 5}}),
               IsNear(Frame{{1, 0}, {0, 1}, {5, 6}}, digits));
}

//> Outer frame not turned
TEST_CASE("leaves the inner axes alone when the outer frame is only moved", "[9.2]") {
    CHECK_THAT(compose({{1, 0}, {0, 1}, {3, 1}}, {{0.8, 0.6}, {-0.6, 0.8}, {2, 5}}),
               IsNear(Frame{{0.8, 0.6}, {-0.6, 0.8}, {5, 6}}, digits));
}

//> Only turned
TEST_CASE("makes half a turn of two quarter turns, and a quarter turn clockwise of three", "[9.2]") {
    const Frame quarter{{0, 1}, {-1, 0}, {0, 0}}, half{{-1, 0}, {0, -1}, {0, 0}}, back{{0, -1}, {1, 0}, {0, 0}};
    CHECK_THAT(compose(quarter, quarter), IsNear(half, digits));
    CHECK_THAT(compose(quarter, half), IsNear(back, digits));
    CHECK_THAT(compose(half, quarter), IsNear(back, digits));
}

//> Both turned
TEST_CASE("turns by twice the angle when both frames are turned alike", "[9.2]") {
    const Frame turned{{0.8, 0.6}, {-0.6, 0.8}, {0, 0}};
    CHECK_THAT(compose(turned, turned), IsNear(Frame{{0.28, 0.96}, {-0.96, 0.28}, {0, 0}}, digits)
                                            .since("cos 2a = 0.64 - 0.36 and sin 2a = 2 · 0.8 · 0.6"));
}

//> Order
TEST_CASE("sees a difference between turning first and moving first", "[9.2]") {
    const Frame quarter{{0, 1}, {-1, 0}, {0, 0}}, moved{{1, 0}, {0, 1}, {5, 0}};
    CHECK_THAT(compose(quarter, moved), IsNear(Frame{{0, 1}, {-1, 0}, {0, 5}}, digits));
    CHECK_THAT(compose(moved, quarter), IsNear(Frame{{0, 1}, {-1, 0}, {5, 0}}, digits));
}

//> The world's own frame
TEST_CASE("changes nothing when either frame is the world's own", "[9.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(200); ++i) {
        const Frame any = frame(dice);
        CHECK_THAT(compose(Frame{}, any), IsNear(any, digits));
        CHECK_THAT(compose(any, Frame{}), IsNear(any, digits));
    }
}

//> And back
TEST_CASE("gets the world's own frame from a frame and what undoes it", "[9.2]") {
    CHECK_THAT(compose({{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, {{0.8, -0.6}, {0.6, 0.8}, {-3, 1}}),
               IsNear(Frame{}, digits).since("-3 · 0.8 - 1 · 0.6 + 3 = 0 and -3 · 0.6 + 1 · 0.8 + 1 = 0"));
    CHECK_THAT(compose({{0.8, -0.6}, {0.6, 0.8}, {-3, 1}}, {{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}), IsNear(Frame{}, digits));
}

//> Angles add up
TEST_CASE("adds up the angles, and turns the inner origin by the outer angle", "[9.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double outer = dice.real(-pi, pi), inner = dice.real(-pi, pi), towards = dice.real(-pi, pi);
        const double far = dice.real(0, 5);
        const Vec2 at = dice.point(-5, 5);
        CHECK_THAT(compose(frame(outer, at), frame(inner, far * at_angle(towards))),
                   IsNear(frame(outer + inner, at + far * at_angle(outer + towards)), digits));
    }
}

//> Three frames
TEST_CASE("gets the same from three frames, whichever two come together first", "[9.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Frame a = frame(dice), b = frame(dice), c = frame(dice);
        const Frame left = compose(compose(a, b), c), right = compose(a, compose(b, c));
        CHECK_THAT(Vec2{left.origin - right.origin}, IsNear(Vec2{0, 0}, chained).of("difference of the origins [m]"));
        CHECK_THAT(Vec2{left.x_axis - right.x_axis}, IsNear(Vec2{0, 0}, chained).of("difference of the x axes [1]"));
        CHECK_THAT(Vec2{left.y_axis - right.y_axis}, IsNear(Vec2{0, 0}, chained).of("difference of the y axes [1]"));
    }
}

//> An arm of frames
TEST_CASE("turns 45°, goes 3 m, turns 90°, goes 5 m, and ends at (-1.414, 5.657)", "[9.2]") {
    Frame hand = frame(degrees(45), {0, 0});
    hand = compose(hand, frame(0, {3, 0}));
    hand = compose(hand, frame(degrees(90), {0, 0}));
    hand = compose(hand, frame(0, {5, 0}));
    CHECK_THAT(hand.origin, IsNear(Vec2{Vec2{-2, 8} / std::sqrt(2)}, chained).of("origin of the hand's frame [m]"));
    CHECK_THAT(hand.x_axis, IsNear(Vec2{Vec2{-1, 1} / std::sqrt(2)}, chained).of("x axis of the hand's frame [1]"));
}

//> Around the clock
TEST_CASE("walks once around the clock, 1 m and 30° an hour, back to the start", "[9.2]") {
    Frame walker;
    for (int hour = 0; hour < 12; ++hour) walker = compose(walker, frame(degrees(30), {1, 0}));
    CHECK_THAT(walker.origin, IsNear(Vec2{0, 0}, chained).of("where the way ends [m]"));
    CHECK_THAT(walker.x_axis, IsNear(Vec2{1, 0}, chained).of("x axis in the end [1]"));
}

//>
TEST_CASE("takes origins up to 1e5, and tiny turns", "[9.2]") {
    CHECK_THAT(compose({{1, 0}, {0, 1}, {1e5, -1e5}}, {{1, 0}, {0, 1}, {1e5, -1e5}}).origin,
               IsNear(Vec2{2e5, -2e5}, of_one).of("origin [m]")); // larger than what goes in
    CHECK_THAT(compose({{0, 1}, {-1, 0}, {-1e5, 0}}, {{1, 0}, {0, 1}, {1e5, 1e5}}).origin,
               IsNear(Vec2{-2e5, 1e5}, of_one).of("origin [m]"));
    CHECK_THAT(compose({{1, 0}, {0, 1}, {3e-9, 0}}, {{0.8, 0.6}, {-0.6, 0.8}, {0, 5e-9}}).origin,
               IsNear(Vec2{3e-9, 5e-9}, of_one).of("origin [m]"));
    CHECK_THAT(compose(frame(1e-7, {0, 0}), frame(0, {1, 0})).origin, IsNear(Vec2{1, 1e-7}, digits).of("origin [m]"));
    CHECK_THAT(compose(frame(0, {0, 0}), frame(1e-7, {0, 0})).x_axis, IsNear(Vec2{1, 1e-7}, digits).of("x axis [1]"));
    CHECK_THAT(compose(frame(1e-7, {0, 0}), frame(-1e-7, {0, 0})), IsNear(Frame{}, digits));
    CHECK_THAT(compose({{-1, 0}, {0, -1}, {0, 0}}, {{-1, 0}, {0, -1}, {1, 2}}),
               IsNear(Frame{{1, 0}, {0, 1}, {-1, -2}}, digits));
    CHECK_THAT(compose({{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, {{1, 0}, {0, 1}, {0, 0}}),
               IsNear(Frame{{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, digits));
    CHECK_THAT(compose(Frame{}, frame(0, {-1e5, 0})).origin, IsNear(Vec2{-1e5, 0}, of_one).of("origin [m]"));
    CHECK_THAT(compose(frame(0.7, {1e5, -4e4}), frame(0.4, {3e4, 7e4})).origin,
               IsNear(Vec2{Vec2{1e5, -4e4} + 3e4 * at_angle(0.7) + 7e4 * quarter_turned(at_angle(0.7))}, digits)
                   .of("origin [m]"));
    CHECK_THAT(compose(frame(5e-9, {0, 0}), Frame{}), IsNear(Frame{{1, 5e-9}, {-5e-9, 1}, {0, 0}}, of_one));
    CHECK_THAT(compose(frame(9e-10, {9e-10, 0}), Frame{}), IsNear(Frame{{1, 9e-10}, {-9e-10, 1}, {9e-10, 0}}, of_one));
    CHECK_THAT(compose(frame(-5, {0, 0}), frame(5, {0, 0})), IsNear(Frame{}, digits));
    const Frame rounded{at_angle(0.7), at_angle(0.7 + pi / 2), {0, 0}}; // the axes' dot product is not quite 0
    CHECK_THAT(compose(rounded, Frame{}), IsNear(frame(0.7, {0, 0}), digits));
    CHECK_THAT(compose(frame(0.5, {1, 2}), frame(0.5, {3, 0})),
               IsNear(frame(1, Vec2{1, 2} + 3 * at_angle(0.5)), digits));
    CHECK_THAT(compose(frame(0.5, {5, 2}), frame(0.5, {3, 0})),
               IsNear(frame(1, Vec2{5, 2} + 3 * at_angle(0.5)), digits));
    CHECK_THAT(compose(frame(-0.5, {5, 2}), frame(0.5, {3, 0})),
               IsNear(frame(0, Vec2{5, 2} + 3 * at_angle(-0.5)), digits));
}

// ---------------------------------------------------------------------------------------------------------- 9.3 joints

//> Worked example: three links at 30° each
TEST_CASE("bends three links of 2 m by 30° each, and the last one points straight up", "[9.3]") {
    const double wide = std::sqrt(3); // 2 m at 30° is (√3, 1), 2 m at 60° is (1, √3), 2 m at 90° is (0, 2)
    CHECK_THAT(joints({1, 0}, {{2, degrees(30)}, {2, degrees(30)}, {2, degrees(30)}}),
               IsNear(std::vector<Vec2>{{1, 0}, {1 + wide, 1}, {2 + wide, 1 + wide}, {2 + wide, 3 + wide}}, digits));
}

//> No link
TEST_CASE("returns just the base when there's no link", "[9.3]") {
    CHECK_THAT(joints({3, -2}, {}), IsNear(std::vector<Vec2>{{3, -2}}, digits));
}

//> One link
TEST_CASE("goes from the base to the end of its only link", "[9.3]") {
    CHECK_THAT(joints({0, 0}, {{5, std::atan2(4, 3)}}), IsNear(std::vector<Vec2>{{0, 0}, {3, 4}}, digits));
    CHECK_THAT(joints({1, 2}, {{5, degrees(-90)}}), IsNear(std::vector<Vec2>{{1, 2}, {1, -3}}, digits));
}

//> Two links again
TEST_CASE("ends where `two_links` ends, for 3 m and 5 m at 45° and 90°", "[9.3]") {
    CHECK_THAT(joints({0, 0}, {{3, degrees(45)}, {5, degrees(90)}}),
               IsNear(std::vector<Vec2>{{0, 0}, Vec2{3, 3} / std::sqrt(2), Vec2{-2, 8} / std::sqrt(2)}, digits));
}

//> Two links, elsewhere
TEST_CASE("moves every joint by as much as the base", "[9.3]") {
    CHECK_THAT(joints({4, -1}, {{3, degrees(90)}, {5, degrees(-90)}}),
               IsNear(std::vector<Vec2>{{4, -1}, {4, 2}, {9, 2}}, digits));
}

//> Straight line
TEST_CASE("lays links that aren't bent on a straight line", "[9.3]") {
    CHECK_THAT(joints({0, 1}, {{1, 0}, {2, 0}, {3, 0}, {4, 0}}),
               IsNear(std::vector<Vec2>{{0, 1}, {1, 1}, {3, 1}, {6, 1}, {10, 1}}, digits));
    CHECK_THAT(joints({0, 1}, {{1, degrees(90)}, {2, 0}, {3, 0}}),
               IsNear(std::vector<Vec2>{{0, 1}, {0, 2}, {0, 4}, {0, 7}}, digits));
}

//> A square
TEST_CASE("closes a square with four links of 2 m and three bends of 90°", "[9.3]") {
    CHECK_THAT(joints({1, 1}, {{2, 0}, {2, degrees(90)}, {2, degrees(90)}, {2, degrees(90)}}),
               IsNear(std::vector<Vec2>{{1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}}, digits));
}

//> A staircase
TEST_CASE("climbs a staircase when the bends alternate", "[9.3]") {
    CHECK_THAT(joints({0, 0}, {{1, 0}, {2, degrees(90)}, {1, degrees(-90)}, {2, degrees(90)}}),
               IsNear(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 4}}, digits));
}

//> A joint without a link
TEST_CASE("stays where it is for a link without length, and still bends", "[9.3]") {
    CHECK_THAT(joints({0, 0}, {{0, degrees(90)}, {0, degrees(45)}, {0, degrees(45)}, {3, 0}}),
               IsNear(std::vector<Vec2>{{0, 0}, {0, 0}, {0, 0}, {0, 0}, {-3, 0}}, digits));
}

//> Lengths and bends
TEST_CASE("keeps each length and each bend, for up to twelve links", "[9.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const std::vector<Link> links = arm(dice, dice.whole(1, 12));

        const std::vector<Vec2> got = joints(dice.point(-5, 5), links);

        CHECK_THAT(got, HasSize(links.size() + 1).of("joints and hand"));
        Vec2 before{1, 0}; // the x axis, from which the first link is turned
        for (std::size_t k = 0; k < links.size(); ++k) {
            const Vec2 along = got[k + 1] - got[k];
            CHECK_THAT(along.norm(), IsNear(links[k].length, 2 * digits).of("length of a link [m]"));
            CHECK_THAT(before.dot(along) / before.norm() / along.norm(),
                       IsNear(std::cos(links[k].angle), chained).of("cosine of a bend"));
            CHECK_THAT((before.x() * along.y() - before.y() * along.x()) / before.norm() / along.norm(),
                       IsNear(std::sin(links[k].angle), chained).of("sine of a bend"));
            before = along;
        }
    }
}

//> Walked
TEST_CASE("agrees with products of complex numbers, link by link", "[9.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 base = dice.point(-5, 5);
        const std::vector<Link> links = arm(dice, dice.whole(0, 12));
        CHECK_THAT(joints(base, links), IsNear(walked(base, links), digits));
    }
}

//> A shorter arm
TEST_CASE("finds the same joints for an arm that ends sooner", "[9.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        std::vector<Link> links = arm(dice, 5);
        const std::vector<Vec2> want = joints({1, 2}, links);
        CHECK_THAT(want, HasSize(6).of("joints of the whole arm"));
        links.pop_back(), links.pop_back();
        const std::vector<Vec2> got = joints({1, 2}, links);
        CHECK_THAT(got, HasSize(4).of("joints of the shorter arm"));
        for (int k = 0; k < 4; ++k)
            CHECK_THAT(Vec2{got[k] - want[k]}, IsNear(Vec2{0, 0}, digits).of("difference of a joint [m]"));
    }
}

//> A polygon of a hundred links
TEST_CASE("closes a polygon with a hundred links, each bent a hundredth of a turn", "[9.3]") {
    const std::vector<Link> links(100, Link{1, 2 * pi / 100});
    const std::vector<Vec2> got = joints({5, 5}, links);
    CHECK_THAT(got, HasSize(101).of("joints and hand"));
    CHECK_THAT(got[100], IsNear(Vec2{5, 5}, 1e-9).of("the hand [m]"));
    CHECK_THAT((got[50] - got[0]).norm(), IsNear(1 / std::sin(pi / 100), 1e-9).of("the polygon's width [m]"));
}

//> Erratum E9.2
TEST_CASE("erratum E9.2: doesn't turn the base; as printed, one at (10, 0) puts the hand at (-8.485, 12.728)",
          "[9.3]") {
    const std::vector<Vec2> got = joints({10, 0}, {{3, degrees(45)}, {5, degrees(90)}});
    CHECK_THAT(got.back(), IsNear(Vec2{10 - std::sqrt(2), 4 * std::sqrt(2)}, digits).of("the hand [m]"));
    // all turns together are 135°: the printed product turns the base by as much
    const Vec2 printed = got.back() - Vec2{10, 0} + 10 * at_angle(degrees(135));
    CHECK_THAT(printed, IsNear(Vec2{-6 * std::sqrt(2), 9 * std::sqrt(2)}, digits).of("the hand, as printed [m]"));
}

//>
static Vec2 hand_of(const Vec2 &base, const std::vector<Link> &links) {
    const std::vector<Vec2> all = joints(base, links);
    CHECK_THAT(all, HasSize(links.size() + 1).of("joints and hand"));
    return all.back();
}

TEST_CASE("takes a base and links up to 1e5, tiny ones, and many turns", "[9.3]") {
    CHECK_THAT(joints({-1e5, -1e5}, {{1e5, 0}, {1e5, 0}, {0, 0}, {1e5, degrees(90)}}),
               IsNear(std::vector<Vec2>{{-1e5, -1e5}, {0, -1e5}, {1e5, -1e5}, {1e5, -1e5}, {1e5, 0}}, 1e-5));
    const Vec2 far = at_angle(std::fmod(1e5, 2 * pi));
    CHECK_THAT(hand_of({0, 0}, {{1, 1e5}, {1, -1e5}}), IsNear(Vec2{far + Vec2{1, 0}}, 1e-5).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1, -1e5}}), IsNear(Vec2{far.x(), -far.y()}, 1e-5).of("the hand [m]"));
    CHECK_THAT(hand_of({1e-9, 2e-9}, {{3e-9, 0}, {5e-9, degrees(90)}}),
               IsNear(Vec2{4e-9, 7e-9}, 2 * of_one).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1, 1e-7}, {1, 1e-7}, {1, 1e-7}}), IsNear(Vec2{3, 6e-7}, digits).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1, 3}, {1, 3}, {1, 3}}),
               IsNear(Vec2{at_angle(3) + at_angle(6) + at_angle(9)}, digits).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, std::vector<Link>(2000, Link{0.5, 0})),
               IsNear(Vec2{1000, 0}, digits).of("the hand [m]"));
    CHECK_THAT(joints({0, 0}, {{2, 1}}), IsNear(std::vector<Vec2>{{0, 0}, 2 * at_angle(1)}, digits)); // shorter again
    CHECK_THAT(joints({7, 7}, {}), IsNear(std::vector<Vec2>{{7, 7}}, digits));
    CHECK_THAT(joints({0, 0}, {{1, 0}, {0, 1}}), IsNear(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 0}}, digits));
    const std::vector<Link> far_apart{{7e4, 2.1}, {5e4, 0.9}};
    CHECK_THAT(joints({8e4, 3e4}, far_apart), IsNear(walked({8e4, 3e4}, far_apart), digits));
    const std::vector<Link> middling{{30, 2.1}, {20, 0.9}};
    CHECK_THAT(joints({20, 30}, middling), IsNear(walked({20, 30}, middling), digits));
    std::vector<Link> many(300, Link{1, 0.01});
    CHECK_THAT(hand_of({0, 0}, many), IsNear(walked({0, 0}, many).back(), digits).of("the hand [m]"));
    many[270].angle = 1;
    CHECK_THAT(hand_of({0, 0}, many), IsNear(walked({0, 0}, many).back(), digits).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1, -10}}), IsNear(at_angle(-10), digits).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1e5, 900}}), IsNear(Vec2{1e5 * at_angle(900)}, digits).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1, 9e-10}}), IsNear(Vec2{1, 9e-10}, of_one).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{9e-10, 0}}), IsNear(Vec2{9e-10, 0}, of_one).of("the hand [m]"));
    CHECK_THAT(hand_of({0, 0}, {{1, 0.5}}), IsNear(at_angle(0.5), digits).of("the hand [m]"));
    CHECK_THAT(hand_of({7, 0}, {{1, 0.5}}), IsNear(Vec2{Vec2{7, 0} + at_angle(0.5)}, digits).of("the hand [m]"));
    CHECK_THAT(hand_of({7, 0}, {{2, 0.5}}), IsNear(Vec2{Vec2{7, 0} + 2 * at_angle(0.5)}, digits).of("the hand [m]"));
}

TEST_CASE("rejects any negative length among the links", "[9.3]") {
    for (const double bad : {-1e-9, -3.0, -1e5}) {
        CHECK_REFUSED(joints({0, 0}, {{bad, 1}, {5, 1}, {4, 1}}), "the first length is negative");
        CHECK_REFUSED(joints({0, 0}, {{3, 1}, {bad, 1}, {4, 1}}), "the second length is negative");
        CHECK_REFUSED(joints({0, 0}, {{3, 1}, {5, 1}, {bad, 1}}), "the last length is negative");
    }
    joints({0, 0}, {{3, 0.5}, {5, 1}}); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 9.4 next_frame

namespace {

constexpr double frame_time = 1.0 / 60; // [s]

/// The end of the bucket: boom 3.2 m, stick 2.4 m, bucket 0.7 m, from 1.2 m above the ground.
Vec2 teeth_of(const Site &site) {
    return walked({site.place, 1.2}, {{3.2, site.boom}, {2.4, site.stick}, {0.7, site.bucket}}).back();
}
Site site(Dice &dice) {
    return {dice.real(-5, 5), dice.real(-1, 2), dice.real(-2, 1), dice.real(-2, 2), dice.point(-9, 9), false};
}
Handles handles(Dice &dice, bool closed) {
    return {dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1), dice.real(-1, 1), closed};
}

} // namespace

//> Worked example: a second of driving
TEST_CASE("drives 2 m and turns the boom 0.8 rad in a second, and lets the stone come down", "[9.4]") {
    const Site start{1, 0.5, -0.5, 0.25, {20, 9}, false};
    CHECK_THAT(next_frame(start, {1, 1, 0, 0, false}, 1), IsNear(Site{3, 1.3, -0.5, 0.25, {20, 5}, false}, digits));
}

//> Each handle
TEST_CASE("turns each joint by its own handle, both ways", "[9.4]") {
    const Site start{0, 0, 0, 0, {20, 0}, false};
    CHECK_THAT(next_frame(start, {0, 0, -1, 0, false}, 0.5), IsNear(Site{0, 0, -0.4, 0, {20, 0}, false}, digits));
    CHECK_THAT(next_frame(start, {0, 0, 0, 0.5, false}, 0.5), IsNear(Site{0, 0, 0, 0.2, {20, 0}, false}, digits));
    CHECK_THAT(next_frame(start, {-0.5, 0, 0, 0, false}, 0.25), IsNear(Site{-0.25, 0, 0, 0, {20, 0}, false}, digits));
}

//> Nobody at the handles
TEST_CASE("changes nothing when nobody touches a handle and the stone lies on the ground", "[9.4]") {
    const Site start{1, 0.5, -0.5, 0.25, {20, 0}, false};
    CHECK_THAT(next_frame(start, {}, frame_time), IsNear(start, digits));
    CHECK_THAT(next_frame(start, {1, 1, 1, 1, true}, 0), IsNear(start, digits));
}

//> Grab
TEST_CASE("grabs a stone within 0.3 m of the teeth, and not one farther away", "[9.4]") {
    const Vec2 teeth{6.3, 1.2}; // a straight arm, level: 3.2 + 2.4 + 0.7
    CHECK_THAT(next_frame({0, 0, 0, 0, {6.3, 1.49}, false}, {0, 0, 0, 0, true}, 0),
               IsNear(Site{0, 0, 0, 0, teeth, true}, digits));
    CHECK_THAT(next_frame({0, 0, 0, 0, {6.3, 1.51}, false}, {0, 0, 0, 0, true}, 0),
               IsNear(Site{0, 0, 0, 0, {6.3, 1.51}, false}, digits));
    CHECK_THAT(next_frame({0, 0, 0, 0, {6.1, 1.0}, false}, {0, 0, 0, 0, true}, 0),
               IsNear(Site{0, 0, 0, 0, teeth, true}, digits));
    CHECK_THAT(next_frame({0, 0, 0, 0, {6.05, 1.0}, false}, {0, 0, 0, 0, true}, 0).held, IsNear(false).of("held"));
}

//> Open, it grabs nothing
TEST_CASE("doesn't grab with an open bucket", "[9.4]") {
    CHECK_THAT(next_frame({0, 0, 0, 0, {6.3, 1.2}, false}, {}, 0), IsNear(Site{0, 0, 0, 0, {6.3, 1.2}, false}, digits));
}

//> Move first, then grab
TEST_CASE("looks for the stone where the teeth are after the move", "[9.4]") {
    // the teeth drive from x = 6.3 to 7.3, where the stone is
    CHECK_THAT(next_frame({0, 0, 0, 0, {7.3, 1.2}, false}, {1, 0, 0, 0, true}, 0.5),
               IsNear(Site{1, 0, 0, 0, {7.3, 1.2}, true}, digits));
    // and away from one that was within reach
    CHECK_THAT(next_frame({0, 0, 0, 0, {6.3, 0}, false}, {-1, 0, 0, 0, true}, 0.5).held, IsNear(false).of("held"));
}

//> Carried
TEST_CASE("carries the stone at the teeth, however they move", "[9.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        Site now = site(dice);
        now.stone = teeth_of(now);
        now.held = true;
        const Site then = next_frame(now, handles(dice, true), dice.real(0, 1));
        CHECK_THAT(then.held, IsNear(true).of("held"));
        CHECK_THAT(then.stone, IsNear(teeth_of(then), chained).of("stone [m]"));
    }
}

//> Let go
TEST_CASE("lets go when the bucket opens; the stone comes down at 4 m/s and lies on the ground", "[9.4]") {
    Site now{0, 0, 0, 0, {6.3, 1.2}, true};
    now = next_frame(now, {}, 0.1);
    CHECK_THAT(now, IsNear(Site{0, 0, 0, 0, {6.3, 0.8}, false}, digits));
    now = next_frame(now, {}, 0.1);
    CHECK_THAT(now.stone, IsNear(Vec2{6.3, 0.4}, chained).of("stone [m]"));
    now = next_frame(now, {}, 0.9);
    CHECK_THAT(now.stone, IsNear(Vec2{6.3, 0}, chained).of("stone [m]"));
}

//> Anywhere
TEST_CASE("leaves a stone out of reach to itself, wherever the digger goes", "[9.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        Site now = site(dice);
        now.stone = {30, dice.real(0, 9)};
        const double dt = dice.real(0, 1);
        const Site then = next_frame(now, handles(dice, i % 2 == 0), dt);
        CHECK_THAT(then.held, IsNear(false).of("held"));
        CHECK_THAT(then.stone, IsNear(Vec2{30, std::max(0.0, now.stone.y() - 4 * dt)}, chained).of("stone [m]"));
    }
}

//> Half as long
TEST_CASE("gets to the same place in two half frames", "[9.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        Site now = site(dice);
        now.stone = {30, 9};
        const Handles pushed = handles(dice, false);
        const double dt = dice.real(0, 1);
        const Site halves = next_frame(next_frame(now, pushed, dt / 2), pushed, dt / 2),
                   whole = next_frame(now, pushed, dt);
        CHECK_THAT(halves.place - whole.place, IsNear(0.0, chained).of("difference of the places [m]"));
        CHECK_THAT(halves.boom - whole.boom, IsNear(0.0, chained).of("difference of the booms [rad]"));
        CHECK_THAT(halves.stick - whole.stick, IsNear(0.0, chained).of("difference of the sticks [rad]"));
        CHECK_THAT(halves.bucket - whole.bucket, IsNear(0.0, chained).of("difference of the buckets [rad]"));
    }
}

//> A whole job
TEST_CASE("picks up a stone, drives off with it and puts it down 2 m farther on", "[9.4]") {
    Site now{0, 0, 0, 0, {6.3, 1.3}, false};
    for (int frame = 0; frame < 60; ++frame) now = next_frame(now, {1, 0, 0, 0, true}, frame_time);
    CHECK_THAT(now.stone, IsNear(Vec2{8.3, 1.2}, chained).of("stone, after a second [m]"));
    for (int frame = 0; frame < 60; ++frame) now = next_frame(now, {}, frame_time);
    CHECK_THAT(now.stone, IsNear(Vec2{8.3, 0}, chained).of("stone, after another one [m]"));
}

//>
TEST_CASE("rejects a handle beyond ±1, and a dt that isn't from 0 to 1", "[9.4]") {
    const Site start{1, 0.5, -0.5, 0.25, {20, 9}, false};
    for (const double bad : {1.0001, -1.0001, 50.0}) {
        CHECK_REFUSED(next_frame(start, {bad, 0, 0, 0, false}, 0.1), "the first handle is beyond ±1");
        CHECK_REFUSED(next_frame(start, {0, bad, 0, 0, false}, 0.1), "the second handle is beyond ±1");
        CHECK_REFUSED(next_frame(start, {0, 0, bad, 0, false}, 0.1), "the third handle is beyond ±1");
        CHECK_REFUSED(next_frame(start, {0, 0, 0, bad, false}, 0.1), "the fourth handle is beyond ±1");
    }
    for (const double bad : {-1e-9, 1.0001}) CHECK_REFUSED(next_frame(start, {}, bad), "dt is not from 0 to 1");
    next_frame(start, {1, -1, 1, -1, true}, 1); // good input is still answered
}

// -------------------------------------------------------------------------------------------------------- 9.5 jacobian

//> Worked example: the hand's two velocities
TEST_CASE("moves the hand of 3 m at 45° and 5 m at 90° by (-5.657, -1.414) and (-3.536, -3.536)", "[9.5]") {
    // from the first joint the hand is at (-1.414, 5.657), from the second at (-3.536, 3.536): a quarter turn to the left
    CHECK_THAT(jacobian({{3, degrees(45)}, {5, degrees(90)}}),
               IsNear(std::vector<Vec2>{Vec2{-8, -2} / std::sqrt(2), Vec2{-5, -5} / std::sqrt(2)}, digits));
}

//> One link turns
TEST_CASE("sends the hand of one 5 m link off at a right angle, at 5 m/s", "[9.5]") {
    CHECK_THAT(jacobian({{5, 0}}), IsNear(std::vector<Vec2>{{0, 5}}, digits));
    CHECK_THAT(jacobian({{5, degrees(90)}}), IsNear(std::vector<Vec2>{{-5, 0}}, digits));
    CHECK_THAT(jacobian({{5, std::atan2(4, 3)}}), IsNear(std::vector<Vec2>{{-4, 3}}, digits));
}

//> No link turns
TEST_CASE("returns an empty list when there's no link", "[9.5]") {
    CHECK_THAT(jacobian({}), IsNear(std::vector<Vec2>{}, digits));
}

//> A straight arm
TEST_CASE("moves the hand of a straight arm in one direction only", "[9.5]") {
    CHECK_THAT(jacobian({{3, 0}, {5, 0}}), IsNear(std::vector<Vec2>{{0, 8}, {0, 5}}, digits));
    CHECK_THAT(jacobian({{1, degrees(90)}, {2, 0}, {3, 0}}),
               IsNear(std::vector<Vec2>{{-6, 0}, {-5, 0}, {-3, 0}}, digits));
}

//> A folded arm
TEST_CASE("can't move a hand that's folded onto the first joint by turning it", "[9.5]") {
    CHECK_THAT(jacobian({{3, 0}, {3, pi}}), IsNear(std::vector<Vec2>{{0, 0}, {0, -3}}, digits));
}

//> Three links
TEST_CASE("lifts the hand of an arch straight up by its first angle", "[9.5]") {
    // up 2 m, right 3 m, down 2 m: from the three joints the hand is at (3, 0), (3, -2) and (0, -2)
    CHECK_THAT(jacobian({{2, degrees(90)}, {3, degrees(-90)}, {2, degrees(-90)}}),
               IsNear(std::vector<Vec2>{{0, 3}, {2, 3}, {2, 0}}, digits));
}

//> Area
TEST_CASE("has both lengths times the sine of the second angle as its determinant", "[9.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Link first = link(dice), second = link(dice);
        const std::vector<Vec2> got = jacobian({first, second});
        CHECK_THAT(got, HasSize(2).of("columns"));
        CHECK_THAT(got[0].x() * got[1].y() - got[0].y() * got[1].x(),
                   IsNear(first.length * second.length * std::sin(second.angle), chained).of("determinant [m²]"));
    }
}

//> A small turn
TEST_CASE("agrees with a small turn of each joint, divided by that turn", "[9.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const std::vector<Link> links = arm(dice, dice.whole(1, 8));
        const std::vector<Vec2> got = jacobian(links);
        CHECK_THAT(got, HasSize(links.size()).of("columns"));
        for (std::size_t k = 0; k < links.size(); ++k) {
            std::vector<Link> more = links, less = links;
            more[k].angle += 1e-4, less[k].angle -= 1e-4;
            const Vec2 want = (walked({0, 0}, more).back() - walked({0, 0}, less).back()) / 2e-4;
            CHECK_THAT(Vec2{got[k] - want}, IsNear(Vec2{0, 0}, 1e-6).of("difference from a small turn [m/rad]"));
        }
    }
}

//> As far as the hand
TEST_CASE("makes each column as long as the arrow to the hand, and at a right angle to it", "[9.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const std::vector<Link> links = arm(dice, dice.whole(1, 8));
        const std::vector<Vec2> at = walked({0, 0}, links), got = jacobian(links);
        CHECK_THAT(got, HasSize(links.size()).of("columns"));
        for (std::size_t k = 0; k < links.size(); ++k) {
            const Vec2 way = at.back() - at[k];
            CHECK_THAT(got[k].dot(way), IsNear(0.0, chained).of("dot product of a column and its way [m²]"));
            CHECK_THAT(way.x() * got[k].y() - way.y() * got[k].x(),
                       IsNear(way.squaredNorm(), chained).of("determinant of a way and its column [m²]"));
        }
    }
}

//> All together
TEST_CASE("turns all columns along when the whole arm turns", "[9.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        std::vector<Link> links = arm(dice, 4);
        const std::vector<Vec2> before = jacobian(links);
        const double by = dice.real(-pi, pi);
        links[0].angle += by;
        const std::vector<Vec2> after = jacobian(links);
        CHECK_THAT(after, HasSize(4).of("columns"));
        for (int k = 0; k < 4; ++k)
            CHECK_THAT(Vec2{after[k] - before[k].x() * at_angle(by) - before[k].y() * quarter_turned(at_angle(by))},
                       IsNear(Vec2{0, 0}, chained).of("difference from the turned column [m/rad]"));
    }
}

//>
TEST_CASE("takes links up to 1e5 m, tiny ones, none, and many turns", "[9.5]") {
    CHECK_THAT(jacobian({{1e5, 0}, {1e5, degrees(90)}}), IsNear(std::vector<Vec2>{{-1e5, 1e5}, {-1e5, 0}}, of_one));
    CHECK_THAT(jacobian({{3e-9, 0}, {5e-9, degrees(90)}}),
               IsNear(std::vector<Vec2>{{-5e-9, 3e-9}, {-5e-9, 0}}, 2 * of_one));
    CHECK_THAT(jacobian({{0, 1}, {5, -1}, {0, 2}}), IsNear(std::vector<Vec2>{{0, 5}, {0, 5}, {0, 0}}, digits));
    CHECK_THAT(jacobian({{3, degrees(45) + 20 * pi}, {5, degrees(90) - 40 * pi}}),
               IsNear(std::vector<Vec2>{Vec2{-8, -2} / std::sqrt(2), Vec2{-5, -5} / std::sqrt(2)}, chained));
    const Vec2 far = at_angle(std::fmod(1e5, 2 * pi));
    CHECK_THAT(jacobian({{1, 1e5}, {1, -1e5}}), IsNear(std::vector<Vec2>{{-far.y(), 1 + far.x()}, {0, 1}}, 1e-5));
    CHECK_THAT(jacobian({{1, -1e5}}), IsNear(std::vector<Vec2>{{far.y(), far.x()}}, 1e-5));
    CHECK_THAT(jacobian({{3, 1e-7}, {5, 0}}), IsNear(std::vector<Vec2>{{-8e-7, 8}, {-5e-7, 5}}, digits));
    const std::vector<Vec2> many = jacobian(std::vector<Link>(500, Link{0.5, 0}));
    CHECK_THAT(many, HasSize(500).of("columns"));
    CHECK_THAT(many.front(), IsNear(Vec2{0, 250}, digits).of("the first column [m/rad]"));
    CHECK_THAT(jacobian({{2, 0}}), IsNear(std::vector<Vec2>{{0, 2}}, digits)); // shorter again
    CHECK_THAT(jacobian({{1, 0}, {0, degrees(90)}, {1, 0}}),
               IsNear(std::vector<Vec2>{{-1, 1}, {-1, 0}, {-1, 0}}, digits)); // no length in the middle
    CHECK_THAT(jacobian({{1, 9e-10}}), IsNear(std::vector<Vec2>{{-9e-10, 1}}, of_one));
    for (const int count : {15, 30, 1001}) {
        const std::vector<Link> links(count, Link{0.5, 0.01});
        CHECK_THAT(jacobian(links), IsNear(columns(links), digits));
    }
    for (const double size : {10.0, 1e4}) {
        const std::vector<Link> links{{7 * size, 2.1}, {2 * size, 0.9}};
        CHECK_THAT(jacobian(links), IsNear(columns(links), digits));
    }
}

TEST_CASE("rejects any negative length in a moving arm", "[9.5]") {
    for (const double bad : {-1e-9, -3.0, -1e5}) {
        CHECK_REFUSED(jacobian({{bad, 1}, {5, 1}, {4, 1}}), "the first length is negative");
        CHECK_REFUSED(jacobian({{3, 1}, {bad, 1}, {4, 1}}), "the second length is negative");
        CHECK_REFUSED(jacobian({{3, 1}, {5, 1}, {bad, 1}}), "the last length is negative");
    }
    jacobian({{3, 0.5}, {5, 1}}); // good input is still answered
}

// -------------------------------------------------------------------------------------------------------- 9.6 to_local

//> Worked example: a point in the hand's frame
TEST_CASE("sees (4, 3) of the world at (2, 1), from a leaning torso at (3, 1)", "[9.6]") {
    // the way to it is (1, 2): 1 · 0.8 + 2 · 0.6 along x, and 1 · -0.6 + 2 · 0.8 along y
    CHECK_THAT(to_local({{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, {4, 3}), IsNear(Vec2{2, 1}, digits));
}

//> Turned, not moved
TEST_CASE("takes dot products with the axes when the frame is only turned", "[9.6]") {
    CHECK_THAT(to_local({{0, 1}, {-1, 0}, {0, 0}}, {3, 5}), IsNear(Vec2{5, -3}, digits));
    CHECK_THAT(to_local({{0.8, 0.6}, {-0.6, 0.8}, {0, 0}}, {1, 2}), IsNear(Vec2{2, 1}, digits));
    CHECK_THAT(to_local({{-1, 0}, {0, -1}, {0, 0}}, {3, 5}), IsNear(Vec2{-3, -5}, digits));
}

//> Moved, not turned
TEST_CASE("subtracts the origin when the frame is only moved", "[9.6]") {
    CHECK_THAT(to_local({{1, 0}, {0, 1}, {3, 1}}, {4, 3}), IsNear(Vec2{1, 2}, digits));
}

//> The world itself
TEST_CASE("leaves a point alone in the world's own frame", "[9.6]") {
    CHECK_THAT(to_local(Frame{}, {4, -3}), IsNear(Vec2{4, -3}, digits));
    CHECK_THAT(to_local(Frame{}, {0, 0}), IsNear(Vec2{0, 0}, digits));
}

//> Its origin and its axes
TEST_CASE("sees the frame's own origin at (0, 0), and its axes end at (1, 0) and (0, 1)", "[9.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const Frame any = frame(dice);
        CHECK_THAT(to_local(any, any.origin), IsNear(Vec2{0, 0}, digits));
        CHECK_THAT(to_local(any, any.origin + any.x_axis), IsNear(Vec2{1, 0}, digits));
        CHECK_THAT(to_local(any, any.origin + any.y_axis), IsNear(Vec2{0, 1}, digits));
    }
}

//> There and back
TEST_CASE("gets back to the point when you walk along both axes", "[9.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Frame any = frame(dice);
        const Vec2 point = dice.point(-10, 10), got = to_local(any, point);
        CHECK_THAT(Vec2{any.origin + got.x() * any.x_axis + got.y() * any.y_axis},
                   IsNear(point, digits).of("the point, walked to again [m]"));
    }
}

//> By distance and angle
TEST_CASE("turns the direction back by the frame's angle, at the same distance", "[9.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double angle = dice.real(-pi, pi), towards = dice.real(-pi, pi), far = dice.real(0, 10);
        const Vec2 at = dice.point(-5, 5);
        CHECK_THAT(to_local(frame(angle, at), at + far * at_angle(towards)),
                   IsNear(Vec2{far * at_angle(towards - angle)}, digits));
    }
}

//>
TEST_CASE("keeps the distance from the frame's origin", "[9.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const Frame any = frame(dice);
        const Vec2 point = dice.point(-10, 10);
        CHECK_THAT(to_local(any, point).norm(), IsNear((point - any.origin).norm(), digits).of("distance [m]"));
    }
}

//> A box in the hand
TEST_CASE("keeps a box where it is in the hand, however the hand moves and turns", "[9.6]") {
    const Vec2 box = to_local(frame(degrees(90), {2, 3}), {2, 3.5}); // picked up, half a metre in front of the hand
    CHECK_THAT(box, IsNear(Vec2{0.5, 0}, digits).of("the box, in the hand's frame [m]"));
    CHECK_THAT(to_local(frame(degrees(180), {-1, 4}), {-1.5, 4}), IsNear(Vec2{0.5, 0}, digits));
}

//>
TEST_CASE("takes points and origins up to 1e5, and tiny ones", "[9.6]") {
    CHECK_THAT(to_local({{1, 0}, {0, 1}, {-1e5, 1e5}}, {1e5, -1e5}), IsNear(Vec2{2e5, -2e5}, of_one));
    CHECK_THAT(to_local({{0, 1}, {-1, 0}, {0, -1e5}}, {1e5, 1e5}), IsNear(Vec2{2e5, -1e5}, of_one));
    CHECK_THAT(to_local({{0.8, 0.6}, {-0.6, 0.8}, {3e-9, 1e-9}}, {4e-9, 3e-9}), IsNear(Vec2{2e-9, 1e-9}, of_one));
    CHECK_THAT(to_local(frame(1e-7, {0, 0}), {1, 0}), IsNear(Vec2{1, -1e-7}, digits));
    CHECK_THAT(to_local(frame(0, {1e-7, 0}), {1, 0}), IsNear(Vec2{1 - 1e-7, 0}, digits));
    CHECK_THAT(to_local({{0.8, 0.6}, {-0.6, 0.8}, {4, 3}}, {3, 1}), IsNear(Vec2{-2, -1}, digits));
    CHECK_THAT(to_local({{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, {0, 0}), IsNear(Vec2{-3, 1}, digits)); // the world's origin
    CHECK_THAT(to_local(Frame{}, {-1e5, 0}), IsNear(Vec2{-1e5, 0}, of_one));
    CHECK_THAT(to_local(Frame{}, {2, 1e-8}), IsNear(Vec2{2, 1e-8}, of_one));
    CHECK_THAT(to_local(Frame{}, {1e5, 1e-3}), IsNear(Vec2{1e5, 1e-3}, of_one));
    const Vec2 x = at_angle(0.7), y = quarter_turned(x);
    for (const double size : {10.0, 1e4}) {
        const Vec2 origin = size * Vec2{10, -4}, point = size * Vec2{-3, 9}, way = point - origin;
        CHECK_THAT(to_local({x, y, origin}, point), IsNear(Vec2{way.dot(x), way.dot(y)}, digits));
    }
    CHECK_THAT(to_local({x, y, {3, 1}}, {2, 2}), IsNear(Vec2{-x.x() + x.y(), -y.x() + y.y()}, digits));
    CHECK_THAT(to_local({x, y, {4, 1}}, {2, 2}), IsNear(Vec2{-2 * x.x() + x.y(), -2 * y.x() + y.y()}, digits));
}

// ----------------------------------------------------------------------------------------------- 9.7 turn_above_ground

// What lies up to 1e-5 m below the ground counts as on it. A point that comes down to the ground on its way, and goes no
// deeper than that, may end the turn there or not; one that stays where it is does not end it. Where the turn ends early,
// what touches the ground is at y = 0, or no deeper than the arm was to begin with, to nine digits of the largest number
// that goes in, or of 1 if that is larger.

namespace {

constexpr double in_angle =
    1e-8; // of worked examples [rad]: what an error of 1e-9 m makes where a height changes slowly

/// The heights above the ground of all joints and of the hand, once one joint has turned so far [m].
std::vector<double> heights(const Vec2 &base, std::vector<Link> links, int joint, double turn) {
    links[joint].angle += turn;
    std::vector<double> all;
    for (const Vec2 &point : walked(base, links)) all.push_back(point.y());
    return all;
}
double lowest(const std::vector<double> &heights) { return *std::min_element(heights.begin(), heights.end()); }

/// An arm that is above the ground by some centimetres.
struct Arm {
    Vec2 base;
    std::vector<Link> links;
};
Arm raised_arm(Dice &dice) {
    for (;;) {
        const Arm any{{dice.real(-2, 2), dice.real(0.1, 3)}, arm(dice, dice.whole(1, 5))};
        if (lowest(heights(any.base, any.links, 0, 0)) > 0.05) return any;
    }
}

} // namespace

//> Worked example: down to the ground
TEST_CASE("lets a level 5 m link, 3 m up, turn 0.6435 rad clockwise and no further", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, -pi / 2), IsNear(-std::asin(0.6), in_angle));
}

//> Not so far
TEST_CASE("doesn't stop a turn that ends above the ground", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, -0.6), IsNear(-0.6, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, 3), IsNear(3.0, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, 0), IsNear(0.0, digits));
}

//> Over the top
TEST_CASE("comes down on the other side when it turns anticlockwise", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, 6), IsNear(pi + std::asin(0.6), in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, pi}}, 0, -6), IsNear(-pi - std::asin(0.6), in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, pi}}, 0, 6), IsNear(std::asin(0.6), in_angle));
}

//> Short enough
TEST_CASE("lets a link that's too short for the ground turn as often as it likes", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 3}, {{2.9, 0}}, 0, -100), IsNear(-100.0, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{2.9, 0}}, 0, 1e5), IsNear(1e5, digits));
}

//> The elbow touches first
TEST_CASE("stops at the elbow when the hand is held up", "[9.7]") {
    // 5 m to the right, then 2 m straight up: the elbow is down after asin(3/5)
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}, {2, degrees(90)}}, 0, -2), IsNear(-std::asin(0.6), in_angle));
}

//> The hand touches first
TEST_CASE("stops at the hand when it's held down", "[9.7]") {
    // 4 m to the right and 1 m down: the hand is √17 m away, and atan(1/4) below the level already
    CHECK_THAT(turn_above_ground({0, 3}, {{4, 0}, {1, degrees(-90)}}, 0, -2),
               IsNear(-std::asin(3 / std::sqrt(17)) + std::atan(0.25), in_angle));
}

//> The second joint
TEST_CASE("turns only what comes after the elbow when the elbow bends", "[9.7]") {
    // the elbow is at (3, 4), the hand 5 m to the right of it
    const std::vector<Link> links{{5, std::atan2(4, 3)}, {5, -std::atan2(4, 3)}};
    CHECK_THAT(turn_above_ground({0, 0}, links, 1, -2), IsNear(-std::asin(0.8), in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, links, 1, 6), IsNear(pi + std::asin(0.8), in_angle));
}

//> The middle of three
TEST_CASE("turns two links of three by the middle joint", "[9.7]") {
    // up 3 m, right 4 m, down 1 m: the hand is √17 m from the elbow
    const std::vector<Link> links{{3, degrees(90)}, {4, degrees(-90)}, {1, degrees(-90)}};
    CHECK_THAT(turn_above_ground({0, 0}, links, 1, -2),
               IsNear(-std::asin(3 / std::sqrt(17)) + std::atan(0.25), in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, links, 2, -100), IsNear(-100.0, digits)); // 1 m cannot reach 3 m down
}

//> Any joint
TEST_CASE("stops the third joint, the fourth and the fifth where the hand gets to the ground", "[9.7]") {
    for (const int joint : {2, 3, 4}) {
        std::vector<Link> links(joint, Link{1, 0}); // level, 2 m up; the last link is 3 m long
        links.push_back({3, 0});
        CHECK_THAT(turn_above_ground({0, 2}, links, joint, -3), IsNear(-std::asin(2.0 / 3), in_angle));
    }
}

//> One in between touches first
TEST_CASE("stops at a joint in between when that one gets there first", "[9.7]") {
    // from the first joint the others are at (0, 1), (4, 1), (4, 4), (1, 4), and the hand is at (1, 2)
    const std::vector<Link> links{
        {1, degrees(90)}, {4, degrees(-90)}, {3, degrees(90)}, {3, degrees(90)}, {2, degrees(90)}};
    CHECK_THAT(turn_above_ground({0, 3}, links, 0, -3),
               IsNear(-std::asin(3 / std::sqrt(17)) - std::atan(0.25), in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, links, 0, 6),
               IsNear(pi + std::asin(3 / std::sqrt(17)) - std::atan(4), in_angle));
}

//> From the ground
TEST_CASE("turns from level to level when the base is on the ground", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 0}, {{5, degrees(30)}}, 0, 4), IsNear(degrees(150), in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, degrees(30)}}, 0, -4), IsNear(degrees(-30), in_angle));
    CHECK_THAT(turn_above_ground({7, 0}, {{5, degrees(90)}}, 0, 4), IsNear(degrees(90), in_angle));
}

//> On the ground
TEST_CASE("holds a hand that's on the ground, and lets it go up and over", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 0}, {{5, 0}}, 0, -1), IsNear(0.0, in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, 0}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, 0}}, 0, 4), IsNear(pi, in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, pi}}, 0, 1), IsNear(0.0, in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, pi}}, 0, -4), IsNear(-pi, in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, -std::asin(0.6)}}, 0, -1), IsNear(0.0, in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, -std::asin(0.6)}}, 0, 6), IsNear(pi + 2 * std::asin(0.6), in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, pi + std::asin(0.6)}}, 0, -6),
               IsNear(-pi - 2 * std::asin(0.6), in_angle));
}

//> Asked again
TEST_CASE("stays where it stopped when you ask again, and may go back up", "[9.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        auto [base, links] = raised_arm(dice);
        const int joint = dice.whole(0, int(links.size()) - 1);
        const double by = dice.sign() * 10;
        const double turned = turn_above_ground(base, links, joint, by);
        for (int step = 1; step <= 20; ++step) // or else what comes is about an arm that's in the ground
            CHECK_THAT(lowest(heights(base, links, joint, turned * step / 20)),
                       IsAtLeast(-1.1e-5).of("height of the lowest joint on the way [m]"));
        if (turned == by) continue; // it touches nothing
        links[joint].angle += turned;
        CHECK_THAT(lowest(heights(base, links, joint, by / 1e5)), IsBelow(1e-8).of("height, one step farther [m]"));
        if (lowest(heights(base, links, joint, by / 1e4)) > -1e-4) continue; // it hardly dips
        CHECK_THAT(lowest(heights(base, links, joint, turn_above_ground(base, links, joint, by))),
                   IsNear(0.0, 3e-8).of("height of the lowest joint, turned once more [m]"));
        CHECK_THAT(turn_above_ground(base, links, joint, -turned), IsNear(-turned, digits));
    }
}

//> Frame by frame
TEST_CASE("gets to the ground by a tenth of a radian a frame, and stays there", "[9.7]") {
    std::vector<Link> links{{2, degrees(60)}, {3, degrees(-20)}, {1, degrees(-30)}};
    double angle = links[0].angle;
    for (int frame = 0; frame < 100; ++frame) {
        links[0].angle = angle;
        angle += turn_above_ground({0, 1}, links, 0, -0.1);
    }
    CHECK_THAT(lowest(heights({0, 1}, links, 0, 0)), IsNear(0.0, 1e-7).of("height of the lowest joint [m]"));
}

//> Never below
TEST_CASE("never takes a joint below the ground, and stops early only when one is on it", "[9.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const auto [base, links] = raised_arm(dice);
        const int joint = dice.whole(0, int(links.size()) - 1);
        const double by = dice.real(-8, 8);

        const double got = turn_above_ground(base, links, joint, by);

        CHECK_THAT(got * by, IsAtLeast(0).of("the answer, times `by` [rad²]"));
        CHECK_THAT(std::abs(got), IsAtMost(std::abs(by)).of("how far it turns [rad]"));
        for (int step = 1; step <= 50; ++step)
            CHECK_THAT(lowest(heights(base, links, joint, got * step / 50)),
                       IsAtLeast(-1.1e-5).of("height of the lowest joint on the way [m]"));
        if (std::abs(got) < std::abs(by) - 1e-9)
            CHECK_THAT(lowest(heights(base, links, joint, got)),
                       IsNear(0.0, 1e-8).of("height of the lowest joint where it ends [m]"));
    }
}

//> On the ground but for rounding
TEST_CASE("holds a joint on the left whose height is 0 but for rounding", "[9.7]") {
    const std::vector<Link> links{{1.8991019796208011, -0.58986670438353661},
                                  {1.8004549573577864, -2.2755968140702709},
                                  {2.5752097221673198, -0.81084344568161798}};
    CHECK_THAT(turn_above_ground({0, 1.5472402503657643}, links, 0, 0.4), IsNear(0.0, in_angle));
}

//> In a mirror
TEST_CASE("turns a mirrored arm the other way, just as far", "[9.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const auto [base, links] = raised_arm(dice);
        std::vector<Link> mirrored = links;
        for (Link &each : mirrored) each.angle = -each.angle;
        mirrored[0].angle += pi;
        const int joint = dice.whole(0, int(links.size()) - 1);
        const double by = dice.real(-8, 8);
        const double one = turn_above_ground(base, links, joint, by);
        const double other = turn_above_ground({-base.x(), base.y()}, mirrored, joint, -by);
        CHECK_THAT(one + other, IsNear(0.0, 1e-3).of("sum of a turn and its mirror image [rad]"));
    }
}

//> Rounding below the ground
TEST_CASE("counts 5e-6 m below the ground as on it", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 0}, {{5, -1e-16}}, 0, -1), IsNear(0.0, in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, -1e-16}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, -pi}}, 0, 1), IsNear(0.0, in_angle)); // its y is -6e-16
    CHECK_THAT(turn_above_ground({0, 0}, {{5, -pi}}, 0, -4), IsNear(-pi, in_angle));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, -1e-6}}, 0, -1), IsNear(0.0, 2e-6));
    CHECK_THAT(turn_above_ground({0, 0}, {{5, -1e-6}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, -5e-6}, {{5, degrees(90)}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 0}, {{1e-4, -0.05}}, 0, -1), IsNear(0.0, 1e-4)); // close to the joint
}

//>
TEST_CASE("handles links without length, long arms, and arms right above the ground", "[9.7]") {
    CHECK_THAT(turn_above_ground({0, 0}, {{0, 1}}, 0, -7), IsNear(-7.0, digits)); // nothing moves
    CHECK_THAT(turn_above_ground({0, 0}, {{0, 1}, {5, 1}, {0, 3}}, 0, -7), IsNear(-2.0, in_angle));
    CHECK_THAT(turn_above_ground({0, 2}, {{5, 0}, {0, 0}}, 1, -7), IsNear(-7.0, digits));
    CHECK_THAT(turn_above_ground({1e5, 3}, {{5, pi}}, 0, 1), IsNear(std::asin(0.6), 3e-5)); // y to nine digits of 1e5
    CHECK_THAT(turn_above_ground({1e5, 3}, {{5, pi}}, 0, -1), IsNear(-1.0, digits));
    CHECK_THAT(turn_above_ground({-1e5, 3}, {{5, 0}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 6e4}, {{1e5, 0}}, 0, -1e5), IsNear(-std::asin(0.6), 1.5e-9));
    CHECK_THAT(turn_above_ground({0, 1e5}, {{8e4, 0}, {8e4, degrees(-90)}}, 0, -1e5),
               IsNear(degrees(45) - std::asin(1 / (0.8 * std::sqrt(2))), 1e-8));
    CHECK_THAT(turn_above_ground({0, 1e5}, {{9e4, 0}}, 0, 1e5), IsNear(1e5, digits));
    CHECK_THAT(turn_above_ground({0, 0.003}, {{0.005, 0}}, 0, -1), IsNear(-std::asin(0.6), 1e-6));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 20 * pi}}, 0, -1), IsNear(-std::asin(0.6), chained));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, -20 * pi}}, 0, 6), IsNear(pi + std::asin(0.6), chained));
    CHECK_THAT(turn_above_ground({0, 3}, {{3.001, 0}}, 0, -7),
               IsNear(-std::asin(3 / 3.001), 1e-6)); // a millimetre deep
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, -0.643), IsNear(-0.643, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, -0.644), IsNear(-std::asin(0.6), in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}}, 0, -1e-7), IsNear(-1e-7, digits));
    CHECK_THAT(turn_above_ground({0, 5}, {{5, degrees(-80)}}, 0, 9e4), IsNear(9e4, 1)); // it may stop where it grazes
    CHECK_THAT(turn_above_ground({0, 3}, {{2, 0}}, 0, -1e5), IsNear(-1e5, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{2, 0}}, 0, -9e-8), IsNear(-9e-8, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{2, 0}}, 0, 9e-6), IsNear(9e-6, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{1e-7, 0}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 20}}, 0, -3), IsNear(-(20 - 6 * pi) - std::asin(0.6), 1e-7));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 600}}, 0, -3), IsNear(-3.0, digits)); // to the left, but for 0.04 rad
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 900}}, 0, -3), IsNear(-(900 - 286 * pi) - std::asin(0.6), 2e-7));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 1e5}}, 0, -3), IsNear(-3.0, digits));
    for (const int count : {8, 12, 1001}) // level, 4 m in all
        CHECK_THAT(turn_above_ground({0, 2}, std::vector<Link>(count, Link{4.0 / count, 0}), 0, -3),
                   IsNear(-degrees(30), in_angle));
    turn_above_ground({0, 3}, {{5, 0}, {2.9, -0.2}}, 0, -3); // another joint of the same arm
    CHECK_THAT(turn_above_ground({0, 3}, {{5, 0}, {2.9, -0.2}}, 1, -3), IsNear(-3.0, digits));

    // arms that hardly dip, that are hardly above the ground, or that come down late
    for (const double height : {4.99, 4.9999, 4.99996, 4.999982, 4.999987}) // 1.3e-5 m deep, and more
        CHECK_THAT(turn_above_ground({0, height}, {{5, 0}}, 0, -3), IsNear(-std::asin(height / 5), 1e-6));
    CHECK_THAT(turn_above_ground({0, 4.99996}, {{5, 0.005}}, 0, -3), IsNear(-0.005 - std::asin(4.99996 / 5), 1e-6));
    CHECK_THAT(turn_above_ground({0, 999.9995}, {{1000, 0}}, 0, -3), IsNear(-std::asin(0.9999995), 1e-5));
    CHECK_THAT(turn_above_ground({0, 999.99995}, {{1000, 0.0007}}, 0, -3),
               IsNear(-0.0007 - std::asin(0.99999995), 1e-5));
    CHECK_THAT(turn_above_ground({0, 5.03}, {{5, 0}}, 0, -3), IsNear(-3.0, digits)); // 3 cm above the ground
    for (const double height : {9e-4, 9e-5, 9e-6, 9e-7, 9e-8})
        CHECK_THAT(turn_above_ground({0, height}, {{1, 0}}, 0, -1), IsNear(-std::asin(height), in_angle / 5));
    for (const double length : {9e-5, 2.9e-5}) // what is close to its joint touches, too
        CHECK_THAT(turn_above_ground({0, 0}, {{length, 1}}, 0, -3), IsNear(-1.0, 2e-4));
    CHECK_THAT(turn_above_ground({0, 3}, {{3.1, -1.2}}, 0, 10), IsNear(pi + std::asin(3 / 3.1) + 1.2, 1e-6));
    CHECK_THAT(turn_above_ground({0, 3}, {{3.01, -1.48}}, 0, 10), IsNear(pi + std::asin(3 / 3.01) + 1.48, 1e-6));

    // a hair below the ground to begin with: it can be lifted, and does not sink
    CHECK_THAT(turn_above_ground({0, 3}, {{5, pi + std::asin(0.6) + 2.2e-6}}, 0, 1), IsNear(0.0, in_angle));
    CHECK_THAT(turn_above_ground({0, 3}, {{5, -std::asin(0.6) - 2e-6}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 0}, {{0.5, -1.6e-5}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, 0}, {{0.005, -1.6e-3}}, 0, 1), IsNear(1.0, digits));
    CHECK_THAT(turn_above_ground({0, -9e-6}, {{1, 1}}, 0, -3),
               IsNear(-1 + 4.5e-6, 4.6e-6)); // at y = 0, or as low as it
    for (const double low : {5e-6, 9.5e-6, 9.95e-6, 1e-5})
        CHECK_THAT(turn_above_ground({0, -low}, {{1, 1}}, 0, 0.5), IsNear(0.5, digits)); // the base
    for (const double low : {5e-6, 9.5e-6, 9.95e-6}) {
        CHECK_THAT(turn_above_ground({0, 1}, {{1 + low, -pi / 2}}, 0, 0), IsNear(0.0, digits));  // the hand
        CHECK_THAT(turn_above_ground({0, 0}, {{1, -low}, {1, 1}}, 1, 0.5), IsNear(0.5, digits)); // the joint that turns
        CHECK_THAT(turn_above_ground({0, -low}, {{1, 1}, {1, 1}}, 1, 0.5), IsNear(0.5, digits)); // one before it
    }
}

TEST_CASE("rejects an arm that starts below the ground, wherever that is", "[9.7]") {
    for (const double deep : {1.005e-5, 2e-5, 0.1, 1.0}) {
        CHECK_REFUSED(turn_above_ground({0, -deep}, {{5, degrees(90)}}, 0, 1), "the base is below the ground");
        CHECK_REFUSED(turn_above_ground({0, 0}, {{5, -std::asin(deep / 5)}}, 0, 1), "the hand is below the ground");
        CHECK_REFUSED(turn_above_ground({0, 3}, {{5, -std::asin((3 + deep) / 5)}, {5, degrees(90)}}, 0, 1),
                      "the elbow is below the ground");
        CHECK_REFUSED(turn_above_ground({0, 3}, {{5, -std::asin((3 + deep) / 5)}, {5, degrees(90)}}, 1, 1),
                      "the elbow, which turns, is below the ground");
        CHECK_REFUSED(turn_above_ground({0, -deep}, {{5, degrees(90)}}, 0, 0), "the base is below the ground, by 0");
    }
    for (const int joint : {1, 2}) // at (1.08, -0.68)
        CHECK_REFUSED(turn_above_ground({0, 1}, {{2, -1}, {2, 2}, {1, 0}}, joint, 0.5), "the elbow of three links");
    turn_above_ground({0, 3}, {{5, 0}}, 0, -1); // good input is still answered
}

TEST_CASE("rejects a joint that doesn't exist", "[9.7]") {
    CHECK_REFUSED(turn_above_ground({0, 3}, {{5, 0}, {2, 0}}, -1, 1), "joint -1");
    CHECK_REFUSED(turn_above_ground({0, 3}, {{5, 0}, {2, 0}}, 2, 1), "joint 2 of two links");
    CHECK_REFUSED(turn_above_ground({0, 3}, {{5, 0}, {2, 0}}, 100, 1), "joint 100 of two links");
    CHECK_REFUSED(turn_above_ground({0, 3}, {}, 0, 1), "joint 0 of no links");
    for (const int joint : {-2, -2147483647 - 1, 2000000})
        CHECK_REFUSED(turn_above_ground({0, 3}, {{5, 0}, {2, 0}}, joint, 1), "a joint that is far from any");
    turn_above_ground({0, 3}, {{5, 0}, {2, 0}}, 1, 1); // good input is still answered
}

TEST_CASE("rejects any negative length above the ground", "[9.7]") {
    for (const double bad : {-1e-9, -3.0}) {
        CHECK_REFUSED(turn_above_ground({0, 3}, {{bad, 0}, {2, 0}}, 0, 1), "the first length is negative");
        CHECK_REFUSED(turn_above_ground({0, 3}, {{2, 0}, {bad, 0}}, 0, 1), "the last length is negative");
    }
    CHECK_REFUSED(turn_above_ground({0, 3}, {{1, 0}, {-1, 0}, {1, 0}}, 0, 1),
                  "the second of three lengths is negative");
    CHECK_REFUSED(turn_above_ground({0, 3}, {{1, 0}, {1, 0}, {-1, 0}}, 0, 1), "the third of three lengths is negative");
    turn_above_ground({0, 3}, {{2, 0.1}}, 0, 1); // good input is still answered
}

// --------------------------------------------------------------------------------------------------- 9.8 over_the_wall

namespace {

/// The joints of a crane's arm in a pose.
std::vector<Vec2> joints_of(const Crane &crane, const Pose &pose) {
    return walked({0, crane.height}, {{crane.first, pose.first}, {crane.second, pose.second}});
}
bool on_side(const Crane &crane, const Pose &pose, double side) {
    const std::vector<Vec2> all = joints_of(crane, pose);
    return side * all[1].x() > 0.01 && side * all[2].x() > 0.01 && all[1].y() > 0.01 && all[2].y() > 0.01;
}

/// How much room there is between the wall and a link where it crosses the line of the wall [m]; a lot if it doesn't.
double room_above_wall(const Crane &crane, const Vec2 &from, const Vec2 &to) {
    if (from.x() * to.x() > 0 || from.x() == to.x())
        return from.x() == 0 ? std::min(from.y(), to.y()) - crane.wall : 1e3;
    const double part = from.x() / (from.x() - to.x());
    return from.y() + part * (to.y() - from.y()) - crane.wall;
}

double difference(double one, double other) { return std::abs(std::remainder(one - other, 2 * pi)); }

/// All that `over_the_wall` promises.
void check_promises(const Crane &crane, const Pose &start, const Pose &goal) {
    const std::vector<Pose> poses = over_the_wall(crane, start, goal);
    CHECK_THAT(int(poses.size()), IsAtLeast(2).of("poses"));
    CHECK_THAT(int(poses.size()), IsAtMost(10000).of("poses"));
    CHECK_THAT(difference(poses.front().first, start.first),
               IsNear(0.0, digits).of("the first pose's first angle, off by [rad]"));
    CHECK_THAT(difference(poses.front().second, start.second),
               IsNear(0.0, digits).of("the first pose's second angle, off by [rad]"));
    CHECK_THAT(difference(poses.back().first, goal.first),
               IsNear(0.0, chained).of("the last pose's first angle, off by [rad]"));
    CHECK_THAT(difference(poses.back().second, goal.second),
               IsNear(0.0, chained).of("the last pose's second angle, off by [rad]"));
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::vector<Vec2> all = joints_of(crane, poses[i]);
        const std::string which = ", in pose " + std::to_string(i) + " of " + std::to_string(poses.size());
        CHECK_THAT(all[1].y(), IsAtLeast(-digits).of("height of the elbow" + which + " [m]"));
        CHECK_THAT(all[2].y(), IsAtLeast(-digits).of("height of the hand" + which + " [m]"));
        const double room = std::min(room_above_wall(crane, all[0], all[1]), room_above_wall(crane, all[1], all[2]));
        CHECK_THAT(room, IsAbove(0).of("room above the wall" + which + " [m]"));
        if (i == 0) continue;
        const double step =
            std::max(std::abs(poses[i].first - poses[i - 1].first), std::abs(poses[i].second - poses[i - 1].second));
        CHECK_THAT(step, IsAtMost(0.1 + digits).of("largest turn" + which + " [rad]"));
    }
}

} // namespace

//> Straight over
TEST_CASE("swings a straight arm from the left of the wall to the right", "[9.8]") {
    check_promises({5, 3, 2, 3}, {degrees(200), 0}, {degrees(-20), 0});
}

//> Not from below
TEST_CASE("goes over the top, even when the way under the base is shorter", "[9.8]") {
    check_promises({5, 2, 1, 4}, {degrees(260), 0}, {degrees(-80), 0});
}

//> Bent
TEST_CASE("brings a hand that's held down on the left to one that's held up on the right", "[9.8]") {
    check_promises({5, 3, 4, 4.5}, {degrees(160), degrees(60)}, {degrees(-10), degrees(120)});
    check_promises({5, 3, 4, 4.5}, {degrees(190), degrees(-120)}, {degrees(20), degrees(-70)});
}

//> Folded up
TEST_CASE("carries an arm that's folded up tightly", "[9.8]") {
    check_promises({5, 4, 3, 4}, {degrees(250), degrees(-170)}, {degrees(-70), degrees(170)});
    check_promises({5, 4, 5, 4}, {degrees(100), degrees(150)}, {degrees(80), degrees(-150)});
}

//> Another turn
TEST_CASE("doesn't mind angles of another turn", "[9.8]") {
    check_promises({5, 3, 2, 3}, {degrees(-160), 0}, {degrees(340), 0});
    check_promises({5, 3, 2, 3}, {degrees(200), 0}, {degrees(340), 0});
    check_promises({5, 3, 2, 3}, {degrees(-160), 0}, {degrees(-340), 0});
}

//> Both at once, into the ground
TEST_CASE("doesn't take a load through the ground, where turning both angles at once would", "[9.8]") {
    check_promises({5, 4.93, 4.81, 4.91}, {degrees(139), degrees(83)}, {degrees(-18), degrees(-117)});
    check_promises({5, 4.22, 3.19, 4.22}, {degrees(227), degrees(98)}, {degrees(-61), degrees(-171)});
}

//> Both at once, into the wall
TEST_CASE("doesn't take a load through the wall, where turning both angles at once would", "[9.8]") {
    check_promises({5, 4.45, 3.42, 4.29}, {degrees(222), degrees(172)}, {degrees(-62), degrees(-172)});
    check_promises({5, 3.31, 2.84, 3.48}, {degrees(230), degrees(175)}, {degrees(0), degrees(-131)});
}

//> Long links
TEST_CASE("keeps long links off the ground", "[9.8]") {
    check_promises({5, 5, 5, 4}, {degrees(200), degrees(-60)}, {degrees(-20), degrees(60)});
    check_promises({5, 1, 5, 0}, {degrees(95), degrees(100)}, {degrees(85), degrees(-100)});
}

//> Any crane
TEST_CASE("gets over the wall with any crane, from any pose to any other", "[9.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double height = dice.real(1, 9);
        const Crane crane{height, dice.real(0.1, 1) * height, dice.real(0.1, 1) * height, dice.real(0, 0.99) * height};
        Pose start, goal;
        const double bent = i % 2 == 0 ? 1.5 : -3.05; // half of them far, and to opposite sides
        do start = {dice.real(-6, 6), dice.real(bent, 3.05)};
        while (!on_side(crane, start, -1));
        do goal = {dice.real(-6, 6), -dice.real(bent, 3.05)};
        while (!on_side(crane, goal, 1));
        check_promises(crane, start, goal);
    }
}

//>
TEST_CASE("rejects poses on the wrong side or in the ground, long links, and a wall as high as the crane", "[9.8]") {
    const Crane crane{5, 3, 2, 3};
    const Pose left{degrees(200), 0}, right{degrees(-20), 0};
    CHECK_REFUSED(over_the_wall(crane, right, right), "the start is on the right");
    CHECK_REFUSED(over_the_wall(crane, left, left), "the goal is on the left");
    CHECK_REFUSED(over_the_wall(crane, {degrees(100), degrees(-60)}, right), "the hand starts on the right");
    CHECK_REFUSED(over_the_wall({3, 3, 2, 1}, {degrees(255), 0}, right), "the hand starts in the ground");
    CHECK_REFUSED(over_the_wall({5, 5.1, 2, 3}, left, right), "the first link is longer than the crane is high");
    CHECK_REFUSED(over_the_wall({5, 3, 5.1, 3}, left, right), "the second link is longer than the crane is high");
    CHECK_REFUSED(over_the_wall({5, 0, 2, 3}, left, right), "a link has no length");
    CHECK_REFUSED(over_the_wall({5, 3, 2, 5}, left, right), "the wall is as high as the crane");
    CHECK_REFUSED(over_the_wall({5, 3, 2, -1}, left, right), "the wall has a negative height");
    CHECK_REFUSED(over_the_wall(crane, {left.first, 3.2}, right), "the second angle is beyond ±3.1");
    CHECK_REFUSED(over_the_wall(crane, {left.first + 2 * pi, 0}, right), "the first angle is beyond ±2π");
    over_the_wall(crane, left, right); // good input is still answered
}
