#pragma once
// The glossary of book.md: a row for each term that a chapter has in bold.

#include "base/workspace.hpp"
#include "book/finding.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A term where a chapter explains it: `**determinant** <!-- also: 2D cross product -->`. Bold text that ends in
/// punctuation is not a term, and neither is any in a heading or in a box: `> **Write** ...`.
struct Term {
    std::string name;                     ///< "determinant", as in a cell of a table
    std::vector<std::string> also_called; ///< "2D cross product": what a comment right after it lists
    int section = 0;                      ///< 7
    std::string link;                     ///< "chapters/07_walls/README.md#where-two-lines-cross"
    std::filesystem::path file;           ///< of the chapter
    int line = 0;                         ///< from 1
};

/// The terms of a chapter, in order.
/// @param link  of the chapter, as book.md writes it
std::vector<Term> terms_of(std::string_view chapter, int section, const std::string &link,
                           const std::filesystem::path &file);

/// The terms of all chapters, in their order.
/// @throws UserError if a chapter cannot be read.
std::vector<Term> terms_of(const Workspace &workspace);

/// A text with the glossary that these terms give.
struct Glossary {
    std::string book;              ///< book.md with a row for each term below the heading `## Glossary`
    std::vector<Finding> findings; ///< what weaving cannot put right: no heading, a term that a chapter has twice
};

/// @param terms  of all chapters, in their order
Glossary weave_glossary(const std::string &book, const std::filesystem::path &file, const std::vector<Term> &terms);

} // namespace course
