// 7.6: the exact sign: a sum of parts that lose nothing to rounding, added until only the largest is left
#include "segment_intersection.hpp"

namespace segment_intersection {

int orientation(const Segment &first, const Segment &second) {
    const auto [p, q] = first;
    const auto [u, v] = second;
    std::vector<double> parts; // of (q.x - p.x)(v.y - u.y) - (q.y - p.y)(v.x - u.x), each product as two numbers
    const auto add = [&](double x, double y) {
        parts.push_back(x * y);
        parts.push_back(std::fma(x, y, -x * y));
    };
    add(q.x(), v.y()), add(-q.x(), u.y()), add(-p.x(), v.y()), add(p.x(), u.y());
    add(-q.y(), v.x()), add(q.y(), u.x()), add(p.y(), v.x()), add(-p.y(), u.x());

    for (int round = 0; round < 60; ++round) // each pair becomes its sum and what the sum has lost, which sinks down
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const double x = parts[i - 1], y = parts[i], sum = x + y, part = sum - x;
            parts[i - 1] = (x - (sum - part)) + (y - part);
            parts[i] = sum;
        }
    return parts.back() > 0 ? 1 : parts.back() < 0 ? -1 : 0;
}

} // namespace segment_intersection
