// `course dev weave` on a book of one small chapter, made anew for each test and spoilt in one way.

#include "base/files.hpp"
#include "base/text.hpp"
#include "book/chapter.hpp"
#include "book/contents.hpp"
#include "book/glossary.hpp"
#include "book/links.hpp"
#include "book/markdown.hpp"
#include "book/prerequisites.hpp"
#include "check/catalogue.hpp"
#include "commands/commands.hpp"
#include "own_folder.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <chrono>
#include <fstream>
#include <iostream>
#include <sstream>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using namespace course;
namespace fs = std::filesystem;

namespace {

constexpr const char *header = R"(#pragma once
#include "../course.hpp"

/// Section 7.
namespace wall {
using course::Vec2;

//> A wall
/// Where it stands.
struct Wall {
    Vec2 start;

    Vec2 end;
};

//> The exercises
namespace subject {
COURSE_EXERCISE("7.1", core, wall, length, "wall", "m")
} // namespace subject
//>
} // namespace wall
)";

constexpr const char *solution_code = R"(#include "wall.hpp"

namespace wall {
//> Solution: a helper
static double square(double x) { return x * x; }

//> Solution 7.1: a length
double length(const Wall &wall) { return (wall.end - wall.start).norm(); }

//> Solution 7.10: not this one
double other();
//>
}
)";

constexpr const char *chapter = R"(# 7 Wall

Plan a minute.

```cpp
//> A wall
/// Where it stands.
struct Wall {
    Vec2 start;

    Vec2 end;
};
```

```cpp
//> The exercises
namespace subject {
COURSE_EXERCISE("7.1", core, wall, length, "wall", "m")
} // namespace subject
```

```cpp
//> Main
int main() {}
```

```console
$ ./course run 7
length 5
```

```console
$ ./course check 7
all of it is up to you
```

![A wall.](../../plots/07_wall_path.svg)

```gnuplot
#> Figure: a path
plot ARG1
```

| | exercise | tier | about |
|:--|:--|:--|--:|
| 7.1 | `length`: a wall's | core | 5 min |

<details>
<summary>7.1, a hint: where to begin</summary>

Pythagoras: √(Δx² + Δy²), see `std::hypot` and [the idea](#7-wall).
</details>

<details>
<summary>Our solution</summary>

```cpp
//> Solution: a helper
static double square(double x) { return x * x; }
```

```cpp
//> Solution 7.1: a length
double length(const Wall &wall) { return (wall.end - wall.start).norm(); }
```

```cpp
//> Solution 7.10: not this one
double other();
```
</details>

<!-- budget: first box 100, since this is a chapter for tests -->
<!-- budget: listings 999, since this is a chapter for tests -->
)";

struct Told {
    int code;
    std::string text; ///< what it printed, or its complaint
};

/// A checkout with one section, 07_wall, and its built program; removed at the end.
class Book {
  public:
    Book() {
        workspace.root = fs::canonical(folder.path);
        workspace.build = workspace.root / "build";
        put("CMakeLists.txt", "section(07_wall)\n");
        put("chapters/07_wall/README.md", chapter);
        put("chapters/07_wall/wall.hpp", header);
        put("chapters/07_wall/main.cpp", "#include \"wall.hpp\"\n\n//> Main\nint main() {}\n");
        put("solutions/07_wall.cpp", solution_code);
        put("tests/07_wall/tests.cpp", "#include \"wall.hpp\"\nconstexpr double not_shown = 0;\n");
        put("plots/07_wall_path.gp", "#> Figure: a path\nplot ARG1\n");
        put("plots/07_wall_path.svg", "<svg/>");
        program("echo length 5");
    }

    void put(const fs::path &file, std::string_view text) const {
        fs::create_directories((workspace.root / file).parent_path());
        std::ofstream{workspace.root / file, std::ios::binary} << text; // unlike write_file, doesn't wait for the disk
    }
    std::string text(const fs::path &file = "chapters/07_wall/README.md") const {
        return read_file(workspace.root / file);
    }

    /// Replaces the one place where `was` stands.
    void edit(const fs::path &file, const std::string &was, const std::string &is) const {
        std::string all = text(file);
        REQUIRE(all.find(was) != all.npos);
        REQUIRE(all.find(was) == all.rfind(was));
        put(file, all.replace(all.find(was), was.size(), is));
        renew_program();
    }
    void edit_chapter(const std::string &was, const std::string &is) const {
        edit("chapters/07_wall/README.md", was, is);
    }

    /// The section's "program" is a line of shell.
    void program(const std::string &line) {
        script = "#!/bin/sh\n" + line + '\n';
        renew_program();
    }

    /// Makes the program newer than its code, as a build leaves it.
    void renew_program() const {
        const fs::path file = workspace.build / "chapters/07_wall";
        put(file, script);
        fs::permissions(file, fs::perms::owner_all);
        fs::last_write_time(file, fs::file_time_type::clock::now());
    }

    Told weave(const std::string &arguments = "") const {
        CLI::App app;
        add_weave(app, workspace);
        std::ostringstream out;
        std::streambuf *const terminal = std::cout.rdbuf(out.rdbuf());
        int code = all_well;
        try {
            app.parse("weave " + arguments);
        } catch (const ExitRequest &leave) {
            code = leave.code;
        } catch (const UserError &complaint) {
            code = bad_input;
            out << complaint.what();
        }
        std::cout.rdbuf(terminal);
        return {code, out.str()};
    }
    Told check() const { return weave("--check"); }

    OwnFolder folder{"a book XXXXXX"}; // blanks in paths are all right
    Workspace workspace;
    Section section{"07_wall"};

  private:
    std::string script; ///< the program
};

std::string replaced(std::string text, const std::string &was, const std::string &is) {
    replace_all(text, was, is);
    return text;
}

constexpr const char *wall_listing =
    "```cpp\n//> A wall\n/// Where it stands.\nstruct Wall {\n    Vec2 start;\n\n    Vec2 end;\n};\n```\n";

} // namespace

