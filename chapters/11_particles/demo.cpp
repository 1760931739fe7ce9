#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace particles;
using demo::Colour, demo::Input, demo::Shape;

enum Burst { three, box, ring, disc, mistake_beside_disc };
enum Trail { none, one_a_frame, at_a_rate };
enum Loop { open_sky, among_walls, without_gaps };

const demo::About about{
    "A rocket leaves a trail of sparks and bursts. It follows the pointer; a click is a burst.",
    {0, 0},
    {24, 14},
    {demo::choice("A burst",
                  {"three sparks", "a first try", "a ring (11.4)", "a disc (11.5)", "disc and usual mistake"}, disc),
     demo::choice("The trail", {"none", "one a frame (11.6)", "30 per second (11.7)"}, at_a_rate),
     demo::choice("The loop", {"open sky", "with walls (11.8)", "without gaps (11.9)"}, open_sky),
     {"gravity", "m/s²", -5, 15, 0.1, 4},
     {"wind", "m/s²", -5, 5, 0.1, 0.5},
     {"frames per second", "", 5, 144, 1, 60}},
    {{"x", "Burst"}}};
const demo::Still still{8.1};

constexpr int slots = 500;
const std::vector<Wall> walls{{.start = {0, 1.5}, .end = {17, 1.5}}, {.start = {17, 1.5}, .end = {24, 7}}};

struct State {
    Pool pool = Pool(slots);
    std::vector<Particle> packed; // in place of the pool, if there are no gaps
    Particle rocket{.position = {12, 7}, .velocity = {0, 0}, .age = 0, .life = 1};
    Random random{11};
    Emission emission;
    double time{}, spare{}, next_burst{0.5};
    bool touched{}; // until then the rocket flies a show of its own
};

State begin() { return {}; }

/// The usual mistake: a random number is the speed, as it comes. So half of the sparks are in a quarter of the disc.
std::vector<Vec2> mistaken_disc(Random &random, int count, double max_speed) {
    std::vector<Vec2> velocities;
    for (int i = 0; i < count; ++i) {
        const double speed = max_speed * random.one(), angle = 6.283185307179586 * random.one();
        velocities.push_back({speed * std::cos(angle), speed * std::sin(angle)});
    }
    return velocities;
}

std::vector<Particle> sparks_of(Burst kind, State &now, const Vec2 &place) {
    Particle at{.position = place, .velocity = {0, 0}, .age = 0, .life = 1};
    switch (kind) {
    case three: return three_sparks(place);
    case box: return burst(at, box_burst(now.random, 100, 5), 1.6);
    case ring: return burst(at, ring_burst(48, 5, 0), 1.6);
    case disc: return burst(at, disc_burst(now.random.many(200), 5.5), 1.6);
    case mistake_beside_disc: break;
    }
    at.position.x() = std::clamp(place.x(), 8.0, 16.0) - 4; // both are in the picture
    std::vector<Particle> sparks = burst(at, disc_burst(now.random.many(200), 3), 1.6);
    at.position.x() += 8;
    for (const Particle &spark : burst(at, mistaken_disc(now.random, 100, 3), 1.6)) sparks.push_back(spark);
    return sparks;
}

void spawn_all(State &now, const std::vector<Particle> &newborn) {
    for (const Particle &spark : newborn)
        if (const auto slot = free_slot(now.pool)) now.pool[*slot] = spark;
}

