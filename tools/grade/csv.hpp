#pragma once
// Tables as CSV, with `,` or `;`, and where each cell stands in the text, so that all else can be left as it is.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace course {

struct CsvCell {
    std::string text;               ///< without quotes
    std::size_t begin = 0, end = 0; ///< where it stands, with quotes
};

struct Csv {
    char separator = ','; ///< the first one of the header line: `,` or `;`
    std::vector<std::vector<CsvCell>> rows;
};

/// Rows end with \n, \r\n or \r; a byte-order mark is skipped.
/// @param file  the name, for complaints
/// @throws UserError with the line, if quotes are broken
Csv read_csv(std::string_view text, const std::string &file);

/// The line of the text, from 1, in which this byte stands.
std::size_t line_at(std::string_view text, std::size_t byte);

/// The text with other words in these cells, quoted where the words need it or the cell was. Nothing else changes.
/// @param cells    where each begins, and what it becomes
/// @param columns  of each row, what's kept besides the first cell, by place; empty: all
std::string with_cells(std::string_view text, const Csv &csv, const std::map<std::size_t, std::string> &cells,
                       const std::set<std::size_t> &columns = {});

/// These words as a cell: in quotes, where they need it.
std::string csv_cell(std::string words, char separator = ',', bool quotes = false);

} // namespace course
