#include "book/budgets.hpp"
#include "book/voice.hpp"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>

using namespace course;

namespace {

Budget budget(const std::string &chapter, const std::string &name) {
    const auto all = budgets_of(chapter);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Budget &b) { return b.name == name; });
    REQUIRE(found != all.end());
    return *found;
}

std::string repeated(const std::string &text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

std::string listing(int lines, const std::string &first = "int x;\n") {
    return "```cpp\n" + first + repeated("int y;\n", lines - 1) + "```\n\n";
}

std::string folded(const std::string &text) { return "<details><summary>More</summary>\n\n" + text + "</details>\n\n"; }

const std::string box = "> ### Your turn: 7.1 `meet` (10 minutes)\n>\n> Write it.\n\n";

std::vector<std::string> complaints(const std::string &chapter) {
    std::vector<std::string> messages;
    for (const Finding &finding : exceeded_budgets(chapter, "README.md")) messages.push_back(finding.message);
    return messages;
}

} // namespace

TEST_CASE("the first box is looked for where its heading is, in or out of a quote") {
    CHECK(budget(repeated("Words.\n", 10) + "### Your turn: 7.1 `meet`\n" + repeated("Words.\n", 89), "first box").value
          == 10);
    CHECK(budget(repeated("Words.\n", 50) + box, "first box").line == 51);
    CHECK(budget("Your turn: said in passing.\n", "first box").value == 100);
}

TEST_CASE("code counts against prose, folded code does not, and the longest listing is named with its line") {
    const std::string prose = repeated("A sentence.\n", 10) + '\n';
    CHECK(budget(prose + listing(4), "listings").value == 40);
    CHECK(budget(prose + folded(listing(40)), "listings").value == 0);
    const Budget longest = budget(prose + listing(3) + listing(16) + folded(listing(30)), "longest listing");
    CHECK(longest.value == 16);
    CHECK(longest.line == 18);
    CHECK(budget(prose + "> ```cpp\n> int x;\n> int y;\n> ```\n", "longest listing").value == 2);
}

TEST_CASE("unfolded tests are added up, output within each part") {
    CHECK(budget(listing(5, "//> A test\n") + listing(3, "TEST_CASE(\"a\", \"[7.1]\") {\n")
                     + folded(listing(9, "TEST_CASE(\"b\", \"[7.1]\") {\n")),
                 "tests")
              .value
          == 2);
    const std::string output = "```console\n$ ./course run 7 walls\none\ntwo\n```\n\n";
    CHECK(budget("## One\n\n" + output + output + "## Two\n\n" + output, "output").value == 4);
}

TEST_CASE("words are counted up to what the reader does, and from there to the next; a formula is one word") {
    const std::string ten = "One two three four five six seven $a + b = c$ nine ten.\n";
    CHECK(budget(ten + ten + "*Try it: throw the ball.*\n" + ten, "opening").value == 20);
    CHECK(budget(ten, "opening").value == 10);
    for (const std::string &task :
         std::vector<std::string>{"<!-- demo: room -->\n", "**Pencil (1 minute).** Guess.\n", box, "**Finish 7.1.**\n",
                                  "> **Your test (10 minutes).** A law.\n"})
        CHECK(budget(ten + task + ten, "opening").value == 10);
    const Budget reading = budget("**Pencil.**\n" + repeated(ten, 3) + folded(repeated(ten, 9)) + box + ten, "reading");
    CHECK(reading.value == 31); // with the word that asks for it
    CHECK(reading.line == 1);
}

TEST_CASE("what stands for a demo on a forge is no reading") {
    const std::string demo = "<!-- demo: room | Throw. -->\n\n";
    const std::string shown =
        "![A ball in a room](../../demos/07_wall.svg)\n\n*Play it:* `./course play 7`. Throw.\n\n";
    CHECK(budget(demo + shown + "One two three.\n", "reading").value == 3);
    CHECK(budget(demo + "*Play it* again.\n", "reading").value == 3);
}

