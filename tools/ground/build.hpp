#pragma once
#include "ground/kernel.hpp"
#include "ground/lab.hpp"
#include "ground/plain.hpp"
#include "ground/process.hpp"
#include "ground/tree.hpp"

#include <string>

namespace course {

/// Brings one target of the build up to date; what it printed is plain text. The caller holds the Lock.
inline Finished build_target(const Tree &tree, const std::string &target) {
    require_room_in_files();
    Finished built = tree.is_shared() ? build_apart(tree, target)
                                      : run({"cmake", "--build", tree.build.string(), "--target", target});
    built.out = plain_output(built.out);
    built.err = plain_output(built.err);
    return built;
}

} // namespace course
