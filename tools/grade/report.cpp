#include "grade/report.hpp"

#include "check/picture.hpp"
#include "grade/report_html.hpp"
#include "grade/report_style.hpp"
#include "grade/statistics.hpp"

namespace course::report {
namespace {

bool is_not_started(const GradedExercise &exercise) {
    return exercise.passed <= exercise.baseline && !exercise.verdicts.empty() && !exercise.unbuilt
           && std::ranges::all_of(exercise.verdicts, [](const Verdict &verdict) {
                  return verdict.passed() || verdict.kind == Outcome::not_started;
              });
}

bool is_to_look_at(const Graded &student) {
    return student.exercises.empty() || student.overridden || student.submission.late || !student.our_trouble.empty()
           || !student.taken_out.empty() || !std::ranges::all_of(student.exercises, &GradedExercise::all_passed);
}

std::string share(const GradedExercise &exercise) {
    return fmt::format("{} of {}", exercise.passed, pluralize(exercise.counted, "test"));
}

std::string cell(const GradedExercise &exercise) {
    if (exercise.unbuilt) return "<td class=\"bad\">" + sign("✗", "doesn't compile") + "</td>";
    if (exercise.all_passed()) return "<td class=\"good\">" + sign("✓", "passed") + "</td>";
    if (exercise.verdicts.empty()) return "<td>" + sign("–", "not judged") + "</td>";
    if (exercise.counted == 0) return "<td>" + sign("–", "no test counts") + "</td>";
    if (is_not_started(exercise)) return "<td class=\"dim\">" + sign("·", "not started") + "</td>";
    const std::string some = fmt::format("{}/{}", exercise.passed, exercise.counted);
    if (exercise.consequence_of.empty()) return "<td>" + sign(some, share(exercise)) + "</td>";
    return "<td>" + sign("↳" + some, share(exercise) + ", since " + as_html(exercise.consequence_of) + " isn't right")
           + "</td>";
}

/// What's wrong with an exercise, from the points to the verdict that says most.
std::string detail(const GradedClass &graded, const GradedExercise &exercise) {
    std::string html = fmt::format("<h3>{} {}</h3>\n<p>{}, {} of {} {}", as_html(exercise.exercise.number),
                                   as_html(exercise.exercise.function), share(exercise), points_text(exercise.earned),
                                   points_text(exercise.possible), exercise.possible == 1 ? "point" : "points");
    if (exercise.baseline > 0) html += fmt::format(". An answer that computes nothing passes {}", exercise.baseline);
    html += ".</p>\n";
    if (!exercise.consequence_of.empty())
        html += "<p>It's right, but it calls " + as_html(exercise.consequence_of) + ", and that isn't.</p>\n";
    if (!exercise.mistake.empty()) html += "<p>A known mistake: “" + as_html(exercise.mistake) + "”</p>\n";
    if (exercise.unbuilt) return html + preformatted(explain(*exercise.unbuilt, 0));
    const Verdict *verdict = telling_verdict(graded, exercise);
    if (verdict == nullptr) return html;
    return html + "<p>✗ " + as_html(verdict->test) + "</p>\n" + preformatted(explain(*verdict, 0));
}

std::string in_short(const GradedClass &graded, const GradedExercise &exercise) {
    const std::string number = as_html(exercise.exercise.number);
    if (exercise.unbuilt) return number + " doesn't compile";
    const Verdict *verdict = telling_verdict(graded, exercise);
    return verdict == nullptr ? number + " has no test that counts" : number + ": " + as_html(verdict->test);
}

/// A fold with all exercises that aren't right, if one is more than not started; shut, it says the first.
std::string what_is_wrong(const GradedClass &graded, const Graded &student) {
    std::string first, details, later;
    for (const GradedExercise &exercise : student.exercises) {
        if (exercise.all_passed() || (exercise.verdicts.empty() && !exercise.unbuilt)) continue;
        if (is_not_started(exercise)) {
            later += (later.empty() ? "" : ", ") + as_html(exercise.exercise.number + ' ' + exercise.exercise.function);
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
    if (!student.our_trouble.empty()) say("bad", "Our trouble: " + as_html(student.our_trouble));
    if (student.taken_off > 0)
        say("set", points_text(student.taken_off) + " of " + points_text(student.earned() + student.taken_off)
                       + " points taken off, for being " + pluralize(student.days_late, "day") + " late");
    if (student.overridden) say("set", "You set these points: " + as_html(student.why));
    if (!student.submission.trouble.empty())
        say("bad", "No file to judge: “" + as_html(student.submission.trouble) + "”");
    if (student.unbuilt)
        html += fold("The file: " + as_html(std::string{name_of(student.unbuilt->kind)}),
                     preformatted(explain(*student.unbuilt, 0)));
    for (const Verdict &why : student.taken_out)
        html += fold("A function that belongs to no exercise: the rest was judged without it",
                     preformatted(explain(why, 0)));
    return html + what_is_wrong(graded, student);
}

std::string cells(const Graded &student, const std::vector<std::string> &exercises) {
    std::string all;
    for (const std::string &number : exercises) {
        const auto exercise =
            std::ranges::find(student.exercises, number, [](const GradedExercise &one) { return one.exercise.number; });
        all += exercise == student.exercises.end() ? "<td></td>" : cell(*exercise);
    }
    return all;
}

/// Two rows: what there is to compare, and what's to be read.
std::string rows(const GradedClass &graded, const Graded &student, const People &people,
                 const std::vector<std::string> &exercises) {
    const std::string &id = student.submission.id;
    std::string html = fmt::format(R"(<tbody id="{0}" class="{1}">
<tr><th scope="row"><a href="#{0}">{2}</a></th>)",
                                   People::anchor(id), is_to_look_at(student) ? "" : "whole", as_html(id));
    if (!people.names.empty()) html += "<td class=\"name\">" + people.name(id) + "</td>";
    html += "<td>" + (has_grade(student) ? points_text(student.earned()) : sign("–", "no grade")) + "</td>";
    html += cells(student, exercises) + "<td class=\"file\">" + as_html(student.submission.taken) + ' '
            + (student.submission.late ? tag(as_html(lateness(student.submission))) : "")
            + (student.overridden ? tag("set by you") : "") + "</td></tr>\n";
    if (const std::string more = below(graded, student); !more.empty())
        html += fmt::format("<tr class=\"more\"><td colspan=\"{}\"><div>\n{}</div></td></tr>\n",
                            exercises.size() + (people.names.empty() ? 3 : 4), more);
    return html + "</tbody>\n";
}

/// The class as a table: a row for each student, and below it, folded, what's wrong.
/// @param exercises  by number: the columns
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

/// A heading, and what's below it: a part of the page that isn't there if it's empty.
struct Part {
    std::string id, title, html, kind{};
};

class Page {
  public:
    Page(const GradedClass &graded_, const std::map<std::string, std::string> &names) : graded{graded_}, people{names} {
        for (const TestOfClass &test : tests) {
            if (exercises.empty() || exercises.back() != test.test.exercise) exercises.push_back(test.test.exercise);
        }
    }

    std::string head(std::size_t missing) const {
        std::vector<double> all;
        double possible = 0;
        for (const Graded &student : graded.students) {
            if (has_grade(student)) all.push_back(student.earned());
            possible = std::max(possible, student.possible());
        }
        std::string facts = fact("Students", in_numbers(all.size(), missing));
        std::string spread = points_text(possible) + " possible";
        if (const auto middle = quartiles(all))
            spread += fmt::format("; the median is {}, and half of the class is between {} and {}",
                                  points_text(middle->median), points_text(middle->lower), points_text(middle->upper));
        facts += fact("Points", spread) + fact("Course", as_html(graded.version))
                 + fact("Hash of the tests", "<code>" + as_html(graded.tests_hash) + "</code>")
                 + fact("Seed of generated values", std::to_string(graded.seed));
        if (!graded.warning.empty())
            facts += fact("Protection", "<span class=\"bad\">" + as_html(graded.warning) + "</span>");
        std::string voids;
        for (const std::string &claim : graded.void_tests) voids += "<li>" + as_html(claim) + "</li>\n";
        if (!voids.empty()) facts += fact("Tests that don't count", "<ul>\n" + voids + "</ul>");
        return fmt::format("<h1>{}</h1>\n<p class=\"lead\">{}</p>\n<dl class=\"facts\">\n{}</dl>\n", title(),
                           "How the class did, for its instructor alone.", facts);
    }

    std::string title() const {
        std::string words = graded.section.slug();
        std::ranges::replace(words, '_', ' ');
        return as_html("Section " + graded.section.short_number() + ", " + words);
    }

    std::string our_troubles() const {
        return about_students(
            "<p>These have no verdict that counts, and it's not their fault. Mend what's said here, then type your "
            "<code>./course grade</code> once more, with the same <code>--out …</code> and with "
            "<code>--again</code>.</p>\n",
            [](const Graded &student) { return as_html(student.our_trouble); });
    }

    std::string changed(const std::vector<Change> &changes) const {
        std::string rows;
        for (const Change &change : changes)
            rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                                people.link(change.id), as_html(change.before), as_html(change.after),
                                as_html(change.because));
        return rows.empty()
                   ? ""
                   : table("Changes", {"Student", "Before", "Now", "Because of"}, "<tbody>\n" + rows + "</tbody>\n");
    }

    std::string all_students() const { return student_table(graded, people, exercises); }

    std::string list(const std::vector<std::string> &ids) const {
        std::string all;
        for (const std::string &id : ids) all += "<li>" + people.id_and_name(id) + "</li>\n";
        return all.empty() ? "" : "<ul>\n" + all + "</ul>\n";
    }

    std::string all_tests() const {
        std::string rows, last;
        for (const TestOfClass &test : tests) {
            if (test.test.exercise != last) rows += heading_of_tests(test.test.exercise);
            last = test.test.exercise;
            rows += row(test);
        }
        if (rows.empty()) return "";
        return table("Tests", {"Test", "Pass", "Most common failure"}, "<tbody>\n" + rows + "</tbody>\n");
    }

    std::string alike() const {
        std::string all;
        for (const Alike &group : equal_wrong_answers(graded)) all += group_of(group);
        if (all.empty()) return "";
        return "<p>The same wrong values came out of these students' functions. That can have many innocent reasons: "
               "they learned from the same page, sat in the same tutorial, or made a slip that almost everybody makes "
               "once. So ask before you think of copying. Where the mistake has a name, it's a common one, and being "
               "equal tells you nothing.</p>\n"
               + all;
    }

    std::string began_with_others() const {
        return about_students(
            "<p>Their files were handed out with other tests than judged them here. They may have taken an update "
            "since: <code>./course check -v</code> says which tests they have now.</p>\n",
            [](const Graded &student) { return student.began_with ? as_html(words_for(*student.began_with)) : ""; });
    }

    std::string not_taken() const {
        return about_students("", [](const Graded &student) {
            std::string files;
            for (const std::string &file : student.submission.others)
                files += (files.empty() ? "" : "; ") + as_html(file);
            return files;
        });
    }

    std::string undelivered() const {
        return about_students("<p>What's for them in feedback.zip can't be read in Canvas. Paste into a comment what "
                              "<code>./course grade --out … --only</code> and their number prints.</p>\n",
                              [](const Graded &student) { return as_html(student.submission.undelivered); });
    }

  private:
    /// A list of those about whom there's something to say; nothing if there are none.
    /// @param html  what there is
    std::string about_students(const std::string &before, std::string (*html)(const Graded &)) const {
        std::string all;
        for (const Graded &student : graded.students)
            if (const std::string words = html(student); !words.empty())
                all += "<li>" + people.link(student.submission.id) + ": " + words + "</li>\n";
        return all.empty() ? "" : before + "<ul>\n" + all + "</ul>\n";
    }

    static std::string fact(const std::string &term, const std::string &html) {
        return "<dt>" + term + "</dt><dd>" + html + "</dd>\n";
    }

    std::string in_numbers(std::size_t with_grade, std::size_t missing) const {
        const std::size_t all = graded.students.size();
        std::string words = fmt::format("{} handed in, from {}", all, name_of(graded.platform));
        if (missing > 0) words += fmt::format("; {} didn't", missing);
        if (with_grade < all) words += fmt::format("; <span class=\"bad\">{} without a grade</span>", all - with_grade);
        return words;
    }

    std::string heading_of_tests(const std::string &number) const {
        std::string html = "<tr><th scope=\"rowgroup\" colspan=\"3\">" + as_html(number + ' ' + function(number));
        if (const MostCommon most = commonest_mistake(graded, number); most.times > 0)
            html += fmt::format("<p class=\"dim\">Most common mistake, {}: “{}”</p>", times(most.times),
                                as_html(most.words));
        return html + "</th></tr>\n";
    }

    std::string function(const std::string &number) const {
        for (const Graded &student : graded.students)
            for (const GradedExercise &exercise : student.exercises)
                if (exercise.exercise.number == number) return exercise.exercise.function;
        return "";
    }

    static std::string row(const TestOfClass &test) {
        const std::size_t percent = test.judged == 0 ? 0 : (100 * test.passed + test.judged / 2) / test.judged;
        std::string marks;
        if (test.is_void) marks += tag("doesn't count");
        if (test.judged > 0 && test.answered == 0) marks += tag("nobody has an answer yet");
        else if (test.answered > 0 && test.passed == 0) marks += tag("nobody passes: is it broken?", "bad");
        else if (test.judged > 0 && test.passed == test.judged) marks += tag("everybody passes: it tells you nothing");
        return fmt::format("<tr><td>{} {}</td><td><span class=\"bar\" aria-hidden=\"true\"><span style=\"width:{}%\">"
                           "</span></span>{} of {}</td><td>{}</td></tr>\n",
                           as_html(test.test.claim), marks, percent, test.passed, test.judged, often(test.failure));
    }

    static std::string often(const MostCommon &failure) {
        return failure.times == 0 ? "" : with_capital(times(failure.times)) + ": " + as_html(failure.words);
    }

    std::string group_of(const Alike &group) const {
        std::string who;
        for (const std::string &id : group.ids) who += (who.empty() ? "" : ", ") + people.link(id);
        std::string html = fmt::format("<div class=\"group\">\n<h3>{} {}: {} fail {} alike</h3>\n<p>{}</p>\n",
                                       as_html(group.exercise.number), as_html(group.exercise.function),
                                       pluralize(group.ids.size(), "student"), pluralize(group.failed, "test"), who);
        if (!group.mistake.empty()) html += "<p>A common mistake: “" + as_html(group.mistake) + "”</p>\n";
        if (group.is_same_file) html += "<p>Their files are the same, byte for byte.</p>\n";
        return html
               + fold("What comes out", "<p>✗ " + as_html(group.verdict.test) + "</p>\n"
                                            + picture_of(group.verdict).value_or("")
                                            + preformatted(explain(group.verdict, 0)))
               + "</div>\n";
    }

    const GradedClass &graded;
    People people;
    const std::vector<TestOfClass> tests = how_tests_went(graded);
    std::vector<std::string> exercises; // by number
};

} // namespace
} // namespace course::report

