#include "loop/advice.hpp"

#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace course {
namespace {

constexpr const char *missing_star = "Is a * missing? A product needs it: 2 * t, 2 * (a + b).";
constexpr const char *write_pi = "Write std::numbers::pi, and #include <numbers> at the top of your file.";
constexpr const char *length_of_vector = "The length of a Vec2 is a.norm().";
constexpr const char *call_it = "A call needs parentheses: a.x(), not a.x.";
constexpr const char *whole_number =
    "An int has no digits after the decimal point: to keep them, write double; to drop them, int(…).";
constexpr const char *two_at_a_time = "Compare two at a time: a < b && b < c.";
constexpr const char *no_way_back = "Some path through this function has no `return`.";
constexpr const char *return_what = "Put the answer behind return: return a; or, for nothing, return {};";
constexpr const char *two_colons = "If a section's name is before the dot, write two colons: name::function(…).";
constexpr const char *copy_it = "It is const, so it cannot be changed: copy it, and change the copy.";
constexpr const char *two_components = "A Vec2 has two components: write Vec2{x, y}.";
constexpr const char *same_result = "The header gives this function another result: copy its line from there.";
constexpr const char *no_call = "A field has no parentheses: write a.position, not a.position().";
constexpr const char *answer_nothing = "To answer nothing, write return {};";
constexpr const char *answer_a_list = "A list needs braces: return {a}; for one value, return {}; for none.";
constexpr const char *double_quotes = "Text needs double quotes: \"like this\".";
constexpr const char *compare_it = "= gives a value; to compare, write ==.";
constexpr const char *missing_brace = "Is a } missing above this line?";
constexpr const char *nested =
    "A function cannot stand inside another one: put it above. If it is not meant to be inside, a } is missing above "
    "this line.";
constexpr const char *number_already = "That is a number already: it has no fields.";
constexpr const char *other_list = "The lists hold different things: begin an empty one, and fill it with push_back.";
constexpr const char *fields_in_braces =
    "The braces hold the fields of the result, in the order of the header; a number is "
    "a.mass, say, not the whole a.";
constexpr const char *one_more =
    "A type before the name makes a second variable: to change the first one, leave it out.";
constexpr const char *call_function = "That is a function: call it, with what it needs in parentheses.";
constexpr const char *count_arguments = "Look up in the header how many arguments this function has.";
constexpr const char *one_value =
    "push_back takes one value: a Vec2 or a struct in braces, push_back({a, b}), or one number at a time.";
constexpr const char *once_each = "push_back takes one value: call it once for each number.";
constexpr const char *write_dot = "For the dot product of two vectors write a.dot(b).";
constexpr const char *dot_is_number = "a.dot(b) is a number; a.dot(b) * b is a vector.";
constexpr const char *name_taken = "The name is taken already: use what has it, or choose another name.";
constexpr const char *count_in_size = "The size of a list is a std::size_t: for (std::size_t i = 0; …).";

/// A slip that the compiler's words alone give away, or together with a word of its notes.
struct Slip {
    const char *words;
    const char *note;
    const char *means;
};

constexpr std::array slips{
    Slip{"return-statement with no value", "", return_what},
    Slip{"should return a value", "", return_what}, // Clang: non-void function 'f' should return a value
    Slip{"non-void function", "", no_way_back},
    Slip{"no return statement", "", no_way_back},
    Slip{"'pi' is not a member of 'std'", "", write_pi},
    Slip{"no member named 'pi' in namespace 'std'", "", write_pi},
    Slip{"expected primary-expression before '.' token", "", two_colons},
    Slip{"unexpected namespace name", "", two_colons},
    Slip{"unable to find numeric literal operator", "", missing_star},
    Slip{"invalid suffix '", "", missing_star},
    Slip{"unresolved overloaded function type", "", call_it},
    Slip{"cannot resolve overloaded function", "", call_it},
    Slip{"wrong type argument to unary minus", "", call_it},
    Slip{"(Eigen::MatrixBase<Vec2>::)() const' to type", "", call_it},
    Slip{"no match for call to '(const Vec2) ()'", "", no_call},
    Slip{"no match for call to '(Vec2) ()'", "", no_call},
    Slip{"call to object of type 'const Vec2'", "", no_call},
    Slip{"call to object of type 'Vec2'", "", no_call},
    Slip{"reference to non-static member function must be called", "", call_it},
    Slip{"invalid use of member function", "", call_it},
    Slip{"invalid use of non-static member function", "", call_it},
    Slip{"comparison in operand of", "", two_at_a_time},
    Slip{"do not have their mathematical meaning", "", two_at_a_time},
    Slip{"with boolean expression is always", "", two_at_a_time},
    Slip{"with expression of type 'bool' is always", "", two_at_a_time},
    Slip{"product of Vec2s", "", write_dot},
    Slip{"INVALID_VECTOR_VECTOR_PRODUCT", "", "Two vectors have no product with *: a.dot(b) is their dot product."},
    Slip{"IT_IS_READ_ONLY", "", "Write Vec2 in the place of auto."},
    Slip{"FLOATING_POINT_ARGUMENT_PASSED__INTEGER_WAS_EXPECTED", "", two_components},
    Slip{"call to 'require_number", "",
         "require_range takes numbers, Vec2s and lists of them: give it a struct's "
         "fields one by one, as start.position, start.velocity."},
    Slip{"assignment used as truth value", "", compare_it},
    Slip{"result of an assignment as a condition", "", compare_it},
    Slip{"function-definition is not allowed here", "", nested},
    Slip{"function definition is not allowed here", "", nested},
    Slip{"expected '}' before 'else'", "", missing_brace},
    Slip{"ambiguating new declaration", "", same_result},
    Slip{"functions that differ only in their return type", "", same_result},
    Slip{"to 'const char*'", "", double_quotes},
    Slip{"of type 'const char *' with an rvalue", "", double_quotes},
    Slip{"shadows a previous local", "", one_more},
    Slip{"declaration shadows a local variable", "", one_more},
    Slip{"shadows a parameter", "", name_taken},
    Slip{"redeclaration of '", "", name_taken},
    Slip{"with a different type: '", "", name_taken}, // Clang: redefinition of 'a' with a different type: 'b' vs 'c'
    Slip{"of different signedness", "", count_in_size},
    Slip{"of different signs", "", count_in_size},
    Slip{"conversion from 'double' to 'int'", "", whole_number},
    Slip{"number into integer: 'double' to 'int'", "", whole_number},
    Slip{"vector<double>::push_back(<brace", "", once_each},
    Slip{"push_back", "initializer list argument to 'const std::vector<double>", once_each}, // Clang
    Slip{"push_back", "expects 1 argument", one_value},
    Slip{"push_back", "requires single argument", one_value},
    Slip{"too few arguments to function", "", count_arguments},
    Slip{"too many arguments to function", "", count_arguments},
    Slip{"no matching function for call to", "candidate function not viable: requires", count_arguments},
    Slip{"assignment of read-only", "", copy_it},
    Slip{"crement of read-only", "", copy_it},
    Slip{"in read-only object", "", copy_it},
    Slip{"discards qualifiers", "", copy_it},
    Slip{"returns a const value", "", copy_it},
    Slip{"with const-qualified type", "", copy_it},
    Slip{"function is not marked const", "", copy_it},
    Slip{"drops 'const' qualifier", "", copy_it},
    Slip{"no viable overloaded '", "not marked const", copy_it},
    Slip{"no viable overloaded '", "for object argument", copy_it},
    Slip{"no matching member function for call", "not marked const", copy_it},
};

/// Everything in plain quotes.
std::vector<std::string> in_quotes(std::string_view words) {
    std::vector<std::string> found;
    while (const auto next = between(words, "'", "'")) {
        found.emplace_back(*next);
        words.remove_prefix(static_cast<std::size_t>(next->data() + next->size() + 1 - words.data()));
    }
    return found;
}

bool is_optional(std::string_view type) { return contains(type, "std::optional<"); }
bool is_vector(std::string_view type) { return type.ends_with("Vec2") || type.ends_with("expression of Vec2s"); }
bool is_number(std::string_view type) {
    if (type.starts_with("const ")) type.remove_prefix(6);
    return type == "double" || type == "int" || type == "float" || type == "long" || type == "long int";
}

/// A struct of the course or the student's own: State, as the compiler writes it; or else nothing.
std::string struct_name(std::string_view type) {
    for (const char *word : {"const ", "struct "})
        if (type.starts_with(word)) type.remove_prefix(std::string_view{word}.size());
    if (type.ends_with('&')) type.remove_suffix(1);
    if (const std::size_t colon = type.rfind(':'); colon != type.npos) type.remove_prefix(colon + 1);
    const bool is_name =
        type.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789") == type.npos;
    if (!is_name || type.empty() || type[0] < 'A' || type[0] > 'Z' || type == "Vec2") return {};
    return std::string{type};
}

/// What to do with a struct that was taken for a vector or a number.
std::string about_fields(const std::string &name) {
    const bool vowel = contains("AEIOU", name.substr(0, 1));
    return (vowel ? "An " : "A ") + name + " is a struct: use its fields, one at a time.";
}

bool is_in_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// A name or a number with which this begins; or nothing.
std::string_view first_word(std::string_view code) {
    const auto end = std::find_if_not(code.begin(), code.end(), is_in_a_name);
    return code.substr(0, static_cast<std::size_t>(end - code.begin()));
}

/// a, b or (a, b): a comma that is in no inner brackets.
bool has_comma(std::string_view answer) {
    if (answer.starts_with('(') && answer.ends_with(')')) answer = answer.substr(1, answer.size() - 2);
    int open = 0;
    for (const char c : answer) {
        if (contains("([{<", {&c, 1})) ++open;
        if (contains(")]}>", {&c, 1})) --open;
        if (c == ',' && open == 0) return true;
    }
    return false;
}

/// return a, b; and return none;
std::string about_return(const Said &said) {
    const std::string_view code = without_blanks(said.code);
    const std::size_t back = code.find("return ");
    if (back == code.npos) return {};
    const std::string_view answer = code.substr(back + 7, code.find(';', back) - back - 7);
    const bool is_about_it = contains(said.words, "conver") || contains(said.words, "left operand of comma");
    if (has_comma(answer) && is_about_it) return "Two values need braces: return {first, second};";
    for (const char *none : {"nothing", "none", "None", "null"})
        if (answer == none && (contains(said.words, "was not declared") || contains(said.words, "undeclared")))
            return answer_nothing;
    return {};
}

/// "expected ';' before 'double'": GCC names what comes after the gap, Clang points into it.
std::string about_semicolon(const Said &said) {
    if (!said.words.starts_with("expected") || !contains(said.words, "';'") || said.code.empty()) return {};
    const auto names = in_quotes(said.words);
    if (contains(said.words, "before '") && without_blanks(said.code).starts_with(names.back()))
        return "Look at the end of the line above: is its ; there?";
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
    for (const char *statement : {"", "return", "if", "for", "while", "else", "const", "auto", "double", "int"})
        if (word == statement) return {};
    return missing_star;
}

/// t², t ** 2
std::string about_power(const Said &said) {
    if (contains(said.words, "²") || contains(said.words, "<U+00B2>")) return "² is not C++: write t * t.";
    const bool dereferences =
        contains(said.words, "type argument of unary '*'") || contains(said.words, "indirection requires pointer");
    return dereferences && contains(said.code, "**") ? "** is not a power: write t * t." : "";
}

/// Where the parenthesis closes that opens at `from`, or npos.
std::size_t where_it_closes(std::string_view code, std::size_t from) {
    int open = 0;
    for (std::size_t i = from; i < code.size(); ++i) {
        if (code[i] == '(') ++open;
        if (code[i] == ')' && --open == 0) return i;
    }
    return code.npos;
}

/// if t < 1, if (t < 1 x = 2, if (t < 1) && (t > 0), else (t < 1), if (t < 1);
std::string about_if(const Said &said) {
    const std::string_view code = without_blanks_behind(std::string_view{said.code}.substr(0, said.code.find("//")));
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
    return is_empty && behind == ";" ? "The ; behind the parentheses ends the if: remove it." : "";
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
    for (const char *slip : {"*{", "+{", "-{", "/{"})
        if (contains(code, slip)) return write_vec2;
    return {};
}

/// An `else` without its block, as Clang says it.
std::string about_else(const Said &said) {
    return said.words == "expected expression" && without_blanks(said.code).starts_with("else") ? missing_brace : "";
}

/// if (a = b), where a cannot be changed.
std::string about_condition(const Said &said) {
    bool cannot_assign = false;
    for (const char *words : {"assignment of ", "left operand of assignment", "cannot assign to", "is not assignable"})
        if (contains(said.words, words)) cannot_assign = true;
    const std::size_t begins = std::min(said.code.find("if ("), said.code.find("while ("));
    if (!cannot_assign || begins == said.code.npos) return {};
    const std::size_t end = std::min(where_it_closes(said.code, said.code.find('(', begins)), said.code.size() - 1);
    for (std::size_t i = said.code.find('(', begins); i < end; ++i) {
        const bool compares = said.code[i + 1] == '=' || contains("=<>!", said.code.substr(i - 1, 1));
        if (said.code[i] == '=' && !compares) return compare_it;
    }
    return {};
}

/// A field that a struct or a number does not have; or of a struct that an optional holds, asked of the optional.
std::string about_member(const Said &said) {
    const auto names = in_quotes(said.words);
    const bool no_struct =
        contains(said.words, "which is of non-class type '") || contains(said.words, "is not a structure or union");
    if (no_struct && !names.empty() && is_number(names.back())) return number_already;
    const bool gcc = contains(said.words, "has no member named '"), clang = said.words.starts_with("no member named '");
    if (names.size() < 2 || (!gcc && !clang)) return {};
    const std::string &asked = gcc ? names[0] : names[1];
    if (const std::string name = struct_name(asked); !name.empty() && !contains(said.words, "did you mean"))
        return "Look up the fields of " + name + " in the header.";
    if (is_vector(asked) && (gcc ? names[1] : names[0]) == "length") return length_of_vector;
    if (!is_optional(asked)) return {};
    return "It may be nothing: ask first, if (found), and then write found->" + (gcc ? names[1] : names[0]) + '.';
}

/// A struct where a list of numbers or vectors is to grow, or a number where a function wants the whole struct.
std::string about_argument(const Said &said) {
    std::vector<std::string> types = in_quotes(said.words); // GCC; of Clang's words the note says it
    if (const auto note = between(said.notes, "no known conversion from ", "\n"); note && types.size() < 2)
        types = in_quotes(*note);
    const std::string pushed{between(said.words, "push_back(", ")").value_or(types.empty() ? "" : types.front())};
    std::string list; // what it is a list of
    for (const std::string &type : types)
        if (list.empty()) list = between(type, "vector<", ">").value_or("");
    if (contains(said.words, "push_back") && !struct_name(pushed).empty() && !list.empty() && struct_name(list).empty())
        return about_fields(struct_name(pushed));
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
    return is_vector(given) || !struct_name(given).empty()
               ? "A " + whole + " is wanted here: put its fields in braces, in the order of the header."
               : "";
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

/// Box.high: GCC points at the dot, Clang at the dot or at the type.
std::string about_type_with_dot(const Said &said) {
    bool is_it = false;
    for (const char *words : {"before '.' token", "does not refer to a value", "dot operator on a type", "type name '"})
        if (contains(said.words, words)) is_it = true;
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
    bool takes_a_value = false;
    for (const char *words : {"invalid operands", "cannot convert", "cannot initialize", "incompatible"})
        if (contains(said.words, words)) takes_a_value = true;
    for (const std::string &type : in_quotes(said.words))
        if (takes_a_value && type.ends_with(')') && contains(type, "(") && !contains(type, "::)")) return call_function;
    return {};
}

/// Two operands that do not go together.
std::string about_operands(const Said &said) {
    if ((contains(said.words, "operand type is '") || contains(said.words, "to unary expression"))
        && contains(said.code, "=+"))
        return "To add to a value, write += and not =+.";
    const bool gcc = contains(said.words, "operand types are '") || contains(said.words, "invalid operands of types '");
    if (!gcc && !contains(said.words, "invalid operands to binary expression (")) return {};
    if (contains(said.words, "operator^") || (!gcc && contains(said.code, "^")))
        return "^ is not a power: write t * t.";
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
    if (mixed && contains(said.code, ".dot(")) return dot_is_number;
    if (mixed)
        return "One of them is a number, the other a vector: its components are a.x() and a.y(), its length is "
               "a.norm().";
    const bool computes = !at_caret.empty() && contains("+-*/", at_caret);
    for (const std::string &operand : {left, right})
        if (const std::string name = struct_name(operand); computes && !name.empty()) return about_fields(name);
    return {};
}

/// A name of the standard library, and its header.
struct Standard {
    const char *name;
    const char *header;
};
constexpr std::array standards{
    Standard{"cout", "iostream"},      Standard{"cerr", "iostream"},     Standard{"cin", "iostream"},
    Standard{"endl", "iostream"},      Standard{"sort", "algorithm"},    Standard{"count_if", "algorithm"},
    Standard{"clamp", "algorithm"},    Standard{"find_if", "algorithm"}, Standard{"ranges", "algorithm"},
    Standard{"accumulate", "numeric"}, Standard{"numbers", "numbers"},   Standard{"optional", "optional"},
    Standard{"array", "array"},        Standard{"set", "set"},           Standard{"map", "map"}};

/// Whether a function of this name is called: x(…), and not a.x() or max(…).
bool is_called(std::string_view code, const std::string &name) {
    for (std::size_t at = 0; (at = code.find(name + '(', at)) != code.npos; ++at)
        if (at == 0 || (code[at - 1] != '.' && !is_in_a_name(code[at - 1]))) return true;
    return false;
}

/// A name that the compiler does not know and has no guess at: of the standard library, of a function that is defined
/// further below or not at all, of a field, or of a variable whose braces have ended.
std::string about_unknown_name(const Said &said) {
    const bool unknown = contains(said.words, "was not declared in this scope")
                         || said.words.starts_with("use of undeclared identifier");
    const auto names = in_quotes(said.words);
    if (contains(said.words, "declared") && !names.empty() && names[0] == "numbers"
        && contains(said.code, "numbers::pi"))
        return write_pi;
    if (!unknown || names.empty()) return {};
    if (names[0] == "pi" || names[0] == "PI") return write_pi;
    if (names[0] == "norm" || names[0] == "length") return length_of_vector;
    if (names[0] == "dot") return write_dot;
    if (contains(said.words, "std::")) return {};
    for (const auto &[name, header] : standards)
        if (names[0] == name && names[0] != header) // a list of your own may be called `numbers`
            return "Write std::" + names[0] + ", and #include <" + header + "> at the top of your file.";
    if (is_called(said.code, names[0]))
        return "If " + names[0] + " is a function of yours, put it above the one that calls it.";
    if (names[0].size() == 2 && std::isalpha(static_cast<unsigned char>(names[0][0])) != 0
        && std::isdigit(static_cast<unsigned char>(names[0][1])) != 0)
        return "If " + names[0]
               + " is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; "
                 "else declare it above.";
    if (contains(said.words, "did you mean")) return {};
    return "A field needs its struct, as in start.velocity; a variable is known below the line that declares it, "
           "inside the same braces.";
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
    if (names.size() < 2
        || !(contains(said.words, "convert") || contains(said.words, "conversion")
             || contains(said.words, "incompatible type")))
        return {};
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
    if (is_vector(from) && is_number(to))
        return "A Vec2 is not a number: its components are a.x() and a.y(), its length is a.norm().";
    if (is_number(from) && is_vector(to)) {
        if (contains(said.code, ".norm();")) return "a.norm() is a number; a / a.norm() is a vector of length 1.";
        return contains(said.code, ".dot(") ? dot_is_number : two_components;
    }
    if (is_number(from) && !struct_name(to).empty())
        return "A " + struct_name(to) + " is wanted here: put its fields in braces, in the order of the header.";
    if (!struct_name(from).empty() && (is_vector(to) || is_number(to))) return about_fields(struct_name(from));
    return {};
}

/// std::min(t, 1) and its like.
std::string about_two_types(const Said &said) {
    const bool is_it = contains(said.words, "call to 'min") || contains(said.words, "call to 'max")
                       || contains(said.words, "call to 'clamp");
    const auto types = between(said.notes, "deduced conflicting types", "\n");
    if (!is_it || !types) return {};
    if (contains(*types, "unsigned"))
        return "All must be of one type: the size of a list as an int is int(list.size()).";
    return contains(*types, "'double'") && contains(*types, "'int'") ? "All must be of one type: write 1.0, not 1."
                                                                     : "";
}

/// A header that is not included. GCC says which one has the name; Clang does not know.
std::string about_header(const Said &said) {
    const auto write = [](std::string_view header) {
        return "Write #include <" + std::string{header} + "> at the top of your file.";
    };
    if (const auto header = between(said.notes, "did you forget to '#include <", ">")) return write(*header);
    if (!said.words.starts_with("no member named '") || !contains(said.words, "in namespace 'std'")) return {};
    for (const auto &[name, header] : standards)
        if (in_quotes(said.words).front() == name) return write(header);
    return {};
}

/// Where a type that begins at `from` ends: behind the last of its angle brackets.
std::size_t end_of_type(std::string_view text, std::size_t from) {
    int open = 0;
    for (std::size_t i = from; i < text.size(); ++i) {
        if (text[i] == '<') ++open;
        if (text[i] == '>' && --open == 0) return i + 1;
        if (open == 0 && text[i] == '\'') return i;
    }
    return text.size();
}

/// 'Eigen::…::ReturnType' {aka 'double'}, what dot() returns, is 'double'.
void name_doubles(std::string &text) {
    for (const char *known : {"' {aka 'double'}", "' (aka 'double')"})
        for (std::size_t at; (at = text.find(known)) != text.npos && at > 0;) {
            const std::size_t begin = text.rfind('\'', at - 1);
            if (begin == text.npos) return;
            text.replace(begin, at + std::string_view{known}.size() - begin, "'double'");
        }
}

} // namespace

std::string advice(const Said &said) {
    for (const auto about :
         {about_else,       about_if,           about_order,    about_missing_type,    about_return,   about_condition,
          about_semicolon,  about_missing_star, about_power,    about_function_of_std, about_braces,   about_member,
          about_argument,   about_dot,          about_absolute, about_type_with_dot,   about_function, about_operands,
          about_conversion, about_two_types,    about_header,   about_unknown_name})
        if (std::string means = about(said); !means.empty()) return means;
    for (const auto &[words, note, means] : slips)
        if (contains(said.words, words) && contains(said.notes, note)) return means;
    return {};
}

std::string with_short_names(std::string text) {
    name_doubles(text);
    erase_all(text, " {aka ", "}");
    erase_all(text, " (aka '", "')");
    erase_all(text, " [with ", "]");
    for (const char *spelling : {"Eigen::Matrix<double, 2, 1, 0, 2, 1>", "Eigen::Matrix<double, 2, 1, 0>",
                                 "Eigen::Matrix<double, 2, 1>", "course::Vec2"})
        replace_all(text, spelling, "Vec2");
    for (const char *type : {"Product<", "CwiseBinaryOp<", "CwiseUnaryOp<"})
        replace_all(text, std::string{"Eigen::"} + type, type); // Clang leaves it out here and there
    constexpr const char *product = "product of Vec2s";
    for (const auto &[type, name] : {std::pair{"Product<", product},
                                     {"CwiseBinaryOp<", "expression of Vec2s"},
                                     {"CwiseUnaryOp<", "expression of Vec2s"}}) {
        for (std::size_t at; (at = text.find(type)) != text.npos;) {
            const std::size_t length = end_of_type(text, at) - at;
            const bool has_product = contains(std::string_view{text}.substr(at, length), product);
            text.replace(at, length, has_product ? product : name); // a product that is halved is the slip of a product
        }
        replace_all(text, std::string{"const "} + name, name);
    }
    replace_all(text, "<Vec2 >", "<Vec2>");
    return text;
}

} // namespace course
