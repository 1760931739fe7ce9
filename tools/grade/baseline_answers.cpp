#include "grade/baseline_answers.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "check/functions.hpp"
#include "check/judge.hpp"

#include <algorithm>
#include <array>

namespace course {
namespace {

/// What each kind of answer gives back, as far as the type takes it; behind it, all that doesn't fit isn't started.
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

std::vector<Trivial> trivial_answers(const Workspace &workspace, const Section &section) {
    const std::string stub = read_file(workspace.stub(section));
    std::vector<Trivial> all{{"the stub as it is", stub}};
    for (const auto &[name, gives] : kinds) {
        std::string text = stub;
        for (const Exercise &exercise : catalogue(workspace, section)) {
            const Functions functions = functions_of(Source{text}, {});
            const Function *function = find_function(functions, exercise.function);
            const std::size_t open =
                function != nullptr ? text.find("throw course::NotYet", function->body) : text.npos;
            if (open == text.npos || open > function->end)
                throw UserError{workspace.relative_name(workspace.stub(section)) + " doesn't throw course::NotYet in "
                                + exercise.function};
            text.replace(open, text.find("};", open) + 2 - open,
                         call(text.substr(function->begin, function->body - function->begin), exercise.function));
        }
        text.insert(text.find("\nnamespace "), helper(gives));
        all.push_back({name, text});
    }
    return all;
}

Baselines measure_baselines(const Workspace &workspace, const Section &section, unsigned seed) {
    Baselines all;
    for (const Trivial &trivial : trivial_answers(workspace, section)) {
        const JudgeResult result = judge(workspace, section, trivial.name, trivial.text, {.seed = seed});
        if (result.unbuilt || result.our_fault())
            throw UserError{"section " + section.short_number() + " can't be judged by `" + trivial.name
                            + "`: " + (result.unbuilt ? result.unbuilt->sentence : "a test says nothing")};
        std::map<std::string, std::size_t> place;
        std::map<std::string, std::vector<std::size_t>> passed;
        for (const Verdict &verdict : result.verdicts) {
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

} // namespace course
