#pragma once
// How long is a shell in the air? The clock runs down, and the shell stops where it's out.
#include "shared.hpp"

namespace play {

struct Lands : DialScene {
    static constexpr std::string_view name = "it lands (4.2)";

    Lands() { still_time = 5.5; }

    void landed() override { remember(shell.time); }

    void draw(Canvas &canvas) const override {
        draw_cannon(canvas);
        draw_dial(canvas);
        draw_marks(canvas);
        draw_shell(canvas);
        if (shell.left <= 0) return; // aimed down, it lands at once
        const Vec2 clock = shell.state.position + Vec2{0, 5};
        const double whole = shell.time + shell.left, turn = 2 * std::numbers::pi * shell.left / whole;
        canvas.body(arc(clock, 2.6), Colour::line);
        canvas.body(sector(clock, 2.6, std::numbers::pi / 2 - turn, std::numbers::pi / 2), Colour::amber);
        canvas.plate(clock + Vec2{0, 4}, number(shell.left, 1, "s left"), Colour::ink, 18);
    }
    void draw_marks(Canvas &canvas) const {
        for (const Mark &mark : marks) canvas.line(mark.path, Colour::dim, 2).strength = 0.45;
        for (std::size_t i = 0; i < marks.size(); ++i)
            flag(canvas, marks[i].at, number(marks[i].value, 2, "s"),
                 i + 1 == marks.size() ? Colour::green : Colour::ink, 3.5 + 4.5 * double(i));
    }
};
} // namespace play
