#pragma once
// What a demo and the page that shows it tell each other: its controls, what the reader does, and what is seen. Scenes are
// written with scene.hpp.
#include "course.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace demo {
using course::Vec2;

/// By name, as in plots/style.gp: the page knows how each looks on light and on dark. Wood and earth are for bodies.
enum class Colour { ink, dim, line, blue, orange, green, amber, violet, pink, wood, earth };

/// What a shape is made of. Solid: lit from the upper left, with an edge and a soft shadow, so that discs are balls,
/// lines are bars and areas are painted bodies. Glow: with a halo of its colour, as a spark or a lamp has one.
/// Light: what overlaps adds up, as sparks at night do. Mist: soft, and it covers, as smoke does.
enum class Material { flat, solid, glow, light, mist };

/// Where words are, seen from their point.
enum class Anchor { left, middle, right };

/// Where it all happens. Felt is a billiard table's, and night is dark, on a light page, too: what's drawn there has the
/// colours of a dark page. A yard has a sky, and ground below; hills are a yard in the country, a skyline is a town at night,
/// and the moon's ground has craters. A workshop has a wall and a floor. Paper may be squared, by the metre.
enum class Stage { paper, felt, yard, night, hills, skyline, moon, workshop, squared };

/// A slider; or, if it has `options`, a choice among them, whose value is the number of the one that is chosen, from 0; or,
/// if its step is 0, a key that acts while it's held.
struct Control {
    std::string_view name, unit;
    double low, high, step, value; ///< value: at the start, then in each frame
    std::vector<std::string_view> options{};
    std::vector<std::string_view> only_with{}; ///< options of a choice: without one of them it is not shown
};
inline Control choice(std::string_view name, std::vector<std::string_view> options, int chosen) {
    return {name, "", 0, double(options.size()) - 1, 1, double(chosen), options};
}
/// A key, as a Key's: 1 while it or its button is down, several at once, too, and 0 otherwise. A tap is 1 for one frame.
inline Control held(std::string_view name, std::string_view key, std::vector<std::string_view> only_with = {}) {
    return {name, key, 0, 1, 0, 0, {}, std::move(only_with)};
}
struct Key {
    std::string_view key, meaning; ///< as browsers call it: "n", "ArrowUp"; it gets a button of that meaning, too
    std::vector<std::string_view> only_with{}; ///< as a Control's
};
struct About {
    std::string_view title; ///< also for readers who cannot see it
    Vec2 low, high;         ///< the part of the world that is seen [m]
    std::vector<Control> controls;
    std::vector<Key> keys;
};

/// What somebody does in one frame.
struct Input {
    double dt{};                     ///< since the frame before [s], at most 0.1; 0 while the demo is paused
    bool one_step{};                 ///< whether *Step* was pressed
    Vec2 pointer{0, 0};              ///< where the mouse or a finger is, or was last [m]
    bool inside{};                   ///< whether it is over the picture
    bool pressed{};                  ///< whether it went down in this frame
    bool down{};                     ///< whether it's down
    int handle{-1};                  ///< which of the picture's handles it holds, in the order of drawing; -1: none
    std::string_view key{};          ///< pressed in this frame
    std::vector<Control> controls{}; ///< as in About, with their values
    double operator[](std::string_view name) const {
        for (const Control &each : controls)
            if (each.name == name) return each.value;
        throw std::invalid_argument{"there is no control " + std::string{name}};
    }
};

/// How many steps of `length` seconds this frame takes; the time that is left over waits in `spare` for the next.
inline int steps_due(double &spare, const Input &in, double length) {
    if (in.one_step) return 1;
    spare += in.dt;
    int count = 0;
    for (; spare >= length; spare -= length) ++count;
    return count;
}

/// One thing in a picture: discs, handles and arrows have points and a size, lines and areas points, words one point.
struct Shape {
    enum Kind { discs, line, area, arrow, words, handle, trail } kind;
    Colour colour;
    double size{0}; ///< discs: the radius [m]; lines, arrows: the width [px], negative: dotted and flat. Where the
                    ///< material isn't flat, it's the width in a picture of 640 px, and grows with that, as a trail's
                    ///< width at its end and the height of words do; words without a size have the page's
    double strength{1}; ///< 1: opaque
    std::vector<Vec2> points{};
    std::string text{};
    Material material{Material::flat}; ///< of words: solid if they are on a plate
    Anchor anchor{Anchor::left};
    std::vector<double> each{}; ///< for each disc of light or mist its radius [m] and its strength
};
struct Readout {
    std::string_view name, unit;
    double value;
    int decimals;
};
/// What comes first lies below.
struct Picture {
    std::vector<Shape> shapes{};
    std::vector<Readout> readouts{};
    Stage stage{Stage::paper};
    Vec2 low{0, 0}, high{0, 0}; ///< the part of the world that's seen [m]
    double ground{0};           ///< how high the stage's ground is [m]
};
} // namespace demo
