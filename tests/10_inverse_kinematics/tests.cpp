#include "section_test.hpp"

#include "inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using inverse_kinematics::Apple;
using inverse_kinematics::Arm;
using inverse_kinematics::Limits;
using inverse_kinematics::Link;
using inverse_kinematics::Orchard;
using inverse_kinematics::Pose;
using namespace inverse_kinematics::subject; // point_at, poses, ... write: the student's

namespace {

constexpr double pi = std::numbers::pi;
// An angle is right to nine digits. So is a place, but where a hand has to be somewhere, it's there to 1e-12 of the arm's
// length. Where an acos is of ±1, seven digits will do, since it has no more: very near the first joint, where only links of
// equal lengths get to, and where a joint turns by nothing or by half a turn.
constexpr double digits = 1e-9;
constexpr double of_arm = 1e-12;
constexpr double chained = 1e-7; // where a test computes with answers, or an acos of ±1 may

constexpr double degrees(double angle) { return angle * pi / 180; } // [rad]

Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
double cross(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }
/// The same direction as an angle, within half a turn.
double within_half_a_turn(double angle) { return std::arg(std::polar(1.0, angle)); }
double off(double one, double other) { return std::abs(within_half_a_turn(one - other)); }

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
Vec2 elbow_of(const Arm &arm, const Pose &pose) { return arm.first * at_angle(pose.first); }
Vec2 hand_of(const Arm &arm, const Pose &pose) {
    return elbow_of(arm, pose) + arm.second * at_angle(pose.first + pose.second);
}
double length_of(const Arm &arm) { return arm.first + arm.second; }
double hole_of(const Arm &arm) { return std::abs(arm.first - arm.second); }

Arm arm(Dice &dice) { return {dice.real(0.2, 3), dice.real(0.2, 3)}; }
/// A place that the hand can reach, a hundredth of the arm or more from the first joint.
Vec2 within_reach(Dice &dice, const Arm &arm) {
    return dice.real(std::max(hole_of(arm), 0.01 * length_of(arm)), length_of(arm)) * at_angle(dice.real(-pi, pi));
}
std::vector<Link> chain(Dice &dice, int count) {
    std::vector<Link> links;
    while (int(links.size()) < count) links.push_back({dice.real(0.2, 3), dice.real(-4, 4)});
    return links;
}

} // namespace

// -------------------------------------------------------------------------------------------------------- 10.1 point_at

//> Worked example: 3 m to the right, 4 m up
TEST_CASE("points from (1, 2) at (4, 6), which is 3 m to the right and 4 m up, at 53.13°", "[10.1]") {
    CHECK_THAT(point_at({1, 2}, {4, 6}), IsNear(std::acos(3.0 / 5), digits)); // 5 m away
}

//> Along the axes
TEST_CASE("points right at 0°, up at 90°, and down at -90°", "[10.1]") {
    CHECK_THAT(point_at({0, 0}, {5, 0}), IsNear(0.0, digits));
    CHECK_THAT(point_at({0, 0}, {0, 5}), IsNear(pi / 2, digits));
    CHECK_THAT(point_at({0, 0}, {0, -5}), IsNear(-pi / 2, digits));
}

//> Up and to the left
TEST_CASE("points at a target up and to the left at 126.87°", "[10.1]") {
    CHECK_THAT(point_at({0, 0}, {-3, 4}), IsNear(std::acos(-3.0 / 5), digits));
    CHECK_THAT(point_at({0, 0}, {-2, 2}), IsNear(degrees(135), digits));
}

//> Down and to the left
TEST_CASE("points at a target down and to the left at -126.87°", "[10.1]") {
    CHECK_THAT(point_at({0, 0}, {-3, -4}), IsNear(-std::acos(-3.0 / 5), digits));
    CHECK_THAT(point_at({0, 0}, {-2, -2}), IsNear(degrees(-135), digits));
}

//> Down and to the right
TEST_CASE("points at a target down and to the right at -53.13°", "[10.1]") {
    CHECK_THAT(point_at({0, 0}, {3, -4}), IsNear(-std::acos(3.0 / 5), digits));
    CHECK_THAT(point_at({0, 0}, {2, -2}), IsNear(degrees(-45), digits));
}

//> Straight to the left
TEST_CASE("points straight to the left at half a turn, with either sign", "[10.1]") {
    CHECK_THAT(std::abs(point_at({0, 0}, {-5, 0})), IsNear(pi, digits).of("the angle without its sign [rad]"));
    CHECK_THAT(std::abs(point_at({7, 3}, {2, 3})), IsNear(pi, digits).of("the angle without its sign [rad]"));
}

//> From another joint
TEST_CASE("looks from the joint, wherever that is, not from the origin", "[10.1]") {
    CHECK_THAT(point_at({5, 1}, {5, 4}), IsNear(pi / 2, digits));
    CHECK_THAT(point_at({5, 1}, {2, 1.0 - 3}), IsNear(degrees(-135), digits));
    CHECK_THAT(point_at({-2, -7}, {-1, -8}), IsNear(degrees(-45), digits));
    CHECK_THAT(point_at({4, 6}, {0, 0}), IsNear(std::atan2(-6, -4), digits));
}

//> Nowhere to point
TEST_CASE("answers 0 when joint and target are the same point", "[10.1]") {
    CHECK_THAT(point_at({0, 0}, {0, 0}), IsNear(0.0, digits));
    CHECK_THAT(point_at({-3, 4}, {-3, 4}), IsNear(0.0, digits));
}

//> On a clock
TEST_CASE("follows a pointer once around the joint", "[10.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 joint = dice.point(-5, 5);
        const double angle = dice.real(-3.14, 3.14);
        CHECK_THAT(point_at(joint, joint + dice.real(0.1, 9) * at_angle(angle)), IsNear(angle, digits));
    }
}

//> Its end
TEST_CASE("makes a link that's long enough end at the target", "[10.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 joint = dice.point(-5, 5), target = dice.point(-5, 5);
        const Vec2 end = walked(joint, {{(target - joint).norm(), point_at(joint, target)}}).back();
        CHECK_THAT(Vec2{end - target}, IsNear(Vec2{0, 0}, chained).of("how far the link's end is off [m]"));
    }
}

//> There and back
TEST_CASE("turns by half a turn when joint and target swap places", "[10.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Vec2 one = dice.point(-5, 5), other = dice.point(-5, 5);
        const double there = point_at(one, other), back = point_at(other, one);
        CHECK_THAT(std::abs(there - back), IsNear(pi, digits).of("difference of both angles [rad]"));
    }
}

//> Never more than half a turn
TEST_CASE("never answers more than half a turn", "[10.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i)
        CHECK_THAT(std::abs(point_at(dice.point(-5, 5), dice.point(-5, 5))),
                   IsAtMost(pi).of("angle without sign [rad]"));
}

//> Erratum E10.3
TEST_CASE("erratum E10.3: a 5 m link that ends at x = 3 may end at y = 4 or at -4, at two angles", "[10.1]") {
    const double up = point_at({0, 0}, {3, 4}), down = point_at({0, 0}, {3, -4});
    for (const double angle : {up, down})
        CHECK_THAT(5 * std::cos(angle), IsNear(3.0, digits).of("x of the link's end [m]"));
    CHECK_THAT(up - down, IsNear(2 * std::acos(3.0 / 5), digits).of("difference of both angles [rad]")); // 106.26°
}

//> Erratum E10.5
TEST_CASE("erratum E10.5: needs both equations: acos says 120° and asin -60°, where -120° is right", "[10.1]") {
    const Vec2 end{-1.5, -1.5 * std::sqrt(3)}; // of a 3 m link
    const double angle = point_at({0, 0}, end);
    CHECK_THAT(angle, IsNear(degrees(-120), digits));
    CHECK_THAT(std::acos(end.x() / 3) - angle, IsNear(degrees(240), digits).of("how far acos is off [rad]"));
    CHECK_THAT(std::asin(end.y() / 3) - angle, IsNear(degrees(60), digits).of("how far asin is off [rad]"));
}

//>
TEST_CASE("points at targets that are very far away, or very near", "[10.1]") {
    CHECK_THAT(point_at({-1e5, -1e5}, {1e5, 1e5}), IsNear(degrees(45), digits));
    CHECK_THAT(point_at({1e5, 0}, {-1e5, 1}), IsNear(pi - 5e-6, digits));
    CHECK_THAT(point_at({1e5, 0}, {1e5, 5e-8}), IsNear(degrees(90), digits)); // near, and not the same
    CHECK_THAT(point_at({0, 0}, {-3e-9, 4e-9}), IsNear(std::acos(-3.0 / 5), digits));
    CHECK_THAT(point_at({0, 0}, {-1e-100, 1e-100}), IsNear(degrees(135), digits));
    CHECK_THAT(point_at({0, 0}, {1e5, 1e-5}), IsNear(1e-10, 1e-12));
    CHECK_THAT(point_at({0, 0}, {1, 1e-7}), IsNear(1e-7, 1e-12));
    CHECK_THAT(point_at({0, 0}, {-1, 1e-7}), IsNear(pi - 1e-7, 1e-12));
    CHECK_THAT(point_at({0, 0}, {1e-7, -1}), IsNear(1e-7 - pi / 2, 1e-12));
}

// ----------------------------------------------------------------------------------------------------------- 10.2 poses

namespace {

/// How far the hand is from where it should be, by the arm's length.
double miss(const Arm &arm, const Pose &pose, const Vec2 &target) {
    return (hand_of(arm, pose) - target).norm() / length_of(arm);
}
void check_hands(const Arm &arm, const std::vector<Pose> &all, const Vec2 &target, double tolerance = of_arm) {
    for (const Pose &pose : all)
        CHECK_THAT(miss(arm, pose, target), IsAtMost(tolerance).of("how far a hand is off, by the arm's length"));
}
/// One pose, or two that rounding makes of it: on a border.
void check_border(const Arm &arm, const Vec2 &target, double second) {
    const std::vector<Pose> all = poses(arm, target);
    CHECK_THAT(int(all.size()), IsAtLeast(1).of("poses"));
    CHECK_THAT(int(all.size()), IsAtMost(2).of("poses"));
    check_hands(arm, all, target, 2 * of_arm);
    for (const Pose &pose : all)
        CHECK_THAT(off(pose.second, second),
                   IsAtMost(1e-5).of("how far from straight or folded a second angle is [rad]"));
}

} // namespace

