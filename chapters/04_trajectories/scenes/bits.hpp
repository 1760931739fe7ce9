#pragma once
// What flies about when a cannon fires, and where a shell hits the ground.
#include "../../props.hpp"
#include "../game.hpp"

namespace play {
using namespace demo;
using namespace trajectories;

/// Small things that fly up and fall, and are gone after a second: earth, smoke.
struct Bits {
    std::vector<motion::State> all{};
    Colour colour = Colour::earth;
    double age = 9;    ///< [s]
    double weight = 1; ///< in parts of a stone's

    void throw_from(const Vec2 &at, const Vec2 &way, double spread) {
        all.clear();
        age = 0;
        for (int i = 0; i < 9; ++i) {
            const double part = (i - 4) / 4.0, far = 1 - 0.35 * ((i * 5) % 3);
            all.push_back({at, far * (way + part * spread * turned(way))});
        }
    }
    void step(double dt) {
        age += dt;
        for (motion::State &bit : all) bit = motion::accelerated_motion(bit, {0, -weight * g}, dt);
        if (age > 1) all.clear();
    }
    void draw(Canvas &canvas, double size) const {
        std::vector<Spark> puffs;
        for (const motion::State &bit : all) puffs.push_back({bit.position, 2 * size * (1 + age), 1 - age});
        canvas.puffs(puffs, colour);
    }
};
} // namespace play
