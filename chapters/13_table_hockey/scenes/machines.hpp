#pragma once
// Two machines: the left one always looks ahead.
#include "shared.hpp"

namespace play {

struct Machines : Match {
    static constexpr std::string_view name = "machine against machine";
    Choice machine = choice("The machine", {"easy", "hard"});

    Vec2 left_hand() const override { return machine_hand(world, -1, Level::difficult); }
    Vec2 right_hand() const override { return machine_hand(world, 1, Level(int(machine))); }
};
} // namespace play
