#pragma once
// Texts, line by line, with their own line ends: `\n`, `\r\n`, `\r`, as Markdown and compilers count them.

#include <algorithm>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace course {

struct Line {
    std::string_view text; ///< without the line end
    std::string_view end;  ///< "\n", "\r\n", "\r"; empty only at the end of the text
};

inline std::vector<Line> split_lines(std::string_view text) {
    std::vector<Line> lines;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view rest = text.substr(length);
        const std::size_t end = rest.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest.size());
        lines.push_back({text.substr(0, length), rest.substr(0, end)});
        text.remove_prefix(length + end);
    }
    return lines;
}

/// The same with their ends in them, so that lines can be taken out and put in; and all of them as a text again.
inline std::vector<std::string> with_line_ends(std::string_view text) {
    std::vector<std::string> lines;
    for (const Line &line : split_lines(text)) lines.push_back(std::string{line.text} + std::string{line.end});
    return lines;
}
inline std::string joined(const std::vector<std::string> &lines) {
    return std::accumulate(lines.begin(), lines.end(), std::string{});
}

inline std::string_view without_blanks_behind(std::string_view text) {
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

inline std::string_view trim(std::string_view text) {
    return without_blanks_behind(text.substr(std::min(text.find_first_not_of(" \t"), text.size())));
}

/// The byte-order mark that some editors write before a text; it is not part of the text.
inline std::string_view byte_order_mark(std::string_view text) {
    return text.substr(0, text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
}

} // namespace course
