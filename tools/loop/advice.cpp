#include "loop/advice_rules.hpp"

#include "ground/text.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace course {
namespace {

struct Slip {
    const char *means;
    std::vector<std::string_view> said; ///< any of these gives it away: "words", or "words … with these in the notes"
};

const std::vector<Slip> slips{
    {"Put the answer behind return: return a; or, for nothing, return {};",
     {"return-statement with no value", "should return a value"}},
    {"Some path through this function has no `return`.", {"non-void function", "no return statement"}},
    {write_pi, {"'pi' is not a member of 'std'", "no member named 'pi' in namespace 'std'"}},
    {"If a section's name is before the dot, write two colons: name::function(…).",
     {"expected primary-expression before '.' token", "unexpected namespace name"}},
    {missing_star, {"unable to find numeric literal operator", "invalid suffix '"}},
    {call_it,
     {"unresolved overloaded function type", "cannot resolve overloaded function", "wrong type argument to unary minus",
      "(Eigen::MatrixBase<Vec2>::)() const' to type", "reference to non-static member function must be called",
      "invalid use of member function", "invalid use of non-static member function"}},
    {no_call,
     {"no match for call to '(const Vec2) ()'", "no match for call to '(Vec2) ()'",
      "call to object of type 'const Vec2'", "call to object of type 'Vec2'"}},
    {"Cosine and sine are std::cos(…) and std::sin(…).", {"'cosinus'", "'sinus'"}},
    {"Compare two at a time: a < b && b < c.",
     {"comparison in operand of", "do not have their mathematical meaning", "with boolean expression is always",
      "with expression of type 'bool' is always"}},
    {write_dot, {"product of Vec2s"}},
    {"Two vectors have no product with *: a.dot(b) is their dot product.", {"INVALID_VECTOR_VECTOR_PRODUCT"}},
    {"Write Vec2 in the place of auto.", {"IT_IS_READ_ONLY"}},
    {two_components, {"FLOATING_POINT_ARGUMENT_PASSED__INTEGER_WAS_EXPECTED"}},
    {"require_range takes numbers, Vec2s and lists of them: give it a struct's "
     "fields one by one, as start.position, start.velocity.",
     {"call to 'require_number"}},
    {compare_it, {"assignment used as truth value", "result of an assignment as a condition"}},
    {"A function can't stand inside another one: put it above. If it isn't meant to be inside, a } is missing above "
     "this line.",
     {"function-definition is not allowed here", "function definition is not allowed here"}},
    {missing_brace, {"expected '}' before 'else'"}},
    {"The header gives this function another result: copy its line from there.",
     {"ambiguating new declaration", "functions that differ only in their return type"}},
    {"Text needs double quotes: \"like this\".", {"to 'const char*'", "of type 'const char *' with an rvalue"}},
    {"A type before the name makes a second variable: to change the first one, leave it out.",
     {"shadows a previous local", "declaration shadows a local variable"}},
    {"The name is taken already: use what has it, or choose another name.",
     {"shadows a parameter", "redeclaration of '", "conflicting declaration '", "redefinition of '",
      "with a different type: '"}},
    {"The size of a list is a std::size_t: for (std::size_t i = 0; …).",
     {"of different signedness", "of different signs"}},
    {"An int has no digits after the decimal point: to keep them, write double; to drop them, int(…).",
     {"conversion from 'double' to 'int'", "number into integer: 'double' to 'int'"}},
    {"push_back takes one value: call it once for each number.",
     {"vector<double>::push_back(<brace", "push_back … initializer list argument to 'const std::vector<double>"}},
    {"push_back takes one value: a Vec2 or a struct in braces, push_back({a, b}), or one number at a time.",
     {"push_back … expects 1 argument", "push_back … requires single argument"}},
    {"Look up in the header how many arguments this function has.",
     {"too few arguments to function", "too many arguments to function",
      "no matching function for call to … candidate function not viable: requires"}},
    {copy_it,
     {"assignment of read-only", "crement of read-only", "in read-only object", "discards qualifiers",
      "returns a const value", "with const-qualified type", "function is not marked const", "drops 'const' qualifier",
      "no viable overloaded ' … not marked const", "no viable overloaded ' … for object argument",
      "no matching member function for call … not marked const"}},
};

} // namespace

std::string first_of(std::initializer_list<Rule> rules, const Said &said) {
    for (const Rule about : rules)
        if (std::string means = about(said); !means.empty()) return means;
    return {};
}

std::string with_article(const std::string &name) {
    return (contains("AEIOU", name.substr(0, 1)) ? "an " : "a ") + name;
}

std::string wanted(const std::string &name, const std::string &instead) {
    return with_capital(with_article(name)) + " is wanted here" + instead
           + ": put its fields in braces, in the order of the header.";
}

bool calls_no_function(const Said &said) {
    return said.words.starts_with("no match for call to '(")
           || contains(said.words, "does not provide a call operator");
}

std::string advice(const Said &said) {
    if (std::string means = first_of({advice_on_lists, advice_on_code, advice_on_types, advice_on_names}, said);
        !means.empty())
        return means;
    const auto gives_away = [&](std::string_view slip) {
        constexpr std::string_view between = " … ";
        const std::size_t words = std::min(slip.find(between), slip.size());
        return contains(said.words, slip.substr(0, words))
               && contains(said.notes, slip.substr(std::min(words + between.size(), slip.size())));
    };
    for (const auto &[means, any] : slips) // the first: Clang says "non-void function 'f' should return a value"
        if (std::ranges::any_of(any, gives_away)) return means;
    return {};
}

} // namespace course
