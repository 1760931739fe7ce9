#pragma once
// The velocities of two carts as one point of a plane, above their rail: what the scenes of this chapter share, too.
#include "meeting.hpp"

namespace play {

/// All points with the momentum, and all with the energy, that the carts came with.
struct Plane {
    static constexpr double size = 2.45;     // half of its width [m]
    static inline const Vec2 middle{7, 4.3}; // [m]
    double m_a, m_b;
    double momentum = m_a * before.a + m_b * before.b;                           ///< [N s]
    double energy = (m_a * before.a * before.a + m_b * before.b * before.b) / 2; ///< [J]
    double wide = std::sqrt(2 * energy / m_a), high = std::sqrt(2 * energy / m_b);
    double scale = size / std::max({6.0, wide, high}); // [s]

    Vec2 at(const Vec2 &velocities) const { return middle + scale * velocities; }
    Vec2 back(const Vec2 &place) const { return (place - middle) / scale; }
    /// Where the line of momentum leaves the picture, to the lower right and to the upper left.
    Vec2 end_of_line(double sign) const {
        const double common = momentum / (m_a + m_b), most = size / scale;
        const double to_x = (most - sign * common) / m_b, to_y = (most + sign * common) / m_a;
        return Vec2{common, common} + sign * std::min(to_x, to_y) * Vec2{m_b, -m_a};
    }
    void draw(Canvas &canvas) const {
        canvas.body(box(middle - Vec2{size + 0.15, size + 0.15}, middle + Vec2{size + 0.15, size + 0.15}),
                    Colour::wood);
        canvas.area(box(middle - Vec2{size, size}, middle + Vec2{size, size}), Colour::line);
        canvas.line({middle - Vec2{size, 0}, middle + Vec2{size, 0}}, Colour::ink, 1.5).strength = 0.6;
        canvas.line({middle - Vec2{0, size}, middle + Vec2{0, size}}, Colour::ink, 1.5).strength = 0.6;
        canvas.text(middle + Vec2{size - 0.3, 0.3}, "A", Colour::blue, 20);
        canvas.text(middle + Vec2{0.12, size - 0.25}, "B", Colour::green, 20);
        std::vector<Vec2> ellipse;
        for (const Vec2 &point : arc({0, 0}, 1)) ellipse.push_back(at({wide * point.x(), high * point.y()}));
        canvas.dotted(std::move(ellipse), Colour::orange, 4);
        canvas.line({at(end_of_line(-1)), at(end_of_line(1))}, Colour::violet, 4);
        canvas.dot(at({before.a, before.b}), 0.12, Colour::ink);
    }
};

/// Two carts that meet, below their plane. To its sides is what they have, and had, together.
struct PlaneScene : Meeting {
    View view() const override { return {{0, -0.75}, {14, 7.125}, Stage::yard, -0.2}; }
    Plane plane() const { return {mass_of_a(), mass_of_b()}; }
    Vec2 velocities() const { return {a.cart.velocity, b.cart.velocity}; }

    void draw_with(Canvas &canvas, const Vec2 &point) const {
        const Plane it = plane();
        const double momentum = it.m_a * point.x() + it.m_b * point.y();
        const double energy = (it.m_a * point.x() * point.x() + it.m_b * point.y() * point.y()) / 2;
        it.draw(canvas);
        canvas.ball(it.at(point), 0.2, Colour::orange);
        canvas.plate({2.2, 6.2}, "A " + number(point.x(), 1, "m/s"), Colour::blue, 22);
        canvas.plate({11.8, 6.2}, "B " + number(point.y(), 1, "m/s"), Colour::green, 22);
        draw_amount(canvas, 2.2, "momentum", momentum, it.momentum, "N s", Colour::violet);
        draw_amount(canvas, 11.8, "energy", energy, it.energy, "J", Colour::orange);
        draw_rail(canvas, 0, -0.5, 14);
        draw_carts(canvas, false);
    }
    /// A bar as high as it is now, in a frame as high as it was.
    static void draw_amount(Canvas &canvas, double x, const char *name, double now, double was, const char *unit,
                            Colour colour) {
        const double unit_height = 1.6 / std::max({std::abs(was), std::abs(now), 0.1}), foot = 2.9;
        canvas.text({x, 2.35}, name, colour, 18, Anchor::middle);
        canvas.body(box({x - 0.3, foot}, {x + 0.3, foot + unit_height * now}), colour);
        canvas.line({{x - 0.55, foot + unit_height * was}, {x + 0.55, foot + unit_height * was}}, Colour::ink, 3);
        canvas.plate({x, 5.2}, number(now, 1, unit), colour, 24);
    }
};
} // namespace play
