// Compiled once and put before every student's file: what exercises use, and nothing more, or it would load slowly.
#include "course.hpp"
#include "interface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>
