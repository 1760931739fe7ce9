#include "grade/assignment.hpp"

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"
#include "check/answer_file.hpp"
#include "check/build_config.hpp"
#include "check/junit.hpp"
#include "check/mistakes.hpp"
#include "grade/archive.hpp"
#include "grade/feedback.hpp"
#include "grade/points_table.hpp"
#include "grade/process_pool.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sys/stat.h>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Agreed, section, given, gradebook, column, worth, void_tests, forgive,
                                                late, seed, take, no_file_is_blank)

namespace {

using nlohmann::json;

/// One hash of the tests of this section and of all that's linked with an answer, as it's built here, and of the course's
/// version: what judges is known by that alone.
std::string hash_of_judges(const Workspace &workspace, const Section &section) {
    const BuildConfig config = build_config(workspace, section);
    bring_up_to_date(workspace, section, config);
    std::string text = course_version() + '\n';
    for (const std::string &hash : sha256_of({workspace.test_program(section), config.server, config.missing,
                                              config.ours, workspace.header(section), workspace.stub(section)}))
        text += hash + '\n';
    return sha256(text);
}

fs::path copied(const fs::path &given, const fs::path &to) {
    if (given == to || given.empty() || fs::is_directory(given)) return given;
    if (!fs::exists(given)) throw UserError{"there's no " + given.string() + ": is its name right?"};
    write_file(to, read_file(given));
    return to;
}

/// A folder that holds anything else may be anybody's: nothing there is written over. And none that another has prepared
/// for root to write in is taken.
void require_own_folder(const fs::path &out) {
    struct stat about {};
    if (::stat(out.c_str(), &about) != 0) return; // it's made
    if (!S_ISDIR(about.st_mode)) throw UserError{out.string() + " is a file: name a folder, which is made"};
    if (about.st_uid != ::geteuid())
        throw UserError{out.string() + " belongs to another user (" + std::to_string(about.st_uid)
                        + "), who could read and change all of it: name a new folder, which is made"};
    for (const fs::directory_entry &entry : fs::directory_iterator{out}) {
        const std::string name = entry.path().filename().string();
        if (!Assignment::is_begun(out)
            && !is_any_of(name, {"files", "handed_in.zip", "gradebook.csv", "points.txt", "overrides.csv"}))
            throw UserError{out.string() + " has something else in it, " + name
                            + ", so nothing is written there: name a new folder, which is made"};
    }
    fs::permissions(out, fs::perms::owner_all); // from here on nobody else puts a link there
    for (const fs::directory_entry &entry : fs::recursive_directory_iterator{out})
        if (entry.is_symlink())
            throw UserError{out.string() + " has a link in it, " + entry.path().lexically_relative(out).string()
                            + ", through which other files would be written: take it out, or name a new folder"};
}

/// The names of tests that failed: what an appeal or a mended test may change.
std::set<std::string> failed_tests(const Graded &student) {
    std::set<std::string> all;
    for (const GradedExercise &exercise : student.exercises)
        for (const Verdict &verdict : exercise.verdicts)
            if (!verdict.passed()) all.insert(verdict.test);
    return all;
}

} // namespace

