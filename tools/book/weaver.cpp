#include "book/weaver.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "book/chapter.hpp"
#include "book/chunks.hpp"
#include "check/catalogue.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> figures(const Workspace &workspace, const Section &section) {
    return files_in(workspace.root / "plots", ".gp", section.name + "_");
}

/// What a fence is to hold, and where that comes from.
struct Expected {
    std::vector<std::string> lines;
    std::string title;                              ///< "the output", "A normal"
    std::optional<fs::path> file;                   ///< of the code, if it is a listing
    std::function<std::string(std::size_t)> source; ///< where the n-th line comes from: "chapters/.../main.cpp:12"
};

class Weaver {
  public:
    Weaver(const Workspace &tree_, const Page &page_, std::string_view text_, const Output &output_)
        : workspace{tree_}, page{page_}, text{text_}, output{output_} {}

    Woven weave() {
        const Chapter chapter = read_chapter(text, page.file);
        find_chunks();
        result.broken = !chapter.broken.empty();
        if (!result.broken) weave_into(chapter);
        else {
            result.text = text;
            result.findings.insert(result.findings.end(), chapter.broken.begin(), chapter.broken.end());
        }
        std::ranges::sort(result.findings);
        return std::move(result);
    }

  private:
    std::string place(const fs::path &file, int line) const {
        return fmt::format("{}:{}", workspace.relative_name(file), line);
    }
    void find(const fs::path &file, int line, std::string message) {
        result.findings.push_back({file, line, std::move(message)});
    }

    void weave_into(const Chapter &chapter) {
        const std::size_t mark = byte_order_mark(text).size();
        const std::vector<Line> lines = split_lines(text.substr(mark));
        result.text = text.substr(0, mark);
        std::size_t done = 0;
        const auto keep_until = [&](std::size_t line) {
            for (; done < line; ++done) (result.text += lines[done].text) += lines[done].end;
        };
        for (const Fence &fence : chapter.fences) {
            const auto expected = expected_in(fence);
            if (!expected) continue;
            keep_until(static_cast<std::size_t>(fence.line) - 1);
            write(fence, *expected, lines);
            done = static_cast<std::size_t>(fence.end);
        }
        keep_until(lines.size());
        find_unshown();
    }

    void find_chunks() {
        for (const fs::path &file : page.code)
            for (Chunk &chunk : cut(file)) {
                if (chunk.lines.size() == 1)
                    find(file, chunk.line,
                         fmt::format("the chunk \"{}\" is empty; write its code below, or take the mark out.",
                                     chunk.title));
                const auto [first, is_new] = chunks.try_emplace(chunk.title, chunk);
                if (!is_new)
                    find(file, chunk.line,
                         fmt::format("there is a chunk called \"{}\" in {} already; give one of them another title.",
                                     chunk.title, place(first->second.file, first->second.line)));
            }
        for (const fs::path &file : page.whole)
            if (const auto finding = unmarked_code(file)) result.findings.push_back(*finding);
    }

    void find_unshown() {
        for (const auto &[title, chunk] : chunks)
            if (!line_of.contains(title)
                && (title.starts_with("The frame loop") || std::ranges::count(page.required, chunk.file) > 0))
                find(chunk.file, chunk.line,
                     fmt::format("the chunk \"{}\" is not shown in {}; put a fence there whose first line is `{}`, or "
                                 "take the title out of the mark if the code is to stay out.",
                                 title, workspace.relative_name(page.file), chunk.lines.front()));
    }

    /// Nothing if the fence is not woven, or cannot be.
    std::optional<Expected> expected_in(const Fence &fence) {
        if (fence.content.empty()) return {};
        if (fence.language == "console") return output_in(fence);
        const auto title = mark_title(fence.content.front());
        if (!title) return {};
        ++result.listings;
        return chunk_in(fence, *title);
    }

    std::optional<Expected> chunk_in(const Fence &fence, const std::string &title) {
        const int line = fence.line + 1;
        if (title.empty())
            return find(page.file, line, "this mark has no title; name the chunk that belongs here."), std::nullopt;
        const auto chunk = chunks.find(title);
        if (chunk == chunks.end()) {
            std::vector<std::string> titles;
            for (const auto &each : chunks) titles.push_back(each.first);
            return find(page.file, line,
                        fmt::format("there is no chunk called \"{}\"; write that mark into the code, or correct it "
                                    "here.{}",
                                    title, did_you_mean(title, titles))),
                   std::nullopt;
        }
        const auto [first, is_new] = line_of.try_emplace(title, line);
        if (!is_new)
            find(page.file, line,
                 fmt::format("the chunk \"{}\" is shown in line {} already; keep one of the two.", title,
                             first->second));
        return Expected{
            chunk->second.lines, '"' + title + '"', chunk->second.file,
            [this, from = chunk->second](std::size_t n) { return place(from.file, from.line + static_cast<int>(n)); }};
    }

