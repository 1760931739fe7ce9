#include "book/demo_places.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "book/markdown.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <map>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view play_line = "*Play it:* ";

/// Whether the line was woven below a mark: a picture, or a command.
bool stands_for_a_demo(std::string_view line) {
    return (line.starts_with("![") && contains(line, "](../../demos/")) || line.starts_with(play_line);
}

/// The marks of a chapter by their lines, from 1.
std::map<std::size_t, DemoMark> marks_by_line(std::string_view chapter) {
    std::map<std::size_t, DemoMark> marks;
    for (const DemoMark &mark : demo_marks(chapter)) marks[static_cast<std::size_t>(mark.line)] = mark;
    return marks;
}

/// 4 of "7.4", and 0 of nothing.
int number_in_section(const std::string &exercise) {
    return std::atoi(exercise.substr(exercise.find('.') + 1).c_str());
}

std::string command_that_plays(const Section &section, const DemoMark &mark) {
    return fmt::format("{}`./course play {}{}`. {}", play_line,
                       mark.exercise.empty() ? section.short_number() : mark.exercise, mark.mine ? " --mine" : "",
                       mark.task);
}

} // namespace

std::vector<std::string> demo_starts(const std::vector<DemoMark> &marks) {
    std::vector<std::string> starts;
    for (const DemoMark &mark : marks)
        if (std::ranges::find(starts, mark.start) == starts.end()) starts.push_back(mark.start);
    return starts;
}

std::size_t place_for(const std::vector<DemoMark> &marks, const std::string &exercise, bool mine) {
    const auto below = std::ranges::find_if(marks, [&](const DemoMark &mark) {
        return (mark.mine || !mine)
               && (exercise.empty() || number_in_section(mark.exercise) >= number_in_section(exercise));
    });
    const auto place = below != marks.end() ? below : exercise.empty() ? marks.begin() : marks.end() - 1;
    return static_cast<std::size_t>(place - marks.begin());
}

std::string demo_picture_file(const Section &section, std::size_t start) {
    return "demos/" + section.name + (start == 0 ? "" : '_' + std::to_string(start + 1)) + ".svg";
}

std::string picture_title(const fs::path &svg) {
    const std::string text = fs::exists(svg) ? read_file(svg) : "";
    return std::string{between(text, "<title>", "</title>").value_or("")};
}

std::string picture_words(const std::string &title, const DemoMark &mark) {
    static const std::regex first_sentence{R"(^.*?[.?!](?= [A-Z]|$))"};
    std::smatch match;
    return std::regex_search(mark.task, match, first_sentence) ? title + ' ' + match.str() : title;
}

std::string weave_demo_places(const Workspace &workspace, const Section &section, std::string_view text) {
    const std::vector<Line> lines = split_lines(text);
    const std::map<std::size_t, DemoMark> marks = marks_by_line(text.substr(byte_order_mark(text).size()));
    const bool has_picture = fs::exists(workspace.root / demo_picture_file(section));
    std::string woven;
    std::vector<DemoMark> so_far;
    for (std::size_t at = 0; at < lines.size(); ++at) {
        if (stands_for_a_demo(lines[at].text)) { // it is written anew below the mark, if that is still there
            if (at + 1 < lines.size() && lines[at + 1].text.empty()) ++at;
            continue;
        }
        (woven += lines[at].text) += lines[at].end;
        const auto mark = marks.find(at + 1);
        if (mark == marks.end() || !has_picture) continue;
        const std::string end{lines[at].end};
        const std::size_t known = demo_starts(so_far).size();
        so_far.push_back(mark->second);
        if (demo_starts(so_far).size() > known) {
            const std::string file = demo_picture_file(section, known);
            woven += end
                     + fmt::format("![{}](../../{})", picture_words(picture_title(workspace.root / file), mark->second),
                                   file)
                     + end;
        }
        woven += end + command_that_plays(section, mark->second) + end;
    }
    return woven;
}

} // namespace course
