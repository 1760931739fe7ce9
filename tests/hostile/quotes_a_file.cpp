// Has the compiler quote a file that isn't its own.
#include "/etc/passwd"
