#include "check/mistakes.hpp"

#include "base/text.hpp"
#include "check/scanner.hpp"
#include "judge/protocol/signature.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

namespace course {
namespace {

/// The numbers in a text, as they are written.
std::set<std::string> numbers_in(const std::string &text) {
    std::set<std::string> numbers;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_digit(text[i]) || (i > 0 && is_in_a_name(text[i - 1]))) continue;
        const std::size_t end = std::min(text.find_first_not_of("0123456789.e", i), text.size());
        numbers.insert(text.substr(i, end - i));
        i = end;
    }
    return numbers;
}

bool is_telling(const Verdict &verdict) {
    if (verdict.yours.empty() || !verdict.call) return false;
    if (contains(verdict.yours, "not a number") || contains(verdict.yours, "infinity")) return true;
    std::set<std::string> usual{"0", "1"};
    for (const std::string &argument : verdict.call->arguments) usual.merge(numbers_in(argument));
    return !std::ranges::includes(usual, numbers_in(verdict.yours));
}

/// Whether code has a float, a number like 0.5f, or a Vector2f.
bool names_float(std::string_view code) {
    const auto in_word = [](char c) { return is_in_a_name(c) || c == '.'; };
    for (std::size_t i = 0, end = 0; i < code.size(); i = end + 1) {
        for (end = i; end < code.size() && in_word(code[end]); ++end) {}
        const std::string_view word = code.substr(i, end - i);
        const bool is_number = !word.empty() && is_digit(word[0]) && !contains(word, "x");
        if (word == "float" || word.ends_with("2f") || (is_number && word.ends_with('f'))) return true;
    }
    return false;
}

} // namespace

std::string known_mistake(const std::string &table, const std::vector<Verdict> &verdicts) {
    std::vector<Verdict> failed;
    const std::string lines_of_table = '\n' + table;
    std::ranges::copy_if(verdicts, std::back_inserter(failed), [&](const Verdict &verdict) {
        const std::string line = '\n' + verdict.exercise + "\tgenerated\t" + verdict.test + '\n';
        return !verdict.passed() && !contains(lines_of_table, line);
    });
    if (failed.empty() || (failed.size() == 1 && !is_telling(failed.front()))) return {};
    const std::string head = failed.front().exercise + '\t' + signature(failed) + '\t';
    std::vector<std::string> known;
    std::istringstream lines{table};
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(head)) known.push_back(line.substr(head.size()));
    if (known.empty() || known.size() > 2) return {};
    const std::string all = known.front() + (known.size() == 2 ? ", or when " + known.back() : "");
    return all + (all.ends_with('?') ? "" : ".");
}

std::string lost_digits(const std::string &text, const std::vector<Verdict> &verdicts) {
    const auto failed = std::ranges::count_if(verdicts, std::not_fn(&Verdict::passed));
    double most = 0;
    for (const Verdict &verdict : verdicts)
        if (!verdict.passed()) most = std::max(most, verdict.accepted.empty() ? verdict.off : 1);
    constexpr double seven = 1e-9, six = 2e-6;
    if (most < seven || most > six || (failed == 1 && verdicts.size() > 1)) return {};
    if (names_float(Source{text}.code))
        return "All your numbers are right to about seven digits: is there a float somewhere? Write double.";
    return "Only the last digits are lost: is a constant like pi cut short, does a search stop early, or is an "
           "acos near 1?";
}

} // namespace course
