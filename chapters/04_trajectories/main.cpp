#include "../program.hpp"

#include "game.hpp"

using namespace trajectories;
using course::row, course::text;

//> A shell flies
void print_flight(std::ostream &out) {
    out << row({{"t [s]", 7}, {"position [m]", 23}, {"velocity [m/s]", 0}});
    State shell = fired(0, 60);
    for (int frame = 0; frame <= 300; ++frame) {
        if (frame % 60 == 0)
            out << row({{text(frame / 60.0), 7}, {text(shell.position), 23}, {text(shell.velocity), 0}});
        next_frame(shell, frame_time);
    }
}

//> A shell lands
void print_landing(std::ostream &out) {
    out << row({{"muzzle [m]", 12}, {"in the air [s]", 16}, {"lands at [m]", 0}});
    for (const double height : {0.0, 5.0, cliff}) {
        Flight flight{fired(height, 60)};
        const double t = flight.left;
        while (flight.left > 0) next_frame(flight, frame_time);
        out << row({{text(height), 12}, {text(t), 16}, {text(flight.shell.position), 0}});
    }
}

//> Range against angle
void print_ranges(std::ostream &out) {
    out << row({{"angle [°]", 12}, {"from the ground [m]", 21}, {"from the cliff [m]", 0}});
    for (const double angle_deg : {15.0, 30.0, 45.0, 60.0, 75.0})
        out << row({{text(angle_deg), 11},
                    {text(range(fired(0, angle_deg), g)), 21},
                    {text(range(fired(cliff, angle_deg), g)), 0}});
}

//> The farthest
/// The angle from 0° to 90° with the longest range, to a hundredth of a degree.
double best_angle(double height) {
    double best = 0;
    for (int i = 0; i <= 9000; ++i)
        if (range(fired(height, i / 100.0), g) > range(fired(height, best), g)) best = i / 100.0;
    return best;
}

void print_best(std::ostream &out) {
    out << row({{"muzzle [m]", 12}, {"best angle [°]", 17}, {"range [m]", 0}});
    for (const double height : {0.0, 5.0, cliff, 100.0}) {
        const double angle_deg = best_angle(height);
        out << row({{text(height), 12}, {text(angle_deg), 15}, {text(range(fired(height, angle_deg), g)), 0}});
    }
}

//> Highest points
void print_apexes(std::ostream &out) {
    out << row({{"angle [°]", 12}, {"apex [m]", 0}});
    for (const double angle_deg : {-30.0, 0.0, 30.0, 60.0, 90.0})
        out << row({{text(angle_deg), 11}, {text(apex(fired(cliff, angle_deg), g)), 0}});
}

//> An arc in letters
void print_arc(std::ostream &out) {
    std::vector<std::string> lines(7, std::string(64, ' ')); // each letter is 1 m wide and 4 m high
    lines.back() = std::string(64, '_');
    for (const double angle_deg : {30.0, 60.0})
        for (const Vec2 &point : dotted_arc(fired(0, angle_deg), g, 0.2))
            lines[std::size_t(6 - point.y() / 4)][std::size_t(point.x())] = angle_deg > 45 ? '*' : 'o';
    for (const std::string &line : lines) out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
}

//> Wind
void print_winds(std::ostream &out) {
    out << row({{"wind [m/s²]", 14}, {"from the ground [m]", 21}, {"from the cliff [m]", 0}});
    for (const double wind : {-10.0, -2.0, 0.0, 1.0})
        out << row({{text(wind), 13},
                    {text(range_in_wind({{0, 0}, {15, 20}}, g, wind)), 21},
                    {text(range_in_wind({{0, cliff}, {15, 20}}, g, wind)), 0}});
}

//> Terraces
void print_terraces(std::ostream &out) {
    out << row({{"height [m]", 12}, {"comes down at [m]", 0}});
    for (const double height : {-25.0, 0.0, 15.0, 20.0, 21.0}) {
        const std::optional<double> there = range_at_height({{0, 0}, {15, 20}}, g, height);
        out << row({{text(height), 12}, {there ? text(*there) : "not at all", 0}});
    }
}

//> A cannon that aims
void print_angles(std::ostream &out) {
    out << row({{"target [m]", 12}, {"angles [°]", 0}});
    for (const Vec2 &target : {Vec2{60, 0}, Vec2{40, 15}, Vec2{75, -25}, Vec2{62.5, 0}, Vec2{70, 0}}) {
        std::string angles;
        for (const double angle_deg : launch_angles(speed, target, g)) angles += text(angle_deg) + "  ";
        out << row({{text(target), 12}, {angles.empty() ? "out of reach" : angles, 0}});
    }
}