//> Worked example: the opening's arm
TEST_CASE("finds 0° and 90°, then 67.38° and -90°, for a 3 m and a 2 m link and a hand at (3, 2)", "[10.2]") {
    // 3² + 2² is 13, as far as the hand is, squared: so the elbow makes a right angle. The other pose is its mirror
    // image in the line to the hand, at 33.69°: twice that.
    CHECK_THAT(poses({3, 2}, {3, 2}),
               IsNear(std::vector<Pose>{{0, degrees(90)}, {2 * std::asin(2 / std::sqrt(13)), degrees(-90)}}, digits));
}

//> Worked example: no right angle
TEST_CASE("finds -13.18° and 70.53°, then 41.25° and -70.53°, for 3 m and 2 m and a hand at (4, 1)", "[10.2]") {
    const double bend = std::acos(1.0 / 3), aside = std::acos((3 + 2.0 / 3) / std::sqrt(17)),
                 line = std::asin(1 / std::sqrt(17));
    CHECK_THAT(poses({3, 2}, {4, 1}),
               IsNear(std::vector<Pose>{{line - aside, bend}, {line + aside, -bend}}, digits)
                   .since("17 = 9 + 4 + 2 · 6 cos, so cos = 1/3, and both make 3 + 2/3 m along the first link"));
    const double more = std::acos(1.0 / 15), beside = std::acos((3 + 5.0 / 15) / 6);
    CHECK_THAT(poses({3, 5}, {0, 6}),
               IsNear(std::vector<Pose>{{pi / 2 - beside, more}, {pi / 2 + beside, -more}}, digits)
                   .since("36 = 9 + 25 + 2 · 15 cos, so cos = 1/15, and both make 3 + 5/15 m along the first link"));
}

//> Back from chapter 9
TEST_CASE("finds chapter 9's 45° and 90° again, from 3 m and 5 m and a hand at (-1.414, 5.657)", "[10.2]") {
    const std::vector<Pose> all = poses({3, 5}, Vec2{-2, 8} / std::sqrt(2));
    CHECK_THAT(all, HasSize(2).of("poses"));
    CHECK_THAT(all[0], IsNear(Pose{degrees(45), degrees(90)}, digits).of("the pose whose elbow bends left"));
    const double line = std::acos(-1 / std::sqrt(17)); // at which the hand is: the mirror
    CHECK_THAT(all[1],
               IsNear(Pose{2 * line - degrees(45), degrees(-90)}, digits).of("the pose whose elbow bends right"));
}

//> Equal lengths
TEST_CASE("makes an equilateral triangle of two 2 m links and a hand 2 m away", "[10.2]") {
    CHECK_THAT(poses({2, 2}, {2, 0}),
               IsNear(std::vector<Pose>{{degrees(-60), degrees(120)}, {degrees(60), degrees(-120)}}, digits));
    CHECK_THAT(poses({2, 2}, {0, -2}),
               IsNear(std::vector<Pose>{{degrees(-150), degrees(120)}, {degrees(-30), degrees(-120)}}, digits));
}

//> Straight
TEST_CASE("finds one pose, a straight arm, when the hand is as far away as it gets", "[10.2]") {
    CHECK_THAT(poses({3, 5}, {8, 0}), IsNear(std::vector<Pose>{{0, 0}}, digits));
    CHECK_THAT(poses({3, 2}, {0, -5}), IsNear(std::vector<Pose>{{degrees(-90), 0}}, digits));
    CHECK_THAT(poses({3, 2}, {-3, 4}), IsNear(std::vector<Pose>{{std::acos(-3.0 / 5), 0}}, digits));
}

//> Folded
TEST_CASE("finds one pose, a folded arm, when the hand is as near as it gets", "[10.2]") {
    for (const auto &[arm, target, first] : {std::tuple{Arm{3, 2}, Vec2{1, 0}, 0.0},
                                             {Arm{3, 2}, {0, -1}, degrees(-90)},
                                             {Arm{2, 3}, {1, 0}, pi},
                                             {Arm{3, 5}, {0, 2}, degrees(-90)}}) {
        const std::vector<Pose> all = poses(arm, target);
        CHECK_THAT(all, HasSize(1).of("poses"));
        CHECK_THAT(off(all[0].first, first), IsNear(0.0, chained).of("how far the first angle is off [rad]"));
        CHECK_THAT(off(all[0].second, pi),
                   IsNear(0.0, chained).of("how far the second angle is from half a turn [rad]"));
    }
}

//> Nowhere
TEST_CASE("finds no pose when the hand can't get that far, or that near", "[10.2]") {
    for (const Vec2 &target : {Vec2{5.1, 0}, Vec2{-4, 4}, Vec2{0, 100}, Vec2{0.9, 0}, Vec2{0, -0.5}, Vec2{0, 0}})
        CHECK_THAT(poses({3, 2}, target), HasSize(0).of("poses of 3 m and 2 m"));
    CHECK_THAT(poses({2, 3}, {0, 0}), HasSize(0).of("poses of 2 m and 3 m"));
}

//> A hand at the first joint
TEST_CASE("answers {0, π} when both links are equally long and the hand is at the first joint", "[10.2]") {
    CHECK_THAT(poses({2, 2}, {0, 0}), IsNear(std::vector<Pose>{{0, pi}}, digits));
    CHECK_THAT(poses({0.7, 0.7}, {0, 0}), IsNear(std::vector<Pose>{{0, pi}}, digits));
}

//> To wherever it can reach
TEST_CASE("gets the hand to wherever it can reach, in both poses, to 1e-12 of the arm's length", "[10.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Arm any = arm(dice);
        const Vec2 target = within_reach(dice, any);
        const std::vector<Pose> all = poses(any, target);
        CHECK_THAT(all, HasSize(2).of("poses"));
        check_hands(any, all, target);
    }
}

//> On the border
TEST_CASE("gets to its outermost circle, where a rounded cosine may be more than 1", "[10.2]") {
    check_border({3, 2}, 5 * at_angle(degrees(225)), 0);
    check_border({0.1, 0.2}, {0.3, 0}, 0);
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        check_border(any, length_of(any) * at_angle(dice.real(-pi, pi)), 0);
    }
}

//> On the inner border
TEST_CASE("gets to the circle around its hole, where a rounded cosine may be less than -1", "[10.2]") {
    check_border({0.1, 0.3}, (0.3 - 0.1) * at_angle(degrees(120)), pi);
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        Arm any = arm(dice);
        if (hole_of(any) < 0.1) any.first += 0.2;
        check_border(any, hole_of(any) * at_angle(dice.real(-pi, pi)), pi);
    }
}

//> Left, then right
TEST_CASE("puts the elbow that bends left first, and the other one is its mirror image", "[10.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        const Vec2 target = within_reach(dice, any);
        const std::vector<Pose> all = poses(any, target);
        CHECK_THAT(all, HasSize(2).of("poses"));
        CHECK_THAT(all[0].second, IsAbove(0).of("second angle of the first pose [rad]"));
        CHECK_THAT(all[0].second + all[1].second, IsNear(0.0, chained).of("sum of both second angles [rad]"));
        const Vec2 left = elbow_of(any, all[0]), right = elbow_of(any, all[1]);
        CHECK_THAT((left - right).dot(target),
                   IsNear(0.0, chained).of("dot product of elbow to elbow and target [m²]"));
        CHECK_THAT(cross(target, left) + cross(target, right),
                   IsNear(0.0, chained).of("sum of the determinants of target and elbow [m²]"));
    }
}

//> Half a turn is enough
TEST_CASE("keeps both angles within half a turn", "[10.2]") {
    const auto check_angles = [](const std::vector<Pose> &all) {
        CHECK_THAT(int(all.size()), IsAtLeast(1).of("poses"));
        for (const Pose &pose : all) {
            CHECK_THAT(std::abs(pose.first), IsAtMost(pi).of("first angle without its sign [rad]"));
            CHECK_THAT(std::abs(pose.second), IsAtMost(pi).of("second angle without its sign [rad]"));
        }
    };
    for (const double y : {0.3, -0.3}) check_angles(poses({3, 2}, {-4, y})); // one elbow is across the line to the left
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        check_angles(poses(any, within_reach(dice, any)));
    }
}

//> Any pose comes back
TEST_CASE("finds any pose again from where its hand is", "[10.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        const Pose pose{dice.real(-3.1, 3.1), dice.real(0.2, 2.9) * (i % 2 == 0 ? 1 : -1)};
        const std::vector<Pose> all = poses(any, hand_of(any, pose));
        CHECK_THAT(all, HasSize(2).of("poses"));
        CHECK_THAT(all[pose.second > 0 ? 0 : 1], IsNear(pose, chained).of("the pose on that side"));
    }
}

//> Erratum E10.1
TEST_CASE("erratum E10.1: two links never have more than two poses, so nothing is underdetermined", "[10.2]") {
    for (int x = -9; x <= 9; ++x)
        for (int y = -9; y <= 9; ++y) {
            const int far = x * x + y * y, want = far < 4 || far > 64 ? 0 : far == 4 || far == 64 ? 1 : 2;
            CHECK_THAT(poses({3, 5}, Vec2(x, y)), HasSize(std::size_t(want)).of("poses"));
        }
}

//> Erratum E10.2
TEST_CASE("erratum E10.2: not every place has two poses: (10, 0) and (1, 0) have none, (8, 0) has one", "[10.2]") {
    CHECK_THAT(poses({3, 5}, {10, 0}), HasSize(0).of("poses at (10, 0)"));
    CHECK_THAT(poses({3, 5}, {1, 0}), HasSize(0).of("poses at (1, 0)"));
    CHECK_THAT(poses({3, 5}, {8, 0}), HasSize(1).of("poses at (8, 0)"));
    CHECK_THAT(poses({3, 5}, {5, 0}), HasSize(2).of("poses at (5, 0)"));
}

