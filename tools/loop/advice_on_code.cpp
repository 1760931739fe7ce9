#include "loop/advice_rules.hpp"

#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <string_view>

namespace course {
namespace {

/// return a, b; and return none;
std::string about_return(const Said &said) {
    const std::string_view code = without_blanks(said.code);
    const std::size_t back = code.find("return ");
    if (back == code.npos) return {};
    std::string_view answer = code.substr(back + 7, code.find(';', back) - back - 7);
    const bool is_about_it = contains(said.words, "conver") || contains(said.words, "left operand of comma");
    if (has_comma(answer) && is_about_it) return "Two values need braces: return {first, second};";
    bool is_strange = contains(said.words, "was not declared") || contains(said.words, "undeclared");
    for (const char *quote : {"'", "\""})
        if (answer.size() > 2 && answer.starts_with(quote) && answer.ends_with(quote)) {
            is_strange = contains(said.words, "conver") || contains(said.words, "character constant");
            answer = answer.substr(1, answer.size() - 2);
        }
    return is_strange && is_any_of(answer, {"nothing", "none", "None", "null"}) ? answer_nothing : "";
}

/// {a, b}; where a return belongs before it
std::string about_bare_braces(const Said &said) {
    if (!said.words.starts_with("expected ';'")) return {};
    std::string_view code = code_alone(said.code);
    if (code.ends_with(';')) code.remove_suffix(1);
    const std::size_t begins = code.rfind('{');
    if (begins == code.npos || !code.ends_with('}')) return {};
    const std::string_view before = without_blanks_behind(code.substr(0, begins)),
                           inside = without_blanks(code.substr(begins + 1, code.size() - begins - 2));
    const std::string_view behind = inside.substr(first_word(inside).size()), next = without_blanks(behind);
    const bool is_block = before.empty() || before.ends_with(')') || before.ends_with("else");
    const bool declares = behind.starts_with(' ') && !next.empty() && is_in_a_name(next.front());
    const bool does_something = contains(inside, ";") || contains(inside, "=") || declares;
    return is_block && has_comma(inside) && !does_something ? "An answer needs return before its braces: return {a, b};"
                                                            : "";
}

/// "expected ';' before 'double'": GCC names what comes after the gap, Clang points into it.
std::string about_semicolon(const Said &said) {
    const bool unfinished = said.words.starts_with("expected initializer before '");
    const bool wants_one = said.words.starts_with("expected") && contains(said.words, "';'");
    if ((!unfinished && !wants_one) || said.code.empty()) return {};
    const auto names = in_quotes(said.words);
    if (contains(said.words, "before '") && without_blanks(said.code).starts_with(names.back()))
        return "Look at the end of the line above: is its ; there?";
    if (unfinished) return {};
    const std::string_view code = without_blanks_behind(std::string_view{said.code}.substr(0, said.code.find("//")));
    const std::size_t caret = said.caret.find('^');
    const bool at_the_end = caret != said.caret.npos && caret >= code.size();
    return at_the_end ? "A ; is missing at the end of this line." : "";
}

/// 2 velocity, where the compiler ends the sum after the 2.
bool number_meets_name(std::string_view code) {
    code = code.substr(0, code.find("//"));
    for (std::size_t blank = 0; (blank = code.find(' ', blank)) != code.npos; ++blank) {
        const std::string_view left = code.substr(0, blank), right = without_blanks(code.substr(blank));
        const std::size_t before = left.find_last_not_of("0123456789.");
        const bool is_literal = before + 1 < left.size() && (before == left.npos || !is_in_a_name(left[before]));
        if (is_literal && !right.empty() && is_in_a_name(right[0]) && first_word(right) != "and"
            && first_word(right) != "or")
            return true;
    }
    return false;
}

/// 0.5(a + b), 2 t
std::string about_missing_star(const Said &said) {
    const auto names = in_quotes(said.words);
    const std::size_t caret = said.caret.find('^');
    if (contains(said.words, "expression cannot be used as a function")
        || (said.words.starts_with("called object type '") && is_number(names[0])))
        return said.code.find("()", caret) == caret ? no_call : missing_star; // box.mass()
    const bool cannot_add = contains(said.words, "operand types are '") || contains(said.words, "binary expression (");
    if (cannot_add && number_meets_name(said.code)) return missing_star;
    if (!said.words.starts_with("expected") || !contains(said.words, "';'")) return {};
    if (caret >= said.code.size()) return {};
    const std::string_view left = without_blanks_behind(std::string_view{said.code}.substr(0, caret)),
                           right = without_blanks(std::string_view{said.code}.substr(caret));
    if (left.empty() || right.empty() || !(is_in_a_name(left.back()) || left.ends_with(')'))) return {};
    const std::string_view word = first_word(right);
    const Words statements{"", "return", "if", "for", "while", "else", "const", "auto", "double", "int"};
    return is_any_of(word, statements) ? "" : missing_star;
}

/// t², t ** 2
std::string about_power(const Said &said) {
    if (contains(said.words, "²") || contains(said.words, "<U+00B2>"))
        return "² isn't C++: write (t * t), with the brackets.";
    const bool dereferences =
        contains(said.words, "type argument of unary '*'") || contains(said.words, "indirection requires pointer");
    return dereferences && contains(said.code, "**") ? "** isn't a power: write (t * t), with the brackets." : "";
}

/// -b ± c, -b +/- c
std::string about_two_signs(const Said &said) {
    const bool no_operand =
        said.words.starts_with("expected primary-expression before '/'") || said.words == "expected expression";
    const bool is_it = contains_any(said.words, {"±", "<U+00B1>"}) || (no_operand && contains(said.code, "+/-"));
    return is_it ? "± stands for two values: write + for one of them, and - for the other." : "";
}

/// if t < 1, if (t < 1 x = 2, if (t < 1) && (t > 0), else (t < 1), if (t < 1);
std::string about_if(const Said &said) {
    const std::string_view code = code_alone(said.code);
    if (said.words.starts_with("expected '(' ") && contains(code, "if "))
        return "An if needs parentheses: if (t < 1) …";
    if (contains(said.words, "expected ';'") && contains(code, "else ("))
        return "A question after else needs an if of its own: else if (t < 1) …";
    const std::size_t begins = code.find("if (");
    if (begins == code.npos) return {};
    const std::size_t end = where_it_closes(code, begins + 3);
    if (end == code.npos)
        return said.words.starts_with("expected ';' before") || said.words == "expected ')'"
                   ? "Count the parentheses of the if: is a ) missing?"
                   : "";
    const std::string_view behind = without_blanks(code.substr(end + 1));
    const std::string_view joined = first_word(behind);
    if (behind.starts_with("&&") || behind.starts_with("||") || joined == "and" || joined == "or")
        return "One pair of parentheses holds the whole question: if (a > 0 && b > 0) …";
    const bool is_empty = contains(said.words, "empty body") || contains(said.words, "does not guard");
    return is_empty && behind.starts_with(';') ? "The ; behind the parentheses ends the if: remove it." : "";
}

/// t => 1
std::string about_order(const Said &said) {
    const bool no_operand =
        said.words.starts_with("expected primary-expression") || said.words == "expected expression";
    const bool turned_round = contains(said.code, "=>") || contains(said.code, "=<");
    return no_operand && turned_round ? "At least is >=, and at most is <=: the = comes last." : "";
}

/// const part = …, and a parameter: (Vec2 v, angle)
std::string about_missing_type(const Said &said) {
    const std::string_view code = without_blanks(said.code);
    const auto names = in_quotes(said.words);
    if (contains(said.words, "does not name a type") || contains(said.words, "requires a type specifier")) {
        const std::string_view name = code.starts_with("const ") ? first_word(code.substr(6)) : "";
        if (name.empty() || name == "Vec2") return {};
        const std::string_view behind = without_blanks(code.substr(6 + name.size()));
        return behind.starts_with('=') || behind.starts_with('{')
                   ? "A variable needs its type: const Vec2 a = …; or const double a = …;"
                   : "";
    }
    if (!contains(said.words, "has not been declared") && !contains(said.words, "unknown type name")) return {};
    const std::string parameter = ", " + (names.empty() ? "" : names[0]);
    const std::size_t at = code.find(parameter);
    const bool ends = at != code.npos && contains(",)", code.substr(at + parameter.size(), 1));
    return ends ? "A parameter needs its type, too: (Vec2 v, double t)." : "";
}

/// std::cos angle
std::string about_function_of_std(const Said &said) {
    if (!contains(said.words, "overloaded function")) return {};
    for (std::size_t at = 0; (at = said.code.find("std::", at)) != said.code.npos; at += 5) {
        const std::string_view rest = std::string_view{said.code}.substr(at + 5), name = first_word(rest);
        if (name.size() < rest.size() && rest[name.size()] == ' ')
            return "A call needs parentheses: std::" + std::string{name} + "(…).";
    }
    return {};
}

/// 2 * {x, y}: Clang names the operator, GCC stops at the brace, as it does elsewhere too. {x, y} / 2: both want a ;.
std::string about_braces(const Said &said) {
    constexpr const char *write_vec2 = "Write Vec2 before the braces: 2 * Vec2{x, y}.";
    if (said.words.starts_with("initializer list cannot be used on the right hand side of operator"))
        return contains("'+' '-' '*' '/'", said.words.substr(said.words.size() - 3)) ? write_vec2 : "";
    const std::size_t caret = said.caret.find('^'); // behind the braces of {x, y} / 2
    if (said.words.starts_with("expected") && contains(said.words, "';'") && caret < said.code.size()) {
        const std::string_view code = said.code, next = without_blanks(code.substr(caret));
        const bool computes = !next.empty() && contains("+-*/", next.substr(0, 1)) && !next.starts_with("//");
        return computes && without_blanks_behind(code.substr(0, caret)).ends_with('}') ? write_vec2 : "";
    }
    if (!said.words.starts_with("expected primary-expression before '{'")) return {};
    std::string code = said.code;
    std::erase(code, ' ');
    return contains_any(code, {"*{", "+{", "-{", "/{"}) ? write_vec2 : "";
}

/// An `else` without its block, as Clang says it.
std::string about_else(const Said &said) {
    return said.words == "expected expression" && without_blanks(said.code).starts_with("else") ? missing_brace : "";
}

/// if (a = b), where a cannot be changed, or is no number.
std::string about_condition(const Said &said) {
    const bool cannot_assign = contains_any(said.words, {"assignment of ", "left operand of assignment",
                                                         "cannot assign to", "is not assignable", "' to 'bool'",
                                                         "convertible to 'bool'", "'operator='", "overloaded '='"});
    const std::size_t begins = std::min(said.code.find("if ("), said.code.find("while ("));
    if (!cannot_assign || begins == said.code.npos) return {};
    const std::size_t end = std::min(where_it_closes(said.code, said.code.find('(', begins)), said.code.size() - 1);
    for (std::size_t i = said.code.find('(', begins); i < end; ++i) {
        const bool compares = said.code[i + 1] == '=' || contains("=<>!", said.code.substr(i - 1, 1));
        if (said.code[i] == '=' && !compares) return compare_it;
    }
    return {};
}

} // namespace

std::string advice_on_code(const Said &said) {
    return first_of({about_else, about_if, about_order, about_missing_type, about_return, about_condition,
                     about_bare_braces, about_semicolon, about_missing_star, about_power, about_two_signs,
                     about_function_of_std, about_braces},
                    said);
}

} // namespace course
