#include "class/report_students.hpp"

#include "class/statistics.hpp"

namespace course::report {
namespace {

bool is_not_started(const GradedExercise &exercise) {
    return exercise.passed <= exercise.baseline && !exercise.verdicts.empty() && !exercise.unbuilt
           && std::ranges::all_of(exercise.verdicts, [](const Verdict &verdict) {
                  return verdict.passed() || verdict.kind == Kind::not_started;
              });
}

bool is_to_look_at(const Graded &student) {
    return student.exercises.empty() || student.overridden || student.submission.late || !student.our_trouble.empty()
           || !student.taken_out.empty() || !std::ranges::all_of(student.exercises, &GradedExercise::all_passed);
}

std::string share(const GradedExercise &exercise) {
    return fmt::format("{} of {}", exercise.passed, counted(exercise.counted, "test"));
}

std::string cell(const GradedExercise &exercise) {
    if (exercise.unbuilt) return "<td class=\"bad\">" + sign("✗", "doesn't compile") + "</td>";
    if (exercise.all_passed()) return "<td class=\"good\">" + sign("✓", "passed") + "</td>";
    if (exercise.counted == 0) return "<td>" + sign("–", "no test counts") + "</td>";
    if (is_not_started(exercise)) return "<td class=\"dim\">" + sign("·", "not started") + "</td>";
    const std::string some = fmt::format("{}/{}", exercise.passed, exercise.counted);
    if (exercise.consequence_of.empty()) return "<td>" + sign(some, share(exercise)) + "</td>";
    return "<td>" + sign("↳" + some, share(exercise) + ", since " + shown(exercise.consequence_of) + " isn't right")
           + "</td>";
}

/// What's wrong with an exercise, from its points to the verdict that says most.
std::string detail(const GradedClass &graded, const GradedExercise &exercise) {
    std::string html = fmt::format("<h3>{} {}</h3>\n<p>{}, {} of {} {}", shown(exercise.exercise.number),
                                   shown(exercise.exercise.function), share(exercise), points_text(exercise.earned),
                                   points_text(exercise.possible), exercise.possible == 1 ? "point" : "points");
    if (exercise.baseline > 0) html += fmt::format(". An answer that computes nothing passes {}", exercise.baseline);
    html += ".</p>\n";
    if (!exercise.consequence_of.empty())
        html += "<p>It's right, but it calls " + shown(exercise.consequence_of) + ", and that isn't.</p>\n";
    if (!exercise.mistake.empty()) html += "<p>A known mistake: “" + shown(exercise.mistake) + "”</p>\n";
    if (exercise.unbuilt) return html + preformatted(explain(*exercise.unbuilt, 0));
    const Verdict *verdict = telling_verdict(graded, exercise);
    if (verdict == nullptr) return html;
    return html + "<p>✗ " + shown(verdict->test) + "</p>\n" + preformatted(explain(*verdict, 0));
}

std::string in_short(const GradedClass &graded, const GradedExercise &exercise) {
    const std::string number = shown(exercise.exercise.number);
    if (exercise.unbuilt) return number + " doesn't compile";
    const Verdict *verdict = telling_verdict(graded, exercise);
    return verdict == nullptr ? number + " has no test that counts" : number + ": " + shown(verdict->test);
}

/// A fold with all exercises that aren't right, if one is more than not started; shut, it says the first.
std::string what_is_wrong(const GradedClass &graded, const Graded &student) {
    std::string first, details, later;
    for (const GradedExercise &exercise : student.exercises) {
        if (exercise.all_passed()) continue;
        if (is_not_started(exercise)) {
            later += (later.empty() ? "" : ", ") + shown(exercise.exercise.number + ' ' + exercise.exercise.function);
            continue;
        }
        if (first.empty()) first = in_short(graded, exercise);
        details += detail(graded, exercise);
    }
    if (first.empty()) return "";
    return fold(first, details + (later.empty() ? "" : "<p>Not started: " + later + "</p>\n"));
}

std::string below(const GradedClass &graded, const Graded &student) {
    std::string html;
    const auto say = [&](const std::string &kind, const std::string &words) {
        html += "<p class=\"" + kind + "\">" + words + "</p>\n";
    };
    if (!student.our_trouble.empty()) say("bad", "Our trouble: " + shown(student.our_trouble));
    if (student.taken_off > 0)
        say("set", points_text(student.taken_off) + " of " + points_text(student.earned() + student.taken_off)
                       + " points taken off, for being " + counted(student.days_late, "day") + " late");
    if (student.overridden) say("set", "You set these points: " + shown(student.why));
    if (!student.submission.trouble.empty())
        say("bad", "No file to judge: “" + shown(student.submission.trouble) + "”");
    if (student.unbuilt)
        html += fold("The file: " + shown(std::string{name_of(student.unbuilt->kind)}),
                     preformatted(explain(*student.unbuilt, 0)));
    for (const Verdict &why : student.taken_out)
        html += fold("A function that belongs to no exercise: the rest was judged without it",
                     preformatted(explain(why, 0)));
    return html + what_is_wrong(graded, student);
}

std::string cells(const Graded &student, const std::vector<std::string> &exercises) {
    std::string all;
    for (const std::string &number : exercises) {
        const auto found =
            std::ranges::find(student.exercises, number, [](const GradedExercise &one) { return one.exercise.number; });
        all += found == student.exercises.end() ? "<td></td>" : cell(*found);
    }
    return all;
}

/// Two rows: what there is to compare, and what's to be said.
std::string rows(const GradedClass &graded, const Graded &student, const People &people,
                 const std::vector<std::string> &exercises) {
    const std::string &id = student.submission.id;
    std::string html = fmt::format(R"(<tbody id="{0}" class="{1}">
<tr><th scope="row"><a href="#{0}">{2}</a></th>)",
                                   People::anchor(id), is_to_look_at(student) ? "" : "whole", shown(id));
    if (!people.names.empty()) html += "<td class=\"name\">" + people.name(id) + "</td>";
    html += "<td>" + (has_grade(student) ? points_text(student.earned()) : sign("–", "no grade")) + "</td>";
    html += cells(student, exercises) + "<td class=\"file\">" + shown(student.submission.taken) + ' '
            + (student.submission.late ? tag(shown(lateness(student.submission))) : "")
            + (student.overridden ? tag("set by you") : "") + "</td></tr>\n";
    if (const std::string more = below(graded, student); !more.empty())
        html += fmt::format("<tr class=\"more\"><td colspan=\"{}\"><div>\n{}</div></td></tr>\n",
                            exercises.size() + (people.names.empty() ? 3 : 4), more);
    return html + "</tbody>\n";
}

} // namespace

std::string student_table(const GradedClass &graded, const People &people, const std::vector<std::string> &exercises) {
    if (graded.students.empty()) return "";
    std::vector<std::string> columns{"Student", "Name", "Points"};
    if (people.names.empty()) columns.erase(columns.begin() + 1);
    columns.insert(columns.end(), exercises.begin(), exercises.end());
    columns.emplace_back("File");
    std::string all;
    for (const Graded &student : graded.students) all += rows(graded, student, people, exercises);
    return R"(<p class="filter"><label><input type="checkbox" id="only-red"/> Hide students with nothing to look at)"
           "</label></p>\n"
           + table("Students", columns, all)
           + "<p class=\"dim\">✓ all tests pass; 3/5 so many do; · not started; ✗ doesn't compile; ↳ is right, but "
             "calls "
             "another exercise that isn't; – no grade, or no test that counts.</p>\n";
}

} // namespace course::report
