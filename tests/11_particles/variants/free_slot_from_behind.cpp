// 11.1: the last free slot
#include "particles.hpp"

namespace particles {

std::optional<int> free_slot(const Pool &pool) {
    for (int i = int(pool.size()) - 1; i >= 0; --i)
        if (!pool[std::size_t(i)].has_value()) return i;
    return std::nullopt;
}

} // namespace particles
