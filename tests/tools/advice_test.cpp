// What `check` adds to a compiler's words, with the words that GCC and Clang have for slips.cpp, where they are.

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "check/diagnosis.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace course;

namespace {

/// What a student reads of the first error or warning in this line.
std::string said_of_line(const std::string &printed, const std::string &file, int number) {
    const std::string place = file + ':' + std::to_string(number) + ':';
    std::size_t at = printed.find(place);
    while (at != printed.npos) {
        const std::string line = printed.substr(at, printed.find('\n', at) - at);
        if (contains(line, ": warning: ")) {
            const auto warnings = find_warnings(printed.substr(at), file, "it");
            return warnings.empty() ? "" : warnings.front();
        }
        if (contains(line, "error: ") || contains(line, "required from")) break;
        const std::size_t error = printed.rfind(": error: ", at); // Clang: a note of an error in another file
        if (contains(line, "requested here") && error != printed.npos) {
            at = printed.rfind('\n', error) + 1;
            break;
        }
        at = printed.find(place, at + 1);
    }
    return at == printed.npos ? "" : diagnose_compiler(printed.substr(at), file, "it").sentence;
}

/// Whether this ends in one of the sentences of slips.cpp.
bool ends_with_advice(const std::string &said, const std::string &slips) {
    for (const Line &line : split_lines(slips)) {
        const std::size_t comment = line.text.find("// ");
        if (comment != line.text.npos && said.ends_with(line.text.substr(comment + 3))) return true;
    }
    return false;
}

} // namespace

