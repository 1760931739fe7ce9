#pragma once
// A ball that's too quick for its frames, in slow motion: each of them is seen.
#include "meeting.hpp"

namespace play {

struct Fast : Meeting {
    static constexpr std::string_view name = "between frames (8.4)";
    static constexpr double off = 0.6; ///< how much higher B's centre is than A's way [m]
    Choice contact = choice("contact", {"only in frames (8.3)", "between frames (8.4)"});
    Slider speed = slider("speed", "m/s", 10, 100, 5, 60);
    std::vector<Colour> tried[2]{std::vector(19, Colour::dim),
                                 std::vector(19, Colour::dim)}; ///< each speed, by contact

    Fast() { still_time = 1.5; }

    View view() const override { return {{-7.6, -4.275}, {7.6, 4.275}, Stage::felt}; }
    double step_time() const override { return 0.12; } // for a frame
    void begin() override {
        place({0.8, off}, {{0, 0}, {speed, 0}, 0.5, 1}, {{0, 0}, {0, 0}, 0.5, 1}, 0);
        a.position = {-7.5, -off};
        b.position = {1, 0};
        paths[0] = {a.position};
    }
    void take_over() override { begin(); }
    void changed() override { begin(); }
    std::size_t number_of_speed() const { return std::size_t(std::lround((speed - 10) / 5)); }
    static Vec2 lamp_of(std::size_t speed_number) { return {-6.3 + 0.7 * double(speed_number), -3.1}; }
    void move(double /*dt*/) override {
        if (contact == 1) next_frame_with_contact(a, b, 1, frame_time);
        else collide_and_roll(1, frame_time);
    }
    bool is_through() const { return !met && a.position.x() > b.position.x() + 1; }
    void step(double dt) override {
        roll(dt);
        if (met || is_through()) tried[contact][number_of_speed()] = met ? Colour::green : Colour::pink;
        const bool gone = !is_seen(a) && (!met || !is_seen(b));
        if (gone || since > 12) begin();
    }

    void draw(Canvas &canvas) const override {
        canvas.dotted({{-7.6, -off}, {7.6, -off}}, Colour::ink, 1.5).strength = 0.5;
        for (const Vec2 &at : paths[0]) draw_outline(canvas, at, a.radius, colours[0]);
        draw_lettered(canvas, b.position, b.radius, 1);
        draw_lettered(canvas, a.position, a.radius, 0);
        if (met || is_through())
            canvas.plate({-1.6, 1.5}, met ? "caught" : "through!", met ? Colour::green : Colour::pink, 26);
        for (std::size_t i = 0; i < 19; ++i) { // a lamp for each speed
            const Vec2 at = lamp_of(i);
            if (const Colour colour = tried[contact][i]; colour == Colour::dim)
                canvas.dot(at, 0.19, Colour::ink).strength = 0.35;
            else canvas.lamp(at, 0.21, colour);
            if (i % 6 == 0)
                canvas.text(at - Vec2{0, 0.8}, number(double(10 + 5 * i), 0, "m/s"), Colour::ink, 18, Anchor::middle);
        }
        canvas.dotted(arc(lamp_of(number_of_speed()), 0.36), Colour::amber, 2);
    }
};
} // namespace play
