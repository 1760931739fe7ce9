#include "base/watch.hpp"

#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;
namespace {

/// A process in the background that reads the terminal is stopped.
bool may_read_keys() {
    const pid_t foreground = ::tcgetpgrp(STDIN_FILENO); // -1: no terminal
    return foreground < 0 || foreground == ::getpgrp();
}

} // namespace

FileWatch::FileWatch(std::vector<fs::path> files_) : files{std::move(files_)}, state{look()} {}

std::string FileWatch::look() const {
    std::string text;
    for (const fs::path &file : files) {
        std::error_code missing;
        const auto date = fs::last_write_time(file, missing).time_since_epoch().count();
        const auto size = fs::file_size(file, missing);
        if (missing) return ""; // an editor may be between two versions of it
        text += std::to_string(date) + ' ' + std::to_string(size) + '\n';
    }
    return text;
}

bool FileWatch::wait() {
    constexpr int interval = 100; // [ms] asking for a date costs a microsecond, and works on every disk
    for (;;) {
        pollfd keyboard{STDIN_FILENO, POLLIN, 0};
        std::string line, now;
        if (::poll(&keyboard, keys && may_read_keys() ? 1 : 0, interval) > 0) {
            keys = static_cast<bool>(std::getline(std::cin, line));
            if (keys) {
                state = look();
                return line != "q";
            }
        }
        now = look();
        if (now.empty() || now == state) continue;
        state = now;
        return true;
    }
}

} // namespace course
