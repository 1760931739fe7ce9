#include "../scenes.hpp"

#include "scenes/friends.hpp"
#include "scenes/machines.hpp"
#include "scenes/opening.hpp"

//> The demo
namespace play {
const Scenes scenes =
    demo::scenes<Opening, Friends, Machines>("A table with a disc, and two arms with mallets that play for goals.");
} // namespace play
