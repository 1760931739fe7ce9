#include "sketch.hpp"
#include <deque>
#include <random>
using namespace demo;
using particles::Particle;

struct Train : Scene {
    Slider speed = slider("speed", "m/s", 1, 8, 0.5, 4);
    Slider wind = slider("wind", "m/s", -3, 3, 0.25, 1);

    static constexpr double gap = 0.1;      // between two points of the track [m]
    static constexpr double coach = 1.5;    // one car with its coupling [m]
    static constexpr int cars = 6;          // with the engine
    static constexpr double tightest = 1.7; // radius of a curve [m]

    std::size_t laid = 0;   // points of the track so far
    std::deque<Vec2> track; // front first, every `gap`
    Vec2 head{9, 4};
    double heading = 0; // [rad]
    double now = 0, v = 0, puff = 0;
    std::vector<Particle> smoke;
    std::vector<Vec2> trees;
    std::mt19937 dice{7};

    View view() const override { return {{0, 0}, {24, 13.5}, Stage::night}; }

    void begin() override {
        while (trees.size() < 18) trees.push_back({random(0.5, 23.5), random(0.5, 13)});
        for (int i = 0; i < 160; ++i) track.push_back(head - Vec2{i * gap, 0});
    }
    double random(double low, double high) { return std::uniform_real_distribution<double>{low, high}(dice); }

    Vec2 goal() const {
        if (hand.inside) return hand.at;
        return {12 + 8 * std::cos(0.4 * now), 6.75 + 4 * std::sin(0.8 * now)};
    }
    // A point so far behind the engine's front, along the track.
    Vec2 along(double back) const {
        double left = back - (head - track.front()).norm();
        if (left <= 0) return head;
        const std::size_t i = static_cast<std::size_t>(left / gap);
        if (i + 1 >= track.size()) return track.back();
        const double part = left / gap - static_cast<double>(i);
        return (1 - part) * track[i] + part * track[i + 1];
    }
    Button whistle = button("w", "Whistle", [this] { blow(); });
    void blow() {
        for (const Vec2 &velocity : particles::ring_burst(24, 3, 0)) smoke.push_back({along(0.35), velocity, 0, 2});
    }
    void press(const Vec2 &) override { blow(); }
    void step(double dt) override {
        now += dt;
        const Vec2 way = goal() - head;
        const double wanted = std::min<double>(speed, 2 * std::max(way.norm() - 0.6, 0.0));
        v += std::clamp(wanted - v, -6 * dt, 3 * dt);
        const double off = std::remainder(std::atan2(way.y(), way.x()) - heading, 2 * std::numbers::pi);
        heading += std::clamp(off, -v / tightest * dt, v / tightest * dt);
        head += v * dt * Vec2{std::cos(heading), std::sin(heading)};
        while ((head - track.front()).norm() >= gap) {
            track.push_front(track.front() + gap * (head - track.front()).normalized());
            ++laid;
        }
        while (track.size() > 400) track.pop_back();

        puff += std::max(v, 0.7) * dt;
        while (puff > 0.22) {
            puff -= 0.22;
            const Vec2 chimney = along(0.35);
            smoke.push_back(
                {chimney,
                 Vec2{random(-0.3, 0.3), random(0.1, 0.6)} + 0.25 * v * Vec2{std::cos(heading), std::sin(heading)}, 0,
                 random(2.5, 4.5)});
        }
        for (Particle &one : smoke) {
            one.velocity += dt * 1.2 * (Vec2{wind, 0.5} - one.velocity);
            one.position += dt * one.velocity;
            one.age += dt;
        }
        std::erase_if(smoke, [](const Particle &one) { return one.age > one.life; });
    }
    static std::vector<Vec2> block(const Vec2 &middle, const Vec2 &ahead, double length, double width) {
        const Vec2 side{-ahead.y(), ahead.x()};
        const Vec2 l = 0.5 * length * ahead, w = 0.5 * width * side;
        return {middle - l - w, middle + l - w, middle + l + w, middle - l + w};
    }
    void draw(Canvas &canvas) const override {
        // the meadow at night
        canvas.area(box({0, 0}, {24, 13.5}), Colour::green).strength = 0.1;

        // the track: sleepers and two rails
        std::vector<Vec2> left, right;
        for (std::size_t i = track.size() - 1; i > 0; --i) {
            const Vec2 ahead = (track[i - 1] - track[i]).normalized();
            const Vec2 side{-ahead.y(), ahead.x()};
            left.push_back(track[i] + 0.2 * side);
            right.push_back(track[i] - 0.2 * side);
            if ((laid + 4000 - i) % 4 == 0)
                canvas.line({track[i] + 0.33 * side, track[i] - 0.33 * side}, Colour::wood, 3).strength =
                    0.8 * (1 - double(i) / 400);
        }
        canvas.trail(left, Colour::dim, 2);
        canvas.trail(right, Colour::dim, 2);

        // the headlight
        const Vec2 nose{std::cos(heading), std::sin(heading)};
        for (double reach = 0.75; reach < 5; reach += 0.5)
            canvas.area(sector(head, reach, heading - 0.3, heading + 0.3), Colour::amber).strength = 0.045;

        const Colour paint[] = {Colour::blue, Colour::orange, Colour::green, Colour::violet, Colour::pink};
        std::vector<Spark> windows;
        for (int car = cars - 1; car >= 0; --car) {
            const double back = car * coach;
            const Vec2 front = along(back + 0.15), rear = along(back + coach - 0.15);
            const Vec2 ahead = (front - rear).normalized();
            const Vec2 side{-ahead.y(), ahead.x()};
            const Vec2 middle = 0.5 * (front + rear);
            if (car > 0) {
                canvas.line({front, along(back - 0.15)}, Colour::dim, 4);
                canvas.body(block(middle, ahead, coach - 0.2, 0.7), paint[(car - 1) % 5]);
                for (double x : {-0.42, -0.14, 0.14, 0.42})
                    for (double y : {-0.3, 0.3}) windows.push_back({middle + x * ahead + y * side, 0.07, 0.6});
            } else {
                canvas.body(block(middle + 0.2 * ahead, ahead, 1.1, 0.5), Colour::ink);
                canvas.body(block(middle - 0.4 * ahead, ahead, 0.55, 0.76), Colour::wood);
                canvas.dot(along(0.35), 0.16, Colour::dim);
            }
        }
        canvas.sparks(windows, Colour::amber);
        const Vec2 end = along(cars * coach - 0.2);
        canvas.lamp(end, 0.07, Colour::pink);
        canvas.lamp(head + 0.05 * nose, 0.12, Colour::amber);
        // the train goes below the trees
        for (std::size_t i = 0; i < trees.size(); ++i) {
            const double size = 0.3 + 0.06 * double(i % 5);
            canvas.ball(trees[i], size, Colour::green).strength = 0.55;
            canvas.ball(trees[i] + Vec2{0.7 * size, -0.6 * size}, 0.7 * size, Colour::green).strength = 0.55;
        }
        for (const Particle &one : smoke) // soft discs: several, one inside the other
            for (double part : {0.4, 0.6, 0.8, 1.0})
                canvas.dot(one.position, part * (0.15 + 0.24 * one.age), Colour::ink).strength =
                    0.12 * (1 - one.age / one.life);
        canvas.readout("speed", v, "m/s");
    }
};
SKETCH(Train, "A night train that follows the pointer")
