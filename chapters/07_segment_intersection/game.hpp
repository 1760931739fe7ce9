#pragma once
// The game of this chapter, as it grows: a ball in a room. The program runs it, with the functions of section 7.
#include "segment_intersection.hpp"

namespace segment_intersection {

//> The walls of a room
/// The walls of a room: each joins a corner to the next, and the last corner to the first.
inline std::vector<Segment> walls_of(const std::vector<Vec2> &room) {
    std::vector<Segment> walls;
    for (std::size_t i = 0; i < room.size(); ++i) walls.push_back({room[i], room[(i + 1) % room.size()]});
    return walls;
}

//> Reflected at a wall
/// A velocity after a smooth, elastic wall: the part across the wall is reversed, the part along it stays.
inline Vec2 reflected(const Vec2 &velocity, const Segment &wall) {
    const Vec2 along = (wall.end - wall.start).normalized();
    return 2 * velocity.dot(along) * along - velocity;
}

/// Whether this velocity leads out of the room. Seen along a wall, inside is left, so out is right.
inline bool leads_out(const Vec2 &velocity, const Segment &wall) {
    const Vec2 along = wall.end - wall.start;
    return along.x() * velocity.y() - along.y() * velocity.x() < 0;
}

//> The frame loop
/// One frame: the ball moves for `dt` seconds, or until it hits a wall, which reflects it.
inline Ball next_frame(const Ball &ball, const std::vector<Segment> &walls, double dt) {
    Segment motion{ball.position, ball.position + dt * ball.velocity};
    Vec2 velocity = ball.velocity;
    for (const Segment &wall : walls) {
        const auto hit = intersect_lines(motion, wall);
        if (!hit || !segments_intersect(motion, wall) || !leads_out(ball.velocity, wall)) continue;
        motion.end = hit->point; // the ball stops here, so any wall that it still hits comes even sooner
        velocity = reflected(ball.velocity, wall);
    }
    return {motion.end, velocity};
}

//> The frame loop, for a ball with a size
/// One frame of a ball with a radius: it moves until it first touches a wall, which reflects it.
inline Ball next_frame(const Ball &ball, double radius, const std::vector<Segment> &walls, double dt) {
    const Segment motion{ball.position, ball.position + dt * ball.velocity};
    std::optional<Impact> first;
    for (const Segment &wall : walls) {
        const auto impact = time_of_impact(motion, radius, wall);
        if (impact && (!first || impact->t < first->t)) first = impact;
    }
    if (!first) return {motion.end, ball.velocity};
    const Vec2 normal = (first->centre - first->point).normalized();
    return {first->centre, ball.velocity - 2 * ball.velocity.dot(normal) * normal};
}
//>
} // namespace segment_intersection
