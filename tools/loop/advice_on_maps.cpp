#include "loop/advice_rules.hpp"

#include "ground/text.hpp"

namespace course {
namespace {

constexpr const char *key_in_braces = "Brackets take one value: a key of two numbers stands in braces, grid[{1, 2}].";
constexpr const char *list_in_map =
    "What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for (const int i : grid[{1, 2}]) "
    "goes through one.";
constexpr const char *ordered_key =
    "What is sorted, or is a map's key, must have an order: numbers have one, and so has std::pair<int, int>.";
constexpr const char *not_hashed = "A std::unordered_map cannot have such a key: a std::map can.";

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

std::string advice_on_maps(const Said &said) {
    return first_of(
        {about_map_brackets, about_three_types, about_numbers, about_key, about_list, about_map_order, about_hash},
        said);
}

} // namespace course
