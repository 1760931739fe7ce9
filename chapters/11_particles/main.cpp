#include "../program.hpp"

#include "particles.hpp"

#include <array>
#include <cstdint>
#include <random>

using namespace particles;
using course::row, course::text;

//> Random numbers
/// Random numbers, at least 0 and less than 1, the same on every machine: C++ specifies this generator bit by bit.
class Random {
  public:
    explicit Random(std::uint64_t seed) : engine{seed} {}
    double one() { return std::ldexp(double(engine() >> 11), -53); } // its upper 53 bits, times 2^-53
    std::vector<double> many(int count) {
        std::vector<double> numbers;
        for (int i = 0; i < count; ++i) numbers.push_back(one());
        return numbers;
    }

  private:
    std::mt19937_64 engine;
};

//> A pool of three
void print_pool(std::ostream &out) {
    const Particle spark{.position = {3, 7}, .velocity = {-2, 5}, .age = 0, .life = 4};
    Pool pool(3);
    out << row({{"start", 7}, {"does it fit?", 14}, {"slots", 0}});
    for (int i = 1; i <= 4; ++i) {
        const auto after = spawn(pool, spark);
        if (after) pool = *after;
        std::string slots;
        for (const auto &slot : pool) slots += slot ? '*' : '.';
        out << row({{text(i), 7}, {after ? "yes" : "no, full", 14}, {slots, 0}});
    }
}

//> Shades
void print_shades(std::ostream &out) {
    out << row({{"age [s]", 9}, {"life [s]", 10}, {"shade, of 16", 0}});
    for (const double age : {0.0, 0.18, 0.1875, 1.5, 2.9, 3.0}) {
        const auto found = shade_index(age, 3, 16);
        out << row({{text(age), 9}, {"3", 10}, {found ? text(*found) : "dead", 0}});
    }
}

//> Off the top
void print_steps(std::ostream &out) {
    const World screen{.gravity = 0.1, .wind = 0, .width = 640, .height = 480}; // a row is a metre, a frame a second
    std::optional<Particle> now = Particle{.position = {10, 459}, .velocity = {0, 5}, .age = 0, .life = 90};
    out << row({{"frame", 7}, {"position", 13}, {"velocity", 0}});
    for (int frame = 0; frame <= 5; ++frame) {
        out << row({{text(frame), 7}, {now ? text(now->position) : "dead", 13}, {now ? text(now->velocity) : "", 0}});
        if (now) now = step(*now, screen, 1);
    }
}

//> How fast are they?
/// Speeds of 40000 particles, as fractions of the maximum: spread evenly, a random number as the speed, and as printed.
std::array<std::vector<double>, 3> speeds() {
    Random random{11};
    std::array<std::vector<double>, 3> found;
    for (int i = 0; i < 40000; ++i) {
        const std::vector<double> random_numbers = random.many(2);
        found[0].push_back(disc_burst(random_numbers, 1).at(0).norm());
        found[1].push_back(random_numbers[0]);                           // the usual mistake
        found[2].push_back((2 + std::floor(4 * random_numbers[0])) / 5); // 2, 3, 4 or 5 of 5
    }
    return found;
}

void print_speeds(std::ostream &out) {
    out << row({{"slower than", 13}, {"of the area", 13}, {"disc_burst", 12}, {"random speed", 14}, {"as printed", 0}});
    const auto found = speeds();
    for (const double share : {0.25, 0.39, 0.5, 0.75, 0.9}) {
        std::array<std::string, 3> percent;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto slower = std::count_if(found[i].begin(), found[i].end(), [&](double v) { return v < share; });
            percent[i] = text(std::round(100 * double(slower) / 40000)) + " %";
        }
        const std::string area = text(std::round(100 * share * share)) + " %";
        out << row({{text(share), 13}, {area, 13}, {percent[0], 12}, {percent[1], 14}, {percent[2], 0}});
    }
}

//> Ten seconds
void print_emission(std::ostream &out) {
    out << row({{"frames per second", 17}, {"emitted in 10 s at 45 per second", 0}});
    for (const int frames : {24, 30, 60, 144}) {
        Emission now{};
        int total = 0;
        for (int frame = 0; frame < 10 * frames; ++frame) {
            now = emission_count(45, now.remainder, 1.0 / frames);
            total += now.count;
        }
        out << row({{text(frames), 17}, {text(total), 0}});
    }
}

//> Bounces
void print_bounces(std::ostream &out) {
    const std::vector<Wall> walls{{.start = {0, 0}, .end = {20, 0}}, {.start = {20, 0}, .end = {11, 12}}};
    out << row({{"restitution", 13}, {"position after 3.5 s", 22}, {"velocity", 0}});
    for (const double e : {1.0, 0.5, 0.0}) {
        const Particle after =
            move_and_collide({.position = {4, 3}, .velocity = {4, -2}, .age = 0, .life = 9}, walls, e, 3.5);
        out << row({{text(e), 13}, {text(after.position), 22}, {text(after.velocity), 0}});
    }
}

