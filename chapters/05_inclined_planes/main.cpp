#include "../program.hpp"

#include "game.hpp"

using namespace inclined_planes;
using course::row, course::text;

//> A puck slows down
void print_sliding(std::ostream &out) {
    out << row({{"t [s]", 7}, {"position [m]", 14}, {"velocity [m/s]", 0}});
    motion::State puck{{0, 0}, {6, 0}};
    for (int second = 0; second <= 5; ++second) {
        out << row({{text(second), 7}, {text(puck.position.x()), 14}, {text(puck.velocity.x()), 0}});
        next_frame(puck, 1);
    }
}

//> Where it should stop
void print_distances(std::ostream &out) {
    out << row({{"velocity [m/s]", 16}, {"stops after [m]", 0}});
    for (const double velocity : {3.0, 6.0, 12.0, -6.0})
        out << row({{text(velocity), 16}, {text(stopping_distance(velocity, deceleration)), 0}});
}

//> A puck stops
void print_stopping(std::ostream &out) {
    out << row({{"t [s]", 7}, {"position [m]", 14}, {"velocity [m/s]", 0}});
    Puck puck{0, 6};
    for (int frame = 0; frame <= 300; ++frame) {
        if (frame % 60 == 0) out << row({{text(frame / 60.0), 7}, {text(puck.x), 14}, {text(puck.velocity), 0}});
        next_frame(puck, frame_time);
    }
}

//> A box on boards
constexpr Box crate{10, 0.5, 0.3}; // 10 kg, which g makes 100 N
constexpr Box rough_crate{10, 0.5, 0.45};

void print_presses(std::ostream &out) {
    out << row({{"angle [°]", 12}, {"normal force [N]", 0}});
    for (const double angle_deg : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0})
        out << row({{text(angle_deg), 11}, {text(normal_force(crate.mass, angle_deg * degree, g)), 0}});
}

//> Two boxes slide
void print_boards(std::ostream &out) {
    out << row({{"angle [°]", 12}, {"10 kg [m/s²]", 15}, {"20 kg [m/s²]", 0}});
    for (const double angle_deg : {10.0, 20.0, 26.0, 27.0, 45.0})
        out << row({{text(angle_deg), 11},
                    {text(incline_acceleration(crate, angle_deg * degree, g)), 14},
                    {text(incline_acceleration({20, 0.5, 0.3}, angle_deg * degree, g)), 0}});
}

//> Critical angles
void print_angles(std::ostream &out) {
    out << row({{"mu_s", 6}, {"critical angle [°]", 0}});
    for (const double mu_s : {0.1, 0.3, 0.5, 1.0})
        out << row({{text(mu_s), 6}, {text(critical_angle(mu_s) / degree), 0}});
}

//> A puck on a table
void print_table(std::ostream &out) {
    out << row({{"t [s]", 7}, {"position [m]", 18}, {"velocity [m/s]", 0}});
    motion::State puck{{0, 0}, {3, 4}};
    for (int half = 0; half <= 6; ++half) {
        out << row({{text(half / 2.0), 7}, {text(puck.position), 18}, {text(puck.velocity), 0}});
        next_frame(puck, deceleration, 0.5);
    }
}

//> Up, and back or not
void print_climbs(std::ostream &out) {
    out << row({{"angle [°]", 12}, {"up [m]", 10}, {"back [m/s]", 0}});
    for (const double angle_deg : {0.0, 20.0, 26.0, 27.0, 45.0, 90.0}) {
        const auto [up, back] = up_and_back(rough_crate, 9.6, angle_deg * degree, g);
        out << row({{text(angle_deg), 11}, {text(up), 10}, {text(back), 0}});
    }
}

//> Stick and slip
void print_slips(std::ostream &out) {
    out << row({{"t [s]", 8}, {"position [m]", 14}, {"the block", 0}});
    Pulled now{0, 0, 0};
    for (int frame = 0; frame < 9000; ++frame) {
        const Pulled before = now;
        next_frame(now, 1e-3);
        if ((before.velocity == 0) != (now.velocity == 0))
            out << row(
                {{text(frame / 1000.0), 8}, {text(before.position), 14}, {now.velocity == 0 ? "sticks" : "slips", 0}});
    }
}

