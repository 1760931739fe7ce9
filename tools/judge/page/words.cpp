// What `./course check` says of a file, for a page, as a WebAssembly module: a request goes in, an answer comes out, both
// JSON in UTF-8. See tools/online/words.mjs for what's in them.

#include "base/plain.hpp"
#include "base/terminal.hpp"
#include "check/diagnosis.hpp"
#include "check/diagnostic.hpp"
#include "check/feedback.hpp"
#include "check/help.hpp"
#include "check/mistakes.hpp"
#include "check/picture.hpp"
#include "check/report.hpp"
#include "check/scanner.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <cxxabi.h>

namespace course {

std::string painted(Colour colour, std::string_view text) { return in_colour(colour, text); } // a page has them all

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Exercise, number, tier, function)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Attempt, number, state, mistake, when)

namespace {

using nlohmann::json;

struct Request {
    SectionFacts facts;
    std::vector<Section> sections;
    std::string name, file, text, only, step, printed, mistakes, symbols;
    std::vector<Verdict> verdicts;
    bool is_sketch = false; ///< it belongs to no section
};

/// Functions of an object, by their names in it, as `nm -C --defined-only` lists them.
std::string listed(const std::vector<std::string> &mangled) {
    std::string list;
    for (const std::string &name : mangled) {
        char *const readable = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, nullptr);
        list += "                 T " + sanitize(readable != nullptr ? readable : name);
        std::free(readable);
    }
    return list;
}

/// @throws json::exception if something that's needed isn't there; std::bad_optional_access for a verdict that is none
Request read_request(const json &from) {
    const auto text = [&](const char *key) { return from.value(key, std::string{}); };
    Request request;
    request.facts = {Section{from.at("section")}, from.at("exercises"), text("header"), text("stub"),
                     read_renamed(text("renamed"))};
    for (const json &name : from.value("sections", json::array())) request.sections.push_back({name});
    request.name = from.value("name", "exercises/" + request.facts.section.name + ".cpp");
    request.file = from.at("file");
    request.text = from.at("text");
    request.only = text("only");
    request.step = from.at("step");
    request.printed = sanitize(text("compiler"));
    request.is_sketch = from.value("sketch", false);
    request.mistakes = text("mistakes");
    request.symbols = listed(from.value("symbols", std::vector<std::string>{}));
    for (const json &verdict : from.value("verdicts", json::array()))
        request.verdicts.push_back(from_line(verdict.dump()).value());
    return request;
}

/// As `judge` goes on where a compiler, a linker and tests have spoken.
JudgeResult judged(const Request &request) {
    const auto &[facts, sections, name, file, text, only, step, printed, mistakes, symbols, reported, is_sketch] =
        request;
    if (!is_sketch)
        if (auto trouble = trouble_in(text, name, facts.section, sections, Reader::page)) return {trouble, {}, {}};
    if (step == "not compiled")
        return {is_sketch ? diagnose_compiler(printed, file, name) : why_not_compiled(printed, file, name, text, facts),
                {},
                {}};
    std::vector<std::string> warnings = find_warnings(printed, file, name);
    for (const std::string &warning : warnings_in(text, name)) warnings.push_back(warning);
    if (step == "not linked")
        return {diagnose_linker(printed, name, facts.section.short_number(), Reader::page), {}, warnings};
    std::vector<Verdict> verdicts = reported;
    help_the_missing(verdicts, symbols, facts);
    help_the_accepting(verdicts, text, facts.stub);
    return {{}, verdicts, warnings};
}

/// How the exercises stand that this check says something of. A file that can't be compiled is held against the one that
/// was asked for; in an empty one all are gone.
json states_of(const Checked &checked) {
    json states = json::object();
    if (const auto &unbuilt = checked.judgement.unbuilt) {
        for (const Exercise &exercise : checked.exercises)
            if (unbuilt->kind == Outcome::empty || exercise.number == checked.only)
                states[exercise.number] = name_of(unbuilt->kind);
    } else
        for (const ExerciseResult &result : checked.results()) states[result.exercise.number] = result.standing();
    return states;
}

/// Of the first failure that can be drawn, as SVG.
json picture_in(const Checked &checked) {
    for (const ExerciseResult &result : checked.results())
        if (const Verdict *failure = result.first_failure())
            if (const auto picture = picture_of(*failure)) return *picture;
    return nullptr;
}

/// What the reader did in the first exercise that's red, if that is known; else "".
std::string mistake_in(const Checked &checked) {
    const std::vector<ExerciseResult> results = checked.results();
    const auto red = std::ranges::find_if(results, [](const ExerciseResult &each) { return each.first_failure(); });
    return red == results.end() ? "" : known_mistake(checked.mistakes, red->verdicts);
}

/// A column in bytes, from 1, as JavaScript counts it.
std::size_t column_in_page(std::string_view line, std::size_t column) {
    std::size_t characters = 1;
    for (const char byte : line.substr(0, column - 1)) {
        const auto bits = static_cast<unsigned char>(byte);
        if ((bits & 0xC0) != 0x80) characters += bits >= 0xF0 ? 2 : 1;
    }
    return characters;
}

/// Where in the file the compiler stopped.
json place_of(const Request &request, const std::optional<Verdict> &unbuilt) {
    if (!unbuilt || unbuilt->file != request.name) return nullptr;
    const auto errors = diagnostics_in(request.printed, request.file);
    const auto error = std::ranges::find_if(errors, [&](const Diagnostic &each) {
        return each.is_error && each.file == request.file && each.line == unbuilt->line && each.column > 0;
    });
    const std::string_view line =
        std::string_view{request.text}.substr(Source{request.text}.line_begins(unbuilt->line));
    const std::size_t column =
        error == errors.end() ? 1 : column_in_page(line, static_cast<std::size_t>(error->column));
    return {{"line", unbuilt->line}, {"column", column}};
}

json answer_to(const json &from) {
    if (from.contains("attempts"))
        return {
            {"text", feedback(from.at("attempts"), from.at("hints"), "Frame by Frame " COURSE_VERSION ", in a page")}};
    const Request request = read_request(from);
    const Checked checked{request.name, request.text,    judged(request), request.facts.exercises,
                          request.only, request.mistakes};
    return {{"text", explain(checked, {.reader = Reader::page})},
            {"states", states_of(checked)},
            {"picture", picture_in(checked)},
            {"mistake", mistake_in(checked)},
            {"place", place_of(request, checked.judgement.unbuilt)}};
}

std::string asked, answered;

} // namespace
} // namespace course

/// Room for so many bytes of a request.
extern "C" [[clang::export_name("room")]] char *room(std::size_t size) {
    course::asked.resize(size);
    return course::asked.data();
}

/// Answers what was put there. @return how many bytes the answer has
extern "C" [[clang::export_name("answer")]] std::size_t answer() {
    using nlohmann::json;
    json answer;
    try {
        answer = course::answer_to(json::parse(course::asked));
    } catch (const std::exception &trouble) {
        answer = {{"error", trouble.what()}};
    }
    course::answered = answer.dump(-1, ' ', false, json::error_handler_t::replace);
    return course::answered.size();
}

/// Where the answer is.
extern "C" [[clang::export_name("reply")]] const char *reply() { return course::answered.data(); }
