#pragma once
// A rolls to the right, and meets B as far off centre as the reader has put it.
#include "meeting.hpp"

namespace play {

struct OffCentre : Meeting {
    Slider speed_of_b = slider("velocity of B", "m/s", -4, 4, 1, 0);
    Handle from = handle({-5.8, -0.6}, {-5.8, -2}, {-5.8, 2}); ///< where A begins [m]
    double off = 0.6; ///< how much higher B's centre is when they meet, in the sum of both radii
    int times = 0;    ///< that they met by themselves

    OffCentre() { handles_below = true; }

    /// They begin anew.
    virtual void start() = 0;
    void meet(const Ball &first, const Ball &second) {
        place({std::sqrt(1 - off * off), off}, first, second, 60);
        from.move(a.position);
    }
    void begin() override { start(); }
    void changed() override { start(); }
    void take_over() override {
        off = 0.6;
        start();
    }
    void drag() override {
        const double reach = a.radius + b.radius;
        off = std::clamp(std::round(-10 * from.at().y() / reach) / 10, -0.9, 0.9);
        start();
    }
    void step(double dt) override {
        if (hand.down && !untouched) return; // it's being put elsewhere
        roll(dt);
        if (!is_over()) return;
        constexpr double film[]{0.6, -0.3, 0.8, -0.7};
        if (untouched) off = film[++times % 4];
        start();
    }
};
} // namespace play
