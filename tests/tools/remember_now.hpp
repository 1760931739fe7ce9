#pragma once
// For tests of what is remembered: of the student's file as it is now.

#include "base/files.hpp"
#include "check/progress_store.hpp"

namespace course {

inline void remember(const Workspace &workspace, const Section &section, const std::vector<ExerciseState> &states) {
    const auto file = workspace.exercise(section);
    remember(workspace, section, std::filesystem::exists(file) ? read_file(file) : "", states);
}

} // namespace course
