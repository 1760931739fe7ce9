#include "grade/handout.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/process.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "book/chunks.hpp"
#include "book/front_door.hpp"
#include "book/links.hpp"
#include "check/which_tests.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// What stays of tests/NN_slug: mutants and variants give answers away.
constexpr std::array stays_with_tests{"tests.cpp", "stub.cpp", "mistakes.tsv"};

/// What gives answers away, or tests and describes the whole course.
constexpr std::array not_in_a_handout{
    "solutions",
    "tests/hostile",
    "tests/verdicts",
    "tests/bugs.mjs",
    "tests/bugs.txt",
    "tests/peers",
    "tests/tools",
    "tests/online",
    "tests/site",
    "tests/play",
    "tests/class",
    "tests/points.txt",
    "tests/CMakeLists.txt",
    "tests/fresh_machine.sh",
    "tests/under_load.sh",
    "tools/online",
    "docs/instructors.md",
    "exercises/sketches",
    "CONTRIBUTING.md",
    "ARCHITECTURE.md",
    "docs/authors.md",
    "docs/voice.cjs",
    "CHANGELOG.md",
    ".ci",
    ".github",
};

constexpr const char *what_a_handout_is = R"(# This is a handout

It's *Frame by Frame* without our solutions: your instructor has those.
Everything else is here: the chapters, their hints and demos, the exercises, and the tests that tell you what's right.
A later section builds on what you wrote in an earlier one, so finish that one first.

## What to hand in

One file, the section's own: for section 5, `exercises/05_inclined_planes.cpp`.
Keep its name, and don't pack it, rename it, or paste it into a document.
It may be half done: each function counts by itself.
Your feedback comes back as a text, under your file's name in Canvas and as `feedback.txt` in Moodle.
)";

using Lines = std::vector<std::string>;

bool begins_with(const std::string &line, std::string_view words) { return trim(line).starts_with(words); }

/// The end of a bar, `<details>`, that begins in this line: the place behind the last line.
std::size_t end_of_bar(const Lines &lines, std::size_t first) {
    std::size_t depth = 0;
    for (std::size_t i = first; i < lines.size(); ++i) {
        if (begins_with(lines[i], "<details>")) ++depth;
        if (contains(lines[i], "</details>") && --depth == 0) return i + 1;
    }
    return lines.size();
}

/// The end of a block of code that begins with this fence.
std::size_t end_of_code(const Lines &lines, std::size_t first) {
    const auto ends = [](const std::string &line) { return begins_with(line, "```"); };
    const auto last = std::find_if(lines.begin() + static_cast<long>(first) + 1, lines.end(), ends);
    return static_cast<std::size_t>(last - lines.begin()) + (last == lines.end() ? 0 : 1);
}

/// Takes out the lines from `first` to before `end`, and the blank lines behind them.
void take_out(Lines &lines, std::size_t first, std::size_t end) {
    while (end < lines.size() && trim(lines[end]).starts_with('\n')) ++end;
    lines.erase(lines.begin() + static_cast<long>(first), lines.begin() + static_cast<long>(end));
}

/// Without the blocks of code that are solutions, from `first` to before `end`.
void without_solution_code(Lines &lines, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end;) {
        const std::size_t next = begins_with(lines[i], "```") ? end_of_code(lines, i) : i + 1, before = lines.size();
        if (next > i + 1 && begins_with(lines[i + 1], "//> Solution")) take_out(lines, i, next);
        else i = next;
        end -= before - lines.size();
    }
}

/// A bar "Our solution of 7.2" goes; of "Our solution of 12.1, and the frame loop that calls it" the frame loop stays.
void without_solution_bars(Lines &lines) {
    static const std::regex bar{R"(<details><summary>Our solution of (\d+\.\d+)(?:, and (.*?)( it)?)?</summary>\s*)"};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch match;
        const std::string line = lines[i];
        if (!std::regex_match(line, match, bar)) continue;
        const std::size_t end = end_of_bar(lines, i);
        if (!match[2].matched) {
            take_out(lines, i--, end);
            continue;
        }
        lines[i] = "<details><summary>" + with_capital(match[2]) + (match[3].matched ? " " + match[1].str() : "")
                   + "</summary>\n";
        without_solution_code(lines, i, end);
    }
}

/// Takes out what begins with a line for which `first` is true, and ends before one for which `next` is.
void without(Lines &lines, const auto &first, const auto &next) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!first(lines[i])) continue;
        const auto end = std::find_if(lines.begin() + static_cast<long>(i) + 1, lines.end(), next);
        take_out(lines, i--, static_cast<std::size_t>(end - lines.begin()));
    }
}

