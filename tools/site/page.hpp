#pragma once
#include <string>
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
    /// `<span class="math display" data-from="chapters/07_.../README.md:12" data-plain="x²">x^2</span>`,
    /// `<pre class="code numbered" data-language="cpp"><code>int x;</code></pre>`.
    std::string html;
    std::vector<Heading> headings; ///< below the title
};

} // namespace course
