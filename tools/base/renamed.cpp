#include "base/renamed.hpp"

#include "base/lines.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <sstream>

namespace course {
namespace {

bool is_name(std::string_view word) { return std::ranges::all_of(word, is_in_a_name); }

} // namespace

std::vector<Renamed> read_renamed(std::string_view text) {
    std::vector<Renamed> names;
    int number = 0;
    for (const Line &line : split_lines(text)) {
        std::istringstream words{std::string{line.text.substr(0, line.text.find('#'))}};
        Renamed name{"", "", ++number};
        if (!(words >> name.before)) continue;
        std::string more;
        if (words >> name.now && (words >> more || !is_name(name.before) || !is_name(name.now))) name.now.clear();
        names.push_back(name);
    }
    return names;
}

std::string explain_renamed(const std::vector<std::string> &names, const std::vector<Renamed> &renamed) {
    std::vector<std::string> parts;
    for (const std::string &name : names)
        for (const Renamed &one : renamed) {
            if (one.before != name || one.now.empty()) continue;
            std::string part = '`' + one.before + "` is called `" + one.now + '`';
            if (std::ranges::find(parts, part) == parts.end()) parts.push_back(std::move(part));
        }
    if (parts.empty()) return "";
    std::string sentence = parts.front() + " now";
    for (std::size_t i = 1; i < parts.size(); ++i) sentence += ", " + parts[i];
    return sentence + ": rename " + (parts.size() == 1 ? "it" : "them") + " in your file.";
}

} // namespace course
