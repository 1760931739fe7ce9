// A function that was deleted.
#include "rest.hpp"

namespace segment_intersection {


} // namespace segment_intersection
