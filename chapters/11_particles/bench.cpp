// `./course dev bench particles` builds and runs this. Its figure is not redrawn each time, unlike the others.
#include "../bench.hpp"

#include "pools.hpp"

#include <algorithm>
#include <array>
#include <random>

using namespace particles;
using course::row, course::seconds, course::median_seconds;

//> What is measured
/// Frames of 1/60 s and lives of 2 s: in each frame one particle in 120 dies, and another is spawned in its place.
constexpr double dt = 1.0 / 60;
constexpr double life = 2;

/// `count` particles with random ages.
std::vector<Particle> crowd(std::size_t count) {
    std::mt19937_64 engine{count};
    std::vector<Particle> particles(count, {.position = {0, 0}, .velocity = {1, 9}, .age = 0, .life = life});
    for (Particle &particle : particles) particle.age = (double(engine() % 120) + 0.5) * dt;
    return particles;
}

/// A frame of a pool that is full again at its end; how many were spawned.
template <class AnyPool> std::size_t frame(AnyPool &pool) {
    const Particle young{.position = {0, 0}, .velocity = {1, 9}, .age = 0.5 * dt, .life = life};
    pool.step(dt);
    std::size_t spawned = 0;
    while (pool.spawn(young)) ++spawned;
    return spawned;
}

//> How it is measured
/// Millions of particles per second.
template <class AnyPool> double rate(std::size_t count) {
    AnyPool pool{crowd(count)};
    std::size_t spawned = 0;
    const double time = median_seconds([&] { spawned += frame(pool); });
    if (spawned == 0) throw std::runtime_error{"no particle was spawned: this would measure nothing"};
    return 1e-6 * double(count) / time;
}

/// Bytes per second [GB/s] for numbers that are read, changed and written back in place, as particles are. It is the best
/// of twenty: what memory can deliver when no other program uses it.
double bandwidth() {
    std::vector<double> numbers(32u << 20, 1.0); // 256 MB: far more than any cache holds
    double least = 1;
    for (int i = 0; i < 20; ++i)
        least = std::min(least, seconds([&] {
                             for (double &x : numbers) x = 0.5 * x + 1;
                         }));
    return 1e-9 * double(2 * sizeof(double) * numbers.size()) / least;
}

//> The results
struct Row {
    std::size_t count;
    std::array<double, 3> rates; ///< of linear search, free list, swap and pop [1e6/s]
};

struct Results {
    double memory{}; ///< [GB/s], the best of what was measured between the rows
    std::vector<Row> rows;
};

/// Bytes that a particle moves to the processor and back in each frame.
constexpr std::array<double, 3> bytes{2 * sizeof(Pool::value_type), 2 * sizeof(Pool::value_type), 2 * sizeof(Particle)};

const Results &results() { // measured once, printed and traced
    static const Results all = [] {
        Results found{};
        for (const std::size_t n : {256u, 1024u, 4096u, 16384u, 65536u, 262144u, 1000000u}) {
            found.rows.push_back({n, {rate<LinearSearch>(n), rate<FreeList>(n), rate<SwapPop>(n)}});
            found.memory = std::max(found.memory, bandwidth());
        }
        return found;
    }();
    return all;
}

void print_pools(std::ostream &out) {
    const auto &[memory, rows] = results();
    const auto digits = [](double x) { return course::digits(x, x < 100 ? 2 : 3); };
    out << "Millions of particles per second, and what fraction that is of what memory can deliver (" << digits(memory)
        << " GB/s):\n"
        << row({{"particles", 11}, {"linear search", 17}, {"free list", 17}, {"swap-and-pop", 0}});
    for (const auto &[count, rates] : rows) {
        std::array<std::string, 3> cells;
        for (std::size_t i = 0; i < 3; ++i)
            cells[i] = digits(rates[i]) + "  " + digits(0.1 * rates[i] * bytes[i] / memory) + " %";
        out << row({{std::to_string(count), 11}, {cells[0], 17}, {cells[1], 17}, {cells[2], 0}});
    }
}

void trace_pools(std::ostream &out) {
    const auto &[memory, rows] = results();
    out << std::setprecision(4); // a measurement has no more digits
    out << "# particles[1]\tlinear search[1e6/s]\tfree list[1e6/s]\tswap and pop[1e6/s]\tmemory[1e6/s]\n";
    for (const auto &[count, rates] : rows) {
        out << count;
        for (const double rate : rates) out << '\t' << rate;
        out << '\t' << 1e3 * memory / bytes[2] << '\n';
    }
}

//> Main of the benchmark
int main(int argc, char **argv) {
    return course::run(argc, argv, {{"pools", print_pools}, {"11_particles_measured_pools.tsv", trace_pools}});
}
