// What a function is spared: the server refuses a number out of range before it calls, wherever that number is.

#include "course.hpp"
#include "interface.hpp"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#define COURSE_SECTION "border_exercises.hpp"
#include "judge/server/serve.hpp"

namespace border_exercises {

double halved(double x) { return x / 2; }
int takes_all(const Everything &, const std::vector<Ball> &balls, bool, int count) { return count + int(balls.size()); }
double seconds(const Clock &clock) { return clock.time; }

} // namespace border_exercises

using border_exercises::Ball, border_exercises::Everything;
using course::Vec2;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls an exercise of border_exercises.hpp as the server does.
/// @return what it refused, or "" if it answered
template <class... Arguments> std::string refusal(int exercise, const Arguments &...arguments) {
    Writer request, result;
    (request.put(arguments), ...);
    Reader reader{request.bytes};
    try {
        served[exercise](reader, result);
    } catch (const std::invalid_argument &refused) {
        return refused.what();
    }
    return result.bytes.empty() ? "no answer" : "";
}

std::string refusal_of(const Everything &all, const std::vector<Ball> &balls = {}) {
    return refusal(1, all, balls, true, 1'000'000);
}

constexpr const char *words = "each number must lie within ±1e5, but is ";

} // namespace

TEST_CASE("the server accepts numbers up to ±1e5, and whole numbers as large as they like") {
    for (const double good : {0.0, -0.0, 1e-300, 1e5, -1e5}) {
        CHECK(refusal(0, good) == "");
        const Ball ball{{good, good}, good};
        CHECK(refusal_of({{good, good}, {good, good}, {{good, good}}, {ball}, {{good}, {}}, good, ball}, {ball, ball})
              == "");
    }
}

TEST_CASE("the server refuses a number that is too large, infinite, or none, by itself") {
    CHECK(refusal(0, 100001.0) == words + std::string{"100001"});
    CHECK(refusal(0, std::nextafter(1e5, infinity)) == words + std::string{"100000.00000000001"});
    CHECK(refusal(0, -3e200) != "");
    CHECK(refusal(0, infinity) == words + std::string{"inf"});
    CHECK(refusal(0, -infinity) == words + std::string{"-inf"});
    CHECK(refusal(0, std::nan("")) == words + std::string{"nan"});
}

TEST_CASE("the server refuses it wherever it is: in a vector, a list, a struct, an optional, or several of these") {
    for (const double bad : {100001.0, -100001.0, infinity, -infinity, std::nan("")}) {
        CHECK(refusal_of({.place = {bad, 0}}) != "");
        CHECK(refusal_of({.place = {0, bad}}) != "");
        CHECK(refusal_of({.numbers = {1, 2, bad}}) != "");
        CHECK(refusal_of({.points = {{1, 2}, {3, bad}}}) != "");
        CHECK(refusal_of({.balls = {{}, {{0, 0}, bad}}}) != "");
        CHECK(refusal_of({.pool = {{}, bad}}) != "");
        CHECK(refusal_of({.maybe = bad}) != "");
        CHECK(refusal_of({.ball = Ball{{bad, 0}, 1}}) != "");
        CHECK(refusal_of({}, {{}, {{0, 0}, bad}}) != "");
    }
}

TEST_CASE("a section may take larger numbers in an exercise, and then says so in the refusal") {
    CHECK(refusal(2, border_exercises::Clock{1e10}) == "");
    CHECK(refusal(2, border_exercises::Clock{2e10}) == "each number must lie within ±1e10, but is 20000000000");
    CHECK(refusal(2, border_exercises::Clock{std::nan("")}) != "");
}
