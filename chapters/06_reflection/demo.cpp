#include "../scenes.hpp"

#include "scenes/crooked.hpp"
#include "scenes/ends.hpp"
#include "scenes/opening.hpp"
#include "scenes/pinball.hpp"
#include "scenes/pool.hpp"
#include "scenes/rough.hpp"
#include "scenes/screen.hpp"
#include "scenes/wall.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, OnScreen, OffWall, Ends, Rough, Crooked, Pool, Table>(
    "A ball on a screen, a wall that you turn, and a pool table.");
} // namespace play
