#pragma once
// What the benchmarks share: how long something takes.

#include "program.hpp"

#include <algorithm>
#include <ctime>

namespace course {

/// Processor time [s] that one call of `work` takes; what other programs use meanwhile does not count.
template <class Work> double seconds(const Work &work) {
    for (int calls = 1;; calls *= 2) { // twice as many each time, until reading the clock costs next to nothing
        const std::clock_t begin = std::clock();
        for (int i = 0; i < calls; ++i) work();
        const double passed = double(std::clock() - begin) / CLOCKS_PER_SEC;
        if (passed >= 0.05) return passed / calls;
    }
}

/// The median of five; what takes more than a second is measured once.
template <class Work> double median_seconds(const Work &work) {
    std::vector<double> times{seconds(work)};
    while (times.size() < 5 && times[0] < 1) times.push_back(seconds(work));
    std::ranges::sort(times);
    return times[times.size() / 2];
}

/// So many digits of a measurement, and no more.
inline std::string digits(double x, int count) {
    std::ostringstream shown;
    shown << std::setprecision(count) << x;
    return shown.str();
}

} // namespace course
