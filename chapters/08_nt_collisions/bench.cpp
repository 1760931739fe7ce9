// `./course bench pairs` builds and runs this. Its figure is not redrawn each time, unlike the others.
#include "../bench.hpp"

#include "nt_collisions.hpp"

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

//> The measurements
struct Row {
    std::size_t count;
    double all, grid; ///< [ms]
};

const std::vector<Row> &results() { // measured once, printed and traced
    static const std::vector<Row> all = [] {
        std::vector<Row> rows;
        for (const std::size_t count : {100u, 1000u, 10000u, 100000u}) {
            const std::vector<Vec2> centres = crowd(count);
            std::size_t found = 0, found_by_grid = 0;
            const double slow = course::median_seconds([&] { found = all_pairs(centres).size(); });
            const double fast = course::median_seconds([&] { found_by_grid = close_pairs(centres, distance).size(); });
            if (found != found_by_grid) throw std::runtime_error{"the grid finds other pairs"};
            rows.push_back({count, 1e3 * slow, 1e3 * fast});
        }
        return rows;
    }();
    return all;
}

void print_pairs(std::ostream &out) {
    out << row({{"balls", 9}, {"all pairs [ms]", 17}, {"grid [ms]", 12}, {"ratio", 0}});
    for (const auto &[count, all, grid] : results())
        out << row(
            {{std::to_string(count), 9}, {digits(all, 3), 17}, {digits(grid, 3), 12}, {digits(all / grid, 2), 0}});
}

void trace_pairs(std::ostream &out) {
    out << std::setprecision(4); // a measurement has no more digits
    out << "# balls[1]\tall pairs[ms]\tgrid[ms]\n";
    for (const auto &[count, all, grid] : results()) out << count << '\t' << all << '\t' << grid << '\n';
}

//> Main of the benchmark
int main(int argc, char **argv) {
    return course::run(argc, argv, {{"pairs", print_pairs}, {"08_nt_collisions_measured_pairs.tsv", trace_pairs}});
}
