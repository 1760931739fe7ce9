#include "check/others.hpp"

#include "check/differences.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace course {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t shown_others = 3;

/// The lines of an answer, without those that belong to every exercise.
std::string own_lines(const differences::Solution &solution, const differences::Answer &answer) {
    const auto place = [](const differences::Line &line) { return std::pair{*line.file, line.number}; };
    std::set<std::pair<fs::path, int>> common;
    for (const auto &line : solution.of(answer.exercise)) common.insert(place(line));
    for (const auto &line : solution.only_of(answer.exercise)) common.erase(place(line));
    std::string code;
    for (const auto &line : solution.with(answer))
        if (!common.contains(place(line))) code += line.text + '\n';
    code.erase(0, code.find_first_not_of('\n'));
    code.erase(code.find_last_not_of('\n') + 1);
    return code + '\n';
}

std::string words_of(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

} // namespace

std::vector<OtherAnswer> other_answers(const Workspace &workspace, const Section &section, std::string_view number) {
    const fs::path file = workspace.tests_folder(section) / "variants.diff";
    std::vector<OtherAnswer> others;
    if (!fs::exists(file) || !workspace.has_solution(section)) return others;
    const differences::Solution solution{workspace.solution(section)};
    for (const differences::Answer &answer : differences::read_differences(file))
        if (answer.exercise == number && others.size() < shown_others)
            others.push_back({words_of(answer.name) + ": " + answer.claim, own_lines(solution, answer)});
    return others;
}

std::string words_for_others(std::size_t count) {
    constexpr std::array words{"Another way to write it", "Two other ways to write it", "Three other ways to write it"};
    return words.at(count - 1);
}

} // namespace course
