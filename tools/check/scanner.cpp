#include "check/scanner.hpp"

#include "base/lines.hpp"
#include "base/text.hpp"

#include <algorithm>

namespace course {
namespace {

struct Token {
    std::size_t end;
    bool hidden = false; ///< a comment or a quote
    bool closed = true;
};

std::size_t end_of_line(std::string_view text, std::size_t at) { return std::min(text.find('\n', at), text.size()); }

/// Behind a backslash, the next sign means nothing: a line's end, too, which may be two of them.
std::size_t behind_escape(std::string_view text, std::size_t at) {
    return at + (text.substr(at + 1).starts_with("\r\n") ? 3 : 2);
}

Token line_comment_at(std::string_view text, std::size_t at) {
    while (at < text.size() && text[at] != '\n') at = text[at] == '\\' ? behind_escape(text, at) : at + 1;
    return {std::min(at, text.size()), true};
}

/// One that another one follows in a later line, before an end comes, has none of its own.
Token comment_at(std::string_view text, std::size_t begin) {
    const std::size_t line = end_of_line(text, begin);
    for (std::size_t at = begin + 2; at < text.size(); ++at) {
        const std::string_view next = text.substr(at, 2);
        if (next == "*/") return {at + 2, true};
        if (next == "/*" && at > line) break;
    }
    return {line, true, false};
}

Token quote_at(std::string_view text, std::size_t begin) {
    std::size_t at = begin + 1;
    while (at < text.size() && text[at] != '\n') {
        if (text[at] == text[begin]) return {at + 1, true};
        at = text[at] == '\\' ? behind_escape(text, at) : at + 1;
    }
    return {std::min(at, text.size()), true, false};
}

/// R"x( … )x"
Token raw_quote_at(std::string_view text, std::size_t begin) {
    constexpr std::size_t longest_delimiter = 16;
    const std::string_view opens = text.substr(begin + 1, longest_delimiter + 1);
    const std::size_t bracket = opens.find('(');
    if (bracket == opens.npos) return quote_at(text, begin);
    const std::string closes = ')' + std::string{opens.substr(0, bracket)} + '"';
    const std::size_t at = text.find(closes, begin + 2 + bracket);
    return at == text.npos ? Token{text.size(), true, false} : Token{at + closes.size(), true};
}

/// A name, or a number with all that may be in it: 0x1p-3, 1'000.
Token word_at(std::string_view text, std::size_t begin) {
    const auto separates = [&](std::size_t at) {
        return (text[at] == '\'' && at + 1 < text.size() && is_in_a_name(text[at + 1])) || text[at] == '.';
    };
    std::size_t at = begin;
    while (at < text.size() && (is_in_a_name(text[at]) || (is_digit(text[begin]) && separates(at)))) ++at;
    const bool raw = is_any_of(text.substr(begin, at - begin), {"R", "LR", "uR", "UR", "u8R"});
    return raw && at < text.size() && text[at] == '"' ? raw_quote_at(text, at) : Token{at};
}

Token token_at(std::string_view text, std::size_t at) {
    const std::string_view next = text.substr(at, 2);
    if (is_in_a_name(text[at])) return word_at(text, at);
    if (next == "//") return line_comment_at(text, at);
    if (next == "/*") return comment_at(text, at);
    if (text[at] == '"' || text[at] == '\'') return quote_at(text, at);
    return {at + 1};
}

char opener_of(char c) { return c == ')' ? '(' : c == ']' ? '[' : c == '}' ? '{' : '\0'; }

} // namespace

Brackets::Brackets(std::string_view code) : closes(code.size(), code.npos) {
    std::vector<std::size_t> open;
    bool at_the_left = true;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const char c = code[i], opener = opener_of(c);
        if (c == '#' && at_the_left) i = std::min(line_comment_at(code, i).end, code.size() - 1);
        at_the_left = code[i] == '\n' || (at_the_left && contains(" \t\r", code.substr(i, 1)));
        if (c == '(' || c == '[' || c == '{') open.push_back(i);
        if (opener == '\0') continue;
        for (; !open.empty() && code[open.back()] != opener && code[open.back()] != '{'; open.pop_back())
            unclosed.push_back(open.back());
        if (open.empty() || code[open.back()] != opener) stray.push_back(i);
        else {
            closes[open.back()] = i;
            open.pop_back();
        }
    }
    unclosed.insert(unclosed.end(), open.begin(), open.end());
}

Source::Source(std::string_view text) : code{text}, lines{0} {
    for (std::size_t at = 0; at < text.size();) {
        const auto [end, hidden, closed] = token_at(text, at);
        if (!closed) (text[at] == '/' ? open_comments : open_quotes).push_back(at);
        if (hidden)
            std::replace_if(
                code.begin() + long(at), code.begin() + long(end), [](char c) { return c != '\n'; }, ' ');
        at = end;
    }
    for (std::size_t at = 0; at < code.size(); ++at)
        if (code[at] == '\n') lines.push_back(at + 1);
}

std::size_t Source::line_begins(int line) const {
    const std::size_t index = line > 0 ? static_cast<std::size_t>(line) - 1 : 0;
    return index < lines.size() ? lines[index] : code.size();
}

int Source::line_of(std::size_t place) const {
    return static_cast<int>(std::ranges::upper_bound(lines, place) - lines.begin());
}

std::string_view code_alone(std::string_view line) {
    std::size_t at = 0;
    while (at < line.size() && line.substr(at, 2) != "//") at = token_at(line, at).end;
    return trim(line.substr(0, at));
}

} // namespace course
