#include "../program.hpp"

#include "time_based_motion.hpp"

using namespace time_based_motion;

//> Three stretches
constexpr double stiffness = 30; // [N/m], a soft spring: a bag of sugar stretches it by a third of a metre

void print_pulls(std::ostream &out) {
    out << course::row({{"stretch [m]", 13}, {"pull [N]", 0}});
    for (const double stretch : {0.25, 0.5, -0.1})
        out << course::row({{course::text(stretch), 13}, {course::text(pull(stiffness, stretch)), 0}});
}

//> Stretch and pull
void trace_pull(std::ostream &out) {
    out << "# stretch[m]\tpull[N]\n";
    for (int centimetres = -20; centimetres <= 20; centimetres += 4) {
        const double stretch = centimetres / 100.0;
        out << stretch << '\t' << pull(stiffness, stretch) + 0.0 << '\n'; // + 0.0: no negative zero
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv, {{"pulls", print_pulls}, {"12_time_based_motion_pull.tsv", trace_pull}});
}
