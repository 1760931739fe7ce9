// A lamp in a room at night: hold it, and see what it lights, and where one could hide.
#include "sketch.hpp"
using namespace demo;
using segment_intersection::Segment;

//> The sketch: a lamp at night
struct Lamp : Scene {
    const std::vector<Segment> walls{{{0, 0}, {16, 0}}, {{16, 0}, {16, 9}}, {{16, 9}, {0, 9}}, {{0, 9}, {0, 0}},
                                     {{5, 9}, {5, 6}},  {{5, 4}, {5, 2}},   {{9, 0}, {11, 4}}, {{9, 7}, {13, 6}}};
    Vec2 lamp{2, 3};
    double time = 0;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }
    void step(double dt) override {
        time += dt;
        lamp = hand.down ? hand.at : Vec2{8 + 6 * std::cos(0.5 * time), 5 - 0.4 * std::sin(0.7 * time)};
    }
    Vec2 lit(double angle) const {
        Segment ray{lamp, lamp + 20 * Vec2{std::cos(angle), std::sin(angle)}};
        for (const Segment &wall : walls)
            if (segment_intersection::segments_intersect(ray, wall))
                if (const auto hit = segment_intersection::intersect_lines(ray, wall)) ray.end = hit->point;
        return ray.end;
    }
    void draw(Canvas &canvas) const override {
        std::vector<Vec2> edge;
        for (int i = 0; i < 720; ++i) edge.push_back(lit(i * std::numbers::pi / 360));
        canvas.area(edge, Colour::amber);
        for (const Segment &wall : walls) canvas.bar({wall.start, wall.end}, Colour::wood, 8);
        canvas.lamp(lamp, 0.25, Colour::amber);
    }
};
SKETCH(Lamp, "A lamp at night")
