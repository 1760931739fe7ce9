// The instructor's file of grades: what's read of it, and that it comes back byte for byte but for grades. tests/class
// has files as Canvas and Moodle export them, each with its filled one beside it.

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "grade/gradebook.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>
#include <random>
#include <set>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using namespace course;
namespace fs = std::filesystem;

namespace {

const Section planes{"05_inclined_planes"};
using Grades = std::map<std::string, Entered>;

fs::path exported(const std::string &name) { return fs::path{COURSE_ROOT} / "tests" / "class" / (name + ".csv"); }

/// A file of grades with this text.
struct GradeFile {
    explicit GradeFile(const std::string &text) { write_file(file, text); }
    Gradebook book(const std::string &column = "", const Section &section = planes) const {
        return Gradebook{file, section, column};
    }
    OwnFolder own;
    fs::path file = own.path / "grades.csv";
};

std::string complaint_about(const std::string &text, const std::string &column = "", const Section &section = planes) {
    try {
        GradeFile{text}.book(column, section);
    } catch (const UserError &complaint) {
        return complaint.what();
    }
    return "none";
}

/// Canvas' gradebook with these titles, each worth 10 points, and one student.
std::string canvas_with(const std::vector<std::string> &titles) {
    std::string header = "Student,ID,SIS Login ID,Section", points = "    Points Possible,,,",
                student = "Baker,1003,ab,A";
    for (const std::string &title : titles) {
        header += ',' + title;
        points += ",10";
        student += ',';
    }
    return header + '\n' + points + '\n' + student + '\n';
}

std::string column_chosen(const std::vector<std::string> &titles, const std::string &column = "",
                          const Section &section = planes) {
    return GradeFile{canvas_with(titles)}.book(column, section).column();
}

const std::string moodle_header = "Identifier,Full name,Grade,Maximum Grade,Last modified (grade),Feedback comments\n";

std::string changed(std::string text, const std::string &old, const std::string &with) {
    REQUIRE(contains(text, old));
    replace_all(text, old, with);
    return text;
}

} // namespace

TEST_CASE("Canvas' gradebook comes back with people and the assignment, byte for byte but for the grades",
          "[gradebook]") {
    const Gradebook book{exported("canvas"), planes, ""};
    CHECK(book.platform() == Platform::canvas);
    CHECK(book.column() == "HW 5 (4711)");
    CHECK(book.most() == 10);
    REQUIRE(book.rows().size() == 6);
    CHECK(book.rows()[0].name == "Baker, Anna");
    CHECK(book.rows()[1].locked == "is excused (EX)");
    CHECK(book.rows()[2].was == "9.00");
    CHECK(book.rows()[3].locked == "isn't assigned this (N/A)");
    CHECK(book.rows()[5].id == "1099");
    CHECK(book.filled({{"1003", {0.75, "a comment"}},
                       {"1004", {1, ""}}, // excused
                       {"1005", {2.5 / 3, ""}},
                       {"1012", {1, ""}},   // not assigned
                       {"1013", {0.6, ""}}, // 6.00 already
                       {"1099", {0, ""}},
                       {"2000", {1, ""}}})
          == read_file(exported("canvas_filled")));
}

TEST_CASE("a gradebook with semicolons, a byte-order mark and decimal commas gets decimal commas", "[gradebook]") {
    const Gradebook book{exported("canvas_semicolons"), planes, ""};
    CHECK(book.column() == "Section 5: Inclined planes (82)");
    CHECK(book.most() == 7.5);
    CHECK(book.rows()[2].name == "Fischer; Jörg");
    CHECK(book.filled({{"1003", {1, ""}}, {"1005", {0.5, ""}}, {"1013", {0.01 / 1.5, ""}}})
          == read_file(exported("canvas_semicolons_filled")));
}

TEST_CASE("a gradebook with last and first names is filled", "[gradebook]") {
    const Gradebook book{exported("canvas_names"), planes, ""};
    CHECK(book.column() == "Inclined planes (4711)");
    CHECK(book.rows()[2].name == "van Dijk, Jr., Maria");
    CHECK(book.filled({{"1003", {1, ""}}, {"1004", {1 / 3., ""}}}) == read_file(exported("canvas_names_filled")));
}

