#include "../program.hpp"

#include "game.hpp"

using namespace motion;
using course::row, course::text;

//> Pixels per second, printed
void print_pixels(std::ostream &out) {
    out << "4 px/frame at 30 frames per second: " << text(px_per_second(4, 30)) << " px/s\n";
}

//> The screen in letters
/// A screen of 640 px as 40 letters: `|   M        H       |`. What is outside is not shown.
std::string screen(const std::vector<std::pair<char, double>> &things) {
    std::string letters(40, ' ');
    for (const auto &[letter, x] : things)
        if (0 <= x && x < 640) letters[std::size_t(x / 16)] = letter;
    return '|' + letters + '|';
}

//> A helicopter crosses the screen
void print_crossing(std::ostream &out) {
    out << row({{"t [s]", 7}, {"x [px]", 8}, {"the screen, 640 px wide", 0}});
    Helicopter helicopter;
    for (int frame = 0; frame <= 150; ++frame) {
        const double x = helicopter.position.x();
        if (frame % 30 == 0) out << row({{text(frame / 30.0), 7}, {text(x), 8}, {screen({{'H', x}}), 0}});
        next_frame(helicopter, 1.0 / 30);
    }
}

//> A missile overtakes it
void print_chase(std::ostream &out) {
    out << row({{"frame", 7}, {"missile", 9}, {"helicopter", 12}, {"the screen, 640 px wide", 0}});
    Helicopter helicopter{.position = {200, 80}};
    Missile missile{.state = {{50, 80}, helicopter.velocity}, .acceleration = {2 * 30 * 30, 0}}; // 2 px/frame²
    for (int frame = 0; frame <= 20; ++frame) {
        const double m = missile.state.position.x(), h = helicopter.position.x();
        if (frame % 5 == 0)
            out << row({{text(frame), 7}, {text(m), 9}, {text(h), 12}, {screen({{'H', h}, {'M', m}}), 0}});
        next_frame(helicopter, 1.0 / 30);
        next_frame(missile, 1.0 / 30);
    }
}

//> Tables 13.1 and 13.2
const State from_rest{.position = {0, 0}, .velocity = {0, 0}};
const State moving{.position = {50, 0}, .velocity = {4, 0}};
const Vec2 acceleration{2, 0};

void print_table_13_1(std::ostream &out) {
    out << row({{"t [s]", 7}, {"v [m/s]", 9}, {"a [m/s²]", 0}});
    for (int t = 0; t <= 5; ++t) {
        const State now = accelerated_motion(from_rest, acceleration, t);
        out << row({{text(t), 7}, {text(now.velocity.x()), 9}, {text(acceleration.x()), 0}});
    }
}

void print_table_13_2(std::ostream &out) {
    out << row({{"t [s]", 7}, {"x [m]", 7}, {"change [m]", 12}, {"change of that [m]", 0}});
    const auto x = [](int t) { return accelerated_motion(moving, acceleration, t).position.x(); };
    for (int t = 0; t <= 5; ++t) {
        const std::string change = t < 1 ? "" : text(x(t) - x(t - 1));
        const std::string of_change = t < 2 ? "" : text((x(t) - x(t - 1)) - (x(t - 1) - x(t - 2)));
        out << row({{text(t), 7}, {text(x(t)), 7}, {change, 12}, {of_change, 0}});
    }
}

//> A missile breaks in two
const Vec2 gravity{0, -10}; // [m/s²], a round number
const State thrown{.position = {0, 0}, .velocity = {3, 7}};

/// Its nose, 1 kg, and its hull, 3 kg, which fly together at first. The engine is off.
std::vector<Missile> nose_and_hull() { return {{thrown, gravity, 1}, {thrown, gravity, 3}}; }

/// They push each other apart. The hull is three times as heavy, so it gains a third of the velocity, backwards.
void burst(std::vector<Missile> &pieces) {
    const Vec2 kick{3, 3}; // [m/s]
    pieces[0].state.velocity += kick;
    pieces[1].state.velocity -= kick / 3;
}

