#pragma once
// What every section shares, and every student's file compiles: keep it small.

#include <Eigen/Core>

// A formula of vectors, as in `const auto there = start + t * fall();`, is worked out where it's used. Eigen keeps references
// in it to what it's made of, and the vector of fall() is gone by then. So these make it keep copies, of matrices, too.
namespace Eigen::internal { // before Geometry, which has formulas of its own

template <class T, int Rows, int Columns>
requires(Rows > 0 && Columns > 0) struct ref_selector<const Matrix<T, Rows, Columns>> {
    using type = const Matrix<T, Rows, Columns>;
    using non_const_type = type;
};
template <class T, int Rows, int Columns>
requires(Rows > 0 && Columns > 0) struct ref_selector<Matrix<T, Rows, Columns>> {
    using type = const Matrix<T, Rows, Columns>;
    using non_const_type = Matrix<T, Rows, Columns> &; // `matrix.col(0) = v` writes into the original
};

} // namespace Eigen::internal

#include <Eigen/Geometry>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

/// What all sections share.
namespace course {

using Vec2 = Eigen::Vector2d; ///< x to the right, y up; metres unless said otherwise

/// Thrown by an exercise that has not been started; what() says where to begin.
/// The tests report it as "not started". It is no std::invalid_argument, so no refusal is taken for it.
struct NotYet : std::runtime_error {
    explicit NotYet(const char *hint, const char *in = __builtin_FUNCTION()) : std::runtime_error{hint}, function{in} {}

    const char *function; ///< the one that throws: others may have called it
};

/// Throws for `require`: apart from it, and without a std::string, since every file compiles it.
[[noreturn, gnu::noinline, gnu::cold]] inline void refuse(const char *claim, double value) {
    char text[200];
    std::snprintf(text, sizeof text, "%s, but is %.17g", claim, value);
    throw std::invalid_argument{text};
}

/// Refuses a value, and says which: `require(radius > 0, "radius [m] must be positive", radius)`.
/// @throws std::invalid_argument "radius [m] must be positive, but is -1"
inline void require(bool holds, const char *claim, double value) {
    if (!holds) refuse(claim, value);
}

/// What goes into a function, in whatever unit, is within ± this.
inline constexpr double largest = 1e5;

inline void require_number(double x) { require(std::abs(x) <= largest, "each number must lie within ±1e5", x); }
inline void require_number(const Vec2 &v) {
    require_number(v.x());
    require_number(v.y());
}

template <class T> void require_number(const std::vector<T> &list) {
    for (const T &each : list) require_number(each);
}

/// Refuses numbers, vectors and lists of them that break this rule: `course::require_range(start, velocity, t)`.
/// @throws std::invalid_argument naming the first number outside; "not a number" is outside.
template <class... Values> void require_range(const Values &...values) { (require_number(values), ...); }

} // namespace course
