#pragma once
// Friction as a constant acceleration. What's that once the glass has stopped?
#include "shared.hpp"

namespace play {

struct Slows : CounterScene {
    static constexpr std::string_view name = "it slows (5.1)";
    motion::State now{{0, 0}, {6, 0}};

    Slows() : CounterScene{true} { still_time = 2; }

    motion::State glass() const override { return now; }
    void shove() override { now = {{0, 0}, {velocity(), 0}}; }
    void move(double dt) override { next_frame(now, dt); }
    bool over() const override { return std::abs(now.position.x()) > 12 || time > 12; }
};
} // namespace play
