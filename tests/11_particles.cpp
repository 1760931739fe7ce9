#include "section_test.hpp"

#include "particles.hpp"

#include <algorithm>
#include <array>
#include <optional>

using particles::Due, particles::Emitter, particles::Particle, particles::Pool, particles::Wall, particles::World;
using particles::most_bounces, particles::touching;
using namespace particles::subject; // start, shade, step, ring, explosion, trail, due, fly, renew: the student's

constexpr double rounding = 1e-12;       // as the header says
constexpr double rounding_of_1e5 = 1e-7; // where numbers as large as that go into a result
constexpr double pi = std::numbers::pi;

namespace {

const Particle spark{.position = {3, 7}, .velocity = {-2, 5}, .age = 0.5, .life = 4};
const std::optional<Particle> dead;
const std::optional<int> no_shade;
const std::optional<Pool> no_room;

/// A particle that no other one is like.
Particle numbered(int i) {
    return {.position = {i + 0.25, 2.0 * i}, .velocity = {-i - 0.5, i / 4.0}, .age = 0.125 * i, .life = 100.0 + i};
}

/// Whether it is the same in every field, to the last bit.
bool same(const Particle &a, const Particle &b) {
    return a.position == b.position && a.velocity == b.velocity && a.age == b.age && a.life == b.life;
}

/// Particles that are allowed, though not usual: at the ends of the range, at rest, dead, with a life of next to nothing.
const std::vector<Particle> unusual{{{1e5, -1e5}, {-1e5, 1e5}, 0, 1e5}, {{-1e5, 1e5}, {1e5, -1e5}, 1e5, 1e-7},
                                    {{0.1, 0.2}, {0, 0}, -0.0, 5},      {{0.1, 0.2}, {0.3, -0.7}, 3, 3},
                                    {{-3, 1e5}, {0, -1e5}, 90, 3},      {{3, 7}, {1e-10, 0}, 0, 1e-300}};

/// Asks `call` for a particle with an age or a life that cannot be.
template <class Call> void check_age_and_life_refused(const Particle &good, const Call &call) {
    for (const double age : {-0.1, -1e-9, -1e-300})
        CHECK_REFUSED(call({good.position, good.velocity, age, good.life}), "age is negative");
    for (const double life : {-4.0, -1e-9, 0.0})
        CHECK_REFUSED(call({good.position, good.velocity, good.age, life}), "life is not positive");
}

} // namespace

// ------------------------------------------------------------------------------------------------------ 11.1 start

namespace {

/// A pool of `size` slots, in which all but `free` hold a particle.
Pool pool_with_free(int size, const std::vector<int> &free) {
    Pool pool;
    for (int i = 0; i < size; ++i) pool.emplace_back(numbered(i));
    for (const int i : free) pool[std::size_t(i)].reset();
    return pool;
}

/// The slots in which two pools differ.
std::vector<int> changed(const Pool &before, const Pool &after) {
    std::vector<int> slots;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool equal =
            before[i] && after[i] ? same(*before[i], *after[i]) : before[i].has_value() == after[i].has_value();
        if (!equal) slots.push_back(int(i));
    }
    return slots;
}

} // namespace

//> One slot is free
TEST_CASE("a particle starts in the only free slot, and nothing else changes", "[11.1]") {
    const int slot = GENERATE(0, 1, 3, 4); // the first, two in the middle, the last
    const Pool pool = pool_with_free(5, {slot});

    Pool want = pool;
    want[std::size_t(slot)] = spark;
    CHECK_THAT(start(pool, spark), IsNear(std::optional{want}));
}

//>
TEST_CASE("of several free slots it takes one", "[11.1]") {
    const std::vector<int> free = GENERATE(std::vector{0, 1, 2, 3, 4}, std::vector{1, 3}, std::vector{2, 3, 4});
    const Pool pool = pool_with_free(5, free);

    const Pool after = start(pool, spark).value();

    CHECK_THAT(after, HasSize(5).of("slots"));
    const std::vector<int> slots_changed = changed(pool, after);
    CHECK_THAT(slots_changed, HasSize(1).of("slots that changed"));
    CHECK_THAT(std::ranges::count(free, slots_changed[0]) == 1, IsTrue("the slot that changed was free"));
    CHECK_THAT(after[std::size_t(slots_changed[0])], IsNear(std::optional{spark}).of("slot that changed"));
}

//> Full
TEST_CASE("a full pool says so: it does not grow, and nobody has to go", "[11.1]") {
    const int size = GENERATE(1, 2, 5, 128);
    CHECK_THAT(start(pool_with_free(size, {}), spark), IsNear(no_room));
    CHECK_THAT(start({}, spark), IsNear(no_room)); // no slot at all
}

//> 128 of them
TEST_CASE("128 particles fit into 128 slots, and not one more; a slot that is freed is used again", "[11.1]") {
    Pool pool(128);
    for (int i = 0; i < 128; ++i) {
        const Pool after = start(pool, numbered(i)).value();
        CHECK_THAT(after, HasSize(128).of("slots"));
        CHECK_THAT(changed(pool, after), HasSize(1).of("slots that changed"));
        pool = after;
    }
    for (int i = 0; i < 128; ++i) {
        const auto is_it = [&](const std::optional<Particle> &slot) { return slot && same(*slot, numbered(i)); };
        CHECK_THAT(int(std::ranges::count_if(pool, is_it)), IsNear(1).of("slots that hold the same particle"));
    }
    CHECK_THAT(start(pool, spark), IsNear(no_room));

    const std::size_t freed = GENERATE(0u, 77u, 127u);
    pool[freed].reset();
    const Pool again = start(pool, spark).value();
    CHECK_THAT(again, HasSize(128).of("slots"));
    CHECK_THAT(changed(pool, again), IsNear(std::vector{int(freed)}).of("slots that changed"));
    CHECK_THAT(start(again, spark), IsNear(no_room));
}

//>
TEST_CASE("a particle goes in as it is, whatever its age, and those in the pool are not looked at", "[11.1]") {
    for (const Particle &particle : unusual) {
        CHECK_THAT(start(Pool(1), particle), IsNear(std::optional{Pool{particle}}));
        CHECK_THAT(start({particle, std::nullopt}, particle), IsNear(std::optional{Pool{particle, particle}}));
    }
    const Pool strange{Particle{{1e9, -3e200}, {3, 4}, -1, -1}, std::nullopt, Particle{{0.1, 0.2}, {3, 4}, 7, 2}};
    CHECK_THAT(start(strange, spark), IsNear(std::optional{Pool{strange[0], spark, strange[2]}}));
}

TEST_CASE("a dead particle keeps its slot: only a free one is used", "[11.1]") {
    const Particle just_dead{.position = {1, 2}, .velocity = {3, 4}, .age = 2, .life = 2};
    const Particle long_dead{.position = {1, 2}, .velocity = {3, 4}, .age = 7, .life = 2};
    CHECK_THAT(start({just_dead, std::nullopt, long_dead}, spark),
               IsNear(std::optional{Pool{just_dead, spark, long_dead}}));
    CHECK_THAT(start({just_dead, long_dead}, spark), IsNear(no_room));
}

