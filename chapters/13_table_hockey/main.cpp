#include "../program.hpp"

#include "table_hockey.hpp"

namespace {
using namespace table_hockey;

/// Both mallets rest, and somebody has just hit the disc.
World after_a_shot(double speed) {
    World now = opening();
    now.disc = {{-0.8, -0.3}, trajectories::launch_velocity(speed, 40)};
    return now;
}

double energy(const World &now) { return disc_mass * now.disc.velocity.squaredNorm() / 2; }

void print_shot(std::ostream &out) {
    out << course::row({{"time [s]", 12}, {"place [m]", 26}, {"speed [m/s]", 14}, {"energy [J]", 0}});
    World now = after_a_shot(4);
    for (int i = 0; i <= 6; ++i, now = step(now, {}, 0.25))
        out << course::row({{course::text(0.25 * i), 12},
                            {course::text(now.disc.place), 26},
                            {course::text(now.disc.velocity.norm()), 14},
                            {course::text(energy(now)), 0}});
}

/// Where the disc is after each step, until it rests or is in a goal.
void trace_shot(std::ostream &out) {
    out << "time [s]\tx [m]\ty [m]\n";
    World now = after_a_shot(4);
    for (int i = 0; now.disc.velocity.norm() > 0; ++i, now = step(now, {}, step_time))
        out << i * step_time << '\t' << now.disc.place.x() << '\t' << now.disc.place.y() << '\n';
}

} // namespace

int main(int argc, char **argv) {
    return course::run(argc, argv, {{"shot", print_shot}, {"13_table_hockey_shot.tsv", trace_shot}});
}
