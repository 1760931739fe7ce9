#pragma once
#include "base/renamed.hpp"
#include "base/section.hpp"
#include "check/exercise.hpp"

#include <string>
#include <vector>

namespace course {

/// What must be known of a section to say what's wrong in an answer to it.
struct SectionFacts {
    Section section;
    std::vector<Exercise> exercises;
    std::string header, stub;     ///< the texts of its header, and of the file that a student begins with
    std::vector<Renamed> renamed; ///< old names
};

} // namespace course
