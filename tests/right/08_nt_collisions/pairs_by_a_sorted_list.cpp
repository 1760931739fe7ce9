// 8.6: cells in the order of a book, and a search by halving for the first of three in each row
#include "nt_collisions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace nt_collisions {

using Place = std::array<int, 3>; // the row and the column of a cell, and the index of a point in it

std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance) {
    course::require_range(centres, distance);
    course::require(distance >= 0.001, "distance [m] must be 0.001 or more", distance);
    std::vector<Place> places;
    for (int i = 0; i < int(centres.size()); ++i)
        places.push_back({int(std::floor(centres[i].y() / distance)), int(std::floor(centres[i].x() / distance)), i});
    std::sort(places.begin(), places.end());

    std::vector<Pair> pairs;
    for (const auto &[row, column, i] : places)
        for (const int near : {row - 1, row, row + 1}) {
            auto other = std::lower_bound(places.begin(), places.end(), Place{near, column - 1, 0});
            for (; other != places.end() && *other < Place{near, column + 2, 0}; ++other)
                if (const int j = (*other)[2]; i < j && (centres[i] - centres[j]).norm() <= distance)
                    pairs.push_back({i, j});
        }
    return pairs;
}

} // namespace nt_collisions
