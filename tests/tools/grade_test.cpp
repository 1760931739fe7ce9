// `course grade`: what a file comes to that is half broken, what it earns, and what comes of a class.

#include "base/kernel.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"
#include "check/build_config.hpp"
#include "check/functions.hpp"
#include "check/junit.hpp"
#include "check/outline.hpp"
#include "grade/archive.hpp"
#include "grade/assignment.hpp"
#include "grade/baseline_answers.hpp"
#include "grade/feedback.hpp"
#include "grade/points.hpp"
#include "grade/process_pool.hpp"
#include "made_zip.hpp"
#include "small_course.hpp"
#include "whole_answer.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <ctime>
#include <unistd.h>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using namespace course;
namespace fs = std::filesystem;

namespace {

/// The course's own section 5, as it's built.
const Workspace &built_course() {
    static const Workspace workspace{.root = COURSE_ROOT, .build = COURSE_BUILD};
    return workspace;
}
Section section_five() { return built_course().section("5"); }
std::string answer_of_ours() { return read_file(built_course().solution(section_five())); }

std::string with(std::string text, const std::string &old, const std::string &instead) {
    REQUIRE(text.find(old) != text.npos);
    return text.replace(text.find(old), old.size(), instead);
}

Outcomes come_out(const std::string &text) {
    return outcomes_of(built_course(), section_five(), "05_inclined_planes.cpp", text, 2026);
}

/// Which exercises fail a test.
std::string that_fail(const Outcomes &outcomes) {
    std::string all;
    for (const Verdict &verdict : outcomes.verdicts)
        if (!verdict.passed() && all.find(verdict.exercise) == all.npos) all += verdict.exercise + ' ';
    return all;
}

constexpr const char *wrong_normal_force = "return mass * g * std::sin(angle);";
constexpr const char *right_normal_force = "return mass * g * std::cos(angle);";

GradedExercise of_tests(std::initializer_list<bool> passed) {
    GradedExercise exercise;
    exercise.possible = 3;
    for (const bool each : passed) {
        Verdict verdict{.test = "test " + std::to_string(exercise.verdicts.size() + 1)};
        verdict.kind = each ? Outcome::passed : Outcome::wrong;
        exercise.verdicts.push_back(verdict);
    }
    return exercise;
}

/// Which tests judged, in a text: they change with every build.
std::string feedback_hash(const std::string &text) {
    return std::string{between(text, "of the course, tests ", "\n").value_or("none")};
}

/// A class of a few, as a folder, graded in one of its own.
struct SmallClass {
    void hand_in(const std::string &id, const std::string &text) const {
        write_file(folder.path / "in" / id / "05_inclined_planes.cpp", text);
    }
    Finished operator()(std::vector<std::string> words) const {
        if (words.front() == "5") words.insert(words.end(), {"--seed", "2026"}); // else it draws its own
        return draws_its_own(words);
    }
    Finished draws_its_own(std::vector<std::string> words) const {
        words.insert(words.begin(), "grade");
        return run(course_command(built_course(), words, {"NO_COLOR=1"}));
    }
    std::vector<std::string> words(std::vector<std::string> more = {}) const {
        std::vector<std::string> all{"5", in(), "--gradebook", (folder.path / "grades.csv").string(), "--out", out()};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    void write_gradebook(const std::vector<std::string> &ids) const {
        std::string text = "Student,ID,HW 5 (4711)\n    Points Possible,,10\n";
        for (const std::string &id : ids) text += "\"Doe, J" + id + "\"," + id + ",\n";
        write_file(folder.path / "grades.csv", text);
    }
    std::string in() const { return (folder.path / "in").string(); }
    std::string out() const { return (folder.path / "out").string(); }
    std::string read(const std::string &file) const { return read_file(fs::path{out()} / file); }
    OwnFolder folder{"a class XXXXXX"};
};

} // namespace

TEST_CASE("what keeps a job from leaving its result is told, and the others have left theirs") {
    std::size_t done = 0;
    const auto job = [](std::size_t number) {
        if (number == 3) throw UserError{"cannot write 3.json: the disk is full"};
    };
    REQUIRE_THROWS_MATCHES(in_parallel(8, job, [&] { ++done; }), EnvironmentError,
                           MessageMatches(ContainsSubstring("cannot write 3.json: the disk is full")));
    CHECK(done == 7);
}

TEST_CASE("a function's definition is found in code that needn't compile") {
    const auto found = [](const std::string &text) {
        const Functions functions = functions_of(Source{text}, {"first", "second"});
        const Function *its = find_function(functions, "first");
        return its != nullptr ? text.substr(its->begin, its->end - its->begin) + (its->fault ? " FAULT" : "") : "none";
    };
    CHECK(found("int first();\n// first() {\nint first(int a) { return a; }\nint b;")
          == "int first(int a) { return a; }");
    CHECK(found("int second() { return first(1); }\n") == "none");
    CHECK(found("int x() { if (first(1)) {} }\nint first()\n{\n  return \"}\"[0];\n}\n")
          == "int first()\n{\n  return \"}\"[0];\n}");
    CHECK(found("int first() {\n  if (1) {\n}\nint second() {}\n") == "int first() {\n  if (1) {\n} FAULT");
    CHECK(found("int at_first() {}\n") == "none");
    CHECK(found("char q = '\"', b = '{', e = '\\''; int n = 1'000;\nint first() { return 1; }\n")
          == "int first() { return 1; }");
    CHECK(found("auto s = \"open;\nint first() { return 1; }\n") == "int first() { return 1; }");
    CHECK(found("auto s = R\"x(\" { )\" ()x\";\nint first() { return 1; }\n") == "int first() { return 1; }");
    CHECK(found("auto s = \"\\\\\";\nint first() { return 1; }\n") == "int first() { return 1; }");
    const auto calls_second = [](const std::string &body) {
        const Source source{"int first() { return " + body + "; }"};
        return calls(source, functions_of(source, {}).at(0), "second");
    };
    CHECK(calls_second("second(1)"));
    CHECK(calls_second("1 + second (1)"));
    CHECK_FALSE(calls_second("pair.second(1) + my_second(1) + second"));
    const auto around = [](const std::string &text, const std::string &place) {
        const Functions functions = functions_of(Source{text}, {});
        const Function *its = function_around(functions, text.find(place));
        return its != nullptr ? text.substr(its->begin, its->end - its->begin) : "none";
    };
    const std::string file = "#include <x> // (\nnamespace n {\nint a[] = {1};\nstruct S { int m() { return 2; } };\n"
                             "template <class T> T f(T t) {\n  if (t) { return 3; }\n}\nint v = g(4);\n} // n\n";
    CHECK(around(file, "1") == "none");
    CHECK(around(file, "2") == "int m() { return 2; }");
    CHECK(around(file, "3") == "template <class T> T f(T t) {\n  if (t) { return 3; }\n}");
    CHECK(around(file, "template") == around(file, "3"));
    CHECK(around(file, "4") == "none");
    CHECK(around("int open() {\n return 1;\n", "1") == "int open() {\n return 1;\n");
    CHECK(Source{"a\nbc\nd"}.line_begins(2) == 2);
    CHECK(Source{"a\nbc\nd"}.line_begins(9) == 6);
    CHECK(Source{"a\nbc\nd"}.line_of(3) == 2);
}

TEST_CASE("points are all or, above what an answer passes that computes nothing, in proportion") {
    const auto earned = [](GradedExercise exercise, const std::vector<std::string> &void_tests = {}) {
        count(exercise, void_tests, {{1, 2}, {3}});
        return exercise.earned;
    };
    CHECK(earned(of_tests({true, true, true, true})) == 3);
    CHECK(earned(of_tests({true, true, false, false})) == 0);
    CHECK(earned(of_tests({false, false, false, true})) == 0);
    CHECK_THAT(earned(of_tests({true, true, true, false})), WithinAbs(1.5, 1e-12));
    CHECK_THAT(earned(of_tests({true, true, true, false}), {"test 1"}), WithinAbs(1.5, 1e-12)); // 2 of 3, above 1
    CHECK(earned(of_tests({true, true, true, false}), {"test 4"}) == 3);
    CHECK(earned(of_tests({})) == 0);
}

TEST_CASE("a file of points that can't be understood is refused with its line") {
    const OwnFolder folder{"points XXXXXX"};
    const auto worth = [&](const std::string &text) {
        write_file(folder.path / "points.txt", text);
        return Worth{folder.path / "points.txt", {{"5.3", "core", "f"}, {"5.4", "core", "f"}, {"5.6", "core", "f"}}};
    };
    const Worth mixed = worth("# ours\ncore 2\n5.4 3.5 # hard\n6.9 1\n");
    CHECK(mixed.of({"5.4", "core", "f"}) == 3.5);
    CHECK(mixed.of({"5.3", "core", "f"}) == 2);
    CHECK(mixed.of({"5.6", "stretch", "f"}) == 1);
    for (const char *bad : {"core\n", "core two\n", "kern 2\n", "core -1\n", "core 2 3\n", "core inf\n", "5.9 3\n"})
        CHECK_THROWS_WITH(worth(std::string{"# ours\n"} + bad), ContainsSubstring("points.txt:2: "));
}

TEST_CASE("a day late counts when it has started, in Moodle's words and in no others") {
    for (const auto &[words, days] : std::vector<std::pair<const char *, int>>{{"now", 1},
                                                                               {"1 sec", 1},
                                                                               {"3 mins 20 secs", 1},
                                                                               {"23 hours 59 mins", 1},
                                                                               {"1 day", 1},
                                                                               {"1 day 1 hour", 2},
                                                                               {"12 days 23 hours", 13},
                                                                               {"1 year 3 days", 368}}) {
        INFO(words);
        CHECK(started_days(words) == days);
    }
    for (const char *other :
         {"", "day", "1", "1 day 2", "1 Tag", "1 day and", "-1 days", "99999999999 days", "1 day late"})
        CHECK_FALSE(started_days(other));
    Graded late;
    late.submission.late_by = "einen Tag";
    take_off_for_lateness(late, 0);
    CHECK(late.our_trouble.empty());
    take_off_for_lateness(late, 10);
    CHECK_THAT(late.our_trouble, ContainsSubstring("`einen Tag late`"));
    CHECK(per_cent_per_day("10%/day") == 10);
    CHECK(per_cent_per_day("2.5%/day") == 2.5);
    for (const char *other :
         {"", "10", "10%", "10%/hour", "-10%/day", "0%/day", "101%/day", "nan%/day", "10%/day x", "x"})
        CHECK_THROWS_WITH(per_cent_per_day(other), ContainsSubstring("as in 10%/day"));
}

TEST_CASE("what a student reads names no command that a platform doesn't have") {
    CHECK(without_commands("x.cpp is empty. `./course reset 5` brings it back, and keeps a copy.\n")
          == "x.cpp is empty.\n");
    CHECK(without_commands("    Type ./course check 5. It's wrong.\n") == " It's wrong.\n");
    CHECK(without_commands("It answers section 4: ./course check 4 judges it. Another one.\n")
          == "It answers section 4. Another one.\n");
    CHECK(without_commands("a\n\n    Stuck? ./course hint 5.1\nb\n") == "a\n\nb\n");
}

TEST_CASE("no trivial answer earns anything, and ours earns all") {
    const Section section = built_course().section(GENERATE("1", "2", "5", "7"));
    const Baselines baselines = measure_baselines(built_course(), section);
    const auto earned = [&](const std::string &text) {
        const Outcomes outcomes = outcomes_of(built_course(), section, "an answer", text, 2026);
        REQUIRE_FALSE(outcomes.unbuilt);
        double sum = 0;
        for (const Exercise &exercise : catalogue(built_course(), section)) {
            GradedExercise its;
            its.possible = 1;
            std::ranges::copy_if(outcomes.verdicts, std::back_inserter(its.verdicts),
                                 [&](const Verdict &v) { return v.exercise == exercise.number; });
            const auto trivial = baselines.find(exercise.number);
            count(its, {}, trivial == baselines.end() ? Baselines::mapped_type{} : trivial->second);
            sum += its.earned;
        }
        return sum;
    };
    const auto trivial = trivial_answers(built_course(), section);
    CHECK(trivial.size() == 5);
    for (const Trivial &each : trivial) {
        INFO(each.name);
        CHECK(earned(each.text) == 0);
    }
    CHECK(earned(read_file(built_course().solution(section))) == double(catalogue(built_course(), section).size()));
}

TEST_CASE("a trivial answer gives back what its name says, where the type takes it") {
    const Section section = built_course().section("7");
    for (const Trivial &each : trivial_answers(built_course(), section)) {
        const Outcomes outcomes = outcomes_of(built_course(), section, each.name, each.text, 2026);
        const auto gives = [&](const std::string &answer) {
            return std::ranges::any_of(outcomes.verdicts,
                                       [&](const Verdict &v) { return v.call && v.call->answer == answer; });
        };
        INFO(each.name);
        CHECK(gives("true") == (each.name == "return true" || each.name == "return 1"));
        CHECK(gives("false") == (each.name == "return {}"));
    }
}

TEST_CASE("a function that doesn't compile costs no other one anything") {
    const std::string broken = "return mass * g * std::cos(angle)";
    SECTION("a semicolon is missing") {
        const std::string text = with(answer_of_ours(), right_normal_force, broken);
        const Outcomes outcomes = come_out(text);
        REQUIRE(outcomes.without.size() == 1);
        CHECK_THAT(outcomes.without.at("5.3").sentence, ContainsSubstring(";"));
        CHECK(outcomes.without.at("5.3").line == std::ranges::count(text.substr(0, text.find(broken)), '\n') + 1);
        CHECK(that_fail(outcomes) == "5.3 5.4 5.7 ");
        CHECK(outcomes.because_of == std::map<std::string, std::string>{{"5.4", "5.3"}, {"5.7", "5.3 and 5.4"}});
    }
    SECTION("two functions are broken, one lacks its last brace") {
        const Outcomes outcomes = come_out(
            with(with(answer_of_ours(), right_normal_force, broken), "return std::atan(mu_s);\n}", "return atan();"));
        CHECK(outcomes.without.contains("5.3"));
        CHECK(outcomes.without.contains("5.5"));
        CHECK(outcomes.without.size() == 2);
    }
    SECTION("a last brace is missing: the compiler stops in the next function, which isn't to blame") {
        const Outcomes outcomes =
            come_out(with(answer_of_ours(), "return std::atan(mu_s);\n}", "return std::atan(mu_s);"));
        CHECK(outcomes.without.size() == 1);
        CHECK(outcomes.without.contains("5.5"));
        CHECK(that_fail(outcomes) == "5.5 ");
    }
    SECTION("a helper is broken: whoever calls it fails, and nobody else") {
        const std::string helper = "static double weight(double mass, double g) {\n    return mass * g\n}\n\n";
        const Outcomes outcomes =
            come_out(with(with(answer_of_ours(), "double normal_force(", helper + "double normal_force("),
                          right_normal_force, "return weight(mass, g) * std::cos(angle);"));
        REQUIRE(outcomes.taken_out.size() == 1);
        CHECK_THAT(outcomes.taken_out[0].sentence, ContainsSubstring(";"));
        CHECK(outcomes.without.empty());
        CHECK(that_fail(outcomes) == "5.3 5.4 5.7 ");
        CHECK(outcomes_from(to_text(outcomes))->taken_out.size() == 1);
    }
    SECTION("a helper's heading is broken: that costs the whole file") {
        const Outcomes outcomes = come_out(
            with(answer_of_ours(), "double normal_force(", "int x(y z) {\n    return 1;\n}\ndouble normal_force("));
        CHECK(outcomes.unbuilt);
        CHECK(outcomes.verdicts.empty());
    }
    SECTION("more helpers are broken than we take out") {
        std::string helpers;
        for (const char *name : {"a", "b", "c", "d"})
            helpers += std::string{"int "} + name + "() {\n    return x;\n}\n";
        CHECK(come_out(answer_of_ours() + helpers).unbuilt);
    }
    SECTION("there's a main, which costs nothing, even if it doesn't compile") {
        const char *main = GENERATE("\nint main() { return 0; }\n", "\nint main() {\n    return x;\n}\n");
        const Outcomes outcomes = come_out(answer_of_ours() + main);
        REQUIRE_FALSE(outcomes.taken_out.empty());
        CHECK_THAT(outcomes.taken_out.back().sentence, ContainsSubstring("`main` of its own"));
        CHECK(that_fail(outcomes).empty());
        CHECK(outcomes.verdicts.size() > 10);
    }
    SECTION("what's broken is in no function of an exercise") {
        const Outcomes outcomes =
            come_out(with(answer_of_ours(), "namespace inclined_planes {", "int x\nnamespace inclined_planes {"));
        REQUIRE(outcomes.unbuilt);
        CHECK(outcomes.unbuilt->kind == Outcome::does_not_compile);
        CHECK(outcomes.verdicts.empty());
    }
}

namespace {

/// A slip in one function of ours: none of them is in a type, or in a value.
std::string with_slip(const std::string &function, const std::string &slip) {
    const std::string ours = answer_of_ours();
    const Functions functions = functions_of(Source{ours}, {});
    const Function &its = *find_function(functions, function);
    const std::string code = ours.substr(its.begin, its.end - its.begin);
    const std::size_t line = code.find('\n') + 1, quote = std::min(code.find('"'), code.size());
    const std::map<std::string, std::string> slips{
        {"fair", code.substr(0, line) + "this is no code;\n" + code.substr(line)},
        {"last )", std::string{code}.erase(code.rfind(')'), 1)},
        {"{", std::string{code}.erase(code.find('{'), 1)},
        {"}", code.substr(0, code.size() - 1)},
        {"\"", std::string{code}.erase(quote, 1)},
        {"} too many", code + "\n}"},
        {"/*", code.substr(0, line) + "/* how far?\n" + code.substr(line)},
        {"twice", code + "\n" + code}};
    return ours.substr(0, its.begin) + slips.at(slip) + ours.substr(its.end);
}

void check_slip(const Exercise &exercise, const std::string &slip) {
    INFO(exercise.number << ", " << slip);
    const std::string text = with_slip(exercise.function, slip);
    if (text == answer_of_ours()) return; // it has no quote
    const Outcomes outcomes = come_out(text);
    CHECK_FALSE(outcomes.unbuilt);
    CHECK(outcomes.without.contains(exercise.number));
    CHECK(that_fail(outcomes) == that_fail(come_out(with_slip(exercise.function, "fair"))));
}

const std::vector<std::string> slips{"last )", "{", "}", "\"", "} too many", "/*", "twice"};

} // namespace

TEST_CASE("a bracket too many or missing costs no more than any other slip in its function") {
    const std::vector<Exercise> exercises = catalogue(built_course(), section_five());
    for (std::size_t i = 0; i < exercises.size(); ++i) check_slip(exercises[i], slips[i % slips.size()]);
    check_slip(exercises.back(), "}");
    check_slip(exercises[5], "}"); // with a line that ends in one
}

TEST_CASE("each bracket in each function costs no more than any other slip in it", "[.each-bracket]") {
    if (sanitized) SKIP("hundreds of checks, which without sanitizers take a tenth of the time");
    for (const Exercise &exercise : catalogue(built_course(), section_five()))
        for (const std::string &slip : slips) check_slip(exercise, slip);
}

TEST_CASE("what's wrong around the code of a function is told at its place") {
    const std::string ours = answer_of_ours(), heading = "namespace inclined_planes {\n";
    const auto told = [](const std::string &text, int stopped = 0) {
        const auto verdict = diagnose_outline(text, "x.cpp", facts_of(built_course(), section_five()), stopped);
        return verdict ? std::to_string(verdict->line) + ": " + verdict->sentence : "nothing";
    };
    const auto line = [](const std::string &text, const std::string &words) { // in which these words end
        const auto end = text.begin() + long(text.find(words) + words.size());
        return std::to_string(1 + std::count(text.begin(), end, '\n')) + ": ";
    };
    CHECK(told(ours) == "nothing");
    const std::string much = with_slip("stopping_distance", "} too many"), comment = with_slip("normal_force", "/*"),
                      less = with_slip("critical_angle", "}");
    CHECK_THAT(told(much), ContainsSubstring(line(much, "}\n}") + "In 5.1 stopping_distance, this } is one too many"));
    CHECK_THAT(told(comment),
               ContainsSubstring(line(comment, "/* how") + "In 5.3 normal_force, the comment that starts"));
    CHECK_THAT(told(less),
               ContainsSubstring(line(less, "double critical_angle") + "In 5.5 critical_angle, this { never"));
    CHECK_THAT(told(with_slip("up_and_back", "{")), ContainsSubstring("In 5.7 up_and_back, a { is missing"));
    CHECK_THAT(told(with_slip("up_and_back", "last )")), ContainsSubstring("In 5.7 up_and_back, this ( never closes"));
    const std::string helper =
        with(ours, "static void require_board(double mass,", "static void require_board(double mass;");
    CHECK(told(helper) == "nothing");
    CHECK_THAT(told(with(ours, "#include \"inclined_planes.hpp\"", "")),
               ContainsSubstring("0: Your file doesn't include"));
    CHECK_THAT(told(with(ours, heading, "")), ContainsSubstring("`namespace inclined_planes {` is gone"));
    CHECK_THAT(told("```cpp\n" + ours), ContainsSubstring("1: Lines with ```"));
    CHECK_THAT(told(with(ours, "\"deceleration [m/s²] must be positive\"", "“deceleration”")),
               ContainsSubstring("Curly quotes"));
    CHECK(told(with(ours, "must be positive\"", "must be “positive”\"")) == "nothing");
}

TEST_CASE("a text is read in a time that grows as it does, whatever is in it") {
    const std::string piece =
        GENERATE("apply_friction(", "double first(", "\ndouble first(int a)\n", "/* \n", "'\"\n", "R\"(\n", "}({[",
                 "#if 0\n", "a a a a\n", "double second() {\n", "namespace n {\n");
    const auto work = [&](std::size_t size) {
        std::string text;
        while (text.size() < size) text += piece;
        double least = 1e18;
        for (int i = 0; i < 3; ++i) {
            const std::clock_t begin = std::clock();
            functions_of(Source{text}, {"first", "second"});
            least = std::min(least, double(std::clock() - begin));
        }
        return least;
    };
    INFO(piece);
    CHECK(work(400'000) < 32 * work(50'000)); // 8 times as long; 64, if it grew with the square
}

TEST_CASE("a function that fails because of another one is told so, and one that's wrong itself isn't") {
    const Outcomes only = come_out(with(answer_of_ours(), right_normal_force, wrong_normal_force));
    CHECK(that_fail(only) == "5.3 5.4 5.7 ");
    CHECK(only.because_of == std::map<std::string, std::string>{{"5.4", "5.3"}, {"5.7", "5.3 and 5.4"}});

    const Outcomes both = come_out(with(with(answer_of_ours(), right_normal_force, wrong_normal_force),
                                        "if (pull <= box.mu_s * normal) return 0;", ""));
    CHECK(both.because_of.count("5.4") == 0);
}

TEST_CASE("what a student hasn't written is no consequence, although with ours in its place it passes") {
    const std::string heading = "double incline_acceleration(const Box &box, double angle, double g) {";
    const std::string wrong = with(answer_of_ours(), right_normal_force, wrong_normal_force);
    SECTION("it takes something else than it should") {
        const Outcomes outcomes =
            come_out(with(wrong, heading, "double incline_acceleration(Box &box, double angle, double g) {"));
        CHECK(that_fail(outcomes) == "5.3 5.4 5.7 ");
        CHECK(outcomes.because_of.count("5.4") == 0);
    }
    SECTION("it goes away together with the one that it calls") {
        const std::string hidden = "\n#define OPENS {\n}\n#define OTHER incline_acceleration\n"
                                   "double OTHER(const Box &, double, double) { return 1; }\n#define CLOSES }\n";
        const Outcomes outcomes =
            come_out(with(with(wrong, wrong_normal_force + std::string{"\n}"}, wrong_normal_force + hidden), heading,
                          "double incline_acceleration(Box &box, double angle, double g) {"));
        CHECK(that_fail(outcomes) == "5.3 5.4 5.7 ");
        CHECK(outcomes.because_of.count("5.4") == 0);
    }
    SECTION("it looks for ours at its distance from the one that it calls") {
        const BuildConfig tools = build_config(built_course(), section_five());
        const std::string symbols = run({tools.nm, tools.ours.string()}).out;
        const auto place = [&](const std::string &function) {
            const std::size_t line = symbols.rfind('\n', symbols.find(function));
            return std::stoll(symbols.substr(line + 1, 16), nullptr, 16);
        };
        const std::string distance = std::to_string(place("incline_acceleration") - place("normal_force"));
        const std::size_t begin = wrong.find(heading), end = wrong.find("\n}", begin);
        const std::string far =
            heading + "\n    auto its = reinterpret_cast<const char *>(&normal_force) + " + distance
            + ";\n    if (g < 0) return normal_force(box.mass, angle, g);\n"
              "    return reinterpret_cast<decltype(&incline_acceleration)>(const_cast<char *>(its))"
              "(box, angle, g);";
        const Outcomes outcomes = come_out(wrong.substr(0, begin) + far + wrong.substr(end));
        CHECK_FALSE(outcomes.unbuilt);
        CHECK(outcomes.without.empty());
        CHECK(outcomes.because_of.count("5.4") == 0);
    }
    SECTION("it calls the one that calls it, so that each has ours while it's judged") {
        const Outcomes outcomes = come_out(
            with(with(answer_of_ours(), "    const double loss = deceleration * dt; // of speed [m/s]\n",
                      "    return table_friction({velocity, 0}, deceleration, dt).x();\n    const double loss = 0;\n"),
                 "    if (speed <= loss) return {0, 0};\n    return (speed - loss) / speed * velocity;",
                 "    if (speed == 0) return velocity;\n"
                 "    return apply_friction(speed, deceleration, dt) / speed * velocity + 0 * loss * velocity;"));
        CHECK(outcomes.because_of.count("5.2") == 0);
    }
    SECTION("it's there only as long as the other one is") {
        const std::string symbol = "_ZN15inclined_planes20incline_accelerationERKNS_3BoxEdd";
        const std::size_t begin = wrong.find(heading), end = wrong.find("\n}", begin);
        const std::string hidden =
            with(heading, " {", " asm(\"hidden\");\n") + heading
            + "\n    asm(\".ifdef _ZN15inclined_planes12normal_forceEddd\\n.pushsection .text.x,\\\"ax\\\",@progbits\\n"
              ".globl "
            + symbol + "\\n" + symbol
            + ": jmp hidden\\n.popsection\\n.endif\\n\");\n    return normal_force(box.mass, angle, g);";
        const Outcomes outcomes = come_out(wrong.substr(0, begin) + hidden + wrong.substr(end));
        CHECK(that_fail(outcomes) == "5.3 5.4 5.7 ");
        CHECK(outcomes.because_of.count("5.4") == 0);
    }
}

TEST_CASE("outcomes are the same when they come back from a file, and half a file is none") {
    const Outcomes outcomes = come_out(with(answer_of_ours(), right_normal_force, "return mass * g * std::sin(angle)"));
    const std::string text = to_text(outcomes);
    const auto back = outcomes_from(text);
    REQUIRE(back);
    CHECK(to_text(*back) == text);
    CHECK_FALSE(outcomes_from(text.substr(0, text.size() / 2)));
    CHECK_FALSE(outcomes_from("{}"));
}

TEST_CASE("a class is graded into the gradebook, and another call judges only what's new") {
    if (sanitized) SKIP("a quarter of an hour there, and others grade with sanitizers, too");
    static const SmallClass grade;
    static const OwnFolder kept{"a graded class XXXXXX"}; // each section goes on from this
    const fs::path graded = kept.path / "class";
    if (!fs::exists(graded)) {
        grade.write_gradebook({"1001", "1002", "1003", "1004", "1005"});
        grade.hand_in("1001", answer_of_ours());
        grade.hand_in("1002", with(answer_of_ours(), right_normal_force, wrong_normal_force));
        grade.hand_in("1003", "");
        grade.hand_in("1004", read_file(built_course().stub(section_five())));
        const Finished first = grade(grade.words());
        INFO(first.out << first.err);
        REQUIRE(first.code == 0);
        CHECK_THAT(first.out, ContainsSubstring("4 judged") && ContainsSubstring("(1): 1005"));
        CHECK(grade.read("grades.csv")
              == "Student,ID,HW 5 (4711)\n    Points Possible,,10\n\"Doe, J1001\",1001,10\n\"Doe, J1002\",1002,6.24\n"
                 "\"Doe, J1003\",1003,0\n\"Doe, J1004\",1004,0\n\"Doe, J1005\",1005,\n");
        CHECK((fs::status(grade.out()).permissions() & fs::perms::all) == fs::perms::owner_all);
        fs::copy(grade.folder.path, graded, fs::copy_options::recursive);
    }
    fs::remove_all(grade.folder.path);
    fs::copy(graded, grade.folder.path, fs::copy_options::recursive);

    SECTION("nothing is judged twice; an override survives, and is said") {
        write_file(fs::path{grade.out()} / "overrides.csv",
                   "id,points,why\n1003,\"7,5\",\"the upload, broke\"\n1005,2,oral\n");
        const Finished again = grade({"--out", grade.out(), "--again"});
        INFO(again.out << again.err);
        CHECK_THAT(again.out, ContainsSubstring("0 judged")
                                  && ContainsSubstring("1003: 0 -> 7.5 (set by hand: the upload, broke)")
                                  && ContainsSubstring("1005: nothing -> 2 (set by hand: oral)"));
        CHECK_THAT(grade.read("grades.csv"), ContainsSubstring("1003,7.5\n") && ContainsSubstring("1005,2\n"));
        CHECK_THAT(grade({"--out", grade.out(), "--again"}).out, ContainsSubstring("Nobody's points have changed"));
        CHECK_THAT(grade.read("overrides.csv"), ContainsSubstring("the upload, broke"));
        grade.hand_in("1003", answer_of_ours());
        write_file(fs::path{grade.out()} / "overrides.csv", "1003,7.5,broke\n");
        CHECK_THAT(
            grade({"--out", grade.out(), "--again"}).out,
            ContainsSubstring("2 students changed:\n  1003: 7.5 -> 7.5 (set by hand: broke; another file was "
                              "handed in, which comes to 10)\n  1005: 2 -> nothing (no longer set by hand: clear "
                              "it on the platform, too)\n"));
        write_file(fs::path{grade.out()} / "overrides.csv", "");
        CHECK_THAT(grade({"--out", grade.out(), "--again"}).out,
                   ContainsSubstring("1 student changed:\n  1003: 7.5 -> 10 (no longer set by hand)\n"));
    }
    SECTION("an override that can't be meant is refused; its head may be missing") {
        const auto refused = [&](const std::string &text) {
            write_file(fs::path{grade.out()} / "overrides.csv", text);
            const Finished done = grade({"--out", grade.out(), "--again"});
            CHECK(done.code == 2);
            return done.err;
        };
        CHECK_THAT(refused("id,points,why\n10033,7,oral\n"), ContainsSubstring("nobody has the id 10033"));
        CHECK_THAT(refused("10033,7,oral\n"), ContainsSubstring("nobody has the id 10033"));
        CHECK_THAT(refused("id,points,why\n1003,nan,oral\n"), ContainsSubstring("the line of 1003 should be"));
        CHECK_THAT(refused("1003,7,oral\n1003,8,oral\n"), ContainsSubstring("two lines for 1003"));
    }
    SECTION("a second download keeps what was agreed with the first") {
        const std::string name = "on a level board it presses with its whole weight, 100 N";
        grade({"--out", grade.out(), "--forgive", "--without", name});
        const std::string before = grade.read("grade.json");
        grade.hand_in("1003", answer_of_ours());
        const Finished second = grade({"5", grade.in(), "--out", grade.out()});
        INFO(second.out << second.err);
        CHECK_THAT(second.out, ContainsSubstring("1 student changed:\n  1003: 0 -> 10 (another file was handed in)\n"));
        CHECK(grade.read("grade.json") == before);
        CHECK_THAT(grade.read("grades.csv"), ContainsSubstring(",1003,10\n"));
    }
    SECTION("another section wants another folder") {
        const Finished other = grade({"7", grade.in(), "--out", grade.out()});
        CHECK(other.code == 2);
        CHECK_THAT(other.err, ContainsSubstring("holds section 5 already: name another folder, as --out g7"));
    }
    SECTION("an appeal is judged anew, and shown whole") {
        const Finished appeal = grade({"--out", grade.out(), "--only", "1002", "-v"});
        CHECK_THAT(appeal.out, ContainsSubstring("1 judged") && ContainsSubstring("when you take the sine")
                                   && ContainsSubstring("consequence of 5.3"));
        CHECK(grade({"--out", grade.out(), "--only", "1005"}).code == 2);
    }
    SECTION("who hands in another file has no points for the one before, until it's judged") {
        grade.hand_in("1004", answer_of_ours());
        const Finished appeal = grade({"--out", grade.out(), "--only", "1002"});
        CHECK(appeal.code == 3);
        CHECK_THAT(appeal.out, ContainsSubstring("not graded 1004: it hasn't been judged as it is now"));
        CHECK_THAT(grade.read("grades.csv"), ContainsSubstring("1004,\n"));
    }
    SECTION("all answers to an exercise are shown, equal ones once") {
        const Finished all = grade({"--out", grade.out(), "--show", "5.3"});
        CHECK_THAT(all.out, ContainsSubstring("// 1001 (1.54)\ndouble normal_force(")
                                && ContainsSubstring(std::string{"    "} + wrong_normal_force));
        CHECK_THAT(grade({"--out", grade.out(), "--show", "5.5"}).out,
                   ContainsSubstring("// 1001 (1.54), 1002 (1.54)\n"));
        const Finished none = grade({"--out", grade.out(), "--show", "7.1"});
        CHECK(none.code == 2);
        CHECK_THAT(none.err, ContainsSubstring("answers to section 5, and none to 7.1"));
    }
    SECTION("a void test counts for nobody, and everybody is told") {
        const std::string name = "on a level board it presses with its whole weight, 100 N";
        const Finished without = grade({"--out", grade.out(), "--without", name});
        CHECK_THAT(without.out, ContainsSubstring("0 judged"));
        CHECK_THAT(grade({"--out", grade.out(), "--only", "1001"}).out,
                   ContainsSubstring("doesn't count for anybody: " + name));
        CHECK(grade({"--out", grade.out(), "--without", "no such test"}).code == 2);
    }
    SECTION("a consequence isn't blamed for a mistake besides") {
        grade.hand_in("1004", with(answer_of_ours(), "    if (pull <= box.mu_s * normal) return 0;\n", ""));
        REQUIRE(grade({"--out", grade.out(), "--again"}).code == 0);
        const Archive texts{fs::path{grade.out()} / "feedback.zip"};
        const auto entry = std::ranges::find(texts.entries(), "1004/feedback.txt", &Archive::Entry::name);
        const std::string text = texts.read(*entry, 10000);
        const std::size_t consequence = text.find("This is a consequence of 5.4:");
        REQUIRE(consequence != text.npos); // 5.7 is right, and comes out as if it checked nothing on the way back
        CHECK_THAT(text.substr(consequence), !ContainsSubstring("This is what comes out when"));
        const std::string report = grade.read("report.html");
        CHECK_THAT(report, !ContainsSubstring("0 of 0 tests") && !ContainsSubstring("no test that counts</"));
    }
    SECTION("a consequence may cost nothing") {
        grade({"--out", grade.out(), "--forgive"});
        CHECK_THAT(grade.read("grades.csv"), ContainsSubstring("1002,8.46\n"));
    }
    SECTION("a file that was cut off, and one that changed, are judged again") {
        write_file(fs::path{grade.out()} / "results" / "1001.json", grade.read("results/1001.json").substr(0, 300));
        grade.hand_in("1004", answer_of_ours());
        const Finished again = grade({"--out", grade.out(), "--again"});
        CHECK_THAT(again.out,
                   ContainsSubstring("2 judged") && ContainsSubstring("1004: 0 -> 10 (another file was handed in)\n"));
    }
}

TEST_CASE("late days cost points, as Moodle's worksheet counts them, and no more than were earned") {
    const SmallClass grade;
    const auto kept = [](const char *name) { return read_file(fs::path{COURSE_ROOT} / "tests" / "class" / name); };
    write_file(grade.folder.path / "grades.csv", kept("moodle_late.csv"));
    for (const char *id : {"1003", "1004", "1005", "1012", "1013", "1014"}) grade.hand_in(id, answer_of_ours());
    write_file(fs::path{grade.out()} / "overrides.csv", "1012,7,was ill\n");
    const Finished plan = grade(grade.words({"--dry-run"}));
    CHECK_THAT(plan.out, ContainsSubstring("  1003: 05_inclined_planes.cpp, 1 day 2 hours late\n")
                             && ContainsSubstring("  1013: 05_inclined_planes.cpp\n"));
    const Finished done = grade(grade.words({"--late", "10%/day"}));
    INFO(done.out << done.err);
    CHECK(done.code == 3);
    CHECK_THAT(done.out, ContainsSubstring("not graded 1005: Moodle's Status says `einen Tag late`"));
    CHECK_THAT(done.out, ContainsSubstring("taken off for handing in late (3): 1003 (2 days, 2), 1004 (1 day, 1), 1014 "
                                           "(41 days, 10)\n"));
    CHECK(grade.read("grades.csv") == kept("moodle_late_filled.csv"));
    CHECK_THAT(grade.read("report.html"), ContainsSubstring("2 of 10 points taken off, for being 2 days late")
                                              && ContainsSubstring("1 day 2 hours late"));
    const Archive texts{fs::path{grade.out()} / "feedback.zip"};
    for (const Archive::Entry &entry : texts.entries())
        if (entry.name == "1003/feedback.txt")
            CHECK_THAT(
                texts.read(entry, 10000),
                ContainsSubstring(
                    "Section 5: 8 of 10 points\nThat's 10, minus 2 for being 2 days late. A day counts once it has "
                    "started.\nJudged: 05_inclined_planes.cpp (1 day 2 hours late), by "));

    write_file(fs::path{grade.out()} / "overrides.csv", "1012,7,was ill\n1005,9,a day late\n");
    const Finished again = grade({"--out", grade.out(), "--again"}); // it's kept what lateness costs
    INFO(again.out << again.err);
    CHECK(again.code == 0);
    CHECK_THAT(again.out, ContainsSubstring("1 student changed:\n  1005: nothing -> 9 (set by hand: a day late)\n"));
}

TEST_CASE("where no platform says how late somebody is, nothing is taken off, and the remedy is named") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    CHECK_THAT(grade({"5", grade.in(), "--out", grade.out(), "--late", "10%/day"}).err,
               ContainsSubstring("name that with --gradebook, or leave out --late, and set points in overrides.csv"));
    grade.write_gradebook({"1"});
    CHECK_THAT(grade(grade.words({"--late", "10%/day"})).err,
               ContainsSubstring("set it there, in the gradebook's Settings, Late Policies"));
    CHECK(grade(grade.words()).code == 0);
}

