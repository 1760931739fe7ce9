#pragma once
// A whole show: it has so many places for sparks, and so many seconds. Who lights the most?
#include "shared.hpp"

namespace play {

struct Whole : demo::Scene {
    static constexpr std::string_view name = "a whole show (11.10)";
    static constexpr double seconds = 20; ///< for firing [s]
    static constexpr int sparks = 24;     ///< in each rocket
    static constexpr Rules rules{.gravity = 5, .places = 100, .speed = 4.6, .life = 1.8};
    Button fire = button("x", "Fire", [this] { press({4 + 16 * random.one(), 5 + 5.5 * random.one()}); });
    particles::Show show;
    std::vector<Rocket> fired; ///< since the last frame
    Random random{7};
    double time = 0, over_for = 0, since_lost = 9; ///< [s]
    int best = 0;

    Whole() { still_time = 5.2; }

    View view() const override { return {{0, -1.3}, {width, height}, Stage::skyline, 0}; }
    /// What the machine plays: it has thought of all rockets before, and they wait.
    void begin() override {
        show = {};
        time = over_for = 0;
        since_lost = 9;
        if (!untouched) return;
        for (int i = 0; i < 26; ++i) {
            const Vec2 place{4 + 16 * random.one(), 5 + 5.5 * random.one()};
            show.rockets.push_back(rocket_to(place, 0.05 + 0.72 * i, sparks, rules, random));
        }
    }
    void take_over() override { begin(); }
    void press(const Vec2 &place) override {
        if (time >= seconds) return;
        const Vec2 top{std::clamp(place.x(), 2.5, width - 1), std::clamp(place.y(), 2.5, height - 1)};
        fired.push_back(rocket_to(top, 0, sparks, rules, random));
    }
    int points() const { return show.shown - 2 * show.lost; }
    void step(double dt) override {
        time += dt;
        since_lost += dt;
        const int lost = show.lost;
        next_frame(show, fired, rules, dt);
        fired.clear();
        if (show.lost > lost) since_lost = 0;
        if (time < seconds || !show.rockets.empty() || !show.sparks.empty()) return;
        best = std::max(best, points());
        if ((over_for += dt) > 4) begin();
    }

    struct Burst {
        double age; ///< [s]
        Vec2 sum;   ///< of its sparks' places [m]
        int sparks;
    };
    void draw(Canvas &canvas) const override {
        std::vector<Burst> bursts; // sparks of the same age are of one burst
        for (const Particle &spark : show.sparks) {
            const auto same =
                std::find_if(bursts.begin(), bursts.end(), [&](const Burst &each) { return each.age == spark.age; });
            if (same == bursts.end()) bursts.push_back({spark.age, spark.position, 1});
            else same->sum += spark.position, ++same->sparks;
        }
        for (const auto &[age, sum, count] : bursts)
            if (const double light = 1 - age / 0.45; light > 0) {
                const Vec2 middle = sum / count;
                canvas.sparks({{middle, 1 + 2.2 * light, 0.9 * light}, {{middle.x(), 0}, 3.2, 0.35 * light}},
                              Colour::amber);
            }
        draw_sparks(canvas, show.sparks, 0.28);
        std::vector<Spark> exhaust;
        for (const auto &[wait, position, velocity, random_numbers] : show.rockets) {
            if (wait > 0) continue;
            for (int i = 0; i < 7; ++i)
                exhaust.push_back({position - 0.032 * i * velocity, 0.26 - 0.03 * i, 0.8 - 0.1 * i});
            draw_rocket(canvas, Show::at(position, velocity), 1.3);
        }
        canvas.sparks(exhaust, Colour::orange);
        std::vector<bool> taken(std::size_t(rules.places));
        for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = i < show.sparks.size();
        draw_slots(canvas, taken, -0.65, 100);
        if (over_for > 0) {
            canvas.plate({width / 2, 7}, number(points(), 0) + " points", Colour::amber, 40);
            canvas.plate({width / 2, 5},
                         number(show.shown, 0) + " shown, " + number(show.lost, 0) + " lost, " + number(show.most, 0)
                             + " at one time",
                         Colour::ink, 24);
        } else {
            canvas.plate({3, 1.1}, number(std::max(0.0, seconds - time), 0, "s"), Colour::ink, 24);
            canvas.plate({width - 3.4, 1.1}, number(points(), 0) + " points",
                         since_lost < 0.6 ? Colour::pink : Colour::amber, 24);
        }
        if (best > 0) canvas.plate({width / 2, 1.1}, "best " + number(best, 0), Colour::blue, 24);
    }
};
} // namespace play
