// A demo without a page: reads one line of input for each frame, writes the frame's numbers, bit by bit.
#include "frame.hpp"

#include <cstdio>
#include <iostream>
#include <sstream>

int main() {
    try {
        host::begin();
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
            for (const double x : host::row) std::printf("%a ", x);
            std::printf("\n");
        }
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
