#include "class/trivial.hpp"

#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/text.hpp"
#include "loop/functions.hpp"
#include "loop/judge.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace course {
namespace fs = std::filesystem;
namespace {

/// What each kind of answer gives back, as far as its type takes it; behind it, all that doesn't fit isn't started.
constexpr std::array<std::pair<const char *, const char *>, 4> kinds{
    {{"return {}", "if constexpr (std::is_default_constructible_v<T>) return T{};"},
     {"return true", "if constexpr (std::is_convertible_v<bool, T>) return true;"},
     {"return 1", "if constexpr (std::is_convertible_v<int, T>) return 1;"},
     {"return the first argument", "if constexpr (std::is_convertible_v<const First &, T>) return first;"}}};

std::string helper(const char *gives) {
    return std::string{"\ntemplate <class T, class First> T trivial([[maybe_unused]] const First &first) {\n"
                       "    if constexpr (std::is_void_v<T>) return;\n    else {\n        "}
           + gives + "\n        throw course::NotYet{\"\"};\n    }\n}\n";
}

/// Of "double f(const Vec2 &a, double b) ": `return trivial<double>(a)`.
std::string call(const std::string &heading, const std::string &function) {
    const std::size_t name = heading.find(function + '('), from = name + function.size() + 1;
    const std::size_t to = heading.find_first_of(",)", from);
    std::size_t argument = to;
    while (argument > from && is_in_a_name(heading[argument - 1])) --argument;
    return "return trivial<" + heading.substr(0, name) + ">(" + heading.substr(argument, to - argument) + ");";
}

} // namespace

std::vector<Trivial> trivial_answers(const Tree &tree, const Section &section) {
    const std::string stub = read_file(tree.stub(section));
    std::vector<Trivial> all{{"the stub as it is", stub}};
    for (const auto &[name, gives] : kinds) {
        std::string text = stub;
        for (const Exercise &exercise : catalogue(tree, section)) {
            const auto its = definition_of(code_of(text), exercise.function, {});
            const std::size_t open = its ? text.find("throw course::NotYet", its->body) : text.npos;
            if (open == text.npos || open > its->end)
                throw Complaint{tree.shown(tree.stub(section)) + " doesn't throw course::NotYet in "
                                + exercise.function};
            text.replace(open, text.find("};", open) + 2 - open,
                         call(text.substr(its->begin, its->body - its->begin), exercise.function));
        }
        text.insert(text.find("\nnamespace "), helper(gives));
        all.push_back({name, text});
    }
    return all;
}

Baselines measure_baselines(const Tree &tree, const Section &section) {
    Baselines all;
    for (const Trivial &trivial : trivial_answers(tree, section)) {
        const Judgement judgement = judge(tree, section, trivial.name, trivial.text, {});
        if (judgement.unbuilt || judgement.our_fault())
            throw Complaint{"section " + section.short_number() + " can't be judged by `" + trivial.name
                            + "`: " + (judgement.unbuilt ? judgement.unbuilt->sentence : "a test says nothing")};
        std::map<std::string, std::size_t> place;
        std::map<std::string, std::vector<std::size_t>> passed;
        for (const Verdict &verdict : judgement.verdicts) {
            ++place[verdict.exercise];
            if (verdict.passed()) passed[verdict.exercise].push_back(place[verdict.exercise]);
        }
        for (auto &[exercise, places] : passed) all[exercise].insert(std::move(places));
    }
    for (auto &[exercise, sets] : all) // what another one passes as well tells nothing
        std::erase_if(sets, [&sets = sets](const auto &places) {
            return std::ranges::any_of(
                sets, [&](const auto &other) { return &other != &places && std::ranges::includes(other, places); });
        });
    return all;
}

fs::path file_of_baselines(const Tree &tree, const Section &section) {
    return tree.root / "tests" / "baselines" / (section.name + ".txt");
}

std::string to_text(const Baselines &baselines) {
    std::string text;
    for (const auto &[exercise, sets] : baselines)
        for (const auto &places : sets) {
            text += exercise + ':';
            for (const std::size_t place : places) text += ' ' + std::to_string(place);
            text += '\n';
        }
    return text;
}

Baselines read_baselines(const Tree &tree, const Section &section) {
    Baselines all;
    const fs::path file = file_of_baselines(tree, section);
    if (!fs::exists(file))
        throw Complaint{tree.shown(file) + " isn't there: type ./course publish --baselines " + section.short_number()};
    const std::string text = read_file(file);
    for (const Line &line : lines_of(text)) {
        const std::size_t colon = line.text.find(':');
        std::istringstream numbers{std::string{line.text.substr(std::min(colon, line.text.size() - 1) + 1)}};
        std::vector<std::size_t> places;
        for (std::size_t place = 0; numbers >> place;) places.push_back(place);
        all[std::string{line.text.substr(0, colon)}].insert(std::move(places));
    }
    return all;
}

} // namespace course
