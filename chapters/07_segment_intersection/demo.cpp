#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace segment_intersection;
using demo::Colour, demo::Input, demo::Shape;

// The ball's games come first; in the last two there is none.
enum Game {
    asks_once_a_frame,
    asks_where,
    asks_about_the_motion,
    bounces_once_a_frame,
    bounces,
    has_a_size,
    common,
    turns
};

const std::vector<std::string_view> with_ball{"asks once a frame",          "asks 7.1",      "asks 7.2",
                                              "bounces once a frame (7.2)", "bounces (7.4)", "has a size (7.5)"};
const demo::About about{
    "A ball in a room with seven walls. Drag the tip of its arrow to throw it, or a corner; it turns to where you "
    "press.",
    {0, -0.5},
    {12, 7.5},
    {demo::choice("The game",
                  {"asks once a frame", "asks 7.1", "asks 7.2", "bounces once a frame (7.2)", "bounces (7.4)",
                   "has a size (7.5)", "two segments (7.3)", "left or right (7.6)"},
                  asks_once_a_frame),
     {"frames per second", "", 5, 120, 1, 30, {}, with_ball},
     {"radius", "m", 0.1, 0.5, 0.01, 0.15, {}, {"asks once a frame", "has a size (7.5)"}}},
    {{"t", "Turn the ball", with_ball}}};
const demo::Still still{1.1};

/// The arrow is as long as the way of so many seconds.
constexpr double arrow_time = 0.1;

struct State {
    std::vector<Vec2> room;
    Ball ball;
    std::vector<double> lit; // until when each wall is lit [s]
    std::vector<Vec2> trail; // where the ball was in the last frames
    double time{}, spare{};
    int noticed{}, missed{};
    std::vector<Vec2> common_ends{{1, 1}, {7, 4}, {9, 5}, {3, 2}},
        turn_ends{{1.3, 0.8}, {5.6, 2.9}, {3.9, 3.2}, {8.2, 5.3}};
};

State begin() {
    return {{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}},
            {{2, 3}, {3.6, 1.7}},
            std::vector<double>(7, -1.0),
            {}};
}

/// What many games ask: whether the ball touches a wall now, wherever it was a moment ago.
bool touches_now(const Vec2 &centre, double radius, const Segment &wall) {
    const Vec2 along = wall.end - wall.start;
    const double s = std::clamp(along.dot(centre - wall.start) / along.squaredNorm(), 0.0, 1.0);
    return (wall.start + s * along - centre).norm() <= radius;
}

State one_frame(State now, Game game, double radius, double dt) {
    const std::vector<Segment> walls = walls_of(now.room);
    const Segment motion{now.ball.position, now.ball.position + dt * now.ball.velocity};
    if (game == bounces_once_a_frame) now.ball = next_frame(now.ball, walls, dt);
    else if (game == bounces) now.ball = move_and_bounce(now.ball, now.room, dt);
    else if (game == has_a_size) now.ball = next_frame(now.ball, radius, walls, dt);
    else now.ball.position = motion.end; // it flies on, through whatever is in its way

    now.time += dt;
    for (std::size_t i = 0; i < walls.size() && game != asks_where; ++i) {
        const bool before = touches_now(motion.start, radius, walls[i]),
                   after = touches_now(motion.end, radius, walls[i]);
        const bool seen = game == asks_once_a_frame ? after && !before
                          : game == has_a_size      ? time_of_impact(motion, radius, walls[i]).has_value()
                                                    : segments_intersect(motion, walls[i]);
        if (seen) now.lit[i] = now.time + 0.4, ++now.noticed;
        else if (game == asks_once_a_frame && !before && segments_intersect(motion, walls[i])) ++now.missed;
    }

    now.trail.push_back(motion.start);
    if (now.trail.size() > 30) now.trail.erase(now.trail.begin());
    for (int k : {0, 1}) { // what leaves the picture enters it on the other side; a ball that must not, starts again
        const double width = about.high[k] - about.low[k];
        const double pictures = std::floor((now.ball.position[k] - about.low[k]) / width);
        if (pictures == 0 || !std::isfinite(pictures)) continue; // if it is nowhere, the page says so
        now.trail.clear();
        if (game >= bounces_once_a_frame) now.ball.position = begin().ball.position;
        else now.ball.position[k] -= pictures * width;
    }
    return now;
}

bool walls_cross(const std::vector<Segment> &walls) {
    for (std::size_t i = 0; i < walls.size(); ++i)
        for (std::size_t j = i + 2; j < walls.size() - (i == 0); ++j)
            if (segments_intersect(walls[i], walls[j])) return true;
    return false;
}

/// An end goes to a point of a grid with so many lines per metre: whole metres are exact, tenths are not.
void drag(std::vector<Vec2> &ends, double lines, const Input &in) {
    if (in.handle < 0 || in.handle >= int(ends.size())) return;
    const Vec2 to = in.pointer.cwiseMax(Vec2{0, 0}).cwiseMin(Vec2{12, 7});
    ends[std::size_t(in.handle)] = {std::round(to.x() * lines) / lines, std::round(to.y() * lines) / lines};
}

