// A board of nails: one ball after the other bounces down through it, and each column counts its own.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;

//> The sketch: a board of nails
struct Nails : Scene {
    std::vector<reflection::Bumper> nails;
    std::vector<reflection::Pinball> games; // one for each ball
    int frames = 0, landed[17]{};

    Nails() { still_time = 60; }
    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void begin() override {
        for (int i = 0; i < 8 * 17; ++i) {
            const Vec2 at{i % 17 - 0.5 * (i / 17 % 2), 8.4 - 0.7 * (i / 17)};
            nails.push_back({at, at, 0.08, {0.3, 0}});
        }
    }
    void step(double dt) override {
        if (++frames % 24 == 1) games.push_back({{{7.9 + 0.2 * course::chance(1, frames), 9}, {0, 0}, 0.15}, nails});
        for (auto &game : games) {
            game = reflection::play_pinball(game, {0, -6}, dt);
            if (game.over) ++landed[std::clamp(int(game.ball.position.x() + 0.5), 0, 16)];
        }
        std::erase_if(games, [](const auto &game) { return game.over; });
    }
    void draw(Canvas &canvas) const override {
        for (int i = 0; i <= 16; ++i) canvas.area(box({i - 0.4, 0}, {i + 0.4, 0.08 * landed[i]}), Colour::blue);
        for (const auto &nail : nails) canvas.ball(nail.start, nail.radius, Colour::line);
        for (const auto &game : games) canvas.ball(game.ball.position, game.ball.radius, Colour::amber);
    }
};
SKETCH(Nails, "A board of nails")
