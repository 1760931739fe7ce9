#include "site/link_check.hpp"

#include "base/errors.hpp"
#include "base/text.hpp"
#include "book/html.hpp"
#include "book/links.hpp"

#include <regex>
#include <set>
#include <vector>

namespace course {
namespace {

/// What a file refers to, and what in it can be referred to.
struct Seen {
    std::vector<std::string> links;
    std::vector<std::string> foreign; ///< what a browser would fetch from elsewhere as it shows the page
    std::set<std::string> ids;
    std::set<std::string> twice; ///< ids that two elements have
};

Seen read_page(const std::string &text) {
    Seen seen;
    each_tag(text, [&](const Tag &tag) {
        const std::string id = tag.attribute("id");
        if (!id.empty() && !seen.ids.insert(id).second) seen.twice.insert(id);
        for (const char *link : {"href", "src", "srcset", "data", "poster", "action"}) {
            const std::string url = tag.attribute(link);
            if (url.empty() || url.starts_with("data:")) continue;
            if (!is_on_the_web(url)) seen.links.push_back(url);
            else if (tag.name() != "a") seen.foreign.push_back(url);
        }
    });
    return seen;
}

Seen read_style(const std::string &text) {
    static const std::regex address{R"re(url\(\s*["']?([^"')]+)["']?\s*\)|@import\s+["']([^"']+))re"};
    Seen seen;
    for (std::sregex_iterator match{text.begin(), text.end(), address}; match != std::sregex_iterator{}; ++match) {
        const std::string url = (*match)[1].matched ? (*match)[1] : (*match)[2];
        if (!url.starts_with("data:")) (is_on_the_web(url) ? seen.foreign : seen.links).push_back(url);
    }
    return seen;
}

/// The scripts that a script reads when it needs them.
Seen read_script(const std::string &text) {
    static const std::regex address{R"re('([\w-]+\.js)')re"};
    Seen seen;
    for (std::sregex_iterator match{text.begin(), text.end(), address}; match != std::sregex_iterator{}; ++match)
        seen.links.push_back((*match)[1]);
    return seen;
}

Seen read(const std::string &name, const std::string &text) {
    if (name.ends_with(".html")) return read_page(text);
    if (name.ends_with(".css")) return read_style(text);
    if (name == "site.js") return read_script(text);
    return {};
}

} // namespace

void keep_reachable(SiteFiles &files) {
    std::map<std::string, Seen> met;
    std::vector<std::string> waiting{"index.html"};
    if (files.contains("404.html")) waiting.push_back("404.html"); // a server leads there
    std::set<std::string> troubles;
    const auto target = [](const std::string &url) { return unescaped(url.substr(0, url.find('#'))); };
    while (!waiting.empty()) {
        const std::string name = waiting.back();
        waiting.pop_back();
        if (met.contains(name)) continue;
        Seen &seen = met[name] = read(name, files.at(name));
        for (const std::string &url : seen.foreign)
            troubles.insert(name + " would fetch " + url + " from another host");
        for (const std::string &id : seen.twice) troubles.insert(name + " has two places called #" + id);
        for (const std::string &url : seen.links) {
            const std::string file = target(url);
            if (file.empty()) continue;
            if (files.contains(file)) waiting.push_back(file);
            else troubles.insert(name + " links to " + url + ", and there is no such file");
        }
    }
    for (const auto &[name, seen] : met)
        for (const std::string &url : seen.links) {
            const auto hash = url.find('#');
            if (hash == url.npos || hash + 1 == url.size()) continue;
            const auto there = met.find(hash == 0 ? name : target(url));
            if (there != met.end() && !there->second.ids.contains(unescaped(url.substr(hash + 1))))
                troubles.insert(name + " links to " + url + ", and there is no such place");
        }
    std::erase_if(files, [&](const auto &file) { return !met.contains(file.first); });
    if (troubles.empty()) return;
    std::string all = "the site is not sound:";
    for (const std::string &trouble : troubles) all += "\n  " + trouble;
    throw UserError{all};
}

} // namespace course
