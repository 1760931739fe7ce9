// A line of the compiler that looks like another one, with a line number that no number holds.
#include "segment_intersection.hpp"
#error foo:99999999999999999999: warning: b

namespace segment_intersection {} // else that would be told first
