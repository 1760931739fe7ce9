#pragma once
// Off the cushions to a target: the ball rolls straight on through tables that are seen in mirrors, and on the real one.
#include "shared.hpp"

namespace play {

struct Pool : Scene {
    static constexpr std::string_view name = "bank shot (6.6)";
    Slider across = slider("across", "", -1, 1, 1, 0);
    Slider up = slider("up", "", -1, 1, 1, 0);
    const Box table{{-2.875, -1.725}, {2.875, 1.725}};
    const Ball cue{{-1.955, -0.92}, {0, 0}, 0.23};
    const Vec2 low{table.low + Vec2{0.23, 0.23}}, high{table.high - Vec2{0.23, 0.23}}; // where the ball's centre turns
    const Vec2 in_the_way{0.575, 0.4255};
    Handle target = handle({1.725, 1.035}, low, high);
    int shots = 0;
    double way = 0, pause = 0.3; ///< how far the ball has rolled [m], and until it does [s]
    bool rolls = false;
    Vec2 at{cue.position}, before{at};
    std::vector<Vec2> path;
    View seen{};

    Pool() { still_time = 1.9; }

    View view() const override { return seen; }
    /// How many tables away the image is; left alone, none of these shots gets there.
    int tables(int axis) const {
        constexpr int film[][2]{{0, 0}, {1, 0}, {0, -1}, {1, 1}};
        return untouched ? film[shots % 4][axis] : int(axis == 0 ? across : up);
    }
    Vec2 shift() const { return {tables(0) * (high - low).x(), tables(1) * (high - low).y()}; }
    Vec2 image() const {
        const auto mirrored = [](double x, int count) { return count % 2 == 0 ? x : -x; }; // about the middle
        return shift() + Vec2{mirrored(target.at().x(), tables(0)), mirrored(target.at().y(), tables(1))};
    }
    double whole() const { return (image() - cue.position).norm(); }
    Vec2 direction() const { return bank_shot(cue, target, table, tables(0), tables(1)); }
    bool is_blocked() const { return (at - in_the_way).norm() < 2 * cue.radius; }

    void back() {
        at = before = cue.position;
        path.clear();
        way = 0;
        rolls = false;
        pause = 0.3;
    }
    /// The real table, and the image.
    View target_view() const {
        const Vec2 margin{0.5, 0.42}, edge{0.45, 0.5};
        const Vec2 corner = (table.low - margin).cwiseMin(image() - edge);
        const Vec2 other = (table.high + margin).cwiseMax(image() + edge);
        const Vec2 middle = (corner + other) / 2, size = other - corner;
        const double half = std::max(size.x(), size.y() * 16 / 9) / 2;
        return {middle - Vec2{half, half * 9 / 16}, middle + Vec2{half, half * 9 / 16}, Stage::felt};
    }
    void begin() override { seen = target_view(); }
    void take_over() override { back(); }
    void changed() override { back(); }
    void drag() override {
        const Vec2 away = target.at() - cue.position;
        if (away.norm() < 0.7) target.move(cue.position + 0.7 * (away + Vec2{1e-6, 0}).normalized());
        back();
    }
    void step(double dt) override {
        if (hand.down) return; // the camera stands still, too
        const View wanted = target_view();
        seen.low += std::min(1.0, 5 * dt) * (wanted.low - seen.low);
        seen.high += std::min(1.0, 5 * dt) * (wanted.high - seen.high);
        if (!rolls) {
            if ((pause -= dt) > 0) return;
            if (way > 0) back(), ++shots;
            else rolls = true;
            return;
        }
        way = std::min(way + 3 * dt, whole());
        before = at;
        at = rolled(cue, table, direction(), way);
        path.push_back(at);
        rolls = way < whole() && !is_blocked();
        if (!rolls) pause = 1.6;
    }

    void draw(Canvas &canvas) const override {
        draw_tables(canvas);
        const Vec2 to = direction(), aimed = cue.position + whole() * to;
        canvas.beam({cue.position, aimed}, Colour::violet, 3);
        draw_target(canvas, target, 1);
        if (shift() != Vec2{0, 0}) draw_target(canvas, image(), 0.45);
        canvas.trail(path, Colour::orange, 6);
        canvas.ball(in_the_way, cue.radius, Colour::dim);
        if (way > 0 && shift() != Vec2{0, 0}) canvas.dotted(arc(cue.position + way * to, cue.radius), Colour::ink, 3);
        rolling_ball(canvas, at, cue.radius, at - before, way);
        if (rolls || way <= 0) return;
        const double off = (at - target.at()).norm();
        if (is_blocked()) canvas.plate(in_the_way + Vec2{-0.9, 0.45}, "blocked", Colour::pink, 26);
        else if (off < 0.01) canvas.plate(at + Vec2{0, 0.45}, "there", Colour::green, 28);
        else canvas.plate(at + Vec2{0, 0.45}, number(off, 1, "m away"), Colour::pink, 24);
    }
    /// As far as the ball's centre gets, each table ends where its neighbour in the mirror begins.
    void draw_tables(Canvas &canvas) const {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y) {
                const Vec2 by{x * (high - low).x(), y * (high - low).y()};
                const bool chosen = x == tables(0) && y == tables(1);
                if (x != 0 || y != 0)
                    canvas.area(box(low + by, high + by), Colour::green).strength = chosen ? 0.3 : 0.1;
            }
        canvas.dotted({low, {high.x(), low.y()}, high, {low.x(), high.y()}, low}, Colour::ink, 2).strength = 0.5;
        rails(canvas, table.low, table.high, 0, 0.1, Colour::green);
        rails(canvas, table.low, table.high, 0.1, 0.24, Colour::wood);
    }
    static void draw_target(Canvas &canvas, const Vec2 &where, double strength) {
        canvas.body(arc(where, 0.26), Colour::pink).strength = strength;
        canvas.body(arc(where, 0.17), Colour::line).strength = strength;
        canvas.body(arc(where, 0.08), Colour::pink).strength = strength;
    }
};
} // namespace play
