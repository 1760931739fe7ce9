#include "loop/advice.hpp"

#include "ground/text.hpp"
#include "loop/advice_rules.hpp"

#include <array>

namespace course {
namespace {

constexpr const char *whole_number =
    "An int has no digits after the decimal point: to keep them, write double; to drop them, int(…).";
constexpr const char *two_at_a_time = "Compare two at a time: a < b && b < c.";
constexpr const char *no_way_back = "Some path through this function has no `return`.";
constexpr const char *return_what = "Put the answer behind return: return a; or, for nothing, return {};";
constexpr const char *two_colons = "If a section's name is before the dot, write two colons: name::function(…).";
constexpr const char *same_result = "The header gives this function another result: copy its line from there.";
constexpr const char *double_quotes = "Text needs double quotes: \"like this\".";
constexpr const char *nested =
    "A function cannot stand inside another one: put it above. If it is not meant to be inside, a } is missing above "
    "this line.";
constexpr const char *one_more =
    "A type before the name makes a second variable: to change the first one, leave it out.";
constexpr const char *count_arguments = "Look up in the header how many arguments this function has.";
constexpr const char *one_value =
    "push_back takes one value: a Vec2 or a struct in braces, push_back({a, b}), or one number at a time.";
constexpr const char *once_each = "push_back takes one value: call it once for each number.";
constexpr const char *name_taken = "The name is taken already: use what has it, or choose another name.";
constexpr const char *short_names = "Cosine and sine are std::cos(…) and std::sin(…).";
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
    Slip{"'cosinus'", "", short_names},
    Slip{"'sinus'", "", short_names},
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
    Slip{"conflicting declaration '", "", name_taken},
    Slip{"redefinition of '", "", name_taken},        // Clang
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

} // namespace

std::string first_of(std::initializer_list<Rule> rules, const Said &said) {
    for (const Rule about : rules)
        if (std::string means = about(said); !means.empty()) return means;
    return {};
}

std::string with_article(const std::string &name) {
    return (contains("AEIOU", name.substr(0, 1)) ? "an " : "a ") + name;
}

bool calls_no_function(const Said &said) {
    return said.words.starts_with("no match for call to '(")
           || contains(said.words, "does not provide a call operator");
}

std::string advice(const Said &said) {
    if (std::string means = first_of(
            {advice_on_maps, advice_on_lists, advice_on_code, advice_on_structs, advice_on_types, advice_on_names},
            said);
        !means.empty())
        return means;
    for (const auto &[words, note, means] : slips)
        if (contains(said.words, words) && contains(said.notes, note)) return means;
    return {};
}

} // namespace course
