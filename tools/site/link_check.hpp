#pragma once
// The site as it will be read: the files, and whether each link in them leads somewhere.

#include <map>
#include <string>

namespace course {

/// What a file holds, by path.
using SiteFiles = std::map<std::string, std::string>;

/// Follows every link, picture, script and style sheet from index.html on, and drops the files that are not met.
/// @throws UserError listing links that lead to no file or to no place in it, and what would be fetched from another
///         host.
void keep_reachable(SiteFiles &files);

} // namespace course
