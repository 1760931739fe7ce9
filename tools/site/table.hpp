#pragma once
// Pipe tables: a forge knows them, cmark does not.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

struct Table {
    std::vector<std::string> alignments;        ///< of each column: "left", "right", "center" or ""
    std::vector<std::vector<std::string>> rows; ///< the cells' Markdown; the first row is the head
};

/// The cells of a line `| a | b |`. Within a cell, and be it in code, a `|` is written `\|`, as forges want it.
std::vector<std::string> cells_of(std::string_view line);

/// The table that these lines are, or nothing: the second one decides, `|--:|:--|`.
std::optional<Table> read_table(const std::vector<std::string_view> &lines);

} // namespace course