const auto any_line = [](const std::string &) { return true; };
auto beginning(std::string words) {
    return [words](const std::string &line) { return begins_with(line, words); };
}

/// Commands that need our answers.
constexpr std::array commands_with_answers{"solution", "bug", "mytests", "dev bench"};

/// Without what our answers are for: their commands, bugs to hunt, tests to write against them, and comparisons with others.
void without_what_needs_answers(Lines &lines) {
    for (const char *command : commands_with_answers)
        std::erase_if(lines, beginning(std::string{"| `./course "} + command + ' '));
    without(lines, beginning("Three bugs to hunt: "), any_line);
    without(lines, beginning("<!-- which is wrong -->"), any_line);
    without(lines, beginning("> **Your test"), [](const std::string &line) { return !line.starts_with('>'); });
    without(lines, beginning("- How far can you trust our solutions?"),
            [](const std::string &line) { return !line.starts_with(' ') && line != "\n"; });
}

/// Without a heading's part of a page.
void without_part(Lines &lines, const std::string &heading) {
    without(lines, beginning("## " + heading),
            [](const std::string &line) { return line.starts_with("## ") || line.starts_with("MIT licence"); });
}

bool is_text(const fs::path &file) {
    return is_any_of(file.extension().string(), {".md", ".html", ".js", ".json", ".txt", ".tsv", ".hpp", ".cpp", ".svg",
                                                 ".gp", ".cjs", ".mjs", ".sh", ".cmake", ".diff", ""});
}

/// The files in a folder and in all below it, without what git and a build keep there.
std::vector<fs::path> all_files(const fs::path &folder) {
    std::vector<fs::path> files;
    for (auto each = fs::recursive_directory_iterator{folder}; each != fs::recursive_directory_iterator{}; ++each)
        if (is_any_of(each->path().filename().string(), {".git", "build"})) each.disable_recursion_pending();
        else if (each->is_regular_file()) files.push_back(each->path());
    std::ranges::sort(files);
    return files;
}

/// Code without what a page puts between letters: elements and escapes of HTML or of a script, and blanks.
std::string bare(std::string_view text, bool is_html = false) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> escapes{
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}, {"\\n", ""}, {"\\\"", "\""}}};
    std::string out;
    while (!text.empty()) {
        const auto escape = std::ranges::find_if(escapes, [&](const auto &one) { return text.starts_with(one.first); });
        if (is_html && text[0] == '<') {
            text.remove_prefix(std::min(text.find('>'), text.size() - 1) + 1);
        } else if (escape != escapes.end()) {
            out += escape->second;
            text.remove_prefix(escape->first.size());
        } else {
            if (!contains(" \n\r\t", text.substr(0, 1))) out += text[0];
            text.remove_prefix(1);
        }
    }
    return out;
}

/// A chapter without listings: what boxes and hints tell in so many words.
std::string without_listings(const std::string &chapter) {
    Lines lines = with_line_ends(chapter);
    for (std::size_t i = 0; i < lines.size();)
        if (lines[i].starts_with("```")) take_out(lines, i, end_of_code(lines, i));
        else ++i;
    return joined(lines);
}

/// What a student may read of a section in any edition, though the solution has it, too.
std::string public_code(const Workspace &workspace, const Section &section) {
    std::string text = read_file(workspace.stub(section)) + read_file(workspace.tests(section))
                       + without_listings(read_file(workspace.chapter(section)));
    for (const char *end : {".hpp", ".cpp"})
        for (const fs::path &file : files_in(workspace.chapter(section).parent_path(), end)) text += read_file(file);
    return bare(text);
}

constexpr std::size_t telling_size = 24,
                      lines_enough = 3; ///< a line as long as this, without blanks; so many for each exercise

struct Telling {
    fs::path file;
    int line;
    std::string code; ///< bare
};

/// The longest lines of each exercise's solution that stand nowhere else.
void add_telling_lines(const Workspace &workspace, const Section &section, const std::string &known,
                       std::vector<Telling> &all) {
    if (!workspace.has_solution(section)) return;
    for (const Chunk &chunk : cut(workspace.solution(section))) {
        std::vector<Telling> candidates;
        for (std::size_t i = 1; i < chunk.lines.size(); ++i)
            if (const std::string code = bare(chunk.lines[i]);
                code.size() >= telling_size && !code.starts_with("//") && !contains(known, code))
                candidates.push_back({workspace.solution(section), chunk.line + static_cast<int>(i), code});
        std::ranges::stable_sort(candidates, std::greater{}, [](const Telling &one) { return one.code.size(); });
        candidates.resize(std::min(candidates.size(), lines_enough));
        std::ranges::move(candidates, std::back_inserter(all));
    }
}

