#include "../program.hpp"

#include "game.hpp"

#include <algorithm>
#include <array>

using namespace particles;
using course::row, course::text;

//> A pool of three
void print_pool(std::ostream &out) {
    const Particle spark{.position = {3, 7}, .velocity = {-2, 5}, .age = 0, .life = 4};
    Pool pool(3);
    out << row({{"spawn", 7}, {"does it fit?", 14}, {"slots", 0}});
    for (int i = 1; i <= 4; ++i) {
        const auto free = free_slot(pool);
        if (free) pool[*free] = spark;
        std::string slots;
        for (const auto &slot : pool) slots += slot ? '*' : '.';
        out << row({{text(i), 7}, {free ? "yes" : "no, full", 14}, {slots, 0}});
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

//> Three sparks fly
void print_sparks(std::ostream &out) {
    const World night{.gravity = 9.81, .wind = 0, .width = 10, .height = 6};
    Pool pool(5);
    out << row({{"time [s]", 10}, {"slots", 7}, {"position in slot 2", 0}});
    for (int frame = 0; frame <= 96; ++frame) {
        next_frame(pool, frame == 0 ? three_sparks({2, 1}) : std::vector<Particle>{}, night, 1.0 / 64);
        if (frame % 48 != 0) continue;
        std::string slots;
        for (const auto &slot : pool) slots += slot ? '*' : '.';
        out << row({{text(frame / 64.0), 10}, {slots, 7}, {pool[2] ? text(pool[2]->position) : "free", 0}});
    }
}

//> How many slots does a show need?
void print_slots(std::ostream &out) {
    const World still{.gravity = 0, .wind = 0, .width = 1, .height = 1}; // only age kills
    const Particle spark{.position = {0, 0}, .velocity = {0, 0}, .age = 0, .life = 2.5};
    out << row({{"slots", 7}, {"lost, of 400", 0}});
    for (const std::size_t slots : {100u, 119u, 120u}) {
        Pool pool(slots);
        int found = 0;
        for (int frame = 0; frame < 640; ++frame) { // ten seconds
            next_frame(pool, std::vector(frame % 64 == 0 ? 40 : 0, spark), still, 1.0 / 64);
            for (const auto &slot : pool)
                if (slot && slot->age == 0) ++found;
        }
        out << row({{text(double(slots)), 7}, {text(400 - found), 0}});
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

//> One spark per frame
void print_trail(std::ostream &out) {
    const World night{.gravity = 9.81, .wind = 0, .width = 48, .height = 30};
    out << row({{"frames per second", 19}, {"sparks behind the rocket after 1 s", 0}});
    for (const int frames : {30, 60, 144}) {
        Random random{6};
        Particle rocket{.position = {24, 0}, .velocity = {0, 19}, .age = 0, .life = 9};
        Pool pool(200);
        for (int frame = 0; frame < frames; ++frame) {
            rocket = step(rocket, night, 1.0 / frames).value();
            next_frame(pool, {emit(engine_of(rocket), random.many(5))}, night, 1.0 / frames);
        }
        const auto sparks = std::count_if(pool.begin(), pool.end(), [](const auto &slot) { return slot.has_value(); });
        out << row({{text(frames), 19}, {text(double(sparks)), 0}});
    }
}

//> Ten seconds
void print_emission(std::ostream &out) {
    out << row({{"frames per second", 19}, {"emitted in 10 s at 45 per second", 0}});
    for (const int frames : {24, 30, 60, 144}) {
        Emission now{};
        int total = 0;
        for (int frame = 0; frame < 10 * frames; ++frame) {
            now = emission_count(45, now.remainder, 1.0 / frames);
            total += now.count;
        }
        out << row({{text(frames), 19}, {text(total), 0}});
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

//> A spark on a roof
void print_roof(std::ostream &out) {
    const std::vector<Wall> roof{{.start = {0, 1}, .end = {10, 1}}};
    const World calm{.gravity = 9.81, .wind = 0, .width = 10, .height = 10};
    Particle spark{.position = {5, 4.2}, .velocity = {0, 0}, .age = 0, .life = 60};
    double highest = 3.2; // above the roof
    out << row({{"bounces", 9}, {"rises above the roof [m]", 0}});
    for (int bounces = 0; bounces < 4;) {
        const Particle next = step(spark, calm, roof, 1e-4).value();
        highest = std::max(highest, next.position.y() - 1);
        if (spark.velocity.y() < 0 && next.velocity.y() > 0) { // it has bounced
            out << row({{text(bounces++), 9}, {text(std::round(100 * highest) / 100), 0}});
            highest = 0;
        }
        spark = next;
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

//> Two pools, one show
void print_two(std::ostream &out) {
    const World still{.gravity = 0, .wind = 0, .width = 1, .height = 1}; // only age kills
    const Particle spark{.position = {0, 0}, .velocity = {0, 0}, .age = 0, .life = 2.5};
    Pool pool(120);
    std::vector<Particle> gapless;
    out << row({{"time [s]", 10}, {"sparks in slots", 17}, {"sparks without gaps", 0}});
    for (int frame = 0; frame <= 192; ++frame) {
        const std::vector newborn(frame % 64 == 0 ? 40 : 0, spark);
        next_frame(pool, newborn, still, 1.0 / 64);
        next_frame(gapless, newborn, 120, still, 1.0 / 64);
        if (frame % 48 != 0) continue;
        const auto alive = std::count_if(pool.begin(), pool.end(), [](const auto &slot) { return slot.has_value(); });
        out << row({{text(frame / 64.0), 10}, {text(double(alive)), 17}, {text(double(gapless.size())), 0}});
    }
}

//> How a pool is drawn
/// The place of each spark at this moment, and which of four shades it shows.
void trace_pool(std::ostream &out, const Pool &pool) {
    for (const auto &slot : pool)
        if (slot)
            out << slot->age << '\t' << slot->position.x() << '\t' << slot->position.y() << '\t'
                << shade_index(slot->age, slot->life, 4).value() << '\n';
}

const World night{.gravity = 9.81, .wind = 0.5, .width = 48, .height = 30};

//> The first firework
void trace_first(std::ostream &out) {
    Random random{5};
    const Particle rocket{.position = {24, 19}, .velocity = {0, 3}, .age = 0, .life = 1};
    Pool pool(300);
    out << "# age[s]\tx[m]\ty[m]\tshade[1]\n";
    for (int frame = 0; frame < 90; ++frame) {
        const int sparks = frame == 0 ? 300 : 0;
        next_frame(pool, burst(rocket, box_burst(random, sparks, 9), 1.5), night, 1.0 / 60);
        if (frame == 18 || frame == 42 || frame == 60 || frame == 84) trace_pool(out, pool);
    }
}

//> The whole firework
void trace_firework(std::ostream &out) {
    const double dt = 1.0 / 60;
    Random random{2002};
    std::optional<Particle> rocket = Particle{.position = {28, 0.5}, .velocity = {1, 19}, .age = 0, .life = 1.8};
    Emission emission;
    Pool pool(100);
    out << "# age[s]\tx[m]\ty[m]\tshade[1]\n";
    for (int frame = 0; frame < 205; ++frame) {
        std::vector<Particle> newborn;
        if (rocket) {
            const auto next = step(*rocket, night, dt);
            if (next) {
                newborn = trail(*next, emission, random, dt);
            } else { // its life is over: a filled disc, and a ring around it
                newborn = burst(*rocket, disc_burst(random.many(2 * 60), 9), 1.6);
                for (const Particle &spark : burst(*rocket, ring_burst(24, 13, 0.2), 1.2)) newborn.push_back(spark);
            }
            rocket = next;
        }
        next_frame(pool, newborn, night, dt);
        if (frame % 6 == 0) trace_pool(out, pool);
    }
}

//> Three bursts
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

//> A disc in quarters
/// The sparks of one burst, as fractions of the fastest.
void trace_area(std::ostream &out) {
    Random random{5};
    out << "# x[1]\ty[1]\n";
    for (const Vec2 &spark : disc_burst(random.many(800), 1)) out << spark.x() << '\t' << spark.y() << '\n';
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

//> Slots
/// Two pools, before and after a particle is spawned: the slot, the row, and what the slot holds (0: nothing, 1: a
/// particle from before, 2: the new one).
void trace_slots(std::ostream &out) {
    const Particle old{.position = {0, 0}, .velocity = {0, 0}, .age = 1, .life = 2};
    const Particle young{.position = {0, 0}, .velocity = {0, 0}, .age = 0, .life = 2};
    const Pool before{old, std::nullopt, old, std::nullopt, old};
    Pool after = before;
    after[free_slot(before).value()] = young;
    out << "# slot[1]\trow[1]\tholds[1]\n";
    int line = 0;
    for (const Pool &pool : {before, after}) {
        for (std::size_t i = 0; i < pool.size(); ++i)
            out << i << '\t' << line << '\t' << (!pool[i] ? 0 : pool[i]->age > 0 ? 1 : 2) << '\n';
        ++line;
    }
}

//> A ramp of shades
void trace_ramp(std::ostream &out) {
    out << "# age[s]\tshade[1]\n";
    for (int i = 0; i < 320; ++i) {
        const double age = i * 0.01;
        const auto shade = shade_index(age, 3, 16);
        if (shade) out << age << '\t' << *shade << '\n';
    }
}

//> Four frames
/// Four frames of 1/4 s at 10 particles per second: the remainder from before, what the frame adds, how many are emitted,
/// and the remainder after it.
void trace_frames(std::ostream &out) {
    out << "# frame[1]\tbefore[1]\tcount[1]\tafter[1]\n";
    Emission now;
    for (int frame = 1; frame <= 4; ++frame) {
        const double before = now.remainder;
        now = emission_count(10, before, 0.25);
        out << frame << '\t' << before << '\t' << now.count << '\t' << now.remainder << '\n';
    }
}

//> A bounce in parts
/// Arrows: from where, and how far. The velocity before, its part along the wall, its part along the normal; the same
/// after a bounce with restitution 0.5.
void trace_bounce(std::ostream &out) {
    const Vec2 along{0.8, 0.6}, normal{-0.6, 0.8};
    const std::vector<Wall> wall{{.start = -5 * along, .end = 5 * along}};
    const Vec2 before{4, -2};
    const Particle falling{.position = -before, .velocity = before, .age = 0, .life = 9};
    const Vec2 after = move_and_collide(falling, wall, 0.5, 2).velocity;
    out << "# x[m]\ty[m]\tvx[m/s]\tvy[m/s]\n";
    for (const Vec2 &v : {before, after}) {
        const Vec2 from = v == before ? Vec2{-before} : Vec2{0, 0};
        for (const Vec2 &part : {v, Vec2{v.dot(along) * along}, Vec2{v.dot(normal) * normal}})
            out << from.x() << '\t' << from.y() << '\t' << part.x() << '\t' << part.y() << '\n';
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
                        {"sparks", print_sparks},
                        {"slots", print_slots},
                        {"speeds", print_speeds},
                        {"trail", print_trail},
                        {"rate", print_emission},
                        {"bounces", print_bounces},
                        {"roof", print_roof},
                        {"compact", print_compacted},
                        {"two", print_two},
                        {"11_particles_slots.tsv", trace_slots},
                        {"11_particles_ramp.tsv", trace_ramp},
                        {"11_particles_first.tsv", trace_first},
                        {"11_particles_firework.tsv", trace_firework},
                        {"11_particles_discs.tsv", trace_discs},
                        {"11_particles_area.tsv", trace_area},
                        {"11_particles_density.tsv", trace_density},
                        {"11_particles_frames.tsv", trace_frames},
                        {"11_particles_bounce.tsv", trace_bounce},
                        {"11_particles_energy.tsv", trace_energy}});
}
