// What the sections' programs share: chapters/program.hpp.

#include "program.hpp"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("columns line up, and a text that is too long for its column keeps its distance from the next") {
    CHECK(course::row({{"t [s]", 7}, {"x [m]", 0}}) == "t [s]  x [m]\n");
    CHECK(course::row({{"(2.466667, 2.066667)", 14}, {"(2.4, 2.4)", 0}}) == "(2.466667, 2.066667) (2.4, 2.4)\n");
}
