#pragma once
// A room at night, seen from above, and a ball that the reader throws in it: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace segment_intersection;

const Vec2 low{-0.75, -0.3}, high{12.75, 7.29375}; // of what's seen [m]

/// What is marked at a wall for a while, in words.
struct Mark {
    Vec2 at;
    std::string words;
    double age = 0; ///< [s]
};

struct RoomScene : Scene {
    static constexpr double arrow_time = 0.1; ///< the arrow is as long as the way of so many seconds
    const std::vector<Vec2> room{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};
    const std::vector<Segment> walls = walls_of(room);
    const Ball first{{2, 3}, {5.4, 2.55}};
    Ball ball = first;
    Handle tip = handle(first.position + arrow_time * first.velocity, low - Vec2{6, 6}, high + Vec2{6, 6});
    std::vector<double> lit = std::vector<double>(7, 0); ///< for how long each wall still is [s]
    std::vector<Vec2> prints;                            ///< where the ball was in the last frames
    std::vector<Mark> marks;

    View view() const override { return {low, high, Stage::night}; }
    virtual double size() const { return 0.2; } ///< of the ball, as it's drawn [m]
    virtual void move(double dt) = 0;
    virtual void gone() { marks.push_back({ball.position.cwiseMax(low).cwiseMin(high), "out"}); }

    /// A ball that is nowhere stays there: the page says so.
    bool outside() const {
        const Vec2 past = (low - ball.position).cwiseMax(ball.position - high);
        return ball.position.allFinite() && past.maxCoeff() > 0.5;
    }
    void aim(const Vec2 &velocity) {
        const double speed = velocity.norm();
        if (speed > 0) ball.velocity = velocity * (std::clamp(speed, 1.0, 60.0) / speed);
        point();
    }
    void point() { tip.move(ball.position + arrow_time * ball.velocity); }
    void drag() override { aim((tip.at() - ball.position) / arrow_time); }
    void press(const Vec2 &at) override {
        const Vec2 way = at - ball.position;
        if (way.norm() > 0) aim(ball.velocity.norm() * way.normalized());
    }
    double step_time() const override { return 1.0 / 30; }
    void step(double dt) override {
        if (hand.down) return; // while somebody aims, time stands still
        prints.push_back(ball.position);
        if (prints.size() > 24) prints.erase(prints.begin());
        for (double &each : lit) each = std::max(0.0, each - dt);
        for (Mark &mark : marks) mark.age += dt;
        std::erase_if(marks, [](const Mark &mark) { return mark.age > 4; });
        const Segment motion{ball.position, ball.position + dt * ball.velocity};
        move(dt);
        for (std::size_t i = 0; i < walls.size(); ++i)
            if (is_lit_by(motion, walls[i])) lit[i] = 0.4;
        if (outside()) {
            gone();
            ball.position = first.position;
            prints.clear();
        }
        point();
    }
    virtual bool is_lit_by(const Segment &motion, const Segment &wall) const {
        return segments_intersect(motion, wall);
    }

    void draw_room(Canvas &canvas) const {
        canvas.area(room, Colour::blue).strength = 0.16;
        std::vector<Vec2> tiles;
        for (int x = 1; x < 12; ++x)
            for (int y = 1; y < 7; ++y)
                if (inside({double(x), double(y)})) tiles.push_back({double(x), double(y)});
        canvas.dots(std::move(tiles), 0.05, Colour::ink).strength = 0.25;
        for (std::size_t i = 0; i < walls.size(); ++i)
            if (lit[i] > 0) canvas.beam({walls[i].start, walls[i].end}, Colour::amber, 8);
            else canvas.bar({walls[i].start, walls[i].end}, Colour::dim, 8);
        canvas.balls(room, 0.2, Colour::wood);
    }
    bool inside(const Vec2 &at) const {
        bool in = false;
        for (const auto &[a, b] : walls)
            if ((a.y() > at.y()) != (b.y() > at.y())
                && at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                in = !in;
        return in;
    }
    /// A print for each frame, and nothing between them: there nobody looked.
    void draw_prints(Canvas &canvas) const {
        std::vector<Spark> all;
        for (std::size_t i = 0; i < prints.size(); ++i)
            all.push_back({prints[i], 0.11, double(i + 1) / double(prints.size())});
        canvas.sparks(all, Colour::orange);
    }
    void draw_ball(Canvas &canvas) const {
        canvas.arrow(ball.position, ball.position + arrow_time * ball.velocity, Colour::blue, 5);
        canvas.ball(ball.position, size(), Colour::orange);
    }
    void draw_marks(Canvas &canvas) const {
        for (const auto &[at, words, age] : marks) {
            const double strength = std::min(1.0, 4 - age);
            for (const Vec2 &way : {Vec2{0.5, 0.2}, {-0.4, 0.3}, {0.1, -0.5}, {-0.5, -0.2}, {0.2, 0.5}}) // a crack
                canvas.line({at, at + 0.6 * way + 0.15 * turned(way), at + way}, Colour::pink, 3).strength = strength;
            canvas
                .plate((at + Vec2{0, 0.75}).cwiseMax(low + Vec2{1, 0.4}).cwiseMin(high - Vec2{1, 0.4}), words,
                       Colour::pink, 26)
                .strength = strength;
        }
    }
};
} // namespace play
