// The book's site: what becomes of a page of Markdown, and of a whole small course.

#include "site/link_check.hpp"
#include "site/page_writer.hpp"
#include "site/progress_script.hpp"
#include "site/section_map.hpp"
#include "site/share.hpp"
#include "small_course.hpp"

#include "base/errors.hpp"
#include "base/text.hpp"
#include "remember_now.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <regex>

#include <chrono>
#include <thread>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::StartsWith;
using namespace course;
namespace fs = std::filesystem;

namespace {

/// A small course with all that a site needs.
struct SmallBook : SmallCourse {
    SmallBook() : SmallCourse{"a $(HOME) of \"it's\" & $HOME #1 XXXXXX"} { // each of them once broke something
        fs::copy(fs::path{COURSE_ROOT} / "docs", workspace.root / "docs", fs::copy_options::recursive);
        for (const Section &section : workspace.sections()) {
            write(workspace.header(section),
                  "#pragma once\n\n/// Section " + section.short_number() + ".\nnamespace " + section.slug()
                      + " {\n\n//> A wall\n/// Where it stands.\nstruct Wall {\n    double start; ///< [m]\n};\n\n"
                        "/// How long it is [m].\ndouble length(const Wall &wall);\n//>\n} // namespace\n");
            write(workspace.program(section), "//> Main\nint main() {}\n");
            write(workspace.tests(section), "//> A test\nTEST_CASE(\"x < y & \\\"z\\\"\") {}\n");
            write(workspace.solution(section), "//> Solution: nothing\nint nothing;\n");
        }
        write("chapters/course.hpp",
              "#pragma once\n/// What all share.\nnamespace course {\n/// Refuses.\nvoid require(bool holds);\n"
              "/// Refuses a number.\nvoid require(double x);\n}\n");
        write("tests/section_test.hpp", "// tests\n");
        write("plots/style.gp", "# the look\n");
        write("plots/07_wall_meeting_room.gp", "#> Figure\nplot 'x'\n");
        write("plots/07_wall_meeting_room.svg",
              R"(<svg width="640" height="400" xmlns="http://www.w3.org/2000/svg"></svg>)");
        write("README.md", "# A small course\n\n## I want to learn\n\n## I teach with it\n");
        write("CONTRIBUTING.md", "# Contributing\n");
        write("docs/weekend.md", "# A weekend\n"); // which leads into chapters of the large one
        write("LICENSE", "do as you like\n");
        write("book.md", book);
    }

    fs::path chapter_file() const { return workspace.chapter(seven()); }

    /// The chapter's page, unfinished, if it says this below its title.
    std::string page(const std::string &markdown) const {
        return written_page(Addresses{workspace}, chapter_file(), "# 7 Walls\n\n" + markdown, "chapter_07_wall_meeting")
            .html;
    }

    /// Makes the site, with this below the chapter's title.
    Finished make(const std::string &markdown = "Words.\n", const std::string &title = "Walls") const {
        write(chapter_file(), "# 7 " + title + "\n\n" + markdown);
        return (*this)({"make-site", "--doxygen", COURSE_DOXYGEN, "--node", COURSE_NODE, "--katex", COURSE_KATEX,
                        "--lunr", COURSE_LUNR});
    }
    std::string made(const std::string &file) const { return read(workspace.build / "site" / file); }

    static constexpr const char *book = R"(# Small

## Preface

Of $x$, see [what is wrong](#wrong-signs) and [what there is](#contents).

## Contents

| | section | about | minutes |
|--:|:--|:--|--:|
| 6 | [Reflection](chapters/06_reflection/README.md) | mirrors | 20 |
| 7 | [Walls](chapters/07_wall_meeting/README.md) | walls | 30 + 5 |
| 8 | Springs | *to come* | |

## Notation and units

## Glossary

## Where next

## Errata

### Wrong signs

They are [here](chapters/07_wall_meeting/README.md).
)";
};

std::string formula(const std::string &tex, int line, bool display = false) {
    return "<span class=\"math" + std::string{display ? " display" : ""}
           + "\" data-from=\"chapters/07_wall_meeting/README.md:" + std::to_string(line) + "\">" + tex + "</span>";
}
std::string formula_x(int line) { return formula("x", line); }

} // namespace

// Pages of Markdown

TEST_CASE("a page has a title, and its text as HTML") {
    const SmallBook book;
    const SitePage page = written_page(Addresses{book.workspace}, book.workspace.root / "README.md",
                                       "\xEF\xBB\xBF# \"Read\" `it`\r\n\r\nme\r\n", "readme");
    CHECK(page.title == "“Read” it");
    CHECK(page.html == "<h1>\n“Read” <code>it</code>\n</h1>\n<p>me</p>\n");
}

TEST_CASE("words stay words") {
    const SmallBook book;
    const auto [markdown, html] = GENERATE(table<std::string, std::string>({
        {"mail @word and \\brief, C:\\new, ::x, #12, %y", "<p>mail @word and \\brief, C:\\new, ::x, #12, %y</p>"},
        {"<kbd>Esc</kbd>", "<p><kbd>Esc</kbd></p>"},
        {"a < b && c", "<p>a &lt; b &amp;&amp; c</p>"},
        {"`a | b`, `$PATH`, `<b>`", "<p><code>a | b</code>, <code>$PATH</code>, <code>&lt;b&gt;</code></p>"},
        {"costs \\$5, or $9", "<p>costs $5, or $9</p>"},
        {"\"so\" -- isn't it...", "<p>“so” – isn’t it…</p>"},
        {"one\\\ntwo", "<p>one<br />\ntwo</p>"},
    }));
    CHECK_THAT(book.page(markdown + "\n"), ContainsSubstring(html));
}

TEST_CASE("formulas keep every sign, and know their line") {
    const SmallBook book;
    const auto [markdown, html] = GENERATE(table<std::string, std::string>({
        {"with $\\dot x_1 * y_1 * z$ in it", "with " + formula("\\dot x_1 * y_1 * z", 3) + " in it"},
        {"first\nthen $a < b$", "then " + formula("a &lt; b", 4)},
        {"$$a\n= b$$", formula("a\n= b", 3, true)},
        {"**bold $x$**", "<strong>bold " + formula_x(3) + "</strong>"},
        {"\"$x$\"", "“" + formula_x(3) + "”"},
        {"> quoted $x$", "<p>quoted " + formula_x(3)},
        {"- item $x$", "<li>item " + formula_x(3)},
        {"| a |\n|:--|\n| $|x|$ |\n| $y$ |",
         "<td align=\"left\">" + formula("|x|", 5) + "</td>\n</tr>\n<tr>\n<td align=\"left\">" + formula("y", 6)},
        {"<details>\n<summary>7.1: $x$ and `y`</summary>\n\nz\n</details>",
         "<summary>7.1: " + formula_x(3) + " and <code>y</code></summary>"},
        {"## About $x_1$",
         "About " + formula("x_1", 3) + "\n<a class=\"anchor\" href=\"#about-x_1\" aria-label=\"Link to About x_1\">"},
    }));
    CHECK_THAT(book.page(markdown + "\n"), ContainsSubstring(html));
}

TEST_CASE("a demo plays where the chapter marks its place, if its section keeps one; a task has formulas and words") {
    const SmallBook book;
    const std::string marks =
        "<!-- demo: room | Try $x$, and `watch`. -->\n\n<!-- demo: room mine, The game: \"on\", radius: 2 | "
        "Now yours. -->\n";
    book.write(book.chapter_file(), "# 7 Walls\n\n" + marks);
    CHECK(book.page(marks).find("figure") == std::string::npos);
    book.write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': ''};\n");
    const std::string page = book.page(marks);
    CHECK_THAT(page, ContainsSubstring("<figure class=\"play\" id=\"demo-room\" data-demo=\"07_wall_meeting\">"
                                       "<figcaption>Try "
                                       + formula_x(3) + ", and <code>watch</code>.</figcaption>"));
    CHECK_THAT(page, ContainsSubstring("id=\"demo-room-2\" data-demo=\"07_wall_meeting\" data-mine "
                                       "data-start=\"The game: &quot;on&quot;, radius: 2\">"));
}

TEST_CASE("what a forge shows in the place of a demo is not on the site") {
    const SmallBook book;
    book.write("demos/07_wall_meeting.svg", "<svg/>");
    CHECK(book.page("<!-- demo: room | Try $x$. -->\n\n![A ball](../../demos/07_wall_meeting.svg)\n\n"
                    "*Play it:* `./course play 7`. Try $x$.\n\nThen $y$.\n")
          == book.page("<!-- demo: room | Try $x$. -->\n\n\n\n\n\nThen $y$.\n"));
    CHECK_THAT(book.page("*Play it* again.\n"), ContainsSubstring("<em>Play it</em> again."));
}

TEST_CASE("a picture says what it shows, and leads to the script that draws it; a formula in its words is named") {
    const SmallBook book;
    const std::string page = book.page("![From a_x to √2](../../plots/07_wall_meeting_room.svg)\n\nand $y$\n");
    CHECK_THAT(page,
               ContainsSubstring(
                   "<img src=\"plots/07_wall_meeting_room.svg\" alt=\"From a_x to √2\" width=\"640\" height=\"400\">"));
    CHECK_THAT(page, ContainsSubstring("<a class=\"from\" href=\"source_plots_07_wall_meeting_room_gp.html\">"));
    CHECK_THAT(page, ContainsSubstring("and " + formula("y", 5)));
    CHECK_THROWS_MATCHES(book.page("![From $a_x$](../../plots/07_wall_meeting_room.svg)\n"), UserError,
                         MessageMatches(StartsWith("chapters/07_wall_meeting/README.md:3: write what the picture ")));
}

TEST_CASE("a picture that the site cannot have is named") {
    const SmallBook book;
    CHECK_THROWS_MATCHES(
        book.page("![x](room.gif)\n"), UserError,
        MessageMatches(StartsWith("chapters/07_wall_meeting/README.md:3: the site cannot show the picture room.gif;")));
}

TEST_CASE("a fold keeps its paragraphs, lists and folds within it") {
    const SmallBook book;
    CHECK_THAT(book.page("<details>\n<summary>Open</summary>\n\nOne.\n\nTwo.\n</details>\n"),
               ContainsSubstring("<details>\n<summary>Open</summary>\n<p>One.</p>\n<p>Two.</p>\n</details>"));
    CHECK_THAT(book.page("- item\n  <details><summary>Open</summary>\n\n  One.\n  </details>\n"),
               ContainsSubstring("<details><summary>Open</summary>\n<p>One.</p>\n</details>\n</li>"));
}

TEST_CASE("a fold says whether it holds a hint or our solution") {
    const SmallBook book;
    const std::string other = "<details><summary>7.2, a hint: it is not</summary>\n\nz\n</details>\n\n";
    const std::string hints =
        book.page("<details>\n<summary>7.1, a hint: it is $x$</summary>\n\nz\n</details>\n\n" + other
                  + "<details><summary>7.1, a hint: it is red</summary>\n\nz\n</details>\n");
    CHECK_THAT(hints,
               ContainsSubstring("<details class=\"hint\">\n<summary>Hint 1: it is " + formula_x(3) + "</summary>"));
    CHECK_THAT(hints, ContainsSubstring("<details class=\"hint\"><summary>Hint 2: it is red</summary>")
                          && ContainsSubstring("<summary>Hint 1: it is not</summary>"));
    CHECK_THAT(book.page("<details><summary>Our solution of 7.1</summary>\n\nz\n</details>\n"),
               ContainsSubstring("<details class=\"solution\"><summary>Our solution of 7.1</summary>"));
    CHECK_THAT(book.page("<details><summary>How 7.1 is tested</summary>\n\nz\n</details>\n"),
               ContainsSubstring("<details><summary>How"));
}

TEST_CASE("the box of an exercise is no quotation; others are") {
    const SmallBook book;
    CHECK_THAT(book.page("> ### Your turn: 7.1 `f` (5 minutes)\n>\n> Write $x$.\n"),
               ContainsSubstring("<article class=\"turn\" id=\"exercise-7.1\" data-exercise=\"7.1\">\n<h3 "
                                 "id=\"your-turn-71-f-5-minutes\">"));
    CHECK_THAT(book.page("> ### Your turn: 7.1 `f`, first try\n\n> ### Your turn: 7.1, second try\n"),
               ContainsSubstring("id=\"exercise-7.1-2\" data-exercise=\"7.1\""));
    CHECK_THAT(book.page("> ### Your turn\n>\n> Write $x$.\n"),
               ContainsSubstring("<p>Write " + formula_x(5) + ".</p>\n</article>"));
    CHECK_THAT(book.page("> ### My turn\n"), ContainsSubstring("<blockquote>\n<h3"));
    CHECK_THAT(book.page("> In print.\n"), ContainsSubstring("<blockquote>\n<p>In print.</p>"));
}

TEST_CASE("only long code may break within a line") {
    const SmallBook book;
    CHECK_THAT(book.page("`const Vec2 abcd = b < c;`\n"),
               ContainsSubstring("<code>const Vec2 abcd = b &lt; c;</code>"));
    CHECK_THAT(book.page("`const Vec2 a = motion.end < motion.start;`\n"),
               ContainsSubstring("<code class=\"long\">const Vec2 a = motion.end &lt; motion.start;</code>"));
}

TEST_CASE("code is as it was written, and says its language where its words are coloured") {
    const SmallBook book;
    CHECK_THAT(book.page("> Before.\n>\n> ```c++\n> int x; // $5 @see \\dot\n>\n> ```\n> After.\n"),
               ContainsSubstring("<blockquote>\n<p>Before.</p>\n<figure class=\"listing\"><pre class=\"code\" "
                                 "data-language=\"cpp\"><code>int x; // $5 @see \\dot\n\n</code></pre></figure>\n"
                                 "<p>After.</p>\n</blockquote>"));
    CHECK_THAT(book.page("```gnuplot\nplot x # it's\n```\n"),
               ContainsSubstring("<pre class=\"code\" data-language=\"gnuplot\"><code>plot x # it's\n</code></pre>"));
    CHECK_THAT(book.page("```console\n$ ./course <7>\n```\n"),
               ContainsSubstring("<pre class=\"console\"><code>$ ./course &lt;7&gt;\n</code></pre>"));
    CHECK_THAT(book.page("    four blanks\n"),
               ContainsSubstring("<pre class=\"plain\"><code>four blanks\n</code></pre>"));
}

TEST_CASE("a listing is headed by its title, and by the file and line where it begins") {
    const SmallBook book;
    const std::string page = book.page("```cpp\n//> A wall\nstruct Wall {\n```\n");
    CHECK_THAT(page, ContainsSubstring("<span class=\"title\">A wall</span> <a class=\"from\" "
                                       "href=\"source_chapters_07_wall_meeting_wall_meeting_hpp.html#L7\">"
                                       "chapters/<wbr>07_wall_meeting/<wbr>wall_meeting.hpp:7</a>"));
    CHECK_THAT(page, ContainsSubstring("<code>struct Wall {\n</code>"));
    CHECK(page.find("//>") == page.npos);
}

TEST_CASE("headings can be linked to as on a forge") {
    const SmallBook book;
    const std::string page = book.page("## What's `so`?\n\n## What's so\n\n### Deep\n");
    CHECK_THAT(page, ContainsSubstring("<h2 id=\"whats-so\">\nWhat’s <code>so</code>?\n<a class=\"anchor\" "
                                       "href=\"#whats-so\" aria-label=\"Link to What’s so?\">#</a></h2>"));
    CHECK_THAT(page, ContainsSubstring("<h2 id=\"whats-so-1\">"));
    CHECK_THAT(page, ContainsSubstring("<h3 id=\"deep\">"));
}

TEST_CASE("links lead to pages of the site, and stay plain text where there is no such page") {
    const SmallBook book;
    const auto [url, html] = GENERATE(table<std::string, std::string>({
        {"../06_reflection/README.md", "<a href=\"chapter_06_reflection.html\">x</a>"},
        {"../06_reflection/", "<a href=\"chapter_06_reflection.html\">x</a>"},
        {"../06_reflection/README.md#by-hand", "<a href=\"chapter_06_reflection.html#by-hand\">x</a>"},
        {"../../book.md#errata", "<a href=\"errata.html\">x</a>"},
        {"../../book.md#wrong-signs", "<a href=\"errata.html#wrong-signs\">x</a>"},
        {"../../book.md#notation-and-units", "<a href=\"notation_and_units.html\">x</a>"},
        {"../../book.md#contents", "<a href=\"index.html#contents\">x</a>"},
        {"../../book.md", "<a href=\"index.html\">x</a>"},
        {"../../README.md", "<a href=\"readme.html\">x</a>"},
        {"wall_meeting.hpp", "<a href=\"source_chapters_07_wall_meeting_wall_meeting_hpp.html\">x</a>"},
        {"../../tests/07_wall_meeting/tests.cpp", "<a href=\"source_tests_07_wall_meeting_tests_cpp.html\">x</a>"},
        {"#by-hand", "<a href=\"#by-hand\">x</a>"},
        {"https://example.org/a", "<a href=\"https://example.org/a\">x</a>"},
        {"../../LICENSE", "<span class=\"path\">x</span>"},
        {"../../tests/play", "<span class=\"path\">x</span>"},
    }));
    CHECK_THAT(book.page("[x](" + url + ")\n"), ContainsSubstring(html));
}

TEST_CASE("the lead is the italic paragraph below the title") {
    const SmallBook book;
    CHECK_THAT(book.page("*What it is.*\n\n*Words.*\n"),
               ContainsSubstring("<p class=\"lead\">\nWhat it is.\n</p>\n<p><em>Words.</em></p>"));
}

TEST_CASE("tables") {
    const SmallBook book;
    CHECK_THAT(book.page("> | a |\n> |---|\n> | [b](../../LICENSE) |\n"),
               ContainsSubstring("<div class=\"table\">\n<table>")
                   && ContainsSubstring("<td><span class=\"path\">b</span></td>"));
    CHECK_THAT(book.page("| \"so\" | (x) |\n|---|---|\n"), ContainsSubstring("<th>“so”</th>\n<th>(x)</th>"));
    CHECK_THAT(book.page("a | b, in words\n"), ContainsSubstring("<p>a | b, in words</p>"));
    REQUIRE(book.make("| | a |\n|--:|:-:|\n| 1. | `x \\| y` |\n").code == 0);
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"),
               ContainsSubstring("<tr>\n<td class=\"right\"></td>\n<th class=\"center\">a</th>\n</tr>")
                   && ContainsSubstring("<td class=\"right\">1.</td>\n<td class=\"center\"><code>x | y</code></td>"));
}

