// limits.cpp: a limit that callers reach on purpose, by a clamp, a fraction or a clock, has slack in our solutions, since
// what they computed is rounded. A student's file from before there was any refuses that, and isn't asked.
#include "../dice.hpp"
#include "04_trajectories/trajectories.hpp"
#include "06_reflection/reflection.hpp"
#include "09_forward_kinematics/forward_kinematics.hpp"
#include "12_time_based_motion/time_based_motion.hpp"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using course::Vec2;

TEST_CASE("bank_shot takes a ball that was clamped to a cushion, or into a corner", "[6.6]") {
    Dice dice{7};
    for (int i = 0; i < 10'000; ++i) {
        const double radius = dice.real(0.05, 1);
        const reflection::Box table{dice.point(-10, 0), dice.point(3, 13)};
        const Vec2 edge{radius, radius}, low = table.low + edge, high = table.high - edge, middle = (low + high) / 2;
        const Vec2 corner = dice.point(-1000, 1000).cwiseMax(low).cwiseMin(high);
        const Vec2 out = reflection::bank_shot({corner, {0, 0}, radius}, middle, table, 0, 0);
        const Vec2 in = reflection::bank_shot({middle, {0, 0}, radius}, corner, table, 0, 0);
        CHECK((out + in).norm() < 1e-12);
        CHECK((in - (corner - middle).normalized()).norm() < 1e-12);
    }
}

TEST_CASE("dotted_arc and frame_loop_ranges take a 10 000th of the time of flight, as it is divided", "[4.5][4.9]") {
    Dice dice{7};
    for (int i = 0; i < 500; ++i) {
        const trajectories::State muzzle{{0, dice.real(0, 100)}, dice.point(1, 50)};
        const double dt = trajectories::time_of_flight(muzzle, 9.81) / 10'000;
        const std::size_t dots = trajectories::dotted_arc(muzzle, 9.81, dt).size();
        CHECK((dots == 10'001 || dots == 10'002)); // the last twice, where 10 000 dt is rounded down
        const double right = trajectories::range(muzzle, 9.81);
        CHECK(std::abs(trajectories::frame_loop_ranges(muzzle, 9.81, dt).exact - right) < 1e-6);
    }
}

TEST_CASE("over_the_wall takes a hand that lies on the ground", "[9.8]") {
    Dice dice{7};
    for (int i = 0; i < 1000; ++i) {
        const forward_kinematics::Crane crane{dice.real(2.5, 3.5), 2.4, 2.4, 1};
        const double below = dice.real(0.6, 1), // how steeply the first link goes down, and the second one
            then = std::asin((crane.height - crane.first * std::sin(below)) / crane.second);
        const forward_kinematics::Pose left{std::numbers::pi + below, then - below}, right{-below, below - then};
        CHECK_FALSE(forward_kinematics::over_the_wall(crane, left, right).empty());
    }
}

TEST_CASE("tick, next_frame and seen_at take the time of any clock, from 1970 on, too", "[12.2][12.4][12.8]") {
    using namespace time_based_motion;
    for (const double began : {100'000.0, 1.8e9}) { // a machine that's been on for 28 hours, and 2027
        Clock clock = tick({}, began);
        CHECK(clock.dt == 0);
        clock = tick(clock, began + 0.125);
        CHECK(clock.dt == 0.125);
        CHECK(tick(clock, began + 200'000).skipped == 199'999.625);
        CHECK(tick(tick(clock, began + 200'000), began + 200'000.125).skipped == 199'999.625);

        Game game = next_frame({}, began, false);
        for (int i = 1; i <= 8; ++i) game = next_frame(game, began + i / 8.0, false);
        CHECK(std::abs(game.now.place.x() - run_speed) < 1e-9);

        const Vec2 seen = seen_at({{began, {0, 0}}, {began + 0.5, {4, 2}}}, began + 0.25 + delay);
        CHECK((seen - Vec2{2, 1}).norm() < 1e-5);
        CHECK_NOTHROW(seen_at({{began, {0, 0}}, {began + 0.001, {4, 2}}}, began));
    }
}
