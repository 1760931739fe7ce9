#pragma once
#include "site/addresses.hpp"
#include "site/page.hpp"

#include <map>
#include <string>
#include <vector>

namespace course {

/// What surrounds the body of each page: docs/page.html with its gaps filled in.
class PageTemplate {
  public:
    /// @param page  the template: {{title}}, {{contents}}, {{above}}, {{body}}, {{turning}}, {{demos}}
    PageTemplate(const Addresses &addresses, const std::vector<SitePage> &reference, std::string page);

    /// The whole page.
    std::string around(const SitePage &page) const;

  private:
    /// A section in the contents.
    struct Entry {
        std::string number;  ///< "7"
        std::string title;   ///< "Segment intersection"
        std::string minutes; ///< "90 + 150"
        std::string page;    ///< "chapter_07_segment_intersection"; "" if it is to come
    };

    std::string part_items(const SitePage &page, bool before) const;
    std::string sidebar(const SitePage &page) const;
    std::string above(const SitePage &page) const;
    std::string turning(const SitePage &page) const;
    std::string demo_scripts(const std::string &body) const;
    std::string item(const SitePage &page, const std::string &address, const std::string &words,
                     const std::string &number = "") const;
    std::string outline(const SitePage &page) const;
    const Section *section_of(const std::string &name) const;

    const Tree &tree;
    std::map<std::string, std::string> interfaces; ///< of namespaces: the addresses of their pages
    const std::vector<BookPart> &book_pages;
    std::vector<Entry> entries;
    std::string page_template;
    std::vector<Section> sections;
    bool has_demos;
    std::vector<std::pair<std::string, std::string>> others; ///< page and title of what else there is: README, ...
};

} // namespace course
