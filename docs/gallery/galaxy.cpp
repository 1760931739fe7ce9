// A galaxy of two thousand stars around a black hole. The pointer is a second hole: pull the arms apart.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;

struct Galaxy : Scene {
    static constexpr double pull = 900; // of the hole in the middle, as mu [m³/s²]
    Slider second_pull = slider("second hole", "m³/s²", 0, 600, 50, 100);
    std::vector<motion::State> stars;
    course::Dice dice{5};
    double time = 0; // [s]

    View view() const override { return {{-32, -18}, {32, 18}, Stage::night}; }
    void begin() override {
        while (stars.size() < 2000) stars.push_back(star_at(2 + 16 * dice.one()));
    }
    /// A star of one of two arms, fast enough to stay on its circle.
    motion::State star_at(double radius) {
        const double arm = dice.one() < 0.5 ? 0 : std::numbers::pi, spread = 1.6 * (dice.one() - 0.5);
        const double angle = arm + spread + 2.5 * std::log(radius);
        const Vec2 out{std::cos(angle), std::sin(angle)}, along{-out.y(), out.x()};
        return {radius * out, gravity_wells::circular_orbit_speed(pull, radius, 1) * along};
    }
    /// Where the second hole is: it comes by itself, until somebody leads it.
    Vec2 second() const {
        if (hand.inside) return hand.at;
        return {24 * std::cos(0.4 * time), 14 * std::sin(0.4 * time)};
    }

    void step(double dt) override {
        time = std::fmod(time + dt, 5 * std::numbers::pi); // once round
        for (motion::State &star : stars) {
            const Vec2 near = gravity_wells::softened_gravity(star.position, pull, 1);
            const Vec2 far = gravity_wells::softened_gravity(star.position - second(), second_pull, 1);
            star = motion::accelerated_motion(star, near + far, dt);
            if (!(star.position.norm() < 40)) star = star_at(2 + 16 * dice.one()); // lost: another one comes
        }
    }

    void draw(Canvas &canvas) const override {
        std::vector<Spark> old, young;
        for (const motion::State &star : stars) {
            const double heat = std::min(1.0, star.velocity.norm() / 20); // fast ones are bright
            (star.position.norm() < 8 ? old : young).push_back({star.position, 0.18, 0.25 + 0.6 * heat});
        }
        canvas.sparks(young, Colour::blue);
        canvas.sparks(old, Colour::amber);
        draw_hole(canvas, {0, 0}, 1);
        draw_hole(canvas, second(), second_pull / pull);
    }
    static void draw_hole(Canvas &canvas, const Vec2 &at, double size) {
        if (size <= 0) return;
        canvas.lamp(at, 0.4 + 0.5 * size, Colour::violet);
        canvas.dot(at, 0.3 + 0.45 * size, Colour::ink);
    }
};
SKETCH(Galaxy, "A galaxy, and a second black hole")
