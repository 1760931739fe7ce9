#include "section_test.hpp"

#include "momentum.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using momentum::Body, momentum::Cart, momentum::CentreOfMassFrame, momentum::Velocities;
using namespace momentum::subject; // acceleration_due_to, elastic_collision, ... newtons_cradle: the student's

namespace {

// An answer is right to twelve digits of the largest velocity that it's made of, or of the sizes of all forces added up
// (of a thousand at most), unless the header says otherwise. After a collision, one digit fewer may be right for each
// factor of ten by which one mass is larger than the other; with masses below 1e-9 kg any answer may be right to fewer.
// An impulse is right to its first twelve digits when each inverse mass is 0, or 1e-9 per kg or more. A row of carts is
// right to ten digits of the largest velocity for up to ten carts with masses from 0.1 to 10 kg, and for up to a
// hundred of equal mass; other rows may be right to fewer, and with a very light cart between heavy ones one may take
// hours.

double momentum_of(const Cart &a, const Cart &b, const Velocities &v) { return a.mass * v.a + b.mass * v.b; } // [N s]
double energy_of(const Cart &a, const Cart &b, const Velocities &v) {                                         // [J]
    return (a.mass * v.a * v.a + b.mass * v.b * v.b) / 2;
}

/// A cart of 0.1 to 10 kg at up to 10 m/s, either way.
Cart random_cart(Dice &dice) { return {dice.real(0.1, 10), dice.real(-10, 10)}; }

/// Two of them that approach each other.
std::pair<Cart, Cart> random_pair(Dice &dice) {
    Cart a = random_cart(dice), b = random_cart(dice);
    if (a.velocity < b.velocity) std::swap(a.velocity, b.velocity);
    return {a, b};
}

} // namespace

// --------------------------------------------------------------------------------------------- 2.1 acceleration_due_to

//> Worked example: four forces
TEST_CASE("rope, string, weight and rail together: 4 N to the right accelerate 2 kg by 2 m/s²", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{6, 4}, {-2, 1}, {0, -20}, {0, 15}}, 2),
               IsNear(Vec2{2, 0}, rounding)
                   .since("to the right 6 - 2 = 4 N, up 4 + 1 - 20 + 15 = 0 N, and 4 N / 2 kg = 2 m/s²"));
}

//> One newton, one kilogram
TEST_CASE("1 N accelerates 1 kg by 1 m/s², in the direction in which it pulls", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{1, 0}}, 1), IsNear(Vec2{1, 0}, rounding));
    CHECK_THAT(acceleration_due_to({{0, -1}}, 1), IsNear(Vec2{0, -1}, rounding));
    CHECK_THAT(acceleration_due_to({{3, -4}}, 1), IsNear(Vec2{3, -4}, rounding));
}

//>
TEST_CASE("without forces there is no acceleration, whatever the mass", "[2.1]") {
    CHECK_THAT(acceleration_due_to({}, 1), IsNear(Vec2{0, 0}));
    CHECK_THAT(acceleration_due_to({}, 250), IsNear(Vec2{0, 0}));
    CHECK_THAT(acceleration_due_to({{0, 0}, {0, 0}}, 3), IsNear(Vec2{0, 0}));
    acceleration_due_to({{6, -3}}, 1);
    CHECK_THAT(acceleration_due_to({}, 1), IsNear(Vec2{0, 0})); // and nothing is left of those before
}

TEST_CASE("two opposite forces of the same strength cancel; with a third, that one is left", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{7, -2}, {-7, 2}}, 3), IsNear(Vec2{0, 0}, rounding));
    CHECK_THAT(acceleration_due_to({{7, -2}, {0, 5}, {-7, 2}}, 1), IsNear(Vec2{0, 5}, rounding));
    CHECK_THAT(acceleration_due_to({{7, -2}, {0, 0}, {-7, 2}, {0, 5}}, 1), IsNear(Vec2{0, 5}, rounding));
}

TEST_CASE("the order of the forces makes no difference, nor does cutting one of them into parts", "[2.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        std::vector<Vec2> forces;
        for (int k = dice.whole(1, 8); k > 0; --k) forces.push_back(dice.point(-50, 50));
        const Vec2 acceleration = acceleration_due_to(forces, 1);

        std::vector<Vec2> others(forces.rbegin(), forces.rend());
        others.push_back(0.25 * others.front());
        others.front() *= 0.75;

        CHECK_THAT(acceleration_due_to(others, 1), IsNear(acceleration, 1e-10)); // twelve digits of 8 · 70 N
    }
}

//> Twice the mass
TEST_CASE("twice the mass is accelerated half as much, and a tenth of it ten times as much", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{6, -3}}, 1), IsNear(Vec2{6, -3}, rounding));
    CHECK_THAT(acceleration_due_to({{6, -3}}, 2), IsNear(Vec2{3, -1.5}, rounding));
    CHECK_THAT(acceleration_due_to({{6, -3}}, 0.1), IsNear(Vec2{60, -30}, rounding));
}

//> Falling
TEST_CASE("a weight of 9.8 N per kg accelerates a feather and a hammer alike, by 9.8 m/s² downwards", "[2.1]") {
    for (const double mass : {0.03, 1.32, 500.0})
        CHECK_THAT(acceleration_due_to({{0, -9.8 * mass}}, mass), IsNear(Vec2{0, -9.8}, rounding));
}

//> A rocket
TEST_CASE("the velocity gained in a second, times the mass, is the net force", "[2.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const double mass = dice.real(0.1, 100);
        const Vec2 first = dice.point(-50, 50), second = dice.point(-50, 50), third = dice.point(-50, 50);

        const Vec2 gained = acceleration_due_to({first, second, third}, mass); // in one second [m/s]

        const Vec2 net{first.x() + second.x() + third.x(), first.y() + second.y() + third.y()};
        CHECK_THAT(Vec2{mass * gained}, IsNear(net, 1e-10).of("mass times acceleration [N]"));
    }
}

//> Erratum E2.1
TEST_CASE("erratum E2.1: a mass on a table is not accelerated by 9.8 m/s²; the table holds it", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{0, -9.8}, {0, 9.8}}, 1), IsNear(Vec2{0, 0}, rounding)); // weight and table
    CHECK_THAT(acceleration_due_to({{0, -9.8}}, 1), IsNear(Vec2{0, -9.8}, rounding));        // when the table is gone
}

//> Erratum E2.2
TEST_CASE("erratum E2.2: numbers for the figure that has none: (3, 4), (-1, 2) and (0, -9.8) N on 1 kg", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{3, 4}, {-1, 2}, {0, -9.8}}, 1), IsNear(Vec2{2, -3.8}, rounding));
}

