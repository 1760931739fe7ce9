#include "ground/lines.hpp"
#include "ground/text.hpp"
#include "loop/diagnosis.hpp"
#include "loop/said.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace course {
namespace {

/// Code with blanks for all that is in comments and quotes. Its lines stay.
std::string code_of(std::string code) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> hides{
        {{"//", "\n"}, {"/*", "*/"}, {"\"", "\""}}};
    replace_all(code, "\\\"", "  ");
    for (std::size_t at = 0; at < code.size(); ++at)
        for (const auto &[begin, end] : hides) {
            if (!std::string_view{code}.substr(at).starts_with(begin)) continue;
            const std::size_t behind =
                std::min(code.find(end, at + begin.size()), code.size() - end.size()) + end.size();
            std::replace_if(
                code.begin() + long(at), code.begin() + long(behind), [](char c) { return c != '\n'; }, ' ');
            at = behind - 1;
            break;
        }
    return code;
}

/// Whether a number may begin behind this as the first of a product: not behind 0.5 *, where all is double already, not
/// in "x1", "2.1", "1e-3", and not in the brackets of a size.
bool begins_a_product(std::string_view before) {
    if (before.empty()) return true;
    if (is_in_a_name(before.back()) || contains(".'", before.substr(before.size() - 1))) return false;
    const std::size_t end = before.size();
    const bool exponent = end > 2 && contains("+-", before.substr(end - 1)) && contains("eE", before.substr(end - 2, 1))
                          && contains("0123456789.", before.substr(end - 3, 1));
    before = without_blanks_behind(before);
    return !exponent && (before.empty() || !contains("*/%[", before.substr(before.size() - 1)));
}

} // namespace

std::vector<std::string> find_whole_divisions(std::string_view text, const std::string &name) {
    constexpr const char *digits = "0123456789";
    std::vector<std::string> found;
    const std::string all = code_of(std::string{text});
    int number = 0;
    for (const auto &[line, end] : lines_of(all)) {
        ++number;
        for (std::size_t slash = 0; (slash = line.find('/', slash)) != line.npos; ++slash) {
            const std::string_view left = without_blanks_behind(line.substr(0, slash)),
                                   right = without_blanks(line.substr(slash + 1));
            const std::size_t begins = left.find_last_not_of(digits) + 1,
                              ends = std::min(right.find_first_not_of(digits), right.size());
            const std::string over{left.substr(begins)}, under{right.substr(0, ends)};
            const auto a = leading_number(over), b = leading_number(under);
            const bool is_whole =
                ends == right.size() || (!is_in_a_name(right[ends]) && !contains(".'", {&right[ends], 1}));
            if (!a || !b || *b == 0 || *a % *b == 0 || !is_whole || !begins_a_product(left.substr(0, begins))) continue;
            found.push_back(name + ':' + std::to_string(number) + ": `" + over + " / " + under + "` is "
                            + std::to_string(*a / *b) + ", because both are whole numbers: write `" + over + ".0 / "
                            + under + '`');
        }
    }
    return found;
}

} // namespace course
