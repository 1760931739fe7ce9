#include "section_test.hpp"

#include "table_hockey.hpp"

using table_hockey::World;
using namespace table_hockey::subject; // step: the student's

//> Nothing is due
TEST_CASE("changes nothing in a frame that's shorter than a step, but keeps its time", "[13.1]") {
    const World now = table_hockey::opening(), later = step(now, {}, 0.004);
    CHECK_THAT(later.disc.place, IsNear(now.disc.place).of("place of the disc [m]"));
    CHECK_THAT(later.spare, IsNear(0.004, rounding).of("spare time [s]"));
}
