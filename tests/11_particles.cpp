#include "section_test.hpp"

#include "particles.hpp"

#include <algorithm>
#include <array>
#include <optional>

using particles::Due, particles::Emitter, particles::Particle, particles::Pool, particles::Wall, particles::World;
using particles::touching;
using namespace particles::subject; // start, shade, step, ring, explosion, trail, due, fly, renew: the student's

constexpr double rounding = 1e-12; // some dozen operations on numbers of size a hundred
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

/// A good particle with its `which`-th number of six replaced.
Particle spoilt(Particle p, int which, double by) {
    const std::array<double *, 6> numbers{&p.position.x(), &p.position.y(), &p.velocity.x(),
                                          &p.velocity.y(), &p.age,          &p.life};
    *numbers[std::size_t(which)] = by;
    return p;
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
    const std::optional<Pool> after = start(pool, spark);
    if (after) CHECK(after->size() == 5);
    CHECK_THAT(after, IsNear(std::optional{want}));
}

//>
TEST_CASE("of several free slots it takes one", "[11.1]") {
    const std::vector<int> free = GENERATE(std::vector{0, 1, 2, 3, 4}, std::vector{1, 3}, std::vector{2, 3, 4});
    const Pool pool = pool_with_free(5, free);

    const auto after = start(pool, spark);

    CHECK(after.has_value());
    CHECK(after->size() == 5);
    const std::vector<int> slots_changed = changed(pool, *after);
    CHECK(slots_changed.size() == 1);
    const bool was_free = std::ranges::count(free, slots_changed[0]) == 1;
    CHECK(was_free);
    CHECK_THAT((*after)[std::size_t(slots_changed[0])], IsNear(std::optional{spark}));
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
        const auto after = start(pool, numbered(i));
        CHECK(after.has_value());
        CHECK(after->size() == 128);
        const std::vector<int> slots_changed = changed(pool, *after);
        CHECK(slots_changed.size() == 1);
        pool = *after;
    }
    for (int i = 0; i < 128; ++i) {
        const auto is_it = [&](const std::optional<Particle> &slot) { return slot && same(*slot, numbered(i)); };
        CHECK(std::ranges::count_if(pool, is_it) == 1);
    }
    CHECK_THAT(start(pool, spark), IsNear(no_room));

    const std::size_t freed = GENERATE(0u, 77u, 127u);
    pool[freed].reset();
    const auto again = start(pool, spark);
    CHECK(again.has_value());
    CHECK(again->size() == 128);
    const std::vector<int> slots_changed = changed(pool, *again);
    CHECK(slots_changed == std::vector{int(freed)});
    CHECK_THAT(start(*again, spark), IsNear(no_room));
}

//>
TEST_CASE("a particle goes in as it is, whatever its age, and those in the pool are not looked at", "[11.1]") {
    const Particle old{.position = {-3, 1e5}, .velocity = {0, -1e5}, .age = 90, .life = 3};
    CHECK_THAT(start(Pool(1), old), IsNear(std::optional{Pool{old}}));

    const Pool strange{Particle{{1, 2}, {3, 4}, -1, -1}, std::nullopt};
    CHECK_THAT(start(strange, spark), IsNear(std::optional{Pool{strange[0], spark}}));
}

TEST_CASE("what is no particle is not started", "[11.1]") {
    CHECK(start(Pool(3), spark).has_value());
    const Pool pool = GENERATE(Pool(3), pool_with_free(3, {})); // full or not
    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5, -3e200);
    const int which = GENERATE(range(0, 6));

    CHECK_THROWS_AS(start(pool, spoilt(spark, which, bad)), std::invalid_argument);
    CHECK_THROWS_AS(start(pool, spoilt(spark, 4, -0.1)), std::invalid_argument);
    CHECK_THROWS_AS(start(pool, spoilt(spark, 5, -4)), std::invalid_argument);
    CHECK_THROWS_AS(start(pool, spoilt(spark, 5, 0)), std::invalid_argument);
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
    CHECK(alive == 90);
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
    const double life = GENERATE(1.0, 0.25, 16.0, 1024.0);
    for (int k = 0; k < 8; ++k) CHECK_THAT(shade(k * life / 8, life, 8), IsNear(std::optional{k}));
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
    const int shades = 1 << 30, which = 123'456'789;
    CHECK_THAT(shade(2 * (which + 0.5) / shades, 2, shades), IsNear(std::optional{which}));
}