TEST_CASE("a book that is as the code says passes, and weaving leaves its file alone") {
    const Book book;
    const auto date = fs::last_write_time(book.workspace.chapter(book.section));

    const Told told = book.check();
    CHECK(told.text == "1 chapter, 7 listings, 1 output: as the code says\n");
    CHECK(told.code == all_well);
    CHECK(book.weave().text == told.text);
    CHECK(book.weave("7").code == all_well);
    CHECK(book.text() == chapter);
    CHECK(fs::last_write_time(book.workspace.chapter(book.section)) == date);
}

TEST_CASE("edited text is found, and woven back") {
    const Book book;
    book.edit_chapter("/// Where it stands.", "/// Where it lies.");

    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK(told.text
          == "chapters/07_wall/README.md:7: \"A wall\" differs here from chapters/07_wall/wall.hpp:9.\n"
             "To keep the code as it is now, type ./course dev weave, which writes it into the book; to bring back how "
             "it "
             "was, type git restore chapters/07_wall/wall.hpp\n");
    CHECK(book.weave().text == "woven: chapters/07_wall/README.md, 1 block changed\n");
    CHECK(book.text() == chapter);
}

TEST_CASE("any edit inside a listing is found: a line less, a line more, a blank at an end, the mark itself") {
    const Book book;
    const auto [was, is] =
        GENERATE(std::pair{"    Vec2 start;\n", ""}, std::pair{"    Vec2 end;\n};\n", "    Vec2 end;\n};\n\n"},
                 std::pair{"int main() {}", "int main() {} "}, std::pair{"//> A wall", " //>  A wall"},
                 std::pair{"#> Figure: a path", "//> Figure: a path"}, std::pair{"length 5\n", "length 5\n\n"},
                 std::pair{"length 5\n", ""}, std::pair{"length 5\n", "length 5 \n"});
    book.edit_chapter(was, is);

    CHECK(book.check().code == something_to);
    CHECK(book.weave().code == all_well);
    CHECK(book.text() == chapter);
}

TEST_CASE("edited code is found, and woven in") {
    const Book book;
    book.edit("chapters/07_wall/wall.hpp", "    Vec2 start;\n", "    Vec2 start; ///< [m]\n    double width{};\n");

    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK_THAT(
        told.text,
        StartsWith("chapters/07_wall/README.md:9: \"A wall\" differs here from chapters/07_wall/wall.hpp:11.\n"));
    CHECK(book.text() == chapter); // a check changes nothing
    CHECK(book.weave().code == all_well);
    CHECK(book.text() == replaced(chapter, "    Vec2 start;\n", "    Vec2 start; ///< [m]\n    double width{};\n"));
    CHECK(book.check().code == all_well);
}

TEST_CASE("a struct is shown without its COURSE_FIELDS, which beginners needn't read") {
    const Book book;
    book.edit("chapters/07_wall/wall.hpp", "    Vec2 end;\n",
              "    Vec2 end;\n    COURSE_FIELDS(\"m, m\", start, end)\n");
    CHECK(book.check().code == all_well);
    CHECK(book.text() == chapter);
}

TEST_CASE("both ways are told once, whatever was changed, and in how many files") {
    Book book;
    book.edit("chapters/07_wall/wall.hpp", "    Vec2 start;\n", "    Vec2 begin;\n");
    book.edit("chapters/07_wall/main.cpp", "int main() {}", "int main() { return 0; }");
    book.program("echo length 6");

    const std::string told = book.check().text;
    CHECK(std::count(told.begin(), told.end(), '\n') == 4); // two listings, an output, and what to do
    CHECK_THAT(told, EndsWith("type git restore chapters/07_wall/main.cpp chapters/07_wall/wall.hpp\n"));
}

TEST_CASE("a chunk that no chapter shows is found") {
    const Book book;
    book.edit_chapter(wall_listing, "");

    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK_THAT(
        told.text,
        StartsWith("chapters/07_wall/wall.hpp:8: the chunk \"A wall\" is not shown in chapters/07_wall/README.md;"));
    CHECK(book.weave().code == something_to);
}

TEST_CASE("header, solution and frame loops must be shown; what prints, tests and draws may be") {
    const Book book;
    const auto [file, title, must] = GENERATE(
        std::tuple{"chapters/07_wall/wall.hpp", "New", true}, std::tuple{"solutions/07_wall.cpp", "New", true},
        std::tuple{"chapters/07_wall/main.cpp", "The frame loop: new", true},
        std::tuple{"chapters/07_wall/main.cpp", "New", false}, std::tuple{"chapters/07_wall/bench.cpp", "New", false},
        std::tuple{"tests/07_wall/tests.cpp", "New", false}, std::tuple{"plots/07_wall_path.gp", "New", false},
        std::tuple{"tests/07_wall/peer.txt", "New", false});
    const std::string path = file;
    const bool is_code = path.ends_with("pp");
    book.put(path, (fs::exists(book.workspace.root / path) ? book.text(path) : "") + (is_code ? "//> " : "#> ") + title
                       + (is_code ? "\nint x;\n" : "\nreset\n"));
    book.renew_program();

    const Told told = book.check();
    INFO(told.text);
    CHECK(told.text.starts_with(path) == must);
    CHECK(contains(told.text, "is not shown") == must);
}

TEST_CASE("a chunk that is shown twice is found") {
    const Book book;
    book.edit_chapter("Plan a minute.\n", "Plan a minute.\n\n```cpp\n//> Main\nint main() {}\n```\n");

    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK(told.text
          == "chapters/07_wall/README.md:28: the chunk \"Main\" is shown in line 6 already; keep one of the two.\n");
}

TEST_CASE("a fence without a chunk is found, the nearest title is offered, and weaving leaves it alone") {
    const Book book;
    book.edit_chapter("Plan a minute.\n", "Plan a minute.\n\n```cpp\n//> A wal\nmy text\n```\n");
    const std::string before = book.text();

    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK_THAT(told.text, StartsWith("chapters/07_wall/README.md:6: there is no chunk called \"A wal\";")
                              && ContainsSubstring("`A wall`"));
    CHECK(book.weave().code == something_to);
    CHECK(book.text() == before);
}

