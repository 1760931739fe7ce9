// `course check`: the verdict on what a student has written.

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"
#include "base/watch.hpp"
#include "check/answer_file.hpp"
#include "check/catalogue.hpp"
#include "check/judge.hpp"
#include "check/junit.hpp"
#include "check/mistakes.hpp"
#include "check/others.hpp"
#include "check/picture.hpp"
#include "check/progress.hpp"
#include "check/progress_store.hpp"
#include "check/report.hpp"
#include "check/which_tests.hpp"
#include "commands/commands.hpp"
#include "judge/runner/sandbox.hpp"
#include "site/progress_script.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>

namespace course {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    std::string what = {};  ///< section, or one of its exercises; empty: the section to go on with
    std::string file = {};  ///< judge this one instead of the student's
    std::string junit = {}; ///< where to write the same for machines
    unsigned seed = 2026;
    bool watch = false;
    bool verbose = false;
    bool no_diagnosis = false;
    bool picture = false;
};

/// The first failure of each exercise as a page, in the browser.
void open_pictures(const Workspace &workspace, const std::vector<ExerciseResult> &results) {
    std::string page =
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>What came out, and what was expected"
        "</title><meta name=\"viewport\" content=\"width=device-width\"><style>\n"
        + style_of_pictures()
        + ":root { color-scheme: light dark } body { font: 16px/1.5 Inter, sans-serif; max-width: 44em; "
          "margin: 2em auto; padding: 0 1em } pre { white-space: pre-wrap; font-size: 13px }\n</style>\n";
    std::size_t drawn = 0;
    for (const ExerciseResult &result : results) {
        const Verdict *failure = result.first_failure();
        const auto picture = failure == nullptr ? std::nullopt : picture_of(*failure);
        if (!picture) continue;
        ++drawn;
        page += "<h2>" + result.exercise.number + " <code>" + result.exercise.function + "</code></h2>\n<p>"
                + escaped(failure->test) + ".</p>\n" + *picture + "<pre>" + escaped(explain(*failure, 0)) + "</pre>\n";
    }
    if (drawn == 0) {
        std::cout << "There's nothing to draw here: no failure has a point, an arrow or a number to compare.\n";
        return;
    }
    const fs::path place = workspace.build / "picture.html";
    write_file(place, page);
    open_page(place);
}

/// Before anything is judged: an earlier report goes, so that it is not taken for this one, and a place that cannot be
/// written is an error now.
void make_room(const fs::path &report) {
    if (fs::exists(report) && !fs::is_regular_file(report))
        throw UserError{"--junit writes a file, and " + report.string() + " is something else"};
    std::string head;
    std::getline(std::ifstream{report}, head);
    if (fs::exists(report) && !fs::is_empty(report) && !head.starts_with("<?xml"))
        throw UserError{"--junit would overwrite " + report.string()
                        + ", which is not an earlier report: give it another name, or delete that file first"};
    if (const fs::path folder = fs::absolute(report).parent_path(); !fs::is_directory(folder))
        throw UserError{"--junit can't write " + report.string() + ": there's no folder " + folder.string()
                        + "; make it first, or name another"};
    write_file(report, "");
    fs::remove(report);
}

class Check {
  public:
    Check(const Workspace &tree_, CheckOptions options_) : workspace{tree_}, options{std::move(options_)} {
        if (options.what != "all" && !options.what.empty())
            build_if_missing(workspace, workspace.section(options.what));
        if (is_number_of_exercise(options.what)) only = find_exercise(workspace, options.what).exercise;
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
            const std::string text = read_answer(file_of(section));
            const JudgeResult judgement = course::judge(workspace, section, workspace.relative_name(file_of(section)),
                                                        text, {options.seed, only ? only->number : ""});
            report(section, judgement, text);
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
        FileWatch saves{{place_of(section)}};
        do {
            if (is_terminal()) std::cout << "\x1b[2J\x1b[H";
            try {
                once();
            } catch (const UserError &complaint) { // a file that is gone may come back
                std::cout << complaint.what() << '\n';
            }
            std::cout << painted(Colour::dim, "Waiting for you to save. Enter: check again; q Enter: leave.")
                      << std::endl;
        } while (saves.wait());
    }

