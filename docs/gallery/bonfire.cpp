// A bonfire: it follows your finger, and while you press, the wind blows.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;

//> The sketch: a bonfire
struct Bonfire : Scene {
    std::vector<particles::Particle> embers;
    particles::Emission emission;
    course::Dice dice{11};

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void step(double dt) override {
        const particles::Emitter fire{hand.inside ? hand.at : Vec2{8, 1}, {0, 1}, 0.6, 0.9, 0.5, 2.8};
        std::vector<particles::Particle> newborn;
        emission = particles::emission_count(150, emission.remainder, dt);
        for (int i = 0; i < emission.count; ++i)
            newborn.push_back(particles::emit(fire, {dice.one(), dice.one(), dice.one(), dice.one(), dice.one()}));
        for (auto &ember : embers) // hot air rises, so gravity is negative
            if (const auto next = particles::step(ember, {-2, hand.down ? 4.0 : 0, 16, 9}, dt)) ember = *next;
            else ember.age = ember.life;
        embers = particles::compact_pool(embers, newborn, 400);
    }
    void draw(Canvas &canvas) const override {
        std::vector<Spark> young, old; // each ember is two lights, and lights add up
        for (const auto &[at, velocity, age, life] : embers) {
            const double part = age / life, flicker = course::chance(unsigned(1e6 * life), unsigned(10 * age));
            const double bright = (1 - part) * (0.4 + 0.6 * flicker);
            young.push_back({at, 0.13, bright * (1 - part)});
            old.push_back({at, 0.13, bright * part});
        }
        canvas.sparks(old, Colour::pink);
        canvas.sparks(young, Colour::amber);
    }
};
SKETCH(Bonfire, "A bonfire")
