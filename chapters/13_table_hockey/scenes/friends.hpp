#pragma once
// Two who play at one table; until they come, a beginner plays the machine.
#include "shared.hpp"

namespace play {

struct Friends : Match {
    static constexpr std::string_view name = "two players";
    Seat blue = blue_seat(), orange = orange_seat();

    Vec2 left_hand() const override {
        return is_played() ? blue.hand(world.left) : beginner_hand(world, matches, time);
    }
    Vec2 right_hand() const override {
        return is_played() ? orange.hand(world.right) : machine_hand(world, 1, Level::easy);
    }
    std::string hint() const override { return "drag a mallet to take over"; }

    void drag() override {
        blue.drag();
        orange.drag();
    }
    void step(double dt) override {
        const bool left = blue.is_led(), right = orange.is_led();
        look_who_plays(left || right, hand.down, dt);
        Match::step(dt);
        blue.follow(world.left);
        orange.follow(world.right);
    }
};
} // namespace play