//>
TEST_CASE("forces up to ±1e5, a thousand of them, and masses from 1e-9 to 1e5 kg are allowed", "[2.1]") {
    CHECK_THAT(acceleration_due_to({{1e5, -1e5}}, 1e5), IsNear(Vec2{1, -1}, rounding));
    CHECK_THAT(acceleration_due_to({{1e5, -1e5}}, 1e-9), IsNear(Vec2{1e14, -1e14}, rounding));
    CHECK_THAT(acceleration_due_to({{1e-9, 0}}, 1e-9), IsNear(Vec2{1, 0}, rounding));
    CHECK_THAT(acceleration_due_to({{1e-100, 0}}, 1e-100), IsNear(Vec2{1, 0}, rounding));
    CHECK_THAT(Vec2{1e14 * acceleration_due_to({{1e-9, 0}}, 1e5)},
               IsNear(Vec2{1, 0}, rounding).of("acceleration [1e-14 m/s²]"));
    CHECK_THAT(acceleration_due_to({{1e5, 0}, {1e5, 0}}, 1), IsNear(Vec2{2e5, 0}, rounding)); // the sum may be larger
    CHECK_THAT(acceleration_due_to(std::vector<Vec2>(1000, {1, -2}), 4), IsNear(Vec2{250, -500}, 1e-9));
}

TEST_CASE("a mass of 0 or a negative mass is refused", "[2.1]") {
    CHECK_REFUSED(acceleration_due_to({{1, 2}}, 0));
    CHECK_REFUSED(acceleration_due_to({{1, 2}}, -3));
    CHECK_REFUSED(acceleration_due_to({{1, 2}}, -1e-300));
    CHECK_REFUSED(acceleration_due_to({}, 0));
    acceleration_due_to({{1, 2}}, 3); // good input is still answered
}

// ----------------------------------------------------------------------------------------------- 2.2 elastic_collision

//> Worked example: elastic
TEST_CASE("2 kg at 4 m/s and 3 kg at -2 m/s part at -3.2 and 2.8 m/s", "[2.2]") {
    CHECK_THAT(
        elastic_collision({2, 4}, {3, -2}),
        IsNear(Velocities{-3.2, 2.8}, rounding)
            .since("together both move at (2 · 4 - 3 · 2) / 5 = 0.4 m/s: A has lost 3.6 m/s, and loses them again"));
}

//> Equal masses
TEST_CASE("carts of the same mass swap their velocities", "[2.2]") {
    CHECK_THAT(elastic_collision({2, 4}, {2, -2}), IsNear(Velocities{-2, 4}, rounding));
    CHECK_THAT(elastic_collision({0.5, 4}, {0.5, 0}), IsNear(Velocities{0, 4}, rounding));
    CHECK_THAT(elastic_collision({7, 0}, {7, -4}), IsNear(Velocities{-4, 0}, rounding));
    CHECK_THAT(elastic_collision({7, 5}, {7, 3}), IsNear(Velocities{3, 5}, rounding)); // one catches up with the other
}

//> One at rest
TEST_CASE("1 kg at 3 m/s comes back from 2 kg at rest; 2 kg at 3 m/s roll on behind 1 kg", "[2.2]") {
    CHECK_THAT(elastic_collision({1, 3}, {2, 0}),
               IsNear(Velocities{-1, 2}, rounding).since("squeezed together both move at 3 / 3 = 1 m/s"));
    CHECK_THAT(elastic_collision({2, 3}, {1, 0}),
               IsNear(Velocities{1, 4}, rounding).since("squeezed together both move at 6 / 3 = 2 m/s"));
    CHECK_THAT(elastic_collision({2, 0}, {1, -3}), IsNear(Velocities{-2, 1}, rounding));
    CHECK_THAT(elastic_collision({3, 5}, {1, 1}),
               IsNear(Velocities{3, 7}, rounding).since("squeezed together both move at 16 / 4 = 4 m/s"));
}

//>
TEST_CASE("seen in a mirror, the same happens: left and right change places, and all signs", "[2.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);

        const Velocities after = elastic_collision(a, b);
        const Velocities mirrored = elastic_collision({b.mass, -b.velocity}, {a.mass, -a.velocity});

        CHECK_THAT(mirrored, IsNear(Velocities{-after.b, -after.a}, 1e-11));
    }
}

//> Bounce
TEST_CASE("the carts part at the speed at which they approached each other", "[2.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);

        const Velocities after = elastic_collision(a, b);

        CHECK_THAT(after.b - after.a, IsNear(a.velocity - b.velocity, 1e-11).of("speed at which they part [m/s]"));
    }
}

//> Momentum
TEST_CASE("the momentum of the two carts together is the same after the collision as before", "[2.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double before = momentum_of(a, b, {a.velocity, b.velocity});

        const Velocities after = elastic_collision(a, b);

        CHECK_THAT(momentum_of(a, b, after), IsNear(before, 1e-10).of("momentum of both [N s]")); // of up to 200 N s
    }
}

//> Kinetic energy
TEST_CASE("the kinetic energy of the two carts together is the same after the collision as before", "[2.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double before = energy_of(a, b, {a.velocity, b.velocity});

        const Velocities after = elastic_collision(a, b);

        CHECK_THAT(energy_of(a, b, after), IsNear(before, 1e-10).of("kinetic energy of both [J]")); // of up to 1000 J
    }
}

//> From a moving train
TEST_CASE("from a train that moves along the rail, the same collision is seen, only with other velocities", "[2.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double train = dice.real(-50, 50);

        const Velocities after = elastic_collision(a, b);
        const Velocities seen = elastic_collision({a.mass, a.velocity - train}, {b.mass, b.velocity - train});

        CHECK_THAT(seen, IsNear(Velocities{after.a - train, after.b - train}, 1e-10)); // twelve digits of 60 m/s
    }
}

//> Very unequal
TEST_CASE("a light cart bounces off a very heavy one, and is hit away by it at twice its velocity", "[2.2]") {
    const double heavy = 1e5, light = 0.1, almost = 1e-5; // a millionth of the momentum is missing
    CHECK_THAT(elastic_collision({light, 5}, {heavy, 0}), IsNear(Velocities{-5, 0}, almost));
    CHECK_THAT(elastic_collision({heavy, 5}, {light, 0}), IsNear(Velocities{5, 10}, almost));
    CHECK_THAT(elastic_collision({heavy, 5}, {light, -5}), IsNear(Velocities{5, 15}, almost));
    // 1 kg at 3 m/s and 9999 kg at rest: together 3 / 10000 m/s
    CHECK_THAT(elastic_collision({1, 3}, {9999, 0}), IsNear(Velocities{-2.9994, 0.0006}, 1e-8));
    CHECK_THAT(elastic_collision({9999, 0}, {1, -3}), IsNear(Velocities{-0.0006, 2.9994}, 1e-8));
}

//> Apart
TEST_CASE("carts that do not approach each other keep their velocities", "[2.2]") {
    CHECK_THAT(elastic_collision({2, -3.2}, {3, 2.8}), IsNear(Velocities{-3.2, 2.8})); // after the worked example
    CHECK_THAT(elastic_collision({2, 1}, {3, 4}), IsNear(Velocities{1, 4}));           // the one ahead is faster
    CHECK_THAT(elastic_collision({2, -4}, {3, -1}), IsNear(Velocities{-4, -1}));       // the one behind is slower
    CHECK_THAT(elastic_collision({2, -1}, {3, 0}), IsNear(Velocities{-1, 0}));
    CHECK_THAT(elastic_collision({2, 4}, {3, 4}), IsNear(Velocities{4, 4})); // equally fast
    CHECK_THAT(elastic_collision({2, 0}, {3, 0}), IsNear(Velocities{0, 0}));
    CHECK_THAT(elastic_collision({2, 4}, {3, std::nextafter(4.0, 5.0)}),
               IsNear(Velocities{4, std::nextafter(4.0, 5.0)}));
}

