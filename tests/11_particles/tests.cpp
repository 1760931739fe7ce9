#include "section_test.hpp"

#include "particles.hpp"

#include <algorithm>
#include <array>
#include <optional>

using particles::Emission, particles::Emitter, particles::Particle, particles::Pool, particles::Wall, particles::World;
using particles::max_bounces, particles::contact_tolerance;
using namespace particles::subject; // free_slot, shade_index, ...: the student's functions

// An answer is right to 1e-12, or to 1e-12 of the largest number that goes into it if that's more than 1; after n
// terms, bounces or added angles, to n times that. Where rounding decides which of two shades it is, whether a particle
// is dead, or whether one more is whole, either is right; `shades` itself never is. move_and_collide leaves three cases
// open: a wall that the particle reaches at the very end of dt, one that it meets within contact_tolerance of an end,
// and one so nearly parallel to its path that intersect_lines returns nothing.

constexpr double rounding_of_1e5 = 1e-7; // where numbers as large as that go into a result
constexpr double pi = std::numbers::pi;
constexpr int more_than_16_bits = 70'000; // particles or walls: an index must not wrap at 65536

namespace {

const Particle spark{.position = {3, 7}, .velocity = {-2, 5}, .age = 0.5, .life = 4};
const std::optional<Particle> dead;
const std::optional<int> no_shade;
const std::optional<int> no_slot;

/// A particle that differs from every other one.
Particle numbered(int i) {
    return {.position = {i + 0.25, 2.0 * i}, .velocity = {-i - 0.5, i / 4.0}, .age = 0.125 * i, .life = 100.0 + i};
}

/// Whether two particles are the same in every field, to the last bit.
bool same(const Particle &a, const Particle &b) {
    return a.position == b.position && a.velocity == b.velocity && a.age == b.age && a.life == b.life;
}

/// Valid particles, though unusual: at the limits of the range, at rest, dead, or with a tiny life.
const std::vector<Particle> unusual{{{1e5, -1e5}, {-1e5, 1e5}, 0, 1e5}, {{-1e5, 1e5}, {1e5, -1e5}, 1e5, 1e-7},
                                    {{0.1, 0.2}, {0, 0}, -0.0, 5},      {{0.1, 0.2}, {0.3, -0.7}, 3, 3},
                                    {{-3, 1e5}, {0, -1e5}, 90, 3},      {{3, 7}, {1e-10, 0}, 0, 1e-300}};

/// Calls with a particle whose age or life is invalid, and checks that each is refused.
template <class Call> void check_age_and_life_refused(const Particle &good, const Call &call) {
    for (const double age : {-0.1, -1e-9, -1e-300})
        CHECK_REFUSED(call({good.position, good.velocity, age, good.life}), "age is negative");
    for (const double life : {-4.0, -1e-9, 0.0})
        CHECK_REFUSED(call({good.position, good.velocity, good.age, life}), "life is not positive");
}

} // namespace

// ------------------------------------------------------------------------------------------------------ 11.1 free_slot

namespace {

/// A pool of `size` slots, all of which hold a particle except those in `free`.
Pool pool_with_free(int size, const std::vector<int> &free) {
    Pool pool;
    for (int i = 0; i < size; ++i) pool.emplace_back(numbered(i));
    for (const int i : free) pool[std::size_t(i)].reset();
    return pool;
}

} // namespace

//> One slot is free
TEST_CASE("the only free slot is found, wherever it is", "[11.1]") {
    const int slot = GENERATE(1, 3, 0, 4); // two in the middle, the first, the last
    Pool pool(5, Particle{.position = {0, 0}, .velocity = {1, 2}, .life = 1});
    pool[std::size_t(slot)].reset();
    CHECK_THAT(free_slot(pool), IsNear(std::optional{slot}));
}

//>
TEST_CASE("of several free slots, any one will do", "[11.1]") {
    const std::vector<int> free = GENERATE(std::vector{0, 1, 2, 3, 4}, std::vector{1, 3}, std::vector{2, 3, 4});
    const int slot = free_slot(pool_with_free(5, free)).value();
    CHECK_THAT(std::ranges::count(free, slot) == 1, IsTrue("the slot is one of those that are free"));
}

//> Full
TEST_CASE("a full pool has no free slot", "[11.1]") {
    const int size = GENERATE(5, 1, 2, 128);
    CHECK_THAT(free_slot(pool_with_free(size, {})), IsNear(no_slot));
    CHECK_THAT(free_slot({}), IsNear(no_slot)); // no slot at all
}

//> 128 of them
TEST_CASE("128 slots hold 128 particles and no more, and a slot that is freed is used again", "[11.1]") {
    Pool pool(128);
    for (int i = 0; i < 128; ++i) {
        const int slot = free_slot(pool).value();
        CHECK_THAT(slot >= 0 && slot < 128, IsTrue("there is such a slot"));
        CHECK_THAT(!pool[std::size_t(slot)].has_value(), IsTrue("the slot is free"));
        pool[std::size_t(slot)] = numbered(i);
    }
    CHECK_THAT(free_slot(pool), IsNear(no_slot));

    const int freed = GENERATE(0, 77, 127);
    pool[std::size_t(freed)].reset();
    CHECK_THAT(free_slot(pool), IsNear(std::optional{freed}));
}

//>
TEST_CASE("what the particles in a pool are like doesn't matter", "[11.1]") {
    for (const Particle &particle : unusual) {
        CHECK_THAT(free_slot({particle, std::nullopt}), IsNear(std::optional{1}));
        CHECK_THAT(free_slot({particle}), IsNear(no_slot));
    }
    CHECK_THAT(free_slot({Particle{{1e5, -1e5}, {3, 4}, -1, -1}, std::nullopt, Particle{{0.1, 0.2}, {3, 4}, 7, 2}}),
               IsNear(std::optional{1}));
}

TEST_CASE("a dead particle keeps its slot", "[11.1]") {
    const Particle just_dead{.position = {1, 2}, .velocity = {3, 4}, .age = 2, .life = 2};
    const Particle long_dead{.position = {1, 2}, .velocity = {3, 4}, .age = 7, .life = 2};
    CHECK_THAT(free_slot({just_dead, std::nullopt, long_dead}), IsNear(std::optional{1}));
    CHECK_THAT(free_slot({just_dead, long_dead}), IsNear(no_slot));
}

TEST_CASE("the only free slot of 70000 is found", "[11.1]") {
    Pool pool(more_than_16_bits, spark);
    pool.back().reset();
    CHECK_THAT(free_slot(pool), IsNear(std::optional{more_than_16_bits - 1}));
}

// ---------------------------------------------------------------------------------------------------- 11.2 shade_index

//> Sixteen shades
TEST_CASE("the worked example: with a life of 3 s each of 16 shades is shown for 3/16 s", "[11.2]") {
    CHECK_THAT(shade_index(0, 3, 16), IsNear(std::optional{0}));
    CHECK_THAT(shade_index(0.18, 3, 16), IsNear(std::optional{0}));
    CHECK_THAT(shade_index(0.1875, 3, 16), IsNear(std::optional{1})); // 3/16
    CHECK_THAT(shade_index(1.5, 3, 16), IsNear(std::optional{8}));    // half its life
    CHECK_THAT(shade_index(2.8, 3, 16), IsNear(std::optional{14}).since("the last shade begins at 15 · 3/16 = 2.8125"));
    CHECK_THAT(shade_index(2.9, 3, 16), IsNear(std::optional{15}));
}

//> Dead
TEST_CASE("a particle older than its life has no shade", "[11.2]") {
    CHECK_THAT(shade_index(3.1, 3, 16), IsNear(no_shade));
    CHECK_THAT(shade_index(1e5, 3, 16), IsNear(no_shade));
}

TEST_CASE("a particle is dead, and has no shade, at the very moment when its age reaches its life", "[11.2]") {
    CHECK_THAT(shade_index(3, 3, 16), IsNear(no_shade));
    CHECK_THAT(shade_index(0.25, 0.25, 1), IsNear(no_shade));
}

//> Erratum E11.1
// 1/30 is rounded, and added up ninety times it's a little less than 3: step keeps such a particle for a frame more.
// Where that matters, count frames, and divide by 30.
TEST_CASE("erratum E11.1: a life of 90 frames lasts 90 frames, not 90 for each of 16 shades", "[11.2]") {
    int alive = 0;
    for (int frame = 0; frame < 200; ++frame)                  // in the printed code it is alive in all of them
        if (shade_index(frame / 30.0, 90 / 30.0, 16)) ++alive; // 30 frames per second
    CHECK_THAT(alive, IsNear(90).of("frames in which it shows a shade"));
}

//>
TEST_CASE("all shades are shown for the same time, for random lives and numbers of shades", "[11.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const int shades = dice.whole(1, 40), which = dice.whole(0, shades - 1);
        const double life = dice.real(0.01, 300);
        const double part = std::array{1e-10, dice.real(0.001, 0.999), 1 - 1e-10}[std::size_t(i % 3)]; // of this shade
        const double age = (which + part) * life / shades;
        CHECK_THAT(shade_index(age, life, shades), IsNear(std::optional{which}));
    }
}

TEST_CASE("at the very moment when one shade follows another, the later one is shown", "[11.2]") {
    const double life = GENERATE(1.0, 0.25, 16.0, 1024.0, 0x1p-30, 0x1p-300);
    for (int k = 0; k < 8; ++k) {
        CHECK_THAT(shade_index(k * life / 8, life, 8), IsNear(std::optional{k}));
        CHECK_THAT(shade_index(((k + 1) / 8.0 - 0x1p-45) * life, life, 8),
                   IsNear(std::optional{k})); // 3e-14 before the next
    }
}

