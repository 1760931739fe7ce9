#include "check/bugs.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/differences.hpp"
#include "check/scanner.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

namespace course {
namespace fs = std::filesystem;
namespace {

/// The words of a text that may be names of functions, types or constants.
std::set<std::string> words_of(std::string_view text) {
    std::set<std::string> words;
    std::string word;
    for (const char c : std::string{text} + ' ') {
        if (is_in_a_name(c)) word += c;
        else words.insert(std::exchange(word, ""));
    }
    return words;
}

/// What a piece of code defines, by the first line: `two` of "static int two(int a) {", "constexpr int two = 2;" and
/// "struct two {".
std::string defined_by(std::string_view line) {
    const std::string_view before =
        without_blanks_behind(line.substr(0, line.starts_with("struct ") ? line.find('{') : line.find_first_of("(={")));
    std::size_t begin = before.size();
    while (begin > 0 && is_in_a_name(before[begin - 1])) --begin;
    return std::string{before.substr(begin)};
}

bool is_at_the_left(std::string_view line) { return !line.empty() && line[0] != ' '; }

/// Whether a function or a definition ends with this line.
bool ends_a_piece(std::string_view line) {
    const std::string_view code = code_alone(line);
    return line.empty() || (is_at_the_left(line) && (code.ends_with('}') || code.ends_with(';')));
}

/// A function of a solution, or something else that stands at the left edge, with the comment above it.
struct Piece {
    std::string defines, text;
};
std::vector<Piece> pieces_of(const differences::Lines &lines) {
    std::vector<Piece> pieces;
    bool ended = true;
    for (const auto &line : lines) {
        const std::string &text = line.text;
        if (ended && is_at_the_left(text) && text[0] != '}') pieces.emplace_back();
        ended = ends_a_piece(text);
        if (pieces.empty()) continue;
        Piece &piece = pieces.back();
        const bool says_what = is_at_the_left(text) && !text.starts_with("//") && !text.starts_with("namespace");
        if (piece.defines.empty() && says_what) piece.defines = defined_by(text);
        piece.text += text + '\n';
    }
    for (Piece &piece : pieces) piece.text.erase(piece.text.find_last_not_of('\n') + 1);
    return pieces;
}

/// Those that a function needs, and itself, in their order: what it calls, and what that calls.
std::string needed(const std::vector<Piece> &pieces, const std::string &function) {
    std::set<std::string> words{function};
    std::vector<bool> chosen(pieces.size());
    for (bool more = true; std::exchange(more, false);)
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (!chosen[i] && words.contains(pieces[i].defines)) {
                words.merge(words_of(pieces[i].text));
                chosen[i] = more = true;
            }
    std::string code;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (chosen[i]) code += '\n' + pieces[i].text + '\n';
    return code;
}

fs::path list_of_bugs(const Workspace &workspace) { return workspace.root / "tests" / "bugs.txt"; }

const differences::Answer &answer_of(const Workspace &workspace, const std::vector<differences::Answer> &answers,
                                     const std::string &exercise, const std::string &name) {
    const auto answer = std::ranges::find(answers, name, &differences::Answer::name);
    if (answer == answers.end() || answer->exercise != exercise)
        throw std::runtime_error{list_of_bugs(workspace).string() + " names " + name + ", which is no wrong answer to "
                                 + exercise};
    return *answer;
}

} // namespace

std::vector<Bug> bugs_of(const Workspace &workspace, const Section &section) {
    if (!workspace.has_answers(section))
        throw UserError{
            "a bug is our answer with a mistake in it, and this course comes without our answers to section "
            + section.short_number()};
    std::vector<Bug> bugs;
    bool is_here = false;
    const std::string all = read_file(list_of_bugs(workspace));
    for (const Line &line : split_lines(all)) {
        const std::string words{trim(line.text)};
        if (words.empty() || words[0] == '#') continue;
        const std::string rest = words.substr(std::min(words.find(' '), words.size() - 1) + 1);
        if (is_digit(words[0])) {
            is_here = words.starts_with(section.short_number() + '.');
            if (is_here) bugs.push_back({.exercise = words.substr(0, words.find(' ')), .name = rest});
        } else if (is_here && words.starts_with("at ")) {
            bugs.back().place = rest;
        } else if (is_here && words.starts_with("or ")) {
            bugs.back().others.push_back(rest);
        } else if (is_here) {
            if (words.starts_with("breaks ")) bugs.back().broken = rest;
            bugs.back().laws.push_back(rest);
        }
    }
    for (Bug &bug : bugs) std::ranges::sort(bug.laws);
    return bugs;
}

Causes causes_of(const Workspace &workspace, const Section &section, const Bug &bug) {
    const auto answers = differences::read_differences(workspace.mutants(section));
    const auto without_its_question = [&](const std::string &name) {
        const std::string claim = answer_of(workspace, answers, bug.exercise, name).claim;
        return claim.substr(0, claim.find(": "));
    };
    Causes causes;
    const std::string right = causes.all.emplace_back(without_its_question(bug.name));
    std::ranges::transform(bug.others, std::back_inserter(causes.all), without_its_question);
    std::ranges::sort(causes.all);
    causes.right = std::size_t(std::ranges::find(causes.all, right) - causes.all.begin());
    return causes;
}

BuggyCode code_of(const Workspace &workspace, const Section &section, const Bug &bug) {
    const auto answers = differences::read_differences(workspace.mutants(section));
    const differences::Answer &answer = answer_of(workspace, answers, bug.exercise, bug.name);
    const differences::Solution solution{workspace.solution(section)};
    std::vector<Piece> pieces = pieces_of(solution.with(answer));
    std::string text, function;
    for (const Exercise &each : catalogue(workspace, section))
        if (each.number == bug.exercise) function = each.function;
        else std::ranges::move(pieces_of(solution.only_of(each.number)), std::back_inserter(pieces));
    for (const auto &include : solution.includes)
        text += include.text + (&include == &solution.includes.front() ? "\n\n" : "\n"); // the section's header first
    text += "\nnamespace " + section.slug() + " {\n" + needed(pieces, function) + "\n} // namespace " + section.slug()
            + '\n';
    return {text, answer.claim};
}

} // namespace course
