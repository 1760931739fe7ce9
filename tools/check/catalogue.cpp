#include "check/catalogue.hpp"

#include "base/files.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"

#include <nlohmann/json.hpp>

namespace course {
namespace {

/// One of the lists that the section's tests printed when they were built.
template <class Element, class Read>
std::vector<Element> read_list(const Workspace &workspace, const Section &section, const char *name, Read read) {
    const std::filesystem::path file = workspace.catalogue(section);
    if (!is_built(workspace, section))
        throw UserError{section.name + " isn't built yet: type ./course, which builds all"};
    const auto json = nlohmann::json::parse(read_file(file), nullptr, false);
    std::vector<Element> result;
    try {
        for (const auto &element : json.at(name)) result.push_back(read(element));
    } catch (const nlohmann::json::exception &) {
        throw UserError{file.string() + " is broken: delete it, and type ./course, which makes a new one"};
    }
    return result;
}

std::string numbers(const std::vector<Exercise> &exercises) {
    std::string result;
    for (const Exercise &e : exercises) result += (result.empty() ? "" : ", ") + e.number;
    return result;
}

/// "7.2" in a section that is there: the exercise, or which ones there are.
FoundExercise by_number(const Workspace &workspace, const std::string &number) {
    const Section section = workspace.section(number);
    const std::vector<Exercise> exercises = catalogue(workspace, section);
    for (const Exercise &e : exercises)
        if (e.number == number) return {section, e};
    throw UserError{"there's no exercise " + number + "; section " + section.short_number() + " has "
                    + numbers(exercises)};
}

FoundExercise by_function(const Workspace &workspace, const std::string &word) {
    std::vector<std::string> functions;
    for (const Section &section : workspace.sections()) {
        if (!is_built(workspace, section)) continue;
        for (const Exercise &e : catalogue(workspace, section)) {
            if (e.function == word) return {section, e};
            functions.push_back(e.function);
        }
    }
    throw UserError{"there's no exercise `" + word + "`." + did_you_mean(word, functions)
                    + " An exercise is named by its number, as 7.2, or its function; `./course list` shows them all"};
}

} // namespace

bool is_built(const Workspace &workspace, const Section &section) {
    return std::filesystem::exists(workspace.catalogue(section));
}

std::vector<Exercise> catalogue(const Workspace &workspace, const Section &section) {
    return read_list<Exercise>(workspace, section, "exercises", [](const nlohmann::json &e) {
        return Exercise{e.at("number"), e.at("tier"), e.at("function")};
    });
}

std::vector<KnownTest> tests_of(const Workspace &workspace, const Section &section) {
    return read_list<KnownTest>(workspace, section, "tests", [](const nlohmann::json &e) {
        return KnownTest{e.at("exercise"), e.at("claim")};
    });
}

std::vector<Renamed> renamed(const Workspace &workspace, const Section &section) {
    const std::filesystem::path file = workspace.renamed(section);
    if (!std::filesystem::exists(file)) return {};
    return read_renamed(read_file(file));
}

SectionFacts facts_of(const Workspace &workspace, const Section &section) {
    return {section, catalogue(workspace, section), read_file(workspace.header(section)),
            read_file(workspace.stub(section)), renamed(workspace, section)};
}

bool is_number_of_exercise(std::string_view words) {
    const std::size_t dot = std::min(words.find('.'), words.size());
    return is_all_digits(words.substr(0, dot)) && dot < words.size() && is_all_digits(words.substr(dot + 1));
}

FoundExercise find_exercise(const Workspace &workspace, std::string_view words) {
    const std::string typed{words};
    if (is_number_of_exercise(typed)) return by_number(workspace, typed.substr(typed.find_first_not_of('0')));

    if (is_all_digits(typed)) {
        const Section section = workspace.section(typed);
        throw UserError{"which exercise of section " + section.short_number() + "? It has "
                        + numbers(catalogue(workspace, section))};
    }
    return by_function(workspace, typed);
}

} // namespace course