TEST_CASE("a column is warned of that Canvas won't import, or that doesn't hold numbers", "[gradebook]") {
    const auto warned = [](const std::string &text) {
        const Gradebook book = GradeFile{text}.book();
        std::string all;
        for (const std::string &each : book.warnings()) all += each + '\n';
        return all;
    };
    const std::string canvas = canvas_with({"HW 5 (1)"});
    CHECK(warned(canvas).empty());
    for (const char *fine : {"7.50", "\"7,5\"", "EX", "N/A", "-", " "})
        CHECK(warned(changed(canvas, "ab,A,", std::string{"ab,A,"} + fine)).empty());
    CHECK(warned(canvas_with({"Current grade and final score 5 (1)"})).empty()); // Canvas goes by capitals
    CHECK(warned(canvas_with({"Final Score exam 5 (4711)"}))
          == "Canvas won't import `Final Score exam 5 (4711)`, since it passes over titles with `Final Score` in them. "
             "Rename the assignment there, and export again.\n");
    for (const char *other : {"complete", "A-", "85%"})
        CHECK(warned(changed(canvas, "ab,A,", std::string{"ab,A,"} + other))
              == std::string{"1003 has `"} + other
                     + "`, and Canvas may drop numbers there. Set the assignment's Display Grade as to Points, and "
                       "export again.\n");
}

TEST_CASE("Moodle's worksheet gets grades and comments, and none that a spreadsheet would run", "[gradebook]") {
    const Gradebook book{exported("moodle"), planes, ""};
    CHECK(book.platform() == Platform::moodle);
    CHECK(book.column() == "Grade");
    CHECK(book.rows()[0].id == "1003");
    CHECK(book.rows()[3].locked == "can't be changed in Moodle");
    CHECK(book.filled({{"1003", {0.75, "7.5 of 10. 5.3: look at \"slides\", a < b."}},
                       {"1005", {1, "10 of 10."}},
                       {"1012", {1, "10 of 10."}}, // locked
                       {"1013", {0.6, "=1+1"}}})
          == read_file(exported("moodle_filled")));
    CHECK_THAT(book.filled({{"1005", {0.5, ""}}}), ContainsSubstring("<p>A \"\"good\"\" one"));
    for (const std::string formula : {"=1+1", "+1", "-1", "@SUM(A1)", " =1", "\t=1"})
        CHECK_THAT(book.filled({{"1013", {0.6, formula}}}), ContainsSubstring(",'"));
}

TEST_CASE("Moodle's worksheet with groups, a marking workflow and decimal commas is filled", "[gradebook]") {
    const Gradebook book{exported("moodle_groups"), planes, ""};
    CHECK(book.most() == 7.5);
    CHECK(book.filled({{"1003", {2 / 3., ""}}, {"1004", {0.5, "half of it"}}, {"1005", {0.01 / 1.5, ""}}})
          == read_file(exported("moodle_groups_filled")));
    CHECK_THAT(book.filled({{"1003", {1, ""}}}), ContainsSubstring("\"Iris Berg\",\"7,5\",\"7,50\""));
}

TEST_CASE("a gradebook without grades comes back as it was", "[gradebook]") {
    for (const std::string name : {"sixty_canvas", "moodle", "moodle_groups"})
        CHECK(Gradebook(exported(name), planes, "").filled({}) == read_file(exported(name)));
}