//> Erratum E2.12
TEST_CASE("erratum E2.12: with the printed 2.4 m/s both momentum and energy are lost; 2.8 m/s keep them", "[2.2]") {
    const Cart a{2, 4}, b{3, -2};
    CHECK_THAT(momentum_of(a, b, {4, -2}), IsNear(2.0, rounding));     // before
    CHECK_THAT(energy_of(a, b, {4, -2}), IsNear(22.0, rounding));      // before
    CHECK_THAT(momentum_of(a, b, {-3.2, 2.4}), IsNear(0.8, rounding)); // as printed
    CHECK_THAT(energy_of(a, b, {-3.2, 2.4}), IsNear(18.88, rounding)); // as printed

    const Velocities after = elastic_collision(a, b);
    CHECK_THAT(momentum_of(a, b, after), IsNear(2.0, rounding).of("momentum of both [N s]"));
    CHECK_THAT(energy_of(a, b, after), IsNear(22.0, rounding).of("kinetic energy of both [J]"));
}

//> Erratum E2.13
TEST_CASE("erratum E2.13: the two carts do not both leave to the right; each turns around", "[2.2]") {
    const Velocities after = elastic_collision({2, 4}, {3, -2});
    CHECK_THAT(after.a, IsBelow(0).of("velocity of cart a [m/s]"));
    CHECK_THAT(after.b, IsAbove(0).of("velocity of cart b [m/s]"));
}

//>
TEST_CASE("elastic_collision allows masses from 1e-9 to 1e5 kg, velocities up to ±1e5, and tiny ones", "[2.2]") {
    CHECK_THAT(elastic_collision({1e5, 1e5}, {1e5, -1e5}), IsNear(Velocities{-1e5, 1e5}, rounding));
    CHECK_THAT(elastic_collision({1e-9, 1e5}, {1e-9, -1e5}), IsNear(Velocities{-1e5, 1e5}, rounding));
    CHECK_THAT(elastic_collision({1e-100, 5}, {1e-100, 0}),
               IsNear(Velocities{0, 5}, 1e-9));              // even lighter: fewer digits
    CHECK_THAT(elastic_collision({1e5, 1e5}, {1e4, -1e5}).b, // an answer beyond 1e5
               IsNear(2.9e6 / 11, 1e-11).of("velocity of b [m/s]"));
    elastic_collision({1e5, 1e5}, {1e-9, -1e5}); // allowed, but no digit need be right
    CHECK_THAT(elastic_collision({1e5, 4}, {5e4, -2}), IsNear(Velocities{0, 6}, rounding));
    CHECK_THAT(elastic_collision({1e-9, 4}, {3e-9, 0}), IsNear(Velocities{-2, 2}, rounding));
    CHECK_THAT(elastic_collision({1, 1e-20}, {2, 0}).b * 1e20,
               IsNear(2.0 / 3, rounding).of("velocity of b [1e-20 m/s]"));
    CHECK_THAT(elastic_collision({2, 100 + 1e-8}, {3, 100}), IsNear(Velocities{100 - 2e-9, 100 + 8e-9}, rounding));
    CHECK_THAT(elastic_collision({2, 100.5}, {3, 100}), IsNear(Velocities{99.9, 100.4}, rounding)); // barely faster
    CHECK_THAT(elastic_collision({2, -99.5}, {3, -100}), IsNear(Velocities{-100.1, -99.6}, rounding));
}

TEST_CASE("a cart with a mass of 0 or less is refused", "[2.2]") {
    CHECK_REFUSED(elastic_collision({0, 4}, {3, -2}));
    CHECK_REFUSED(elastic_collision({2, 4}, {0, -2}));
    CHECK_REFUSED(elastic_collision({-2, 4}, {3, -2}));
    CHECK_REFUSED(elastic_collision({2, 4}, {-3, -2}));
    CHECK_REFUSED(elastic_collision({2, 4}, {-1e-300, -2}));
    CHECK_REFUSED(elastic_collision({0, -4}, {3, 2})); // even if they move apart
    CHECK_REFUSED(elastic_collision({0, 4}, {3, 4}));  // or are equally fast
    elastic_collision({2, 4}, {3, -2});                // good input is still answered
}

// --------------------------------------------------------------------------------------------------------- 2.3 collide

//> Worked example: clay
TEST_CASE("2 kg of clay at 4 m/s and 3 kg at -2 m/s move on together at 0.4 m/s", "[2.3]") {
    CHECK_THAT(collide({2, 4}, {3, -2}, 0),
               IsNear(Velocities{0.4, 0.4}, rounding).since("2 · 4 + 3 · (-2) = 2 N s are shared by 5 kg"));
}

//> Between clay and rubber
TEST_CASE("between clay and rubber: the two carts part at a quarter, half, three quarters of 6 m/s", "[2.3]") {
    CHECK_THAT(collide({2, 4}, {3, -2}, 0.25),
               IsNear(Velocities{-0.5, 1}, rounding).since("0.4 - 3.6/4 = -0.5 and 0.4 + 2.4/4 = 1"));
    CHECK_THAT(collide({2, 4}, {3, -2}, 0.5), IsNear(Velocities{-1.4, 1.6}, rounding));
    CHECK_THAT(collide({2, 4}, {3, -2}, 0.75), IsNear(Velocities{-2.3, 2.2}, rounding));
}

//> Rubber
TEST_CASE("with a restitution of 1 the collision is elastic", "[2.3]") {
    CHECK_THAT(collide({2, 4}, {3, -2}, 1), IsNear(Velocities{-3.2, 2.8}, rounding));
    CHECK_THAT(collide({1, 3}, {2, 0}, 1), IsNear(Velocities{-1, 2}, rounding));
    CHECK_THAT(collide({7, 5}, {7, 3}, 1), IsNear(Velocities{3, 5}, rounding));
}

//> Equal and opposite
TEST_CASE("carts with opposite momenta come back with the fraction `restitution` of their velocities", "[2.3]") {
    CHECK_THAT(collide({2, 3}, {3, -2}, 0.5), IsNear(Velocities{-1.5, 1}, rounding));
    CHECK_THAT(collide({5, 4}, {5, -4}, 0.25), IsNear(Velocities{-1, 1}, rounding));
    CHECK_THAT(collide({5, 4}, {5, -4}, 0), IsNear(Velocities{0, 0}, rounding));
}

//> The speed of parting
TEST_CASE("the speed at which the carts part is `restitution` times that of their approach", "[2.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double restitution = dice.real(0, 1);

        const Velocities after = collide(a, b, restitution);

        const double parting = restitution * (a.velocity - b.velocity);
        CHECK_THAT(after.b - after.a, IsNear(parting, 1e-11).of("speed at which they part [m/s]"));
    }
}

//> Momentum, always
TEST_CASE("for every restitution, the momentum of both carts together is the same after as before", "[2.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double before = momentum_of(a, b, {a.velocity, b.velocity});

        const Velocities after = collide(a, b, dice.real(0, 1));

        CHECK_THAT(momentum_of(a, b, after), IsNear(before, 1e-10).of("momentum of both [N s]"));
    }
}

