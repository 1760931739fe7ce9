#pragma once
#include "site/addresses.hpp"
#include "site/link_check.hpp"
#include "site/page_writer.hpp"

#include <map>
#include <string>
#include <vector>

namespace course {

/// A template of docs/ with each {{gap}} filled in.
/// @param file  for a complaint
/// @throws UserError about a gap that nothing fills.
std::string fill_template(std::string text, const std::map<std::string, std::string> &gaps, const std::string &file);

/// Adds the pages to the site's files, each in docs/page.html with all gaps filled in: {{title}}, {{about}}, {{kind}},
/// {{contents}}, {{above}}, {{body}}, {{turning}}, {{demos}}.
void add_pages(SiteFiles &files, const Addresses &addresses, const std::vector<SitePage> &pages);

} // namespace course