TEST_CASE("a mark without a title, a title given twice, and a chunk without code are found") {
    const Book book;
    SECTION("no title") {
        book.edit_chapter("//> Main\n", "//>\n");
        CHECK_THAT(book.check().text, ContainsSubstring("README.md:23: this mark has no title;"));
    }
    SECTION("twice in the code") {
        book.edit("chapters/07_wall/main.cpp", "//> Main\n", "//> A wall\n");
        CHECK_THAT(book.check().text,
                   ContainsSubstring(
                       "main.cpp:3: there is a chunk called \"A wall\" in chapters/07_wall/wall.hpp:8 already;"));
    }
    SECTION("no code") {
        book.edit("chapters/07_wall/main.cpp", "//> Main\n", "//> Nothing\n\n//> Main\n");
        CHECK_THAT(book.check().text, ContainsSubstring("main.cpp:3: the chunk \"Nothing\" is empty;"));
    }
}

TEST_CASE("code above the first mark is found; includes, namespaces and comments do not count") {
    const Book book;
    SECTION("C++") {
        book.edit("chapters/07_wall/main.cpp", "//> Main\n",
                  "/* two\nlines */\n// one\nusing namespace wall;\nint hidden;\n//> Main\n");
        CHECK(book.check().text
              == "chapters/07_wall/main.cpp:7: this code is above the first mark, so no chapter can show it; put "
                 "a line "
                 "`//> Title` above it, or the same without a title if it is to stay out.\n");
    }
    SECTION("a file without any mark") {
        book.put("plots/07_wall_more.gp", "# comment\n\nplot ARG1\n");
        CHECK_THAT(book.check().text, ContainsSubstring("plots/07_wall_more.gp:3: this code is above the first mark"));
    }
    SECTION("behind a bare mark it may be") {
        book.edit("chapters/07_wall/main.cpp", "//> Main\n", "//>\nint hidden;\n//> Main\n");
        CHECK(book.check().code == all_well);
    }
}

TEST_CASE("a fence in a quote, a fold, a list, or several of them keeps the prefix of its lines") {
    const Book book;
    const auto [name, before, first, others, after] =
        GENERATE(std::tuple{"quote", "> In print.\n>\n", "> ", "> ", ""},
                 std::tuple{"narrow quote", "> In print.\n>\n", ">", ">", ""},
                 std::tuple{"fold", "<details>\n<summary>More</summary>\n\n", "", "", "</details>\n"},
                 std::tuple{"list", "- one\n", "- ", "  ", ""}, std::tuple{"numbers", "", "12. ", "    ", ""},
                 std::tuple{"below a number", "12. text\n\n", "    ", "    ", ""},
                 std::tuple{"quote in list", "", "- > ", "  > ", ""},
                 std::tuple{"list in quote", "", "> - ", ">   ", ""}, std::tuple{"indented", "", "   ", "   ", ""},
                 std::tuple{"fold in list", "- x\n  <details><summary>A</summary>\n\n", "  ", "  ", "  </details>\n"});
    INFO(name);

    const auto in_container = [&, b = std::string{before}, f = std::string{first}, o = std::string{others},
                               a = std::string{after}](const std::string &listing) {
        std::string text = f + replaced(listing.substr(0, listing.size() - 1), "\n", '\n' + o) + '\n';
        return b + replaced(text, '\n' + o + '\n', '\n' + o.substr(0, o.find_last_not_of(' ') + 1) + '\n') + a;
    };
    book.edit_chapter(wall_listing, in_container("```cpp\n//> A wall\nold\n```\n"));
    CHECK(book.check().code == something_to);
    CHECK(book.weave().code == all_well);
    CHECK(book.text() == replaced(chapter, wall_listing, in_container(wall_listing)));
    CHECK(book.check().code == all_well);
}

TEST_CASE("a fence without an end is found, and its chapter is not touched") {
    const Book book;
    const auto [was, is, line] = GENERATE(
        std::tuple{"double other();\n```\n</details>\n", "double other();\n</details>\n",
                   67},                                                   // it reaches to the end of the text
        std::tuple{"    Vec2 end;\n};\n```\n", "    Vec2 end;\n};\n", 5}, // it swallows prose and the next one
        std::tuple{"length 5\n```\n", "length 5\n", 27},                  // not a listing, but it swallows one
        std::tuple{"Plan a minute.\n", "> ```cpp\n> //> A wall\n> old\n\nPlan a minute.\n", 3}, // its quote ends
        std::tuple{"Plan a minute.\n", "> ```cpp\n> //> A wall\n```cpp\n//> Main\n```\nPlan a minute.\n",
                   3}, // a fence below its quote
        std::tuple{"Plan a minute.\n", "- ```cpp\n  //> A wall\n```\nPlan\n```\n",
                   3}); // its item ends with what looks like its end
    book.edit_chapter(was, is);
    const std::string before = book.text();

    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK_THAT(told.text, StartsWith("chapters/07_wall/README.md:" + std::to_string(line) + ": this fence has no end"));
    CHECK_THAT(told.text, ContainsSubstring("; put ``` on a line of its own where its code ends."));
    const Told woven = book.weave();
    CHECK(woven.code == something_to);
    CHECK(book.text() == before);
}

TEST_CASE("a fence that Markdown cannot see is found: right below HTML, or indented by four blanks") {
    const Book book;
    SECTION("HTML") {
        book.edit_chapter("<summary>Our solution</summary>\n\n", "<summary>Our solution</summary>\n");
        CHECK_THAT(
            book.check().text,
            ContainsSubstring("README.md:56: Markdown sees no fence here, but HTML; put an empty line above it."));
    }
    SECTION("blanks") {
        book.edit_chapter(wall_listing, replaced(std::string{"\n"} + wall_listing, "\n", "\n    "));
        CHECK_THAT(book.check().text,
                   ContainsSubstring("README.md:6: Markdown sees no fence here, since it is indented by four blanks"));
    }
    SECTION("a fold without an end") {
        book.edit_chapter("[the idea](#7-wall).\n</details>\n", "[the idea](#7-wall).\n");
        CHECK_THAT(book.check().text, ContainsSubstring("README.md:48: this fold has no end; put a line `</details>`"));
    }
}