//> What is lost
TEST_CASE("of the energy with which they approach each other, the fraction 1 - restitution² is lost", "[2.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double restitution = dice.real(0, 1);

        const Velocities after = collide(a, b, restitution);

        // As if one body with the mass m_a m_b / (m_a + m_b) ran into a wall at the speed of approach.
        const double reduced = 1 / (1 / a.mass + 1 / b.mass), approach = a.velocity - b.velocity;
        const double lost = (1 - restitution * restitution) * reduced * approach * approach / 2;
        const double before = energy_of(a, b, {a.velocity, b.velocity});
        CHECK_THAT(before - energy_of(a, b, after), IsNear(lost, 1e-9).of("kinetic energy lost [J]")); // of 1000 J
    }
}

//>
TEST_CASE("with restitution, too, a mirror and a moving train show the same collision", "[2.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double restitution = dice.real(0, 1), train = dice.real(-50, 50);

        const Velocities after = collide(a, b, restitution);
        const Velocities mirrored = collide({b.mass, -b.velocity}, {a.mass, -a.velocity}, restitution);
        CHECK_THAT(mirrored, IsNear(Velocities{-after.b, -after.a}, 1e-11));

        const Velocities seen = collide({a.mass, a.velocity - train}, {b.mass, b.velocity - train}, restitution);
        CHECK_THAT(seen, IsNear(Velocities{after.a - train, after.b - train}, 1e-10));
    }
}

//> Apart, whatever they are made of
TEST_CASE("even carts of clay keep their velocities if they do not approach each other", "[2.3]") {
    for (const double restitution : {0.0, 0.5, 1.0}) {
        CHECK_THAT(collide({2, -3.2}, {3, 2.8}, restitution), IsNear(Velocities{-3.2, 2.8}));
        CHECK_THAT(collide({2, 1}, {3, 4}, restitution), IsNear(Velocities{1, 4}));
        CHECK_THAT(collide({2, -4}, {3, -1}, restitution), IsNear(Velocities{-4, -1}));
        CHECK_THAT(collide({2, 4}, {3, 4}, restitution), IsNear(Velocities{4, 4}));
    }
}

//> Erratum E2.4
TEST_CASE("erratum E2.4: a pea of 1 g at 10 000 km/s has a hundredth of the momentum of a train at 1 m/s", "[2.3]") {
    // In tonnes and km/s: the train has 1000 · 0.001 = 1 t km/s, the pea 1e-6 · 1e4 = 0.01 t km/s.
    // Meeting head-on as clay, they go on the way of the train, at all but a hundredth of its speed.
    const Velocities after = collide({1000, 0.001}, {1e-6, -1e4}, 0);
    CHECK_THAT(after.a * 1000, IsNear(0.99, 1e-8).of("velocity of the train [m/s]")); // slowed by a hundredth
}

//> Erratum E2.6
TEST_CASE("erratum E2.6: a bee at 155 mph throws nobody off a motorbike: 200 lb gain 0.08 mm/s", "[2.3]") {
    const double mile = 1609.344, pound = 0.45359237;
    const Cart bee{0.0001, 155 * mile / 3600}, rider{200 * pound, 0}; // 0.1 g at 69.3 m/s, 90.7 kg
    CHECK_THAT(collide(bee, rider, 0).b * 1000, IsNear(0.0764, 0.0001).of("velocity of the rider [mm/s]"));
}

//> Erratum E2.8
TEST_CASE("erratum E2.8: momentum is not lost in a collision that is not elastic: 2 N s before and after", "[2.3]") {
    const Cart a{2, 4}, b{3, -2};
    for (const double restitution : {0.0, 0.5, 1.0}) {
        const Velocities after = collide(a, b, restitution);
        CHECK_THAT(momentum_of(a, b, after), IsNear(2.0, rounding).of("momentum of both [N s]"));
    }
}

//> Erratum E2.9
TEST_CASE("erratum E2.9: kinetic energy does not stay, \"elastic or not\": clay keeps 0.4 J of 22 J", "[2.3]") {
    const Cart a{2, 4}, b{3, -2};
    CHECK_THAT(energy_of(a, b, {4, -2}), IsNear(22.0, rounding)); // before
    const Velocities clay = collide(a, b, 0), half = collide(a, b, 0.5), rubber = collide(a, b, 1);
    CHECK_THAT(energy_of(a, b, clay), IsNear(0.4, rounding).of("kinetic energy with restitution 0 [J]"));
    CHECK_THAT(energy_of(a, b, half), IsNear(5.8, rounding).of("kinetic energy with restitution 0.5 [J]"));
    CHECK_THAT(energy_of(a, b, rubber), IsNear(22.0, rounding).of("kinetic energy with restitution 1 [J]"));
}

//>
TEST_CASE("collide allows masses from 1e-9 to 1e5 kg, velocities up to ±1e5, and any restitution from 0 to 1",
          "[2.3]") {
    CHECK_THAT(collide({1e5, 1e5}, {1e5, -1e5}, 0.5), IsNear(Velocities{-5e4, 5e4}, rounding));
    CHECK_THAT(collide({1e5, 1e5}, {1e4, -1e5}, 0.5).b, // an answer beyond 1e5
               IsNear(1.9e6 / 11, 1e-11).of("velocity of b [m/s]"));
    collide({1e5, 1e5}, {1e-9, -1e5}, 0.5); // allowed, but no digit need be right
    CHECK_THAT(collide({1e5, 4}, {5e4, -2}, 0.5), IsNear(Velocities{1, 4}, rounding));
    CHECK_THAT(collide({1e-9, 4}, {3e-9, 0}, 0.5), IsNear(Velocities{-0.5, 1.5}, rounding));
    CHECK_THAT(collide({1e-9, 1e5}, {1e-9, -1e5}, 0.5), IsNear(Velocities{-5e4, 5e4}, rounding));
    CHECK_THAT(collide({1e5, 1}, {1e5, -1}, 0.5), IsNear(Velocities{-0.5, 0.5}, rounding));
    CHECK_THAT(collide({1e-100, 6}, {1e-100, 0}, 0), IsNear(Velocities{3, 3}, 1e-9)); // even lighter: fewer digits
    // 1 kg at 3 m/s and 9999 kg at rest: together 3 / 10000 m/s
    CHECK_THAT(collide({1, 3}, {9999, 0}, 0), IsNear(Velocities{0.0003, 0.0003}, 1e-8));
    CHECK_THAT(collide({9999, 0}, {1, -3}, 0), IsNear(Velocities{-0.0003, -0.0003}, 1e-8));
    CHECK_THAT(collide({1, 1e-20}, {3, 0}, 0.5).b * 1e20, IsNear(0.375, rounding).of("velocity of b [1e-20 m/s]"));
    CHECK_THAT(collide({2, 100 + 1e-8}, {3, 100}, 0), IsNear(Velocities{100 + 4e-9, 100 + 4e-9}, rounding));
    CHECK_THAT(collide({2, 100.5}, {3, 100}, 0), IsNear(Velocities{100.2, 100.2}, rounding));
    CHECK_THAT(collide({2, 4}, {3, -2}, 1e-10), IsNear(Velocities{0.4 - 3.6e-10, 0.4 + 2.4e-10}, rounding));
    CHECK_THAT(collide({2, 4}, {3, -2}, 1 - 1e-10), IsNear(Velocities{-3.2 + 3.6e-10, 2.8 - 2.4e-10}, rounding));
}

