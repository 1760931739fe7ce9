// JudgeOptions: one verdict for each test, what stopped a compiler, and whose fault it was.

#include "base/kernel.hpp"
#include "base/process.hpp"
#include "check/answer.hpp"
#include "check/build_config.hpp"
#include "check/compiling.hpp"
#include "check/diagnosis.hpp"
#include "check/judge.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <csignal>
#include <thread>

using namespace course;
namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string passed(const std::string &test) { return to_line({.exercise = "7.1", .test = test}); }

std::vector<Outcome> kinds(const std::string &said) {
    std::vector<Outcome> all;
    for (const Verdict &verdict : one_for_each({{"7.1", "first"}, {"7.1", "second"}}, said))
        all.push_back(verdict.kind);
    return all;
}

bool about_the_code(const std::string &printed) {
    Finished finished;
    finished.code = 1;
    return is_about_the_code(finished, printed);
}

/// What is said of a compiler that printed this and left with this exit code.
std::string stopped(const std::string &printed, int code = 1) {
    Finished finished;
    finished.code = code;
    return stopped_by_a_limit(finished, printed);
}

} // namespace

TEST_CASE("a test passes only if exactly one verdict says so") {
    const Outcome well = Outcome::passed, none = Outcome::no_verdict;
    CHECK(kinds(passed("first") + passed("second")) == std::vector{well, well});
    CHECK(kinds(passed("second") + passed("first")) == std::vector{well, well}); // in the order of the list
    CHECK(kinds(passed("first")) == std::vector{well, none});
    CHECK(kinds("") == std::vector{none, none});
    CHECK(kinds(passed("first") + passed("second") + passed("first")) == std::vector{none, well});
    CHECK(kinds(passed("first") + passed("second") + passed("third")) == std::vector{well, well, none});
    CHECK(kinds(passed("first") + passed("second").substr(0, 40)) == std::vector{well, none});
    CHECK(kinds(passed("first") + "{\"kind\": 7}\n[]\n" + passed("second")) == std::vector{well, well});
    CHECK_FALSE(JudgeResult{}.all_passed());
}

TEST_CASE("bad input that is accepted because a line of the stub is gone: the verdict shows that line") {
    const std::string stub = "// 2.1 core\nint f(int x) {\n    require_cart(x);\n    throw course::NotYet{\"\"};\n}\n"
                             "// 2.2 core\nint g(int x) {\n    require_cart(x);\n    throw course::NotYet{\"\"};\n}\n"
                             "// 2.3 core\nint h(int x) {\n    throw course::NotYet{\"\"};\n}\n";
    const std::string gone = "int f(int x) { return x; }\nint g(int x) {\n\trequire_cart(x);\n\treturn x;\n}\n";
    CHECK_THAT(explain_accepted(gone, stub, "2.1"), ContainsSubstring("put `require_cart(x);` back"));
    CHECK(explain_accepted(stub, stub, "2.1").empty());
    CHECK(explain_accepted("", stub, "2.3").empty()); // the lesson of this one is to refuse
}

TEST_CASE("a compiler that a limit has stopped is told from one that found an error") {
    CHECK_THAT(stopped("c++: internal compiler error: CPU time limit exceeded signal terminated program cc1plus\n", 4),
               ContainsSubstring("never end"));
    CHECK_THAT(stopped("", 128 + SIGXCPU), ContainsSubstring("never end"));
    CHECK_THAT(stopped("c++: internal compiler error: File size limit exceeded signal terminated program as\n", 4),
               ContainsSubstring("256 MB"));
    CHECK_THAT(stopped("cc1plus: out of memory allocating 2147483664 bytes\n"), ContainsSubstring("2 GB"));
    CHECK(stopped("/x/07.cpp:3:5: error: nothing\n").empty());
    CHECK(stopped("", 0).empty());
}

TEST_CASE("what doesn't say where the code is wrong isn't taken for the code's fault") {
    CHECK_FALSE(
        about_the_code("c++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n"));
    CHECK_FALSE(about_the_code("/x/07.cpp:1: fatal error: error writing to /tmp/cc.s: No space left on device\n"));
    CHECK_FALSE(about_the_code("collect2: error: ld terminated with signal 9 [Killed]\n"));
    CHECK_FALSE(about_the_code("/usr/bin/ld.gold: fatal error: subject: No space left on device\n"
                               "collect2: error: ld returned 1 exit status\n"));
    CHECK_FALSE(about_the_code("cc1plus: fatal error: PCH allocation failure\n"));
    CHECK_FALSE(about_the_code("as: x.o: No space left on device\n"));
    CHECK_FALSE(about_the_code(""));
    CHECK(about_the_code("/x/07.cpp:3:5: error: nothing\n"));
    CHECK(about_the_code("/x/07.cpp:3:5: fatal error: x.hpp: No such file or directory\n"));
    CHECK(about_the_code("07.cpp:(.text+0x5): undefined reference to `f()'\n"));
}