TEST_CASE("who began with the file of other tests is listed, and told; nobody else is") {
    const SmallClass grade;
    const WhichTests today = which_tests(hash_of_tests(built_course(), section_five()), course_version());
    const std::string other = "// Handed out with tests 5f3a2b1c9d0e (0.0.9).\n";
    grade.hand_in("1", answer_of_ours());
    grade.hand_in("2", answer_of_ours() + stamp_of({today.digits, "0.0.9"})); // the same tests
    grade.hand_in("3", answer_of_ours() + other);
    grade.hand_in("4", answer_of_ours() + "// Handed out with tests <b>5f3a2b1c9d (0.0.9).\n");
    const Finished done = grade({"5", grade.in(), "--out", grade.out()});
    INFO(done.out << done.err);
    REQUIRE(done.code == 0);
    CHECK_THAT(done.out, ContainsSubstring("Began with the file of other tests than these, " + today.digits
                                           + ", and may have updated since (1): 3 (5f3a2b1c9d0e, version 0.0.9)\n"));
    const std::string report = grade.read("report.html");
    CHECK_THAT(report, ContainsSubstring("Began with the file of other tests")
                           && ContainsSubstring("version 0.0.9 of the course, tests 5f3a2b1c9d0e</li>"));
    const Archive texts{fs::path{grade.out()} / "feedback.zip"};
    for (const Archive::Entry &entry : texts.entries()) {
        const std::string text = texts.read(entry, 10000);
        const std::string told =
            "\nYour file was handed out with version 0.0.9 of the course, tests 5f3a2b1c9d0e: if your "
            "`check` says something else than this, `./course update` brings yours up to date.\n";
        CHECK(contains(text, told) == (entry.name == "3/feedback.txt"));
        CHECK(contains(text, "handed out") == (entry.name == "3/feedback.txt"));
        CHECK_THAT(text, ContainsSubstring("by " + words_for(today) + '\n'));
    }
    const auto check = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"check", "5", "--file", grade.in() + "/1/05_inclined_planes.cpp"});
        return run(course_command(built_course(), more, {"NO_COLOR=1"})).out;
    };
    CHECK(check({"-v"}).ends_with("\nJudged by " + words_for(today) + '\n'));
    CHECK_THAT(check({}), !ContainsSubstring("Judged by"));
}

