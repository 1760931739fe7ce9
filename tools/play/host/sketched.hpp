#pragma once
// A sketch as the host's demo. Its file is linked before this, so that what it has of constants is there.
#include "sketch.hpp"

namespace play {
const demo::Scenes scenes = sketched_scenes();
}