namespace course {

std::string report_page(const GradedClass &graded, const std::map<std::string, std::string> &names,
                        const std::vector<std::string> &missing, const std::vector<Change> &changes) {
    const report::Page page{graded, names};
    const std::vector<report::Part> parts{
        {"trouble", "The grader's own trouble", page.our_troubles(), "ours"},
        {"changes", "Changed since last time", page.changed(changes)},
        {"undelivered", "Feedback that doesn't arrive", page.undelivered()},
        {"class", "The class", page.all_students()},
        {"missing", "Handed in nothing", page.list(missing)},
        {"tests", "Test by test", page.all_tests()},
        {"began", "Began with the file of other tests", page.began_with_others()},
        {"alike", "Equal wrong answers", page.alike()},
        {"others", "Files that weren't taken", page.not_taken()},
    };
    std::string links, html;
    for (const report::Part &part : parts) {
        if (part.html.empty()) continue;
        links += fmt::format("<a href=\"#{}\">{}</a>\n", part.id, part.title);
        html += fmt::format("<section id=\"{}\" class=\"{}\">\n<h2>{}</h2>\n{}</section>\n", part.id, part.kind,
                            part.title, part.html);
    }
    // Nothing on it may run or be fetched, even if a name or a value ever got through as a tag.
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>"
           + page.title() + "</title>\n<style>" + std::string{report_style} + style_of_pictures()
           + "</style>\n</head>\n<body>\n<main>\n" + page.head(missing.size()) + "<nav aria-label=\"On this page\">\n"
           + links + "</nav>\n" + html + "</main>\n</body>\n</html>\n";
}

} // namespace course
