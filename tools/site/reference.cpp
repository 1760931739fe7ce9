#include "site/reference.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "book/html.hpp"

#include <pugixml.hpp>
#include <regex>

namespace course {
namespace fs = std::filesystem;

nlohmann::json declared_names(const fs::path &tag_file) {
    pugi::xml_document document;
    if (!document.load_file(tag_file.c_str()))
        throw UserError{"cannot read " + tag_file.string() + ", which Doxygen should have written"};
    nlohmann::json names = nlohmann::json::object();
    const auto add = [&](const std::string &space, const std::string &name, const std::string &address, bool function) {
        if (!names[space].contains(name)) // of overloads the first
            names[space][name] = {{"address", address}, {"function", function}};
    };
    for (const pugi::xml_node compound : document.child("tagfile").children("compound")) {
        const std::string kind = compound.attribute("kind").value(), name = compound.child_value("name");
        const auto colons = name.find("::"); // a name of a struct's members has no place here
        if (kind == "namespace" && colons == name.npos) {
            for (const pugi::xml_node member : compound.children("member"))
                add(name, member.child_value("name"),
                    std::string{member.child_value("anchorfile")} + '#' + member.child_value("anchor"),
                    std::string_view{member.attribute("kind").value()} == "function");
        } else if ((kind == "struct" || kind == "class") && colons != name.npos && colons == name.rfind("::")) {
            add(name.substr(0, colons), name.substr(colons + 2), compound.child_value("filename"), false);
        }
    }
    return names;
}

namespace {

/// Without "More...", since the name before it leads there as well, and without a heading that says "Description".
std::string without_repetitions(std::string contents) {
    static const std::regex more{R"re(\s*<a href="[^"]*">More\.\.\.</a>)re"};
    replace_all(contents, "<h2 class=\"groupheader\">Detailed Description</h2>", "");
    return std::regex_replace(contents, more, "");
}

} // namespace

std::vector<SitePage> reference_pages(const fs::path &folder) {
    static const std::regex described{"(namespace|struct|class|union).*"},
        list{"namespaces|namespacemembers.*|classes|.*-members"};
    std::vector<SitePage> pages;
    for (const fs::path &file : files_in(folder, ".html")) {
        const std::string name = file.stem().string();
        if (!std::regex_match(name, described) || std::regex_match(name, list)) continue;
        const std::string page = read_file(file);
        const auto title = between(page, "<div class=\"title\">", " Reference"),
                   contents = between(page, "<div class=\"contents\">", "</div><!-- contents -->");
        if (!title || !contents)
            throw UserError{"Doxygen wrote " + name + ".html without contents; is another version at work?"};
        // "wall::Touch Struct" is Doxygen's, "wall::Touch" ours.
        const std::string words = without_entities(std::string{title->substr(0, title->find_last_of(' '))});
        pages.push_back({name,
                         words,
                         "interface",
                         "<h1><code>" + escaped(words) + "</code></h1>\n" + without_repetitions(std::string{*contents}),
                         {}});
    }
    return pages;
}

} // namespace course
