#pragma once
// A firework: rockets climb and burst, and each spark needs a slot.
#include "shared.hpp"

namespace play {

struct Opening : Show {
    static constexpr std::string_view name = "a firework";
    Button burst_now = button("x", "Burst", [this] { burst_at({6 + 12 * random.one(), 5 + 5 * random.one()}); });
    struct Rocket {
        Particle body;
        Emission emission;
    };
    std::vector<Rocket> rockets;
    double next = 0; ///< when the next one starts, from now [s]
    int started = 0, fired = 0;
    Vec2 flash{12, 7};          ///< where the last burst was
    std::vector<Particle> lost; ///< sparks for which there was no slot: they fall
    int refused = 0;

    Opening() : Show(150) { still_time = 4.4; }

    void press(const Vec2 &place) override { burst_at(inside(place)); }
    /// A disc and a small ring take turns.
    void burst_at(const Vec2 &place, const Vec2 &velocity = {0, 0}) {
        since = 0;
        flash = place;
        const bool disc = fired++ % 2 == 0;
        spawn(burst(at(place, velocity), disc ? disc_burst(random.many(88), 5.5) : ring_burst(24, 3.4, 0),
                    disc ? 1.45 : 1));
    }
    void lose(const Particle &spark) override {
        ++refused;
        if (lost.size() < 40) lost.push_back(spark);
    }
    void begin() override { burst_at({8, 8.2}); }

    void step(double dt) override {
        Show::step(dt);
        if ((next -= dt) <= 0) {
            next = untouched ? 0.6 : 1.2;
            const double side = (started++ % 2 == 0 ? 1 : -1); // they start left and right of the middle in turn
            const Vec2 start{12 + side * (2 + 6 * random.one()), 0};
            rockets.push_back({at(start, {3 * side * (random.one() - 0.5), 10 + 3 * random.one()}), {}});
        }
        for (Rocket &rocket : rockets) {
            rocket.body.velocity.y() -= 9 * dt;
            rocket.body.position += dt * rocket.body.velocity;
            spawn(trail(rocket.body, rocket.emission, random, dt));
            if (at_top(rocket)) burst_at(inside(rocket.body.position), {rocket.body.velocity.x(), 0});
        }
        std::erase_if(rockets, at_top);
        for (Particle &each : lost) {
            each.velocity = {0.95 * each.velocity.x(), 0.95 * each.velocity.y() - 20 * dt};
            each.position += dt * each.velocity;
        }
        std::erase_if(lost, [](const Particle &each) { return each.position.y() < 0; });
    }
    static bool at_top(const Rocket &rocket) { return rocket.body.velocity.y() < 2; }

    void draw(Canvas &canvas) const override {
        const double light = std::max(0.0, 1 - since / 0.45);
        canvas.sparks({{flash, 1 + 2.4 * light, 0.9 * light}, {{flash.x(), 0}, 3.5, 0.4 * light}}, Colour::amber);
        draw_sparks(canvas, alive(), 0.27);
        for (const Rocket &rocket : rockets) draw_rocket(canvas, rocket.body);
        std::vector<Vec2> specks;
        for (const Particle &each : lost) specks.push_back(each.position);
        canvas.dots(std::move(specks), 0.12, Colour::dim);
        draw_slots(canvas, taken());
        if (refused > 0) canvas.plate({width - 3, 1.1}, "lost " + number(refused, 0), Colour::orange, 28);
    }
};
} // namespace play
