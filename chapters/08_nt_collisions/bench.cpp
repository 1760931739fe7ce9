// `./course dev bench pairs` builds and runs this. Its figure is not redrawn each time, unlike the others.
#include "../bench.hpp"

#include "nt_collisions.hpp"

#include <map>
#include <random>

using namespace nt_collisions;
using course::digits, course::row;

//> What is measured
constexpr double distance = 1; // at which two balls of a radius of 0.5 m touch [m]

/// So many balls anywhere on a table that has 4 m² for each of them.
std::vector<Vec2> crowd(std::size_t count) {
    std::mt19937_64 engine{count};
    const double side = 2 * std::sqrt(double(count)); // of the table [m]
    const auto anywhere = [&] { return side * double(engine() >> 11) / double(1ull << 53); };
    std::vector<Vec2> centres(count);
    for (Vec2 &centre : centres) centre = {anywhere(), anywhere()};
    return centres;
}

/// Each ball compared with all before it.
std::vector<Pair> all_pairs(const std::vector<Vec2> &centres) {
    std::vector<Pair> pairs;
    for (int i = 0; i < int(centres.size()); ++i)
        for (int j = 0; j < i; ++j)
            if ((centres[i] - centres[j]).norm() <= distance) pairs.push_back({j, i});
    return pairs;
}

/// Each ball compared with those before it in the nine cells around it, which a map finds.
std::vector<Pair> pairs_by_map(const std::vector<Vec2> &centres) {
    std::map<std::pair<int, int>, std::vector<int>> grid;
    std::vector<Pair> pairs;
    for (int i = 0; i < int(centres.size()); ++i) {
        const int column = int(std::floor(centres[i].x() / distance)), row = int(std::floor(centres[i].y() / distance));
        for (int x = column - 1; x <= column + 1; ++x)
            for (int y = row - 1; y <= row + 1; ++y)
                if (const auto near = grid.find({x, y}); near != grid.end())
                    for (const int earlier : near->second)
                        if ((centres[i] - centres[earlier]).norm() <= distance) pairs.push_back({earlier, i});
        grid[{column, row}].push_back(i);
    }
    return pairs;
}

//> The measurements
struct Row {
    std::size_t count;
    double all, map, sorted; ///< [ms]
};

/// How long such a function takes [ms], which must find as many pairs as ours.
template <class Function> double measured(const Function &function, const std::vector<Vec2> &centres) {
    std::size_t count = 0;
    const double time = course::median_seconds([&] { count = function(centres).size(); });
    if (count != close_pairs(centres, distance).size()) throw std::runtime_error{"one way finds other pairs"};
    return 1e3 * time;
}

const std::vector<Row> &results() { // measured once, printed and traced
    static const std::vector<Row> all = [] {
        std::vector<Row> rows;
        for (const std::size_t count : {100u, 1000u, 10000u, 100000u}) {
            const std::vector<Vec2> centres = crowd(count);
            const auto by_sorting = [](const std::vector<Vec2> &points) { return close_pairs(points, distance); };
            rows.push_back(
                {count, measured(all_pairs, centres), measured(pairs_by_map, centres), measured(by_sorting, centres)});
        }
        return rows;
    }();
    return all;
}

void print_pairs(std::ostream &out) {
    out << row({{"balls", 9}, {"all pairs [ms]", 17}, {"map [ms]", 12}, {"sorted [ms]", 14}, {"map / sorted", 0}});
    for (const auto &[count, all, map, sorted] : results())
        out << row({{std::to_string(count), 9},
                    {digits(all, 3), 17},
                    {digits(map, 3), 12},
                    {digits(sorted, 3), 14},
                    {digits(map / sorted, 2), 0}});
}

void trace_pairs(std::ostream &out) {
    out << std::setprecision(4); // a measurement has no more digits
    out << "# balls[1]\tall pairs[ms]\tmap[ms]\tsorted[ms]\n";
    for (const auto &[count, all, map, sorted] : results())
        out << count << '\t' << all << '\t' << map << '\t' << sorted << '\n';
}

//> Main of the benchmark
int main(int argc, char **argv) {
    return course::run(argc, argv, {{"pairs", print_pairs}, {"08_nt_collisions_measured_pairs.tsv", trace_pairs}});
}
