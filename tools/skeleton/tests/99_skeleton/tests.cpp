#include "section_test.hpp"

#include "skeleton.hpp"

using namespace skeleton::subject; // pull: the student's

//> Worked example
TEST_CASE("the worked example: a spring of 30 N/m, 0.25 m longer than at rest, pulls back with 7.5 N", "[99.1]") {
    CHECK_THAT(pull(30, 0.25), IsNear(-7.5, rounding)); // -30 N/m * 0.25 m
}

//> What the energy says
TEST_CASE("the pull is what the stored energy loses for each metre, for soft and stiff springs", "[99.1]") {
    const double stiffness = GENERATE(0.4, 30.0, 9e4);
    const double stretch = GENERATE(-2.0, -0.75, -1e-6, 0.0, 0.1, 1.3, 1.9);
    const auto energy = [&](double x) { return stiffness * x * x / 2; }; // [J]

    const double loss = energy(stretch - 0.5) - energy(stretch + 0.5); // over one metre, exact for a square

    CHECK_THAT(pull(stiffness, stretch), IsNear(loss, 1e-11)); // a dozen roundings of 3e5 J, beside up to 2e5 N
}

//>
TEST_CASE("the largest input is accepted, and its answer may be larger still", "[99.1]") {
    CHECK_THAT(pull(1e5, -1e5), IsNear(1e10, rounding));
}

TEST_CASE("a stiffness that is not positive is refused", "[99.1]") {
    CHECK_REFUSED(pull(0, 0.25), "stiffness is zero");
    CHECK_REFUSED(pull(-30, 0.25), "stiffness is negative");
}
