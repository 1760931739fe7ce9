// What a reader's file calls of earlier sections, where its demo plays the reader's of those, too: it asks the page, as the demo
// does, and ours are linked beside. A test that calls the reader's file never has it ask.
#include "calls.hpp"

extern "C" __attribute__((export_name("ask_reader"))) void asks_ask_reader() { host::asks_reader = true; }
