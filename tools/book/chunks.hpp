#pragma once
// A code file is cut into chunks by comment lines `//> Title` (`#> Title` in gnuplot). A chunk runs to the next such
// line; a bare `//>` ends one, and what follows is not shown. Nor is COURSE_FIELDS, which says nothing of the physics.

#include "book/finding.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The text after `//>` or `#>`, if the line is such a mark; empty for a bare mark.
std::optional<std::string> mark_title(std::string_view line);

struct Chunk {
    std::string title;
    std::filesystem::path file;
    int line = 0;                   ///< of the mark, from 1
    std::vector<std::string> lines; ///< the mark is the first; no blank ones at the end
};

/// All chunks of a code file, in order.
/// @throws UserError if the file cannot be read.
std::vector<Chunk> cut(const std::filesystem::path &file);

/// The first line before any mark that is more than an include, a pragma, a `using`, a namespace or a comment: code
/// that a reader of the chapter would miss. (Code that is to be left out follows a bare mark.)
std::optional<Finding> unmarked_code(const std::filesystem::path &file);

} // namespace course
