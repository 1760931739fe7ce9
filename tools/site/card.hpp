#pragma once
#include <string>
#include <vector>

namespace course {

/// What leads to a section or a demo: a picture, a title, a sentence and a line below. All of it is one link.
struct Card {
    std::string address;
    std::string picture; ///< its file; "" for none
    std::string number;  ///< "7"; may be ""
    std::string title;
    std::string about;
    std::string foot; ///< HTML; may be ""
};

/// Cards side by side, as HTML.
std::string in_a_row(const std::vector<Card> &cards);

} // namespace course