TEST_CASE("a grading draws its own seed, names it everywhere, and keeps it until another is said") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    const auto seed_of = [](const Finished &done) {
        INFO(done.out << done.err);
        return std::string{between(done.out, "Generated values: --seed ", ".\n").value_or("none")};
    };
    const std::string first = seed_of(grade.draws_its_own({"5", grade.in(), "--out", grade.out() + "1"}));
    const std::string seed = seed_of(grade.draws_its_own({"5", grade.in(), "--out", grade.out()}));
    CHECK(first != seed);
    CHECK_THAT(grade.read("report.html"), ContainsSubstring("<dd>" + seed + "</dd>"));
    CHECK_THAT(grade.read("junit.xml"), ContainsSubstring(seed));
    const Archive texts{fs::path{grade.out()} / "feedback.zip"};
    CHECK_THAT(texts.read(texts.entries().at(0), 10000),
               ContainsSubstring("`check --seed " + seed + "` draws the same.\n"));
    const Finished again = grade.draws_its_own({"--out", grade.out(), "--again"});
    CHECK(seed_of(again) == seed);
    CHECK_THAT(again.out, ContainsSubstring("0 judged now"));
    const Finished joined = grade.draws_its_own({"5", grade.in(), "--out", grade.out() + "2", "--merge", grade.out()});
    CHECK(seed_of(joined) == seed);
    CHECK_THAT(joined.out, ContainsSubstring("0 judged now"));
    const Finished other = grade.draws_its_own({"--out", grade.out(), "--seed", "7"});
    CHECK(seed_of(other) == "7");
    CHECK_THAT(other.out, ContainsSubstring("1 judged now"));

    const Finished apart = grade.draws_its_own({"--out", grade.out(), "--merge", grade.out() + "1"});
    CHECK(apart.code == 2);
    CHECK_THAT(apart.err, ContainsSubstring("was judged with --seed " + first + ", and this with --seed 7"));
    const Finished part = grade.draws_its_own({"5", grade.in(), "--out", grade.out() + "3", "--shard", "1/2"});
    CHECK(part.code == 2);
    CHECK_THAT(part.err, ContainsSubstring("say the same for each, as in --seed "));
    CHECK(grade.draws_its_own({"5", grade.in(), "--out", grade.out() + "3", "--seed", "-1"}).code == 2);
}

