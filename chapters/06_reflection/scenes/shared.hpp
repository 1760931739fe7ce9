#pragma once
// What the scenes of this chapter share: balls on felt, a television, and a wall that the reader turns.
#include "felt.hpp"
#include "television.hpp"

namespace play {

/// A wall that the reader turns, and the angles at it.
struct TurningScene : ThrowScene {
    static constexpr double reach = 4.4; ///< from the middle of the wall to its ends [m]
    Handle hold = handle(reach * at_angle(37 * degree), {-6.4, -2.6}, {6.4, 4.6});
    double angle_deg = 37, from_deg = 37; ///< of the wall, and before it was turned the last time
    bool let = true;                      ///< whether the reader has let go since then
    int throws = 0;

    TurningScene() { still_time = 1.4; }

    /// The ball's velocity after the bounce [m/s].
    virtual Vec2 after(const Vec2 &normal) const = 0;
    Vec2 normal() const { return at_angle((angle_deg + 90) * degree); }
    /// Where the ball's centre is then.
    Vec2 meets() const { return {0, ball.radius / normal().y()}; }
    double turned_by() const { return untouched ? 0 : angle_deg - from_deg; }

    void turn_to(double degrees) {
        angle_deg = degrees;
        hold.move(reach * at_angle(degrees * degree));
    }
    void take_over() override {
        turn_to(37);
        throw_ball();
    }
    void drag() override {
        if (let) from_deg = angle_deg;
        let = false;
        turn_to(std::clamp(std::round(direction_of(hold) / degree), -70.0, 70.0));
        throw_ball();
    }
    void let_go() override { let = true; }
    void next_throw() override { ++throws; }
    void step(double dt) override {
        constexpr double film[]{37, 22, -30, 51};
        const double there = film[throws % 4], far = 90 * dt;
        if (untouched && pause > 0) turn_to(angle_deg + std::clamp(there - angle_deg, -far, far));
        ThrowScene::step(dt);
    }

    /// The ball's way, and its angles with the normal.
    void draw_angles(Canvas &canvas, int decimals) const {
        const Vec2 at = meets(), n = normal(), in{0, 1}, out = after(n);
        canvas.dotted({at, at + 6 * n}, Colour::ink, 2).strength = 0.7;
        canvas.dotted({at, {0, top}}, Colour::orange, 3);
        if (out.norm() <= 0) return;
        canvas.dotted({at, at + 9 * out.normalized()}, Colour::orange, 3);
        draw_one(canvas, in, out.dot(turned(n)) > 0 ? -1 : 1, decimals);
        draw_one(canvas, out, in.dot(turned(n)) > 0 ? -1 : 1, decimals);
    }
    /// One of them, on a side of the normal where there's room for its number: 1 is the left one.
    void draw_one(Canvas &canvas, const Vec2 &way, int side, int decimals) const {
        const Vec2 n = normal();
        draw_angle(canvas, meets(), 1.5, n, way);
        const double angle = std::abs(turn(n, way)), beside = std::max(angle / 2, 0.2 + 0.08 * decimals);
        canvas.plate(meets() + 2.1 * at_angle(direction_of(n) + side * beside), number(angle / degree, decimals) + "°",
                     Colour::amber, 22);
    }
};
} // namespace play
