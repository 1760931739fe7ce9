#include "site/search.hpp"

#include "book/markdown.hpp"

#include <utility>

namespace course {
namespace {

/// Reads a page from heading to heading.
class Reader {
  public:
    explicit Reader(const Draft &draft_) : draft{draft_} {}

    nlohmann::json read(const GumboNode *root) {
        begin("", "");
        walk(root);
        finish();
        return std::move(documents);
    }

  private:
    void begin(const std::string &id, const std::string &words) {
        part = words;
        address = draft.name() + ".html" + (id.empty() ? "" : "#" + id);
        text.clear();
    }

    void finish() {
        if (!text.empty() || !part.empty())
            documents.push_back({{"page", draft.title()},
                                 {"part", part},
                                 {"address", address},
                                 {"text", text},
                                 {"words", std::exchange(other_words, "")}});
    }

    void say(std::string_view words) {
        for (const char c : words) {
            const bool blank = c == ' ' || c == '\n' || c == '\t';
            if (!blank) text += c;
            else if (!text.empty() && text.back() != ' ') text += ' ';
        }
    }

    void walk(const GumboNode *node) {
        if (node->type != GUMBO_NODE_ELEMENT) {
            if (node->type != GUMBO_NODE_COMMENT && node->type != GUMBO_NODE_DOCUMENT) say(node->v.text.text);
            return;
        }
        const Element element{node};
        if (element.has_class("anchor") || element.has_class("ttc") || element.name() == "h1") return;
        if (element.has_class("words")) { // what readers may type for what this part is about
            other_words += element.text() + ' ';
            return;
        }
        if (element.has_class("math")) return say(plain_formula(element.text()));
        if ((element.name() == "h2" || element.name() == "h3") && element.has("id")) return heading(element);
        for (const GumboNode *child : element.nodes()) walk(child);
        if (ends_words(element.name())) say(" ");
    }

    void heading(const Element &element) {
        finish();
        text.clear();
        for (const GumboNode *child : element.nodes()) walk(child);
        std::string words = text;
        while (words.ends_with(' ')) words.pop_back();
        begin(std::string{element.attribute("id")}, words.substr(std::min(words.find_first_not_of(' '), words.size())));
    }

    static bool ends_words(std::string_view element) {
        return element == "p" || element == "li" || element == "td" || element == "th" || element == "div"
               || element == "pre" || element == "summary" || element == "figcaption";
    }

    const Draft &draft;
    nlohmann::json documents = nlohmann::json::array();
    std::string part, address, text, other_words;
};

} // namespace

nlohmann::json search_documents(const Draft &draft) { return Reader{draft}.read(draft.html().root()); }

} // namespace course
