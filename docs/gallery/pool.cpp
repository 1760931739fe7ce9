// A pool table: press anywhere, and the cue ball rolls there, the faster the farther.
#include "sketch.hpp"
using namespace demo;

//> The sketch: a pool table
struct Pool : Scene {
    static constexpr double radius = 0.3; // [m]
    std::vector<nt_collisions::Ball> balls;

    View view() const override { return {{0, 0}, {16, 9}, Stage::felt}; }
    void begin() override {
        balls = {{{3, 4.5}, {9, 0.3}, radius, 1}};
        for (int row = 0; row < 5; ++row)
            for (int i = 0; i <= row; ++i)
                balls.push_back({{10 + 0.53 * row, 4.5 + 0.61 * (i - row / 2.0)}, {0, 0}, radius, 1});
    }
    void press(const Vec2 &at) override { balls[0].velocity = 2 * (at - balls[0].position); }
    void step(double dt) override {
        for (auto &ball : balls) {
            ball.velocity = inclined_planes::table_friction(ball.velocity, 1, dt);
            ball.velocity = reflection::bounce_in_box({ball.position, ball.velocity, radius}, {{0, 0}, {16, 9}});
            ball.position += dt * ball.velocity;
        }
        for (std::size_t i = 0; i < balls.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) meet(balls[k], balls[i]);
    }
    static void meet(nt_collisions::Ball &a, nt_collisions::Ball &b) {
        if ((b.position - a.position).norm() > 2 * radius) return;
        const auto after = nt_collisions::resolve_collision(a, b, 0.95);
        a.velocity = after.a;
        b.velocity = after.b;
    }
    void draw(Canvas &canvas) const override {
        for (const auto &ball : balls) canvas.ball(ball.position, radius, Colour::orange);
        canvas.ball(balls[0].position, radius, Colour::ink);
    }
};
SKETCH(Pool, "A pool table")
