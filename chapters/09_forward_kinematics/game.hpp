#pragma once
// The game of this chapter, as it grows: an arm that draws, a digger, a tentacle, a hand that carries, and the ground.
#include "forward_kinematics.hpp"

#include <cmath>
#include <cstddef>

namespace forward_kinematics {

//> The world
constexpr double frame_time = 1.0 / 60;         ///< [s]
constexpr double degree = 0.017453292519943295; ///< [rad]
constexpr double quarter_turn = 90 * degree;    ///< [rad]

//> An arm that draws
struct Arm {
    Link first, second;
    std::vector<Vec2> trail; ///< where the hand has been [m]
};

//> The frame loop: two motors
/// One frame of the game: a motor turns each joint, at so many radians per second, and the hand leaves a mark.
inline void next_frame(Arm &arm, double first_rate, double second_rate, double dt) {
    arm.first.angle += dt * first_rate;
    arm.second.angle += dt * second_rate;
    arm.trail.push_back(two_links(arm.first, arm.second).hand);
}

//> Frames of a digger
/// The frame at the end of a link, as seen from its joint.
inline Frame end_of(const Link &link) {
    const double c = std::cos(link.angle), s = std::sin(link.angle);
    return {{c, s}, {-s, c}, {link.length * c, link.length * s}};
}

/// A point that is given as seen from a frame, as the world sees it.
inline Vec2 in_world(const Frame &frame, const Vec2 &point) { return compose(frame, {{1, 0}, {0, 1}, point}).origin; }

//> The parts of a digger
struct Digger {
    Frame cab;                ///< as seen from the world
    Link boom, stick, bucket; ///< each as seen from the part before it
};
struct Parts {
    Frame cab, boom, stick, bucket; ///< as seen from the world: of the cab, and of the ends of the others
};

//> The frame loop: a digger
/// Where all parts of a digger are.
inline Parts parts_of(const Digger &it) {
    const Frame joint = compose(it.cab, {{1, 0}, {0, 1}, {0.5, 1.2}}); // of the boom: on the cab, 1.2 m up
    const Frame boom = compose(joint, end_of(it.boom));
    const Frame stick = compose(boom, end_of(it.stick));
    const Frame bucket = compose(stick, end_of(it.bucket));
    return {it.cab, boom, stick, bucket};
}

//> The frame loop: a tentacle
/// A tentacle at a time [s]: each link swings by up to `swing` [rad], like the link before it, but a little later.
inline std::vector<Link> tentacle(int links, double length, double swing, double lag, double time) {
    std::vector<Link> all{{length / links, quarter_turn}}; // the first one stands upright
    while (int(all.size()) < links)
        all.push_back({length / links, swing * std::sin(3 * time - lag * double(all.size()))});
    return all;
}

//> The frame at the hand
/// The frame of an arm's hand, as the world sees it.
inline Frame hand_of(const Vec2 &base, const std::vector<Link> &links) {
    Frame frame{{1, 0}, {0, 1}, base};
    for (const Link &link : links) frame = compose(frame, end_of(link));
    return frame;
}

//> A box
struct Box {
    Frame place;       ///< as the world sees it
    Frame in_hand;     ///< as the hand sees it
    bool held = false; ///< whether the hand has it
};

/// An arrow of the world, as seen from a frame.
inline Vec2 arrow_in(const Frame &frame, const Vec2 &arrow) { return to_local(frame, frame.origin + arrow); }

//> Pick up
/// The hand takes the box: its place in the hand is remembered.
inline void take(Box &box, const Frame &hand) {
    box.in_hand = {arrow_in(hand, box.place.x_axis), arrow_in(hand, box.place.y_axis),
                   to_local(hand, box.place.origin)};
    box.held = true;
}

//> The frame loop: carry
/// One frame of the game: a box that is held goes where the hand goes.
inline void next_frame(Box &box, const Frame &hand) {
    if (box.held) box.place = compose(hand, box.in_hand);
}

//> The frame loop: above the ground
/// One frame of the game: a motor turns a joint, as far as the ground allows.
inline void next_frame(const Vec2 &base, std::vector<Link> &links, int joint, double speed, double dt) {
    links[std::size_t(joint)].angle += turn_above_ground(base, links, joint, dt * speed);
}
//>
} // namespace forward_kinematics
