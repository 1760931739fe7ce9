#include "../scenes.hpp"

#include "scenes/clay.hpp"
#include "scenes/cradle.hpp"
#include "scenes/opening.hpp"
#include "scenes/point.hpp"
#include "scenes/ropes.hpp"
#include "scenes/rubber.hpp"
#include "scenes/walls.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Ropes, Point, Rubber, Clay, Walls, Cradle>(
    "Carts on a straight rail, or balls on strings, which collide.");
} // namespace play
