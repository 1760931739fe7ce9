#pragma once
// Two equal balls, one of which comes off centre; or two that are in each other, and part.
#include "off_centre.hpp"

namespace play {

struct Equal : OffCentre {
    static constexpr std::string_view name = "equal balls (8.2)";
    Button overlap = button("o", "Overlap", [this] { put_into_each_other(); });
    bool parting = false;

    Equal() { still_time = 1.7; }

    void start() override {
        parting = false;
        meet({{0, 0}, {5, 0}, 0.5, 1}, {{0, 0}, {speed_of_b, 0}, 0.5, 1});
    }
    void put_into_each_other() {
        place({0.8, 0.6}, {{0, 0}, {-0.48, -0.36}, 0.5, 1}, {{0, 0}, {0.48, 0.36}, 0.5, 1}, 20);
        parting = true;
    }
    void move(double dt) override { next_frame(a, b, dt); }

    void draw(Canvas &canvas) const override {
        const bool angle = !untouched && met && !parting && a.velocity.norm() > 1e-9 && b.velocity.norm() > 1e-9;
        if (angle) draw_angle(canvas, touched[0], 1.5, a.velocity, b.velocity);
        draw_both(canvas);
        if (angle) {
            const Vec2 middle = (a.velocity.normalized() + b.velocity.normalized()).normalized();
            canvas.plate(touched[0] + 2.2 * middle, number(angle_between(a.velocity, b.velocity), 1) + "°",
                         Colour::amber, 24);
        }
        if (parting)
            canvas.plate(a.position - Vec2{0, 1}, number((b.position - a.position).norm(), 2, "m apart"), Colour::amber,
                         24);
    }
};
} // namespace play
