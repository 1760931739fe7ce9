// Compiled once and put before every student's file: what exercises use, and nothing more, or it would load slowly.
#include <cstddef>
#undef _GLIBCXX_USE_STD_SPEC_FUNCS // of <cmath>: Bessel's functions and others would be compiled again with every file

#include "course.hpp"
#include "interface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace course::at_hand {

extern const Vec2 v; // for its type: it is nowhere
inline constexpr double c = 1;
template <class... Types> constexpr int sizes = (static_cast<int>(sizeof(Types)) + ...);

/// The type of `v.dot(v)` before it is summed.
using Products = decltype(v.binaryExpr(v, Eigen::internal::scalar_conj_product_op<double, double>{}));

/// The types of the sums that every exercise writes: the compiler makes them once, here, not for every file.
inline constexpr int made =
    sizes<decltype(v + v), decltype(v - v), decltype(-v), decltype(c * v), decltype(v * c), decltype(v / c),
          decltype(v + c * v), decltype(v - c * v), decltype(v + v * c), decltype(c * (v + v)), decltype((v + v) / c),
          decltype((v - v) / c), decltype(v.dot(v)), decltype((v - v).dot(v)), decltype(v.norm()),
          decltype((v - v).norm()), decltype(v.squaredNorm()), decltype((v - v).squaredNorm()), decltype(Vec2{v + v}),
          decltype(Vec2{v - v}), decltype(Vec2{c * v}), decltype(Vec2{v + c * v}), decltype(Vec2{v / c}),
          decltype(v.cwiseAbs2()), decltype((v - v).cwiseAbs2()), Products, std::vector<Vec2>, std::vector<double>,
          std::optional<Vec2>>;

} // namespace course::at_hand
