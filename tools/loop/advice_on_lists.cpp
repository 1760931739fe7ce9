#include "loop/advice_rules.hpp"

#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <string_view>

namespace course {
namespace {

constexpr const char *colon_for_in =
    "A loop over a list has a colon: for (const Vec2 &v : list), or for (int i : list).";
constexpr const char *one_element = "That's a list: one element of it is list[i], the first is list[0].";
constexpr const char *count_them = "How many elements a list has is list.size().";
constexpr const char *element_or_size =
    "That's the whole list: one element of it is list[i], and how many it has is list.size().";
constexpr const char *last_one = "The last element of a list is list.back().";
constexpr const char *to_add = "To add to a list, write list.push_back(a).";
constexpr const char *close_angle = "Each < of a type needs its >: is one missing?";

/// for (const int i in list), for i of list:
std::string about_loop(const Said &said) {
    const std::string_view code = code_alone(said.code);
    if (!code.starts_with("for (") && !code.starts_with("for ")) return {};
    for (const char *word : {" in ", " of "}) {
        const std::size_t at = code.find(word);
        if (at == code.npos || contains(code.substr(0, at), ";") || contains(code.substr(0, at), " : ")) continue;
        const std::string_view behind = code.substr(at + 4);
        if (is_in_a_name(code[at - 1]) && !behind.empty() && is_in_a_name(behind[0])) return colon_for_in;
    }
    return {};
}

/// pairs.add(2), centres.length, centres.x()
std::string about_list_member(const Said &said) {
    const auto [asked, member] = missing_member(said);
    const auto element = between(asked, "std::vector<", ">");
    if (!element) return {};
    if (member == "last") return last_one;
    if (contains(said.words, "did you mean")) return {};
    const bool may_be_field = !struct_name(*element).empty() && !contains(said.code, '.' + member + '(');
    if (member == "length" && may_be_field) return element_or_size;
    if (is_any_of(member, {"add", "append", "push", "Add"})) return to_add;
    if (is_any_of(member, {"length", "count", "len"})) return count_them;
    const bool of_a_vector = is_any_of(member, {"x", "y", "norm", "dot", "normalized", "squaredNorm"});
    return may_be_field || (is_vector(*element) && of_a_vector) ? one_element : "";
}

/// list(2)
std::string about_list_brackets(const Said &said) {
    const auto names = in_quotes(said.words);
    if (!calls_no_function(said) || names.empty()) return {};
    const std::string_view type = std::string_view{names[0]}.substr(names[0].starts_with('(') ? 1 : 0);
    return type.starts_with("std::vector<") || type.starts_with("const std::vector<")
               ? "An element of a list stands in square brackets: list[i]."
               : "";
}

/// std::map<std::pair<int, int> cells;
std::string about_angles(const Said &said) {
    const bool is_it = (said.words.starts_with("template argument ") && said.words.ends_with(" is invalid"))
                       || said.words == "expected '>'";
    int open = 0;
    for (const char c : said.code) open += c == '<' ? 1 : c == '>' ? -1 : 0;
    return is_it && open > 0 && without_blanks(said.code).starts_with("std::") ? close_angle : "";
}

constexpr const char *key_in_braces = "Brackets take one value: a key of two numbers stands in braces, grid[{1, 2}].";
constexpr const char *list_in_map =
    "What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for (const int i : grid[{1, 2}]) "
    "goes through one.";
constexpr const char *ordered_key =
    "What is sorted, or is a map's key, must have an order: numbers have one, and so has std::pair<int, int>.";
constexpr const char *not_hashed = "A std::unordered_map can't have such a key: a std::map can.";

constexpr const char *square_brackets = "The brackets of a map are square: grid[{1, 2}].";
constexpr const char *pair_as_key = "A map has one key and one value: std::map<std::pair<int, int>, std::vector<int>>.";
constexpr const char *map_of_lists =
    "push_back adds to a list, and this map has none: std::map<std::pair<int, int>, std::vector<int>>.";

/// grid(1, 2), grid({1, 2})
std::string about_map_brackets(const Said &said) {
    return calls_no_function(said) && contains(said.words, "std::map<std::pair<") ? square_brackets : "";
}

/// std::map<int, int, std::vector<int>>, std::map<{int, int}, std::vector<int>>
std::string about_three_types(const Said &said) {
    const bool opens = contains(said.code, "std::map<{int, int}") || contains(said.code, "std::map<(int, int)");
    if (opens && (contains(said.words, "template argument") || contains(said.words, "expected"))) return pair_as_key;
    return contains(said.words + said.code, "std::map<int, int, std::vector<") ? pair_as_key : "";
}

/// grid[{1, 2}].push_back(3), where numbers stand in the map
std::string about_numbers(const Said &said) {
    const bool no_list = contains(said.words, "which is of non-class type") || contains(said.words, "not a structure");
    return no_list && contains(said.words, "::mapped_type") && contains(said.code, "].push_back(") ? map_of_lists : "";
}

/// grid[1][2], grid[v], grid[1, 2]
std::string about_key(const Said &said) {
    const bool no_operator =
        contains_any(said.words, {"for 'operator[]'", "overloaded operator[]", "operator[] for type"});
    const bool of_map = no_operator && contains(said.words, "std::map<std::pair<");
    return of_map || contains(said.words, "comma expression in array subscript") ? key_in_braces : "";
}

/// grid[{1, 2}] = 3, grid.push_back(3), for (int i : grid)
std::string about_list(const Said &said) {
    const bool in_words = contains(said.words, "std::map<") && contains(said.words, "vector<")
                          && (contains(said.words, "mapped_type") || contains(said.words, "'push_back'"));
    const bool element = contains(said.words, "'std::pair<const ") && contains(said.words, "vector<");
    const bool assigned = contains(said.words, "no viable overloaded '='") && contains(said.notes, "vector<")
                          && contains(said.code, "] =");
    return in_words || element || assigned ? list_in_map : "";
}

/// std::map<Pair, int>: the compiler stands in the library, which compares two keys.
std::string about_map_order(const Said &said) {
    const bool compares = contains(said.words, "no match for 'operator<'")
                          || contains(said.words, "invalid operands to binary expression");
    const bool vectors = contains(said.words, "Vec2'"); // of which advice_on_types knows more
    return compares && !vectors && said.code.empty() ? ordered_key : "";
}

std::string about_hash(const Said &said) {
    return contains(said.words, "unordered_map<") && contains(said.words, "deleted") ? not_hashed : "";
}

} // namespace

std::string advice_on_lists(const Said &said) {
    return first_of({about_map_brackets, about_three_types, about_numbers, about_key, about_list, about_map_order,
                     about_hash, about_loop, about_list_member, about_list_brackets, about_angles},
                    said);
}

} // namespace course
