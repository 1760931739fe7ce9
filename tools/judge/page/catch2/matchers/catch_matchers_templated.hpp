#pragma once
#include "../small.hpp"
