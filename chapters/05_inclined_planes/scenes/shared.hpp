#pragma once
// A box on a board that is lifted: what most scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"
#include "counter.hpp"

namespace play {
using namespace demo;
using namespace inclined_planes;

constexpr int parts = 16; ///< of each frame, so that the last one before a stop is short

inline Vec2 at_degrees(double angle_deg) { return {std::cos(angle_deg * degree), std::sin(angle_deg * degree)}; }

/// The board follows the ring at its end, and the box slides if it isn't held. Once it's down, it waits for a flat board.
struct BoardScene : Scene {
    static constexpr double length = 9, start = 6.7; ///< of the board, and how far up it the box lies at first [m]
    static constexpr double flat = 10;               ///< where the board is at first [°]
    const Vec2 foot{-6.5, 0};                        ///< of the board [m]
    Handle end = handle(foot + length * at_degrees(flat), foot, foot + Vec2{length, length});
    double angle_deg = flat, goal_deg = flat; ///< of the board, and where it's lifted to
    double lift = 40;                         ///< how fast [°/s]
    Sliding it;
    double since_down = -1; ///< how long it has been on the ground [s]; negative: not yet

    /// The steeper the board, the wider; about its foot, so that a hand at its end keeps its angle.
    View view() const override {
        const double wide = 15.6 + 4.6 * std::clamp((angle_deg - 30) / 35, 0.0, 1.0);
        const Vec2 low = foot - wide * Vec2{0.17, 0.09};
        return {low, low + wide * Vec2{1, 9.0 / 16}, Stage::workshop, 0};
    }
    virtual Box box() const { return {10, 0.5, 0.3}; }
    /// How far the board is to be lifted while nobody touches it [°].
    virtual double film() const = 0;
    virtual void slips() {}

    double angle() const { return angle_deg * degree; }
    Vec2 along() const { return at_degrees(angle_deg); }
    double size() const { return box().mass > 20 ? 2.2 : 1.6; }
    bool down() const { return since_down >= 0; }

    void set_goal(double degrees) {
        goal_deg = std::clamp(degrees, 0.0, 90.0);
        end.move(foot + length * at_degrees(goal_deg));
    }
    void put_back() {
        it = {};
        since_down = -1;
    }
    void take_over() override {
        put_back();
        set_goal(flat);
        angle_deg = flat;
    }
    void drag() override {
        const Vec2 there = end.at() - foot;
        set_goal(std::round(std::atan2(there.y(), there.x()) / degree));
    }
    void step(double dt) override {
        if (untouched) set_goal(film());
        angle_deg += std::clamp(goal_deg - angle_deg, -lift * dt, lift * dt);
        if (down()) {
            since_down += dt;
            if (angle_deg <= flat + 2 && since_down > 0.6) put_back();
            return;
        }
        const bool rested = it.speed == 0;
        for (int i = 0; i < parts; ++i) next_frame(it, box(), angle(), dt / parts);
        if (rested && it.speed != 0) slips();
        if (it.way >= start) since_down = 0;
    }

    /// Its lower left corner, and the direction of its sole; on the ground it lies in front of the board.
    std::pair<Vec2, Vec2> place() const {
        const double part = std::clamp(since_down / 0.15, 0.0, 1.0);
        const Vec2 on = foot + (start - std::min(it.way, start)) * along(), below = foot - Vec2{size() + 0.15, 0};
        return {on + part * (below - on), at_degrees(down() ? (1 - part) * angle_deg : angle_deg)};
    }
    Vec2 middle() const {
        const auto [low, right] = place();
        return low + size() / 2 * (right + turned(right));
    }
    void draw_board(Canvas &canvas) const {
        const Vec2 up = turned(along()), tip = foot + length * along();
        for (int i = 1; i < 10; ++i) { // a protractor
            const Vec2 way = at_degrees(10 * i);
            canvas.line({foot + 9.3 * way, foot + 9.7 * way}, Colour::ink, 2).strength = 0.5;
        }
        canvas.line(arc(foot, 9.5, 0, std::numbers::pi / 2), Colour::ink, 1.5).strength = 0.35;
        canvas.bar({{tip.x(), 0}, {tip.x(), std::max(0.0, tip.y() - 0.4)}}, Colour::dim, 6); // a jack
        canvas.bar({{tip.x(), 0}, {tip.x(), std::max(0.0, 0.5 * tip.y() - 0.2)}}, Colour::ink, 13);
        canvas.area(sector(foot, 2.6, 0, angle()), Colour::amber).strength = 0.6;
        canvas.body({foot, tip, tip - 0.4 * up, foot - 0.4 * up}, Colour::wood);
        canvas.ball(foot - 0.2 * up, 0.35, Colour::ink);
        canvas.plate(foot + 3.5 * at_degrees(angle_deg / 2) - Vec2{0, 0.2}, number(angle_deg, 0) + "°", Colour::ink,
                     22);
    }
    void draw_box(Canvas &canvas) const {
        const auto [low, right] = place();
        if (it.speed > 0.3 && !down()) { // dust behind it
            std::vector<Spark> dust;
            for (int i = 0; i < 6; ++i)
                dust.push_back({low + (size() + 0.2 + 0.3 * i) * right
                                    + (0.12 + 0.1 * ((i * 5 + int(9 * it.way)) % 4)) * turned(right),
                                0.25 + 0.04 * i, std::min(1.0, 0.5 * it.speed)});
            canvas.puffs(dust, Colour::earth);
        }
        crate(canvas, low, size(), right);
    }
};
} // namespace play