namespace {

/// What a check of our solution comes to where a tool of the compiler's stops before its work is done.
Finished check_where(const std::string &spoiled) {
    const Workspace workspace{.root = COURSE_ROOT, .build = COURSE_BUILD};
    const std::string solution = workspace.solution(workspace.section("5"));
    return run({"sh", "-c",
                spoiled
                    + "; COURSE_ROOT='" COURSE_ROOT "' COURSE_BUILD='" COURSE_BUILD "' NO_COLOR=1 exec '" COURSE_TOOL
                      "' check 5 --file '"
                    + solution + "'"});
}

} // namespace

TEST_CASE("where no file could be compiled, nobody's code is to blame") {
    if (sanitized) SKIP("a sanitizer needs terabytes of addresses");
    const Finished little = check_where("ulimit -v 180000");
    INFO(little.out << little.err);
    CHECK(little.code == machine_trouble);
    CHECK_THAT(little.err, ContainsSubstring("untouched exercise") || ContainsSubstring("type `ulimit -v unlimited`"));
    CHECK_THROWS_AS(require_room("ld: subject: No space left on device", "/proc"), EnvironmentError); // where none is
    CHECK_NOTHROW(require_room("something else", "/proc"));
}

TEST_CASE("what keeps the tests themselves from running is the machine's") {
    if (sanitized) SKIP("a sanitizer needs files of its own");
    if (std::thread::hardware_concurrency() < 2) SKIP("one process runs all tests here, and has the one file it needs");
    const auto tested =
        run({"sh", "-c", "exec 3>&-; ulimit -n 4; exec \"$0\" /bin/true --json", // files: one is left for two
             COURSE_BUILD "/tests/07_segment_intersection"});
    CHECK(tested.code == machine_trouble);
    CHECK_THAT(tested.err, ContainsSubstring("cannot be kept"));
    CHECK(tested.out.empty());
}

TEST_CASE("no file can put its own mistake down to the machine or to a limit") {
    CHECK(stopped("/x/07.cpp:3:5: error: #error No space left on device\n").empty());
    CHECK(stopped("g++:1:15: error: static assertion failed: \n"
                  "g++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n")
              .empty());
    CHECK(stopped("/tmp/x.s:25: Error: out of memory\n").empty());
    CHECK(stopped("07.cpp:(.text+0x5): undefined reference to `No space left on device'\n").empty());
}

TEST_CASE("a file may include only the system, Eigen and chapters/, whatever the path looks like") {
    const auto elsewhere = [](const std::string &rule) {
        const auto found =
            included_from_elsewhere(rule, "/home/a b/07.cpp", "/scratch", {"/usr/include", "/course/chapters"});
        return found ? found->string() : "";
    };
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp /usr/include/math.h \\\n /course/chapters/07_x/x.hpp\n").empty());
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp /usr/include/../../dev/zero\n") == "/dev/zero");
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp /course/chapters/../solutions/07.cpp\n") == "/course/solutions/07.cpp");
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp \\\n /usr/included\n") == "/usr/included");
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp notes.txt\n") == "/scratch/notes.txt");
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp /n/\\#\\ $$.hpp\n") == "/n/# $.hpp");
    CHECK(elsewhere("x.o: /home/a\\ b/07.cpp \\\n \\\n /home/a\\ b/more.hpp") == "/home/a b/more.hpp");
}

TEST_CASE("nothing that the course has built can be taken into a student's program, nor its pages and solutions") {
    if (!protection_of_this_kernel().files) SKIP("this kernel has no Landlock, or a sanitizer is in the way");
    const Workspace workspace{.root = COURSE_ROOT, .build = COURSE_BUILD};
    const Section section = workspace.section("2"); // which builds on the first
    const BuildConfig tools = build_config(workspace, section);
    std::vector<fs::path> files{tools.server,
                                tools.missing,
                                tools.ours,
                                tools.earlier.at(0),
                                "../02_momentum_ours.o",
                                workspace.test_program(section),
                                workspace.solution(section),
                                workspace.root / "chapters/02_momentum/README.md"};
    if (tools.quick) files.emplace_back(tools.quick_link.at(0));
    for (const fs::path &file : files) {
        INFO(file);
        const std::string text = "#include \"momentum.hpp\"\nasm(\".pushsection .rodata\\n.incbin \\\"" + file.string()
                                 + "\\\"\\n.popsection\");\n";
        const auto why = judge(workspace, section, "02.cpp", text, {}).unbuilt;
        CHECK((why && why->sentence == explain_unopened()));
    }
}
