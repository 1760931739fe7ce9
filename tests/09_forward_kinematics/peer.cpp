// needs orocos_kdl orocos_kdl::orocos_kdl liborocos-kdl-dev
// needs Boost Boost::headers libboost-dev
// KDL is what robots calculate their arms with: chains of segments in space. Eigen has frames as one matrix, and its
// inverse. Boost finds when a point meets the ground by a search for a root.
#include "../peers/peer.hpp"
#include "../peers/kdl.hpp"
#include "forward_kinematics.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/version.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/config.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using course::Robot, course::Vec2, course::worse;
using namespace forward_kinematics;

namespace {

constexpr int cases = 20000; // in each comparison, or a hundredth of them with a search

std::vector<Link> arm(Dice &dice, int count) {
    std::vector<Link> links;
    while (int(links.size()) < count) links.push_back({dice.real(0.2, 3), dice.real(-4, 4)});
    return links;
}

std::vector<Vec2> columns(const Robot &robot) {
    KDL::ChainJntToJacSolver solver{robot.chain};
    KDL::Jacobian matrix{robot.chain.getNrOfJoints()};
    solver.JntToJac(robot.angles, matrix);
    std::vector<Vec2> all;
    for (unsigned i = 0; i < matrix.columns(); ++i)
        all.emplace_back(matrix.getColumn(i).vel.x(), matrix.getColumn(i).vel.y());
    return all;
}

double compare_elbows(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const std::vector<Link> links = arm(dice, 2);
        Robot robot{links};
        const auto [elbow, hand] = two_links(links[0], links[1]);
        largest = worse(worse((elbow - robot.end(1)).norm(), (hand - robot.end(2)).norm()), largest);
    }
    return largest;
}

double compare_joints(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Vec2 base = dice.point(-5, 5);
        const std::vector<Link> links = arm(dice, dice.whole(1, 8));
        Robot robot{links};
        const std::vector<Vec2> got = joints(base, links);
        for (int k = 0; k < int(got.size()); ++k)
            largest = worse((got[std::size_t(k)] - base - robot.end(k)).norm(), largest);
    }
    return largest;
}

double compare_columns(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const std::vector<Link> links = arm(dice, dice.whole(1, 8));
        const std::vector<Vec2> got = jacobian(links), want = columns(Robot{links});
        for (std::size_t k = 0; k < links.size(); ++k) largest = worse((got[k] - want[k]).norm(), largest);
    }
    return largest;
}

Eigen::Isometry2d isometry(double angle, const Vec2 &origin) {
    return Eigen::Translation2d{origin} * Eigen::Rotation2Dd{angle};
}
Frame frame(const Eigen::Isometry2d &from) { return {from.linear().col(0), from.linear().col(1), from.translation()}; }

/// Angles add up, and the inner origin is a point of the outer frame.
double compare_frames(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double turn = dice.real(-4, 4), more = dice.real(-4, 4);
        const Vec2 at = dice.point(-5, 5), there = dice.point(-5, 5);
        const Eigen::Isometry2d outer = isometry(turn, at);
        const Frame got = compose(frame(outer), frame(isometry(more, there)));
        const Frame want = frame(isometry(turn + more, outer * there));
        largest = worse((got.x_axis - want.x_axis).norm(), largest);
        largest = worse((got.y_axis - want.y_axis).norm(), largest);
        largest = worse((got.origin - want.origin).norm(), largest);
    }
    return largest;
}

double compare_places(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Eigen::Isometry2d hand = isometry(dice.real(-4, 4), dice.point(-5, 5));
        const Vec2 point = dice.point(-10, 10);
        largest = worse((to_local(frame(hand), point) - hand.inverse() * point).norm(), largest);
    }
    return largest;
}

/// The lowest of KDL's joints, and of its hand, if one angle is so much larger [m].
double lowest(double height, std::vector<Link> links, int joint, double turn) {
    links[std::size_t(joint)].angle += turn;
    Robot robot{links};
    double y = height;
    for (int k = 1; k <= int(links.size()); ++k) y = std::min(y, height + robot.end(k).y());
    return y;
}

/// Small steps, and a search in the one at whose end something is below the ground.
double searched_turn(double height, const std::vector<Link> &links, int joint, double by) {
    const auto at = [&](double turn) { return lowest(height, links, joint, turn); };
    constexpr int steps = 2000;
    for (int step = 0; step < steps; ++step) {
        const double from = by * step / steps, to = by * (step + 1) / steps;
        if (at(to) >= 0) continue;
        std::uintmax_t tries = 200;
        const auto [low, high] = boost::math::tools::toms748_solve(
            at, std::min(from, to), std::max(from, to), boost::math::tools::eps_tolerance<double>(50), tries);
        return (low + high) / 2;
    }
    return by;
}

double compare_turns(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100;) {
        const double height = dice.real(0.1, 3), by = dice.real(-8, 8);
        const std::vector<Link> links = arm(dice, dice.whole(1, 5));
        const int joint = dice.whole(0, int(links.size()) - 1);
        if (lowest(height, links, 0, 0) < 0.05) continue;
        ++i;
        const double got = turn_above_ground({dice.real(-5, 5), height}, links, joint, by);
        largest = worse(course::difference(got, searched_turn(height, links, joint, by)), largest);
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv,
        "Compared with KDL " + std::string{KDL_VERSION_STRING} + ", Eigen " + std::to_string(EIGEN_WORLD_VERSION) + '.'
            + std::to_string(EIGEN_MAJOR_VERSION) + '.' + std::to_string(EIGEN_MINOR_VERSION) + " and Boost "
            + std::to_string(BOOST_VERSION / 100000) + '.' + std::to_string(BOOST_VERSION / 100 % 1000)
            + ", 20000 random cases each, or 200 with *",
        {{"two_links: a chain of KDL's [m]", compare_elbows},
         {"compose: Eigen's Isometry2d, by the sum of both angles [m]", compare_frames},
         {"joints: a chain of KDL's, of up to eight segments [m]", compare_joints},
         {"jacobian: KDL's [m/rad]", compare_columns},
         {"to_local: Eigen's inverse [m]", compare_places},
         {"turn_above_ground*: a search in KDL's chain [rad]", compare_turns}});
}
