#pragma once
// A cannon among hills, and its shell: what the scenes of this chapter share.
#include "../../props.hpp"
#include "../../scene.hpp"
#include "../game.hpp"
#include "bits.hpp"

namespace play {
using namespace demo;
using namespace trajectories;

/// A shell that flies, or has landed, and where it has been.
struct Shell {
    State state{{0, 0}, {0, 0}};
    double left = 0; ///< until it lands [s]
    double time = 0; ///< since it was fired [s]
    bool flying = false;
    std::vector<Vec2> path;

    void fire(const State &muzzle, double until) {
        state = muzzle;
        left = until;
        time = 0;
        flying = true;
        path = {state.position};
    }
    /// @return whether it lands in this step
    bool step(double dt) {
        if (!flying) return false;
        dt = std::min(dt, left);
        next_frame(state, dt);
        left -= dt;
        time += dt;
        path.push_back(state.position);
        flying = left > 0;
        return !flying;
    }
    /// The last 40 places of its way.
    std::vector<Vec2> recent() const {
        return {path.end() - std::min<std::ptrdiff_t>(40, std::ssize(path)), path.end()};
    }
    /// All of its way, a place for every 8 frames.
    std::vector<Vec2> whole() const {
        std::vector<Vec2> some;
        for (std::size_t i = 0; i < path.size(); i += 8) some.push_back(path[i]);
        some.push_back(path.back());
        return some;
    }
};

/// What a shot was like, in one number, where it ended.
struct Mark {
    Vec2 at;
    double value;
    std::vector<Vec2> path;
};

/// All that isn't a scene's question: the cannon fires again when its shell has landed, and the camera shows the shot.
struct CannonScene : Scene {
    double height = 0; ///< of the muzzle [m]
    Shell shell;
    Bits spray{}, smoke{.colour = Colour::dim, .weight = -0.15};
    double pause = 0.2; ///< until it fires [s]
    double wide = 70;   ///< of what's seen [m]

    virtual double angle_deg() const = 0;
    /// What the chapter's functions say of a shot; a shell that nobody stops flies on for good.
    virtual double time_until_landing(const State &) const { return 100; }
    virtual void landed() {}

    State muzzle() const { return fired(height, angle_deg()); }
    Vec2 direction() const {
        const double angle = angle_deg() * std::numbers::pi / 180;
        return {std::cos(angle), std::sin(angle)};
    }
    void fire() {
        shell.fire(muzzle(), time_until_landing(muzzle()));
        smoke.throw_from(shell.state.position, 9 * direction(), 0.3);
        pause = 1;
    }
    void begin() override { wide = target_width(); }
    void changed() override { fire(); }
    void step(double dt) override {
        if (!shell.flying && (pause -= dt) <= 0) fire();
        if (shell.step(dt)) {
            spray.throw_from(shell.state.position, {0, 12}, 0.6);
            landed();
        }
        spray.step(dt);
        smoke.step(dt);
        wide += std::min(1.0, 2 * dt) * (target_width() - wide);
    }

    /// As wide as a shot reaches, and as high.
    virtual double target_width() const {
        const Vec2 velocity = speed * direction();
        const double top = height + velocity.y() * velocity.y() / (2 * g);
        return width_for(2 * velocity.x() * std::max(velocity.y(), 4.0) / g, top);
    }
    static double width_for(double far, double top) {
        return std::clamp(std::max(1.1 * far + 20, (top + 16) * 16 / 9), 62.0, 112.0);
    }
    View view() const override { return {{-12, -10}, {wide - 12, wide * 9 / 16 - 10}, Stage::hills, 0}; }
    void draw_cannon(Canvas &canvas) const {
        if (height > 0)
            canvas.body({{-14, -11}, {2, -11}, {2, height - 9}, {0.6, height}, {-14, height}}, Colour::earth);
        const Vec2 floor{-10, height - 9}; // of its pit, which is lined with planks
        canvas.area(box(floor, {0.6, height}), Colour::ink).strength = 0.75;
        canvas.bar({{floor.x(), height}, floor, {0.6, floor.y()}, {0.6, height - 4}}, Colour::wood, 9);
        smoke.draw(canvas, 0.7);
        cannon(canvas, {0, height}, direction());
        if (shell.flying && shell.time < 0.1) canvas.lamp(Vec2{0, height} + direction(), 1.6, Colour::amber);
    }
    /// Farther than any shot from level ground.
    static void draw_crates(Canvas &canvas) {
        for (const Vec2 &low : {Vec2{64.5, 0}, {70, 0}, {67.2, 5}}) crate(canvas, low, 5);
    }
    void draw_shell(Canvas &canvas) const {
        if (shell.path.empty()) return;
        if (shell.flying) canvas.trail(shell.recent(), Colour::orange, 7);
        spray.draw(canvas, 0.5);
        canvas.ball(shell.state.position, 1.2, Colour::ink);
    }
};

/// The cannon as its dial says: the place of each scene in the chapter sets it.
struct DialScene : CannonScene {
    Slider dial = slider("angle", "°", -45, 90, 1, 60);
    std::vector<Mark> marks;

    double angle_deg() const override { return dial; }
    double time_until_landing(const State &from) const override { return time_of_flight(from, g); }
    void remember(double value) {
        if (marks.size() == 4) marks.erase(marks.begin());
        marks.push_back({shell.state.position, value, shell.whole()});
    }
    void draw_dial(Canvas &canvas) const {
        const double angle = angle_deg() * std::numbers::pi / 180;
        const Vec2 at{0, height};
        canvas.line({at, at + Vec2{12, 0}}, Colour::ink, 1.5).strength = 0.6;
        canvas.line(arc(at, 9, 0, angle), Colour::ink, 2);
        canvas.plate(at + 15 * Vec2{std::cos(angle / 2), std::sin(angle / 2)}, number(angle_deg(), 0) + "°",
                     Colour::ink, 20);
    }
};
} // namespace play
