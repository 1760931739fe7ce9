#pragma once
// A missile breaks in flight, and a camera follows the centre of mass of its pieces.
#include "shared.hpp"

namespace play {

struct Breaks : Scene {
    static constexpr std::string_view name = "it breaks (1.4)";
    const motion::State start{{1, 1}, {13, 15}}; // [m], [m/s]
    static constexpr double size = 7;            // [m]
    Button now = button("b", "Break it", [this] { break_in_two(); });
    std::vector<Missile> pieces;                ///< one; or nose and hull
    std::vector<Vec2> looked_at, trails[2];     ///< where the camera looked at; and where nose and hull have been
    double time = 0, broken_at = -1, pause = 0; ///< [s]
    Vec2 place{0, 0}, along{1, 0};              ///< where it broke [m], and how it pointed
    int flights = 0;

    Breaks() { still_time = 2.3; }

    View view() const override { return {{-3, -3}, {45, 24}, Stage::hills, 0}; }
    void begin() override {
        pieces = {{start, {0, -10}, 4}};
        looked_at.clear();
        for (std::vector<Vec2> &each : trails) each.clear();
        time = pause = 0;
        broken_at = -1;
        ++flights;
    }
    void take_over() override { begin(); }
    void press(const Vec2 &) override { break_in_two(); }
    /// They push each other apart. The hull is three times as heavy: it gets a third of the velocity, and the way.
    void break_in_two() {
        if (pieces.size() != 1 || !flying()) return;
        Missile nose = pieces[0], hull = pieces[0];
        along = nose.state.velocity.normalized();
        nose.mass = 1, hull.mass = 3;
        nose.state.position += 0.375 * size * along, hull.state.position -= 0.125 * size * along;
        nose.state.velocity += Vec2{1.5, 5.25}, hull.state.velocity -= Vec2{0.5, 1.75};
        place = pieces[0].state.position;
        pieces = {nose, hull};
        broken_at = time;
    }
    bool flying() const {
        return std::all_of(pieces.begin(), pieces.end(),
                           [](const Missile &each) { return each.state.position.y() > 0; });
    }
    void step(double dt) override {
        constexpr double film[]{0.9, 1.5, 0.5};
        if (!flying() || time > 6) {
            if ((pause += dt) > 1.2) begin();
            return;
        }
        if (untouched && time > film[(flights - 1) % 3]) break_in_two();
        for (Missile &piece : pieces) next_frame(piece, dt);
        time += dt;
        for (std::size_t i = 0; i < pieces.size() && pieces.size() == 2; ++i)
            trails[i].push_back(pieces[i].state.position);
        if (const auto target = camera_target(pieces); target && int(time / 0.15) > int((time - dt) / 0.15))
            looked_at.push_back(*target);
    }

    void draw(Canvas &canvas) const override {
        std::vector<Vec2> unbroken;
        for (int i = 0; i <= 30; ++i) unbroken.push_back(accelerated_motion(start, {0, -10}, 0.1 * i).position);
        canvas.dotted(std::move(unbroken), Colour::ink, 3);
        canvas.dots(looked_at, 0.3, Colour::blue);
        if (pieces.size() == 1) {
            const auto &[at, velocity] = pieces[0].state;
            draw_missile(canvas, at, size * velocity.normalized(), 0, time);
        } else draw_pieces(canvas);
        if (const auto target = camera_target(pieces)) draw_finder(canvas, *target);
        if (pieces.size() == 1) return;
        canvas.plate(pieces[0].state.position + Vec2{0, 2.4}, "1 kg", Colour::pink, 20);
        canvas.plate(pieces[1].state.position + Vec2{-4.8, -0.5}, "3 kg", Colour::orange, 20);
    }
    void draw_pieces(Canvas &canvas) const {
        const double since = time - broken_at, fades = std::max(0.0, 1 - 2 * since);
        const auto tumbled = [&](double turns) {
            const double angle = turns * since;
            return Vec2{size * (std::cos(angle) * along + std::sin(angle) * turned(along))};
        };
        canvas.trail(trails[0], Colour::pink, 5);
        canvas.trail(trails[1], Colour::orange, 5);
        if (fades > 0) canvas.lamp(place, 2.5 * fades, Colour::amber);
        const Vec2 nose = tumbled(-5), hull = tumbled(1.7);
        draw_hull(canvas, pieces[1].state.position - 0.33 * hull, hull);
        draw_nose(canvas, pieces[0].state.position - 0.14 * nose, nose);
    }
    /// What a camera shows at its middle.
    void draw_finder(Canvas &canvas, const Vec2 &at) const {
        for (const Vec2 &to : {Vec2{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
            const Vec2 corner = at + Vec2{6.4 * to.x(), 3.6 * to.y()};
            canvas.line({corner - Vec2{1.6 * to.x(), 0}, corner, corner - Vec2{0, 1.6 * to.y()}}, Colour::blue, 4);
        }
        canvas.line({at - Vec2{1, 0}, at + Vec2{1, 0}}, Colour::blue, 4);
        canvas.line({at - Vec2{0, 1}, at + Vec2{0, 1}}, Colour::blue, 4);
    }
};
} // namespace play
