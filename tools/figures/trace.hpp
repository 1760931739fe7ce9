#pragma once
// What a program writes for a figure: a table of numbers behind one line `# name[unit]<tab>name[unit]`. An empty line
// is a gap in a curve; every other line has one finite number for each column.

#include "base/errors.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

struct Trace {
    struct Row {
        std::size_t line;           ///< in the file, from 1
        std::vector<double> values; ///< empty: a gap
    };
    std::vector<std::string> columns; ///< "x[m]"
    std::vector<Row> rows;
};

/// A trace that cannot be drawn. what() tells an author of the course; a student is told by `kind` and `value`.
struct TraceFault : UserError {
    enum Kind { missing, empty, malformed, not_finite };
    TraceFault(Kind of, const std::string &sentence, std::string where = "", std::string what_stands_there = "")
        : UserError{sentence}, kind{of}, column{std::move(where)}, value{std::move(what_stands_there)} {}
    Kind kind;
    std::string column, value; ///< of the value that is not finite, and the value as written
};

/// @param name what messages call the file
/// @throws TraceFault with file, line and column
Trace parse_trace(std::string_view text, const std::string &name);

/// @throws TraceFault, also if there is no such file
Trace read_trace(const std::filesystem::path &path, const std::string &name);

/// The trace as it is kept in the tree, with six significant digits: a thousandth of a pixel in a figure, and far above
/// the last bits in which compilers and their libraries differ.
std::string rounded(const Trace &trace);

/// Where a kept trace and the program's own of today differ first, in one sentence: file, row, column, was, is. "" if
/// they are the same: header, rows and gaps equal, and each number within one unit of the sixth digit (half of it is
/// the rounding) or within 1e-12 of the largest in the column (what is left of a zero after thousands of roundings).
std::string difference(const Trace &kept, const Trace &now, const std::string &name);

} // namespace course
