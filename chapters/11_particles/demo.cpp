#include "../scenes.hpp"

#include "scenes/colours.hpp"
#include "scenes/disc.hpp"
#include "scenes/gaps.hpp"
#include "scenes/opening.hpp"
#include "scenes/rate.hpp"
#include "scenes/ring.hpp"
#include "scenes/three.hpp"
#include "scenes/walls.hpp"
#include "scenes/whole.hpp"

//> The demo
namespace play {
const Scenes scenes =
    demo::scenes<Opening, Colours, Three, Ring, Disc, Rate, Walls, Gaps, Whole>("Fireworks over a town.");
} // namespace play
