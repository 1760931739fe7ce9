#include "section_test.hpp"

#include "motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

using motion::Law, motion::PointMass, motion::Sample, motion::Schemes, motion::State;
using namespace motion::subject; // px_per_second, uniform_motion, ... law_of_motion: the student's

constexpr double rounding = 1e-12; // some dozen operations on numbers of size ten
const std::array<double, 6> outside{infinity, -infinity, not_a_number, 1.1e5, -1.1e5, -3e200}; // of the range

// --------------------------------------------------------------------------------------------------- 1.1 px_per_second

//> Worked example: pixels
TEST_CASE("the worked example: 4 px in each of 30 frames a second are 120 px/s", "[1.1]") {
    CHECK_THAT(px_per_second(4, 30), IsNear(120.0, rounding)); // 4 px/frame · 30 frame/s
}

//> More pixels
TEST_CASE("more frames a second, or more pixels a frame: faster; to the left is negative", "[1.1]") {
    CHECK_THAT(px_per_second(4, 60), IsNear(240.0, rounding));
    CHECK_THAT(px_per_second(8, 30), IsNear(240.0, rounding));
    CHECK_THAT(px_per_second(-4, 30), IsNear(-120.0, rounding));
    CHECK_THAT(px_per_second(2.5, 24), IsNear(60.0, rounding));
    CHECK_THAT(px_per_second(3, 0.5), IsNear(1.5, rounding)); // a frame every two seconds
    CHECK_THAT(px_per_second(0, 30), IsNear(0.0));
}

//>
TEST_CASE("a second holds that many frames: moved on in each, it has gone as far as it goes in a second", "[1.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double px = dice.real(-20, 20);
        const int frames = dice.whole(1, 240);
        double way = 0;
        for (int frame = 0; frame < frames; ++frame) way += px;

        CHECK_THAT(px_per_second(px, frames), IsNear(way, 1e-11)); // 240 roundings of 5000 px
    }
}

TEST_CASE("no frames a second, fewer than none, and what is not a number within ±1e5, is refused", "[1.1]") {
    CHECK(std::isfinite(px_per_second(4, 30))); // what makes sense is answered
    CHECK_THROWS_AS(px_per_second(4, 0), std::invalid_argument);
    CHECK_THROWS_AS(px_per_second(4, -30), std::invalid_argument);

    for (const double bad : outside) {
        CHECK_THROWS_AS(px_per_second(bad, 30), std::invalid_argument);
        CHECK_THROWS_AS(px_per_second(4, bad), std::invalid_argument);
    }
}

// -------------------------------------------------------------------------------------------------- 1.2 uniform_motion

//> Worked example: uniform motion
TEST_CASE("the worked example: at 4 px/frame it is 120 px further after 30 frames", "[1.2]") {
    CHECK_THAT(uniform_motion({200, 80}, {4, 0}, 30), IsNear(Vec2{320, 80}, rounding)); // 200 + 4 · 30
    CHECK_THAT(uniform_motion({0, 0}, {4, 0}, 30), IsNear(Vec2{120, 0}, rounding));
    CHECK_THAT(uniform_motion({200, 80}, {0, -4}, 30), IsNear(Vec2{200, -40}, rounding)); // 80 - 4 · 30
}

//> Both components
TEST_CASE("x and y go their own ways, back in time too", "[1.2]") {
    CHECK_THAT(uniform_motion({1, -2}, {3, 0.5}, 4), IsNear(Vec2{13, 0}, rounding));          // 1 + 12, -2 + 2
    CHECK_THAT(uniform_motion({1, -2}, {3, 0.5}, -4), IsNear(Vec2{-11, -4}, rounding));       // 1 - 12, -2 - 2
    CHECK_THAT(uniform_motion({1, -2}, {-3, 0.5}, 0.5), IsNear(Vec2{-0.5, -1.75}, rounding)); // half a second
    CHECK_THAT(uniform_motion({1, -2}, {3, 0.5}, 0), IsNear(Vec2{1, -2}));
    CHECK_THAT(uniform_motion({1, -2}, {0, 0}, 9), IsNear(Vec2{1, -2}));
}

//>
TEST_CASE("a way that is walked in two parts is the whole way", "[1.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 start = dice.point(-100, 100), velocity = dice.point(-20, 20);
        const double t = dice.real(-10, 10), more = dice.real(-10, 10);

        const Vec2 on_the_way = uniform_motion(start, velocity, t);

        CHECK_THAT(uniform_motion(on_the_way, velocity, more),
                   IsNear(uniform_motion(start, velocity, t + more), rounding));
    }
}

TEST_CASE("between any two instants it moves along its velocity, and by as much as there is time", "[1.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Vec2 direction = dice.direction();
        const double speed = dice.real(0, 50), t = dice.real(-10, 10);
        const Vec2 start = dice.point(-100, 100);

        const Vec2 way = uniform_motion(start, speed * direction, t) - start;

        CHECK_THAT(way.dot(direction), IsNear(speed * t, 1e-11)); // 1e-16 of 600 m, a few times over
        CHECK_THAT(way.x() * direction.y() - way.y() * direction.x(), IsNear(0.0, 1e-11));
    }
}

