#include "ground/build.hpp"

#include "ground/limits.hpp"
#include "ground/plain.hpp"

namespace course {

Finished build_target(const Tree &tree, const std::string &target) {
    require_room_in_files();
    Finished built = run({"cmake", "--build", tree.build.string(), "--target", target});
    built.out = plain_output(built.out);
    built.err = plain_output(built.err);
    return built;
}

} // namespace course
