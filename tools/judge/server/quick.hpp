// Put before every student's file where Clang compiles it first: `student.hpp`, with the templates that answers use made
// and compiled beforehand. (GCC would load that more slowly than it makes them.)
#include "student.hpp"

namespace course::at_hand {

/// A sum is assigned, `Vec2{sum}`, or `Vec2 a = sum`.
template <class Sum> void keep(Vec2 &a, const Sum &sum) {
    a = sum, a = Vec2{sum};
    const Vec2 b = sum;
    a = b;
}
template <class... Sums> void keep(Vec2 &a, const Sums &...sums) { (keep(a, sums), ...); }

/// What is in each cell of a grid.
inline int made_for_grids(std::map<std::pair<int, int>, std::vector<int>> &grid) {
    grid[{1, 2}].push_back(3);
    const auto near = grid.find({1, 2});
    int sum = near != grid.end() ? near->second.front() : static_cast<int>(grid.size());
    for (const int each : grid[{0, 0}]) sum += each;
    return sum;
}

// Nobody calls it.
inline double made_once(std::vector<Vec2> &points, std::vector<double> &numbers, std::optional<Vec2> &point,
                        std::optional<double> &number, std::optional<int> &count) {
    Vec2 a = points.front(), b{-a.y(), a.x()};
    const Vec2 p = points.back(), q = Vec2::Zero();
    double t = numbers[0];
    keep(a, p + q, p - q, -p, t * p, p * t, p / t, 2 * t * p, 2 * p, p / 2, t * p / 2);
    keep(a, p + t * q, p - t * q, p + q * t, p - q * t, p + q / t);
    keep(a, p + t * q + t * b, p + t * q + 0.5 * t * t * b, p + q - b, p - q - b, p - q + b);
    keep(a, t * p + q, t * p + t * q, t * (p + t * q), p / t * t, t / t * p, t * (p / t), p.cwiseMax(q).cwiseMin(b));
    keep(a, t * (p + q), t * (p - q), (p + q) / t, (p - q) / t, p + t * (q - p), p + q + b);
    a += p, a -= p, a *= t, a /= t, a += t * p, a -= t * p, a += p * t, a += 0.5 * t * p, a += p + q, a += p - q,
        a += t * (p + q), a += t * (p - q), a = p.normalized();
    a[0] = t, b = {t, 1}, b = {0, 1}, a = points[1];
    points.push_back(a), points.push_back({t, 1}), points.emplace_back(t, 1), numbers.push_back(t);
    points.pop_back(), points.clear(), points.reserve(3), points.resize(2), numbers.resize(2);
    const std::vector<Vec2> more = points, pair{a, b};
    const std::vector<double> others = numbers;
    points = more, numbers = others;
    for (const Vec2 &each : points) a += each;
    for (const double each : numbers) t += each;
    a += pair[0], t += others[0];
    std::sort(numbers.begin(), numbers.end());
    point = a, point = std::nullopt, number = t, number = std::nullopt, count = 1, count = std::nullopt;
    if (point && number) t += point->x() + (*point).y() + *number;
    t += p.dot(q) + (p - q).dot(a) + a.dot(p - q) + p.norm() + (p - q).norm() + p.squaredNorm() + (p - q).squaredNorm();
    t += (p + q - b).dot(a) + (p - q - b).dot(a) + (t * p).dot(q) + (p - t * q).dot(a) + (p + t * q - b).squaredNorm();
    t += (p - q).dot(p - q) + (p + t * q).norm() + (p + q).norm() + (t * p).norm() + (p - q).normalized().dot(a)
         + (p + t * q - b).dot(a) + (p + t * q - b).norm() + (p - q).minCoeff() + (p - q).maxCoeff();
    t += std::max(t, 1.0) + std::min(t, 1.0) + std::clamp(t, 0.0, 1.0) + std::abs(t) + std::sqrt(t) + std::hypot(t, t);
    return p.allFinite() && p != q && !(p == q) && std::isfinite(t) && points.size() > 1 && !points.empty() ? t : 0;
}

} // namespace course::at_hand
