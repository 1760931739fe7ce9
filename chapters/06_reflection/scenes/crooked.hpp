#pragma once
// The television hangs crooked, and the reader turns it while the logo is on its screen.
#include "shared.hpp"

namespace play {

struct Crooked : Scene {
    static constexpr std::string_view name = "turned box (6.5)";
    const Box box{{-4, -2.5}, {4, 2.5}};
    Handle side = handle(4.35 * at_angle(20 * degree), {-9.6, -5.4}, {9.6, 5.4});
    Ball logo{{0, 0}, {3, 4}, 0.6};
    int bounces = 0;
    double time = 0; ///< [s]
    std::vector<Vec2> path;

    Crooked() { still_time = 2.4; }

    View view() const override { return {{-9.6, -5.4}, {9.6, 5.4}, Stage::night}; }
    double angle() const { return direction_of(side); }
    void drag() override { side.move(4.35 * at_angle(angle())); }
    void step(double dt) override {
        time += dt;
        if (untouched) side.move(4.35 * at_angle((20 + 25 * std::sin(1.2 * time)) * degree));
        const Vec2 was = logo.velocity;
        next_frame(logo, box, angle(), dt);
        if ((logo.velocity - was).norm() > 1e-9) ++bounces;
        path.push_back(logo.position);
        if (path.size() > 30) path.erase(path.begin());
    }

    void draw(Canvas &canvas) const override {
        draw_television(canvas, box, angle());
        canvas.trail(path, colour_of(bounces), 18).strength = 0.6;
        draw_logo(canvas, logo, bounces);
        if (!untouched)
            canvas.plate(logo.position + Vec2{0, 1.2}, number(logo.velocity.norm(), 2, "m/s"), Colour::ink, 22);
    }
};
} // namespace play
