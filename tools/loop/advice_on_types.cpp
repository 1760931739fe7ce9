#include "loop/advice_rules.hpp"

#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace course {
namespace {

constexpr const char *answer_a_list = "A list needs braces: return {a}; for one value, return {}; for none.";
constexpr const char *number_already = "That is a number already: it has no fields.";
constexpr const char *vector_already = "That is a vector already: its components are a.x() and a.y().";
constexpr const char *two_in_braces = "Two values need braces: push_back({first, second});";
constexpr const char *type_before_braces = "Write the type before the braces: Vec2{1, 0}.";
constexpr const char *other_list = "The lists hold different things: begin an empty one, and fill it with push_back.";
constexpr const char *fields_in_braces = "The braces hold the fields of the result, in the order of the header: where "
                                         "it has a number, a.mass, say; where it "
                                         "has a Vec2, a.velocity; not the whole a.";
constexpr const char *call_function = "That is a function: call it, with what it needs in parentheses.";
constexpr const char *only_lists_grow = "Only a list has push_back: std::vector<Vec2> list;";
constexpr const char *pair_in_braces = "Two numbers make a vector in braces: Vec2{a, b}, not (a, b).";
constexpr const char *dot_is_number = "a.dot(b) is a number; a.dot(b) * b is a vector.";

bool is_optional(std::string_view type) { return contains(type, "std::optional<"); }

/// What to do with a struct that was taken for a vector or a number.
std::string about_fields(const std::string &name) {
    return with_capital(with_article(name)) + " is a struct: use its fields, one at a time.";
}

/// A field that a struct or a number does not have; or of a struct that an optional holds, asked of the optional.
std::string about_member(const Said &said) {
    const auto names = in_quotes(said.words);
    const bool no_struct =
        contains(said.words, "which is of non-class type '") || contains(said.words, "is not a structure or union");
    if (no_struct && !names.empty() && is_number(names.back())) return number_already;
    const auto [asked, member] = missing_member(said);
    if (member == "push_back" && !contains(asked, "std::")) return only_lists_grow;
    if (const std::string name = struct_name(asked); !name.empty() && !contains(said.words, "did you mean"))
        return "Look up the fields of " + name + " in the header.";
    if (is_vector(asked) && member == "length") return length_of_vector;
    if (is_vector(asked) && !contains(said.words, "did you mean")) return vector_already;
    if (!is_optional(asked)) return {};
    return "It may be nothing: ask first, if (found), and then write found->" + member + '.';
}

/// A struct where a list of numbers or vectors is to grow, or a number where a function wants the whole struct.
std::string about_argument(const Said &said) {
    std::vector<std::string> types = in_quotes(said.words); // GCC; of Clang's words the note says it
    if (const auto note = between(said.notes, "no known conversion from ", "\n"); note && types.size() < 2)
        types = in_quotes(with_short_names(std::string{*note}));
    std::string pushed{between(said.words, "push_back(", ")").value_or(types.empty() ? "" : types.front())};
    while (pushed.ends_with('&')) pushed.pop_back();
    std::string list; // what it is a list of
    for (const std::string &type : types)
        if (list.empty()) list = between(type, "vector<", ">").value_or("");
    if (contains(said.words, "push_back") && !struct_name(pushed).empty() && !list.empty() && struct_name(list).empty())
        return about_fields(struct_name(pushed));
    if (contains(said.code, "push_back((") && (contains(said.words, "push_back") || contains(said.words, "of comma")))
        return two_in_braces;
    const std::string element = struct_name(list);
    if (contains(said.words, "push_back") && !element.empty() && (is_vector(pushed) || is_number(pushed)))
        return wanted(element);
    const std::string all = said.words + said.notes;
    const auto own = between(all, "std::vector<", ">");
    const bool fields_pushed =
        contains(said.words, "push_back(<brace") || contains(said.notes, "initializer list argument");
    if (fields_pushed && own && !struct_name(*own).empty())
        return "The braces hold the fields of a " + struct_name(*own) + ", in the order of the header.";
    const bool gcc = said.words.starts_with("invalid initialization of reference of type '");
    if ((!gcc && !said.words.starts_with("no matching function for call to '")) || types.size() < 2) return {};
    const std::string &given = types[gcc ? 1 : 0];
    const bool wants_vector = gcc ? types[0].ends_with("Vec2&") : is_vector(types[1]);
    if (wants_vector && is_number(given)) return two_components;
    if (wants_vector && !struct_name(given).empty()) return about_fields(struct_name(given));
    const std::string whole = struct_name(gcc ? types.front() : types.back());
    if (whole.empty()) return {};
    if (is_number(given))
        return "A whole " + whole
               + " is wanted here, not a number: pass one that you have, a and not a.mass, or make one of its fields "
                 "in braces, in the order of the header.";
    return is_vector(given) || !struct_name(given).empty() ? wanted(whole) : "";
}

/// velocity.dot(2)
std::string about_dot(const Said &said) {
    return contains(said.words, "::dot(") || contains(said.words, "function for call to 'dot'")
               ? "A dot product has a vector on each side: a.dot(b)."
               : "";
}

/// std::abs(velocity)
std::string about_absolute(const Said &said) {
    const bool is_it = contains(said.words, "function for call to 'abs");
    return is_it && contains(said.words + said.notes, "Vec2") ? length_of_vector : "";
}

/// std::cos(link)
std::string about_sine(const Said &said) {
    std::string words = said.words;
    if (const auto note = between(said.notes, "no known conversion from ", "\n"))
        words += ' ' + with_short_names(std::string{*note});
    for (const char *function : {"sin", "cos", "tan", "sqrt"}) {
        if (!contains(words, "function for call to '" + std::string{function})) continue;
        for (std::string type : in_quotes(words)) {
            if (const auto given = between(type, std::string{function} + '(', ")")) type = *given;
            if (type != function && !struct_name(type).empty()) return about_fields(struct_name(type));
        }
    }
    return {};
}

/// Box.high: GCC points at the dot, Clang at the dot or at the type.
std::string about_type_with_dot(const Said &said) {
    const bool is_it = contains_any(
        said.words, {"before '.' token", "does not refer to a value", "dot operator on a type", "type name '"});
    std::size_t from = std::min(said.caret.find('^'), said.code.size());
    while (from > 0 && is_in_a_name(said.code[from - 1])) --from;
    const std::string_view code = std::string_view{said.code}.substr(from), type = first_word(code);
    if (!is_it || type.empty() || type[0] < 'A' || type[0] > 'Z' || !code.substr(type.size()).starts_with('.'))
        return {};
    const std::string_view field = first_word(code.substr(type.size() + 1));
    std::string own = type == "Vec2" ? "velocity" : std::string{type};
    own[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(own[0])));
    return std::string{type} + " is a type: before the dot, write the name of the parameter or variable, as in " + own
           + '.' + std::string{field} + '.';
}