TEST_CASE("a restitution beyond 0 to 1, or a mass of 0 or less, is refused", "[2.3]") {
    CHECK_REFUSED(collide({2, 4}, {3, -2}, -0.1));
    CHECK_REFUSED(collide({2, 4}, {3, -2}, 1.1));
    CHECK_REFUSED(collide({2, 4}, {3, -2}, std::nextafter(1.0, 2.0)), "the first number beyond 1");
    CHECK_REFUSED(collide({2, 4}, {3, -2}, -1e-300));
    CHECK_REFUSED(collide({2, -4}, {3, 2}, 1.5)); // even if they move apart
    CHECK_REFUSED(collide({2, 4}, {3, 4}, 1.5));  // or are equally fast
    CHECK_REFUSED(collide({0, 4}, {3, 4}, 0.5));
    CHECK_REFUSED(collide({0, 4}, {3, -2}, 0.5));
    CHECK_REFUSED(collide({2, 4}, {0, -2}, 0.5));
    CHECK_REFUSED(collide({-2, 4}, {3, -2}, 0.5));
    CHECK_REFUSED(collide({2, 4}, {-3, -2}, 0.5));
    CHECK_REFUSED(collide({2, 4}, {-1e-300, -2}, 0.5));
    collide({2, 4}, {3, -2}, 0.5); // good input is still answered
}

// -------------------------------------------------------------------------------------------- 2.4 centre_of_mass_frame

//> Worked example: from the centre of mass
TEST_CASE("the centre of mass of the two carts moves at 0.4 m/s; from it they are seen at 3.6 and -2.4 m/s", "[2.4]") {
    CHECK_THAT(
        centre_of_mass_frame({2, 4}, {3, -2}),
        IsNear(CentreOfMassFrame{0.4, 3.6, -2.4, 21.6}, 1e-11)
            .since("(2 · 4 - 3 · 2) / 5 = 0.4, 4 - 0.4 = 3.6, -2 - 0.4 = -2.4, and 2/2 · 3.6² + 3/2 · 2.4² = 21.6"));
}

//> Simple frames
TEST_CASE("equal masses are seen at half the difference of their velocities, either way", "[2.4]") {
    CHECK_THAT(centre_of_mass_frame({2, 5}, {2, 1}), IsNear(CentreOfMassFrame{3, 2, -2, 8}, 1e-11));
    CHECK_THAT(centre_of_mass_frame({2, 1}, {2, 5}), IsNear(CentreOfMassFrame{3, -2, 2, 8}, 1e-11)); // they part
    CHECK_THAT(centre_of_mass_frame({3, 4}, {1, 0}), IsNear(CentreOfMassFrame{3, 1, -3, 6}, 1e-11));
    CHECK_THAT(centre_of_mass_frame({3, 7}, {5, 7}), IsNear(CentreOfMassFrame{7, 0, 0, 0}, 1e-11)); // side by side
    CHECK_THAT(centre_of_mass_frame({3, 0}, {5, 0}), IsNear(CentreOfMassFrame{0, 0, 0, 0}, 1e-11));
}

//> No momentum is left
TEST_CASE("seen from the centre of mass, the two momenta are equal and opposite", "[2.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Cart a = random_cart(dice), b = random_cart(dice);

        const CentreOfMassFrame seen = centre_of_mass_frame(a, b);

        CHECK_THAT(a.mass * seen.a + b.mass * seen.b, IsNear(0.0, 1e-10).of("momentum of both, seen from there [N s]"));
        CHECK_THAT(seen.velocity + seen.a, IsNear(a.velocity, 1e-11).of("velocity of a, back on the rail [m/s]"));
        CHECK_THAT(seen.velocity + seen.b, IsNear(b.velocity, 1e-11).of("velocity of b, back on the rail [m/s]"));
    }
}

//> König's theorem
TEST_CASE("the energy seen from there, plus that of all mass at the centre's velocity, is the whole", "[2.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Cart a = random_cart(dice), b = random_cart(dice);

        const CentreOfMassFrame seen = centre_of_mass_frame(a, b);

        const double of_all = (a.mass + b.mass) * seen.velocity * seen.velocity / 2;
        const double whole = energy_of(a, b, {a.velocity, b.velocity});
        CHECK_THAT(seen.energy + of_all, IsNear(whole, 1e-10).of("kinetic energy of both [J]"));
    }
}

//> Galilean invariance
TEST_CASE("if both carts are faster by the same velocity, only the velocity of their centre of mass changes", "[2.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Cart a = random_cart(dice), b = random_cart(dice);
        const double more = dice.real(-50, 50);

        const CentreOfMassFrame seen = centre_of_mass_frame(a, b);
        const CentreOfMassFrame faster = centre_of_mass_frame({a.mass, a.velocity + more}, {b.mass, b.velocity + more});

        CHECK_THAT(faster, IsNear(CentreOfMassFrame{seen.velocity + more, seen.a, seen.b, seen.energy}, 1e-10));
    }
}

//>
TEST_CASE("when the carts change places, so do their velocities, and nothing else changes", "[2.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const Cart a = random_cart(dice), b = random_cart(dice);

        const CentreOfMassFrame seen = centre_of_mass_frame(a, b);

        CHECK_THAT(centre_of_mass_frame(b, a),
                   IsNear(CentreOfMassFrame{seen.velocity, seen.b, seen.a, seen.energy}, 1e-10));
    }
}

TEST_CASE("seen from a centre of mass near a heavy cart, the light one has nearly all of the velocity", "[2.4]") {
    CHECK_THAT(centre_of_mass_frame({1e-9, 3}, {1e5, 0}),
               IsNear(CentreOfMassFrame{3e-14, 3, -3e-14, 4.5e-9}, rounding));
    const CentreOfMassFrame heavy_left = centre_of_mass_frame({1e5, 3}, {1e-9, 1});
    CHECK_THAT(heavy_left, IsNear(CentreOfMassFrame{3, 2e-14, -2, 2e-9}, rounding));
    CHECK_THAT(heavy_left.energy * 1e9, IsNear(2.0, 1e-11).of("energy seen from there [1e-9 J]"));
    CHECK_THAT(centre_of_mass_frame({1e5, 1e5}, {1e5, -1e5}), IsNear(CentreOfMassFrame{0, 1e5, -1e5, 1e15}, 1e-11));
    // 1 kg at 3 m/s and 9999 kg at rest: together 3 / 10000 m/s, and 1/2 · 0.9999 kg · 9 m²/s²
    CHECK_THAT(centre_of_mass_frame({1, 3}, {9999, 0}),
               IsNear(CentreOfMassFrame{0.0003, 2.9997, -0.0003, 4.49955}, 1e-11));
    CHECK_THAT(centre_of_mass_frame({1, 1e5}, {9999, -1e5}), // an answer beyond 1e5
               IsNear(CentreOfMassFrame{-99980, 199980, -20, 1.9998e10}, 1e-11));
    CHECK_THAT(centre_of_mass_frame({1e-100, 2}, {1e-100, 0}), IsNear(CentreOfMassFrame{1, 1, -1, 0}, 1e-9));
    // 10 mg at 1000 m/s and 100 t at rest: together 1e-7 m/s, but for ten digits
    const double missing = 1e-10;
    CHECK_THAT(centre_of_mass_frame({1e-5, 1000}, {1e5, 0}),
               IsNear(CentreOfMassFrame{1e-7, 1000 * (1 - missing), -1e-7, 5 * (1 - missing)}, rounding));
    CHECK_THAT(
        centre_of_mass_frame({1e5, 1000}, {1e-5, 0}),
        IsNear(CentreOfMassFrame{1000 * (1 - missing), 1e-7, -1000 * (1 - missing), 5 * (1 - missing)}, rounding));
    const CentreOfMassFrame slow = centre_of_mass_frame({1, 1e-20}, {3, 0});
    CHECK_THAT(slow.a * 1e20, IsNear(0.75, rounding).of("velocity of a, seen from there [1e-20 m/s]"));
    CHECK_THAT(slow.energy * 1e40, IsNear(0.375, 1e-11).of("energy seen from there [1e-40 J]"));
}

