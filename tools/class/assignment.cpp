#include "class/assignment.hpp"

#include "class/archive.hpp"
#include "class/csv.hpp"
#include "class/feedback.hpp"
#include "class/late.hpp"
#include "class/points.hpp"
#include "class/pool.hpp"
#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/plain.hpp"
#include "ground/process.hpp"
#include "ground/text.hpp"
#include "loop/answer.hpp"
#include "loop/junit.hpp"
#include "loop/mistakes.hpp"
#include "loop/toolbox.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace course {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

/// SHA-256 of each file, 64 digits.
std::vector<std::string> hashes_of(const std::vector<fs::path> &files) {
    std::vector<std::string> command{"sha256sum", "--"}, all;
    for (const fs::path &file : files) command.push_back(file.string());
    if (files.empty()) return all;
    const Finished done = run(command);
    for (const Line &line : lines_of(done.out)) all.emplace_back(line.text.substr(0, 64));
    if (done.code != 0 || all.size() != files.size())
        throw Complaint{"sha256sum can't read what is to be judged: " + done.err};
    return all;
}

/// One hash of everything that a verdict on this section rests on, as it's built here.
std::string hash_of_judges(const Tree &tree, const Section &section, const fs::path &list) {
    const Toolbox tools = toolbox(tree, section);
    bring_up_to_date(tree, section, tools);
    std::string text = course_version() + '\n';
    for (const std::string &hash : hashes_of({tree.test_program(section), tools.server, tools.missing, tools.ours,
                                              tree.header(section), tree.stub(section)}))
        text += hash + '\n';
    write_file(list, text);
    return hashes_of({list}).front();
}

fs::path copied(const fs::path &given, const fs::path &to) {
    if (given == to || given.empty() || fs::is_directory(given)) return given;
    if (!fs::exists(given)) throw Complaint{"there's no " + given.string() + ": is its name right?"};
    write_file(to, read_file(given));
    return to;
}

void remember_agreed(const Agreed &agreed, const fs::path &out) {
    write_file(out / "grade.json", json{{"section", agreed.section},
                                        {"given", agreed.given.string()},
                                        {"gradebook", agreed.gradebook.string()},
                                        {"column", agreed.column},
                                        {"worth", agreed.worth.string()},
                                        {"void_tests", agreed.void_tests},
                                        {"forgive", agreed.forgive},
                                        {"late", agreed.late},
                                        {"seed", agreed.seed}}
                                           .dump(1)
                                       + '\n');
}

constexpr const char *head_of_overrides = "id,points,why\n";

/// What the instructor has set by hand: points and why, by id.
std::map<std::string, std::pair<double, std::string>> overrides_in(const fs::path &file) {
    std::map<std::string, std::pair<double, std::string>> all;
    if (!fs::exists(file)) return all;
    const std::string text = read_file(file);
    bool head = true;
    for (const std::vector<CsvCell> &row : read_csv(text, file.string()).rows) {
        const bool is_head = std::exchange(head, false) && row.front().text == "id";
        if (is_head || row.front().text.empty()) continue;
        std::string points = row.size() < 2 ? "" : row[1].text;
        std::ranges::replace(points, ',', '.');
        std::size_t end = 0;
        double worth = -1;
        try {
            worth = std::stod(points, &end);
        } catch (const std::exception &) {}
        if (row.size() != 3 || end != points.size() || !std::isfinite(worth) || worth < 0)
            throw Complaint{file.string() + ": the line of " + row.front().text
                            + " should be an id, points, and why: 1003,7.5,\"was ill\""};
        if (!all.insert({row.front().text, {worth, row[2].text}}).second)
            throw Complaint{file.string() + " has two lines for " + row.front().text + ": leave the one that counts"};
    }
    return all;
}

