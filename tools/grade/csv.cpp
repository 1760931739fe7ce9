#include "grade/csv.hpp"

#include "base/errors.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"

#include <algorithm>

namespace course {
namespace {

/// Goes through the text, cell by cell.
struct CsvReader {
    std::string_view text;
    const std::string &file;
    char separator = 0; // until the first one is seen
    std::size_t at = 0;

    bool at_line_end() const { return at == text.size() || text[at] == '\n' || text[at] == '\r'; }
    bool at_separator() {
        if (at == text.size() || (text[at] != ',' && text[at] != ';')) return false;
        if (separator == 0) separator = text[at];
        return text[at] == separator;
    }

    [[noreturn]] void complain(std::size_t byte, const std::string &what) const {
        throw UserError{file + ", line " + std::to_string(line_at(text, byte)) + ": " + what
                        + " Download the file again, and don't edit it."};
    }

    /// What's between quotes; a doubled quote is one.
    std::string quoted() {
        const std::size_t opening = at++;
        std::string words;
        for (; at < text.size(); words += text[at++]) {
            if (text[at] != '"') continue;
            ++at;
            if (at == text.size() || text[at] != '"') return words;
        }
        complain(opening, "a quote opens here and never closes.");
    }

    CsvCell cell() {
        CsvCell cell{{}, at, at};
        if (at < text.size() && text[at] == '"') {
            cell.text = quoted();
            if (!at_line_end() && !at_separator()) complain(at, "there's something behind a closing quote.");
        }
        for (; !at_line_end() && !at_separator(); cell.text += text[at++])
            if (text[at] == '"') complain(at, "there's a quote in the middle of a cell.");
        cell.end = at;
        return cell;
    }

    std::vector<CsvCell> row() {
        std::vector<CsvCell> cells{cell()};
        for (; at_separator(); cells.push_back(cell())) ++at;
        at += text.substr(at).starts_with("\r\n") ? 2 : at < text.size() ? 1 : 0;
        return cells;
    }
};

} // namespace

Csv read_csv(std::string_view text, const std::string &file) {
    CsvReader reader{text, file};
    reader.at = byte_order_mark(text).size();
    Csv csv;
    while (reader.at < text.size()) {
        csv.rows.push_back(reader.row());
        if (reader.separator == 0) reader.separator = ','; // only the header line tells
    }
    csv.separator = reader.separator;
    return csv;
}

std::size_t line_at(std::string_view text, std::size_t byte) {
    return std::max<std::size_t>(split_lines(text.substr(0, byte + 1)).size(), 1);
}

std::string csv_cell(std::string words, char separator, bool quotes) {
    if (!quotes && words.find_first_of(std::string{"\"\r\n"} + separator) == words.npos) return words;
    replace_all(words, "\"", "\"\"");
    return '"' + words + '"';
}

std::string with_cells(std::string_view text, const Csv &csv, const std::map<std::size_t, std::string> &cells,
                       const std::set<std::size_t> &columns) {
    std::string out;
    std::size_t copied = 0;
    for (const std::vector<CsvCell> &row : csv.rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            const CsvCell &cell = row[i];
            const std::string_view before = text.substr(copied, cell.begin - copied), // a separator, or a line's end
                was = text.substr(cell.begin, cell.end - cell.begin);
            copied = cell.end;
            if (i > 0 && !columns.empty() && !columns.contains(i)) continue;
            const auto given = cells.find(cell.begin);
            out.append(before).append(
                given == cells.end() ? was : csv_cell(given->second, csv.separator, was.starts_with('"')));
        }
    return out.append(text.substr(copied));
}

} // namespace course
