#pragma once
#include "book/finding.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Links and images of a Markdown file that lead nowhere: to a file that is not there, out of the tree, or to a heading
/// that is not in that file. Addresses on the web are not followed.
/// @param text  of the file
/// @throws UserError if another file that it links to cannot be read.
std::vector<Finding> dead_links(const std::filesystem::path &file, std::string_view text,
                                const std::filesystem::path &root);

/// What a forge calls a heading in a link: "Which way does a wall face?" is `#which-way-does-a-wall-face`.
std::string anchor_of(std::string_view heading);

/// The anchors of the headings of a page, in order: a second one of a name gets a number.
class Anchors {
  public:
    std::string next(std::string_view heading) {
        std::string anchor = anchor_of(heading);
        const int before = seen[anchor]++;
        return before == 0 ? anchor : anchor + '-' + std::to_string(before);
    }

  private:
    std::map<std::string, int> seen;
};

/// Whether a link has a scheme, as "https:" or "mailto:".
bool is_on_the_web(std::string_view url);

/// A link's path as a file system has it: "%20" is a blank.
std::string unescaped(std::string_view url);

} // namespace course
