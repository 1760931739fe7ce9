#pragma once
// Pieces of the instructor's report. What comes into them has been through `as_html`, or is our own.

#include "base/plain.hpp"
#include "base/text.hpp"
#include "grade/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace course::report {

/// What anybody may have chosen, as one line of text: never as a tag, whatever it says.
inline std::string as_html(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return escaped(plain_line(text, 400));
}

/// The same with its lines.
inline std::string preformatted(const std::string &text) { return "<pre>" + escaped(sanitize(text)) + "</pre>\n"; }

inline std::string times(std::size_t count) {
    return count == 1 ? "once" : count == 2 ? "twice" : std::to_string(count) + " times";
}

inline std::string tag(const std::string &words, const std::string &kind = "dim") {
    return fmt::format(R"(<span class="tag {}">{}</span> )", kind, words);
}

/// A sign for eyes, and words for ears and for whoever points at it.
inline std::string sign(const std::string &for_eyes, const std::string &words) {
    return fmt::format(R"(<span aria-hidden="true" title="{0}">{1}</span><span class="hidden">{0}</span>)", words,
                       for_eyes);
}

inline std::string fold(const std::string &summary, const std::string &html) {
    return "<details><summary>" + summary + "</summary>\n" + html + "</details>\n";
}

/// In a box that it scrolls in, if it's too wide.
inline std::string table(const std::string &name, const std::vector<std::string> &columns, const std::string &rows) {
    std::string heads;
    for (const std::string &column : columns) heads += "<th scope=\"col\">" + as_html(column) + "</th>";
    return fmt::format(R"(<div class="table" tabindex="0" role="region" aria-label="{}"><table class="{}">
<thead><tr>{}</tr></thead>
{}</table></div>
)",
                       name, lower(name), heads, rows);
}

/// How students are called, and where their rows are.
struct People {
    const std::map<std::string, std::string> &names; ///< by id

    static std::string anchor(std::string id) {
        std::ranges::replace(id, ' ', '_');
        return "student-" + as_html(id);
    }
    std::string name(const std::string &id) const {
        const auto name = names.find(id);
        return name == names.end() ? "" : as_html(name->second);
    }
    std::string id_and_name(const std::string &id) const {
        return as_html(id) + (name(id).empty() ? "" : " " + name(id));
    }
    std::string link(const std::string &id) const {
        return "<a href=\"#" + anchor(id) + "\">" + id_and_name(id) + "</a>";
    }
};

} // namespace course::report