//> Erratum E1.9
TEST_CASE("erratum E1.9: for 3 miles, 80 miles an hour need more time than 90, not less", "[1.2]") {
    const double at_90 = 3.0 / 90 * 60, at_80 = 3.0 / 80 * 60;                               // in minutes: 2 and 2.25
    CHECK_THAT(uniform_motion({0, 0}, {90.0 / 60, 0}, at_90), IsNear(Vec2{3, 0}, rounding)); // in miles a minute
    CHECK_THAT(uniform_motion({0, 0}, {80.0 / 60, 0}, at_80), IsNear(Vec2{3, 0}, rounding));

    // As printed, the two minutes are to be reduced; but in two minutes it has not even got there.
    CHECK_THAT(uniform_motion({0, 0}, {80.0 / 60, 0}, at_90), IsNear(Vec2{8.0 / 3, 0}, rounding));
}

//>
TEST_CASE("a uniform motion with anything in it that is not a number within ±1e5 is refused", "[1.2]") {
    for (const double bad : outside) {
        CHECK_THROWS_AS(uniform_motion({bad, 2}, {3, 4}, 5), std::invalid_argument);
        CHECK_THROWS_AS(uniform_motion({1, bad}, {3, 4}, 5), std::invalid_argument);
        CHECK_THROWS_AS(uniform_motion({1, 2}, {bad, 4}, 5), std::invalid_argument);
        CHECK_THROWS_AS(uniform_motion({1, 2}, {3, bad}, 5), std::invalid_argument);
        CHECK_THROWS_AS(uniform_motion({1, 2}, {3, 4}, bad), std::invalid_argument);
    }
}

// ---------------------------------------------------------------------------------------------- 1.3 accelerated_motion

//> By hand: thrown up
TEST_CASE("a stone thrown up at 7 m/s where g is 10 m/s² is 2.4 m up after 0.6 s, and rises at 1 m/s", "[1.3]") {
    // on average (7 + 1)/2 = 4 m/s, for 0.6 s; and 3 m/s sideways, 1.8 m, which nothing changes
    CHECK_THAT(accelerated_motion({{1, 0}, {3, 7}}, {0, -10}, 0.6), IsNear(State{{2.8, 2.4}, {3, 1}}, rounding));
    // it falls through the same height at the same speed, 0.2 s later
    CHECK_THAT(accelerated_motion({{1, 0}, {3, 7}}, {0, -10}, 0.8), IsNear(State{{3.4, 2.4}, {3, -1}}, rounding));
    // and was 2 m below, and faster, before
    CHECK_THAT(accelerated_motion({{1, 0}, {3, 7}}, {0, -10}, -0.2), IsNear(State{{0.4, -1.6}, {3, 9}}, rounding));
}

//> Table 13.1
TEST_CASE("Table 13.1: from rest, at 2 m/s², the velocity is 0, 2, 4, 6, 8, 10 m/s", "[1.3]") {
    const std::array<double, 6> velocity{0, 2, 4, 6, 8, 10}; // 2 t
    for (int t = 0; t <= 5; ++t) {
        const State after = accelerated_motion({{0, 0}, {0, 0}}, {2, 0}, t);
        CHECK_THAT(after.velocity, IsNear(Vec2{velocity[std::size_t(t)], 0}, rounding));
    }
}

//> Table 13.2
const std::array<double, 6> table_13_2{50, 55, 62, 71, 82, 95}; // 50 + 4 t + t²

TEST_CASE("Table 13.2: from 50, at 4 and with an acceleration of 2, it is at 50, 55, 62, 71, 82, 95", "[1.3]") {
    for (int t = 0; t <= 5; ++t) {
        const double x = table_13_2[std::size_t(t)], v = 4 + 2.0 * t;
        CHECK_THAT(accelerated_motion({{50, 0}, {4, 0}}, {2, 0}, t), IsNear(State{{x, 0}, {v, 0}}, rounding));
        CHECK_THAT(accelerated_motion({{0, 50}, {0, 4}}, {0, 2}, t),
                   IsNear(State{{0, x}, {0, v}}, rounding)); // upwards
    }
}

//>
TEST_CASE("at t = 0 nothing has changed", "[1.3]") {
    CHECK_THAT(accelerated_motion({{1, -2}, {3, 7}}, {5, -6}, 0), IsNear(State{{1, -2}, {3, 7}}));
}

TEST_CASE("without acceleration it is a uniform motion", "[1.3]") {
    CHECK_THAT(accelerated_motion({{1, -2}, {3, 0.5}}, {0, 0}, 4), IsNear(State{{13, 0}, {3, 0.5}}, rounding));
    CHECK_THAT(accelerated_motion({{1, -2}, {0, 0}}, {0, 0}, 4), IsNear(State{{1, -2}, {0, 0}}, rounding));
}

//> Average and energy
TEST_CASE("it goes as far as at the average of its first and its last velocity", "[1.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double t = dice.real(-10, 10);

        const State after = accelerated_motion(start, acceleration, t);

        const Vec2 way = after.position - start.position;
        CHECK_THAT(after.velocity, IsNear(Vec2{start.velocity + t * acceleration}, rounding));
        CHECK_THAT(way, IsNear(Vec2{(start.velocity + after.velocity) / 2 * t}, 1e-11)); // 1e-16 of 800 m
        // The square of the speed grows by twice acceleration times way: what the energy says.
        const double gained = after.velocity.squaredNorm() - start.velocity.squaredNorm();
        CHECK_THAT(2 * acceleration.dot(way), IsNear(gained, 1e-9)); // 1e-16 of 5e4 m²/s², and what cancels
    }
}

