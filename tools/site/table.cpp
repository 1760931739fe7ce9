#include "site/table.hpp"

#include "ground/lines.hpp"

#include <regex>

namespace course {
namespace {

std::string alignment(const std::string &cell) {
    const bool left = cell.starts_with(':'), right = cell.ends_with(':');
    return left && right ? "center" : right ? "right" : left ? "left" : "";
}

} // namespace

std::vector<std::string> cells_of(std::string_view line) {
    line = without_blanks(line);
    if (line.starts_with('|')) line.remove_prefix(1);
    std::vector<std::string> cells(1);
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t length = line[at] == '\\' ? 2 : 1;
        if (line[at] == '|') cells.emplace_back();
        else cells.back() += line.substr(at, length);
        at += length;
    }
    if (cells.size() > 1 && without_blanks(cells.back()).empty()) cells.pop_back();
    for (std::string &cell : cells) {
        cell = std::string{without_blanks(cell)};
        for (std::size_t at = 0; (at = cell.find("\\|", at)) != cell.npos; ++at) cell.erase(at, 1);
    }
    return cells;
}

std::optional<Table> read_table(const std::vector<std::string_view> &lines) {
    static const std::regex rule{R"(\s*\|?\s*:?-+:?\s*(\|\s*:?-+:?\s*)*\|?\s*)"};
    if (lines.size() < 2 || lines[0].find('|') == std::string_view::npos
        || !std::regex_match(lines[1].begin(), lines[1].end(), rule))
        return {};
    Table table;
    for (const std::string &cell : cells_of(lines[1])) table.alignments.push_back(alignment(cell));
    if (cells_of(lines[0]).size() != table.alignments.size()) return {};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i == 1) continue;
        table.rows.push_back(cells_of(lines[i]));
        table.rows.back().resize(table.alignments.size());
    }
    return table;
}

} // namespace course