//>
TEST_CASE("counts a target up to 1e-12 of the arm beyond its reach as reached, but none farther", "[10.2]") {
    for (const double angle : {0.0, 1.0, -2.0}) {
        const Vec2 way = at_angle(angle);
        check_border({3, 2}, (5 + 2e-12) * way, 0);
        check_border({3, 2}, (1 - 2e-12) * way, pi);
        check_border({2, 3}, (1 - 2e-12) * way, pi);
        for (const double more : {2e-11, 1e-9, 1e-6}) {
            CHECK_THAT(poses({3, 2}, (5 + more) * way), HasSize(0).of("poses beyond the reach"));
            CHECK_THAT(poses({3, 2}, (1 - more) * way), HasSize(0).of("poses in the hole"));
        }
        for (const double less : {1e-9, 1e-6}) {
            CHECK_THAT(poses({3, 2}, (5 - less) * way), HasSize(2).of("poses just within the reach"));
            CHECK_THAT(poses({3, 2}, (1 + less) * way), HasSize(2).of("poses just outside the hole"));
            check_hands({3, 2}, poses({3, 2}, (5 - less) * way), (5 - less) * way);
            check_hands({3, 2}, poses({3, 2}, (1 + less) * way), (1 + less) * way);
        }
    }
    for (const double size : {1e-4, 1e4}) { // it's a part of the arm's length, for small arms and large ones
        check_border({3 * size, 2 * size}, {5 * size * (1 + 5e-13), 0}, 0);
        check_border({3 * size, 2 * size}, {0, size * (1 - 2e-12)}, pi);
        CHECK_THAT(poses({3 * size, 2 * size}, {5 * size * (1 + 1e-10), 0}), HasSize(0).of("poses beyond the reach"));
        CHECK_THAT(poses({3 * size, 2 * size}, {0, size * (1 - 1e-10)}), HasSize(0).of("poses in the hole"));
    }
}

TEST_CASE("takes links up to 1e5, tiny ones, unequal ones, and a hand next to the first joint", "[10.2]") {
    for (const Arm &any : {Arm{1e5, 1e5}, Arm{1e5, 3}, Arm{1e-5, 2e-5}, Arm{3e-9, 2e-9}, Arm{0.01, 100}})
        for (const double part : {0.001, 0.3, 0.999}) {
            const Vec2 target = (hole_of(any) + part * (length_of(any) - hole_of(any))) * at_angle(2 + part);
            if (std::max(std::abs(target.x()), std::abs(target.y())) > 1e5) continue;
            const std::vector<Pose> all = poses(any, target);
            CHECK_THAT(all, HasSize(2).of("poses"));
            check_hands(any, all, target, 10 * of_arm);
        }
    for (const double near : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const Vec2 target = near * at_angle(1);
        const std::vector<Pose> all = poses({2, 2}, target);
        CHECK_THAT(int(all.size()), IsAtLeast(1).of("poses"));
        check_hands({2, 2}, all, target, 1e-7);
    }
}

TEST_CASE("rejects a length that isn't positive", "[10.2]") {
    for (const double bad : {0.0, -1e-9, -3.0}) {
        CHECK_REFUSED(poses({bad, 2}, {1, 1}), "the first length isn't positive");
        CHECK_REFUSED(poses({3, bad}, {1, 1}), "the second length isn't positive");
    }
    poses({3, 2}, {3, 2}); // good input is still answered
}

// ----------------------------------------------------------------------------------------------- 10.3 nearest_reachable

//> Worked example: twice as far as it gets
TEST_CASE("stops halfway to (6, 8), which is 10 m away, with 3 m and 2 m: at (3, 4)", "[10.3]") {
    CHECK_THAT(nearest_reachable({3, 2}, {6, 8}), IsNear(Vec2{3, 4}, digits));
}

//> Too near
TEST_CASE("backs off from (0.3, 0.4), which is 0.5 m away, to the edge of the hole: (0.6, 0.8)", "[10.3]") {
    CHECK_THAT(nearest_reachable({3, 2}, {0.3, 0.4}), IsNear(Vec2{0.6, 0.8}, digits));
}

//> On the x axis
TEST_CASE("reaches (8, 0) for (10, 0), and (2, 0) for (1, 0), with 3 m and 5 m", "[10.3]") {
    CHECK_THAT(nearest_reachable({3, 5}, {10, 0}), IsNear(Vec2{8, 0}, digits));
    CHECK_THAT(nearest_reachable({3, 5}, {1, 0}), IsNear(Vec2{2, 0}, digits));
}

//> Within reach
TEST_CASE("leaves a target alone that the hand can reach", "[10.3]") {
    for (const Vec2 &target : {Vec2{3, 2}, Vec2{-1, 1}, Vec2{0, -4.9}, Vec2{5, 0}, Vec2{0, 1}})
        CHECK_THAT(nearest_reachable({3, 2}, target), IsNear(target, digits));
}

//> All directions
TEST_CASE("keeps the direction, to the left and below, too", "[10.3]") {
    CHECK_THAT(nearest_reachable({3, 2}, {-6, 8}), IsNear(Vec2{-3, 4}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {-6, -8}), IsNear(Vec2{-3, -4}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {6, -8}), IsNear(Vec2{3, -4}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {-0.3, 0.4}), IsNear(Vec2{-0.6, 0.8}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {0, -0.25}), IsNear(Vec2{0, -1}, digits));
}

//> From the first joint
TEST_CASE("goes to the right when the target is at the first joint, and that's too near", "[10.3]") {
    CHECK_THAT(nearest_reachable({3, 2}, {0, 0}), IsNear(Vec2{1, 0}, digits));
    CHECK_THAT(nearest_reachable({3, 5}, {0, 0}), IsNear(Vec2{2, 0}, digits));
}

//> No hole
TEST_CASE("gets right to the first joint when both links are equally long", "[10.3]") {
    CHECK_THAT(nearest_reachable({2, 2}, {0, 0}), IsNear(Vec2{0, 0}, digits));
    CHECK_THAT(nearest_reachable({2, 2}, {-0.01, 0.02}), IsNear(Vec2{-0.01, 0.02}, digits));
    CHECK_THAT(nearest_reachable({2, 2}, {0, 9}), IsNear(Vec2{0, 4}, digits));
}

//> The longer one second
TEST_CASE("has the same hole when the longer link comes second", "[10.3]") {
    CHECK_THAT(nearest_reachable({2, 3}, {0.3, 0.4}), IsNear(Vec2{0.6, 0.8}, digits));
    CHECK_THAT(nearest_reachable({1, 6}, {0, 3}), IsNear(Vec2{0, 5}, digits));
}

//> Within the ring
TEST_CASE("never answers a place that the hand can't reach", "[10.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        for (const Vec2 &target : {dice.point(-9, 9), Vec2{hole_of(any) * dice.point(-0.7, 0.7)}}) { // far, and near
            const double r = nearest_reachable(any, target).norm();
            CHECK_THAT(r, IsAtMost(length_of(any) + digits).of("distance from the first joint [m]"));
            CHECK_THAT(r, IsAtLeast(hole_of(any) - digits).of("distance from the first joint [m]"));
        }
    }
}

//> In line
TEST_CASE("answers a place in line with the target, on the same side of the first joint", "[10.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        const Vec2 target = dice.point(-9, 9), got = nearest_reachable(any, target);
        CHECK_THAT(cross(target, got), IsNear(0.0, chained).of("determinant of target and answer [m²]"));
        CHECK_THAT(target.dot(got), IsAtLeast(0).of("dot product of target and answer [m²]"));
    }
}

//> No place is nearer
TEST_CASE("answers a place that's nearer to the target than any other pose's hand", "[10.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const Arm any = arm(dice);
        const Vec2 target = dice.point(-9, 9);
        const double got = (nearest_reachable(any, target) - target).norm();
        for (int k = 0; k < 50; ++k) {
            const Vec2 other = hand_of(any, {dice.real(-pi, pi), dice.real(-pi, pi)});
            CHECK_THAT(got, IsAtMost((other - target).norm() + digits).of("distance from the target [m]"));
        }
    }
}

//> Once is enough
TEST_CASE("leaves its own answer alone", "[10.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Arm any = arm(dice);
        const Vec2 once = nearest_reachable(any, dice.point(-9, 9)), twice = nearest_reachable(any, once);
        CHECK_THAT(Vec2{twice - once}, IsNear(Vec2{0, 0}, digits).of("how far it moves again [m]"));
    }
}

//>
TEST_CASE("takes targets that are very far away, or very near the first joint", "[10.3]") {
    CHECK_THAT(nearest_reachable({3, 2}, {1e5, 0}), IsNear(Vec2{5, 0}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {-6e4, 8e4}), IsNear(Vec2{-3, 4}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {-3e-9, 4e-9}), IsNear(Vec2{-0.6, 0.8}, digits));
    CHECK_THAT(nearest_reachable({3, 2}, {0, -1e-100}), IsNear(Vec2{0, -1}, digits));
    CHECK_THAT(nearest_reachable({1e5, 9e4}, {0, 1e4}), IsNear(Vec2{0, 1e4}, digits));
    CHECK_THAT(nearest_reachable({3e-9, 2e-9}, {6, 8}), IsNear(Vec2{3e-9, 4e-9}, 1e-15));
}

