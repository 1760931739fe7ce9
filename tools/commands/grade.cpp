// `course grade`: a class's submissions, from the platform's download to what goes back.

#include "base/files.hpp"
#include "base/plain.hpp"
#include "base/terminal.hpp"
#include "base/text.hpp"
#include "check/answer_file.hpp"
#include "check/functions.hpp"
#include "commands/commands.hpp"
#include "grade/assignment.hpp"
#include "grade/feedback.hpp"
#include "grade/gradescope.hpp"
#include "grade/points.hpp"
#include "grade/statistics.hpp"
#include "judge/runner/sandbox.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>

namespace course {
namespace {

namespace fs = std::filesystem;

struct GradeOptions {
    std::string section = {}, given = {}, gradebook = {}, column = {}, points = {}, out = {}, late = {}, shard = {},
                show = {}, no_file = {}, gradescope = {};
    std::vector<std::string> only = {}, without = {}, merge = {}, take = {}, hide = {};
    std::optional<unsigned> seed = {};
    bool dry_run = false, again = false, forgive = false, verbose = false;
};

/// "3/8" as (3, 8)
std::pair<std::size_t, std::size_t> part_of(const std::string &shard) {
    if (shard.empty()) return {1, 1};
    const std::size_t slash = shard.find('/');
    const auto which = leading_number(shard),
               of = leading_number(std::string_view{shard}.substr(std::min(slash, shard.size() - 1) + 1));
    if (slash == shard.npos || !which || !of || *which < 1 || *which > *of)
        throw UserError{"--shard wants a part and of how many, as in 3/8, not " + shard};
    return {static_cast<std::size_t>(*which), static_cast<std::size_t>(*of)};
}

std::string list_of(const std::vector<std::string> &words) {
    std::string text;
    for (const std::string &word : words) text += (text.empty() ? "" : ", ") + plain_line(word, 100);
    return text;
}

/// A seed that nobody knew when they wrote their answers; what's joined has that of the parts.
unsigned drawn_seed(const GradeOptions &options) {
    constexpr unsigned nine_digits = 1'000'000'000;
    const unsigned drawn = std::random_device{}() % nine_digits;
    if (!options.merge.empty()) return Assignment::kept(options.merge.front()).seed;
    if (!options.shard.empty())
        throw UserError{"all parts need the same seed, which students don't know: say the same for each, as in --seed "
                        + std::to_string(drawn)};
    return drawn;
}

/// What's agreed on: by an earlier call, as far as this one doesn't say otherwise.
Agreed read_assignment(const Workspace &workspace, const GradeOptions &options) {
    const bool begun = !options.out.empty() && Assignment::is_begun(options.out);
    Agreed agreed;
    if (begun || options.section.empty()) agreed = Assignment::kept(options.out);
    if (!options.section.empty()) {
        if (options.given.empty())
            throw UserError{"which submissions? Name the platform's download: ./course grade " + options.section
                            + " submissions.zip --out g" + options.section};
        const Section section = workspace.section(options.section);
        if (begun && agreed.section != section.name)
            throw UserError{options.out + " holds section " + workspace.section(agreed.section).short_number()
                            + " already: name another folder, as --out g" + section.short_number()};
        agreed.section = section.name;
        agreed.given = fs::absolute(options.given);
    }
    if (options.seed) agreed.seed = *options.seed;
    else if (!begun) agreed.seed = drawn_seed(options);
    const auto path = [](const std::string &word) { return fs::absolute(word); };
    if (!options.gradebook.empty()) agreed.gradebook = path(options.gradebook);
    if (!options.column.empty()) agreed.column = options.column;
    if (!options.points.empty()) agreed.worth = path(options.points);
    for (const std::string &test : options.without)
        if (std::ranges::find(agreed.void_tests, test) == agreed.void_tests.end()) agreed.void_tests.push_back(test);
    agreed.forgive = agreed.forgive || options.forgive;
    for (const std::string &words : options.take) {
        const std::size_t is = words.find('=');
        if (is == words.npos || is + 1 == words.size())
            throw UserError{"--take wants an id and the name of a file of theirs, as in 1032=f.cpp.txt, not " + words};
        agreed.take[words.substr(0, is)] = words.substr(is + 1);
    }
    if (!options.no_file.empty()) agreed.no_file_is_blank = options.no_file == "blank";
    if (!options.late.empty()) agreed.late = per_cent_per_day(options.late);
    return agreed;
}

/// What was understood, before anything is done.
void print_class(const Assignment &assignment) {
    const Submissions &all = assignment.submissions();
    if (const std::string warning = warning_of_this_kernel(); !warning.empty())
        std::cout << painted(Colour::red, warning) << '\n';
    std::cout << "Section " << assignment.section().short_number() << ", from " << name_of(all.platform) << ": "
              << pluralize(all.all.size(), "student") << " handed something in.\n";
    if (const auto &book = assignment.gradebook())
        std::cout << "The gradebook comes from " << name_of(book->platform()) << ": "
                  << pluralize(book->rows().size(), "row") << "; grades go into \"" << plain_line(book->column(), 100)
                  << "\", " << points_text(book->most()) << " points at most.\n";
    if (const auto &book = assignment.gradebook())
        for (const std::string &warning : book->warnings()) std::cout << painted(Colour::red, warning) << '\n';
    const auto print_all = [](const char *what, const std::vector<std::string> &ids) {
        if (!ids.empty()) std::cout << what << " (" << ids.size() << "): " << list_of(ids) << '\n';
    };
    print_all("Handed in nothing, so their rows stay as they are", assignment.missing());
    print_all("Handed in, but not in the gradebook", assignment.strangers());
    print_all("Belongs to nobody, and was left alone", all.left_alone);
    if (assignment.looks_like_group_work())
        std::cout << "No name in the download is its row's. Is it group work? Then only the member whose id is there "
                     "gets a grade here: see docs/instructors.md.\n";
    const std::string *choice = nullptr; // somebody with one
    for (const Submission &each : all.all) {
        const bool others = each.others.size() > (each.trouble.empty() && each.unread.empty() ? 0 : 1);
        if (const std::string why = each.trouble + each.unread; !why.empty())
            std::cout << "  " << each.id << ": " << plain_line(why, 300) << '\n';
        if (others) std::cout << "  " << each.id << ": not taken: " << list_of(each.others) << '\n';
        if (choice == nullptr && (others || contains(each.trouble, "but no .cpp file"))) choice = &each.id;
    }
    if (choice != nullptr)
        std::cout << "To judge another file of theirs, name it, as in --take " << *choice << "=FILE\n";
    if (const auto &book = assignment.gradebook())
        for (const Person &row : book->rows())
            if (!row.locked.empty()) std::cout << "  " << row.id << ' ' << row.locked << ": the row stays as it is\n";
}

void print_plan(const Assignment &assignment) {
    for (const Submission &each : assignment.submissions().all)
        std::cout << "  " << each.id << ": " << (each.file.empty() ? "nothing to judge" : plain_line(each.taken, 200))
                  << (each.late ? ", " + plain_line(lateness(each), 100) : "") << '\n';
    if (const auto &book = assignment.gradebook())
        for (const Person &row : book->rows()) {
            const auto &all = assignment.submissions().all;
            const auto submission = std::ranges::find(all, row.id, &Submission::id);
            if (!row.locked.empty() || submission == all.end() || assignment.leaves_blank(*submission)
                || !submission->unread.empty())
                continue;
            std::cout << "  row " << row.id << " (" << plain_line(row.name, 60)
                      << (submission->file.empty() ? ") would become 0" : ") would change")
                      << (row.was.empty() ? "" : ", which has " + plain_line(row.was, 20)) << '\n';
        }
    std::cout << "Nothing was judged or written.\n";
}

/// A line that moves, on a terminal: how far it is, how fast, and how long it'll take.
class ProgressLine {
  public:
    void operator()(std::size_t done, std::size_t of) const {
        if (!is_terminal()) return;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
        const double rate = double(done) / std::max(took.count(), 1e-3);
        std::cout << "\r\x1b[K  " << done << " of " << of << ", " << points_text(rate) << " a second, "
                  << static_cast<int>(double(of - done) / rate + 0.5) << " s left" << (done == of ? "\r\x1b[K" : "")
                  << std::flush;
    }

