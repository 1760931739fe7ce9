// The instructor's report: what it says of a class made by hand, and that nothing anybody chose becomes a tag. The page
// is read as XML, so each of its tags is closed.

#include "grade/report.hpp"

#include "base/files.hpp"
#include "base/text.hpp"
#include "grade/report_style.hpp"
#include "grade/statistics.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <catch2/matchers/catch_matchers_vector.hpp>
#include <pugixml.hpp>

using namespace course;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Equals;

namespace {

const std::string stops = "at 6 m/s, losing 2 m/s each second, a puck stops after 9 m",
                  to_the_left = "at -6 m/s, to the left, it stops after -9 m",
                  refuses = "rejects a deceleration that isn't positive",
                  slows = "friction of 3 N slows 2 kg down by 1.5 m/s each second",
                  never_back = "friction never pushes a crate back", rests = "a crate at rest stays at rest",
                  normal = "a 10 kg box pushes with 98.1 N on a level floor";

Verdict report_pass(const std::string &test) { return {.test = test}; }
Verdict report_todo(const std::string &test) {
    return {.test = test, .kind = Outcome::not_started, .sentence = "Nothing's here yet."};
}
Verdict report_wrong(const std::string &test, const std::string &yours, const std::string &expected) {
    return {.test = test,
            .kind = Outcome::wrong,
            .call = Call{"stopping_distance", {"speed = 6", "deceleration = 2"}, 0, yours},
            .yours = yours,
            .expected = expected,
            .tolerance = "1e-12",
            .file = "tests/05_inclined_planes/tests.cpp",
            .line = 31};
}

GradedExercise report_graded(const std::string &number, const std::string &function, double possible,
                             std::vector<Verdict> verdicts, std::size_t baseline = 0) {
    GradedExercise one;
    one.exercise = {number, "core", function};
    one.possible = possible;
    one.baseline = baseline;
    for (const Verdict &verdict : verdicts) {
        if (verdict.test == rests) continue; // it doesn't count
        ++one.counted;
        if (verdict.passed()) ++one.passed;
    }
    one.earned = one.possible * static_cast<double>(one.passed) / static_cast<double>(one.counted);
    one.verdicts = std::move(verdicts);
    return one;
}

GradedExercise report_stop(const std::string &first = "", const std::string &second = "") {
    return report_graded("5.1", "stopping_distance", 3,
                         {first.empty() ? report_pass(stops) : report_wrong(stops, first, "9"),
                          second.empty() ? report_pass(to_the_left) : report_wrong(to_the_left, second, "-9"),
                          report_pass(refuses)},
                         1);
}
GradedExercise report_friction(const std::string &first = "", bool last = true) {
    return report_graded("5.2", "apply_friction", 6,
                         {first.empty() ? report_pass(slows) : report_wrong(slows, first, "1.5"),
                          report_pass(never_back), last ? report_pass(rests) : report_wrong(rests, "0.1", "0")});
}
GradedExercise report_normal() { return report_graded("5.3", "normal_force", 1, {report_todo(normal)}); }

Graded report_student(const std::string &id, std::vector<GradedExercise> exercises) {
    Graded student;
    student.submission.id = id;
    student.submission.taken = "05_inclined_planes.cpp";
    student.exercises = std::move(exercises);
    student.file_hash = std::string(64, 'a') + id;
    return student;
}

/// Ten students, each for something else that a report says.
GradedClass report_class() {
    GradedClass all;
    all.section = {"05_inclined_planes"};
    all.platform = Platform::canvas;
    all.version = "1.4.0";
    all.tests_hash = std::string(64, 'f');
    all.void_tests = {rests};
    for (const std::string &claim : {stops, to_the_left, refuses}) all.tests.push_back({"5.1", claim});
    for (const std::string &claim : {slows, never_back, rests}) all.tests.push_back({"5.2", claim});
    all.tests.push_back({"5.3", normal});

    all.students.push_back(report_student("1001", {report_stop(), report_friction(), report_normal()})); // all but 5.3
    for (const char *id : {"1002", "1003", "1004"}) { // the same mistake, with a name
        all.students.push_back(report_student(id, {report_stop("18", "-18"), report_friction(), report_normal()}));
        all.students.back().exercises[0].mistake = "you forget to halve.";
    }
    for (const char *id : {"1005", "1006"}) // the same mistake, without one; in a test that doesn't count, another
        all.students.push_back(
            report_student(id, {report_stop(), report_friction("3.25", id == std::string{"1006"}), report_normal()}));
    all.students.back().file_hash = all.students[4].file_hash;
    all.students.back().submission.late = true;

    all.students.push_back(report_student("1007", {report_stop("0", "0"), report_friction("0"), report_normal()}));
    GradedExercise &unbuilt = all.students.back().exercises[1];
    unbuilt.unbuilt = Verdict{.kind = Outcome::does_not_compile, .sentence = "There's a semicolon missing in line 12."};
    unbuilt.passed = 0;
    unbuilt.earned = 0;
    all.students.back().overridden = 6.5;
    all.students.back().why = "shown to me <b>at the desk</b>";

    all.students.push_back(report_student("1008", {report_stop("0", "0"), report_friction("2.75"), report_normal()}));
    all.students.back().exercises[1].consequence_of = "5.1";

    all.students.push_back(report_student("1009", {}));
    all.students.back().submission.taken = "";
    all.students.back().submission.trouble = "You handed in a zip archive, and we need your file itself.";
    all.students.back().submission.others = {"all.zip", "</li><script>alert(1)</script>"};

    all.students.push_back(report_student("1010", {}));
    all.students.back().our_trouble = "The sandbox didn't start: the kernel has no Landlock.";
    return all;
}

const std::map<std::string, std::string> report_names{{"1001", "Ada Lovelace"}, {"2001", "Émilie du Châtelet"}};

/// A page as it is read; it must be well-formed.
struct ReportPage {
    explicit ReportPage(const GradedClass &graded, const std::map<std::string, std::string> &names = report_names,
                        const std::vector<std::string> &missing = {}, const std::vector<Change> &changes = {})
        : text{report_page(graded, names, missing, changes)} {
        const pugi::xml_parse_result read = document.load_string(text.c_str());
        INFO(read.description() << " at " << text.substr(static_cast<std::size_t>(read.offset), 200));
        REQUIRE(read);
    }
    pugi::xml_node node(const std::string &path) const { return document.select_node(path.c_str()).node(); }
    std::size_t count(const std::string &path) const { return document.select_nodes(path.c_str()).size(); }
    /// All that is written in a node and below it, blanks as they come.
    static std::string words(pugi::xml_node node) {
        std::string all;
        for (const auto &found : node.select_nodes(".//text()")) all += found.node().value();
        return all;
    }
    std::string words(const std::string &path) const { return words(node(path)); }
    std::string student(const std::string &id) const { return words("//tbody[@id='student-" + id + "']"); }
    /// The signs of a student's exercises.
    std::vector<std::string> signs(const std::string &id) const {
        std::vector<std::string> all;
        for (const auto &found :
             document.select_nodes(("//tbody[@id='student-" + id + "']/tr[1]/td/span[@aria-hidden='true']").c_str()))
            all.emplace_back(found.node().child_value());
        return all;
    }
    std::string test(const std::string &claim) const {
        for (const auto &row : document.select_nodes("//table[@class='tests']//tr[count(td) = 3]"))
            if (words(row.node()).starts_with(claim)) return words(row.node());
        return "";
    }

