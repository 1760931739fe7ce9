// Catch2 finds the tests and runs them. What it would print is never looked at: the session owns the verdict.

#include "judge/runner/harness.hpp"

#include "base/kernel.hpp"
#include "course.hpp"

#include <catch2/catch_session.hpp>
#include <catch2/catch_translate_exception.hpp>
#include <catch2/interfaces/catch_interfaces_registry_hub.hpp>
#include <catch2/interfaces/catch_interfaces_testcase.hpp>
#include <catch2/internal/catch_sharding.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>

#include <algorithm>
#include <iostream>
#include <new>

namespace {

using namespace course;

/// To a student about the code that is judged.
std::string explain_to_student(const Catch::AssertionResult &result) {
    switch (result.getResultType()) {
    case Catch::ResultWas::DidntThrowException:
        return "Your code accepted input that the header says it refuses with std::invalid_argument.";
    case Catch::ResultWas::ThrewException: return explain_exception(std::string{result.getMessage()});
    case Catch::ResultWas::ExpressionFailed:
        if (std::string{result.getTestMacroName()}.ends_with("_THAT")) return {}; // yours and expected say it
        return what_does_not_hold(result);
    default: return std::string{result.getMessage()};
    }
}

void add_verdict(Verdict verdict) {
    on_verdict(verdict);
    verdicts.push_back(std::move(verdict));
}

/// Hears what happens in the tests, and passes it to the session.
class Listener : public Catch::EventListenerBase {
  public:
    using EventListenerBase::EventListenerBase;
    static std::string getDescription() { return "verdicts for students"; }

    void testCaseStarting(const Catch::TestCaseInfo &test) override { session()->begin(exercise_of(test), test.name); }
    void assertionStarting(const Catch::AssertionInfo &) override { session()->note({}); }

    void assertionEnded(const Catch::AssertionStats &stats) override {
        const auto &result = stats.assertionResult;
        if (result.isOk()) return;
        const auto where = result.getSourceInfo();
        session()->fail(Outcome::wrong, explain_failure(result), where.file, static_cast<int>(where.line));
    }

    void testCaseEnded(const Catch::TestCaseStats &stats) override {
        const auto &asserted = stats.totals.assertions;
        add_verdict(session()->end(asserted.total() > asserted.skipped && asserted.skipped == 0));
    }
};

/// A test that ran but was not heard of, or the other way round, is our mistake, and no student's.
void add_missing_verdicts(const Part &part) {
    for (const Catch::TestCaseInfo *test : Catch::createShard(all_tests(), part.of, part.index)) {
        if (!part.exercise.empty() && exercise_of(*test) != part.exercise) continue;
        if (std::ranges::any_of(verdicts, [&](const Verdict &v) { return v.test == test->name; })) continue;
        add_verdict({.exercise = exercise_of(*test),
                     .test = test->name,
                     .kind = Outcome::no_verdict,
                     .sentence = "This test didn't run: our mistake, not yours."});
    }
}

} // namespace

CATCH_REGISTER_LISTENER(Listener)

// What a test calls by itself is ours, and so is done; in a handout, an earlier section's functions are the student's.
CATCH_TRANSLATE_EXCEPTION(const course::NotYet &hint) {
    session()->note_not_started(hint.what(), hint.function);
    return hint.what();
}

CATCH_TRANSLATE_EXCEPTION(const std::bad_alloc &none) {
    session()->note_no_memory();
    return none.what();
}

namespace course {

Explain explain_failure = explain_to_student;
std::vector<Verdict> verdicts;
std::function<void(const Verdict &)> on_verdict = [](const Verdict &) {};
bool all_cases = false;

std::string what_does_not_hold(const Catch::AssertionResult &result) {
    const std::string written{result.getExpression()};
    std::string expanded = result.getExpandedExpression(); // in three lines, where it's long
    std::ranges::replace(expanded, '\n', ' ');
    return "This doesn't hold: " + written + (expanded == written ? "" : ", that is " + expanded);
}

std::string passed_of_all() {
    const auto passed = std::ranges::count_if(verdicts, &Verdict::passed);
    return std::to_string(passed) + " of " + std::to_string(verdicts.size());
}

std::string in_words(const Verdict &verdict) {
    const std::string test = verdict.exercise + "  " + verdict.test + '\n';
    if (verdict.passed()) return "passed  " + test;
    return "FAILED  " + test + "        " + std::string{name_of(verdict.kind)} + '\n' + explain(verdict, 8);
}

const std::vector<Catch::TestCaseInfo *> &all_tests() {
    return Catch::getRegistryHub().getTestCaseRegistry().getAllInfos();
}

std::string exercise_of(const Catch::TestCaseInfo &test) {
    return test.tags.empty() ? "?" : std::string{test.tags.front().original};
}

void run_tests(Session &running, unsigned seed, const Part &part) {
    static Catch::Session catch2; // there may be only one
    session() = &running;
    Catch::ConfigData config;
    config.rngSeed = seed;
    config.shardIndex = part.index;
    config.shardCount = part.of;
    config.defaultOutputFilename = "/dev/null"; // nobody reads what Catch2 says
    config.allowZeroTests = true;
    if (!part.exercise.empty()) config.testsOrTags = {"[" + part.exercise + "]"};
    if (part.until_red) config.abortAfter = 1;
    catch2.useConfigData(config);
    catch2.run();
    if (!part.until_red) add_missing_verdicts(part);
    if (!running.trouble().empty()) throw EnvironmentError{running.trouble()};
}

void print_verdicts(const std::string &subject, unsigned seed, const Part &part) {
    on_verdict = [](const Verdict &verdict) { std::cout << in_words(verdict); };
    prepare_for_subjects(cores().front());
    Session running{subject, patient};
    run_tests(running, seed, part);
    std::cout << passed_of_all() << " passed (seed " << seed << ")\n";
}

bool all_passed() { return !verdicts.empty() && std::ranges::all_of(verdicts, &Verdict::passed); }

int cases(int full) { return all_cases ? full : full / 100; }

} // namespace course

int main(int argc, char **argv) try {
    hide_from_other_processes();
    return course::section_main(argc, argv);
} catch (const EnvironmentError &trouble) {
    std::cerr << trouble.what() << std::endl;
    return machine_trouble;
}