//> Two fast carts, and a slow collision
TEST_CASE("two carts at 1e5 m/s with a difference of 2^-10 m/s are seen at their shares of it, to twelve digits",
          "[2.4]") {
    for (const int exponent : {-10, -36}) {          // at last the smallest difference that there is at 1e5 m/s
        const double slow = std::ldexp(1, exponent); // [m/s]: exact, as are both velocities
        const CentreOfMassFrame seen = centre_of_mass_frame({2, 99999 + slow}, {3, 99999});
        CHECK_THAT(seen.a / slow, IsNear(0.6, rounding).of("velocity of a, in units of the difference"));
        CHECK_THAT(seen.b / slow, IsNear(-0.4, rounding).of("velocity of b, in units of the difference"));
        CHECK_THAT(seen.energy / (slow * slow),
                   IsNear(0.6, 1e-11).of("energy, in units of 1 kg and the difference squared"));
    }
}

//>
TEST_CASE("seen from a centre of mass: a mass of 0 or less is refused", "[2.4]") {
    CHECK_REFUSED(centre_of_mass_frame({0, 4}, {3, -2}));
    CHECK_REFUSED(centre_of_mass_frame({2, 4}, {0, -2}));
    CHECK_REFUSED(centre_of_mass_frame({-2, 4}, {3, -2}));
    CHECK_REFUSED(centre_of_mass_frame({2, 4}, {-3, -2}));
    CHECK_REFUSED(centre_of_mass_frame({2, 4}, {-1e-300, -2}));
    centre_of_mass_frame({2, 4}, {3, -2}); // good input is still answered
}

// --------------------------------------------------------------------------------------------------------- 2.5 impulse

//> Worked example: impulse
TEST_CASE("the impulse between the two carts is 14.4 N s if they are rubber, 7.2 N s if they are clay", "[2.5]") {
    CHECK_THAT(
        impulse({1.0 / 2, 4}, {1.0 / 3, -2}, 0.5),
        IsNear(10.8, rounding)
            .since("1 N s takes 1/2 + 1/3 = 5/6 m/s away: 7.2 N s take all of 6, and 3.6 N s give half of it back"));
    CHECK_THAT(impulse({1.0 / 2, 4}, {1.0 / 3, -2}, 1),
               IsNear(14.4, rounding)
                   .since("1 N s takes 1/2 + 1/3 = 5/6 m/s away: 7.2 N s take all of 6 m/s, and 14.4 N s reverse it"));
    CHECK_THAT(impulse({1.0 / 2, 4}, {1.0 / 3, -2}, 0),
               IsNear(7.2, rounding).since("1 N s takes 1/2 + 1/3 = 5/6 m/s away, and 6 / (5/6) = 7.2"));
}

//> The carts of 2.3
TEST_CASE("the impulse changes both velocities to those that part at `restitution` times the approach", "[2.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double restitution = dice.real(0, 1);

        const double j = impulse({1 / a.mass, a.velocity}, {1 / b.mass, b.velocity}, restitution);

        const double parting = (b.velocity + j / b.mass) - (a.velocity - j / a.mass);
        const double want = restitution * (a.velocity - b.velocity);
        CHECK_THAT(j, IsAtLeast(0).of("impulse [N s]"));
        CHECK_THAT(parting, IsNear(want, 1e-10).of("speed at which they part [m/s]")); // masses from 0.1 kg
    }
}

//>
TEST_CASE("an impulse depends on the difference of the velocities, and not on which of them is called a", "[2.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const auto [a, b] = random_pair(dice);
        const double restitution = dice.real(0, 1), train = dice.real(-50, 50);

        const double j = impulse({1 / a.mass, a.velocity}, {1 / b.mass, b.velocity}, restitution);

        CHECK_THAT(impulse({1 / b.mass, -b.velocity}, {1 / a.mass, -a.velocity}, restitution), IsNear(j, 1e-10));
        CHECK_THAT(impulse({1 / a.mass, a.velocity - train}, {1 / b.mass, b.velocity - train}, restitution),
                   IsNear(j, 1e-10));
    }
}

TEST_CASE("bodies that do not approach each other exert no impulse", "[2.5]") {
    CHECK_THAT(impulse({0.5, -3.2}, {0.25, 2.8}, 1), IsNear(0.0));
    CHECK_THAT(impulse({0.5, 1}, {0.25, 4}, 0.5), IsNear(0.0));
    CHECK_THAT(impulse({0.5, -4}, {0.25, -1}, 0), IsNear(0.0));
    CHECK_THAT(impulse({0.5, 4}, {0.25, 4}, 0), IsNear(0.0)); // equally fast
    CHECK_THAT(impulse({0, 0}, {0.25, 4}, 1), IsNear(0.0));   // away from a wall
}

//> A wall
TEST_CASE("a wall, which nothing can move, turns 2 kg at 5 m/s around with 20 N s", "[2.5]") {
    CHECK_THAT(impulse({0.5, 5}, {0, 0}, 1), IsNear(20.0, rounding));    // from 10 N s to -10 N s
    CHECK_THAT(impulse({0, 0}, {0.5, -5}, 1), IsNear(20.0, rounding));   // a wall on the left
    CHECK_THAT(impulse({0.5, 5}, {0, 0}, 0), IsNear(10.0, rounding));    // and clay stays at it
    CHECK_THAT(impulse({0.5, 5}, {0, -1}, 0.5), IsNear(18.0, rounding)); // a piston at -1 m/s: 1.5 · 6 · 2
    CHECK_THAT(impulse({0, 1}, {0.5, -5}, 0.5), IsNear(18.0, rounding)); // one on the left
    CHECK_THAT(impulse({0.5, 5}, {0, 5.5}, 0.5), IsNear(0.0));           // one that moves away faster
}

//> Two walls
TEST_CASE("two bodies that nothing can move exert no impulse, even if they approach each other", "[2.5]") {
    CHECK_THAT(impulse({0, 0}, {0, 0}, 1), IsNear(0.0));
    CHECK_THAT(impulse({0, 3}, {0, -2}, 1), IsNear(0.0)); // two pistons
    CHECK_THAT(impulse({0, 3}, {0, -2}, 0), IsNear(0.0));
}