TEST_CASE("a folder with other things in it, or a file, is left alone") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    write_file(fs::path{grade.out()} / "report.html", "somebody's own");
    const Finished folder = grade({"5", grade.in(), "--out", grade.out()});
    CHECK(folder.code == 2);
    CHECK_THAT(folder.err, ContainsSubstring("something else in it, report.html"));
    CHECK(grade.read("report.html") == "somebody's own");
    const Finished file = grade({"5", grade.in(), "--out", grade.out() + "/report.html"});
    CHECK(file.code == 2);
    CHECK_THAT(file.err, ContainsSubstring("is a file: name a folder"));
}

TEST_CASE("writes through no link, and into nobody else's folder") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    const fs::path out = grade.out(), elsewhere = grade.folder.path / "elsewhere";
    fs::create_directories(elsewhere);
    const auto refuses = [&](const std::string &words) {
        const Finished done = grade({"5", grade.in(), "--out", grade.out()});
        CHECK(done.code == 2);
        CHECK_THAT(done.err, ContainsSubstring(words));
        CHECK(fs::is_empty(elsewhere));
    };
    for (const char *name : {"files", "files/1.cpp", "points.txt"}) {
        fs::create_directories((out / name).parent_path());
        fs::create_symlink(elsewhere / "x", out / name);
        refuses("has a link in it, " + std::string{name} + ", through which other files would be written");
        fs::remove_all(out);
    }
    if (::geteuid() != 0) SKIP("only root can make another's folder");
    fs::create_directories(out);
    REQUIRE(::chown(out.c_str(), 65534, 65534) == 0);
    refuses("belongs to another user (65534), who could read and change all of it: name a new folder");
}

