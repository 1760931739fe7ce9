// Fireworks over a town: press where a shell is to burst.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;
using particles::Particle;

struct Fireworks : Scene {
    static constexpr double gravity = 9.81; // [m/s²]
    static constexpr Colour colours[]{Colour::amber, Colour::pink, Colour::blue, Colour::green, Colour::violet};
    std::vector<motion::State> shells;
    std::vector<Particle> stars[5]; // of each colour
    course::Dice dice{12};
    double wait = 0; // until the next shell flies by itself [s]
    unsigned count = 0;

    View view() const override { return {{0, 0}, {96, 54}, Stage::skyline, 4}; }
    void begin() override { burst({48, 42}); }
    void press(const Vec2 &at) override {
        const double speed = std::sqrt(2 * gravity * std::max(at.y() - 4, 6.0)); // so that it's highest there
        if (shells.size() < 12) shells.push_back({{at.x(), 4}, trajectories::launch_velocity(speed, 90)});
    }
    void step(double dt) override {
        wait -= dt;
        if (untouched && wait <= 0) {
            press({12 + 72 * dice.one(), 41 + 8 * std::sin(double(count))});
            wait = 0.6;
        }
        for (motion::State &shell : shells) {
            shell = motion::accelerated_motion(shell, {0, -gravity}, dt);
            if (shell.velocity.y() <= 0) burst(shell.position);
        }
        std::erase_if(shells, [](const motion::State &shell) { return !(shell.velocity.y() > 0); });
        for (std::vector<Particle> &all : stars) {
            for (Particle &star : all) {
                star.velocity = std::exp(-0.9 * dt) * star.velocity - Vec2{0, 3 * dt}; // air, and gravity
                star.position += dt * star.velocity;
                star.age += dt;
            }
            std::erase_if(all, [](const Particle &star) { return star.age > star.life; });
        }
    }
    void burst(const Vec2 &at) {
        std::vector<double> numbers(200);
        for (double &each : numbers) each = dice.one();
        const bool ring = count % 3 == 0;
        for (const Vec2 &flies : ring ? particles::ring_burst(48, 15, 0) : particles::disc_burst(numbers, 18))
            stars[count % 5].push_back({at, flies, 0, 1.3 + 1.2 * dice.one()});
        ++count;
    }

    void draw(Canvas &canvas) const override {
        for (std::size_t i = 0; i < 5; ++i) {
            std::vector<Spark> lights;
            for (const Particle &star : stars[i])
                for (const double ago : {0.0, 0.06, 0.12}) // it has a tail
                    lights.push_back({star.position - ago * star.velocity, 0.6 - 3 * ago, 1 - star.age / star.life});
            canvas.sparks(lights, colours[i]);
        }
        for (const auto &[at, velocity] : shells) canvas.beam({at, at - 0.12 * velocity}, Colour::amber, 3);
    }
};
SKETCH(Fireworks, "Fireworks over a town")
