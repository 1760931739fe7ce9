#include "../scenes.hpp"

#include "scenes/across.hpp"
#include "scenes/breaks.hpp"
#include "scenes/chase.hpp"
#include "scenes/opening.hpp"
#include "scenes/plate.hpp"
#include "scenes/screen.hpp"
#include "scenes/sightings.hpp"
#include "scenes/speeds.hpp"
#include "scenes/three.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Speeds, Across, Chase, Breaks, Three, Plate, Sightings, OnScreen>(
    "A helicopter crosses the screen at a constant velocity. A missile behind it gets faster.");
} // namespace play
