#include "book/contents.hpp"

#include "ground/complaint.hpp"
#include "ground/lines.hpp"

#include <optional>
#include <regex>
#include <vector>

namespace course {
namespace {

std::vector<std::string> with_line_ends(const std::string &text) {
    std::vector<std::string> lines;
    for (const Line &line : lines_of(text)) lines.push_back(std::string{line.text} + std::string{line.end});
    return lines;
}

std::string joined(const std::vector<std::string> &lines) {
    std::string text;
    for (const std::string &line : lines) text += line;
    return text;
}

std::string end_of(const std::string &line) { return line.ends_with("\r\n") ? "\r\n" : "\n"; }

/// Puts `line` where its number belongs among the lines that have one; `number_of` gives it, or nothing.
/// @return whether there are such lines
template <class NumberOf>
bool put_in_order(std::vector<std::string> &lines, const std::string &line, int number, NumberOf number_of) {
    std::optional<std::size_t> place;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::optional<int> other = number_of(lines[i]);
        if (other && (*other < number || !place)) place = *other < number ? i + 1 : i;
    }
    if (place) lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(*place), line);
    return place.has_value();
}

// Contents are a table or a list whose entries link to the chapters: `| 7 | [Segment ...](chapters/07_.../README.md) | 3 h |`.
// An entry to come has no link, but its number, in the first cell or behind the bullet.

const std::regex chapter_link{R"(\[([^\]]*)\]\(chapters/(\d\d)_[a-z0-9_]+/README\.md\))"};
const std::regex unlinked{R"(^(?:\||[-*])\s*(\d{1,2})\b.*)"};

std::optional<int> number_of_entry(const std::string &line) {
    std::smatch found;
    if (std::regex_search(line, found, chapter_link)) return std::stoi(found[2]);
    return std::nullopt;
}

/// A line like `model` for the section: its number, title and link in the same places, and nothing in the others.
std::string entry_like(const std::string &model, const Section &section, const std::string &title) {
    std::smatch old;
    std::regex_search(model, old, chapter_link);
    static const std::regex numbered{R"(0?\d+\.? .*)"};
    const bool with_number = std::regex_match(old[1].str(), numbered);
    const std::string words = with_number ? section.short_number() + " " + title : title;
    const std::string reference = "[" + words + "](chapters/" + section.name + "/README.md)";
    if (!model.starts_with("|"))
        return model.substr(0, model.find_first_not_of("-* ")) + (with_number ? "" : section.short_number() + " ")
               + reference + end_of(model);

    static const std::regex cell{R"(\|([^|\r\n]*))"}, number{R"(\s*0?(\d{1,2})\s*)"};
    std::string entry;
    for (std::sregex_iterator found{model.begin(), model.end(), cell}, end; found != end; ++found) {
        const std::string old_cell = (*found)[1];
        if (std::regex_search(old_cell, chapter_link)) entry += "| " + reference + " ";
        else if (std::smatch its; std::regex_match(old_cell, its, number) && std::stoi(its[1]) == std::stoi(old[2]))
            entry += "| " + section.short_number() + " ";
        else entry += old_cell.empty() ? "|" : "| ";
    }
    return entry + end_of(model);
}

} // namespace

std::string with_section(const std::string &cmake_lists, const Section &section) {
    static const std::regex call{R"(^[ \t]*section\([ \t]*(\d\d)_[^)]*\)\s*(#.*\s*)?)"};
    std::vector<std::string> lines = with_line_ends(cmake_lists);
    const bool put =
        put_in_order(lines, "section(" + section.name + ")\n", section.number(), [](const std::string &line) {
            std::smatch found;
            return std::regex_match(line, found, call) ? std::optional{std::stoi(found[1])} : std::nullopt;
        });
    if (!put)
        throw Complaint{"CMakeLists.txt has no line like section(07_segment_intersection), so it is not clear where "
                        "the new one belongs"};
    return joined(lines);
}

std::string title_to_come(const std::string &book, int number) {
    static const std::regex entry{R"(\|\s*0?(\d{1,2})\s*\|\s*([^|\[]*[^|\[\s])\s*\|.*to come.*)"};
    std::smatch found;
    for (const Line &line : lines_of(book))
        if (const std::string text{line.text}; std::regex_match(text, found, entry) && std::stoi(found[1]) == number)
            return found[2];
    return "";
}

std::string with_entry(const std::string &book, const Section &section, const std::string &title) {
    std::vector<std::string> lines = with_line_ends(book);
    std::optional<std::size_t> model;
    for (std::size_t i = 0; i < lines.size() && !model; ++i)
        if (number_of_entry(lines[i])) model = i;
    if (!model)
        throw Complaint{"the contents of book.md link to no chapter yet, as in [7 Segment "
                        "intersection](chapters/07_segment_intersection/README.md); write the first entry by hand"};

    // The contents are what stands together with that entry: lines of the same kind, without a gap.
    const char kind = lines[*model][0];
    std::size_t first = *model, last = *model;
    while (first > 0 && lines[first - 1][0] == kind) --first;
    while (last + 1 < lines.size() && lines[last + 1][0] == kind) ++last;

    const std::string entry = entry_like(lines[*model], section, title);
    std::vector<std::string> contents(lines.begin() + static_cast<std::ptrdiff_t>(first),
                                      lines.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto number = [](const std::string &line) -> std::optional<int> {
        std::smatch found;
        if (const auto linked = number_of_entry(line)) return linked;
        return std::regex_search(line, found, unlinked) ? std::optional{std::stoi(found[1])} : std::nullopt;
    };
    std::erase_if(contents,
                  [&](const std::string &line) { return !number_of_entry(line) && number(line) == section.number(); });
    put_in_order(contents, entry, section.number(), number);
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(first),
                lines.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(first), contents.begin(), contents.end());
    return joined(lines);
}

} // namespace course
