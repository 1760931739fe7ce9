// An object file of two gigabytes.
#include "segment_intersection.hpp"

char all[1u << 31] = {1};