TEST_CASE("of any gradebook and any grades, nothing but the chosen cells changes, and nothing else comes back",
          "[gradebook]") {
    std::mt19937 dice{5};
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>{0, n - 1}(dice); };
    const auto one_of = [&](const std::vector<std::string> &all) { return all[below(all.size())]; };
    const std::vector<std::string> awkward{"",      "Baker", "\"Baker, Anna\"", "\"a \"\"b\"\"\"",  " x ",
                                           "other", "\"\"",  "\"two\nlines\"",  "\"c;d\r\n,\"\"\"", "'",
                                           "EX",    "-"};
    for (int file = 0; file < 200; ++file) {
        const std::string separator = one_of({",", ";"}), end = one_of({"\n", "\r\n"}),
                          mark = one_of({"", "\xEF\xBB\xBF"});
        const auto cell = [&] {
            std::string any = one_of(awkward);
            if (any == "other") any = separator == "," ? "Jörg;" : "Jörg,"; // which needs no quotes
            return any;
        };
        const std::size_t before = below(4), behind = below(4), students = below(6);
        const auto row = [&](const std::string &first, const std::string &id, const std::string &grade, auto other) {
            std::string head = first + separator + id, tail;
            for (std::size_t i = 0; i < before; ++i) head += separator + other();
            for (std::size_t i = 0; i < behind; ++i) tail += separator + other();
            return std::array{first + separator + id, head + separator + grade + tail + end};
        };
        std::string text = mark, want = mark;
        const auto put = [&](const std::array<std::string, 2> &parts, const std::string &now) {
            text += parts[1];
            want += parts[0] + separator + now + end;
        };
        put(row("Student", "ID", "HW (1)", cell), "HW (1)");
        put(row("    Points Possible", "", "10.00", [] { return "(read only)"; }), "10.00");
        Grades grades;
        std::set<std::string> chosen, differ;
        for (std::size_t i = 0; i < students; ++i) {
            const std::string id = std::to_string(1000 + i), was = one_of({"", "3.50", "\"3.50\"", "EX", "late"});
            const std::size_t hundredths = below(1001);
            std::string now = was;
            if (below(2) == 0) {
                grades[id] = {static_cast<double>(hundredths) / 1000, "no column has it"};
                const std::string tenths =
                    hundredths % 100 == 0 ? "" : std::to_string(hundredths % 100 + 100).substr(1);
                now = std::to_string(hundredths / 100) + (tenths.empty() ? "" : '.' + tenths);
                if (!tenths.empty() && now.back() == '0') now.pop_back();
                if (was.starts_with('"')) now = '"' + now + '"';
                if (was == "EX" || hundredths == 350) now = was;
            }
            put(row(cell(), id, was, cell), now);
            if (now != was) differ.insert(id);
        }
        const GradeFile given{text};
        const std::string filled = given.book().filled(grades);
        REQUIRE(filled == want);
        const GradeFile again{filled};
        const std::vector<Person> old = given.book().rows(), now = again.book().rows();
        REQUIRE(now.size() == students);
        for (std::size_t i = 0; i < students; ++i) REQUIRE((old[i].was != now[i].was) == differ.contains(now[i].id));
    }
}

TEST_CASE("a grade has at most two decimals, and half a hundredth goes up", "[gradebook]") {
    const GradeFile of_ten{canvas_with({"HW 5 (1)"})}, of_one{changed(canvas_with({"HW 5 (1)"}), ",10", ",1")};
    const Gradebook ten = of_ten.book(), one = of_one.book();
    CHECK(ten.grade(0) == "0");
    CHECK(ten.grade(1) == "10");
    CHECK(ten.grade(0.75) == "7.5");
    CHECK(ten.grade(0.105) == "1.05");
    CHECK(ten.grade(1 / 3.) == "3.33");
    CHECK(ten.grade(2 / 3.) == "6.67");
    CHECK(ten.grade(0.2855) == "2.86"); // 2.8549999999999995 as doubles multiply
    CHECK(ten.grade(0.28549) == "2.85");
    CHECK(ten.grade(0.9999) == "10");
    CHECK(one.grade(0.285) == "0.29"); // 28.499999999999996 hundredths
    CHECK(one.grade(0.005) == "0.01");
    CHECK(one.grade(0.004) == "0");
    for (int n = 1; n <= 200; ++n) // all halves there are among 200 points
        for (int earned = 0; earned <= n; ++earned) {
            const int half_up = (2000 * earned + n) / (2 * n); // hundredths of ten points, half up, in integers
            CAPTURE(earned, n);
            REQUIRE(std::lround(std::stod(ten.grade(static_cast<double>(earned) / n)) * 100) == half_up);
        }
    for (const double nonsense : {-0.1, 1.01, std::nan("")})
        CHECK_THROWS_AS(ten.grade(nonsense), std::invalid_argument);
}

