#include "../program.hpp"

#include "table_hockey.hpp"

namespace {
using namespace table_hockey;

/// Both mallets rest, and somebody on the left has just hit the disc, this many degrees upwards.
World after_a_shot(double angle) {
    World now = opening();
    now.disc = {{-0.8, -0.3}, trajectories::launch_velocity(4, angle)};
    return now;
}

bool is_over(const World &now) { return now.left.goals + now.right.goals > 0 || now.disc.velocity.isZero(0); }

/// A turn is when the disc's velocity changes by more than the felt can change it.
void print_shots(std::ostream &out) {
    out << course::row({{"shot [°]", 12}, {"turns", 9}, {"time [s]", 12}, {"goals", 0}});
    for (const double angle : {20, 25, 35}) {
        World now = after_a_shot(angle);
        int turns = 0, steps = 0;
        for (; !is_over(now); ++steps) {
            const Disc before = now.disc;
            now = step(now, {}, step_time);
            if (is_over(now)) continue;
            turns += (now.disc.velocity - before.velocity).norm() > 2 * felt * step_time;
        }
        out << course::row({{course::text(angle), 12},
                            {std::to_string(turns), 9},
                            {course::text(std::round(steps * step_time * 100) / 100), 12},
                            {std::to_string(now.left.goals) + " : " + std::to_string(now.right.goals), 0}});
    }
}

/// Where the disc is after each step, until it's in a goal.
void trace_shots(std::ostream &out) {
    for (const double angle : {20, 25}) {
        out << "time [s]\tx [m]\ty [m]\n";
        World now = after_a_shot(angle);
        for (int i = 0; !is_over(now); ++i, now = step(now, {}, step_time))
            out << i * step_time << '\t' << now.disc.place.x() << '\t' << now.disc.place.y() << '\n';
        out << "\n\n";
    }
}

} // namespace

int main(int argc, char **argv) {
    return course::run(argc, argv, {{"shots", print_shots}, {"13_table_hockey_shots.tsv", trace_shots}});
}