    std::string text;
    pugi::xml_document document;
};

} // namespace

TEST_CASE("a report says first what the class is about, and what's in the way", "[class-report]") {
    const GradedClass graded = report_class();
    const ReportPage page{graded, report_names, {"2001"}, {{"1002", "5", "6", stops}}};
    CHECK(page.words("//h1") == "Section 5, inclined planes");
    const std::string facts = page.words("//dl");
    CHECK_THAT(facts, ContainsSubstring("10 handed in, from Canvas; 1 didn't; 1 without a grade"));
    CHECK_THAT(facts, ContainsSubstring("10 possible; the median is 6.5, and half of the class is between 6 and 7"));
    CHECK_THAT(facts, ContainsSubstring("1.4.0") && ContainsSubstring(graded.tests_hash) && ContainsSubstring(rests));

    std::vector<std::string> parts;
    for (const auto &part : page.document.select_nodes("//section"))
        parts.emplace_back(part.node().attribute("id").value());
    CHECK_THAT(parts,
               Equals(std::vector<std::string>{"trouble", "changes", "class", "missing", "tests", "alike", "others"}));
    CHECK(page.count("//nav/a") == parts.size());
    CHECK_THAT(facts, !ContainsSubstring("Protection"));
    GradedClass open = graded;
    open.warning = "This kernel lacks Landlock.";
    CHECK_THAT((ReportPage{open}.words("//dl")), ContainsSubstring("This kernel lacks Landlock."));
    CHECK_THAT(page.words("//section[@id='trouble']"), ContainsSubstring("Landlock") && ContainsSubstring("--again"));
    CHECK(page.words("//section[@id='changes']//tbody/tr") == "100256" + stops);
    CHECK(page.words("//section[@id='missing']//li") == "2001 Émilie du Châtelet");
}