TEST_CASE("an age and a life may be as long as 1e5 s", "[11.2]") {
    CHECK_THAT(shade_index(1e5, 2, 4), IsNear(no_shade));
    CHECK_THAT(shade_index(75'001, 1e5, 4), IsNear(std::optional{3}));
    CHECK_THAT(shade_index(74'999, 1e5, 4), IsNear(std::optional{2}));
    CHECK_THAT(shade_index(1e5, 1e5, 4), IsNear(no_shade));
    CHECK_THAT(shade_index(-0.0, 1e5, 4), IsNear(std::optional{0})); // -0 is 0
}

TEST_CASE("just before death the last shade is shown, and at age = life none", "[11.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const int shades = dice.whole(1, 40);
        const double life = dice.real(0.01, 300);
        CHECK_THAT(shade_index(std::nextafter(life, 0), life, shades), IsNear(std::optional{shades - 1}));
        CHECK_THAT(shade_index(life, life, shades), IsNear(no_shade));
    }
}

TEST_CASE("a single shade is shown for the whole life", "[11.2]") {
    CHECK_THAT(shade_index(0, 2, 1), IsNear(std::optional{0}));
    CHECK_THAT(shade_index(1.999, 2, 1), IsNear(std::optional{0}));
    CHECK_THAT(shade_index(2, 2, 1), IsNear(no_shade));
}

TEST_CASE("a billion shades are told apart", "[11.2]") {
    const int shades = 1 << 30, which = 123'456'789, most = std::numeric_limits<int>::max();
    CHECK_THAT(shade_index(2 * (which + 0.5) / shades, 2, shades), IsNear(std::optional{which}));
    CHECK_THAT(shade_index(0, 2, most), IsNear(std::optional{0}));
    CHECK_THAT(shade_index(std::nextafter(2, 0), 2, most), IsNear(std::optional{most - 1}));
}

TEST_CASE("a negative age, a life of 0 or less, and fewer than 1 shade are refused", "[11.2]") {
    for (const double age : {0.0, 1.0, 4.0}) { // unborn, alive and dead
        for (const int shades : {0, -1, -16, std::numeric_limits<int>::min()})
            CHECK_REFUSED(shade_index(age, 3, shades), "shades is less than 1");
        for (const double life : {0.0, -3.0, -1e-9}) CHECK_REFUSED(shade_index(age, life, 16), "life is not positive");
    }
    for (const double age : {-0.1, -1e-9}) CHECK_REFUSED(shade_index(age, 3, 16), "age is negative");
}

// ----------------------------------------------------------------------------------------------------------- 11.3 step

namespace {

const World world{.gravity = 10, .wind = 1, .width = 20, .height = 16};

} // namespace

//> One step
TEST_CASE("the worked example: the new velocity moves the particle from (2, 3) to (4.25, 3)", "[11.3]") {
    const Particle before{.position = {2, 3}, .velocity = {4, 5}, .age = 1, .life = 9};
    const Particle after{.position = {4.25, 3}, .velocity = {4.5, 0}, .age = 1.5, .life = 9};
    CHECK_THAT(step(before, world, 0.5),
               IsNear(std::optional{after}, rounding)
                   .since("v = (4, 5) + 0.5 (1, -10) = (4.5, 0), and (2, 3) + 0.5 v = (4.25, 3)"));
}

//>
TEST_CASE("gravity pulls down and wind blows to the right; negative values do the opposite", "[11.3]") {
    const Particle rest{.position = {5, 5}, .velocity = {0, 0}, .age = 0, .life = 9};
    const auto after = [&](double gravity, double wind) { return step(rest, {gravity, wind, 20, 16}, 0.5); };
    // after half a second of 2 m/s² the velocity is 1 m/s, and in that half second it covers 0.5 m
    CHECK_THAT(after(2, 0), IsNear(std::optional{Particle{{5, 4.5}, {0, -1}, 0.5, 9}}, rounding));
    CHECK_THAT(after(-2, 0), IsNear(std::optional{Particle{{5, 5.5}, {0, 1}, 0.5, 9}}, rounding));
    CHECK_THAT(after(0, 2), IsNear(std::optional{Particle{{5.5, 5}, {1, 0}, 0.5, 9}}, rounding));
    CHECK_THAT(after(0, -2), IsNear(std::optional{Particle{{4.5, 5}, {-1, 0}, 0.5, 9}}, rounding));
    CHECK_THAT(after(0, 0), IsNear(std::optional{Particle{{5, 5}, {0, 0}, 0.5, 9}}, rounding));
}

//> A hundred steps
TEST_CASE("after 100 steps the position is the start plus dt times the sum of all new velocities", "[11.3]") {
    const double dt = GENERATE(1.0 / 30, 1.0 / 60, 0.001);
    const World wide{.gravity = 9.81, .wind = -0.7, .width = 1000, .height = 1000};
    const Particle first{.position = {500, 600}, .velocity = {7, 11}, .age = 0, .life = 1e4};
    std::optional<Particle> now = first;
    for (int n = 1; n <= 100; ++n) {
        now = step(*now, wide, dt);
        // v grows by a dt each time, so x by n v dt and (1 + 2 + … + n) a dt²
        const Vec2 a{-0.7, -9.81};
        const Vec2 velocity = first.velocity + n * dt * a;
        const Vec2 position = first.position + n * dt * first.velocity + n * (n + 1) / 2.0 * dt * dt * a;
        CHECK_THAT(now, IsNear(std::optional{Particle{position, velocity, n * dt, 1e4}}, rounding));
    }
}

//> At the edge
TEST_CASE("erratum E11.5: a particle at x = width or y = height is dead, at 0 it is alive", "[11.3]") {
    const World still{.gravity = 0, .wind = 0, .width = 640, .height = 480};
    const auto rest = [](double x, double y, double age) { return Particle{{x, y}, {0, 0}, age, 9}; };
    const auto step_at = [&](double x, double y) { return step(rest(x, y, 0), still, 0.5); };
    const auto alive_at = [&](double x, double y) { return IsNear(std::optional{rest(x, y, 0.5)}, rounding); };
    CHECK_THAT(step_at(639.5, 100), alive_at(639.5, 100)); // the last column of pixels, from 639 to 640
    CHECK_THAT(step_at(640, 100), IsNear(dead));           // printed: alive, and not drawn
    CHECK_THAT(step_at(640.5, 100), IsNear(dead));
    CHECK_THAT(step_at(100, 479.5), alive_at(100, 479.5));
    CHECK_THAT(step_at(100, 480), IsNear(dead));
    CHECK_THAT(step_at(100, 480.5), IsNear(dead));
    CHECK_THAT(step_at(0, 100), alive_at(0, 100)); // the left and the lower edge belong to the picture
    CHECK_THAT(step_at(100, 0), alive_at(100, 0));
    CHECK_THAT(step_at(0, 0), alive_at(0, 0));
    CHECK_THAT(step_at(-1e-12, 100), IsNear(dead));
    CHECK_THAT(step_at(100, -1e-12), IsNear(dead));
    CHECK_THAT(step_at(640 - 1e-12, 100), alive_at(640 - 1e-12, 100));
    CHECK_THAT(step_at(100, 480 - 1e-12), alive_at(100, 480 - 1e-12));
    CHECK_THAT(step_at(500, 100), alive_at(500, 100)); // wider than high
    CHECK_THAT(step_at(100, 500), IsNear(dead));
}

//>
TEST_CASE("a particle that leaves the picture in this step is dead, even if it started inside", "[11.3]") {
    const World still{.gravity = 0, .wind = 0, .width = 20, .height = 16};
    CHECK_THAT(step({{19, 8}, {4, 0}, 0, 9}, still, 0.5), IsNear(dead));  // from 19 to 21
    CHECK_THAT(step({{1, 8}, {-4, 0}, 0, 9}, still, 0.5), IsNear(dead));  // to -1
    CHECK_THAT(step({{10, 15}, {0, 4}, 0, 9}, still, 0.5), IsNear(dead)); // to 17
    CHECK_THAT(step({{10, 1}, {0, -4}, 0, 9}, still, 0.5), IsNear(dead)); // to -1
    const auto comes_in = [&](Vec2 from, Vec2 velocity, Vec2 to) {
        CHECK_THAT(step({from, velocity, 0, 9}, still, 0.5),
                   IsNear(std::optional{Particle{to, velocity, 0.5, 9}}, rounding));
        CHECK_THAT(step({from, velocity, 0, 9}, still, 0), IsNear(dead)); // with dt = 0 it stays outside
    };
    comes_in({-1, 8}, {4, 0}, {1, 8});
    comes_in({21, 8}, {-4, 0}, {19, 8});
    comes_in({10, -1}, {0, 4}, {10, 1});
    comes_in({10, 17}, {0, -4}, {10, 15});
    CHECK_THAT(step({{10, 12}, {0, 10}, 0, 9}, {10, 0, 20, 16}, 1.5),
               IsNear(std::optional{Particle{{10, 4.5}, {0, -5}, 1.5, 9}}, rounding)
                   .since("it rises above the picture, but ends inside: v = 10 - 1.5 · 10 = -5, y = 12 - 1.5 · 5"));
}

//> Erratum E11.2
TEST_CASE("erratum E11.2: the printed example leaves the picture in frame 5, not after 90 frames", "[11.3]") {
    // it starts 20 rows below the top of 480 and rises 5 rows per frame; here a row is 1 m and a frame 1 s
    const double gravity = GENERATE(0.0, 0.1);
    std::optional<Particle> now = Particle{.position = {10, 479 - 20}, .velocity = {0, 5}, .age = 0, .life = 90};
    int frame = 0;
    for (; now && frame < 90; ++frame) now = step(*now, {gravity, 0, 640, 480}, 1);
    CHECK_THAT(frame, IsNear(5).of("frames until it is dead"));
}

//> At its life's end
TEST_CASE("a particle is dead as soon as its age reaches its life", "[11.3]") {
    const World still{.gravity = 0, .wind = 0, .width = 20, .height = 16};
    const auto aged = [](double age) { return Particle{{5, 5}, {0, 0}, age, 2}; };
    CHECK_THAT(step(aged(1), still, 0.75), IsNear(std::optional{aged(1.75)}, rounding));
    CHECK_THAT(step(aged(1), still, 1), IsNear(dead)); // exactly
    CHECK_THAT(step(aged(1), still, 1.25), IsNear(dead));
    CHECK_THAT(step(aged(2), still, 0), IsNear(dead)); // dead before the step
    CHECK_THAT(step(aged(3), still, 0), IsNear(dead));
    CHECK_THAT(step(aged(0), still, 0), IsNear(std::optional{aged(0)}, rounding));
}

//>
TEST_CASE("with dt = 0 a living particle stays as it is", "[11.3]") {
    CHECK_THAT(step(spark, world, 0), IsNear(std::optional{spark}));
    CHECK_THAT(step(spark, world, -0.0), IsNear(std::optional{spark}));
}

TEST_CASE("a step may be very long or short, and its numbers tiny", "[11.3]") {
    const World still{.gravity = 0, .wind = 0, .width = 20, .height = 16};
    const Vec2 at{5, 6};
    const auto check_lives = [](const Particle &before, const World &in, double dt, const Vec2 &to,
                                const Vec2 &velocity) {
        const Particle after{to, velocity, before.age + dt, before.life};
        CHECK_THAT(step(before, in, dt), IsNear(std::optional{after}, rounding_of_1e5));
    };
    check_lives({at, {0, 0}, 0, 1e5}, still, 9e4, at, {0, 0});
    check_lives({at, {5e-10, -5e-10}, 0, 1e5}, still, 9e4, {5 + 4.5e-5, 6 - 4.5e-5}, {5e-10, -5e-10});
    check_lives({at, {1e5, -1e5}, 0, 9}, still, 5e-10, {5 + 5e-5, 6 - 5e-5}, {1e5, -1e5});
    check_lives({at, {0, 0}, 0, 1e5}, {5e-10, -5e-10, 20, 16}, 1000, {5 - 5e-4, 6 - 5e-4}, {-5e-7, -5e-7});
    check_lives({{4e-8, 7e-8}, {0, 0}, 0, 9}, {0, 0, 5e-8, 8e-8}, 1, {4e-8, 7e-8}, {0, 0}); // a tiny picture
    check_lives({at, {0, 0}, 0, 1e-7}, still, 5e-8, at, {0, 0});                            // a short life
    check_lives({at, {0, 0}, 1, 1.75 + 1e-12}, still, 0.75, at, {0, 0});                    // it dies 1e-12 s later
}

TEST_CASE("input may be as large as 1e5, and the result larger", "[11.3]") {
    const auto huge = [](double gravity, double wind) { return World{gravity, wind, 1e5, 1e5}; };
    const Particle fast{.position = {0, 500}, .velocity = {1e5, -1e5}, .age = 0, .life = 1e5};
    const Particle faster{.position = {100.1, 399.9}, .velocity = {100'100, -100'100}, .age = 1e-3, .life = 1e5};
    CHECK_THAT(step(fast, huge(1e5, 1e5), 1e5), IsNear(dead)); // at -1e15 m
    CHECK_THAT(step({{1e5, -1e5}, {0, 0}, 1e5, 1e5}, huge(0, 0), 1e5), IsNear(dead));
    CHECK_THAT(step({{5, 5}, {0, 0}, 6e4, 1e5}, huge(0, 0), 6e4), IsNear(dead)); // at 1.2e5 s
    CHECK_THAT(step(fast, huge(1e5, 1e5), 1e-3), IsNear(std::optional{faster}, rounding_of_1e5));
    const Particle back{.position = {500, 0}, .velocity = {-1e5, 1e5}, .age = 0, .life = 1e5};
    const Particle far_back{.position = {399.9, 100.1}, .velocity = {-100'100, 100'100}, .age = 1e-3, .life = 1e5};
    CHECK_THAT(step(back, huge(-1e5, -1e5), 1e-3), IsNear(std::optional{far_back}, rounding_of_1e5));
}

TEST_CASE("each call stands alone: no world is remembered from the call before", "[11.3]") {
    const Particle rest{.position = {15, 12}, .velocity = {0, 0}, .age = 0, .life = 9};
    const std::optional<Particle> alive = Particle{{15, 12}, {0, 0}, 1, 9};
    for (const World &large : {World{0, 0, 20, 16}, World{0, 0, 16, 20}}) {
        CHECK_THAT(step(rest, {0, 0, 10, 20}, 1), IsNear(dead));
        CHECK_THAT(step(rest, large, 1), IsNear(alive, rounding));
        CHECK_THAT(step(rest, {0, 0, 20, 10}, 1), IsNear(dead));
    }
}

TEST_CASE("an invalid particle, an empty picture or a negative dt is refused", "[11.3]") {
    const auto check_refused = [](const Particle &particle, double dt) {
        for (const double bad : {0.0, -20.0, -1e-9}) {
            CHECK_REFUSED(step(particle, {10, 1, bad, 16}, dt), "width is not positive");
            CHECK_REFUSED(step(particle, {10, 1, 20, bad}, dt), "height is not positive");
        }
        for (const double bad : {-0.1, -1e-9}) CHECK_REFUSED(step(particle, world, bad), "dt is negative");
        check_age_and_life_refused(particle, [&](const Particle &bad) { return step(bad, world, dt); });
    };
    check_refused(spark, 0.1);
    check_refused({{5, 5}, {0, 0}, 1, 4}, 0);    // at rest, with dt = 0
    check_refused({{-5, 5}, {0, 0}, 1, 4}, 0.1); // outside
    check_refused({{5, 5}, {1, 1}, 4, 4}, 0.1);  // dead
}

// ----------------------------------------------------------------------------------------------------- 11.4 ring_burst

//> Four of them
TEST_CASE("the worked example: four velocities, to the right, up, to the left and down", "[11.4]") {
    CHECK_THAT(ring_burst(4, 5, 0), IsNear(std::vector<Vec2>{{5, 0}, {0, 5}, {-5, 0}, {0, -5}}, rounding));
}

//>
TEST_CASE("six velocities, the first straight down", "[11.4]") {
    const double side = 2 * std::sqrt(3);
    CHECK_THAT(ring_burst(6, 4, -pi / 2),
               IsNear(std::vector<Vec2>{{0, -4}, {side, -2}, {side, 2}, {0, 4}, {-side, 2}, {-side, -2}}, rounding)
                   .since("4 cos 30° = 2 √3"));
}

//> Erratum E11.8
TEST_CASE("erratum E11.8: 36 neighbours are 10 degrees apart, all of them", "[11.4]") {
    // with random angles, as printed, a ring of 36 had a gap of 38 degrees, and one direction twice
    const std::vector<Vec2> velocities = ring_burst(36, 3, 0.3);
    CHECK_THAT(velocities, HasSize(36));
    for (std::size_t i = 0; i < 36; ++i) {
        const Vec2 &here = velocities[i], &next = velocities[(i + 1) % 36];
        const double turn = std::atan2(here.x() * next.y() - here.y() * next.x(), here.dot(next)); // anticlockwise
        CHECK_THAT(turn * 180 / pi, IsNear(10.0, 36 * rounding).of("angle between neighbours [°]"));
    }
}

//>
TEST_CASE("all velocities have the given speed and the same angle to the next, and their sum is 0", "[11.4]") {
    const int count = GENERATE(2, 3, 5, 7, 64, 1000);
    const double speed = GENERATE(0.0, 0.5, 40.0), first = GENERATE(0.0, 1.2, -9.0);
    const std::vector<Vec2> velocities = ring_burst(count, speed, first);

    CHECK_THAT(velocities, HasSize(std::size_t(count)));
    Vec2 sum{0, 0};
    for (const Vec2 &v : velocities) {
        CHECK_THAT(v.norm(), IsNear(speed, count * rounding).of("speed [m/s]"));
        sum += v;
    }
    // an angle that is added up may be off by count roundings, and so may each velocity
    CHECK_THAT(sum, IsNear(Vec2{0, 0}, count * count * rounding * speed).of("sum of all velocities [m/s]"));
    CHECK_THAT(velocities[0],
               IsNear(Vec2{speed * std::cos(first), speed * std::sin(first)}, rounding).of("first velocity [m/s]"));
    const Vec2 apart{std::cos(2 * pi / count), std::sin(2 * pi / count)};
    for (std::size_t i = 1; i < velocities.size(); ++i) {
        const Vec2 &before = velocities[i - 1], left{-before.y(), before.x()};
        CHECK_THAT(velocities[i],
                   IsNear(Vec2{apart.x() * before + apart.y() * left}, count * rounding).of("next velocity [m/s]"));
    }
}

TEST_CASE("a ring of 70000 velocities is complete", "[11.4]") {
    const int count = more_than_16_bits;
    const std::vector<Vec2> velocities = ring_burst(count, 3, 0.5);
    CHECK_THAT(velocities, HasSize(std::size_t(count)));
    const Vec2 ahead{3 * std::cos(0.5), 3 * std::sin(0.5)}, left{-ahead.y(), ahead.x()};
    const auto quarter = std::size_t(count / 4); // of a turn
    CHECK_THAT(velocities[quarter], IsNear(left, count * rounding).of("velocity after a quarter of a turn [m/s]"));
    CHECK_THAT(velocities[3 * quarter],
               IsNear(Vec2{-left}, count * rounding).of("velocity after three quarters [m/s]"));
}

TEST_CASE("speed and angle may be 1e5 or tiny, and each call stands alone", "[11.4]") {
    CHECK_THAT(ring_burst(2, 1e5, 0), IsNear(std::vector<Vec2>{{1e5, 0}, {-1e5, 0}}, 1e-10)); // π is rounded too
    CHECK_THAT(ring_burst(2, 1e5, 5e-10), IsNear(std::vector<Vec2>{{1e5, 5e-5}, {-1e5, -5e-5}}, 1e-10));
    CHECK_THAT(ring_burst(2, 5e-10, 0), IsNear(std::vector<Vec2>{{5e-10, 0}, {-5e-10, 0}}, rounding));
    for (const double first : {1e5, -1e5, 7.0, 1001.0}) { // beside 1e5 only eleven decimals are left
        const Vec2 want{std::cos(first), std::sin(first)};
        CHECK_THAT(ring_burst(2, 1, first), IsNear(std::vector<Vec2>{want, -want}, rounding_of_1e5));
    }
    CHECK_THAT(ring_burst(2, -0.0, 1), IsNear(std::vector<Vec2>{{0, 0}, {0, 0}}));

    CHECK_THAT(ring_burst(4, 5, 0), IsNear(std::vector<Vec2>{{5, 0}, {0, 5}, {-5, 0}, {0, -5}}, rounding));
    CHECK_THAT(ring_burst(2, 3, 0), IsNear(std::vector<Vec2>{{3, 0}, {-3, 0}}, rounding));
    CHECK_THAT(ring_burst(4, 5, pi), IsNear(std::vector<Vec2>{{-5, 0}, {0, -5}, {5, 0}, {0, 5}}, rounding));
}

TEST_CASE("one particle leaves in the first direction, and a count of 0 gives an empty list", "[11.4]") {
    CHECK_THAT(ring_burst(1, 2, pi / 2), IsNear(std::vector<Vec2>{{0, 2}}, rounding));
    CHECK_THAT(ring_burst(0, 2, 1), IsNear(std::vector<Vec2>{}));
}

TEST_CASE("a negative count and a negative speed are refused", "[11.4]") {
    for (const int count : {-1, std::numeric_limits<int>::min()})
        CHECK_REFUSED(ring_burst(count, 5, 0), "count is negative");
    for (const int count : {4, 1, 0}) {
        for (const double speed : {-5.0, -1e-9}) CHECK_REFUSED(ring_burst(count, speed, 0), "speed is negative");
    }
}

// ----------------------------------------------------------------------------------------------------- 11.5 disc_burst

//> A quarter of the disc
TEST_CASE("the worked example: 0.25 gives half of the maximum speed, 0.81 nine tenths of it", "[11.5]") {
    // 0.25 of the area has speeds below 5 of 10 m/s, 0.81 below 9; angle 0 is to the right, 0.25 up, 0.5 to the left
    CHECK_THAT(disc_burst({0.25, 0, 0.25, 0.25, 0.81, 0.5}, 10),
               IsNear(std::vector<Vec2>{{5, 0}, {0, 5}, {-9, 0}}, rounding));
}

//>
TEST_CASE("the first number is the fraction of the disc that is slower, the second the fraction of a turn", "[11.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double first = dice.real(0.001, 1), second = dice.real(0, 1), max_speed = dice.real(0.1, 900);
        const std::vector<Vec2> velocities = disc_burst({first, second}, max_speed);

        CHECK_THAT(velocities, HasSize(1));
        const Vec2 &v = velocities[0];
        CHECK_THAT(v.squaredNorm() / (max_speed * max_speed),
                   IsNear(first, rounding).of("fraction of the disc that is slower"));
        const double turn = std::atan2(v.y(), v.x()) / (2 * pi); // from -1/2 to 1/2
        CHECK_THAT(std::remainder(turn - second, 1), IsNear(0.0, rounding).of("turn, less the second number"));
    }
}

//> Equal areas
TEST_CASE("equal areas of the disc hold equal numbers of velocities", "[11.5]") {
    Dice dice;
    std::vector<double> random_numbers(2 * 20000);
    for (double &number : random_numbers) number = dice.real(0, 1);
    const std::vector<Vec2> velocities = disc_burst(random_numbers, 3);
    CHECK_THAT(velocities, HasSize(20000));

    // ten rings of equal area, cut into six sectors, the axes within them
    std::array<int, 60> counts{};
    for (const Vec2 &v : velocities) {
        CHECK_THAT(v.norm(), IsAtMost(3 * (1 + rounding)).of("speed [m/s]"));
        const double turn = std::atan2(v.y(), v.x()) / (2 * pi) + 0.55;
        const auto sector = std::size_t(6 * (turn - std::floor(turn))), circle = std::size_t(10 * v.squaredNorm() / 9);
        ++counts[std::min<std::size_t>(circle, 9) * 6 + sector];
    }
    // the sum of (count - expected)² / expected is near 59, and above 130 once in a million
    double chi_squared = 0;
    for (const int count : counts) chi_squared += std::pow(count - 20000 / 60.0, 2) / (20000 / 60.0);
    CHECK_THAT(chi_squared, IsBelow(130).of("chi squared of the 60 counts"));
}

//> Erratum E11.7
TEST_CASE("erratum E11.7: 16 % are slower than two fifths of the maximum; in print, none are", "[11.5]") {
    // printed speeds: 2, 3, 4 or 5; but 2²/5² = 16 % of a disc's area is inside 2
    std::vector<double> random_numbers;
    for (int i = 0; i < 1000; ++i)
        random_numbers.insert(random_numbers.end(), {(i + 0.5) / 1000, std::fmod(0.618 * i, 1)});
    const std::vector<Vec2> velocities = disc_burst(random_numbers, 5);
    CHECK_THAT(velocities, HasSize(1000));
    const auto slow = std::ranges::count_if(velocities, [](const Vec2 &v) { return v.norm() < 2; });
    CHECK_THAT(int(slow), IsNear(160).of("velocities below 2 m/s"));
}

//>
TEST_CASE("no random numbers give an empty list, and a maximum speed of 0 gives velocities of 0", "[11.5]") {
    CHECK_THAT(disc_burst({}, 7), IsNear(std::vector<Vec2>{}));
    CHECK_THAT(disc_burst({0.3, 0.7}, 0), IsNear(std::vector<Vec2>{{0, 0}}));
    CHECK_THAT(disc_burst({0, 0.7}, 7), IsNear(std::vector<Vec2>{{0, 0}}, rounding));
}

TEST_CASE("velocities come in the order of their pairs, and each call stands alone", "[11.5]") {
    CHECK_THAT(disc_burst({0.81, 0.5, 0.25, 0, 0.49, 0.25}, 10),
               IsNear(std::vector<Vec2>{{-9, 0}, {5, 0}, {0, 7}}, rounding));

    CHECK_THAT(disc_burst({0.25, 0.5}, 10), IsNear(std::vector<Vec2>{{-5, 0}}, rounding));
    CHECK_THAT(disc_burst({0.25, 0.5}, 2), IsNear(std::vector<Vec2>{{-1, 0}}, rounding));
}

TEST_CASE("random numbers may be tiny or nearly 1, and the maximum speed tiny or 1e5", "[11.5]") {
    const double nearly_1 = 1 - 1e-13;
    CHECK_THAT(disc_burst({5e-13, 0, 0.25, 0}, 1e5),
               IsNear(std::vector<Vec2>{{1e5 * std::sqrt(5e-13), 0}, {5e4, 0}}, rounding_of_1e5));
    CHECK_THAT(disc_burst({1e-300, 0}, 1e5), IsNear(std::vector<Vec2>{{1e-145, 0}}, rounding_of_1e5));
    CHECK_THAT(disc_burst({nearly_1, 5e-10}, 1e5), IsNear(std::vector<Vec2>{{1e5, 1e5 * 1e-9 * pi}}, 1e-10));
    CHECK_THAT(disc_burst({0.25, nearly_1}, 10), IsNear(std::vector<Vec2>{{5, -1e-12 * pi}}, rounding));
    CHECK_THAT(disc_burst({0.25, 0.5}, 5e-10), IsNear(std::vector<Vec2>{{-2.5e-10, 0}}, rounding));
    CHECK_THAT(disc_burst({-0.0, -0.0}, -0.0), IsNear(std::vector<Vec2>{{0, 0}}));
}

TEST_CASE("an odd count of numbers, a number outside [0, 1), and a negative speed are refused", "[11.5]") {
    for (const double max_speed : {7.0, 0.0}) {
        for (const std::size_t odd : {1u, 3u, 5u, 131u})
            CHECK_REFUSED(disc_burst(std::vector<double>(odd, 0.5), max_speed), "the number of random numbers is odd");
        for (const std::size_t i : {0u, 1u, 2u, 131u})
            for (const double bad : {infinity, -infinity, not_a_number, 1.0, 1 + 1e-9, -0.001, -1e-300}) {
                std::vector<double> random_numbers(132, 0.5);
                random_numbers[i] = bad;
                CHECK_REFUSED(disc_burst(random_numbers, max_speed), "a random number is outside [0, 1)");
            }
    }
    for (const std::vector<double> &random_numbers : {std::vector{0.5, 0.5}, std::vector<double>{}})
        for (const double max_speed : {-7.0, -1e-9})
            CHECK_REFUSED(disc_burst(random_numbers, max_speed), "max_speed is negative");
}

// ----------------------------------------------------------------------------------------------------------- 11.6 emit

namespace {

const Emitter rocket{
    .position = {30, 40}, .velocity = {6, -8}, .offset = 0.5, .jitter = 2, .min_life = 3, .max_life = 5};

} // namespace

//> A moving emitter
TEST_CASE("the worked example: 0.5 gives the middle, 0 the smallest value", "[11.6]") {
    // 0.5 gives the middle, 0 the smallest value, and 0.75 is halfway from the middle to the largest
    CHECK_THAT(emit(rocket, {0.5, 0.5, 0.5, 0.5, 0.5}), IsNear(Particle{{30, 40}, {6, -8}, 0, 4}, rounding));
    CHECK_THAT(emit(rocket, {0, 0.75, 0.75, 0, 0}), IsNear(Particle{{29.5, 40.25}, {7, -10}, 0, 3}, rounding));
}

//>
TEST_CASE("each of the five numbers changes one quantity, and no other", "[11.6]") {
    // from 0.5 to 0.625: an eighth of the whole range, which is 1 m, 4 m/s or 2 s
    CHECK_THAT(emit(rocket, {0.625, 0.5, 0.5, 0.5, 0.5}), IsNear(Particle{{30.125, 40}, {6, -8}, 0, 4}, rounding));
    CHECK_THAT(emit(rocket, {0.5, 0.625, 0.5, 0.5, 0.5}), IsNear(Particle{{30, 40.125}, {6, -8}, 0, 4}, rounding));
    CHECK_THAT(emit(rocket, {0.5, 0.5, 0.625, 0.5, 0.5}), IsNear(Particle{{30, 40}, {6.5, -8}, 0, 4}, rounding));
    CHECK_THAT(emit(rocket, {0.5, 0.5, 0.5, 0.625, 0.5}), IsNear(Particle{{30, 40}, {6, -7.5}, 0, 4}, rounding));
    CHECK_THAT(emit(rocket, {0.5, 0.5, 0.5, 0.5, 0.625}), IsNear(Particle{{30, 40}, {6, -8}, 0, 4.25}, rounding));
}

//> Seen from the rocket
TEST_CASE("the emitter's velocity is added to every particle, and changes nothing else", "[11.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        std::vector<double> random_numbers(5);
        for (double &number : random_numbers) number = dice.real(0, 1);
        Emitter resting = rocket, moving = rocket;
        resting.velocity = {0, 0};
        moving.velocity = dice.point(-90, 90);

        const Particle from_resting = emit(resting, random_numbers), from_moving = emit(moving, random_numbers);

        CHECK_THAT(from_moving.velocity - moving.velocity,
                   IsNear(from_resting.velocity, rounding * 100).of("velocity, less the emitter's [m/s]"));
        CHECK_THAT(from_moving.position, IsNear(from_resting.position, rounding).of("position [m]"));
        CHECK_THAT(from_moving.life, IsNear(from_resting.life, rounding).of("life [s]"));
    }
}

//> Erratum E11.9
TEST_CASE("erratum E11.9: 100 random numbers give 100 velocities; in print there are only 25", "[11.6]") {
    std::vector<double> across; // printed: a whole number from -2 to 2 along each axis, so 5 · 5 pairs
    for (int i = 0; i < 100; ++i) across.push_back(emit(rocket, {0.5, 0.5, i / 100.0, 0.5, 0.5}).velocity.x());
    for (std::size_t i = 0; i < 100; ++i)
        CHECK_THAT(across[i], IsNear(4 + 0.04 * double(i), rounding).of("velocity along x [m/s]"));
    for (int i = 0; i < 100; ++i) { // all five at once
        const double x = i / 100.0;
        CHECK_THAT(emit(rocket, {x, x, x, x, x}),
                   IsNear(Particle{{29.5 + x, 39.5 + x}, {4 + 4 * x, -10 + 4 * x}, 0, 3 + 2 * x}, rounding));
    }
}

//>
TEST_CASE("with offset and jitter 0 and equal lives, random numbers change nothing", "[11.6]") {
    const Emitter calm{.position = {-3, 2}, .velocity = {1, 7}, .offset = 0, .jitter = 0, .min_life = 2, .max_life = 2};
    CHECK_THAT(emit(calm, {0.1, 0.9, 0.3, 0.99, 0.7}), IsNear(Particle{{-3, 2}, {1, 7}, 0, 2}, rounding));
}

TEST_CASE("offset, jitter and life do not affect each other, and may be tiny", "[11.6]") {
    const std::vector<double> random_numbers{0.75, 0.25, 0.25, 0.75,
                                             0.5}; // half the offset or jitter, in either direction
    for (const double tiny : {5e-7, 5e-10}) {
        const Emitter wide{
            .position = {0, 0}, .velocity = {0, 0}, .offset = tiny, .jitter = 0, .min_life = 2, .max_life = 2};
        CHECK_THAT(emit(wide, random_numbers), IsNear(Particle{{tiny / 2, -tiny / 2}, {0, 0}, 0, 2}, rounding));
        const Emitter wild{
            .position = {0, 0}, .velocity = {0, 0}, .offset = 0, .jitter = tiny, .min_life = 2, .max_life = 2};
        CHECK_THAT(emit(wild, random_numbers), IsNear(Particle{{0, 0}, {-tiny / 2, tiny / 2}, 0, 2}, rounding));
        const Emitter brief{
            .position = {0, 0}, .velocity = {0, 0}, .offset = 0, .jitter = 0, .min_life = tiny, .max_life = 2 * tiny};
        CHECK_THAT(emit(brief, random_numbers), IsNear(Particle{{0, 0}, {0, 0}, 0, 1.5 * tiny}, rounding));
    }
}

TEST_CASE("an emitter's numbers may be as large as 1e5, and the particle's larger", "[11.6]") {
    const auto of_ones = [](double sign) {
        return Emitter{{sign * 1e5, -sign * 1e5}, {-sign * 1e5, sign * 1e5}, 1e5, 1e5, 1e5, 1e5};
    };
    const double last = 1 - 1e-13; // as good as 1
    CHECK_THAT(emit(of_ones(1), {last, 0, 0, last, last}),
               IsNear(Particle{{2e5, -2e5}, {-2e5, 2e5}, 0, 1e5}, rounding));
    CHECK_THAT(emit(of_ones(-1), {0, last, last, 0, 0}), IsNear(Particle{{-2e5, 2e5}, {2e5, -2e5}, 0, 1e5}, rounding));
}

TEST_CASE("an invalid emitter, and random numbers that are not five in [0, 1), are refused", "[11.6]") {
    Emitter calm = rocket, resting = rocket;
    calm.offset = calm.jitter = 0;
    calm.max_life = calm.min_life;
    resting.velocity = {0, 0};
    for (const Emitter &emitter : {rocket, calm, resting}) {
        for (const std::size_t number : {0u, 4u, 6u})
            CHECK_REFUSED(emit(emitter, std::vector<double>(number, 0.5)), "there are not 5 random numbers");
        for (std::size_t i = 0; i < 5; ++i)
            for (const double bad : {infinity, -infinity, not_a_number, 1.0, 1 + 1e-9, -0.001, -1e-300}) {
                std::vector<double> random_numbers(5, 0.5);
                random_numbers[i] = bad;
                CHECK_REFUSED(emit(emitter, random_numbers), "a random number is outside [0, 1)");
            }
        const auto check_refused = [&](double Emitter::*field, double value, const char *input) {
            Emitter bad = emitter;
            bad.*field = value;
            CHECK_REFUSED(emit(bad, std::vector<double>(5, 0.5)), input);
        };
        for (const double bad : {-2.0, -1e-9}) {
            check_refused(&Emitter::offset, bad, "offset is negative");
            check_refused(&Emitter::jitter, bad, "jitter is negative");
            check_refused(&Emitter::min_life, bad, "min_life is not positive");
        }
        check_refused(&Emitter::min_life, 0, "min_life is not positive");
        check_refused(&Emitter::max_life, emitter.min_life - 1e-9, "max_life is less than min_life");
    }
}

// ------------------------------------------------------------------------------------------------- 11.7 emission_count

//> Ten a second
TEST_CASE("the worked example: at 10 per second, frames of 1/4 s emit 2, then 3", "[11.7]") {
    // 2.5 per frame: 2, and half a particle is left; with it the next frame emits 3
    CHECK_THAT(emission_count(10, 0, 0.25), IsNear(Emission{2, 0.5}, rounding));
    CHECK_THAT(emission_count(10, 0.5, 0.25), IsNear(Emission{3, 0}, rounding));
}

//> At any frame rate
TEST_CASE("the total stays within one of rate times time, at any frame rate", "[11.7]") {
    const double rate = GENERATE(0.3, 7.0, 100.0, 59.9, 1234.5);
    const double frames_per_second = GENERATE(24.0, 50.0, 144.0);
    double remainder = 0;
    int total = 0;
    for (int frame = 1; frame <= 60; ++frame) {
        const Emission now = emission_count(rate, remainder, 1 / frames_per_second);
        remainder = now.remainder;
        total += now.count;
        CHECK_THAT(remainder >= 0 && remainder < 1, IsTrue("the remainder is at least 0 and less than 1"));
        CHECK_THAT(std::abs(total - rate * frame / frames_per_second),
                   IsAtMost(1 + 1e-9).of("difference between the total and rate times time")); // 60 roundings
    }
}

TEST_CASE("4, 32 and 64 frames per second emit the same number in a second", "[11.7]") {
    // powers of two, so that 1 / frames is exact: at 8 per second, a particle in every 4th frame, or in every 8th
    const auto emitted_in_a_second = [](int frames) {
        Emission now{};
        int total = 0;
        for (int frame = 0; frame < frames; ++frame) {
            now = emission_count(8.0, now.remainder, 1.0 / frames);
            total += now.count;
        }
        return total;
    };
    CHECK_THAT(emitted_in_a_second(32), IsNear(8).of("count of 32 frames"));
    CHECK_THAT(emitted_in_a_second(64), IsNear(8).of("count of 64 frames"));
    CHECK_THAT(emitted_in_a_second(4), IsNear(8).of("count of 4 frames"));
    CHECK_THAT(emitted_in_a_second(1), IsNear(8).of("count of 1 frame"));
}

//>
namespace {

/// Checks that count and remainder add up. Where rounding decides, the last particle may still be in the remainder.
void check_adds_up(const Emission &now, double together, double tolerance = rounding) {
    CHECK_THAT(now.remainder >= 0 && now.remainder < 1, IsTrue("the remainder is at least 0 and less than 1"));
    CHECK_THAT(now.count + now.remainder, IsNear(together, tolerance).of("count and remainder together"));
}

} // namespace

TEST_CASE("count plus new remainder equals old remainder plus rate times dt, for random frames", "[11.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double rate = dice.real(0, 300), remainder = dice.real(0, 1), dt = dice.real(0, 0.2);
        const Emission now = emission_count(rate, remainder, dt);
        check_adds_up(now, remainder + rate * dt);
    }
}

