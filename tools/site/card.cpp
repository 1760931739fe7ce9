#include "site/card.hpp"

#include "ground/text.hpp"

namespace course {
namespace {

std::string as_item(const Card &card) {
    return "<li class=\"card\">" + (card.picture.empty() ? "" : "<img src=\"" + card.picture + "\" alt=\"\">")
           + "<div><a href=\"" + card.address + "\">"
           + (card.number.empty() ? "" : "<span class=\"number\">" + card.number + "</span> ") + escaped(card.title)
           + "</a>" + (card.about.empty() ? "" : "<p>" + escaped(card.about) + "</p>")
           + (card.foot.empty() ? "" : "<p class=\"foot\">" + card.foot + "</p>") + "</div></li>\n";
}

} // namespace

std::string in_a_row(const std::vector<Card> &cards) {
    std::string html = "<ol class=\"cards\">\n";
    for (const Card &card : cards) html += as_item(card);
    return html + "</ol>";
}

} // namespace course
