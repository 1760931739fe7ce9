#include "grade/feedback.hpp"

#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"
#include "grade/points.hpp"
#include "grade/statistics.hpp"

#include <algorithm>

namespace course {
namespace {

/// "2 of 2 points"
std::string of_points(double earned, double possible) {
    return points_text(earned) + " of " + points_text(possible) + (points_text(possible) == "1" ? " point" : " points");
}

/// "That's 9.54, minus 2 for being 2 days late."
std::string taken_off(const Graded &student) {
    return "That's " + points_text(student.earned() + student.taken_off) + ", minus " + points_text(student.taken_off)
           + " for being " + pluralize(student.days_late, "day") + " late.";
}

std::string where(const Verdict &verdict) {
    return verdict.file.empty() ? "" : verdict.file + ':' + std::to_string(verdict.line) + ": ";
}

std::string of_unbuilt(const Verdict &verdict, const std::string &indent) {
    std::string text = indent + where(verdict) + verdict.sentence + '\n';
    for (const std::string &line : verdict.printed) text += indent + line + '\n';
    return text;
}

/// What isn't right in an exercise: the first failure in words, and the names of the others.
std::string failures(const GradedClass &graded, const GradedExercise &exercise, bool whole) {
    constexpr std::size_t most = 3; // names beside the first, as `check` shows them
    std::string text;
    std::size_t failures = 0;
    for (const Verdict &verdict : exercise.verdicts) {
        if (verdict.passed() || is_void(graded, verdict.test) || (++failures > 1 + most && !whole)) continue;
        text += "    ✗ " + verdict.test;
        if (verdict.kind != Outcome::wrong) text += "  (" + std::string{name_of(verdict.kind)} + ')';
        text += '\n';
        if (failures == 1 || whole) text += explain(verdict, 6);
    }
    if (failures > 1 + most && !whole) text += "      and " + std::to_string(failures - 1 - most) + " more\n";
    return text;
}

/// Whether it's as the stub has it.
bool is_open(const GradedExercise &exercise) {
    return exercise.consequence_of.empty() && std::ranges::any_of(exercise.verdicts, [](const Verdict &v) {
               return v.kind == Outcome::not_started && v.needs.empty();
           });
}

std::string of_exercise(const GradedClass &graded, const GradedExercise &exercise, bool whole) {
    const bool good = exercise.all_passed();
    std::string text = (good ? "✓ " : "✗ ") + exercise.exercise.number + ' ' + exercise.exercise.function + ", "
                       + exercise.exercise.tier + ": " + of_points(exercise.earned, exercise.possible);
    if (good) return text + '\n';
    if (exercise.unbuilt)
        return text + ", since it doesn't compile (the rest was judged without it)\n"
               + of_unbuilt(*exercise.unbuilt, "    ");
    if (is_open(exercise)) return text + ", not started\n";
    text += ", " + std::to_string(exercise.passed) + " of " + pluralize(exercise.counted, "test") + " passed";
    if (exercise.baseline > 0)
        text += " (an answer that computes nothing passes " + std::to_string(exercise.baseline) + ')';
    text += '\n';
    if (!exercise.consequence_of.empty())
        text += "    This is a consequence of " + exercise.consequence_of + ": with ours in its place, all of it passes"
                + (exercise.earned == exercise.possible ? ", and it has its points.\n" : ".\n");
    if (exercise.consequence_of.empty() || whole) text += failures(graded, exercise, whole);
    if (!exercise.mistake.empty()) text += "    This is what comes out when " + exercise.mistake + '\n';
    return text;
}

} // namespace

std::string without_commands(const std::string &text) {
    std::string kept;
    for (const Line &each : split_lines(text)) {
        std::string line{each.text};
        for (std::size_t at = 0; (at = line.find("./course")) != line.npos;) {
            const auto last = [&](const char *end) { return line.rfind(end, at) + 2; }; // npos + 2 is 1
            const std::size_t from = std::max(last(". "), last(": ")), behind = line.find(". ", at);
            if (from > 1 && line[from - 2] == ':') line[from - 2] = '.';
            line.erase(from > 1 ? from - 1 : 0,
                       behind == line.npos ? line.npos : behind + 1 - (from > 1 ? from - 1 : 0));
        }
        if (line.find_first_not_of(' ') != line.npos || each.text.empty()) kept += line + '\n';
    }
    return kept;
}

std::string feedback_head(const GradedClass &graded, const Graded &student) {
    const std::string title = "Section " + graded.section.short_number();
    if (!student.our_trouble.empty())
        return title + " hasn't been judged yet: the grader, or its machine, was in the way. You'll hear again.\n";
    if (student.left_blank) return sanitize(title + " has no points yet.\n" + student.submission.trouble + '\n');
    std::string text = title + ": " + of_points(student.earned(), student.possible()) + '\n';
    if (student.taken_off > 0) text += taken_off(student) + " A day counts once it has started.\n";
    if (student.overridden) text += "These points were set by your instructor: " + student.why + '\n';
    if (!student.submission.trouble.empty()) return sanitize(text + student.submission.trouble + '\n');
    const WhichTests today = which_tests(graded.tests_hash, graded.version);
    const std::string late = lateness(student.submission);
    text += "Judged: " + student.submission.taken + (late.empty() ? "" : " (" + late + ')') + ", by " + words_for(today)
            + "\nThe tests drew their random values by seed " + std::to_string(graded.seed) + ": `check --seed "
            + std::to_string(graded.seed) + "` draws the same.\n";
    if (const auto &began = student.began_with)
        text += "Your file was handed out with " + words_for(*began)
                + ": if your `check` says something else than "
                  "this, `./course update` brings yours up to date.\n";
    for (const std::string &test : graded.void_tests) text += "This test doesn't count for anybody: " + test + '\n';
    std::string rest;
    for (const Verdict &why : student.taken_out)
        rest += "✗ A function of yours that belongs to no exercise (the rest was judged without it)\n"
                + of_unbuilt(why, "    ");
    if (student.unbuilt)
        rest += "It can't be judged (" + std::string{name_of(student.unbuilt->kind)} + "):\n"
                + of_unbuilt(*student.unbuilt, "    ");
    return sanitize(text) + '\n' + without_commands(sanitize(rest));
}

std::string feedback_of(const GradedClass &graded, const GradedExercise &exercise, bool whole) {
    return without_commands(sanitize(of_exercise(graded, exercise, whole)));
}

std::string feedback(const GradedClass &graded, const Graded &student, bool whole) {
    std::string text = feedback_head(graded, student);
    const bool is_judged = student.our_trouble.empty() && !student.left_blank && student.submission.trouble.empty();
    if (is_judged && !student.unbuilt)
        for (const GradedExercise &exercise : student.exercises) text += feedback_of(graded, exercise, whole);
    return text;
}

std::string comment(const Graded &student) {
    std::string text = of_points(student.earned(), student.possible()) + '.';
    if (student.taken_off > 0) text += ' ' + taken_off(student);
    if (student.overridden) text += " Set by your instructor: " + student.why;
    else if (!student.submission.trouble.empty()) text += ' ' + student.submission.trouble;
    else if (student.unbuilt) text += " It can't be judged (" + std::string{name_of(student.unbuilt->kind)} + ").";
    else {
        std::string open;
        for (const GradedExercise &exercise : student.exercises)
            if (!exercise.all_passed())
                open += (open.empty() ? " Not all right yet: " : ", ") + exercise.exercise.number + ' '
                        + exercise.exercise.function;
        text += open.empty() ? " All of it is right." : open + ". The feedback file says what's wrong.";
    }
    return plain_line(text, 1000);
}

} // namespace course
