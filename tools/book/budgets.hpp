#pragma once
// What keeps a chapter readable, as numbers that can be checked: how soon the reader does something, how much is read
// between two things to do, how much code is in the way. What is folded away counts for none of them.

#include "book/finding.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A limit that every chapter keeps, or says why not.
struct Budget {
    std::string name;   ///< "longest listing"
    std::string what;   ///< what is counted, for a message: "lines of the longest unfolded listing"
    int limit = 0;      ///< the chapter may have this many
    int value = 0;      ///< it has this many
    int line = 1;       ///< where that is seen
    std::string remedy; ///< what to do about it
};

/// The budgets of a chapter with what it spends.
std::vector<Budget> budgets_of(std::string_view chapter);

/// Budgets that the chapter exceeds without saying why. An exception stands anywhere in it as
/// `<!-- budget: longest listing 22, since it is one table of constants -->`: the budget's name, what the chapter needs,
/// and the reason. One that is no longer needed is a finding too.
std::vector<Finding> exceeded_budgets(std::string_view chapter, const std::filesystem::path &file);

} // namespace course
