#pragma once
// A page between Doxygen and the reader.

#include "ground/tree.hpp"
#include "site/html.hpp"
#include "site/interface.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A heading of a page.
struct Heading {
    int level = 2;
    std::string id, words;
};

/// A formula, and its place in the book.
struct FormulaAt {
    std::string tex, from; ///< from: "chapters/07_.../README.md:12"
    bool display = false;
};

/// The contents of one page that Doxygen has written, without Doxygen's own header and menus.
class Draft {
  public:
    /// @throws Complaint if this is no page of Doxygen's.
    Draft(std::string name, const std::string &doxygens_html);

    const std::string &name() const { return own_name; } ///< without ".html"
    const std::string &title() const { return own_title; }
    bool is_interface() const { return interface; } ///< of a namespace or type, written by Doxygen alone
    const Html &html() const { return body; }

    std::vector<Heading> headings() const;
    std::vector<FormulaAt> formulas() const;

    /// The page's own HTML: formulas typeset (in the order of formulas()), listings as `pre`, names linked to `known`,
    /// lines of a source numbered.
    std::string finished(const std::vector<std::string> &typeset, const Interface *known);

  private:
    std::string own_name, own_title;
    bool interface = false;
    Html body;
};

} // namespace course
