// Asks whether a file is there: quotes_a_file.txt says the same of one that is.
#include "/etc/passwd-of-nobody"
