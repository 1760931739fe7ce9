#include "../program.hpp"

#include "game.hpp"

#include <algorithm>
#include <numbers>
#include <random>

using namespace segment_intersection;
using course::row, course::text;

//> How a segment is printed
std::string text(const Segment &s) { return course::text(s.start) + '-' + course::text(s.end); }

//> Intersections
const Segment motion{.start = {4, 7}, .end = {16, 3}}; // the worked example
const Segment wall{.start = {1, 1}, .end = {17, 10}};
const Segment misprint{.start = {1, 1}, .end = {18, 11}}; // the wall that the printed numbers belong to

void print_intersections(std::ostream &out) {
    out << row({{"motion", 16}, {"wall", 17}, {"t", 10}, {"s", 10}, {"where the lines cross", 0}});
    for (const auto &[first, second] : {std::pair{motion, wall},
                                        {motion, misprint},
                                        {Segment{{0, 0}, {1, 1}}, Segment{{3, 0}, {0, 3}}},
                                        {Segment{{0, 0}, {4, 2}}, Segment{{1, 1}, {7, 4}}}}) {
        const auto found = intersect_lines(first, second);
        const std::string t = found ? text(found->t) : "-", s = found ? text(found->s) : "-";
        const std::string point = found ? text(found->point) : "nowhere";
        out << row({{text(first), 16}, {text(second), 17}, {t, 10}, {s, 10}, {point, 0}});
    }
}

//> Quarters
void trace_shares(std::ostream &out) {
    const Vec2 point = intersect_lines(motion, wall).value().point;
    out << "# t or s[1]\tmotion x[m]\tmotion y[m]\twall x[m]\twall y[m]\tintersection x[m]\tintersection y[m]\n";
    for (const double quarter : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec2 on_motion = motion.start + quarter * (motion.end - motion.start);
        const Vec2 on_wall = wall.start + quarter * (wall.end - wall.start);
        out << quarter << '\t' << on_motion.x() << '\t' << on_motion.y() << '\t' << on_wall.x() << '\t' << on_wall.y()
            << '\t' << point.x() << '\t' << point.y() << '\n';
    }
}

//> In print, and in truth
void trace_print(std::ostream &out) {
    out << "# from x[m]\tfrom y[m]\tto x[m]\tto y[m]\tintersection x[m]\tintersection y[m]\n";
    for (const Segment &second : {wall, misprint}) {
        const Vec2 point = intersect_lines(motion, second).value().point;
        out << second.start.x() << '\t' << second.start.y() << '\t' << second.end.x() << '\t' << second.end.y() << '\t'
            << point.x() << '\t' << point.y() << '\n';
    }
}

//> Meetings
const std::vector<std::pair<Segment, Segment>> pairs{
    {motion, wall},
    {{{0, 0}, {1, 1}}, {{3, 0}, {0, 3}}}, // the lines cross, the segments do not
    {{{0, 0}, {4, 2}}, {{2, 1}, {5, 0}}}, // an end touches
    {{{0, 0}, {4, 2}}, {{6, 3}, {2, 1}}}, // one line, and an overlap
    {{{0, 0}, {4, 2}}, {{6, 3}, {8, 4}}}, // one line, and a gap
};

void print_meetings(std::ostream &out) {
    out << row({{"first", 16}, {"second", 17}, {"do they meet?", 0}});
    for (const auto &[first, second] : pairs)
        out << row({{text(first), 16}, {text(second), 17}, {segments_intersect(first, second) ? "yes" : "no", 0}});
}

//> Two pairs and their sides
void trace_sides(std::ostream &out) {
    out << "# first x[m]\tfirst y[m]\tsecond x[m]\tsecond y[m]\n";
    for (const auto &[first, second] : {pairs[0], pairs[1]})
        for (const auto &[p, q] : {std::pair{first.start, second.start}, {first.end, second.end}})
            out << p.x() << '\t' << p.y() << '\t' << q.x() << '\t' << q.y() << '\n';
}

//> The room
const std::vector<Vec2> room{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};
const Ball thrown{.position = {2, 3}, .velocity = {2.3, 1.1}};

