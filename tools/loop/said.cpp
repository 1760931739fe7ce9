#include "loop/said.hpp"

#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>

namespace course {
namespace {

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

/// The first "std::allocator<std::optional<int> >" of a type is one of 'std::optional<int>'.
std::string element_of_allocator(std::string_view type) {
    constexpr std::string_view name = "std::allocator<";
    const std::size_t at = type.find(name);
    if (at == type.npos) return {};
    const std::size_t begin = at + name.size(), end = end_of_type(type, at) - 1; // its own >
    return std::string{without_blanks_behind(type.substr(begin, end - begin))};
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
    for (const char *negative :
         {"const Eigen::DenseBase<Vec2>::NegativeReturnType", "Eigen::DenseBase<Vec2>::NegativeReturnType"})
        replace_all(text, negative, "expression of Vec2s");
    for (std::size_t at; (at = text.find("__gnu_cxx::__alloc_traits<")) != text.npos;) { // an element of a list
        constexpr std::string_view kind = "::value_type";
        const std::size_t end = end_of_type(text, at);
        const std::string type = element_of_allocator(std::string_view{text}.substr(at, end - at));
        if (type.empty() || !std::string_view{text}.substr(end).starts_with(kind)) break;
        text.replace(at, end + kind.size() - at, type);
    }
    for (const char *computed :
         {"Eigen::MatrixBase<expression of Vec2s >::PlainObject", "Eigen::MatrixBase<expression of Vec2s>::PlainObject",
          "Eigen::MatrixBase<Vec2>::PlainObject"})
        replace_all(text, computed, "Vec2"); // what normalized() returns
    return text;
}

std::vector<std::string> in_quotes(std::string_view words) {
    std::vector<std::string> found;
    while (const auto next = between(words, "'", "'")) {
        found.emplace_back(*next);
        words.remove_prefix(static_cast<std::size_t>(next->data() + next->size() + 1 - words.data()));
    }
    return found;
}

bool is_number(std::string_view type) {
    if (type.starts_with("const ")) type.remove_prefix(6);
    return type == "double" || type == "int" || type == "float" || type == "long" || type == "long int";
}

bool is_vector(std::string_view type) { return type.ends_with("Vec2") || type.ends_with("expression of Vec2s"); }

std::string struct_name(std::string_view type) {
    for (const char *word : {"const ", "struct "})
        if (type.starts_with(word)) type.remove_prefix(std::string_view{word}.size());
    if (type.ends_with('&')) type.remove_suffix(1);
    if (const std::size_t colon = type.rfind(':'); colon != type.npos) type.remove_prefix(colon + 1);
    const bool is_name = std::ranges::all_of(type, is_in_a_name);
    if (!is_name || type.empty() || type[0] < 'A' || type[0] > 'Z' || type == "Vec2") return {};
    return std::string{type};
}

std::size_t where_it_closes(std::string_view code, std::size_t from) {
    int open = 0;
    for (std::size_t i = from; i < code.size(); ++i) {
        if (contains("([{", {&code[i], 1})) ++open;
        if (contains(")]}", {&code[i], 1}) && --open == 0) return i;
    }
    return code.npos;
}

bool has_comma(std::string_view code) {
    if (code.starts_with('(') && code.ends_with(')')) code = code.substr(1, code.size() - 2);
    int open = 0;
    for (const char c : code) {
        if (contains("([{<", {&c, 1})) ++open;
        if (contains(")]}>", {&c, 1})) --open;
        if (c == ',' && open == 0) return true;
    }
    return false;
}

std::string_view code_alone(std::string_view line) { return without_blanks(line.substr(0, line.find("//"))); }

std::pair<std::string, std::string> missing_member(const Said &said) {
    const auto names = in_quotes(said.words);
    if (names.size() < 2) return {};
    if (contains(said.words, "has no member named '")) return {names[0], names[1]}; // GCC
    if (said.words.starts_with("no member named '")) return {names[1], names[0]};   // Clang
    return {};
}

std::string_view first_word(std::string_view code) {
    const auto end = std::ranges::find_if_not(code, is_in_a_name);
    return code.substr(0, static_cast<std::size_t>(end - code.begin()));
}

} // namespace course