TEST_CASE("the column that must be meant is the only one, or the only one that names the section", "[gradebook]") {
    CHECK(column_chosen({"Anything (1)"}) == "Anything (1)");
    for (const std::string title :
         {"05_inclined_planes", "Inclined planes", "HW 5", "hw05", "Section 5", "Exercise 5", "5", "5 Inclined planes",
          "5. inclined_planes", "Homework 5: Inclined Planes", "05"})
        CHECK(column_chosen({"Final exam (1)", title + " (22)", "HW 4 (5)"}) == title + " (22)");
    for (const std::string title : {"Quiz 5", "HW 15", "HW 50", "HW 5.2", "HW 1-5", "HW 0 5", "Exercise 5 2",
                                    "Inclined planes quiz", "HW 5 late", "4 Inclined planes", "Week 5", "55", "HW"})
        CHECK_THAT(
            complaint_about(canvas_with({"Final exam (1)", title + " (22)"})),
            ContainsSubstring("no column is clearly that of section 5. Say which one, with --column and its title: "
                              "`Final exam (1)`, `"
                              + title + " (22)`."));
    CHECK_THAT(
        complaint_about(canvas_with({"HW 5 (1)", "Section 5 (2)", "HW 6 (3)"})),
        ContainsSubstring("more than one column is clearly that of section 5. Say which one, with --column and its "
                          "title: `HW 5 (1)`, `Section 5 (2)`."));
    const Section motion{"01_motion"}, collisions{"08_nt_collisions"};
    CHECK_THAT(complaint_about(canvas_with({"12 Time-based motion (1)", "Exam (2)"}), "", motion),
               ContainsSubstring("no column"));
    CHECK(column_chosen({"n–t Collisions (1)", "Exam (2)"}, "", collisions) == "n–t Collisions (1)");
}

TEST_CASE("the option --column is a title, or one without its number, or a part of one", "[gradebook]") {
    const std::vector<std::string> titles{"HW 1 (10)", "HW 10 (11)", "HW 11 (12)", "Essay (1)"};
    CHECK(column_chosen(titles, "HW 1") == "HW 1 (10)");
    CHECK(column_chosen(titles, "HW 1 (10)") == "HW 1 (10)");
    CHECK(column_chosen(titles, "essay") == "Essay (1)");
    CHECK_THAT(complaint_about(canvas_with(titles), "hw 1"),
               ContainsSubstring("more than one column is what `hw 1` means")
                   && ContainsSubstring("`HW 1 (10)`, `HW 10 (11)`, `HW 11 (12)`."));
    CHECK_THAT(complaint_about(canvas_with(titles), "Quiz"),
               ContainsSubstring("no column is what `Quiz` means") && ContainsSubstring("`Essay (1)`."));
    for (const std::string column : {"Final Score", "Section", "Midterm (2)"}) { // read only, or no assignment
        const std::string text = "Student,ID,Section,HW 5 (1),Midterm (2),Final Score\n"
                                 "Points Possible,,,10,(read only),(read only)\n";
        CHECK_THAT(complaint_about(text, column), ContainsSubstring("`" + column + "` can't be written to")
                                                      && ContainsSubstring("one of these: `HW 5 (1)`."));
    }
}

