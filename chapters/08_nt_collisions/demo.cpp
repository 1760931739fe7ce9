#include "../scenes.hpp"

#include "scenes/break_shot.hpp"
#include "scenes/contact.hpp"
#include "scenes/crowd.hpp"
#include "scenes/equal.hpp"
#include "scenes/fast.hpp"
#include "scenes/masses.hpp"
#include "scenes/opening.hpp"
#include "scenes/thousand.hpp"

//> The demo
namespace play {
const Scenes scenes = demo::scenes<Opening, Contact, Equal, Masses, BreakShot, Fast, Crowd, Thousand>(
    "Balls on a table that meet: two of them, fifteen, a crowd, and a thousand.");
} // namespace play
