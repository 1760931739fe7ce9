#pragma once
#include "grade/graded.hpp"

#include <map>
#include <string>

namespace course {

/// What has changed since the class was last graded.
struct Change {
    std::string id, before, after; ///< grades, as points: "7.5"
    std::string because;           ///< the tests that came out otherwise, or another reason
};

/// A page for the instructor, whole in itself: what's in the way first, then the class, tests, and equal wrong answers.
/// @param names    of people, by id; who has none is shown by id
/// @param missing  who handed in nothing: ids
std::string report_page(const GradedClass &graded, const std::map<std::string, std::string> &names,
                        const std::vector<std::string> &missing, const std::vector<Change> &changes);

} // namespace course