/// Runs a frame loop for a minute.
/// @return for each number of frames per second, in how many of them it hits a wall, and where it ends
template <class NextFrame> void print_minutes(std::ostream &out, NextFrame next) {
    out << row({{"frames per second", 19}, {"frames with a hit", 19}, {"after one minute", 0}});
    for (const int rate : {60, 20, 2}) {
        Ball ball = thrown;
        int hits = 0;
        for (int frame = 0; frame < 60 * rate; ++frame) {
            const Vec2 before = ball.velocity;
            ball = next(ball, 1.0 / rate);
            if (ball.velocity != before) ++hits;
        }
        out << row({{std::to_string(rate), 19}, {std::to_string(hits), 19}, {text(ball.position), 0}});
    }
}

//> A minute, frame by frame
void print_frames(std::ostream &out) {
    print_minutes(out, [](const Ball &ball, double dt) { return next_frame(ball, walls_of(room), dt); });
}

//> The path in the room
/// Writes a path of 20 frames a second, with one corner of the room beside each frame, so that the figure knows the walls.
template <class NextFrame> void trace_path(std::ostream &out, int seconds, NextFrame next) {
    out << "# t[s]\tx[m]\ty[m]\tcorner x[m]\tcorner y[m]\n";
    Ball ball = thrown;
    for (int frame = 0; frame <= 20 * seconds; ++frame) {
        const Vec2 &corner = room[std::size_t(frame) % room.size()];
        out << frame / 20.0 << '\t' << ball.position.x() << '\t' << ball.position.y() << '\t' << corner.x() << '\t'
            << corner.y() << '\n';
        ball = next(ball, 1.0 / 20);
    }
}

void trace_frames(std::ostream &out) {
    trace_path(out, 20, [](const Ball &ball, double dt) { return next_frame(ball, walls_of(room), dt); });
}

//> Common points
void print_common(std::ostream &out) {
    out << row({{"first", 16}, {"second", 17}, {"what they have in common", 0}});
    for (const auto &[first, second] : pairs) {
        const auto points = common_points(first, second);
        std::string words = points.empty() ? "nothing" : text(points[0]);
        if (points.size() > 1) words += " to " + text(points[1]);
        out << row({{text(first), 16}, {text(second), 17}, {words, 0}});
    }
}

//> The parts of a velocity at a wall
void trace_parts(std::ostream &out) {
    const Vec2 at{18.5, 2}, velocity{5, 0}, normal{-0.8, -0.6}; // the worked example
    const Vec2 across = velocity.dot(normal) * normal, along = velocity - across;
    out << "# from x[m]\tfrom y[m]\tarrow x[m/s]\tarrow y[m/s]\n";
    for (const auto &[from, arrow] : {std::pair{Vec2{at - velocity}, velocity},
                                      {at, across},
                                      {at, along},
                                      {at, Vec2{-across}},
                                      {at, Vec2{along - across}}})
        out << from.x() << '\t' << from.y() << '\t' << arrow.x() << '\t' << arrow.y() << '\n';
}

//> Aimed at a corner
constexpr int thrown_at_corners = 2000;

/// Throws balls exactly at the corners of a room, and counts those that are outside of it 2.5 s later.
template <class NextFrame> int count_escaped(const std::vector<Vec2> &corners, NextFrame next) {
    std::mt19937 generator{7};
    const auto random = [&](int low, int high) { return low + double(generator() % 1024) / 1024 * (high - low); };
    int escaped = 0;
    for (int i = 0; i < thrown_at_corners; ++i) {
        const Vec2 corner = corners[std::size_t(i) % corners.size()], start{random(3, 7), random(3, 7)};
        Ball ball{start, random(1, 2) * (corner - start)}; // there after half a second, up to one
        for (int frame = 0; frame < 150; ++frame) ball = next(ball, 1.0 / 60);
        const auto beyond = [&](const Segment &edge) {
            const Vec2 along = (edge.end - edge.start).normalized();
            return (ball.position - edge.start).dot(Vec2{along.y(), -along.x()}) > 1e-6; // metres to the right of it
        };
        if (std::ranges::any_of(walls_of(corners), beyond)) ++escaped;
    }
    return escaped;
}

void print_corners(std::ostream &out) {
    const std::vector<Vec2> corners{{0, 0}, {20, 0}, {11, 12}, {2, 8}};
    const auto walls = walls_of(corners);
    const int first = count_escaped(corners, [&](const Ball &b, double dt) { return next_frame(b, walls, dt); });
    const int now = count_escaped(corners, [&](const Ball &b, double dt) { return move_and_bounce(b, corners, dt); });
    out << row({{"balls aimed at a corner", 25}, {"escaped after 7.2", 19}, {"after 7.4", 0}});
    out << row({{std::to_string(thrown_at_corners), 25}, {std::to_string(first), 19}, {std::to_string(now), 0}});
}