State next(State now, const Input &in) {
    const auto game = static_cast<Game>(in["The game"]);
    if (game >= common) {
        drag(game == common ? now.common_ends : now.turn_ends, game == common ? 1 : 10, in);
        return now;
    }
    Vec2 &velocity = now.ball.velocity;
    if (in.key == "t") velocity = {0.8 * velocity.x() - 0.6 * velocity.y(), 0.6 * velocity.x() + 0.8 * velocity.y()};
    const Vec2 to_pointer = in.pointer - now.ball.position;
    if (in.pressed && in.handle < 0 && to_pointer.norm() > 0) velocity = velocity.norm() * to_pointer.normalized();
    if (in.handle == 0) { // while somebody aims, time stands still
        const Vec2 aimed = to_pointer / arrow_time;
        if (aimed.norm() > 0) velocity = aimed * std::clamp(1.0, 1 / aimed.norm(), 60 / aimed.norm());
        return now;
    }
    if (in.handle > 0 && in.handle <= int(now.room.size())) {
        std::vector<Vec2> room = now.room;
        room[std::size_t(in.handle) - 1] = in.pointer.cwiseMax(about.low).cwiseMin(about.high);
        if (!walls_cross(walls_of(room))) now.room = room;
    }
    const double dt = 1 / in["frames per second"];
    for (int due = demo::steps_due(now.spare, in, dt); due > 0; --due) now = one_frame(now, game, in["radius"], dt);
    return now;
}

/// The line along the ball's arrow, and the points where it crosses the lines of the walls: on the wall, or beyond it.
void add_intersections(demo::Picture &seen, const Segment &motion, const std::vector<Segment> &walls) {
    const Vec2 far = 100 * (motion.end - motion.start);
    seen.shapes.push_back({Shape::line, Colour::blue, -1.5, 0.6, {motion.start - far, motion.end + far}});
    double next_t = 0;
    for (const Segment &wall : walls) {
        const auto found = intersect_lines(motion, wall);
        if (!found) continue;
        const auto &[t, s, point] = *found;
        const bool on_wall = s >= 0 && s <= 1;
        if (!on_wall)
            seen.shapes.push_back({Shape::line, Colour::dim, -1, 0.6, {s < 0 ? wall.start : wall.end, point}});
        seen.shapes.push_back(
            {Shape::discs, on_wall ? Colour::orange : Colour::dim, on_wall ? 0.14 : 0.09, 1, {point}});
        if (on_wall && t > 0 && (next_t == 0 || t < next_t)) next_t = t;
    }
    seen.readouts = {{"speed", "m/s", (motion.end - motion.start).norm() / arrow_time, 1},
                     {"t at the next wall", "", next_t, 2}};
}

/// Two segments by their four ends, and what they have in common.
demo::Picture two_segments(const std::vector<Vec2> &ends) {
    demo::Picture seen{{{Shape::line, Colour::blue, 3, 1, {ends[0], ends[1]}},
                        {Shape::line, Colour::green, 3, 1, {ends[2], ends[3]}}}};
    const std::vector<Vec2> both = common_points({ends[0], ends[1]}, {ends[2], ends[3]});
    seen.shapes.push_back({Shape::line, Colour::orange, 7, 1, both});
    seen.shapes.push_back({Shape::discs, Colour::orange, 0.17, 1, both});
    seen.shapes.push_back({Shape::handle, Colour::ink, 0, 1, ends});
    seen.readouts = {{"points in common", "", double(both.size()), 0}};
    return seen;
}

/// Two arrows, and to which side of the first the second points: as 7.6 says, and as the sign of the rounded determinant has it.
demo::Picture two_arrows(const std::vector<Vec2> &ends) {
    const Vec2 a = ends[1] - ends[0], b = ends[3] - ends[2];
    const double d = a.x() * b.y() - a.y() * b.x();
    const int turn = orientation({ends[0], ends[1]}, {ends[2], ends[3]});
    const char *const side = turn > 0 ? "left" : turn < 0 ? "right" : "cannot tell";
    demo::Picture seen{{{Shape::arrow, Colour::blue, 3, 1, {ends[0], ends[1]}},
                        {Shape::arrow, Colour::orange, 3, 1, {ends[2], ends[3]}},
                        {Shape::words, Colour::orange, 0, 1, {ends[3] + Vec2{0.3, -0.1}}, side},
                        {Shape::handle, Colour::ink, 0, 1, ends}}};
    seen.readouts = {{"7.6 says", "", double(turn), 0}, {"rounded sign", "", double(d > 0) - double(d < 0), 0}};
    return seen;
}

demo::Picture draw(const State &now, const Input &in) {
    const auto &[at, velocity] = now.ball;
    const auto game = static_cast<Game>(in["The game"]);
    if (game == common) return two_segments(now.common_ends);
    if (game == turns) return two_arrows(now.turn_ends);
    const double radius = game == asks_once_a_frame || game == has_a_size ? in["radius"] : 0.07; // as a point
    demo::Picture seen{{{Shape::area, Colour::line, 0, 0.3, now.room}}};
    const std::vector<Segment> walls = walls_of(now.room);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const bool lit = now.time < now.lit[i];
        seen.shapes.push_back(
            {Shape::line, lit ? Colour::orange : Colour::dim, lit ? 5.0 : 2.5, 1, {walls[i].start, walls[i].end}});
    }
    const Vec2 tip = at + arrow_time * velocity;
    seen.shapes.push_back({Shape::discs, Colour::blue, radius, 0.18, now.trail});
    seen.shapes.push_back({Shape::discs, Colour::blue, radius, 1, {at}});
    seen.shapes.push_back({Shape::arrow, Colour::blue, 2, 1, {at, tip}});
    seen.shapes.push_back({Shape::handle, Colour::blue, 0, 1, {tip}});
    seen.shapes.push_back({Shape::handle, Colour::green, 0, 1, now.room});
    if (game == asks_where) return add_intersections(seen, {at, tip}, walls), seen;
    seen.readouts = {{"speed", "m/s", velocity.norm(), 1},
                     {"from frame to frame", "m", velocity.norm() / in["frames per second"], 2},
                     {"walls noticed", "", double(now.noticed), 0},
                     {"walls missed", "", double(now.missed), 0}};
    return seen;
}
} // namespace play