TEST_CASE("notes of any length cost no more than others do") {
    std::string printed =
        "x.cpp:1:1: error: ‘f’ was not declared in this scope\nx.cpp:1:1: note: did you forget to ‘#include <";
    for (int i = 0; i < 300'000; ++i) printed += i % 100 == 0 ? "\nx.cpp:1:1: note: n" : "n";
    CHECK(!diagnose_compiler(printed, "x.cpp", "it").sentence.empty());
}

TEST_CASE("a compiler's guess at a name of one or two letters is left out: any other short name is as near") {
    const auto said = [](const std::string &words) {
        return diagnose_compiler("/x/01.cpp:3:5: error: " + words + "\n    3 |  y\n      |  ^\n", "/x/01.cpp", "01.cpp")
            .sentence;
    };
    CHECK(said("‘x0’ was not declared in this scope; did you mean ‘y0’?")
              .starts_with("'x0' was not declared in this scope. If x0 is a letter of a formula, "));
    CHECK(said("use of undeclared identifier 'v'; did you mean 'a'?")
              .starts_with("use of undeclared identifier 'v'. If v is a letter of a formula, "));
    const std::string useful = "'velocty' was not declared in this scope; did you mean 'velocity'?";
    CHECK(said(useful) == useful);
}

TEST_CASE(
    "what the library calls a value is left out of a compiler's words: the student's own line stands below them") {
    const auto said = [](const std::string &value) {
        return diagnose_compiler("/x/08.cpp:3:5: error: could not convert ‘" + value
                                     + "’ from ‘x::Ball’ to ‘x::Pair’\n",
                                 "/x/08.cpp", "08.cpp")
            .sentence;
    };
    const std::string advice =
        " from 'x::Ball' to 'x::Pair'. A Pair is wanted here, not a Ball: put its fields in braces, "
        "in the order of the header.";
    CHECK(said("x::Ball{Eigen::MatrixBase<Derived>::norm()}") == "could not convert" + advice);
    CHECK(said(std::string(4000, 'b')) == "could not convert" + advice);
    CHECK(said("ball") == "could not convert 'ball'" + advice);
}

TEST_CASE("a header of a later C++, and a library that isn't linked, are told with what to do instead") {
    const auto said = [](const std::string &words) {
        return diagnose_compiler("/x/04.cpp:1:10: fatal error: " + words + "\n", "/x/04.cpp", "04.cpp").sentence;
    };
    const std::string print = ": print with std::cout, and #include <iostream>.";
    CHECK(said("format: No such file or directory") == "This compiler doesn't have <format> yet" + print);
    CHECK(said("'print' file not found") == "This compiler doesn't have <print> yet" + print);
    CHECK(said("generator: No such file or directory") == "This compiler doesn't have <generator> yet: do without it.");
    CHECK(said("formats.hpp: No such file or directory").starts_with("A check can't open this file"));
    CHECK(diagnose_linker("x.o: undefined reference to `fmt::v9::vprint(fmt::v9::basic_string_view<char>)'\n", "04.cpp",
                          "4")
              .sentence
          == "A check doesn't link the library fmt" + print);
}

TEST_CASE("an else behind a missing } is explained, whatever the compiler calls it") {
    for (const char *words : {"expected ‘}’ before ‘else’", "expected expression"})
        CHECK(diagnose_compiler("/x/02.cpp:4:5: error: " + std::string{words} + "\n    else x = 2;\n    ^\n",
                                "/x/02.cpp", "02.cpp")
                  .sentence.ends_with(". Is a } missing above this line?"));
}

TEST_CASE("what GCC says of a vector whose parts are gone is said in words") {
    const std::string file = "/x/11.cpp", place = file + ":97:29: warning: ";
    const std::string parts = " + offsetof(Eigen::Matrix<double, 2, 1>, <unnamed>))’ may be used uninitialized\n";
    CHECK(find_warnings(sanitize(place + "‘*(__m128d*)((char*)&<unnamed>" + parts), file, "11.cpp")
          == std::vector<std::string>{
              "11.cpp:97: This vector's parts may be gone by now: if it's declared with auto, write Vec2 instead."});
    CHECK(find_warnings(sanitize(place + "‘*(__m128d*)((char*)&v" + parts), file, "11.cpp")
              .at(0)
              .ends_with("uninitialized"));
}

TEST_CASE("a type that the compiler also calls double is shown as double") {
    for (const char *type : {"‘Eigen::GenericNumTraits<double>::Real’ {aka ‘double’}",
                             "'typename ScalarBinaryOpTraits<double, double>::ReturnType' (aka 'double')"})
        CHECK(diagnose_compiler("/x/06.cpp:3:5: error: conversion from " + std::string{type} + " to 'Vec2'\n",
                                "/x/06.cpp", "06.cpp")
                  .sentence.starts_with("conversion from 'double' to 'Vec2'"));
}

TEST_CASE("the element of a list is shown as its whole type, also if that has elements itself") {
    const auto said = [](const std::string &element, const std::string &space) {
        return diagnose_compiler("/x/11.cpp:3:5: error: no match for ‘operator=’ (operand types are ‘const "
                                 "__gnu_cxx::__alloc_traits<std::allocator<"
                                     + element + space + ">, " + element + space + ">::value_type’ and ‘int’)\n",
                                 "/x/11.cpp", "11.cpp")
            .sentence;
    };
    for (const char *element : {"double", "std::optional<x::Spark>", "std::vector<std::pair<int, int> >"})
        for (const char *space : {"", " "})
            CHECK(said(element, space)
                      .starts_with("no match for 'operator=' (operand types are 'const " + std::string{element}
                                   + "' and 'int')"));
}

TEST_CASE("the student's line is shown, also if the compiler has shown it before, or shows a line of the library") {
    const std::string file = "/x/08.cpp", place = file + ":2:5: ", text = "first line\n    elseif (t > 2) t = 2;\n";
    using Lines = std::vector<std::string>;
    const Lines line{"    2 |     elseif (t > 2) t = 2;"};
    const std::string again = place + "warning: this\n    2 |     elseif (t > 2) t = 2;\n      |     ^~~~~~\n" + place
                              + "error: ‘elseif’ was not declared in this scope\n" + file + ":3:5: error: another\n";
    CHECK(diagnose_compiler(again, file, "08.cpp", text).printed == line);
    const std::string gap = "    2 |  t = a[i] - b[i].norm();\n      |         ^\n";
    const std::string unshown = place + "warning: of i\n" + gap + place
                                + "error: no match for ‘operator-’ (operand types are ‘const Vec2’ and ‘double’)\n";
    CHECK(diagnose_compiler(unshown, file, "08.cpp", text)
              .sentence.ends_with("(a - b).norm().")); // of the warning's line
    const std::string library =
        place + "  required from here\n/usr/include/map:9:5: error: no match\n    9 | x\n      | ^\n";
    CHECK(diagnose_compiler(library, file, "08.cpp", text).printed == line);
    CHECK(diagnose_compiler(file + ":4:5: error: behind the end\n", file, "08.cpp", text).printed == Lines{});
    const std::string shown = place + "error: this\n    2 |     elseif\n      |     ^\n";
    CHECK(diagnose_compiler(shown, file, "08.cpp", text).printed == Lines{"    2 |     elseif", "      |     ^"});
}

TEST_CASE("the slips that are made most are explained, whatever the compiler calls them") {
    const std::string compiler = GENERATE("g++", "clang++");
    CAPTURE(compiler);
    if (run({"sh", "-c", "command -v " + compiler}).code != 0) SKIP("there is no " << compiler << " here");
    const std::string file = COURSE_ROOT "/tests/tools/slips.cpp";
    const std::string many = compiler == "g++" ? "-fmax-errors=0" : "-ferror-limit=0";
    const auto compiled =
        run({compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wshadow", "-Wfloat-conversion",
             "-fdiagnostics-color=never", many, "-I" COURSE_ROOT "/chapters", "-isystem", COURSE_EIGEN, file});
    const std::string printed = sanitize(compiled.err);
    int number = 0, explained = 0;
    const std::string text = read_file(file);
    for (const Line &line : split_lines(text)) {
        ++number;
        const std::size_t comment = line.text.find("// ");
        if (comment == line.text.npos || trim(line.text.substr(0, comment)).empty()) continue;
        std::string said = said_of_line(printed, file, number);
        const std::string want{line.text.substr(comment + 3)};
        if (want.starts_with("Look at the end") && compiler == "clang++") // which stands in the gap itself
            continue;
        CAPTURE(number, said);
        CHECK_FALSE(said.empty());
        if (want == "nothing") CHECK_FALSE(ends_with_advice(said, text));
        else CHECK(said.ends_with(want));
        ++explained;
    }
    CHECK(explained > 40);
}
