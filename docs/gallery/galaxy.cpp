// Two galaxies meet: press where the small one is to start, pull to where it's to fly, and let go.
#include "chance.hpp"
#include "sketch.hpp"
using namespace demo;
using motion::State;

struct Galaxies : Scene {
    static constexpr unsigned count = 2000;
    static constexpr double mu[]{500, 1000}, radius[]{6.5, 11}; // of the small and the large one [m³/s²], [m]
    std::vector<State> stars{count, {{0, 0}, {0, 0}}};          // the first two are the cores, which pull
    double time = 0;                                            // since they were let go [s]

    static unsigned galaxy_of(unsigned star) { return star % 3 == 0 ? 0 : 1; }
    Vec2 pull(unsigned galaxy, const Vec2 &at) const {
        return gravity_wells::softened_gravity(at - stars[galaxy].position, mu[galaxy], 1.5);
    }
    View view() const override { return {{-32, -18}, {32, 18}, Stage::night}; }
    void begin() override {
        press({-14, 8});
        release({-15, 1});
    }
    void press(const Vec2 &at) override { // their centre of mass is in the middle of the picture
        stars[0] = {at, {0, 0}};
        stars[1] = {-0.5 * at, {0, 0}};
        for (unsigned i = 2; i < count; ++i) stars[i] = new_star(i);
        time = 0;
    }
    void release(const Vec2 &at) override { // ... and stays there
        const Vec2 push = 0.5 * (at - stars[0].position);
        for (unsigned i = 0; i < count; ++i) stars[i].velocity += galaxy_of(i) == 0 ? push : -0.5 * push;
    }
    State new_star(unsigned i) const { // in one of two arms, and so fast that it stays on a circle
        const unsigned galaxy = galaxy_of(i);
        const double r = radius[galaxy] * (0.04 + 0.96 * i / count), off = course::chance(1, i) * course::chance(2, i);
        const double angle = i % 2 * std::numbers::pi + 3 * std::log(r) + 2.2 * off;
        const Vec2 out{std::cos(angle), std::sin(angle)}, place = stars[galaxy].position + r * out;
        const double mass = pull(galaxy, place).norm() * r * r; // of a point that would pull as hard
        return {place, gravity_wells::circular_orbit_speed(mass, r, 1) * Vec2{-out.y(), out.x()}};
    }
    void step(double dt) override {
        if (hand.down) return;
        for (State &star : stars) star.velocity += dt * (pull(0, star.position) + pull(1, star.position));
        for (State &star : stars) star.position += dt * star.velocity;
        if ((time += dt) > 12) begin();
    }
    void draw(Canvas &canvas) const override {
        std::vector<Spark> near[2], far[2]; // those that were near their core, and far from it
        for (unsigned i = 0; i < count; ++i) {
            const Spark light{stars[i].position, i < 2 ? 1.8 : 0.1 + 0.12 * course::chance(3, i), i < 2 ? 1 : 0.7};
            (i < 360 ? near : far)[galaxy_of(i)].push_back(light);
        }
        canvas.sparks(far[0], Colour::pink);
        canvas.sparks(far[1], Colour::blue);
        canvas.sparks(near[0], Colour::orange);
        canvas.sparks(near[1], Colour::amber);
        if (hand.down && (hand.at - stars[0].position).norm() > 1)
            canvas.arrow(stars[0].position, hand.at, Colour::green, 4);
    }
};
SKETCH(Galaxies, "Two galaxies meet")
