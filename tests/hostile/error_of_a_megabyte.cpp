// A line of the compiler that is a megabyte long.
#include "segment_intersection.hpp"

#define TEN(x) x x x x x x x x x x
#define THOUSAND(x) TEN(TEN(TEN(x)))
static_assert(false, THOUSAND(THOUSAND("x")));
