#pragma once
// The reader decides by a point how the carts leave. Where are momentum and energy both right?
#include "shared.hpp"

namespace play {

struct Point : PlaneScene {
    static constexpr std::string_view name = "drag the point";
    Handle ring = handle(Plane::middle, Plane::middle - Vec2{2.45, 2.45}, Plane::middle + Vec2{2.45, 2.45});
    int meetings = 0;

    Point() { still_time = 1.7; }

    Vec2 decided() const { return plane().back(ring); }
    void begin() override {
        const Vec2 film[]{{-2, 4}, {1.6, -0.4}, {-1, -3}};
        if (untouched) ring.move(plane().at(film[meetings++ % 3]));
        Meeting::begin();
    }
    void drag() override { begin(); }
    void press(const Vec2 &) override { begin(); }
    void roll(double dt) override { roll_as_decided(dt, {decided().x(), decided().y()}); }

    void draw(Canvas &canvas) const override { draw_with(canvas, decided()); }
};
} // namespace play
