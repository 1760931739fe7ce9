#pragma once
// A demo and what surrounds it, wherever it runs: its state, and a frame of it as a row of numbers.
#include "scenes.hpp"

#include DEMO

#include <utility>
#include <vector>

namespace host {
inline play::State now;
inline demo::Input in;
inline std::vector<double> row;

inline void put(double x) { row.push_back(x); }
inline void put(const demo::Vec2 &v) { put(v.x()), put(v.y()); }
inline void put(std::string_view text) { // its length, then its bytes
    put(double(text.size()));
    for (const char c : text) put(double(static_cast<unsigned char>(c)));
}
template <class T, class Each> void put_all(const std::vector<T> &list, Each each) {
    put(double(list.size()));
    for (const T &one : list) each(one);
}

inline void put_texts(const std::vector<std::string_view> &texts) {
    put_all(texts, [](std::string_view text) { put(text); });
}

inline void begin() {
    in = {};
    in.controls = play::about.controls;
    now = play::begin();
    row.clear();
    put(play::about.title), put(play::about.low), put(play::about.high);
    put_all(play::about.controls, [](const demo::Control &c) {
        put(c.name), put(c.unit), put(c.low), put(c.high), put(c.step), put(c.value);
        put_texts(c.options), put_texts(c.only_with);
    });
    put_all(play::about.keys, [](const demo::Key &key) { put(key.key), put(key.meaning), put_texts(key.only_with); });
}

inline void frame() {
    now = play::next(std::move(now), in);
    in.pressed = in.one_step = false, in.key = {};
    const demo::Picture seen = play::draw(now, in);
    const bool has_bounds = (seen.high - seen.low).norm() > 0;
    row.clear();
    put(double(seen.stage)), put(seen.ground);
    put(has_bounds ? seen.low : play::about.low), put(has_bounds ? seen.high : play::about.high);
    put_all(seen.shapes, [](const demo::Shape &shape) {
        put(double(shape.kind)), put(double(shape.colour)), put(shape.size), put(shape.strength);
        put_all(shape.points, [](const demo::Vec2 &point) { put(point); });
        put(shape.text), put(double(shape.material)), put(double(shape.anchor));
        put_all(shape.each, [](double x) { put(x); });
    });
    put_all(seen.readouts, [](const demo::Readout &readout) {
        put(readout.name), put(readout.unit), put(readout.value), put(double(readout.decimals));
    });
}

inline std::string_view key(int number) { return number < 0 ? "" : play::about.keys[std::size_t(number)].key; }
} // namespace host
