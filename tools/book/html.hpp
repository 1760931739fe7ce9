#pragma once
// HTML as the site's pages have it: values of attributes in quotes.

#include <functional>
#include <string>
#include <string_view>

namespace course {

struct Tag {
    std::string_view whole; ///< from "<" to ">", a piece of the page

    std::string_view name() const; ///< "p", or "/p"
    bool has(const std::string &attribute) const;
    std::string attribute(const std::string &name) const; ///< the value, without entities; "" without it
};

/// Visits the tags of a page in their order; what a comment has in it is none.
void each_tag(std::string_view html, const std::function<void(const Tag &)> &visit);

/// "a < b" of "a &lt; b".
std::string without_entities(std::string text);

} // namespace course
