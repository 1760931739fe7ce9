// 8.6: a map of cells, point by point
#include "nt_collisions.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace nt_collisions {

static int cell(double x, double width) { return int(std::floor(x / width)); }

std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance) {
    course::require(distance >= 0.001, "distance [m] must be 0.001 or more", distance);
    std::map<std::pair<int, int>, std::vector<int>> grid; // what is in each cell
    std::vector<Pair> pairs;
    for (int i = 0; i < int(centres.size()); ++i) {
        const int column = cell(centres[i].x(), distance), row = cell(centres[i].y(), distance);
        for (int x = column - 1; x <= column + 1; ++x)
            for (int y = row - 1; y <= row + 1; ++y)
                if (const auto near = grid.find({x, y}); near != grid.end())
                    for (const int earlier : near->second)
                        if ((centres[i] - centres[earlier]).norm() <= distance) pairs.push_back({earlier, i});
        grid[{column, row}].push_back(i); // last of all: so a point meets those before it, and not itself
    }
    return pairs;
}
} // namespace nt_collisions
