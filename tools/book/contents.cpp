#include "book/contents.hpp"

#include "base/lines.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <regex>

namespace course {
namespace {

std::optional<int> number_in(const std::string &cell) {
    static const std::regex number{R"(\d{1,2})"};
    return std::regex_match(cell, number) ? std::optional{std::stoi(cell)} : std::nullopt;
}

} // namespace

std::vector<Entry> contents(std::string_view book) {
    for (const Table &table : tables(book)) {
        std::vector<Entry> entries;
        for (const auto &[line, cells] : table)
            if (const auto number = number_in(cells[0].words); number && cells.size() > 1)
                entries.push_back({line, *number, cells[1].words, cells[1].link, cells.size() > 2 ? cells[2].words : "",
                                   cells.size() > 3 ? cells[3].words : "", cells.size() > 4 ? cells[4].words : "",
                                   cells.size()});
        if (!entries.empty()) return entries;
    }
    return {};
}

std::string minutes_cell(std::string_view chapter) {
    static const std::regex exercise{R"(\d+\.\d+)"}, minutes{R"((\d+) \+ (\d+))"};
    int core = 0, others = 0, reading = 0;
    for (const Table &table : tables(chapter))
        for (const auto &[line, cells] : table) {
            std::smatch match;
            if (cells.size() < 4 || !std::regex_match(cells[0].words, exercise)
                || !std::regex_match(cells[3].words, match, minutes))
                continue;
            reading += std::stoi(match[1]);
            (cells[2].words == "core" ? core : others) += std::stoi(match[1]) + std::stoi(match[2]);
        }
    if (core == 0) core = reading, others -= reading;
    const auto rounded = [](int all) { return (all + 2) / 5 * 5; };
    return core + others == 0 ? "" : fmt::format("{} + {}", rounded(core), rounded(others));
}

std::string title_to_come(std::string_view book, int number) {
    for (const Entry &entry : contents(book))
        if (entry.number == number && entry.chapter.empty()) return entry.title;
    return "";
}

std::string with_entry(const std::string &book, const Section &section, const std::string &title) {
    const std::vector<Entry> entries = contents(book);
    if (entries.empty())
        throw UserError{"book.md has no contents: write a table with a row like | 7 | [Segment intersection]"
                        "(chapters/07_segment_intersection/README.md) |"};
    std::vector<std::string> lines = with_line_ends(book);
    const std::string like = lines.at(static_cast<std::size_t>(entries.front().line) - 1);
    std::string row = fmt::format("| {} | [{}](chapters/{}/README.md) |", section.number(), title, section.name);
    for (std::size_t column = 2; column < entries.front().columns; ++column) row += " |";
    row += like.ends_with("\r\n") ? "\r\n" : "\n";

    const auto same_or_later = std::ranges::find_if(
        entries, [&](int number) { return number >= section.number(); }, &Entry::number);
    const bool at_the_end = same_or_later == entries.end();
    const int line = at_the_end ? entries.back().line + 1 : same_or_later->line;
    const auto place = lines.begin() + line - 1;
    if (!at_the_end && same_or_later->number == section.number()) *place = row;
    else lines.insert(place, row);
    return joined(lines);
}

std::string with_section(const std::string &cmake_lists, const Section &section) {
    std::vector<std::string> lines = with_line_ends(cmake_lists);
    std::optional<std::vector<std::string>::iterator> place;
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        const auto added = section_added_by(*line);
        if (!added) continue;
        const bool earlier = added->number() < section.number();
        if (earlier || !place) place = earlier ? line + 1 : line;
    }
    if (!place)
        throw UserError{"CMakeLists.txt has no line like section(07_segment_intersection), so there is no place for "
                        "the new one"};
    lines.insert(*place, "section(" + section.name + ")\n");
    return joined(lines);
}

} // namespace course