TEST_CASE("almost one whole particle is not emitted yet, and the smallest remainder is kept", "[11.7]") {
    const double little = 0x1p-45; // 3e-14
    CHECK_THAT(emission_count(1, 0, 1 - little), IsNear(Emission{0, 1 - little}, little / 8));
    CHECK_THAT(emission_count(1, 1 - little, 2), IsNear(Emission{2, 1 - little}, little / 8));
    CHECK_THAT(emission_count(1, little, 2), IsNear(Emission{2, little}, little / 8));
    CHECK_THAT(emission_count(0, 5e-13, 1), IsNear(Emission{0, 5e-13}, 1e-15));
    CHECK_THAT(emission_count(5e-10, 0, 1e5), IsNear(Emission{0, 5e-5}, rounding_of_1e5));
    CHECK_THAT(emission_count(1e5, 0, 5e-10), IsNear(Emission{0, 5e-5}, rounding_of_1e5));
    CHECK_THAT(emission_count(1e-5, 0, 5e-5), IsNear(Emission{0, 5e-10}, rounding));
}

TEST_CASE("with dt = 0 or rate = 0 none is emitted, and the remainder stays", "[11.7]") {
    CHECK_THAT(emission_count(100, 0.75, 0), IsNear(Emission{0, 0.75}, rounding));
    CHECK_THAT(emission_count(0, 0.75, 5), IsNear(Emission{0, 0.75}, rounding));
    CHECK_THAT(emission_count(-0.0, -0.0, -0.0), IsNear(Emission{0, 0})); // -0 is 0
}

