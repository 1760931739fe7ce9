// Includes what has no end.
#include "/dev/zero"
