#include "../program.hpp"

#include "table_hockey.hpp"

namespace {
using namespace table_hockey;

void print_serve(std::ostream &out) {
    World now = opening();
    for (int i = 0; i < 480; ++i) now = step(now, {}, step_time);
    out << course::text(now.disc.place) << '\n';
}

} // namespace

int main(int argc, char **argv) { return course::run(argc, argv, {{"serve", print_serve}}); }
