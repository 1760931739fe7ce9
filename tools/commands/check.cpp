// `course check`: the verdict on what a student has written.

#include "commands/commands.hpp"
#include "ground/files.hpp"
#include "ground/terminal.hpp"
#include "ground/text.hpp"
#include "loop/answer.hpp"
#include "loop/catalogue.hpp"
#include "loop/diagnosis.hpp"
#include "loop/judge.hpp"
#include "loop/junit.hpp"
#include "loop/memory.hpp"
#include "loop/mistakes.hpp"
#include "loop/progress.hpp"
#include "loop/which_tests.hpp"
#include "site/progress_script.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace course {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    std::string what = {};  ///< section, or one of its exercises; empty: the first section that is not finished
    std::string file = {};  ///< judge this one instead of the student's
    std::string junit = {}; ///< where to write the same for machines
    unsigned seed = 2026;
    bool watch = false;
    bool verbose = false;
    bool no_diagnosis = false;
};

/// What the tests said of one exercise.
struct Outcome {
    Exercise exercise;
    std::vector<Verdict> verdicts;

    const Verdict *first(const auto &of) const {
        const auto found = std::ranges::find_if(verdicts, of);
        return found == verdicts.end() ? nullptr : &*found;
    }
    const Verdict *first_failure() const { return first(std::not_fn(&Verdict::passed)); }
    const Verdict *first_open() const {
        return first([](const Verdict &v) { return v.kind == Kind::not_started; });
    }
    /// Not started as long as any call says so: a stub that refuses bad input passes some tests as it is.
    Kind state() const {
        const Verdict *failure = first_failure();
        return failure == nullptr ? Kind::passed : first_open() ? Kind::not_started : failure->kind;
    }
    /// How far it is from done: "wrong", "not started", "needs 4.2 time_of_flight". This is remembered, too.
    std::string standing() const {
        const Verdict *open = first_open();
        return open == nullptr || open->needs.empty() ? std::string{name_of(state())} : "needs " + open->needs;
    }
};

