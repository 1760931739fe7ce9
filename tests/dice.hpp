#pragma once
// Random input, the same on every machine.

#include "course.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

/// The same numbers each time for one seed.
class Dice {
  public:
    Dice(); ///< with the seed that the tests print
    explicit Dice(std::uint32_t seed) : engine{seed} {}

    double real(double low, double high) { return low + (high - low) * double(engine() >> 5) / double(1 << 27); }
    int whole(int low, int high) { return low + int(engine() % unsigned(high - low + 1)); }
    double sign() { return whole(0, 1) == 0 ? -1 : 1; }
    course::Vec2 point(double low, double high) { return {real(low, high), real(low, high)}; }
    course::Vec2 grid(int low, int high) { return {double(whole(low, high)), double(whole(low, high))}; }
    course::Vec2 direction() { // of length 1
        const double angle = real(-std::numbers::pi, std::numbers::pi);
        return {std::cos(angle), std::sin(angle)};
    }

  private:
    std::mt19937 engine;
};
