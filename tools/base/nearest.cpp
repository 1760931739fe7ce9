#include "base/nearest.hpp"

#include "base/text.hpp"

#include <algorithm>

namespace course {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Rows of the table "the first i letters of a against the first j of b"; a swap looks two rows back.
    std::vector<std::size_t> two_back(b.size() + 1), back(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        two_back.swap(back);
        back.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({back[j] + 1, row[j - 1] + 1, back[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], two_back[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string> &candidates) {
    const std::string small = lower(word);
    std::string best;
    std::size_t least = 0;
    for (const std::string &candidate : candidates) {
        const std::size_t distance = edit_distance(small, lower(candidate));
        if (distance >= std::max(small.size(), candidate.size())) continue; // no letter in its place
        if (!best.empty() && distance >= least) continue;
        best = candidate;
        least = distance;
    }
    return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string> &candidates) {
    const std::string best = nearest(word, candidates);
    return best.empty() ? "" : " Did you mean `" + best + "`?";
}

} // namespace course