TEST_CASE("rejects bad lengths when it looks for the nearest place", "[10.3]") {
    for (const double bad : {0.0, -1e-9, -3.0}) {
        CHECK_REFUSED(nearest_reachable({bad, 2}, {1, 1}), "the first length isn't positive");
        CHECK_REFUSED(nearest_reachable({3, bad}, {1, 1}), "the second length isn't positive");
    }
    nearest_reachable({3, 2}, {6, 8}); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------ 10.4 next_frame

namespace {

constexpr Arm picker{3, 2};
constexpr double frame_time = 1.0 / 60; // [s]

/// A pose whose hand is there, and whose elbow bends to that side, by the law of cosines.
Pose pose_at(const Arm &arm, const Vec2 &hand, double side = 1) {
    const double a = arm.first, b = arm.second, r = hand.norm();
    const double second = side * std::acos((r * r - a * a - b * b) / (2 * a * b));
    return {std::atan2(hand.y(), hand.x()) - std::atan2(b * std::sin(second), a + b * std::cos(second)), second};
}
Orchard orchard(const Vec2 &hand, std::vector<Apple> apples = {}) {
    return {pose_at(picker, hand), std::move(apples), 0, 0};
}
void check_hand(const Orchard &then, const Vec2 &want) {
    CHECK_THAT(hand_of(picker, then.pose), IsNear(want, chained).of("hand [m]"));
    CHECK_THAT(std::sin(then.pose.second), IsAtLeast(-digits).of("sine of the second angle: the elbow bends left"));
}
void check_counts(const Orchard &then, int caught, int missed, std::size_t in_the_air) {
    CHECK_THAT(then.caught, IsNear(caught).of("caught"));
    CHECK_THAT(then.missed, IsNear(missed).of("missed"));
    CHECK_THAT(then.apples, HasSize(in_the_air).of("apples in the air"));
}

} // namespace

//> Worked example: half a second's way
TEST_CASE("moves the hand 2 m in half a second, straight towards the pointer", "[10.4]") {
    check_hand(next_frame(orchard({3, 2}), {3, -3}, 0.5), {3, 0});
    check_hand(next_frame(orchard({3, 2}), {-3, 2}, 0.5), {1, 2});
    check_hand(next_frame(orchard({3, -2}), {0, 2}, 0.25), {2.4, -1.2}); // 1 m along (-3, 4) / 5
}

//> At the pointer
TEST_CASE("stops at the pointer when that's less than a frame away", "[10.4]") {
    check_hand(next_frame(orchard({3, 2}), {3, 2.1}, 0.5), {3, 2.1});
    check_hand(next_frame(orchard({3, 2}), {3, 2}, 0.5), {3, 2});
    check_hand(next_frame(orchard({-2, 2}), {-2.5, 2}, 1), {-2.5, 2});
    check_hand(next_frame({{0, 0}, {}, 0, 0}, {5, 0}, 0.5), {5, 0}); // there to the last digit
}

//> A pointer out of reach
TEST_CASE("goes straight to the nearest place when the pointer is out of reach", "[10.4]") {
    check_hand(next_frame(orchard({3, 2}), {10, 0}, 0.25), Vec2{3, 2} + Vec2{1, -1} / std::sqrt(2)); // towards (5, 0)
    check_hand(next_frame(orchard({3, 2}), {10, 0}, 1), {5, 0});
    check_hand(next_frame(orchard({3, 0}), {0.1, 0}, 0.25), {2, 0});
    check_hand(next_frame(orchard({3, 0}), {0.1, 0}, 1), {1, 0});
}

//> Around the hole
TEST_CASE("goes along the edge of its hole when the straight way leads through it", "[10.4]") {
    check_hand(next_frame(orchard({-2, 0.5}), {2, 0.5}, 0.5), {0, 1}); // (0, 0.5) is too near
    check_hand(next_frame(orchard({-2, 0.5}), {2, 0.5}, 1), {2, 0.5});
    check_hand(next_frame(orchard({0.6, -3}), {0.6, 3}, 0.75), {1, 0});   // (0.6, 0)
    const Vec2 on_its_way = Vec2{0, -4} + 4 / std::sqrt(17) * Vec2{1, 4}; // to (1, 0), but it's 2 cm too near there
    check_hand(next_frame(orchard({0, -4}), {0, 0}, 1), on_its_way.normalized());
}

//> The other elbow
TEST_CASE("bends the elbow left, even when it bent right before", "[10.4]") {
    check_hand(next_frame({pose_at(picker, {3, 2}, -1), {}, 0, 0}, {3, -3}, 0.5), {3, 0});
    check_hand(next_frame({pose_at(picker, {3, 2}, -1), {}, 0, 0}, {3, 2}, 0), {3, 2});
}

//> Worked example: an apple falls
TEST_CASE("makes an apple faster first, and then moves it: 1 m/s becomes 2 m/s, and 0.2 m in 0.1 s", "[10.4]") {
    const Orchard then = next_frame(orchard({3, 0}, {{{-4, 9}, 1}}), {3, 0}, 0.1);
    check_counts(then, 0, 0, 1);
    CHECK_THAT(then.apples[0], IsNear(Apple{{-4, 8.8}, 2}, digits).of("the apple"));
}

//> Within 0.3 m
TEST_CASE("catches an apple 0.29 m from the hand, and not one 0.31 m away", "[10.4]") {
    check_counts(next_frame(orchard({5, 0}, {{{5, 0.3}, 0}}), {5, 0}, 0), 1, 0, 0); // on the edge
    check_counts(next_frame(orchard({3, 2}, {{{3.29, 2}, 0}}), {3, 2}, 0), 1, 0, 0);
    check_counts(next_frame(orchard({3, 2}, {{{3.31, 2}, 0}}), {3, 2}, 0), 0, 0, 1);
    check_counts(next_frame(orchard({3, 2}, {{{2.8, 1.8}, 0}}), {3, 2}, 0), 1, 0, 0);   // √0.08 m away
    check_counts(next_frame(orchard({3, 2}, {{{2.75, 1.75}, 0}}), {3, 2}, 0), 0, 0, 1); // √0.125 m
    check_counts(next_frame(orchard({3, 2}, {{{3, 0}, 0}}), {3, 2}, 0), 0, 0, 1);       // the elbow doesn't catch
}

//> Where both are then
TEST_CASE("looks for apples where hand and apples are at the end of the frame", "[10.4]") {
    check_counts(next_frame(orchard({3, 2}, {{{3, 0}, 0}}), {3, -3}, 0.5), 0, 0, 1);   // it's gone down: y = -2.5
    check_counts(next_frame(orchard({3, 2}, {{{3, 2.5}, 0}}), {3, -3}, 0.5), 1, 0, 0); // both at y = 0
    check_counts(next_frame(orchard({3, 2}, {{{3, 2.1}, 4}}), {3, 2}, 0.1), 0, 0, 1);  // it falls 0.5 m: past the hand
    check_counts(next_frame(orchard({3, 2}, {{{3, 2.7}, 4}}), {3, 2}, 0.1), 1, 0, 0);  // into the hand
}

//> Missed
TEST_CASE("counts an apple as missed when it's at or below the grass, y = -3, and takes it away", "[10.4]") {
    check_counts(next_frame(orchard({3, 2}, {{{0, -3}, 0}}), {3, 2}, 0), 0, 1, 0);
    check_counts(next_frame(orchard({3, 2}, {{{0, -2.99}, 0}}), {3, 2}, 0), 0, 0, 1);
    check_counts(next_frame(orchard({3, 2}, {{{0, -2}, 20}}), {3, 2}, 0.1), 0, 1, 0);
}

//> Caught on the grass
TEST_CASE("catches an apple next to the hand, even on the grass, and doesn't count it as missed", "[10.4]") {
    check_counts(next_frame(orchard({0, -3}, {{{0.1, -3.1}, 0}}), {0, -3}, 0), 1, 0, 0);
}

//> Many apples
TEST_CASE("catches and misses several apples in one frame, and keeps the others in their order", "[10.4]") {
    const Orchard now{pose_at(picker, {3, 2}),
                      {{{-5, 5}, 1}, {{3.1, 2}, 0}, {{0, -4}, 0}, {{-4, 6}, 2}, {{2.9, 2}, 0}, {{-3, 7}, 3}},
                      7,
                      2};
    const Orchard then = next_frame(now, {3, 2}, 0);
    check_counts(then, 9, 3, 3);
    CHECK_THAT(then.apples, IsNear(std::vector<Apple>{{{-5, 5}, 1}, {{-4, 6}, 2}, {{-3, 7}, 3}}, digits).of("apples"));
}

//> Anywhere
TEST_CASE("moves the hand at 4 m/s at most, and never away from the pointer, where nothing is in the way", "[10.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Vec2 hand{dice.real(1.5, 3), dice.real(-3, 3)}, pointer{dice.real(1.5, 9), dice.real(-9, 9)};
        const double dt = dice.real(0, 0.3);
        const Vec2 then = hand_of(picker, next_frame(orchard(hand), pointer, dt).pose);
        CHECK_THAT((then - hand).norm(), IsAtMost(4 * dt + chained).of("the hand's way [m]"));
        CHECK_THAT((then - pointer).norm(),
                   IsAtMost((hand - pointer).norm() + chained).of("distance from the pointer [m]"));
    }
}

//> A game
TEST_CASE("catches an apple from 2 m above a waiting hand in frame 35, and misses another in 63", "[10.4]") {
    // after n frames of 1/60 s an apple has fallen 10 · n (n + 1) / 2 / 3600 m: 1.653 m after 34, 1.75 m after 35; so the
    // first one is 0.25 m above the hand then. The other one has 5.5 m to go: 5.425 m after 62 frames, 5.6 m after 63
    Orchard now = orchard({3, 0}, {{{3, 2}, 0}, {{-4, 2.5}, 0}});
    int caught_in = 0, missed_in = 0;
    for (int frame = 1; frame <= 120; ++frame) {
        now = next_frame(now, {3, 0}, frame_time);
        if (now.caught == 1 && caught_in == 0) caught_in = frame;
        if (now.missed == 1 && missed_in == 0) missed_in = frame;
    }
    CHECK_THAT(caught_in, IsNear(35).of("frame in which it's caught"));
    CHECK_THAT(missed_in, IsNear(63).of("frame in which it's missed"));
    check_counts(now, 1, 1, 0);
}

