#include "judge/protocol/signature.hpp"

#include "base/hash.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace course {
namespace {

/// A text with numbers of six digits: what's within 1e-9 of 0 is 0, without a minus.
std::string rounded(const std::string &text) {
    std::string result;
    for (const char *at = text.c_str(); *at != '\0';) {
        char *end = nullptr;
        const bool begins = (std::isdigit(static_cast<unsigned char>(*at)) || *at == '-')
                            && (result.empty() || !std::isalnum(static_cast<unsigned char>(result.back())));
        const double number = begins ? std::strtod(at, &end) : 0;
        if (!begins || end == at) {
            result += *at++;
            continue;
        }
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), "%.6g", std::abs(number) < 1e-9 ? 0 : number);
        result += digits.data();
        at = end;
    }
    return result;
}

} // namespace

std::string seen_by(const Verdict &verdict) {
    std::string text = verdict.test + '\n' + std::string{name_of(verdict.kind)} + '\n' + verdict.label + '\n'
                       + rounded(verdict.yours) + '\n' + (verdict.call ? rounded(verdict.call->answer) : "") + '\n';
    if (verdict.yours.empty() && verdict.accepted.empty()) text += verdict.sentence + '\n';
    for (const std::string &input : verdict.accepted) text += input + '\n';
    return text;
}

std::string signature(const std::vector<Verdict> &failed) {
    std::vector<std::string> seen;
    for (const Verdict &verdict : failed) seen.push_back(seen_by(verdict));
    std::ranges::sort(seen);
    std::string text;
    for (const std::string &each : seen) text += each + '\f';
    return fnv1a(text);
}

} // namespace course
