#include "../scenes.hpp"

#include "scenes/apples.hpp"
#include "scenes/around.hpp"
#include "scenes/both.hpp"
#include "scenes/eyes.hpp"
#include "scenes/letter.hpp"
#include "scenes/opening.hpp"
#include "scenes/ring.hpp"
#include "scenes/tentacle.hpp"

//> The demo
namespace play {
const Scenes scenes =
    demo::scenes<Opening, Eyes, Both, Ring, Apples, Around, Tentacle, Letter>("Arms that find their angles.");
} // namespace play