TEST_CASE("a call that failed stands in nobody's way") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    CHECK(grade({"5", grade.in(), "--out", grade.out(), "--without", "no such test"}).code == 2);
    CHECK(grade({"5", grade.in(), "--out", grade.out()}).code == 0);
}

TEST_CASE("Ctrl-C keeps what's judged, says so, and the same command goes on") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    for (const char *id : {"2", "3"})
        grade.hand_in(id, with(answer_of_ours(), "return std::atan(mu_s);", "for (;;) {}"));
    auto command = course_command(built_course(), {"grade", "5", grade.in(), "--out", grade.out(), "--seed", "2026"});
    const std::string script =
        "\"$@\" & until [ -e '" + grade.out() + "/results/1.json' ]; do sleep 0.05; done; kill -INT $!; wait $!";
    command.insert(command.begin(), {"sh", "-c", script, "sh"});
    const Finished stopped = run(command, {.deadline = 300});
    CHECK(stopped.code == 130);
    CHECK(stopped.err == "\nStopped. What's judged is kept: the same command once more goes on from here.\n");
    for (const char *id : {"2", "3"}) grade.hand_in(id, answer_of_ours());
    const Finished rest = grade({"5", grade.in(), "--out", grade.out()});
    CHECK(rest.code == 0);
    CHECK_THAT(rest.out, ContainsSubstring("2 judged now"));
}

