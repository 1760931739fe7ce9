#pragma once
#include "ground/tree.hpp"
#include "loop/catalogue.hpp"

#include <algorithm>
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

    std::ptrdiff_t passed() const { return std::ranges::count(standings, "passed", &Standing::state); }
    std::vector<Standing>::const_iterator first_open() const { ///< the first that is not passed, or the end
        return std::ranges::find_if(standings, [](const Standing &s) { return s.state != "passed"; });
    }
    bool finished() const { return first_open() == standings.end(); }
};

/// @throws Complaint if the section is not built yet.
Progress progress(const Tree &tree, const Section &section);

/// The first section that is not finished; none if all are.
std::optional<Section> first_unfinished(const Tree &tree);

} // namespace course
