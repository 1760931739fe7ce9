#pragma once
#include "site/addresses.hpp"
#include "site/page.hpp"
#include "site/reachable.hpp"

#include <vector>

namespace course {

/// Adds the pages to the site's files, each in docs/page.html with its gaps filled in: {{title}}, {{about}}, {{kind}},
/// {{contents}}, {{above}}, {{body}}, {{turning}}, {{demos}}.
void add_pages(SiteFiles &files, const Addresses &addresses, const std::vector<SitePage> &pages);

} // namespace course
