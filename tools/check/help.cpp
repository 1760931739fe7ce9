#include "check/help.hpp"

#include "check/answer.hpp"
#include "check/diagnosis.hpp"
#include "check/outline.hpp"

#include <map>

namespace course {

std::optional<Verdict> trouble_in(std::string_view text, const std::string &name, const Section &section,
                                  const std::vector<Section> &all, Reader reader) {
    if (auto trouble = diagnose_text(text, name, section.short_number(), reader)) return trouble;
    return diagnose_section(text, name, section, all, reader);
}

Verdict why_not_compiled(std::string_view printed, const std::string &file, const std::string &name,
                         std::string_view text, const SectionFacts &facts) {
    Verdict why = diagnose_compiler(printed, file, name, text, facts.renamed);
    if (why.sentence == explain_unopened()) return why;
    return diagnose_outline(text, name, facts, why.line).value_or(std::move(why));
}

std::vector<std::string> warnings_in(std::string_view text, const std::string &name) {
    std::vector<std::string> warnings = find_unreached(text, name);
    for (const std::string &warning : find_whole_divisions(text, name)) warnings.push_back(warning);
    return warnings;
}

void help_the_missing(std::vector<Verdict> &verdicts, std::string_view symbols, const SectionFacts &facts) {
    std::map<std::string, std::string> explained; // once for each function, however many tests call it
    for (Verdict &verdict : verdicts)
        if (verdict.kind == Outcome::missing && verdict.call) {
            const auto [more, is_new] = explained.try_emplace(verdict.call->function);
            if (is_new) more->second = explain_missing(symbols, facts.header, more->first, facts.renamed);
            verdict.sentence += more->second;
        }
}

void help_the_accepting(std::vector<Verdict> &verdicts, std::string_view text, std::string_view stub) {
    for (Verdict &verdict : verdicts)
        if (!verdict.accepted.empty())
            if (const auto more = explain_accepted(text, stub, verdict.exercise); !more.empty()) {
                verdict.sentence.back() = '.'; // instead of the colon before the list
                verdict.sentence += more;
            }
}

} // namespace course