//> No gaps
void print_compacted(std::ostream &out) {
    std::vector<Particle> pool;
    for (int i = 0; i < 6; ++i) pool.push_back({{double(i), 0}, {0, 0}, i == 1 || i == 5 ? 2.0 : 1.0, 2}); // 1, 5: dead
    const auto names = [](const std::vector<Particle> &particles) {
        std::string line;
        for (const Particle &p : particles) line += (line.empty() ? "" : " ") + text(p.position.x());
        return line;
    };
    out << row({{"pool", 13}, {"of which dead", 15}, {"newborn", 9}, {"room for 6", 0}});
    const std::vector<Particle> newborn{{{7, 0}, {0, 0}, 0, 2}, {{8, 0}, {0, 0}, 0, 2}};
    out << row({{names(pool), 13}, {"1 5", 15}, {names(newborn), 9}, {names(compact_pool(pool, newborn, 6)), 0}});
}

//> A firework
void trace_firework(std::ostream &out) {
    const World night{.gravity = 9.81, .wind = 0.5, .width = 48, .height = 30};
    const double dt = 1.0 / 60;
    Random random{2002};
    std::vector<std::vector<Particle>> paths; // of each spark, a frame a point
    const auto add = [&](const Particle &spark) {
        paths.push_back({spark});
        while (const auto next = step(paths.back().back(), night, dt)) paths.back().push_back(*next);
    };

    Particle rocket{.position = {28, 0.5}, .velocity = {1, 19}, .age = 0, .life = 1.8};
    Emission now{};
    while (const auto next = step(rocket, night, dt)) {
        rocket = *next;
        now = emission_count(30, now.remainder, dt);
        for (int i = 0; i < now.count; ++i)
            add(emit({rocket.position, 0.1 * rocket.velocity, 0.1, 0.5, 0.2, 0.6}, random.many(5)));
    }
    for (const Vec2 &velocity : disc_burst(random.many(2 * 40), 9)) // fast ones, slow ones, all of the disc
        add({.position = rocket.position, .velocity = rocket.velocity + velocity, .age = 0, .life = 1.6});
    for (const Vec2 &velocity : ring_burst(12, 13, 0.2)) // and a ring around them
        add({.position = rocket.position, .velocity = rocket.velocity + velocity, .age = 0, .life = 1.2});

    out << "# age[s]\tx[m]\ty[m]\tshade[1]\n";
    for (const std::vector<Particle> &path : paths) {
        for (std::size_t i = 0; i < path.size(); i += 4) {
            const auto &[position, velocity, age, life] = path[i];
            out << age << '\t' << position.x() << '\t' << position.y() << '\t' << shade_index(age, life, 4).value()
                << '\n';
        }
        out << '\n';
    }
}

//> Three explosions
void trace_discs(std::ostream &out) {
    Random random{5};
    out << "# even x[1]\teven y[1]\trandom x[1]\trandom y[1]\tprinted x[1]\tprinted y[1]\n";
    for (int i = 0; i < 600; ++i) {
        const std::vector<double> random_numbers = random.many(2);
        const Vec2 even = disc_burst(random_numbers, 1).at(0), direction = even.normalized();
        const Vec2 at_random = random_numbers[0] * direction,
                   printed = (2 + std::floor(4 * random_numbers[0])) / 5 * direction;
        out << even.x() << '\t' << even.y() << '\t' << at_random.x() << '\t' << at_random.y() << '\t' << printed.x()
            << '\t' << printed.y() << '\n';
    }
}

//> Densities
void trace_density(std::ostream &out) {
    const auto found = speeds();
    out << "# share of the disc[1]\tdisc_burst[1]\trandom speed[1]\tas printed[1]\n";
    for (int bin = 0; bin < 20; ++bin) { // each a ring with a twentieth of the area
        out << (bin + 0.5) / 20;
        for (const std::vector<double> &speed : found) {
            const auto in_bin = [&](double v) { return std::min(int(20 * v * v), 19) == bin; };
            out << '\t' << double(std::count_if(speed.begin(), speed.end(), in_bin)) / (40000 / 20);
        }
        out << '\n';
    }
}

//> Energy
void trace_energy(std::ostream &out) {
    const std::vector<Vec2> cave{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};
    std::vector<Wall> walls;
    for (std::size_t i = 0; i < cave.size(); ++i) walls.push_back({cave[i], cave[(i + 1) % cave.size()]});

    const std::array restitutions{1.0, 0.9, 0.7, 0.4};
    std::array<Particle, 4> sparks;
    sparks.fill({.position = {2, 3}, .velocity = {7, 3.4}, .age = 0, .life = 60});
    out << "# t[s]\te = 1[1]\te = 0.9[1]\te = 0.7[1]\te = 0.4[1]\n";
    for (int frame = 0; frame <= 200; ++frame) {
        out << frame / 20.0;
        for (std::size_t i = 0; i < 4; ++i) {
            out << '\t' << sparks[i].velocity.squaredNorm() / Vec2{7, 3.4}.squaredNorm(); // of the energy at the start
            sparks[i] = move_and_collide(sparks[i], walls, restitutions[i], 1.0 / 20);
        }
        out << '\n';
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"pool", print_pool},
                        {"shades", print_shades},
                        {"steps", print_steps},
                        {"speeds", print_speeds},
                        {"rate", print_emission},
                        {"bounces", print_bounces},
                        {"compact", print_compacted},
                        {"11_particles_firework.tsv", trace_firework},
                        {"11_particles_discs.tsv", trace_discs},
                        {"11_particles_density.tsv", trace_density},
                        {"11_particles_energy.tsv", trace_energy}});
}
