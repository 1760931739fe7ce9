// A demo without a page. It reads one line of input for each frame, and writes the frame's numbers, to the last bit; or,
// as `NN_slug --picture "wind: 2"`, writes what it is about, and then, for who has this control so, the moment of its still
// picture and all controls; or, as `NN_slug --wild 36000`, plays every game by a wild hand for so many frames; or, as
// `NN_slug --alone 36000`, leaves each alone.
#include "interface.hpp"

#undef COURSE_EXERCISE // here the section's exercises are called through the border, in checked.cpp
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    }                                                                                                                  \
    decltype(function) function __asm__("checked_" #section "_" #function);                                            \
    namespace subject {
#include COURSE_SECTION
#undef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)

#include "wild.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string_view>

namespace {

void print_row() {
    for (const double x : host::row) std::printf("%.17g ", x);
    std::printf("\n");
}

/// "The game: bounces (7.4), radius: 0.4", as the place of a demo has it, and as docs/play.js reads it.
void begin_with(std::string_view settings) {
    while (!settings.empty()) {
        const std::string_view setting = settings.substr(0, settings.find(", "));
        settings.remove_prefix(std::min(setting.size() + 2, settings.size()));
        const std::string_view name = setting.substr(0, setting.find(": "));
        const std::string value{setting.substr(std::min(name.size() + 2, setting.size()))};
        auto &controls = host::in.controls;
        const auto control =
            std::find_if(controls.begin(), controls.end(), [&](const auto &c) { return c.name == name; });
        if (control == controls.end()) throw std::runtime_error{"there is no control " + std::string{name}};
        const auto &options = control->options;
        control->value = options.empty() ? std::stod(value)
                                         : double(std::find(options.begin(), options.end(), value) - options.begin());
        if (!options.empty() && control->value == double(options.size()))
            throw std::runtime_error{"there is no choice " + value};
    }
}

/// What there is, then the moment of its picture, and the controls as they are.
void tell() {
    print_row();
    host::row = {play::scenes.still_time(host::in)};
    for (const demo::Control &control : host::in.controls) host::row.push_back(control.value);
    print_row();
}

void play_lines() {
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream words{line};
        demo::Input &in = host::in;
        int key = -1;
        words >> in.dt >> in.one_step >> in.pointer.x() >> in.pointer.y() >> in.inside >> in.pressed >> in.down
            >> in.handle >> key;
        in.key = host::key(key);
        for (demo::Control &control : in.controls) words >> control.value;
        if (!words) throw std::runtime_error{"this line has too few numbers: " + line};
        host::frame();
        print_row();
    }
}

constexpr unsigned seed = 7;

/// Every game anew, as the first choice has them. Whether all go on to the end; of one that doesn't it prints why.
bool play_all(bool alone, int frames) {
    const auto &controls = host::about.controls;
    const std::vector<std::string_view> games =
        controls.empty() || controls[0].options.empty() ? std::vector{host::about.title} : controls[0].options;
    bool good = true;
    for (std::size_t game = 0; game < games.size(); ++game) {
        host::begin();
        try {
            alone ? host::leave_alone(double(game), frames) : host::WildHand{seed, double(game)}.play(frames);
        } catch (const std::exception &error) {
            std::cout << games[game] << ": " << error.what() << std::endl;
            good = false;
        }
    }
    return good;
}

} // namespace

int main(int count, char **words) {
    try {
        host::begin();
        if (count == 3 && std::string_view{words[1]} == "--picture") begin_with(words[2]), tell();
        else if (count == 3 && std::string_view{words[1]} == "--wild")
            return play_all(false, std::atoi(words[2])) ? 0 : 1;
        else if (count == 3 && std::string_view{words[1]} == "--alone")
            return play_all(true, std::atoi(words[2])) ? 0 : 1;
        else play_lines();
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