TEST_CASE("a file keeps its line ends and its byte-order mark, whatever those of the code") {
    const Book book;
    const std::string crlf = replaced(chapter, "\n", "\r\n"), mark = "\xEF\xBB\xBF";
    const std::string wanted =
        GENERATE_COPY(std::string{chapter}, crlf, mark + crlf, mark + chapter, crlf.substr(0, crlf.size() - 2));
    const bool windows_code = GENERATE(false, true);
    for (const char *file : {"chapters/07_wall/wall.hpp", "solutions/07_wall.cpp", "plots/07_wall_path.gp"})
        if (windows_code) book.put(file, mark + replaced(book.text(file), "\n", "\r\n"));
    book.put("chapters/07_wall/README.md", wanted);
    book.renew_program();

    CHECK(book.check().text == "1 chapter, 7 listings, 1 output: as the code says\n");
    book.put("chapters/07_wall/README.md",
             replaced(replaced(wanted, "it stands", "it lies"), "plot ARG1", "plot ARG2"));
    CHECK(book.weave().text == "woven: chapters/07_wall/README.md, 2 blocks changed\n");
    CHECK(book.text() == wanted);

    if (wanted.find('\r') == wanted.npos) return;
    book.edit_chapter("    Vec2 start;\r\n", "    Vec2 start;\n"); // one end is not like the others
    CHECK(book.check().code == something_to);
    CHECK(book.weave().code == all_well);
    CHECK(book.text() == wanted);
}

TEST_CASE("a code line that looks like a fence makes the chapter's fence longer") {
    const Book book;
    const auto [code, fence] =
        GENERATE(std::pair{"```", "````"}, std::pair{"   `````cpp", "``````"}, std::pair{"    ```", "````"},
                 std::pair{"~~~", "```"}, std::pair{"int x; // ```", "```"});
    const std::string quote = GENERATE("", "> ");
    const std::string was = "```cpp\n" + quote + "//> Main\n" + quote + "int main() {}\n" + quote + "```\n";
    book.edit_chapter("```cpp\n//> Main\nint main() {}\n```\n", quote + was);
    book.edit("chapters/07_wall/main.cpp", "int main() {}\n", "int main() {}\n/*\n" + std::string{code} + "\n*/\n");

    CHECK(book.weave().code == all_well);
    const std::string now = fence + std::string{"cpp\n"} + quote + "//> Main\n" + quote + "int main() {}\n" + quote
                            + "/*\n" + quote + code + '\n' + quote + "*/\n" + quote + fence + '\n';
    CHECK_THAT(book.text(), ContainsSubstring(quote + now));
    CHECK(book.check().code == all_well);
}

TEST_CASE("an output that looks like a fence makes its fence longer, too") {
    Book book;
    book.program("echo '```'");

    CHECK(book.weave().code == all_well);
    CHECK_THAT(book.text(), ContainsSubstring("````console\n$ ./course run 7\n```\n````\n"));
    CHECK(book.check().code == all_well);
}

TEST_CASE("what a program prints is woven; other commands are left alone") {
    Book book;
    book.program("echo length 6; echo; echo 'width 7'; echo; echo to nobody >&2");

    CHECK(book.check().text
          == "chapters/07_wall/README.md:29: this output differs here from what ./course run 7 prints.\n"
             "To keep the code as it is now, type ./course dev weave, which writes it into the book; if the book is "
             "right, "
             "correct the code.\n");
    CHECK(book.weave().code == all_well);
    CHECK(book.text() == replaced(chapter, "length 5\n", "length 6\n\nwidth 7\n"));
}

TEST_CASE("the output of one part is woven from that part alone, also under --mine; an unknown part is named") {
    Book book;
    book.program(
        "case $1 in --out) echo all ;; walls) echo 'walls only' ;; *) echo \"no part $1\" >&2; exit 2 ;; esac");
    for (const std::string mine : {"", " --mine"}) {
        book.put("chapters/07_wall/README.md",
                 replaced(chapter, "$ ./course run 7\nlength 5\n", "$ ./course run 7 walls" + mine + "\nlength 5\n"));
        book.renew_program();
        CHECK_THAT(book.check().text, ContainsSubstring("differs here from what ./course run 7 walls prints"));
        CHECK(book.weave().code == all_well);
        CHECK_THAT(book.text(), ContainsSubstring("$ ./course run 7 walls" + mine + "\nwalls only\n```"));
    }

    book.put("chapters/07_wall/README.md",
             replaced(chapter, "$ ./course run 7\nlength 5\n", "$ ./course run 7 doors\n"));
    CHECK_THAT(book.weave().text, ContainsSubstring("07_wall: no part doors"));
}

TEST_CASE("a program is run with --out, in a folder of the build") {
    Book book;
    book.program("echo \"$1\"; case \"$2\" in \"" + book.workspace.build.string() + "\"/*) pwd >\"$2/trace\" ;; esac");

    CHECK(book.weave().code == all_well);
    CHECK_THAT(book.text(), ContainsSubstring("$ ./course run 7\n--out\n```"));
    CHECK_THAT(book.text("build/weave/07_wall/trace"), StartsWith(book.workspace.build.string()));
}

TEST_CASE("a program that is missing, old or failing is reported with the remedy, and nothing is woven") {
    Book book;
    book.edit_chapter("it stands", "it lies");
    const std::string before = book.text();
    SECTION("missing") {
        fs::remove(book.workspace.build / "chapters/07_wall");
        CHECK(book.check().text
              == "the program of 07_wall is not built, so its output cannot be woven; ./course builds it.");
    }
    SECTION("old") {
        fs::last_write_time(book.workspace.solution(book.section),
                            fs::file_time_type::clock::now() + std::chrono::seconds{5});
        CHECK(book.check().text == "the program of 07_wall is older than solutions/07_wall.cpp; ./course rebuilds it.");
    }
    SECTION("older than its game") {
        book.put("chapters/07_wall/game.hpp", "//>\n");
        fs::last_write_time(book.workspace.root / "chapters/07_wall/game.hpp",
                            fs::file_time_type::clock::now() + std::chrono::seconds{5});
        CHECK(book.check().text
              == "the program of 07_wall is older than chapters/07_wall/game.hpp; ./course rebuilds it.");
    }
    SECTION("fails") {
        book.program("exit 3");
        CHECK(book.check().text
              == "the program of 07_wall stopped with exit code 3; ./course run 7 shows what it says.");
    }
    SECTION("has computed for too long") {
        book.program("kill -XCPU $$");
        CHECK(book.check().text
              == "the program of 07_wall would not end, and was stopped; ./course run 7 runs it without weaving.");
    }
    CHECK(book.weave().code == bad_input);
    CHECK(book.text() == before);
}

