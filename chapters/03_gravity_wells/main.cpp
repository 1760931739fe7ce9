#include "../program.hpp"

#include "game.hpp"

#include <numbers>

using namespace gravity_wells;
using course::row, course::text;

//> The pull at some distances
void print_pulls(std::ostream &out) {
    out << row({{"distance [m]", 14}, {"pull on 2 kg [N]", 18}, {"acceleration [m/s²]", 0}});
    for (const double r : {16.0, 8.0, 4.0, 2.0, 1.0}) {
        const double pull = gravity({{r, 0}, 2}, hole, G).norm();
        out << row({{text(r), 14}, {text(pull), 18}, {text(pull / 2), 0}});
    }
}

//> A ship falls in
void print_plunge(std::ostream &out) {
    out << row({{"t [s]", 7}, {"distance [m]", 14}, {"velocity [m/s]", 0}});
    Ship ship;
    for (int frame = 0; frame <= 48; ++frame) {
        if (frame % 12 == 0)
            out << row(
                {{text(frame / 60.0), 7}, {text(ship.state.position.x()), 14}, {text(ship.state.velocity.x()), 0}});
        next_frame(ship, frame_time);
    }
}

//> A jump
void print_jumps(std::ostream &out) {
    out << row({{"", 9}, {"g [m/s²]", 11}, {"in the air [s]", 0}});
    for (const auto &[where, g] : {std::pair{"Moon", 1.6}, {"Mars", 3.7}, {"Earth", 9.8}, {"Jupiter", 24.8}})
        out << row({{where, 9}, {text(g), 10}, {text(time_to_fall(0.5, 3, g)), 0}}); // at 3 m/s, from a step of 0.5 m
}

//> A landing at several frame rates
void print_landing(std::ostream &out) {
    out << row({{"frames per second", 19}, {"lands after [s]", 17}, {"at [m/s]", 0}});
    for (const int rate : {1, 10, 60}) {
        Fall lander{20, 0, 0};
        while (lander.height > 0) next_frame(lander, 0, 1.0 / rate);
        out << row({{text(rate), 19}, {text(lander.time), 17}, {text(lander.velocity), 0}});
    }
}

//> Circles
constexpr double pi = std::numbers::pi;

void print_circles(std::ostream &out) {
    out << row({{"radius [m]", 12}, {"speed [m/s]", 13}, {"once around [s]", 0}});
    for (const double r : {2.0, 8.0, 32.0}) {
        const double speed = circular_orbit_speed(hole.mass, r, G);
        out << row({{text(r), 12}, {text(speed), 13}, {text(2 * pi * r / speed), 0}});
    }
}

//> How far from a circle
void print_turns(std::ostream &out) {
    out << row({{"turns", 7}, {"distance [m]", 14}, {"energy of each kg [J]", 0}});
    State ship{{8, 0}, {0, circular_orbit_speed(hole.mass, 8, G)}};
    const double frames_per_turn = 2 * pi * 8 / ship.velocity.y() / frame_time;
    for (int turn = 0, frame = 0; turn <= 3; ++turn) {
        for (; frame < turn * frames_per_turn; ++frame) next_frame(ship, frame_time);
        out << row({{text(turn), 7}, {text(ship.position.norm()), 14}, {text(energy_of(ship)), 0}});
    }
}

//> Pulled through the middle
void print_softened(std::ostream &out) {
    out << row({{"distance [m]", 14}, {"pull [m/s²]", 14}, {"softened by 2 m", 0}});
    for (const double r : {8.0, 4.0, 2.0, 1.0, 0.0})
        out << row({{text(r), 14},
                    {r > 0 ? text(gravity({{r, 0}, 1}, hole, G).norm()) : "?", 13},
                    {text(softened_gravity({r, 0}, mu, 2).norm()), 0}});
}

//> An ellipse that doesn't close
/// The angle at which a softened ship is at its farthest again, seen from where it started at 8 m [°]; below 0 is against
/// its flight.
double far_end_moves_by(double push, double epsilon) {
    State ship{{8, 0}, {0, push}}, before;
    int frames = 0; // a ship that isn't pulled never comes back
    do {
        before = ship;
        ship.velocity += frame_time * softened_gravity(ship.position, mu, epsilon);
        ship.position += frame_time * ship.velocity;
    } while (++frames < 1000 && (before.position.dot(before.velocity) <= 0 || ship.position.dot(ship.velocity) > 0));
    const double fell = before.position.dot(before.velocity), falls = ship.position.dot(ship.velocity);
    const Vec2 far = before.position + fell / (fell - falls) * (ship.position - before.position);
    return std::atan2(far.y(), far.x()) / pi * 180;
}

void print_turned(std::ostream &out) {
    out << row({{"push [m/s]", 12}, {"softened by [m]", 17}, {"the far end moves by [°]", 0}});
    for (const auto &[push, epsilon] : {std::pair{2.0, 2.0}, {4.0, 2.0}, {8.0, 2.0}, {6.0, 0.5}})
        out << row({{text(push), 12}, {text(epsilon), 17}, {text(std::round(far_end_moves_by(push, epsilon))), 0}});
}

