#pragma once
// One firework in two pools: in one the dead leave gaps, in the other the last spark moves into each.
#include "shared.hpp"

namespace play {

struct Gaps : Show {
    static constexpr std::string_view name = "without gaps (11.9)";
    static constexpr int slots = 60;
    Button again = button("x", "Burst", [this] { burst_at({12, 6.7}); });
    std::vector<Particle> packed;

    Gaps() : Show(slots) { still_time = 2.9; }

    World world() const override { return {4, 0.5, width, 10.3}; }
    View view() const override { return {{0, -3.2}, {width, 10.3}, Stage::skyline, 0}; }
    void press(const Vec2 &place) override { burst_at(inside(place)); }
    void burst_at(const Vec2 &place) {
        since = 0;
        std::vector<Particle> sparks = burst(at(place), disc_burst(random.many(90), 5), 1);
        for (Particle &spark : sparks) spark.life = 0.8 + 1.4 * random.one();
        spawn(sparks);
        packed = compact_pool(packed, sparks, slots);
    }
    void begin() override { burst_at({12, 6.7}); }
    void step(double dt) override {
        Show::step(dt);
        next_frame(packed, {}, slots, world(), dt);
        if (since > (untouched ? 0.9 : 4)) burst_at({6 + 12 * random.one(), 5.2 + 3 * random.one()});
    }

    void draw(Canvas &canvas) const override {
        draw_sparks(canvas, packed, 0.3);
        std::vector<bool> full(slots);
        for (std::size_t i = 0; i < packed.size() && i < slots; ++i) full[i] = true;
        canvas.text({0.4, -0.75}, "slots (11.1)", Colour::ink, 20);
        draw_slots(canvas, taken(), -1.25, slots);
        canvas.text({0.4, -2.15}, "without gaps (11.9)", Colour::ink, 20);
        draw_slots(canvas, full, -2.65, slots);
    }
};
} // namespace play
