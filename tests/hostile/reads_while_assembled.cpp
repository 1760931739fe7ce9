// Has the assembler put a file into the program, under a name that no search of the text finds.
#include "segment_intersection.hpp"

asm(".pushsection .rodata\n.inc"
    "bin \"/etc/passwd\"\n.popsection");
