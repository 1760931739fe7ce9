// A marble run: drag the ends of the ramps, and lose as few marbles as you can.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;
using particles::Particle, particles::Wall;

struct Marbles : Scene {
    static constexpr double radius = 0.2; // [m]
    const Vec2 low{0.5, 0.5}, high{15.5, 8.5};
    Handle ramps[3][2]{{handle({1, 7.9}, low, high), handle({7, 7}, low, high)},
                       {handle({15, 6.8}, low, high), handle({5, 4.6}, low, high)},
                       {handle({0.7, 4.3}, low, high), handle({8.8, 2.3}, low, high)}};
    std::vector<Particle> marbles;
    course::Dice dice{3};
    double wait = 0; // until the next marble [s]
    int in_cup = 0, lost = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    /// A wall stops what comes from its left, as you walk from its start to its end: so it begins at the left.
    std::vector<Wall> walls() const {
        std::vector<Wall> all{{{10.9, 1.6}, {11.1, 0}}, {{13.1, 0}, {13.3, 1.6}}}; // the cup's
        for (const auto &[a, b] : ramps)
            if ((b.at() - a.at()).norm() > 0.1) all.push_back(a.at().x() < b.at().x() ? Wall{a, b} : Wall{b, a});
        return all;
    }
    void step(double dt) override {
        if ((wait -= dt) <= 0 && marbles.size() < 40) {
            marbles.push_back({{2 + 0.5 * dice.one(), 9.2}, {0, 0}, 0, 60});
            wait = 0.6;
        }
        const std::vector<Wall> all = walls();
        for (Particle &marble : marbles) {
            marble.velocity.y() -= 6 * dt;
            marble = particles::move_and_collide(marble, all, 0.3, dt);
            if (marble.position.y() > 0) continue;
            ++(std::abs(marble.position.x() - 12.1) < 1 ? in_cup : lost);
            marble.age = marble.life;
        }
        std::erase_if(marbles, [](const Particle &each) { return each.age >= each.life; });
        for (std::size_t i = 0; i < marbles.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) meet(marbles[i], marbles[k]);
    }
    static void meet(Particle &a, Particle &b) {
        const double distance = (a.position - b.position).norm();
        if (distance > 2 * radius || distance == 0) return;
        const nt_collisions::Velocities after = nt_collisions::resolve_collision(
            {a.position, a.velocity, radius, 1}, {b.position, b.velocity, radius, 1}, 0.5);
        a.velocity = after.a;
        b.velocity = after.b;
    }

    void draw(Canvas &canvas) const override {
        for (const auto &[a, b] : ramps) canvas.bar({a, b}, Colour::wood, 10);
        canvas.bar({{10.9, 1.6}, {11.1, 0.1}, {13.1, 0.1}, {13.3, 1.6}}, Colour::dim, 8);
        std::vector<Vec2> centres;
        for (const Particle &marble : marbles) centres.push_back(marble.position + Vec2{0, radius + 0.1});
        canvas.balls(centres, radius, Colour::blue);
        canvas.plate({12.1, 0.6}, number(in_cup, 0), Colour::green, 26);
        canvas.text({1, 0.4}, number(lost, 0, "lost"), Colour::pink, 22);
    }
};
SKETCH(Marbles, "A marble run")
