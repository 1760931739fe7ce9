#pragma once
// Where's the hand? A guess, and how far off it is.
#include "shared.hpp"

namespace play {

struct Opening : Scene {
    static constexpr std::string_view name = "you guess";
    const std::vector<Vec2> film{{4, 2}, {1.2, 3.3}, {4.9, 0.8}, {2, 1}}; // none of them is right
    Handle guess = handle(film[0], {-2.2, -0.2}, {6.6, 4.3});
    Button show = button("f", "Show", [this] { reveal(); });
    Button other = button("n", "New", [this] { next_round(); });
    Link first{3, 30 * degree}, second{2, 45 * degree};
    std::vector<Vec2> misses; ///< from the hand to the last five guesses [m]
    unsigned round = 0;
    bool shown = false;
    double time = 0, since = 0; ///< the answer has been shown [s]

    Opening() { still_time = 1; }

    View view() const override { return {{-2.2, -0.75}, {6.6, 4.2}, Stage::night}; }
    Vec2 hand_at() const { return two_links(first, second).hand; }
    void reveal() {
        if (shown) return;
        shown = true;
        since = 0;
        misses.push_back(guess.at() - hand_at());
        if (misses.size() > 5) misses.erase(misses.begin());
    }
    /// Another arm that stays above the table.
    void next_round() {
        shown = false;
        course::Dice dice{++round * 2654435761u};
        const auto whole = [&](int count) { return std::floor(count * dice.one()); };
        for (int i = 0; i < 1000; ++i) {
            const double l1 = 1.5 + 0.5 * whole(5), a1 = 15 * whole(7), l2 = 1 + 0.5 * whole(4),
                         a2 = 15 * (whole(13) - 6);
            first = {l1, a1 * degree};
            second = {l2, a2 * degree};
            const Vec2 at = hand_at();
            if (a2 != 0 && at.x() > 0.3 && at.x() < 4.8 && at.y() > 0.2 && at.y() < 3.6) return;
        }
    }
    void take_over() override { guess.move({4, 2}); }
    void press(const Vec2 &at) override { guess.move(at); }
    void step(double dt) override {
        since += dt;
        if (!untouched) return;
        time += dt; // it only wonders
        const std::size_t leg = std::size_t(time / 1.2);
        const Vec2 &from = film[leg % film.size()], &to = film[(leg + 1) % film.size()];
        guess.move(from + eased(time - 1.2 * double(leg), 0, 0.9) * (to - from));
    }

    void draw(Canvas &canvas) const override {
        for (int x = -2; x <= 6; ++x) canvas.line({{double(x), -1}, {double(x), 4.3}}, Colour::dim, 1).strength = 0.35;
        for (int y = 0; y <= 4; ++y) canvas.line({{-3, double(y)}, {7, double(y)}}, Colour::dim, 1).strength = 0.35;
        canvas.body(box({-2.4, -0.9}, {6.8, -0.35}), Colour::wood);
        draw_foot(canvas, {0, 0}, 0.35);
        const Vec2 at = guess;
        const auto set_up = [](const Link &link, const char *how) {
            const bool half = std::abs(2 * link.length - 2 * std::floor(link.length)) > 0.5;
            return number(link.length, half ? 1 : 0, "m") + how + number(link.angle / degree, 0) + "°";
        };
        canvas.plate({2.2, -0.62}, set_up(first, " at ") + ", then " + set_up(second, ", bent by "), Colour::ink, 20);
        if (shown) draw_answer(canvas);
        else canvas.ball({0, 0}, 0.17, Colour::ink);
        if (!shown) canvas.plate(at + Vec2{0, 0.45}, "hand?", Colour::orange, 24);
        canvas.lamp(at, 0.09, Colour::orange);
    }
    /// The arm unfolds; the last guesses stay around its hand, as holes around the middle of a target.
    void draw_answer(Canvas &canvas) const {
        const double part = eased(since, 0, 0.6);
        const auto [elbow, hand_now] =
            two_links({first.length, part * first.angle}, {second.length, part * second.angle});
        steel_arm(canvas, {{0, 0}, elbow, hand_now}, Colour::dim, 20, 0.14);
        if (part < 1) return;
        const Vec2 at = guess, right = hand_at();
        for (const Vec2 &miss : misses) canvas.lamp(right + miss, 0.06, Colour::amber);
        canvas.dotted({at, right}, Colour::orange, 3);
        const double aside = at.y() > right.y() && at.y() < 3.4 ? 0.45 : -0.5; // away from the hand
        canvas.plate({std::clamp(at.x(), -1.4, 5.8), at.y() + aside}, number((at - right).norm(), 2, "m off"),
                     Colour::orange, 24);
    }
};
} // namespace play
