// A line of the compiler that is a megabyte long. (Of parts of ten letters: a million parts take GCC 14 minutes.)
#include "segment_intersection.hpp"

#define TEN(x) x x x x x x x x x x
#define THOUSAND(x) TEN(TEN(TEN(x)))
static_assert(false, THOUSAND(TEN(TEN("xxxxxxxxxx"))));

namespace segment_intersection {} // else that would be told first
