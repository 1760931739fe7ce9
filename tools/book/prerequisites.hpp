#pragma once
// What a reader must know before a chapter: each chapter says it in one line, which is woven into book.md's contents.

#include "base/workspace.hpp"
#include "book/contents.hpp"
#include "book/finding.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// An earlier section that another one needs.
struct Prerequisite {
    int section = 0;
    std::string exercise; ///< "11.8" if only that exercise needs it; "" if the whole chapter does
};

/// What the chapter links to in the line that begins with "You need", once each; a link behind an exercise's number is
/// for that exercise alone. Nothing if there is no such line.
std::optional<std::vector<Prerequisite>> prerequisites(std::string_view chapter);

/// "1, 7 for 11.8" and back: a cell of the contents' last column, `needs`.
std::string needs_cell(const std::vector<Prerequisite> &needed);
std::vector<Prerequisite> read_needs(std::string_view cell);

/// book.md with what chapters need in the last column of the contents, and how long they take in the one before it. What
/// is to come keeps what is written there, and so does the time of a chapter without a table of exercises.
struct Needs {
    std::string book;
    std::vector<Finding> findings; ///< chapters that do not say it, or need a later one
};
Needs weave_needs(const Workspace &workspace, const std::string &book);

} // namespace course