TEST_CASE("a report leaves out what there is nothing to say of", "[class-report]") {
    GradedClass graded;
    graded.section = {"05_inclined_planes"};
    CHECK(ReportPage{graded, {}}.count("//section") == 0);
    graded.students.push_back(report_student("1001", {report_stop()}));
    graded.tests = {{"5.1", stops}};
    const ReportPage page{graded, {}};
    CHECK(page.count("//section") == 2); // the class, and its test
    CHECK(page.count("//table[@class='students']//th[text() = 'Name']") == 0);
    CHECK(page.count("//tbody[@class='whole']") == 1);
    CHECK(page.count("//tbody//details") == 0);
}

TEST_CASE("a report has a row for each student", "[class-report]") {
    const ReportPage page{report_class()};
    CHECK(page.count("//tbody[starts-with(@id, 'student-')]") == 10);
    CHECK(page.count("//tbody[@class='whole']") == 0);

    CHECK_THAT(page.signs("1001"), Equals(std::vector<std::string>{"✓", "✓", "·"}));
    CHECK_THAT(page.student("1001"), ContainsSubstring("Ada Lovelace") && !ContainsSubstring("Nothing's here yet"));
    CHECK(page.count("//tbody[@id='student-1001']//details") == 0);
    CHECK_THAT(page.signs("1002"), Equals(std::vector<std::string>{"1/3", "✓", "·"}));
    CHECK_THAT(page.student("1002"),
               ContainsSubstring("1 of 3 tests, 1 of 3 points. An answer that computes nothing passes 1.")
                   && ContainsSubstring("A known mistake: “you forget to halve.”")
                   && ContainsSubstring("yours     18"));
    CHECK_THAT(page.student("1006"), ContainsSubstring("late") && ContainsSubstring("5.2: " + slows));
    CHECK_THAT(page.signs("1007"), Equals(std::vector<std::string>{"1/3", "✗", "·"}));
    CHECK_THAT(page.student("1007"), ContainsSubstring("6.5") && ContainsSubstring("set by you")
                                         && ContainsSubstring("shown to me <b>at the desk</b>")
                                         && ContainsSubstring("a semicolon missing in line 12"));
    CHECK_THAT(page.signs("1008"), Equals(std::vector<std::string>{"1/3", "↳1/2", "·"}));
    CHECK_THAT(page.student("1008"), ContainsSubstring("it calls 5.1, and that isn't"));
    CHECK_THAT(page.student("1009"), ContainsSubstring("No file to judge: “You handed in a zip archive"));
    CHECK_THAT(page.student("1010"), ContainsSubstring("no grade") && ContainsSubstring("Our trouble: The sandbox"));
    for (const auto &link : page.document.select_nodes("//a[starts-with(@href, '#')]"))
        CHECK(page.count("//*[@id='" + std::string{link.node().attribute("href").value()}.substr(1) + "']") == 1);
}