TEST_CASE("a long frame may emit a million particles at once", "[11.7]") {
    const double million_roundings = rounding_of_1e5; // relative: one by one, each of a million particles adds its own
    check_adds_up(emission_count(1e5, 0, 10), 1e6, million_roundings);
    check_adds_up(emission_count(10, 0.25, 1e5), 1e6 + 0.25, million_roundings);
    check_adds_up(emission_count(1e5, 0.5, 10), 1e6 + 0.5, million_roundings); // the old remainder is added on top
}

TEST_CASE("a negative rate or dt, a remainder outside [0, 1), and more than a million are refused", "[11.7]") {
    for (const double long_frame : {10 + 5e-9, 10.1, 1e5})
        CHECK_REFUSED(emission_count(1e5, 0, long_frame), "rate times dt is more than 1e6");
    for (const double other :
         {0.1, 0.0, -0.1}) // also if the other one is 0, or negative, so that the product is positive
        for (const double bad : {-1.0, -1e-9}) {
            CHECK_REFUSED(emission_count(bad, 0, other), "rate is negative");
            CHECK_REFUSED(emission_count(other, 0, bad), "dt is negative");
        }
    for (const double rate : {10.0, 0.0})
        for (const double dt : {0.1, 0.0}) {
            for (const double bad : {-0.1, -1e-9, 1.0, 1 + 1e-9, 1.5})
                CHECK_REFUSED(emission_count(rate, bad, dt), "remainder is outside [0, 1)");
        }
}

// ----------------------------------------------------------------------------------------------- 11.8 move_and_collide

namespace {

const std::vector<Wall> ground{{.start = {0, 0}, .end = {20, 0}}};

Particle flying(const Vec2 &position, const Vec2 &velocity, double age = 0) { return {position, velocity, age, 1e5}; }

/// A box from (0, 0) to (8, 6), its left sides inside. Its walls extend beyond the corners, because at its very end a wall
/// may reflect or not.
const std::vector<Wall> box{{{-1, 0}, {9, 0}}, {{8, -1}, {8, 7}}, {{9, 6}, {-1, 6}}, {{0, 7}, {0, -1}}};

/// The longest horizontal wall there may be, its left side up.
const std::vector<Wall> endless{{.start = {-1e5, 0}, .end = {1e5, 0}}};

} // namespace

//> Half of it comes back
TEST_CASE("the worked example: half of the falling speed comes back, and the time left is used up", "[11.8]") {
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), ground, 0.5, 2),
               IsNear(flying({8, 0.5}, {2, 1}, 2), rounding)
                   .since("it hits after 1.5 s, at x = 4 + 1.5 · 2, and then rises at 1 m/s for half a second"));
}

//>
TEST_CASE("at a slanted wall only the velocity along the normal is reversed and reduced", "[11.8]") {
    // the wall's displacement is (-9, 12), its normal (-0.8, -0.6); (5, 0) approaches it at 4 m/s and hits after 1.9 s:
    // at y = 2 the wall is at x = 20 - 9/12 · 2 = 18.5. (5, 0) + (1 + 0.25) 4 (-0.8, -0.6) = (1, -3), for 0.1 s
    const std::vector<Wall> leaning{{.start = {20, 0}, .end = {11, 12}}};
    CHECK_THAT(move_and_collide(flying({9, 2}, {5, 0}), leaning, 0.25, 2),
               IsNear(flying({18.6, 1.7}, {1, -3}, 2), rounding)
                   .since("it hits after 1.9 s, and (5, 0) + (1 + 0.25) 4 (-0.8, -0.6) = (1, -3), for 0.1 s"));
    CHECK_THAT(move_and_collide(flying({9, 2}, {5, 0}), leaning, 1, 2),
               IsNear(flying({18.36, 1.52}, {-1.4, -4.8}, 2), rounding));
    CHECK_THAT(move_and_collide(flying({9, 2}, {5, 0}), leaning, 0, 2),
               IsNear(flying({18.68, 1.76}, {1.8, -2.4}, 2), rounding));
}

TEST_CASE("on a wall's right side a particle is not reflected, whether it comes or goes", "[11.8]") {
    CHECK_THAT(move_and_collide(flying({4, -3}, {2, 2}), ground, 0.5, 3), IsNear(flying({10, 3}, {2, 2}, 3), rounding));
    const std::vector<Wall> ceiling{{.start = {20, 0}, .end = {0, 0}}};
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), ceiling, 0.5, 3),
               IsNear(flying({10, -3}, {2, -2}, 3), rounding));
    CHECK_THAT(move_and_collide(flying({4, -3}, {2, 2}), ceiling, 0.5, 2),
               IsNear(flying({8, -0.5}, {2, -1}, 2), rounding));
    // beyond the ground already: one second ago it passed through
    CHECK_THAT(move_and_collide(flying({8, -2}, {3, -2}), ground, 0.5, 2),
               IsNear(flying({14, -6}, {3, -2}, 2), rounding));
    // down through 1200 ceilings, which count as no bounces, and then off the ground
    std::vector<Wall> many = ground;
    for (int i = 0; i < 1200; ++i) many.push_back({{20, 1 + i / 1000.0}, {0, 1 + i / 1000.0}});
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), many, 0.5, 2), IsNear(flying({8, 0.5}, {2, 1}, 2), rounding));
}

TEST_CASE("a particle that passes beside a wall's end is not reflected", "[11.8]") {
    CHECK_THAT(move_and_collide(flying({-0.5, 3}, {0, -2}), ground, 0.5, 3),
               IsNear(flying({-0.5, -3}, {0, -2}, 3), rounding));
    CHECK_THAT(move_and_collide(flying({20.5, 3}, {0, -2}), ground, 0.5, 3),
               IsNear(flying({20.5, -3}, {0, -2}, 3), rounding));
    CHECK_THAT(move_and_collide(flying({0.001, 3}, {0, -2}), ground, 0.5, 2),
               IsNear(flying({0.001, 0.5}, {0, 1}, 2), rounding));
    CHECK_THAT(move_and_collide(flying({19.999, 3}, {0, -2}), ground, 0.5, 2),
               IsNear(flying({19.999, 0.5}, {0, 1}, 2), rounding));
    // on the wall's line: beside the wall, and moving towards its end
    CHECK_THAT(move_and_collide(flying({20.5, 0}, {2, -2}), ground, 0.5, 1),
               IsNear(flying({22.5, -2}, {2, -2}, 1), rounding));
    CHECK_THAT(move_and_collide(flying({25, 0}, {-4, 0}), ground, 0.5, 2),
               IsNear(flying({17, 0}, {-4, 0}, 2), rounding));
    CHECK_THAT(move_and_collide(flying({-5, 0}, {4, 0}), ground, 0.5, 2), IsNear(flying({3, 0}, {4, 0}, 2), rounding));
}

TEST_CASE("a wall ends at its end point, to within contact_tolerance, however long it is", "[11.8]") {
    const std::vector<Wall> long_one{{.start = {-1e5, 0}, .end = {5e4, 0}}};
    const auto check_turned = [](const std::vector<Wall> &walls, double x, bool turned) {
        const Particle want = turned ? flying({x, 0.5}, {0, 1}, 2) : flying({x, -1}, {0, -2}, 2);
        CHECK_THAT(move_and_collide(flying({x, 3}, {0, -2}), walls, 0.5, 2), IsNear(want, rounding_of_1e5));
    };
    for (const double more : {3e-9, 1e-7, 1e-4, 0.05}) {
        check_turned(ground, -more, false);
        check_turned(ground, more, true);
        check_turned(ground, 20 - more, true);
        check_turned(ground, 20 + more, false);
    }
    check_turned(long_one, 5e4 - 5e-7, true);
    check_turned(long_one, 5e4 + 5e-7, false);
}