//>
TEST_CASE("two flights, one after the other, are one", "[1.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double t = dice.real(-5, 5), more = dice.real(-5, 5);

        const State on_the_way = accelerated_motion(start, acceleration, t);

        CHECK_THAT(accelerated_motion(on_the_way, acceleration, more),
                   IsNear(accelerated_motion(start, acceleration, t + more), 1e-11));
    }
}

TEST_CASE("turned round, it flies back home", "[1.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double t = dice.real(0, 10);

        const State there = accelerated_motion(start, acceleration, t);
        const State home = accelerated_motion({there.position, -there.velocity}, acceleration, t);

        CHECK_THAT(home, IsNear(State{start.position, -start.velocity}, 1e-11));
    }
}

//> Erratum E1.5
TEST_CASE("erratum E1.5: 2 is Table 13.1's acceleration; a constant velocity of 2 m/s makes another table", "[1.3]") {
    for (int t = 1; t <= 5; ++t) {
        // As printed, "a constant velocity of 2": 2, 2, 2, 2, 2 m/s, and places 2, 4, 6, 8, 10 m.
        CHECK_THAT(accelerated_motion({{0, 0}, {2, 0}}, {0, 0}, t), IsNear(State{{2.0 * t, 0}, {2, 0}}, rounding));
        // Printed are the velocities 2, 4, 6, 8, 10 m/s: the acceleration is 2, as the table's title says.
        CHECK_THAT(accelerated_motion({{0, 0}, {0, 0}}, {2, 0}, t),
                   IsNear(State{{1.0 * t * t, 0}, {2.0 * t, 0}}, rounding));
    }
}

//> Erratum E1.6
TEST_CASE("erratum E1.6: in Table 13.2 the changes are 5, 7, 9, 11, 13; it is their change that is always 2", "[1.3]") {
    const auto x = [](int t) { return accelerated_motion({{50, 0}, {4, 0}}, {2, 0}, t).position.x(); };
    const std::array<double, 5> change{5, 7, 9, 11, 13};
    for (int t = 1; t <= 5; ++t) CHECK_THAT(x(t) - x(t - 1), IsNear(change[std::size_t(t - 1)], rounding));
    for (int t = 1; t <= 4; ++t) CHECK_THAT((x(t + 1) - x(t)) - (x(t) - x(t - 1)), IsNear(2.0, rounding));
}

//> Erratum E1.8
TEST_CASE("erratum E1.8: an acceleration of 2 is 2 px/frame², and 1800 px/s² at 30 frames a second", "[1.3]") {
    const State in_frames = accelerated_motion({{0, 0}, {0, 0}}, {2, 0}, 30); // t in frames: a second
    CHECK_THAT(in_frames.position, IsNear(Vec2{900, 0}, rounding));

    const State in_seconds = accelerated_motion({{0, 0}, {0, 0}}, {2 * 30 * 30, 0}, 1);
    CHECK_THAT(in_seconds.position, IsNear(Vec2{900, 0}, rounding));
    // Were it px/frame, as the comment has it, it would count thirtyfold, and it would creep.
    CHECK_THAT(accelerated_motion({{0, 0}, {0, 0}}, {2 * 30, 0}, 1).position, IsNear(Vec2{30, 0}, rounding));
}

//> Erratum E1.11
TEST_CASE("erratum E1.11: all of the velocity makes the way, not only the gained part", "[1.3]") {
    // The strip below v = 4 + 2 t, from 0 to 3: a rectangle of 4 · 3 and a triangle of 6 · 3 / 2.
    const State after = accelerated_motion({{50, 0}, {4, 0}}, {2, 0}, 3);
    CHECK_THAT(after.position.x() - 50, IsNear(12.0 + 9, rounding)); // the printed "integral of the velocity" is 9

    const State from_rest = accelerated_motion({{50, 0}, {0, 0}}, {2, 0}, 3);
    CHECK_THAT(from_rest.position.x() - 50, IsNear(9.0, rounding)); // true only of what starts from rest
}

//>
TEST_CASE("an accelerated motion with anything in it that is not a number within ±1e5 is refused", "[1.3]") {
    for (const double bad : outside) {
        CHECK_THROWS_AS(accelerated_motion({{bad, 2}, {3, 4}}, {5, 6}, 7), std::invalid_argument);
        CHECK_THROWS_AS(accelerated_motion({{1, bad}, {3, 4}}, {5, 6}, 7), std::invalid_argument);
        CHECK_THROWS_AS(accelerated_motion({{1, 2}, {bad, 4}}, {5, 6}, 7), std::invalid_argument);
        CHECK_THROWS_AS(accelerated_motion({{1, 2}, {3, bad}}, {5, 6}, 7), std::invalid_argument);
        CHECK_THROWS_AS(accelerated_motion({{1, 2}, {3, 4}}, {bad, 6}, 7), std::invalid_argument);
        CHECK_THROWS_AS(accelerated_motion({{1, 2}, {3, 4}}, {5, bad}, 7), std::invalid_argument);
        CHECK_THROWS_AS(accelerated_motion({{1, 2}, {3, 4}}, {5, 6}, bad), std::invalid_argument);
    }
}

// -------------------------------------------------------------------------------------------------- 1.4 centre_of_mass

const std::optional<Vec2> no_centre;

namespace {

std::vector<PointMass> random_bodies(Dice &dice, int count) {
    std::vector<PointMass> bodies;
    for (int i = 0; i < count; ++i) bodies.push_back({dice.point(-50, 50), dice.real(0.1, 10)});
    return bodies;
}

} // namespace

