#include "../scenes.hpp"

#include "scenes/common.hpp"
#include "scenes/disc.hpp"
#include "scenes/dots.hpp"
#include "scenes/once.hpp"
#include "scenes/opening.hpp"
#include "scenes/race.hpp"

//> The demo
namespace play {
const Scenes scenes =
    demo::scenes<Opening, Dots, Once, Common, Race, Disc>("A ball in a room with seven walls, which you throw.");
} // namespace play
