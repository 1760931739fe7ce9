#pragma once
// Up to a thousand balls, each of which is compared with those in the nine cells around it.
#include "shared.hpp"

namespace play {

struct Thousand : Scene {
    static constexpr std::string_view name = "a thousand (8.6)";
    Slider count = slider("balls", "", 100, 1000, 100, 1000);
    std::vector<Ball> balls;

    Thousand() { still_time = 1; }

    View view() const override { return whole_table(); }
    void begin() override {
        course::Dice dice{8};
        const int total = int(count), columns = int(std::sqrt(total * 1.6));
        const double radius = 0.1 * std::sqrt(1000.0 / total);
        const Vec2 apart{(table.high - table.low).x() / (columns + 1), 9.0 / (total / columns + 2)};
        balls.clear();
        for (int i = 0; i < total; ++i) {
            const Vec2 at = table.low + Vec2{apart.x() * (1 + i % columns), apart.y() * (1 + i / columns)};
            const double right = 4 * dice.one() - 2, up = 4 * dice.one() - 2; // [m/s]
            balls.push_back({at, {right, up}, radius, 1});
        }
        std::swap(balls[0], balls[std::size_t(total / 2 + columns / 3)]); // the orange one, near the middle
    }
    void changed() override { begin(); }
    void step(double dt) override { next_frame_with_pairs(balls, table, 1, dt); }

    double cell() const { return 2 * balls[0].radius; }
    Vec2 cell_of(const Vec2 &at) const {
        const Vec2 cells = (at - table.low) / cell();
        return {std::floor(cells.x()), std::floor(cells.y())};
    }
    int in_the_nine_cells() const {
        int found = 0;
        for (const Ball &ball : balls) {
            const Vec2 away = cell_of(ball.position) - cell_of(balls[0].position);
            found += std::abs(away.x()) < 1.5 && std::abs(away.y()) < 1.5;
        }
        return found;
    }
    void draw(Canvas &canvas) const override {
        draw_table(canvas);
        draw_grid(canvas);
        draw_balls(canvas, balls, Colour::orange, {Colour::blue});
        const double total = double(balls.size());
        canvas.readout("pairs in all", total * (total - 1) / 2, "", 0);
        canvas.readout("close pairs", double(close_pairs(centres_of(balls), cell()).size()), "", 0);
        canvas.readout("others in the nine cells", in_the_nine_cells() - 1, "", 0);
        canvas.readout("kinetic energy", std::round(energy_of(balls) * 1e6) / 1e6, "J");
    }
    void draw_grid(Canvas &canvas) const {
        for (double x = table.low.x(); x < table.high.x(); x += cell())
            canvas.line({{x, table.low.y()}, {x, table.high.y()}}, Colour::ink, 1).strength = 0.15;
        for (double y = table.low.y(); y < table.high.y(); y += cell())
            canvas.line({{table.low.x(), y}, {table.high.x(), y}}, Colour::ink, 1).strength = 0.15;
        const Vec2 low = table.low + cell() * (cell_of(balls[0].position) - Vec2{1, 1});
        canvas.area(box(low, low + 3 * Vec2{cell(), cell()}), Colour::amber).strength = 0.4;
    }
};
} // namespace play