//> Worked example: centre of mass
const std::vector<PointMass> three{{{0, 0}, 1}, {{4, 0}, 1}, {{0, 3}, 2}};

TEST_CASE("the worked example: 1 kg at (0, 0), 1 kg at (4, 0), 2 kg at (0, 3) balance at (1, 1.5)", "[1.4]") {
    // x: (1 · 0 + 1 · 4 + 2 · 0) / 4 = 1;  y: (1 · 0 + 1 · 0 + 2 · 3) / 4 = 1.5
    CHECK_THAT(centre_of_mass(three), IsNear(Vec2{1, 1.5}, rounding));
}

//> A seesaw
TEST_CASE("the heavier of two is nearer to where they balance", "[1.4]") {
    CHECK_THAT(centre_of_mass({{{2, 7}, 3}, {{6, -1}, 3}}), IsNear(Vec2{4, 3}, rounding)); // equal: the middle
    CHECK_THAT(centre_of_mass({{{2, 7}, 9}, {{6, -1}, 3}}), IsNear(Vec2{3, 5}, rounding)); // 1 : 3, so a quarter
    CHECK_THAT(centre_of_mass({{{2, 7}, 3}, {{6, -1}, 9}}), IsNear(Vec2{5, 1}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 0}, {{6, -1}, 9}}), IsNear(Vec2{6, -1}, rounding)); // nothing at (2, 7)
}

//> No mass, no centre
TEST_CASE("where there is no mass there is no centre; a little mass is enough", "[1.4]") {
    CHECK_THAT(centre_of_mass({}), IsNear(no_centre));
    CHECK_THAT(centre_of_mass({{{2, 7}, 0}}), IsNear(no_centre));
    CHECK_THAT(centre_of_mass({{{2, 7}, 0}, {{6, -1}, 0}}), IsNear(no_centre));
    CHECK_THAT(centre_of_mass({{{2, 7}, 1e-9}, {{6, -1}, 3e-9}}), IsNear(Vec2{5, 1}, rounding));
    CHECK_THAT(centre_of_mass({{{2, 7}, 1e-100}, {{6, -1}, 3e-100}}), IsNear(Vec2{5, 1}, rounding));
}

//>
TEST_CASE("one body alone is its own centre of mass", "[1.4]") {
    CHECK_THAT(centre_of_mass({{{2, 7}, 0.25}}), IsNear(Vec2{2, 7}, rounding));
    CHECK_THAT(centre_of_mass({{{-6, -1}, 1e4}}), IsNear(Vec2{-6, -1}, rounding));
}

//> It balances
TEST_CASE("about the centre of mass, all arms times masses balance, left and right, above and below", "[1.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto bodies = random_bodies(dice, dice.whole(1, 9));

        const auto centre = centre_of_mass(bodies);

        CHECK(centre.has_value());
        Vec2 balance{0, 0}; // [m kg]
        for (const PointMass &body : bodies) balance += body.mass * (body.position - *centre);
        CHECK_THAT(balance, IsNear(Vec2{0, 0}, 1e-10)); // nine times 1e-16 of 500 m kg, and room
    }
}

//>
TEST_CASE("several bodies may be replaced by one in their centre that has all their mass", "[1.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto group = random_bodies(dice, dice.whole(1, 4)), others = random_bodies(dice, dice.whole(0, 4));
        double mass = 0;
        for (const PointMass &body : group) mass += body.mass;
        auto all = others, few = others;
        all.insert(all.begin() + dice.whole(0, int(others.size())), group.begin(), group.end());

        const auto centre = centre_of_mass(group);
        CHECK(centre.has_value());
        few.push_back({*centre, mass});

        const auto of_all = centre_of_mass(all);
        CHECK(of_all.has_value());
        CHECK_THAT(centre_of_mass(few), IsNear(*of_all, 1e-11));
    }
}

TEST_CASE("whatever the order and the unit of the masses, the centre is the same; moved bodies take it along",
          "[1.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto bodies = random_bodies(dice, dice.whole(1, 9));
        const Vec2 by = dice.point(-100, 100);
        const double unit = dice.real(0.01, 100);
        auto others = bodies;
        for (PointMass &body : others) body.mass *= unit, body.position += by;
        std::reverse(others.begin(), others.end());
        std::rotate(others.begin(), others.begin() + dice.whole(0, int(others.size()) - 1), others.end());

        const auto centre = centre_of_mass(bodies);

        CHECK(centre.has_value());
        CHECK_THAT(centre_of_mass(others), IsNear(Vec2{*centre + by}, 1e-11));
    }
}

//> Erratum E1.1
TEST_CASE("erratum E1.1: three bodies are three terms; the printed sum has a fourth", "[1.4]") {
    // From i = 0 to n there are n + 1. Whatever stands behind the list is weighed too: say, 4 kg at (9, 9).
    std::vector<PointMass> four = three;
    four.push_back({{9, 9}, 4});
    CHECK_THAT(centre_of_mass(four), IsNear(Vec2{5, 5.25}, rounding)); // (4 + 36)/8, (6 + 36)/8

    CHECK_THAT(centre_of_mass(three), IsNear(Vec2{1, 1.5}, rounding));
}