TEST_CASE("parts that were judged apart join to the same as a whole") {
    if (sanitized) SKIP("minutes there, and others grade with sanitizers, too");
    const SmallClass grade;
    grade.write_gradebook({"1", "2", "3"});
    grade.hand_in("1", answer_of_ours());
    grade.hand_in("2", with(answer_of_ours(), right_normal_force, wrong_normal_force));
    grade.hand_in("3", "nonsense");
    REQUIRE(grade(grade.words()).code == 0);
    const std::string whole = grade.read("grades.csv"), texts = grade.read("feedback.zip");
    std::vector<std::string> merge{"--merge"};
    for (const char *part : {"1", "2"}) {
        const std::string folder = (grade.folder.path / part).string();
        CHECK(grade({"5", grade.in(), "--out", folder, "--shard", std::string{part} + "/2"}).code == 0);
        merge.push_back(folder);
    }
    fs::remove_all(grade.out());
    CHECK_THAT(grade(grade.words(merge)).out, ContainsSubstring("0 judged"));
    CHECK(grade.read("grades.csv") == whole);
    CHECK(grade.read("feedback.zip") == texts);
    CHECK(grade(grade.words({"--shard", "3/2"})).code == 2);
}

TEST_CASE("who hasn't been judged, through no fault of theirs, gets no 0 for it") {
    const SmallClass grade;
    grade.write_gradebook({"1", "2"});
    grade.hand_in("1", answer_of_ours());
    grade.hand_in("2", answer_of_ours());
    const Finished one = grade(grade.words({"--only", "2"}));
    INFO(one.out << one.err);
    CHECK(one.code == 3);
    CHECK_THAT(one.out, ContainsSubstring("not graded 1: it hasn't been judged"));
    CHECK_THAT(grade.read("grades.csv"), ContainsSubstring(",1,\n") && ContainsSubstring(",2,10\n"));
    CHECK(grade({"--out", grade.out(), "--again"}).code == 0);
    CHECK_THAT(grade.read("grades.csv"), ContainsSubstring(",1,10\n"));
}

