#pragma once
// HTML: read by Gumbo, which reads it as browsers do, and changed in place.

#include <gumbo.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// One element of a page. Its pieces are views into the page's text, byte for byte.
struct Element {
    const GumboNode *node = nullptr;

    std::string_view name() const;                      ///< "p"; "" of what HTML does not know
    std::string_view attribute(const char *name) const; ///< its value, without entities; "" without it
    bool has(const char *name) const;                   ///< the attribute
    bool has_class(std::string_view name) const;
    std::string_view outer() const;               ///< from "<p>" to "</p>"
    std::string_view inner() const;               ///< the text between its tags
    std::string_view opening() const;             ///< "<p>"
    std::string text() const;                     ///< its words, without entities
    std::vector<const GumboNode *> nodes() const; ///< all that it holds: elements, texts, comments
    std::vector<Element> children() const;
    std::vector<std::string_view> own_texts() const; ///< the pieces of text in it that are in no element within
};

class Html {
  public:
    explicit Html(std::string text_);

    /// Visits the elements in the order of the text; `visit` returns whether those within it are visited too.
    void each(const std::function<bool(const Element &)> &visit) const;

    const GumboNode *root() const { return output->root; }

    /// The first element for which this holds; its node is null if there is none.
    Element first(const std::function<bool(const Element &)> &holds) const;

    /// Replaces `piece`, a view into the text, by `words`. Pieces must not overlap.
    void replace(std::string_view piece, std::string words);

    /// The text with all that was replaced.
    std::string changed() const;

  private:
    struct Free {
        void operator()(GumboOutput *parsed) const { gumbo_destroy_output(&kGumboDefaultOptions, parsed); }
    };
    struct Change {
        std::size_t at, length;
        std::string words;
    };
    std::unique_ptr<std::string> source; ///< stays where it is when this is moved: Gumbo points into it
    std::unique_ptr<GumboOutput, Free> output;
    std::vector<Change> changes;
};

} // namespace course
