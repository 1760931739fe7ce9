#include "book/front_door.hpp"

#include <regex>

namespace course {

std::string with_front_door(std::string readme, const std::string &address) {
    static const std::regex line{R"(^(# [^\n]*\n\n)\*\*\[[^\n]*\n\n)"}, linked{R"(\n\[(!\[[^\n]*\))\]\([^\n]*\)\n)"},
        picture{R"(\n(!\[[^\n]*\))\n)"}, title{R"(^(# [^\n]*\n\n))"};
    constexpr auto first = std::regex_constants::format_first_only;
    readme = std::regex_replace(std::regex_replace(readme, line, "$1", first), linked, "\n$1\n", first);
    if (address.empty()) return readme;
    readme = std::regex_replace(readme, picture, "\n[$1](" + address + ")\n", first);
    return std::regex_replace(readme, title,
                              "$1**[Read it, play it, and write your first line in your browser](" + address
                                  + ")**: there's nothing to install.\n\n",
                              first);
}

} // namespace course
