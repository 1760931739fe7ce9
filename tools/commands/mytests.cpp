// `course mytests`: which mistakes the reader's own tests catch, and whether they accept what's right.

#include "base/files.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/own_tests.hpp"
#include "check/report.hpp"
#include "commands/commands.hpp"

#include <algorithm>
#include <iostream>

namespace course {
namespace {

/// What a reader can do with an empty file of tests.
std::string first_step(const Workspace &workspace, const Section &section) {
    return "Put a number in it that the chapter works out: call `" + catalogue(workspace, section).front().function
           + "` there, and say with CHECK_THAT what must come out. Save, and type ./course mytests "
           + section.short_number() + " again.\n";
}

bool calls(const OwnTest &test, const Exercise &exercise) {
    return std::ranges::find(test.calls, exercise.number) != test.calls.end();
}

/// A verdict on an answer of ours, which is right: it's the test that may be wrong.
Verdict as_read(Verdict verdict) {
    if (verdict.kind == Outcome::too_long && verdict.call)
        verdict.sentence = "A right answer takes too long for this: is something in it huge, or called very often?";
    if (!verdict.expected.empty())
        verdict.sentence = "Your test wants " + (verdict.label.empty() ? "" : "the " + verdict.label + " to be ")
                           + verdict.expected + (verdict.tolerance.empty() ? "" : " ± " + verdict.tolerance)
                           + ", but a right answer has " + verdict.yours + '.';
    verdict.label = verdict.yours = verdict.expected = verdict.whole = "";
    return verdict;
}

void print_trouble(const std::string &test, const std::string &what, const Verdict &verdict) {
    std::cout << painted(Colour::red, "✗") << ' ' << painted(Colour::bold, test) << ": " << what << '\n'
              << explain(as_read(verdict), 4);
}

/// Whether this check leaves no room for rounding.
bool is_exact(const Verdict &verdict) {
    return verdict.expected.empty() ? contains(verdict.sentence, " == ") && !contains(verdict.sentence, "Approx")
                                    : verdict.tolerance.empty();
}

/// What keeps a test from being asked about mistakes.
void print_trouble(const OwnTest &test, const std::string &place, const std::string &example) {
    if (test.verdict.kind == Outcome::no_verdict || test.verdict.passed()) {
        Verdict none{.sentence = test.verdict.sentence, .file = place, .line = test.line};
        if (test.calls.empty())
            none.sentence = "This test calls none of the section's functions, so it can't catch anything: call "
                            + example + ", say.";
        print_trouble(test.name, "it has nothing to say", none);
    } else
        print_trouble(test.name, test.verdict.call ? "our solution fails it" : "it goes wrong by itself", test.verdict);
}

class MyTests {
  public:
    MyTests(const Workspace &tree_, Section section_, bool verbose_)
        : workspace{tree_}, section{std::move(section_)}, verbose{verbose_}, exercises{catalogue(workspace, section)} {}

    int run() {
        const std::string name = workspace.relative_name(workspace.own_tests(section));
        judgement = judge_own_tests(workspace, section);
        if (judgement.unbuilt) {
            std::cout << explain_unbuilt(*judgement.unbuilt, name);
            return something_to;
        }
        std::cout << explain_warnings(judgement.warnings, {verbose});
        if (judgement.tests.empty()) {
            std::cout << name << " has no TEST_CASE in it. ./course reset " << section.short_number()
                      << " --tests brings back the file that it was, and keeps a copy of yours.\n";
            return something_to;
        }
        bool well = true;
        for (const OwnTest &test : judgement.tests)
            if (!is_fine(test)) {
                well = false;
                print_trouble_of(test, name);
            }
        for (const Exercise &exercise : exercises)
            if (std::ranges::any_of(judgement.tests, [&](const OwnTest &test) { return calls(test, exercise); }))
                print(exercise);
        print_next(well);
        return well ? all_well : something_to;
    }

  private:
    static bool is_fine(const OwnTest &test) { return test.sound && !test.calls.empty(); }

    void print_trouble_of(const OwnTest &test, const std::string &name) const {
        const auto is_of_test = [&](const Refusal &refusal) { return refusal.verdict.test == test.name; };
        const auto first = std::ranges::find_if(judgement.refusals, is_of_test);
        if (first == judgement.refusals.end()) return print_trouble(test, name, exercises.front().function);
        print_trouble(test.name, "our solution passes, but another right answer doesn't (" + first->right + ")",
                      first->verdict);
        std::cout << "    "
                  << (is_exact(first->verdict)
                          ? "It's right, and rounds otherwise: allow for that, with IsNear(…, 1e-9) or == Approx(…)."
                          : "It's right, too: does your test want more than the header promises?")
                  << '\n';
        if (const auto all = std::ranges::count_if(judgement.refusals, is_of_test); all > 1)
            std::cout << "    It's the same with " << pluralize(all - 1, "other right answer") << ".\n";
    }

