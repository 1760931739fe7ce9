#include "check/outline.hpp"

#include "base/lines.hpp"
#include "base/text.hpp"
#include "check/answer.hpp"
#include "check/diagnosis.hpp"
#include "check/functions.hpp"

#include <algorithm>

namespace course {
namespace {

struct Flaw {
    std::size_t place;
    std::string sentence;
};

/// What came with the text from a web page, a chat or a word processor.
std::optional<Flaw> find_pasted(const Source &source) {
    for (const std::size_t line : source.lines)
        if (source.code.compare(line, 3, "```") == 0)
            return Flaw{
                line,
                "Lines with ``` belong to a web page or a chat, not to C++: delete this one, and the one that ends "
                "the code."};
    for (const char *quote : {"“", "”", "‘", "’"})
        if (const std::size_t place = source.code.find(quote); place != source.code.npos)
            return Flaw{place, "Curly quotes like “ and ’ aren't C++: type straight ones, \" or ', in your editor."};
    return {};
}

/// The lines that stand around all functions.
std::optional<Flaw> find_gone(const Source &source, std::string_view text, const Section &section) {
    const std::string slug = section.slug(), header = slug + ".hpp";
    const auto lines = split_lines(text);
    if (std::ranges::none_of(lines, [&](const Line &line) { return included(line.text) == header; }))
        return Flaw{source.code.size(), "Your file doesn't include its section's header: put #include \"" + header
                                            + "\" back, above all functions."};
    if (!contains(source.code, slug + "::") && !opens_namespace(source, slug))
        return Flaw{source.code.size(),
                    "The line `namespace " + slug + " {` is gone: put it back above your functions."};
    return {};
}

/// "5.1 stopping_distance", or the name of a helper.
std::string with_number(const std::vector<Exercise> &exercises, const std::string &function) {
    const auto exercise = std::ranges::find(exercises, function, &Exercise::function);
    return (exercise == exercises.end() ? "" : exercise->number + ' ') + function;
}

std::string explain_fault(const Fault &fault, const std::string &code, const std::string &function) {
    const std::string bracket = code.substr(fault.place, 1), other = bracket == "("   ? ")"
                                                                     : bracket == "[" ? "]"
                                                                     : bracket == "{" ? "}"
                                                                                      : "{";
    switch (fault.what) {
    case Fault::What::no_comment:
        return "In " + function + ", the comment that starts here never ends: put */ behind it.";
    case Fault::What::no_quote:
        return "In " + function + ", the quote that starts here never ends: put the same mark behind it.";
    case Fault::What::no_body: return "In " + function + ", a { is missing behind this line: the body starts there.";
    case Fault::What::not_closed:
        return "In " + function + ", this " + bracket + " never closes: put the " + other + " where it's missing.";
    case Fault::What::too_many: break;
    }
    return bracket == "}"
               ? "In " + function + ", this } is one too many: delete it, or put the { above that it should close."
               : "In " + function + ", this " + bracket
                     + " is one too many: delete it, or put the bracket before it that it should close.";
}

/// The first function whose brackets don't fit.
std::optional<Flaw> find_fault(const Source &source, const SectionFacts &facts, int stopped) {
    const Functions of_stub = functions_of(Source{facts.stub}, {});
    std::vector<std::string> known;
    std::ranges::transform(of_stub, std::back_inserter(known), &Function::name);
    for (const Function &each : functions_of(source, known))
        if (each.fault) {
            if (source.line_of(each.fault->place) == stopped && each.fault->what != Fault::What::no_comment) return {};
            return Flaw{each.fault->place,
                        explain_fault(*each.fault, source.code, with_number(facts.exercises, each.name))};
        }
    return {};
}

} // namespace

std::optional<Verdict> diagnose_outline(std::string_view text, const std::string &name, const SectionFacts &facts,
                                        int stopped) {
    const Source source{text};
    std::optional<Flaw> flaw = find_pasted(source);
    if (!flaw) flaw = find_gone(source, text, facts.section);
    if (!flaw) flaw = find_fault(source, facts, stopped);
    if (!flaw) return {};
    Verdict verdict{.kind = Outcome::does_not_compile, .sentence = flaw->sentence};
    if (flaw->place == source.code.size()) return verdict; // a line that isn't there
    verdict.file = name;
    verdict.line = source.line_of(flaw->place);
    const std::size_t line = source.line_begins(verdict.line);
    verdict.printed = {numbered(verdict.line, text.substr(line, text.find_first_of("\r\n", line) - line))};
    return verdict;
}

} // namespace course