/// A folder that holds anything else may be anybody's: nothing there is written over.
void require_own_folder(const fs::path &out) {
    if (!fs::exists(out) || Assignment::is_begun(out)) return;
    if (!fs::is_directory(out)) throw Complaint{out.string() + " is a file: name a folder, which is made"};
    for (const fs::directory_entry &entry : fs::directory_iterator{out}) {
        const std::string name = entry.path().filename().string();
        if (!is_any_of(name, {"files", "handed_in.zip", "gradebook.csv", "points.txt", "overrides.csv"}))
            throw Complaint{out.string() + " has something else in it, " + name
                            + ", so nothing is written there: name a new folder, which is made"};
    }
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

Assignment::Assignment(const Tree &tree_, Agreed agreed_, const fs::path &out_)
    : tree{tree_}, agreed{std::move(agreed_)}, out{out_}, its_section{tree.section(agreed.section)} {
    tree.require_solution(its_section, "Grade with the whole course, which has them");
    require_own_folder(out);
    if (!agreed.gradebook.empty()) book.emplace(agreed.gradebook, its_section, agreed.column);
    fs::create_directories(out / "files");
    fs::permissions(out, fs::perms::owner_all);
    handed_in = read_submissions(agreed.given, its_section, out / "files");
    if (book && handed_in.platform != Platform::folder && handed_in.platform != book->platform())
        throw Complaint{"the submissions are from " + std::string{name_of(handed_in.platform)}
                        + ", but the gradebook is from " + std::string{name_of(book->platform())}};
    learn_lateness();
    overrides = overrides_in(out / "overrides.csv");
    for (const auto &[id, set] : overrides)
        if (std::ranges::count(handed_in.all, id, &Submission::id) == 0
            && !(book && std::ranges::count(book->rows(), id, &Person::id) > 0))
            throw Complaint{(out / "overrides.csv").string() + ": nobody has the id " + plain_line(id, 100)
                            + ", neither among the submissions nor in the gradebook"};
    const auto tests = tests_of(tree, its_section);
    for (const std::string &name : agreed.void_tests)
        if (std::ranges::find(tests, name, &KnownTest::claim) == tests.end())
            throw Complaint{"section " + its_section.short_number() + " has no test `" + name + "`: ./course check "
                            + its_section.short_number() + " -v lists their names"};
    agreed.given = copied(agreed.given, out / "handed_in.zip");
    agreed.gradebook = copied(agreed.gradebook, out / "gradebook.csv");
    agreed.worth = copied(agreed.worth, out / "points.txt");
    remember_agreed(agreed, out);
    judged_with = hash_of_judges(tree, its_section, out / "judged_with.txt");
    tests_hash = hash_of_tests(tree, its_section);
    std::vector<fs::path> files;
    std::vector<std::string> ids;
    for (const Submission &each : handed_in.all)
        if (!each.file.empty()) files.push_back(each.file), ids.push_back(each.id);
    const auto of_files = hashes_of(files);
    for (std::size_t i = 0; i < ids.size(); ++i) hashes[ids[i]] = of_files[i];
}

void Assignment::learn_lateness() {
    if (agreed.late > 0 && (handed_in.platform == Platform::canvas || (book && book->platform() == Platform::canvas)))
        throw Complaint{"Canvas takes points off for lateness itself, and knows by how much: leave out --late, and set "
                        "it there, in the gradebook's Settings, Late Policies"};
    if (agreed.late > 0 && !(book && book->tells_lateness()))
        throw Complaint{
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
        throw Complaint{folder.string()
                        + " is no folder that `grade` has made: begin with a section and a download, as "
                          "in ./course grade 5 submissions.zip --out "
                        + folder.string()};
    const json its = json::parse(read_file(folder / "grade.json"));
    const auto path = [&](const char *key) { return fs::path{its.at(key).get<std::string>()}; };
    return {its.at("section"),    path("given"),     path("gradebook"),      its.at("column"), path("worth"),
            its.at("void_tests"), its.at("forgive"), its.value("late", 0.0), its.at("seed")};
} catch (const json::exception &) {
    throw Complaint{(folder / "grade.json").string()
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

std::string Assignment::key_of(const std::string &id) const {
    const auto its = hashes.find(id);
    return its == hashes.end() ? "" : its->second + ' ' + judged_with + ' ' + std::to_string(agreed.seed);
}

std::optional<Outcomes> Assignment::result(const std::string &id) const {
    if (!fs::exists(result_of(id))) return {};
    const std::string text = read_file(result_of(id));
    const std::size_t line = text.find('\n');
    if (line == text.npos || text.substr(0, line) != key_of(id)) return {};
    return outcomes_from(text.substr(line));
}

bool Assignment::is_judged(const std::string &id) const {
    const auto its = result(id);
    return its && its->our_trouble.empty(); // else it's tried again
}

void Assignment::merge(const fs::path &folder) {
    if (!fs::is_directory(folder / "results"))
        throw Complaint{folder.string() + " holds no part of a class: has its --shard run?"};
    for (const Submission &each : handed_in.all) {
        const fs::path its = folder / "results" / (each.id + ".json");
        if (fs::exists(its) && !is_judged(each.id)) write_file(result_of(each.id), read_file(its));
    }
}

std::size_t Assignment::judge(const std::set<std::string> &only, std::pair<std::size_t, std::size_t> part,
                              const std::function<void(std::size_t, std::size_t)> &ended) {
    baselines = measure_baselines(tree, its_section); // first: where it can't be done, nobody can be judged
    std::vector<const Submission *> open;
    for (std::size_t i = 0; i < handed_in.all.size(); ++i) {
        const Submission &each = handed_in.all[i];
        if (each.file.empty() || i % part.second != part.first - 1) continue;
        if (only.empty() ? !is_judged(each.id) : only.contains(each.id)) open.push_back(&each);
    }
    std::size_t done = 0;
    for (const Submission *each : open) fs::remove(result_of(each->id)); // what's left of earlier ones isn't theirs
    in_parallel(
        open.size(),
        [&](std::size_t which) {
            const Submission &each = *open[which];
            Outcomes outcomes;
            try {
                outcomes = outcomes_of(tree, its_section, name_of_file(), read_answer(each.file), agreed.seed);
            } catch (const Complaint &complaint) {
                outcomes.our_trouble = complaint.what();
            }
            write_file(result_of(each.id), key_of(each.id) + '\n' + to_text(outcomes));
        },
        [&] { ended(++done, open.size()); });
    return open.size();
}

GradedClass Assignment::graded() const {
    GradedClass all{its_section, handed_in.platform,         course_version(), tests_hash, agreed.void_tests,
                    {},          tests_of(tree, its_section)};
    const Worth worth{agreed.worth.empty() ? tree.root / "tests" / "points.txt" : agreed.worth};
    const fs::path known = file_of_mistakes(tree, its_section);
    const std::string mistakes = fs::exists(known) ? '\n' + read_file(known) : "";
    const auto exercises = catalogue(tree, its_section);
    const WhichTests today = which_tests(tests_hash, all.version);
    double sum = 0;
    for (const Exercise &exercise : exercises) sum += worth.of(exercise);
    const double unit = book && sum > 0 ? book->most() / sum : 1; // points of the gradebook for one of ours
    std::vector<Submission> everybody = handed_in.all;
    for (const auto &[id, set] : overrides)
        if (std::ranges::find(everybody, id, &Submission::id) == everybody.end()) {
            Submission &nothing = everybody.emplace_back();
            nothing.id = id;
            nothing.trouble = "You handed in nothing.";
        }
    for (const Submission &each : everybody) {
        Graded student;
        student.submission = each;
        Outcomes outcomes;
        if (!each.file.empty()) {
            if (const auto its = result(each.id)) outcomes = *its;
            else outcomes.our_trouble = "it hasn't been judged as it is now, by these tests";
            student.file_hash = hashes.at(each.id);
            if (const auto began = stamp_in(read_answer(each.file)); began && began->digits != today.digits)
                student.began_with = began;
        }
        student.our_trouble = outcomes.our_trouble;
        student.unbuilt = outcomes.unbuilt;
        student.taken_out = outcomes.taken_out;
        for (const Exercise &exercise : exercises) {
            GradedExercise its;
            its.exercise = exercise;
            its.possible = unit * worth.of(exercise);
            std::ranges::copy_if(outcomes.verdicts, std::back_inserter(its.verdicts),
                                 [&](const Verdict &v) { return v.exercise == exercise.number; });
            if (const auto why = outcomes.without.find(exercise.number); why != outcomes.without.end())
                its.unbuilt = why->second;
            if (const auto other = outcomes.because_of.find(exercise.number); other != outcomes.because_of.end())
                its.consequence_of = other->second;
            its.mistake = its.unbuilt ? "" : known_mistake(mistakes, its.verdicts);
            const auto trivial = baselines.find(exercise.number);
            count(its, agreed.void_tests, trivial == baselines.end() ? Baselines::mapped_type{} : trivial->second);
            if (agreed.forgive && !its.consequence_of.empty()) its.earned = its.possible;
            student.exercises.push_back(std::move(its));
        }
        if (const auto set = overrides.find(each.id); set != overrides.end())
            std::tie(student.overridden, student.why) = set->second;
        take_off_for_lateness(student, agreed.late);
        if (student.overridden > student.possible() + 1e-9)
            throw Complaint{(out / "overrides.csv").string() + ": " + each.id + " can't have "
                            + points_text(*student.overridden) + " of " + points_text(student.possible()) + " points"};
        all.students.push_back(std::move(student));
    }
    return all;
}

std::vector<Change> Assignment::changes(const GradedClass &graded) const {
    std::vector<Change> all;
    json last = json::object(), now = json::object();
    if (fs::exists(out / "last.json")) last = json::parse(read_file(out / "last.json"), nullptr, false);
    for (const Graded &student : graded.students) {
        const std::string &id = student.submission.id;
        if (!student.our_trouble.empty()) { // it counts when it's there
            if (last.contains(id)) now[id] = last[id];
            continue;
        }
        const std::set<std::string> failed = failed_tests(student);
        now[id] = {{"points", points_text(student.earned())}, {"failed", failed}, {"file", student.file_hash}};
        const bool is_new = !last.contains(id);
        if (is_new && (!student.overridden || last.empty())) continue; // who hands in later is nothing to look at
        const json old = is_new ? json::object() : last[id];
        const std::string before = old.value("points", "nothing");
        if (before == now[id]["points"]) continue;
        const auto failed_before = old.value("failed", std::set<std::string>{});
        Change change{id, before, points_text(student.earned()), ""};
        std::vector<std::string> others;
        std::ranges::set_symmetric_difference(failed_before, failed, std::back_inserter(others));
        for (const std::string &test : others) change.because += (change.because.empty() ? "" : "; ") + test;
        if (student.overridden) change.because = "set by hand: " + student.why;
        else if (old.value("file", student.file_hash) != student.file_hash)
            change.because = "another file was handed in";
        else if (others.empty()) change.because = "what the points are counted by";
        all.push_back(std::move(change));
    }
    write_file(out / "last.json", now.dump(1) + '\n');
    return all;
}

std::vector<Change> Assignment::write(const GradedClass &graded) const {
    std::map<std::string, Entered> grades;
    std::map<std::string, std::string> names;
    std::vector<std::pair<std::string, std::string>> texts;
    std::vector<Report> reports;
    const auto exercises = catalogue(tree, its_section);
    for (const Graded &student : graded.students) {
        const Submission &its = student.submission;
        if (!its.feedback_name.empty()) texts.emplace_back(its.feedback_name, feedback(graded, student, false));
        if (!student.our_trouble.empty()) continue;
        grades[its.id] = {student.possible() > 0 ? student.earned() / student.possible() : 0, comment(student)};
        Report report{its_section, its.id, agreed.seed, exercises, graded.tests, student.unbuilt, {}};
        for (const GradedExercise &exercise : student.exercises)
            std::ranges::copy(exercise.verdicts, std::back_inserter(report.verdicts));
        if (!its.trouble.empty()) report.unbuilt = Verdict{.kind = Kind::empty, .sentence = its.trouble};
        report.also = {{"file sha256", student.file_hash}, {"tests sha256", tests_hash}};
        reports.push_back(std::move(report));
    }
    if (book)
        for (const Person &row : book->rows()) names[row.id] = row.name;
    write_archive(out / "feedback.zip", texts);
    write_file(out / "junit.xml", junit(reports));
    if (book) write_file(out / "grades.csv", book->filled(grades));
    if (!fs::exists(out / "overrides.csv")) write_file(out / "overrides.csv", head_of_overrides);
    const auto changed = changes(graded);
    write_file(out / "report.html", report_page(graded, names, missing(), changed));
    return changed;
}

} // namespace course
