#pragma once
// A ship near a black hole, at night: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace gravity_wells;

constexpr double hole_radius = 0.6;      // what comes nearer is swallowed [m]
constexpr double burst = 2, engine = 16; // what a press adds to the velocity [m/s], and how fast it comes [m/s²]
constexpr double arrow = 0.4;            // so long is an arrow of 1 m/s [s]
const Vec2 start = at_rest.position;     // [m]

/// Where a hole is that lets no light out, there's none but around it.
inline void draw_hole(Canvas &canvas, double time, double radius = hole_radius) {
    std::vector<Spark> glow;
    for (int i = 0; i < 24; ++i) {
        const double r = radius * (1.3 + 0.1 * (i * 5 % 8)), angle = 2.4 * i + 2 * time / r;
        glow.push_back({{r * std::cos(angle), r * std::sin(angle)}, 0.25, 0.35});
    }
    canvas.sparks(glow, Colour::amber);
    canvas.beam(arc({0, 0}, 1.15 * radius), Colour::amber, 3);
}

/// A ship that flies until it's swallowed or far away, and then starts again.
struct Space : Scene {
    Ship ship;
    std::vector<Vec2> path;           ///< where it has been, every 20th of a second
    double nearest = 8, farthest = 8; ///< [m]
    Vec2 due{0, 0};                   ///< what the engine has still to add to the velocity [m/s]
    double time = 0, over_for = 0;    ///< since it started, and since it was over [s]
    double wide = 39;                 ///< of what's seen [m]
    enum { flying, swallowed, gone } fate = flying;

    /// The state that it starts with.
    virtual State begins() const { return at_rest; }
    /// A frame of a ship that's still there.
    virtual void fly(double dt) {
        for (int part = 0; part < 4 && ship.state.position.norm() >= hole_radius; ++part) next_frame(ship, dt / 4);
    }
    virtual double widest() const { return 80; }

    View view() const override { return {{-wide / 2, -wide * 9 / 32}, {wide / 2, wide * 9 / 32}, Stage::night}; }
    void begin() override {
        ship.state = begins();
        nearest = farthest = ship.state.position.norm();
        path = {ship.state.position};
        due = ship.thrust = {0, 0};
        time = over_for = 0;
        fate = flying;
    }
    void step(double dt) override {
        wide += std::min(1.0, 2 * dt) * (std::clamp(3.7 * (farthest + 2), 39.0, widest()) - wide);
        time += dt;
        if (fate != flying) {
            if ((over_for += dt) > 1.5) begin();
            return;
        }
        const Vec2 gain = due * std::min(1.0, engine * dt / std::max(due.norm(), 1e-9));
        due -= gain;
        ship.thrust = ship.mass / dt * gain;
        fly(dt);
        const double r = ship.state.position.norm();
        nearest = std::min(nearest, r);
        farthest = std::max(farthest, std::min(r, 1e3));
        if (int(20 * time) > int(20 * (time - dt))) path.push_back(ship.state.position);
        if (path.size() > 400) path.erase(path.begin());
        if (r < hole_radius && can_swallow()) fate = swallowed;
        else if (r > 0.29 * widest()) fate = gone;
    }
    virtual bool can_swallow() const { return true; }
    void burst_towards(const Vec2 &place) {
        if (fate == flying && place != ship.state.position) due += burst * (place - ship.state.position).normalized();
    }

    void draw_path(Canvas &canvas, Colour colour = Colour::blue) const {
        canvas.line(path, colour, 2).strength = 0.45;
        std::vector<Vec2> recent{path.end() - std::min<std::ptrdiff_t>(20, std::ssize(path)), path.end()};
        recent.push_back(ship.state.position);
        canvas.trail(std::move(recent), colour, 7);
    }
    void draw_ship(Canvas &canvas) const {
        const auto &[at, velocity] = ship.state;
        if (fate == swallowed) canvas.plate({0, 0.16 * wide}, "swallowed", Colour::pink, 24);
        if (fate == gone)
            canvas.plate({0, 0.16 * wide}, energy_of(ship.state) < 0 ? "far away" : "escaped", Colour::pink, 24);
        if (fate != flying) return;
        const Vec2 ahead = due.norm() > 0 ? due : velocity.norm() > 0.1 ? velocity : Vec2{0, 1};
        demo::ship(canvas, at, ahead.normalized(), 0.05 * wide, Colour::orange, due.norm() > 0 ? 1 : 0);
    }
    /// Around the hole, through where it was, with how many metres that is.
    static void draw_circle(Canvas &canvas, double r, double angle, const std::string &words, Colour colour) {
        canvas.dotted(arc({0, 0}, r), colour, 2);
        canvas.plate((r + 1.4) * Vec2{std::cos(angle), std::sin(angle)}, words, colour, 20);
    }
};

/// By its feet [m].
inline void draw_lander(Canvas &canvas, const Vec2 &at) {
    for (const double side : {-1.0, 1.0}) {
        canvas.bar({at + Vec2{0.6 * side, 1.4}, at + Vec2{1.5 * side, 0.1}}, Colour::line, 5);
        canvas.bar({at + Vec2{1.1 * side, 0.06}, at + Vec2{1.9 * side, 0.06}}, Colour::line, 5);
    }
    canvas.body({at + Vec2{-0.5, 0.6}, at + Vec2{0.5, 0.6}, at + Vec2{0.3, 1.2}, at + Vec2{-0.3, 1.2}}, Colour::dim);
    canvas.body({at + Vec2{-1.2, 1.1}, at + Vec2{1.2, 1.1}, at + Vec2{1.2, 2}, at + Vec2{-1.2, 2}}, Colour::amber);
    canvas.body({at + Vec2{-0.9, 2}, at + Vec2{0.9, 2}, at + Vec2{0.9, 2.9}, at + Vec2{0.4, 3.4}, at + Vec2{-0.4, 3.4},
                 at + Vec2{-0.9, 2.9}},
                Colour::ink);
    canvas.ball(at + Vec2{0, 2.7}, 0.35, Colour::blue);
}

/// What an engine blows away near the ground, for so long [s].
inline void draw_dust(Canvas &canvas, const Vec2 &at, double time) {
    if (at.y() < 4)
        for (const double side : {-1.0, 1.0})
            canvas.puffs({{{at.x() + side * (1 + 6 * time), 0.4}, 1 + 3 * time, 1}}, Colour::line);
}

/// On the Moon's ground, below something so high [m]: the nearer, the smaller and the darker.
inline void draw_shadow(Canvas &canvas, double x, double height) {
    std::vector<Vec2> shadow;
    for (const Vec2 &point : arc({0, 0}, 1.1 + 0.08 * height))
        shadow.push_back({x + point.x(), -0.35 + 0.16 * point.y()});
    canvas.area(std::move(shadow), Colour::line).strength = std::max(0.15, 0.9 - 0.06 * height);
}
} // namespace play