void print_burst(std::ostream &out) {
    out << row({{"t [s]", 7}, {"centre [m]", 14}, {"unbroken [m]", 14}, {"the camera's screen, 8 m wide", 0}});
    Missile unbroken{.state = thrown, .acceleration = gravity};
    std::vector<Missile> pieces = nose_and_hull();
    for (int frame = 0; frame <= 14; ++frame) { // of 0.1 s
        if (frame == 6) burst(pieces);
        if (frame >= 6 && frame % 2 == 0) {
            const Vec2 centre = camera_target(pieces).value();
            const auto seen = [&](const Vec2 &p) { return 320 + 80 * (p - centre).x(); }; // 80 px per metre
            const double n = seen(pieces[0].state.position), h = seen(pieces[1].state.position);
            out << row({{text(frame / 10.0), 7},
                        {text(centre), 14},
                        {text(unbroken.state.position), 14},
                        {screen({{'n', n}, {'h', h}, {'+', seen(centre)}}), 0}});
        }
        for (Missile &piece : pieces) next_frame(piece, 0.1);
        next_frame(unbroken, 0.1);
    }
}

//> Centres of mass
const std::vector<PointMass> three{{{0, 0}, 1}, {{4, 0}, 1}, {{0, 3}, 2}};

void print_centres(std::ostream &out) {
    const std::vector<PointMass> unweighted{{{0, 0}, 1}, {{4, 0}, 1}, {{0, 3}, 1}};
    const std::vector<PointMass> massless{{{0, 0}, 0}, {{4, 0}, 0}, {{0, 3}, 0}};
    out << row({{"masses [kg]", 13}, {"at (0, 0), (4, 0), (0, 3) balance at [m]", 0}});
    for (const auto &[masses, bodies] : {std::pair{"1, 1, 2", three}, {"1, 1, 1", unweighted}, {"0, 0, 0", massless}}) {
        const auto centre = centre_of_mass(bodies);
        out << row({{masses, 13}, {centre ? text(*centre) : "nothing balances", 0}});
    }
}

//> Three integrators, printed
void print_integrators(std::ostream &out) {
    out << row({{"t [s]", 7}, {"explicit Euler [m]", 20}, {"semi-implicit [m]", 19}, {"exact [m]", 0}});
    Integrators now{moving, moving, moving};
    for (int t = 0; t <= 5; ++t) {
        out << row({{text(t), 7},
                    {text(now.explicit_euler.position.x()), 20},
                    {text(now.semi_implicit.position.x()), 19},
                    {text(now.exact.position.x()), 0}});
        now = step_all(now, acceleration, 1);
    }
}

//> An L and a fit
const std::vector<Vec2> l_shape{{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}};

void print_centroid(std::ostream &out) { out << "centroid of the L [m]: " << text(centroid(l_shape)) << '\n'; }

void print_fit(std::ostream &out) {
    const Motion found = fit_motion({1, 55}, {2, 62}, {5, 95});
    out << "rows 1, 2 and 5 of Table 13.2: x_0 = " << text(found.x_0) << ", v_0 = " << text(found.v_0)
        << ", a = " << text(found.a) << '\n';
}

//> Table 13.2 as a curve
void trace_table(std::ostream &out) {
    out << "# t[frame]\tx[px]\tv[px/frame]\n";
    for (int tenth = 0; tenth <= 50; ++tenth) {
        const double t = tenth / 10.0;
        const State now = accelerated_motion(moving, acceleration, t);
        out << t << '\t' << now.position.x() << '\t' << now.velocity.x() << '\n';
    }
}

//> Four frames, and what they hand on
void trace_frames(std::ostream &out) {
    out << "# frame[1]\tx[m]\tv[m/s]\n";
    Missile missile{.state = moving, .acceleration = acceleration};
    for (int frame = 0; frame < 4; ++frame) {
        out << frame << '\t' << missile.state.position.x() << '\t' << missile.state.velocity.x() << '\n';
        next_frame(missile, 1);
    }
}