Assignment::Assignment(const Workspace &tree_, Agreed agreed_, const fs::path &out_)
    : workspace{tree_}, agreed{std::move(agreed_)}, out{out_}, section_{workspace.section(agreed.section)} {
    workspace.require_solution(section_, "Grade with the whole course, which has them");
    require_own_folder(out);
    build_if_missing(workspace, section_);
    if (!agreed.gradebook.empty()) book.emplace(agreed.gradebook, section_, agreed.column);
    fs::create_directories(out / "files");
    fs::permissions(out, fs::perms::owner_all);
    const bool wrapped = !book || book->platform() != Platform::classroom;
    handed_in = read_submissions(agreed.given, section_, out / "files", agreed.take, wrapped);
    if (book && handed_in.platform != Platform::folder && handed_in.platform != book->platform())
        throw UserError{"the submissions are from " + std::string{name_of(handed_in.platform)}
                        + ", but the gradebook is from " + std::string{name_of(book->platform())}};
    learn_lateness();
    overrides = read_overrides(out / "overrides.csv");
    for (const auto &[id, set] : overrides)
        if (std::ranges::count(handed_in.all, id, &Submission::id) == 0
            && !(book && std::ranges::count(book->rows(), id, &Person::id) > 0))
            throw UserError{(out / "overrides.csv").string() + ": nobody has the id " + plain_line(id, 100)
                            + ", neither among the submissions nor in the gradebook"};
    const auto tests = tests_of(workspace, section_);
    for (const std::string &name : agreed.void_tests)
        if (std::ranges::find(tests, name, &KnownTest::claim) == tests.end())
            throw UserError{"section " + section_.short_number() + " has no test `" + name + "`: ./course check "
                            + section_.short_number() + " -v lists their names"};
    set_points(); // before it's copied: the complaint names the file that was given
    agreed.given = copied(agreed.given, out / "handed_in.zip");
    agreed.gradebook = copied(agreed.gradebook, out / "gradebook.csv");
    agreed.worth = copied(agreed.worth, out / "points.txt");
    write_file(out / "grade.json", json(agreed).dump(1) + '\n');
    judged_with = hash_of_judges(workspace, section_);
    tests_hash = hash_of_tests(workspace, section_);
    std::vector<std::string> ids;
    std::vector<fs::path> files;
    for (const Submission &each : handed_in.all)
        if (!each.file.empty()) ids.push_back(each.id), files.push_back(each.file);
    const std::vector<std::string> of_files = sha256_of(files);
    for (std::size_t i = 0; i < ids.size(); ++i) hashes[ids[i]] = of_files[i];
}

void Assignment::set_points() {
    exercises = catalogue(workspace, section_);
    const Worth worth{agreed.worth.empty() ? workspace.root / "tests" / "points.txt" : agreed.worth, exercises};
    double sum = 0;
    for (const Exercise &exercise : exercises) sum += worth.of(exercise);
    if (book && book->most() == 0) book->take_most(sum); // a workflow of a student's own says it in GitHub Classroom
    const double unit = book && sum > 0 ? book->most() / sum : 1; // points of the gradebook for one of ours
    for (const Exercise &exercise : exercises) points_of[exercise.number] = unit * worth.of(exercise);
    if (const fs::path known = workspace.mistakes(section_); fs::exists(known)) mistakes = read_file(known);
}

void Assignment::require_tests_that_ours_passes() const {
    const std::string solution = read_file(workspace.solution(section_));
    const Outcomes outcomes = outcomes_of(workspace, section_, name_of_file(), solution, agreed.seed);
    if (!outcomes.our_trouble.empty())
        throw EnvironmentError{"our own solution can't be judged: " + outcomes.our_trouble};
    if (outcomes.unbuilt)
        throw UserError{"our own solution can't be judged, so nobody's points have changed: "
                        + outcomes.unbuilt->sentence};
    for (const Verdict &verdict : outcomes.verdicts)
        if (!verdict.passed() && std::ranges::count(agreed.void_tests, verdict.test) == 0)
            throw UserError{"our own solution of " + verdict.exercise + " fails `" + verdict.test
                            + "`, so that test is wrong, and nobody's points have changed: mend it, or leave it out "
                              "with --without"};
}

void Assignment::learn_lateness() {
    if (agreed.late > 0 && (handed_in.platform == Platform::canvas || (book && book->platform() == Platform::canvas)))
        throw UserError{"Canvas takes points off for lateness itself, and knows by how much: leave out --late, and set "
                        "it there, in the gradebook's Settings, Late Policies"};
    if (agreed.late > 0 && !(book && book->tells_lateness()))
        throw UserError{
            "--late goes by the column Status of Moodle's grading worksheet: name that with --gradebook, or "
            "leave out --late, and set points in overrides.csv"};
    if (!book) return;
    for (Submission &each : handed_in.all) {
        const auto row = std::ranges::find(book->rows(), each.id, &Person::id);
        if (row == book->rows().end() || row->late.empty()) continue;
        each.late = true;
        each.late_by = row->late;
    }
}