/// 2 * time_of_flight: the name of a function, which is not called.
std::string about_function(const Said &said) {
    const bool takes_a_value =
        contains_any(said.words, {"invalid operands", "cannot convert", "cannot initialize", "incompatible"});
    for (const std::string &type : in_quotes(said.words))
        if (takes_a_value && type.ends_with(')') && contains(type, "(") && !contains(type, "::)")) return call_function;
    return {};
}

/// Whether there is a dot product in the statement that the caret points to, of those on the line.
bool has_dot_product(const Said &said) {
    const std::size_t caret = std::min(said.caret.find('^'), said.code.size()), end = said.code.find(';', caret),
                      before = caret == 0 ? said.code.npos : said.code.rfind(';', caret - 1);
    if (caret == said.code.size()) return contains(said.code, ".dot("); // it points nowhere
    const std::size_t begin = before == said.code.npos ? 0 : before;
    return contains(std::string_view{said.code}.substr(begin, end - begin), ".dot(");
}

/// a + (x, y), a = (x, y): parentheses for braces.
bool has_pair_in_parentheses(std::string_view code) {
    for (std::size_t at = 0; (at = code.find('(', at)) != code.npos; ++at) {
        const std::size_t before = at == 0 ? code.npos : code.find_last_not_of(' ', at - 1);
        if (before == code.npos || !contains("=+-", code.substr(before, 1))) continue;
        if (has_comma(code.substr(at, where_it_closes(code, at) + 1 - at))) return true;
    }
    return false;
}

