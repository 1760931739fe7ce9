#pragma once
// A friend's ship, by packets that come late, or never.
#include "shared.hpp"

namespace play {

struct Friends : Scene {
    static constexpr std::string_view name = "a friend (12.8)";
    Slider lost = slider("lost", "%", 0, 80, 5, 10);
    double time = 0;                                                     ///< [s]
    std::vector<Sent> line = std::vector<Sent>(24, {{0, flight(0)}, 0}); ///< the last 24 packets that weren't lost
    unsigned packets = 0;                                                ///< how many the friend has sent
    std::vector<Vec2> losses;                ///< where the last ones would have been seen [m]
    Vec2 seen = flight(0), news = flight(0); ///< where the ship is, by `seen_at` and by the newest packet [m]
    std::vector<double> hops[2]{};           ///< how far these two moved in the last two seconds' frames [m]

    Friends() { still_time = 3; }

    /// Where the friend's ship really is [m].
    static Vec2 flight(double t) { return {4 * std::sin(1.1 * t), 1.7 * std::sin(2 * t + 0.5)}; }

    View view() const override { return {{-5.6, -3.15}, {5.6, 3.15}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        while (0.05 * (packets + 1) <= time) {
            const double sent = 0.05 * ++packets, late = 0.01 + 0.04 * course::chance(5, 2 * packets + 1);
            if (100 * course::chance(5, 2 * packets) < lost) keep(losses, flight(sent), 8);
            else line[packets % 24] = {{sent, flight(sent)}, sent + late};
        }
        const Vec2 ours = next_frame(line, time), last = newest(line, time);
        keep(hops[0], (ours - seen).norm(), 120);
        keep(hops[1], (last - news).norm(), 120);
        seen = ours, news = last;
    }
    template <class T> static void keep(std::vector<T> &all, const T &one, std::size_t most) {
        if (all.size() == most) all.erase(all.begin());
        all.push_back(one);
    }

    void draw(Canvas &canvas) const override {
        std::vector<Vec2> arrived;
        for (const Sent &each : line)
            if (each.arrives <= time) arrived.push_back(each.packet.place);
        canvas.dots(std::move(arrived), 0.06, Colour::amber);
        for (const Vec2 &at : losses) canvas.text(at, "×", Colour::pink, 20, Anchor::middle);
        const Vec2 there = flight(time), ahead = (there - flight(time - 0.1)).normalized();
        draw_ghost(canvas, there, 1.25, Colour::ink, ahead);
        draw_ship(canvas, news, 1.25, Colour::orange, time, ahead);
        draw_ship(canvas, seen, 1.25, Colour::blue, time, ahead);
        const auto most = [](const std::vector<double> &all) {
            return all.empty() ? 0.0 : *std::max_element(all.begin(), all.end());
        };
        canvas.plate({-2.6, 2.86}, "yours hops " + number(most(hops[0]), 2, "m"), Colour::blue, 18);
        canvas.plate({2.4, 2.86}, "newest packet hops " + number(most(hops[1]), 2, "m"), Colour::orange, 18);
        canvas.text({0, -2.9}, "outline: where it really is", Colour::ink, 16, Anchor::middle);
    }
};
} // namespace play