// The soundness of a site

TEST_CASE("files without a link to them are left out") {
    SiteFiles files{
        {"index.html",
         "<a href=\"a%20b.html#x\">a</a><link rel=\"stylesheet\" href=\"s.css\"><script src=\"site.js\"></script>"},
        {"a b.html", "<p id=\"x\">"},
        {"s.css", "@font-face { src: url(f.woff2) }"},
        {"f.woff2", ""},
        {"site.js", "read('more.js')"},
        {"more.js", ""},
        {"alone.html", "<a href=\"nowhere.html\">"}};
    keep_reachable(files);
    CHECK(files.size() == 6);
    CHECK_FALSE(files.contains("alone.html"));
}

TEST_CASE("a link that leads nowhere, a place that is there twice, another host") {
    const auto [html, trouble] = GENERATE(table<std::string, std::string>({
        {"<a href=\"b.html\">", "index.html links to b.html, and there is no such file"},
        {"<img src=\"b.svg\">", "index.html links to b.svg, and there is no such file"},
        {"<img alt=\"x\"\nsrc='b.svg'>", "index.html links to b.svg, and there is no such file"},
        {"<a href=\"a&amp;b\">", "index.html links to a&b, and there is no such file"},
        {"<a href=\"#x\">", "index.html links to #x, and there is no such place"},
        {"<a href=\"a.html#y\">", "index.html links to a.html#y, and there is no such place"},
        {"<p id=\"x\"><p id=\"x\">", "index.html has two places called #x"},
        {"<script src=\"https://example.org/x.js\"></script>",
         "index.html would fetch https://example.org/x.js from another host"},
        {"<img src=\"//example.org/x.png\">", "index.html would fetch //example.org/x.png from another host"},
        {"<link rel=\"stylesheet\" href=\"s.css\">", "s.css would fetch https://example.org/f.woff2 from another host"},
    }));
    SiteFiles files{
        {"index.html", html}, {"a.html", "<p id=\"x\">"}, {"s.css", "a { src: url(\"https://example.org/f.woff2\") }"}};
    CHECK_THROWS_MATCHES(keep_reachable(files), UserError, MessageMatches(ContainsSubstring("  " + trouble)));
}

