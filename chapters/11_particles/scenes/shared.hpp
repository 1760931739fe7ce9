#pragma once
// Sparks over a town at night: what the scenes of this chapter share.
#include "../../scene.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace particles;

constexpr double width = 24, height = 12.2; // of the sky [m]: whatever leaves it goes out, and below is the street
constexpr int shades = 8;

/// A spark's colour by its shade: it begins as amber, and cools.
inline Colour colour_of(int shade) {
    constexpr Colour colours[]{Colour::amber, Colour::orange, Colour::pink, Colour::violet};
    return colours[std::clamp(shade / 2, 0, 3)];
}

/// The usual mistake of 11.5: a random number is the speed, as it comes. So half of the sparks are in a quarter of it.
inline std::vector<Vec2> mistaken_disc(Random &random, int count, double max_speed) {
    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const double speed = max_speed * random.one(), angle = 2 * std::numbers::pi * random.one();
        velocities.push_back({speed * std::cos(angle), speed * std::sin(angle)});
    }
    return velocities;
}

/// Each spark in the colour of its age: the older it is, the smaller and the fainter. Two more are its tail, so many
/// seconds long, where it came from. In a crowd the youngest are small, or else all of them would be one white disc.
inline void draw_sparks(Canvas &canvas, const std::vector<Particle> &alive, double radius, double tail = 0.16,
                        double youngest = 0.3) {
    std::vector<Spark> lights[4];
    for (const Particle &spark : alive) {
        const auto shade = shade_index(spark.age, spark.life, shades);
        if (!shade || *shade < 0 || *shade >= shades) continue;
        const double left = 1 - double(*shade) / shades, spread = std::min(1.0, youngest + 1.6 * spark.age);
        const double large = radius * (0.55 + 0.45 * left) * spread, strength = (0.3 + 0.7 * left) * spread;
        std::vector<Spark> &same = lights[std::clamp(*shade / 2, 0, 3)];
        same.push_back({spark.position, large, strength});
        for (int i = 1; i <= 2 && tail > 0; ++i) {
            const double before = std::min(0.5 * i * tail, spark.age);
            same.push_back(
                {spark.position - before * spark.velocity, large * (1 - 0.25 * i), strength * (0.8 - 0.25 * i)});
        }
    }
    for (int i = 3; i >= 0; --i)
        if (!lights[i].empty()) canvas.sparks(lights[i], colour_of(2 * i));
}

/// A rocket with its nose where it flies to.
inline void draw_rocket(Canvas &canvas, const Particle &rocket, double length = 1.6) {
    const Vec2 ahead = length * rocket.velocity.normalized(), side{-0.16 * ahead.y(), 0.16 * ahead.x()};
    const Vec2 tail = rocket.position, shoulder = tail + 0.62 * ahead;
    canvas.body({tail, tail - 0.15 * ahead + 2.2 * side, tail + 0.3 * ahead + side, tail + 0.3 * ahead - side,
                 tail - 0.15 * ahead - 2.2 * side},
                Colour::amber);
    canvas.body({tail + side, shoulder + side, shoulder - side, tail - side}, Colour::ink);
    canvas.body({shoulder + side, tail + ahead, shoulder - side}, Colour::pink);
}

/// A lamp for each slot, in rows along the street: lit where a spark has it, and another colour if none is free.
inline void draw_slots(Canvas &canvas, const std::vector<bool> &taken, double top = -0.4, std::size_t row = 75) {
    const double apart = (width - 0.6) / double(row), radius = std::min(0.17, 0.4 * apart);
    std::vector<Vec2> lit, dark;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        const Vec2 at{0.3 + apart * (0.5 + double(i % row)), top - 0.5 * double(i / row)};
        (taken[i] ? lit : dark).push_back(at);
    }
    const Colour colour = dark.empty() ? Colour::orange : Colour::blue;
    canvas.dots(std::move(dark), 0.55 * radius, Colour::dim).strength = 0.6;
    canvas.dots(std::move(lit), radius, colour);
}

/// A pool, and what happens in it, frame by frame.
struct Show : Scene {
    explicit Show(std::size_t slots) : pool(slots) {}
    Pool pool;
    Random random{11};
    double time = 0;  ///< [s]
    double since = 0; ///< the last burst [s]

    virtual World world() const { return {4, 0.5, width, height}; }
    View view() const override { return {{0, -1.3}, {width, height}, Stage::skyline, 0}; }
    /// A spark for which there's no slot.
    virtual void lose(const Particle &) {}
    void spawn(const std::vector<Particle> &newborn) {
        for (const Particle &spark : newborn)
            if (const auto slot = free_slot(pool)) pool[*slot] = spark;
            else lose(spark);
    }
    void step(double dt) override {
        time += dt;
        since += dt;
        next_frame(pool, {}, world(), dt);
    }

    static Particle at(const Vec2 &place, const Vec2 &velocity = {0, 0}) {
        return {.position = place, .velocity = velocity, .age = 0, .life = 1};
    }
    /// The nearest place where a burst can be seen.
    Vec2 inside(const Vec2 &place) const {
        return place.cwiseMax(Vec2{1, 1}).cwiseMin(Vec2{world().width - 1, world().height - 1});
    }
    std::vector<Particle> alive() const {
        std::vector<Particle> all;
        for (const auto &slot : pool)
            if (slot) all.push_back(*slot);
        return all;
    }
    std::vector<bool> taken() const {
        std::vector<bool> all;
        for (const auto &slot : pool) all.push_back(slot.has_value());
        return all;
    }
};
} // namespace play
