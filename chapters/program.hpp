#pragma once
// What the programs share: parts that run one by one, columns, and a main that says what went wrong.

#include "course.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace course {

/// `0.401163`: rounded to six decimals, without a negative zero.
inline std::string text(double x) {
    std::ostringstream out;
    out << std::setprecision(15) << std::round(x * 1e6) / 1e6 + 0.0;
    return out.str();
}

/// `(4, -2)`
inline std::string text(const Vec2 &v) { return '(' + text(v.x()) + ", " + text(v.y()) + ')'; }

/// One line of a table: each text in its column, and no blanks at the end. `{{"wall", 12}, {"s", 0}}`
inline std::string row(const std::vector<std::pair<std::string, std::size_t>> &columns) {
    std::string line;
    for (const auto &[words, width] : columns) {
        line += words;
        line.append(words.size() < width ? width - words.size() : 1, ' '); // too long a text keeps its distance
    }
    return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

/// A part of a program, written to the screen or into a trace.
struct Part {
    std::string name; ///< one word, as in `./course run 7 crossings`; or a trace's file, which ends in ".tsv"
    std::function<void(std::ostream &)> write;
};

/// Runs one part. If something stops it, that is said in one line, and nothing else of the part is shown.
/// @param gap  what is printed before it; from then on an empty line
/// @throws std::runtime_error if a trace cannot be written
inline bool run_part(const Part &part, const std::filesystem::path &folder, std::string &gap) {
    std::ostringstream out;
    out.precision(17);
    try {
        part.write(out);
    } catch (const NotYet &hint) {
        std::cerr << "not started: " << part.name << ": needs " << hint.function << ": " << hint.what() << std::endl;
        return false;
    } catch (const std::exception &error) {
        std::cerr << "error: " << part.name << ": " << error.what() << std::endl;
        return false;
    } catch (...) {
        std::cerr << "error: " << part.name << ": something was thrown that is no std::exception" << std::endl;
        return false;
    }
    if (!part.name.ends_with(".tsv")) {
        std::cout << std::exchange(gap, "\n") << out.str() << std::flush;
        return true;
    }
    std::ofstream file{folder / part.name, std::ios::binary};
    if (!(file << out.str()).flush()) throw std::runtime_error{"cannot write " + (folder / part.name).string()};
    return true;
}

/// A section's program: `program [PART] [--out FOLDER]` runs all of its parts, or only the one named. Each runs by itself,
/// so an exercise that is not written yet costs only the parts that need it. Traces go to FOLDER, or here.
/// @return 0 if all parts ran, 1 if some could not, 2 if it cannot write, or does not know its arguments
inline int run(int argc, char **argv, std::vector<Part> parts) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    std::filesystem::path folder = ".";
    if (arguments.size() >= 2 && arguments[arguments.size() - 2] == "--out") {
        folder = arguments.back();
        arguments.resize(arguments.size() - 2);
    }
    if (!arguments.empty()) {
        std::string names;
        for (const Part &part : parts)
            if (!part.name.ends_with(".tsv")) names += (names.empty() ? "" : ", ") + part.name;
        std::erase_if(parts, [&](const Part &part) { return part.name != arguments[0]; });
        if (parts.empty() || arguments.size() > 1) {
            std::cerr << "this program has no part `" << arguments.back() << "`; its parts are " << names << '\n';
            return 2;
        }
    }
    bool all = true;
    try {
        std::string gap;
        for (const Part &part : parts) all = run_part(part, folder, gap) && all;
    } catch (const std::exception &error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
    return all ? 0 : 1;
}

} // namespace course
