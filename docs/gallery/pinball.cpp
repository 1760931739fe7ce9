// Pinball: the flippers are yours, by the arrow keys. A bumper kicks, and gives 100 points.
#include "props.hpp"
#include "sketch.hpp"
using namespace demo;
using segment_intersection::Segment;

struct Pinball : Scene {
    HeldKey left = held("left flipper", "ArrowLeft"), right = held("right flipper", "ArrowRight");
    const std::vector<Segment> walls{{{2, 0}, {2, 7}},      {{2, 7}, {4.5, 9}}, {{4.5, 9}, {11.5, 9}},
                                     {{11.5, 9}, {14, 7}},  {{14, 7}, {14, 0}}, {{2, 3}, {5.8, 1.6}},
                                     {{14, 3}, {10.2, 1.6}}};
    const std::vector<Vec2> bumpers{{5, 6.3}, {11, 6.3}, {8, 7.2}, {8, 4.8}};
    const double radius = 0.24; // of the ball [m]
    motion::State ball{{8.3, 8.5}, {2.5, 0}};
    double up[2]{0, 0}, lit[4]{}; // how far up each flipper is, from 0 to 1; how bright each bumper is
    int points = 0;

    View view() const override { return {{0, 0}, {16, 9.2}, Stage::felt}; }
    double step_time() const override { return 1.0 / 480; } // the ball goes 4 cm in that, at most
    Segment flipper(int i) const {
        const double side = i == 0 ? 1 : -1, angle = -0.45 + 0.95 * up[i];
        const Vec2 pivot{8 - 2.2 * side, 1.6};
        return {pivot, pivot + 1.85 * Vec2{side * std::cos(angle), std::sin(angle)}};
    }
    bool wants_up(int i) const {
        return untouched ? (ball.position - Vec2{i == 0 ? 7.1 : 8.9, 1.2}).norm() < 0.8 : i == 0 ? left : right;
    }
    void step(double dt) override {
        ball = motion::accelerated_motion(ball, {0, -6}, dt);
        for (const Segment &wall : walls) bounces(nearest(wall), radius, {0, 0}, 0);
        for (const int i : {0, 1}) {
            const double more = std::clamp((wants_up(i) ? 12 : -6) * dt, -up[i], 1 - up[i]);
            up[i] += more;
            const double turns = (i == 0 ? 0.95 : -0.95) * more / dt; // [rad/s]
            bounces(nearest(flipper(i)), radius, turns * turned(ball.position - flipper(i).start), 0);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            lit[i] = std::max(0.0, lit[i] - 3 * dt);
            if (bounces(bumpers[i], 0.65 + radius, {0, 0}, 6)) lit[i] = 1, points += 100;
        }
        if (std::abs(ball.position.y() - 5) > 6) // it's gone: the next one
            ball = {{8.3, 8.5}, {2.5 - 0.01 * (points % 500), 0}}, points = 0;
    }
    Vec2 nearest(const Segment &wall) const {
        const Vec2 along = wall.end - wall.start;
        return wall.start + std::clamp((ball.position - wall.start).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
    }
    /// Whether the ball bounces off this point, which moves so [m/s], and kicks [m/s].
    bool bounces(const Vec2 &point, double distance, const Vec2 &moves, double kick) {
        const Vec2 out = ball.position - point, approach = ball.velocity - moves;
        if (out.norm() > distance || approach.dot(out) >= 0) return false;
        ball.velocity = moves + reflection::bounce(approach, out.normalized(), {0.5, 0}) + kick * out.normalized();
        return true;
    }

    void draw(Canvas &canvas) const override {
        for (const auto &[from, to] : walls) canvas.bar({from, to}, Colour::wood, 12);
        for (std::size_t i = 0; i < 4; ++i)
            canvas.ball(bumpers[i], 0.65 + 0.12 * lit[i], lit[i] > 0 ? Colour::amber : Colour::violet);
        for (const int i : {0, 1}) canvas.bar({flipper(i).start, flipper(i).end}, Colour::orange, 15);
        canvas.ball(ball.position, radius, Colour::ink);
        canvas.plate({8, 0.35}, number(points, 0), Colour::amber, 26);
    }
};
SKETCH(Pinball, "Pinball")
