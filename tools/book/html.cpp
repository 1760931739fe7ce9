#include "book/html.hpp"

#include "base/text.hpp"

#include <algorithm>

namespace course {

std::string_view Tag::name() const { return whole.substr(1, whole.find_first_of(" \n>", 1) - 1); }

bool Tag::has(const std::string &attribute) const {
    return std::ranges::any_of(std::string_view{" =>"},
                               [&](char end) { return contains(whole, ' ' + attribute + end); });
}

std::string Tag::attribute(const std::string &name) const {
    for (const char before : {' ', '\n'})
        for (const std::string quote : {"\"", "'"})
            if (const auto value = between(whole, before + name + '=' + quote, quote))
                return without_entities(std::string{*value});
    return "";
}

void each_tag(std::string_view html, const std::function<void(const Tag &)> &visit) {
    for (std::size_t at = 0; (at = html.find('<', at)) != html.npos;) {
        const bool comment = html.substr(at).starts_with("<!--");
        const std::size_t end = comment ? html.find("-->", at) : html.find('>', at);
        if (end == html.npos) return;
        if (!comment) visit({html.substr(at, end + 1 - at)});
        at = end + 1;
    }
}

std::string without_entities(std::string text) {
    for (const auto &[entity, sign] :
         {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}})
        replace_all(text, entity, sign);
    return text;
}

} // namespace course
