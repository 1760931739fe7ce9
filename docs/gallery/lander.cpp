// Land on the platform, and softly: below 2 m/s. Thrust with the arrow keys before the fuel is gone.
#include "chance.hpp"
#include "props.hpp"
#include "sketch.hpp"
using namespace demo;

struct Lander : Scene {
    HeldKey left = held("left", "ArrowLeft"), thrust = held("thrust", "ArrowUp"), right = held("right", "ArrowRight");
    std::vector<Vec2> ground;
    motion::State ship{{6, 30}, {6, 0}};
    Vec2 push{0, 0};  // of the engines [m/s²]
    double fuel = 10; // [s] of thrust
    double down = 0;  // since it touched the ground [s]
    bool good = false;

    View view() const override { return {{0, 0}, {64, 36}, Stage::night}; }
    void begin() override {
        for (unsigned i = 0; i <= 32; ++i) ground.push_back({2.0 * i, i / 4 == 5 ? 4 : 2 + 9 * course::chance(3, i)});
        ground.insert(ground.end(), {{64, -1}, {0, -1}}); // below what's seen
    }
    void take_over() override { start(); }
    void start() {
        ship = {{6, 30}, {6, 0}};
        fuel = 10;
        down = 0;
    }
    /// Until somebody plays: to the platform, and slower the lower it is.
    Vec2 autopilot() const {
        const double wanted = std::clamp(0.3 * (43 - ship.position.x()), -6.0, 6.0);
        const bool too_fast = ship.velocity.y() < -0.6 - 0.2 * (ship.position.y() - 5);
        return {std::clamp(4 * (wanted - ship.velocity.x()), -2.0, 2.0), too_fast ? 5.0 : 0.0};
    }
    void step(double dt) override {
        if (down > 0) return (down += dt) > 3 ? start() : void();
        push = untouched ? autopilot() : Vec2{2.0 * (right - left), 5.0 * thrust};
        if (fuel <= 0) push = {0, 0};
        if (push.y() > 0) fuel -= dt;
        const Vec2 legs{0, -1.7}, before = ship.position + legs;
        ship = motion::accelerated_motion(ship, push - Vec2{0, 1.62}, dt);
        for (std::size_t i = 0; i < 32; ++i)
            if (segment_intersection::segments_intersect({before, ship.position + legs}, {ground[i], ground[i + 1]})) {
                good = i >= 20 && i < 23 && ship.velocity.norm() < 2;
                down = dt;
            }
        if (std::abs(ship.position.x() - 32) > 34 || std::abs(ship.position.y()) > 60) start();
    }

    void draw(Canvas &canvas) const override {
        canvas.body(ground, Colour::dim);
        canvas.bar({ground[20], ground[23]}, Colour::green, 8);
        canvas.bar({{2, 2}, {2 + 1.4 * std::max(fuel, 0.1), 2}}, fuel > 3 ? Colour::green : Colour::pink, 10);
        const std::string speed = number(ship.velocity.norm(), 1, "m/s");
        if (down > 0) canvas.plate({32, 22}, (good ? "landed at " : "crash: ") + speed, Colour::amber, 36);
        if (down > 0 && !good)
            for (const Vec2 &flies : particles::ring_burst(24, 9, 0.1))
                canvas.lamp(ship.position + down * flies, 0.5 / (1 + down), Colour::orange);
        if (down > 0 && !good) return;
        if (push.x() != 0) canvas.beam({ship.position, ship.position - Vec2{1.5 * push.x(), 0}}, Colour::amber, 5);
        demo::ship(canvas, ship.position, {0, 1}, 4, Colour::blue, down > 0 ? 0 : push.y() / 5);
        if (down == 0) canvas.plate(ship.position + Vec2{0, 3.6}, speed, Colour::ink, 22);
    }
};
SKETCH(Lander, "A lander on the moon")
