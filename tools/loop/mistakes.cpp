#include "loop/mistakes.hpp"

#include "ground/text.hpp"
#include "verdict/shared/signature.hpp"

#include <algorithm>
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

} // namespace

std::filesystem::path file_of_mistakes(const Tree &tree, const Section &section) {
    return tree.root / "tests" / "mistakes" / (section.name + ".tsv");
}

std::string known_mistake(const std::string &table, const std::vector<Verdict> &verdicts) {
    std::vector<Verdict> failed;
    std::ranges::copy_if(verdicts, std::back_inserter(failed), [&](const Verdict &verdict) {
        return !verdict.passed() && !contains(table, '\n' + verdict.exercise + "\tgenerated\t" + verdict.test + '\n');
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

} // namespace course
