#pragma once
// A demo, which is `const demo::Scenes scenes` in namespace play, wherever it runs: its state, and a frame of it as a row of
// numbers. No clock, no random device, no printing.
#include "scenes.hpp"

#include DEMO

#include <vector>

namespace host {
const demo::About about = play::scenes.about();
inline demo::Player now;
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
    in.controls = about.controls;
    now = demo::Player{play::scenes};
    row.clear();
    put(about.title), put(about.low), put(about.high);
    put_all(about.controls, [](const demo::Control &c) {
        put(c.name), put(c.unit), put(c.low), put(c.high), put(c.step), put(c.value);
        put_texts(c.options), put_texts(c.only_with);
    });
    put_all(about.keys, [](const demo::Key &key) { put(key.key), put(key.meaning), put_texts(key.only_with); });
}

inline void frame() {
    now.next(in);
    in.pressed = in.one_step = false, in.key = {};
    const demo::Picture seen = now.draw();
    row.clear();
    put(double(seen.stage)), put(seen.ground);
    put(seen.low), put(seen.high);
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

inline std::string_view key(int number) { return number < 0 ? "" : about.keys[std::size_t(number)].key; }
} // namespace host
