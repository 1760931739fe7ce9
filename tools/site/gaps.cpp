#include "site/gaps.hpp"

#include "ground/complaint.hpp"

namespace course {

std::string filled(std::string text, const std::map<std::string, std::string> &gaps, const std::string &file) {
    std::string out;
    for (std::size_t at; (at = text.find("{{")) != text.npos;) {
        const std::size_t end = text.find("}}", at);
        const auto gap = gaps.find(text.substr(at + 2, end - at - 2));
        if (end == text.npos || gap == gaps.end())
            throw Complaint{file + " has a gap that nothing fills: " + text.substr(at, 20)};
        out += text.substr(0, at) + gap->second;
        text.erase(0, end + 2);
    }
    return out + text;
}

} // namespace course
