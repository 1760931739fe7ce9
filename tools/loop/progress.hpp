#pragma once
#include "ground/tree.hpp"
#include "loop/catalogue.hpp"

#include <optional>
#include <string>
#include <vector>

namespace course {

/// An exercise, and how it stands as far as is remembered.
struct Standing {
    Exercise exercise;
    std::string state; ///< the last verdict; "not started" in an untouched file; "not checked" if there was no verdict
};

/// How far a student is in a section. Nothing is run for it.
struct Progress {
    std::vector<Standing> standings;
    bool there = true;    ///< whether the student's file is there
    bool changed = false; ///< whether it has changed since the last check

    int passed() const;
    bool finished() const { return passed() == static_cast<int>(standings.size()); }
};

/// @throws Complaint if the section is not built yet.
Progress progress(const Tree &tree, const Section &section);

/// The first section that is not finished; none if all are.
std::optional<Section> first_unfinished(const Tree &tree);

} // namespace course
