// 8.6: a table of lists, and a cell's two numbers made into one
#include "nt_collisions.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace nt_collisions {

std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance) {
    course::require(distance >= 0.001, "distance [m] must be 0.001 or more", distance);
    std::unordered_map<std::int64_t, std::vector<int>> grid;
    const auto key = [](std::int64_t column, std::int64_t row) { return column * 1'000'000'007 + row; };
    std::vector<Pair> pairs;
    for (int i = 0; i < int(centres.size()); ++i) {
        const auto column = std::int64_t(std::floor(centres[i].x() / distance));
        const auto row = std::int64_t(std::floor(centres[i].y() / distance));
        for (auto x = column - 1; x <= column + 1; ++x)
            for (auto y = row - 1; y <= row + 1; ++y)
                for (const int earlier : grid[key(x, y)])
                    if ((centres[i] - centres[earlier]).norm() <= distance) pairs.push_back({earlier, i});
        grid[key(column, row)].push_back(i);
    }
    return pairs;
}

} // namespace nt_collisions
