#pragma once
// Back from words to numbers: what a verdict says of arguments and answers, as tools/judge/runner/describe.hpp wrote it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A value in a verdict: "(4, -2) m", "{start (0, 0) m, end (4, 3) m}", "[1, 2] s".
struct Described {
    enum class Kind { number, vector, list, fields, other };
    Kind kind = Kind::other;
    std::string name = {}; ///< of a field, or of an argument; "[2]" for an element of a list
    std::string unit = {};
    double x = 0, y = 0;               ///< of a number or a vector
    std::vector<Described> parts = {}; ///< of a list, unless it was too long to be written out; or the fields
};

/// @return nothing if the text is no value
std::optional<Described> read_described(std::string_view text, std::string name = {});

} // namespace course