TEST_CASE("an age, a life or a number of shades that cannot be is refused", "[11.2]") {
    CHECK_THROWS_AS(shade(-0.1, 3, 16), std::invalid_argument);
    CHECK_THROWS_AS(shade(1, 0, 16), std::invalid_argument);
    CHECK_THROWS_AS(shade(0, 0, 16), std::invalid_argument);
    CHECK_THROWS_AS(shade(1, -3, 16), std::invalid_argument);
    CHECK_THROWS_AS(shade(1, 3, 0), std::invalid_argument);
    CHECK_THROWS_AS(shade(1, 3, -16), std::invalid_argument);
    CHECK_THROWS_AS(shade(4, 3, 0), std::invalid_argument); // dead, but asked all the same

    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5);
    CHECK_THROWS_AS(shade(bad, 3, 16), std::invalid_argument);
    CHECK_THROWS_AS(shade(1, bad, 16), std::invalid_argument);
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
    CHECK_THAT(step_at(-1e-9, 100), IsNear(dead));
    CHECK_THAT(step_at(100, -1e-9), IsNear(dead));
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
    const Particle inside{.position = {1, 8}, .velocity = {4, 0}, .age = 0.5, .life = 9};
    CHECK_THAT(step({{-1, 8}, {4, 0}, 0, 9}, still, 0.5), IsNear(std::optional{inside}, rounding)); // from -1 to 1
}

//> Erratum E11.2
TEST_CASE("erratum E11.2: the printed example dies in frame 5, off the top, and not after 90", "[11.3]") {
    // 20 rows below the top one of 480, 5 rows up in each frame; a row is a metre here, and a frame a second
    const double gravity = GENERATE(0.0, 0.1);
    std::optional<Particle> now = Particle{.position = {10, 479 - 20}, .velocity = {0, 5}, .age = 0, .life = 90};
    int frame = 0;
    for (; now && frame < 90; ++frame) now = step(*now, {gravity, 0, 640, 480}, 1);
    CHECK(frame == 5);
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
TEST_CASE("in no time nothing happens", "[11.3]") { CHECK_THAT(step(spark, world, 0), IsNear(std::optional{spark})); }

TEST_CASE("what is no particle, no picture or no time cannot take a step", "[11.3]") {
    CHECK_THROWS_AS(step(spark, world, -0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, 1, 0, 16}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, 1, -20, 16}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, 1, 20, 0}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, 1, 20, -16}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spoilt(spark, 4, -0.1), world, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spoilt(spark, 5, 0), world, 0.1), std::invalid_argument);

    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5, -3e200);
    for (int which = 0; which < 6; ++which)
        CHECK_THROWS_AS(step(spoilt(spark, which, bad), world, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {bad, 1, 20, 16}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, bad, 20, 16}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, 1, bad, 16}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, {10, 1, 20, bad}, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(step(spark, world, bad), std::invalid_argument);
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
    CHECK(velocities.size() == 36);
    for (std::size_t i = 0; i < 36; ++i) {
        const Vec2 &here = velocities[i], &next = velocities[(i + 1) % 36];
        const double turn = std::atan2(here.x() * next.y() - here.y() * next.x(), here.dot(next)); // left of it
        CHECK_THAT(turn * 180 / pi, IsNear(10.0, 1e-10));
    }
}

//>
TEST_CASE("all are equally fast, and together they go nowhere", "[11.4]") {
    const int count = GENERATE(2, 3, 5, 7, 64, 1000);
    const double speed = GENERATE(0.0, 0.5, 40.0), first = GENERATE(0.0, 1.2, -9.0);
    const std::vector<Vec2> velocities = ring(count, speed, first);

    CHECK(velocities.size() == std::size_t(count));
    Vec2 sum{0, 0};
    for (const Vec2 &v : velocities) {
        CHECK_THAT(v.norm(), IsNear(speed, rounding));
        sum += v;
    }
    CHECK_THAT(sum, IsNear(Vec2{0, 0}, 1e-9)); // a thousand roundings of 40
    CHECK_THAT(velocities[0], IsNear(Vec2{speed * std::cos(first), speed * std::sin(first)}, rounding));
}

