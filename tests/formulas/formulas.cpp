// Spellings that keep a formula of vectors beyond the vectors that it's made of: right with whatever compiles an answer.
// See course.hpp. It prints those that come out wrong, and how many these are.
#include "course.hpp"

#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

using course::Vec2;

namespace {

int wrong = 0;

[[gnu::noinline]] Vec2 fall(double t) { return {0, -5 * t * t}; }
[[gnu::noinline]] double overwrite_the_stack() {
    volatile double many[300];
    for (volatile double &each : many) each = 7e77;
    return many[7];
}

template <class Formula> void expect(const char *spelling, const Formula &formula, double x, double y) {
    overwrite_the_stack();
    const Vec2 got = formula;
    if ((got - Vec2{x, y}).norm() < 1e-12) return;
    std::printf("%s is (%g, %g), not (%g, %g)\n", spelling, got.x(), got.y(), x, y);
    ++wrong;
}

void functions(const Vec2 &start) {
    const auto sum = start + fall(1);
    expect("a sum with a function's result", sum, 3, -1);
    const auto scaled = 2 * fall(2) - start / 2;
    expect("multiples of it", scaled, -1.5, -42);
    const auto opposite = -fall(1);
    expect("its opposite", opposite, 0, 5);
    auto &&kept = start - fall(1);
    expect("auto &&", kept, 3, 9);
    const auto &bound = start + 2 * fall(1);
    expect("const auto &", bound, 3, -6);
    const auto unit = (start + fall(0)).normalized();
    expect("a direction", unit, 0.6, 0.8);
    const auto larger = fall(1).cwiseMax(start);
    expect("the larger of each", larger, 3, 4);
    const bool early = start.x() > 0;
    const auto either = early ? start + fall(1) : start + fall(2);
    expect("one of two", either, 3, -1);
}

void lambdas(const Vec2 &start, const Vec2 &velocity, double g) {
    const auto at = [&](double t) {
        const Vec2 a{0, -g};
        return start + t * velocity + 0.5 * t * t * a;
    };
    const auto later = at(2);
    expect("a lambda's formula of its own vector", later, 5, -14);
    const auto twice = [](auto any) { return 2 * any; };
    const auto doubled = twice(fall(1));
    expect("a generic lambda", doubled, 0, -10);
    const auto mirrored = [](Vec2 v, Vec2 n) { return v - 2 * v.dot(n) * n; };
    const auto up = mirrored(fall(1), {0, 1});
    expect("a lambda's formula of its parameters", up, 0, 5);
    const auto products = [](Vec2 a, Vec2 b) { return a.cwiseProduct(b); };
    const auto by_parts = products(start, velocity);
    expect("products of each", by_parts, 3, 4);
}

void lists(const Vec2 &start) {
    const std::vector formulas{start + fall(1), start + fall(2)};
    expect("a list of formulas", formulas[1], 3, -16);
    const std::optional maybe{start + fall(1)};
    expect("an optional formula", *maybe, 3, -1);
    const auto [here, there] = std::pair{start + fall(0), start - fall(1)};
    expect("the first of a pair", here, 3, 4);
    expect("the second of a pair", there, 3, 9);
}

void matrices() {
    const auto turned = [](double angle) {
        Eigen::Matrix2d turn;
        turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        return turn * Vec2{2, 0};
    };
    const auto quarter = turned(std::acos(0.0));
    expect("a local matrix times a vector", quarter, 0, 2);
    const auto row = [](const Vec2 &v) { return v.transpose(); };
    const auto lying = row(fall(1));
    expect("a row", lying.transpose(), 0, -5);
    Eigen::Matrix2d matrix;
    matrix.col(0) = fall(1), matrix.row(1) += Eigen::RowVector2d{1, 2}, matrix(0, 1) = 1;
    expect("a matrix written to by parts, in its first column", matrix.col(0), 0, -4);
}

} // namespace

int main() {
    functions({3, 4});
    lambdas({3, 4}, {1, 1}, 10);
    lists({3, 4});
    matrices();
    return wrong;
}