bool Assignment::is_begun(const fs::path &folder) { return fs::exists(folder / "grade.json"); }

Agreed Assignment::kept(const fs::path &folder) try {
    if (!is_begun(folder))
        throw UserError{folder.string()
                        + " is no folder that `grade` has made: begin with a section and a download, as "
                          "in ./course grade 5 submissions.zip --out "
                        + folder.string()};
    const json stored = json::parse(read_file(folder / "grade.json"));
    (void)stored.at("section");
    return stored;
} catch (const json::exception &) {
    throw UserError{(folder / "grade.json").string()
                    + " is broken: delete it, and name section, download and gradebook again"};
}

std::vector<std::string> Assignment::missing() const {
    std::vector<std::string> all;
    if (!book) return all;
    for (const Person &row : book->rows())
        if (std::ranges::find(handed_in.all, row.id, &Submission::id) == handed_in.all.end()) all.push_back(row.id);
    return all;
}

std::vector<std::string> Assignment::strangers() const {
    std::vector<std::string> all;
    if (!book) return all;
    for (const Submission &each : handed_in.all)
        if (std::ranges::find(book->rows(), each.id, &Person::id) == book->rows().end()) all.push_back(each.id);
    return all;
}

bool Assignment::leaves_blank(const Submission &each) const {
    return agreed.no_file_is_blank && each.file.empty() && !overrides.contains(each.id);
}

bool Assignment::looks_like_group_work() const {
    const auto letters = [](std::string name) { // Canvas leaves out what's between them
        std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
        return lower(name);
    };
    if (!book || handed_in.platform != Platform::canvas || handed_in.all.empty()) return false;
    return std::ranges::none_of(handed_in.all, [&](const Submission &each) {
        const auto row = std::ranges::find(book->rows(), each.id, &Person::id);
        return each.name.empty() || (row != book->rows().end() && letters(row->name) == letters(each.name));
    });
}

std::string Assignment::key_of(const std::string &id) const {
    const auto hash = hashes.find(id);
    return hash == hashes.end() ? "" : hash->second + ' ' + judged_with + ' ' + std::to_string(agreed.seed);
}

std::optional<Outcomes> Assignment::result(const std::string &id) const {
    if (!fs::exists(result_of(id))) return {};
    const std::string text = read_file(result_of(id));
    const std::size_t line = text.find('\n');
    if (line == text.npos || text.substr(0, line) != key_of(id)) return {};
    return outcomes_from(text.substr(line));
}

bool Assignment::is_judged(const std::string &id) const {
    const auto stored = result(id);
    return stored && stored->our_trouble.empty(); // else it's tried again
}

void Assignment::merge(const fs::path &folder) {
    if (!fs::is_directory(folder / "results"))
        throw UserError{folder.string() + " holds no part of a class: has its --shard run?"};
    if (const unsigned seed = kept(folder).seed; seed != agreed.seed)
        throw UserError{folder.string() + " was judged with --seed " + std::to_string(seed) + ", and this with --seed "
                        + std::to_string(agreed.seed) + ": say the same for all parts"};
    for (const Submission &each : handed_in.all) {
        const fs::path other = folder / "results" / (each.id + ".json");
        if (fs::exists(other) && !is_judged(each.id)) write_file(result_of(each.id), read_file(other));
    }
}