TEST_CASE("an exercise is started when more of its tests pass than need an answer", "[class-report]") {
    GradedClass graded = report_class();
    graded.students = {report_student(
        "of 3", {report_graded("5.1", "stopping_distance", 3, {report_pass(stops), report_todo(to_the_left)}, 0),
                 report_graded("5.2", "apply_friction", 3, {report_pass(slows), report_todo(never_back)}, 1)})};
    const ReportPage page{graded};
    CHECK_THAT(page.signs("of_3"), Equals(std::vector<std::string>{"1/2", "·"}));
    CHECK(page.count("//a[@href='#student-of_3']") == 1);
    CHECK_THAT(page.student("of_3"), ContainsSubstring("5.1: " + to_the_left) && ContainsSubstring("Nothing's here yet")
                                         && ContainsSubstring("Not started: 5.2 apply_friction"));
}

TEST_CASE("a report says how each test went, and which tell nothing", "[class-report]") {
    const ReportPage page{report_class()};
    CHECK_THAT(page.test(stops), ContainsSubstring("3 of 8") && ContainsSubstring("3 times: 18 instead of 9"));
    CHECK_THAT(page.test(refuses), ContainsSubstring("8 of 8") && ContainsSubstring("everybody passes"));
    CHECK_THAT(page.test(slows), ContainsSubstring("4 of 8") && ContainsSubstring("Twice: 3.25 instead of 1.5"));
    CHECK_THAT(page.test(rests), ContainsSubstring("doesn't count") && ContainsSubstring("Once: 0.1 instead of 0"));
    CHECK_THAT(page.test(normal), ContainsSubstring("0 of 8") && ContainsSubstring("nobody has an answer yet"));
    CHECK_THAT(page.words("//table[@class='tests']//th[@colspan]"),
               ContainsSubstring("5.1 stopping_distance") && ContainsSubstring("3 times: “you forget to halve.”"));
    CHECK(page.count("//span[@class='bar']/span[@style='width:38%']") == 2); // of 5.1, each 3 of 8

    GradedClass broken = report_class();
    for (Graded &student : broken.students)
        for (GradedExercise &exercise : student.exercises)
            for (Verdict &verdict : exercise.verdicts)
                if (verdict.test == never_back) verdict.kind = Outcome::wrong;
    CHECK_THAT(ReportPage{broken}.test(never_back), ContainsSubstring("nobody passes: is it broken?"));
}

TEST_CASE("equal wrong answers are those whose values say something", "[class-report]") {
    const std::vector<Alike> groups = equal_wrong_answers(report_class());
    REQUIRE(groups.size() == 2); // not the zeros of 1007 and 1008
    CHECK_THAT(groups[0].ids, Equals(std::vector<std::string>{"1002", "1003", "1004"}));
    CHECK(groups[0].mistake == "you forget to halve.");
    CHECK(groups[0].failed == 2);
    CHECK_FALSE(groups[0].is_same_file);
    CHECK_THAT(groups[1].ids, Equals(std::vector<std::string>{"1005", "1006"})); // though a void test differs
    CHECK(groups[1].is_same_file);

    const ReportPage page{report_class()};
    CHECK(page.count("//section[@id='alike']/div") == 2);
    CHECK(page.words("//section[@id='alike']/div[1]/p[1]") == "1002, 1003, 1004");
    CHECK_THAT(page.words("//section[@id='alike']/div[1]"), ContainsSubstring("common mistake"));
    CHECK_THAT(page.words("//section[@id='alike']/div[2]"),
               ContainsSubstring("byte for byte") && !ContainsSubstring("common mistake"));
    CHECK_THAT(page.words("//section[@id='alike']/p"), ContainsSubstring("innocent"));

    CHECK(page.count("//svg") == 0); // of numbers without a unit there's nothing to see
    GradedClass drawn = report_class();
    for (Graded &student : drawn.students)
        for (GradedExercise &exercise : student.exercises)
            for (Verdict &verdict : exercise.verdicts)
                if (verdict.call) verdict.call->arguments = {"wall = {start (0, 0) m, end (3, 4) m}"};
    CHECK(ReportPage{drawn}.count("//section[@id='alike']//details/svg") == 2);

    GradedClass other = report_class();
    other.students[5].exercises[1].consequence_of = "5.1";
    CHECK(equal_wrong_answers(other).size() == 1);
}