//>
TEST_CASE("a negative mass, and what is not a number within ±1e5, is refused, wherever it stands", "[1.4]") {
    for (const std::size_t which : {0u, 1u, 2u}) {
        for (const double bad : outside) {
            auto bodies = three;
            bodies[which].position.x() = bad;
            CHECK_THROWS_AS(centre_of_mass(bodies), std::invalid_argument);
            bodies = three;
            bodies[which].position.y() = bad;
            CHECK_THROWS_AS(centre_of_mass(bodies), std::invalid_argument);
            bodies = three;
            bodies[which].mass = bad;
            CHECK_THROWS_AS(centre_of_mass(bodies), std::invalid_argument);
        }
        auto bodies = three;
        bodies[which].mass = -0.5; // the others weigh more
        CHECK_THROWS_AS(centre_of_mass(bodies), std::invalid_argument);
    }
    CHECK_THROWS_AS(centre_of_mass({{{1, 2}, 3}, {{4, 5}, -3}}), std::invalid_argument); // and not "nothing"
}

// ------------------------------------------------------------------------------------------------------------ 1.5 step

namespace {

Schemes all_at(const State &state) { return {state, state, state}; }

} // namespace

//> Side by side
TEST_CASE("Table 13.2 in steps of 1: the one Euler stays behind, the other runs ahead, exact is exact", "[1.5]") {
    const std::array<double, 5> slow{54, 60, 68, 78, 90}, fast{56, 64, 74, 86, 100}, exact{55, 62, 71, 82, 95};
    Schemes now = all_at({{50, 0}, {4, 0}});
    for (std::size_t n = 0; n < 5; ++n) {
        now = step(now, {2, 0}, 1);
        const Vec2 velocity{6 + 2.0 * double(n), 0}; // in all three
        CHECK_THAT(now.explicit_euler,
                   IsNear(State{{slow[n], 0}, velocity}, rounding)); // the old velocity: 4, 6, 8, ...
        CHECK_THAT(now.semi_implicit, IsNear(State{{fast[n], 0}, velocity}, rounding)); // the new one: 6, 8, 10, ...
        CHECK_THAT(now.exact, IsNear(State{{exact[n], 0}, velocity}, rounding));        // half way: 5, 7, 9, ...
    }
}

//> Own ways
TEST_CASE("one step of 0.5 s, from three different states", "[1.5]") {
    const Schemes before{{{1, 2}, {3, -4}}, {{-5, 6}, {-7, 8}}, {{9, -1}, {2, 5}}};
    const Schemes after = step(before, {10, -6}, 0.5);                            // each gains (5, -3) m/s
    CHECK_THAT(after.explicit_euler, IsNear(State{{2.5, 0}, {8, -7}}, rounding)); // moves at (3, -4)
    CHECK_THAT(after.semi_implicit, IsNear(State{{-6, 8.5}, {-2, 5}}, rounding)); // at (-2, 5)
    CHECK_THAT(after.exact, IsNear(State{{11.25, 0.75}, {7, 2}}, rounding));      // at (4.5, 3.5)
}

//> Errors
TEST_CASE("after n steps the Eulers are off by n a dt²/2, to either side; halving dt halves that", "[1.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const State start{dice.point(-50, 50), dice.point(-20, 20)};
        const Vec2 acceleration = dice.point(-10, 10);
        const double time = dice.real(0.1, 5); // [s]
        const Vec2 truth = start.position + time * start.velocity + time * time / 2 * acceleration;
        const int steps = dice.whole(1, 20);
        for (const int n : {steps, 2 * steps}) {
            const double dt = time / n;
            Schemes now = all_at(start);
            for (int k = 0; k < n; ++k) now = step(now, acceleration, dt);

            const Vec2 error = n * dt * dt / 2 * acceleration; // = time dt/2 · a: half the step, half the error
            CHECK_THAT(now.explicit_euler.position, IsNear(Vec2{truth - error}, 1e-11)); // 40 roundings of 250 m
            CHECK_THAT(now.semi_implicit.position, IsNear(Vec2{truth + error}, 1e-11));
            CHECK_THAT(now.exact.position, IsNear(truth, 1e-11));
            CHECK_THAT(now.explicit_euler.velocity, IsNear(Vec2{start.velocity + time * acceleration}, 1e-11));
            CHECK_THAT(now.semi_implicit.velocity, IsNear(Vec2{start.velocity + time * acceleration}, 1e-11));
            CHECK_THAT(now.exact.velocity, IsNear(Vec2{start.velocity + time * acceleration}, 1e-11));
        }
    }
}

//> Slopes
TEST_CASE("on log-log axes the errors of the Eulers have the slope 1; that of the exact step is rounding", "[1.5]") {
    const auto errors = [](int n) { // after 5 s in n steps, from (0, 0) at (3, 7) m/s, under (0, -9.8) m/s²
        Schemes now = all_at({{0, 0}, {3, 7}});
        for (int k = 0; k < n; ++k) now = step(now, {0, -9.8}, 5.0 / n);
        const Vec2 truth{15, 35 - 122.5};
        return std::array{(now.explicit_euler.position - truth).norm(), (now.semi_implicit.position - truth).norm(),
                          (now.exact.position - truth).norm()};
    };
    const auto coarse = errors(7), fine = errors(700); // a hundredth of the step
    for (const std::size_t euler : {0u, 1u}) CHECK_THAT(std::log10(coarse[euler] / fine[euler]) / 2, IsNear(1.0, 1e-6));
    CHECK(coarse[2] < 1e-12); // 7 roundings of 100 m
    CHECK(fine[2] < 1e-10);   // 700 of them, which may all go one way
}

