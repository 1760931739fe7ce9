// needs GSL GSL::gsl libgsl-dev
// needs box2d box2d::box2d libbox2d-dev
// GSL moves things with an integrator of its own, and finds when they stop by a search for a root.
// Box2D is an engine: it holds boxes on slopes, or lets them slide, in floats and with one coefficient of friction.
#include "../peers/peer.hpp"
#include "../peers/box2d.hpp"
#include "../peers/gsl.hpp"
#include "inclined_planes.hpp"

#include <gsl/gsl_version.h>

#include <array>
#include <cmath>
#include <numbers>

using course::moved, course::root_of, course::Vec2, course::worse;
using namespace inclined_planes;

namespace {

constexpr int cases = 20000; // in each comparison, or a hundredth of them where GSL takes many steps
constexpr double g = 9.8;

Box random_box(Dice &dice) {
    const double mu_k = dice.real(0.05, 1);
    return {dice.real(0.1, 100), mu_k + dice.real(0, 0.5), mu_k};
}

/// Two numbers, and how fast each of them changes.
using Pair = std::array<double, 2>;
using Slopes = course::Slopes<2>;

double compare_distances(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const double speed = dice.real(1, 20), loss = dice.real(0.5, 10);
        const Slopes slopes = [&](const Pair &now) { return Pair{now[1], -loss}; };
        const double t = root_of([&](double end) { return moved({0, speed}, slopes, end)[1]; }, 1e-3, 50);
        largest = worse(course::difference(stopping_distance(speed, loss), moved({0, speed}, slopes, t)[0]), largest);
    }
    return largest;
}

/// The acceleration of a box on a slope, in its second second. The slope is level, and gravity is turned instead.
double engine_acceleration(double mu, double angle, double gravity) {
    b2World world{{float(gravity * std::sin(angle)), float(-gravity * std::cos(angle))}};
    b2BodyDef at_rest;
    b2EdgeShape slope;
    slope.SetTwoSided({-100, 0}, {1000, 0});
    b2FixtureDef below;
    below.shape = &slope;
    below.friction = float(mu);
    world.CreateBody(&at_rest)->CreateFixture(&below);

    b2BodyDef movable;
    movable.type = b2_dynamicBody;
    movable.position = {0, 0.25f};
    movable.fixedRotation = true;
    movable.allowSleep = false;
    b2PolygonShape shape;
    shape.SetAsBox(0.5f, 0.25f);
    b2Body *box = world.CreateBody(&movable);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = float(mu);
    box->CreateFixture(&fixture);

    const auto one_second = [&] {
        for (int frame = 0; frame < 60; ++frame) world.Step(1 / 60.0f, 8, 3);
        return double(box->GetLinearVelocity().x);
    };
    const double before = one_second();
    return one_second() - before;
}

double compare_slopes(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const double mu = dice.real(0.05, 1), angle = dice.real(0, 1.3), gravity = dice.real(5, 15);
        if (std::abs(std::tan(angle) - mu) < 1e-3) continue; // held or not, by rounding
        const double want = engine_acceleration(mu, angle, gravity);
        largest = worse(std::abs(incline_acceleration({1, mu, mu}, angle, gravity) - want), largest);
    }
    return largest;
}

double compare_angles(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double mu_s = dice.real(0.01, 3);
        const double want =
            root_of([&](double angle) { return std::sin(angle) - mu_s * std::cos(angle); }, 0, std::numbers::pi / 2);
        largest = worse(std::abs(critical_angle(mu_s) - want), largest);
    }
    return largest;
}

/// Friction as an acceleration against the velocity, whatever its direction.
double compare_tables(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const Vec2 velocity = dice.real(3, 10) * dice.direction();
        const double loss = dice.real(0, 5), dt = dice.real(0.01, 0.5);
        const Slopes slopes = [&](const Pair &v) {
            const double speed = std::hypot(v[0], v[1]);
            return Pair{-loss * v[0] / speed, -loss * v[1] / speed};
        };
        const Pair want = moved({velocity.x(), velocity.y()}, slopes, dt);
        largest = worse((table_friction(velocity, loss, dt) - Vec2{want[0], want[1]}).norm(), largest);
    }
    return largest;
}

/// Up until it rests; if it then slips, down until it is back.
double compare_climbs(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const Box box = random_box(dice);
        const double speed = dice.real(1, 20), angle = dice.real(0.05, 1.5);
        const double pull = g * std::sin(angle), press = g * std::cos(angle);
        const Slopes up = [&](const Pair &now) { return Pair{now[1], -pull - box.mu_k * press}; };
        const double t = root_of([&](double end) { return moved({0, speed}, up, end)[1]; }, 1e-3, 50);
        const double top = moved({0, speed}, up, t)[0];

        const Slopes down = [&](const Pair &now) { return Pair{now[1], -pull + box.mu_k * press}; };
        const auto falling = [&](double end) { return moved({top, 0}, down, end); };
        const bool slips = pull > box.mu_s * press;
        const double back = slips ? -falling(root_of([&](double end) { return falling(end)[0]; }, 1e-3, 1000))[1] : 0;

        const UpAndBack got = up_and_back(box, speed, angle, g);
        largest = worse(course::difference(got.up, top), largest);
        largest = worse(std::abs(got.back - back) / speed, largest);
    }
    return largest;
}

/// A block that sticks first: how long it slips then, and how far it gets, in frames and by GSL.
double compare_slips(Dice &dice) {
    double largest = 0;
    constexpr double dt = 1e-4;
    for (int i = 0; i < 20; ++i) {
        const Box box{2, dice.real(0.45, 0.6), dice.real(0.2, 0.35)};
        const Spring spring{dice.real(10, 40), dice.real(0.05, 0.3)};
        const double holds = box.mu_s * box.mass * g / spring.stiffness;
        const Slopes slopes = [&](const Pair &now) { // stretch and velocity
            return Pair{spring.speed - now[1], spring.stiffness * now[0] / box.mass - box.mu_k * g};
        };
        const auto slipped = [&](double t) { return moved({holds, 0}, slopes, t); };
        const double t = root_of([&](double end) { return slipped(end)[1]; }, 0.1, // not its beginning, at rest, too
                                 1.9 * std::numbers::pi * std::sqrt(box.mass / spring.stiffness));
        const double jump = holds + spring.speed * t - slipped(t)[0];

        Pulled now{0, 0, holds + 1e-9};
        double time = 0;
        do {
            now = stick_slip_step(now, box, spring, g, dt);
            time += dt;
        } while (now.velocity > 0);
        largest = worse(std::abs(time - t), largest);
        largest = worse(std::abs(now.position - jump), largest);
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv,
        "Compared with GSL " GSL_VERSION " and " + course::box2d_name()
            + ", 20000 random cases each, 200 with *, 20 with **",
        {{"stopping_distance*: moved until it rests, of itself", compare_distances},
         {"incline_acceleration*: a box in Box2D, held or sliding, in floats [m/s²]", compare_slopes},
         {"critical_angle: by a search for a root [rad]", compare_angles},
         {"table_friction*: slowed down by an integrator [m/s]", compare_tables},
         {"up_and_back*: moved until it rests, and back, of itself and of the speed", compare_climbs},
         {"stick_slip_step**, in frames of 0.1 ms: one slip, in seconds and metres", compare_slips}});
}
