// A marble run: drag the ends of the ramps, so that all marbles fall into the pail; each comes again above.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;
using nt_collisions::Ball, segment_intersection::Segment;

struct Marbles : Scene {
    static constexpr double radius = 0.22, tick = 1.0 / 240; // [m], a step [s]
    static constexpr Colour colours[]{Colour::blue, Colour::pink, Colour::amber, Colour::violet};
    const Vec2 low{0.2, 0.5}, high{15.8, 8.4};
    Handle ends[6]{handle({0.2, 8.1}, low, high), handle({9, 7.2}, low, high),   handle({15.8, 6.6}, low, high),
                   handle({6.2, 4.8}, low, high), handle({0.2, 4.1}, low, high), handle({8.3, 2.9}, low, high)};
    const std::vector<Vec2> pegs{{9.6, 2.3}, {11, 2.3}, {12.4, 2.3}, {13.8, 2.3}, {10.3, 1.7}, {11.7, 1.7}};
    std::vector<Ball> marbles;
    course::Dice dice{3};
    int caught = 0;

    View view() const override { return {{-0.25, 0}, {16.25, 9.28}, Stage::felt}; }
    double step_time() const override { return tick; }
    void begin() override {
        for (int i = 0; i < 20; ++i) marbles.push_back({{1 + 0.42 * i, 8.7}, {0, 0}, radius, 1});
    }
    void step(double) override {
        for (Ball &marble : marbles) move(marble);
        for (std::size_t i = 0; i < marbles.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if ((marbles[i].position - marbles[k].position).norm() < 2 * radius) meet(marbles[i], marbles[k]);
    }
    void move(Ball &marble) {
        const Vec2 before = marble.position;
        marble.velocity.y() -= 6 * tick;
        marble.velocity = reflection::bounce_in_box({before, marble.velocity, radius}, {{0, -9}, {16, 99}});
        marble.position += tick * marble.velocity;
        for (int i = 0; i < 6; i += 2) bounce(marble, before, {ends[i], ends[i + 1]}, 0.12);
        for (const Vec2 &peg : pegs) bounce(marble, before, {peg, peg}, 0.15);
        if (marble.position.y() > -radius) return;
        if (std::abs(marble.position.x() - 10.7) < 1.6) ++caught;
        marble = {{1.5 + 2 * dice.one(), 9.6 + dice.one()}, {0, 0}, radius, 1};
    }
    static void bounce(Ball &marble, const Vec2 &before, const Segment &wall, double thick) {
        const auto impact = segment_intersection::time_of_impact({before, marble.position}, radius + thick, wall);
        if (!impact) return;
        marble.velocity = reflection::bounce(marble.velocity, impact->centre - impact->point, {0.5, 0});
        marble.position = impact->centre + tick * marble.velocity;
    }
    static void meet(Ball &a, Ball &b) {
        const auto [a_apart, b_apart] = nt_collisions::push_apart({a.position, radius, 1}, {b.position, radius, 1});
        a.position = a_apart, b.position = b_apart;
        const auto [a_after, b_after] = nt_collisions::resolve_collision(a, b, 0.6);
        a.velocity = a_after, b.velocity = b_after;
    }
    void draw(Canvas &canvas) const override {
        for (int i = 0; i < 6; i += 2) canvas.bar({ends[i], ends[i + 1]}, Colour::wood, 10);
        for (const Vec2 &peg : pegs) canvas.lamp(peg, 0.15, Colour::amber);
        for (std::size_t i = 0; i < marbles.size(); ++i) canvas.ball(marbles[i].position, radius, colours[i % 4]);
        canvas.body({{9, 1.1}, {9.2, 0}, {12.2, 0}, {12.4, 1.1}}, Colour::orange);
        canvas.plate({10.7, 0.45}, number(caught, 0), Colour::amber, 28);
    }
};
SKETCH(Marbles, "A marble run")