//> Errors of the frame loops
/// How far each range is from the right one [m], for a shell of 20 m/s and 60°, with 9.8 m/s².
std::vector<double> errors_with(double dt) {
    const State muzzle{{0, 0}, {10, std::sqrt(300)}};
    const LoopRanges ranges = frame_loop_ranges(muzzle, 9.8, dt);
    const double there = range(muzzle, 9.8);
    return {ranges.explicit_euler - there, ranges.semi_implicit - there, ranges.exact - there};
}

void print_loops(std::ostream &out) {
    out << row({{"dt [s]", 8}, {"explicit [m]", 14}, {"semi-implicit [m]", 19}, {"exact [m]", 0}});
    for (const double dt : {0.1, 0.05, 0.01, 0.001}) {
        const std::vector<double> errors = errors_with(dt);
        out << row({{text(dt), 8}, {text(errors[0]), 14}, {text(errors[1]), 19}, {text(errors[2]), 0}});
    }
}

//> A shell in air
/// Where a shell is at the end of each frame, and then where it lands [m].
std::vector<Vec2> flight_in(const Air &air, double angle_deg, double dt = frame_time) {
    State shell = fired(0, angle_deg);
    std::vector<Vec2> path{shell.position};
    do {
        next_frame(shell, air, dt);
        path.push_back(shell.position);
    } while (shell.position.y() > 0);
    path.back() = hit(path.end()[-2], path.back());
    return path;
}

/// How far it gets, in steps of a millisecond [m].
double range_in(const Air &air, double angle_deg) { return flight_in(air, angle_deg, 0.001).back().x(); }

void print_farthest_in_air(std::ostream &out) {
    double best = 0;
    for (int angle_deg = 1; angle_deg < 90; ++angle_deg)
        if (range_in({}, angle_deg) > range_in({}, best)) best = angle_deg;
    out << "In still air, from the ground: " << text(best) << "°, " << text(range_in({}, best)) << " m\n";
}

void print_air(std::ostream &out) {
    out << row({{"angle [°]", 12}, {"no air [m]", 13}, {"in air [m]", 13}, {"against 10 m/s [m]", 0}});
    for (const double angle_deg : {30.0, 45.0, 60.0}) {
        out << row({{text(angle_deg), 11},
                    {text(range(fired(0, angle_deg), g)), 13},
                    {text(range_in({}, angle_deg)), 13},
                    {text(range_in({.wind = {-10, 0}}, angle_deg)), 0}});
    }
}

//> Confetti
/// What explicit Euler makes of drag: it's all at the velocity before the step.
State explicit_drag_step(const State &piece, const Air &air, double dt) {
    const Vec2 relative = piece.velocity - air.wind;
    const Vec2 acceleration = Vec2{0, -g} - air.drag * relative.norm() * relative;
    return {piece.position + dt * piece.velocity, piece.velocity + dt * acceleration};
}

void print_confetti(std::ostream &out) {
    out << row({{"frame", 7}, {"explicit [m/s]", 18}, {"drag_step [m/s]", 0}});
    const Air air{.drag = 10};
    State by_euler = fired(0, 60), piece = by_euler;
    for (int frame = 0; frame <= 4; ++frame) {
        out << row({{text(frame), 7}, {text(by_euler.velocity.norm()), 18}, {text(piece.velocity.norm()), 0}});
        by_euler = explicit_drag_step(by_euler, air, frame_time);
        next_frame(piece, air, frame_time);
    }
}

//> Arcs, traced
void trace_arcs(std::ostream &out) {
    out << "# 15 x[m]\t15 y[m]\t30 x[m]\t30 y[m]\t45 x[m]\t45 y[m]\t60 x[m]\t60 y[m]\t75 x[m]\t75 y[m]\n";
    for (int i = 0; i <= 40; ++i)
        for (const double angle_deg : {15.0, 30.0, 45.0, 60.0, 75.0}) {
            State shell = fired(0, angle_deg);
            next_frame(shell, i / 40.0 * time_of_flight(shell, g));
            out << shell.position.x() << '\t' << shell.position.y() << (angle_deg == 75 ? '\n' : '\t');
        }
}

//> Ranges, traced
void trace_ranges(std::ostream &out) {
    out << "# angle[°]\tfrom the ground[m]\tfrom the cliff[m]\n";
    for (int angle_deg = 0; angle_deg <= 90; ++angle_deg)
        out << angle_deg << '\t' << range(fired(0, angle_deg), g) << '\t' << range(fired(cliff, angle_deg), g) << '\n';
}

