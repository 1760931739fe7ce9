// Put before every student's file where Clang compiles it first: `student.hpp`, with the templates that answers use made
// and compiled beforehand. (GCC would load that more slowly than it makes them.)
#include "student.hpp"

#include <tuple>
#include <utility>

namespace course::at_hand {

/// As the structs of headers are compared and shown.
template <class... Fields> bool tied(Fields &...fields) {
    return std::tie(fields...) == std::tie(std::as_const(fields)...);
}

// Nobody calls it.
inline double made_once(std::vector<Vec2> &points, std::vector<double> &numbers, std::optional<Vec2> &point,
                        std::optional<double> &number) {
    Vec2 a = points.front(), b{-a.y(), a.x()};
    const Vec2 p = points.back(), q = Vec2::Zero();
    double t = numbers[0];
    a = p + q, a = p - q, a = -p, a = t * p, a = p * t, a = p / t, a = 2 * t * p;
    a = p + t * q, a = p - t * q, a = p + q * t, a = p - q * t, a = p + q / t;
    a = p + t * q + t * b, a = p + t * q + 0.5 * t * t * b, a = p + q - b, a = p - q - b, a = p - q + b;
    a = t * (p + q), a = t * (p - q), a = (p + q) / t, a = (p - q) / t, a = p + t * (q - p), a = p + q + b;
    a += p, a -= p, a *= t, a /= t, a += t * p, a -= t * p, a += p * t, a += 0.5 * t * p, a += p + q, a += p - q,
        a = p.normalized();
    a[0] = t, b = {t, 1};
    points.push_back(a), points.push_back({t, 1}), points.emplace_back(t, 1), numbers.push_back(t);
    points.pop_back(), points.clear(), points.reserve(3), points.resize(2), numbers.resize(2);
    const std::vector<Vec2> more = points;
    const std::vector<double> others = numbers;
    points = more, numbers = others;
    for (const Vec2 &each : points) a += each;
    for (const double each : numbers) t += each;
    std::sort(numbers.begin(), numbers.end());
    point = a, point = std::nullopt, number = t, number = std::nullopt;
    if (point && number) t += point->x() + (*point).y() + *number;
    t += p.dot(q) + (p - q).dot(a) + a.dot(p - q) + p.norm() + (p - q).norm() + p.squaredNorm() + (p - q).squaredNorm();
    t += (p + q - b).dot(a) + (p - q - b).dot(a) + (t * p).dot(q) + (p - t * q).dot(a) + (p + t * q - b).squaredNorm();
    t += std::max(t, 1.0) + std::min(t, 1.0) + std::clamp(t, 0.0, 1.0) + std::abs(t) + std::sqrt(t) + std::hypot(t, t);
    const bool same = tied(a, b) && tied(a, b, t) && tied(t, t, a) && tied(t, t) && tied(t, t, t) && tied(t, t, t, t);
    return same && p.allFinite() && p != q && !(p == q) && std::isfinite(t) && points.size() > 1 && !points.empty() ? t
                                                                                                                    : 0;
}

} // namespace course::at_hand
