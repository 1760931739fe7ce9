#include "book/budgets.hpp"

#include "book/chapter.hpp"
#include "book/demo_places.hpp"
#include "book/markdown.hpp"
#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace course {
namespace {

/// The words of a line as they are read; a formula is one word.
int words_in(const std::string &line) {
    std::istringstream words{take_out_formulas(line).text};
    int count = 0;
    for (std::string word; words >> word;)
        if (std::any_of(word.begin(), word.end(),
                        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c < 0; }))
            ++count;
    return count;
}

/// Whether the line asks the reader to do something: play, guess, or write code.
bool is_task(std::string_view line) {
    return contains(line, "<!-- demo:") || contains(line, "*Try it") || contains(line, "**Pencil")
           || contains(line, "Your turn:") || contains(line, "**Your test") || contains(line, "**Finish ");
}

/// Reads a chapter from line to line.
class Meter {
  public:
    explicit Meter(std::string_view text_) : chapter{text_} {}

    std::vector<Budget> read() {
        walk(
            chapter, [this](std::string_view text, int number, bool folded) { line(text, number, folded); },
            [this](const Fence &fence, bool folded) { listing(fence, folded); });
        end_reading();
        return budgets();
    }

  private:
    void line(std::string_view text, int number, bool folded) {
        if (folded || text.empty()) return;
        if (text.starts_with("## ")) outputs = 0;
        if (is_task(text)) {
            if (first_task == 0) first_task = number, words_before = words_since;
            end_reading();
            reading_from = number;
        }
        if (text.starts_with("#") && contains(text, "Your turn:") && first_box == 0) first_box = number;
        minutes_in(text, number);
        if (text.starts_with("<!--") || stands_for_a_demo(text)) return;
        ++prose;
        if (!text.starts_with("|") && !text.starts_with("#")) words_since += words_in(std::string{text});
    }

    /// A row of the chapter's table: `| 7.1 | ... | core | 25 + 10 |`.
    void minutes_in(std::string_view text, int number) {
        static const std::regex row{R"(\| *\d+\.\d+ *\|.*\| *(\w+) *\| *(?:(\d+) *\+ *)?(\d+)[^|\d]*\|)"};
        std::match_results<std::string_view::const_iterator> found;
        if (!std::regex_match(text.begin(), text.end(), found, row)) return;
        const int doing = std::stoi(found[3]), reading = found[2].matched ? std::stoi(found[2]) : 0;
        worst(longest_part, reading + doing, number);
        if (found[1] == "core") worst(longest_core, doing, number);
    }

    void end_reading() {
        worst(longest_reading, words_since, reading_from);
        words_since = 0;
    }

    void listing(const Fence &fence, bool folded) {
        if (folded) return;
        const int length = static_cast<int>(fence.content.size());
        listings += length;
        worst(longest_listing, length, fence.line);
        if (length == 0) return;
        if (contains(fence.content.front(), "$ ./course run")) worst(longest_output, outputs += length - 1, fence.line);
        if (std::any_of(fence.content.begin(), fence.content.end(),
                        [](const auto &code) { return code.starts_with("TEST_CASE("); }))
            worst(tests, tests.value + length - 1, fence.line);
    }

    struct Most {
        int value = 0, line = 1;
    };
    static void worst(Most &most, int value, int line) {
        if (value > most.value) most = {value, line};
    }

    std::vector<Budget> budgets() const {
        const int all = static_cast<int>(lines_of(chapter).size());
        const auto share = [](int part, int whole) { return whole == 0 ? 0 : (100 * part + whole - 1) / whole; };
        return {
            {"first box", "% of the chapter before its first \"Your turn\" box", 20,
             first_box == 0 ? 100 : share(first_box - 1, all), std::max(first_box, 1),
             "let the reader write something sooner"},
            {"listings", "unfolded lines of code for 100 lines of prose", 40, share(listings, prose), 1,
             "fold code that the reader need not read to go on"},
            {"longest listing", "lines of the longest unfolded listing", 15, longest_listing.value,
             longest_listing.line, "split it, or fold it"},
            {"tests", "unfolded lines of tests", 8, tests.value, tests.line,
             "show one short test, and fold the others"},
            {"output", "unfolded lines of output in one part", 8, longest_output.value, longest_output.line,
             "show the part that this is about, `./course run N PART`, or fold it"},
            {"opening", "words before the reader does something", 80, first_task == 0 ? words_total() : words_before,
             std::max(first_task, 1), "ask for a guess, or show the demo, sooner"},
            {"reading", "words between two things to do", 500, longest_reading.value, longest_reading.line,
             "ask the reader to guess, to play or to write in between"},
            {"part", "minutes for one part, read and done", 45, longest_part.value, longest_part.line,
             "split the exercise"},
            {"core box", "minutes for a core exercise", 20, longest_core.value, longest_core.line,
             "split the exercise"},
        };
    }
    int words_total() const { return longest_reading.value; } // nothing to do: all of it is one reading

    std::string_view chapter;
    int prose = 0, listings = 0, outputs = 0, first_box = 0, first_task = 0;
    int words_since = 0, words_before = 0, reading_from = 1;
    Most longest_listing, longest_output, longest_reading, longest_part, longest_core, tests;
};

struct Exception {
    int allowed = 0, line = 0;
};

} // namespace

std::vector<Budget> budgets_of(std::string_view chapter) { return Meter{chapter}.read(); }

std::vector<Finding> exceeded_budgets(std::string_view chapter, const std::filesystem::path &file) {
    static const std::regex stated{R"(<!-- budget: ([a-z ]+?) (\d+), since \S.* -->)"};
    std::vector<Finding> findings;
    std::map<std::string, Exception> exceptions;
    int number = 0;
    for (const Line &line : lines_of(chapter)) {
        ++number;
        if (!contains(line.text, "<!-- budget:")) continue;
        std::match_results<std::string_view::const_iterator> found;
        if (std::regex_search(line.text.begin(), line.text.end(), found, stated))
            exceptions[found[1]] = {std::stoi(found[2]), number};
        else
            findings.push_back(
                {file, number,
                 "write an exception as `<!-- budget: longest listing 22, since ... -->`, with its reason."});
    }
    for (const Budget &budget : budgets_of(chapter)) {
        const auto found = exceptions.find(budget.name);
        const Exception exception = found == exceptions.end() ? Exception{budget.limit, 0} : found->second;
        exceptions.erase(budget.name);
        if (budget.value > exception.allowed)
            findings.push_back({file, budget.line,
                                std::to_string(budget.value) + ' ' + budget.what + ", where "
                                    + std::to_string(exception.allowed) + " are the most: " + budget.remedy
                                    + ", or write `<!-- budget: " + budget.name + ' ' + std::to_string(budget.value)
                                    + ", since ... -->` with a reason."});
        else if (exception.line != 0 && budget.value <= budget.limit)
            findings.push_back({file, exception.line,
                                "this exception is no longer needed, for " + std::to_string(budget.value)
                                    + " are within the budget; take it out."});
    }
    for (const auto &[name, exception] : exceptions)
        findings.push_back({file, exception.line, "there is no budget called \"" + name + "\"."});
    return findings;
}

} // namespace course
