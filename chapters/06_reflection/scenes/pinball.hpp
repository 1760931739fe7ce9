#pragma once
// Pinball: an arrow key or a press at its side lifts a flipper, and either of them shoots the ball that waits.
#include "shared.hpp"

namespace play {

struct Table : Scene {
    static constexpr std::string_view name = "pinball (6.7)";
    static constexpr std::size_t flippers = 2, round_ones = 5;
    HeldKey keys[2]{held("left flipper", "ArrowLeft"), held("right flipper", "ArrowRight")};
    const Ball waiting{{15.1, 0.72}, {0, 0}, 0.22};
    Pinball game{waiting, {}, 0, false};
    double lit[round_ones]{}; ///< how bright each bumper is
    std::vector<Vec2> way;
    int balls = 3, best = 0, shots = 0;
    double gone_for = 0; ///< [s]

    Table() { still_time = 3.2; }

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void begin() override {
        constexpr Surface rubber{0.5, 0.02}, kicks{1.3, 0};
        game.bumpers = {{{5.15, 1.45}, {6.75, 0.6}, 0.17, rubber}, {{9.75, 1.45}, {8.15, 0.6}, 0.17, rubber}};
        for (const Vec2 &at : {Vec2{3.6, 6.2}, {7.5, 7}, {11.4, 6.2}, {5.5, 4.6}, {9.5, 4.6}})
            game.bumpers.push_back({at, at, 0.6, kicks, 0, 100});
        for (const double side : {-1.0, 1.0}) // above each flipper
            game.bumpers.push_back({{7.45 + side * 4.4, 3.5}, {7.45 + side * 3.4, 2.9}, 0.14, {1.2, 0}, 0, 10});
        const Vec2 outline[]{{5.1, 1.6},   {0.5, 3.1},   {0.5, 7},    {2, 8.5},    {14.2, 8.5}, {15.6, 7.1},
                             {15.6, 0.44}, {14.6, 0.44}, {14.6, 6.6}, {14.6, 3.1}, {9.8, 1.6}};
        for (std::size_t i = 1; i < std::size(outline); ++i)
            game.bumpers.push_back({outline[i - 1], outline[i], 0.06, rubber});
    }
    void take_over() override { start(); }
    void start() {
        best = std::max(best, game.score);
        balls = 3;
        game.score = 0;
        next_ball();
    }
    void next_ball() {
        game.ball = waiting;
        game.over = false;
        gone_for = 0;
        way.clear();
    }
    bool waits() const { return game.ball.position.x() > 14.6 && game.ball.position.y() < 0.8; }
    bool is_wanted(int side) const {
        const Vec2 &at = game.ball.position;
        if (untouched) return !waits() && at.y() < 1.35 && game.ball.velocity.y() < 0 && (at.x() < 7.45) == (side == 0);
        return keys[side] || (hand.down && (hand.at.x() < 7.45) == (side == 0));
    }
    void step(double dt) override {
        for (double &each : lit) each = std::max(0.0, each - 2.5 * dt);
        const bool left = is_wanted(0), right = is_wanted(1);
        if (game.over) {
            if ((gone_for += dt) < 1 || (balls == 1 && !untouched && !left && !right)) return;
            if (balls == 1) return start();
            --balls;
            return next_ball();
        }
        if (waits() && (untouched || left || right)) game.ball.velocity.y() = 13 + 0.37 * (++shots % 6);
        next_frame(game, left, right, dt);
        for (std::size_t i = 0; i < round_ones; ++i)
            if (game.bumpers.at(flippers + i).touched) lit[i] = 1;
        way.push_back(game.ball.position);
        if (way.size() > 24) way.erase(way.begin());
    }

    void draw(Canvas &canvas) const override {
        for (std::size_t i = 0; i < game.bumpers.size(); ++i) {
            const Bumper &each = game.bumpers[i];
            const bool is_round = i >= flippers && i < flippers + round_ones;
            if (is_round) canvas.lamp(each.start, each.radius, lit[i - flippers] > 0 ? Colour::amber : Colour::violet);
            else if (each.points > 0)
                canvas.beam({each.start, each.end}, each.touched ? Colour::amber : Colour::pink, 9);
            else if (i >= flippers) canvas.beam({each.start, each.end}, Colour::blue, 5);
        }
        for (std::size_t i = 0; i < flippers; ++i)
            canvas.bar({game.bumpers[i].start, game.bumpers[i].end}, Colour::orange, 15);
        canvas.trail(way, Colour::pink, 11);
        if (!game.over) canvas.ball(game.ball.position, game.ball.radius, Colour::ink);
        canvas.plate({12.4, 0.8}, std::to_string(game.score), Colour::amber, 30);
        for (int i = 1; i < balls; ++i) canvas.ball({0.2 + 0.6 * i, 0.8}, 0.22, Colour::ink); // still to come
        if (game.over && balls == 1)
            canvas.plate({7.45, 3}, game.score > best ? "the best so far" : "best: " + std::to_string(best),
                         Colour::green, 30);
    }
};
} // namespace play
