#include "../program.hpp"

#include "segment_intersection.hpp"

#include <algorithm>
#include <random>

using namespace segment_intersection;
using course::row, course::text;

//> How a segment is printed
std::string text(const Segment &s) { return course::text(s.start) + '-' + course::text(s.end); }

//> Crossings
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

void print_overlaps(std::ostream &out) {
    out << row({{"first", 16}, {"second", 17}, {"what they share", 0}});
    for (const auto &[first, second] : pairs) {
        const auto points = common_points(first, second);
        std::string words = points.empty() ? "nothing" : text(points[0]);
        if (points.size() > 1) words += " to " + text(points[1]);
        out << row({{text(first), 16}, {text(second), 17}, {words, 0}});
    }
}

//> Touches
void print_impacts(std::ostream &out) {
    const Segment floor{.start = {0, 0}, .end = {20, 0}}, fence{.start = {7, -4}, .end = {7, 1.5}};
    out << row({{"disc's way", 20}, {"radius", 8}, {"wall", 18}, {"t", 7}, {"centre", 9}, {"impacts", 0}});
    for (const auto &[way, radius, edge] : {std::tuple{Segment{{0, 3}, {4, -1}}, 1.0, floor},
                                            {Segment{{0, 1.5}, {8, 0.5}}, 1.0, floor},
                                            {Segment{{0, 3}, {8, 3}}, 2.5, fence}}) {
        const Impact impact = time_of_impact(way, radius, edge).value();
        const std::string t = text(impact.t), centre = text(impact.centre), point = text(impact.point);
        out << row({{text(way), 20}, {text(radius), 8}, {text(edge), 18}, {t, 7}, {centre, 9}, {point, 0}});
    }
}

//> Quarters of the way
void trace_shares(std::ostream &out) {
    const Vec2 point = intersect_lines(motion, wall).value().point;
    out << "# share[1]\tmotion x[m]\tmotion y[m]\twall x[m]\twall y[m]\tcrossing x[m]\tcrossing y[m]\n";
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec2 on_motion = motion.start + share * (motion.end - motion.start);
        const Vec2 on_wall = wall.start + share * (wall.end - wall.start);
        out << share << '\t' << on_motion.x() << '\t' << on_motion.y() << '\t' << on_wall.x() << '\t' << on_wall.y()
            << '\t' << point.x() << '\t' << point.y() << '\n';
    }
}

//> In print, and in truth
void trace_print(std::ostream &out) {
    out << "# from x[m]\tfrom y[m]\tto x[m]\tto y[m]\tcrossing x[m]\tcrossing y[m]\n";
    for (const Segment &second : {wall, misprint}) {
        const Vec2 point = intersect_lines(motion, second).value().point;
        out << second.start.x() << '\t' << second.start.y() << '\t' << second.end.x() << '\t' << second.end.y() << '\t'
            << point.x() << '\t' << point.y() << '\n';
    }
}

//> A minute in a room
void trace_room(std::ostream &out) {
    const std::vector<Vec2> room{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};
    Ball ball{.position = {2, 3}, .velocity = {2.3, 1.1}};

    // Beside each frame stands one corner, round and round, so that the figure knows the walls.
    out << "# t[s]\tx[m]\ty[m]\tcorner x[m]\tcorner y[m]\n";
    for (std::size_t frame = 0; frame <= 60 * 20; ++frame) {
        const Vec2 &corner = room[frame % room.size()];
        out << double(frame) / 20 << '\t' << ball.position.x() << '\t' << ball.position.y() << '\t' << corner.x()
            << '\t' << corner.y() << '\n';
        ball = move_and_bounce(ball, room, 1.0 / 20);
    }
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
            // Lay two segments through a point, rather than compute one: then the truth is known to the last digit.
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
                        {"overlaps", print_overlaps},
                        {"impacts", print_impacts},
                        {"07_segment_intersection_shares.tsv", trace_shares},
                        {"07_segment_intersection_print.tsv", trace_print},
                        {"07_segment_intersection_room.tsv", trace_room},
                        {"07_segment_intersection_angle.tsv", trace_angle}});
}