//>
TEST_CASE("rejects a dt that isn't from 0 to 1", "[10.4]") {
    const Orchard now = orchard({3, 2}, {{{1, 5}, 1}, {{2, 6}, 2}});
    for (const double bad : {-1e-9, 1.0001}) CHECK_REFUSED(next_frame(now, {3, 2}, bad), "dt is not from 0 to 1");
    next_frame(now, {3, 2}, 1); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------- 10.5 continued

namespace {

double change(const Pose &one, const Pose &other) {
    return std::abs(one.first - other.first) + std::abs(one.second - other.second);
}

/// How much both angles change at least, over either elbow and whole turns.
double least_change(const Arm &arm, const Pose &before, const Vec2 &target) {
    double least = infinity;
    for (const double side : {1.0, -1.0}) {
        const Pose one = pose_at(arm, target, side);
        least = std::min(least, off(one.first, before.first) + off(one.second, before.second));
    }
    return least;
}

/// Leads a hand along a path, and says how much it jumped at most in one step [rad].
double largest_change(const Arm &arm, Pose pose, const std::vector<Vec2> &path, Pose &end) {
    double largest = 0;
    for (const Vec2 &place : path) {
        const Pose then = continued(arm, pose, place);
        largest = std::max(largest, std::max(std::abs(then.first - pose.first), std::abs(then.second - pose.second)));
        pose = then;
    }
    end = pose;
    return largest;
}
std::vector<Vec2> circle(const Vec2 &centre, double radius, double from, double turns, int steps) {
    std::vector<Vec2> path;
    for (int i = 0; i <= steps; ++i) path.push_back(centre + radius * at_angle(from + turns * 2 * pi * i / steps));
    return path;
}

} // namespace

//> Worked example: either elbow
TEST_CASE("takes the first 0° and 90° from 10° and 80°, and 67.38° and -90° from 60° and -80°", "[10.5]") {
    const double up = 2 * std::asin(2 / std::sqrt(13)); // the other pose's first angle, as in 10.2
    CHECK_THAT(continued({3, 2}, {degrees(10), degrees(80)}, {3, 2}), IsNear(Pose{0, degrees(90)}, digits));
    CHECK_THAT(continued({3, 2}, {degrees(60), degrees(-80)}, {3, 2}), IsNear(Pose{up, degrees(-90)}, digits));
}

//> Turn by turn
TEST_CASE("keeps whole turns of either angle", "[10.5]") {
    CHECK_THAT(continued({3, 2}, {2 * pi, degrees(80)}, {3, 2}), IsNear(Pose{2 * pi, degrees(90)}, digits));
    CHECK_THAT(continued({3, 2}, {-6 * pi + 0.1, degrees(80)}, {3, 2}), IsNear(Pose{-6 * pi, degrees(90)}, digits));
    CHECK_THAT(continued({3, 2}, {0.1, degrees(440)}, {3, 2}), IsNear(Pose{0, degrees(450)}, digits));
    CHECK_THAT(continued({3, 2}, {0.1, degrees(-280)}, {3, 2}), IsNear(Pose{0, degrees(-270)}, digits));
}

//> From 179° to 181°
TEST_CASE("goes on from 179° to 181°, not to -179°", "[10.5]") {
    for (const double side : {1.0, -1.0}) {
        const Pose want{degrees(181), side * degrees(90)};
        CHECK_THAT(continued({3, 2}, {degrees(179), side * degrees(90)}, hand_of({3, 2}, want)), IsNear(want, digits));
        const Pose back{degrees(-181), side * degrees(90)};
        CHECK_THAT(continued({3, 2}, {degrees(-179), side * degrees(90)}, hand_of({3, 2}, back)), IsNear(back, digits));
    }
}

//> Already there
TEST_CASE("stays as it is when the hand is at the target already, with either elbow", "[10.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Arm any = arm(dice);
        const Pose before{dice.real(-9, 9), dice.real(0.2, 2.9) * (i % 2 == 0 ? 1 : -1)};
        CHECK_THAT(continued(any, before, hand_of(any, before)), IsNear(before, chained));
    }
}

//> Both angles count
TEST_CASE("counts the changes of both angles, not just of one", "[10.5]") {
    // to (3, 2): {0°, 90°} and {67.38°, -90°}
    CHECK_THAT(continued({3, 2}, {degrees(60), degrees(40)}, {3, 2}), IsNear(Pose{0, degrees(90)}, digits)); // 110, 137
    CHECK_THAT(continued({3, 2}, {degrees(10), degrees(-20)}, {3, 2}).second,
               IsNear(degrees(90), digits).of("second angle [rad]")); // 120, 127
    CHECK_THAT(continued({3, 2}, {degrees(20), degrees(-20)}, {3, 2}).second,
               IsNear(degrees(-90), digits).of("second angle [rad]")); // 130, 117
}

//> A target out of reach
TEST_CASE("goes to the nearest place the hand can reach, straight or folded", "[10.5]") {
    CHECK_THAT(continued({3, 2}, {0.5, 0.5}, {6, 8}), IsNear(Pose{std::acos(3.0 / 5), 0}, chained));
    CHECK_THAT(continued({3, 2}, {0.5, 2.5}, {0.3, 0.4}), IsNear(Pose{std::acos(3.0 / 5), pi}, chained));
    CHECK_THAT(continued({3, 2}, {0.5, -2.5}, {0.3, 0.4}), IsNear(Pose{std::acos(3.0 / 5), -pi}, chained));
    CHECK_THAT(continued({3, 2}, {-0.2, 3.0}, {0, 0}), IsNear(Pose{0, pi}, chained));
}

//> Folded at the first joint
TEST_CASE("leaves the first angle alone when equal links fold, so that the hand is at the first joint", "[10.5]") {
    CHECK_THAT(continued({2, 2}, {1, 3}, {0, 0}), IsNear(Pose{1, pi}, chained));
    CHECK_THAT(continued({2, 2}, {-2, -3}, {0, 0}), IsNear(Pose{-2, -pi}, chained));
    CHECK_THAT(continued({2, 2}, {20, 9}, {0, 0}), IsNear(Pose{20, 3 * pi}, chained));
}

//> To its target
TEST_CASE("brings the hand to its target, from any pose before", "[10.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        const Vec2 target = within_reach(dice, any);
        const Pose then = continued(any, {dice.real(-20, 20), dice.real(-20, 20)}, target);
        CHECK_THAT(Vec2{hand_of(any, then) - target}, IsNear(Vec2{0, 0}, digits).of("how far the hand is off [m]"));
    }
}

//> The least change
TEST_CASE("changes both angles together by as little as it can", "[10.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Arm any = arm(dice);
        const Pose before{dice.real(-20, 20), dice.real(-20, 20)};
        const Vec2 target = hand_of(any, {dice.real(-pi, pi), dice.real(0.1, 3)});
        CHECK_THAT(change(continued(any, before, target), before),
                   IsNear(least_change(any, before, target), chained).of("sum of both changes [rad]"));
    }
}

//> Once around
TEST_CASE("never jumps when its hand is led once around the first joint, with either elbow", "[10.5]") {
    for (const double side : {1.0, -1.0}) {
        Pose end;
        const Pose start = pose_at({3, 2}, {3, 0}, side);
        const double largest = largest_change({3, 2}, start, circle({0, 0}, 3, 0, 1, 360), end);
        CHECK_THAT(largest, IsAtMost(degrees(1) + chained).of("largest change of an angle in a step [rad]"));
        CHECK_THAT(end, IsNear(Pose{start.first + 2 * pi, start.second}, chained).of("the pose after one turn"));
    }
}

//> Ten times
TEST_CASE("winds up ten turns when its hand is led around ten times, clockwise", "[10.5]") {
    Pose end;
    const Pose start = pose_at({3, 2}, {3, 0}, -1);
    largest_change({3, 2}, start, circle({0, 0}, 3, 0, -10, 500), end);
    CHECK_THAT(end, IsNear(Pose{start.first - 20 * pi, start.second}, chained).of("the pose after ten turns"));
}

//> Elsewhere
TEST_CASE("comes back to the pose it started in when its hand is led around somewhere else", "[10.5]") {
    for (const double side : {1.0, -1.0})
        for (const Vec2 &centre : {Vec2{2.5, 1}, Vec2{-2.5, 0}, Vec2{-1, -2.8}}) {
            Pose end;
            const Pose start = pose_at({3, 2}, centre + Vec2{1, 0}, side);
            const double largest = largest_change({3, 2}, start, circle(centre, 1, 0, 1, 360), end);
            CHECK_THAT(largest, IsAtMost(0.05).of("largest change of an angle in a step [rad]"));
            CHECK_THAT(end, IsNear(start, chained).of("the pose in the end"));
        }
}

//>
TEST_CASE("rejects bad lengths when it goes on from a pose", "[10.5]") {
    for (const double bad : {0.0, -1e-9, -3.0}) {
        CHECK_REFUSED(continued({bad, 2}, {0, 1}, {1, 1}), "the first length isn't positive");
        CHECK_REFUSED(continued({3, bad}, {0, 1}, {1, 1}), "the second length isn't positive");
    }
    continued({3, 2}, {-1e5, 1e5}, {3, 2}); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------- 10.6 ccd_sweep

namespace {

double distance_to(const Vec2 &base, const std::vector<Link> &links, const Vec2 &target) {
    return (walked(base, links).back() - target).norm();
}

/// The same sweep, one joint after another: the whole arm is walked again for each, by complex numbers.
std::vector<Link> swept(const Vec2 &base, std::vector<Link> links, const Vec2 &target) {
    for (int i = int(links.size()) - 1; i >= 0; --i) {
        const std::vector<Vec2> all = walked(base, links);
        const Vec2 to_hand = all.back() - all[std::size_t(i)], to_target = target - all[std::size_t(i)];
        const std::complex<double> hand{to_hand.x(), to_hand.y()}, there{to_target.x(), to_target.y()};
        links[std::size_t(i)].angle += std::arg(there / hand);
    }
    return links;
}

} // namespace

//> Worked example: two turns
TEST_CASE("turns the last joint by 135°, then the first by 22.5°, to get from straight to (0, 1)", "[10.6]") {
    // from (1, 0) the hand is to the right and the target at 135°; then the hand is at (0.293, 0.707), at 67.5°
    CHECK_THAT(ccd_sweep({0, 0}, {{1, 0}, {1, 0}}, {0, 1}),
               IsNear(std::vector<Link>{{1, degrees(22.5)}, {1, degrees(135)}}, digits));
    CHECK_THAT(ccd_sweep({0, 0}, {{1e-4, 0}, {1e-4, 0}}, {0, 1e-4}), // so does a tenth of a millimetre
               IsNear(std::vector<Link>{{1e-4, degrees(22.5)}, {1e-4, degrees(135)}}, digits));
}

//> One link
TEST_CASE("points a single link at the target", "[10.6]") {
    CHECK_THAT(ccd_sweep({1, 2}, {{2, 0}}, {4, 6}), IsNear(std::vector<Link>{{2, std::acos(3.0 / 5)}}, digits));
    CHECK_THAT(ccd_sweep({1, 2}, {{2, 0}}, {-2, -2}), IsNear(std::vector<Link>{{2, -std::acos(-3.0 / 5)}}, digits));
}

//> One turn will do
TEST_CASE("leaves the first joint alone when the last one gets the hand to the target", "[10.6]") {
    CHECK_THAT(ccd_sweep({0, 0}, {{1, 0}, {1, 0}}, {1, 1}),
               IsNear(std::vector<Link>{{1, 0}, {1, degrees(90)}}, chained));
}

//> In line already
TEST_CASE("changes nothing when a straight arm points at the target already", "[10.6]") {
    const std::vector<Link> straight{{2, std::acos(3.0 / 5)}, {1, 0}, {1, 0}};
    CHECK_THAT(ccd_sweep({0, 0}, straight, {3, 4}), IsNear(straight, chained));
    CHECK_THAT(ccd_sweep({0, 0}, straight, {6, 8}), IsNear(straight, chained));
}

//> No link
TEST_CASE("returns an empty arm for an arm without links", "[10.6]") {
    CHECK_THAT(ccd_sweep({1, 2}, {}, {4, 6}), HasSize(0).of("links"));
}

//> The shorter way
TEST_CASE("turns by 20° from 170° to 190°, not by 340° the other way", "[10.6]") {
    const Vec2 behind = at_angle(degrees(190)), above = at_angle(degrees(170));
    CHECK_THAT(ccd_sweep({0, 0}, {{1, degrees(170)}}, behind), IsNear(std::vector<Link>{{1, degrees(190)}}, digits));
    CHECK_THAT(ccd_sweep({0, 0}, {{1, degrees(-170)}}, above), IsNear(std::vector<Link>{{1, degrees(-190)}}, digits));
    CHECK_THAT(ccd_sweep({0, 0}, {{1, degrees(350)}}, {3, 0}), IsNear(std::vector<Link>{{1, degrees(360)}}, digits));
}

//> Nothing to turn
TEST_CASE("leaves a joint alone that has the hand or the target on it", "[10.6]") {
    CHECK_THAT(ccd_sweep({0, 0}, {{1, 0}, {0, 0.5}}, {0, 2}), // the last link has no length
               IsNear(std::vector<Link>{{1, degrees(90)}, {0, 0.5}}, digits));
    const std::vector<Link> at_the_elbow = ccd_sweep({0, 0}, {{1, 0}, {1, 1}}, {1, 0});
    CHECK_THAT(at_the_elbow, HasSize(2).of("links"));
    CHECK_THAT(at_the_elbow.back(), IsNear(Link{1, 1}, digits).of("the last link"));
    CHECK_THAT(ccd_sweep({0, 0}, {{1, 0.3}, {1, pi}}, {0, 0}), // the hand is there, at the first joint
               IsNear(std::vector<Link>{{1, 0.3}, {1, pi}}, digits));
    for (const auto &[height, angle] : {std::pair{5e-10, 0.0}, {1e-7, degrees(90)}}) // on it is 1e-9 m from it
        CHECK_THAT(ccd_sweep({0, 0}, {{1, 0}}, {0, height}), IsNear(std::vector<Link>{{1, angle}}, digits));
}

//> By complex numbers
TEST_CASE("agrees with joints worked out anew after each turn", "[10.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Vec2 base = dice.point(-5, 5), target = dice.point(-5, 5);
        const std::vector<Link> links = chain(dice, dice.whole(1, 12));
        const std::vector<Link> got = ccd_sweep(base, links, target), want = swept(base, links, target);
        CHECK_THAT(got, HasSize(links.size()).of("links"));
        CHECK_THAT(Vec2{walked(base, got).back() - walked(base, want).back()},
                   IsNear(Vec2{0, 0}, chained).of("difference of the hands [m]"));
    }
}

