// A spider follows the pointer over stones: each of its feet stays where it is, until its leg is too far behind.
#include "props.hpp"
#include "sketch.hpp"
using namespace demo;

struct Spider : Scene {
    static constexpr inverse_kinematics::Arm leg{2.7, 3.8}; // [m]
    Vec2 body{12, 5}, feet[8], from[8], to[8]; // a foot's step begins and ends there; the legs behind come first
    double part[8]{1, 1, 1, 1, 1, 1, 1, 1};    // of its step
    double looks = -1, turn = 0;               // to the left -1, to the right 1; of the fly [rad]

    View view() const override { return {{0, 0}, {24, 13.5}, Stage::hills, 2}; }
    Vec2 fly() const { return hand.inside ? hand.at : Vec2{12 - 8 * std::cos(turn), 9 + 2.5 * std::sin(3 * turn)}; }
    Vec2 hip(int i) const { return body + Vec2{-0.9 + 0.6 * (i % 4), -0.5}; }
    double best(int i) const { return body.x() - 4.2 + 2.8 * (i % 4) + (i < 4 ? 0.3 : -0.3); } // where it stands
    static double stone(double x) { return 1.3 + 0.4 * std::sin(2 * std::round(x / 4.8)); }    // its radius [m]
    static Vec2 on_ground(double x) {
        return {x, 1.4 + std::sqrt(std::max(0.25, std::pow(stone(x), 2) - std::pow(std::remainder(x, 4.8), 2)))};
    }
    void begin() override {
        for (int i = 0; i < 8; ++i) feet[i] = from[i] = to[i] = on_ground(best(i));
    }
    void step(double dt) override {
        turn = std::fmod(turn + 0.5 * dt, 2 * std::numbers::pi);
        const Vec2 goal = fly().cwiseMax(Vec2{5, 4}).cwiseMin(Vec2{19, 12});
        body.x() += dt * std::clamp(2 * (goal.x() - body.x()), -4.5, 4.5);
        body.y() += 3 * dt * (3.7 + 0.25 * goal.y() + 0.15 * std::sin(5 * body.x()) - body.y());
        looks += 5 * dt * ((goal.x() < body.x() ? -1 : 1) - looks);
        for (int i = 0; i < 8; ++i) walk(i, dt);
    }
    void walk(int i, double dt) {
        const bool others_stand = part[(i + 4) % 8] == 1 && part[i % 2 == 0 ? i + 1 : i - 1] == 1;
        if (part[i] == 1 && others_stand && std::abs(best(i) - to[i].x()) > 0.9) {
            from[i] = to[i];
            to[i] = on_ground(best(i) + 0.7 * looks);
            part[i] = 0;
        }
        part[i] = std::min(1.0, part[i] + 6 * dt);
        feet[i] = from[i] + part[i] * (to[i] - from[i]) + Vec2{0, std::sin(part[i] * std::numbers::pi)};
    }
    void draw(Canvas &canvas) const override {
        for (int i = 0; i < 6; ++i) canvas.ball({4.8 * i, 1.4}, stone(4.8 * i), Colour::dim);
        for (int i = 0; i < 4; ++i) draw_leg(canvas, i, Colour::dim);
        canvas.ball(body + Vec2{-1.2 * looks, 0.6}, 1.7, Colour::violet);
        for (int i = 4; i < 8; ++i) draw_leg(canvas, i, Colour::ink);
        canvas.ball(body + Vec2{1.4 * looks, 0.3}, 1.1, Colour::violet);
        for (const double side : {-0.4, 0.4}) {
            const Vec2 eye = body + Vec2{side + 1.7 * looks, 0.7};
            canvas.lamp(eye, 0.38, Colour::amber);
            canvas.dot(eye + 0.18 * (fly() - eye).normalized(), 0.18, Colour::wood);
        }
        canvas.lamp(fly(), 0.2, Colour::amber);
    }
    void draw_leg(Canvas &canvas, int i, Colour colour) const {
        const forward_kinematics::Pose up{i % 4 < 2 ? 2.2 : 0.9, i % 4 < 2 ? 1.4 : -1.4}; // that's where its knee is
        const auto [first, second] = inverse_kinematics::continued(leg, up, feet[i] - hip(i));
        steel_arm(canvas, forward_kinematics::joints(hip(i), {{leg.first, first}, {leg.second, second}}), colour, 9);
    }
};
SKETCH(Spider, "A spider that follows you")
