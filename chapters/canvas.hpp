#pragma once
// What a scene draws onto: a shape for each call, and what comes first lies below. Lengths are in metres, but for the width
// of a line, which is in pixels of a picture that is 640 wide. Each call returns its shape, whose strength, say, may be set.
#include "demo.hpp"

#include <cmath>
#include <numbers>

namespace demo {

/// A point of light, or a puff of smoke: how large [m], and how bright or dense, up to 1.
struct Spark {
    Vec2 at{0, 0};
    double radius{0.1}, strength{1};
};

/// Points on a circle from one angle to another [rad], anticlockwise from the x-axis.
inline std::vector<Vec2> arc(const Vec2 &centre, double radius, double from = 0, double to = 2 * std::numbers::pi) {
    const int parts = std::max(8, static_cast<int>(std::ceil(32 * std::abs(to - from) / std::numbers::pi)));
    std::vector<Vec2> points;
    for (int i = 0; i <= parts; ++i) {
        const double angle = from + (to - from) * i / parts;
        points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    return points;
}
inline std::vector<Vec2> sector(const Vec2 &centre, double radius, double from, double to) {
    std::vector<Vec2> points = arc(centre, radius, from, to);
    points.push_back(centre);
    return points;
}
inline std::vector<Vec2> box(const Vec2 &low, const Vec2 &high) {
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}
/// One that is turned.
/// @param ahead  along its length, a unit vector
inline std::vector<Vec2> box(const Vec2 &middle, const Vec2 &ahead, double length, double width) {
    const Vec2 front = length / 2 * ahead, left = width / 2 * Vec2{-ahead.y(), ahead.x()};
    return {middle - front - left, middle + front - left, middle + front + left, middle - front + left};
}

class Canvas {
  public:
    /// Flat: drawn with ink.
    Shape &dots(std::vector<Vec2> at, double radius, Colour colour) {
        return add({.kind = Shape::discs, .colour = colour, .size = radius, .points = std::move(at)});
    }
    Shape &dot(const Vec2 &at, double radius, Colour colour) { return dots({at}, radius, colour); }
    Shape &line(std::vector<Vec2> points, Colour colour, double width = 2) {
        return add({.kind = Shape::line, .colour = colour, .size = width, .points = std::move(points)});
    }
    Shape &dotted(std::vector<Vec2> points, Colour colour, double width = 2) {
        return line(std::move(points), colour, -width);
    }
    Shape &arrow(const Vec2 &from, const Vec2 &to, Colour colour, double width = 2) {
        return add({.kind = Shape::arrow, .colour = colour, .size = width, .points = {from, to}});
    }
    Shape &area(std::vector<Vec2> corners, Colour colour) {
        return add({.kind = Shape::area, .colour = colour, .points = std::move(corners)});
    }

    /// Solid: lit from the upper left, with an edge and a shadow.
    Shape &balls(std::vector<Vec2> at, double radius, Colour colour) {
        return solid(dots(std::move(at), radius, colour));
    }
    Shape &ball(const Vec2 &at, double radius, Colour colour) { return balls({at}, radius, colour); }
    Shape &bar(std::vector<Vec2> points, Colour colour, double width) {
        return solid(line(std::move(points), colour, width));
    }
    Shape &body(std::vector<Vec2> corners, Colour colour) { return solid(area(std::move(corners), colour)); }

    /// Light: lamps and beams have a halo; sparks add up where they overlap.
    Shape &lamp(const Vec2 &at, double radius, Colour colour) {
        Shape &shape = dot(at, radius, colour);
        shape.material = Material::glow;
        return shape;
    }
    Shape &beam(std::vector<Vec2> points, Colour colour, double width = 2) {
        Shape &shape = line(std::move(points), colour, width);
        shape.material = Material::glow;
        return shape;
    }
    Shape &sparks(const std::vector<Spark> &all, Colour colour) { return many(all, colour, Material::light); }
    /// Smoke, dust, clouds: they cover what lies below, and fade towards their rims.
    Shape &puffs(const std::vector<Spark> &all, Colour colour) { return many(all, colour, Material::mist); }

    /// Where something has been, the oldest point first: it fades and narrows towards that.
    Shape &trail(std::vector<Vec2> points, Colour colour, double width = 4) {
        return add({.kind = Shape::trail, .colour = colour, .size = width, .points = std::move(points)});
    }

    /// Words to the right of this point, or around it, or to its left; on a plate they're read over anything.
    Shape &text(const Vec2 &at, std::string words, Colour colour = Colour::ink, double size = 16,
                Anchor anchor = Anchor::left) {
        return add({.kind = Shape::words,
                    .colour = colour,
                    .size = size,
                    .points = {at},
                    .text = std::move(words),
                    .anchor = anchor});
    }
    Shape &plate(const Vec2 &at, std::string words, Colour colour = Colour::ink, double size = 22) {
        Shape &shape = text(at, std::move(words), colour, size, Anchor::middle);
        shape.material = Material::solid;
        return shape;
    }

    /// Below the picture: for what can't be read in it.
    void readout(std::string_view name, double value, std::string_view unit, int decimals = 2) {
        picture.readouts.push_back({name, unit, value, decimals});
    }
    void readout(std::string_view name, int value, std::string_view unit = {}) { readout(name, value, unit, 0); }

    Picture picture;

  private:
    Shape &add(Shape shape) {
        picture.shapes.push_back(std::move(shape));
        return picture.shapes.back();
    }
    Shape &many(const std::vector<Spark> &all, Colour colour, Material material) {
        Shape &shape = dots({}, 1, colour);
        shape.material = material;
        for (const Spark &each : all) {
            shape.points.push_back(each.at);
            shape.each.insert(shape.each.end(), {each.radius, each.strength});
        }
        return shape;
    }
    static Shape &solid(Shape &shape) {
        shape.material = Material::solid;
        return shape;
    }
};

/// A number for a picture, as "40.2 m".
inline std::string number(double value, int decimals, std::string_view unit = {}) {
    const double scale = std::pow(10.0, decimals), rounded = std::round(std::abs(value) * scale);
    std::string digits = std::to_string(static_cast<long long>(std::min(rounded, 9e15)));
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, ".");
    return (value < 0 && rounded > 0 ? "−" : "") + digits + (unit.empty() ? "" : " ") + std::string{unit};
}
} // namespace demo
