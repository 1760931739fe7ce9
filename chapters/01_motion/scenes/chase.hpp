#pragma once
// A missile 150 px behind a helicopter: how far do they get from mark to mark, while its engine runs and without it?
#include "shared.hpp"

namespace play {

struct Chase : Scene {
    static constexpr std::string_view name = "a chase (1.3)";
    static constexpr double thrust = 180; // [px/s²]
    HeldKey key = held("engine", "e");
    Helicopter helicopter{{0, 0}, {0, 0}};
    Missile missile{{{0, 0}, {0, 0}}, {0, 0}}; ///< [px]
    std::vector<Vec2> marks[2], path;          ///< the helicopter's and the missile's; and where the missile has been
    double time = 0;                           ///< [s]
    int steps = 0;
    bool burns = false;

    Chase() { still_time = 1.9; }

    /// A camera rides with the missile.
    View view() const override {
        const double x = missile.state.position.x();
        return {{x - 330, 0}, {x + 310, 360}, Stage::hills, 40};
    }
    void begin() override {
        helicopter = {{150, 250}, {px_per_second(4, 30), 0}};
        missile = {{{0, 130}, helicopter.velocity}, {0, 0}};
        for (std::vector<Vec2> &each : marks) each.clear();
        path.clear();
        time = 0;
        steps = 0;
    }
    void take_over() override { begin(); }
    void step(double dt) override {
        burns = untouched || key || hand.down;
        missile.acceleration = {burns ? thrust : 0, 0};
        if (steps++ % 20 == 0) { // a mark each third of a second
            marks[0].push_back(helicopter.position);
            marks[1].push_back(missile.state.position);
            for (std::vector<Vec2> &each : marks)
                if (each.size() > 40) each.erase(each.begin());
        }
        next_frame(helicopter, dt);
        next_frame(missile, dt);
        time += dt;
        path.push_back(missile.state.position);
        if (path.size() > 40) path.erase(path.begin());
        const double there = missile.state.position.x();
        if (std::abs(there - helicopter.position.x()) > (untouched ? 700 : 1500) || there > 2e4) begin();
    }

    void draw(Canvas &canvas) const override {
        const double middle = missile.state.position.x(), first = std::ceil((middle - 400) / 200);
        for (int i = 0; i < 4; ++i) { // what streams by
            const double x = 200 * (first + i);
            canvas.bar({{x, 30}, {x, 56}}, Colour::wood, 5);
            canvas.text({x, 14}, number(x, 0), Colour::ink, 16, Anchor::middle);
        }
        draw_gaps(canvas, marks[0], Colour::blue);
        draw_gaps(canvas, marks[1], Colour::orange);
        if (burns && path.size() > 1) canvas.trail(path, Colour::amber, 10);
        draw_helicopter(canvas, helicopter.position, 130, time);
        draw_missile(canvas, missile.state.position, {100, 0}, burns ? 1 : 0, time);
    }
    /// From each mark to the next.
    void draw_gaps(Canvas &canvas, const std::vector<Vec2> &all, Colour colour) const {
        std::vector<Vec2> seen;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Vec2 at = all[i] + Vec2{0, -56};
            if (std::abs(at.x() - view().low.x() - 320) > 330) continue;
            seen.push_back(at);
            if (i == 0) continue;
            const double gap = all[i].x() - all[i - 1].x();
            canvas.line({at - Vec2{gap - 8, 0}, at - Vec2{8, 0}}, colour, 3);
            canvas.text(at + Vec2{-gap / 2, 13}, number(gap, 0), colour, 18, Anchor::middle);
        }
        canvas.dots(std::move(seen), 5, colour);
    }
};
} // namespace play