TEST_CASE("a ring of one goes where the first one goes, and a ring of none is empty", "[11.4]") {
    CHECK_THAT(ring(1, 2, pi / 2), IsNear(std::vector<Vec2>{{0, 2}}, rounding));
    CHECK_THAT(ring(0, 2, 1), IsNear(std::vector<Vec2>{}));
}

TEST_CASE("fewer than none, slower than not at all, and what is no number is refused", "[11.4]") {
    CHECK_THROWS_AS(ring(-1, 5, 0), std::invalid_argument);
    CHECK_THROWS_AS(ring(4, -5, 0), std::invalid_argument);
    CHECK_THROWS_AS(ring(0, -5, 0), std::invalid_argument);
    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5);
    CHECK_THROWS_AS(ring(4, bad, 0), std::invalid_argument);
    CHECK_THROWS_AS(ring(4, 5, bad), std::invalid_argument);
    CHECK_THROWS_AS(ring(0, 5, bad), std::invalid_argument);
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

        CHECK(velocities.size() == 1);
        const Vec2 &v = velocities[0];
        CHECK_THAT(v.squaredNorm() / (fastest * fastest), IsNear(first, rounding));
        const double turn = std::atan2(v.y(), v.x()) / (2 * pi); // from -1/2 to 1/2
        CHECK_THAT(std::remainder(turn - second, 1), IsNear(0.0, rounding));
    }
}

//> Equal areas
TEST_CASE("equal areas get equal shares", "[11.5]") {
    Dice dice;
    std::vector<double> chances(2 * 20000);
    for (double &chance : chances) chance = dice.real(0, 1);
    const std::vector<Vec2> velocities = explosion(chances, 3);
    CHECK(velocities.size() == 20000);

    // ten rings of equal area, cut into six sectors, the axes within them
    std::array<int, 60> counts{};
    for (const Vec2 &v : velocities) {
        CHECK(v.norm() <= 3);
        const double turn = std::atan2(v.y(), v.x()) / (2 * pi) + 0.55;
        const auto sector = std::size_t(6 * (turn - std::floor(turn))), circle = std::size_t(10 * v.squaredNorm() / 9);
        ++counts[std::min<std::size_t>(circle, 9) * 6 + sector];
    }
    // the sum of (count - expected)² / expected is near 59, and above 130 once in a million
    double chi_squared = 0;
    for (const int count : counts) chi_squared += std::pow(count - 20000 / 60.0, 2) / (20000 / 60.0);
    CHECK(chi_squared < 130);
}

//> Erratum E11.7
TEST_CASE("erratum E11.7: one in six is slower than two fifths of the fastest; in print, none is", "[11.5]") {
    // printed speeds: 2, 3, 4 or 5. A disc has 2²/5² = 16 % of its area inside of 2
    std::vector<double> chances;
    for (int i = 0; i < 1000; ++i) chances.insert(chances.end(), {(i + 0.5) / 1000, std::fmod(0.618 * i, 1)});
    const std::vector<Vec2> velocities = explosion(chances, 5);
    CHECK(velocities.size() == 1000);
    CHECK(std::ranges::count_if(velocities, [](const Vec2 &v) { return v.norm() < 2; }) == 160);
}

//>
TEST_CASE("no chances, no particles; no speed, no motion", "[11.5]") {
    CHECK_THAT(explosion({}, 7), IsNear(std::vector<Vec2>{}));
    CHECK_THAT(explosion({0.3, 0.7}, 0), IsNear(std::vector<Vec2>{{0, 0}}));
    CHECK_THAT(explosion({0, 0.7}, 7), IsNear(std::vector<Vec2>{{0, 0}}, rounding));
}