//> An ellipse, flown by all four
constexpr double semi_major = 8, eccentricity = 0.5;                                     // [m], [1]
const double whole_turn = 2 * pi * std::sqrt(semi_major * semi_major * semi_major / mu); // [s]

/// A ship at the near end of the ellipse.
Integrators near_end() {
    const State ship{{semi_major * (1 - eccentricity), 0},
                     {0, std::sqrt(mu / semi_major * (1 + eccentricity) / (1 - eccentricity))}};
    return {ship, ship, ship, ship};
}

std::vector<State> in_order(const Integrators &all) {
    return {all.explicit_euler, all.semi_implicit, all.leapfrog, all.runge_kutta};
}

//> Three digits
std::string digits(double x) {
    std::ostringstream out;
    out << std::setprecision(3) << (std::abs(x) < 1e-12 ? 0.0 : x);
    return out.str();
}

//> Errors after a quarter of a turn
/// How far each of the four is from the right place, after a quarter of the time in so many steps [m].
std::vector<double> errors_after_a_quarter(int steps) {
    Integrators now = near_end();
    for (int i = 0; i < steps; ++i) now = step_all(now, mu, whole_turn / 4 / steps);
    const Vec2 right = semi_major * Vec2{-0.9351308590367096, 0.7797408874975592}; // 3.8 will say why
    std::vector<double> errors;
    for (const State &ship : in_order(now)) errors.push_back((ship.position - right).norm());
    return errors;
}

void print_errors(std::ostream &out) {
    out << row({{"steps", 7}, {"explicit [m]", 14}, {"semi-implicit", 15}, {"leapfrog", 12}, {"Runge-Kutta", 0}});
    for (const int steps : {50, 100, 200, 400}) {
        const std::vector<double> errors = errors_after_a_quarter(steps);
        out << row({{text(steps), 7},
                    {digits(errors[0]), 14},
                    {digits(errors[1]), 15},
                    {digits(errors[2]), 12},
                    {digits(errors[3]), 0}});
    }
}

//> A comet
void print_comet(std::ostream &out) {
    out << row({{"t / turn", 10}, {"x [m]", 9}, {"y [m]", 9}, {"distance [m]", 0}});
    for (const double part : {0.0, 0.125, 0.25, 0.375, 0.5}) {
        const Vec2 at = kepler_position(semi_major, eccentricity, mu, part * whole_turn);
        out << row({{text(part), 10}, {digits(at.x()), 9}, {digits(at.y()), 9}, {digits(at.norm()), 0}});
    }
}

//> A comet, traced
void trace_anomaly(std::ostream &out) {
    out << "# x[m]\ty[m]\n";
    for (int part = 0; part < 24; ++part) { // of a turn
        const Vec2 at = kepler_position(semi_major, eccentricity, mu, part / 24.0 * whole_turn);
        out << at.x() << '\t' << at.y() << '\n';
    }
}

//> A fall of 479 pixels, traced
void trace_fall(std::ostream &out) {
    out << "# t[frames]\tas printed[px]\texact[px]\n";
    int printed = 479, velocity = 0;
    Fall exact{479, 0, 0};
    for (int frame = 0; frame <= 32; ++frame) {
        out << frame << '\t' << printed << '\t' << exact.height << '\n';
        printed -= velocity++;
        exact = fall_and_land(exact, 1, 1);
    }
}

//> A fall to the side, traced
void trace_sideways(std::ostream &out) {
    out << "# t[s]\tto the side[m]\tfall[m]\tthe circle's bend[m]\tradius[m]\n";
    const double r = 8, v = 10, a = gravity({{0, r}, 1}, hole, G).norm();
    for (int step = 0; step <= 25; ++step) { // half a second
        const double t = step / 50.0, side = v * t;
        out << t << '\t' << side << '\t' << a * t * t / 2 << '\t' << r - std::sqrt(r * r - side * side) << '\t' << r
            << '\n';
    }
}

//> Five pushes, traced
void trace_push(std::ostream &out) {
    out << "# 5 x[m]\t5 y[m]\t7 x[m]\t7 y[m]\t10 x[m]\t10 y[m]\t12 x[m]\t12 y[m]\t14.2 x[m]\t14.2 y[m]\n";
    std::vector<std::pair<Ship, double>> flights; // and how long they take, once around or out of the picture [s]
    for (const auto &[push, seconds] : {std::pair{5.0, 2.18}, {7.0, 2.72}, {10.0, 5.04}, {12.0, 12.0}, {14.2, 3.0}})
        flights.push_back({{{{8, 0}, {0, push}}}, seconds});
    for (int step = 0; step <= 20000; ++step)
        for (auto &[ship, seconds] : flights) {
            const char *end = &ship == &flights.back().first ? "\n" : "\t";
            if (step % 100 == 0) out << ship.state.position.x() << '\t' << ship.state.position.y() << end;
            next_frame(ship, seconds / 20000);
        }
}