//>
TEST_CASE("two exact steps are one of double length; of no other scheme that is so", "[1.5]") {
    const Schemes start = all_at({{1, 2}, {3, -4}});
    const Schemes two = step(step(start, {10, -6}, 0.5), {10, -6}, 0.5), one = step(start, {10, -6}, 1);
    CHECK_THAT(two.exact, IsNear(one.exact, rounding));
    // half the error, and the errors of the one step are a/2
    CHECK_THAT(Vec2{two.explicit_euler.position - one.explicit_euler.position}, IsNear(Vec2{2.5, -1.5}, rounding));
    CHECK_THAT(Vec2{two.semi_implicit.position - one.semi_implicit.position}, IsNear(Vec2{-2.5, 1.5}, rounding));
}

TEST_CASE("without acceleration all three agree, and a step of 0 changes nothing", "[1.5]") {
    const State start{{1, 2}, {3, -4}}, later{{2.5, 0}, {3, -4}};
    CHECK_THAT(step(all_at(start), {0, 0}, 0.5), IsNear(all_at(later), rounding));

    const Schemes before{{{1, 2}, {3, -4}}, {{-5, 6}, {-7, 8}}, {{9, -1}, {2, 5}}};
    CHECK_THAT(step(before, {10, -6}, 0), IsNear(before));
}

//> Erratum E1.7
TEST_CASE("erratum E1.7: the printed loop is off by n a/2 px; half an acceleration less at the start mends it",
          "[1.5]") {
    // velocity += acceleration, then x += velocity: that is the semi-implicit Euler with dt = 1 frame.
    Schemes printed = all_at({{50, 0}, {4, 0}});
    State mended{{50, 0}, {4 - 2.0 / 2, 0}};
    for (int n = 1; n <= 5; ++n) {
        printed = step(printed, {2, 0}, 1);
        CHECK_THAT(printed.semi_implicit.position.x(), IsNear(table_13_2[std::size_t(n)] + n * 2.0 / 2, rounding));

        mended = step(all_at(mended), {2, 0}, 1).semi_implicit;
        CHECK_THAT(mended.position.x(), IsNear(table_13_2[std::size_t(n)], rounding));
    }
}

//>
TEST_CASE("the code as printed starts from rest: 2, 6, 12, 20, 30, where 1, 4, 9, 16, 25 is true", "[1.5]") {
    Schemes now = all_at({{0, 0}, {0, 0}});
    for (int n = 1; n <= 5; ++n) {
        now = step(now, {0, 2}, 1);
        CHECK_THAT(now.explicit_euler, IsNear(State{{0, double(n * (n - 1))}, {0, 2.0 * n}}, rounding));
        CHECK_THAT(now.semi_implicit, IsNear(State{{0, double(n * (n + 1))}, {0, 2.0 * n}}, rounding));
        CHECK_THAT(now.exact, IsNear(State{{0, double(n * n)}, {0, 2.0 * n}}, rounding));
    }
}

TEST_CASE("a step back in time, and what is not a number within ±1e5, is refused", "[1.5]") {
    const Schemes good = all_at({{1, 2}, {3, 4}});
    CHECK_THROWS_AS(step(good, {5, 6}, -0.1), std::invalid_argument);

    for (const double bad : outside) {
        CHECK_THROWS_AS(step(good, {bad, 6}, 0.1), std::invalid_argument);
        CHECK_THROWS_AS(step(good, {5, bad}, 0.1), std::invalid_argument);
        CHECK_THROWS_AS(step(good, {5, 6}, bad), std::invalid_argument);
        for (State Schemes::*const scheme : {&Schemes::explicit_euler, &Schemes::semi_implicit, &Schemes::exact})
            for (const int axis : {0, 1}) {
                Schemes spoilt = good;
                (spoilt.*scheme).position[axis] = bad;
                CHECK_THROWS_AS(step(spoilt, {5, 6}, 0.1), std::invalid_argument);
                spoilt = good;
                (spoilt.*scheme).velocity[axis] = bad;
                CHECK_THROWS_AS(step(spoilt, {5, 6}, 0.1), std::invalid_argument);
            }
    }
}

// -------------------------------------------------------------------------------------------------------- 1.6 centroid

using Corners = std::vector<Vec2>;

//> An L
TEST_CASE("the worked example: an L made of 3 m² about (0.5, 1.5) and 2 m² about (2, 0.5) has its middle at (1.1, 1.1)",
          "[1.6]") {
    // x: (3 · 0.5 + 2 · 2) / 5 = 1.1;  y: (3 · 1.5 + 2 · 0.5) / 5 = 1.1
    const Corners l{{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}};
    CHECK_THAT(centroid(l), IsNear(Vec2{1.1, 1.1}, rounding));
    CHECK_THAT(centroid({l.rbegin(), l.rend()}), IsNear(Vec2{1.1, 1.1}, rounding)); // the other way round
}

//> Simple plates
TEST_CASE("a triangle's middle is the mean of its corners, a rectangle's is where its diagonals cross", "[1.6]") {
    CHECK_THAT(centroid({{0, 0}, {6, 0}, {0, 3}}), IsNear(Vec2{2, 1}, rounding));
    CHECK_THAT(centroid({{0, 0}, {0, 3}, {6, 0}}), IsNear(Vec2{2, 1}, rounding));
    CHECK_THAT(centroid({{7, -4}, {9, -1}, {-1, 2}}), IsNear(Vec2{5, -1}, rounding));
    CHECK_THAT(centroid({{1, 2}, {5, 2}, {5, 4}, {1, 4}}), IsNear(Vec2{3, 3}, rounding));
    CHECK_THAT(centroid({{-1, -2}, {-5, -2}, {-5, -4}, {-1, -4}}), IsNear(Vec2{-3, -3}, rounding));
}

