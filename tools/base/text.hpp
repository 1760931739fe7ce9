#pragma once
// Searches in text that others wrote. A regular expression of libstdc++ recurses once for each character that it
// matches, so a long line of a student's file would end the program; these do not.

#include <algorithm>
#include <cctype>
#include <charconv>
#include <concepts>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace course {

inline bool contains(std::string_view text, std::string_view words) { return text.find(words) != text.npos; }

using Words = std::initializer_list<std::string_view>;
inline bool contains_any(std::string_view text, Words all) {
    return std::ranges::any_of(all, [&](std::string_view words) { return contains(text, words); });
}
inline bool is_any_of(std::string_view text, Words all) { return std::ranges::find(all, text) != all.end(); }

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_all_digits(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_digit); }

inline bool is_in_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// With small letters, in ASCII.
inline std::string lower(std::string_view text) {
    std::string small{text};
    for (char &c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small;
}

/// With a capital letter first, in ASCII.
inline std::string with_capital(std::string words) {
    if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

/// "1 test", "5 tests"
template <std::integral Count> std::string pluralize(Count count, std::string_view thing) {
    return std::to_string(count).append(" ").append(thing).append(count == 1 ? "" : "s");
}

/// The number that `text` begins with, if it begins with one that fits.
inline std::optional<int> leading_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || number < 0) return {};
    return number;
}

/// What is between the first `before` and the next `after`; nothing if one of them is missing.
inline std::optional<std::string_view> between(std::string_view text, std::string_view before, std::string_view after) {
    const std::size_t from = text.find(before);
    if (from == text.npos) return {};
    text.remove_prefix(from + before.size());
    const std::size_t to = text.find(after);
    if (to == text.npos) return {};
    return text.substr(0, to);
}
template <std::same_as<std::string> Temporary> // a view into one would dangle
void between(Temporary &&, std::string_view, std::string_view) = delete;

inline void replace_all(std::string &text, std::string_view old, std::string_view with) {
    std::size_t from = 0, at = text.find(old);
    if (at == text.npos) return;
    std::string out; // what's behind isn't moved for each
    for (; at != text.npos; at = text.find(old, from)) {
        out.append(text, from, at - from).append(with);
        from = at + old.size();
    }
    text = out.append(text, from);
}

/// "a < b" as "a &lt; b", fit for the text of HTML and SVG, and for attributes.
inline std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') out += "&amp;";
        else if (c == '<') out += "&lt;";
        else if (c == '>') out += "&gt;";
        else if (c == '"') out += "&quot;";
        else out += c;
    }
    return out;
}

/// Without anything that begins with `first`, as far as the next `last`: asides of a compiler.
inline void erase_all(std::string &text, std::string_view first, std::string_view last) {
    for (std::size_t at = 0; (at = text.find(first, at)) != text.npos;) {
        const std::size_t end = text.find(last, at + first.size());
        if (end == text.npos) return;
        text.erase(at, end + last.size() - at);
    }
}

} // namespace course
