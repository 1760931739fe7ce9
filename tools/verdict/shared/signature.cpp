#include "verdict/shared/signature.hpp"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>

namespace course {

std::string seen_by(const Verdict &verdict) {
    std::string text = verdict.test + '\n' + std::string{name_of(verdict.kind)} + '\n' + verdict.label + '\n'
                       + verdict.yours + '\n' + (verdict.call ? verdict.call->answer : "") + '\n';
    if (verdict.yours.empty() && verdict.accepted.empty()) text += verdict.sentence + '\n';
    for (const std::string &input : verdict.accepted) text += input + '\n';
    return text;
}

std::string signature(const std::vector<Verdict> &failed) {
    std::vector<std::string> seen;
    for (const Verdict &verdict : failed) seen.push_back(seen_by(verdict));
    std::ranges::sort(seen);
    std::uint64_t hash = 14695981039346656037u; // FNV-1a, the same on every machine
    for (const std::string &text : seen)
        for (const char c : text + '\f') hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016" PRIx64, hash);
    return digits.data();
}

} // namespace course