TEST_CASE("a machine that lets nothing be judged stops before anybody is graded") {
    const SmallClass grade;
    grade.hand_in("1", answer_of_ours());
    auto command = course_command(built_course(), {"grade", "5", grade.in(), "--out", grade.out(), "--seed", "2026"});
    command.insert(command.begin(), {"sh", "-c", "ulimit -f 200000; exec \"$@\"", "sh"}); // half of what a check needs
    CHECK(run(command).code == 4);
    CHECK_FALSE(fs::exists(fs::path{grade.out()} / "feedback.zip"));
}

TEST_CASE("points of everybody are in a table, and no file is 0 or blank, as agreed") {
    const SmallClass grade;
    write_file(grade.folder.path / "grades.csv",
               "Student,ID,HW 5 (4711)\n    Points Possible,,10\n\"=Doe, J\",1,\nRoe,2,3\nPoe,3,\n");
    grade.hand_in("1", with(answer_of_ours(), right_normal_force, "return mass * g * std::cos(angle)"));
    write_file(fs::path{grade.in()} / "2" / "work.zip", "");
    write_file(fs::path{grade.in()} / "3" / "work.zip", "");
    write_file(fs::path{grade.out()} / "overrides.csv", "3,4,+oral\n");
    CHECK_THAT(grade(grade.words({"--dry-run"})).out, ContainsSubstring("row 2 (Roe) would become 0, which has 3\n"));
    CHECK_THAT(grade(grade.words()).out, ContainsSubstring("with --no-file blank (1): 2\n"));
    const std::string archive =
        "\"You handed in an archive, work.zip: hand in 05_inclined_planes.cpp itself, unpacked.\"\n";
    const std::string head = "id,name,total,possible,5.1,5.2,5.3,5.4,5.5,5.6,5.7,5.8,trouble\n",
                      first = "1,\"'=Doe, J\",6.15,10,1.54,1.54,0,0,1.54,0.77,0,0.77,\n",
                      set = "3,Poe,4,10,,,,,,,,,set by hand: +oral\n";
    CHECK(grade.read("points.csv") == head + first + "2,Roe,0,10,,,,,,,,," + archive + set);
    CHECK_THAT(grade.read("grades.csv"), ContainsSubstring("Roe,2,0\n"));

    const Finished blank = grade({"--out", grade.out(), "--no-file", "blank"});
    CHECK_THAT(blank.out, ContainsSubstring("No file to judge, so their rows stay as they are (1): 2\n")
                              && ContainsSubstring("2: 0 -> nothing (there's no file)\n"));
    CHECK(grade.read("points.csv") == head + first + "2,Roe,,10,,,,,,,,," + archive + set);
    CHECK_THAT(grade.read("grades.csv"), ContainsSubstring("Roe,2,3\n"));
    CHECK_THAT(grade({"--out", grade.out(), "--again"}).out, ContainsSubstring("Nobody's points have changed"));
    CHECK_THAT(grade.read("grades.csv"), ContainsSubstring("Roe,2,3\n")); // it's kept
    CHECK(grade({"--out", grade.out(), "--no-file", "1"}).code == 2);
}

TEST_CASE("a test that our own solution fails is said first, and changes nobody's points") {
    const SmallClass grade;
    grade.write_gradebook({"1"});
    grade.hand_in("1", answer_of_ours());
    REQUIRE(grade(grade.words()).code == 0);
    const std::string before = grade.read("grades.csv");
    const fs::path root = grade.folder.path / "course"; // where ours is wrong: to a test that's as bad as a wrong test
    fs::create_directories(root / "solutions");
    link_all_but({"solutions"}, COURSE_ROOT, root);
    write_file(root / "solutions" / "05_inclined_planes.cpp",
               with(answer_of_ours(), right_normal_force, wrong_normal_force));
    const fs::path build = grade.folder.path / "build"; // the same, but with a record of its own of what's up to date
    fs::create_directories(build);
    link_all_but({"loop"}, COURSE_BUILD, build);
    write_file(build / "loop" / "05_inclined_planes.checked", "");
    const Workspace workspace{.root = root, .build = build};
    const auto there = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"grade", "--out", grade.out()});
        return run(course_command(workspace, words, {"NO_COLOR=1"}));
    };
    grade.hand_in("1", with(answer_of_ours(), right_normal_force, wrong_normal_force));
    const Finished done = there({"--again"});
    CHECK(done.code == 2);
    CHECK_THAT(done.err, ContainsSubstring("our own solution of 5.3 fails `") && ContainsSubstring("nobody's points"));
    CHECK(grade.read("grades.csv") == before);

    write_file(root / "solutions" / "05_inclined_planes.cpp", "none of it\n");
    const Finished unbuilt = there({"--again"});
    CHECK(unbuilt.code == 2);
    CHECK_THAT(unbuilt.err, ContainsSubstring("our own solution can't be judged, so nobody's points have changed: "));
    CHECK(grade.read("grades.csv") == before);
}