/// a - b.norm(), a - list[i].squaredNorm(): what follows the operator is one name, and its length.
bool measures_only_the_last(std::string_view code) {
    for (std::size_t at = 0; (at = code.find_first_of("+-", at)) != code.npos; ++at) {
        const std::string_view right = without_blanks(code.substr(at + 1)),
                               name = right.substr(0, right.find_first_of(" (;"));
        if (name.ends_with(".norm") || name.ends_with(".squaredNorm")) return true;
    }
    return false;
}

/// GCC warns of the comma first, and Clang says no more than that = does not fit.
std::string about_pair(const Said &said) {
    const bool is_it =
        contains(said.words, "left operand of comma") || said.words.starts_with("no viable overloaded '='");
    return is_it && has_pair_in_parentheses(said.code) ? pair_in_braces : "";
}

/// Two operands that do not go together.
std::string about_operands(const Said &said) {
    if ((contains(said.words, "operand type is '") || contains(said.words, "to unary expression"))
        && contains(said.code, "=+"))
        return "To add to a value, write += and not =+.";
    const bool gcc = contains(said.words, "operand types are '") || contains(said.words, "invalid operands of types '");
    if (!gcc && !contains(said.words, "invalid operands to binary expression (")) return {};
    if (contains(said.words, "operator^") || (!gcc && contains(said.code, "^")))
        return "^ isn't a power: write (t * t), with the brackets.";
    const std::size_t caret = said.caret.find('^'); // below the operator
    const std::string at_caret = caret < said.code.size() ? said.code.substr(caret, 1) : "";
    if (contains(said.words, "operator%") || at_caret == "%") return "% is for whole numbers: make both an int.";
    const auto names = in_quotes(said.words);
    const bool operator_first = contains(said.words, "no match for '");
    if (names.size() < (operator_first ? 3 : 2)) return {};
    const std::string &left = names[operator_first ? 1 : 0], &right = names[operator_first ? 2 : 1];
    const bool assigns = contains("operator= operator+= operator-= operator*= operator/= ", names[0] + ' ');
    if (operator_first && assigns && left.starts_with("const ")) return copy_it;
    if (is_optional(left) || is_optional(right))
        return "An optional may be nothing: ask first, if (found), and then compare *found, or its field found->t.";
    const std::string asked = gcc ? names[0] : said.code + said.notes; // Clang shows only the code
    const bool asks_order = contains(asked, gcc ? "operator<" : " < ") || contains(asked, gcc ? "operator>" : " > ");
    if (is_vector(left) && is_vector(right) && asks_order)
        return "No vector is larger than another: compare their components, or their lengths.";
    if (is_vector(left) && is_vector(right) && contains(asked, gcc ? "operator/" : " / "))
        return "No vector can be divided by a vector: divide by its length, a / a.norm().";
    const bool mixed = (is_vector(left) && is_number(right)) || (is_number(left) && is_vector(right));
    if (mixed && has_pair_in_parentheses(said.code)) return pair_in_braces;
    if (mixed && has_dot_product(said)) return dot_is_number;
    if (mixed && is_vector(left) && measures_only_the_last(said.code))
        return "Only the last one is measured. Put brackets around all of it: (a - b).norm().";
    if (mixed)
        return "One of them is a number, the other a vector: its components are a.x() and a.y(), its length is "
               "a.norm().";
    const bool computes = !at_caret.empty() && contains("+-*/<>", at_caret);
    for (const std::string &operand : {left, right})
        if (const std::string name = struct_name(operand); computes && !name.empty()) return about_fields(name);
    return {};
}