std::vector<Outcome> by_exercise(const Tree &tree, const Section &section, const Judgement &judgement) {
    std::vector<Outcome> outcomes;
    for (auto &exercise : catalogue(tree, section)) {
        Outcome outcome{std::move(exercise), {}};
        std::ranges::copy_if(judgement.verdicts, std::back_inserter(outcome.verdicts),
                             [&](const Verdict &v) { return v.exercise == outcome.exercise.number; });
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

void print_failure(const Verdict &verdict) {
    std::cout << "    " << painted(Colour::red, "✗") << ' ' << painted(Colour::bold, verdict.test);
    if (verdict.kind != Kind::wrong) std::cout << "  " << painted(Colour::red, name_of(verdict.kind));
    std::cout << '\n' << explain(verdict, 6);
}

/// An exercise in one line; what is wrong below it: the first failure in full, since one is fixed at a time.
/// @param mistakes  what is known of them
void print(const Outcome &outcome, bool verbose, const std::string &mistakes) {
    const auto &[exercise, verdicts] = outcome;
    const Verdict *failure = outcome.first_failure();
    const auto passed = std::ranges::count_if(verdicts, &Verdict::passed);
    const std::string head = exercise.number + ' ' + exercise.function + ", " + exercise.tier;
    if (failure == nullptr)
        std::cout << painted(Colour::green, "✓ " + head) << ": " << counted(verdicts.size(), "test") << " passed\n";
    else if (const Verdict *open = outcome.first_open()) {
        std::cout << painted(Colour::dim, "· " + head) << ": " << (verbose ? open->sentence : outcome.standing())
                  << '\n';
        return;
    } else
        std::cout << painted(Colour::red, "✗ " + head) << ": " << passed << " of " << counted(verdicts.size(), "test")
                  << " passed\n";

    constexpr std::size_t most = 3; // claims beside the first: enough to guess from
    std::size_t failures = 0;
    for (const Verdict &verdict : verdicts) {
        if (!verdict.passed()) ++failures;
        if (failures > 1 && failure->kind == Kind::missing) continue; // said once
        if (verdict.passed()) {
            if (verbose) std::cout << "    " << painted(Colour::green, "✓") << ' ' << verdict.test << '\n';
        } else if (failures == 1 || verbose) print_failure(verdict);
        else if (failures <= 1 + most) std::cout << "    " << painted(Colour::red, "✗") << ' ' << verdict.test << '\n';
    }
    if (failures > 1 + most && !verbose && failure->kind != Kind::missing)
        std::cout << painted(Colour::dim, "      and " + std::to_string(failures - 1 - most) + " more (-v shows all)")
                  << '\n';
    if (const std::string known = known_mistake(mistakes, verdicts); !known.empty())
        std::cout << "    " << painted(Colour::yellow, "This is what comes out when " + known) << '\n';
}

/// Whether all tests failed for one reason, which has nothing to do with any of them: the code never got as far.
bool never_started(const Judgement &judgement) {
    const auto &first = judgement.verdicts.front();
    return !first.passed() && first.kind != Kind::missing && first.kind != Kind::not_started
           && std::ranges::all_of(judgement.verdicts,
                                  [&](const Verdict &v) { return !v.call && v.sentence == first.sentence; });
}

/// What to do about an exercise that stands like this.
void print_next(const Exercise &exercise, const std::string &standing) {
    const bool needs = standing.starts_with("needs "),
               untouched = needs || standing == name_of(Kind::not_started) || standing == "not checked";
    const std::string next = needs ? standing.substr(6) : exercise.number + ' ' + exercise.function;
    std::cout << "Next: " << next << ". " << (untouched ? "Where to begin: " : "Stuck? ") << "./course hint "
              << next.substr(0, next.find(' ')) << '\n';
}

void print_next(const Tree &tree, const std::vector<Outcome> &outcomes, const Section &section) {
    const auto open = std::ranges::find_if(outcomes, &Outcome::first_failure);
    if (open != outcomes.end()) print_next(open->exercise, open->standing());
    else
        std::cout << painted(Colour::green, "All of section " + section.short_number() + " passes.")
                  << (tree.is_shared() ? " See your figures: ./course plot "
                                       : " See your figures in the book: ./course open ")
                  << section.short_number() << " --mine\n";
}

/// Before anything is judged: an earlier report goes, so that it is not taken for this one, and a place that cannot be
/// written is found out now.
void make_room(const fs::path &report) {
    if (fs::exists(report) && !fs::is_regular_file(report))
        throw Complaint{"--junit writes a file, and " + report.string() + " is something else"};
    std::string head;
    std::getline(std::ifstream{report}, head);
    if (fs::exists(report) && !fs::is_empty(report) && !head.starts_with("<?xml"))
        throw Complaint{"--junit would overwrite " + report.string()
                        + ", which is not an earlier report: give it another name, or delete that file first"};
    if (const fs::path folder = fs::absolute(report).parent_path(); !fs::is_directory(folder))
        throw Complaint{"--junit can't write " + report.string() + ": there's no folder " + folder.string()
                        + "; make it first, or name another"};
    write_file(report, "");
    fs::remove(report);
}

class Check {
  public:
    Check(const Tree &tree_, CheckOptions options_) : tree{tree_}, options{std::move(options_)} {
        if (is_number_of_exercise(options.what)) only = find_exercise(tree, options.what).exercise;
    }

    int once() {
        if (!options.junit.empty()) make_room(options.junit);
        std::vector<Report> judged;
        int code = all_well;
        const std::vector<Section> sections = chosen();
        for (const Section &section : sections) {
            if (&section != &sections.front()) std::cout << '\n';
            const auto unreadable = sections.size() > 1 ? trouble_with_file_of(section) : std::nullopt;
            if (unreadable) {
                std::cout << painted(Colour::red, "✗ " + unreadable->sentence) << '\n';
                code = std::max(code, +bad_input);
                if (!options.junit.empty()) judged.push_back(report_on(section, {unreadable, {}, {}}));
                continue;
            }
            const Judgement judgement =
                course::judge(tree, section, file_of(section), {options.seed, only ? only->number : ""});
            report(section, judgement);
            if (options.verbose) print_which_tests(section);
            code = std::max(code, judgement.our_fault()    ? +our_fault
                                  : judgement.all_passed() ? +all_well
                                                           : +something_to);
            if (!options.junit.empty()) judged.push_back(report_on(section, judgement));
        }
        if (!options.junit.empty()) write_file(options.junit, junit(judged));
        return code;
    }

    /// Again whenever the file changes; Enter for those whose disk tells no dates, q to leave.
    void watch() {
        const Section section = chosen().front();
        if (!only) options.what = section.name; // and not the next one, when this is finished
        for (;;) {
            const std::string seen = look(section);
            if (is_terminal()) std::cout << "\x1b[2J\x1b[H";
            try {
                once();
            } catch (const Complaint &complaint) { // a file that is gone may come back
                std::cout << complaint.what() << '\n';
            }
            std::cout << painted(Colour::dim, "Waiting for you to save. Enter: check again; q Enter: leave.")
                      << std::endl;
            if (!wait_for_change(section, seen)) return;
        }
    }

  private:
    std::vector<Section> chosen() const {
        if (options.what == "all") return tree.sections();
        if (!options.what.empty()) return {tree.section(options.what)};
        if (const auto section = first_unfinished(tree)) return {*section};
        return {tree.sections().back()};
    }

    /// Why a section's file cannot be judged, which is no reason to judge none of the others.
    std::optional<Verdict> trouble_with_file_of(const Section &section) const {
        try {
            read_answer(file_of(section));
            return {};
        } catch (const Complaint &complaint) {
            return Verdict{.kind = Kind::does_not_compile, .sentence = complaint.what()};
        }
    }

    /// For a machine: of the section, or of the exercise that was asked for.
    Report report_on(const Section &section, const Judgement &judgement) const {
        Report result{section,
                      tree.shown(place_of(section)),
                      options.seed,
                      catalogue(tree, section),
                      tests_of(tree, section),
                      judgement.unbuilt,
                      judgement.verdicts};
        if (only) std::erase_if(result.tests, [&](const KnownTest &test) { return test.exercise != only->number; });
        return result;
    }

    /// Without those in the functions of other exercises than the one that was asked for.
    std::vector<std::string> warnings_of_it(const Section &section, const Judgement &judgement) const {
        std::vector<std::string> others;
        for (const Exercise &exercise : catalogue(tree, section))
            if (exercise.number != only->number) others.push_back(exercise.function);
        return warnings_about(judgement.warnings, read_file(file_of(section)), tree.shown(file_of(section)), others);
    }

    /// What is judged; it need not be there.
    fs::path place_of(const Section &section) const {
        return options.file.empty() ? tree.exercise(section) : fs::path{options.file};
    }
    fs::path file_of(const Section &section) const {
        return options.file.empty() ? tree.written_exercise(section) : fs::path{options.file};
    }

    void report(const Section &section, const Judgement &judgement) {
        const std::string name = tree.shown(place_of(section));
        print_warnings(only ? warnings_of_it(section, judgement) : judgement.warnings, options.verbose);
        if (judgement.unbuilt) {
            print_unbuilt(*judgement.unbuilt, name);
            if (options.file.empty()) keep_in_mind(section, {}, judgement.unbuilt->kind);
            return;
        }
        auto outcomes = by_exercise(tree, section, judgement);
        if (only) std::erase_if(outcomes, [&](const Outcome &o) { return o.exercise.number != only->number; });
        if (options.file.empty()) keep_in_mind(section, outcomes, Kind::passed);
        if (never_started(judgement)) {
            Verdict of_all = judgement.verdicts.front();
            of_all.test = "no test could start:";
            of_all.file.clear();
            print_failure(of_all);
        } else {
            const std::string mistakes = mistakes_of(section);
            for (const auto &outcome : outcomes) print(outcome, options.verbose, mistakes);
        }
        if (only && outcomes.front().first_failure() == nullptr) print_after(section);
        else print_next(tree, outcomes, section);
    }

    /// For a student and an instructor to compare.
    void print_which_tests(const Section &section) const {
        const WhichTests tests = which_tests(hash_of_tests(tree, section), course_version());
        std::cout << painted(Colour::dim, "Judged by " + words_for(tests)) << '\n';
    }

    /// The table of known mistakes; a section may have none.
    std::string mistakes_of(const Section &section) const {
        const fs::path file = file_of_mistakes(tree, section);
        return options.no_diagnosis || !fs::exists(file) ? "" : '\n' + read_file(file);
    }

    /// What to do after the exercise that was asked for, and is passed: the next one that was open when it was last
    /// judged, or else one before it. Of somebody's file nothing is known but this exercise.
    void print_after(const Section &section) const {
        Progress known = progress(tree, section);
        const auto is_done = [&](const Standing &s) { return s.exercise.number == only->number; };
        std::rotate(known.standings.begin(), std::ranges::find_if(known.standings, is_done), known.standings.end());
        const auto open = known.first_open();
        if (options.file.empty() && open != known.standings.end()) print_next(open->exercise, open->state);
        else std::cout << "The whole section: ./course check " << section.short_number() << '\n';
    }

    void keep_in_mind(const Section &section, const std::vector<Outcome> &outcomes, Kind of_all) const {
        std::vector<ExerciseState> states;
        for (const auto &outcome : outcomes) states.push_back({outcome.exercise.number, outcome.standing()});
        if (outcomes.empty())
            for (const auto &exercise : catalogue(tree, section))
                states.push_back({exercise.number, std::string{name_of(of_all)}});
        remember(tree, section, states);
        tell_pages(tree);
    }

    /// What changes when the file does.
    std::string look(const Section &section) const {
        std::error_code ignored;
        const auto date = fs::last_write_time(place_of(section), ignored).time_since_epoch().count();
        return std::to_string(date) + ' ' + std::to_string(fs::file_size(place_of(section), ignored));
    }

    bool wait_for_change(const Section &section, const std::string &seen) const {
        constexpr int tenth = 100; // [ms] asking for a date costs a microsecond, and works on every disk
        bool keys = true;
        while (look(section) == seen) {
            pollfd keyboard{STDIN_FILENO, POLLIN, 0};
            if (::poll(&keyboard, keys ? 1 : 0, tenth) <= 0) continue;
            std::string line;
            if (!std::getline(std::cin, line)) keys = false;
            else return line != "q";
        }
        return true;
    }

    const Tree &tree;
    CheckOptions options;
    std::optional<Exercise> only; ///< the one that was asked for, if not a whole section
};

} // namespace

int check_file(const Tree &tree, const std::string &exercise, const fs::path &file) {
    return Check{tree, {.what = exercise, .file = file.string(), .no_diagnosis = true}}.once();
}

void print_unbuilt(const Verdict &verdict, const std::string &name) {
    std::cout << painted(Colour::red, "✗ " + name + ' ' + std::string{name_of(verdict.kind)}) << '\n';
    std::cout << "    " << (verdict.file.empty() ? "" : verdict.file + ':' + std::to_string(verdict.line) + ": ")
              << verdict.sentence << '\n';
    for (const auto &line : verdict.printed) std::cout << "    " << line << '\n';
    if (verdict.printed_more > 0)
        std::cout << "    (" << verdict.printed_more << " more " << (verdict.printed_more == 1 ? "error" : "errors")
                  << "; the first one first)\n";
}

void print_warnings(const std::vector<std::string> &warnings, bool verbose) {
    constexpr std::size_t most = 5;
    const std::size_t shown = verbose ? warnings.size() : std::min(most, warnings.size());
    for (std::size_t i = 0; i < shown; ++i) std::cout << painted(Colour::yellow, "warning ") << warnings[i] << '\n';
    if (warnings.size() > shown) std::cout << "  and " << warnings.size() - shown << " more warnings (-v shows all)\n";
}

void add_check(CLI::App &app, const Tree &tree) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App *command =
        app.add_subcommand("check", "Say what is right, what is wrong and why in what you have written");
    const CLI::Validator given{[](std::string &word) { return word.empty() ? "nothing is given" : ""; }, ""};
    command
        ->add_option(
            "section", options->what,
            "a section, by number, name or file, or one exercise: 7.2; \"all\"; nothing: the first section that "
            "is not finished")
        ->check(given);
    command->add_flag("-w,--watch", options->watch, "check again whenever you save");
    command->add_flag("-v,--verbose", options->verbose, "show every test and every failure whole");
    command->add_flag("--no-diagnosis", options->no_diagnosis, "don't say which known mistake gives the same");
    command->add_option("--file", options->file, "judge this file instead of the one in exercises/")->check(given);
    command->add_option("--junit", options->junit, "write the verdicts to this file as well, as JUnit XML")
        ->check(given);
    const CLI::Validator is_seed{[](const std::string &word) {
                                     constexpr std::size_t digits = 9; // as many as always fit
                                     const bool is = is_all_digits(word) && word.size() <= digits;
                                     return is ? "" : "a whole number of up to nine digits is wanted, not " + word;
                                 },
                                 ""};
    command->add_option("--seed", options->seed, "for generated values; the same seed, the same values")
        ->check(is_seed)
        ->capture_default_str();
    command->footer("Example: ./course check 7 --watch\nExits with 0 if all tests pass, 1 if not, 4 if the machine "
                    "let none be judged.");
    command->callback([&tree, options] {
        if (!options->file.empty() && options->what.empty())
            throw Complaint{"--file needs a section to judge it by, as in: ./course check 7 --file " + options->file};
        Check check{tree, *options};
        if (options->watch) check.watch();
        else if (const int code = check.once(); code != all_well) throw Leave{code};
    });
}

} // namespace course
