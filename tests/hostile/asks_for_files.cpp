// Asks whether a file is there, under a name that no search of the text finds.
#include "segment_intersection.hpp"

#if __has_\
include("/etc/passwd")
#error it is there
#endif