TEST_CASE("a wall may be tiny, huge or very steep", "[11.8]") {
    for (const double length : {1e-3, 1.005e-3, 5e-3}) {
        const std::vector<Wall> tiny{{.start = {0, 0}, .end = {length, 0}}};
        CHECK_THAT(move_and_collide(flying({5e-4, 1}, {0, -2}), tiny, 0.5, 1),
                   IsNear(flying({5e-4, 0.5}, {0, 1}, 1), rounding));
        CHECK_THAT(move_and_collide(flying({length + 1e-4, 1}, {0, -2}), tiny, 0.5, 1),
                   IsNear(flying({length + 1e-4, -1}, {0, -2}, 1), rounding));
    }
    const std::vector<Wall> diagonal{{.start = {-1e5, -1e5}, .end = {1e5, 1e5}}};
    CHECK_THAT(move_and_collide(flying({49'997, 50'003}, {3, -3}), diagonal, 1, 2),
               IsNear(flying({49'997, 50'003}, {-3, 3}, 2), rounding));

    // 200 km up and 0.1 m to the right, 5e-7 per metre; it is hit at x = 0.05, after 0.5025 s
    const double lean = 5e-7;
    const std::vector<Wall> steep{{.start = {0, -1e5}, .end = {0.1, 1e5}}};
    const Vec2 turned{20 - 40 / (1 + lean * lean), 40 * lean / (1 + lean * lean)};
    CHECK_THAT(move_and_collide(flying({-10, 0}, {20, 0}), steep, 1, 1),
               IsNear(flying(Vec2{0.05, 0} + 0.4975 * turned, turned, 1), rounding_of_1e5));

    for (const Vec2 &end : {Vec2{1e-3, 0}, Vec2{0, -1e-3}, Vec2{8e-4, 8e-4}})
        CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), {{{0, 0}, end}}, 1, 1),
                   IsNear(flying({6, 1}, {2, -2}, 1), rounding));
}

TEST_CASE("a particle that hits no wall moves straight on", "[11.8]") {
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -1}), {}, 0.5, 2), IsNear(flying({8, 1}, {2, -1}, 2), rounding));
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -1}), ground, 0.5, 2),
               IsNear(flying({8, 1}, {2, -1}, 2), rounding)); // too early
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, 0}), ground, 0.5, 2), IsNear(flying({8, 3}, {2, 0}, 2), rounding));
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, 1}), ground, 0.5, 2), IsNear(flying({8, 5}, {2, 1}, 2), rounding));
    CHECK_THAT(move_and_collide(flying({4, 3}, {0, 0}), ground, 0.5, 2), IsNear(flying({4, 3}, {0, 0}, 2), rounding));
}

TEST_CASE("the age grows by dt, the life stays, and a dead particle moves on too", "[11.8]") {
    const Particle old{.position = {4, 3}, .velocity = {2, -2}, .age = 3, .life = 4};
    CHECK_THAT(move_and_collide(old, ground, 0.5, 2), IsNear(Particle{{8, 0.5}, {2, 1}, 5, 4}, rounding));
    CHECK_THAT(move_and_collide(old, ground, 0.5, 0), IsNear(old, rounding));
    const Particle over{.position = {4, 3}, .velocity = {2, -2}, .age = 4, .life = 4};
    CHECK_THAT(move_and_collide(over, ground, 0.5, 2), IsNear(Particle{{8, 0.5}, {2, 1}, 6, 4}, rounding));

    for (const Particle &particle : unusual)
        CHECK_THAT(move_and_collide(particle, {}, 1, 0), IsNear(particle, rounding));
}

TEST_CASE("the wall that is hit first in time reflects, wherever it is in the list", "[11.8]") {
    const Wall near{.start = {0, 2}, .end = {20, 2}}, far{.start = {0, 0}, .end = {20, 0}};
    const Particle want = flying({14, 3.5}, {2, 0.5}, 5); // 2 s to y = 2 at 1 m/s, then 0.5 m/s back for 3 s
    CHECK_THAT(move_and_collide(flying({4, 4}, {2, -1}), {near, far}, 0.5, 5),
               IsNear(want, rounding)); // the far one would take 4 s
    CHECK_THAT(move_and_collide(flying({4, 4}, {2, -1}), {far, near}, 0.5, 5), IsNear(want, rounding));

    // the ground is nearer, but the wall on the right is hit first: after 1 s, the ground after 2 s
    const Wall right{.start = {12, -9}, .end = {12, 9}};
    CHECK_THAT(move_and_collide(flying({2, 2}, {10, -1}), {ground[0], right}, 0.5, 3),
               IsNear(flying({2, 0.5}, {-5, 0.5}, 3), rounding));
    CHECK_THAT(move_and_collide(flying({2, 2}, {10, -1}), {right, ground[0]}, 0.5, 3),
               IsNear(flying({2, 0.5}, {-5, 0.5}, 3), rounding));

    // through the ground, up to a ceiling at y = 2 after 1.5 s, and down to the ground, which it now hits from the left
    CHECK_THAT(move_and_collide(flying({4, -1}, {1, 2}), {ground[0], {{20, 2}, {0, 2}}}, 1, 3),
               IsNear(flying({7, 1}, {1, 2}, 3), rounding));

    // 5e-5 m lie between these two, at 100 km/s that is half a nanosecond
    const Wall step_before{.start = {0, 5e-5}, .end = {20, 5e-5}};
    for (const std::vector<Wall> &two : {std::vector{ground[0], step_before}, std::vector{step_before, ground[0]}})
        CHECK_THAT(move_and_collide(flying({4, 1}, {0, -1e5}), two, 1, 1.5e-5),
                   IsNear(flying({4, 0.5001}, {0, 1e5}, 1.5e-5), rounding_of_1e5));

    std::vector<Wall> walls;
    for (int i = 1; i < more_than_16_bits; ++i) // none of them in its way
        walls.push_back({{100.0 + i, 50}, {100.5 + i, 50}});
    walls.push_back(ground[0]);
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), walls, 0.5, 2), IsNear(flying({8, 0.5}, {2, 1}, 2), rounding));
}

TEST_CASE("on a wall, an approaching particle bounces at once; one that leaves or slides does not", "[11.8]") {
    const double height = GENERATE(0.0, 1e-12, -1e-12);
    CHECK_THAT(move_and_collide(flying({5, height}, {4, -2}), ground, 0.5, 1),
               IsNear(flying({9, 1}, {4, 1}, 1), 1e-11));
    CHECK_THAT(move_and_collide(flying({5, height}, {4, 2}), ground, 0.5, 1), IsNear(flying({9, 2}, {4, 2}, 1), 1e-11));
    CHECK_THAT(move_and_collide(flying({5, height}, {4, 0}), ground, 0.5, 1), IsNear(flying({9, 0}, {4, 0}, 1), 1e-11));

    for (const Vec2 &along : {Vec2{1, 0}, Vec2{0.8, 0.6}, Vec2{0, -1}}) { // flat, slanted and upright
        const Vec2 up{-along.y(), along.x()};
        const std::vector<Wall> walls{{.start = -20 * along, .end = 20 * along}};
        const auto start_behind = [&](double behind) {
            return move_and_collide(flying(5 * along - behind * up, 4 * along - 2 * up), walls, 0.5, 1);
        };
        for (const double behind : {2e-10, 0.96e-9})
            CHECK_THAT(start_behind(behind), IsNear(flying(9 * along + up, 4 * along + up, 1), 1e-8));
        for (const double behind : {1.05e-9, 5e-9, 1e-6})
            CHECK_THAT(start_behind(behind), IsNear(flying(9 * along - 2 * up, 4 * along - 2 * up, 1), 1e-5));
    }
}

TEST_CASE("a particle that approaches faster than contact_tolerance bounces, however slow it is", "[11.8]") {
    // a tenth of a millimetre in a day, towards a wall that is flat, slanted or upright
    for (const Vec2 &along : {Vec2{1, 0}, Vec2{0.8, 0.6}, Vec2{0, -1}}) {
        const Vec2 up{-along.y(), along.x()};
        const std::vector<Wall> walls{{.start = -20 * along, .end = 20 * along}};
        CHECK_THAT(move_and_collide(flying(5e-5 * up, -1.05e-9 * up), walls, 1, 1e5),
                   IsNear(flying(5.5e-5 * up, 1.05e-9 * up, 1e5), rounding_of_1e5));
        CHECK_THAT(move_and_collide(flying(5e-5 * up, -0.95e-9 * up), walls, 1, 1e5),
                   IsNear(flying(-4.5e-5 * up, -0.95e-9 * up, 1e5), rounding_of_1e5));
    }
    // fast along it
    CHECK_THAT(move_and_collide(flying({-5e4, 2e-5}, {100, -5e-8}), endless, 1, 1000),
               IsNear(flying({5e4, 3e-5}, {100, 5e-8}, 1000), 2 * rounding));
    for (const double slow : {5e-3, 5e-4, 5e-7}) // half the speed comes back
        CHECK_THAT(move_and_collide(flying({4, 100 * slow}, {0, -slow}), ground, 0.5, 200),
                   IsNear(flying({4, 50 * slow}, {0, slow / 2}, 200), rounding));
    CHECK_THAT(move_and_collide(flying({4, 3}, {5e-10, 0}), ground, 1, 1e5),
               IsNear(flying({4 + 5e-5, 3}, {5e-10, 0}, 1e5), rounding_of_1e5));
}

TEST_CASE("a dt may be very short or very long", "[11.8]") {
    CHECK_THAT(move_and_collide(flying({4, 3}, {1e5, 0}), ground, 1, 5e-10),
               IsNear(flying({4 + 5e-5, 3}, {1e5, 0}, 5e-10), rounding_of_1e5));
    CHECK_THAT(move_and_collide(flying({4, 5e-5}, {0, -1e5}), ground, 1, 1e-5),
               IsNear(flying({4, 1 - 5e-5}, {0, 1e5}, 1e-5), rounding_of_1e5)); // at once
    CHECK_THAT(move_and_collide(flying({4, 1}, {0, -1e5}), ground, 1, 1e-5 + 5e-10),
               IsNear(flying({4, 5e-5}, {0, 1e5}, 1e-5 + 5e-10), rounding_of_1e5));
    CHECK_THAT(move_and_collide(flying({4, 1}, {0, -1}), ground, 1, 1 - 5e-7),
               IsNear(flying({4, 5e-7}, {0, -1}, 1 - 5e-7), rounding)); // not yet
    CHECK_THAT(move_and_collide(flying({4, 1}, {0, -1e5}), ground, 1, 1e-5 - 5e-10),
               IsNear(flying({4, 5e-5}, {0, -1e5}, 1e-5 - 5e-10), rounding_of_1e5)); // nor here
    CHECK_THAT(move_and_collide(flying({4, 50}, {0, -1e-3}), ground, 1, 1e5),
               IsNear(flying({4, 50}, {0, 1e-3}, 1e5), rounding_of_1e5));
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), ground, -0.0, 2), IsNear(flying({8, 0}, {2, 0}, 2), rounding));
}

TEST_CASE("input may be as large as 1e5, and the result larger", "[11.8]") {
    CHECK_THAT(move_and_collide({{1e5, -1e5}, {1e5, -1e5}, 1e5, 1e5}, {}, 1, 1e5),
               IsNear(Particle{{1e10 + 1e5, -1e10 - 1e5}, {1e5, -1e5}, 2e5, 1e5}, rounding));
    const std::vector<Wall> floor{{.start = {-1e5, -1e5}, .end = {1e5, -1e5}}}; // 200 km below
    CHECK_THAT(move_and_collide(flying({0, 1e5}, {0, -1e5}), floor, 1, 3),
               IsNear(flying({0, 0}, {0, 1e5}, 3), rounding_of_1e5));

    // a wall at 22.5 degrees reflects a particle that falls at 45 degrees straight up
    const Vec2 along{std::cos(pi / 8), std::sin(pi / 8)}, normal{-along.y(), along.x()}, falling{1e5, -1e5},
        up{0, 1e5 * std::sqrt(2)};
    const std::vector<Wall> leaning{{.start = -1000 * along, .end = 1000 * along}};
    const double t = -10 / falling.dot(normal);
    CHECK_THAT(move_and_collide(flying(10 * normal, falling), leaning, 1, 1),
               IsNear(flying(10 * normal + t * falling + (1 - t) * up, up, 1), 1e-11));
}

TEST_CASE("with restitution 0 a particle slides along the wall and stays on it", "[11.8]") {
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), ground, 0, 6), IsNear(flying({16, 0}, {2, 0}, 6), 1e-9));

    const Vec2 along{0.8, 0.6}, up{-0.6, 0.8}; // a slope whose coordinates are rounded
    const std::vector<Wall> slope{{.start = -1000 * along, .end = 1000 * along}};
    Particle now = move_and_collide(flying(3 * up, 2 * along - 3 * up), slope, 0, 1); // it is on the slope after 1 s
    for (int frame = 0; frame < 200; ++frame) now = move_and_collide(now, slope, 0, 1.0 / 64);
    CHECK_THAT(now.position, IsNear(Vec2{(2 + 2 * 200 / 64.0) * along}, 1e-9).of("position [m]"));
    CHECK_THAT(now.velocity, IsNear(Vec2{2 * along}, 1e-9).of("velocity [m/s]"));
}

TEST_CASE("in a corner both walls reflect the particle", "[11.8]") {
    // it reaches (8, 6) after 1 s, and flies back for 1 s at half the speed
    CHECK_THAT(move_and_collide(flying({5, 4}, {3, 2}), box, 0.5, 2), IsNear(flying({6.5, 5}, {-1.5, -1}, 2), 1e-11));
    CHECK_THAT(move_and_collide(flying({3, 2}, {-3, -2}), box, 1, 2), IsNear(flying({3, 2}, {3, 2}, 2), 1e-11));
    // along the ground into the corner under a slope: each wall takes a part of the speed, until the particle is at rest
    CHECK_THAT(move_and_collide(flying({8, 3}, {-2, -4}), {{{-20, 0}, {20, 0}}, {{12, 9}, {-12, -9}}}, 0, 9),
               IsNear(flying({0, 0}, {0, 0}, 9), 1e-7));
    // two walls that overlap: after the first it does not approach the second
    CHECK_THAT(move_and_collide(flying({4, 3}, {2, -2}), {{{0, 0}, {12, 0}}, {{5, 0}, {20, 0}}}, 0.5, 2),
               IsNear(flying({8, 0.5}, {2, 1}, 2), rounding));
}