TEST_CASE("a link or an image that leads nowhere is found") {
    const Book book;
    book.put("book.md", "# Which way, `now`? Far\xE2\x80\x93"
                        "away\n\n# Twice\n\n# Twice\n\n<a id=\"e7-1\"></a>\n");
    const auto [link, message] = GENERATE(
        std::pair{"[a](gone.md)", "the link `gone.md` leads to no file"},
        std::pair{"![a](../../plots/gone.svg)", "leads to no file"},
        std::pair{"<img src=\"gone.svg\">", "leads to no file"},
        std::pair{"text [a][b]\n\n[b]: gone.md", "leads to no file"},
        std::pair{"\\$5 [a](gone.md) $6", "leads to no file"},
        std::pair{"[a](#nothing)", "leads to no heading of chapters/07_wall/README.md"},
        std::pair{"[a](../../book.md#twice-2)", "leads to no heading of book.md"},
        std::pair{"[a](/book.md)", "begins with a slash"},
        std::pair{"[a](../../../../etc/passwd)", "leads out of the course"},
        std::pair{"[a](../../book.md#which-way-now-faraway) [b](../../book.md#twice-1) [c](../../book.md#e7-1)", ""},
        std::pair{"[a](wall.hpp) [b](../07_wall) [c](..)", ""},
        std::pair{"[a](https://example.org/gone) [b](mailto:a@example.org)", ""},
        std::pair{"$f[1](x)$ and `[a](gone.md)`", ""}, std::pair{"```text\n[a](gone.md)\n```", ""},
        std::pair{"[a](%77all.hpp)", ""});
    INFO(link);
    book.edit_chapter("Plan a minute.\n", "Plan a minute.\n\n" + std::string{link} + '\n');

    const Told told = book.check();
    CHECK(told.code == (*message ? something_to : all_well));
    if (*message) CHECK_THAT(told.text, StartsWith("chapters/07_wall/README.md:5: ") && ContainsSubstring(message));
}

TEST_CASE("the links of the pages in the top folder are checked, with their lines") {
    const Book book;
    const std::string page = GENERATE("README.md", "CONTRIBUTING.md", "book.md");
    book.put(page, "# Title\n\n> one\n> two [a](chapters/07_wall/README.md#7-wall) and\n> three "
                   "[b](chapters/08_wall/README.md)\n");

    CHECK_THAT(book.check().text, StartsWith(page + ":5: the link `chapters/08_wall/README.md` leads to no file"));
}

TEST_CASE("book.md may show what sections share") {
    const Book book;
    book.put("chapters/course.hpp", "#pragma once\nint hidden;\n//> Vectors\nusing Vec2 = int;\n");
    book.put("book.md", "# Book\n");
    CHECK_THAT(book.check().text, StartsWith("chapters/course.hpp:3: the chunk \"Vectors\" is not shown in book.md;"));

    const std::string mark = GENERATE("", "\xEF\xBB\xBF");
    book.put("book.md", mark + "```cpp\n//> Vectors\n```\n");
    CHECK(book.weave().code == all_well);
    CHECK(book.text("book.md") == mark + "```cpp\n//> Vectors\nusing Vec2 = int;\n```\n");
}

TEST_CASE("exercises of the header without a row, a hint, a solution, rows without an exercise, and unshown figures "
          "are found") {
    const Book book;
    const auto [was, is, message] =
        GENERATE(std::tuple{"| 7.1 | `length`", "| 7.1 | `width`",
                            "wall.hpp:18: the chapter's table has no row for this exercise; write `| 7.1 | `length`: "
                            "... | core |` there."},
                 std::tuple{"| core | 5 min |", "| stretch | 5 min |",
                            "README.md:46: the header declares no exercise like this row;"},
                 std::tuple{"7.1, a hint: where", "7.2, a hint: where", "no hint says how 7.1 is begun;"},
                 std::tuple{"7.1, a hint: where to begin", "7.1, a hint: it is red", "no hint says how 7.1 is begun;"},
                 std::tuple{"../../plots/07_wall_path.svg", "wall.hpp",
                            "plots/07_wall_path.gp:1: the chapter does not show this figure;"});
    book.edit_chapter(was, is);
    CHECK(book.check().code == something_to);
    CHECK_THAT(book.check().text, ContainsSubstring(message));
}

TEST_CASE("the glossary has a row for each bold term, with what else it is called and where it is explained") {
    const Book book;
    book.edit_chapter("# 7 Wall\n",
                      "# 7 Wall\n\nA **wall** is high.\n\n## Which side?\n\nThe **normal** <!-- also: unit "
                      "normal, normal vector --> is *not* a **`Vec2`, of length $1$**, for *it* is **long.**\n\n"
                      "> ### A box: **x**\n>\n> **Write** it.\n\nA **box | wall** (see *there*). **Pencil first:** 2 "
                      "**and so on…**\n\n"
                      "```text\n**code**\n```\n\n## Which side?\n\n"
                      "The **Determinant** (*not* this).\n\n");
    const std::string rest = "\n## Errata\n\n| | |\n|:--|:--|\n| **E1** | x |\n";
    book.put("book.md", "# B\n\n**bold**\n\n## Glossary\n\nThe terms.\n" + rest);
    CHECK_THAT(book.check().text, ContainsSubstring("book.md:9: this line is not what the chapters' demos, bold"));
    CHECK(book.check().code == something_to);
    CHECK(book.weave("7").text == "woven: book.md, 1 block changed\n");
    const std::string chapter_link = "(chapters/07_wall/README.md",
                      rows = "| `Vec2`, of length $1$ | | [7]" + chapter_link
                             + "#which-side) |\n"
                               "| box \\| wall | | [7]"
                             + chapter_link
                             + "#which-side) |\n"
                               "| Determinant | | [7]"
                             + chapter_link
                             + "#which-side-1) |\n"
                               "| normal | unit normal, normal vector | [7]"
                             + chapter_link
                             + "#which-side) |\n"
                               "| wall | | [7]"
                             + chapter_link + ") |\n";
    const std::string woven =
        "# B\n\n**bold**\n\n## Glossary\n\nThe terms.\n\n| term | also called | where |\n|:--|:--|:--|\n" + rows + rest;
    CHECK(book.text("book.md") == woven);
    CHECK(book.check().code == all_well);
    CHECK(book.weave().code == all_well);

    const auto [was, is, place] = GENERATE(std::tuple{"| wall | |", "| walls | |", "book.md:12: "},
                                           std::tuple{"unit normal,", "unit,", "book.md:14: "},
                                           std::tuple{"| term |", "| Term |", "book.md:9: "});
    book.put("book.md", replaced(woven, was, is));
    CHECK(book.check().code == something_to);
    CHECK_THAT(book.check().text, ContainsSubstring(place + std::string{"this line is not what"}));
    book.weave();
    CHECK(book.text("book.md") == woven);
}