//> A minute in a room
void print_bounces(std::ostream &out) {
    print_minutes(out, [](const Ball &ball, double dt) { return move_and_bounce(ball, room, dt); });
}

void trace_room(std::ostream &out) {
    trace_path(out, 60, [](const Ball &ball, double dt) { return move_and_bounce(ball, room, dt); });
}

//> Impacts
const Segment fence{.start = {7, -4}, .end = {7, 1.5}};

void print_impacts(std::ostream &out) {
    const Segment floor{.start = {0, 0}, .end = {20, 0}};
    out << row({{"motion of the centre", 22}, {"radius", 8}, {"wall", 18}, {"t", 7}, {"centre", 9}, {"touches at", 0}});
    for (const auto &[path, radius, edge] : {std::tuple{Segment{{0, 3}, {4, -1}}, 1.0, floor},
                                             {Segment{{0, 1.5}, {8, 0.5}}, 1.0, floor},
                                             {Segment{{0, 3}, {8, 3}}, 2.5, fence}}) {
        const Impact impact = time_of_impact(path, radius, edge).value();
        const std::string t = text(impact.t), centre = text(impact.centre), point = text(impact.point);
        out << row({{text(path), 22}, {text(radius), 8}, {text(edge), 18}, {t, 7}, {centre, 9}, {point, 0}});
    }
}

//> All points one radius away
void trace_track(std::ostream &out) {
    const double radius = 2.5;
    const Impact impact = time_of_impact({{0, 3}, {8, 3}}, radius, fence).value();
    out << "# outline x[m]\toutline y[m]\tcentre x[m]\tcentre y[m]\n";
    for (int degrees = 0; degrees <= 360; degrees += 5) { // half a circle round each end, and straight lines between
        const double angle = degrees * std::numbers::pi / 180;
        const Vec2 point =
            (degrees % 360 < 180 ? fence.end : fence.start) + radius * Vec2{std::cos(angle), std::sin(angle)};
        out << point.x() << '\t' << point.y() << '\t' << impact.centre.x() << '\t' << impact.centre.y() << '\n';
    }
}

//> A ball with a size, in the room
void trace_disc(std::ostream &out) {
    trace_path(out, 20, [](const Ball &ball, double dt) { return next_frame(ball, 0.4, walls_of(room), dt); });
}

//> The angle closes
void trace_angle(std::ostream &out) {
    std::mt19937 dice{7};
    const auto whole = [&](int low, int high) { return low + int(dice() % unsigned(high - low + 1)); };

    out << "# tangent of the angle[1]\tlargest error[m]\tmiddle error[m]\n";
    for (double steps = 123'456'789'012; steps >= 1; steps = std::floor(steps / 2)) {
        const double tangent = std::ldexp(steps, -38);
        std::vector<double> errors;
        for (int i = 0; i < 501; ++i) {
            // Build two segments through a known point: then the truth is known to the last digit.
            const Vec2 along{whole(300, 999) / 1024.0, whole(300, 999) / 1024.0};
            const Vec2 turned = along + tangent * Vec2{-along.y(), along.x()}; // 49 binary digits: nothing is rounded
            const Vec2 point{whole(-7, 7), whole(-7, 7)};
            const Segment first{point - whole(1, 3) * along, point + whole(1, 3) * along};
            const Segment second{point - whole(1, 3) * turned, point + whole(1, 3) * turned};
            errors.push_back((intersect_lines(first, second).value().point - point).norm());
        }
        std::ranges::sort(errors);
        out << tangent << '\t' << errors.back() << '\t' << errors[250] << '\n';
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"intersections", print_intersections},
                        {"meetings", print_meetings},
                        {"frames", print_frames},
                        {"common", print_common},
                        {"bounces", print_bounces},
                        {"corners", print_corners},
                        {"impacts", print_impacts},
                        {"07_segment_intersection_shares.tsv", trace_shares},
                        {"07_segment_intersection_print.tsv", trace_print},
                        {"07_segment_intersection_sides.tsv", trace_sides},
                        {"07_segment_intersection_frames.tsv", trace_frames},
                        {"07_segment_intersection_parts.tsv", trace_parts},
                        {"07_segment_intersection_room.tsv", trace_room},
                        {"07_segment_intersection_track.tsv", trace_track},
                        {"07_segment_intersection_disc.tsv", trace_disc},
                        {"07_segment_intersection_angle.tsv", trace_angle}});
}
