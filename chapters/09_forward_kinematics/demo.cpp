#include "../scenes.hpp"

#include "scenes/arrows.hpp"
#include "scenes/beast.hpp"
#include "scenes/cab.hpp"
#include "scenes/carry.hpp"
#include "scenes/digger.hpp"
#include "scenes/draws.hpp"
#include "scenes/opening.hpp"
#include "scenes/wall.hpp"

//> The demo
namespace play {
const Scenes scenes =
    demo::scenes<Opening, Draws, DiggerScene, Beast, Cab, Arrows, Carry, Wall>("Arms, and where their hands are.");
} // namespace play