void one_frame(State &now, const Input &in, double dt) {
    now.time += dt;
    const Vec2 before = now.rocket.position;
    if (!now.touched) now.rocket.position = {12 + 8 * std::sin(0.9 * now.time), 7 + 4 * std::sin(1.3 * now.time)};
    else if (in.inside || in.handle >= 0) now.rocket.position = in.pointer.cwiseMax(about.low).cwiseMin(about.high);
    now.rocket.velocity = (now.rocket.position - before) / dt;

    std::vector<Particle> newborn;
    const auto kind = static_cast<Trail>(in["The trail"]);
    if (kind == one_a_frame) newborn.push_back(emit(engine_of(now.rocket), now.random.many(5)));
    if (kind == at_a_rate) newborn = trail(now.rocket, now.emission, now.random, dt);
    if (!now.touched && now.time >= now.next_burst) {
        now.next_burst += 1.4;
        for (const Particle &spark : sparks_of(static_cast<Burst>(in["A burst"]), now, now.rocket.position))
            newborn.push_back(spark);
    }
    const World world{in["gravity"], in["wind"], about.high.x(), about.high.y()};
    switch (static_cast<Loop>(in["The loop"])) {
    case open_sky: return next_frame(now.pool, newborn, world, dt);
    case without_gaps: return next_frame(now.packed, newborn, slots, world, dt);
    case among_walls:
        for (auto &slot : now.pool)
            if (slot) slot = step(*slot, world, walls, dt);
        spawn_all(now, newborn);
    }
}

State next(State now, const Input &in) {
    now.touched = now.touched || in.inside || in.pressed || in.handle >= 0;
    const bool gaps = static_cast<Loop>(in["The loop"]) != without_gaps;
    if (gaps) { // if the loop was changed, the sparks go on in the other one
        spawn_all(now, now.packed);
        now.packed.clear();
    } else {
        for (auto &slot : now.pool)
            if (slot) now.packed.push_back(*slot), slot.reset();
    }
    if (in.pressed || in.key == "x") {
        const std::vector<Particle> sparks =
            sparks_of(static_cast<Burst>(in["A burst"]), now, in.pressed ? in.pointer : now.rocket.position);
        if (gaps) spawn_all(now, sparks);
        else now.packed = compact_pool(now.packed, sparks, slots);
    }
    const double dt = 1 / in["frames per second"];
    for (int due = demo::steps_due(now.spare, in, dt); due > 0; --due) one_frame(now, in, dt);
    return now;
}

/// Two rows of dots, one for each slot: those that are taken, or those that are free.
std::vector<Vec2> slots_that_are(bool taken, const State &now) {
    std::vector<Vec2> dots;
    for (int i = 0; i < slots; ++i)
        if ((now.pool[std::size_t(i)] || std::size_t(i) < now.packed.size()) == taken)
            dots.push_back({0.5 + 0.092 * (i % 250), i < 250 ? 0.7 : 0.4});
    return dots;
}

demo::Picture draw(const State &now, const Input &in) {
    constexpr int shades = 8;
    constexpr Colour colours[]{Colour::amber, Colour::orange, Colour::pink, Colour::violet};
    std::vector<Particle> alive = now.packed;
    for (const auto &slot : now.pool)
        if (slot) alive.push_back(*slot);
    std::vector<Vec2> sparks[shades];
    for (const Particle &spark : alive) {
        const auto shade = shade_index(spark.age, spark.life, shades);
        if (shade && *shade >= 0 && *shade < shades) sparks[*shade].push_back(spark.position);
    }
    demo::Picture seen{{{Shape::discs, Colour::line, 0.03, 1, slots_that_are(false, now)},
                        {Shape::discs, Colour::blue, 0.035, 1, slots_that_are(true, now)}}};
    if (static_cast<Loop>(in["The loop"]) == among_walls)
        for (const Wall &wall : walls)
            seen.shapes.push_back({Shape::line, Colour::dim, 2.5, 1, {wall.start, wall.end}});
    for (int i = shades - 1; i >= 0; --i) {
        if (i < 3) seen.shapes.push_back({Shape::discs, colours[i / 2], 0.2, 0.12, sparks[i]}); // a glow
        seen.shapes.push_back({Shape::discs, colours[i / 2], 0.1 - 0.005 * i, 1 - 0.07 * i, sparks[i]});
    }
    seen.shapes.push_back({Shape::handle, Colour::ink, 0, 1, {now.rocket.position}});
    seen.readouts = {{"alive", "sparks", double(alive.size()), 0},
                     {"free", "slots", double(slots) - double(alive.size()), 0},
                     {"time", "s", now.time, 1}};
    return seen;
}
} // namespace play