//> Never farther
TEST_CASE("never gets the hand farther away from the target, whatever the arm", "[10.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 base = dice.point(-5, 5), target = dice.point(-9, 9);
        const std::vector<Link> links = chain(dice, dice.whole(1, 12));
        CHECK_THAT(distance_to(base, ccd_sweep(base, links, target), target),
                   IsAtMost(distance_to(base, links, target) + digits).of("distance from the target [m]"));
    }
}

//> In line in the end
TEST_CASE("ends with hand and target in line, as seen from the first joint", "[10.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Vec2 base = dice.point(-5, 5), target = dice.point(-9, 9);
        const Vec2 way = walked(base, ccd_sweep(base, chain(dice, dice.whole(1, 8)), target)).back() - base;
        CHECK_THAT(cross(way, target - base),
                   IsNear(0.0, chained).of("determinant of the ways to hand and target [m²]"));
        CHECK_THAT(way.dot(target - base), IsAtLeast(-chained).of("dot product of the ways to hand and target [m²]"));
    }
}

//> At most half a turn
TEST_CASE("keeps all lengths, and turns each joint by at most half a turn", "[10.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        std::vector<Link> links = chain(dice, dice.whole(1, 8));
        links[0].angle += 8 * pi;
        const std::vector<Link> got = ccd_sweep({0, 0}, links, dice.point(-9, 9));
        CHECK_THAT(got, HasSize(links.size()).of("links"));
        for (std::size_t k = 0; k < links.size(); ++k) {
            CHECK_THAT(got[k].length, IsNear(links[k].length).of("length of a link [m]"));
            CHECK_THAT(std::abs(got[k].angle - links[k].angle), IsAtMost(pi + digits).of("a joint's turn [rad]"));
        }
    }
}

//> Seen from elsewhere
TEST_CASE("makes the same turns when base and target move together", "[10.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const std::vector<Link> links = chain(dice, 4);
        const Vec2 target = dice.point(-9, 9), by = dice.point(-9, 9);
        const std::vector<Link> here = ccd_sweep({0, 0}, links, target), there = ccd_sweep(by, links, target + by);
        CHECK_THAT(here, HasSize(4).of("links"));
        CHECK_THAT(there, HasSize(4).of("links"));
        for (std::size_t k = 0; k < 4; ++k)
            CHECK_THAT(off(here[k].angle, there[k].angle), IsNear(0.0, chained).of("difference of the angles [rad]"));
    }
}

//> A tentacle
TEST_CASE("gets a tentacle of twelve links within 1 mm of its target in twenty sweeps", "[10.6]") {
    for (const Vec2 &target : {Vec2{2, 1}, Vec2{1, 0}, Vec2{4, 0}}) {
        std::vector<Link> links(12, Link{0.35, 0.05});
        for (int i = 0; i < 20; ++i) links = ccd_sweep({0, 0}, links, target);
        CHECK_THAT(distance_to({0, 0}, links, target), IsAtMost(1e-3).of("distance from the target [m]"));
    }
}

//>
TEST_CASE("rejects any negative length before a sweep", "[10.6]") {
    for (const double bad : {-1e-9, -3.0}) {
        CHECK_REFUSED(ccd_sweep({0, 0}, {{bad, 1}, {5, 1}}, {1, 1}), "the first length is negative");
        CHECK_REFUSED(ccd_sweep({0, 0}, {{3, 1}, {bad, 1}}, {1, 1}), "the last length is negative");
    }
    ccd_sweep({0, 0}, {{3, 0.5}, {5, 1}}, {4, 6}); // good input is still answered
}

// ----------------------------------------------------------------------------------------------------- 10.7 damped_step

namespace {

std::vector<Limits> free_joints(std::size_t count) { return std::vector<Limits>(count, Limits{-1e5, 1e5}); }

/// A step without limits, far above the ground.
std::vector<Link> free_step(const Vec2 &base, const std::vector<Link> &links, const Vec2 &target, double damping) {
    return damped_step(base, links, free_joints(links.size()), target, damping);
}
const Vec2 high{0, 100}; // where a base has no ground to fear

/// For each link, how the hand moves while its angle grows.
std::vector<Vec2> columns(const std::vector<Link> &links) {
    std::vector<Vec2> all = walked({0, 0}, links);
    const Vec2 hand = all.back();
    all.pop_back();
    for (Vec2 &each : all) each = {-(hand - each).y(), (hand - each).x()};
    return all;
}
std::vector<double> turns(const std::vector<Link> &before, const std::vector<Link> &after) {
    CHECK_THAT(after, HasSize(before.size()).of("links"));
    std::vector<double> all;
    for (std::size_t i = 0; i < before.size(); ++i) all.push_back(after[i].angle - before[i].angle);
    return all;
}
double lowest(const Vec2 &base, const std::vector<Link> &links) {
    double y = infinity;
    for (const Vec2 &each : walked(base, links)) y = std::min(y, each.y());
    return y;
}

} // namespace

//> Worked example: one link
TEST_CASE("turns a 1 m link by 0.5 rad towards a target 1 m above its hand, with a damping of 1 m", "[10.7]") {
    // J is (0, 1), so J J^T + 1 is 1 along x and 2 along y: the way (0, 1) is halved
    CHECK_THAT(free_step({0, 9}, {{1, 0}}, {1, 10}, 1), IsNear(std::vector<Link>{{1, 0.5}}, digits));
}

//> Worked example: two links
TEST_CASE("turns the 3 m and 2 m arm by -1/27 and -10/27 rad for a target 1 m to the right of its hand", "[10.7]") {
    // the columns are (-2, 3) and (-2, 0), so J J^T + 1 is (9, -6; -6, 10), and its inverse times (1, 0) is (10, 6) / 54
    CHECK_THAT(free_step({0, 9}, {{3, 0}, {2, degrees(90)}}, {4, 11}, 1),
               IsNear(std::vector<Link>{{3, -1.0 / 27}, {2, degrees(90) - 10.0 / 27}}, digits));
    // and for a target at (2.8, 2.3) of its base, the inverse times (-0.2, 0.3) is (-0.2, 1.5) / 54
    CHECK_THAT(free_step({0, 9}, {{3, 0}, {2, degrees(90)}}, {2.8, 11.3}, 1),
               IsNear(std::vector<Link>{{3, 4.9 / 54}, {2, degrees(90) + 0.4 / 54}}, digits));
}

//> Arrived
TEST_CASE("changes nothing when the hand is at the target already", "[10.7]") {
    CHECK_THAT(free_step({0, 9}, {{3, 0}, {2, degrees(90)}}, {3, 11}, 0.5),
               IsNear(std::vector<Link>{{3, 0}, {2, degrees(90)}}, digits));
}

//> A straight arm
TEST_CASE("stays put, and finite, when a straight arm points at its target", "[10.7]") {
    for (const double angle : {0.0, 0.5, degrees(30), degrees(90), 2.0})
        for (const double far : {2.0, 7.0})
            for (const double damping : {1.0, 0.01, 1e-6}) {
                const std::vector<Link> links{{3, angle}, {2, 0}};
                const std::vector<Link> got = free_step(high, links, high + far * at_angle(angle), damping);
                for (const double turn : turns(links, got))
                    CHECK_THAT(std::abs(turn), IsAtMost(damping < 0.001 ? 0.1 : 1e-8).of("a joint's turn [rad]"));
            }
}

