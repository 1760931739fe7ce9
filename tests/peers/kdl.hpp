#pragma once
// What several peers ask of KDL.

#include "09_forward_kinematics/forward_kinematics.hpp"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

namespace course {

/// An arm of KDL's: each segment is a joint about z, and then a way along x.
struct Robot {
    KDL::Chain chain;
    KDL::JntArray angles;

    explicit Robot(const std::vector<forward_kinematics::Link> &links) : angles{unsigned(links.size())} {
        for (std::size_t i = 0; i < links.size(); ++i) {
            chain.addSegment(
                KDL::Segment{KDL::Joint{KDL::Joint::RotZ}, KDL::Frame{KDL::Vector{links[i].length, 0, 0}}});
            angles(unsigned(i)) = links[i].angle;
        }
    }
    /// Where so many segments end.
    Vec2 end(int segments) const {
        KDL::ChainFkSolverPos_recursive solver{chain};
        KDL::Frame frame;
        solver.JntToCart(angles, frame, segments);
        return segments == 0 ? Vec2{0, 0} : Vec2{frame.p.x(), frame.p.y()};
    }
    Vec2 hand() const { return end(int(chain.getNrOfSegments())); }
};

} // namespace course
