#include "ground/renamed.hpp"

#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <sstream>

namespace course {
namespace {

bool is_name(std::string_view word) { return std::ranges::all_of(word, is_in_a_name); }

} // namespace

std::vector<Renamed> renamed(const Tree &tree, const Section &section) {
    std::vector<Renamed> names;
    if (!std::filesystem::exists(tree.renamed(section))) return names;
    const std::string text = read_file(tree.renamed(section));
    int number = 0;
    for (const Line &line : lines_of(text)) {
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
    std::vector<std::string> said;
    for (const std::string &name : names)
        for (const Renamed &one : renamed) {
            if (one.before != name || one.now.empty()) continue;
            std::string words = '`' + one.before + "` is called `" + one.now + '`';
            if (std::ranges::find(said, words) == said.end()) said.push_back(std::move(words));
        }
    if (said.empty()) return "";
    std::string sentence = said.front() + " now";
    for (std::size_t i = 1; i < said.size(); ++i) sentence += ", " + said[i];
    return sentence + ": rename " + (said.size() == 1 ? "it" : "them") + " in your file.";
}

} // namespace course
