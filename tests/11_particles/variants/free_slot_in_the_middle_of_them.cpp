// 11.1: all free slots are listed first, and the middle one is taken
#include "particles.hpp"

namespace particles {

std::optional<int> free_slot(const Pool &pool) {
    std::vector<int> free;
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (!pool[i].has_value()) free.push_back(int(i));
    if (free.empty()) return {};
    return free[free.size() / 2];
}

} // namespace particles
