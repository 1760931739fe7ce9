#pragma once
// Which angle throws farthest? Each landing leaves a flag.
#include "shared.hpp"

namespace play {

struct Opening : CannonScene {
    static constexpr std::string_view name = "you guess";
    Slider raised = slider("muzzle above the ground", "m", 0, 25, 5, 0);
    Handle aim = handle({14, 5}, {0, -8}, {34, 40});
    Button again = button("f", "Fire", [this] { fire(); });
    std::vector<Mark> marks;
    std::size_t shots = 0;

    Opening() { still_time = 12; }

    double angle_deg() const override {
        const Vec2 away = aim.at() - Vec2{0, height};
        return std::clamp(std::atan2(away.y(), std::max(away.x(), 1e-3)) * 180 / std::numbers::pi, -45.0, 90.0);
    }
    double time_until_landing(const State &from) const override { return time_of_flight(from, g); }
    /// It shows all flags, the shot and the ring, and stands still under a hand.
    double target_width() const override {
        if (hand.down) return wide;
        const auto &[at, velocity] = shell.state;
        const double rising = std::max(0.0, velocity.y());
        double far = at.x() + shell.left * velocity.x(), top = at.y() + rising * rising / (2 * g);
        for (const Vec2 &been : shell.path) top = std::max(top, been.y());
        for (const Mark &mark : marks) far = std::max(far, mark.value);
        return shots > 5 ? 112 : width_for(far, std::max({top, aim.at().y() - 2, height + 12}));
    }

    void take_over() override { forget(); }
    void forget() {
        marks.clear();
        shots = 0;
        shell = {};
    }
    void begin() override {
        changed();
        CannonScene::begin();
    }
    void changed() override {
        aim.move(aim.at() + Vec2{0, raised - height});
        height = raised;
        forget();
    }
    void let_go() override { fire(); }
    void press(const Vec2 &at) override {
        aim.move(at);
        fire();
    }
    void step(double dt) override {
        constexpr double film[]{20, 35, 70};
        if (untouched && !shell.flying && pause <= dt) {
            if (shots == 3) forget();
            const double angle = film[shots] * std::numbers::pi / 180;
            aim.move(Vec2{15 * std::cos(angle), 15 * std::sin(angle)});
        }
        if (!untouched && !shell.flying) pause = 1; // it waits for its reader
        CannonScene::step(dt);
    }
    void landed() override {
        ++shots;
        if (marks.size() == 8) marks.erase(marks.begin());
        marks.push_back({shell.state.position, shell.state.position.x(), shell.whole()});
    }

    void draw(Canvas &canvas) const override {
        double best = 0;
        for (const Mark &mark : marks) best = std::max(best, mark.value);
        for (const Mark &mark : marks) canvas.line(mark.path, Colour::dim, 2).strength = 0.55;
        if (shots > 5) draw_envelope(canvas);
        if (height <= 0) draw_crates(canvas);
        draw_cannon(canvas);
        for (std::size_t i = 0; i < marks.size(); ++i)
            flag(canvas, marks[i].at, number(marks[i].value, 1, "m"),
                 marks[i].value == best ? Colour::green : Colour::ink, 3.5 + 4.5 * double(i % 3), 20);
        draw_shell(canvas);
        canvas.dotted({{0, height}, aim}, Colour::ink);
        canvas.plate(aim.at() + Vec2{0, 3}, number(angle_deg(), 0) + "°", Colour::ink, 20);
    }
    /// No shell gets beyond it, whatever the angle.
    void draw_envelope(Canvas &canvas) const {
        const double top = speed * speed / (2 * g);
        std::vector<Vec2> points;
        for (int x = 0; x <= 96; x += 4) points.push_back({double(x), height + top - x * x / (4 * top)});
        std::erase_if(points, [](const Vec2 &point) { return point.y() < 0; });
        canvas.dotted(std::move(points), Colour::violet, 3);
    }
};
} // namespace play
