#pragma once
// What every test file of the course needs. The matchers are in matchers.hpp; here is how the course checks.
//
// A verdict shows what a check compared, so say what that is, unless it is the answer of the last call as it came:
//     CHECK_THAT(segments_intersect(first, second), IsNear(true));                   // the answer itself
//     CHECK_THAT(total, IsNear(want, rounding).of("sum of all velocities [m/s]"));   // what the test has computed of it
//     CHECK_THAT(speed, IsAtMost(3).of("speed along x [m/s]"));                      // IsAtLeast, IsBelow, IsAbove
//     CHECK_THAT(changed, HasSize(1).of("slots that changed"));                      // of a list
//     CHECK_THAT(a == b, IsTrue("both walls turn it by the same angle"));            // what no other one can say
// Where a student can follow with a pencil how the number comes about, the verdict says that, too:
//     CHECK_THAT(gravity(ship, hole, 1), IsNear(Vec2{-25, 0}, rounding).since("1600 / 64 = 25 N"));
// An optional that must not be empty is read with .value(): a verdict then says that the answer is "nothing".

#include "matchers.hpp"

// The first failure of a case is its verdict, so nothing after it runs.
#undef CHECK
#undef CHECK_FALSE
#undef CHECK_THAT
#undef CHECK_THROWS_AS
#define CHECK(...) static_assert(false, "a verdict would show C++: say CHECK_THAT(…, IsTrue(\"what must hold\"))")
#undef REQUIRE
#undef REQUIRE_FALSE
#define CHECK_THAT(...) REQUIRE_THAT(__VA_ARGS__)

// A test of refusals goes on where input is accepted, and its verdict lists all that was:
//     CHECK_REFUSED(move_and_bounce(ball, room, -1.0), "dt < 0"); // without words it lists the arguments
#define CHECK_REFUSED(call, ...)                                                                                       \
    do {                                                                                                               \
        if (course::accepts([&] { static_cast<void>(call); } __VA_OPT__(, ) __VA_ARGS__))                              \
            FAIL_CHECK("bad input was accepted");                                                                      \
        else SUCCEED();                                                                                                \
    } while (false)
#define CHECK_THROWS_AS(call, invalid_argument) CHECK_REFUSED(call)
