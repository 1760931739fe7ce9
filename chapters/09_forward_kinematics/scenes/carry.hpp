#pragma once
// A hand that takes a box, and where it sees that.
#include "shared.hpp"

namespace play {

struct Carry : JointScene {
    static constexpr std::string_view name = "pick up (9.6)";
    Button grip = button("t", "Take, or let go", [this] { grab(); });
    Box crate_now = at_start();
    double time = 0; ///< [s]

    Carry()
        : JointScene{
            {-5.9, -3.4}, {5.9, 3.24}, {-1, -2.5}, {{2.2, 100 * degree}, {1.8, -60 * degree}, {1.2, -30 * degree}}} {
        still_time = 1.5;
    }
    static Box at_start() { return {{{1, 0}, {0, 1}, {2.5, 0.5}}, {}, false}; }

    View view() const override { return {low, high, Stage::night}; }
    Frame frame() const { return hand_of(base, links); }
    void grab() {
        if (crate_now.held) crate_now.held = false;
        else take(crate_now, frame());
    }
    void press(const Vec2 &) override { grab(); }
    void take_over() override {
        crate_now = at_start();
        set({100, -60, -30});
    }
    /// To the box, away with it, and again.
    void film(double dt) {
        time += dt;
        const double reach = eased(time, 0.2, 1), away = eased(time, 1.3, 2.4), back = eased(time, 2.9, 3.7);
        if (time > 3.9) crate_now = at_start(), time = 0;
        if (time >= 1.15 && time < 1.15 + dt) take(crate_now, frame());
        if (time >= 2.6) crate_now.held = false;
        const auto blend = [&](double start, double box, double there) {
            const double on = start + reach * (box - start) + away * (there - box);
            return on + back * (start - on);
        };
        set({blend(100, 74, 132), blend(-60, -57, -20), blend(-30, 0, 40)});
    }
    void step(double dt) override {
        if (untouched) film(dt);
        next_frame(crate_now, frame());
    }

    void draw(Canvas &canvas) const override {
        const Frame now = frame(), &there = crate_now.place;
        const Vec2 seen = to_local(now, there.origin), corner = now.origin + seen.x() * now.x_axis;
        draw_foot(canvas, base, 1.5);
        crate(canvas, there.origin - 0.5 * there.x_axis - 0.5 * there.y_axis, 1, there.x_axis);
        canvas.arrow(there.origin - 0.3 * there.y_axis, there.origin + 0.35 * there.y_axis,
                     crate_now.held ? Colour::violet : Colour::amber, 5);
        steel_arm(canvas, joints(base, links), Colour::dim, 18);
        canvas.dotted({now.origin, corner}, Colour::pink, 3);
        canvas.dotted({corner, there.origin}, Colour::green, 3);
        canvas.arrow(now.origin, now.origin + now.x_axis, Colour::pink, 5);
        canvas.arrow(now.origin, now.origin + now.y_axis, Colour::green, 5);
        canvas.plate({std::clamp(there.origin.x(), low.x() + 2.1, high.x() - 2.1),
                      there.origin.y() + (there.origin.y() > 2.1 ? -1 : 0.9)},
                     "x " + number(seen.x(), 2) + ", y " + number(seen.y(), 2), Colour::ink, 22);
    }
};
} // namespace play
