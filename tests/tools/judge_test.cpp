// Judging: one verdict for each test, what stopped a compiler, and whose fault it was.

#include "ground/kernel.hpp"
#include "ground/process.hpp"
#include "loop/answer.hpp"
#include "loop/compiling.hpp"
#include "loop/diagnosis.hpp"
#include "loop/judge.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <csignal>
#include <thread>

using namespace course;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string passed(const std::string &test) { return to_line({.exercise = "7.1", .test = test}); }

std::vector<Kind> kinds(const std::string &said) {
    std::vector<Kind> all;
    for (const Verdict &verdict : one_for_each({{"7.1", "first"}, {"7.1", "second"}}, said))
        all.push_back(verdict.kind);
    return all;
}

/// What is said of a compiler that printed this and left with this exit code.
std::string stopped(const std::string &printed, int code = 1) {
    Finished finished;
    finished.code = code;
    return stopped_by_a_limit(finished, printed);
}

} // namespace

TEST_CASE("a test passes only if exactly one verdict says so") {
    const Kind well = Kind::passed, none = Kind::no_verdict;
    CHECK(kinds(passed("first") + passed("second")) == std::vector{well, well});
    CHECK(kinds(passed("second") + passed("first")) == std::vector{well, well}); // in the order of the list
    CHECK(kinds(passed("first")) == std::vector{well, none});
    CHECK(kinds("") == std::vector{none, none});
    CHECK(kinds(passed("first") + passed("second") + passed("first")) == std::vector{none, well});
    CHECK(kinds(passed("first") + passed("second") + passed("third")) == std::vector{well, well, none});
    CHECK(kinds(passed("first") + passed("second").substr(0, 40)) == std::vector{well, none});
    CHECK(kinds(passed("first") + "{\"kind\": 7}\n[]\n" + passed("second")) == std::vector{well, well});
    CHECK_FALSE(Judgement{}.all_passed());
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

TEST_CASE("what the machine did to a compiler is no verdict on the file") {
    CHECK_THROWS_AS(stopped("c++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n"),
                    MachineTrouble);
    CHECK_THROWS_AS(stopped("", 128 + SIGKILL), MachineTrouble);
    CHECK_THROWS_AS(stopped("/x/07.cpp:1: fatal error: error writing to /tmp/cc.s: No space left on device\n"),
                    MachineTrouble);
    CHECK_THROWS_AS(stopped("as: x.o: No space left on device\n"), MachineTrouble);
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
    CHECK(stopped("/x/07.cpp:1:10: fatal error: error writing to x: No space left on device: No such file or "
                  "directory\n")
              .empty());
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