TEST_CASE("a file that the instructor names is judged, also by the next call") {
    const SmallClass grade;
    grade.write_gradebook({"1"});
    for (const char *name : {"one.cpp", "two.cpp"}) write_file(fs::path{grade.in()} / "1" / name, answer_of_ours());
    CHECK_THAT(grade(grade.words({"--dry-run"})).out,
               ContainsSubstring("1: not taken: one.cpp, two.cpp\n")
                   && ContainsSubstring("To judge another file of theirs, name it, as in --take 1=FILE\n"));
    CHECK_THAT(grade(grade.words({"--take", "1"})).err, ContainsSubstring("as in 1032=f.cpp.txt, not 1"));
    CHECK(grade(grade.words({"--take", "1=two.cpp"})).code == 0);
    CHECK_THAT(grade.read("grades.csv"), ContainsSubstring(",1,10\n"));
    CHECK_THAT(grade({"--out", grade.out(), "--again"}).out, ContainsSubstring("0 judged now"));
    CHECK_THAT(grade.read("report.html"),
               ContainsSubstring("one.cpp") && ContainsSubstring("<td class=\"file\">two.cpp"));
}

TEST_CASE("a class's names that aren't the gradebook's may be those of groups") {
    const SmallClass grade;
    grade.write_gradebook({"1", "2"});
    const auto said = [&](const std::string &names) {
        MadeZip zip;
        for (const char *id : {"1", "2"})
            zip.file(names + (names == "doe" ? std::string{"j"} + id : "") + '_' + id + "_9_05_inclined_planes.cpp",
                     "x");
        zip.write(grade.folder.path / "in");
        return grade(grade.words({"--dry-run"})).out;
    };
    CHECK_THAT(said("team"), ContainsSubstring("No name in the download is its row's. Is it group work?"));
    CHECK_THAT(said("doe"), !ContainsSubstring("group work"));
}

TEST_CASE("a dry run says what would be, and leaves nothing behind") {
    const SmallClass grade;
    grade.write_gradebook({"1", "2"});
    grade.hand_in("1", answer_of_ours());
    const Finished dry = grade(grade.words({"--dry-run"}));
    CHECK(dry.code == 0);
    CHECK_THAT(dry.out,
               ContainsSubstring("  1: 05_inclined_planes.cpp\n") && ContainsSubstring("row 1 (Doe, J1) would change"));
    CHECK_FALSE(fs::exists(grade.out()));
    write_file(grade.folder.path / "grades.csv",
               "Student,ID,Final Score of 5 (4711)\n    Points Possible,,10\n\"Doe, J\",1,A-\n");
    CHECK_THAT(grade(grade.words({"--dry-run"})).out, ContainsSubstring("Canvas won't import `Final Score of 5 (4711)`")
                                                          && ContainsSubstring("1 has `A-`, and Canvas may drop"));
}

TEST_CASE("what the manual tells an instructor to type, grades a class of sixty as it's kept") {
    if (sanitized) SKIP("the compiler there has other words");
    const OwnFolder folder{"sixty XXXXXX"};
    REQUIRE(run({CLASS_OF_SIXTY, COURSE_ROOT, folder.path.string()}).code == 0);
    fs::copy(folder.path / "canvas.zip", folder.path / "submissions.zip");
    fs::copy(folder.path / "canvas.csv", folder.path / "grades.csv");
    write_file(folder.path / "course", "#!/bin/sh\nunset DISPLAY WAYLAND_DISPLAY\nCOURSE_ROOT='" COURSE_ROOT
                                       "' COURSE_BUILD='" COURSE_BUILD "' NO_COLOR=1 exec '" COURSE_TOOL "' \"$@\"\n");
    fs::permissions(folder.path / "course", fs::perms::owner_all);
    const auto type = [&](const std::string &line) {
        const Finished done = run({"sh", "-c", line}, {.deadline = 300, .folder = folder.path});
        INFO(line << '\n' << done.out << done.err);
        CHECK(done.code == 0);
        return done.out;
    };
    const auto kept = [](const std::string &name) {
        return read_file(fs::path{COURSE_ROOT} / "tests" / "class" / name);
    };
    const std::string manual = read_file(COURSE_ROOT "/docs/instructors.md");
    std::vector<std::string> said;
    for (const Line &line : split_lines(between(manual, "```sh\n", "```").value())) {
        std::string words{line.text};
        replace_all(words, "submissions.zip", "submissions.zip --seed 2026");
        if (!words.empty()) said.push_back(type(words));
    }
    REQUIRE(said.size() == 6);
    CHECK_THAT(said[0], ContainsSubstring("  row 1002 (Ahorn, Bero) would change\n"));
    CHECK(said[1].substr(0, said[1].find("See ./course open")) == kept("sixty_canvas.txt"));
    CHECK_THAT(said[2], ContainsSubstring("g5/report.html"));
    CHECK_THAT(said[3],
               ContainsSubstring("1 judged now") && ContainsSubstring("when you check only which way it moves"));
    CHECK_THAT(said[4], ContainsSubstring("double normal_force("));
    CHECK_THAT(said[5], ContainsSubstring("Nobody's points have changed"));
    CHECK(read_file(folder.path / "g5" / "grades.csv") == kept("sixty_canvas.csv"));

    std::string texts;
    const Archive feedback{folder.path / "g5" / "feedback.zip"};
    CHECK(feedback.entries().size() == 60);
    for (const Archive::Entry &entry : feedback.entries()) {
        const std::string text = feedback.read(entry, 100000);
        CHECK_THAT(text, !ContainsSubstring(folder.path.string()) && !ContainsSubstring("./course"));
        if (contains_any(entry.name, {"_1023_", "_105", "_1060_"})) texts += "== " + entry.name + '\n' + text + '\n';
    }
    replace_all(texts, feedback_hash(texts), "TESTS");
    CHECK(without_lines(texts) == kept("sixty_feedback.txt"));

    const std::string moodle = type("./course grade 5 moodle.zip --gradebook moodle.csv --out m5 --merge g5");
    CHECK(moodle.substr(0, moodle.find("See ./course open")) == kept("sixty_moodle.txt"));
    CHECK_THAT(said[1], ContainsSubstring("\nCan't read feedback.zip in Canvas (2): 1049 (Canvas calls it "
                                          "05_inclined_planes.zip), 1060 (Canvas drops it, for there's no file that "
                                          "it's about). Paste into a comment for each what ./course grade --out g5 "
                                          "--only 1049 prints.\n"));
    CHECK_THAT(moodle,
               ContainsSubstring("\nUpload grades.csv first: after feedback.zip, Moodle passes over all its rows.\n"));
    CHECK_THAT(type("./course grade --out m5 --again"),
               ContainsSubstring("\nMoodle passes over rows that it has changed")
                   && ContainsSubstring("or name a fresh one with --gradebook.\n"));
    CHECK(read_file(folder.path / "m5" / "grades.csv") == kept("sixty_moodle.csv"));
}