  private:
    std::vector<Section> chosen() const {
        if (options.what == "all") return workspace.sections();
        if (!options.what.empty()) return {workspace.section(options.what)};
        if (const auto section = section_to_go_on_with(workspace)) return {*section};
        return {workspace.sections().back()};
    }

    /// Why a section's file cannot be judged, which is no reason to judge none of the others.
    std::optional<Verdict> trouble_with_file_of(const Section &section) const {
        try {
            read_answer(file_of(section));
            return {};
        } catch (const UserError &complaint) {
            return Verdict{.kind = Outcome::does_not_compile, .sentence = complaint.what()};
        }
    }

    /// For a machine: of the section, or of the exercise that was asked for.
    Report report_on(const Section &section, const JudgeResult &judgement) const {
        Report result{section,
                      workspace.relative_name(place_of(section)),
                      options.seed,
                      catalogue(workspace, section),
                      tests_of(workspace, section),
                      judgement.unbuilt,
                      judgement.verdicts};
        if (only) std::erase_if(result.tests, [&](const KnownTest &test) { return test.exercise != only->number; });
        return result;
    }

    /// What is judged; it need not be there.
    fs::path place_of(const Section &section) const {
        return options.file.empty() ? workspace.exercise(section) : fs::path{options.file};
    }
    fs::path file_of(const Section &section) const {
        return options.file.empty() ? workspace.written_exercise(section) : fs::path{options.file};
    }

    void report(const Section &section, const JudgeResult &judgement, const std::string &text) {
        const Checked checked{workspace.relative_name(place_of(section)),
                              text,
                              judgement,
                              catalogue(workspace, section),
                              only ? only->number : "",
                              mistakes_of(section)};
        const bool tells_of_picture = options.file.empty() && !options.picture;
        std::cout << explain(checked, {options.verbose, tells_of_picture});
        if (judgement.unbuilt) {
            if (options.file.empty()) {
                const std::vector<ExerciseState> states = states_of_unbuilt(section, judgement.unbuilt->kind);
                if (states.size() == 1) remember_attempts(workspace, {{states[0].number, states[0].state}});
                save_progress(section, text, states);
            }
            return;
        }
        const std::vector<ExerciseResult> results = checked.results();
        const Progress judged = standings_of(results);
        std::vector<ExerciseState> states;
        for (const auto &[exercise, state] : judged.standings) states.push_back({exercise.number, state});
        if (options.file.empty()) {
            remember_attempts(workspace, attempts_in(section, checked, results));
            save_progress(section, text, states);
        }
        if (options.picture && !checked.never_started()) open_pictures(workspace, results);
        const bool is_all = !only || results.front().first_failure() != nullptr;
        if (!is_all && !options.file.empty()) // of another file nothing is known but this exercise
            std::cout << "The whole section: ./course check " << section.short_number() << '\n';
        else {
            if (!is_all) tell_of_others(section, only->number);
            std::cout << explain_next((is_all ? judged : progress(workspace, section)).next(), section.short_number());
        }
    }

    /// Once an answer is right, how else it can be written.
    void tell_of_others(const Section &section, const std::string &number) const {
        const std::size_t count = other_answers(workspace, section, number).size();
        if (count > 0) std::cout << words_for_others(count) << ": ./course solution " << number << " --others\n";
    }

    /// The results of this check, as if they were remembered.
    static Progress standings_of(const std::vector<ExerciseResult> &results) {
        Progress judged;
        for (const ExerciseResult &result : results) judged.standings.push_back({result.exercise, result.standing()});
        return judged;
    }

    /// Of what this check has found, what `course feedback` tells of: exercises that have become green, and the first that's
    /// red, which is the one that the reader is at; none of a text that was checked before.
    std::vector<Attempt> attempts_in(const Section &section, const Checked &checked,
                                     const std::vector<ExerciseResult> &results) const {
        const auto before = recall(workspace, section);
        std::vector<Attempt> attempts;
        bool is_red = false;
        for (const ExerciseResult &result : results) {
            const auto memory = before.find(result.exercise.number);
            const bool is_known = memory != before.end()
                                  && (memory->second.state == "passed" || memory->second.file == fnv1a(checked.text));
            const bool is_green = result.state() == Outcome::passed;
            if (is_known || result.first_open() || (is_red && !is_green)) continue;
            is_red = is_red || !is_green;
            attempts.push_back({result.exercise.number, result.standing(),
                                is_green ? "" : known_mistake(checked.mistakes, result.verdicts)});
        }
        return attempts;
    }

