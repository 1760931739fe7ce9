// the page says:
#include "../../../solutions/13_table_hockey.cpp" // and of the earlier sections what is in earlier/