//> Erratum E2.7
TEST_CASE("erratum E2.7: a ball that comes back from a wall has not kept its momentum: it has changed sign", "[2.5]") {
    const double j = impulse({1, 5}, {0, 0}, 1); // 1 kg at 5 m/s
    CHECK_THAT(5 - j, IsNear(-5.0, rounding).of("momentum of the ball after the wall [N s]"));
    CHECK_THAT(j, IsNear(10.0, rounding).of("momentum that wall and Earth have taken [N s]"));
}

//>
TEST_CASE("an impulse is right for inverse masses from 1e-9 to 1e5 per kg, and velocities up to ±1e5", "[2.5]") {
    CHECK_THAT(impulse({1e5, 1e5}, {1e5, -1e5}, 1), IsNear(2.0, rounding));
    CHECK_THAT(impulse({1e-9, 1e5}, {1e-9, -1e5}, 1), IsNear(2e14, rounding));
    CHECK_THAT(impulse({1e-9, 3}, {0, 0}, 0), IsNear(3e9, rounding));
    CHECK_THAT(impulse({0.5, 3}, {1e-100, 0}, 0), IsNear(6.0, 1e-9));
    CHECK_THAT(impulse({1e5, 2}, {0, 0}, 0) * 1e5, IsNear(2.0, rounding).of("impulse [1e-5 N s]"));
    CHECK_THAT(impulse({1e5, 2}, {1e-9, 0}, 0) * 1e5, IsNear(2.0, rounding).of("impulse [1e-5 N s]"));
    CHECK_THAT(impulse({1e5, 2}, {1e-5, 0}, 0) * 1e5, IsNear(2 - 2e-10, rounding).of("impulse [1e-5 N s]"));
    CHECK_THAT(impulse({0.5, 1e-20}, {0.5, 0}, 0) * 1e20, IsNear(1.0, rounding).of("impulse [1e-20 N s]"));
    CHECK_THAT(impulse({0.5, 3}, {0, 0}, 1e-10), IsNear(6 + 6e-10, rounding));
    CHECK_THAT(impulse({0.5, 3}, {0, 0}, 1 - 1e-10), IsNear(12 - 6e-10, rounding));
    // two carts at 1e5 m/s, which approach each other as slowly as a double can say
    CHECK_THAT(impulse({0.5, 99999 + std::ldexp(1, -36)}, {0.125, 99999}, 0.5) * std::ldexp(1, 36),
               IsNear(2.4, rounding).of("impulse [2^-36 N s]"));
}

TEST_CASE("a negative inverse mass, or a restitution beyond 0 to 1, is refused", "[2.5]") {
    CHECK_REFUSED(impulse({-0.5, 4}, {0.25, -2}, 1));
    CHECK_REFUSED(impulse({0.5, 4}, {-0.25, -2}, 1));
    CHECK_REFUSED(impulse({-0.5, -4}, {0.25, 2}, 1)); // even if they move apart
    CHECK_REFUSED(impulse({0.5, 4}, {0.25, -2}, -0.1));
    CHECK_REFUSED(impulse({0.5, 4}, {0.25, -2}, 1.1));
    CHECK_REFUSED(impulse({0.5, 4}, {0.25, -2}, -1e-300));
    CHECK_REFUSED(impulse({0.5, 4}, {0.25, -2}, std::nextafter(1.0, 2.0)), "the first number beyond 1");
    CHECK_REFUSED(impulse({-1e-300, 4}, {0.25, -2}, 1));
    CHECK_REFUSED(impulse({0, 4}, {0, -2}, 1.1)); // even if nothing can move them
    impulse({0.5, 4}, {0.25, -2}, 0.5);           // good input is still answered
}

// -------------------------------------------------------------------------------------------------- 2.6 newtons_cradle

namespace {

std::vector<Cart> equal_carts(double mass, const std::vector<double> &velocities) {
    std::vector<Cart> carts;
    for (const double velocity : velocities) carts.push_back({mass, velocity});
    return carts;
}

} // namespace

//> Worked example: a cradle
TEST_CASE("of five equal carts, as many leave at the right as come in from the left", "[2.6]") {
    using List = std::vector<double>;
    CHECK_THAT(newtons_cradle(equal_carts(2, {3, 0, 0, 0, 0})), IsNear(List{0, 0, 0, 0, 3}, rounding));
    CHECK_THAT(newtons_cradle(equal_carts(2, {3, 3, 0, 0, 0})), IsNear(List{0, 0, 0, 3, 3}, rounding));
    CHECK_THAT(newtons_cradle(equal_carts(2, {3, 3, 3, 0, 0})), IsNear(List{0, 0, 3, 3, 3}, rounding));
    CHECK_THAT(newtons_cradle(equal_carts(2, {3, 3, 3, 3, 0})), IsNear(List{0, 3, 3, 3, 3}, rounding));
}

//> From both sides
TEST_CASE("carts of the same mass that come in from both sides leave on both sides", "[2.6]") {
    using List = std::vector<double>;
    CHECK_THAT(newtons_cradle(equal_carts(2, {3, 0, 0, 0, -3})), IsNear(List{-3, 0, 0, 0, 3}, rounding));
    CHECK_THAT(newtons_cradle(equal_carts(2, {3, 0, 0, -1, -1})), IsNear(List{-1, -1, 0, 0, 3}, rounding));
    CHECK_THAT(newtons_cradle(equal_carts(2, {0, 0, -3})), IsNear(List{-3, 0, 0}, rounding));
    CHECK_THAT(newtons_cradle(equal_carts(2, {5, 3, 4, 1})), IsNear(List{1, 3, 4, 5}, rounding)); // a queue
}

//>
TEST_CASE("of up to a hundred equal carts, each leaves at a velocity with which one of them came", "[2.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        std::vector<double> velocities(std::size_t(i == 0 ? 100 : dice.whole(1, 20)));
        for (double &velocity : velocities) velocity = dice.real(-10, 10);
        if (i == 0) std::ranges::sort(velocities, std::greater{}); // every two collide: 4950 collisions

        const std::vector<double> after = newtons_cradle(equal_carts(dice.real(0.1, 10), velocities));

        std::ranges::sort(velocities); // the slowest on the left, or they would still approach each other
        CHECK_THAT(after, IsNear(velocities, 1e-9));
    }
}

//> Nobody to collide with
TEST_CASE("no carts, a single cart, or carts that do not approach each other: nothing happens", "[2.6]") {
    using List = std::vector<double>;
    CHECK_THAT(newtons_cradle({}), IsNear(List{}));
    CHECK_THAT(newtons_cradle({{2, -3}}), IsNear(List{-3}));
    CHECK_THAT(newtons_cradle({{2, -3}, {1, -3}, {5, 0}, {0.5, 7}}), IsNear(List{-3, -3, 0, 7}));
}