TEST_CASE(
    "a term of several chapters is one row; twice in one chapter it is a finding; without terms there is no table") {
    const std::string one = "# A\n\n**wall** <!-- also: brick -->, **corner**\n",
                      two = "# B\n\nA **Wall** <!-- also: brick, fence -->.\n";
    std::vector<Term> terms = terms_of(one, 1, "a.md", "a.md");
    for (const Term &term : terms_of(two, 2, "b.md", "b.md")) terms.push_back(term);
    const Glossary woven = weave_glossary("## Glossary\n", "book.md", terms);
    CHECK(woven.book
          == "## Glossary\n\n| term | also called | where |\n|:--|:--|:--|\n| corner | | [1](a.md) |\n| wall | brick, "
             "fence | [1](a.md), [2](b.md) |\n");
    CHECK(woven.findings.empty());
    CHECK(weave_glossary(woven.book, "book.md", terms).book == woven.book);
    CHECK(weave_glossary("## Glossary\n", "book.md", {}).book == "## Glossary\n");
    CHECK(weave_glossary("# Book\n", "book.md", {}).findings.empty());
    CHECK(weave_glossary("# Book\n", "book.md", terms)
              .findings.at(0)
              .message.starts_with("there is no glossary; write a heading"));

    const Glossary twice =
        weave_glossary(woven.book, "book.md", terms_of(one + "\nThe **wall**.\n", 1, "a.md", "a.md"));
    REQUIRE(twice.findings.size() == 1);
    CHECK(twice.findings[0].line == 5);
    CHECK(twice.findings[0].message
          == "\"wall\" is bold in line 3 already; make it bold only once, where it is explained.");
}

TEST_CASE("a chapter with a fence without an end takes no row out of the glossary") {
    const Book book;
    book.edit_chapter("# 7 Wall\n", "# 7 Wall\n\n```cpp\nint x;\n\nA **wall** is high.\n");
    const std::string woven =
        "## Glossary\n\n| term | also called | where |\n|:--|:--|:--|\n| wall | | [7](chapters/07_wall/README.md) |\n";
    book.put("book.md", woven);
    CHECK(book.weave().code == something_to);
    CHECK(book.text("book.md") == woven);
}

TEST_CASE("the place of a demo is a line of its own, with a name and what to try") {
    const Book book;
    book.edit_chapter("# 7 Wall\n", "# 7 Wall\n\n<!-- demo: room2 | throw the ball -->\n\n<!-- demo: room mine, The "
                                    "game: on | throw it again -->\n");
    CHECK(book.check().code == all_well);
    const std::string wrong =
        GENERATE("<!-- demo: room -->", "<!-- demo: | throw -->", "<!-- demo: the room | throw -->",
                 "<!-- demo: room |\nthrow -->", "Text <!-- demo: room | throw -->", "<!-- demo: room | throw --> text",
                 "<!-- demo room | throw -->", "<!-- demo: room, | throw -->");
    book.edit_chapter("<!-- demo: room mine, The game: on | throw it again -->", wrong);
    CHECK(book.check().text
          == "chapters/07_wall/README.md:5: write a demo's place as `<!-- demo: name | what to try, and what to watch "
             "-->`, on a line of its own.\n");
}

TEST_CASE("old names are read from renamed.txt, and each leads to a name of the header") {
    const Book book;
    CHECK(renamed(book.workspace, book.section).empty());
    book.put("chapters/07_wall/renamed.txt", "# since version 2\nspan length # one\r\n\nBrick Wall\n");
    CHECK(book.check().code == all_well);
    const auto names = renamed(book.workspace, book.section);
    REQUIRE(names.size() == 2);
    CHECK(names[0].before == "span");
    CHECK(names[0].now == "length");
    CHECK(names[0].line == 2);
    CHECK(names[1].now == "Wall");

    const auto [line, message] = GENERATE(
        std::tuple{"span", "renamed.txt:1: a line holds an old name and the new one, with a blank between."},
        std::tuple{"span length width", "renamed.txt:1: a line holds an old name"},
        std::tuple{"span length()", "renamed.txt:1: a line holds an old name"},
        std::tuple{"span Where",
                   "renamed.txt:1: the header has nothing called `Where`; write the name that `span` has now."});
    book.put("chapters/07_wall/renamed.txt", line);
    CHECK(book.check().code == something_to);
    CHECK_THAT(book.check().text, ContainsSubstring(message));
}

TEST_CASE("a solution that `course solution` would not find is told") {
    const Book book;
    book.edit("solutions/07_wall.cpp", "//> Solution 7.1: a length", "//> Solution: a length");

    CHECK_THAT(
        book.check().text,
        ContainsSubstring(
            "solutions/07_wall.cpp:1: no chunk is the solution of 7.1; write `//> Solution 7.1: ...` above it."));
    CHECK_THROWS_AS(solution(book.workspace, book.section, "7.1"), UserError);
}

