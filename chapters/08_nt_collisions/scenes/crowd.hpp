#pragma once
// A post that's pushed through a crowd.
#include "shared.hpp"

namespace play {

struct Crowd : Scene {
    static constexpr std::string_view name = "pushed apart (8.5)";
    Handle post = handle({-6, 0}, table.low + Vec2{0.7, 0.7}, table.high - Vec2{0.7, 0.7});
    Button drop = button("n", "Drop ten more", [this] { drop_ten(); });
    std::vector<Disc> discs;
    double time = 0; ///< [s]

    Crowd() { still_time = 2.2; }

    View view() const override { return whole_table(); }
    void begin() override {
        discs = {{{-6, 0}, 0.7, 0}};
        for (int i = 0; i < 40; ++i) {
            const bool heavy = i % 9 == 4;
            discs.push_back(
                {{-3 + i / 5, 1.1 * (i % 5) - 2.3 + 0.03 * (i * 7 % 11)}, heavy ? 0.5 : 0.35, heavy ? 0.25 : 1.0});
        }
    }
    void drop_ten() {
        for (int i = 0; i < 10 && discs.size() <= 80; ++i)
            discs.push_back({{2 + 0.1 * (i % 4), 0.1 * (i / 4) + 0.01 * i}, 0.35, 1});
    }
    void step(double dt) override {
        time += dt;
        if (untouched) post.move({-6 * std::cos(0.9 * time), 2.6 * std::sin(1.7 * time)});
        discs[0].position = post;
        next_frame(discs);
        for (Disc &disc : discs) {
            const Vec2 edge{disc.radius, disc.radius};
            disc.position = disc.position.cwiseMax(table.low + edge).cwiseMin(table.high - edge);
        }
    }
    double deepest_overlap() const {
        double deepest = 0;
        for (std::size_t i = 0; i < discs.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                deepest = std::max(deepest,
                                   discs[i].radius + discs[k].radius - (discs[i].position - discs[k].position).norm());
        return deepest;
    }

    void draw(Canvas &canvas) const override {
        draw_table(canvas);
        for (std::size_t i = 1; i < discs.size(); ++i)
            canvas.ball(discs[i].position, discs[i].radius, discs[i].inverse_mass < 1 ? Colour::violet : Colour::blue);
        canvas.ball(discs[0].position, discs[0].radius, Colour::orange);
        canvas.readout("balls", double(discs.size()) - 1, "", 0);
        canvas.readout("deepest overlap", deepest_overlap(), "m");
    }
};
} // namespace play
