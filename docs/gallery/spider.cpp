// A spider that walks after the pointer. Each foot stays where it is, until the body has gone too far.
#include "props.hpp"
#include "sketch.hpp"
using namespace demo;

struct Spider : Scene {
    static constexpr inverse_kinematics::Arm leg{1.1, 1.4}; // [m]
    struct Foot {
        Vec2 at{0, 0}, from{0, 0}, to{0, 0}; // now, and where its step begins and ends [m]
        double part = 1;                     // of its step
    };
    Vec2 body{9.4, 3.6}, ahead{0, 1};
    Foot feet[8];
    double time = 0; // [s]

    View view() const override { return {{0, 0}, {12.8, 7.2}, Stage::felt}; }
    Vec2 goal() const {
        if (hand.inside) return hand.at;
        return {6.4 + 4 * std::cos(0.6 * time), 3.6 + 1.8 * std::sin(1.2 * time)};
    }
    /// Four legs on each side, from the front to the back.
    static int side(int i) { return i < 4 ? 1 : -1; }
    Vec2 on_body(double forward, double left) const { return body + forward * ahead + left * turned(ahead); }
    Vec2 hip(int i) const { return on_body(0.45 - 0.3 * (i % 4), 0.32 * side(i)); }
    Vec2 rest_of(int i) const { return on_body(1.75 - 1.15 * (i % 4), 1.6 * side(i)); }

    void begin() override {
        for (int i = 0; i < 8; ++i) feet[i].at = rest_of(i);
    }
    void step(double dt) override {
        time = std::fmod(time + dt, 2 * std::numbers::pi / 0.6);
        const Vec2 way = goal() - body;
        if (way.norm() > 0.3) {
            ahead = (ahead + 5 * dt * way.normalized()).normalized();
            body += std::min(3.4, 3 * way.norm()) * dt * ahead;
        }
        for (int i = 0; i < 8; ++i) walk(i, dt);
    }
    /// A leg steps while its neighbours stand: the one across, and the next one on its side.
    void walk(int i, double dt) {
        Foot &foot = feet[i];
        const bool firm = feet[(i + 4) % 8].part >= 1 && feet[i % 2 == 0 ? i + 1 : i - 1].part >= 1;
        if (foot.part >= 1 && firm && (rest_of(i) - foot.at).norm() > 0.6)
            foot = {foot.at, foot.at, rest_of(i) + 0.5 * ahead, 0};
        foot.part = std::min(1.0, foot.part + 8 * dt);
        if (foot.part < 1) foot.at = foot.from + foot.part * (foot.to - foot.from);
    }

    void draw(Canvas &canvas) const override {
        for (int i = 0; i < 8; ++i) draw_leg(canvas, i);
        canvas.ball(on_body(-0.75, 0), 0.8, Colour::violet);
        canvas.ball(on_body(0.3, 0), 0.5, Colour::violet);
        for (const double left : {-0.2, 0.2}) canvas.lamp(on_body(0.65, left), 0.1, Colour::amber);
    }
    void draw_leg(Canvas &canvas, int i) const {
        const Vec2 foot = inverse_kinematics::nearest_reachable(leg, feet[i].at - hip(i));
        Vec2 knee{0, 0};
        for (const auto &pose : inverse_kinematics::poses(leg, foot)) { // the knee that's farther in front
            const Vec2 at = leg.first * Vec2{std::cos(pose.first), std::sin(pose.first)};
            if (knee.isZero(0) || (at - knee).dot(ahead) * (i % 4 < 2 ? 1 : -1) > 0) knee = at;
        }
        canvas.bar({hip(i), hip(i) + knee, hip(i) + foot}, Colour::ink, 8);
        canvas.ball(hip(i) + foot, 0.1, Colour::ink);
    }
};
SKETCH(Spider, "A spider that follows you")