TEST_CASE("a pool may have thousands of slots", "[11.1]") {
    Pool pool(5'000, spark);
    pool.back().reset();
    const Pool after = start(pool, numbered(7)).value();
    CHECK_THAT(after, HasSize(5'000).of("slots"));
    CHECK_THAT(changed(pool, after), IsNear(std::vector{4'999}).of("slots that changed"));
    CHECK_THAT(after.back(), IsNear(std::optional{numbered(7)}).of("the last slot"));
}

TEST_CASE("what is no particle is not started", "[11.1]") {
    const std::vector<Pool> pools{Pool(3), pool_with_free(3, {}), Pool{}}; // free, full, without slots
    for (const Pool &pool : pools) {
        const auto start_one = [&](const Particle &particle) { return start(pool, particle); };
        check_age_and_life_refused(spark, start_one);
        CHECK_OUT_OF_RANGE_REFUSED(start, {Pool(pool.size()), spark});
    }
    CHECK_OUT_OF_RANGE_REFUSED(start, {Pool(3), Particle{{3, 7}, {0, 0}, 0, 4}}); // at rest
}

// ------------------------------------------------------------------------------------------------------ 11.2 shade

//> Sixteen shades
TEST_CASE("the worked example: a life of 3 s and 16 shades, each shown for 3/16 s", "[11.2]") {
    CHECK_THAT(shade(0, 3, 16), IsNear(std::optional{0}));
    CHECK_THAT(shade(0.18, 3, 16), IsNear(std::optional{0}));
    CHECK_THAT(shade(0.1875, 3, 16), IsNear(std::optional{1})); // 3/16
    CHECK_THAT(shade(1.5, 3, 16), IsNear(std::optional{8}));    // half its life
    CHECK_THAT(shade(2.8, 3, 16), IsNear(std::optional{14}));   // 15 · 3/16 = 2.8125 is the last border
    CHECK_THAT(shade(2.9, 3, 16), IsNear(std::optional{15}));
    CHECK_THAT(shade(3, 3, 16), IsNear(no_shade)); // exactly at its life's end
    CHECK_THAT(shade(3.1, 3, 16), IsNear(no_shade));
    CHECK_THAT(shade(1e5, 3, 16), IsNear(no_shade));
}

//> Erratum E11.1
TEST_CASE("erratum E11.1: a life of 90 frames is 90 frames, not 90 for each of 16 shades", "[11.2]") {
    int alive = 0;
    for (int frame = 0; frame < 200; ++frame)            // the printed code lets it live for all of them
        if (shade(frame / 30.0, 90 / 30.0, 16)) ++alive; // 30 frames a second
    CHECK_THAT(alive, IsNear(90).of("frames in which it shows a shade"));
}

//>
TEST_CASE("each shade lasts as long as any other", "[11.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const int shades = dice.whole(1, 40), which = dice.whole(0, shades - 1);
        const double life = dice.real(0.01, 300);
        const double age = (which + dice.real(0.001, 0.999)) * life / shades; // within this shade, off its borders
        CHECK_THAT(shade(age, life, shades), IsNear(std::optional{which}));
    }
}

TEST_CASE("a border that no rounding touches belongs to the later shade", "[11.2]") {
    const double life = GENERATE(1.0, 0.25, 16.0, 1024.0, 0x1p-30, 0x1p-300);
    for (int k = 0; k < 8; ++k) {
        CHECK_THAT(shade(k * life / 8, life, 8), IsNear(std::optional{k}));
        CHECK_THAT(shade(((k + 1) / 8.0 - 0x1p-45) * life, life, 8), IsNear(std::optional{k})); // 3e-14 before the next
    }
}

TEST_CASE("a life, and an age, may be as long as 1e5 s", "[11.2]") {
    CHECK_THAT(shade(1e5, 2, 4), IsNear(no_shade));
    CHECK_THAT(shade(75'001, 1e5, 4), IsNear(std::optional{3}));
    CHECK_THAT(shade(74'999, 1e5, 4), IsNear(std::optional{2}));
    CHECK_THAT(shade(1e5, 1e5, 4), IsNear(no_shade));
    CHECK_THAT(shade(-0.0, 1e5, 4), IsNear(std::optional{0})); // that is 0
}

TEST_CASE("until its very end a particle shows a shade, and never one that is not there", "[11.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const int shades = dice.whole(1, 40);
        const double life = dice.real(0.01, 300);
        CHECK_THAT(shade(std::nextafter(life, 0), life, shades), IsNear(std::optional{shades - 1}));
        CHECK_THAT(shade(life, life, shades), IsNear(no_shade));
    }
}

TEST_CASE("one shade is shown from the start to the end", "[11.2]") {
    CHECK_THAT(shade(0, 2, 1), IsNear(std::optional{0}));
    CHECK_THAT(shade(1.999, 2, 1), IsNear(std::optional{0}));
    CHECK_THAT(shade(2, 2, 1), IsNear(no_shade));
}

TEST_CASE("very many shades are told apart", "[11.2]") {
    const int shades = 1 << 30, which = 123'456'789, most = std::numeric_limits<int>::max();
    CHECK_THAT(shade(2 * (which + 0.5) / shades, 2, shades), IsNear(std::optional{which}));
    CHECK_THAT(shade(0, 2, most), IsNear(std::optional{0}));
    CHECK_THAT(shade(std::nextafter(2, 0), 2, most), IsNear(std::optional{most - 1}));
}

TEST_CASE("an age, a life or a number of shades that cannot be is refused", "[11.2]") {
    for (const double age : {0.0, 1.0, 4.0}) { // unborn, alive and dead
        for (const int shades : {0, -1, -16, std::numeric_limits<int>::min()})
            CHECK_REFUSED(shade(age, 3, shades), "shades is less than 1");
        for (const double life : {0.0, -3.0, -1e-9}) CHECK_REFUSED(shade(age, life, 16), "life is not positive");
        CHECK_OUT_OF_RANGE_REFUSED(shade, {age, 3, 16});
    }
    for (const double age : {-0.1, -1e-9}) CHECK_REFUSED(shade(age, 3, 16), "age is negative");
}

// ------------------------------------------------------------------------------------------------------- 11.3 step

namespace {

const World world{.gravity = 10, .wind = 1, .width = 20, .height = 16};

} // namespace

//> One step
TEST_CASE("the worked example: the velocity first, then the position by the new one", "[11.3]") {
    // v: (4, 5) + 0.5 (1, -10) = (4.5, 0);  x: (2, 3) + 0.5 (4.5, 0) = (4.25, 3).  The old velocity leads to (4, 5.5).
    const Particle before{.position = {2, 3}, .velocity = {4, 5}, .age = 1, .life = 9};
    const Particle after{.position = {4.25, 3}, .velocity = {4.5, 0}, .age = 1.5, .life = 9};
    CHECK_THAT(step(before, world, 0.5), IsNear(std::optional{after}, rounding));
}

//>
TEST_CASE("gravity pulls down and wind blows to the right; their signs turn them round", "[11.3]") {
    const Particle rest{.position = {5, 5}, .velocity = {0, 0}, .age = 0, .life = 9};
    const auto after = [&](double gravity, double wind) { return step(rest, {gravity, wind, 20, 16}, 0.5); };
    // half a second of 2 m/s² makes 1 m/s, and by that 0.5 m
    CHECK_THAT(after(2, 0), IsNear(std::optional{Particle{{5, 4.5}, {0, -1}, 0.5, 9}}, rounding));
    CHECK_THAT(after(-2, 0), IsNear(std::optional{Particle{{5, 5.5}, {0, 1}, 0.5, 9}}, rounding));
    CHECK_THAT(after(0, 2), IsNear(std::optional{Particle{{5.5, 5}, {1, 0}, 0.5, 9}}, rounding));
    CHECK_THAT(after(0, -2), IsNear(std::optional{Particle{{4.5, 5}, {-1, 0}, 0.5, 9}}, rounding));
    CHECK_THAT(after(0, 0), IsNear(std::optional{Particle{{5, 5}, {0, 0}, 0.5, 9}}, rounding));
}

//> A thousand steps
TEST_CASE("after n steps it is where the sum of all its velocities has taken it", "[11.3]") {
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
TEST_CASE("erratum E11.5: what is killed at the edge is what is not drawn there", "[11.3]") {
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
    CHECK_THAT(step_at(0, 100), alive_at(0, 100)); // the other two edges belong to the picture
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
TEST_CASE("it is where it has come to that counts, not where it was", "[11.3]") {
    const World still{.gravity = 0, .wind = 0, .width = 20, .height = 16};
    CHECK_THAT(step({{19, 8}, {4, 0}, 0, 9}, still, 0.5), IsNear(dead));  // from 19 to 21
    CHECK_THAT(step({{1, 8}, {-4, 0}, 0, 9}, still, 0.5), IsNear(dead));  // to -1
    CHECK_THAT(step({{10, 15}, {0, 4}, 0, 9}, still, 0.5), IsNear(dead)); // to 17
    CHECK_THAT(step({{10, 1}, {0, -4}, 0, 9}, still, 0.5), IsNear(dead)); // to -1
    const auto comes_in = [&](Vec2 from, Vec2 velocity, Vec2 to) {
        CHECK_THAT(step({from, velocity, 0, 9}, still, 0.5),
                   IsNear(std::optional{Particle{to, velocity, 0.5, 9}}, rounding));
        CHECK_THAT(step({from, velocity, 0, 9}, still, 0), IsNear(dead)); // in no time it stays outside
    };
    comes_in({-1, 8}, {4, 0}, {1, 8});
    comes_in({21, 8}, {-4, 0}, {19, 8});
    comes_in({10, -1}, {0, 4}, {10, 1});
    comes_in({10, 17}, {0, -4}, {10, 15});
}

//> Erratum E11.2
TEST_CASE("erratum E11.2: the printed example dies in frame 5, off the top, and not after 90", "[11.3]") {
    // 20 rows below the top one of 480, 5 rows up in each frame; a row is a metre here, and a frame a second
    const double gravity = GENERATE(0.0, 0.1);
    std::optional<Particle> now = Particle{.position = {10, 479 - 20}, .velocity = {0, 5}, .age = 0, .life = 90};
    int frame = 0;
    for (; now && frame < 90; ++frame) now = step(*now, {gravity, 0, 640, 480}, 1);
    CHECK_THAT(frame, IsNear(5).of("frames until it is dead"));
}

//> At its life's end
TEST_CASE("it is dead as soon as its age has reached its life", "[11.3]") {
    const World still{.gravity = 0, .wind = 0, .width = 20, .height = 16};
    const auto aged = [](double age) { return Particle{{5, 5}, {0, 0}, age, 2}; };
    CHECK_THAT(step(aged(1), still, 0.75), IsNear(std::optional{aged(1.75)}, rounding));
    CHECK_THAT(step(aged(1), still, 1), IsNear(dead)); // exactly
    CHECK_THAT(step(aged(1), still, 1.25), IsNear(dead));
    CHECK_THAT(step(aged(2), still, 0), IsNear(dead)); // it was dead before
    CHECK_THAT(step(aged(3), still, 0), IsNear(dead));
    CHECK_THAT(step(aged(0), still, 0), IsNear(std::optional{aged(0)}, rounding));
}

//>
TEST_CASE("in no time nothing happens", "[11.3]") {
    CHECK_THAT(step(spark, world, 0), IsNear(std::optional{spark}));
    CHECK_THAT(step(spark, world, -0.0), IsNear(std::optional{spark}));
}

TEST_CASE("a step may be long or short, and anything in it tiny", "[11.3]") {
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

TEST_CASE("what goes in may be as large as 1e5, and what comes out larger", "[11.3]") {
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

TEST_CASE("each step looks at its own world", "[11.3]") {
    const Particle rest{.position = {15, 12}, .velocity = {0, 0}, .age = 0, .life = 9};
    const std::optional<Particle> alive = Particle{{15, 12}, {0, 0}, 1, 9};
    for (const World &large : {World{0, 0, 20, 16}, World{0, 0, 16, 20}}) {
        CHECK_THAT(step(rest, {0, 0, 10, 20}, 1), IsNear(dead));
        CHECK_THAT(step(rest, large, 1), IsNear(alive, rounding));
        CHECK_THAT(step(rest, {0, 0, 20, 10}, 1), IsNear(dead));
    }
}

TEST_CASE("what is no particle, no picture or no time cannot take a step", "[11.3]") {
    const auto check_refused = [](const Particle &particle, double dt) {
        CHECK_OUT_OF_RANGE_REFUSED(step, {particle, world, dt});
        for (const double bad : {0.0, -20.0, -1e-9}) {
            CHECK_REFUSED(step(particle, {10, 1, bad, 16}, dt), "width is not positive");
            CHECK_REFUSED(step(particle, {10, 1, 20, bad}, dt), "height is not positive");
        }
        for (const double bad : {-0.1, -1e-9}) CHECK_REFUSED(step(particle, world, bad), "dt is negative");
        check_age_and_life_refused(particle, [&](const Particle &bad) { return step(bad, world, dt); });
    };
    check_refused(spark, 0.1);
    check_refused({{5, 5}, {0, 0}, 1, 4}, 0);    // at rest, and in no time
    check_refused({{-5, 5}, {0, 0}, 1, 4}, 0.1); // outside
    check_refused({{5, 5}, {1, 1}, 4, 4}, 0.1);  // dead
}

// ------------------------------------------------------------------------------------------------------- 11.4 ring

//> Four of them
TEST_CASE("the worked example: four particles, the first to the right", "[11.4]") {
    CHECK_THAT(ring(4, 5, 0), IsNear(std::vector<Vec2>{{5, 0}, {0, 5}, {-5, 0}, {0, -5}}, rounding));
}

//>
TEST_CASE("six particles, the first one straight down", "[11.4]") {
    // cos 30° = √3/2, times 4
    const double side = 2 * std::sqrt(3);
    CHECK_THAT(ring(6, 4, -pi / 2),
               IsNear(std::vector<Vec2>{{0, -4}, {side, -2}, {side, 2}, {0, 4}, {-side, 2}, {-side, -2}}, rounding));
}

//> Erratum E11.8
TEST_CASE("erratum E11.8: 36 particles leave no gap wider than 10 degrees, and none leaves twice", "[11.4]") {
    // with an angle by chance for each, as printed, a ring of 36 had a gap of 38 degrees, and a direction twice
    const std::vector<Vec2> velocities = ring(36, 3, 0.3);
    CHECK_THAT(velocities, HasSize(36));
    for (std::size_t i = 0; i < 36; ++i) {
        const Vec2 &here = velocities[i], &next = velocities[(i + 1) % 36];
        const double turn = std::atan2(here.x() * next.y() - here.y() * next.x(), here.dot(next)); // left of it
        CHECK_THAT(turn * 180 / pi, IsNear(10.0, 36 * rounding).of("angle between neighbours [°]"));
    }
}

//>
TEST_CASE("all are equally fast, and together they go nowhere", "[11.4]") {
    const int count = GENERATE(2, 3, 5, 7, 64, 1000);
    const double speed = GENERATE(0.0, 0.5, 40.0), first = GENERATE(0.0, 1.2, -9.0);
    const std::vector<Vec2> velocities = ring(count, speed, first);

    CHECK_THAT(velocities, HasSize(std::size_t(count)));
    Vec2 sum{0, 0};
    for (const Vec2 &v : velocities) {
        CHECK_THAT(v.norm(), IsNear(speed, count * rounding).of("speed [m/s]"));
        sum += v;
    }
    // an angle that is added up is off by up to count roundings, and so is each of the velocities
    CHECK_THAT(sum, IsNear(Vec2{0, 0}, count * count * rounding * speed).of("sum of all velocities [m/s]"));
    CHECK_THAT(velocities[0],
               IsNear(Vec2{speed * std::cos(first), speed * std::sin(first)}, rounding).of("first velocity [m/s]"));
}

TEST_CASE("a ring may be of thousands", "[11.4]") {
    const int count = 12'000;
    const std::vector<Vec2> velocities = ring(count, 3, 0.5);
    CHECK_THAT(velocities, HasSize(std::size_t(count)));
    const Vec2 ahead{3 * std::cos(0.5), 3 * std::sin(0.5)}, left{-ahead.y(), ahead.x()};
    const auto quarter = std::size_t(count / 4); // of a turn
    CHECK_THAT(velocities[quarter], IsNear(left, count * rounding).of("velocity after a quarter of a turn [m/s]"));
    CHECK_THAT(velocities[3 * quarter],
               IsNear(Vec2{-left}, count * rounding).of("velocity after three quarters [m/s]"));
}

TEST_CASE("a speed or an angle may be as large as 1e5, or tiny, and each ring is made anew", "[11.4]") {
    CHECK_THAT(ring(2, 1e5, 0), IsNear(std::vector<Vec2>{{1e5, 0}, {-1e5, 0}}, 1e-10)); // π is rounded as well
    CHECK_THAT(ring(2, 1e5, 5e-10), IsNear(std::vector<Vec2>{{1e5, 5e-5}, {-1e5, -5e-5}}, 1e-10));
    CHECK_THAT(ring(2, 5e-10, 0), IsNear(std::vector<Vec2>{{5e-10, 0}, {-5e-10, 0}}, rounding));
    for (const double first : {1e5, -1e5, 7.0, 1001.0}) { // 1e5 has eleven digits behind the point
        const Vec2 want{std::cos(first), std::sin(first)};
        CHECK_THAT(ring(2, 1, first), IsNear(std::vector<Vec2>{want, -want}, rounding_of_1e5));
    }
    CHECK_THAT(ring(2, -0.0, 1), IsNear(std::vector<Vec2>{{0, 0}, {0, 0}}));

    CHECK_THAT(ring(4, 5, 0), IsNear(std::vector<Vec2>{{5, 0}, {0, 5}, {-5, 0}, {0, -5}}, rounding));
    CHECK_THAT(ring(2, 3, 0), IsNear(std::vector<Vec2>{{3, 0}, {-3, 0}}, rounding));
    CHECK_THAT(ring(4, 5, pi), IsNear(std::vector<Vec2>{{-5, 0}, {0, -5}, {5, 0}, {0, 5}}, rounding));
}

TEST_CASE("a ring of one goes where the first one goes, and a ring of none is empty", "[11.4]") {
    CHECK_THAT(ring(1, 2, pi / 2), IsNear(std::vector<Vec2>{{0, 2}}, rounding));
    CHECK_THAT(ring(0, 2, 1), IsNear(std::vector<Vec2>{}));
}

TEST_CASE("fewer than none, slower than not at all, and what is no number is refused", "[11.4]") {
    for (const int count : {-1, std::numeric_limits<int>::min()}) CHECK_REFUSED(ring(count, 5, 0), "count is negative");
    for (const int count : {4, 1, 0}) {
        for (const double speed : {-5.0, -1e-9}) CHECK_REFUSED(ring(count, speed, 0), "speed is negative");
        CHECK_OUT_OF_RANGE_REFUSED(ring, {count, 5, 0});
        CHECK_OUT_OF_RANGE_REFUSED(ring, {count, 0, 0});
    }
}

// -------------------------------------------------------------------------------------------------- 11.5 explosion

//> A quarter of the disc
TEST_CASE("the worked example: a quarter of the disc is inside half of its radius", "[11.5]") {
    // 0.25 of the area is inside 5 of 10 m/s, and 0.81 inside 9; 0 is to the right, 0.25 up, 0.5 to the left
    CHECK_THAT(explosion({0.25, 0, 0.25, 0.25, 0.81, 0.5}, 10),
               IsNear(std::vector<Vec2>{{5, 0}, {0, 5}, {-9, 0}}, rounding));
}

//>
TEST_CASE("the share of the disc that is slower is the first chance, and the share of a turn the second", "[11.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double first = dice.real(0.001, 1), second = dice.real(0, 1), fastest = dice.real(0.1, 900);
        const std::vector<Vec2> velocities = explosion({first, second}, fastest);

        CHECK_THAT(velocities, HasSize(1));
        const Vec2 &v = velocities[0];
        CHECK_THAT(v.squaredNorm() / (fastest * fastest),
                   IsNear(first, rounding).of("share of the disc that is slower"));
        const double turn = std::atan2(v.y(), v.x()) / (2 * pi); // from -1/2 to 1/2
        CHECK_THAT(std::remainder(turn - second, 1), IsNear(0.0, rounding).of("turn, less the second chance"));
    }
}

//> Equal areas
TEST_CASE("equal areas get equal shares", "[11.5]") {
    Dice dice;
    std::vector<double> chances(2 * 20000);
    for (double &chance : chances) chance = dice.real(0, 1);
    const std::vector<Vec2> velocities = explosion(chances, 3);
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
TEST_CASE("erratum E11.7: one in six is slower than two fifths of the fastest; in print, none is", "[11.5]") {
    // printed speeds: 2, 3, 4 or 5. A disc has 2²/5² = 16 % of its area inside of 2
    std::vector<double> chances;
    for (int i = 0; i < 1000; ++i) chances.insert(chances.end(), {(i + 0.5) / 1000, std::fmod(0.618 * i, 1)});
    const std::vector<Vec2> velocities = explosion(chances, 5);
    CHECK_THAT(velocities, HasSize(1000));
    const auto slow = std::ranges::count_if(velocities, [](const Vec2 &v) { return v.norm() < 2; });
    CHECK_THAT(int(slow), IsNear(160).of("velocities below 2 m/s"));
}

//>
TEST_CASE("no chances, no particles; no speed, no motion", "[11.5]") {
    CHECK_THAT(explosion({}, 7), IsNear(std::vector<Vec2>{}));
    CHECK_THAT(explosion({0.3, 0.7}, 0), IsNear(std::vector<Vec2>{{0, 0}}));
    CHECK_THAT(explosion({0, 0.7}, 7), IsNear(std::vector<Vec2>{{0, 0}}, rounding));
}

TEST_CASE("velocities stand in the order of their pairs, and each explosion is made anew", "[11.5]") {
    CHECK_THAT(explosion({0.81, 0.5, 0.25, 0, 0.49, 0.25}, 10),
               IsNear(std::vector<Vec2>{{-9, 0}, {5, 0}, {0, 7}}, rounding));

    CHECK_THAT(explosion({0.25, 0.5}, 10), IsNear(std::vector<Vec2>{{-5, 0}}, rounding));
    CHECK_THAT(explosion({0.25, 0.5}, 2), IsNear(std::vector<Vec2>{{-1, 0}}, rounding));
}

TEST_CASE("a chance may be tiny or nearly 1, and the fastest speed tiny or 1e5", "[11.5]") {
    const double nearly_1 = 1 - 1e-13;
    CHECK_THAT(explosion({5e-13, 0, 0.25, 0}, 1e5),
               IsNear(std::vector<Vec2>{{1e5 * std::sqrt(5e-13), 0}, {5e4, 0}}, rounding_of_1e5));
    CHECK_THAT(explosion({1e-300, 0}, 1e5), IsNear(std::vector<Vec2>{{1e-145, 0}}, rounding_of_1e5));
    CHECK_THAT(explosion({nearly_1, 5e-10}, 1e5), IsNear(std::vector<Vec2>{{1e5, 1e5 * 1e-9 * pi}}, 1e-10));
    CHECK_THAT(explosion({0.25, nearly_1}, 10), IsNear(std::vector<Vec2>{{5, -1e-12 * pi}}, rounding));
    CHECK_THAT(explosion({0.25, 0.5}, 5e-10), IsNear(std::vector<Vec2>{{-2.5e-10, 0}}, rounding));
    CHECK_THAT(explosion({-0.0, -0.0}, -0.0), IsNear(std::vector<Vec2>{{0, 0}}));
}

TEST_CASE("an odd number of chances, one that is none, and a speed that is none, are refused", "[11.5]") {
    for (const double fastest : {7.0, 0.0}) {
        for (const std::size_t odd : {1u, 3u, 5u, 131u})
            CHECK_REFUSED(explosion(std::vector<double>(odd, 0.5), fastest), "the number of chances is odd");
        for (const std::size_t i : {0u, 1u, 2u, 131u})
            for (const double bad : {infinity, -infinity, not_a_number, 1.0, 1 + 1e-9, -0.001, -1e-9}) {
                std::vector<double> chances(132, 0.5);
                chances[i] = bad;
                CHECK_REFUSED(explosion(chances, fastest), "a chance is outside of [0, 1)");
            }
    }
    for (const std::vector<double> &chances : {std::vector{0.5, 0.5}, std::vector<double>{}})
        for (const double fastest : {infinity, -infinity, not_a_number, 100'001.0, -7.0, -1e-9})
            CHECK_REFUSED(explosion(chances, fastest), "fastest is negative, or out of range");
}

// ------------------------------------------------------------------------------------------------------ 11.6 trail

namespace {

const Emitter rocket{
    .position = {30, 40}, .velocity = {6, -8}, .offset = 0.5, .jitter = 2, .shortest = 3, .longest = 5};

} // namespace

//> A moving emitter
TEST_CASE("the worked example: a particle of a rocket's trail", "[11.6]") {
    // 0.5 is the middle, 0 the smallest; 0.75 is half of the way from the middle to the largest
    CHECK_THAT(trail(rocket, {0.5, 0.5, 0.5, 0.5, 0.5}), IsNear(Particle{{30, 40}, {6, -8}, 0, 4}, rounding));
    CHECK_THAT(trail(rocket, {0, 0.75, 0.75, 0, 0}), IsNear(Particle{{29.5, 40.25}, {7, -10}, 0, 3}, rounding));
}

//>
TEST_CASE("each chance has its own effect, and no other", "[11.6]") {
    // from 0.5 to 0.625: an eighth of the whole width, which is 1 m, 4 m/s or 2 s
    CHECK_THAT(trail(rocket, {0.625, 0.5, 0.5, 0.5, 0.5}), IsNear(Particle{{30.125, 40}, {6, -8}, 0, 4}, rounding));
    CHECK_THAT(trail(rocket, {0.5, 0.625, 0.5, 0.5, 0.5}), IsNear(Particle{{30, 40.125}, {6, -8}, 0, 4}, rounding));
    CHECK_THAT(trail(rocket, {0.5, 0.5, 0.625, 0.5, 0.5}), IsNear(Particle{{30, 40}, {6.5, -8}, 0, 4}, rounding));
    CHECK_THAT(trail(rocket, {0.5, 0.5, 0.5, 0.625, 0.5}), IsNear(Particle{{30, 40}, {6, -7.5}, 0, 4}, rounding));
    CHECK_THAT(trail(rocket, {0.5, 0.5, 0.5, 0.5, 0.625}), IsNear(Particle{{30, 40}, {6, -8}, 0, 4.25}, rounding));
}

//> Seen from the rocket
TEST_CASE("seen from the emitter, a trail looks the same however fast it flies", "[11.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        std::vector<double> chances(5);
        for (double &chance : chances) chance = dice.real(0, 1);
        Emitter resting = rocket, moving = rocket;
        resting.velocity = {0, 0};
        moving.velocity = dice.point(-90, 90);

        const Particle from_resting = trail(resting, chances), from_moving = trail(moving, chances);

        CHECK_THAT(from_moving.velocity - moving.velocity,
                   IsNear(from_resting.velocity, rounding * 100).of("velocity, less the emitter's [m/s]"));
        CHECK_THAT(from_moving.position, IsNear(from_resting.position, rounding).of("position [m]"));
        CHECK_THAT(from_moving.life, IsNear(from_resting.life, rounding).of("life [s]"));
    }
}

//> Erratum E11.9
TEST_CASE("erratum E11.9: 100 chances make 100 velocities; in print there are 25 of them", "[11.6]") {
    std::vector<double> across; // printed: a whole number from -2 to 2 along each axis, 5 · 5 pairs
    for (int i = 0; i < 100; ++i) across.push_back(trail(rocket, {0.5, 0.5, i / 100.0, 0.5, 0.5}).velocity.x());
    for (std::size_t i = 0; i < 100; ++i)
        CHECK_THAT(across[i], IsNear(4 + 0.04 * double(i), rounding).of("velocity along x [m/s]"));
}

//>
TEST_CASE("without offset, jitter and choice of life, chance has no say", "[11.6]") {
    const Emitter calm{.position = {-3, 2}, .velocity = {1, 7}, .offset = 0, .jitter = 0, .shortest = 2, .longest = 2};
    CHECK_THAT(trail(calm, {0.1, 0.9, 0.3, 0.99, 0.7}), IsNear(Particle{{-3, 2}, {1, 7}, 0, 2}, rounding));
}

TEST_CASE("offset, jitter and lives are each for themselves, and may be tiny", "[11.6]") {
    const std::vector<double> chances{0.75, 0.25, 0.25, 0.75, 0.5}; // half of the offset or jitter, to either side
    for (const double tiny : {5e-7, 5e-10}) {
        const Emitter wide{
            .position = {0, 0}, .velocity = {0, 0}, .offset = tiny, .jitter = 0, .shortest = 2, .longest = 2};
        CHECK_THAT(trail(wide, chances), IsNear(Particle{{tiny / 2, -tiny / 2}, {0, 0}, 0, 2}, rounding));
        const Emitter wild{
            .position = {0, 0}, .velocity = {0, 0}, .offset = 0, .jitter = tiny, .shortest = 2, .longest = 2};
        CHECK_THAT(trail(wild, chances), IsNear(Particle{{0, 0}, {-tiny / 2, tiny / 2}, 0, 2}, rounding));
        const Emitter brief{
            .position = {0, 0}, .velocity = {0, 0}, .offset = 0, .jitter = 0, .shortest = tiny, .longest = 2 * tiny};
        CHECK_THAT(trail(brief, chances), IsNear(Particle{{0, 0}, {0, 0}, 0, 1.5 * tiny}, rounding));
    }
}

TEST_CASE("an emitter's numbers may be as large as 1e5, and the particle's larger", "[11.6]") {
    const auto of_ones = [](double sign) {
        return Emitter{{sign * 1e5, -sign * 1e5}, {-sign * 1e5, sign * 1e5}, 1e5, 1e5, 1e5, 1e5};
    };
    const double last = 1 - 1e-13; // as good as 1
    CHECK_THAT(trail(of_ones(1), {last, 0, 0, last, last}),
               IsNear(Particle{{2e5, -2e5}, {-2e5, 2e5}, 0, 1e5}, rounding));
    CHECK_THAT(trail(of_ones(-1), {0, last, last, 0, 0}), IsNear(Particle{{-2e5, 2e5}, {2e5, -2e5}, 0, 1e5}, rounding));
}

TEST_CASE("a trail is made of five chances and a sound emitter", "[11.6]") {
    Emitter calm = rocket, resting = rocket;
    calm.offset = calm.jitter = 0;
    calm.longest = calm.shortest;
    resting.velocity = {0, 0};
    for (const Emitter &emitter : {rocket, calm, resting}) {
        for (const std::size_t number : {0u, 4u, 6u})
            CHECK_REFUSED(trail(emitter, std::vector<double>(number, 0.5)), "the number of chances is not 5");
        for (std::size_t i = 0; i < 5; ++i)
            for (const double bad : {infinity, -infinity, not_a_number, 1.0, 1 + 1e-9, -0.001, -1e-9}) {
                std::vector<double> chances(5, 0.5);
                chances[i] = bad;
                CHECK_REFUSED(trail(emitter, chances), "a chance is outside of [0, 1)");
            }
        const auto check_refused = [&](double Emitter::*field, double value, const char *input) {
            Emitter bad = emitter;
            bad.*field = value;
            CHECK_REFUSED(trail(bad, std::vector<double>(5, 0.5)), input);
        };
        for (const double bad : {-2.0, -1e-9}) {
            check_refused(&Emitter::offset, bad, "offset is negative");
            check_refused(&Emitter::jitter, bad, "jitter is negative");
            check_refused(&Emitter::shortest, bad, "shortest is not positive");
        }
        check_refused(&Emitter::shortest, 0, "shortest is not positive");
        check_refused(&Emitter::longest, emitter.shortest - 1e-9, "longest is less than shortest");
        CHECK_OUT_OF_RANGE_REFUSED(trail, {emitter, std::vector<double>(5, 0.5)});
    }
}

// -------------------------------------------------------------------------------------------------------- 11.7 due

//> Ten a second
TEST_CASE("the worked example: 10 a second, in frames of 1/4 s", "[11.7]") {
    // 2.5 a frame: 2, and half a one is left; with it the next frame has 3
    CHECK_THAT(due(10, 0, 0.25), IsNear(Due{2, 0.5}, rounding));
    CHECK_THAT(due(10, 0.5, 0.25), IsNear(Due{3, 0}, rounding));
}

//> At any frame rate
TEST_CASE("in any time there are rate times time of them, to within one, however it is cut into frames", "[11.7]") {
    const double rate = GENERATE(0.3, 7.0, 100.0, 59.9, 1234.5);
    const double frames_per_second = GENERATE(24.0, 30.0, 50.0, 60.0, 144.0);
    double carry = 0;
    int total = 0;
    for (int frame = 1; frame <= 60; ++frame) {
        const Due now = due(rate, carry, 1 / frames_per_second);
        carry = now.carry;
        total += now.count;
        CHECK_THAT(carry >= 0 && carry < 1, IsTrue("the carry is from 0 up to, but without, 1"));
        CHECK_THAT(std::abs(total - rate * frame / frames_per_second),
                   IsAtMost(1 + 1e-9).of("how far all counts together are from rate times time")); // 60 roundings
    }
}

TEST_CASE("30 and 60 frames a second start equally many", "[11.7]") {
    // 32 and 64, so that no frame's length is rounded, and a quarter of a particle each: 1 in 4 frames, 1 in 8
    const auto started_in_a_second = [](int frames) {
        Due now{};
        int total = 0;
        for (int frame = 0; frame < frames; ++frame) {
            now = due(8.0, now.carry, 1.0 / frames);
            total += now.count;
        }
        return total;
    };
    CHECK_THAT(started_in_a_second(32), IsNear(8).of("count of 32 frames"));
    CHECK_THAT(started_in_a_second(64), IsNear(8).of("count of 64 frames"));
    CHECK_THAT(started_in_a_second(4), IsNear(8).of("count of 4 frames"));
    CHECK_THAT(started_in_a_second(1), IsNear(8).of("count of 1 frame"));
}

//>
namespace {

/// Checks that count and carry are together what they should be. Where a rounding decides, the last one may be carried.
void check_adds_up(const Due &now, double together) {
    CHECK_THAT(now.carry >= 0 && now.carry < 1, IsTrue("the carry is from 0 up to, but without, 1"));
    CHECK_THAT(now.count + now.carry, IsNear(together, rounding).of("count and carry together"));
}

} // namespace

TEST_CASE("no part of a particle is lost, in frames as long as chance wants them", "[11.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double rate = dice.real(0, 300), carry = dice.real(0, 1), dt = dice.real(0, 0.2);
        const Due now = due(rate, carry, dt);
        check_adds_up(now, carry + rate * dt);
    }
}

TEST_CASE("nearly a whole one is none yet, and next to nothing is carried on", "[11.7]") {
    const double little = 0x1p-45; // 3e-14
    CHECK_THAT(due(1, 0, 1 - little), IsNear(Due{0, 1 - little}, little / 8));
    CHECK_THAT(due(1, 1 - little, 2), IsNear(Due{2, 1 - little}, little / 8));
    CHECK_THAT(due(1, little, 2), IsNear(Due{2, little}, little / 8));
    CHECK_THAT(due(0, 5e-13, 1), IsNear(Due{0, 5e-13}, 1e-15));
    CHECK_THAT(due(5e-10, 0, 1e5), IsNear(Due{0, 5e-5}, rounding_of_1e5));
    CHECK_THAT(due(1e5, 0, 5e-10), IsNear(Due{0, 5e-5}, rounding_of_1e5));
    CHECK_THAT(due(1e-5, 0, 5e-5), IsNear(Due{0, 5e-10}, rounding));
}

TEST_CASE("in no time, and at no rate, none is due, and the carry stays", "[11.7]") {
    CHECK_THAT(due(100, 0.75, 0), IsNear(Due{0, 0.75}, rounding));
    CHECK_THAT(due(0, 0.75, 5), IsNear(Due{0, 0.75}, rounding));
    CHECK_THAT(due(-0.0, -0.0, -0.0), IsNear(Due{0, 0})); // each is 0
}

TEST_CASE("a frame may be long: a million at once are due, and not more", "[11.7]") {
    check_adds_up(due(1e5, 0, 10), 1e6);
    check_adds_up(due(10, 0.25, 1e5), 1e6 + 0.25);
    check_adds_up(due(1e5, 0.5, 10), 1e6 + 0.5); // what was carried comes on top
    CHECK_REFUSED(due(1e5, 0, 10 + 5e-9), "rate times dt is more than 1e6");
    CHECK_REFUSED(due(1e5, 0, 10.1), "rate times dt is more than 1e6");
    CHECK_REFUSED(due(1e5, 0, 1e5), "rate times dt is more than 1e6");
}

TEST_CASE("a rate, a carry or a time that cannot be is refused", "[11.7]") {
    for (const double other : {0.1, 0.0, -0.1}) // also where the other one is 0, or makes the product positive
        for (const double bad : {-1.0, -1e-9}) {
            CHECK_REFUSED(due(bad, 0, other), "rate is negative");
            CHECK_REFUSED(due(other, 0, bad), "dt is negative");
        }
    for (const double rate : {10.0, 0.0})
        for (const double dt : {0.1, 0.0}) {
            for (const double bad : {-0.1, -1e-9, 1.0, 1 + 1e-9, 1.5})
                CHECK_REFUSED(due(rate, bad, dt), "carry is outside of [0, 1)");
            CHECK_OUT_OF_RANGE_REFUSED(due, {rate, 0, dt});
        }
}

// -------------------------------------------------------------------------------------------------------- 11.8 fly

namespace {

const std::vector<Wall> ground{{.start = {0, 0}, .end = {20, 0}}};

Particle flying(const Vec2 &position, const Vec2 &velocity, double age = 0) { return {position, velocity, age, 1e5}; }

/// A box from (0, 0) to (8, 6), its left sides inside. Its walls go on beyond the corners, for at its very end a wall may
/// turn or not.
const std::vector<Wall> box{{{-1, 0}, {9, 0}}, {{8, -1}, {8, 7}}, {{9, 6}, {-1, 6}}, {{0, 7}, {0, -1}}};

/// A level wall as long as there can be, its left side up.
const std::vector<Wall> endless{{.start = {-1e5, 0}, .end = {1e5, 0}}};

} // namespace

//> Half of it comes back
TEST_CASE("the worked example: at a wall half of the speed into it comes back, and the time left is flown", "[11.8]") {
    // 3 m above the ground, falling 2 m/s: there after 1.5 s, at x = 4 + 1.5 · 2. Then 1 m/s up, for half a second.
    CHECK_THAT(fly(flying({4, 3}, {2, -2}), ground, 0.5, 2), IsNear(flying({8, 0.5}, {2, 1}, 2), rounding));
}

//>
TEST_CASE("at a wall that leans, only the part along its normal is turned and lessened", "[11.8]") {
    // the wall goes (-9, 12), its normal (-0.8, -0.6); of (5, 0) the part into it is 4. It is there after 1.9 s:
    // at y = 2 the wall stands at 20 - 9/12 · 2 = 18.5. (5, 0) + (1 + 0.25) 4 (-0.8, -0.6) = (1, -3), for 0.1 s
    const std::vector<Wall> leaning{{.start = {20, 0}, .end = {11, 12}}};
    CHECK_THAT(fly(flying({9, 2}, {5, 0}), leaning, 0.25, 2), IsNear(flying({18.6, 1.7}, {1, -3}, 2), rounding));
    CHECK_THAT(fly(flying({9, 2}, {5, 0}), leaning, 1, 2), IsNear(flying({18.36, 1.52}, {-1.4, -4.8}, 2), rounding));
    CHECK_THAT(fly(flying({9, 2}, {5, 0}), leaning, 0, 2), IsNear(flying({18.68, 1.76}, {1.8, -2.4}, 2), rounding));
}

TEST_CASE("what comes from the right side of a wall passes", "[11.8]") {
    CHECK_THAT(fly(flying({4, -3}, {2, 2}), ground, 0.5, 3), IsNear(flying({10, 3}, {2, 2}, 3), rounding));
    const std::vector<Wall> ceiling{{.start = {20, 0}, .end = {0, 0}}};
    CHECK_THAT(fly(flying({4, 3}, {2, -2}), ceiling, 0.5, 3), IsNear(flying({10, -3}, {2, -2}, 3), rounding));
    CHECK_THAT(fly(flying({4, -3}, {2, 2}), ceiling, 0.5, 2), IsNear(flying({8, -0.5}, {2, -1}, 2), rounding));
}

TEST_CASE("beside the ends of a wall there is nothing", "[11.8]") {
    CHECK_THAT(fly(flying({-0.5, 3}, {0, -2}), ground, 0.5, 3), IsNear(flying({-0.5, -3}, {0, -2}, 3), rounding));
    CHECK_THAT(fly(flying({20.5, 3}, {0, -2}), ground, 0.5, 3), IsNear(flying({20.5, -3}, {0, -2}, 3), rounding));
    CHECK_THAT(fly(flying({0.001, 3}, {0, -2}), ground, 0.5, 2), IsNear(flying({0.001, 0.5}, {0, 1}, 2), rounding));
    CHECK_THAT(fly(flying({19.999, 3}, {0, -2}), ground, 0.5, 2), IsNear(flying({19.999, 0.5}, {0, 1}, 2), rounding));
    // on its line: beside it, and coming towards its end
    CHECK_THAT(fly(flying({20.5, 0}, {2, -2}), ground, 0.5, 1), IsNear(flying({22.5, -2}, {2, -2}, 1), rounding));
    CHECK_THAT(fly(flying({25, 0}, {-4, 0}), ground, 0.5, 2), IsNear(flying({17, 0}, {-4, 0}, 2), rounding));
    CHECK_THAT(fly(flying({-5, 0}, {4, 0}), ground, 0.5, 2), IsNear(flying({3, 0}, {4, 0}, 2), rounding));
}

TEST_CASE("a wall ends where it ends, to `touching`, however long it is", "[11.8]") {
    const std::vector<Wall> long_one{{.start = {-1e5, 0}, .end = {5e4, 0}}};
    const auto check_turned = [](const std::vector<Wall> &walls, double x, bool turned) {
        const Particle want = turned ? flying({x, 0.5}, {0, 1}, 2) : flying({x, -1}, {0, -2}, 2);
        CHECK_THAT(fly(flying({x, 3}, {0, -2}), walls, 0.5, 2), IsNear(want, rounding_of_1e5));
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
        CHECK_THAT(fly(flying({5e-4, 1}, {0, -2}), tiny, 0.5, 1), IsNear(flying({5e-4, 0.5}, {0, 1}, 1), rounding));
        CHECK_THAT(fly(flying({length + 1e-4, 1}, {0, -2}), tiny, 0.5, 1),
                   IsNear(flying({length + 1e-4, -1}, {0, -2}, 1), rounding));
    }
    const std::vector<Wall> diagonal{{.start = {-1e5, -1e5}, .end = {1e5, 1e5}}};
    CHECK_THAT(fly(flying({49'997, 50'003}, {3, -3}), diagonal, 1, 2),
               IsNear(flying({49'997, 50'003}, {-3, 3}, 2), rounding));

    // up 200 km, and 0.1 m to the right: 5e-7 a metre. It is met at x = 0.05 after 0.5025 s
    const double lean = 5e-7;
    const std::vector<Wall> steep{{.start = {0, -1e5}, .end = {0.1, 1e5}}};
    const Vec2 turned{20 - 40 / (1 + lean * lean), 40 * lean / (1 + lean * lean)};
    CHECK_THAT(fly(flying({-10, 0}, {20, 0}), steep, 1, 1),
               IsNear(flying(Vec2{0.05, 0} + 0.4975 * turned, turned, 1), rounding_of_1e5));

    for (const Vec2 &end : {Vec2{1e-3, 0}, Vec2{0, -1e-3}, Vec2{8e-4, 8e-4}})
        CHECK_THAT(fly(flying({4, 3}, {2, -2}), {{{0, 0}, end}}, 1, 1), IsNear(flying({6, 1}, {2, -2}, 1), rounding));
}

TEST_CASE("where it meets none it flies straight on", "[11.8]") {
    CHECK_THAT(fly(flying({4, 3}, {2, -1}), {}, 0.5, 2), IsNear(flying({8, 1}, {2, -1}, 2), rounding));
    CHECK_THAT(fly(flying({4, 3}, {2, -1}), ground, 0.5, 2), IsNear(flying({8, 1}, {2, -1}, 2), rounding)); // too early
    CHECK_THAT(fly(flying({4, 3}, {2, 0}), ground, 0.5, 2), IsNear(flying({8, 3}, {2, 0}, 2), rounding));
    CHECK_THAT(fly(flying({4, 3}, {2, 1}), ground, 0.5, 2), IsNear(flying({8, 5}, {2, 1}, 2), rounding));
    CHECK_THAT(fly(flying({4, 3}, {0, 0}), ground, 0.5, 2), IsNear(flying({4, 3}, {0, 0}, 2), rounding));
}

TEST_CASE("it grows older by dt, lives as long as before, and death does not stop it here", "[11.8]") {
    const Particle old{.position = {4, 3}, .velocity = {2, -2}, .age = 3, .life = 4};
    CHECK_THAT(fly(old, ground, 0.5, 2), IsNear(Particle{{8, 0.5}, {2, 1}, 5, 4}, rounding));
    CHECK_THAT(fly(old, ground, 0.5, 0), IsNear(old, rounding));
    const Particle over{.position = {4, 3}, .velocity = {2, -2}, .age = 4, .life = 4};
    CHECK_THAT(fly(over, ground, 0.5, 2), IsNear(Particle{{8, 0.5}, {2, 1}, 6, 4}, rounding));

    for (const Particle &particle : unusual) CHECK_THAT(fly(particle, {}, 1, 0), IsNear(particle, rounding));
}

TEST_CASE("the first wall in time turns it, wherever that stands in the list, be it behind thousands", "[11.8]") {
    const Wall near{.start = {0, 2}, .end = {20, 2}}, far{.start = {0, 0}, .end = {20, 0}};
    const Particle want = flying({14, 3.5}, {2, 0.5}, 5); // 2 s to y = 2 at 1 m/s, then 0.5 m/s back for 3 s
    CHECK_THAT(fly(flying({4, 4}, {2, -1}), {near, far}, 0.5, 5), IsNear(want, rounding)); // 4 s to the far one
    CHECK_THAT(fly(flying({4, 4}, {2, -1}), {far, near}, 0.5, 5), IsNear(want, rounding));

    // the ground is nearer, the wall on the right is met earlier: after 1 s, and the ground after 2
    const Wall right{.start = {12, -9}, .end = {12, 9}};
    CHECK_THAT(fly(flying({2, 2}, {10, -1}), {ground[0], right}, 0.5, 3),
               IsNear(flying({2, 0.5}, {-5, 0.5}, 3), rounding));
    CHECK_THAT(fly(flying({2, 2}, {10, -1}), {right, ground[0]}, 0.5, 3),
               IsNear(flying({2, 0.5}, {-5, 0.5}, 3), rounding));

    std::vector<Wall> walls;
    for (int i = 0; i < 5000; ++i) walls.push_back({{100.0 + i, 50}, {100.5 + i, 50}}); // none of them in its way
    walls.push_back(ground[0]);
    CHECK_THAT(fly(flying({4, 3}, {2, -2}), walls, 0.5, 2), IsNear(flying({8, 0.5}, {2, 1}, 2), rounding));
}

TEST_CASE("on a wall: what approaches bounces at once, what leaves or flies along is let go", "[11.8]") {
    const double height = GENERATE(0.0, 1e-12, -1e-12);
    CHECK_THAT(fly(flying({5, height}, {4, -2}), ground, 0.5, 1), IsNear(flying({9, 1}, {4, 1}, 1), 1e-11));
    CHECK_THAT(fly(flying({5, height}, {4, 2}), ground, 0.5, 1), IsNear(flying({9, 2}, {4, 2}, 1), 1e-11));
    CHECK_THAT(fly(flying({5, height}, {4, 0}), ground, 0.5, 1), IsNear(flying({9, 0}, {4, 0}, 1), 1e-11));

    for (const double behind : {2e-10, 0.96e-9})
        CHECK_THAT(fly(flying({5, -behind}, {4, -2}), ground, 0.5, 1), IsNear(flying({9, 1}, {4, 1}, 1), 1e-8));
    for (const double behind : {1.05e-9, 5e-9, 1e-6})
        CHECK_THAT(fly(flying({5, -behind}, {4, -2}), ground, 0.5, 1), IsNear(flying({9, -2}, {4, -2}, 1), 1e-5));
}

TEST_CASE("faster than `touching` it approaches a wall, however slow that is", "[11.8]") {
    // a ten-thousandth of a metre in a day
    CHECK_THAT(fly(flying({4, 5e-5}, {0, -1.05e-9}), ground, 1, 1e5),
               IsNear(flying({4, 5.5e-5}, {0, 1.05e-9}, 1e5), rounding_of_1e5));
    CHECK_THAT(fly(flying({4, 5e-5}, {0, -0.95e-9}), ground, 1, 1e5),
               IsNear(flying({4, -4.5e-5}, {0, -0.95e-9}, 1e5), rounding_of_1e5));
    // fast along it
    CHECK_THAT(fly(flying({-5e4, 2e-5}, {100, -5e-8}), endless, 1, 1000),
               IsNear(flying({5e4, 3e-5}, {100, 5e-8}, 1000), 2 * rounding));
    for (const double slow : {5e-3, 5e-4, 5e-7}) // half of the speed comes back
        CHECK_THAT(fly(flying({4, 100 * slow}, {0, -slow}), ground, 0.5, 200),
                   IsNear(flying({4, 50 * slow}, {0, slow / 2}, 200), rounding));
    CHECK_THAT(fly(flying({4, 3}, {5e-10, 0}), ground, 1, 1e5),
               IsNear(flying({4 + 5e-5, 3}, {5e-10, 0}, 1e5), rounding_of_1e5));
}

TEST_CASE("the shortest time is flown as well, and the longest", "[11.8]") {
    CHECK_THAT(fly(flying({4, 3}, {1e5, 0}), ground, 1, 5e-10),
               IsNear(flying({4 + 5e-5, 3}, {1e5, 0}, 5e-10), rounding_of_1e5));
    CHECK_THAT(fly(flying({4, 5e-5}, {0, -1e5}), ground, 1, 1e-5),
               IsNear(flying({4, 1 - 5e-5}, {0, 1e5}, 1e-5), rounding_of_1e5)); // at once
    CHECK_THAT(fly(flying({4, 1}, {0, -1e5}), ground, 1, 1e-5 + 5e-10),
               IsNear(flying({4, 5e-5}, {0, 1e5}, 1e-5 + 5e-10), rounding_of_1e5));
    CHECK_THAT(fly(flying({4, 1}, {0, -1}), ground, 1, 1 - 5e-7),
               IsNear(flying({4, 5e-7}, {0, -1}, 1 - 5e-7), rounding)); // not yet
    CHECK_THAT(fly(flying({4, 50}, {0, -1e-3}), ground, 1, 1e5),
               IsNear(flying({4, 50}, {0, 1e-3}, 1e5), rounding_of_1e5));
    CHECK_THAT(fly(flying({4, 3}, {2, -2}), ground, -0.0, 2), IsNear(flying({8, 0}, {2, 0}, 2), rounding));
}

TEST_CASE("what goes in may be as large as 1e5, and what comes out larger", "[11.8]") {
    CHECK_THAT(fly({{1e5, -1e5}, {1e5, -1e5}, 1e5, 1e5}, {}, 1, 1e5),
               IsNear(Particle{{1e10 + 1e5, -1e10 - 1e5}, {1e5, -1e5}, 2e5, 1e5}, rounding));
    const std::vector<Wall> floor{{.start = {-1e5, -1e5}, .end = {1e5, -1e5}}}; // 200 km below
    CHECK_THAT(fly(flying({0, 1e5}, {0, -1e5}), floor, 1, 3), IsNear(flying({0, 0}, {0, 1e5}, 3), rounding_of_1e5));

    // a wall that leans by 22.5 degrees turns what falls at 45 degrees straight up
    const Vec2 along{std::cos(pi / 8), std::sin(pi / 8)}, normal{-along.y(), along.x()}, falling{1e5, -1e5},
        up{0, 1e5 * std::sqrt(2)};
    const std::vector<Wall> leaning{{.start = -1000 * along, .end = 1000 * along}};
    const double t = -10 / falling.dot(normal);
    CHECK_THAT(fly(flying(10 * normal, falling), leaning, 1, 1),
               IsNear(flying(10 * normal + t * falling + (1 - t) * up, up, 1), 1e-11));
}

TEST_CASE("without restitution it slides along the wall, for as long as you like", "[11.8]") {
    CHECK_THAT(fly(flying({4, 3}, {2, -2}), ground, 0, 6), IsNear(flying({16, 0}, {2, 0}, 6), 1e-9));

    const Vec2 along{0.8, 0.6}, up{-0.6, 0.8}; // a slope whose numbers are rounded
    const std::vector<Wall> slope{{.start = -1000 * along, .end = 1000 * along}};
    Particle now = fly(flying(3 * up, 2 * along - 3 * up), slope, 0, 1); // there after 1 s
    for (int frame = 0; frame < 200; ++frame) now = fly(now, slope, 0, 1.0 / 64);
    CHECK_THAT(now.position, IsNear(Vec2{(2 + 2 * 200 / 64.0) * along}, 1e-9).of("position [m]"));
    CHECK_THAT(now.velocity, IsNear(Vec2{2 * along}, 1e-9).of("velocity [m/s]"));
}

TEST_CASE("into a corner: both walls turn it", "[11.8]") {
    // (8, 6) is reached after 1 s; then a second back, at half the speed
    CHECK_THAT(fly(flying({5, 4}, {3, 2}), box, 0.5, 2), IsNear(flying({6.5, 5}, {-1.5, -1}, 2), 1e-11));
    CHECK_THAT(fly(flying({3, 2}, {-3, -2}), box, 1, 2), IsNear(flying({3, 2}, {3, 2}, 2), 1e-11));
}

TEST_CASE("in a corner of any angle both walls turn it, until it approaches neither", "[11.8]") {
    const int parts = GENERATE(2, 3, 5, 9, 18); // of 180 degrees; the walls go on behind the corner
    const double angle = pi / parts;
    const auto to = [](double at) { return Vec2{std::cos(at), std::sin(at)}; };
    const std::vector<Wall> corner{{{-100, 0}, {100, 0}}, {100 * to(angle), -100 * to(angle)}};
    // Mirror the corner at its walls again and again: there the path is straight. Fold it back.
    const auto folded = [&](const Vec2 &v) {
        const double turn = std::fmod(std::atan2(v.y(), v.x()) + 2 * pi, 2 * angle);
        return Vec2{v.norm() * to(std::min(turn, 2 * angle - turn))};
    };
    for (const double share : {0.1, 0.3, 0.5, 0.9}) {
        const Vec2 from = 2 * to(share * angle);
        // into the very corner: after 1 s it is out again, as far as it was; the way back is straight
        const Vec2 out = folded(-from);
        CHECK_THAT(fly(flying(from, -2 * from), corner, 1, 1), IsNear(flying(out, 2 * out, 1), 1e-9));
        // beside it
        const Vec2 velocity = 5 * to(pi + share / 10), after = from + 3 * velocity;
        CHECK_THAT(fly(flying(from, velocity), corner, 1, 3).position, IsNear(folded(after), 1e-9).of("position [m]"));
    }
}

//> Unfolded
TEST_CASE("in a box with restitution 1 each axis goes to and fro by itself", "[11.8]") {
    // Mirror the box at its walls again and again: the way is straight there. Fold it back.
    const auto folded = [](double x, double width) {
        const double in_two = std::fmod(std::fmod(x, 2 * width) + 2 * width, 2 * width);
        return width - std::abs(width - in_two);
    };
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 from{dice.real(0.01, 7.99), dice.real(0.01, 5.99)}, velocity = dice.point(-30, 30);
        const double dt = dice.real(0, 3);
        const Particle after = fly(flying(from, velocity), box, 1, dt);

        const Vec2 straight = from + dt * velocity;
        // up to 40 bounces, each with some roundings of 90 m
        CHECK_THAT(after.position,
                   IsNear(Vec2{folded(straight.x(), 8), folded(straight.y(), 6)}, 1e-9).of("position [m]"));
        CHECK_THAT(after.velocity.cwiseAbs(),
                   IsNear(Vec2{velocity.cwiseAbs()}, 1e-9).of("velocity without its signs [m/s]"));
    }
}

//> Between two walls
TEST_CASE("between two walls it loses the same share at each, and needs longer each time", "[11.8]") {
    const double e = GENERATE(0.3, 0.5, 0.9, 1.0);
    const double width = 6, speed = 5;
    const int bounces = GENERATE(1, 2, 3, 6);
    // from the left wall: 6/5 s to the right one, then e times as fast, …
    double time = 0, now = speed;
    for (int i = 0; i < bounces; ++i, now *= e) time += width / now;
    const double rest = 0.25 * width / now; // and a quarter of the way back
    const std::vector<Wall> walls{{{0, 9}, {0, -9}}, {{width, -9}, {width, 9}}};

    const Particle after = fly(flying({0, 0}, {speed, 0}), walls, e, time + rest);

    const bool on_the_way_left = bounces % 2 == 1;
    const double x = on_the_way_left ? 0.75 * width : 0.25 * width;
    CHECK_THAT(after, IsNear(flying({x, 0}, {on_the_way_left ? -now : now, 0}, time + rest), 1e-9));
}

namespace {

/// Seven corners, one of which stands into the room, and the walls between them.
const std::vector<Vec2> cave{{0.5, 1}, {6, 0}, {11.5, 1.5}, {10, 6.5}, {6.5, 3.5}, {4, 7}, {1, 5.5}};

std::vector<Wall> walls_of(const std::vector<Vec2> &room) {
    std::vector<Wall> walls;
    for (std::size_t i = 0; i < room.size(); ++i) walls.push_back({room[i], room[(i + 1) % room.size()]});
    return walls;
}

/// How far a point is outside of the cave [m]; 0 or less: it is inside, or on a wall. Even and odd crossings to the
/// right tell inside from outside, and only for a point near no wall does it matter.
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
TEST_CASE("in a cave nothing escapes, and no energy is won", "[11.8]") {
    const double e = GENERATE(1.0, 0.97);
    const std::vector<Wall> walls = walls_of(cave);
    Dice dice;
    Particle now = flying({2, 3}, {23, 11});
    for (int frame = 0; frame < course::cases(20000); ++frame) {
        const Particle after = fly(now, walls, e, dice.real(0, 0.2)); // up to five metres, and several walls

        CHECK_THAT(outside(after.position, cave), IsBelow(1e-9).of("how far it is outside of the cave [m]"));
        CHECK_THAT(after.velocity.norm(), IsAtMost(now.velocity.norm() * (1 + rounding)).of("speed [m/s]"));
        if (e == 1) CHECK_THAT(after.velocity.norm(), IsNear(now.velocity.norm(), rounding).of("speed [m/s]"));
        now = {after.position, after.velocity, 0, 1e5};
    }
}

//>
TEST_CASE("no wall is jumped over, however fast it is", "[11.8]") {
    // 90 km in one call, against a fence of 2 m
    const std::vector<Wall> fence{{.start = {5, -1}, .end = {5, 1}}};
    CHECK_THAT(fly(flying({-45000, 0}, {90000, 0}), fence, 1, 1), IsNear(flying({-44990, 0}, {-90000, 0}, 1), 1e-9));
}

TEST_CASE("after most_bounces bounces it waits, and the call ends", "[11.8]") {
    const std::vector<Wall> slit{{{0, 9}, {0, -9}}, {{0.01, -9}, {0.01, 9}}};
    const Particle after = fly(flying({0.005, 0}, {1e5, 0}), slit, 1, 1e4); // 1e11 bounces, would it go on
    CHECK_THAT(after.position.x(), IsAbove(-1e-9).of("position along x [m]"));
    CHECK_THAT(after.position.x(), IsBelow(0.01 + 1e-9).of("position along x [m]"));
    CHECK_THAT(after.position.y(), IsNear(0.0, 1e-9).of("position along y [m]"));
    CHECK_THAT(std::abs(after.velocity.x()), IsNear(1e5, 1e-9).of("speed along x [m/s]"));
    CHECK_THAT(after.age, IsNear(1e4, rounding).of("age [s]"));
}

TEST_CASE("the last bounce before it waits is the 1000th", "[11.8]") {
    // 1024 times a second from one side to the other, first from x = 0.25: no time is rounded
    const std::vector<Wall> slit{{{0, 9}, {0, -9}}, {{1, -9}, {1, 9}}};
    const auto time = [](double bounces) { return (bounces - 0.25) / 1024; };
    const auto after = [&](double bounces) { return fly(flying({0.25, 0}, {1024, 0}), slit, 1, time(bounces)); };
    const auto is_at = [&](double x, double velocity, double bounces) {
        return IsNear(flying({x, 0}, {velocity, 0}, time(bounces)), 1e-9);
    };
    static_assert(most_bounces == 1000);
    CHECK_THAT(after(998.5), is_at(0.5, 1024, 998.5));
    CHECK_THAT(after(999.5), is_at(0.5, -1024, 999.5));
    for (const double more : {1000.5, 1001.5, 1002.5, 3000.5}) CHECK_THAT(after(more), is_at(0, 1024, more));
    for (int again = 0; again < 20; ++again) CHECK_THAT(after(700.5), is_at(0.5, 1024, 700.5)); // each call counts anew

    // to and fro through a square: each of its corners takes two bounces
    const std::vector<Wall> square{{{-1, 0}, {2, 0}}, {{1, -1}, {1, 2}}, {{2, 1}, {-1, 1}}, {{0, 2}, {0, -1}}};
    const auto in_corners = [&](double corners) {
        return fly(flying({0, 0}, {1024, 1024}), square, 1, corners / 1024);
    };
    CHECK_THAT(in_corners(499.5), IsNear(flying({0.5, 0.5}, {-1024, -1024}, 499.5 / 1024), 1e-9));
    CHECK_THAT(in_corners(500.5), IsNear(flying({0, 0}, {1024, 1024}, 500.5 / 1024), 1e-9));
}

TEST_CASE("what is no particle, no wall, no restitution or no time is refused", "[11.8]") {
    const auto check_refused = [](const Particle &particle, double dt) {
        const Wall good = ground[0];
        const auto fly_among = [&](const std::vector<Wall> &walls) { return fly(particle, walls, 0.5, dt); };
        for (const Vec2 &end : {Vec2{0, 0}, Vec2{0, 0.0009}, Vec2{1e-3 - 5e-8, 0}, Vec2{6e-4, 6e-4}}) {
            CHECK_REFUSED(fly_among({{{0, 0}, end}}), "the only wall is shorter than 1e-3 m");
            CHECK_REFUSED(fly_among({good, {{0, 0}, end}}), "the second wall is shorter than 1e-3 m");
            CHECK_REFUSED(fly_among({{{0, 0}, end}, good}), "the first wall is shorter than 1e-3 m");
        }
        CHECK_REFUSED(fly_among({good, {{900, 900}, {900, 900}}}), "a wall far away is a point");
        for (const std::vector<Wall> &walls : {ground, std::vector<Wall>{}}) {
            for (const double bad : {-0.1, -1e-9, 1.1, 1 + 1e-9})
                CHECK_REFUSED(fly(particle, walls, bad, dt), "restitution is not from 0 to 1");
            for (const double bad : {-1.0, -1e-9}) CHECK_REFUSED(fly(particle, walls, 0.5, bad), "dt is negative");
            check_age_and_life_refused(particle, [&](const Particle &bad) { return fly(bad, walls, 0.5, dt); });
        }
        CHECK_OUT_OF_RANGE_REFUSED(fly, {particle, {}, 0.5, dt});
        CHECK_OUT_OF_RANGE_REFUSED(fly, {particle, {good, {{2, 2}, {2, 3}}}, 0.5, dt});
    };
    check_refused(flying({4, 3}, {2, -2}), 1);
    check_refused(flying({4, 3}, {0, 0}), 1);  // at rest
    check_refused({{4, 3}, {2, -2}, 7, 5}, 0); // dead, and in no time
}

// ------------------------------------------------------------------------------------------------------ 11.9 renew

namespace {

/// As many particles as letters: a dot is a dead one.
std::vector<Particle> row_of(const std::string &letters) {
    std::vector<Particle> row;
    for (const char letter : letters) {
        row.push_back(numbered(int(row.size()) + 1));
        if (letter == '.') row.back().age = row.back().life;
    }
    return row;
}

bool lives(const Particle &particle) { return particle.age < particle.life; }

/// Checks all that the header says of `renew`.
void check_renewed(const std::vector<Particle> &pool, const std::vector<Particle> &newborn, int capacity) {
    const std::vector<Particle> after = renew(pool, newborn, capacity);

    const auto living = std::size_t(std::ranges::count_if(pool, lives));
    const std::size_t fit = std::min(newborn.size(), std::size_t(capacity) - living);
    CHECK_THAT(after, HasSize(living + fit));
    for (std::size_t i = 0; i < living; ++i)
        if (lives(pool[i])) CHECK_THAT(after[i], IsNear(pool[i]).of("a particle that need not move"));
    for (const Particle &particle : pool) // nobody is lost, nobody is there twice
        if (lives(particle)) {
            const auto found = std::count_if(after.begin(), after.begin() + std::ptrdiff_t(living),
                                             [&](const Particle &other) { return same(particle, other); });
            CHECK_THAT(int(found), IsNear(1).of("places of the same particle"));
        }
    for (std::size_t i = 0; i < fit; ++i) CHECK_THAT(after[living + i], IsNear(newborn[i]).of("a newborn particle"));
}

} // namespace

//> The last one moves
TEST_CASE("the worked example: the last one fills the gap, and nobody else moves", "[11.9]") {
    const std::vector<Particle> five = row_of("ab.de"); // the third of five is dead
    const Particle young{.position = {9, 9}, .velocity = {1, 1}, .age = 0, .life = 2};
    CHECK_THAT(renew(five, {}, 8), IsNear(std::vector{five[0], five[1], five[4], five[3]}));
    CHECK_THAT(renew(five, {young}, 8), IsNear(std::vector{five[0], five[1], five[4], five[3], young}));
}

//>
TEST_CASE("one that is dead does not fill a gap", "[11.9]") {
    const std::vector<Particle> row = row_of("a.c..");
    CHECK_THAT(renew(row, {}, 5), IsNear(std::vector{row[0], row[2]}));
    const std::vector<Particle> other = row_of(".b.");
    CHECK_THAT(renew(other, {}, 3), IsNear(std::vector{other[1]}));
    const std::vector<Particle> three = row_of(".bc.e."); // the header's example
    CHECK_THAT(renew(three, {}, 6), IsNear(std::vector{three[4], three[1], three[2]}));
}

TEST_CASE("where nobody is dead nobody moves, even if two are alike", "[11.9]") {
    const std::vector<Particle> row = row_of("abcdefg");
    for (const int capacity : {7, 100, 1'000'001, std::numeric_limits<int>::max()})
        CHECK_THAT(renew(row, {}, capacity), IsNear(row));

    CHECK_THAT(renew({spark, spark}, {spark}, 3), IsNear(std::vector{spark, spark, spark}));
}

TEST_CASE("where all are dead the pool is empty, and new ones find room", "[11.9]") {
    CHECK_THAT(renew(row_of("...."), {}, 4), IsNear(std::vector<Particle>{}));
    CHECK_THAT(renew({}, {}, 0), IsNear(std::vector<Particle>{}));
    const std::vector<Particle> young{numbered(50), numbered(60), numbered(70)};
    CHECK_THAT(renew(row_of("...."), young, 4), IsNear(young));
}

TEST_CASE("no more start than fit, and the first come first", "[11.9]") {
    const std::vector<Particle> row = row_of("ab"), young{numbered(50), numbered(60), numbered(70)};
    CHECK_THAT(renew(row, young, 4), IsNear(std::vector{row[0], row[1], young[0], young[1]}));
    CHECK_THAT(renew(row, young, 2), IsNear(row));
    CHECK_THAT(renew(row_of("a."), young, 2), IsNear(std::vector{row[0], young[0]})); // the dead make room first
    const int most = std::numeric_limits<int>::max();
    CHECK_THAT(renew({row[0]}, {young[0]}, most), IsNear(std::vector{row[0], young[0]}));
}

TEST_CASE("a newborn goes in as it is, and its age is not looked at until the next time", "[11.9]") {
    const Particle old{.position = {1, 2}, .velocity = {3, 4}, .age = 7, .life = 5};
    CHECK_THAT(renew({}, {old}, 1), IsNear(std::vector{old}));
    for (const Particle &particle : unusual) CHECK_THAT(renew({}, {particle}, 1), IsNear(std::vector{particle}));
}

TEST_CASE("a pool may hold thousands", "[11.9]") {
    const auto check_is = [](const std::vector<Particle> &after, const std::vector<Particle> &want) {
        CHECK_THAT(after, HasSize(want.size()));
        CHECK_THAT(std::ranges::equal(after, want, same), IsTrue("each place holds the particle that belongs there"));
    };
    std::vector<Particle> pool(5'000, spark);
    pool.back() = numbered(7);
    for (const std::size_t i : {0u, 4'998u}) pool[i].age = pool[i].life;
    std::vector<Particle> want(4'998, spark);
    want[0] = pool.back(); // the last one moves
    check_is(renew(pool, {}, 5'000), want);

    const std::vector<Particle> newborn(10'001, numbered(3));
    check_is(renew({}, newborn, 1'000'001), newborn);
}

TEST_CASE("dead is whose age has reached its life, exactly or more", "[11.9]") {
    const auto aged = [](double age) { return std::vector{Particle{{1, 2}, {0, 0}, age, 5}}; };
    CHECK_THAT(renew(aged(4.9), {}, 1), IsNear(aged(4.9)));
    CHECK_THAT(renew(aged(5), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(renew(aged(5.1), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(renew(aged(1e5), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(renew(aged(std::nextafter(5, 0)), {}, 1), IsNear(aged(std::nextafter(5, 0))));
    for (const Particle &particle : unusual)
        CHECK_THAT(renew({particle}, {}, 1), IsNear(lives(particle) ? std::vector{particle} : std::vector<Particle>{}));
}

//> Every pattern of eight
TEST_CASE("whoever of eight is dead: the living are all there, and none moves without need", "[11.9]") {
    for (int pattern = 0; pattern < 256; ++pattern) {
        std::vector<Particle> pool = row_of("abcdefgh");
        for (std::size_t i = 0; i < 8; ++i)
            if (pattern >> i & 1) pool[i].age = pool[i].life;
        check_renewed(pool, {}, 8);
    }
}

//>
TEST_CASE("in a pool that is renewed again and again nobody is lost", "[11.9]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000) / 10; ++i) {
        std::vector<Particle> pool, newborn;
        const int size = dice.whole(0, 60), young = dice.whole(0, 20);
        for (int k = 0; k < size; ++k) {
            pool.push_back(numbered(k));
            if (dice.whole(0, 2) == 0) pool.back().age = pool.back().life + dice.whole(0, 1);
        }
        for (int k = 0; k < young; ++k) newborn.push_back(numbered(100 + k));
        check_renewed(pool, newborn, size + dice.whole(0, 10));
    }
}

TEST_CASE("what is no particle, and a capacity that is too small, is refused", "[11.9]") {
    const std::vector<Particle> row = row_of("ab.");
    for (const int capacity : {2, 1, 0, -1})
        CHECK_REFUSED(renew(row, {}, capacity), "capacity is less than the pool holds"); // there are three, one is dead
    for (const int capacity : {-1, std::numeric_limits<int>::min()}) {
        CHECK_REFUSED(renew({}, {}, capacity), "capacity is negative");
        CHECK_REFUSED(renew({}, {row[0]}, capacity), "capacity is negative");
    }
    CHECK_OUT_OF_RANGE_REFUSED(renew, {row, {}, 3});
    CHECK_OUT_OF_RANGE_REFUSED(renew, {row, row_of("a."), 3}); // one of them fits
    CHECK_OUT_OF_RANGE_REFUSED(renew, {{}, row_of("a."), 0});  // none does
    for (const int first : {0, 1, 2}) {                        // with this one dead
        std::vector<Particle> others = row_of("abc");
        others[std::size_t(first)].age = others[std::size_t(first)].life;
        for (const std::size_t i : {0u, 1u, 2u}) {
            check_age_and_life_refused(others[i], [&](const Particle &bad) {
                std::vector<Particle> pool = others;
                pool[i] = bad;
                return renew(pool, {}, 3);
            });
            check_age_and_life_refused(others[i], [&](const Particle &bad) {
                std::vector<Particle> newborn = others;
                newborn[i] = bad;
                return renew({}, newborn, 0);
            });
        }
    }
    std::vector<Particle> large(131, spark);
    large.back().life = 0;
    CHECK_REFUSED(renew(large, {}, 131), "the last of 131 particles has a life of 0");
}
