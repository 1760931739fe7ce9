#include "../scenes.hpp"

#include "scenes/busy.hpp"
#include "scenes/cameras.hpp"
#include "scenes/friends.hpp"
#include "scenes/opening.hpp"
#include "scenes/running.hpp"
#include "scenes/sleeping.hpp"
#include "scenes/three.hpp"
#include "scenes/whole.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Three, Sleeping, Whole, Running, TwoCameras, Busy, Friends>(
    "The same game on screens that are fast and slow.");
} // namespace play