TEST_CASE("in a corner of any angle a particle bounces until it approaches neither wall", "[11.8]") {
    const int parts = GENERATE(2, 3, 5, 9, 18); // of 180 degrees; the walls extend beyond the corner
    const double angle = pi / parts;
    const auto to = [](double at) { return Vec2{std::cos(at), std::sin(at)}; };
    const std::vector<Wall> corner{{{-100, 0}, {100, 0}}, {100 * to(angle), -100 * to(angle)}};
    // Mirror the corner in its walls again and again: the path becomes straight. Then fold it back.
    const auto folded = [&](const Vec2 &v) {
        const double turn = std::fmod(std::atan2(v.y(), v.x()) + 2 * pi, 2 * angle);
        return Vec2{v.norm() * to(std::min(turn, 2 * angle - turn))};
    };
    for (const double share : {0.1, 0.3, 0.5, 0.9}) {
        const Vec2 from = 2 * to(share * angle);
        // exactly into the corner: after 1 s it is as far outside as it was, on a straight line
        const Vec2 out = folded(-from);
        CHECK_THAT(move_and_collide(flying(from, -2 * from), corner, 1, 1), IsNear(flying(out, 2 * out, 1), 1e-9));
        // next to the corner
        const Vec2 velocity = 5 * to(pi + share / 10), after = from + 3 * velocity;
        CHECK_THAT(move_and_collide(flying(from, velocity), corner, 1, 3).position,
                   IsNear(folded(after), 1e-9).of("position [m]"));
    }
}

//> Unfolded
TEST_CASE("in a box with restitution 1 the particle ends where the mirror-image construction puts it", "[11.8]") {
    // Mirror the box in its walls again and again: the path becomes straight. Then fold it back.
    const auto folded = [](double x, double width) {
        const double in_two = std::fmod(std::fmod(x, 2 * width) + 2 * width, 2 * width);
        return width - std::abs(width - in_two);
    };
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 from{dice.real(0.01, 7.99), dice.real(0.01, 5.99)}, velocity = dice.point(-30, 30);
        const double dt = dice.real(0, 3);
        const Particle after = move_and_collide(flying(from, velocity), box, 1, dt);

        const Vec2 straight = from + dt * velocity;
        // up to 40 bounces, each with a few roundings of up to 90 m
        CHECK_THAT(after.position,
                   IsNear(Vec2{folded(straight.x(), 8), folded(straight.y(), 6)}, 1e-9).of("position [m]"));
        CHECK_THAT(after.velocity.cwiseAbs(),
                   IsNear(Vec2{velocity.cwiseAbs()}, 1e-9).of("velocity without its signs [m/s]"));
    }
}

//> Between two walls
TEST_CASE("between two walls each bounce multiplies the speed by the restitution", "[11.8]") {
    const double e = GENERATE(0.3, 0.5, 0.9, 1.0);
    const double width = 0.5, speed = 5;
    const int bounces = GENERATE_COPY(1, 2, 3, e < 0.9 ? 6 : 100);
    // from the left wall: 0.5/5 s to the right one, then e times as fast, …
    double time = 0, now = speed;
    for (int i = 0; i < bounces; ++i, now *= e) time += width / now;
    const double rest = 0.25 * width / now; // and a quarter of the distance back
    const std::vector<Wall> walls{{{0, 9}, {0, -9}}, {{width, -9}, {width, 9}}};

    const Particle after = move_and_collide(flying({0, 0}, {speed, 0}), walls, e, time + rest);

    const bool moving_left = bounces % 2 == 1;
    const double x = moving_left ? 0.75 * width : 0.25 * width;
    CHECK_THAT(after, IsNear(flying({x, 0}, {moving_left ? -now : now, 0}, time + rest), 1e-9));
}

namespace {

/// A cave with seven corners, one of which points inwards.
const std::vector<Vec2> cave{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};

std::vector<Wall> walls_of(const std::vector<Vec2> &room) {
    std::vector<Wall> walls;
    for (std::size_t i = 0; i < room.size(); ++i) walls.push_back({room[i], room[(i + 1) % room.size()]});
    return walls;
}

/// How far a point is outside the cave [m]; 0 or less: it is inside or on a wall. A point is inside if a ray to the right
/// crosses the walls an odd number of times.
double outside(const Vec2 &p, const std::vector<Vec2> &room) {
    bool inside = false;
    double nearest = infinity;
    for (std::size_t i = 0; i < room.size(); ++i) {
        const Vec2 &a = room[i], &b = room[(i + 1) % room.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
        const double s = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - s * (b - a)).norm());
    }
    return inside ? -nearest : nearest;
}

} // namespace

//> No escape, and no gain
TEST_CASE("in a cave no particle escapes or gains energy", "[11.8]") {
    const double e = GENERATE(1.0, 0.97);
    const std::vector<Wall> walls = walls_of(cave);
    Dice dice;
    Particle now = flying({2, 3}, {23, 11});
    for (int frame = 0; frame < course::cases(20000); ++frame) {
        const Particle after =
            move_and_collide(now, walls, e, dice.real(0, 0.2)); // up to five metres, and several walls

        CHECK_THAT(outside(after.position, cave), IsBelow(1e-9).of("distance outside the cave [m]"));
        CHECK_THAT(after.velocity.norm(), IsAtMost(now.velocity.norm() * (1 + rounding)).of("speed [m/s]"));
        if (e == 1) CHECK_THAT(after.velocity.norm(), IsNear(now.velocity.norm(), rounding).of("speed [m/s]"));
        now = {after.position, after.velocity, 0, 1e5};
    }
}

//>
TEST_CASE("a particle at 90 km/s does not skip a fence", "[11.8]") {
    // 90 km in one call, and a fence 2 m high
    const std::vector<Wall> fence{{.start = {5, -1}, .end = {5, 1}}};
    CHECK_THAT(move_and_collide(flying({-45000, 0}, {90000, 0}), fence, 1, 1),
               IsNear(flying({-44990, 0}, {-90000, 0}, 1), 1e-9));
}

TEST_CASE("a call ends after max_bounces bounces, with the particle between the walls", "[11.8]") {
    const std::vector<Wall> slit{{{0, 9}, {0, -9}}, {{0.01, -9}, {0.01, 9}}};
    const Particle after = move_and_collide(flying({0.005, 0}, {1e5, 0}), slit, 1, 1e4); // this would be 1e11 bounces
    CHECK_THAT(after.position.x(), IsAbove(-1e-9).of("position along x [m]"));
    CHECK_THAT(after.position.x(), IsBelow(0.01 + 1e-9).of("position along x [m]"));
    CHECK_THAT(after.position.y(), IsNear(0.0, 1e-9).of("position along y [m]"));
    CHECK_THAT(std::abs(after.velocity.x()), IsNear(1e5, 1e-9).of("speed along x [m/s]"));
    CHECK_THAT(after.age, IsNear(1e4, rounding).of("age [s]"));

    // A bounce near 1e5: where the path would end without the wall is beyond it.
    const std::vector<Wall> near_the_limit{{.start = {99999.9, -9}, .end = {99999.9, 9}}};
    CHECK_THAT(move_and_collide(flying({99999.5, 0}, {1, 0}), near_the_limit, 1, 1),
               IsNear(flying({99999.3, 0}, {-1, 0}, 1), rounding_of_1e5));
}

TEST_CASE("the 1000th bounce is the last, and each call counts from 0", "[11.8]") {
    // it crosses 1024 times per second, at first from x = 0.25: no time is rounded
    const std::vector<Wall> slit{{{0, 9}, {0, -9}}, {{1, -9}, {1, 9}}};
    const auto time = [](double bounces) { return (bounces - 0.25) / 1024; };
    const auto after = [&](double bounces) {
        return move_and_collide(flying({0.25, 0}, {1024, 0}), slit, 1, time(bounces));
    };
    const auto is_at = [&](double x, double velocity, double bounces) {
        return IsNear(flying({x, 0}, {velocity, 0}, time(bounces)), 1e-9);
    };
    static_assert(max_bounces == 1000);
    CHECK_THAT(after(998.5), is_at(0.5, 1024, 998.5));
    CHECK_THAT(after(999.5), is_at(0.5, -1024, 999.5));
    for (const double more : {1000.5, 1001.5, 1002.5, 3000.5}) CHECK_THAT(after(more), is_at(0, 1024, more));
    for (int again = 0; again < 20; ++again)
        CHECK_THAT(after(700.5), is_at(0.5, 1024, 700.5)); // each call counts from 0

    // back and forth along a square's diagonal: each corner takes two bounces
    const std::vector<Wall> square{{{-1, 0}, {2, 0}}, {{1, -1}, {1, 2}}, {{2, 1}, {-1, 1}}, {{0, 2}, {0, -1}}};
    const auto in_corners = [&](double corners) {
        return move_and_collide(flying({0, 0}, {1024, 1024}), square, 1, corners / 1024);
    };
    CHECK_THAT(in_corners(499.5), IsNear(flying({0.5, 0.5}, {-1024, -1024}, 499.5 / 1024), 1e-9));
    CHECK_THAT(in_corners(500.5), IsNear(flying({0, 0}, {1024, 1024}, 500.5 / 1024), 1e-9));
}

TEST_CASE("an invalid particle, wall, restitution or dt is refused", "[11.8]") {
    const auto check_refused = [](const Particle &particle, double dt) {
        const Wall good = ground[0];
        const auto fly_among = [&](const std::vector<Wall> &walls) {
            return move_and_collide(particle, walls, 0.5, dt);
        };
        for (const Vec2 &end : {Vec2{0, 0}, Vec2{0, 0.0009}, Vec2{1e-3 - 5e-8, 0}, Vec2{6e-4, 6e-4}}) {
            CHECK_REFUSED(fly_among({{{0, 0}, end}}), "the only wall is shorter than 1e-3 m");
            CHECK_REFUSED(fly_among({good, {{0, 0}, end}}), "the second wall is shorter than 1e-3 m");
            CHECK_REFUSED(fly_among({{{0, 0}, end}, good}), "the first wall is shorter than 1e-3 m");
        }
        CHECK_REFUSED(fly_among({good, {{900, 900}, {900, 900}}}), "a wall far away is a point");
        for (const std::vector<Wall> &walls : {ground, std::vector<Wall>{}}) {
            for (const double bad : {-0.1, -1e-9, 1.1, 1 + 1e-9})
                CHECK_REFUSED(move_and_collide(particle, walls, bad, dt), "restitution is not from 0 to 1");
            for (const double bad : {-1.0, -1e-9})
                CHECK_REFUSED(move_and_collide(particle, walls, 0.5, bad), "dt is negative");
            check_age_and_life_refused(particle,
                                       [&](const Particle &bad) { return move_and_collide(bad, walls, 0.5, dt); });
        }
    };
    check_refused(flying({4, 3}, {2, -2}), 1);
    check_refused(flying({4, 3}, {0, 0}), 1);  // at rest
    check_refused({{4, 3}, {2, -2}, 7, 5}, 0); // dead, with dt = 0
}

// --------------------------------------------------------------------------------------------------- 11.9 compact_pool

namespace {

/// One particle for each letter, numbered from 1 so that a verdict is easy to read; a dot is a dead one, of age 10 s.
std::vector<Particle> row_of(const std::string &letters) {
    std::vector<Particle> row;
    for (const char letter : letters) {
        const double number = double(row.size()) + 1;
        row.push_back(
            {.position = {number, 0}, .velocity = {0, number}, .age = letter == '.' ? 10 : number, .life = 10});
    }
    return row;
}

bool lives(const Particle &particle) { return particle.age < particle.life; }

/// Checks everything that the header says about `compact_pool`.
void check_compacted(const std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity) {
    const std::vector<Particle> after = compact_pool(pool, newborn, capacity);

    const auto living = std::size_t(std::ranges::count_if(pool, lives));
    const std::size_t fit = std::min(newborn.size(), std::size_t(capacity) - living);
    CHECK_THAT(after, HasSize(living + fit));
    for (std::size_t i = 0; i < living; ++i)
        if (lives(pool[i])) CHECK_THAT(after[i], IsNear(pool[i]).of("a particle that need not move"));
    for (const Particle &particle : pool) // none is lost, none is there twice
        if (lives(particle)) {
            const auto found = std::count_if(after.begin(), after.begin() + std::ptrdiff_t(living),
                                             [&](const Particle &other) { return same(particle, other); });
            CHECK_THAT(int(found), IsNear(1).of("places of the same particle"));
        }
    for (std::size_t i = 0; i < fit; ++i) CHECK_THAT(after[living + i], IsNear(newborn[i]).of("a newborn particle"));
}

} // namespace

//> The last one moves
TEST_CASE("the worked example: the last particle fills the gap, and no other moves", "[11.9]") {
    const std::vector<Particle> five = row_of("ab.de"); // the third of five is dead
    const Particle young{.position = {9, 9}, .velocity = {1, 1}, .age = 0, .life = 2};
    CHECK_THAT(compact_pool(five, {}, 8), IsNear(std::vector{five[0], five[1], five[4], five[3]}));
    CHECK_THAT(compact_pool(five, {young}, 8), IsNear(std::vector{five[0], five[1], five[4], five[3], young}));
}

//>
TEST_CASE("a gap is never filled with a dead particle", "[11.9]") {
    const std::vector<Particle> row = row_of("a.c..");
    CHECK_THAT(compact_pool(row, {}, 5), IsNear(std::vector{row[0], row[2]}));
    const std::vector<Particle> other = row_of(".b.");
    CHECK_THAT(compact_pool(other, {}, 3), IsNear(std::vector{other[1]}));
    const std::vector<Particle> three = row_of(".bc.e."); // the header's example
    CHECK_THAT(compact_pool(three, {}, 6), IsNear(std::vector{three[4], three[1], three[2]}));
}

TEST_CASE("without dead particles none moves, even if two are equal", "[11.9]") {
    const std::vector<Particle> row = row_of("abcdefg");
    for (const int capacity : {7, 100, 1'000'001, std::numeric_limits<int>::max()})
        CHECK_THAT(compact_pool(row, {}, capacity), IsNear(row));

    CHECK_THAT(compact_pool({spark, spark}, {spark}, 3), IsNear(std::vector{spark, spark, spark}));
}

TEST_CASE("if all are dead the pool is emptied, and the newborn have room", "[11.9]") {
    CHECK_THAT(compact_pool(row_of("...."), {}, 4), IsNear(std::vector<Particle>{}));
    CHECK_THAT(compact_pool({}, {}, 0), IsNear(std::vector<Particle>{}));
    const std::vector<Particle> young{numbered(50), numbered(60), numbered(70)};
    CHECK_THAT(compact_pool(row_of("...."), young, 4), IsNear(young));
}

