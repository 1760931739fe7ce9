#pragma once
// Compares a solution with a peer: code that others wrote for the same job, in another way. tests/NN_slug/peer.txt
// keeps how far apart the two are at most, and the chapter shows it.
//
//     NN_slug NN_slug.txt                       fails if a difference is larger than the kept one, or less than half
//     COURSE_GOLDEN=write NN_slug NN_slug.txt   keeps the differences as they are now, rounded up to two digits

#include "../dice.hpp"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Something that both can do.
struct Comparison {
    std::string what;                     ///< "intersect_lines, 20000 pairs: t, s"
    std::function<double(Dice &)> differ; ///< the largest difference, or how many answers are others
};

/// The larger of two differences; "not a number" is larger than any number.
inline double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// Relative for what is larger than 1, as the tests compare.
inline double difference(double got, double want) { return std::abs(got - want) / std::max(1.0, std::abs(want)); }

/// To two digits.
inline double rounded_up(double x) {
    if (x == 0 || !std::isfinite(x)) return x;
    const double digit = std::pow(10, std::floor(std::log10(x)) - 1);
    return std::ceil(x / digit) * digit;
}

/// The lines "3.2e-14  what was compared" of a file; the first line is a title.
inline std::map<std::string, double> read_kept(const std::string &file) {
    std::map<std::string, double> kept;
    std::ifstream in{file};
    std::string line, what;
    std::getline(in, line);
    for (double largest_then = 0; in >> largest_then && std::getline(in >> std::ws, what);) kept[what] = largest_then;
    return kept;
}

/// What the main function of a peer does.
inline int compare_with_peer(int argc, char **argv, const std::string &title,
                             const std::vector<Comparison> &comparisons) try {
    if (argc != 2) throw std::runtime_error{"usage: " + std::string{argv[0]} + " tests/NN_slug/peer.txt"};
    const std::map<std::string, double> kept = read_kept(argv[1]);
    std::ostringstream now;
    now << "#> " << title << '\n' << std::left << std::setprecision(2);
    bool as_kept = kept.size() == comparisons.size();
    for (const Comparison &each : comparisons) {
        Dice dice{1};
        const double found = each.differ(dice);
        now << std::setw(9) << rounded_up(found) << each.what << '\n';
        const auto before = kept.find(each.what);
        as_kept = as_kept && before != kept.end() && found <= before->second && found >= before->second / 2;
    }
    std::cout << now.str();
    if (const char *write = std::getenv("COURSE_GOLDEN"); write != nullptr && std::string_view{write} == "write") {
        if (!(std::ofstream{argv[1]} << now.str() << std::flush))
            throw std::runtime_error{std::string{argv[1]} + " cannot be written"};
        return 0;
    }
    if (!as_kept) std::cerr << argv[1] << " says otherwise. Keep these differences only if you know why.\n";
    return as_kept ? 0 : 1;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 2;
}

} // namespace course