    /// For a student and an instructor to compare.
    void print_which_tests(const Section &section) const {
        const WhichTests tests = which_tests(hash_of_tests(workspace, section), course_version());
        std::cout << painted(Colour::dim, "Judged by " + words_for(tests)) << '\n';
    }

    /// The table of known mistakes; a section may have none.
    std::string mistakes_of(const Section &section) const {
        const fs::path file = workspace.mistakes(section);
        return options.no_diagnosis || !fs::exists(file) ? "" : read_file(file);
    }

    /// An error of the compiler is remembered of the exercise that was asked for, or else of the first that isn't passed:
    /// no other was tried, and what has passed will do so again. In an empty file all are gone.
    std::vector<ExerciseState> states_of_unbuilt(const Section &section, Outcome why) const {
        std::vector<ExerciseState> states;
        for (const auto &[exercise, state] : progress(workspace, section).standings) {
            const ExerciseState unbuilt{exercise.number, std::string{name_of(why)}};
            if (why == Outcome::empty) states.push_back(unbuilt);
            else if (state != "passed" && (!only || only->number == exercise.number)) return {unbuilt};
        }
        return states;
    }

    void save_progress(const Section &section, const std::string &text,
                       const std::vector<ExerciseState> &states) const {
        remember(workspace, section, text, states);
        write_progress_script(workspace);
    }

    const Workspace &workspace;
    CheckOptions options;
    std::optional<Exercise> only; ///< the one that was asked for, if not a whole section
};

} // namespace

int check_file(const Workspace &workspace, const std::string &exercise, const fs::path &file) {
    return Check{workspace, {.what = exercise, .file = file.string(), .no_diagnosis = true}}.once();
}

CLI::Validator is_seed() {
    return {[](const std::string &word) {
                constexpr std::size_t digits = 9; // as many as always fit
                const bool is = is_all_digits(word) && word.size() <= digits;
                return is ? "" : "a whole number of up to nine digits is wanted, not " + word;
            },
            ""};
}

void add_check(CLI::App &app, const Workspace &workspace) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App *command =
        app.add_subcommand("check", "Say what is right, what is wrong and why in what you have written");
    const CLI::Validator given{[](std::string &word) { return word.empty() ? "nothing is given" : ""; }, ""};
    command
        ->add_option(
            "section", options->what,
            "a section, by number, name or file, or one exercise: 7.2; \"all\"; nothing: the section to go on with")
        ->check(given);
    CLI::Option *watch = command->add_flag("-w,--watch", options->watch, "check again whenever you save");
    command->add_flag("-v,--verbose", options->verbose, "show every test and every failure whole");
    command->add_flag("--picture", options->picture, "draw the first failure of each exercise, in the browser")
        ->excludes(watch);
    command->add_flag("--no-diagnosis", options->no_diagnosis, "don't say which known mistake gives the same");
    command->add_option("--file", options->file, "judge this file instead of the one in exercises/")->check(given);
    command->add_option("--junit", options->junit, "write the verdicts to this file as well, as JUnit XML")
        ->check(given);
    command->add_option("--seed", options->seed, "for generated values; the same seed, the same values")
        ->check(is_seed())
        ->capture_default_str();
    command->footer("Example: ./course check 7 --watch\nExits with 0 if all tests pass, 1 if not, 4 if the machine "
                    "let none be judged.");
    command->callback([&workspace, options] {
        if (!options->file.empty() && options->what.empty())
            throw UserError{"--file needs a section to judge it by, as in: ./course check 7 --file " + options->file};
        if (const std::string warning = warning_of_this_kernel(); !warning.empty() && !options->file.empty())
            std::cerr << painted(Colour::yellow, warning) << '\n'; // what's in exercises/ is one's own
        Check check{workspace, *options};
        if (options->watch) check.watch();
        else if (const int code = check.once(); code != all_well) throw ExitRequest{code};
    });
}

} // namespace course