TEST_CASE("an odd number of chances, one that is none, and a speed that is none, are refused", "[11.5]") {
    CHECK_THROWS_AS(explosion({0.5}, 7), std::invalid_argument);
    CHECK_THROWS_AS(explosion({0.5, 0.1, 0.2}, 7), std::invalid_argument);
    CHECK_THROWS_AS(explosion({0.5, 0.1}, -7), std::invalid_argument);
    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.0, -0.001);
    CHECK_THROWS_AS(explosion({bad, 0.5, 0.5, 0.5}, 7), std::invalid_argument);
    CHECK_THROWS_AS(explosion({0.5, bad, 0.5, 0.5}, 7), std::invalid_argument);
    CHECK_THROWS_AS(explosion({0.5, 0.5, 0.5, bad}, 7), std::invalid_argument);
    const double speed = GENERATE(infinity, -infinity, not_a_number, 1.1e5);
    CHECK_THROWS_AS(explosion({0.5, 0.5}, speed), std::invalid_argument);
    CHECK_THROWS_AS(explosion({}, speed), std::invalid_argument);
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

        CHECK_THAT(from_moving.velocity - moving.velocity, IsNear(from_resting.velocity, rounding));
        CHECK_THAT(from_moving.position, IsNear(from_resting.position, rounding));
        CHECK_THAT(from_moving.life, IsNear(from_resting.life, rounding));
    }
}

//> Erratum E11.9
TEST_CASE("erratum E11.9: 100 chances make 100 velocities; in print there are 25 of them", "[11.6]") {
    std::vector<double> across; // printed: a whole number from -2 to 2 along each axis, 5 · 5 pairs
    for (int i = 0; i < 100; ++i) across.push_back(trail(rocket, {0.5, 0.5, i / 100.0, 0.5, 0.5}).velocity.x());
    for (std::size_t i = 0; i < 100; ++i) CHECK_THAT(across[i], IsNear(4 + 0.04 * double(i), rounding));
}

//>
TEST_CASE("without offset, jitter and choice of life, chance has no say", "[11.6]") {
    const Emitter calm{.position = {-3, 2}, .velocity = {1, 7}, .offset = 0, .jitter = 0, .shortest = 2, .longest = 2};
    CHECK_THAT(trail(calm, {0.1, 0.9, 0.3, 0.99, 0.7}), IsNear(Particle{{-3, 2}, {1, 7}, 0, 2}, rounding));
}

TEST_CASE("a trail is made of five chances and a sound emitter", "[11.6]") {
    const std::vector<double> good(5, 0.5);
    CHECK_THROWS_AS(trail(rocket, {}), std::invalid_argument);
    CHECK_THROWS_AS(trail(rocket, {0.5, 0.5, 0.5, 0.5}), std::invalid_argument);
    CHECK_THROWS_AS(trail(rocket, {0.5, 0.5, 0.5, 0.5, 0.5, 0.5}), std::invalid_argument);
    const int which = GENERATE(range(0, 5));
    for (const double bad : {infinity, -infinity, not_a_number, 1.0, -0.001}) {
        std::vector<double> chances = good;
        chances[std::size_t(which)] = bad;
        CHECK_THROWS_AS(trail(rocket, chances), std::invalid_argument);
    }
    const auto refused = [&](double Emitter::*field, double value) {
        Emitter emitter = rocket;
        emitter.*field = value;
        CHECK_THROWS_AS(trail(emitter, good), std::invalid_argument);
    };
    refused(&Emitter::offset, -0.5);
    refused(&Emitter::jitter, -2);
    refused(&Emitter::shortest, 0);
    refused(&Emitter::shortest, -3);
    refused(&Emitter::longest, 2.9); // less than the shortest
    for (const double bad : {infinity, -infinity, not_a_number, 1.1e5}) {
        for (const auto field : {&Emitter::offset, &Emitter::jitter, &Emitter::shortest, &Emitter::longest})
            refused(field, bad);
        for (int axis = 0; axis < 2; ++axis) {
            Emitter lost = rocket, wild = rocket;
            lost.position[axis] = bad;
            wild.velocity[axis] = bad;
            CHECK_THROWS_AS(trail(lost, good), std::invalid_argument);
            CHECK_THROWS_AS(trail(wild, good), std::invalid_argument);
        }
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
        CHECK((carry >= 0 && carry < 1));
        CHECK(std::abs(total - rate * frame / frames_per_second) <= 1 + 1e-9); // 60 roundings
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
    CHECK(started_in_a_second(32) == 8);
    CHECK(started_in_a_second(64) == 8);
    CHECK(started_in_a_second(4) == 8);
    CHECK(started_in_a_second(1) == 8);
}

//>
TEST_CASE("no part of a particle is lost, in frames as long as chance wants them", "[11.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double rate = dice.real(0, 300), carry = dice.real(0, 1), dt = dice.real(0, 0.2);
        const Due now = due(rate, carry, dt);
        CHECK((now.carry >= 0 && now.carry < 1));
        CHECK_THAT(now.count + now.carry, IsNear(carry + rate * dt, rounding));
    }
}

