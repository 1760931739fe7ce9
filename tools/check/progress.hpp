#pragma once
#include "base/workspace.hpp"
#include "check/catalogue.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace course {

/// How far a student is in a section. Nothing is run for it.
struct Progress {
    std::vector<Standing> standings;
    bool there = true;    ///< whether the student's file is there
    bool changed = false; ///< whether it has changed since the last check
    std::string judged;   ///< when one of them was last judged, as UTC; "" if never, or the file is as it was given

    std::ptrdiff_t passed() const { return std::ranges::count(standings, "passed", &Standing::state); }
    bool finished() const { return next() == nullptr; }
    /// The exercise to go on with: the first that is not passed, or the one it needs; none if all are passed.
    const Standing *next() const;
};

/// @throws UserError if the section is not built yet.
Progress progress(const Workspace &workspace, const Section &section);

/// The section to go on with: of those with something left to do, the one judged last, or else the first; none if all
/// are done. `list`, the pages, and `check` and `hint` without a section go by it.
std::optional<Section> section_to_go_on_with(const Workspace &workspace);

} // namespace course