/// return {x, y}; where the answer may be nothing
std::string about_optional_list(std::string_view optional) {
    std::string inside{between(optional, "std::optional<", ">").value_or("Vec2")};
    if (const std::size_t colon = inside.rfind(':'); colon != inside.npos) inside.erase(0, colon + 1);
    return "Write its type before the braces, " + inside + "{…}; to answer nothing, write return {};";
}

/// A value of one type where another is wanted.
std::string about_conversion(const Said &said) {
    const auto names = in_quotes(said.words);
    if (said.words.starts_with("no matching constructor for initialization of 'std::optional<")
        && contains(said.code, "return {"))
        return about_optional_list(names[0]);
    if (names.size() < 2 || !contains_any(said.words, {"convert", "conversion", "incompatible type"})) return {};
    const bool clang_assigns = said.words.starts_with("assigning to '"); // 'double' from incompatible type 'Vec2'
    const std::string &from = names[names.size() - (clang_assigns ? 1 : 2)],
                      &to = names[names.size() - (clang_assigns ? 2 : 1)];
    if (is_optional(to) && from.starts_with("<brace-enclosed")) return about_optional_list(to);
    if (is_optional(to) && (is_number(from) || from == "bool" || contains(from, "nullptr_t"))) return answer_nothing;
    if (to.starts_with("std::vector<") && contains(said.code, "return ") && !from.starts_with("<brace-enclosed")
        && !contains(from, "std::vector<"))
        return answer_a_list;
    if (contains(from, "vector<") && contains(to, "vector<")) return other_list;
    if (contains(said.code, "return {")
        && ((from.starts_with("<brace-enclosed") && !struct_name(to).empty())
            || (!struct_name(from).empty() && is_number(to))))
        return fields_in_braces;
    if (is_optional(from) && !is_optional(to))
        return "It may be nothing: ask first, if (found), and then write *found.";
    if (is_vector(from) && (is_number(to) || contains(to, "std::optional<double>")))
        return "A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm().";
    if (is_number(from) && is_vector(to)) {
        if (contains(said.code, ".norm();")) return "a.norm() is a number; a / a.norm() is a vector of length 1.";
        if (has_pair_in_parentheses(said.code)) return pair_in_braces;
        return has_dot_product(said) ? dot_is_number : two_components;
    }
    if ((is_number(from) || is_vector(from)) && !struct_name(to).empty()) return wanted(struct_name(to));
    if (!struct_name(from).empty() && (is_vector(to) || is_number(to))) return about_fields(struct_name(from));
    return {};
}

/// b ? {1, 0} : v
std::string about_choice(const Said &said) {
    const bool is_it =
        contains_any(said.words, {"before '{' token", "initializer list cannot be used", "expected expression"});
    return is_it && (contains(said.code, " ? {") || (contains(said.code, " ? ") && contains(said.code, " : {")))
               ? type_before_braces
               : "";
}

/// std::min(t, 1) and its like.
std::string about_two_types(const Said &said) {
    const bool is_it = contains_any(said.words, {"call to 'min", "call to 'max", "call to 'clamp"});
    const auto types = between(said.notes, "deduced conflicting types", "\n");
    if (!is_it || !types) return {};
    if (contains(*types, "unsigned"))
        return "All must be of one type: the size of a list as an int is int(list.size()).";
    return contains(*types, "'double'") && contains(*types, "'int'") ? "All must be of one type: write 1.0, not 1."
                                                                     : "";
}

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

std::string advice_on_types(const Said &said) {
    return first_of({about_two_vectors, about_product, about_uncalled, about_bare_type, about_other_struct,
                     about_struct_braces, about_member, about_argument, about_dot, about_absolute, about_sine,
                     about_type_with_dot, about_function, about_pair, about_operands, about_conversion, about_choice,
                     about_two_types},
                    said);
}

} // namespace course
