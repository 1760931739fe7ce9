// A function with a name of 100,000 letters that is declared, used and never defined.
#include "rest.hpp"

#define TEN(x) x x x x x x x x x x
#define THOUSAND(x) TEN(TEN(TEN(x)))
void never_defined() __asm__(TEN(TEN(THOUSAND("x"))));

namespace segment_intersection {

std::optional<LineIntersection> intersect_lines(const Segment &, const Segment &) {
    never_defined();
    return {};
}

} // namespace segment_intersection