    std::optional<Expected> output_in(const Fence &fence) {
        static const std::regex command{R"(\$ \./course run (\S+)( [^-\s]\S*)?( --mine)?\s*)"};
        std::smatch match;
        if (!std::regex_match(fence.content.front(), match, command)) return {};
        ++result.outputs;
        Expected expected{
            {fence.content.front()}, "this output", {}, [name = match[1].str() + match[2].str()](std::size_t) {
                return "what ./course run " + name + " prints";
            }};
        const std::string part = match[2].matched ? match[2].str().substr(1) : "";
        const std::string printed = output(workspace.section(match[1].str()), part);
        for (const Line &line : split_lines(printed)) expected.lines.emplace_back(line.text);
        while (trim(expected.lines.back()).empty()) expected.lines.pop_back();
        return expected;
    }

    /// Long enough for its code: a line that looks like a fence must not end it.
    static std::size_t length_for(const Fence &fence, const std::vector<std::string> &code) {
        std::size_t length = fence.length;
        for (const std::string &line : code) length = std::max(length, run_of(fence.sign, line) + 1);
        return length;
    }

    void write(const Fence &fence, const Expected &expected, const std::vector<Line> &lines) {
        const auto opening = static_cast<std::size_t>(fence.line) - 1,
                   closing = static_cast<std::size_t>(fence.end) - 1;
        const std::string_view end = lines[opening].end;
        const std::string_view first = lines[opening + 1].text, inside = fence.content.front();
        if (!first.ends_with(inside))
            throw UserError{place(page.file, fence.line + 1)
                            + ": write the start of this line with blanks instead of tabs, so that it can be woven."};
        const std::string prefix{first.substr(0, first.size() - inside.size())}; // what a quote or a list wants there

        const std::size_t longer = length_for(fence, expected.lines) - fence.length;
        const std::string_view old_closing = without_blanks_behind(lines[closing].text);
        std::vector<std::string> block;
        block.push_back(std::string{lines[opening].text}.insert(fence.column, longer, fence.sign));
        for (const std::string &line : expected.lines)
            block.push_back(line.empty() ? std::string{without_blanks_behind(prefix)} : prefix + line);
        block.push_back(std::string{longer == 0 ? lines[closing].text : old_closing}.append(longer, fence.sign));

        compare(fence, expected, block, lines);
        for (std::size_t i = 0; i + 1 < block.size(); ++i) (result.text += block[i]) += end;
        (result.text += block.back()) += lines[closing].end;
    }

    void compare(const Fence &fence, const Expected &expected, const std::vector<std::string> &block,
                 const std::vector<Line> &lines) {
        const auto opening = static_cast<std::size_t>(fence.line) - 1;
        const auto old_size = static_cast<std::size_t>(fence.end - fence.line) + 1;
        for (std::size_t i = 0; i < std::max(old_size, block.size()); ++i) {
            const bool both = i < old_size && i < block.size();
            const bool same_end = both && (i + 1 == block.size() || lines[opening + i].end == lines[opening].end);
            if (same_end && lines[opening + i].text == block[i]) continue;
            const std::size_t line = std::min(i, old_size - 1),
                              in_source = std::clamp<std::size_t>(i, 1, expected.lines.size()) - 1;
            result.differences.push_back(
                {page.file, fence.line + static_cast<int>(line),
                 fmt::format("{} differs here from {}.", expected.title, expected.source(in_source))});
            if (expected.file) result.code.insert(*expected.file);
            return;
        }
    }

    const Workspace &workspace;
    const Page &page;
    std::string_view text;
    const Output &output;
    std::map<std::string, Chunk> chunks;
    std::map<std::string, int> line_of; ///< of the page, for each chunk that it shows
    Woven result;
};

