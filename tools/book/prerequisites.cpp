#include "book/prerequisites.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <regex>

namespace course {
namespace {

constexpr std::string_view line_of_needs = "You need ";
constexpr std::size_t needs_column = 4; // of the contents, from 0

/// `section` of "../07_segment_intersection/README.md".
std::optional<int> section_behind(const std::string &link) {
    static const std::regex chapter{R"((?:^|/)(\d\d)_\w+/README\.md)"};
    std::smatch match;
    return std::regex_search(link, match, chapter) ? std::optional{std::stoi(match[1])} : std::nullopt;
}

void add_need(std::vector<Prerequisite> &all, const Prerequisite &one) {
    const auto known = std::ranges::find(all, one.section, &Prerequisite::section);
    if (known == all.end()) all.push_back(one);
    else if (one.exercise.empty()) known->exercise.clear();
}

/// The row with this text in a cell: 0 is the last one, 1 the one before it.
std::string with_cell(std::string row, int before_last, const std::string &text) {
    std::size_t end = row.rfind('|');
    while (before_last-- > 0) end = row.rfind('|', end - 1);
    const std::size_t start = row.rfind('|', end - 1);
    return row.replace(start + 1, end - start - 1, text.empty() ? " " : ' ' + text + ' ');
}

} // namespace

std::optional<std::vector<Prerequisite>> prerequisites(std::string_view chapter) {
    static const std::regex link{R"((\d+\.\d+)|\[[^\]]*\]\(([^)]*)\)|[.;]\s)"};
    for (const Line &each : split_lines(chapter)) {
        if (!each.text.starts_with(line_of_needs)) continue;
        const std::string line{each.text};
        std::vector<Prerequisite> needed;
        std::string exercise; // the last one since a semicolon or a full stop
        for (std::sregex_iterator match{line.begin(), line.end(), link}, end; match != end; ++match) {
            if ((*match)[1].matched) exercise = (*match)[1];
            else if (!(*match)[2].matched) exercise.clear();
            else if (const auto section = section_behind((*match)[2])) add_need(needed, {*section, exercise});
        }
        return needed;
    }
    return {};
}

std::string needs_cell(const std::vector<Prerequisite> &needed) {
    std::string cell;
    for (const auto &[section, exercise] : needed)
        cell += (cell.empty() ? "" : ", ") + std::to_string(section) + (exercise.empty() ? "" : " for " + exercise);
    return cell;
}

std::vector<Prerequisite> read_needs(std::string_view cell) {
    static const std::regex need{R"((\d+)(?: for (\d+\.\d+))?(?:, |$))"};
    const std::string text{cell};
    std::vector<Prerequisite> needed;
    for (std::sregex_iterator match{text.begin(), text.end(), need}, end; match != end; ++match)
        needed.push_back({std::stoi((*match)[1]), (*match)[2]});
    return needed;
}

Needs weave_needs(const Workspace &workspace, const std::string &book) {
    Needs result;
    std::vector<std::string> rows = with_line_ends(book);
    for (const Entry &entry : contents(book)) {
        const std::filesystem::path chapter = workspace.root / entry.chapter;
        if (entry.chapter.empty() || entry.columns <= needs_column || !std::filesystem::exists(chapter)) continue;
        const std::string text = read_file(chapter);
        const auto needed = prerequisites(text);
        if (!needed) {
            result.findings.push_back({chapter, 1,
                                       "say in a line that begins with \"You need\" what a reader must know before, "
                                       "with a link to each section that this one needs."});
            continue;
        }
        for (const Prerequisite &one : *needed)
            if (one.section >= entry.number)
                result.findings.push_back({chapter, 1,
                                           "what it needs, in the line \"You need\", is not an earlier section: "
                                               + std::to_string(one.section) + "."});
        std::string &row = rows[static_cast<std::size_t>(entry.line) - 1];
        if (needs_cell(*needed) != entry.needs) row = with_cell(row, 0, needs_cell(*needed));
        if (const std::string minutes = minutes_cell(text); !minutes.empty() && minutes != entry.minutes)
            row = with_cell(row, 1, minutes);
    }
    result.book = joined(rows);
    return result;
}

} // namespace course
