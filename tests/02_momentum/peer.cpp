// needs box2d box2d::box2d libbox2d-dev
// Box2D computes in float, with seven digits, so that is how far apart we are.
#include "../peers/peer.hpp"
#include "../peers/box2d.hpp"
#include "momentum.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using course::Vec2, course::worse;
using namespace momentum;

namespace {

constexpr int cases = 100000; // in each comparison
constexpr float dt = 1e-4f;   // so short that nothing moves far [s]

/// A random number that a float holds.
double real(Dice &dice, double low, double high) { return double(float(dice.real(low, high))); }

/// Two discs that touch, on a straight line, without gravity and friction.
struct Collision final : b2ContactListener {
    Collision(const Body &a_, const Body &b_, double restitution) {
        world.SetContinuousPhysics(false);
        world.SetContactListener(this);
        a = add(a_, 0, restitution);
        b = add(b_, 0.999f, restitution);
        world.Step(dt, 8, 3);
    }

    b2Body *add(const Body &body, float x, double restitution) {
        b2BodyDef definition;
        definition.type = body.inverse_mass > 0 ? b2_dynamicBody : b2_kinematicBody;
        definition.position = {x, 0};
        definition.linearVelocity = {float(body.velocity), 0};
        definition.fixedRotation = true;
        b2Body *added = world.CreateBody(&definition);

        b2CircleShape disc;
        disc.m_radius = 0.5f;
        b2FixtureDef fixture;
        fixture.shape = &disc;
        fixture.friction = 0;
        fixture.restitution = float(restitution);
        fixture.restitutionThreshold = 0; // else slow bodies do not bounce
        added->CreateFixture(&fixture);
        const b2MassData mass{float(1 / body.inverse_mass), {0, 0}, 0};
        if (body.inverse_mass > 0) added->SetMassData(&mass);
        return added;
    }

    void PostSolve(b2Contact *, const b2ContactImpulse *solved) override {
        impulse = double(solved->normalImpulses[0]);
    }

    b2World world{{0, 0}};
    b2Body *a, *b;
    double impulse = 0; ///< [N s]
};

/// How far apart the velocities are, of the largest velocity before or after.
double part_of_largest(const Velocities &got, const Collision &want, const Cart &a, const Cart &b) {
    const double want_a = double(want.a->GetLinearVelocity().x), want_b = double(want.b->GetLinearVelocity().x);
    const double largest = std::max({std::abs(a.velocity), std::abs(b.velocity), std::abs(want_a), std::abs(want_b)});
    return worse(std::abs(got.a - want_a), std::abs(got.b - want_b)) / largest;
}

Cart any_cart(Dice &dice) { return {real(dice, 0.1, 100), real(dice, -50, 50)}; }
Body body_of(const Cart &cart) { return {1 / cart.mass, cart.velocity}; }

double compare_accelerations(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double mass = real(dice, 0.1, 100);
        b2World world{{0, 0}};
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        b2Body *body = world.CreateBody(&definition);
        const b2MassData data{float(mass), {0, 0}, 0};
        body->SetMassData(&data);

        std::vector<Vec2> forces;
        double all = 0;
        for (int count = dice.whole(1, 6); count > 0; --count) {
            forces.emplace_back(real(dice, -10, 10), real(dice, -10, 10));
            body->ApplyForceToCenter({float(forces.back().x()), float(forces.back().y())}, true);
            all += forces.back().norm();
        }
        world.Step(dt, 8, 3);
        const Vec2 want = Vec2{body->GetLinearVelocity().x, body->GetLinearVelocity().y} / double(dt);
        largest = worse((acceleration_due_to(forces, mass) - want).norm() / (all / mass), largest);
    }
    return largest;
}

double compare_elastic_collisions(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Cart a = any_cart(dice), b = any_cart(dice);
        largest = worse(part_of_largest(elastic_collision(a, b), {body_of(a), body_of(b), 1}, a, b), largest);
    }
    return largest;
}

double compare_collisions(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Cart a = any_cart(dice), b = any_cart(dice);
        const double restitution = real(dice, 0, 1);
        largest =
            worse(part_of_largest(collide(a, b, restitution), {body_of(a), body_of(b), restitution}, a, b), largest);
    }
    return largest;
}

/// Bodies that approach each other slower than 1 m/s are left out: of their impulse, float keeps too little. Of half of
/// the pairs one cannot be moved, but may move by itself.
double compare_impulses(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        Body a = body_of(any_cart(dice)), b = body_of(any_cart(dice));
        if (i % 4 == 0) a.inverse_mass = 0;
        if (i % 4 == 1) b.inverse_mass = 0;
        if (const double approach = a.velocity - b.velocity; approach > 0 && approach < 1) continue;
        const double restitution = real(dice, 0, 1), want = Collision{a, b, restitution}.impulse;
        const double got = impulse(a, b, restitution);
        largest = worse(got == want ? 0 : std::abs(got - want) / std::max(got, want), largest);
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv, "Compared with " + course::box2d_name() + " in 32-bit numbers, 100000 random cases each",
        {{"acceleration_due_to: of the forces' sizes, added up and divided by the mass", compare_accelerations},
         {"elastic_collision: of the largest velocity", compare_elastic_collisions},
         {"collide: of the largest velocity", compare_collisions},
         {"impulse, walls among them, at 1 m/s or more: of itself", compare_impulses}});
}
