#include "check/functions.hpp"

#include "base/text.hpp"

#include <algorithm>

namespace course {

namespace {

constexpr const char *blanks = " \t\r\n";

bool is_in_a_type(char c) { return is_in_a_name(c) || contains(" \t\r\n:<>,*&[]", {&c, 1}); }

/// Where the last part of this begins that has only signs of one kind.
std::size_t begin_of(std::string_view code, bool (*belongs)(char)) {
    std::size_t at = code.size();
    while (at > 0 && belongs(code[at - 1])) --at;
    return at;
}

std::string_view last_name(std::string_view code) { return code.substr(begin_of(code, is_in_a_name)); }

std::string_view without_space_behind(std::string_view code) {
    return code.substr(0, code.find_last_not_of(blanks) + 1);
}

/// "return f", "else f": what stands before a name, and is no type.
bool is_a_type(std::string_view text) {
    bool any = false;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_in_a_name(text[end])) ++end;
        const std::string_view word = text.substr(at, end - at);
        if (is_any_of(word, {"return", "throw", "else", "case", "new", "delete", "using", "namespace", "if"}))
            return false;
        any = any || !word.empty();
        at = end + 1;
    }
    return any;
}

/// The function that has its parameters in this bracket, if it's a heading's, as far as its body. One that has no body is
/// only a heading if it's known, and first in its line.
std::optional<Function> heading_at(std::string_view code, const Brackets &brackets, std::size_t bracket,
                                   const std::vector<std::string> &known) {
    const std::string_view before = without_space_behind(code.substr(0, bracket)), name = last_name(before);
    std::string_view type = before.substr(0, before.size() - name.size());
    std::size_t begin = begin_of(type, is_in_a_type);
    if (begin > 0 && type[begin - 1] == '#')
        begin = std::min(code.find('\n', begin), type.size()); // an #include's line
    begin = std::min(type.find_first_not_of(blanks, begin), type.size());
    type.remove_prefix(begin);
    if (name.empty() || is_any_of(name, {"if", "for", "while", "switch", "catch"}) || !is_a_type(type)) return {};

    const std::size_t closes = brackets.closes[bracket];
    std::size_t next = closes == code.npos ? closes : code.find_first_not_of(blanks, closes + 1);
    for (const std::string_view word : {"const", "noexcept"})
        if (next != code.npos && code.substr(next).starts_with(word))
            next = code.find_first_not_of(blanks, next + word.size());
    if (next != code.npos && code[next] == '{') return Function{std::string{name}, begin, next};
    const bool declares = next != code.npos && code[next] == ';';
    const std::size_t ends = code.substr(0, begin).find_last_not_of(" \t"); // what's before it
    const bool is_first = ends == code.npos || code[ends] == '\n';
    if (declares || !is_first || std::ranges::count(known, name) == 0) return {};
    return Function{std::string{name}, begin, bracket, 0, Fault{Fault::What::no_body, bracket}};
}

bool is_of_a_namespace(std::string_view code, std::size_t brace) {
    const std::string_view before = code.substr(0, brace);
    return contains(before.substr(before.find_last_of(";{}") + 1), "namespace");
}

/// What's wrong with the brackets between two places, where namespaces are open: they may end here, but not the last of
/// them, unless another one begins.
std::optional<Fault> fault_between(const Source &source, std::size_t begin, std::size_t end, std::size_t &open) {
    std::optional<Fault> fault;
    const auto take = [&](Fault::What what, std::size_t place) {
        if (place >= begin && place < end && (!fault || place < fault->place)) fault = Fault{what, place};
    };
    for (const std::size_t place : source.open_comments) take(Fault::What::no_comment, place);
    for (const std::size_t place : source.open_quotes) take(Fault::What::no_quote, place);
    const Brackets brackets{std::string_view{source.code}.substr(begin, end - begin)};
    std::size_t opened = open;
    for (const std::size_t place : brackets.unclosed)
        if (source.code[begin + place] == '{' && is_of_a_namespace(source.code, begin + place)) ++opened;
        else take(Fault::What::not_closed, begin + place);
    for (const std::size_t place : brackets.stray)
        if (source.code[begin + place] == '}' && opened > 1) --opened;
        else take(Fault::What::too_many, begin + place);
    open = std::max<std::size_t>(opened, open > 0 ? 1 : 0);
    return fault;
}

