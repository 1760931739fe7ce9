// Fireworks above a river: a shell flies to where you press, and bursts there. Hold the press down for more of them.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;
using particles::Particle, motion::uniform_motion;

struct Fireworks : Scene {
    static constexpr double gravity = 9.81, speed = 33, bank = 10; // [m/s²], of a shell [m/s], how high the town is [m]
    static constexpr Colour colours[]{Colour::amber, Colour::pink, Colour::blue, Colour::green, Colour::violet};
    std::vector<Particle> all[6]; // stars of five colours, and the shells
    course::Dice dice{12};
    double wait = 0; // until the next shell [s]

    View view() const override { return {{0, 0}, {96, 54}, Stage::skyline, bank}; }
    void begin() override { burst({30, 38}); }
    void fire(const Vec2 &target) {
        const Vec2 muzzle{target.x() - 6, bank};
        const std::vector<double> angles = trajectories::launch_angles(speed, target - muzzle, gravity);
        if (angles.empty()) return; // it's too high
        const Vec2 velocity = trajectories::launch_velocity(speed, angles[0]);
        all[5].push_back({muzzle, velocity, 0, std::clamp(6 / velocity.x(), 0.1, 5.0)}); // then it bursts
        wait = hand.down ? 0.2 : 0.4;
    }
    void burst(const Vec2 &at) {
        const unsigned kind = dice.roll() >> 16;
        std::vector<double> numbers;
        for (int i = 0; i < 180; ++i) numbers.push_back(dice.one());
        for (const Vec2 &flies : kind % 4 == 1 ? particles::ring_burst(60, 19, 0) : particles::disc_burst(numbers, 22))
            all[kind % 5].push_back({at, flies, 0, 1.2 + 1.4 * dice.one()});
        for (const Vec2 &flies : particles::ring_burst(20, 8, 0)) all[(kind + 2) % 5].push_back({at, flies, 0, 1.5});
    }
    void step(double dt) override {
        wait -= dt;
        if (wait <= 0 && hand.down) fire(hand.at);
        if (wait <= 0 && untouched) fire({14 + 68 * dice.one(), 28 + 17 * dice.one()});
        for (unsigned i = 0; i < 6; ++i) {
            const std::vector<Particle> before = all[i];
            all[i].clear();
            for (const Particle &each : before)
                if (auto later = particles::step(each, {i < 5 ? 4 : gravity, 0, 96, 54}, dt)) {
                    if (i < 5) later->velocity *= std::exp(-1.2 * dt); // air slows stars down
                    all[i].push_back(*later);
                } else if (i == 5) burst(each.position);
        }
    }
    void draw(Canvas &canvas) const override {
        for (unsigned i = 0; i < 6; ++i) {
            std::vector<Spark> lights;
            for (const auto &[at, velocity, age, life] : all[i]) {
                const double left = 1 - age / life, depth = 0.22 * (at.y() - bank); // of its mirror image in the river
                for (const double ago : {0.0, 0.05, 0.1})                           // it has a tail
                    lights.push_back({uniform_motion(at, velocity, -ago), 0.55 - 2 * ago, left});
                lights.push_back({{at.x() + 0.4 * std::sin(9 * age + depth), bank - depth}, 0.5, 0.4 * left});
            }
            canvas.sparks(lights, colours[i % 5]);
        }
    }
};
SKETCH(Fireworks, "Fireworks above a river")
