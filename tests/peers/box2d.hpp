#pragma once
// What several peers ask of Box2D.

#include <box2d/box2d.h>

#include <string>

namespace course {

/// As the library names itself.
inline std::string box2d_name() {
    return "Box2D " + std::to_string(b2_version.major) + '.' + std::to_string(b2_version.minor) + '.'
           + std::to_string(b2_version.revision);
}

} // namespace course
