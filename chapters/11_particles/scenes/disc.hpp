#pragma once
// A disc beside the usual mistake, in four rings of equal area: the more sparks one has, the brighter it is.
#include "shared.hpp"

namespace play {

struct Disc : Show {
    static constexpr std::string_view name = "a disc (11.5)";
    static constexpr double speed = 3.1, life = 1.5; // of the fastest [m/s], and [s]
    static constexpr int count = 100;
    Button again = button("x", "Burst", [this] { both(); });
    const Vec2 left{6.5, 7.1}, right{17.5, 7.1};

    Disc() : Show(2 * count) { still_time = 1.9; }

    World world() const override { return {0, 0, width, height}; } // so that a disc stays where it is
    void both() {
        since = 0;
        for (auto &slot : pool) slot.reset();
        spawn(burst(at(left), disc_burst(random.many(2 * count), speed), life));
        spawn(burst(at(right), mistaken_disc(random, count, speed), life));
    }
    void press(const Vec2 &) override { both(); }
    void begin() override { both(); }
    void step(double dt) override {
        Show::step(0.6 * dt); // in slow motion
        if (since > 1.6) both();
    }

    void draw(Canvas &canvas) const override {
        draw_half(canvas, left, "your disc");
        draw_half(canvas, right, "the usual mistake");
        draw_sparks(canvas, alive(), 0.17, 0, 0.25);
    }
    /// Of few corners, because a still picture keeps all of them.
    static std::vector<Vec2> circle(const Vec2 &middle, double radius) {
        std::vector<Vec2> corners;
        for (int i = 0; i <= 36; ++i)
            corners.push_back(
                middle + radius * Vec2{std::cos(i * std::numbers::pi / 18), std::sin(i * std::numbers::pi / 18)});
        return corners;
    }
    void draw_half(Canvas &canvas, const Vec2 &middle, const std::string &words) const {
        const double outer = speed * std::min(since, life);
        int counts[4]{};
        for (const Particle &spark : alive()) {
            const double part = (spark.position - middle).squaredNorm() / (outer * outer); // of the disc's area
            if (part < 1.5) ++counts[std::clamp(int(4 * part), 0, 3)];
        }
        for (int i = 0; i < 4; ++i) {
            std::vector<Vec2> ring = circle(middle, outer * std::sqrt((i + 1) / 4.0));
            const std::vector<Vec2> hole = circle(middle, outer * std::sqrt(i / 4.0));
            if (i == 0) canvas.line(ring, Colour::blue, 2);
            ring.insert(ring.end(), hole.rbegin(), hole.rend());
            canvas.area(std::move(ring), Colour::blue).strength = std::min(0.8, std::pow(counts[i] / 60.0, 1.3));
        }
        canvas.text({middle.x(), -0.85}, words, Colour::ink, 22, Anchor::middle);
        if (since > 0.4 && since < life)
            canvas.plate({middle.x(), 1.3}, number(counts[0], 0) + " in the middle", Colour::blue, 24);
    }
};
} // namespace play
