#pragma once
// The code is the source: a chapter's listings and outputs are brought up to date from it, and what cannot be is reported.

#include "base/workspace.hpp"
#include "book/finding.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A chapter, or book.md, and the code that it shows.
struct Page {
    std::filesystem::path file;
    std::vector<std::filesystem::path> code;  ///< the page may show the chunks of these, each once
    std::vector<std::filesystem::path> whole; ///< those of them that are in chunks from their includes on
    std::vector<std::filesystem::path>
        required; ///< the page must show the chunks of these, as it must every frame loop
};

/// The chapter of a section. It must show header, solution and frame loops, and may show chunks of the program, the
/// tests and the scripts of figures.
Page page_of(const Workspace &workspace, const Section &section);

/// book.md, which may show what sections share: chapters/*.hpp.
Page page_of_book(const Workspace &workspace);

struct Woven {
    std::string text;                     ///< of the page, as it should be; as it is if `broken`
    std::vector<Finding> differences;     ///< listings and outputs that were not so
    std::set<std::filesystem::path> code; ///< where the listings among them come from
    std::vector<Finding> findings;        ///< what weaving cannot put right
    bool broken = false;                  ///< a fence or fold without an end: nothing was woven
    int listings = 0, outputs = 0;
};

/// What the section's program prints, or one part of it.
using Output = std::function<std::string(const Section &, const std::string &part)>;

/// Weaves a page's text: a fence whose first line is a mark `//> Title` gets the chunk of that title, a `console` fence
/// whose first line is `$ ./course run N [PART] [--mine]` what that program, or that part of it, prints with our
/// solution. Everything else stays, byte for byte.
/// @throws UserError if a code file cannot be read, or from `output`.
Woven weave(const Workspace &workspace, const Page &page, std::string_view text, const Output &output);

/// Exercises of the header without a row in the chapter's table, a hint, a solution; rows without an exercise; figures
/// that the chapter does not show; lines of renamed.txt that name nothing in the header.
/// @param chapter  the text
std::vector<Finding> missing_parts(const Workspace &workspace, const Section &section, std::string_view chapter);

} // namespace course