//> Unequal carts
TEST_CASE("two carts in a row collide as in 2.2; a third one is pushed on by the second", "[2.6]") {
    using List = std::vector<double>;
    CHECK_THAT(newtons_cradle({{2, 4}, {3, -2}}), IsNear(List{-3.2, 2.8}, 1e-10));
    // nearly equal carts do not quite swap: together 1 / 2.000001
    CHECK_THAT(newtons_cradle({{1, 1}, {1.000001, 0}}), IsNear(List{-1e-6 / 2.000001, 2 / 2.000001}, 1e-10));
    CHECK_THAT(newtons_cradle({{2, 6}, {1, 0}, {3, 0}}),
               IsNear(List{-2, 4, 4}, 1e-10)
                   .since("the left pair parts at 2, 8 m/s, the right one at -4, 4, and the left one then at -2, 4"));
    // seen in a mirror, the leftmost pair is another one: 3 and 1 kg first, but only the right pair approaches at first
    CHECK_THAT(newtons_cradle({{3, 0}, {1, 0}, {2, -6}}), IsNear(List{-4, -4, 2}, 1e-10));
}

//> The leftmost pair first
TEST_CASE("if two pairs approach each other, the left one collides first, and that makes a difference", "[2.6]") {
    using List = std::vector<double>;
    // kg: 2 1 3 1; m/s: 3 3 0 -3, then 3 -1.5 1.5 -3, then 0 4.5 1.5 -3, then 0 0 3 -3, then 0 0 0 6
    CHECK_THAT(newtons_cradle({{2, 3}, {1, 3}, {3, 0}, {1, -3}}), IsNear(List{0, 0, 0, 6}, 1e-10));
    // 1 and 2 kg: together 1: -1, 2; 2 and 1 kg: together 1/3: -4/3, 8/3; 1 and 2 kg: together -11/9: -13/9, -10/9
    CHECK_THAT(newtons_cradle({{1, 3}, {2, 0}, {1, -3}}), IsNear(List{-13.0 / 9, -10.0 / 9, 11.0 / 3}, 1e-10));
}

//> Checked step by step
TEST_CASE("rows of up to ten unequal carts: as found pair by pair, with each impulse worked out by hand", "[2.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        std::vector<Cart> carts(std::size_t(dice.whole(2, 10)));
        for (Cart &cart : carts) cart = random_cart(dice);

        const std::vector<double> after = newtons_cradle(carts);

        std::vector<long double> want;
        for (const Cart &cart : carts) want.push_back(cart.velocity);
        for (std::size_t k = 0; k + 1 < want.size(); ++k) {
            if (want[k] - want[k + 1] <= 1e-14L) continue; // no more than rounding
            const long double j = 2 * (want[k] - want[k + 1]) / (1.0L / carts[k].mass + 1.0L / carts[k + 1].mass);
            want[k] -= j / carts[k].mass;
            want[k + 1] += j / carts[k + 1].mass;
            k = std::size_t(-1); // look again from the left
        }
        CHECK_THAT(after, IsNear(std::vector<double>(want.begin(), want.end()), 1e-9)); // ten digits of 20 m/s
    }
}

//>
TEST_CASE("a row comes to an end, although rounding can make neighbours approach again and again", "[2.6]") {
    using List = std::vector<double>;
    const double third = 1.0 / 3;
    // where carts end equally fast, one formula or another finds the left one faster, by the last digit, for ever
    CHECK_THAT(newtons_cradle({{1, 0}, {1, -1}, {1, -1}, {2, -1}, {2, -1}}),
               IsNear(List{-4 * third, -1, -1, -1, -third}, 1e-10));
    CHECK_THAT(newtons_cradle({{1, 3}, {5, 2}, {3, 1}}), IsNear(List{4 * third, 4 * third, 8 * third}, 1e-10));
    CHECK_THAT(newtons_cradle({{5, -1}, {1, 1}, {3, -3}}), IsNear(List{-7 * third, -7 * third, third}, 1e-10));
    CHECK_THAT(newtons_cradle({{4.5, 0.1}, {1.5, -0.1}, {6.2, 0.2}}), IsNear(List{0, 0.2, 0.2}, 1e-10));
}

//> Laws of a row
TEST_CASE("the carts of a row keep their momentum and their kinetic energy, and nobody approaches anybody", "[2.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        std::vector<Cart> carts(std::size_t(i == 0 ? 30 : dice.whole(2, 10)));
        for (Cart &cart : carts) cart = random_cart(dice);

        const std::vector<double> after = newtons_cradle(carts);

        CHECK_THAT(after, HasSize(carts.size()));
        double lost_momentum = 0, lost_energy = 0;
        for (std::size_t k = 0; k < carts.size(); ++k) {
            const auto &[mass, before] = carts[k];
            lost_momentum += mass * (before - after[k]);
            lost_energy += mass * (before * before - after[k] * after[k]) / 2;
            if (k > 0)
                CHECK_THAT(after[k - 1] - after[k], IsAtMost(1e-9).of("speed of approach of two neighbours [m/s]"));
        }
        CHECK_THAT(lost_momentum, IsNear(0.0, 1e-7).of("momentum lost [N s]"));   // ten digits of 1000 N s
        CHECK_THAT(lost_energy, IsNear(0.0, 1e-6).of("kinetic energy lost [J]")); // ten digits of 5000 J
    }
}

//>
TEST_CASE("in a row, masses from 1e-9 to 1e5 kg are allowed, velocities up to ±1e5 and tiny ones, and 300 carts",
          "[2.6]") {
    using List = std::vector<double>;
    CHECK_THAT(newtons_cradle({{1e5, 3}, {1e5, 0}, {1e5, 0}}), IsNear(List{0, 0, 3}, 1e-10));
    CHECK_THAT(newtons_cradle({{1e-9, 3}, {1e-9, 0}, {1e-9, 0}}), IsNear(List{0, 0, 3}, 1e-10));
    CHECK_THAT(newtons_cradle({{1e-100, 3}, {1e-100, 0}, {1e-100, 0}}), IsNear(List{0, 0, 3}, 1e-9)); // fewer digits
    CHECK_THAT(newtons_cradle({{1, 1e5}, {1, 0}, {1, -1e5}}), IsNear(List{-1e5, 0, 1e5}, 1e-10));
    const std::vector<double> slow = newtons_cradle({{1, 1e-9}, {1, 0}, {3, 0}});
    CHECK_THAT(slow, HasSize(3));
    CHECK_THAT(slow.back() * 1e9, IsNear(0.5, 1e-10).of("velocity of the last cart [1e-9 m/s]"));
    CHECK_THAT(newtons_cradle({{1, 1 + 1e-9}, {1, 1}}), IsNear(List{1, 1 + 1e-9}, 1e-10));
    List before(300), after(300);
    before.front() = after.back() = 3;
    CHECK_THAT(newtons_cradle(equal_carts(2, before)), IsNear(after, 1e-9));
}

TEST_CASE("a cart in a row with a mass of 0 or less is refused", "[2.6]") {
    CHECK_REFUSED(newtons_cradle({{2, 4}, {0, 0}, {3, -2}}));
    CHECK_REFUSED(newtons_cradle({{2, 4}, {3, -2}, {-1, 0}}));
    CHECK_REFUSED(newtons_cradle({{0, 1}}));
    CHECK_REFUSED(newtons_cradle({{2, -4}, {-1e-300, 2}}));
    newtons_cradle({{2, 4}, {3, -2}}); // good input is still answered
}
