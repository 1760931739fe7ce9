// This file doesn't compile.
#include "momentum.hpp"

namespace momentum {

double impulse(const Body &a, const Body &b, double restitution) { return a.mass * b.mass * }

} // namespace momentum
