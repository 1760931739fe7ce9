#pragma once
// You against the machine; until you come, a beginner plays for you.
#include "shared.hpp"

namespace play {

struct Opening : Match {
    static constexpr std::string_view name = "against the machine";
    Choice machine = choice("The machine", {"easy", "hard"});
    Seat blue = blue_seat();
    Vec2 pointer{0, 0}; ///< where it was before this step [m]

    Vec2 left_hand() const override {
        return is_played() ? blue.hand(world.left) : beginner_hand(world, matches, time);
    }
    Vec2 right_hand() const override { return machine_hand(world, 1, Level(int(machine))); }
    std::string hint() const override { return "drag the blue mallet to take over"; }

    void press(const Vec2 &at) override { blue.point(at); }
    void drag() override { blue.drag(); }
    void step(double dt) override {
        if (hand.inside && hand.at != pointer) blue.point(hand.at); // a mouse needn't be pressed
        pointer = hand.at;
        look_who_plays(blue.is_led(), hand.inside || hand.down, dt);
        Match::step(dt);
        blue.follow(world.left);
    }
};
} // namespace play
