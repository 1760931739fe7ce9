// A confetti cannon: press, and it fires at your finger. The wind turns.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;

//> The sketch: a confetti cannon
struct Confetti : Scene {
    const Vec2 muzzle{8, 0.5};
    std::vector<motion::State> pieces;
    int frames = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void press(const Vec2 &at) override {
        const Vec2 aim = at - muzzle;
        const double angle_deg = std::atan2(aim.y(), aim.x()) * 180 / std::numbers::pi;
        for (int i = 0; i < 80; ++i) {
            const double speed = 60 * course::chance(i, frames), aside = 40 * course::chance(frames, i) - 20;
            pieces.push_back({muzzle, trajectories::launch_velocity(speed, angle_deg + aside)});
        }
        if (pieces.size() > 480) pieces.erase(pieces.begin(), pieces.begin() + 80);
    }
    void step(double dt) override {
        if (frames++ % 30 == 0 && untouched) press({8 + 5 * std::sin(0.7 * frames), 7});
        const Vec2 wind{3 * std::sin(0.015 * frames), 0};
        for (auto &piece : pieces)
            if (piece.position.y() > 0) piece = trajectories::drag_step(piece, 10, 0.3, wind, dt);
    }
    void draw(Canvas &canvas) const override {
        constexpr Colour colours[]{Colour::amber, Colour::pink, Colour::blue, Colour::green, Colour::orange};
        for (std::size_t i = 0; i < pieces.size(); ++i) canvas.dot(pieces[i].position, 0.09, colours[i % 5]);
        canvas.bar({muzzle - Vec2{0, 0.5}, muzzle}, Colour::wood, 24);
    }
};
SKETCH(Confetti, "A confetti cannon")