TEST_CASE("the newborn are added in their order, until the capacity is reached", "[11.9]") {
    const std::vector<Particle> row = row_of("ab"), young{numbered(50), numbered(60), numbered(70)};
    CHECK_THAT(compact_pool(row, young, 4), IsNear(std::vector{row[0], row[1], young[0], young[1]}));
    CHECK_THAT(compact_pool(row, young, 2), IsNear(row));
    CHECK_THAT(compact_pool(row_of("a."), young, 2), IsNear(std::vector{row[0], young[0]})); // the dead make room first
    const int most = std::numeric_limits<int>::max();
    CHECK_THAT(compact_pool({row[0]}, {young[0]}, most), IsNear(std::vector{row[0], young[0]}));
}

TEST_CASE("a newborn particle is added unchanged, even if its age has reached its life", "[11.9]") {
    const Particle old{.position = {1, 2}, .velocity = {3, 4}, .age = 7, .life = 5};
    CHECK_THAT(compact_pool({}, {old}, 1), IsNear(std::vector{old}));
    for (const Particle &particle : unusual) CHECK_THAT(compact_pool({}, {particle}, 1), IsNear(std::vector{particle}));
}

TEST_CASE("a pool may hold thousands of particles", "[11.9]") {
    const auto check_is = [](const std::vector<Particle> &after, const std::vector<Particle> &want) {
        CHECK_THAT(after, HasSize(want.size()));
        CHECK_THAT(std::ranges::equal(after, want, same), IsTrue("each place holds the particle that belongs there"));
    };
    std::vector<Particle> alive(1000, spark);
    alive.front() = numbered(3);
    check_is(compact_pool(alive, {}, 1000), alive);

    std::vector<Particle> pool(more_than_16_bits, spark);
    pool.back() = numbered(7);
    for (const std::size_t i : {std::size_t(0), pool.size() - 2}) pool[i].age = pool[i].life;
    std::vector<Particle> want(pool.size() - 2, spark);
    want[0] = pool.back(); // the last one moves there
    check_is(compact_pool(pool, {}, more_than_16_bits), want);

    const std::vector<Particle> newborn(10'001, numbered(3));
    check_is(compact_pool({}, newborn, 1'000'001), newborn);
}

TEST_CASE("a particle is dead if its age equals its life or is greater", "[11.9]") {
    const auto aged = [](double age) { return std::vector{Particle{{1, 2}, {0, 0}, age, 5}}; };
    CHECK_THAT(compact_pool(aged(4.9), {}, 1), IsNear(aged(4.9)));
    CHECK_THAT(compact_pool(aged(5), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(compact_pool(aged(5.1), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(compact_pool(aged(1e5), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(compact_pool(aged(std::nextafter(5, 0)), {}, 1), IsNear(aged(std::nextafter(5, 0))));
    for (const Particle &particle : unusual)
        CHECK_THAT(compact_pool({particle}, {}, 1),
                   IsNear(lives(particle) ? std::vector{particle} : std::vector<Particle>{}));
}

//> Every pattern of eight
TEST_CASE("for every choice of dead among 8, all others survive, and only those past the new end move", "[11.9]") {
    for (int pattern = 0; pattern < 256; ++pattern) {
        std::vector<Particle> pool = row_of("abcdefgh");
        for (std::size_t i = 0; i < 8; ++i)
            if (pattern >> i & 1) pool[i].age = pool[i].life;
        check_compacted(pool, {}, 8);
    }
}

//>
TEST_CASE("in random pools no particle is lost or doubled, and none moves without need", "[11.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000) / 10; ++i) {
        std::vector<Particle> pool, newborn;
        const int size = dice.whole(0, 60), young = dice.whole(0, 20);
        for (int k = 0; k < size; ++k) {
            pool.push_back(numbered(k));
            if (dice.whole(0, 2) == 0) pool.back().age = pool.back().life + dice.whole(0, 1);
        }
        for (int k = 0; k < young; ++k) newborn.push_back(numbered(100 + k));
        check_compacted(pool, newborn, size + dice.whole(0, 10));
    }
}

TEST_CASE("an invalid particle anywhere, and a capacity below the pool's size, are refused", "[11.9]") {
    const std::vector<Particle> row = row_of("ab.");
    for (const int capacity : {2, 1, 0, -1})
        CHECK_REFUSED(compact_pool(row, {}, capacity),
                      "capacity is less than the pool holds"); // it holds three, one of them dead
    for (const int capacity : {-1, std::numeric_limits<int>::min()}) {
        CHECK_REFUSED(compact_pool({}, {}, capacity), "capacity is negative");
        CHECK_REFUSED(compact_pool({}, {row[0]}, capacity), "capacity is negative");
    }
    for (const int first : {0, 1, 2}) { // which of them is dead
        std::vector<Particle> others = row_of("abc");
        others[std::size_t(first)].age = others[std::size_t(first)].life;
        for (const std::size_t i : {0u, 1u, 2u}) {
            check_age_and_life_refused(others[i], [&](const Particle &bad) {
                std::vector<Particle> pool = others;
                pool[i] = bad;
                return compact_pool(pool, {}, 3);
            });
            check_age_and_life_refused(others[i], [&](const Particle &bad) {
                std::vector<Particle> newborn = others;
                newborn[i] = bad;
                return compact_pool({}, newborn, 0);
            });
        }
    }
    std::vector<Particle> large(131, spark);
    large.back().life = 0;
    CHECK_REFUSED(compact_pool(large, {}, 131), "the last of 131 particles has a life of 0");
}

// ------------------------------------------------------------------------------------------------------ 11.10 run_show

namespace {

using particles::Rocket, particles::Rules, particles::Show;

// A burst of four at 2 m/s: to the right, up, to the left and down.
const std::vector<double> cross{0.25, 0, 0.25, 0.25, 0.25, 0.5, 0.25, 0.75};
constexpr Rules rules{.gravity = 10, .places = 100, .speed = 4, .life = 2};

/// Pairs of random numbers for so many sparks, evenly around.
std::vector<double> pairs(int sparks) {
    std::vector<double> numbers;
    for (int i = 0; i < sparks; ++i) {
        numbers.push_back(0.25);
        numbers.push_back(double(i) / sparks);
    }
    return numbers;
}

/// A rocket that waits on the street, rises straight up at 10 m/s, and bursts a second later, 5 m up.
Rocket rising(double wait, int sparks, double x = 0) { return {wait, {x, 0}, {0, 10}, pairs(sparks)}; }

Show show_of(const std::vector<Rocket> &rockets) { return {rockets, {}, 0, 0, 0}; }

double how_far(const Particle &a, const Particle &b) {
    return (a.position - b.position).norm() + (a.velocity - b.velocity).norm() + std::abs(a.age - b.age)
           + std::abs(a.life - b.life);
}

/// The same show with its sparks in the order of another one's, because any order is right.
Show in_order_of(const Show &other, Show show) {
    if (show.sparks.size() != other.sparks.size()) return show;
    for (std::size_t i = 0; i < show.sparks.size(); ++i)
        for (std::size_t k = i + 1; k < show.sparks.size(); ++k)
            if (how_far(show.sparks[k], other.sparks[i]) < how_far(show.sparks[i], other.sparks[i]))
                std::swap(show.sparks[i], show.sparks[k]);
    return show;
}

/// The show after so many frames that last `time` in all.
Show after_frames(Show now, const Rules &by, double time, int frames) {
    for (int i = 0; i < frames; ++i) now = run_show(now, by, time / frames);
    return now;
}

/// Up to eight rockets of up to six sparks each, which burst within some five seconds.
Show random_show(Dice &dice) {
    Show show;
    for (int rockets = dice.whole(1, 8); rockets > 0; --rockets) {
        Rocket next;
        next.wait = dice.real(0, 4);
        next.position.x() = dice.real(-20, 20);
        next.position.y() = dice.real(0, 2);
        next.velocity.x() = dice.real(-3, 3);
        next.velocity.y() = dice.real(4, 16);
        for (int numbers = 2 * dice.whole(0, 6); numbers > 0; --numbers) next.random_numbers.push_back(dice.real(0, 1));
        show.rockets.push_back(next);
    }
    return show;
}

/// Few places, so that some sparks are lost, and lives so long that some fall into the street.
Rules random_rules(Dice &dice) {
    Rules by;
    by.gravity = dice.real(5, 15);
    by.places = dice.whole(0, 20);
    by.speed = dice.real(0, 6);
    by.life = dice.real(0.2, 3);
    return by;
}

int sparks_in(const std::vector<Rocket> &rockets) {
    std::size_t numbers = 0;
    for (const Rocket &each : rockets) numbers += each.random_numbers.size();
    return int(numbers / 2);
}

} // namespace

//> It waits, and rises
TEST_CASE("waits 1 s, then rises at 10 m/s: half a second after take-off it's 3.75 m up, at 5 m/s", "[11.10]") {
    const Show start = show_of({{1, {3, 0}, {2, 10}, cross}});
    CHECK_THAT(run_show(start, rules, 0.5), IsNear(show_of({{0.5, {3, 0}, {2, 10}, cross}}), rounding));
    CHECK_THAT(run_show(start, rules, 1), IsNear(show_of({{0, {3, 0}, {2, 10}, cross}}), rounding));
    CHECK_THAT(run_show(start, rules, 1.5), IsNear(show_of({{0, {4, 3.75}, {2, 5}, cross}}), rounding));
}

//> It bursts
TEST_CASE("bursts at the top, 5 m up, and its four sparks share its 2 m/s to the right", "[11.10]") {
    const Show start = show_of({{1, {3, 0}, {2, 10}, cross}});
    const Show want{
        {}, {{{5, 5}, {4, 0}, 0, 2}, {{5, 5}, {2, 2}, 0, 2}, {{5, 5}, {0, 0}, 0, 2}, {{5, 5}, {2, -2}, 0, 2}}, 4, 0, 4};
    CHECK_THAT(in_order_of(want, run_show(start, rules, 2)), IsNear(want, rounding).of("show"));
    CHECK_THAT(run_show(start, rules, 1.875), IsNear(show_of({{0, {4.75, 4.921875}, {2, 1.25}, cross}}), rounding));
}

TEST_CASE("within one frame of 2.5 s it waits, rises and bursts, and its sparks fly for half a second", "[11.10]") {
    const Show start = show_of({{1, {3, 0}, {2, 10}, cross}});
    const Show want{{},
                    {{{7, 3.75}, {4, -5}, 0.5, 2},
                     {{6, 4.75}, {2, -3}, 0.5, 2},
                     {{5, 3.75}, {0, -5}, 0.5, 2},
                     {{6, 2.75}, {2, -7}, 0.5, 2}},
                    4,
                    0,
                    4};
    CHECK_THAT(in_order_of(want, run_show(start, rules, 2.5)), IsNear(want, rounding).of("show"));
}

TEST_CASE("bursts as it takes off if it doesn't rise, and what's due in a frame of 0 s happens, too", "[11.10]") {
    for (const double up : {0.0, -3.0}) {
        const Show start = show_of({{0, {1, 7}, {0, up}, pairs(1)}, {0.5, {2, 7}, {0, up}, pairs(1)}});
        const Show now{{start.rockets[1]}, {{{1, 7}, {2, up}, 0, 2}}, 1, 0, 1};
        CHECK_THAT(run_show(start, rules, 0), IsNear(now, rounding));
        CHECK_THAT(run_show(start, rules, 0.5).rockets, HasSize(0).of("rockets after 0.5 s"));
    }
    const Show street = show_of({{0, {1, 0}, {0, 0}, pairs(1)}}); // its spark isn't below the street
    CHECK_THAT(run_show(street, rules, 0), IsNear(Show{{}, {{{1, 0}, {2, 0}, 0, 2}}, 1, 0, 1}, rounding));
}

//> They go out
TEST_CASE("its sparks glow for 2 s, and are gone at that moment, not a frame later", "[11.10]") {
    const Rules weak{.gravity = 1, .places = 100, .speed = 4, .life = 2};
    const Show start = show_of({{0, {0, 90}, {0, 1}, cross}}); // it bursts after 1 s
    CHECK_THAT(run_show(start, weak, 2.875).sparks, HasSize(4).of("sparks 1.875 s after the burst"));
    CHECK_THAT(run_show(start, weak, 3), IsNear(Show{{}, {}, 4, 0, 4}));
    CHECK_THAT(run_show(start, weak, 9), IsNear(Show{{}, {}, 4, 0, 4}));
    // Each by its own life, not by the rules'.
    const Show two{{}, {{{0, 5}, {0, 0}, 3, 3}, {{0, 5}, {0, 0}, 2.5, 3}, {{0, 5}, {0, 0}, 0, 0.25}}, 0, 0, 3};
    CHECK_THAT(run_show(two, rules, 0.25), IsNear(Show{{}, {{{0, 4.6875}, {0, -2.5}, 2.75, 3}}, 0, 0, 3}, rounding));
}

TEST_CASE("a spark that falls below the street is out, however young, and one that's above it isn't", "[11.10]") {
    // Dropped from 5 m, it's 1.8 m up after 0.8 s, and below the street after 1.1 s.
    const Show start{{}, {{{3, 5}, {1, 0}, 0, 9}, {{3, 5}, {0, 8}, 0, 9}}, 2, 0, 2};
    const Show both{{}, {{{3.8, 1.8}, {1, -8}, 0.8, 9}, {{3, 8.2}, {0, 0}, 0.8, 9}}, 2, 0, 2};
    const Show one{{}, {{{3, 7.75}, {0, -3}, 1.1, 9}}, 2, 0, 2};
    CHECK_THAT(in_order_of(both, run_show(start, rules, 0.8)), IsNear(both, rounding).of("show"));
    CHECK_THAT(run_show(start, rules, 1.1), IsNear(one, rounding));
    CHECK_THAT(run_show(start, rules, 3), IsNear(Show{{}, {}, 2, 0, 2}));
}

//> Too few places
TEST_CASE("with 6 places, the first 6 of its 9 sparks glow, in the order of its numbers, and 3 are lost", "[11.10]") {
    const Rules six{.gravity = 10, .places = 6, .speed = 4, .life = 2};
    const Show start = show_of({{0, {0, 5}, {1, 0}, pairs(9)}});
    Show want{{}, {}, 6, 3, 6};
    for (const double turn : {0.0, 40.0, 80.0, 120.0, 160.0, 200.0})
        want.sparks.push_back({{0, 5}, {1 + 2 * std::cos(turn * pi / 180), 2 * std::sin(turn * pi / 180)}, 0, 2});
    CHECK_THAT(in_order_of(want, run_show(start, six, 0)), IsNear(want, rounding).of("show"));
    const Rules no_place{.gravity = 10, .places = 0, .speed = 4, .life = 2};
    CHECK_THAT(run_show(start, no_place, 0), IsNear(Show{{}, {}, 0, 9, 0}));
}

//> Places become free
TEST_CASE("sparks that go out in the middle of a frame make room, and those that glow a bit longer don't", "[11.10]") {
    const Rules four{.gravity = 10, .places = 4, .speed = 1, .life = 0.75};
    const auto both = [&](double later) { return show_of({rising(0, 4), rising(later, 4)}); };
    CHECK_THAT(run_show(both(0.875), four, 3), IsNear(Show{{}, {}, 8, 0, 4})); // they're out before
    CHECK_THAT(run_show(both(0.5), four, 3), IsNear(Show{{}, {}, 4, 4, 4}));   // they glow
    CHECK_THAT(run_show(both(0.75), four, 3), IsNear(Show{{}, {}, 8, 0, 4}));  // they go out at that moment
    const Show start{{rising(0, 4)}, {{{0, 1}, {0, 0}, 0, 9}}, 1, 0, 1};       // it's in the street after 0.45 s
    CHECK_THAT(run_show(start, four, 3), IsNear(Show{{}, {}, 5, 0, 4}));
}

//> Two in a frame
TEST_CASE("of two that burst within a frame, the earlier one gets the places, wherever it's in the list", "[11.10]") {
    const Rules four{.gravity = 10, .places = 4, .speed = 1, .life = 8};
    const Rocket early{0, {-9, 0}, {0, 10}, cross}, late{0.25, {9, 0}, {0, 10}, cross};
    for (const bool swapped : {false, true}) {
        const Show after = run_show(show_of(swapped ? std::vector{late, early} : std::vector{early, late}), four, 1.5);
        CHECK_THAT(after.sparks, HasSize(4).of("sparks"));
        for (const Particle &each : after.sparks) CHECK_THAT(each.position.x(), IsBelow(0).of("x of a spark [m]"));
        CHECK_THAT(after.lost, IsNear(4).of("sparks lost"));
    }
}

TEST_CASE("of two that burst at the same moment, the first one in the list gets the places", "[11.10]") {
    const Rules four{.gravity = 10, .places = 4, .speed = 1, .life = 8};
    const Rocket left{0.5, {-9, 0}, {0, 5}, cross}, right{0, {9, 0}, {0, 10}, cross}; // both after 1 s
    for (const bool swapped : {false, true}) {
        const Show after = run_show(show_of(swapped ? std::vector{right, left} : std::vector{left, right}), four, 1.25);
        CHECK_THAT(after.sparks, HasSize(4).of("sparks"));
        for (const Particle &each : after.sparks)
            CHECK_THAT(swapped ? each.position.x() : -each.position.x(), IsAbove(0).of("on that rocket's side [m]"));
    }
}

//> The most at one time
TEST_CASE("knows the most that glowed at one time, even if all of it happened within one frame", "[11.10]") {
    const Rules brief{.gravity = 10, .places = 100, .speed = 1, .life = 0.5};
    const Show start = show_of({rising(0, 7), rising(0.25, 5), rising(1, 9), rising(2, 1)}); // 7, then 12, then 9
    CHECK_THAT(run_show(start, brief, 10), IsNear(Show{{}, {}, 22, 0, 12}));
    const Show before{{rising(0, 3)}, {}, 30, 2, 20};
    CHECK_THAT(run_show(before, brief, 10), IsNear(Show{{}, {}, 33, 2, 20})); // 20 it was, and stays
}

TEST_CASE("those that haven't burst stay in their order, with their numbers", "[11.10]") {
    const std::vector<Rocket> five{rising(3, 1, 1), rising(0, 2, 2), rising(5, 3, 3), rising(0.25, 4, 4),
                                   rising(4, 5, 5)};
    const Show after = run_show(show_of(five), rules, 1.5);
    CHECK_THAT(after.rockets,
               IsNear(std::vector{rising(1.5, 1, 1), rising(3.5, 3, 3), rising(2.5, 5, 5)}, rounding).of("rockets"));
}

//> The end
TEST_CASE("ends with dark sky: in the end nothing is left, and no spark is missing in the count", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Rules by = random_rules(dice);
        const Show start = random_show(dice);

        const Show over = run_show(start, by, 60);

        CHECK_THAT(over.rockets, HasSize(0).of("rockets at the end"));
        CHECK_THAT(over.sparks, HasSize(0).of("sparks at the end"));
        CHECK_THAT(over.shown + over.lost, IsNear(sparks_in(start.rockets)).of("sparks shown and lost"));
        CHECK_THAT(run_show(over, by, 60), IsNear(over).of("show a minute after its end"));
    }
}

//> A show at any frame rate
TEST_CASE("is the same show at 1, 10, 60 and 144 frames a second, whatever bursts within a frame", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        const Rules by = random_rules(dice);
        const Show start = random_show(dice);
        Show slow = start;
        std::vector<Show> fast(3, start);
        for (int second = 1; second <= 6; ++second) {
            slow = run_show(slow, by, 1);
            for (std::size_t k = 0; k < fast.size(); ++k) {
                const int rate = std::array{10, 60, 144}[k];
                fast[k] = after_frames(fast[k], by, 1, rate);
                CHECK_THAT(in_order_of(slow, fast[k]), IsNear(slow, 1e-9)
                                                           .of("show after " + std::to_string(second) + " s, at "
                                                               + std::to_string(rate) + " frames a second"));
            }
        }
    }
}

//> A frame cut in two
TEST_CASE("a frame cut in two gives the same show as the whole frame, wherever it's cut", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        const Rules by = random_rules(dice);
        const Show start = random_show(dice);
        const double dt = dice.real(0, 6), part = dice.real(0, dt);

        const Show whole = run_show(start, by, dt);

        const Show halves = run_show(run_show(start, by, part), by, dt - part);
        CHECK_THAT(in_order_of(whole, halves), IsNear(whole, 1e-9).of("show after both parts"));
    }
}

//> What is counted
TEST_CASE("every spark is in a rocket, was shown, or is lost; and no more glow than there are places", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Rules by = random_rules(dice);
        Show now = random_show(dice);
        const int all = sparks_in(now.rockets);
        for (int frame = 0; frame < 12; ++frame) {
            const int most = now.most;
            now = run_show(now, by, dice.real(0, 1));

            CHECK_THAT(now.shown + now.lost + sparks_in(now.rockets), IsNear(all).of("all sparks"));
            CHECK_THAT(int(now.sparks.size()), IsAtMost(now.most).of("sparks that glow"));
            CHECK_THAT(now.most, IsAtMost(std::min(by.places, now.shown)).of("the most at one time"));
            CHECK_THAT(now.most, IsAtLeast(most).of("the most at one time"));
            for (const Particle &each : now.sparks) {
                CHECK_THAT(each.age, IsBelow(each.life).of("age of a spark [s]"));
                CHECK_THAT(each.position.y(), IsAtLeast(0).of("height of a spark [m]"));
            }
        }
    }
}

//> Momentum
TEST_CASE("if each spark has an opposite one, their middle flies on as the rocket would have", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Rocket one{0, {dice.real(-20, 20), 0}, {0, 0}, {}};
        one.position.y() = dice.real(300, 400);
        one.velocity.x() = dice.real(-5, 5);
        one.velocity.y() = dice.real(0, 20);
        for (int opposite = dice.whole(1, 20); opposite > 0; --opposite) {
            const double speed = dice.real(0, 1), turn = dice.real(0, 0.5);
            for (const double number : {speed, turn, speed, turn + 0.5}) one.random_numbers.push_back(number);
        }
        const double time = dice.real(2.1, 6), g = 10;

        const Show after = run_show(show_of({one}), {g, 100, 5, 9}, time);

        Vec2 place{0, 0}, velocity{0, 0};
        for (const Particle &each : after.sparks) {
            place += each.position / double(after.sparks.size());
            velocity += each.velocity / double(after.sparks.size());
        }
        const Vec2 flown = one.position + time * one.velocity - Vec2{0, g * time * time / 2};
        CHECK_THAT(velocity, IsNear(Vec2{one.velocity - Vec2{0, g * time}}, 1e-11).of("mean velocity [m/s]"));
        CHECK_THAT(place, IsNear(flown, 1e-11).of("middle of the sparks [m]"));
    }
}

//> Energy of a spark
TEST_CASE("each spark in the air keeps its v²/2 + g y, because gravity alone acts on it", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Show start;
        for (int k = 0; k < 5; ++k) { // their lives are their names
            const Vec2 place{dice.real(-20, 20), 0}, velocity = dice.point(-8, 8);
            start.sparks.push_back({place + Vec2{0, dice.real(0, 20)}, velocity, 0, 5.0 + k});
        }
        start.shown = start.most = 5;
        const double g = dice.real(1, 12);

        const Show after = run_show(start, {g, 5, 0, 1}, dice.real(0, 6));

        for (const Particle &each : after.sparks)
            for (const Particle &before : start.sparks)
                if (before.life == each.life)
                    CHECK_THAT(each.velocity.squaredNorm() / 2 + g * each.position.y(),
                               IsNear(before.velocity.squaredNorm() / 2 + g * before.position.y(), 1e-11)
                                   .of("energy of each kilogram [J]"));
    }
}

