// 7.5: a point against a stadium: the motion is clipped to the box and to both circles, and the earliest wins
#include "segment_intersection.hpp"

#include <algorithm>

namespace segment_intersection {

namespace {
struct Inside { // for t from enter to leave
    double enter, leave;
    bool any() const { return enter <= leave; }
};
} // namespace

static Inside slab(double from, double way, double low, double high) {
    if (way == 0) return from >= low && from <= high ? Inside{-1e300, 1e300} : Inside{1, -1};
    const double t_1 = (low - from) / way, t_2 = (high - from) / way;
    return {std::min(t_1, t_2), std::max(t_1, t_2)};
}
static Inside circle(const Vec2 &from, const Vec2 &way, double radius) {
    const double square = way.squaredNorm(), middle = -from.dot(way) / square;
    const double beside = way.x() * from.y() - way.y() * from.x(),
                 half_square = radius * radius - beside * beside / square;
    if (half_square < 0) return {1, -1};
    const double half = std::sqrt(half_square / square);
    return {middle - half, middle + half};
}

std::optional<Impact> time_of_impact(const Segment &motion, double radius, const Segment &wall) {
    course::require(radius >= 0, "radius [m] must not be negative", radius);
    // in the wall's frame: it lies on the x axis, from 0 to its length
    const double length = (wall.end - wall.start).norm();
    const Vec2 along = length > 0 ? Vec2{(wall.end - wall.start) / length} : Vec2{1, 0};
    Eigen::Matrix2d turn;
    turn << along.x(), along.y(), -along.y(), along.x();
    const Vec2 from = turn * (motion.start - wall.start), way = turn * (motion.end - motion.start);
    const Vec2 from_end = from - Vec2{length, 0};
    const Vec2 away{from.x() - std::clamp(from.x(), 0.0, length), from.y()};
    if (away.dot(way) >= 0) return {};

    double t = 2;
    if (away.norm() <= radius) t = 0;
    else {
        const Inside x = slab(from.x(), way.x(), 0, length), y = slab(from.y(), way.y(), -radius, radius);
        const Inside box{std::max(x.enter, y.enter), std::min(x.leave, y.leave)};
        for (const Inside &part : {box, circle(from, way, radius), circle(from_end, way, radius)})
            if (part.any() && part.enter >= 0) t = std::min(t, part.enter);
    }
    if (t > 1) return {};
    const Vec2 there = from + t * way, foot{std::clamp(there.x(), 0.0, length), 0};
    return Impact{t, wall.start + turn.transpose() * there, wall.start + turn.transpose() * foot};
}

} // namespace segment_intersection
