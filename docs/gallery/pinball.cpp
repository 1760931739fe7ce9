// Pinball: an arrow key or a press at its side lifts a flipper, and either of them shoots the ball that waits.
#include "props.hpp"
#include "sketch.hpp"
using namespace demo;
using segment_intersection::Segment, segment_intersection::time_of_impact;

struct Pinball : Scene {
    static constexpr double radius = 0.22, tick = 1.0 / 240, side[]{1, -1}; // of the ball [m], a step [s]
    HeldKey keys[2]{held("left flipper", "ArrowLeft"), held("right flipper", "ArrowRight")};
    const std::vector<Vec2> outline{{5.1, 1.5},  {0.4, 3},    {0.4, 7},    {2, 8.6},  {14, 8.6}, {15.6, 7},
                                    {15.6, 0.4}, {14.6, 0.4}, {14.6, 6.7}, {14.6, 3}, {9.9, 1.5}};
    const std::vector<Vec2> bumpers{{3.6, 6.2}, {7.5, 6.9}, {11.4, 6.2}, {5.5, 4.5}, {9.5, 4.5}};
    motion::State ball{{15, 0.7}, {0, 0}};
    std::vector<Vec2> way{ball.position};
    Segment flippers[2]{{{5.15, 1.4}, {6.7, 0.6}}, {{9.85, 1.4}, {8.3, 0.6}}};
    double angle[2]{-0.5, -0.5}, lit[5]{}; // of each flipper [rad]; how bright each bumper is
    int points = 0, balls = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    double step_time() const override { return tick; }
    bool is_wanted(int i) const {
        return untouched ? ball.position.y() < 1.4 : keys[i] || (hand.down && (hand.at.x() < 7.5) == (i == 0));
    }
    void step(double) override {
        const bool waits = ball.position.x() > 14.7 && ball.position.y() < 0.8;
        if (waits && (is_wanted(0) || is_wanted(1))) ball.velocity.y() = 14 + 0.4 * (balls % 5);
        ball = motion::accelerated_motion(ball, {0, -6}, tick);
        for (std::size_t i = 1; i < outline.size(); ++i) bounces({outline[i - 1], outline[i]}, 0.06, {0, 0});
        for (const int i : {0, 1}) {
            const double turn = std::clamp(is_wanted(i) ? 8 * tick : -8 * tick, -0.5 - angle[i], 0.5 - angle[i]);
            bounces(flippers[i], 0.16, side[i] * turn / tick * turned(ball.position - flippers[i].start));
            angle[i] += turn;
            flippers[i].end = flippers[i].start + 1.75 * Vec2{side[i] * std::cos(angle[i]), std::sin(angle[i])};
        }
        for (std::size_t i = 0; i < 5; ++i) {
            const Vec2 kick = 4 * (ball.position - bumpers[i]).normalized();
            lit[i] = bounces({bumpers[i], bumpers[i]}, 0.6, kick) ? 1 : std::max(0.0, lit[i] - 2 * tick);
            if (lit[i] == 1) points += 100;
        }
        way.push_back(ball.position);
        if (way.size() > 70) way.erase(way.begin());
        if (std::abs(ball.position.y() - 5) > 6) ball = {{15, 0.7}, {0, 0}}, way = {ball.position}, points = 0, ++balls;
    }
    bool bounces(const Segment &wall, double thick, const Vec2 &moves) { // off something that moves so [m/s]
        const auto impact = time_of_impact({way.back(), ball.position - tick * moves}, radius + thick, wall);
        if (!impact) return false;
        ball.velocity = moves + reflection::bounce(ball.velocity - moves, impact->centre - impact->point, {0.55, 0});
        ball.position = impact->centre + tick * ball.velocity;
        return true;
    }
    void draw(Canvas &canvas) const override {
        canvas.beam(outline, Colour::blue, 5);
        for (std::size_t i = 0; i < 5; ++i) canvas.lamp(bumpers[i], 0.6, lit[i] > 0 ? Colour::amber : Colour::violet);
        for (const auto &[pivot, tip] : flippers) canvas.bar({pivot, tip}, Colour::orange, 14);
        canvas.trail(way, Colour::pink, 11);
        canvas.ball(ball.position, radius, Colour::ink);
        canvas.plate({12.4, 0.8}, number(points, 0), Colour::amber, 30);
    }
};
SKETCH(Pinball, "Pinball")
