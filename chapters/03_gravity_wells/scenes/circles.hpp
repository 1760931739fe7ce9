#pragma once
// A circle at any distance, and how long a turn takes: each turn leaves its ring.
#include "shared.hpp"

namespace play {

struct Circles : Space {
    static constexpr std::string_view name = "circles (3.4)";
    Handle place = handle(start, {1.5, 0}, {10, 0});
    struct Ring {
        double radius, turn; ///< [m], [s]
    };
    std::vector<Ring> rings; ///< of the turns before
    double turned = 0;       ///< so far [rad]
    int flights = 0;

    Circles() { still_time = 3; }

    double widest() const override { return 39; }
    double radius() const { return std::round(10 * place.at().x()) / 10; }
    State begins() const override { return {{radius(), 0}, {0, circular_orbit_speed(hole.mass, radius(), G)}}; }
    void begin() override {
        constexpr double film[]{3, 8, 6.5};
        if (untouched) place.move({film[flights++ % 3], 0});
        Space::begin();
        turned = 0;
    }
    void take_over() override { rings.clear(); }
    void drag() override { begin(); }
    void step(double dt) override {
        const Vec2 before = ship.state.position;
        Space::step(dt);
        const Vec2 now = ship.state.position;
        const double angle = std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now));
        turned += angle;
        const double whole = 2 * std::numbers::pi;
        if (turned < whole || angle <= 0) return;
        rings.push_back({radius(), time - dt * (turned - whole) / angle});
        if (rings.size() > 3) rings.erase(rings.begin());
        begin();
    }

    void draw(Canvas &canvas) const override {
        for (std::size_t i = 0; i < rings.size(); ++i) {
            const Colour colour = i + 1 == rings.size() ? Colour::green : Colour::dim;
            canvas.dotted(arc({0, 0}, rings[i].radius), colour, 2);
            canvas.plate({0, rings[i].radius + 0.1}, number(rings[i].turn, 2, "s"), colour, 18);
        }
        draw_hole(canvas, time);
        draw_path(canvas);
        draw_ship(canvas);
        canvas.line({{hole_radius, 0}, place}, Colour::dim, 2);
        canvas.plate(place.at() + Vec2{3.2, -1.2}, number(radius(), 1, "m"), Colour::ink, 22);
    }
};
} // namespace play