TEST_CASE("a link to another host may stand in the text: nothing is fetched until somebody follows it") {
    SiteFiles files{{"index.html", "<a href=\"https://example.org\">there</a><!-- <img src=\"b.svg\"> -->"}};
    CHECK_NOTHROW(keep_reachable(files));
}

// The whole site

TEST_CASE("a small course becomes a site") {
    const SmallBook book;
    const Finished made = book.make("With $x^2$.\n\n```cpp\n//> A wall\n/// Where it stands.\n```\n");
    INFO(made.err);
    REQUIRE(made.code == 0);
    const std::string chapter = book.made("chapter_07_wall_meeting.html"), index = book.made("index.html");
    CHECK_THAT(chapter, ContainsSubstring("<title>7 Walls · Frame by Frame</title>"));
    CHECK_THAT(chapter, ContainsSubstring("<meta name=\"description\" content=\"Walls: walls. Part of a course"));
    CHECK_THAT(chapter, ContainsSubstring("<meta property=\"og:title\" content=\"7 Walls · Frame by Frame\">"));
    CHECK_THAT(book.made("404.html"), ContainsSubstring("<base href=\"404.html\">"));
    CHECK(chapter.find("<base") == chapter.npos);
    CHECK_THAT(chapter, ContainsSubstring("<p class=\"above\">30 minutes, and 5 for the other exercises</p>"));
    CHECK_THAT(chapter, ContainsSubstring("rel=\"prev\" href=\"chapter_06_reflection.html\""));
    CHECK_THAT(chapter, ContainsSubstring("rel=\"next\" href=\"notation_and_units.html\""));
    CHECK_THAT(index, ContainsSubstring("<li class=\"to-come\"><span class=\"number\">8</span> Springs"));
    CHECK_THAT(book.made("source_chapters_07_wall_meeting_wall_meeting_hpp.html"),
               ContainsSubstring("<span class=\"line\" id=\"L8\"><span class=\"keyword\">struct</span> "
                                 "<a class=\"code\" href=\"structwall__meeting_1_1Wall.html\">Wall</a> {</span>\n"));
    const std::string wall = book.made("namespacewall__meeting.html");
    CHECK_THAT(wall, ContainsSubstring("<h1><code>wall_meeting</code></h1>"));
    CHECK_THAT(wall, ContainsSubstring(
                         "Interface of <a href=\"chapter_07_wall_meeting.html\">section 7</a>, from "
                         "<a href=\"source_chapters_07_wall_meeting_wall_meeting_hpp.html\">wall_meeting.hpp</a>"));
    CHECK(wall.find("More...") == wall.npos);
    CHECK(wall.find("Detailed Description") == wall.npos);
}

TEST_CASE("formulas are typeset, together with the mark behind them") {
    const SmallBook book;
    REQUIRE(book.make("Of $x$, $y$ and $x$.\n\n$$z$$\n").code == 0);
    const std::string page = book.made("chapter_07_wall_meeting.html");
    CHECK_THAT(page,
               ContainsSubstring("Of <span class=\"katex\">") && ContainsSubstring("<span class=\"katex-display\">"));
    CHECK_THAT(page, ContainsSubstring("</math>,</span>")
                         && ContainsSubstring("<span class=\"mark\">,</span></span></span></span> <span")
                         && ContainsSubstring("<span class=\"mark\">.</span></span></span></span></p>"));
    CHECK(page.find("data-from") == page.npos);
}

