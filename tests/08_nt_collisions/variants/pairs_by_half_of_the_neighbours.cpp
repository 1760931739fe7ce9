// 8.6: all points are put in first; then each cell with itself, and with four of the eight around it
#include "nt_collisions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace nt_collisions {

std::vector<Pair> close_pairs(const std::vector<Vec2> &centres, double distance) {
    course::require(distance >= 0.001, "distance [m] must be 0.001 or more", distance);
    std::map<int, std::map<int, std::vector<int>>> rows;
    for (int i = 0; i < int(centres.size()); ++i)
        rows[int(std::floor(centres[i].y() / distance))][int(std::floor(centres[i].x() / distance))].push_back(i);

    std::vector<Pair> pairs;
    const auto compare = [&](int i, int j) {
        if ((centres[i] - centres[j]).norm() <= distance) pairs.push_back({std::min(i, j), std::max(i, j)});
    };
    const auto compare_with = [&](const std::vector<int> &points, int row, int column) {
        const auto found = rows.find(row);
        if (found == rows.end()) return;
        const auto cell = found->second.find(column);
        if (cell == found->second.end()) return;
        for (const int i : points)
            for (const int j : cell->second) compare(i, j);
    };
    for (const auto &[row, columns] : rows)
        for (const auto &[column, points] : columns) {
            for (std::size_t k = 0; k < points.size(); ++k)
                for (std::size_t m = k + 1; m < points.size(); ++m) compare(points[k], points[m]);
            compare_with(points, row, column + 1);
            compare_with(points, row + 1, column - 1);
            compare_with(points, row + 1, column);
            compare_with(points, row + 1, column + 1);
        }
    return pairs;
}

} // namespace nt_collisions
