#pragma once
// A digger to be driven: what's dragged is where its motors try to get. How long does a stone take to the mat?
#include "shared.hpp"

namespace play {

struct Cab : HoldScene {
    static constexpr std::string_view name = "in the cab (9.4)";
    static constexpr double mat = -1.5; ///< its middle [m]
    Button grip = button("c", "Close, or open", [this] { closed = !closed; });
    Site site = at_start();
    bool closed = false;
    double time = 0, took = -1; ///< since the start [s]; until the stone lay on the mat, or negative [s]

    Cab() : HoldScene{{-8.7, -1.2}, {4.5, 6.2}, 4} { still_time = 1; }
    static Site at_start() { return {-5, 55 * degree, -75 * degree, -40 * degree, {1.5, 0.2}, false}; }

    View view() const override { return {low, high, Stage::hills, 0}; }
    std::vector<Vec2> arm() const {
        return joints({site.place, boom_height},
                      {{boom_length, site.boom}, {stick_length, site.stick}, {bucket_length, site.bucket}});
    }
    /// Cab, the ends of boom and stick, and beyond the teeth, where it hides no stone.
    std::vector<Vec2> spots() const {
        const std::vector<Vec2> all = arm();
        return {{site.place - 1.5, 1}, all[1], all[2], all[3] + 0.8 * (all[3] - all[2])};
    }
    void begin() override { take_over(); }
    void take_over() override {
        site = at_start();
        closed = false;
        time = 0, took = -1;
        place(spots());
    }
    void press(const Vec2 &) override { closed = !closed; }

    /// Each handle of the cab, -1 to 1: as far as what's dragged is from where it should be.
    Handles handles() const {
        Handles now{0, 0, 0, 0, closed};
        if (held < 0) return now;
        const std::vector<Vec2> all = arm();
        const std::size_t i = std::size_t(held);
        const Vec2 to = holds[i];
        const double off = held == 0 ? to.x() - (site.place - 1.5) : 3 * turn(all[i] - all[i - 1], to - all[i - 1]);
        (held == 0   ? now.drive
         : held == 1 ? now.boom
         : held == 2 ? now.stick
                     : now.bucket) = std::clamp(4 * off, -1.0, 1.0);
        return now;
    }
    /// There, and back with the stone, and once more.
    Handles film() {
        if (time > 4.2) begin();
        closed = time > 1.16 && time < 3;
        if (time < 1.15) return {0.865, -0.5, 0, 0, closed};
        if (time < 1.3 || (time > 2.85 && time < 3.1)) return {0, 0, 0, 0, closed};
        if (time < 2.85) return {-0.97, time < 2.1 ? 0.8 : -0.8, time < 2.1 ? 0.8 : -0.8, 0, closed};
        return {0, 0.6, 0, 0, closed};
    }
    void step(double dt) override {
        const Handles now = untouched ? film() : handles(); // first: a film that's over puts the site back
        site = next_frame(site, now, dt);
        time += dt;
        if (!untouched && took < 0 && !site.held && site.stone.y() <= 0.2 && std::abs(site.stone.x() - mat) < 0.4)
            took = time;
        place(spots(), held);
        if (const std::size_t i = std::size_t(held);
            held >= 0 && !hand.down && (holds[i].at() - spots()[i]).norm() < 0.05)
            held = -1; // moved by a key, it's there
    }

    void draw(Canvas &canvas) const override {
        canvas.body(box({mat - 0.5, -0.15}, {mat + 0.5, 0.02}), Colour::green);
        const std::vector<Vec2> all = arm();
        const std::vector<Link> links{
            {boom_length, site.boom}, {stick_length, site.stick}, {bucket_length, site.bucket}};
        draw_cab(canvas, {{1, 0}, {0, 1}, {site.place - 0.5, 0}}, {all[0], all[1], all[2]});
        const double open = closed ? 0.25 : 0.6; // its teeth are the origin
        draw_part(canvas, hand_of(all[0], links), closed ? Colour::violet : Colour::ink,
                  {{-0.75, 0.2}, {0, 0}, {-0.05, -0.2}, {-0.4, -open}, {-0.8, -0.3}});
        canvas.balls({all[0], all[1], all[2]}, 0.14, Colour::ink);
        canvas.ball(site.stone + Vec2{0, 0.02}, 0.24, site.held ? Colour::violet : Colour::dim);
        if (untouched) return;
        if (took < 0) canvas.plate({mat, -0.7}, number(time, 1, "s"), Colour::ink, 22);
        else canvas.plate({mat, -0.7}, "there after " + number(took, 1, "s"), Colour::green, 24);
    }
};
} // namespace play
