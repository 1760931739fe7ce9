#include "book/prerequisites.hpp"

#include "book/markdown.hpp"
#include "ground/files.hpp"
#include "ground/lines.hpp"

#include <algorithm>
#include <regex>

namespace course {
namespace {

constexpr std::string_view line_of_needs = "You need ";
constexpr std::size_t needs_column = 4; // of the contents, from 0

/// `section` of "../07_segment_intersection/README.md".
std::optional<int> section_behind(const std::string &link) {
    static const std::regex chapter{R"((?:^|/)(\d\d)_\w+/README\.md)"};
    std::smatch found;
    return std::regex_search(link, found, chapter) ? std::optional{std::stoi(found[1])} : std::nullopt;
}

void add_need(std::vector<Prerequisite> &all, const Prerequisite &one) {
    const auto known = std::ranges::find(all, one.section, &Prerequisite::section);
    if (known == all.end()) all.push_back(one);
    else if (one.exercise.empty()) known->exercise.clear();
}

/// The row with this text as its last cell.
std::string with_last_cell(std::string row, const std::string &text) {
    const std::size_t end = row.rfind('|'), start = row.rfind('|', end - 1);
    return row.replace(start + 1, end - start - 1, text.empty() ? " " : ' ' + text + ' ');
}

} // namespace

std::optional<std::vector<Prerequisite>> prerequisites(std::string_view chapter) {
    static const std::regex link{R"((\d+\.\d+)|\[[^\]]*\]\(([^)]*)\)|[.;]\s)"};
    for (const Line &each : lines_of(chapter)) {
        if (!each.text.starts_with(line_of_needs)) continue;
        const std::string line{each.text};
        std::vector<Prerequisite> needed;
        std::string exercise; // the last one since a semicolon or a full stop
        for (std::sregex_iterator found{line.begin(), line.end(), link}, end; found != end; ++found) {
            if ((*found)[1].matched) exercise = (*found)[1];
            else if (!(*found)[2].matched) exercise.clear();
            else if (const auto section = section_behind((*found)[2])) add_need(needed, {*section, exercise});
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
    for (std::sregex_iterator found{text.begin(), text.end(), need}, end; found != end; ++found)
        needed.push_back({std::stoi((*found)[1]), (*found)[2]});
    return needed;
}

Needs weave_needs(const Tree &tree, const std::string &book) {
    Needs result;
    std::vector<std::string> rows = with_line_ends(book);
    for (const Entry &entry : contents(book)) {
        const std::filesystem::path chapter = tree.root / entry.chapter;
        if (entry.chapter.empty() || entry.columns <= needs_column || !std::filesystem::exists(chapter)) continue;
        const auto needed = prerequisites(read_file(chapter));
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
        if (needs_cell(*needed) != entry.needs) row = with_last_cell(row, needs_cell(*needed));
    }
    result.book = joined(rows);
    return result;
}

} // namespace course
