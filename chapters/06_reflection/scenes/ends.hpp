#pragma once
// A wall with two ends, which the reader drags, and the normal that comes of them.
#include "shared.hpp"

namespace play {

struct Ends : ThrowScene {
    static constexpr std::string_view name = "two ends (6.3)";
    Handle start = handle({-3.5, -1.3}, {-5.8, -2}, {5.8, 4});
    Handle end = handle({3.3, 1.1}, {-5.8, -2}, {5.8, 4});
    double time = 0; ///< [s]

    Ends() { still_time = 1.5; }

    bool has_length() const { return (end.at() - start.at()).norm() > 0.01; }
    void take_over() override {
        start.move({-3.5, -1.3});
        end.move({3.3, 1.1});
        throw_ball();
    }
    void drag() override { throw_ball(); }
    void move(double dt) override {
        if (has_length()) next_frame(ball, Wall{start, end}, dt);
        else ball.position += dt * ball.velocity;
    }
    void step(double dt) override {
        time += dt;
        if (untouched && pause > 0) { // both ends go up and down
            start.move({-3.5, -1.0 + 0.8 * std::sin(2.1 * time)});
            end.move({3.3, 1.1 + 1.2 * std::sin(1.3 * time)});
        }
        ThrowScene::step(dt);
    }

    void draw(Canvas &canvas) const override {
        const Vec2 a = start, b = end;
        if (!has_length()) {
            canvas.plate({0, 3}, "A point has no normal.", Colour::pink, 26);
            return draw_ball(canvas);
        }
        const Vec2 middle = (a + b) / 2, n = unit_normal(a, b), along = (b - a).normalized();
        canvas.dotted({middle - 20 * along, middle + 20 * along}, Colour::ink, 3);
        draw_wall(canvas, a, b);
        canvas.arrow(middle, middle + 1.8 * n, Colour::violet, 6);
        canvas.plate(middle + 2.3 * n, "(" + number(n.x(), 2) + ", " + number(n.y(), 2) + ")", Colour::violet, 20);
        canvas.plate(a - 1.0 * along, "start", Colour::ink, 20);
        canvas.plate(b + 0.9 * along, "end", Colour::ink, 20);
        draw_ball(canvas);
    }
};
} // namespace play
