#include "section_test.hpp"

#include "skeleton.hpp"

using namespace skeleton::subject; // pull: the student's

constexpr double rounding = 1e-12; // a handful of operations on numbers of size one

//> Worked example
TEST_CASE("the worked example: 30 N/m, made 0.25 m longer, pull back with 7.5 N", "[99.1]") {
    CHECK_THAT(pull(30, 0.25), IsNear(-7.5, rounding)); // -30 N/m * 0.25 m
}

//> What the energy says
TEST_CASE("the pull is what the stored energy loses for each metre", "[99.1]") {
    const double stiffness = GENERATE(0.4, 30.0, 2e5);
    const double stretch = GENERATE(take(20, random(-2.0, 2.0)), 0.0);
    const auto energy = [&](double x) { return stiffness * x * x / 2; }; // [J]

    const double loss = energy(stretch - 0.5) - energy(stretch + 0.5); // over one metre, exact for a square

    CHECK_THAT(pull(stiffness, stretch), IsNear(loss, 1e-9)); // 1e-16 of 6e5 J
}

//>
TEST_CASE("a spring that is not stiff, and a force without end, are refused", "[99.1]") {
    CHECK_THROWS_AS(pull(0, 0.25), std::invalid_argument);
    CHECK_THROWS_AS(pull(-30, 0.25), std::invalid_argument);
    CHECK_THROWS_AS(pull(infinity, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(pull(30, infinity), std::invalid_argument);
    CHECK_THROWS_AS(pull(not_a_number, 0.25), std::invalid_argument);
    CHECK_THROWS_AS(pull(30, not_a_number), std::invalid_argument);
    CHECK_THROWS_AS(pull(1e200, 1e200), std::invalid_argument);
}
