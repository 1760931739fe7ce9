#pragma once
#include "../course.hpp"
#include "../interface.hpp"

/// Section 99: what a spring does to what hangs on it.
namespace skeleton {

//> The pull of a spring
/// Force of a spring on what stretches it, along its axis [N]; positive is the direction of a positive stretch.
/// @param stiffness  newtons for each metre of stretch [N/m], positive
/// @param stretch    how much longer it is than at rest [m]; negative: how much shorter
/// @throws std::invalid_argument if the stiffness is not positive.
double pull(double stiffness, double stretch);

//>
namespace subject {
COURSE_EXERCISE("99.1", core, skeleton, pull, "stiffness [N/m], stretch [m]", "N")
} // namespace subject
} // namespace skeleton