TEST_CASE(
    "numbers with a blank in them or a unit behind them do not break within a line; others, and code, are left alone") {
    const SmallBook book;
    REQUIRE(
        book.make(
                "From 3 to 310 000 steps, 2 000 000 in all, 12 000 m, 7.2 N s, (3, 4) m; 3 4567, 5 metres, `1 000`.\n")
            .code
        == 0);
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"),
               ContainsSubstring("From 3 to 310\u00A0000 steps, 2\u00A0000\u00A0000 in all, 12\u00A0000\u00A0m, "
                                 "7.2\u00A0N\u00A0s, (3, 4)\u00A0m; 3 4567, 5 metres, <code>1 000</code>."));
}

namespace {

std::string fenced(const std::vector<std::pair<std::string, std::string>> &cases) {
    std::string markdown;
    for (const auto &[code, html] : cases) markdown += "```cpp\n" + code + "\n```\n\n";
    return markdown;
}

std::string coloured(const std::string &kind, const std::string &words) {
    return "<span class=\"" + kind + "\">" + words + "</span>";
}

} // namespace

TEST_CASE("code is coloured, and nothing of it is lost") {
    const SmallBook book;
    const std::vector<std::pair<std::string, std::string>> cases{
        {"const int x = 1'000; // it's \"so\"", coloured("keyword", "const") + ' ' + coloured("type", "int")
                                                    + " x = 1'000; " + coloured("comment", "// it's &quot;so&quot;")},
        {"#include <a> // why", coloured("macro", "#include &lt;a&gt; ") + coloured("comment", "// why")},
        {"a(\"\\\"int\", '\"', R\"(int\")\");", "a(" + coloured("string", "&quot;\\&quot;int&quot;") + ", "
                                                    + coloured("string", "'&quot;'") + ", "
                                                    + coloured("string", "R&quot;(int&quot;)&quot;") + ");"},
        {"/* int\nint */ int",
         coloured("comment", "/* int") + '\n' + coloured("comment", "int */") + ' ' + coloured("type", "int")},
        {"integer x.int_ a < b && c", "integer x.int_ a &lt; b &amp;&amp; c"},
    };
    REQUIRE(book.make(fenced(cases) + "```gnuplot\nplot 'x' # it's\n```\n").code == 0);
    const std::string page = book.made("chapter_07_wall_meeting.html");
    for (const auto &[code, html] : cases) CHECK_THAT(page, ContainsSubstring("<code>" + html + "\n</code>"));
    CHECK_THAT(page, ContainsSubstring("plot " + coloured("string", "'x'") + ' ' + coloured("comment", "# it's")));
}

TEST_CASE("names in code lead to their descriptions, but not in comments, strings or other things' members") {
    const SmallBook book;
    book.write(book.workspace.header(book.workspace.section("6")),
               "#pragma once\n/// Six.\nnamespace reflection {\n"
               "/// A mirror.\nstruct Mirror { int x; ///< where\n };\n"
               "/// How far.\ndouble length(int x);\n}\n");
    const auto link = [](const std::string &address, const std::string &words) {
        return "<a class=\"code\" href=\"" + address + "\">" + words + "</a>";
    };
    const std::string wall = link("structwall__meeting_1_1Wall.html", "Wall"),
                      mirror = "structreflection_1_1Mirror.html";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"Wall w{}; x.Wall, p->Wall; std::Wall", wall + " w{}; x.Wall, p-&gt;Wall; std::Wall"},
        {"\"Wall\" // Wall", coloured("string", "&quot;Wall&quot;") + ' ' + coloured("comment", "// Wall")},
        {"length lengths() x.length() a::length()", "length lengths() x.length() a::length()"},
        {"Wall::end, Mirror", wall + "::end, " + link(mirror, "Mirror")},
        {"reflection::Mirror::x", link(mirror, "reflection::Mirror") + "::x"},
        {"int wall_meeting = 1;", coloured("type", "int") + " wall_meeting = 1;"},
    };
    REQUIRE(book.make(fenced(cases)
                      + "```cpp\nlength(w) + length (w);\ncourse::require(x); require(x);\n```\n\n"
                        "Of `length`, `length` and `Mirror`.\n\n## A `length`\n\nOf `length`.\n")
                .code
            == 0);
    const std::string page = book.made("chapter_07_wall_meeting.html");
    for (const auto &[code, html] : cases) CHECK_THAT(page, ContainsSubstring("<code>" + html + "\n</code>"));
    const auto count = [&](const std::string &pattern) {
        const std::regex regex{"<a class=\"code\" href=\"namespace" + pattern};
        return std::distance(std::sregex_iterator{page.begin(), page.end(), regex}, {});
    };
    CHECK(count("wall__meeting.html#\\w+\">length</a>") == 2);
    const std::string shared = book.made("namespacecourse.html");
    const std::string first{between(shared, "<a id=\"a", "\"").value()}; // of two that have the name
    CHECK(count("course.html#a" + first + "\">(course::)?require</a>") == 2);
    CHECK(count("wall__meeting.html#\\w+\"><code>length</code></a>") == 2); // once in each part
    CHECK_THAT(page, ContainsSubstring("and <code>Mirror</code>."));
}