std::size_t Assignment::judge(const std::set<std::string> &only, std::pair<std::size_t, std::size_t> part,
                              const std::function<void(std::size_t, std::size_t)> &ended) {
    baselines =
        measure_baselines(workspace, section_, agreed.seed); // first: where it can't be done, nobody can be judged
    std::vector<const Submission *> open;
    for (std::size_t i = 0; i < handed_in.all.size(); ++i) {
        const Submission &each = handed_in.all[i];
        if (each.file.empty() || i % part.second != part.first - 1) continue;
        if (only.empty() ? !is_judged(each.id) : only.contains(each.id)) open.push_back(&each);
    }
    if (!open.empty()) require_tests_that_ours_passes();
    std::size_t done = 0;
    for (const Submission *each : open) fs::remove(result_of(each->id)); // what's left of earlier ones isn't theirs
    in_parallel(
        open.size(),
        [&](std::size_t which) {
            const Submission &each = *open[which];
            Outcomes outcomes;
            try {
                outcomes = outcomes_of(workspace, section_, name_of_file(), read_answer(each.file), agreed.seed);
            } catch (const UserError &complaint) {
                outcomes.our_trouble = complaint.what();
            }
            write_file(result_of(each.id), key_of(each.id) + '\n' + to_text(outcomes));
        },
        [&] { ended(++done, open.size()); });
    return open.size();
}

GradedExercise Assignment::graded_exercise(const Exercise &exercise, const Outcomes &outcomes) const {
    GradedExercise graded;
    graded.exercise = exercise;
    graded.possible = points_of.at(exercise.number);
    std::ranges::copy_if(outcomes.verdicts, std::back_inserter(graded.verdicts),
                         [&](const Verdict &v) { return v.exercise == exercise.number; });
    if (const auto why = outcomes.without.find(exercise.number); why != outcomes.without.end())
        graded.unbuilt = why->second;
    if (const auto other = outcomes.because_of.find(exercise.number); other != outcomes.because_of.end())
        graded.consequence_of = other->second;
    if (!graded.unbuilt && graded.consequence_of.empty()) // a consequence is no mistake
        graded.mistake = known_mistake(mistakes, graded.verdicts);
    const auto trivial = baselines.find(exercise.number);
    count(graded, agreed.void_tests, trivial == baselines.end() ? Baselines::mapped_type{} : trivial->second);
    if (agreed.forgive && !graded.consequence_of.empty()) graded.earned = graded.possible;
    return graded;
}

Graded Assignment::graded_student(const Submission &submission) const {
    Graded student;
    student.submission = submission;
    Outcomes outcomes{.our_trouble = submission.unread};
    if (!submission.file.empty()) {
        if (auto stored = result(submission.id)) outcomes = std::move(*stored);
        else outcomes.our_trouble = "it hasn't been judged as it is now, by these tests";
        student.file_hash = hashes.at(submission.id);
        const WhichTests today = which_tests(tests_hash, course_version());
        if (const auto began = stamp_in(read_answer(submission.file)); began && began->digits != today.digits)
            student.began_with = began;
    }
    student.our_trouble = outcomes.our_trouble;
    student.unbuilt = outcomes.unbuilt;
    student.taken_out = outcomes.taken_out;
    for (const Exercise &exercise : exercises) student.exercises.push_back(graded_exercise(exercise, outcomes));
    if (const auto set = overrides.find(submission.id); set != overrides.end())
        std::tie(student.overridden, student.why) = set->second;
    student.left_blank = leaves_blank(submission);
    take_off_for_lateness(student, agreed.late);
    if (student.overridden > student.possible() + 1e-9)
        throw UserError{(out / "overrides.csv").string() + ": " + submission.id + " can't have "
                        + points_text(*student.overridden) + " of " + points_text(student.possible()) + " points"};
    return student;
}

GradedClass Assignment::graded() const {
    GradedClass all{.section = section_,
                    .platform = handed_in.platform,
                    .version = course_version(),
                    .tests_hash = tests_hash,
                    .void_tests = agreed.void_tests,
                    .students = {},
                    .tests = tests_of(workspace, section_),
                    .seed = agreed.seed,
                    .warning = warning_of_this_kernel()};
    for (const Submission &each : handed_in.all) all.students.push_back(graded_student(each));
    for (const auto &[id, set] : overrides)
        if (std::ranges::count(handed_in.all, id, &Submission::id) == 0) {
            Submission nothing;
            nothing.id = id;
            nothing.trouble = "You handed in nothing.";
            all.students.push_back(graded_student(nothing));
        }
    return all;
}

