#include "loop/functions.hpp"

#include "ground/text.hpp"
#include "loop/said.hpp"

#include <algorithm>

namespace course {

namespace {

/// What ends the comment or quote that begins here; nothing if none does.
std::string end_of_hidden(std::string_view code, std::size_t at) {
    const std::string_view rest = code.substr(at);
    const bool in_a_name = at > 0 && is_in_a_name(code[at - 1]); // 1'000, and the quote of a raw string
    if (rest.starts_with("//")) return "\n";
    if (rest.starts_with("/*")) return "*/";
    if (rest.starts_with("R\"") && !in_a_name)
        return ')' + std::string{rest.substr(2, std::min(rest.find('('), rest.size()) - 2)} + '"';
    if (rest.starts_with('"')) return "\"";
    return rest.starts_with('\'') && !in_a_name ? "'" : "";
}

} // namespace

std::string code_of(std::string code) {
    for (const char *escape : {"\\\\", "\\\"", "\\'"}) replace_all(code, escape, "  ");
    for (std::size_t at = 0; at < code.size(); ++at) {
        const std::string end = end_of_hidden(code, at);
        if (end.empty()) continue;
        const bool in_one_line = end == "\"" || end == "'"; // which ends there, too, if nobody has closed it
        std::size_t behind = code.find(end, at + (in_one_line ? 1 : 2));
        if (in_one_line) behind = std::min(behind, code.find('\n', at));
        behind = behind == code.npos ? code.size() : behind + end.size();
        std::replace_if(
            code.begin() + long(at), code.begin() + long(behind), [](char c) { return c != '\n'; }, ' ');
        at = behind - 1;
    }
    return code;
}

namespace {

/// Where this name stands as a word of its own, with a bracket behind it: at the bracket.
std::size_t find_bracket_of(std::string_view code, std::string_view name, std::size_t from) {
    for (std::size_t at = code.find(name, from); at != code.npos; at = code.find(name, at + 1)) {
        const std::size_t behind = code.find_first_not_of(" \t\n", at + name.size());
        const bool whole = at == 0 || (!is_in_a_name(code[at - 1]) && code[at - 1] != '.');
        if (whole && behind != code.npos && code[behind] == '(') return behind;
    }
    return code.npos;
}

/// The first of these places that is a heading: behind its brackets, a body begins.
std::optional<Definition> heading_of(std::string_view code, std::string_view name, std::size_t from) {
    for (std::size_t at = from; (at = find_bracket_of(code, name, at)) != code.npos; ++at) {
        const std::size_t closes = where_it_closes(code, at);
        if (closes == code.npos) continue;
        const std::size_t body = code.find_first_not_of(" \t\n", closes + 1);
        if (body == code.npos || code[body] != '{') continue;
        const std::size_t line = code.rfind('\n', at);
        return Definition{line == code.npos ? 0 : line + 1, body, code.size()};
    }
    return {};
}

} // namespace

std::size_t line_begins(std::string_view text, int line) {
    std::size_t at = 0;
    for (; line > 1 && at < text.size(); --line) at = std::min(text.find('\n', at), text.size() - 1) + 1;
    return at;
}

std::optional<Definition> definition_of(std::string_view code, std::string_view function,
                                        const std::vector<std::string> &others) {
    auto found = heading_of(code, function, 0);
    if (!found) return {};
    std::size_t next = code.size();
    for (const std::string &other : others)
        if (const auto its = heading_of(code, other, found->body); its && other != function)
            next = std::min(next, its->begin);
    const std::size_t closes = where_it_closes(code, found->body);
    found->closed = closes < next;
    found->end = found->closed ? closes + 1 : next;
    return found;
}

std::optional<Definition> function_around(std::string_view code, std::size_t place) {
    std::size_t begin = 0;
    for (std::size_t at = 0; at < code.size(); ++at) {
        if (code[at] == '#') at = std::min(code.find('\n', at), code.size() - 1); // a line of the preprocessor
        else if (code[at] == '{' && contains(code.substr(begin, at - begin), ")")) {
            const std::size_t closes = where_it_closes(code, at);
            if (closes == code.npos) return {};
            const Definition found{code.find_first_not_of(" \t\n", begin), at, closes + 1};
            if (found.end > place) return found.holds(place) ? std::optional{found} : std::nullopt;
            at = closes;
        } else if (!contains(";{}", code.substr(at, 1))) continue;
        begin = at + 1;
    }
    return {};
}

bool calls(std::string_view code, const Definition &definition, std::string_view function) {
    return find_bracket_of(code.substr(0, definition.end), function, definition.body) != code.npos;
}

} // namespace course
