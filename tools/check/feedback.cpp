#include "check/feedback.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <tuple>

namespace course {
namespace {

/// Minutes from one time to another, as "3"; "break" for more than an hour; "?" if one of them is no time.
std::string minutes_between(const std::string &from, const std::string &to) {
    std::tm begin{}, end{};
    const char *const format = "%Y-%m-%dT%H:%M:%SZ";
    if (!::strptime(from.c_str(), format, &begin) || !::strptime(to.c_str(), format, &end)) return "?";
    const auto minutes = (::timegm(&end) - ::timegm(&begin) + 30) / 60;
    return minutes < 0 ? "?" : minutes > 60 ? "break" : std::to_string(minutes);
}

/// 7.10 comes after 7.9, and 13.1 after 9.2.
bool comes_before(const std::string &one, const std::string &other) {
    const auto key = [](const std::string &number) {
        const std::size_t point = std::min(number.find('.'), number.size());
        return std::tuple{point, number.substr(0, point), number.size(), number};
    };
    return key(one) < key(other);
}

std::string line(const std::string &number, const std::vector<Attempt> &attempts, int hints) {
    std::vector<std::string> gaps;
    for (std::size_t i = 1; i < attempts.size(); ++i)
        gaps.push_back(minutes_between(attempts[i - 1].when, attempts[i].when));
    return fmt::format("{:<9} {:>6}  {:<16} {:>5}  {}\n", number, attempts.size(), attempts.back().state, hints,
                       gaps.empty() ? "-" : fmt::format("{}", fmt::join(gaps, " ")));
}

/// "  2 times: you return s first.", the most frequent first.
std::string mistakes_in(const std::vector<Attempt> &attempts) {
    std::map<std::string, int> times;
    for (const Attempt &attempt : attempts)
        if (!attempt.mistake.empty()) ++times[attempt.mistake];
    std::vector<std::pair<std::string, int>> sorted{times.begin(), times.end()};
    std::ranges::stable_sort(sorted, std::greater{}, &std::pair<std::string, int>::second);
    std::string text;
    for (const auto &[mistake, count] : sorted)
        text += fmt::format("    {}: {}\n", count == 1 ? "once" : fmt::format("{} times", count), mistake);
    return text;
}

} // namespace

std::string feedback(const std::vector<Attempt> &attempts, const std::map<std::string, int> &hints,
                     const std::string &version) {
    std::map<std::string, std::vector<Attempt>, decltype(&comes_before)> by_number{&comes_before};
    for (const Attempt &attempt : attempts) by_number[attempt.number].push_back(attempt);
    std::string text = version + ": how it went, with no code, no name, and nothing of the machine.\n\n"
                       + fmt::format("{:<9} {:>6}  {:<16} {:>5}  {}\n", "exercise", "checks", "now", "hints",
                                     "minutes between the checks");
    for (const auto &[number, of_this] : by_number) {
        const auto open = hints.find(number);
        text += line(number, of_this, open == hints.end() ? 0 : open->second) + mistakes_in(of_this);
    }
    return text;
}

} // namespace course