//> Two parts of a weight, traced
void trace_parts(std::ostream &out) {
    out << "# x[m]\ty[m]\tarrow: x[100 N]\ty[100 N]\n";
    const double angle = std::asin(0.6), normal = normal_force(crate.mass, angle, g), weight = crate.mass * g;
    const Vec2 along{std::cos(angle), std::sin(angle)}, across{-along.y(), along.x()}, at = 2.5 * along;
    const double pull = weight * std::sin(angle);
    for (const Vec2 &arrow : {Vec2{0, -weight}, Vec2{-pull * along}, Vec2{-normal * across}, Vec2{normal * across}})
        out << at.x() << '\t' << at.y() << '\t' << arrow.x() / 100 << '\t' << arrow.y() / 100 << '\n';
}

//> Velocity against time, traced
void trace_stops(std::ostream &out) {
    out << "# t[s]\tvelocity[m/s]\n";
    Puck puck{0, 6};
    for (int frame = 0; frame <= 50; ++frame) {
        out << frame / 10.0 << '\t' << puck.velocity << '\n';
        next_frame(puck, 0.1);
    }
}

//> Acceleration against angle, traced
void trace_slides(std::ostream &out) {
    out << "# angle[°]\ta[m/s²]\n";
    for (int angle_deg = 0; angle_deg <= 90; ++angle_deg)
        out << angle_deg << '\t' << incline_acceleration(crate, angle_deg * degree, g) << '\n';
}

//> Held or sliding, traced
void trace_held(std::ostream &out) {
    out << "# critical angle[°]\tmu_s[1]\n";
    for (int i = 0; i <= 30; ++i) out << critical_angle(i / 20.0) / degree << '\t' << i / 20.0 << '\n';
}

//> Two paths, traced
void trace_turns(std::ostream &out) {
    out << "# x[m]\ty[m]\tper axis: x[m]\ty[m]\n";
    motion::State puck{{0, 0}, {1.5, 6}};
    Puck x{0, puck.velocity.x()}, y{0, puck.velocity.y()}; // as if each component had a friction of its own
    for (int frame = 0; frame <= 40; ++frame) {
        out << puck.position.x() << '\t' << puck.position.y() << '\t' << x.x << '\t' << y.x << '\n';
        next_frame(puck, deceleration, 0.1);
        next_frame(x, 0.1);
        next_frame(y, 0.1);
    }
}

//> Up and back, traced
void trace_climbs(std::ostream &out) {
    out << "# up[m]\tkinetic energy, up[J]\tback[J]\n";
    const double angle = std::asin(0.6), speed = 9.6;
    const auto [up, back] = up_and_back(rough_crate, speed, angle, g);
    for (int i = 0; i <= 20; ++i) {
        const double part = i / 20.0, half_mass = rough_crate.mass / 2;
        out << part * up << '\t' << half_mass * speed * speed * (1 - part) << '\t'
            << half_mass * back * back * (1 - part) << '\n';
    }
}

//> Stick and slip, traced
void trace_slips(std::ostream &out) {
    out << "# stretch[m]\tvelocity[m/s]\n";
    Pulled now{0, 0, 0.25};
    for (int frame = 0; frame < 5000; ++frame) {
        if (frame % 20 == 0) out << now.stretch << '\t' << now.velocity << '\n';
        next_frame(now, 1e-3);
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"sliding", print_sliding},
                        {"distances", print_distances},
                        {"stopping", print_stopping},
                        {"presses", print_presses},
                        {"boards", print_boards},
                        {"angles", print_angles},
                        {"table", print_table},
                        {"climbs", print_climbs},
                        {"slips", print_slips},
                        {"05_inclined_planes_parts.tsv", trace_parts},
                        {"05_inclined_planes_stops.tsv", trace_stops},
                        {"05_inclined_planes_slides.tsv", trace_slides},
                        {"05_inclined_planes_held.tsv", trace_held},
                        {"05_inclined_planes_turns.tsv", trace_turns},
                        {"05_inclined_planes_climbs.tsv", trace_climbs},
                        {"05_inclined_planes_slips.tsv", trace_slips}});
}