//> Beside a straight arm
TEST_CASE("turns a straight arm gently towards a target beside it", "[10.7]") {
    // the columns are (0, 5) and (0, 2), so J J^T is 29 along y; a step of 1 m along y is 1 / (29 + damping²) times 5 and 2
    for (const double damping : {0.1, 1.0, 10.0}) {
        const double part = 1 / (29 + damping * damping);
        CHECK_THAT(free_step({0, 9}, {{3, 0}, {2, 0}}, {5, 10}, damping),
                   IsNear(std::vector<Link>{{3, 5 * part}, {2, 2 * part}}, digits));
    }
}

//> The other way to write it
TEST_CASE("solves (JᵀJ + damping²) Δ = Jᵀ (target - hand), the same step seen from the joints", "[10.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const std::vector<Link> links = chain(dice, dice.whole(1, 8));
        const double damping = dice.real(0.1, 3);
        const Vec2 way = dice.point(-3, 3);
        const std::vector<double> got = turns(links, free_step(high, links, walked(high, links).back() + way, damping));
        const std::vector<Vec2> all = columns(links);
        Vec2 moved{0, 0}; // J Δ
        for (std::size_t k = 0; k < links.size(); ++k) moved += got[k] * all[k];
        for (std::size_t k = 0; k < links.size(); ++k)
            CHECK_THAT(all[k].dot(moved) + damping * damping * got[k] - all[k].dot(way),
                       IsNear(0.0, chained).of("difference of both sides [m²]"));
    }
}

//> More damping
TEST_CASE("takes smaller steps with more damping", "[10.7]") {
    // a hair from straight, and 0.5 m too far out: hardly damped, the elbow would turn more than six times around
    const std::vector<Link> stretched{{3, 0}, {2, 0.01}};
    CHECK_THAT(std::abs(turns(stretched, free_step({0, 9}, stretched, {4.5, 9}, 1e-6))[1]),
               IsNear(degrees(2387), 0.01).of("the elbow's turn, damped by 1e-6 m [rad]"));
    CHECK_THAT(std::abs(turns(stretched, free_step({0, 9}, stretched, {4.5, 9}, 0.5))[1]),
               IsNear(degrees(1.12), 1e-4).of("the elbow's turn, damped by 0.5 m [rad]"));
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        const std::vector<Link> links = chain(dice, dice.whole(2, 8));
        const Vec2 target = walked(high, links).back() + dice.point(-3, 3);
        double before = infinity;
        for (const double damping : {0.1, 0.3, 1.0, 3.0, 10.0}) {
            double size = 0;
            for (const double turn : turns(links, free_step(high, links, target, damping))) size += turn * turn;
            CHECK_THAT(size, IsAtMost(before + chained).of("sum of the squares of all turns [rad²]"));
            before = size;
        }
    }
}

//> Little damping
TEST_CASE("gets to a target within a few steps when there's little damping", "[10.7]") {
    std::vector<Link> links{{3, 0.3}, {2, 1.2}};
    for (int i = 0; i < 12; ++i) links = free_step({0, 9}, links, {2, 12}, 0.01);
    CHECK_THAT(distance_to({0, 9}, links, {2, 12}), IsAtMost(1e-6).of("distance from the target [m]"));
}

//> Each joint's own limits
TEST_CASE("stops each joint at its own limit", "[10.7]") {
    // without limits the step is -1/27 and -10/27, as in the worked example
    const std::vector<Link> links{{3, 0}, {2, degrees(90)}};
    CHECK_THAT(damped_step({0, 9}, links, {{-0.02, 1}, {0, 2}}, {4, 11}, 1),
               IsNear(std::vector<Link>{{3, -0.02}, {2, degrees(90) - 10.0 / 27}}, digits));
    CHECK_THAT(damped_step({0, 9}, links, {{-1, 1}, {1.5, 2}}, {4, 11}, 1),
               IsNear(std::vector<Link>{{3, -1.0 / 27}, {2, 1.5}}, digits));
    CHECK_THAT(damped_step({0, 9}, links, {{-1, 1}, {0, 1.1}}, {4, 11}, 1), // upwards, too
               IsNear(std::vector<Link>{{3, -1.0 / 27}, {2, 1.1}}, digits));
}

//> Outside its limits
TEST_CASE("brings an angle into its limits even when the hand is at the target", "[10.7]") {
    CHECK_THAT(damped_step({0, 9}, {{3, 0}, {2, degrees(90)}}, {{0.5, 1}, {0, 1}}, {3, 11}, 1),
               IsNear(std::vector<Link>{{3, 0.5}, {2, 1}}, digits));
}

//> Half a step
TEST_CASE("takes half a step, or a quarter, when a whole one would lead below the ground", "[10.7]") {
    // one 5 m link at 0.3 rad, and a target 5 m below its hand along its circle: a step of 25 / (25 + 0.25) rad, clockwise
    const Vec2 hand = Vec2{0, 1} + 5 * at_angle(0.3), target = hand + 5 * Vec2{std::sin(0.3), -std::cos(0.3)};
    const double whole = 25 / 25.25;
    // from 1 m above the ground it gets to -0.2014 rad, asin 1/5: so half a step, to -0.195, is as far as it goes
    CHECK_THAT(free_step({0, 1}, {{5, 0.3}}, target, 0.5), IsNear(std::vector<Link>{{5, 0.3 - whole / 2}}, digits));
    // so it does where a limit would have stopped the whole step at -0.3 rad: that's in the ground, too
    CHECK_THAT(damped_step({0, 1}, {{5, 0.3}}, {{-0.3, 1}}, target, 0.5),
               IsNear(std::vector<Link>{{5, 0.3 - whole / 2}}, digits));
    // and from the ground itself it takes a quarter
    CHECK_THAT(free_step({0, 0}, {{5, 0.3}}, target - Vec2{0, 1}, 0.5),
               IsNear(std::vector<Link>{{5, 0.3 - whole / 4}}, digits));
}

//> No step
TEST_CASE("stays as it is when even a 1024th of the step would lead below the ground", "[10.7]") {
    CHECK_THAT(free_step({0, 0}, {{5, 0}}, {5, -3}, 0.5), IsNear(std::vector<Link>{{5, 0}}, digits));
    CHECK_THAT(free_step({0, -1}, {{5, 1}}, {4, 4}, 0.5),
               IsNear(std::vector<Link>{{5, 1}}, digits));           // where its base is
    CHECK_THAT(damped_step({0, -1}, {{1, 2}}, {{-1, 1}}, {0, 3}, 1), // even if that's beyond its limits
               IsNear(std::vector<Link>{{1, 2}}, digits));
    CHECK_THAT(free_step({0, -5e-7}, {{1, 1}}, {0, 3}, 1), IsNear(std::vector<Link>{{1, 1}}, digits)); // a hair deep
    // 3 m down along its circle: the step is 5 · 3 / 25.25 rad, and a 1024th of it is 0.58e-3 rad: from 1e-3 rad that
    // fits, from 0.4e-3 rad it doesn't, though half of that would
    const double step = 5 * 3 / 25.25;
    for (const double angle : {1e-3, 4e-4}) {
        const Vec2 target = 5 * at_angle(angle) - 3 * Vec2{-std::sin(angle), std::cos(angle)};
        const double want = angle == 1e-3 ? angle - step / 1024 : angle;
        CHECK_THAT(free_step({0, 0}, {{5, angle}}, target, 0.5), IsNear(std::vector<Link>{{5, want}}, digits));
    }
}

//> The elbow, too
TEST_CASE("keeps the elbow above the ground, even when the hand stays high", "[10.7]") {
    const std::vector<Link> links{{2, 0.2}, {3, degrees(70)}};
    const Vec2 target{1, 0.6};
    const std::vector<double> whole = turns(links, free_step(high, links, high + target, 0.5));
    std::vector<Link> half = links;
    for (double part = 1; lowest({0, 0}, half) < 0 || part == 1; part /= 2) {
        half = links;
        half[0].angle += part * whole[0], half[1].angle += part * whole[1];
    }
    CHECK_THAT(whole[0], IsBelow(-0.2).of("the whole step of the first joint: the elbow would be in the ground [rad]"));
    CHECK_THAT(free_step({0, 0}, links, target, 0.5), IsNear(half, chained));
}

//> Always above
TEST_CASE("never leads an arm below the ground or out of its limits, step after step", "[10.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(100); ++i) {
        std::vector<Link> links(4, Link{1, 0.4});
        const std::vector<Limits> limits{{-0.2, 3}, {-2, 2}, {-1, 1}, {0, 1}};
        const Vec2 base{0, 0.5}, target = dice.point(-5, 5);
        for (int step = 0; step < 20; ++step) {
            links = damped_step(base, links, limits, target, 0.3);
            CHECK_THAT(links, HasSize(4).of("links"));
            CHECK_THAT(lowest(base, links), IsAtLeast(-1e-8).of("height of the lowest joint [m]"));
            for (std::size_t k = 0; k < 4; ++k) {
                CHECK_THAT(links[k].angle, IsAtLeast(limits[k].low - digits).of("an angle [rad]"));
                CHECK_THAT(links[k].angle, IsAtMost(limits[k].high + digits).of("an angle [rad]"));
            }
        }
    }
}

//>
TEST_CASE("takes an arm without links, and one of a hundred", "[10.7]") {
    CHECK_THAT(damped_step({0, 9}, {}, {}, {4, 11}, 1), HasSize(0).of("links"));
    const std::vector<Link> many(100, Link{0.05, 0.01});
    const Vec2 target = walked({0, 9}, many).back() + Vec2{-0.3, 0.2};
    const std::vector<Link> got = free_step({0, 9}, many, target, 1);
    CHECK_THAT(got, HasSize(100).of("links"));
    CHECK_THAT(distance_to({0, 9}, got, target), IsBelow(0.1).of("distance from the target [m]")); // of 0.36
}

