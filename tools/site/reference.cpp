#include "site/reference.hpp"

#include "ground/complaint.hpp"
#include "ground/files.hpp"
#include "ground/text.hpp"
#include "site/html.hpp"

#include <optional>
#include <pugixml.hpp>
#include <regex>

namespace course {
namespace fs = std::filesystem;

Names declared_names(const fs::path &tag_file) {
    pugi::xml_document document;
    if (!document.load_file(tag_file.c_str()))
        throw Complaint{"cannot read " + tag_file.string() + ", which Doxygen should have written"};
    Names result;
    for (const pugi::xml_node compound : document.child("tagfile").children("compound")) {
        const std::string kind = compound.attribute("kind").value(), whole = compound.child_value("name");
        const auto colons = whole.find("::");
        if (kind == "namespace" && colons == whole.npos) {
            for (const pugi::xml_node member : compound.children("member"))
                result[whole].try_emplace( // of overloads the first
                    member.child_value("name"),
                    Declared{std::string{member.child_value("anchorfile")} + "#" + member.child_value("anchor"),
                             std::string_view{member.attribute("kind").value()} == "function"});
        } else if ((kind == "struct" || kind == "class") && colons != whole.npos) {
            const std::string name = whole.substr(colons + 2); // that of a struct within a struct has its place there
            if (!contains(name, "::"))
                result[whole.substr(0, colons)][name] = {compound.child_value("filename"), false};
        }
    }
    return result;
}

namespace {

/// The text of the first element of this class; nothing if there is none.
std::optional<Element> first_of(const Html &page, const char *its_class) {
    const Element found = page.first([&](const Element &e) { return e.has_class(its_class); });
    return found.node ? std::optional{found} : std::nullopt;
}

/// "wall::Touch Struct Reference" is a title of Doxygen's; "" of its other pages.
std::string reference_title(const Html &page) {
    static const std::regex reference{R"(\s*(.*) (Namespace|Struct|Class|Union|Concept)( Template)? Reference[\s\S]*)"};
    const auto title = first_of(page, "title");
    std::smatch found;
    const std::string words = title ? title->text() : "";
    return std::regex_match(words, found, reference) ? found[1].str() : "";
}

/// Without "More...", since the name before it leads there as well, and without a heading that says "Description".
std::string without_repetitions(std::string contents) {
    static const std::regex more{R"re(\s*<a href="[^"]*">More\.\.\.</a>)re"};
    replace_all(contents, "<h2 class=\"groupheader\">Detailed Description</h2>", "");
    return std::regex_replace(contents, more, "");
}

} // namespace

std::vector<SitePage> reference_pages(const fs::path &folder) {
    static const std::regex wanted{"(namespace|struct|class|union).*"},
        list{"namespaces|namespacemembers.*|classes|.*-members"};
    std::vector<SitePage> pages;
    for (const fs::path &file : files_in(folder, ".html")) {
        const std::string name = file.stem().string();
        if (!std::regex_match(name, wanted) || std::regex_match(name, list)) continue;
        const Html page{read_file(file)};
        const std::string title = reference_title(page);
        const auto contents = first_of(page, "contents");
        if (title.empty() || !contents)
            throw Complaint{"Doxygen wrote " + name + ".html without contents; is another version at work?"};
        pages.push_back(
            {name,
             title,
             "interface",
             "<h1><code>" + escaped(title) + "</code></h1>\n" + without_repetitions(std::string{contents->inner()}),
             {}});
    }
    return pages;
}

} // namespace course