//> Arcs in wind, traced
void trace_wind(std::ostream &out) {
    out << "# -10 x[m]\t-10 y[m]\t-2 x[m]\t-2 y[m]\t0 x[m]\t0 y[m]\t1 x[m]\t1 y[m]\n";
    for (int i = 0; i <= 40; ++i)
        for (const double wind : {-10.0, -2.0, 0.0, 1.0}) {
            const State muzzle{{0, 0}, {15, 20}};
            Flight flight{muzzle};
            next_frame(flight, wind, i / 40.0 * flight.left);
            const Vec2 at =
                i < 40 ? flight.shell.position : Vec2{range_in_wind(muzzle, g, wind), 0}; // the last is yours
            out << at.x() << '\t' << at.y() << (wind == 1 ? '\n' : '\t');
        }
}

//> Aimed arcs, traced
void trace_aimed(std::ostream &out) {
    out << "# low x[m]\tlow y[m]\thigh x[m]\thigh y[m]\n";
    const std::vector<double> angles = launch_angles(speed, {40, 15}, g);
    for (int i = 0; i <= 40; ++i)
        for (const double angle_deg : angles) {
            State shell = fired(0, angle_deg);
            next_frame(shell, i / 40.0 * 40 / shell.velocity.x());
            out << shell.position.x() << '\t' << shell.position.y() << (angle_deg == angles.back() ? '\n' : '\t');
        }
}

//> Errors, traced
void trace_errors(std::ostream &out) {
    out << "# dt[s]\texplicit[m]\tsemi-implicit[m]\texact[m]\n";
    for (double dt = 0.4; dt > 0.0005; dt /= 1.5) {
        out << dt;
        for (const double error : errors_with(dt)) out << '\t' << std::abs(error);
        out << '\n';
    }
}

//> The best shot from the cliff, traced
/// Its velocity when it's fired and when it lands, and what gravity still adds.
void trace_best(std::ostream &out) {
    const State muzzle = fired(cliff, best_angle(cliff));
    const double down = -g * time_of_flight(muzzle, g);
    const double x = muzzle.velocity.x(), y = muzzle.velocity.y();
    out << "# v_x[m/s]\tv_y[m/s]\tto come[m/s]\n" << x << '\t' << y << '\t' << down << '\n';
    out << x << '\t' << y + down << "\t0\n";
}

//> A shot second by second, traced
void trace_falls(std::ostream &out) {
    out << "# straight x[m]\tstraight y[m]\tx[m]\ty[m]\n";
    State shell{{0, 0}, {15, 20}};
    for (int i = 0; i <= 40; ++i) {
        const Vec2 straight = i / 10.0 * Vec2{15, 20};
        out << straight.x() << '\t' << straight.y() << '\t' << shell.position.x() << '\t' << shell.position.y() << '\n';
        next_frame(shell, 0.1);
    }
}

//> Arcs in air, traced
void trace_air(std::ostream &out) {
    const std::vector<Vec2> paths[]{flight_in({.drag = 0}, 45), flight_in({}, 45), flight_in({.wind = {-10, 0}}, 45),
                                    flight_in({.wind = {10, 0}}, 45)};
    out << "# no air x[m]\tno air y[m]\tstill x[m]\tstill y[m]\t-10 x[m]\t-10 y[m]\t10 x[m]\t10 y[m]\n";
    for (int i = 0; i <= 40; ++i)
        for (const auto &path : paths) {
            const Vec2 &at = path[i * (path.size() - 1) / 40];
            out << at.x() << '\t' << at.y() << (&path == &paths[3] ? '\n' : '\t');
        }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"flight", print_flight},
                        {"landing", print_landing},
                        {"ranges", print_ranges},
                        {"best", print_best},
                        {"apexes", print_apexes},
                        {"arc", print_arc},
                        {"winds", print_winds},
                        {"terraces", print_terraces},
                        {"angles", print_angles},
                        {"loops", print_loops},
                        {"air", print_air},
                        {"farthest", print_farthest_in_air},
                        {"confetti", print_confetti},
                        {"04_trajectories_arcs.tsv", trace_arcs},
                        {"04_trajectories_ranges.tsv", trace_ranges},
                        {"04_trajectories_wind.tsv", trace_wind},
                        {"04_trajectories_aimed.tsv", trace_aimed},
                        {"04_trajectories_errors.tsv", trace_errors},
                        {"04_trajectories_best.tsv", trace_best},
                        {"04_trajectories_falls.tsv", trace_falls},
                        {"04_trajectories_air.tsv", trace_air}});
}