TEST_CASE("the search's index has each part's words, formulas in plain characters, and names") {
    const SmallBook book;
    REQUIRE(book.make("With $x^2$ < 3, $v_x\\cdot\\frac{a}{b}$.\n\n<!-- words: parabola -->\n\n## Of $y$ `so`\n\n- "
                      "One\n- two\n")
                .code
            == 0);
    const std::string index = book.made("search-index.js");
    CHECK_THAT(
        index,
        ContainsSubstring(
            R"({"page":"7 Walls","part":"","address":"chapter_07_wall_meeting.html","text":"With x² < 3, v_x · a/b. "})"));
    CHECK_THAT(index, ContainsSubstring(
                          R"("part":"Of y so","address":"chapter_07_wall_meeting.html#of-y-so","text":"One two "})"));
    CHECK_THAT(index, ContainsSubstring(R"_("page":"Interface: wall_meeting","part":"length()","address":"namesp)_"));
    CHECK_THAT(index, ContainsSubstring("\"parabola\""));
}

TEST_CASE("the front page leads to the first section, and has a card for each section that is there") {
    const SmallBook book;
    REQUIRE(book.make("Words.\n", "Who hits a wall?").code == 0);
    const std::string front = book.made("index.html");
    CHECK_THAT(front,
               ContainsSubstring("<a class=\"begin\" href=\"chapter_06_reflection.html\">Begin with 6 Reflection "
                                 "<small>20&nbsp;min</small></a>"));
    CHECK_THAT(front, ContainsSubstring(
                          "<a href=\"chapter_07_wall_meeting.html\"><span class=\"number\">7</span> "
                          "Who hits a wall?</a><p>walls</p><p class=\"foot\"><span>Walls, 30 + 5&nbsp;minutes</span> "
                          "<span data-progress=\"7\"></span></p>"));
    CHECK_THAT(front,
               ContainsSubstring("<ul class=\"coming\">\n<li><span class=\"number\">8</span> Springs</li>\n</ul>"));
    CHECK(front.find("{{") == front.npos);
    book.write("docs/front.md", "# Small\n\n{{beginning}}\n");
    CHECK_THAT(book.make().err, ContainsSubstring("docs/front.md has a gap that nothing fills: {{beginning}}"));
}

TEST_CASE("each part of book.md but its contents is a page, in the contents and between the others") {
    const SmallBook book;
    REQUIRE(book.make().code == 0);
    const std::string preface = book.made("preface.html"), errata = book.made("errata.html");
    CHECK_THAT(preface, ContainsSubstring("<title>Preface · Frame by Frame</title>")
                            && ContainsSubstring("<h1>\nPreface\n</h1>")
                            && ContainsSubstring("<span class=\"katex\">"));
    CHECK_THAT(preface, ContainsSubstring("<a href=\"errata.html#wrong-signs\">what is wrong</a>")
                            && ContainsSubstring("<a href=\"index.html#contents\">what there is</a>"));
    CHECK_THAT(preface, ContainsSubstring("rel=\"prev\" href=\"index.html\"")
                            && ContainsSubstring("rel=\"next\" href=\"chapter_06_reflection.html\""));
    CHECK_THAT(errata, ContainsSubstring("<h2 id=\"wrong-signs\">")
                           && ContainsSubstring("<a href=\"chapter_07_wall_meeting.html\">here</a>"));
    CHECK(errata.find("rel=\"next\"") == errata.npos);
    CHECK_FALSE(book.has(book.workspace.build / "site" / "contents.html"));
    const auto at = [&](const char *page) { return errata.find("<li><a href=\"" + std::string{page} + ".html\""); };
    CHECK((at("index") < at("preface") && at("preface") < at("chapter_06_reflection")));
    CHECK((at("chapter_07_wall_meeting") < at("glossary") && at("glossary") < at("namespacecourse")));
}

TEST_CASE("a formula that cannot be read in a part of book.md is named with its line there") {
    const SmallBook book;
    std::string text = SmallBook::book;
    text.replace(text.find("$x$"), 3, "$\\nonsense$");
    book.write("book.md", text);
    CHECK_THAT(book.make().err, ContainsSubstring("book.md:5: the formula $\\nonsense$ cannot be read: "));
}

TEST_CASE("unchanged pages keep their date, and pages without a source are removed") {
    const SmallBook book;
    REQUIRE(book.make("One.\n").code == 0);
    const fs::path site = book.workspace.build / "site";
    const auto date = fs::last_write_time(site / "index.html");
    book.write(site / "old.html", "");
    REQUIRE(book.make("Two.\n").code == 0);
    CHECK(fs::last_write_time(site / "index.html") == date);
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"), ContainsSubstring("<p>Two.</p>"));
    CHECK_FALSE(book.has(site / "old.html"));
}

TEST_CASE("an error is named with its place, and the earlier site stays") {
    const SmallBook book;
    REQUIRE(book.make("As before.\n").code == 0);
    const auto [markdown, words] = GENERATE(table<std::string, std::string>({
        {"One.\n\nWith $\\frac{1}$ in it.\n",
         "chapters/07_wall_meeting/README.md:5: the formula $\\frac{1}$ cannot be read: "},
        {"$é$\n", "chapters/07_wall_meeting/README.md:3: the formula $é$ cannot be read: "},
        {"[x](#nowhere)\n", "chapter_07_wall_meeting.html links to #nowhere, and there is no such place"},
    }));
    const Finished made = book.make(markdown);
    CHECK(made.code == 2);
    CHECK_THAT(made.err, StartsWith("course: ") && ContainsSubstring(words));
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"), ContainsSubstring("As before."));
}

TEST_CASE("a comment that Doxygen warns of fails the site, and is named") {
    const SmallBook book;
    book.write(book.workspace.header(book.seven()),
               "#pragma once\n/// Section 7.\nnamespace wall_meeting {\n/// Long.\n/// "
               "@param wal  it\ndouble length(double wall);\n}\n");
    const Finished made = book.make();
    CHECK(made.code == 2);
    CHECK_THAT(made.err, ContainsSubstring("chapters/07_wall_meeting/wall_meeting.hpp:")
                             && ContainsSubstring("argument 'wal' of command @param is not found"));
}

// The commands

TEST_CASE("site says where it is, and how to open it") {
    const SmallBook book;
    const Finished site = book({"site"}, {book.instead_of("cmake", "exit 0")});
    CHECK(site.code == 0);
    CHECK(site.out
          == "The book is build/default/site/index.html\nType ./course open, or ./course open 7 for a section\n");
}

TEST_CASE("a site that cannot be built is a sentence, not ninja's log") {
    const SmallBook book;
    const Finished site =
        book({"site"},
             {book.instead_of("cmake", "echo '[1/1] Making the site'; echo 'FAILED: site.stamp'; "
                                       "echo 'course: book.md:3: wrong'; echo; echo 'ninja: build stopped'; exit 1")});
    CHECK(site.code == 2);
    CHECK_THAT(site.err, StartsWith("course: book.md:3: wrong"));
    CHECK(site.err.find("ninja") == std::string::npos);
}

TEST_CASE("open hands the front page or a chapter to the desktop, and does not wait") {
    const SmallBook book;
    const std::string path = book.instead_of("cmake", "exit 0");
    book.instead_of("xdg-open", "cd \"${0%/bin/*}\"; echo \"$1\" >opening; mv opening opened; sleep 5");
    const auto [words, page] = GENERATE(table<std::vector<std::string>, std::string>({
        {{"open"}, "index.html"},
        {{"open", "7"}, "chapter_07_wall_meeting.html"},
        {{"open", "wall"}, "chapter_07_wall_meeting.html"},
    }));
    const std::string file = (book.workspace.build / "site" / page).string();
    const auto began = std::chrono::steady_clock::now();
    const Finished opened = book(words, {path, "DISPLAY=:0"});
    CHECK(opened.out == "Opening " + file + "\n");
    CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds{4});
    for (int i = 0; i < 100 && !book.has("opened"); ++i) std::this_thread::sleep_for(std::chrono::milliseconds{20});
    CHECK(book.read("opened") == file + "\n");
}

TEST_CASE("without a screen, open says which file") {
    const SmallBook book;
    const std::string path = book.instead_of("cmake", "exit 0");
    book.instead_of("xdg-open", "exit 0");
    const Finished opened = book({"open", "7"}, {path, "DISPLAY=", "WAYLAND_DISPLAY="});
    CHECK(opened.code == 0);
    CHECK(opened.out
          == "Open this file in your browser: " + (book.workspace.build / "site/chapter_07_wall_meeting.html").string()
                 + "\n");
    CHECK(book({"open", "9"}, {path}).code == 2);
}

TEST_CASE("pages with a demo have its scripts, and one page has all demos") {
    const SmallBook book;
    const std::string plain_page = (book.make(), book.made("chapter_07_wall_meeting.html"));
    CHECK(plain_page.find("play.js") == std::string::npos);
    CHECK(plain_page.find("og:image") == std::string::npos);
    CHECK(book.made("index.html").find("play.html") == std::string::npos);
    CHECK_FALSE(fs::exists(book.workspace.build / "site" / "play.html"));

    book.write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': ''};\n");
    const Finished made = book.make("<!-- demo: room | Throw the ball. -->\n");
    INFO(made.err);
    REQUIRE(made.code == 0);
    const std::string scripts = "<script src=\"demos/07_wall_meeting.js\"></script>\n<script "
                                "src=\"draw.js\"></script>\n<script src=\"answers.js\"></script>\n"
                                "<script src=\"play.js\"></script>";
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"), ContainsSubstring(scripts));
    CHECK_THAT(book.made("play.html"),
               ContainsSubstring(scripts) && ContainsSubstring("Throw the ball.")
                   && ContainsSubstring("<a href=\"chapter_07_wall_meeting.html\">section 7</a>: walls."));
    CHECK_THAT(book.made("play.html"), ContainsSubstring("<h2 id=\"7-walls\">"));
    CHECK_THAT(book.made("index.html"), ContainsSubstring("<a href=\"play.html\">Play all</a>"));
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"), !ContainsSubstring("og:image"));

    book.write("demos/07_wall_meeting.svg",
               "<svg width=\"640\" height=\"400\"><title>A ball &amp; walls</title></svg>\n");
    REQUIRE(book.make("<!-- demo: room | Throw the ball. -->\n").code == 0);
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"),
               ContainsSubstring("<meta property=\"og:image\" content=\"demos/07_wall_meeting.png\">"));
    const std::string picture = "<img src=\"demos/07_wall_meeting.svg\" alt=\"";
    CHECK_THAT(book.made("chapter_07_wall_meeting.html"),
               ContainsSubstring(picture + "A ball &amp; walls Throw the ball.\">"));
    CHECK_THAT(book.made("play.html"), ContainsSubstring(picture + "A ball &amp; walls Throw the ball.\">"));
    CHECK_THAT(book.made("index.html"), ContainsSubstring("<li class=\"card\">" + picture + "\"><div>"));
    CHECK(book.made("index.html").find("play.js") == std::string::npos);
    CHECK(book.made("preface.html").find("play.js") == std::string::npos);
    book.write(
        "docs/front.md",
        "# Small\n\n{{begin}}\n\n## Contents\n\n{{sections}}\n\n{{map}}\n\n<!-- demo: room | Throw the ball. -->\n");
    CHECK(book.make("<!-- demo: room | Throw the ball. -->\n").err.empty());
    CHECK_THAT(book.made("index.html"), ContainsSubstring(scripts)); // a front page that shows it plays it
    CHECK_THAT(book.made("demos/07_wall_meeting.js"), ContainsSubstring("playable"));
}

TEST_CASE("a shared demo is one page that asks for nothing else, with ours and the student's code in it") {
    const SmallBook book;
    book.write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': 'ours'};\n");
    REQUIRE(book.make("<!-- demo: room | Throw. -->\n").code == 0);
    write_file(book.workspace.build / "play" / "07_wall_meeting_mine.js",
               "self.playable['07_wall_meeting/mine'] = 'yours';\n");
    DemoMark mark;
    mark.start = "size: 1 & 2";
    const std::string page = shared_page(book.workspace, demos(book.workspace).front(), mark, false);
    CHECK_THAT(page, ContainsSubstring("data-demo=\"07_wall_meeting\" data-mine data-start=\"size: 1 &amp; 2\""));
    CHECK_THAT(page, ContainsSubstring("<figure data-shared ") && ContainsSubstring("Press <em>Mine</em>"));
    CHECK_THAT(page, ContainsSubstring("'ours'") && ContainsSubstring("'yours'") && ContainsSubstring("demoPicture"));
    for (const char *outside : {"src=\"", "href=\"", "url(fonts"}) CHECK(page.find(outside) == std::string::npos);
    CHECK(page.find("self.progress = ") == std::string::npos);
    CHECK_THAT(shared_page(book.workspace, demos(book.workspace).front(), mark, true),
               ContainsSubstring("self.progress = "));
}

TEST_CASE("a demo with a bug in it is such a page, too, and names the file in the place of the student") {
    const SmallBook book;
    book.write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': 'ours'};\n");
    REQUIRE(book.make("<!-- demo: room | Throw. -->\n").code == 0);
    write_file(book.workspace.build / "play" / "07_wall_meeting_bug.js",
               "self.playable['07_wall_meeting/mine'] = 'bug';\n");
    DemoMark mark;
    mark.start = "size: 1";
    const std::string page = page_with_bug(book.workspace, demos(book.workspace).front(), mark);
    CHECK_THAT(page, ContainsSubstring("<figure data-yours=\"07_bug.cpp\" class=\"play\"")
                         && ContainsSubstring("data-demo=\"07_wall_meeting\" data-mine data-start=\"size: 1\""));
    CHECK_THAT(page, ContainsSubstring("'ours'") && ContainsSubstring("'bug'") && ContainsSubstring("demoPicture"));
    CHECK_THAT(page, ContainsSubstring("<code>./course bug 7</code>"));
    for (const char *outside : {"src=\"", "href=\"", "url(fonts"}) CHECK(page.find(outside) == std::string::npos);
}

TEST_CASE("play says what it needs before it builds anything") {
    const SmallBook book;
    book.write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': ''};\n");
    book.write(book.chapter_file(), "# 7 Walls\n\n<!-- demo: room | Throw. -->\n");
    CHECK_THAT(book({"play", "6"}).err, ContainsSubstring("section 6 has no demo to play with yet"));
    CHECK_THAT(book({"play", "--mine"}).err, ContainsSubstring("./course play 7 --mine"));
    CHECK_THAT(book({"play", "7", "--mine", "--bug"}).err, ContainsSubstring("--mine excludes --bug"));
    CHECK_THAT(book({"play", "7", "--watch"}).err, ContainsSubstring("--watch is for your own code"));
    CHECK_THAT(book({"play", "7", "--share", "x.html"}).err, ContainsSubstring("--share is for your own code"));
    CHECK_THAT(book({"play", "7", "--mine", "--share", "x.cpp"}).err, ContainsSubstring("a name that ends in .html"));
    const Finished without_compiler = book({"play", "7", "--mine"});
    CHECK(without_compiler.code == 2);
    CHECK_THAT(without_compiler.err, ContainsSubstring("Without --mine the demo runs on ours"));
}

TEST_CASE("play --mine says what the compiler for pages takes, and installs it only when it is told to") {
    const SmallBook book;
    book.write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': ''};\n");
    book.write(book.chapter_file(), "# 7 Walls\n\n<!-- demo: room | Throw. -->\n");
    book.write("tools/setup/needs_of_pages", "clang-14\nlld-14\n");
    book.write_program("bin/sudo", "exec \"$@\"");
    book.write_program("bin/cmake", R"(case $1 in --*) exit ;; esac
[ ! -e "${0%/*}/installed" ] || { mkdir -p "$1/play" && : >"$1/play/can_compile"; })");
    const std::string path = book.instead_of("apt-get", R"(echo "$*" >>"${0%/*}/asked"
case $* in
*--assume-no) echo 'Need to get 3,391 kB of archives.'
    echo 'After this operation, 17.3 MB of additional disk space will be used.' ;;
*--yes) exec sh "${0%/*}/installs" ;;
esac)");
    const std::string install = "install --no-install-recommends clang-14 lld-14 ", trial = install + "--assume-no\n",
                      done = install + "--yes\n";

    const Finished asked = book({"play", "7", "--mine"}, {path});
    CHECK(asked.code == 2);
    CHECK_THAT(asked.out, ContainsSubstring("Debian has one (3,391 kB to download, 17.3 MB on the disk):\n  ")
                              && ContainsSubstring("apt-get install --no-install-recommends clang-14 lld-14\n"));
    CHECK_THAT(asked.err, ContainsSubstring("nothing was installed; type the line above"));
    CHECK(book.read("bin/asked") == trial);

    const auto told = [&](const std::string &installs) {
        book.write("bin/asked", "");
        book.write("bin/installs", installs);
        return book({"play", "7", "--mine", "--yes"}, {path}).err;
    };
    CHECK_THAT(told("exit 100"), ContainsSubstring("apt-get could not install it"));
    CHECK_THAT(told("exit 0"), ContainsSubstring("is installed, but does not work"));
    CHECK_THAT(told(": >\"${0%/*}/installed\""), !ContainsSubstring("install"));
    CHECK(book.read("bin/asked") == trial + done);
    told("exit 100");
    CHECK(book.read("bin/asked").empty()); // it is there now
}

// The map

TEST_CASE("the map has a box for each section, links to those that stand, and says each need once") {
    const SmallBook book;
    fs::create_directories(book.workspace.build);
    const auto entry = [](int number, const std::string &title, const std::string &needs,
                          const std::string &chapter = "") {
        return Entry{0, number, title, chapter, "", "", needs, 5};
    };
    const std::string map =
        section_map(book.workspace, {entry(6, "Reflection", "", "chapters/06_reflection/README.md"),
                                     entry(7, "Walls & floors", "6", "chapters/07_wall_meeting/README.md"),
                                     entry(8, "Springs", "6, 7 for 8.2"), entry(9, "Ropes", "6, 7")});
    const auto count = [&](const std::string &what) {
        const std::regex pattern{what};
        return std::distance(std::sregex_iterator{map.begin(), map.end(), pattern}, {});
    };
    CHECK(count("class=\"node\"") == 2);
    CHECK(count("class=\"node to-come\"") == 2);
    CHECK(count("<a href=\"chapter_06_reflection.html\">") == 2); // in the picture, and in the list for phones
    CHECK_THAT(map, ContainsSubstring("7 Walls &amp; floors</a>: needs 6</li>")
                        && ContainsSubstring("<li>8 Springs, to come: needs 6, 7 for 8.2</li>")
                        && ContainsSubstring("<title>8 Springs, to come: needs 6, 7 for 8.2</title>"));
    CHECK(count("class=\"edge\"") == 3); // 6 to 7, 6 to 8, 7 to 9: from 6 to 9 it's by way of 7
    CHECK(count("class=\"edge in-part\"") == 1);
    CHECK(section_map(book.workspace, {entry(6, "Reflection", ""), entry(7, "Walls", "")}).empty());
}

// What is done

TEST_CASE("the pages know what is done, and where to go on: in the section that was judged last") {
    const SmallBook book;
    const auto progress = [&] { return progress_script(book.workspace); };
    CHECK_THAT(progress(), ContainsSubstring(R"({"number":"7","page":"chapter_07_wall_meeting.html","exercises":[)"
                                             R"({"number":"7.1","function":"first","done":false},)"));
    CHECK(progress().find("next") == std::string::npos);

    for (const Section &section : book.workspace.sections()) book.write(book.workspace.exercise(section), "begun");
    remember(book.workspace, book.workspace.section("6"), {{"6.1", "passed"}});
    CHECK_THAT(progress(), ContainsSubstring(R"("next":{"number":"6.2","function":"second_bounce",)"
                                             R"("address":"chapter_06_reflection.html#exercise-6.2"})"));
    book.write(".course/progress.json",
               R"({"06_reflection": {"6.1": {"state": "passed", "when": "2026-11-20T10:00:00Z"}},
        "07_wall_meeting": {"7.1": {"state": "passed", "when": "2026-11-21T10:00:00Z"}}})");
    CHECK_THAT(progress(), ContainsSubstring(R"({"number":"7.1","function":"first","done":true})")
                               && ContainsSubstring(R"("next":{"number":"7.2")"));
    remember(book.workspace, book.seven(), {{"7.2", "passed"}});
    CHECK_THAT(progress(), ContainsSubstring(R"("next":{"number":"6.2")")); // all of section 7 is done
    remember(book.workspace, book.seven(), {{"7.1", "crashed"}});
    CHECK_THAT(progress(), ContainsSubstring(R"({"number":"7.1","function":"first","done":false})"));
}

TEST_CASE("a site is told what is done when it is made, and by check and reset") {
    const SmallBook book;
    book.write(book.workspace.exercise(book.seven()), "begun");
    remember(book.workspace, book.seven(), {{"7.1", "passed"}});
    CHECK(book({"check", "7"}).code != 0); // without a site nothing is told
    CHECK_FALSE(fs::exists(book.workspace.build / "site"));

    remember(book.workspace, book.seven(), {{"7.1", "passed"}});
    REQUIRE(book.make().code == 0);
    const std::string first = R"("number":"7.1","function":"first","done":)";
    CHECK_THAT(book.made("progress.js"), ContainsSubstring(first + "true"));
    CHECK_THAT(book.made("index.html"),
               ContainsSubstring("<script src=\"progress.js\"></script>\n<script src=\"done.js\"></script>"));

    book.write(book.workspace.exercise(book.seven()), "");
    CHECK_THAT(book({"check", "7"}).out, ContainsSubstring("is empty"));
    CHECK_THAT(book.made("progress.js"), ContainsSubstring(first + "false"));

    remember(book.workspace, book.seven(), {{"7.1", "passed"}});
    book.write(book.workspace.build / "mine" / "site" / "progress.js", "");
    CHECK(book({"reset", "7", "--yes"}).code == 0);
    for (const char *site : {"site/progress.js", "mine/site/progress.js"})
        CHECK_THAT(book.read(book.workspace.build / site), ContainsSubstring(first + "false"));
}

// The student's own site

namespace {

/// A small book with a figure that has a place for the student's curve, and a demo; section 7 is begun.
struct OwnBook : SmallBook {
    OwnBook() {
        const std::string figure = "07_wall_meeting_room";
        write("plots/style.gp", read_file(fs::path{COURSE_ROOT} / "plots/style.gp"));
        write("plots/" + figure + ".gp",
              "#> Figure: a room\nload 'style.gp'\nset output ARG2\nset xrange [0:4]; set yrange [0:5]\n"
              "yours = with_yours(\"ARG3 using 1:2 with lines lt 2 title 'yours'\")\n"
              "plot ARG1 using 1:2 with lines title 'ours', @yours\n");
        write(workspace.build / "traces/07_wall_meeting" / (figure + ".tsv"), "# t[s]\tx[m]\n0\t1\n2\t3\n");
        write("demos/07_wall_meeting.js", "self.playable = {'07_wall_meeting': ''};\n");
        write(workspace.build / "play/07_wall_meeting_mine.js", "self.playable['07_wall_meeting/mine'] = '';\n");
        write(workspace.exercise(seven()), "begun");
        const Finished made = make("![Room](../../plots/07_wall_meeting_room.svg)\n\n<!-- demo: room | Throw. -->\n");
        if (made.code != 0) throw std::runtime_error{made.err};
    }

    /// `./course` with these words, where the build does this, and the student's program that.
    Finished with(const std::vector<std::string> &words, const std::string &build,
                  const std::string &program = "exit 0") const {
        write("build/default/mine/07_wall_meeting", "#!/bin/sh\n" + program + '\n');
        fs::permissions(workspace.build / "mine/07_wall_meeting", fs::perms::all);
        return (*this)(words, {instead_of("cmake", build), "DISPLAY=", "WAYLAND_DISPLAY="});
    }
    void can_compile_for_pages() const { write(workspace.build / "play/can_compile", ""); }
    std::string own(const std::string &file) const { return read(workspace.build / "mine/site" / file); }

    static constexpr const char *chapter = "chapter_07_wall_meeting.html", *room = "plots/07_wall_meeting_room.svg",
                                *own_demo = "demos/07_wall_meeting_mine.js";
    static constexpr const char *good_program =
        "printf '# t[s]\\tx[m]\\n0\\t1\\n2\\t4\\n' > \"$2/07_wall_meeting_room.tsv\"";
};

} // namespace

TEST_CASE("the student's own site has figures with their curve, demos that begin with their code, and our pages") {
    const OwnBook book;
    book.can_compile_for_pages();
    const Finished site = book.with({"site", "--mine"}, "exit 0", OwnBook::good_program);
    CHECK(site.code == 0);
    CHECK(site.out
          == "Section 6: not started, so figures and demo are ours\n"
             "Section 7: one figure shows your curve; the demo runs your code\n"
             "Your copy of the book is build/default/mine/site/index.html\n"
             "Type ./course open --mine, or ./course open 7 --mine for a section\n");
    const std::string chapter = book.own(OwnBook::chapter);
    CHECK_THAT(chapter,
               ContainsSubstring("<p class=\"own\">One figure shows your curve; the demo runs your code.</p>"));
    CHECK_THAT(chapter, ContainsSubstring("<figcaption><strong class=\"own\">With your curve.</strong> "));
    CHECK_THAT(chapter, ContainsSubstring("data-demo=\"07_wall_meeting\" data-mine>"));
    CHECK_THAT(chapter, ContainsSubstring("<script src=\"demos/07_wall_meeting.js\"></script>\n"
                                          "<script src=\"demos/07_wall_meeting_mine.js\"></script>"));
    CHECK_THAT(book.own(OwnBook::room), ContainsSubstring(">yours</"));
    CHECK_THAT(book.own(OwnBook::own_demo), ContainsSubstring("07_wall_meeting/mine"));
    CHECK_THAT(book.own("index.html"), ContainsSubstring("This copy of the book is yours"));

    CHECK(book.made(OwnBook::room) == book.read("plots/07_wall_meeting_room.svg")); // the plain site stays ours
    CHECK(book.made(OwnBook::chapter).find("own") == std::string::npos);
    CHECK_FALSE(fs::exists(book.workspace.build / "site" / OwnBook::own_demo));

    book.write(book.workspace.exercise(book.seven()), book.read(book.workspace.stub(book.seven())));
    CHECK_THAT(book.with({"site", "--mine"}, "exit 0").out, ContainsSubstring("Section 7: not started"));
    CHECK(book.own(OwnBook::room) == book.made(OwnBook::room));
    CHECK(book.own(OwnBook::own_demo).empty());
}

TEST_CASE("whatever is wrong with a student's file, their site is made, says so in one sentence, and keeps ours") {
    const OwnBook book;
    book.can_compile_for_pages();
    book.write(book.workspace.build / "plots/mine/07_wall_meeting_room.svg", "of yesterday");
    const std::string no_compiling = "case \"$*\" in *07_wall_meeting_mine) echo "
                                     "'exercises/07_wall_meeting.cpp:1:1: error: expected a wall'; exit 1;; esac";
    const std::string no_demo = "case \"$*\" in *_play_mine) echo "
                                "'exercises/07_wall_meeting.cpp:1:1: error: expected a page'; exit 1;; esac";
    const auto [build, program, sentence] = GENERATE_COPY(table<std::string, std::string, std::string>({
        {no_compiling, "exit 0", "expected a wall; figures and demo stay ours"},
        {no_demo, "exit 1", "cpp:1: expected a page"},
        {"exit 0", "kill -SEGV $$", "in which function; the figures stay ours; the demo runs your code"},
        {"exit 0", "printf '# t[s]\\tx[m]\\n0\\tnan\\n' > \"$2/07_wall_meeting_room.tsv\"",
         "07_wall_meeting_room stays ours: your functions gave nan where x[m] should stand"},
        {"exit 0", "exit 0", "does one of your functions end the program? The demo runs your code"},
        {"exit 0", "echo 'not started: 07_wall_meeting_room.tsv: the wall' >&2; exit 1",
         "one figure waits for functions that are not started"},
    }));
    const Finished site = book.with({"site", "--mine"}, build, program);
    INFO(site.out + site.err);
    CHECK(site.code == 0);
    CHECK_THAT(site.out, ContainsSubstring(sentence));
    CHECK_THAT(book.own(OwnBook::chapter),
               ContainsSubstring(sentence.substr(1)) && !ContainsSubstring("With your curve"));
    CHECK(book.own(OwnBook::room) == book.made(OwnBook::room));
    CHECK(book.own(OwnBook::own_demo).empty() == (build != "exit 0"));
}

TEST_CASE("without the student's file, or a compiler for pages, their site says so, and what to type") {
    const OwnBook book;
    const Finished site = book.with({"site", "--mine"}, "exit 0", OwnBook::good_program);
    CHECK_THAT(site.out, ContainsSubstring("Section 7: one figure shows your curve\n")
                             && ContainsSubstring("The demos run on our code, since this machine has no compiler for "
                                                  "pages; ./course play 7 --mine offers to install one\n"));
    CHECK(book.own(OwnBook::own_demo).empty());
    fs::remove(book.workspace.exercise(book.seven()));
    CHECK_THAT(book.with({"site", "--mine"}, "exit 0").out,
               ContainsSubstring("exercises/07_wall_meeting.cpp is not there, so all stays ours; `./course reset 7`"));
    CHECK_THAT(book.own(OwnBook::chapter), ContainsSubstring("<code class=\"long\">./course reset 7</code>"));
}

TEST_CASE("open --mine leads into the student's own site, and the plain one is never theirs") {
    const OwnBook book;
    CHECK_THAT(book.with({"open", "7", "--mine"}, "exit 0").out,
               ContainsSubstring("Open this file in your browser: "
                                 + (book.workspace.build / "mine/site/chapter_07_wall_meeting.html").string() + '\n'));
    CHECK_THAT(book.with({"open", "7"}, "exit 0").out,
               StartsWith("Open this file in your browser: " + (book.workspace.build / "site/chapter_07").string()));
}

TEST_CASE("play opens a chapter's first demo, and play --mine the first that begins with the student's code") {
    const OwnBook book;
    book.can_compile_for_pages();
    REQUIRE(book.make("<!-- demo: room | Throw. -->\n\n<!-- demo: room mine | Throw yours. -->\n").code == 0);
    CHECK_THAT(book.with({"play", "7"}, "exit 0").out, ContainsSubstring("chapter_07_wall_meeting.html#demo-room\n"));
    CHECK_THAT(book.with({"play", "7", "--mine"}, "exit 0").out,
               ContainsSubstring("mine/site/chapter_07_wall_meeting.html#demo-room-2\n"));
}

TEST_CASE("play opens an exercise's demo at the first place below its box, or else below a later one") {
    const OwnBook book;
    const auto box = [](const std::string &number) {
        return "> ### Your turn: " + number + " `f` (5 minutes)\n>\n> Go.\n\n";
    };
    const std::string place = "<!-- demo: room mine | Throw. -->\n\n";
    REQUIRE(book.make(place + box("7.1") + box("7.2") + place + place).code == 0);
    const auto opened = [&](const std::string &exercise) {
        const std::string words = book.with({"play", exercise}, "exit 0").out;
        return words.substr(words.rfind('#') + 1);
    };
    CHECK(opened("7") == "demo-room\n");
    CHECK(opened("7.2") == "demo-room-2\n");
    CHECK(opened("7.1") == "demo-room-2\n"); // it has none of its own
    CHECK_THAT(
        book.made(OwnBook::chapter),
        ContainsSubstring("id=\"demo-room\" data-demo=\"07_wall_meeting\" data-mine")
            && ContainsSubstring("id=\"demo-room-2\" data-demo=\"07_wall_meeting\" data-exercise=\"7.2\" data-mine"));
    CHECK_THAT(book.with({"play", "7.9"}, "exit 0").err, ContainsSubstring("7.9"));
    REQUIRE(book.make(place + place + box("7.2")).code == 0);
    CHECK(opened("7.2") == "demo-room-2\n"); // none below it
    book.can_compile_for_pages();
    REQUIRE(book.make(box("7.1") + "<!-- demo: room | Ours. -->\n\n" + place).code == 0);
    CHECK(opened("7.1") == "demo-room\n");
    CHECK_THAT(book.with({"play", "7.1", "--mine"}, "exit 0").out, ContainsSubstring("#demo-room-2\n"));
}

TEST_CASE("play --watch compiles at once and at each save, and not in between") {
    const OwnBook book;
    book.can_compile_for_pages();
    const std::string path = book.instead_of("cmake", "exit 0");
    std::string script = "{ sleep 2; touch -d '+1 minute' \"$1\"; sleep 2; touch -d '+2 minutes' \"$1\"; } & shift; "
                         "exec timeout -s INT 6 \"$@\"";
    std::vector<std::string> line{"sh", "-c", script, "sh", book.workspace.exercise(book.seven()).string()};
    for (const std::string &word :
         book.command({"play", "7", "--mine", "--watch"}, {path, "DISPLAY=", "WAYLAND_DISPLAY="}))
        line.push_back(word);
    const Finished watched = run(line, {.deadline = 30});
    std::size_t times = 0;
    for (std::size_t at = 0; (at = watched.out.find("Your code is in the demo", at)) != watched.out.npos; ++at) ++times;
    CHECK(times == 3);
    CHECK_THAT(watched.out, ContainsSubstring("Save your file, and the page takes it up. Ctrl-C ends this."));
}

TEST_CASE("play --mine keeps what else is the student's in their own site") {
    const OwnBook book;
    book.can_compile_for_pages();
    REQUIRE(book.with({"site", "--mine"}, "exit 0", OwnBook::good_program).code == 0);
    const Finished played = book.with({"play", "7", "--mine"}, "exit 0");
    CHECK_THAT(played.out, ContainsSubstring("Your code is in the demo")
                               && ContainsSubstring("mine/site/chapter_07_wall_meeting.html#demo-room"));
    CHECK_THAT(book.own(OwnBook::room), ContainsSubstring(">yours</"));
    CHECK_THAT(book.own(OwnBook::own_demo), ContainsSubstring("07_wall_meeting/trouble'] = \"\""));
}
