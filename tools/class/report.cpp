#include "class/report.hpp"

#include "class/report_html.hpp"
#include "class/report_students.hpp"
#include "class/report_style.hpp"
#include "class/statistics.hpp"

namespace course::report {
namespace {

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
        facts += fact("Points", spread) + fact("Course", shown(graded.version))
                 + fact("Hash of the tests", "<code>" + shown(graded.tests_hash) + "</code>");
        std::string voids;
        for (const std::string &claim : graded.void_tests) voids += "<li>" + shown(claim) + "</li>\n";
        if (!voids.empty()) facts += fact("Tests that don't count", "<ul>\n" + voids + "</ul>");
        return fmt::format("<h1>{}</h1>\n<p class=\"lead\">{}</p>\n<dl class=\"facts\">\n{}</dl>\n", title(),
                           "How the class did, for its instructor alone.", facts);
    }

    std::string title() const {
        std::string words = graded.section.slug();
        std::ranges::replace(words, '_', ' ');
        return shown("Section " + graded.section.short_number() + ", " + words);
    }

    std::string our_troubles() const {
        std::string all;
        for (const Graded &student : graded.students)
            if (!student.our_trouble.empty())
                all += "<li>" + people.link(student.submission.id) + ": " + shown(student.our_trouble) + "</li>\n";
        if (all.empty()) return "";
        return "<p>These have no verdict that counts, and it's not their fault. Mend what's said here, then type your "
               "<code>./course grade</code> once more, with the same <code>--out …</code> and with "
               "<code>--again</code>.</p>\n<ul>\n"
               + all + "</ul>\n";
    }

    std::string changed(const std::vector<Change> &changes) const {
        std::string rows;
        for (const Change &change : changes)
            rows +=
                fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            people.link(change.id), shown(change.before), shown(change.after), shown(change.because));
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
        std::string all;
        for (const Graded &student : graded.students)
            if (const auto &began = student.began_with)
                all += "<li>" + people.link(student.submission.id) + ": " + shown(words_for(*began)) + "</li>\n";
        if (all.empty()) return "";
        return "<p>Their files were handed out with other tests than judged them here. They may have taken an update "
               "since: <code>./course check -v</code> says which tests they have now.</p>\n<ul>\n"
               + all + "</ul>\n";
    }

    std::string not_taken() const {
        std::string all;
        for (const Graded &student : graded.students) {
            std::string files;
            for (const std::string &file : student.submission.others)
                files += (files.empty() ? "" : "; ") + shown(file);
            if (!files.empty()) all += "<li>" + people.link(student.submission.id) + ": " + files + "</li>\n";
        }
        return all.empty() ? "" : "<ul>\n" + all + "</ul>\n";
    }

  private:
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
        std::string html = "<tr><th scope=\"rowgroup\" colspan=\"3\">" + shown(number + ' ' + function(number));
        if (const MostCommon most = commonest_mistake(graded, number); most.times > 0)
            html +=
                fmt::format("<p class=\"dim\">Most common mistake, {}: “{}”</p>", times(most.times), shown(most.words));
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
                           shown(test.test.claim), marks, percent, test.passed, test.judged, often(test.failure));
    }

    static std::string often(const MostCommon &failure) {
        return failure.times == 0 ? "" : with_capital(times(failure.times)) + ": " + shown(failure.words);
    }

    std::string group_of(const Alike &group) const {
        std::string who;
        for (const std::string &id : group.ids) who += (who.empty() ? "" : ", ") + people.link(id);
        std::string html = fmt::format("<div class=\"group\">\n<h3>{} {}: {} fail {} alike</h3>\n<p>{}</p>\n",
                                       shown(group.exercise.number), shown(group.exercise.function),
                                       counted(group.ids.size(), "student"), counted(group.failed, "test"), who);
        if (!group.mistake.empty()) html += "<p>A common mistake: “" + shown(group.mistake) + "”</p>\n";
        if (group.is_same_file) html += "<p>Their files are the same, byte for byte.</p>\n";
        return html
               + fold("What comes out",
                      "<p>✗ " + shown(group.verdict.test) + "</p>\n" + preformatted(explain(group.verdict, 0)))
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
           + page.title() + "</title>\n<style>" + std::string{report_style} + "</style>\n</head>\n<body>\n<main>\n"
           + page.head(missing.size()) + "<nav aria-label=\"On this page\">\n" + links + "</nav>\n" + html
           + "</main>\n</body>\n</html>\n";
}

} // namespace course
