#pragma once
#include "ground/process.hpp"
#include "ground/tree.hpp"

#include <string>

namespace course {

/// Brings one target of the build up to date; what it printed is plain text. The caller holds the Lock.
Finished build_target(const Tree &tree, const std::string &target);

} // namespace course
