#include "figures/figure.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

namespace course {
namespace {

using Used = std::set<std::pair<std::string, std::string>>; // attribute and colour

bool is(pugi::xml_node node, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, node.name()) != names.end();
}

/// gnuplot opens a group for every change of the pen, and leaves most of them empty.
void drop_empty_groups(pugi::xml_node svg) {
    for (pugi::xpath_node_set empty; !(empty = svg.select_nodes(".//g[not(*)]")).empty();)
        for (const pugi::xpath_node &group : empty) group.parent().remove_child(group.node());
}

/// "rgb( 59, 130, 246)" as "#3b82f6"; anything else stays as it is.
std::string as_hex(const std::string &colour) {
    static const std::regex triple{R"(rgb\(\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*\))"};
    std::smatch match;
    if (!std::regex_match(colour, match, triple)) return colour;
    return fmt::format("#{:02x}{:02x}{:02x}", std::stoi(match[1]) & 255, std::stoi(match[2]) & 255,
                       std::stoi(match[3]) & 255);
}

/// Brings one painting attribute to "#rrggbb" and notes it; black is ink.
void recolour(pugi::xml_attribute paint, const Colours &colours, const std::string &name, Used &used) {
    std::string colour = as_hex(paint.value());
    if (colour.empty() || colour == "none" || colour == "currentColor") return;
    if (colour == "black" || colour == "#000000") colour = colours.ink;
    if (!colours.dark.contains(colour))
        throw FigureFault{name + " draws in " + colour
                          + ", which plots/style.gp doesn't know on dark pages; use lc rgb INK, DIM, or lt 1 to 6"};
    paint.set_value(colour.c_str());
    used.emplace(paint.name(), colour);
}

/// Every group says `color`, but only a point symbol, or a shape with the stroke "currentColor", is drawn in it.
bool draws_in_color(pugi::xml_node node, std::string_view stroke) {
    if (const pugi::xml_attribute own = node.attribute("stroke")) stroke = own.value();
    if (is(node, {"use"}) || node.attribute("fill").value() == std::string_view{"currentColor"}) return true;
    if (is(node, {"path", "polygon", "polyline", "rect", "circle", "ellipse", "line"})) return stroke == "currentColor";
    return std::any_of(node.begin(), node.end(), [&](pugi::xml_node child) {
        return !child.attribute("color") && draws_in_color(child, stroke);
    });
}

void recolour_all(pugi::xml_node node, const Colours &colours, const std::string &name, Used &used) {
    if (is(node, {"defs"})) return; // symbols take the colour of the element that uses them
    if (!draws_in_color(node, "none")) node.remove_attribute("color");
    for (const char *attribute : {"color", "fill", "stroke"}) recolour(node.attribute(attribute), colours, name, used);
    for (const pugi::xml_node child : node.children()) recolour_all(child, colours, name, used);
}

std::string style_sheet(const Used &used, const Colours &colours) {
    std::string rules;
    for (const auto &[attribute, light] : used)
        rules += "[" + attribute + "=\"" + light + "\"] { " + attribute + ": " + colours.dark.at(light) + " }\n";
    // Declared for a figure opened by itself, which would stand on white paper; in a page the page's scheme counts.
    return "\nsvg { color-scheme: light dark }\n@media (prefers-color-scheme: dark) {\n" + rules + "}\n";
}

} // namespace

Colours read_colours(std::string_view style) {
    static const std::regex colour{R"re("(#[0-9a-f]{6})")re"}, twin{R"re(# dark: (#[0-9a-f]{6})\b)re"};
    Colours colours;
    std::istringstream lines{std::string{style}};
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::smatch light, dark;
        if (!std::regex_search(line, light, colour)) continue;
        if (!std::regex_search(line, dark, twin))
            throw UserError{"plots/style.gp, line " + std::to_string(number) + ": the colour " + light[1].str()
                            + " has no twin for dark pages; write \"# dark: #rrggbb\" behind it"};
        colours.dark[light[1]] = dark[1];
        if (line.starts_with("INK")) colours.ink = light[1];
    }
    if (colours.ink.empty()) throw UserError{"plots/style.gp names no INK; write INK = \"#rrggbb\" # dark: #rrggbb"};
    return colours;
}

std::string recoloured(std::string_view text, const std::string &title, const Colours &colours,
                       const std::string &name) {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata);
    pugi::xml_node svg = document.child("svg");
    if (!parsed || !svg) throw FigureFault{name + ": gnuplot wrote no SVG; begin the script with load 'style.gp'"};

    Used used;
    drop_empty_groups(svg);
    recolour_all(svg, colours, name, used);

    svg.remove_child("desc"); // gnuplot's version
    svg.child("title").text().set(title.c_str());
    svg.append_attribute("role") = "img";
    svg.insert_child_after("style", svg.child("title")).text().set(style_sheet(used, colours).c_str());

    std::ostringstream out;
    out << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";
    document.save(out, "", pugi::format_raw | pugi::format_no_declaration);
    return out.str() + '\n';
}

} // namespace course