TEST_CASE("hints come with number, title and a text that a terminal can show") {
    const Book book;
    book.edit_chapter("<details>\n<summary>Our solution</summary>\n",
                      "<details>\n<summary>7.2, a hint: which *w*</summary>\n\nOne.\n\n- `a * b`, "
                      "**bold**\n- |w| ≤ ½ and [a page](wall.hpp)\n\n"
                      "<details><summary>More</summary>\n\nAn inner fold.\n</details>\n\n```cpp\ndouble "
                      "x;\n```\n</details>\n\n<details>\n<summary>Our solution</summary>\n");

    const std::vector<Hint> all = hints(book.text());
    REQUIRE(all.size() == 2);
    CHECK(all[0].number == "7.1");
    CHECK(all[0].title == "where to begin");
    CHECK(all[0].text == "Pythagoras: √(Δx² + Δy²), see std::hypot and the idea.\n");
    CHECK(all[1].number == "7.2");
    CHECK(all[1].title == "which w");
    CHECK(all[1].text
          == "One.\n\n- a * b, bold\n- |w| ≤ ½ and a page (wall.hpp)\n\nMore\n\nAn inner fold.\n\n    double x;\n");
}

TEST_CASE("a solution is the exercise's own chunks and the helpers that it uses, in the order of the file") {
    const Book book;
    REQUIRE(solution(book.workspace, book.section, "7.1").size() == 1); // without the square, which it does not use
    book.edit("solutions/07_wall.cpp", "(wall.end - wall.start).norm()", "square((wall.end - wall.start).x())");
    const std::vector<Chunk> chunks = solution(book.workspace, book.section, "7.1");

    REQUIRE(chunks.size() == 2);
    CHECK(chunks[0].title == "Solution: a helper");
    CHECK(chunks[1].title == "Solution 7.1: a length");
    CHECK(
        chunks[1].lines
        == std::vector<std::string>{"//> Solution 7.1: a length",
                                    "double length(const Wall &wall) { return square((wall.end - wall.start).x()); }"});
}

TEST_CASE("a helper below a solution is not shown with it") {
    const Book book;
    book.edit("solutions/07_wall.cpp", "//> Solution: a helper", "//> Solution 7.1: helped");
    book.edit("solutions/07_wall.cpp", "//> Solution 7.1: a length", "//> Solution: a length");
    const std::vector<Chunk> chunks = solution(book.workspace, book.section, "7.1");

    REQUIRE(chunks.size() == 1);
    CHECK(chunks[0].title == "Solution 7.1: helped");
}

TEST_CASE("a hint with a formula is found, since a terminal shows it as well") {
    const Book book;
    book.edit_chapter("√(Δx² + Δy²)", "$\\sqrt{\\Delta x^2}$");
    const Told result = book.check();
    CHECK(result.code == something_to);
    CHECK_THAT(result.text,
               ContainsSubstring("chapters/07_wall/README.md:48: a terminal shows this hint for 7.1 as well;"));
}

TEST_CASE("a chapter is measured by the script of the course, if it has one") {
    const Book book;
    book.put("docs/voice.cjs", read_file(fs::path{COURSE_ROOT} / "docs" / "voice.cjs"));
    CHECK(book.check().code == all_well);
    book.edit_chapter("<!-- budget: listings 999, since this is a chapter for tests -->\n", "## Further\n");
    const Told result = book.check();
    CHECK(result.code == something_to);
    CHECK_THAT(
        result.text,
        ContainsSubstring("chapters/07_wall/README.md:1: 272 unfolded lines of code for 100 lines of prose, where")
            && ContainsSubstring("chapters/07_wall/README.md:74: the voice: 1 times a standing heading"));
}

TEST_CASE("weaving puts a new chapter in the place of the old one, which is never half written") {
    const Book book;
    book.edit_chapter("it stands", "it lies");
    const std::string before = book.text();
    fs::create_hard_link(book.workspace.chapter(book.section), book.workspace.root / "before");
    CHECK(book.weave().code == all_well);
    CHECK(book.text() == chapter);
    CHECK(book.text("before") == before);
}

TEST_CASE("a forge shows at each demo's place how to play it, and a picture each time that it begins in another way") {
    const Book book;
    const std::string plain = "Plan a minute.\n";
    const std::string marks =
        plain
        + "\n<!-- demo: room | Throw $x$. -->\n\n<!-- demo: room mine, radius: 2 | Larger. Is it? -->\n\n"
          "<!-- demo: room mine | Yours. -->\n\nOn.\n";
    book.edit_chapter(plain, marks);
    CHECK(book.weave().code == all_well);
    CHECK_THAT(book.text(), ContainsSubstring(marks)); // without a picture nothing is woven

    book.put("demos/07_wall.svg", "<svg><title>A ball &amp; a wall</title></svg>");
    book.put("demos/07_wall_2.svg", "<svg><title>A ball &amp; a wall</title></svg>");
    CHECK_THAT(book.check().text,
               StartsWith("chapters/07_wall/README.md:7: this line is not what the chapters' demos"));
    CHECK_THAT(book.weave().text, ContainsSubstring("1 block changed"));
    const std::string woven =
        plain
        + "\n<!-- demo: room | Throw $x$. -->\n\n![A ball &amp; a wall Throw $x$.](../../demos/07_wall.svg)\n\n"
          "*Play it:* `./course play 7`. Throw $x$.\n\n"
          "<!-- demo: room mine, radius: 2 | Larger. Is it? -->\n\n![A ball &amp; a wall "
          "Larger.](../../demos/07_wall_2.svg)\n\n"
          "*Play it:* `./course play 7 --mine`. Larger. Is it?\n\n"
          "<!-- demo: room mine | Yours. -->\n\n*Play it:* `./course play 7 --mine`. Yours.\n\nOn.\n";
    CHECK_THAT(book.text(), ContainsSubstring(woven));
    CHECK(book.check().code == all_well);

    book.edit_chapter("Larger. Is it? -->", "Smaller. Is it? -->");
    CHECK_THAT(book.check().text, StartsWith("chapters/07_wall/README.md:13: "));
    CHECK(book.weave().code == all_well);
    CHECK_THAT(book.text(), ContainsSubstring(replaced(woven, "Larger", "Smaller")));

    book.edit_chapter("<!-- demo: room | Throw $x$. -->\n\n", "");
    CHECK_THAT(book.check().text, StartsWith("chapters/07_wall/README.md:5: this line is not what"));
    CHECK(book.weave().code == all_well);
    CHECK(book.text().find("Throw $x$") == std::string::npos);
    CHECK(book.check().code == all_well);
}