//> Four orbits, traced
void trace_orbits(std::ostream &out) {
    out << "# explicit x[m]\texplicit y[m]\tsemi-implicit x[m]\tsemi-implicit y[m]\tleapfrog x[m]\tleapfrog y[m]\t"
           "Runge-Kutta x[m]\tRunge-Kutta y[m]\n";
    Integrators now = near_end();
    for (int step = 0; step <= 240; ++step) { // four turns
        const std::vector<State> ships = in_order(now);
        for (const State &ship : ships)
            out << ship.position.x() << '\t' << ship.position.y() << (&ship == &ships.back() ? '\n' : '\t');
        now = step_all(now, mu, whole_turn / 60);
    }
}

//> Energy, traced
void trace_energy(std::ostream &out) {
    out << "# turns[1]\texplicit[1]\tsemi-implicit[1]\tleapfrog[1]\tRunge-Kutta[1]\n";
    Integrators now = near_end();
    const double energy = energy_of(now.explicit_euler);
    for (int step = 1; step <= 2000; ++step) { // ten turns
        now = step_all(now, mu, whole_turn / 200);
        if (step % 10 != 0) continue;
        out << step / 200.0;
        for (const State &ship : in_order(now)) out << '\t' << std::abs(energy_of(ship) / energy - 1);
        out << '\n';
    }
}

//> A patch of ships, traced
/// The area inside a ring of ships, each a position [m] and a velocity [m/s] on one line, by the shoelace formula [m²/s].
double area_inside(const std::vector<Vec2> &ring) {
    double twice = 0;
    for (Vec2 before = ring.back(); const Vec2 &ship : ring) {
        twice += before.x() * ship.y() - before.y() * ship.x();
        before = ship;
    }
    return twice / 2;
}

/// Ships bob through a well that's softened by 8 m; they're pulled and moved at once, or in turn.
void trace_patch(std::ostream &out) {
    out << "# explicit x[m]\texplicit v[m/s]\texplicit area[m²/s]\t"
           "semi-implicit x[m]\tsemi-implicit v[m/s]\tsemi-implicit area[m²/s]\tsteps[1]\n";
    constexpr double dt = 0.3; // [s]
    const auto pulled = [](const Vec2 &ship) -> Vec2 { return {0, dt * softened_gravity({ship.x(), 0}, mu, 8).x()}; };
    const auto moved = [](const Vec2 &ship) -> Vec2 { return {dt * ship.y(), 0}; };
    std::vector<Vec2> at_once, in_turn; // by explicit and by semi-implicit Euler
    for (int k = 0; k <= 120; ++k) at_once.emplace_back(2.5 + std::cos(k * pi / 60), std::sin(k * pi / 60));
    in_turn = at_once;
    for (int step = 0; step <= 10; ++step) {
        for (std::size_t k = 0; step % 5 == 0 && k < at_once.size(); ++k)
            out << at_once[k].x() << '\t' << at_once[k].y() << '\t' << area_inside(at_once) << '\t' << in_turn[k].x()
                << '\t' << in_turn[k].y() << '\t' << area_inside(in_turn) << '\t' << step << '\n';
        if (step % 5 == 0) out << "\n\n";
        for (Vec2 &ship : at_once) ship += pulled(ship) + moved(ship);
        for (Vec2 &ship : in_turn) ship += pulled(ship);
        for (Vec2 &ship : in_turn) ship += moved(ship);
    }
}

//> Errors, traced
void trace_errors(std::ostream &out) {
    out << "# dt of a turn[1]\texplicit[m]\tsemi-implicit[m]\tleapfrog[m]\tRunge-Kutta[m]\n";
    for (int steps = 16; steps <= 2048; steps *= 2) {
        out << 0.25 / steps;
        for (const double error : errors_after_a_quarter(steps)) out << '\t' << error;
        out << '\n';
    }
}

//> Pulls, traced
void trace_pull(std::ostream &out) {
    out << "# distance[m]\tsoftened[m/s²]\n";
    for (int k = 0; k <= 60; ++k) out << k / 6.0 << '\t' << softened_gravity({k / 6.0, 0}, mu, 2).norm() << '\n';
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"pulls", print_pulls},
                        {"plunge", print_plunge},
                        {"jumps", print_jumps},
                        {"landing", print_landing},
                        {"circles", print_circles},
                        {"turns", print_turns},
                        {"softened", print_softened},
                        {"turned", print_turned},
                        {"errors", print_errors},
                        {"comet", print_comet},
                        {"03_gravity_wells_fall.tsv", trace_fall},
                        {"03_gravity_wells_push.tsv", trace_push},
                        {"03_gravity_wells_sideways.tsv", trace_sideways},
                        {"03_gravity_wells_orbits.tsv", trace_orbits},
                        {"03_gravity_wells_energy.tsv", trace_energy},
                        {"03_gravity_wells_patch.tsv", trace_patch},
                        {"03_gravity_wells_errors.tsv", trace_errors},
                        {"03_gravity_wells_pull.tsv", trace_pull},
                        {"03_gravity_wells_anomaly.tsv", trace_anomaly}});
}
