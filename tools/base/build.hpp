#pragma once
#include "base/kernel.hpp"
#include "base/plain.hpp"
#include "base/process.hpp"
#include "base/workspace.hpp"

#include <string>

namespace course {

/// Brings one target of the build up to date; what it printed is plain text. The caller holds the Lock.
inline Finished build_target(const Workspace &workspace, const std::string &target) {
    require_room_in_files();
    Finished built = run({"cmake", "--build", workspace.build.string(), "--target", target});
    built.out = sanitize(built.out);
    built.err = sanitize(built.err);
    return built;
}

} // namespace course
