#include "../program.hpp"

#include "motion.hpp"

using namespace motion;
using course::row, course::text;

//> Pixels
void print_pixels(std::ostream &out) {
    out << "4 px/frame at 30 frames a second: " << text(px_per_second(4, 30)) << " px/s\n";
}

void print_uniform(std::ostream &out) {
    const Vec2 place = uniform_motion({200, 80}, {4, 0}, 30);
    out << "from (200, 80) px at (4, 0) px/frame, after 30 frames: " << text(place) << " px\n";
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

//> Side by side, printed
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

void print_centroid(std::ostream &out) { out << "middle of the L [m]: " << text(centroid(l_shape)) << '\n'; }

void print_fit(std::ostream &out) {
    const Motion found = fit_motion({1, 55}, {2, 62}, {5, 95});
    out << "rows 1, 2 and 5 of Table 13.2: x_0 = " << text(found.x_0) << ", v_0 = " << text(found.v_0)
        << ", a = " << text(found.a) << '\n';
}

//> Table 13.2 as a curve
void trace_table(std::ostream &out) {
    out << "# t[s]\tx[m]\tv[m/s]\n";
    for (int tenth = 0; tenth <= 50; ++tenth) {
        const double t = tenth / 10.0;
        const State now = accelerated_motion(moving, acceleration, t);
        out << t << '\t' << now.position.x() << '\t' << now.velocity.x() << '\n';
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
    const State thrown{.position = {0, 0}, .velocity = {3, 7}};
    const Vec2 gravity{0, -9.8};
    const Vec2 truth{15, 35 - 122.5}; // after 5 s: 3 · 5, and 7 · 5 - 9.8/2 · 5²

    out << "# dt[s]\texplicit[m]\tsemi-implicit[m]\texact[m]\n";
    for (const int steps : {3, 7, 17, 31, 70, 150, 310, 700, 1500, 3100, 7000, 15000, 31000, 70000, 150000, 310000}) {
        Integrators now{thrown, thrown, thrown};
        for (int i = 0; i < steps; ++i) now = step_all(now, gravity, 5.0 / steps);
        out << 5.0 / steps << '\t' << (now.explicit_euler.position - truth).norm() << '\t'
            << (now.semi_implicit.position - truth).norm() << '\t' << (now.exact.position - truth).norm() << '\n';
    }
}

//> Three middles of an L
void trace_l(std::ostream &out) {
    const Vec2 middle = centroid(l_shape);
    out << "# x[m]\ty[m]\tmiddle x[m]\tmiddle y[m]\n";
    for (const Vec2 &corner : l_shape)
        out << corner.x() << '\t' << corner.y() << '\t' << middle.x() << '\t' << middle.y() << '\n';
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"pixels", print_pixels},
                        {"uniform", print_uniform},
                        {"velocities", print_table_13_1},
                        {"positions", print_table_13_2},
                        {"centres", print_centres},
                        {"integrators", print_integrators},
                        {"centroid", print_centroid},
                        {"fit", print_fit},
                        {"01_motion_table.tsv", trace_table},
                        {"01_motion_centre.tsv", trace_centre},
                        {"01_motion_integrators.tsv", trace_integrators},
                        {"01_motion_error.tsv", trace_error},
                        {"01_motion_l.tsv", trace_l}});
}
