#pragma once
// A puck on a table, beside one whose axes have a friction of their own each.
#include "shared.hpp"

namespace play {

struct Hockey : Scene {
    static constexpr std::string_view name = "air hockey (5.6)";
    static constexpr double wide = 8.5, high = 8,
                            radius = 0.5;        ///< half of the table, its depth, and a puck's radius [m]
    static constexpr double speed = 6, loss = 1; ///< of a push [m/s], and each second [m/s²]
    const Vec2 start{-6, 1.7};
    Handle aim = handle(start + 4 * Vec2{0.8, 0.6}, {-wide, 0}, {wide, high});
    motion::State puck{start, {0, 0}}, per_axis{puck};
    std::vector<Vec2> path, other_path;
    double rest = 0; ///< how long both have been standing still [s]
    int pushes = 0;

    Hockey() { still_time = 2.6; }

    View view() const override { return {{-9.8, -1.5}, {9.8, 9.525}, Stage::felt}; }
    void push() {
        const Vec2 way = aim.at() - start;
        puck = per_axis = {start, speed * (way.norm() > 0.01 ? way.normalized() : Vec2{1, 0})};
        path = other_path = {start};
        rest = 0;
    }
    void begin() override { push(); }
    void take_over() override { push(); }
    void drag() override { push(); }
    void press(const Vec2 &at) override {
        aim.move(at);
        push();
    }

    /// Off the borders of the table, if the puck moves towards them.
    static void bounce(motion::State &it) {
        auto &[at, velocity] = it;
        const double side = wide - radius;
        if (std::abs(at.x()) > side && at.x() * velocity.x() > 0) velocity.x() = -velocity.x();
        if ((at.y() < radius && velocity.y() < 0) || (at.y() > high - radius && velocity.y() > 0))
            velocity.y() = -velocity.y();
    }
    void move(double dt) {
        next_frame(puck, loss, dt);
        const Vec2 old = per_axis.velocity;
        const auto slower = [&](double v) { return std::copysign(std::max(0.0, std::abs(v) - loss * dt), v); };
        per_axis.velocity = {slower(old.x()), slower(old.y())};
        per_axis.position += (old + per_axis.velocity) / 2 * dt;
        bounce(puck);
        bounce(per_axis);
    }
    bool still() const { return puck.velocity.norm() + per_axis.velocity.norm() == 0; }
    void step(double dt) override {
        if (hand.down) return;
        if (still() && (rest += dt) > 1.5) {
            constexpr double film[]{62, 25, 50, 36}; // [°], and at none of them both end in one place
            ++pushes;
            const double angle = film[pushes % 4] * degree;
            if (untouched) aim.move(start + 4 * Vec2{std::cos(angle), std::sin(angle)});
            return push();
        }
        if (still()) return;
        for (int i = 0; i < 16; ++i) move(dt / 16); // so that the last part before it stops is short
        path.push_back(puck.position);
        other_path.push_back(per_axis.position);
    }

    void draw(Canvas &canvas) const override {
        std::vector<Vec2> holes;
        for (int x = -8; x <= 8; ++x)
            for (int y = 1; y <= 7; ++y) holes.push_back({double(x), double(y)});
        canvas.dots(std::move(holes), 0.05, Colour::ink).strength = 0.3;
        rails(canvas, {-wide, 0}, {wide, high}, 0, 0.25, Colour::green);
        rails(canvas, {-wide, 0}, {wide, high}, 0.25, 0.65, Colour::wood);
        canvas.dotted({start, aim}, Colour::ink, 3);
        canvas.line(other_path, Colour::dim, 5);
        canvas.line(path, Colour::orange, 5).strength = 0.7;
        canvas.ball(per_axis.position, radius, Colour::dim);
        canvas.ball(puck.position, radius, Colour::orange);
        if (!still()) return;
        const double apart = (puck.position - per_axis.position).norm();
        const Vec2 middle = (puck.position + per_axis.position) / 2;
        canvas.dotted({puck.position, per_axis.position}, Colour::ink, 3);
        if (apart > 0.05) canvas.plate(middle, number(apart, 1, "m apart"), Colour::ink, 24);
        else canvas.plate(middle + Vec2{0, 1}, "in one place", Colour::green, 24);
    }
};
} // namespace play