TEST_CASE("rejects limits that don't fit the links, too little damping, and bad lengths", "[10.7]") {
    const std::vector<Link> links{{3, 0.5}, {2, 1}};
    const std::vector<Limits> limits{{-1, 2}, {-2, 3}};
    CHECK_REFUSED(damped_step({0, 9}, links, {{-1, 2}}, {4, 11}, 1), "one limit for two links");
    CHECK_REFUSED(damped_step({0, 9}, links, {{-1, 2}, {-1, 2}, {-1, 2}}, {4, 11}, 1), "three limits for two links");
    CHECK_REFUSED(damped_step({0, 9}, links, {{-1, 2}, {3, 2}}, {4, 11}, 1), "a lower limit above its upper one");
    for (const double bad : {0.0, -1.0, 0.9e-6}) CHECK_REFUSED(damped_step({0, 9}, links, limits, {4, 11}, bad));
    for (const double bad : {-1e-9, -3.0}) {
        CHECK_REFUSED(damped_step({0, 9}, {{bad, 0.5}, {2, 1}}, limits, {4, 11}, 1), "the first length is negative");
        CHECK_REFUSED(damped_step({0, 9}, {{3, 0.5}, {bad, 1}}, limits, {4, 11}, 1), "the second length is negative");
    }
    damped_step({0, 9}, links, limits, {4, 11}, 1); // good input is still answered
}

// ----------------------------------------------------------------------------------------------------------- 10.8 write

namespace {

using Path = std::vector<Vec2>;

double part_of(const Vec2 &from, const Vec2 &to, const Vec2 &point) {
    const Vec2 along = to - from;
    return along.squaredNorm() == 0 ? 0 : std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
}
double distance_from_stroke(const Vec2 &from, const Vec2 &to, const Vec2 &point) {
    return (from + part_of(from, to, point) * (to - from) - point).norm();
}
double distance_from_path(const Path &path, const Vec2 &point) {
    double least = (path.front() - point).norm();
    for (std::size_t i = 1; i < path.size(); ++i)
        least = std::min(least, distance_from_stroke(path[i - 1], path[i], point));
    return least;
}

/// Follows the hands along the path, stroke by stroke.
class Reader {
  public:
    explicit Reader(const Path &path_) : path{path_} {}

    void read(const Vec2 &hand, const std::string &which) {
        const std::size_t from = next == 0 ? 0 : next - 1, to = std::min(next, path.size() - 1);
        const double there = distance_from_stroke(path[from], path[to], hand);
        CHECK_THAT(there, IsAtMost(1e-6 + digits).of("distance from the next stroke" + which + " [m]"));
        const double now = part_of(path[from], path[to], hand) * (path[to] - path[from]).norm();
        CHECK_THAT(now, IsAtLeast(along - 2e-6).of("way along the stroke, not backwards" + which + " [m]"));
        along = std::max(along, now);
        while (next < path.size() && (hand - path[next]).norm() <= 1e-6 + digits) ++next, along = 0;
    }
    std::size_t corners() const { return next; } // that the hand has visited

  private:
    const Path &path;
    std::size_t next = 0;
    double along = 0;
};

/// All that `write` promises.
void check_writing(const Arm &arm, const Pose &start, const Path &path) {
    const std::vector<Pose> all = inverse_kinematics::subject::write(arm, start, path);
    CHECK_THAT(int(all.size()), IsAtLeast(1).of("poses"));
    CHECK_THAT(int(all.size()), IsAtMost(1000).of("poses"));
    CHECK_THAT(all.front(), IsNear(start, digits).of("the first pose"));
    Reader reader{path};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string which = ", in pose " + std::to_string(i) + " of " + std::to_string(all.size());
        const Pose before = all[i == 0 ? 0 : i - 1];
        const double turn = std::max(std::abs(all[i].first - before.first), std::abs(all[i].second - before.second));
        CHECK_THAT(turn, IsAtMost(0.1 + digits).of("largest change of an angle" + which + " [rad]"));
        reader.read(hand_of(arm, all[i]), which);
        const Pose halfway{(all[i].first + before.first) / 2, (all[i].second + before.second) / 2};
        CHECK_THAT(
            distance_from_path(path, hand_of(arm, halfway)),
            IsAtMost(0.002 + digits).of("distance from the path, halfway from the pose before" + which + " [m]"));
    }
    CHECK_THAT(int(reader.corners()), IsNear(int(path.size())).of("corners that the hand has visited"));
    CHECK_THAT((hand_of(arm, all.back()) - path.back()).norm(),
               IsAtMost(1e-6 + digits).of("distance from the last corner, in the end [m]"));
}
void check_both_elbows(const Arm &arm, const Path &path) {
    for (const double side : {1.0, -1.0}) check_writing(arm, pose_at(arm, path.front(), side), path);
}
Path moved(Path path, double size, const Vec2 &by) {
    for (Vec2 &each : path) each = size * each + by;
    return path;
}
const Path letter_l{{0, 2}, {0, 0}, {1, 0}};
const Path letter_f{{0, 0}, {0, 2}, {1, 2}, {0, 2}, {0, 1}, {0.75, 1}}; // back along its upper arm
const Path letter_w{{0, 2}, {0.5, 0}, {1, 1.5}, {1.5, 0}, {2, 2}};

} // namespace

//> One stroke
TEST_CASE("draws one straight stroke, with either elbow", "[10.8]") {
    check_both_elbows({3, 2}, {{3, -1}, {3, 2}});
    check_both_elbows({3, 2}, {{-3, 1}, {3, 2.5}});
    check_both_elbows({2, 3}, {{1.5, 0}, {4.5, 0}}); // straight away from the first joint
}

//> Letters
TEST_CASE("draws an L, an F and a W", "[10.8]") {
    for (const Path &letter : {letter_l, letter_f, letter_w}) check_both_elbows({3, 2}, moved(letter, 1, {1.5, 0.5}));
}

//> Corners
TEST_CASE("goes into every corner, and back along the same stroke", "[10.8]") {
    check_both_elbows({3, 2}, {{2, 0}, {4, 0}, {2, 0}, {4, 0}, {3, 1}});
    check_both_elbows({3, 2}, {{2, 1}, {2, 3}, {2, 1}});
}

//> Nothing to draw
TEST_CASE("draws a dot, and a corner that's there twice", "[10.8]") {
    check_both_elbows({3, 2}, {{3, 2}});
    check_both_elbows({3, 2}, {{3, 2}, {3, 2}});
    check_both_elbows({3, 2}, {{3, 2}, {3, 0}, {3, 0}, {2, 0}});
}

//> Around the first joint
TEST_CASE("draws a square around the first joint, so that its first angle winds up a whole turn", "[10.8]") {
    check_both_elbows({3, 2}, {{3, 0}, {3, 3}, {-3, 3}, {-3, -3}, {3, -3}, {3, 0}});
    check_both_elbows({3, 2}, {{3, 0}, {3, -3}, {-3, -3}, {-3, 3}, {3, 3}, {3, 0}});
}

//> Past half a turn
TEST_CASE("crosses the line to the left of the first joint, where angles jump from π to -π", "[10.8]") {
    check_both_elbows({3, 2}, {{-3, 1}, {-3, -1}, {-2, 1}, {-4, 0}});
    check_both_elbows({1, 4}, {{-4, 1}, {-4, -1}});
}

//> A start with whole turns
TEST_CASE("starts from angles with whole turns in them", "[10.8]") {
    const Path path = moved(letter_l, 1, {1.5, 0.5});
    const Pose start = pose_at({3, 2}, path.front());
    check_writing({3, 2}, {start.first + 6 * pi, start.second - 4 * pi}, path);
    check_writing({3, 2}, {start.first - 2 * pi, start.second + 2 * pi}, path);
}

//> Near the borders
TEST_CASE("draws 0.1 m from where its reach ends, outside and inside", "[10.8]") {
    check_both_elbows({3, 2}, {{1.1, -2}, {1.1, 2}});
    check_both_elbows({3, 2}, {{-2.9, 3.9}, {0, 4.9}, {2.9, 3.9}});
    check_both_elbows({2, 2}, {{0.1, -1}, {0.1, 1}}); // past the first joint, which whips around
}

//> A page
TEST_CASE("draws a page of forty short strokes and a long one past the first joint in no more than 1000 poses",
          "[10.8]") {
    Path page{{0.1, -1}, {0.1, 1}};
    for (int i = 1; i <= 40; ++i) page.push_back({0.1 + 0.05 * i, i % 2 == 0 ? 1.0 : 1.2});
    check_both_elbows({2, 2}, page);
}

//> Small and large
TEST_CASE("draws small letters with a small arm, and large ones with a large arm", "[10.8]") {
    check_both_elbows({0.5, 0.3}, moved(letter_f, 0.1, {0.4, 0.1}));
    check_both_elbows({6, 7}, moved(letter_w, 3, {2, 3}));
}

//> Any arm, any path
TEST_CASE("draws any path with any arm", "[10.8]") {
    Dice dice;
    for (int i = 0; i < course::cases(100); ++i) {
        const Arm any{dice.real(0.5, 3), dice.real(0.5, 3)};
        const double in = hole_of(any) + 0.11, out = length_of(any) - 0.11;
        const auto corner = [&] { return Vec2{dice.real(in, out) * at_angle(dice.real(-pi, pi))}; };
        Path path{corner()};
        while (path.size() < 5) {
            const Vec2 next = corner();
            if (distance_from_stroke(path.back(), next, {0, 0}) > in) path.push_back(next);
            else path.push_back(path.back() * 0.5 + path.back().normalized() * in * 0.5); // straight in
        }
        check_writing(any, pose_at(any, path.front(), dice.sign()), path);
    }
}

//>
TEST_CASE("rejects a path without corners or too near a border, a start elsewhere, and bad lengths", "[10.8]") {
    using inverse_kinematics::subject::write;
    const Pose start = pose_at({3, 2}, {3, 0});
    CHECK_REFUSED(write({3, 2}, start, {}), "no corner");
    CHECK_REFUSED(write({3, 2}, start, {{3, 0.001}, {3, 2}}), "the hand is a millimetre off");
    CHECK_REFUSED(write({3, 2}, start, {{3, 0}, {4.95, 0}}), "a corner is too far out");
    CHECK_REFUSED(write({3, 2}, start, {{3, 0}, {1.05, 0}}), "a corner is too near");
    CHECK_REFUSED(write({3, 2}, start, {{3, 0}, {-3, 0.5}}), "a stroke leads through the hole");
    for (const double bad : {0.0, -3.0}) {
        CHECK_REFUSED(write({bad, 2}, start, {{3, 0}}), "the first length isn't positive");
        CHECK_REFUSED(write({3, bad}, start, {{3, 0}}), "the second length isn't positive");
    }
    write({3, 2}, start, {{3, 0}, {3, 1}}); // good input is still answered
}