TEST_CASE("a file of grades that isn't whole, or isn't one, is turned away with what to do", "[gradebook]") {
    const std::string canvas = canvas_with({"HW 5 (1)"});
    const std::string moodle = moodle_header + "Participant 7,Ann,,10.00,-,\nParticipant 8,Ben,,10.00,-,\n";
    CHECK(complaint_about(canvas) == "none");
    CHECK(complaint_about(moodle) == "none");
    CHECK(complaint_about(moodle + "\n") == "none");
    const auto says = [](const std::string &text, const std::string &words) {
        CHECK_THAT(complaint_about(text), ContainsSubstring(words));
    };
    says("", "is empty");
    says("Name,Points\n", "Its columns are `Name`, `Points`.");
    says(changed(moodle, "Last modified (grade)", "Zuletzt geändert (Bewertung)"), "Set Moodle's language to English");
    says(changed(moodle, "Participant 8", "Teilnehmer/in 8"), "line 3: the Identifier is `Teilnehmer/in 8`");
    says(changed(moodle, "Ben,,10.00", "Ben,,12.00"), "line 3: the Maximum Grade is `12.00`, but 10 above.");
    says(changed(moodle, "10.00", "Excellent"), "no scale");
    says(changed(moodle, "10.00", "\"1,000\""), "should be a number above 0 and below 1000000, and is `1,000`.");
    says(changed(moodle, "Participant 8", "Participant 7"), "line 3: 7 is there twice.");
    says(changed(moodle, "Ben,", "Ben,x,"), "line 3: 7 cells instead of 6.");
    says(changed(moodle, "Ben,,10.00", "Ben,\"7,5\",10.00"),
         "line 3: `7,5` has its decimals behind a `,`, and numbers above behind a `.`.");
    says(canvas + canvas.substr(canvas.find("Baker")), "line 4: 1003 is there twice.");
    says(changed(canvas, "1003", "1E+13"), "line 3: the ID is `1E+13`, and should be a number.");
    says(changed(canvas, "Points Possible", "x"), "no row `Points Possible`");
    says(changed(canvas, ",10\n", ",20,00\n"), "line 2: 6 cells instead of 5. Download the file again."); // 20,00
    says(changed(canvas, ",10\n", ",\"1,000.00\"\n"), "and is `1,000.00`. Give the assignment points");
    says(changed(canvas, ",10\n", ",100000000000000000000\n"), "and below 1000000, and is `100000000000000000000`.");
    says(changed(canvas, ",10", ",0"),
         "line 2: the Points Possible of `HW 5 (1)` should be a number above 0 and below 1000000, and is `0`.");
    says(changed(canvas, "ab,A", "ab,A,x"), "line 3: 6 cells instead of 5.");
    says(changed(canvas, "Baker", "\"Baker"), "line 3: a quote opens here and never closes.");
    says(changed(canvas, "Baker", "\"Baker\" x"), "line 3: there's something behind a closing quote.");
    says(changed(canvas, "Baker", "Ba\"ker"), "line 3: there's a quote in the middle of a cell.");
    says(changed(canvas, "Baker", "J\xF6rg"),
         "line 3, isn't UTF-8. Download it again, or save it as CSV with the encoding UTF-8.");
    says("\xFF\xFE" + canvas, "is UTF-16");
    says(std::string{"S\0t\0", 4}, "is UTF-16");
    CHECK_THROWS_MATCHES(GradeFile{moodle}.book("HW 5"), UserError,
                         MessageMatches(ContainsSubstring("leave out --column")));
    const std::string classroom =
        "github_username,student_repository_name,points_awarded,points_available\nann,w-ann,,13\n";
    CHECK(GradeFile{classroom}.book().rows().front().name == "ann"); // where there's no roster
    for (const char *points : {",0", ",99", ","})                    // which a student's own workflow writes
        CHECK(GradeFile{changed(classroom, ",13", points)}.book().most() == 0);
    Gradebook book = GradeFile{classroom + "bo,w-ann,,13\n"}.book();
    book.take_most(13);
    CHECK(book.filled({{"w-ann", {1, ""}}})
          == "github_username,student_repository_name,points_awarded,points_available\nann,w-ann,13,13\nbo,w-ann,13,"
             "13\n");
    CHECK_THROWS_MATCHES(GradeFile{classroom}.book("points"), UserError,
                         MessageMatches(ContainsSubstring("is from GitHub Classroom, where grades go to the column "
                                                          "`points_awarded`: leave out --column")));
    CHECK_THAT(complaint_about("Student,ID,HW 5 (1),HW 6 (2)\nPoints Possible,,,10\nBaker,1003,,\n"),
               ContainsSubstring("Points Possible of `HW 5 (1)`")); // and HW 6 isn't taken for the only one
}
