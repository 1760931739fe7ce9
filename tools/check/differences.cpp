#include "check/differences.hpp"

#include "check/scanner.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <string_view>

namespace course::differences {
namespace fs = std::filesystem;

BadAnswer::BadAnswer(const Line &line, const std::string &what)
    : std::runtime_error{line.file->string() + ':' + std::to_string(line.number) + ": " + what} {}

Lines read(const fs::path &file) {
    static std::set<fs::path> names; // which lines point to
    std::ifstream in{file};
    if (!in) throw std::runtime_error{file.string() + " cannot be read"};
    const fs::path *name = &*names.insert(file).first;
    Lines lines;
    for (std::string text; std::getline(in, text);) lines.push_back({text, name, static_cast<int>(lines.size()) + 1});
    return lines;
}

namespace {

std::size_t indentation(const std::string &text) { return std::min(text.find_first_not_of(' '), text.size()); }

/// A line that comes, moved to the right by as much as the solution's lines are further right than the answer's, unless
/// it's as far right as they are.
Line indented(Line line, const std::string &in_solution, const std::string &in_answer) {
    const std::size_t there = indentation(in_solution), here = indentation(in_answer);
    if (indentation(line.text) < there && here < there) line.text.insert(0, there - here, ' ');
    return line;
}

/// Makes a change wherever its lines stand in the solution: once, or this is a mistake.
void apply(const Change &change, const Answer &answer, Lines &solution, const fs::path &file) {
    Lines before;
    for (const auto &[sign, line] : change)
        if (sign != '+') before.push_back(line);
    if (before.empty())
        throw BadAnswer{change[0].second, "where does this line come? Write the line before it, with a blank in front"};

    std::vector<std::size_t> places; // of the solution's own lines that have code
    for (std::size_t i = 0; i < solution.size(); ++i)
        if (*solution[i].file == file && !code_alone(solution[i].text).empty()) places.push_back(i);
    const auto same = [&](std::size_t i, const Line &line) {
        return code_alone(solution[i].text) == code_alone(line.text);
    };
    auto place = places.end();
    int times = 0;
    for (auto at = places.begin();; ++at, ++times) {
        at = std::search(at, places.end(), before.begin(), before.end(), same);
        if (at == places.end()) break;
        place = at;
    }
    const std::string what = before.size() == 1 ? "this line" : "these lines, one after the other,";
    const std::string where = file.string() + ", in what belongs to exercise " + answer.exercise;
    if (times == 0) throw BadAnswer{before[0], what + " must be in " + where + ": copy from there what goes"};
    if (times > 1)
        throw BadAnswer{before[0], what + " must be once in " + where + ", not " + std::to_string(times)
                                       + " times: add a line before or after that stays, with a blank in front"};

    std::size_t next = *place;
    const std::string first = solution[next].text;
    Lines changed{solution.begin(), solution.begin() + static_cast<long>(next)};
    for (const auto &[sign, line] : change) {
        if (sign == '+') {
            changed.push_back(indented(line, first, before[0].text));
            continue;
        }
        for (; next < *place; ++next) changed.push_back(solution[next]);
        if (sign == ' ') changed.push_back(solution[next]);
        ++next;
        ++place;
    }
    for (; next < solution.size(); ++next) changed.push_back(solution[next]);
    solution = std::move(changed);
}

} // namespace

std::vector<Answer> read_differences(const fs::path &file) {
    static const std::regex head{
        R"((\d+\.\d+) ([a-z][a-z0-9_]*)(?:, (\d+ of \d+|(?:\d+ of \d+, )?yours [^:]+))?: (.+))"};
    std::vector<Answer> answers;
    bool open = false; // a change that further lines belong to
    for (const Line &line : read(file)) {
        std::smatch match;
        const char sign = line.text.empty() ? '\n' : line.text[0];
        if (std::regex_match(line.text, match, head)) {
            answers.push_back({line, match[1], match[2], match[3], match[4], {}});
            open = false;
        } else if (code_alone(line.text).empty() || sign == '#') {
            open = false;
        } else if (answers.empty() || std::string_view{"-+ "}.find(sign) == std::string_view::npos) {
            throw BadAnswer{line,
                            "this is neither the head of an answer, as `7.2 meet_never: what is wrong with it`, nor "
                            "a line that goes (-), comes (+) or stays ( )"};
        } else {
            auto &changes = answers.back().changes;
            if (!open) changes.emplace_back();
            open = true;
            changes.back().emplace_back(sign, Line{line.text.substr(1), line.file, line.number});
        }
    }
    for (const Answer &answer : answers)
        if (answer.changes.empty()) throw BadAnswer{answer.head, "this answer changes nothing: which line goes?"};
    return answers;
}

Solution::Solution(const fs::path &file_) : file{file_} {
    static const std::regex title{R"(//>.* (\d+\.\d+)\b.*)"};
    std::string number;
    bool inside = false;
    for (const Line &line : read(file)) {
        std::smatch match;
        if (line.text.starts_with("#include")) includes.push_back(line);
        else if (line.text.starts_with("//>")) {
            inside = line.text != "//>";
            number = std::regex_match(line.text, match, title) ? match[1].str() : "";
        } else if (inside) chunks.emplace_back(number, line);
    }
}

Lines Solution::of(const std::string &exercise) const {
    Lines lines;
    for (const auto &[number, line] : chunks)
        if (number.empty() || number == exercise) lines.push_back(line);
    return lines;
}

Lines Solution::only_of(const std::string &exercise) const {
    Lines lines;
    for (const auto &[number, line] : chunks)
        if (number == exercise) lines.push_back(line);
    return lines;
}

Lines Solution::with(const Answer &answer) const {
    Lines lines = of(answer.exercise);
    for (const Change &change : answer.changes) apply(change, answer, lines, file);
    return lines;
}

} // namespace course::differences
