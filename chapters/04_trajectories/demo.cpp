#include "../scenes.hpp"

#include "scenes/aims.hpp"
#include "scenes/air.hpp"
#include "scenes/apexes.hpp"
#include "scenes/dots.hpp"
#include "scenes/flies.hpp"
#include "scenes/lands.hpp"
#include "scenes/loops.hpp"
#include "scenes/opening.hpp"
#include "scenes/ranges.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Flies, Lands, Ranges, Apexes, Dots, Aims, Loops, InAir>(
    "A cannon among hills, and where its shells land.");
} // namespace play
