#include "../scenes.hpp"

#include "scenes/circles.hpp"
#include "scenes/falling.hpp"
#include "scenes/hole.hpp"
#include "scenes/integrators.hpp"
#include "scenes/kepler.hpp"
#include "scenes/lander.hpp"
#include "scenes/landing.hpp"
#include "scenes/opening.hpp"
#include "scenes/softened.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Hole, Falling, Landing, Circles, Softened, FourIntegrators, Kepler, Flight>(
    "Falling, and falling around.");
} // namespace play
