// Land on the green platform, slower than 2 m/s: left and right tilt the lander, and up burns its fuel.
#include "chance.hpp"
#include "props.hpp"
#include "sketch.hpp"
using namespace demo;

struct Lander : Scene {
    static constexpr double gravity = 1.6, thrust = 4.5, height = 2.2; // [m/s²], [m/s²], of its middle [m]
    HeldKey left = held("left", "ArrowLeft"), engine = held("thrust", "ArrowUp"), right = held("right", "ArrowRight");
    std::vector<Vec2> ground;
    Vec2 platform{0, 0};
    motion::State ship{{0, 0}, {0, 0}};
    double angle = 0, burn = 0, fuel = 0, down = 0; // to the left [rad], 0 to 1, left [s], since it's on the ground [s]
    unsigned flight = 0;

    View view() const override { return {{0, 0}, {48, 27}, Stage::moon, 4}; }
    void begin() override {
        platform = {24 + 1.5 * std::floor(11 * course::chance(++flight, 0)), 3};
        ground = {{48, -1}, {0, -1}};
        for (unsigned i = 0; i <= 32; ++i)
            ground.push_back({1.5 * i, std::abs(1.5 * i - platform.x()) < 4 ? 3 : 2 + 5 * course::chance(flight, i)});
        ship = {{6, 20}, {6, 0}}, angle = burn = down = 0, fuel = 9;
    }
    Vec2 autopilot() const { // what acceleration brings it to the platform [m/s²]
        const Vec2 way = platform - ship.position;
        const double sink = std::abs(way.x()) > 3 ? 0.4 * (way.y() + 11) : 0.4 * way.y(); // [m/s]
        return 1.5 * (Vec2{std::clamp(0.5 * way.x(), -8.0, 8.0), sink} - ship.velocity) + Vec2{0, gravity};
    }
    Vec2 up() const { return {-std::sin(angle), std::cos(angle)}; }
    void step(double dt) override {
        if ((ship.position - Vec2{24, 9}).cwiseAbs().maxCoeff() > 24 || (down > 0 && (down += dt) > 3)) begin();
        if (down > 0) return;
        const Vec2 push = autopilot();
        const double tilt = untouched ? std::atan2(-push.x(), std::max(push.y(), 1.5)) : 0.6 * (left - right);
        angle += 4 * dt * (tilt - angle);
        burn = fuel <= 0 ? 0 : untouched ? std::clamp(push.dot(up()) / thrust, 0.0, 1.0) : engine;
        fuel -= burn * dt;
        ship = motion::accelerated_motion(ship, burn * thrust * up() - Vec2{0, gravity}, dt);
        const segment_intersection::Segment body{ship.position, ship.position - height * up()};
        for (std::size_t i = 3; i < ground.size(); ++i)
            if (segment_intersection::segments_intersect(body, {ground[i - 1], ground[i]})) down = dt;
    }
    void draw(Canvas &canvas) const override {
        const auto &[at, velocity] = ship;
        if (down == 0 && at.y() > 0) canvas.dots(trajectories::dotted_arc(ship, gravity, 0.4), 0.13, Colour::amber);
        canvas.body(ground, Colour::dim);
        canvas.bar({platform - Vec2{2.7, 0}, platform + Vec2{2.7, 0}}, Colour::green, 9);
        const bool good = velocity.norm() < 2 && std::abs(at.x() - platform.x()) < 2.7;
        if (down > 0 && !good)
            for (const double speed : {1.5, 3.0, 5.0})
                for (const Vec2 &flies : particles::ring_burst(24, speed, speed))
                    canvas.lamp(at + down * flies, 0.7 / (1 + down), Colour::orange);
        else demo::ship(canvas, at, up(), 4, Colour::orange, down > 0 ? 0 : burn);
        canvas.bar({at + Vec2{-1.5, 2.8}, at + Vec2{0.35 * fuel - 1.5, 2.8}}, Colour::blue, 6); // what's left
        const Vec2 above{std::clamp(at.x(), 4.0, 44.0), at.y() + 4};
        canvas.plate(above, number(velocity.norm(), 1, "m/s"), good ? Colour::green : Colour::pink);
    }
};
SKETCH(Lander, "A lander on the moon")