TEST_CASE("quartiles lie on the line between two students", "[class-report]") {
    CHECK_FALSE(quartiles({}));
    CHECK(quartiles({7})->upper == 7);
    const Quartiles four = *quartiles({4, 1, 3, 2});
    CHECK(four.lower == 1.75);
    CHECK(four.median == 2.5);
    CHECK(four.upper == 3.25);
}

TEST_CASE("nothing that anybody chose becomes a tag of the report, or hides what it says", "[class-report]") {
    const std::string evil = GENERATE(
        as<std::string>{}, "</pre></td></tbody><script>alert(1)</script>", "\" onmouseover=\"alert(1)\" x=\"", "<!-- ",
        "]]><![CDATA[", "&lt;b&gt; &#60;", "=HYPERLINK(\"http://evil.example\")", "\x1b[31mred\x1b[0m\r\b",
        "broken \xff\xc3( \xed\xa0\x80", "abc\u202Edcba\u2066", "a\nb", "\xEF\xBF\xBE", std::string(1, '\0') + "zero");
    CAPTURE(evil);
    GradedClass graded = report_class();
    graded.version = graded.tests_hash = evil;
    graded.void_tests.push_back(evil);
    graded.tests.push_back({evil, evil});
    for (Graded &student : graded.students) {
        student.submission.id += evil;
        student.submission.taken = student.why = student.submission.trouble = student.our_trouble = evil;
        student.submission.others = {evil, evil};
        student.unbuilt = Verdict{.kind = Outcome::does_not_compile, .sentence = evil, .printed = {evil}};
        for (GradedExercise &exercise : student.exercises) {
            exercise.mistake = exercise.exercise.function = evil;
            for (Verdict &verdict : exercise.verdicts) {
                verdict.sentence = verdict.label = verdict.expected = verdict.whole = verdict.since = verdict.file =
                    evil;
                if (verdict.call) verdict.call = Call{evil, {evil}, 1, "1" + evil};
                if (!verdict.yours.empty()) verdict.yours += evil;
                verdict.printed = verdict.accepted = {evil};
            }
        }
    }
    std::map<std::string, std::string> names;
    for (const Graded &student : graded.students) names[student.submission.id] = evil;
    const ReportPage page{graded, names, {evil}, {{graded.students[0].submission.id, evil, evil, evil}}};
    CHECK(page.count("//script | //b | //*[@onmouseover] | //comment()") == 0);
    CHECK(page.count("//section") == 7);
    CHECK(page.count("//tbody[starts-with(@id, 'student-')]") == 10);
    CHECK(page.text.find_first_of(std::string{"\x1b\r\b\xff\0", 5}) == std::string::npos);
    CHECK_FALSE(contains_any(page.text, {"\u202E", "\u2066", "\xed\xa0\x80", "\xEF\xBF\xBE"}));
    if (contains(evil, "alert")) CHECK_THAT(page.words("//section[@id='missing']//li"), ContainsSubstring(evil));
}

TEST_CASE("a report runs nothing, fetches nothing, and looks like the book", "[class-report]") {
    const ReportPage page{report_class()};
    CHECK(page.count("//script | //link | //img | //@src") == 0);
    CHECK_THAT(page.node("//meta[@http-equiv='Content-Security-Policy']").attribute("content").value(),
               ContainsSubstring("default-src 'none'"));
    CHECK_FALSE(contains_any(report_style, {"url(", "@import"}));
    std::string book = read_file(std::filesystem::path{COURSE_ROOT} / "docs/site.css");
    book += read_file(std::filesystem::path{COURSE_ROOT} / "docs/done.css");
    for (const std::string name :
         {"paper", "ink", "dim", "line", "shade", "link", "accent", "good", "text", "code", "plain"}) {
        const auto ours = between(report_style, "--" + name + ": ", ";");
        REQUIRE(ours);
        CAPTURE(name);
        CHECK(contains(book, "--" + name + ": " + std::string{*ours} + ';'));
    }
}
