#pragma once
// A hand that does what no player would, but could: it drags everything everywhere, far outside, too, moves sliders to both
// ends, and presses what there is to press. Whatever it does, a demo goes on: it refuses nothing, every number is one, and
// its picture neither stands still for good nor grows without end. So it is when it's left alone for days.
#include "frame.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace host {

/// Whether something counts with the controls as they are: as docs/play.js has it.
inline bool counts(const std::vector<std::string_view> &only_with) {
    return only_with.empty() || std::any_of(in.controls.begin(), in.controls.end(), [&](const demo::Control &c) {
               return !c.options.empty()
                      && std::find(only_with.begin(), only_with.end(), c.options[std::size_t(c.value)])
                             != only_with.end();
           });
}

/// How many handles there are to take hold of.
inline int handles() {
    int count = 0;
    for (const demo::Shape &shape : now.draw().shapes)
        if (shape.kind == demo::Shape::handle) count += int(shape.points.size());
    return count;
}

inline void expect_numbers() {
    if (!std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); }))
        throw std::runtime_error{"the picture has a number that isn't one"};
    if (row.size() > 100'000) throw std::runtime_error{"the picture grows without end"};
}

class WildHand {
  public:
    WildHand(unsigned seed, double of_game) : dice{seed}, game{of_game} {}

    void play(int frames) {
        std::vector<double> before;
        for (int i = 0, stood = 0; i < frames; ++i) {
            move(i);
            frame();
            expect_numbers();
            stood = row == before ? stood + 1 : 0;
            if (stood > 2000) throw std::runtime_error{"nothing has moved for 2000 frames"};
            before = row;
        }
    }

  private:
    std::mt19937 dice; // its numbers are the same everywhere, those of a distribution aren't
    double game;
    demo::Vec2 to{0, 0};

    double chance() { return double(dice()) / 4294967296.0; }
    int any(std::size_t count) { return int(chance() * double(count)); }

    /// Up to 12 pictures away, as far as a large screen reaches around a small one; or exactly at an edge.
    demo::Vec2 anywhere() {
        const demo::Vec2 low = about.low, size = about.high - low;
        const double far = chance() < 0.3 ? 12 : chance() < 0.5 ? 1 : 0;
        const auto part = [&] { return chance() < 0.1 ? any(2) : (2 * far + 1) * chance() - far; };
        const double across = part(), up = part();
        return low + demo::Vec2{across * size.x(), up * size.y()};
    }

    /// To an end, or to any of its steps.
    void set(demo::Control &control) {
        const double grain = control.step > 0 ? control.step : control.high - control.low;
        const int steps = int(std::round((control.high - control.low) / grain));
        const int at = chance() < 0.5 ? steps * any(2) : any(std::size_t(steps + 1));
        control.value = std::min(control.low + at * grain, control.high);
    }

    void move(int i) {
        if (i % 20 == 0 && !in.controls.empty()) set(in.controls[std::size_t(any(in.controls.size()))]);
        if (!in.controls.empty() && !in.controls[0].options.empty()) in.controls[0].value = game;
        if (i % 15 == 0) { // it keeps hold, as in a page, even if there's none any more
            const int count = i == 0 ? 0 : handles();
            in.handle = count > 0 && chance() < 0.8 ? any(std::size_t(count)) : -1;
        }
        if (i % 5 == 0) to = anywhere();
        in.pointer = chance() < 0.5 ? to : demo::Vec2{in.pointer + 0.3 * (to - in.pointer)};
        in.inside = in.handle >= 0 || chance() < 0.5;
        in.pressed = in.inside && chance() < 0.1;
        in.down = in.handle >= 0 || in.pressed || (in.down && chance() < 0.9);
        in.key = {};
        if (!about.keys.empty() && chance() < 0.1)
            if (const demo::Key &key = about.keys[std::size_t(any(about.keys.size()))]; counts(key.only_with))
                in.key = key.key;
        in.one_step = chance() < 0.02;
        in.dt = in.one_step || chance() < 0.05 ? 0 : chance() < 0.1 ? 0.1 : chance() < 0.5 ? 1 / 60.0 : 1 / 144.0;
    }
};

/// As many frames of 0.1 s without a hand; a picture of some is enough.
inline void leave_alone(double game, int frames) {
    if (!in.controls.empty() && !in.controls[0].options.empty()) in.controls[0].value = game;
    in.dt = 0.1;
    for (int i = 0; i < frames; ++i) {
        if (i % 1000 != 0) {
            now.next(in);
            continue;
        }
        frame();
        expect_numbers();
    }
}

} // namespace host
