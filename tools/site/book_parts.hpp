#pragma once
// book.md on the site: the contents are on the front page, and each other part is a page.

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A part of book.md, from one `##` to the next, as a page.
struct BookPart {
    std::string name;                 ///< of the page, without ".html": "notation_and_units"
    std::string title;                ///< "Notation and units"
    std::string text;                 ///< as Markdown, each line where it is in book.md, headings a level up
    std::vector<std::string> anchors; ///< of its headings, as links into book.md name them; that of the title first
    bool before_contents = false;     ///< as the preface is
};

/// All parts but the contents, in the order of book.md.
std::vector<BookPart> book_parts(std::string_view book);

/// Where the site has what a link calls book.md#anchor; the front page without an anchor.
std::string book_address(const std::vector<BookPart> &parts, const std::string &anchor);

} // namespace course
