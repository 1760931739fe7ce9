#include "site/html.hpp"

#include "ground/text.hpp"

#include <algorithm>
#include <sstream>

namespace course {
namespace {

bool is_element(const GumboNode *node) { return node->type == GUMBO_NODE_ELEMENT || node->type == GUMBO_NODE_TEMPLATE; }

std::string_view view(const GumboStringPiece &piece) { return {piece.data, piece.length}; }

void append_text(const GumboNode *node, std::string &out) {
    if (is_element(node)) {
        for (const GumboNode *child : Element{node}.nodes()) append_text(child, out);
    } else if (node->type != GUMBO_NODE_COMMENT && node->type != GUMBO_NODE_DOCUMENT) {
        out += node->v.text.text;
    }
}

void visit_all(const GumboNode *node, const std::function<bool(const Element &)> &visit) {
    if (!is_element(node)) return;
    const bool has_source = node->v.element.original_tag.length > 0; // else the reader has added it
    if (has_source && !visit({node})) return;
    for (const GumboNode *child : Element{node}.nodes()) visit_all(child, visit);
}

} // namespace

std::string_view Element::name() const { return gumbo_normalized_tagname(node->v.element.tag); }

bool Element::has(const char *name) const { return gumbo_get_attribute(&node->v.element.attributes, name) != nullptr; }

std::string_view Element::attribute(const char *name) const {
    const GumboAttribute *found = gumbo_get_attribute(&node->v.element.attributes, name);
    return found ? found->value : "";
}

bool Element::has_class(std::string_view name) const {
    std::istringstream classes{std::string{attribute("class")}};
    for (std::string each; classes >> each;)
        if (each == name) return true;
    return false;
}

std::string_view Element::opening() const { return view(node->v.element.original_tag); }

std::string_view Element::outer() const {
    const GumboStringPiece &start = node->v.element.original_tag, &end = node->v.element.original_end_tag;
    if (end.length == 0) return opening();
    return {start.data, static_cast<std::size_t>(end.data + end.length - start.data)};
}

std::string_view Element::inner() const {
    const GumboStringPiece &start = node->v.element.original_tag, &end = node->v.element.original_end_tag;
    if (end.length == 0) return opening().substr(opening().size());
    return {start.data + start.length, static_cast<std::size_t>(end.data - start.data) - start.length};
}

std::string Element::text() const {
    std::string out;
    append_text(node, out);
    return out;
}

std::vector<const GumboNode *> Element::nodes() const {
    const GumboVector &all = node->v.element.children;
    std::vector<const GumboNode *> result;
    for (unsigned i = 0; i < all.length; ++i) result.push_back(static_cast<const GumboNode *>(all.data[i]));
    return result;
}

std::vector<Element> Element::children() const {
    std::vector<Element> result;
    for (const GumboNode *child : nodes())
        if (is_element(child)) result.push_back({child});
    return result;
}

std::vector<std::string_view> Element::own_texts() const {
    std::vector<std::string_view> result;
    for (const GumboNode *child : nodes())
        if (child->type == GUMBO_NODE_TEXT) result.push_back(view(child->v.text.original_text));
    return result;
}

Html::Html(std::string text_)
    : source{std::make_unique<std::string>(std::move(text_))},
      output{gumbo_parse_with_options(&kGumboDefaultOptions, source->data(), source->size())} {}

void Html::each(const std::function<bool(const Element &)> &visit) const { visit_all(output->root, visit); }

Element Html::first(const std::function<bool(const Element &)> &holds) const {
    Element found;
    each([&](const Element &element) {
        if (!found.node && holds(element)) found = element;
        return !found.node;
    });
    return found;
}

void Html::replace(std::string_view piece, std::string words) {
    changes.push_back({static_cast<std::size_t>(piece.data() - source->data()), piece.size(), std::move(words)});
}

std::string Html::changed() const {
    std::vector<Change> sorted = changes;
    std::ranges::stable_sort(sorted, {}, &Change::at);
    std::string out;
    std::size_t at = 0;
    for (const Change &change : sorted) {
        out.append(*source, at, change.at - at);
        out += change.words;
        at = change.at + change.length;
    }
    return out.append(*source, at);
}

} // namespace course