std::vector<Change> Assignment::note_changes(const GradedClass &graded) const {
    std::vector<Change> all;
    json last = json::object(), now = json::object();
    if (fs::exists(out / "last.json")) last = json::parse(read_file(out / "last.json"), nullptr, false);
    for (const Graded &student : graded.students) {
        const std::string &id = student.submission.id;
        if (!student.our_trouble.empty()) { // it counts when it's there
            if (last.contains(id)) now[id] = last[id];
            continue;
        }
        if (student.left_blank) {
            if (last.contains(id)) all.push_back({id, last[id].value("points", "0"), "nothing", "there's no file"});
            continue;
        }
        const std::set<std::string> failed = failed_tests(student);
        now[id] = {{"points", points_text(student.earned())}, {"failed", failed}, {"file", student.file_hash}};
        if (student.overridden) now[id]["set"] = student.why;
        const bool is_new = !last.contains(id);
        if (is_new && (!student.overridden || last.empty())) continue; // who hands in later is nothing to look at
        const json old = is_new ? json::object() : last[id];
        const std::string before = old.value("points", "nothing");
        const bool other_file = old.value("file", student.file_hash) != student.file_hash;
        if (before == now[id]["points"] && !(student.overridden && other_file)) continue;
        const auto failed_before = old.value("failed", std::set<std::string>{});
        Change change{id, before, points_text(student.earned()), ""};
        std::vector<std::string> others;
        std::ranges::set_symmetric_difference(failed_before, failed, std::back_inserter(others));
        for (const std::string &test : others) change.because += (change.because.empty() ? "" : "; ") + test;
        if (student.overridden)
            change.because =
                "set by hand: " + student.why
                + (other_file ? "; another file was handed in, which comes to " + points_text(student.judged()) : "");
        else if (old.contains("set")) change.because = "no longer set by hand";
        else if (other_file) change.because = "another file was handed in";
        else if (others.empty()) change.because = "what the points are counted by";
        all.push_back(std::move(change));
    }
    for (const auto &[id, old] : last.items())
        if (std::ranges::find(graded.students, id, [](const Graded &each) { return each.submission.id; })
            == graded.students.end())
            all.push_back({id, old.value("points", "nothing"), "nothing",
                           old.contains("set") ? "no longer set by hand: clear it on the platform, too"
                                               : "nothing is handed in any more"});
    write_file(out / "last.json", now.dump(1) + '\n');
    return all;
}

std::vector<Change> Assignment::write(const GradedClass &graded) const {
    std::map<std::string, Entered> grades;
    std::map<std::string, std::string> names;
    std::vector<std::pair<std::string, std::string>> texts;
    std::vector<Report> reports;
    for (const Graded &student : graded.students) {
        const Submission &submission = student.submission;
        if (!submission.feedback_name.empty())
            texts.emplace_back(submission.feedback_name, feedback(graded, student, false));
        if (!has_grade(student)) continue;
        grades[submission.id] = {student.possible() > 0 ? student.earned() / student.possible() : 0, comment(student)};
        Report report{section_, submission.id, agreed.seed, exercises, graded.tests, student.unbuilt, {}};
        for (const GradedExercise &exercise : student.exercises)
            std::ranges::copy(exercise.verdicts, std::back_inserter(report.verdicts));
        if (!submission.trouble.empty())
            report.unbuilt = Verdict{.kind = Outcome::empty, .sentence = submission.trouble};
        report.also = {{"file sha256", student.file_hash}, {"tests sha256", tests_hash}};
        reports.push_back(std::move(report));
    }
    if (book)
        for (const Person &row : book->rows()) names[row.id] = row.name;
    write_file(out / "points.csv", points_table(graded, names));
    write_archive(out / "feedback.zip", texts);
    write_file(out / "junit.xml", junit(reports));
    if (book) write_file(out / "grades.csv", book->filled(grades));
    if (!fs::exists(out / "overrides.csv")) write_file(out / "overrides.csv", "id,points,why\n");
    const auto changed = note_changes(graded);
    write_file(out / "report.html", report_page(graded, names, missing(), changed));
    return changed;
}

} // namespace course
