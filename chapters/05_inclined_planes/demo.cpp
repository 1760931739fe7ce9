#include "../scenes.hpp"

#include "scenes/critical.hpp"
#include "scenes/hockey.hpp"
#include "scenes/opening.hpp"
#include "scenes/presses.hpp"
#include "scenes/slides.hpp"
#include "scenes/slips.hpp"
#include "scenes/slows.hpp"
#include "scenes/stops.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Slows, Stops, Presses, Slides, Critical, Hockey, Slips>(
    "A box on a board, a glass on a bar, and a block on a spring.");
} // namespace play
