#pragma once
// Which way does each of two equal balls go? Two guesses are arrows; how far off they are is said when it's known.
#include "meeting.hpp"

namespace play {

struct Opening : Meeting {
    static constexpr std::string_view name = "you guess";
    static constexpr double length = 2; ///< of an arrow [m]
    Handle tips[2]{tip(Colour::orange), tip(Colour::blue)};
    Button roll_them = button("f", "Roll", [this] { shoot(); });
    Button another = button("s", "New", [this] { next_contact(); });
    Vec2 n{0.8, 0.6}; ///< from A's centre to B's where they meet; its length is 1
    bool rolling = false;
    int round = 0;
    std::vector<Vec2> misses; ///< of the last five guesses: of A, and of B [rad]

    Opening() { still_time = 1.6; }

    Handle tip(Colour colour) { return handle({0, 0}, view().low, view().high, colour); }
    View view() const override { return {{-5.6, -3.15}, {5.6, 3.15}, Stage::felt}; }
    /// Where a ball's centre is when they meet.
    Vec2 centre(int i) const { return i == 0 ? Vec2{-n} : Vec2{0, 0}; }
    Vec2 guess(int i) const {
        const Vec2 way = tips[i].at() - centre(i);
        return way.norm() > 0.01 ? Vec2{way.normalized()} : Vec2{1, 0};
    }
    void aim(int i, const Vec2 &way) { tips[i].move(centre(i) + length * way); }
    void back() {
        place(n, {{0, 0}, {5, 0}, 0.5, 1}, {{0, 0}, {0, 0}, 0.5, 1}, 48);
        rolling = false;
    }
    void begin() override {
        back();
        for (int i : {0, 1}) aim(i, {1, 0});
    }
    void take_over() override { back(); }
    void drag() override {
        for (int i : {0, 1}) aim(i, guess(i));
        back();
    }
    void shoot() {
        back();
        rolling = true;
    }
    void next_contact() {
        course::Dice dice{40u * unsigned(++round)};
        dice.roll();
        const double angle = 2 * dice.one() - 1; // [rad]
        n = {std::cos(angle), std::sin(angle)};
        begin();
    }

    void move(double dt) override { next_frame(a, b, dt); }
    void step(double dt) override {
        if (untouched) return wonder(dt);
        if (!rolling) return;
        const bool known = met;
        roll(dt);
        if (met && !known) mark();
        if (met && since > 0.6) rolling = false;
    }
    /// By itself A only comes, and both arrows turn where no ball goes.
    void wonder(double dt) {
        since += dt;
        if (since < 0.8) {
            a.position += dt * a.velocity;
            paths[0].push_back(a.position);
        }
        const double part = 0.5 - 0.5 * std::cos(2 * since); // of the way that the arrows turn
        for (int i : {0, 1}) aim(i, Vec2{std::cos(1.5 * part), (i == 0 ? 1 : -1) * std::sin(1.5 * part)});
        if (since > std::numbers::pi) back();
    }
    void mark() {
        misses.push_back({turn(a.velocity, guess(0)), turn(b.velocity, guess(1))});
        if (misses.size() > 5) misses.erase(misses.begin());
    }

    void draw(Canvas &canvas) const override {
        for (int i : {0, 1}) draw_outline(canvas, centre(i), 0.5, colours[i]);
        for (int i : {0, 1}) draw_guess(canvas, i);
        draw_both(canvas);
        for (int i : {0, 1}) draw_words(canvas, i);
    }
    const Ball &ball(int i) const { return i == 0 ? a : b; }
    void draw_guess(Canvas &canvas, int i) const {
        canvas.arrow(centre(i), tips[i], colours[i], 4);
        if (!met) return;
        const Vec2 went = ball(i).velocity.normalized();
        draw_angle(canvas, centre(i), 1.4, guess(i), went, colours[i]);
        for (const Vec2 &each : misses) { // around where each ball went, as holes around the middle of a target
            const Vec2 off = std::cos(each[i]) * went + std::sin(each[i]) * turned(went);
            canvas.dot(centre(i) + length * off, 0.1, Colour::ink);
        }
    }
    void draw_words(Canvas &canvas, int i) const {
        const Vec2 beside = tips[i].at() + 0.6 * guess(i);
        if (!met) return void(canvas.plate(beside, i == 0 ? "A?" : "B?", colours[i], 24));
        canvas.plate(beside, number(angle_between(guess(i), ball(i).velocity), 0) + "° off", colours[i], 24);
        canvas.plate(ball(i).position + 0.95 * ball(i).velocity.normalized(), number(ball(i).velocity.norm(), 1, "m/s"),
                     Colour::ink, 18);
    }
};
} // namespace play
