#include "../program.hpp"

#include "game.hpp"

using namespace reflection;
using course::row, course::text;

//> A ball on a screen
void print_screen(std::ostream &out) {
    out << row({{"t [s]", 7}, {"position [m]", 24}, {"velocity [m/s]", 0}});
    Ball ball{{8, 4}, {3.1, 1.9}, 1};
    for (int frame = 0; frame <= 360; ++frame) {
        if (frame % 60 == 0) out << row({{text(frame / 60), 7}, {text(ball.position), 24}, {text(ball.velocity), 0}});
        next_frame(ball, screen, frame_time);
    }
}

//> A wall that one turns
void print_turns(std::ostream &out) {
    out << row({{"wall [°]", 11}, {"velocity after [m/s]", 0}});
    for (const double angle_deg : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0})
        out << row({{text(angle_deg), 10}, {text(reflect({0, -5}, at_angle((angle_deg + 90) * degree))), 0}});
}

//> Normals of walls
void print_normals(std::ostream &out) {
    out << row({{"from", 9}, {"to", 9}, {"unit normal", 0}});
    for (const auto &[start, end] :
         {Wall{{1, 1}, {5, 4}}, Wall{{5, 4}, {1, 1}}, Wall{{0, 0}, {3, 4}}, Wall{{0, 0}, {7, 0}}, Wall{{0, 0}, {5, 5}}})
        out << row({{text(start), 9}, {text(end), 9}, {text(unit_normal(start, end)), 0}});
}

//> Four surfaces
void print_surfaces(std::ostream &out) {
    out << row({{"restitution", 13}, {"mu_k", 6}, {"velocity after [m/s]", 0}});
    for (const Surface &surface : {Surface{1, 0}, Surface{0.5, 0}, Surface{0.5, 0.3}, Surface{0.5, 1}})
        out << row({{text(surface.restitution), 13},
                    {text(surface.mu_k), 6},
                    {text(bounce({0, -5}, {-0.6, 0.8}, surface)), 0}});
}

//> A ball in a turned box
const Box square{{-5, -5}, {5, 5}};
const double tilt = std::asin(0.6); // 36.87°
const Ball rolling{{0, 0}, {5, 10}, 0.6};

void print_turned(std::ostream &out) {
    out << row({{"t [s]", 7}, {"position [m]", 24}, {"velocity [m/s]", 0}});
    Ball ball = rolling;
    for (int frame = 0; frame <= 120; ++frame) {
        if (frame % 30 == 0) out << row({{text(frame / 60.0), 7}, {text(ball.position), 24}, {text(ball.velocity), 0}});
        next_frame(ball, square, tilt, frame_time);
    }
}

//> Bank shots
const Box table{{0, 0}, {10, 6}};
const Ball cue{{2, 2}, {0, 0}, 1};
const Vec2 target{3, 4};

void print_banks(std::ostream &out) {
    out << row({{"across", 8}, {"up", 5}, {"push towards", 24}, {"angle [°]", 0}});
    for (const auto &[across, up] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {1, 1}, {2, 0}}) {
        const Vec2 to = bank_shot(cue, target, table, across, up);
        out << row({{text(across), 8}, {text(up), 5}, {text(to), 24}, {text(std::atan2(to.y(), to.x()) / degree), 0}});
    }
}

//> At the edge, traced
void trace_edge(std::ostream &out) {
    out << "# frame[1]\tx[px]\tas printed: x[px]\n";
    const Box wide{{0, 0}, {100, 80}};
    Ball ball{{101, 40}, {-4, 0}, 0}; // one frame was too long
    double printed_x = 101, printed_velocity = -4;
    for (int frame = 0; frame <= 10; ++frame) {
        out << frame << '\t' << ball.position.x() << '\t' << printed_x << '\n';
        next_frame(ball, wide, 1);
        if (printed_x >= wide.high.x() || printed_x <= wide.low.x()) printed_velocity = -printed_velocity;
        printed_x += printed_velocity;
    }
}

