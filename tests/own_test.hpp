#pragma once
// What a reader's own tests are made of: Catch2 as it is, and the matchers of the course. See `./course mytests`.
//     CHECK_THAT(accelerated_motion(start, g, 2).velocity, IsNear(Vec2{3, -19.6}, 1e-9)); // and numbers, structs
//     CHECK(maximum_height(25) == Approx(31.9).margin(0.1));                              // a number

#include "matchers.hpp"

#include <catch2/catch_approx.hpp>
#include <catch2/generators/catch_generators_adapters.hpp>
#include <catch2/generators/catch_generators_random.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <numbers>

using Catch::Approx;
using Catch::Matchers::WithinAbs, Catch::Matchers::WithinRel;

inline constexpr double digits = 1e-9; ///< how far off an answer may be, as in our tests
constexpr double degrees(double angle) { return angle * std::numbers::pi / 180; } // [rad]

/// What has fields, or may be nothing, in a failed check: as in a verdict.
template <class T>
requires course::wire::Fields<T> || course::wire::is_optional<T>
struct Catch::StringMaker<T> {
    static std::string convert(const T &value) { return course::describe(value); }
};

/// A vector, or a sum of vectors that isn't worked out yet.
template <class T>
requires std::is_base_of_v<Eigen::MatrixBase<T>, T>
struct Catch::StringMaker<T> {
    static std::string convert(const T &value) { return course::describe(Vec2{value}); }
};

/// Endless random vectors with both components in [low, high].
inline auto vectors(double low, double high) {
    return Catch::Generators::map(
        [](const std::vector<double> &xy) {
            return Vec2{xy[0], xy[1]};
        },
        Catch::Generators::chunk(2, Catch::Generators::random(low, high)));
}
