// A demo without a page. It reads one line of input for each frame, and writes the frame's numbers, bit by bit; or,
// as `NN_slug --picture`, plays until its still picture is taken, and writes what it is about and what is seen then.
#include "frame.hpp"

#include <cstdio>
#include <iostream>
#include <sstream>
#include <string_view>

namespace {

void print_row() {
    for (const double x : host::row) std::printf("%a ", x);
    std::printf("\n");
}

void play_alone() {
    print_row();
    constexpr double dt = 1.0 / 64;
    host::in.dt = dt;
    host::in.key = play::still.key;
    for (double time = 0; time < play::still.time; time += dt) {
        host::frame();
    }
    print_row();
}

void play_lines() {
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words{line};
        demo::Input &in = host::in;
        int key = -1;
        words >> in.dt >> in.one_step >> in.pointer.x() >> in.pointer.y() >> in.inside >> in.pressed >> in.handle
            >> key;
        in.key = host::key(key);
        for (demo::Control &control : in.controls) words >> control.value;
        if (!words) throw std::runtime_error{"this line has too few numbers: " + line};
        host::frame();
        print_row();
    }
}

} // namespace

int main(int count, char **words) {
    try {
        host::begin();
        if (count == 2 && std::string_view{words[1]} == "--picture") play_alone();
        else play_lines();
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
