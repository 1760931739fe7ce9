#pragma once
// The parts of a chapter: listings, hints and exercises. The Markdown is parsed by cmark-gfm.

#include "base/workspace.hpp"
#include "book/chunks.hpp"
#include "book/finding.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace course {

/// A fenced block, in a quote or a list as well.
struct Fence {
    int line = 0;                     ///< of the opening, from 1
    int end = 0;                      ///< of the closing; 0 if there is none
    std::size_t column = 0;           ///< bytes before the opening
    std::size_t length = 3;           ///< of the opening: "```" has 3
    char sign = '`';                  ///< or '~'
    std::string language;             ///< "cpp", "console": the rest of the opening line
    std::vector<std::string> content; ///< without what a quote or a list puts before each line
};

/// How many of a fence's signs a line begins with, after blanks.
std::size_t run_of(char sign, std::string_view line);

struct Chapter {
    std::vector<Fence> fences;
    std::vector<Finding> broken; ///< fences and folds without an end; the text below them would be read wrongly
};

/// Reads a chapter's text; findings will name `file`.
Chapter read_chapter(std::string_view text, const std::filesystem::path &file);

/// A fold `<summary>7.2, a hint: where to begin</summary>`.
struct Hint {
    std::string number; ///< "7.2"
    std::string title;  ///< "where to begin"
    std::string text;   ///< for a terminal, see plain_text
    int line = 0;       ///< of the chapter
};

/// All hints of a chapter, in order.
std::vector<Hint> hints(std::string_view chapter);

/// "7.2" in "Your turn: 7.2 segments_intersect (15 minutes)"; "" if a heading names none.
std::string exercise_of_box(const std::string &heading);

/// The place of a demo, `<!-- demo: room mine, The game: asks 7.1 | what to try, and what to watch -->`.
struct DemoMark {
    std::string name;     ///< "room"
    std::string start;    ///< controls that begin with another value than the demo's own: "The game: asks 7.1"
    std::string task;     ///< what to try, and what to watch: Markdown
    bool mine = false;    ///< begins with the reader's code, where there is some
    std::string exercise; ///< of the last box above it: "7.2"; "" above the first
    int line = 0;         ///< of the chapter
};
/// The mark that this line or HTML block is; nothing if it is none.
std::optional<DemoMark> demo_mark(const std::string &html);
/// All of a chapter, in order.
std::vector<DemoMark> demo_marks(std::string_view chapter);

/// Where a demo's place is not written as a DemoMark, on a line of its own.
std::vector<Finding> misshapen_demos(std::string_view chapter, const std::filesystem::path &file);

/// The chunks of the solution that belong to the exercise: those called `Solution 7.2` or `Solution 7.2: ...`, and the
/// helpers called `Solution: ...`, which belong to all. In the order of the file, which is one that compiles.
/// @throws UserError if the solution cannot be read, or has no chunk for this exercise.
std::vector<Chunk> solution(const Workspace &workspace, const Section &section, std::string_view number);

/// One row of a chapter's exercise table, or one COURSE_EXERCISE line of a header.
struct ListedExercise {
    std::string number, function, tier;
    int line = 0; ///< where it stands

    bool operator==(const ListedExercise &other) const { ///< wherever they stand
        return std::tie(number, function, tier) == std::tie(other.number, other.function, other.tier);
    }
};
std::vector<ListedExercise> exercise_table(std::string_view chapter);
std::vector<ListedExercise> declared_exercises(std::string_view header);

} // namespace course