//> The paths of the pieces
void trace_burst(std::ostream &out) {
    out << "# unbroken x[m]\ty[m]\tnose x[m]\ty[m]\thull x[m]\ty[m]\tcentre x[m]\ty[m]\n";
    Missile unbroken{.state = thrown, .acceleration = gravity};
    std::vector<Missile> pieces = nose_and_hull();
    for (int frame = 0; frame <= 70; ++frame) { // of 0.02 s
        if (frame == 30) burst(pieces);
        const Vec2 whole = unbroken.state.position, nose = pieces[0].state.position, hull = pieces[1].state.position;
        const Vec2 centre = camera_target(pieces).value();
        out << whole.x() << '\t' << whole.y() << '\t' << nose.x() << '\t' << nose.y() << '\t' << hull.x() << '\t'
            << hull.y() << '\t' << centre.x() << '\t' << centre.y() << '\n';
        for (Missile &piece : pieces) next_frame(piece, 0.02);
        next_frame(unbroken, 0.02);
    }
}

//> The weighted corners
void trace_centre(std::ostream &out) {
    const Vec2 centre = centre_of_mass(three).value();
    out << "# x[m]\ty[m]\tmass[kg]\tcentre x[m]\tcentre y[m]\n";
    for (const auto &[position, mass] : three)
        out << position.x() << '\t' << position.y() << '\t' << mass << '\t' << centre.x() << '\t' << centre.y() << '\n';
}

//> Three integrators, traced
void trace_integrators(std::ostream &out) {
    out << "# t[s]\texplicit[m]\tsemi-implicit[m]\texact[m]\n";
    Integrators now{moving, moving, moving};
    for (int t = 0; t <= 5; ++t) {
        out << t << '\t' << now.explicit_euler.position.x() << '\t' << now.semi_implicit.position.x() << '\t'
            << now.exact.position.x() << '\n';
        now = step_all(now, acceleration, 1);
    }
}

//> Errors, printed
void trace_error(std::ostream &out) {
    const Vec2 g{0, -9.8};
    const Vec2 truth{15, 35 - 122.5}; // after 5 s: 3 · 5, and 7 · 5 - 9.8/2 · 5²

    out << "# dt[s]\texplicit[m]\tsemi-implicit[m]\texact[m]\n";
    for (const int steps : {3, 7, 17, 31, 70, 150, 310, 700, 1500, 3100, 7000, 15000, 31000, 70000, 150000, 310000}) {
        Integrators now{thrown, thrown, thrown};
        for (int i = 0; i < steps; ++i) now = step_all(now, g, 5.0 / steps);
        out << 5.0 / steps << '\t' << (now.explicit_euler.position - truth).norm() << '\t'
            << (now.semi_implicit.position - truth).norm() << '\t' << (now.exact.position - truth).norm() << '\n';
    }
}

//> Three centres of an L
void trace_l(std::ostream &out) {
    const Vec2 centre = centroid(l_shape);
    out << "# x[m]\ty[m]\tcentroid x[m]\tcentroid y[m]\n";
    for (const Vec2 &corner : l_shape)
        out << corner.x() << '\t' << corner.y() << '\t' << centre.x() << '\t' << centre.y() << '\n';
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"pixels", print_pixels},
                        {"crossing", print_crossing},
                        {"chase", print_chase},
                        {"velocities", print_table_13_1},
                        {"positions", print_table_13_2},
                        {"burst", print_burst},
                        {"centres", print_centres},
                        {"integrators", print_integrators},
                        {"centroid", print_centroid},
                        {"fit", print_fit},
                        {"01_motion_table.tsv", trace_table},
                        {"01_motion_frames.tsv", trace_frames},
                        {"01_motion_burst.tsv", trace_burst},
                        {"01_motion_centre.tsv", trace_centre},
                        {"01_motion_integrators.tsv", trace_integrators},
                        {"01_motion_error.tsv", trace_error},
                        {"01_motion_l.tsv", trace_l}});
}