/// The text of a file; of a packed demo, what is packed in it.
std::string text_in(const Workspace &workspace, const fs::path &file) {
    if (file.extension() == ".js" && read_file(file).starts_with("(self.playable"))
        return printed_by({in_path("node") ? "node" : "nodejs", (workspace.root / "tools/play/pack.cjs").string(),
                           "--unpack", file.string()},
                          workspace.root);
    return read_file(file);
}

void find_leaks(const Workspace &workspace, const std::vector<Telling> &lines, const fs::path &file,
                std::vector<Finding> &findings) {
    if (!is_text(file)) return;
    const std::string code = bare(text_in(workspace, file), file.extension() == ".html");
    for (const Telling &line : lines)
        if (contains(code, line.code))
            findings.push_back({file, 0,
                                "has a line of our solution, " + workspace.relative_name(line.file) + ':'
                                    + std::to_string(line.line)});
}

/// Words of pages, and what stands there in a handout.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> replaced_words{{
    {"then our solution of 3.2 answers, whether you have written yours or not.", "then your own 3.2 answers."},
    {"`./course dev bench pairs` measures all three ways on your machine.", "We measured all three ways."},
    {"`./course dev bench particles` measures three pools on your machine; in", "We measured three pools: in"},
    {"; how to fix a line or add a section is in [CONTRIBUTING](CONTRIBUTING.md)", ""},
    {" What has changed: [CHANGELOG](CHANGELOG.md).", ""},
    {"\nOn Debian 12 or later",
     "\nThis edition is [a handout](HANDOUT.md): your instructor has the solutions.\n\nOn Debian 12 or later"},
}};

/// What a page says that isn't so in a handout: links that lead nowhere, and commands that need our answers.
std::vector<Finding> untrue_in(const fs::path &page, const fs::path &folder) {
    const std::string text = read_file(page);
    std::vector<Finding> findings = dead_links(page, text, folder);
    int number = 0;
    for (const Line &line : split_lines(text)) {
        ++number;
        for (const char *command : commands_with_answers)
            if (contains(line.text, std::string{"./course "} + command + ' '))
                findings.push_back(
                    {page, number, std::string{"names `./course "} + command + "`, which needs our answers"});
        if (contains(line.text, "ur solution of ")) findings.push_back({page, number, "speaks of our solution"});
    }
    return findings;
}

} // namespace

std::string page_in_handout(const std::string &file, std::string page) {
    Lines lines = with_line_ends(page);
    without_solution_bars(lines);
    without_what_needs_answers(lines);
    if (file == "README.md")
        for (const char *heading : {"I want nobody to install", "I want to fix a line", "I teach with it"})
            without_part(lines, heading);
    if (file == "docs/front.md")
        for (const char *words : {"**You teach?**", "**You'd mend a line"}) std::erase_if(lines, beginning(words));
    page = joined(lines);
    if (file == "README.md") page = with_front_door(page, ""); // our solutions are there
    for (const auto &[words, instead] : replaced_words) replace_all(page, words, instead);
    return page;
}

void make_handout(const fs::path &folder) {
    for (const char *each : not_in_a_handout) fs::remove_all(folder / each);
    fs::remove_all(folder / "exercises"); // an instructor may have solved some
    const Workspace workspace{.root = folder, .build = {}};
    for (const Section &section : workspace.sections()) {
        const WhichTests tests = which_tests(hash_of_tests(workspace, section), version_of(workspace));
        const std::string stub = without_stamp(read_file(workspace.stub(section))) + stamp_of(tests);
        for (const fs::path &file : {workspace.stub(section), workspace.exercise(section)}) write_file(file, stub);
        const fs::directory_iterator beside{workspace.tests_folder(section)};
        for (const fs::path &file : std::vector<fs::path>(begin(beside), end(beside)))
            if (std::ranges::find(stays_with_tests, file.filename()) == stays_with_tests.end()) fs::remove_all(file);
    }
    for (const fs::path &file : all_files(folder))
        if (file.extension() == ".md")
            write_file(file, page_in_handout(file.lexically_relative(folder).generic_string(), read_file(file)));
    write_file(folder / handout_mark, what_a_handout_is);
}

std::vector<Finding> leaks(const Workspace &workspace, const fs::path &folder) {
    std::vector<Telling> lines;
    std::string known;
    for (const Section &section : workspace.sections()) known += public_code(workspace, section);
    for (const Section &section : workspace.sections()) add_telling_lines(workspace, section, known, lines);
    std::vector<Finding> findings;
    for (const fs::path &file : all_files(folder)) {
        find_leaks(workspace, lines, file, findings);
        if (file.extension() == ".md") std::ranges::move(untrue_in(file, folder), std::back_inserter(findings));
    }
    return findings;
}

} // namespace course
