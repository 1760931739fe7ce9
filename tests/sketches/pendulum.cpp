#include "sketch.hpp"
using namespace demo;
using forward_kinematics::Link;

struct Pendulum : Scene {
    Slider first = slider("upper rod", "m", 0.5, 2.2, 0.1, 1.8);
    Slider second = slider("lower rod", "m", 0.5, 2.2, 0.1, 1.8);
    Slider friction = slider("friction", "1/s", 0, 1, 0.05, 0);
    Slider memory = slider("trail", "s", 1, 12, 1, 5);
    Button again = button("n", "Again", [this] { restart(); });

    /// Both angles are seen from the x axis.
    struct State {
        double a{}, b{};   // [rad]
        double va{}, vb{}; // [rad/s]
    };
    State now;
    int grabbed = -1; // 0: the elbow's ball, 1: the last one
    std::vector<Vec2> past;
    long dropped = 0; // how many points have left the trail, so that each keeps its colour

    View view() const override { return {{-8, -4.6}, {8, 4.4}, Stage::night}; }

    void begin() override { restart(); }
    void restart() {
        now = {2.2, 1.4, 0, 0};
        past.clear();
        dropped = 0;
    }
    void changed() override { past.clear(); }

    std::vector<Link> arm(const State &s) const { return {{first, s.a}, {second, s.b - s.a}}; }
    std::vector<Vec2> balls(const State &s) const { return forward_kinematics::joints({0, 0}, arm(s)); }

    Vec2 target() const {
        if (grabbed == 1) return inverse_kinematics::nearest_reachable({first, second}, hand.at);
        return first * hand.at.normalized();
    }
    State slope(const State &s) const {
        const double l = first, m = second, g = 10;
        double qa = -2 * friction * l * l * s.va, qb = -friction * m * m * s.vb;
        if (grabbed >= 0) { // a spring and a damper from the pointer to the ball
            std::vector<Link> links = arm(s);
            links.resize(grabbed + 1);
            const Vec2 at = forward_kinematics::joints({0, 0}, links).back();
            const std::vector<Vec2> j = forward_kinematics::jacobian(links);
            if (grabbed == 0) {
                const Vec2 velocity = s.va * j[0];
                qa += (150 * (target() - at) - 18 * velocity).dot(j[0]);
            } else {
                const Vec2 ja = j[0] - j[1], jb = j[1];
                const Vec2 force = 150 * (target() - at) - 18 * (s.va * ja + s.vb * jb);
                qa += force.dot(ja);
                qb += force.dot(jb);
            }
        }
        const double c = std::cos(s.a - s.b), si = std::sin(s.a - s.b);
        const double ra = -l * m * si * s.vb * s.vb - 2 * g * l * std::cos(s.a) + qa;
        const double rb = l * m * si * s.va * s.va - g * m * std::cos(s.b) + qb;
        const double maa = 2 * l * l, mab = l * m * c, mbb = m * m, det = maa * mbb - mab * mab;
        return {s.va, s.vb, (ra * mbb - rb * mab) / det, (rb * maa - ra * mab) / det};
    }
    static State plus(const State &s, const State &d, double h) {
        return {s.a + h * d.a, s.b + h * d.b, s.va + h * d.va, s.vb + h * d.vb};
    }
    void step(double dt) override {
        const int parts = 6;
        const double h = dt / parts;
        for (int i = 0; i < parts; ++i) { // Runge and Kutta
            const State k1 = slope(now), k2 = slope(plus(now, k1, h / 2)), k3 = slope(plus(now, k2, h / 2)),
                        k4 = slope(plus(now, k3, h));
            now = plus(plus(plus(plus(now, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
        }
        past.push_back(balls(now).back());
        while (past.size() > 60 * memory) past.erase(past.begin()), ++dropped;
    }
    int nearest() const {
        const auto at = balls(now);
        const double a = (hand.at - at[1]).norm(), b = (hand.at - at[2]).norm();
        if (std::min(a, b) > 0.8) return -1;
        return a < b ? 0 : 1;
    }
    void press(const Vec2 &) override { grabbed = nearest(); }
    void release(const Vec2 &) override { grabbed = -1; }

    void draw(Canvas &canvas) const override {
        static constexpr Colour rainbow[]{Colour::pink,  Colour::orange, Colour::amber,
                                          Colour::green, Colour::blue,   Colour::violet};
        const int piece = 6, per_colour = 30;
        // Pieces begin at whole multiples of `piece`, counted from the very first point.
        for (long i = (piece - dropped % piece) % piece; i + 1 < long(past.size()); i += piece) {
            const std::vector<Vec2> points(past.begin() + i, past.begin() + std::min(i + piece + 1, long(past.size())));
            const double hue = double(i + dropped) / per_colour, fade = double(i) / past.size();
            const double blend = hue - std::floor(hue);
            const int which = int(hue) % 6;
            canvas.beam(points, rainbow[which], 4).strength = fade * (1 - blend);
            canvas.beam(points, rainbow[(which + 1) % 6], 4).strength = fade * blend;
        }
        const auto at = balls(now);
        canvas.bar({at[0], at[1]}, Colour::wood, 8);
        canvas.bar({at[1], at[2]}, Colour::wood, 8);
        canvas.dot(at[0], 0.12, Colour::dim);
        canvas.ball(at[1], 0.25, Colour::orange);
        canvas.ball(at[2], 0.3, Colour::amber);
        const int lit = grabbed >= 0 ? grabbed : hand.inside ? nearest() : -1;
        if (lit >= 0) canvas.lamp(at[lit + 1], 0.3, Colour::amber);
        if (grabbed >= 0) canvas.dotted({at[grabbed + 1], hand.at}, Colour::dim);
        if (untouched) canvas.text({-7.6, -4.2}, "grab a ball, and throw it", Colour::ink);
        const double l = first, m = second;
        const Vec2 v1 = l * now.va * Vec2{-std::sin(now.a), std::cos(now.a)};
        const Vec2 v2 = v1 + m * now.vb * Vec2{-std::sin(now.b), std::cos(now.b)};
        canvas.readout("speed", v2.norm(), "m/s");
        canvas.readout("energy", (v1.squaredNorm() + v2.squaredNorm()) / 2 + 10 * (at[1].y() + at[2].y()), "J");
    }
};
SKETCH(Pendulum, "A double pendulum to grab and throw")