TEST_CASE("minutes are those of the chapter's table, reading and doing") {
    const std::string table =
        "| | you write | level | minutes |\n|:--|:--|:--|--:|\n"
        "| 7.1 | `meet`: [do they](#x) | core | 25 + 21 |\n| 7.2 | `turn`: round | stretch | 45 |\n";
    CHECK(budget(table, "part").value == 46);
    CHECK(budget(table, "core box").value == 21);
    CHECK(budget("| 7.2 | `turn`: round | challenge | 50 min |\n", "part").value == 50);
}

TEST_CASE("what exceeds its budget is said with the remedy, unless the chapter says why; not for longer than needed") {
    const std::string chapter = box + repeated("A sentence.\n", 100) + '\n' + listing(16);
    REQUIRE(complaints(chapter).size() == 1);
    CHECK(complaints(chapter).front()
          == "16 lines of the longest unfolded listing, where 15 are the most: split it, or fold it, or write "
             "`<!-- budget: longest listing 16, since ... -->` with a reason.");

    const std::string exception = "\n<!-- budget: longest listing 16, since it is one table -->\n";
    CHECK(complaints(chapter + exception).empty());
    CHECK(complaints(chapter + listing(17) + exception).size() == 1);
    CHECK(complaints(box + repeated("A sentence.\n", 100) + exception)
          == std::vector<std::string>{"this exception is no longer needed, for 0 are within the budget; take it out."});
    CHECK(complaints(chapter + "\n<!-- budget: longest listing 16 -->\n").size() == 2);
    CHECK(complaints(box + repeated("A sentence.\n", 100) + "\n<!-- budget: patience 3, since -->\n").size() == 1);
    CHECK(complaints(box + repeated("A sentence.\n", 100) + "\n<!-- budget: patience 3, since ever -->\n")
          == std::vector<std::string>{"there is no budget called \"patience\"."});
}

TEST_CASE("a chapter is told of its habits, each with the last line that has it") {
    const std::string good = "# 7 Wall\n\nIt's high, isn't it? You'll see why it can't fall.\n\n";
    const auto told = [](const std::string &chapter) {
        std::vector<std::string> all;
        for (const Finding &finding : out_of_voice(chapter, "7.md"))
            all.push_back(std::to_string(finding.line) + ' ' + finding.message);
        return all;
    };
    CHECK(told(good).empty());
    using List = std::vector<std::string>;
    CHECK(told(good + "The ball begins here.\nIt has not begun.\nWe begin.\n")
          == List{"7 the voice: 3 times \"begin\", for \"start\", where 1 are the most."});
    CHECK(told(good + "## Further\n") == List{"5 the voice: 1 times a standing heading, where 0 are the most."});
    CHECK(told(good + "> ### What your function must do\n").size() == 1);
    CHECK(told(good + "That one is wanted.\n").size() == 1);
    CHECK(told(good + "Which way? All the way.\nBy the way, a way.\n").empty());
    CHECK(told(good + "A way, and another way.\n").size() == 1);

    // what is folded away, a listing, a formula or a comment is not heard
    const std::string begin = "begin, begin, begin\n";
    CHECK(told(good + "```text\n" + begin + "```\n\n<details><summary>Answer</summary>\n\n" + begin
               + "</details>\n\n<!-- words: begin, begin -->\n\n$\\begin{pmatrix}\\begin{a}\\begin{b}$\n")
              .empty());
    CHECK(told(good + "<details><summary>Answer</summary>\n\nNo.\n</details>\n\n" + begin).size() == 1);

    // all hints of an exercise are one fold
    const auto folds = [](int count, const std::string &summary) {
        std::string text;
        while (count-- > 0) text += "<details><summary>" + summary + "</summary>\n\nx\n</details>\n\n";
        return text;
    };
    CHECK(told(good + folds(30, "7.1, a hint: why")).empty());
    CHECK(told(good + folds(25, "Answer")).empty());
    CHECK(told(good + folds(26, "Answer")) == List{"1 the voice: 26 folds, where 25 are the most."});

    std::string stiff;
    for (int i = 0; i < 100; ++i) stiff += "A wall stands on a hill.\n";
    CHECK(told(stiff) == List{"1 the voice: 0 contractions, where 3 are the fewest."});
}
