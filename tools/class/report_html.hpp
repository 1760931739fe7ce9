#pragma once
// Pieces of the instructor's report. What comes into them has been through `shown`, or is our own.

#include "class/points.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace course::report {

/// What anybody may have chosen, as one line of text: never as a tag, whatever it says.
inline std::string shown(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return escaped(plain_line(text, 400));
}

/// The same with its lines.
inline std::string preformatted(const std::string &text) { return "<pre>" + escaped(plain_output(text)) + "</pre>\n"; }

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
    for (const std::string &column : columns) heads += "<th scope=\"col\">" + shown(column) + "</th>";
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
        return "student-" + shown(id);
    }
    std::string name(const std::string &id) const {
        const auto found = names.find(id);
        return found == names.end() ? "" : shown(found->second);
    }
    std::string id_and_name(const std::string &id) const {
        return shown(id) + (name(id).empty() ? "" : " " + name(id));
    }
    std::string link(const std::string &id) const {
        return "<a href=\"#" + anchor(id) + "\">" + id_and_name(id) + "</a>";
    }
};

} // namespace course::report