/// Whether a header's code names this function, type or constant.
bool names(const std::string &header, const std::string &name) {
    const std::regex word{"\\b" + name + "\\b"};
    for (const Line &line : split_lines(header)) {
        const std::string_view code = line.text.substr(0, line.text.find("//"));
        if (std::regex_search(code.begin(), code.end(), word)) return true;
    }
    return false;
}

} // namespace

Page page_of(const Workspace &workspace, const Section &section) {
    Page page{workspace.chapter(section),
              {workspace.header(section), workspace.program(section)},
              {},
              {workspace.header(section)}};
    if (workspace.has_solution(section)) {
        page.code.push_back(workspace.solution(section));
        page.required.push_back(workspace.solution(section));
    }
    for (const fs::path &file : files_in(page.file.parent_path(), "pp")) // a benchmark, and what it measures
        if (std::ranges::find(page.code, file) == page.code.end()) page.code.push_back(file);
    for (const fs::path &figure : figures(workspace, section)) page.code.push_back(figure);
    page.whole = page.code;
    page.code.push_back(workspace.tests(section));
    for (const fs::path &peer : files_in(workspace.tests_folder(section), "", "peer.")) // how far apart they are
        page.code.push_back(peer);
    for (const fs::path &sketch : files_in(workspace.root / "docs/gallery", ".cpp")) page.code.push_back(sketch);
    return page;
}

Page page_of_book(const Workspace &workspace) {
    const std::vector<fs::path> shared = files_in(workspace.root / "chapters", ".hpp");
    return {workspace.root / "book.md", shared, {}, shared};
}

Woven weave(const Workspace &workspace, const Page &page, std::string_view text, const Output &output) {
    return Weaver{workspace, page, text, output}.weave();
}

std::vector<Finding> missing_parts(const Workspace &workspace, const Section &section, std::string_view text) {
    const fs::path chapter = workspace.chapter(section), header = workspace.header(section);
    const std::string contract = read_file(header);
    const std::vector<ListedExercise> rows = exercise_table(text), declared = declared_exercises(contract);
    const std::vector<Hint> all_hints = hints(text);
    const std::vector<Chunk> solutions = cut(workspace.solution(section));
    std::vector<Finding> missing;

    for (const ListedExercise &one : declared) {
        if (std::ranges::find(rows, one) == rows.end())
            missing.push_back(
                {header, one.line,
                 fmt::format("the chapter's table has no row for this exercise; write `| {} | `{}`: ... | {} |` there.",
                             one.number, one.function, one.tier)});
        const auto first_hint =
            std::ranges::find_if(all_hints, [&](const Hint &hint) { return hint.number == one.number; });
        if (first_hint == all_hints.end() || first_hint->title != "where to begin")
            missing.push_back(
                {header, one.line,
                 fmt::format("no hint says how {0} is begun; write a fold `<summary>{0}, a hint: where to "
                             "begin</summary>`, before its other hints.",
                             one.number)});
        const std::string title = "Solution " + one.number;
        if (std::ranges::none_of(solutions,
                                 [&](const Chunk &c) { return c.title == title || c.title.starts_with(title + ":"); }))
            missing.push_back(
                {workspace.solution(section), 1,
                 fmt::format("no chunk is the solution of {}; write `//> {}: ...` above it.", one.number, title)});
    }
    for (const Hint &hint : all_hints)
        if (contains(hint.title + hint.text, "$"))
            missing.push_back({chapter, hint.line,
                               fmt::format("a terminal shows this hint for {} as well; write its formulas in plain "
                                           "characters, without `$`.",
                                           hint.number)});
    for (const ListedExercise &row : rows)
        if (std::ranges::find(declared, row) == declared.end())
            missing.push_back(
                {chapter, row.line,
                 "the header declares no exercise like this row; give both the same number, function and tier."});
    for (const fs::path &figure : figures(workspace, section))
        if (const std::string svg = figure.stem().string() + ".svg"; text.find("/" + svg + ")") == text.npos)
            missing.push_back(
                {figure, 1,
                 fmt::format("the chapter does not show this figure; put `![what it shows](../../plots/{})` there.",
                             svg)});
    for (const Renamed &name : renamed(workspace, section))
        if (name.now.empty())
            missing.push_back({workspace.renamed(section), name.line,
                               "a line holds an old name and the new one, with a blank between."});
        else if (!names(contract, name.now))
            missing.push_back({workspace.renamed(section), name.line,
                               fmt::format("the header has nothing called `{}`; write the name that `{}` has now.",
                                           name.now, name.before)});
    return missing;
}

} // namespace course
