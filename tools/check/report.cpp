#include "check/report.hpp"

#include "base/terminal.hpp"
#include "base/text.hpp"
#include "check/answer.hpp"
#include "check/mistakes.hpp"
#include "check/picture.hpp"

#include <algorithm>
#include <functional>

namespace course {
namespace {

const Verdict *first(const std::vector<Verdict> &verdicts, const auto &of) {
    const auto verdict = std::ranges::find_if(verdicts, of);
    return verdict == verdicts.end() ? nullptr : &*verdict;
}

std::string explain_failure(const Verdict &verdict) {
    std::string text = "    " + painted(Colour::red, "✗") + ' ' + painted(Colour::bold, verdict.test);
    if (verdict.kind != Outcome::wrong) text += "  " + painted(Colour::red, name_of(verdict.kind));
    return text + '\n' + explain(verdict, 6);
}

/// The line of an exercise that isn't just not started.
std::string head_of(const ExerciseResult &result) {
    const auto &[exercise, verdicts] = result;
    const bool passed = result.first_failure() == nullptr;
    const std::string all = pluralize(verdicts.size(), "test"),
                      some = std::to_string(std::ranges::count_if(verdicts, &Verdict::passed)) + " of " + all;
    return painted(passed ? Colour::green : Colour::red,
                   (passed ? "✓ " : "✗ ") + exercise.number + ' ' + exercise.function + ", " + exercise.tier)
           + ": " + (passed ? all : some) + " passed\n";
}

/// The tests of an exercise: of those that failed the first in full, since one is fixed at a time.
std::string explain_tests(const ExerciseResult &result, const ReportOptions &how) {
    constexpr std::size_t most = 3; // claims beside the first: enough to guess from
    const Verdict *failure = result.first_failure();
    std::string text;
    std::size_t failures = 0;
    for (const Verdict &verdict : result.verdicts) {
        if (!verdict.passed()) ++failures;
        if (failures > 1 && failure->kind == Outcome::missing) continue; // once is enough
        if (verdict.passed()) {
            if (how.verbose) text += "    " + painted(Colour::green, "✓") + ' ' + verdict.test + '\n';
        } else if (failures == 1 || how.verbose) {
            text += explain_failure(verdict);
            if (how.picture && &verdict == failure && picture_of(verdict))
                text += "      picture   ./course check " + result.exercise.number + " --picture\n";
        } else if (failures <= 1 + most) text += "    " + painted(Colour::red, "✗") + ' ' + verdict.test + '\n';
    }
    if (failures > 1 + most && !how.verbose && failure->kind != Outcome::missing)
        text += painted(Colour::dim, "      and " + std::to_string(failures - 1 - most) + " more"
                                         + (how.reader == Reader::page ? "" : " (-v shows all)"))
                + '\n';
    return text;
}

/// An exercise in one line; what is wrong below it.
std::string explain_result(const ExerciseResult &result, const Checked &checked, const ReportOptions &how) {
    const auto &[exercise, verdicts] = result;
    if (const Verdict *open = result.first_open())
        return painted(Colour::dim, "· " + exercise.number + ' ' + exercise.function + ", " + exercise.tier) + ": "
               + (how.verbose ? open->sentence : result.standing()) + '\n';
    std::string text = head_of(result) + explain_tests(result, how);
    std::string known = known_mistake(checked.mistakes, verdicts);
    known = known.empty() ? lost_digits(checked.text, verdicts) : "This is what comes out when " + known;
    if (!known.empty()) text += "    " + painted(Colour::yellow, known) + '\n';
    return text;
}

/// Without those in the functions of other exercises than the one that was asked for.
std::vector<std::string> warnings_of(const Checked &checked) {
    if (checked.only.empty()) return checked.judgement.warnings;
    std::vector<std::string> others;
    for (const Exercise &exercise : checked.exercises)
        if (exercise.number != checked.only) others.push_back(exercise.function);
    return warnings_about(checked.judgement.warnings, checked.text, checked.name, others);
}

} // namespace

const Verdict *ExerciseResult::first_failure() const { return first(verdicts, std::not_fn(&Verdict::passed)); }

const Verdict *ExerciseResult::first_open() const {
    return first(verdicts, [](const Verdict &v) { return v.kind == Outcome::not_started; });
}

Outcome ExerciseResult::state() const {
    const Verdict *failure = first_failure();
    return failure == nullptr ? Outcome::passed : first_open() ? Outcome::not_started : failure->kind;
}

std::string ExerciseResult::standing() const {
    const Verdict *open = first_open();
    return open == nullptr || open->needs.empty() ? std::string{name_of(state())} : "needs " + open->needs;
}

std::vector<ExerciseResult> Checked::results() const {
    std::vector<ExerciseResult> all;
    for (const Exercise &exercise : exercises) {
        if (!only.empty() && exercise.number != only) continue;
        ExerciseResult result{exercise, {}};
        std::ranges::copy_if(judgement.verdicts, std::back_inserter(result.verdicts),
                             [&](const Verdict &v) { return v.exercise == exercise.number; });
        all.push_back(std::move(result));
    }
    return all;
}

bool Checked::never_started() const {
    const auto &verdicts = judgement.verdicts;
    const Verdict &first = verdicts.front();
    return !first.passed() && first.kind != Outcome::missing && first.kind != Outcome::not_started
           && std::ranges::all_of(verdicts, [&](const Verdict &v) { return !v.call && v.sentence == first.sentence; });
}

std::string explain(const Checked &checked, const ReportOptions &how) {
    std::string text = explain_warnings(warnings_of(checked), how);
    if (checked.judgement.unbuilt) return text + explain_unbuilt(*checked.judgement.unbuilt, checked.name);
    if (checked.never_started()) {
        Verdict of_all = checked.judgement.verdicts.front();
        of_all.test = "no test could start:";
        of_all.file.clear();
        return text + explain_failure(of_all);
    }
    for (const ExerciseResult &result : checked.results()) text += explain_result(result, checked, how);
    return text;
}

std::string explain_unbuilt(const Verdict &verdict, const std::string &name) {
    std::string text = painted(Colour::red, "✗ " + name + ' ' + std::string{name_of(verdict.kind)}) + "\n    ";
    if (!verdict.file.empty()) text += verdict.file + ':' + std::to_string(verdict.line) + ": ";
    text += verdict.sentence + '\n';
    for (const auto &line : verdict.printed) text += "    " + line + '\n';
    if (verdict.printed_more > 0)
        text += "    (" + std::to_string(verdict.printed_more) + " more "
                + (verdict.printed_more == 1 ? "error" : "errors") + "; the first one first)\n";
    return text;
}

std::string explain_warnings(const std::vector<std::string> &warnings, const ReportOptions &how) {
    constexpr std::size_t most = 5;
    const std::size_t told = how.verbose ? warnings.size() : std::min(most, warnings.size());
    std::string text;
    for (std::size_t i = 0; i < told; ++i) text += painted(Colour::yellow, "warning ") + warnings[i] + '\n';
    if (warnings.size() > told)
        text += "  and " + std::to_string(warnings.size() - told) + " more warnings"
                + (how.reader == Reader::page ? "" : " (-v shows all)") + '\n';
    return text;
}

std::string explain_next(const Standing *next, const std::string &number) {
    if (next == nullptr)
        return painted(Colour::green, "All of section " + number + " passes.")
               + " See your figures in the book: ./course open " + number + " --mine\n";
    const bool needs = next->state.starts_with("needs "), // one of another section
        untouched = needs || next->state == name_of(Outcome::not_started) || next->state == "not checked";
    const std::string words = needs ? next->state.substr(6) : next->exercise.number + ' ' + next->exercise.function;
    // Of an exercise that was never tried, nobody is stuck.
    return "Next: " + words + ". " + (untouched ? "Where to begin: " : "Stuck? ") + "./course hint "
           + words.substr(0, words.find(' ')) + '\n';
}

} // namespace course