bool stands_alone(std::string_view code, const Function &function, const std::vector<std::string> &known) {
    return function.begin == 0 || code[function.begin - 1] == '\n' || std::ranges::count(known, function.name) > 0;
}

/// Behind the last } that stands as far right as the heading does, or else where the next function begins.
std::size_t seems_to_end(std::string_view code, const Function &function, std::size_t next) {
    const std::string_view above = code.substr(0, function.begin),
                           inside = code.substr(function.body, next - function.body);
    const std::string brace =
        '\n' + std::string{above.substr(std::min(above.find_last_not_of(" \t") + 1, above.size()))} + '}';
    const std::size_t at = inside.rfind(brace);
    return at == inside.npos ? next : function.body + at + brace.size();
}

/// Sets where each function ends, by where the next one begins, and what's wrong with it.
void find_faults(const Source &source, Functions &functions, const std::vector<std::string> &known) {
    const std::string_view code = source.code;
    std::erase_if(functions, [&](const Function &each) { return !stands_alone(code, each, known); });
    if (functions.empty()) return;
    const Brackets above{code.substr(0, functions.front().begin)};
    std::size_t open = above.unclosed.size(), last = code.size(); // of namespaces
    for (std::size_t i = 0; i < open && last != code.npos; ++i)
        last = last == 0 ? code.npos : code.rfind('}', last - 1);
    for (std::size_t i = 0; i < functions.size(); ++i) {
        Function &function = functions[i];
        const std::size_t next = i + 1 < functions.size() ? functions[i + 1].begin : std::max(last, function.body);
        const auto fault = fault_between(source, function.begin, next, open);
        const bool lacks_parenthesis = fault && fault->place == function.body;
        if (!function.fault || lacks_parenthesis) function.fault = fault;
        if (function.fault) function.end = seems_to_end(code, function, next);
    }
}

} // namespace

Functions functions_of(const Source &source, const std::vector<std::string> &known) {
    const std::string_view code = source.code;
    const Brackets brackets{code};
    Functions functions;
    for (std::size_t at = 0; (at = code.find('(', at)) != code.npos; ++at)
        if (auto function = heading_at(code, brackets, at, known)) {
            if (!function->fault) function->end = std::min(brackets.closes[function->body], code.size() - 1) + 1;
            functions.push_back(std::move(*function));
        }
    if (brackets.stray.empty() && brackets.unclosed.empty() && source.open_comments.empty()
        && source.open_quotes.empty())
        std::erase_if(functions, [](const Function &each) { return each.fault.has_value(); }); // declarations
    else find_faults(source, functions, known);
    return functions;
}

const Function *find_function(const Functions &functions, std::string_view name) {
    const auto match = std::ranges::find(functions, name, &Function::name);
    return match == functions.end() ? nullptr : &*match;
}

const Function *function_around(const Functions &functions, std::size_t place) {
    const auto match = std::ranges::find_if(functions, [&](const Function &each) { return each.holds(place); });
    return match == functions.end() ? nullptr : &*match;
}

bool calls(const Source &source, const Function &caller, std::string_view function) {
    const std::string_view code = std::string_view{source.code}.substr(0, caller.end);
    for (std::size_t at = caller.body; (at = code.find(function, at)) != code.npos; ++at) {
        const bool whole = !is_in_a_name(code[at - 1]) && code[at - 1] != '.';
        const std::size_t behind = code.find_first_not_of(blanks, at + function.size());
        if (whole && behind != code.npos && code[behind] == '(') return true;
    }
    return false;
}

bool opens_namespace(const Source &source, std::string_view name) {
    const std::string_view code = source.code;
    for (std::size_t at = 0; (at = code.find(name, at)) != code.npos; ++at) {
        const std::size_t behind = code.find_first_not_of(blanks, at + name.size());
        if (behind != code.npos && code[behind] == '{'
            && last_name(without_space_behind(code.substr(0, at))) == "namespace")
            return true;
    }
    return false;
}

} // namespace course
