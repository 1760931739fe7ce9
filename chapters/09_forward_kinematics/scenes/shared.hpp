#pragma once
// Arms, a digger, and joints to drag: what the scenes of this chapter share.
#include "../../chance.hpp"
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace forward_kinematics;

/// How far a film is at this time, softly from 0 to 1 [s].
inline double eased(double time, double from, double to) {
    return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp((time - from) / (to - from), 0.0, 1.0));
}
/// A body whose corners are given as seen from a frame.
inline void draw_part(Canvas &canvas, const Frame &frame, Colour colour, const std::vector<Vec2> &corners) {
    std::vector<Vec2> points;
    for (const Vec2 &corner : corners) points.push_back(in_world(frame, corner));
    canvas.body(std::move(points), colour);
}
/// What an arm is bolted to.
inline void draw_foot(Canvas &canvas, const Vec2 &at, double down) {
    canvas.body({at + Vec2{-0.25, 0.1}, at + Vec2{0.25, 0.1}, at + Vec2{0.55, -down}, at + Vec2{-0.55, -down}},
                Colour::dim);
}

/// A digger's cab on its tracks, with a boom and a stick.
inline void draw_cab(Canvas &canvas, const Frame &cab, const std::vector<Vec2> &arm) {
    draw_part(canvas, cab, Colour::ink, {{-1.6, 0}, {1.2, 0}, {1.4, 0.3}, {1.2, 0.6}, {-1.6, 0.6}, {-1.8, 0.3}});
    std::vector<Vec2> wheels;
    for (int i = 0; i < 4; ++i) wheels.push_back(in_world(cab, {-1.4 + 0.8 * i, 0.3}));
    canvas.balls(std::move(wheels), 0.2, Colour::dim);
    draw_part(canvas, cab, Colour::amber,
              {{-1.6, 0.65}, {1, 0.65}, {1, 1.3}, {0.3, 2.3}, {-0.6, 2.3}, {-0.7, 1.5}, {-1.6, 1.4}});
    draw_part(canvas, cab, Colour::blue, {{-0.4, 1.4}, {0.65, 1.4}, {0.2, 2.1}, {-0.4, 2.1}});
    canvas.bar(arm, Colour::orange, 17);
}

/// Several handles, each of which belongs to something that moves.
struct HoldScene : Scene {
    const Vec2 low, high; ///< what's seen [m]
    std::vector<Handle> holds;
    std::vector<Vec2> placed; ///< where each was put the last time [m]
    int held = -1;            ///< which one the reader has

    HoldScene(const Vec2 &from, const Vec2 &to, std::size_t count) : low{from}, high{to} {
        for (std::size_t i = 0; i < count; ++i) holds.push_back(handle((low + high) / 2, low, high));
        for (const Handle &each : holds) placed.push_back(each);
    }
    /// Each is put to its place again, but for one.
    void place(const std::vector<Vec2> &all, int except = -1) {
        for (std::size_t i = 0; i < std::min(all.size(), holds.size()); ++i) {
            if (int(i) == except) continue;
            holds[i].move(all[i]);
            placed[i] = holds[i];
        }
    }
    void drag() override {
        for (std::size_t i = 0; i < holds.size(); ++i)
            if ((holds[i].at() - placed[i]).norm() > 1e-9) held = int(i);
    }
    void let_go() override { held = -1; }
};

/// An arm whose joints the reader drags: each link points there.
struct JointScene : HoldScene {
    const Vec2 base;
    std::vector<Link> links;

    JointScene(const Vec2 &from, const Vec2 &to, const Vec2 &at, const std::vector<Link> &with)
        : HoldScene{from, to, with.size()}, base{at}, links{with} {}
    void place_all() {
        const std::vector<Vec2> all = joints(base, links);
        if (!all.empty()) place({all.begin() + 1, all.end()});
    }
    void begin() override { place_all(); }
    void drag() override {
        HoldScene::drag();
        const std::vector<Vec2> all = joints(base, links);
        const std::size_t i = std::size_t(held);
        if (held >= 0 && i + 1 < all.size()) links[i].angle += turn(all[i + 1] - all[i], holds[i].at() - all[i]);
        place_all();
    }
    void set(const std::vector<double> &degrees) {
        for (std::size_t i = 0; i < links.size(); ++i) links[i].angle = degrees[i] * degree;
        place_all();
    }
};
} // namespace play
