// needs orocos_kdl orocos_kdl::orocos_kdl liborocos-kdl-dev
// needs Boost Boost::headers libboost-dev
// KDL is what robots calculate their arms with: it solves by steps, from a pose nearby, and takes damped steps, too. Boost
// finds the turn that brings a hand in line with its target by a search for a root.
#include "../peers/peer.hpp"
#include "../peers/kdl.hpp"
#include "inverse_kinematics.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/version.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolvervel_wdls.hpp>
#include <kdl/config.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

using course::Robot, course::Vec2, course::worse;
using namespace inverse_kinematics;

namespace {

constexpr int cases = 20000; // in each comparison, or a hundredth of them with a search
constexpr double pi = std::numbers::pi;

/// Brings the hand to a place, from the angles as they are, by Levenberg and Marquardt's method.
void bring_to(Robot &robot, const Vec2 &place) {
    Eigen::Matrix<double, 6, 1> weights;
    weights << 1, 1, 0, 0, 0, 0; // where it is, not how it's turned
    KDL::ChainIkSolverPos_LMA solver{robot.chain, weights, 1e-14, 500, 1e-15};
    const KDL::JntArray before = robot.angles;
    solver.CartToJnt(before, KDL::Frame{KDL::Vector{place.x(), place.y(), 0}}, robot.angles);
}

Robot robot_of(const Arm &arm, const Pose &pose) { return Robot{{{arm.first, pose.first}, {arm.second, pose.second}}}; }

Arm arm(Dice &dice) { return {dice.real(0.2, 3), dice.real(0.2, 3)}; }
double far_border(const Arm &arm) { return arm.first + arm.second; }
double near_border(const Arm &arm) { return std::abs(arm.first - arm.second); }

/// How far KDL's hand is from the target in the worse of the poses, by the arm's length.
double miss(const Arm &arm, const Vec2 &target) {
    const std::vector<Pose> all = poses(arm, target);
    if (all.empty()) return INFINITY;
    double largest = 0;
    for (const Pose &pose : all)
        largest = worse((robot_of(arm, pose).hand() - target).norm() / far_border(arm), largest);
    return largest;
}

double compare_hands(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Arm any = arm(dice);
        largest = worse(miss(any, dice.real(near_border(any), far_border(any)) * dice.direction()), largest);
    }
    return largest;
}

double compare_borders(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Arm any = arm(dice);
        const double out = far_border(any), in = near_border(any), hair = std::pow(10, dice.real(-17, -1));
        for (const double r : {out, in, out * (1 - hair), in + out * hair})
            if (r >= in && r <= out) largest = worse(miss(any, r * dice.direction()), largest);
    }
    return largest;
}

double compare_equal_lengths(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double length = dice.real(0.2, 3);
        largest =
            worse(miss({length, length}, 2 * length * std::pow(10, dice.real(-18, 0)) * dice.direction()), largest);
        largest = worse(miss({length, length}, {0, 0}), largest);
    }
    return largest;
}

/// A pose that is neither straight nor folded, on either side.
Pose bent(Dice &dice) { return {dice.real(-3, 3), dice.sign() * dice.real(0.3, 2.8)}; }

double compare_solved(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const Arm any = arm(dice);
        const Pose pose = bent(dice);
        const Vec2 target = robot_of(any, pose).hand();
        Robot near = robot_of(any, {pose.first + dice.real(-0.1, 0.1), pose.second + dice.real(-0.1, 0.1)});
        bring_to(near, target);
        const Pose ours = poses(any, target)[pose.second > 0 ? 0 : 1];
        largest = worse(std::abs(std::remainder(ours.first - near.angles(0), 2 * pi)), largest);
        largest = worse(std::abs(std::remainder(ours.second - near.angles(1), 2 * pi)), largest);
    }
    return largest;
}

double compare_led(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const Arm any = arm(dice);
        Pose pose = bent(dice);
        Robot robot = robot_of(any, pose);
        const Vec2 start = robot.hand();
        const double turns = 2 * dice.sign();
        for (int step = 1; step <= 100; ++step) { // twice around the first joint
            const double angle = turns * 2 * pi * step / 100;
            const Vec2 place = Eigen::Rotation2Dd{angle} * start;
            pose = continued(any, pose, place);
            bring_to(robot, place);
        }
        largest =
            worse(worse(std::abs(pose.first - robot.angles(0)), std::abs(pose.second - robot.angles(1))), largest);
    }
    return largest;
}

std::vector<Link> chain(Dice &dice, int count) {
    std::vector<Link> links;
    while (int(links.size()) < count) links.push_back({dice.real(0.2, 3), dice.real(-4, 4)});
    return links;
}