  private:
    std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
};

/// Where nobody but the instructor can help: first of all, and the exit code tells.
std::size_t print_our_troubles(const GradedClass &graded) {
    std::size_t troubles = 0;
    for (const Graded &student : graded.students)
        if (!student.our_trouble.empty()) {
            ++troubles;
            std::cout << painted(Colour::red, "not graded ") << student.submission.id << ": "
                      << plain_line(student.our_trouble, 300) << '\n';
        }
    return troubles;
}

void print_without_file(const GradedClass &graded) {
    std::vector<std::string> blank, zero;
    for (const Graded &student : graded.students)
        if (!student.submission.trouble.empty() && !student.overridden)
            (student.left_blank ? blank : zero).push_back(student.submission.id);
    if (!blank.empty())
        std::cout << "No file to judge, so their rows stay as they are (" << blank.size() << "): " << list_of(blank)
                  << '\n';
    if (!zero.empty())
        std::cout << "No file to judge, so 0 points, or none yet with --no-file blank (" << zero.size()
                  << "): " << list_of(zero) << '\n';
}

void print_late(const GradedClass &graded) {
    std::vector<std::string> all;
    for (const Graded &student : graded.students)
        if (student.taken_off > 0)
            all.push_back(student.submission.id + " (" + pluralize(student.days_late, "day") + ", "
                          + points_text(student.taken_off) + ')');
    if (!all.empty())
        std::cout << "Points taken off for handing in late (" << all.size() << "): " << list_of(all) << '\n';
}

void print_other_tests(const GradedClass &graded) {
    std::vector<std::string> all;
    for (const Graded &student : graded.students)
        if (const auto &began = student.began_with)
            all.push_back(student.submission.id + " (" + began->digits + ", version " + began->version + ')');
    if (!all.empty())
        std::cout << "Began with the file of other tests than these, "
                  << which_tests(graded.tests_hash, graded.version).digits << ", and may have updated since ("
                  << all.size() << "): " << list_of(all) << '\n';
}

void print_changes(const std::vector<Change> &changes) {
    if (!changes.empty()) std::cout << "Since last time " << pluralize(changes.size(), "student") << " changed:\n";
    for (const Change &change : changes)
        std::cout << "  " << change.id << ": " << change.before << " -> " << change.after << " ("
                  << plain_line(change.because, 300) << ")\n";
}

void print_sums(const GradedClass &graded) {
    std::vector<double> points;
    std::size_t full = 0;
    for (const Graded &student : graded.students) {
        if (!has_grade(student)) continue;
        points.push_back(student.earned());
        if (points_text(student.earned()) == points_text(student.possible())) ++full;
    }
    const auto spread = quartiles(points);
    if (!spread) return;
    std::cout << pluralize(points.size(), "student") << " graded: " << full << " with all "
              << points_text(graded.students.front().possible()) << " points, half of them with "
              << points_text(spread->median) << " or more.\n";
}

void print_appeal(const GradedClass &graded, const std::vector<std::string> &only, bool verbose) {
    for (const Graded &student : graded.students)
        if (std::ranges::find(only, student.submission.id) != only.end())
            std::cout << student.submission.id << '\n' << feedback(graded, student, verbose) << '\n';
}

std::string exercise_to_show(const Workspace &workspace, const Section &section, const std::string &words) {
    const FoundExercise result = find_exercise(workspace, words);
    if (result.section.name != section.name)
        throw UserError{"these are answers to section " + section.short_number() + ", and none to "
                        + result.exercise.number};
    return result.exercise.number;
}

/// All answers to one exercise, equal ones once, with the students who wrote them, and what they earned.
void print_answers(const GradedClass &graded, const std::string &number) {
    std::vector<std::string> functions;
    for (const GradedExercise &each : graded.students.front().exercises) functions.push_back(each.exercise.function);
    std::map<std::string, std::vector<std::string>> students; // by the answer's text
    for (const Graded &student : graded.students)
        for (const GradedExercise &each : student.exercises) {
            if (each.exercise.number != number || student.submission.file.empty()) continue;
            const std::string text = read_answer(student.submission.file);
            const Functions written = functions_of(Source{text}, functions);
            if (const Function *function = find_function(written, each.exercise.function))
                students[sanitize(text.substr(function->begin, function->end - function->begin))].push_back(
                    student.submission.id + " (" + points_text(each.earned) + ')');
        }
    for (const auto &[text, ids] : students) std::cout << "// " << list_of(ids) << '\n' << text << '\n';
}

/// Whose feedback the instructor has to paste.
void print_undelivered(const GradedClass &graded, const std::string &out) {
    std::vector<std::string> all;
    const std::string *first = nullptr;
    for (const Graded &student : graded.students) {
        if (student.submission.undelivered.empty()) continue;
        if (first == nullptr) first = &student.submission.id;
        all.push_back(student.submission.id + " (" + student.submission.undelivered + ')');
    }
    if (first != nullptr)
        std::cout << "Can't read feedback.zip in Canvas (" << all.size() << "): " << list_of(all)
                  << ". Paste into a comment for each what ./course grade --out " << out << " --only " << *first
                  << " prints.\n";
}

std::set<std::string> hidden_exercises(const Workspace &workspace, const Section &section,
                                       const GradeOptions &options) {
    std::set<std::string> all;
    for (const std::string &words : options.hide) all.insert(exercise_to_show(workspace, section, words));
    return all;
}

/// Nothing is written for a student who couldn't be judged: Gradescope then tells the instructor, and gives no 0.
void write_for_gradescope(const GradedClass &graded, const std::set<std::string> &hidden, const fs::path &file) {
    const Graded &student = graded.students.front();
    if (student.our_trouble.empty()) write_file(file, gradescope_results(graded, student, hidden));
}

/// Moodle says nothing of rows that it passes over.
void print_order(const GradedClass &graded, bool fresh) {
    if (graded.platform != Platform::moodle) return;
    std::cout << (fresh ? "Upload grades.csv first: after feedback.zip, Moodle passes over all its rows.\n"
                        : "Moodle passes over rows that it has changed since this worksheet: tick \"Allow updating "
                          "records that have been modified more recently in Moodle than in the spreadsheet\", or name "
                          "a fresh one with --gradebook.\n");
}

void grade(const Workspace &workspace, const GradeOptions &options) {
    const auto part = part_of(options.shard);
    if (options.dry_run) {
        const Scratch scratch{workspace.build / "grade-dry-run"};
        const Assignment assignment{workspace, read_assignment(workspace, options), scratch.folder};
        print_class(assignment);
        print_plan(assignment);
        return;
    }
    const fs::path out = fs::absolute(options.out);
    Assignment assignment{workspace, read_assignment(workspace, options), out};
    if (!options.again && options.only.empty() && options.show.empty()) print_class(assignment);
    for (const std::string &id : options.only)
        if (std::ranges::count(assignment.submissions().all, id, &Submission::id) == 0)
            throw UserError{"nobody with the id " + id + " has handed anything in"};
    const std::string exercise =
        options.show.empty() ? "" : exercise_to_show(workspace, assignment.section(), options.show);
    const std::set<std::string> hidden = hidden_exercises(workspace, assignment.section(), options);
    if (!options.gradescope.empty() && assignment.submissions().all.size() != 1)
        throw UserError{"--gradescope writes the results of one submission, and here are "
                        + std::to_string(assignment.submissions().all.size())};
    for (const std::string &folder : options.merge) assignment.merge(folder);
    const std::size_t judged = assignment.judge({options.only.begin(), options.only.end()}, part, ProgressLine{});
    if (part.second > 1) {
        std::cout << judged << " judged: part " << options.shard
                  << ". When all parts are there: ./course grade --out DIR --merge " << options.out << " …\n";
        return;
    }
    const GradedClass graded = assignment.graded();
    if (!options.show.empty()) return print_answers(graded, exercise);
    const bool fresh = !options.gradebook.empty() || !fs::exists(out / "grades.csv"); // it may have been uploaded
    const auto changes = assignment.write(graded);
    if (!options.gradescope.empty()) write_for_gradescope(graded, hidden, options.gradescope);
    print_appeal(graded, options.only, options.verbose);
    std::cout << judged << " judged now; what else has a result has kept it. Generated values: --seed " << graded.seed
              << ".\n";
    const std::size_t troubles = print_our_troubles(graded);
    print_sums(graded);
    print_without_file(graded);
    print_late(graded);
    print_other_tests(graded);
    print_changes(changes);
    if (options.again && changes.empty()) std::cout << "Nobody's points have changed.\n";
    std::cout << "See ./course open " << options.out << "; then upload "
              << (assignment.gradebook() ? (fs::path{options.out} / "grades.csv").string() + " and " : "")
              << (fs::path{options.out} / "feedback.zip").string() << '\n';
    if (assignment.gradebook()) print_order(graded, fresh);
    print_undelivered(graded, options.out);
    if (troubles > 0) {
        std::cout << pluralize(troubles, "student")
                  << " not graded: their rows stay as they are. Try again with ./course grade --out " << options.out
                  << " --again\n";
        throw ExitRequest{our_fault};
    }
}

} // namespace

void add_grade(CLI::App &app, const Workspace &workspace) {
    const auto options = std::make_shared<GradeOptions>();
    CLI::App *command = app.add_subcommand("grade", "Grade a class, from the platform's download to its upload");
    command->add_option("section", options->section, "its number, name or file; not again for a folder that's there");
    command->add_option("submissions", options->given, "Canvas' or Moodle's zip, or a folder of folders: id/file.cpp");
    command->add_option("--out", options->out, "the folder for all that comes of it; it's made");
    command->add_option("--gradebook", options->gradebook, "Canvas' export, or Moodle's worksheet: comes back filled");
    command->add_option("--column", options->column, "of the gradebook, if more than one could be meant");
    command->add_option("--points", options->points, "what exercises are worth, in the form of tests/points.txt");
    command->add_option("--without", options->without, "a test that doesn't count for anybody, by its name");
    command->add_flag("--forgive", options->forgive, "a function costs nothing that fails only because of another");
    command->add_option("--take", options->take,
                        "which file of somebody's to judge, whatever its name: 1032=f.cpp.txt");
    command->add_option("--no-file", options->no_file, "what it's worth to hand in nothing that can be judged")
        ->check(CLI::IsMember({"0", "blank"}));
    command->add_option("--late", options->late,
                        "by Moodle's worksheet, take points off for each started day: 10%/day");
    command->add_option("--only", options->only, "judge these ids anew, and print what they read");
    command->add_option("--show", options->show, "print all answers to one exercise, as 5.4");
    command->add_flag("--again", options->again, "after a test was mended, or overrides.csv: says who changed");
    command
        ->add_option("--seed", options->seed,
                     "for generated values; the folder keeps it. Drawn if you don't say one: it can't be known before")
        ->check(is_seed());
    command->add_option("--shard", options->shard, "only a part, as in 3/8, for many machines");
    command->add_option("--merge", options->merge, "folders of parts, to be joined");
    command->add_option("--gradescope", options->gradescope,
                        "write one submission's results.json: see `export gradescope`");
    command->add_option("--hide", options->hide,
                        "with --gradescope: an exercise of which students see nothing, as 5.7");
    command->add_flag("--dry-run", options->dry_run, "say who, which file, which rows; judge nothing");
    command->add_flag("-v,--verbose", options->verbose, "with --only: every failing test whole");
    command->footer("Example: ./course grade 5 submissions.zip --gradebook grades.csv --out g5\n"
                    "Exits with 3 if somebody couldn't be graded: then their rows stay as they are.");
    command->callback([&workspace, options] {
        if (options->out.empty() && !options->dry_run)
            throw UserError{"where to? Name a folder, which is made: --out g5"};
        grade(workspace, *options);
    });
}

} // namespace course
