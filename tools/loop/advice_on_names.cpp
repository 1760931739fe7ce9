#include "loop/advice_rules.hpp"

#include "ground/text.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace course {
namespace {

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
    Standard{"array", "array"},        Standard{"set", "set"},           Standard{"map", "map"},
    Standard{"vector", "vector"},      Standard{"pair", "utility"},      Standard{"swap", "utility"},
    Standard{"max", "algorithm"},      Standard{"min", "algorithm"}};

/// Whether a function of this name is called: x(…), and not a.x() or max(…).
bool is_called(std::string_view code, const std::string &name) {
    for (std::size_t at = 0; (at = code.find(name + '(', at)) != code.npos; ++at)
        if (at == 0 || (code[at - 1] != '.' && !is_in_a_name(code[at - 1]))) return true;
    return false;
}

std::string letter_of_a_formula(const std::string &letter) {
    return "If " + letter
           + " is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; "
             "else "
             "declare it above.";
}

/// A name that the compiler does not know and has no guess at: of the standard library, of a function that is defined
/// further below or not at all, of a field, or of a variable whose braces have ended.
std::string about_unknown_name(const Said &said) {
    const bool unknown = contains(said.words, "was not declared in this scope")
                         || said.words.starts_with("no template named '")
                         || said.words.starts_with("use of undeclared identifier");
    const auto names = in_quotes(said.words);
    if (contains(said.words, "declared") && !names.empty() && names[0] == "numbers"
        && contains(said.code, "numbers::pi"))
        return write_pi;
    if (!unknown || names.empty()) return {};
    if (names[0] == "pi" || names[0] == "PI") return write_pi;
    if (names[0] == "norm" || (names[0] == "length" && is_called(said.code, "length"))) return length_of_vector;
    if (names[0] == "dot") return write_dot;
    if (is_any_of(names[0], {"elseif", "elsif", "elif"})) return "Write else if, in two words.";
    for (const auto &[name, header] : standards)
        if (names[0] == name // a list of your own may be called `numbers`
            && (names[0] != header || contains(said.code, names[0] + '<')))
            return "Write std::" + names[0] + ", and #include <" + header + "> at the top of your file.";
    if (contains(said.words, "std::")) return {};
    if (names[0] == "push_back") return "The list stands before the dot: list.push_back(a).";
    if (names[0].size() == 1 && !contains("ijk", names[0])) return letter_of_a_formula(names[0]);
    if (is_called(said.code, names[0]))
        return "If " + names[0] + " is a function of yours, put it above the one that calls it.";
    if (names[0].size() == 2 && std::isalpha(static_cast<unsigned char>(names[0][0])) != 0
        && std::isdigit(static_cast<unsigned char>(names[0][1])) != 0)
        return letter_of_a_formula(names[0]);
    const bool of_the_c_library = names.back() == "rand" || names.back() == "opterr"; // no good guess
    if (contains(said.words, "did you mean") && !of_the_c_library) return {};
    return "A field needs its struct, as in start.velocity; a variable is known below the line that declares it, "
           "inside the same braces.";
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

} // namespace

std::string advice_on_names(const Said &said) { return first_of({about_header, about_unknown_name}, said); }

} // namespace course