//> The parts of a bounce, traced
void trace_arrow(std::ostream &out, const Vec2 &from, const Vec2 &to) {
    out << from.x() << '\t' << from.y() << '\t' << to.x() << '\t' << to.y() << '\n';
}

void trace_parts(std::ostream &out) {
    out << "# from: x[m]\ty[m]\tarrow: x[m/s]\ty[m/s]\n";
    const Vec2 velocity{0, -5}, normal{-0.6, 0.8}, after = reflect(velocity, normal);
    const Vec2 across = velocity.dot(normal) * normal, along = velocity - across;
    trace_arrow(out, -velocity, velocity);
    trace_arrow(out, -velocity, across);
    trace_arrow(out, across - velocity, along);
    trace_arrow(out, {0, 0}, along);
    trace_arrow(out, along, -across);
    trace_arrow(out, {0, 0}, after);
}

//> Two normals of one wall, traced
void trace_normals(std::ostream &out) {
    out << "# from: x[m]\ty[m]\tarrow: x[m/s]\ty[m/s]\n";
    const Vec2 wall{3, 4}, velocity{5, 0}, printed{wall.y(), wall.x()}, normal = unit_normal({0, 0}, wall);
    trace_arrow(out, -velocity, velocity);
    trace_arrow(out, {0, 0}, 2 * normal);
    trace_arrow(out, {0, 0}, reflect(velocity, normal));
    trace_arrow(out, {0, 0}, 2 * printed / printed.norm());
    trace_arrow(out, {0, 0}, reflect(velocity, printed));
}

//> Angles in and out, traced
void trace_angles(std::ostream &out) {
    out << "# in[°]\treflected: out[°]\trestitution 0.5: out[°]\tmu_k 0.3, too: out[°]\n";
    const auto angle_after = [](const Vec2 &after) { return std::atan2(after.x(), after.y()) / degree; };
    for (int in_deg = 0; in_deg <= 88; in_deg += 2) {
        const Vec2 velocity{5 * std::sin(in_deg * degree), -5 * std::cos(in_deg * degree)}, up{0, 1};
        out << in_deg << '\t' << angle_after(reflect(velocity, up)) << '\t'
            << angle_after(bounce(velocity, up, {0.5, 0})) << '\t' << angle_after(bounce(velocity, up, {0.5, 0.3}))
            << '\n';
    }
}

//> In a turned box, traced
void trace_turned(std::ostream &out) {
    out << "# x[m]\ty[m]\n";
    Ball ball = rolling;
    for (int frame = 0; frame <= 300; ++frame) {
        out << ball.position.x() << '\t' << ball.position.y() << '\n';
        next_frame(ball, square, tilt, frame_time);
    }
}

//> An unfolded table, traced
void trace_unfolded(std::ostream &out) {
    out << "# unfolded: x[m]\ty[m]\ton the table: x[m]\ty[m]\n";
    const Vec2 to = bank_shot(cue, target, table, 1, 0);
    const double whole = Vec2{13, 2}.norm(); // from (2, 2) to the image, (15, 4) [m]
    for (int i = 0; i <= 130; ++i) {
        const double way = whole * i / 130;
        const Vec2 straight = cue.position + way * to, there = rolled(cue, table, to, way);
        out << straight.x() << '\t' << straight.y() << '\t' << there.x() << '\t' << there.y() << '\n';
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"screen", print_screen},
                        {"turns", print_turns},
                        {"normals", print_normals},
                        {"surfaces", print_surfaces},
                        {"turned", print_turned},
                        {"banks", print_banks},
                        {"06_reflection_edge.tsv", trace_edge},
                        {"06_reflection_parts.tsv", trace_parts},
                        {"06_reflection_normals.tsv", trace_normals},
                        {"06_reflection_angles.tsv", trace_angles},
                        {"06_reflection_turned.tsv", trace_turned},
                        {"06_reflection_unfolded.tsv", trace_unfolded}});
}