//> Erratum E1.3
TEST_CASE("erratum E1.3: a corner more on a side moves the mean of the corners, but not the plate's middle", "[1.6]") {
    const Vec2 mean = (Vec2{0, 0} + Vec2{1, 0} + Vec2{2, 0} + Vec2{2, 2} + Vec2{0, 2}) / 5;
    CHECK_THAT(mean, IsNear(Vec2{1, 0.8}, rounding)); // as printed: weights at the corners

    CHECK_THAT(centroid({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}), IsNear(Vec2{1, 1}, rounding));
    CHECK_THAT(centroid({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), IsNear(Vec2{1, 1}, rounding));
}

//>
namespace {

/// A plate that somebody at (0, 0) sees all of: its corners by growing angle. With its middle, from slices round (0, 0).
struct Plate {
    Corners corners;
    Vec2 middle;
};

Plate random_plate(Dice &dice) {
    const int count = dice.whole(3, 12);
    Plate plate{{}, {0, 0}};
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + dice.real(-0.1, 0.1)) / count;
        plate.corners.push_back(dice.real(1, 5) * Vec2{std::cos(angle), std::sin(angle)});
    }
    double area = 0;
    for (std::size_t i = 0; i < plate.corners.size(); ++i) {
        const Vec2 &p = plate.corners[i], &q = plate.corners[(i + 1) % plate.corners.size()];
        const double slice = p.norm() * q.norm() * std::sin(std::acos(p.dot(q) / p.norm() / q.norm())) / 2;
        area += slice;
        plate.middle += slice * (p + q) / 3;
    }
    plate.middle /= area;
    return plate;
}

} // namespace

TEST_CASE("a jagged plate: the middle of its slices, from whichever corner and whichever way round it is told",
          "[1.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const auto [corners, middle] = random_plate(dice);
        const Vec2 by = dice.point(-100, 100);
        Corners other = corners;
        for (Vec2 &corner : other) corner += by;
        std::rotate(other.begin(), other.begin() + dice.whole(0, int(other.size()) - 1), other.end());
        if (dice.whole(0, 1) == 1) std::reverse(other.begin(), other.end());

        // The arc cosine of the slices is worth some 1e-14; coordinates near 100, squared, cost other formulas more.
        CHECK_THAT(centroid(other), IsNear(Vec2{middle + by}, 1e-9));
    }
}

TEST_CASE("cut in two, a plate balances as its halves do, each with its area for a mass", "[1.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        // a triangle, cut from one corner to somewhere on the opposite side: the areas are as the parts of that side
        const Vec2 top = dice.point(-10, 10), left = dice.point(-10, 10), right = dice.point(-10, 10);
        const Vec2 a = left - top, b = right - top;
        if (std::abs(a.x() * b.y() - a.y() * b.x()) < 1) continue; // thin: another test
        const double share = dice.real(0.1, 0.9);
        const Vec2 foot = left + share * (right - left);

        const Vec2 of_left = centroid({top, left, foot}), of_right = centroid({foot, right, top});

        CHECK_THAT(centroid({top, left, right}), IsNear(Vec2{share * of_left + (1 - share) * of_right}, 1e-10));
    }
}

TEST_CASE("far away a plate has its middle as well, small, large or thin", "[1.6]") {
    const Vec2 far{87654.321, -98765.432};
    CHECK_THAT(Vec2{centroid({far, far + Vec2{1, 0}, far + Vec2{1, 1}, far + Vec2{0, 1}}) - far},
               IsNear(Vec2{0.5, 0.5}, 1e-9));
    CHECK_THAT(centroid({{-1e5, -1e5}, {1e5, -1e5}, {1e5, 1e5}, {-1e5, 1e5}}), IsNear(Vec2{0, 0}, 1e-9));
    CHECK_THAT(centroid({{0, 0}, {1e-3, 0}, {1e-3, 1e-3}, {0, 1e-3}}), IsNear(Vec2{5e-4, 5e-4}, 1e-12));
    CHECK_THAT(centroid({{0, 0}, {4, 0}, {4, 1e-6}, {0, 1e-6}}), IsNear(Vec2{2, 5e-7}, 1e-9)); // 2.5e-7 of its length²
    // 2.5e-10 of its length², where a rounding of 1e-16 may count as 4e-7
    CHECK_THAT(centroid({{0, 0}, {4, 0}, {4, 1e-9}, {0, 1e-9}}), IsNear(Vec2{2, 5e-10}, 1e-5));
}

