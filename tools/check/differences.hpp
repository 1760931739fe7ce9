#pragma once
// Wrong and right answers that are written as differences to a section's solution, as tests/NN_slug/mutants.diff has them:
//
//     7.2 meet_leaves_the_ends_open: a touch is no meeting
//     -    return low > 0 || high < 0;
//     +    return (low >= 0 && high > 0) || (low < 0 && high <= 0);
//
// An entry says which lines of the solution go (-), which come (+), and, where more is needed to find the place, which
// stay ( ). A blank line ends a change; an answer may have several. Indentation and comments are not compared.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace course::differences {

/// A line of code, and where it was written.
struct Line {
    std::string text;
    const std::filesystem::path *file;
    int number;
};
using Lines = std::vector<Line>;

/// @throws std::runtime_error if the file can't be read
Lines read(const std::filesystem::path &file);

/// What is wrong with somebody's answer, and where.
struct BadAnswer : std::runtime_error {
    BadAnswer(const Line &line, const std::string &what);
};

/// Lines that stand one after the other in the solution, each with what becomes of it, and those that come: - + or a
/// blank.
using Change = std::vector<std::pair<char, Line>>;

struct Answer {
    Line head;
    std::string exercise, name, verdict; ///< if that matters: "8 of 13, yours t = 0.5"
    std::string claim;                   ///< what is special about it
    std::vector<Change> changes;
};

/// All of a file.
/// @throws BadAnswer if it has another form
std::vector<Answer> read_differences(const std::filesystem::path &file);

/// A solution, cut at each `//> Solution 7.2: title`. A chunk without a number belongs to every exercise.
class Solution {
  public:
    explicit Solution(const std::filesystem::path &file_);

    Lines includes;
    Lines of(const std::string &exercise) const;
    /// Its own alone.
    Lines only_of(const std::string &exercise) const;
    /// The same with the changes of an answer to it.
    /// @throws BadAnswer unless the lines are there, once
    Lines with(const Answer &answer) const;

  private:
    std::filesystem::path file;
    std::vector<std::pair<std::string, Line>> chunks; // each line with the number of an exercise, or with ""
};

} // namespace course::differences
