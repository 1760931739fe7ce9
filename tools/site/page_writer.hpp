#pragma once
// From portable Markdown, as a forge shows it, to the body of a page.

#include "site/addresses.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A heading of a page.
struct Heading {
    int level = 2;
    std::string id, words;
};

/// A page of the site, without what surrounds its text.
struct SitePage {
    std::string name;  ///< without ".html"
    std::string title; ///< in plain words
    std::string kind;  ///< "chapter" for all that is written, "source", or "interface" for what Doxygen writes
    /// Until docs/finish.cjs has been at it, formulas and code are as they were written:
    /// `<span class="math display" data-from="chapters/07_.../README.md:12">x^2</span>`,
    /// `<pre class="code numbered" data-language="cpp"><code>int x;</code></pre>`.
    std::string html;
    std::vector<Heading> headings; ///< below the title
};

/// A page of Markdown. A listing that is a chunk of a file is headed by title, file and line.
/// @param file  where the text is from: links are seen from there
/// @param name  of the page, without ".html"
/// @throws UserError naming the line of what cannot be shown.
SitePage written_page(const Addresses &addresses, const std::filesystem::path &file, std::string_view text,
                      const std::string &name);

/// A code file as a page.
SitePage source_page(const Workspace &workspace, const std::filesystem::path &file);

} // namespace course
