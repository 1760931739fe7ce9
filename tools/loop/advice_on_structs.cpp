#include "loop/advice_rules.hpp"

#include "ground/text.hpp"

#include <string_view>

namespace course {
namespace {

constexpr const char *two_numbers =
    "A Vec2 is made of two numbers, Vec2{x, y}, and not of two vectors: the vector from a to b is b - a.";

/// The struct in whose braces the compiler stands: Ball, of `Ball{a.position, 2}` or `Ball(a.position, 2)`.
std::string struct_around(const Said &said) {
    const std::size_t caret = said.caret.find('^');
    if (caret == said.caret.npos || caret >= said.code.size()) return {};
    int closed = 0;
    for (std::size_t i = caret; i-- > 0;) {
        if (contains(")]}", said.code.substr(i, 1))) ++closed;
        if (!contains("([{", said.code.substr(i, 1)) || closed-- > 0) continue;
        std::size_t begin = i;
        while (begin > 0 && is_in_a_name(said.code[begin - 1])) --begin;
        return struct_name(std::string_view{said.code}.substr(begin, i - begin));
    }
    return {};
}

/// Disc{a, b}, with fields that a Disc does not have there.
std::string about_struct_braces(const Said &said) {
    if (contains_any(said.words, {"std::optional<", "::)(", "product of Vec2s"})) return {}; // other rules know more
    std::string name;
    for (const char *words : {"could not convert", "cannot convert", "no viable conversion", "cannot initialize"})
        if (said.words.starts_with(words)) name = struct_around(said);
    for (const char *words : {"too many initializers for '", "no matching constructor for initialization of '"})
        if (said.words.starts_with(words)) name = struct_name(in_quotes(said.words).front());
    if (name.empty()) return {};
    const bool is_answer = contains(said.code, "return " + name + '{') || contains(said.code, "return " + name + '(');
    return "The braces of " + with_article(name) + " hold its fields, in the order of the header"
           + (is_answer ? "; if the result is another struct, write return {…};" : ".");
}

/// return ball; where Velocities are wanted
std::string about_other_struct(const Said &said) {
    if (!said.words.starts_with("could not convert") && !said.words.starts_with("no viable conversion")) return {};
    const auto names = in_quotes(said.words);
    if (names.size() < 2) return {};
    const std::string from = struct_name(names[names.size() - 2]), to = struct_name(names.back());
    if (from.empty() || to.empty() || from == to) return {};
    return wanted(to, ", not " + with_article(from));
}

/// return Pair;
std::string about_bare_type(const Said &said) {
    const bool no_value = said.words == "expected primary-expression before ';' token"
                          || contains(said.words, "does not refer to a value")
                          || said.words.starts_with("unexpected type name '");
    const auto answer = between(said.code, "return ", ";");
    if (!no_value || !answer || struct_name(*answer).empty()) return {};
    const std::string name{*answer};
    return name + " is a type: answer with a value, a variable or " + name + "{…}.";
}

/// Vec2{a, b}: the compiler stands in the library, which makes numbers of them.
std::string about_two_vectors(const Said &said) {
    const bool casts =
        said.words.starts_with("invalid cast from type '") || contains(said.words, "without a conversion");
    const auto names = in_quotes(said.words);
    return casts && said.code.empty() && names.size() == 2 && is_vector(names[0]) && is_number(names[1]) ? two_numbers
                                                                                                         : "";
}

/// {n.y(), n.x}: of braces, GCC says no more than that they do not fit.
std::string about_uncalled(const Said &said) {
    if (contains_any(said.words, {", 1>::x}", ", 1>::x,", ", 1>::y}", ", 1>::y,"})) return call_it;
    if (!contains(said.words, "'Vec2::Matrix(<brace") || !contains(said.notes, "deduce template parameter 'T"))
        return {};
    for (const std::string component : {".x", ".y"})
        for (std::size_t at = 0; (at = said.code.find(component, at)) != said.code.npos; at += 2) {
            const std::string behind = said.code.substr(at + 2, 1);
            if (behind.empty() || (behind != "(" && !is_in_a_name(behind[0]))) return call_it;
        }
    return {};
}

/// {n * v, 2}: of braces, GCC says no more than that they do not fit.
std::string about_product(const Said &said) { return contains(said.words, "::operator*<Vec2>(") ? write_dot : ""; }

} // namespace

std::string advice_on_structs(const Said &said) {
    return first_of(
        {about_two_vectors, about_product, about_uncalled, about_bare_type, about_other_struct, about_struct_braces},
        said);
}

} // namespace course
