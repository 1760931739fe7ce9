#include "site/interface.hpp"

#include "ground/complaint.hpp"

#include <algorithm>
#include <pugixml.hpp>

namespace course {
namespace {

bool in_word(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// The namespace and the rest of "wall::Touch"; a name of a struct's members has no place here.
std::pair<std::string, std::string> split(const std::string &name) {
    const auto colons = name.find("::");
    return colons == name.npos ? std::pair{name, std::string{}}
                               : std::pair{name.substr(0, colons), name.substr(colons + 2)};
}

} // namespace

std::map<std::string, Interface> interfaces(const std::filesystem::path &tag_file) {
    pugi::xml_document document;
    if (!document.load_file(tag_file.c_str()))
        throw Complaint{"cannot read " + tag_file.string() + ", which Doxygen should have written"};
    std::map<std::string, Interface> result;
    for (const pugi::xml_node compound : document.child("tagfile").children("compound")) {
        const std::string kind = compound.attribute("kind").value(), page = compound.child_value("filename");
        const auto [space, name] = split(compound.child_value("name"));
        if (kind == "struct" || kind == "class") {
            if (!name.empty() && name.find("::") == name.npos) result[space].names[name] = {page, false};
            continue;
        }
        if (kind != "namespace" || !name.empty()) continue;
        Interface &here = result[space];
        here.page = page;
        for (const pugi::xml_node member : compound.children("member"))
            here.names[member.child_value("name")] = {std::string{member.child_value("anchorfile")} + "#"
                                                          + member.child_value("anchor"),
                                                      std::string_view{member.attribute("kind").value()} == "function"};
    }
    return result;
}

std::string linked(std::string_view line, const Interface &known, std::map<std::string, int> &seen) {
    std::string out;
    int within = 0; // elements whose words stay words: comments, strings, links that are there already
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at + 1;
        if (line[at] == '<') {
            end = std::min(line.find('>', at), line.size() - 1) + 1;
            within += line[at + 1] == '/' ? -1 : 1;
        } else if (line[at] == '&') {
            end = std::min(line.find(';', at), line.size() - 1) + 1;
        } else if (in_word(line[at])) {
            while (end < line.size() && in_word(line[end])) ++end;
        }
        const std::string word{line.substr(at, end - at)};
        const auto found = within == 0 ? known.names.find(word) : known.names.end();
        const std::string_view before{out.data(), out.size()};
        const bool member = before.ends_with('.') || before.ends_with("-&gt;") || before.ends_with("::");
        const bool called = line.substr(end).starts_with('(');
        if (found != known.names.end() && !member && called == found->second.is_function && seen[word]++ == 0)
            out += "<a class=\"code\" href=\"" + found->second.address + "\">" + word + "</a>";
        else out += word;
        at = end;
    }
    return out;
}

} // namespace course
