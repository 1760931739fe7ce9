// Has the compiler quote a file that isn't its own, and give up before it lists what it reads.
#include "/etc/passwd"
#include "nowhere.hpp"