    void print(const Exercise &exercise) const {
        const std::string head = exercise.number + ' ' + exercise.function + ", " + exercise.tier;
        const auto fails = [&](const OwnTest &test) { return calls(test, exercise) && !is_fine(test); };
        const bool well = std::ranges::none_of(judgement.tests, fails);
        const auto known = judgement.mistakes.find(exercise.number);
        if (!well && known == judgement.mistakes.end()) {
            std::cout << painted(Colour::red, "✗ " + head) << ": no test of yours accepts all right answers yet\n";
            return;
        }
        const auto mistakes = known == judgement.mistakes.end() ? std::vector<KnownMistake>{} : known->second;
        const auto caught = static_cast<std::size_t>(std::ranges::count_if(mistakes, &KnownMistake::caught));
        std::cout << (well ? painted(Colour::green, "✓ " + head) : painted(Colour::red, "✗ " + head)) << ": "
                  << (well ? "accepts all " + pluralize(judgement.right.at(exercise.number), "right answer")
                                 + ", catches "
                           : "without what's red above, catches ")
                  << caught << " of " << pluralize(mistakes.size(), "mistake") << '\n';
        print_caught(mistakes, caught);
    }

    void print_caught(const std::vector<KnownMistake> &mistakes, std::size_t caught) const {
        constexpr std::size_t most = 6;
        std::size_t printed = 0;
        for (const KnownMistake &mistake : mistakes)
            if (mistake.caught && (verbose || printed < most)) {
                std::cout << "    " << painted(Colour::green, "✓") << " when " << mistake.what << '\n';
                ++printed;
            }
        if (caught > printed)
            std::cout << painted(Colour::dim, "      and " + std::to_string(caught - printed) + " more (-v shows all)")
                      << '\n';
    }

    void print_next(bool well) const {
        if (!well) {
            std::cout << "First mend what's red: a test that fails what's right sends you after a mistake that isn't "
                         "there.\n";
            return;
        }
        std::size_t missed = 0;
        for (const auto &[exercise, mistakes] : judgement.mistakes)
            missed += static_cast<std::size_t>(
                std::ranges::count_if(mistakes, [](const KnownMistake &mistake) { return !mistake.caught; }));
        if (missed == 0) std::cout << painted(Colour::green, "Your tests catch every mistake that we know.") << '\n';
        else
            std::cout << pluralize(missed, "mistake") << (missed == 1 ? " gets" : " get")
                      << " past your tests. What else does " << workspace.relative_name(workspace.header(section))
                      << " promise? Ours are in " << workspace.relative_name(workspace.tests(section)) << '\n';
    }

    const Workspace &workspace;
    Section section;
    bool verbose;
    std::vector<Exercise> exercises;
    OwnJudgement judgement;
};

/// Makes the file if it isn't there.
/// @return whether it holds anything to run
bool is_written(const Workspace &workspace, const Section &section) {
    const std::filesystem::path file = workspace.own_tests(section);
    const std::string empty = empty_own_tests(workspace, section);
    if (!std::filesystem::exists(file)) {
        write_file(file, empty);
        std::cout << workspace.relative_name(file) << " is there now, with one empty test. "
                  << first_step(workspace, section);
        throw ExitRequest{all_well};
    }
    if (read_file(file) != empty) return true;
    std::cout << workspace.relative_name(file) << " still has its one empty test. " << first_step(workspace, section);
    return false;
}

void my_tests(const Workspace &workspace, const std::string &words, bool verbose) {
    const Section section = workspace.section(words);
    if (is_number_of_exercise(words))
        throw UserError{"the tests of a section are in one file: ./course mytests " + section.short_number()};
    require_answers(workspace, section);
    if (!is_written(workspace, section)) throw ExitRequest{something_to};
    if (!are_answers_built(workspace, section))
        std::cout << "Compiling our right and wrong answers to section " << section.short_number()
                  << ". That takes up to a minute, this once.\n"
                  << std::flush;
    if (const int code = MyTests{workspace, section, verbose}.run(); code != all_well) throw ExitRequest{code};
}

} // namespace

void add_mytests(CLI::App &app, const Workspace &workspace) {
    const auto section = std::make_shared<std::string>();
    const auto verbose = std::make_shared<bool>();
    CLI::App *command = app.add_subcommand("mytests", "Write tests of your own, and see which mistakes they catch");
    command->add_option("section", *section, "its number, name or file")->required();
    command->add_flag("-v,--verbose", *verbose, "name every mistake that is caught");
    command->footer(
        "Your tests are in exercises/NN_slug_tests.cpp, which the first call makes. They run against our right "
        "answers, which they must accept, and against wrong ones.\n\nExample: ./course mytests 2\nExits with 0 if your "
        "tests accept what's right, 1 if not.");
    command->callback([&workspace, section, verbose] { my_tests(workspace, *section, *verbose); });
}

} // namespace course
