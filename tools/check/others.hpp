#pragma once
// Right answers to an exercise that are written in another way than our solution is.
#include "base/workspace.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace course {

struct OtherAnswer {
    std::string claim; ///< what is special about it: "gravity component by component: x and y on their own"
    std::string code;  ///< what belongs to this exercise alone
};

/// The first three of tests/NN_slug/variants.diff; none in an edition without them.
std::vector<OtherAnswer> other_answers(const Workspace &workspace, const Section &section, std::string_view number);

/// "Three other ways to write it"
std::string words_for_others(std::size_t count);

} // namespace course
