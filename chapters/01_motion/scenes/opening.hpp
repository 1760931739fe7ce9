#pragma once
// Four frames of a missile. Where is it in the next two? The reader's guesses are two rings.
#include "shared.hpp"

namespace play {

struct Opening : Scene {
    static constexpr std::string_view name = "you guess";
    Handle fifth = handle({77, 8}, {72, 8}, {105, 8}), sixth = handle({84, 8}, {72, 8}, {105, 8});
    Button go_on = button("f", "Let it fly on", [this] { guessing = false; });
    const motion::State missile{{50, 8}, {4, 0}}, helicopter{{59, 20}, {4, 0}}; // [px], and [px] a frame
    double frame = 0; ///< a second each, so that one can see what's between two
    double pause = 0; ///< at the last frame [s]
    bool guessing = true;

    Opening() { still_time = 3.9; }

    View view() const override { return {{44, -7}, {108, 29}, Stage::hills, 0}; }
    int last() const { return guessing ? 3 : 5; }
    void drag() override { guessing = true; }
    void step(double dt) override {
        if (frame < last()) pause = 0;
        if ((frame += dt) < last()) return;
        frame = last();
        if ((pause += dt) > (guessing ? 1.6 : 4)) frame = 0;
    }
    Vec2 missile_at(double t) const { return accelerated_motion(missile, {2, 0}, t).position; }
    Vec2 helicopter_at(double t) const { return uniform_motion(helicopter.position, helicopter.velocity, t); }

    void draw(Canvas &canvas) const override {
        std::vector<Vec2> even;
        for (int k = 0; k <= frame; ++k) {
            const Vec2 at = missile_at(k);
            canvas.line({{at.x(), 0}, at}, Colour::orange, 2).strength = 0.5;
            canvas.dot(at, 0.7, Colour::orange);
            canvas.plate({at.x(), -2.6}, number(at.x(), 0), k > 3 ? Colour::orange : Colour::ink, 24);
            even.push_back(helicopter_at(k) + Vec2{0, -4.6});
        }
        canvas.dots(std::move(even), 0.5, Colour::blue);
        draw_guess(canvas, fifth, 4, 5);
        draw_guess(canvas, sixth, 5, -5);
        draw_helicopter(canvas, helicopter_at(frame), 13, frame + pause);
        draw_missile(canvas, missile_at(frame), {7, 0}, frame > 0 && frame < last() ? 1 : 0, frame);
    }
    /// A ring, with what it's for, and after that with how far off it is.
    void draw_guess(Canvas &canvas, const Vec2 &ring, int of_frame, double label) const {
        canvas.line(arc(ring, 1.7), Colour::violet, 4);
        const double off = ring.x() - missile_at(of_frame).x();
        std::string words = of_frame == 4 ? "fifth?" : "sixth?";
        if (!guessing && frame >= of_frame)
            words = std::abs(off) < 0.5 ? "right" : number(std::abs(off), 0) + (off < 0 ? " short" : " too far");
        canvas.line({ring + Vec2{0, label < 0 ? -1.7 : 1.7}, ring + Vec2{0, 0.7 * label}}, Colour::violet, 2);
        canvas.plate(ring + Vec2{0, label}, words, Colour::violet, 20);
    }
};
} // namespace play