//> Later
TEST_CASE("if all rockets wait a second longer, it's the same show, a second later", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Rules by = random_rules(dice);
        const Show start = random_show(dice);
        const double dt = dice.real(0, 6);
        Show later = start;
        for (Rocket &each : later.rockets) each.wait += 1;

        const Show want = run_show(start, by, dt);

        CHECK_THAT(in_order_of(want, run_show(later, by, dt + 1)), IsNear(want, 1e-9).of("show a second later"));
    }
}

//> Two shows at one time
TEST_CASE("with a place for each spark, two shows at one time are the sum of both", "[11.10]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Rules by = random_rules(dice);
        by.places = 200;
        const Show one = random_show(dice), other = random_show(dice);
        const double dt = dice.real(0, 6);
        Show both = one;
        both.rockets.insert(both.rockets.end(), other.rockets.begin(), other.rockets.end());

        Show want = run_show(one, by, dt);
        const Show second = run_show(other, by, dt);
        const Show got = run_show(both, by, dt);

        CHECK_THAT(got.most, IsAtMost(want.most + second.most).of("the most at one time"));
        want.rockets.insert(want.rockets.end(), second.rockets.begin(), second.rockets.end());
        want.sparks.insert(want.sparks.end(), second.sparks.begin(), second.sparks.end());
        want.shown += second.shown;
        want.most = got.most;
        CHECK_THAT(in_order_of(want, got), IsNear(want, 1e-9).of("both shows"));
    }
}

//>
TEST_CASE("200 rockets of 20 sparks, all within a frame, come to 4000 sparks, shown or lost", "[11.10]") {
    std::vector<Rocket> many;
    for (int i = 0; i < 200; ++i) many.push_back(rising(0.01 * i, 20, i));
    const Show after = run_show(show_of(many), {10, 1000, 1, 100}, 1.995);
    CHECK_THAT(after.rockets, HasSize(100).of("rockets after 1.995 s")); // half of them have burst
    CHECK_THAT(after.shown, IsAtLeast(1000).of("sparks shown"));
    CHECK_THAT(after.shown + after.lost, IsNear(2000).of("sparks shown and lost"));
}

TEST_CASE("run_show allows an empty show, a rocket without sparks, a day's wait, and places beyond memory", "[11.10]") {
    const int most = std::numeric_limits<int>::max();
    CHECK_THAT(run_show({}, {10, 0, 0, 1}, 86400), IsNear(Show{}));
    CHECK_THAT(run_show(show_of({rising(0, 0)}), {10, most, 4, 2}, 1), IsNear(Show{}));
    CHECK_THAT(run_show(show_of({rising(86400, 3)}), rules, 86400), IsNear(show_of({rising(0, 3)}), 1e-9));
    CHECK_THAT(run_show(show_of({rising(0, 3)}), {10, most, 4, 2}, 86400), IsNear(Show{{}, {}, 3, 0, 3}));
    CHECK_THAT(run_show(show_of({rising(0, 3)}), {10, 3, 0, 9}, 1.25).sparks, HasSize(3).of("sparks in one place"));
}

TEST_CASE("rejects what's below the street, numbers out of range or without a pair, and bad rules", "[11.10]") {
    const Show good{{rising(1, 2)}, {{{0, 5}, {0, 0}, 0, 2}}, 1, 0, 1};
    const auto with = [&](const auto &change) {
        Show bad = good;
        change(bad);
        return bad;
    };
    CHECK_REFUSED(run_show(with([](Show &bad) { bad.rockets[0].wait = -1e-3; }), rules, 1), "wait is negative");
    CHECK_REFUSED(run_show(with([](Show &bad) { bad.rockets[0].position.y() = -1e-3; }), rules, 1),
                  "a rocket is below the street");
    CHECK_REFUSED(run_show(with([](Show &bad) { bad.rockets[0].random_numbers.pop_back(); }), rules, 1),
                  "a random number has no partner");
    for (const double number : {-0.1, 1.0, 3.0})
        CHECK_REFUSED(run_show(with([&](Show &bad) { bad.rockets[0].random_numbers[1] = number; }), rules, 0),
                      "a random number is out of range"); // though it doesn't burst yet
    CHECK_REFUSED(run_show(with([](Show &bad) { bad.sparks[0].position.y() = -1e-3; }), rules, 1),
                  "a spark is below the street");
    check_age_and_life_refused(good.sparks[0], [&](const Particle &particle) {
        return run_show(with([&](Show &bad) { bad.sparks[0] = particle; }), rules, 1);
    });
    CHECK_REFUSED(run_show(with([](Show &bad) { bad.most = 0; }), rules, 1), "most is less than the sparks");
    CHECK_REFUSED(run_show(good, {0, 100, 4, 2}, 1), "gravity is 0");
    CHECK_REFUSED(run_show(good, {-10, 100, 4, 2}, 1), "gravity is negative");
    CHECK_REFUSED(run_show(good, {10, 0, 4, 2}, 1), "fewer places than sparks");
    CHECK_REFUSED(run_show({}, {10, -1, 4, 2}, 1), "places is negative");
    CHECK_REFUSED(run_show(good, {10, 100, -4, 2}, 1), "speed is negative");
    CHECK_REFUSED(run_show(good, {10, 100, 4, 0}, 1), "life is 0");
    CHECK_REFUSED(run_show(good, rules, -1e-3), "dt is negative");
    run_show(good, rules, 1); // good input is still answered
}
