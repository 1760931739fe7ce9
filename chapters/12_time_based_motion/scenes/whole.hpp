#pragma once
// The same jump on three screens: with one step a frame, and in whole steps.
#include "shared.hpp"

namespace play {

struct Whole : Scene {
    static constexpr std::string_view name = "whole steps (12.3)";
    Slider rate = slider("frames per second", "", 10, 144, 1, 60); ///< of the first one of each three
    Button up = button("j", "Jump", [this] { jump(); });
    Lane lanes[6]{};
    double shown[6]{};           ///< when each showed its last frame [s]
    bool down[6]{};              ///< whether a runner is still to jump
    double time = 0, next = 0.1; ///< when they jump by themselves [s]

    double frame(int i) const { return 1 / (i % 3 == 0 ? double(rate) : i % 3 == 1 ? 30 : 144); }
    void jump() {
        for (bool &each : down) each = true;
        for (Lane &lane : lanes) lane.highest = 0;
        next = time + 1.46;
    }
    void press(const Vec2 &) override { jump(); }
    View view() const override { return {{0, -0.36}, {4, 1.89}, Stage::yard, 0}; }
    void step(double dt) override {
        time += dt;
        if (time >= next) jump();
        for (int i = 0; i < 6; ++i) {
            Lane &lane = lanes[i];
            for (int due = frames_due(shown[i], frame(i), time); due > 0; --due) {
                lane.spare = std::min(lane.spare, 1.0); // if an answer never catches up
                if (i >= 3) lane = next_frame(lane, frame(i), down[i]);
                else lane.runner = time_based_motion::step(lane.runner, down[i], frame(i));
                lane.highest = std::max(lane.highest, lane.runner.place.y());
                down[i] = down[i] && lane.runner.place.y() == 0;
            }
        }
    }

    void draw(Canvas &canvas) const override {
        const double rolled = std::fmod(run_speed * time, 0.4);
        for (int i = 0; i < 11; ++i)
            canvas.line({{0.4 * i - rolled, -0.05}, {0.4 * i - rolled + 0.14, -0.05}}, Colour::dim, 2);
        canvas.line({{2, -0.36}, {2, 1.89}}, Colour::dim, 2).strength = 0.6;
        canvas.plate({1, 1.77}, "one step a frame", Colour::orange, 20);
        canvas.plate({3, 1.77}, "whole steps", Colour::blue, 20);
        for (int i = 0; i < 6; ++i) {
            const double x = 0.36 + 0.62 * (i % 3) + (i >= 3 ? 2.04 : 0);
            const Lane &lane = lanes[i];
            const double y = std::clamp(lane.runner.place.y(), 0.0, 5.0), top = std::clamp(lane.highest, 0.0, 5.0);
            const Colour colour = i >= 3 ? Colour::blue : Colour::orange;
            canvas.bar({{x - 0.25, top}, {x + 0.25, top}}, Colour::ink, 4);
            draw_runner(canvas, {x, y}, 0.42, colour, lane.runner.place.x());
            canvas.text({x, -0.2}, number(1 / frame(i), 0) + "/s", Colour::ink, 18, Anchor::middle);
            if (top > 0) canvas.plate({x, y > 0.5 * top ? 0.14 : top - 0.13}, number(top, 2, "m"), colour, 18);
        }
    }
};
} // namespace play