TEST_CASE("in no time, and at no rate, none is due, and the carry stays", "[11.7]") {
    CHECK_THAT(due(100, 0.75, 0), IsNear(Due{0, 0.75}, rounding));
    CHECK_THAT(due(0, 0.75, 5), IsNear(Due{0, 0.75}, rounding));
}

TEST_CASE("a frame may be long: a million at once are due, and not more", "[11.7]") {
    CHECK_THAT(due(1e5, 0, 10), IsNear(Due{1'000'000, 0}, rounding));
    CHECK_THAT(due(10, 0.25, 1e5), IsNear(Due{1'000'000, 0.25}, 1e-9)); // a rounding of a million
    CHECK_THROWS_AS(due(1e5, 0, 10.1), std::invalid_argument);
    CHECK_THROWS_AS(due(1e5, 0, 1e5), std::invalid_argument);
}

TEST_CASE("a rate, a carry or a time that cannot be is refused", "[11.7]") {
    CHECK_THROWS_AS(due(-1, 0, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(due(10, 0, -0.1), std::invalid_argument);
    CHECK_THROWS_AS(due(10, -0.1, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(due(10, 1, 0.1), std::invalid_argument);
    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5);
    CHECK_THROWS_AS(due(bad, 0, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(due(10, bad, 0.1), std::invalid_argument);
    CHECK_THROWS_AS(due(10, 0, bad), std::invalid_argument);
    CHECK_THROWS_AS(due(bad, 0, 0), std::invalid_argument);
}

// -------------------------------------------------------------------------------------------------------- 11.8 fly

namespace {

const std::vector<Wall> ground{{.start = {0, 0}, .end = {20, 0}}};

Particle flying(const Vec2 &position, const Vec2 &velocity, double age = 0) { return {position, velocity, age, 1e5}; }

/// A box from (0, 0) to (8, 6), its left sides inside.
const std::vector<Wall> box{{{0, 0}, {8, 0}}, {{8, 0}, {8, 6}}, {{8, 6}, {0, 6}}, {{0, 6}, {0, 0}}};

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
}

TEST_CASE("the first wall in time turns it, wherever that stands in the list", "[11.8]") {
    const Wall near{.start = {0, 2}, .end = {20, 2}}, far{.start = {0, 0}, .end = {20, 0}};
    const Particle want = flying({14, 3.5}, {2, 0.5}, 5); // 2 s to y = 2 at 1 m/s, then 0.5 m/s back for 3 s
    CHECK_THAT(fly(flying({4, 4}, {2, -1}), {near, far}, 0.5, 5), IsNear(want, rounding)); // 4 s to the far one
    CHECK_THAT(fly(flying({4, 4}, {2, -1}), {far, near}, 0.5, 5), IsNear(want, rounding));
}

TEST_CASE("on a wall: what approaches bounces at once, what leaves or flies along is let go", "[11.8]") {
    const double height = GENERATE(0.0, 1e-12, -1e-12);
    CHECK_THAT(fly(flying({5, height}, {4, -2}), ground, 0.5, 1), IsNear(flying({9, 1}, {4, 1}, 1), 1e-11));
    CHECK_THAT(fly(flying({5, height}, {4, 2}), ground, 0.5, 1), IsNear(flying({9, 2}, {4, 2}, 1), 1e-11));
    CHECK_THAT(fly(flying({5, height}, {4, 0}), ground, 0.5, 1), IsNear(flying({9, 0}, {4, 0}, 1), 1e-11));
    // farther behind it than `touching`: it comes from the right
    CHECK_THAT(fly(flying({5, -1e-6}, {4, -2}), ground, 0.5, 1), IsNear(flying({9, -2}, {4, -2}, 1), 1e-5));
}

TEST_CASE("without restitution it slides along the wall, for as long as you like", "[11.8]") {
    CHECK_THAT(fly(flying({4, 3}, {2, -2}), ground, 0, 6), IsNear(flying({16, 0}, {2, 0}, 6), 1e-9));

    const Vec2 along{0.8, 0.6}, up{-0.6, 0.8}; // a slope whose numbers are rounded
    const std::vector<Wall> slope{{.start = -1000 * along, .end = 1000 * along}};
    Particle now = fly(flying(3 * up, 2 * along - 3 * up), slope, 0, 1); // there after 1 s
    for (int frame = 0; frame < 200; ++frame) now = fly(now, slope, 0, 1.0 / 64);
    CHECK_THAT(now.position, IsNear(Vec2{(2 + 2 * 200 / 64.0) * along}, 1e-9));
    CHECK_THAT(now.velocity, IsNear(Vec2{2 * along}, 1e-9));
}

TEST_CASE("into a corner: both walls turn it", "[11.8]") {
    // (8, 6) is reached after 1 s; then a second back, at half the speed
    CHECK_THAT(fly(flying({5, 4}, {3, 2}), box, 0.5, 2), IsNear(flying({6.5, 5}, {-1.5, -1}, 2), 1e-11));
    CHECK_THAT(fly(flying({3, 2}, {-3, -2}), box, 1, 2), IsNear(flying({3, 2}, {3, 2}, 2), 1e-11));
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
        CHECK_THAT(after.position, IsNear(Vec2{folded(straight.x(), 8), folded(straight.y(), 6)}, 1e-9));
        CHECK_THAT(after.velocity.cwiseAbs(), IsNear(Vec2{velocity.cwiseAbs()}, 1e-9));
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

        CHECK(outside(after.position, cave) < 1e-9);
        CHECK(after.velocity.norm() <= now.velocity.norm() * (1 + rounding));
        if (e == 1) CHECK_THAT(after.velocity.norm(), IsNear(now.velocity.norm(), rounding));
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
    CHECK(after.position.x() > -1e-9);
    CHECK(after.position.x() < 0.01 + 1e-9);
    CHECK_THAT(after.position.y(), IsNear(0.0, 1e-9));
    CHECK_THAT(std::abs(after.velocity.x()), IsNear(1e5, 1e-9));
    CHECK_THAT(after.age, IsNear(1e4, rounding));
}

TEST_CASE("what is no particle, no wall, no restitution or no time is refused", "[11.8]") {
    const Particle good = flying({4, 3}, {2, -2});
    CHECK_THROWS_AS(fly(good, ground, -0.1, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, ground, 1.1, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, ground, 0.5, -1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, {{{2, 2}, {2, 2}}}, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, {ground[0], {{2, 2}, {2, 2.0009}}}, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(spoilt(good, 4, -1), ground, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(spoilt(good, 5, 0), ground, 0.5, 1), std::invalid_argument);

    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5);
    for (int which = 0; which < 6; ++which)
        CHECK_THROWS_AS(fly(spoilt(good, which, bad), ground, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, ground, bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, ground, 0.5, bad), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, {ground[0], {{bad, 2}, {2, 3}}}, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, {ground[0], {{2, bad}, {2, 3}}}, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, {ground[0], {{2, 2}, {bad, 3}}}, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_AS(fly(good, {ground[0], {{2, 2}, {2, bad}}}, 0.5, 1), std::invalid_argument);
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
    CHECK(after.size() == living + fit);
    for (std::size_t i = 0; i < living; ++i)
        if (lives(pool[i])) CHECK_THAT(after[i], IsNear(pool[i])); // it has not moved
    for (const Particle &particle : pool)                          // nobody is lost, nobody is there twice
        if (lives(particle))
            CHECK(std::count_if(after.begin(), after.begin() + std::ptrdiff_t(living),
                                [&](const Particle &other) { return same(particle, other); })
                  == 1);
    for (std::size_t i = 0; i < fit; ++i) CHECK_THAT(after[living + i], IsNear(newborn[i]));
}

} // namespace

//> The last one moves
TEST_CASE("the worked example: the last one fills the gap, and nobody else moves", "[11.9]") {
    const std::vector<Particle> five = row_of("ab.de"); // the third of five is dead
    const Particle young{.position = {9, 9}, .velocity = {1, 1}, .age = 0, .life = 2};
    CHECK(renew(five, {}, 8).size() == 4);
    CHECK_THAT(renew(five, {}, 8), IsNear(std::vector{five[0], five[1], five[4], five[3]}));
    CHECK(renew(five, {young}, 8).size() == 5);
    CHECK_THAT(renew(five, {young}, 8), IsNear(std::vector{five[0], five[1], five[4], five[3], young}));
}

//>
TEST_CASE("one that is dead does not fill a gap", "[11.9]") {
    const std::vector<Particle> row = row_of("a.c..");
    CHECK(renew(row, {}, 5).size() == 2);
    CHECK_THAT(renew(row, {}, 5), IsNear(std::vector{row[0], row[2]}));
    const std::vector<Particle> other = row_of(".b.");
    CHECK(renew(other, {}, 3).size() == 1);
    CHECK_THAT(renew(other, {}, 3), IsNear(std::vector{other[1]}));
    const std::vector<Particle> three = row_of(".bc.e."); // the header's example
    CHECK(renew(three, {}, 6).size() == 3);
    CHECK_THAT(renew(three, {}, 6), IsNear(std::vector{three[4], three[1], three[2]}));
}

TEST_CASE("where nobody is dead nobody moves", "[11.9]") {
    const std::vector<Particle> row = row_of("abcdefg");
    for (const int capacity : {7, 100}) {
        CHECK(renew(row, {}, capacity).size() == 7);
        CHECK_THAT(renew(row, {}, capacity), IsNear(row));
    }
}

TEST_CASE("where all are dead the pool is empty, and new ones find room", "[11.9]") {
    CHECK_THAT(renew(row_of("...."), {}, 4), IsNear(std::vector<Particle>{}));
    CHECK_THAT(renew({}, {}, 0), IsNear(std::vector<Particle>{}));
    const std::vector<Particle> young{numbered(50), numbered(60), numbered(70)};
    CHECK_THAT(renew(row_of("...."), young, 4), IsNear(young));
}

TEST_CASE("no more start than fit, and the first come first", "[11.9]") {
    const std::vector<Particle> row = row_of("ab"), young{numbered(50), numbered(60), numbered(70)};
    CHECK(renew(row, young, 4).size() == 4);
    CHECK_THAT(renew(row, young, 4), IsNear(std::vector{row[0], row[1], young[0], young[1]}));
    CHECK(renew(row, young, 2).size() == 2);
    CHECK_THAT(renew(row, young, 2), IsNear(row));
    CHECK(renew(row_of("a."), young, 2).size() == 2);
    CHECK_THAT(renew(row_of("a."), young, 2), IsNear(std::vector{row[0], young[0]})); // the dead make room first
}

TEST_CASE("a newborn goes in as it is, and its age is not looked at until the next time", "[11.9]") {
    const Particle old{.position = {1, 2}, .velocity = {3, 4}, .age = 7, .life = 5};
    CHECK_THAT(renew({}, {old}, 1), IsNear(std::vector{old}));
}

TEST_CASE("dead is whose age has reached its life, exactly or more", "[11.9]") {
    const auto aged = [](double age) { return std::vector{Particle{{1, 2}, {3, 4}, age, 5}}; };
    CHECK_THAT(renew(aged(4.9), {}, 1), IsNear(aged(4.9)));
    CHECK_THAT(renew(aged(5), {}, 1), IsNear(std::vector<Particle>{}));
    CHECK_THAT(renew(aged(5.1), {}, 1), IsNear(std::vector<Particle>{}));
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
    CHECK_THROWS_AS(renew(row, {}, 2), std::invalid_argument); // there are three, though one is dead
    CHECK_THROWS_AS(renew({}, {}, -1), std::invalid_argument);
    const double bad = GENERATE(infinity, -infinity, not_a_number, 1.1e5);
    for (int which = 0; which < 6; ++which) {
        CHECK_THROWS_AS(renew({row[0], spoilt(row[1], which, bad)}, {}, 3), std::invalid_argument);
        CHECK_THROWS_AS(renew(row, {row[0], spoilt(row[1], which, bad)}, 3), std::invalid_argument); // none would fit
    }
    CHECK_THROWS_AS(renew({spoilt(row[0], 4, -1)}, {}, 3), std::invalid_argument);
    CHECK_THROWS_AS(renew({}, {spoilt(row[0], 5, 0)}, 3), std::invalid_argument);
}