/// One sweep by searches: for each joint, all over a turn for the nearest hand, and there for one that's in line.
std::vector<Link> searched_sweep(std::vector<Link> links, const Vec2 &target) {
    for (std::size_t i = links.size(); i-- > 0;) {
        const double before = links[i].angle;
        const Vec2 joint = i == 0 ? Vec2{0, 0} : Robot{{links.begin(), links.begin() + long(i)}}.hand();
        const auto hand = [&](double turn) {
            links[i].angle = before + turn;
            return Robot{links}.hand();
        };
        const auto beside = [&](double turn) { // how far the hand is on the left of the line to the target
            const Vec2 to_hand = hand(turn) - joint, to_target = target - joint;
            return to_target.x() * to_hand.y() - to_target.y() * to_hand.x();
        };
        double best = -pi;
        for (int k = 0; k < 60; ++k)
            if (const double turn = -pi + 2 * pi * k / 60; (hand(turn) - target).norm() < (hand(best) - target).norm())
                best = turn;
        std::uintmax_t tries = 200;
        const auto [low, high] = boost::math::tools::toms748_solve(
            beside, best - 0.2, best + 0.2, boost::math::tools::eps_tolerance<double>(50), tries);
        links[i].angle = before + (low + high) / 2;
    }
    return links;
}

double compare_sweeps(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const std::vector<Link> links = chain(dice, dice.whole(1, 5));
        const Vec2 target = dice.point(-5, 5);
        const Vec2 ours = Robot{ccd_sweep({0, 0}, links, target)}.hand();
        largest = worse((ours - Robot{searched_sweep(links, target)}.hand()).norm(), largest);
    }
    return largest;
}

double compare_steps(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const std::vector<Link> links = chain(dice, dice.whole(6, 8)); // it takes six or more
        const std::vector<Limits> limits(links.size(), Limits{-1e5, 1e5});
        const double damping = dice.real(0.1, 3);
        const Vec2 way = dice.point(-3, 3), base{0, 100}; // far above the ground
        Robot robot{links};

        KDL::ChainIkSolverVel_wdls solver{robot.chain};
        Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(6, 6);
        weights(0, 0) = weights(1, 1) = 1; // where it is, not how it's turned
        solver.setWeightTS(weights);
        solver.setLambda(damping);
        solver.setEps(1e9); // damped always, not only near a straight pose
        KDL::JntArray turns{unsigned(links.size())};
        solver.CartToJnt(robot.angles, KDL::Twist{KDL::Vector{way.x(), way.y(), 0}, KDL::Vector::Zero()}, turns);

        const std::vector<Link> ours = damped_step(base, links, limits, base + robot.hand() + way, damping);
        for (std::size_t k = 0; k < links.size(); ++k)
            largest = worse(std::abs(ours[k].angle - links[k].angle - turns(unsigned(k))), largest);
    }
    return largest;
}

/// How far from the stroke between two corners a point is.
double distance_from(const Vec2 &from, const Vec2 &to, const Vec2 &point) {
    const Vec2 along = to - from;
    return (from + std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along - point).norm();
}

double compare_strokes(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const Arm any{dice.real(2, 3), dice.real(1, 1.8)};
        const Vec2 from = dice.real(1.9, far_border(any) - 0.11) * dice.direction(), to = from + dice.point(-0.5, 0.5);
        if (to.norm() > far_border(any) - 0.11) continue;
        if (distance_from(from, to, {0, 0}) < near_border(any) + 0.11) continue;
        for (const Pose &pose : write(any, poses(any, from)[std::size_t(i % 2)], {from, to}))
            largest = worse(distance_from(from, to, robot_of(any, pose).hand()), largest);
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv,
        "Compared with KDL " + std::string{KDL_VERSION_STRING} + " and Boost " + std::to_string(BOOST_VERSION / 100000)
            + '.' + std::to_string(BOOST_VERSION / 100 % 1000) + ", 20000 random cases each, or 200 with *",
        {{"poses: KDL's hand, by the arm's length [1]", compare_hands},
         {"poses on both borders and next to them: KDL's hand, by the arm's length [1]", compare_borders},
         {"poses of equal lengths, down to the first joint: KDL's hand, by the arm's length [1]",
          compare_equal_lengths},
         {"poses*: KDL's solver by steps, from nearby [rad]", compare_solved},
         {"continued*: the same solver, led around twice in 100 steps [rad]", compare_led},
         {"ccd_sweep*: a search for a hand in line, joint by joint, in KDL's chain [m]", compare_sweeps},
         {"damped_step: KDL's damped solver, of six to eight segments [rad]", compare_steps},
         {"write*: KDL's hand from the stroke [m]", compare_strokes}});
}