TEST_CASE("fewer than three corners, and corners on one line, are no plate", "[1.6]") {
    CHECK_THROWS_AS(centroid({}), std::invalid_argument);
    CHECK_THROWS_AS(centroid({{1, 2}}), std::invalid_argument);
    CHECK_THROWS_AS(centroid({{1, 2}, {3, 4}}), std::invalid_argument);
    CHECK_THROWS_AS(centroid({{1, 2}, {1, 2}, {1, 2}}), std::invalid_argument);
    CHECK_THROWS_AS(centroid({{0, 0}, {2, 1}, {6, 3}}), std::invalid_argument);
    CHECK_THROWS_AS(centroid({{0, 0}, {6, 3}, {2, 1}, {4, 2}}), std::invalid_argument); // to and fro
    CHECK_THROWS_AS(centroid({{5, 0}, {5, 3}, {5, -2}}), std::invalid_argument);
    CHECK_THROWS_AS(centroid({{0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}}), std::invalid_argument); // but for a rounding
    CHECK_THROWS_AS(centroid({{1e5, 0}, {-1e5, 0}, {0, 1e-9}}), std::invalid_argument);     // 2.5e-15 of its length²
}

TEST_CASE("a corner that is not a number within ±1e5 is refused, wherever it stands", "[1.6]") {
    for (const double bad : outside)
        for (const std::size_t which : {0u, 1u, 2u, 3u})
            for (const int axis : {0, 1}) {
                Corners corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
                corners[which][axis] = bad;
                CHECK_THROWS_AS(centroid(corners), std::invalid_argument);
            }
}

// --------------------------------------------------------------------------------------------------- 1.7 law_of_motion

//> By hand: three looks
TEST_CASE("the worked example: at 6, 11 and 27 m after 1, 2 and 4 s, it began at 3 m, at 2 m/s, with 2 m/s²", "[1.7]") {
    // 5 m/s on average from 1 to 2 s, so 5 m/s at 1.5 s; 8 m/s on average from 2 to 4 s, so 8 m/s at 3 s
    // a = (8 - 5) / (3 - 1.5) = 2 m/s²; v_0 = 5 - 2 · 1.5 = 2 m/s; x_0 = 6 - 2 · 1 - 2/2 · 1² = 3 m
    CHECK_THAT(law_of_motion({1, 6}, {2, 11}, {4, 27}), IsNear(Law{3, 2, 2}, rounding));
}

//> Three rows of a table
TEST_CASE("any three rows of Table 13.2, in any order, tell that it began at 50, at 4, with 2", "[1.7]") {
    const auto row = [&](int t) { return Sample{double(t), table_13_2[std::size_t(t)]}; };
    for (int i = 0; i <= 5; ++i)
        for (int j = 0; j <= 5; ++j)
            for (int k = 0; k <= 5; ++k)
                if (i != j && j != k && k != i)
                    CHECK_THAT(law_of_motion(row(i), row(j), row(k)), IsNear(Law{50, 4, 2}, rounding));
}

//> Made backwards
TEST_CASE("a law that was chosen first comes back from any three looks at it", "[1.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const Law law{dice.real(-100, 100), dice.real(-20, 20), dice.real(-10, 10)};
        const auto look = [&](double t) { return Sample{t, law.x_0 + t * (law.v_0 + t * law.a / 2)}; };
        const double t_1 = dice.real(-10, 10), t_2 = dice.real(-10, 10), t_3 = dice.real(-10, 10);
        if (std::min({std::abs(t_1 - t_2), std::abs(t_2 - t_3), std::abs(t_3 - t_1)}) < 0.5) continue;

        // A look is off by 1e-13 m, of 800; divided by two gaps of 0.5 s and seen from 10 s away: 1e-10, and room.
        CHECK_THAT(law_of_motion(look(t_1), look(t_2), look(t_3)), IsNear(law, 1e-8));
    }
}

//>
TEST_CASE("what rests has no velocity; what moves uniformly, no acceleration; and what turns round at t = 0 rests then",
          "[1.7]") {
    CHECK_THAT(law_of_motion({1, -4}, {2, -4}, {4, -4}), IsNear(Law{-4, 0, 0}, rounding));
    CHECK_THAT(law_of_motion({-1, 9}, {2, 3}, {4, -1}), IsNear(Law{7, -2, 0}, rounding));
    CHECK_THAT(law_of_motion({0, 5}, {0.5, 4}, {-2, -11}), IsNear(Law{5, 0, -8}, rounding));
}

TEST_CASE("from a second in the middle of its motion: hundredths apart", "[1.7]") {
    // x = 5 - 3 t + 4 t²; a rounding of 1e-15 m, by two gaps of 0.01 s
    CHECK_THAT(law_of_motion({0.50, 4.5}, {0.51, 4.5104}, {0.53, 4.5336}), IsNear(Law{5, -3, 8}, 1e-8));
}

TEST_CASE("two looks at one instant are refused, whichever two, and even if they agree", "[1.7]") {
    const Sample one{1, 6}, two{2, 11}, four{4, 27};
    for (const Sample &again : {Sample{1, 6}, Sample{1, 7}}) {
        CHECK_THROWS_AS(law_of_motion(one, again, four), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion(one, two, again), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion(two, one, again), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion(one, again, one), std::invalid_argument);
    }
}

TEST_CASE("a look at what is not a number within ±1e5, or at such a time, is refused", "[1.7]") {
    for (const double bad : outside) {
        CHECK_THROWS_AS(law_of_motion({bad, 6}, {2, 11}, {4, 27}), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion({1, bad}, {2, 11}, {4, 27}), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion({1, 6}, {bad, 11}, {4, 27}), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion({1, 6}, {2, bad}, {4, 27}), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion({1, 6}, {2, 11}, {bad, 27}), std::invalid_argument);
        CHECK_THROWS_AS(law_of_motion({1, 6}, {2, 11}, {4, bad}), std::invalid_argument);
    }
}
