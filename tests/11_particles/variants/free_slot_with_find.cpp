// 11.1: std::find for an empty slot
#include "particles.hpp"

#include <algorithm>

namespace particles {

std::optional<int> free_slot(const Pool &pool) {
    const auto free = std::find(pool.begin(), pool.end(), std::nullopt);
    if (free == pool.end()) return {};
    return int(free - pool.begin());
}

} // namespace particles