TEST_CASE("below the box of an exercise, a forge's command opens the demo of that exercise") {
    const Book book;
    book.put("demos/07_wall.svg", "<svg><title>A ball</title></svg>");
    book.edit_chapter("Plan a minute.\n", "> ### Your turn: 7.1 `length` (5 minutes)\n>\n> Write.\n\n"
                                          "<!-- demo: room mine | Throw. -->\n");
    book.weave();
    CHECK_THAT(book.text(), ContainsSubstring("*Play it:* `./course play 7.1 --mine`. Throw.\n"));
}

TEST_CASE("what a chapter needs is in its line \"You need\": links to sections, some for one exercise alone") {
    const auto needs = [](const std::string &line) {
        return needs_cell(prerequisites("# 8\n\n" + line + "\nMore.\n").value());
    };
    const std::string one = "[section 1](../01_motion/README.md)", seven = "[7.5](../07_wall/README.md#size)";
    CHECK(needs("You need vectors from school.").empty());
    CHECK(needs("You need " + one + " and " + seven + ", and [a dictionary](https://example.org).") == "1, 7");
    CHECK(needs("You need " + one + "; only 8.2 calls functions of " + seven + ".") == "1, 7 for 8.2");
    CHECK(needs("You need loops; only 8.2 needs " + seven + "; all need " + one + '.') == "7 for 8.2, 1");
    CHECK(needs("You need " + one + "; 8.3 needs " + one + " again.") == "1");
    CHECK_FALSE(prerequisites("# 8\n\nDo you need it? You need it.\n"));
    for (const char *cell : {"", "1", "1, 7 for 8.2, 9"}) CHECK(needs_cell(read_needs(cell)) == cell);
}

TEST_CASE("the contents' minutes are added up from a chapter's table: the core, and the rest, to the nearest five") {
    const std::string head = "| | you write | level | minutes |\n|:--|:--|:--|--:|\n",
                      core = "| 7.1 | `f`: [a](#b) | core | 12 + 20 |\n",
                      rest = "| 7.2 | `g` | stretch | 9 + 5 |\n| 7.3 | `h` | challenge | 10 + 39 |\n";
    CHECK(minutes_cell(head + core + rest + "\n| push | far |\n|:--|:--|\n| 2.5 | 1 |\n") == "30 + 65");
    CHECK(minutes_cell(head + rest) == "20 + 45"); // without a core: 19 to read, 44 to do
    CHECK(minutes_cell("| push |\n|:--|\n| 2.5 |\n").empty());
    const Book book;
    const std::string contents =
        "# A book\n\n## Contents\n\n| | section | about | minutes | needs |\n|--:|:--|:--|--:|:--|\n"
        "| 7 | [Wall](chapters/07_wall/README.md) | walls | ";
    book.edit_chapter("Plan a minute.\n", "You need vectors.\n\n" + head + core);
    book.put("book.md", contents + "75 + 80 | |\n\n## Glossary\n");
    CHECK_THAT(book.check().text, ContainsSubstring("book.md:7: this line is not what"));
    book.weave();
    CHECK(book.text("book.md") == contents + "30 + 0 | |\n\n## Glossary\n");
}

TEST_CASE("the contents' column `needs` is woven from the chapters, and is kept for what is to come") {
    const Book book;
    const std::string head =
                          "# A book\n\n## Contents\n\n| | section | about | minutes | needs |\n|--:|:--|:--|--:|:--|\n",
                      to_come = "| 8 | Springs | *to come* | | 7 |\n\n## Glossary\n",
                      row = "| 7 | [Wall](chapters/07_wall/README.md) | walls | 5 |";
    book.put("book.md", head + row + " |\n" + to_come);
    CHECK_THAT(book.check().text,
               ContainsSubstring("chapters/07_wall/README.md:1: say in a line that begins with \"You need\""));
    book.edit_chapter("Plan a minute.\n", "You need [motion](../01_motion/README.md).\n");
    book.put("chapters/01_motion/README.md", "# 1 Motion\n");
    CHECK_THAT(book.check().text, ContainsSubstring("book.md:7: this line is not what"));
    CHECK(book.weave().code == all_well);
    CHECK(book.text("book.md") == head + row + " 1 |\n" + to_come);
    CHECK(book.check().code == all_well);
    book.edit_chapter("01_motion", "07_wall");
    CHECK_THAT(book.check().text, ContainsSubstring("is not an earlier section: 7."));
}

TEST_CASE("README leads to the published book once it has an address, and nowhere before") {
    const Book book;
    const fs::path readme = book.workspace.root / "README.md", lists = book.workspace.root / "CMakeLists.txt";
    const std::string before = "# A book\n\n![A ball.](demos/a.svg)\n\nPhysics.\n\n![Another.](demos/b.svg)\n",
                      project = read_file(lists);
    write_file(readme, before);
    CHECK(book.weave().code == all_well);
    CHECK(read_file(readme) == before);

    write_file(lists, "project(x VERSION 1.2.3 HOMEPAGE_URL \"https://a.example/b\" LANGUAGES CXX)\n" + project);
    const Told told = book.check();
    CHECK(told.code == something_to);
    CHECK_THAT(told.text, StartsWith("README.md:3: "));
    for (int times = 0; times < 2; ++times) {
        book.weave();
        CHECK(read_file(readme)
              == "# A book\n\n**[Read it, play it, and write your first line in your browser](https://a.example/b)**: "
                 "there's nothing to install.\n\n[![A ball.](demos/a.svg)](https://a.example/b)\n\nPhysics.\n\n"
                 "![Another.](demos/b.svg)\n");
    }
    write_file(lists, project);
    book.weave();
    CHECK(read_file(readme) == before);
}
