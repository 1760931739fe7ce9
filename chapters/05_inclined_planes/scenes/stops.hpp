#pragma once
// Friction frame by frame: it stops the glass, and nothing starts it again.
#include "shared.hpp"

namespace play {

struct Stops : CounterScene {
    static constexpr std::string_view name = "it stops (5.2)";
    Puck puck{0, 6};

    Stops() : CounterScene{false} { still_time = 2; }

    motion::State glass() const override { return {{puck.x, 0}, {puck.velocity, 0}}; }
    void shove() override { puck = {0, velocity()}; }
    void move(double dt) override { next_frame(puck, dt); }
    bool over() const override { return std::abs(puck.x) > 12 || time > 6; }
};
} // namespace play
