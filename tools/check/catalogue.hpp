#pragma once
#include "base/workspace.hpp"
#include "check/section_facts.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Whether there is a catalogue: a section that has just come with an update is not built yet.
bool is_built(const Workspace &workspace, const Section &section);

/// The exercises of a section, in order: what the tests printed when they were built.
/// @throws UserError if the section is not built yet.
std::vector<Exercise> catalogue(const Workspace &workspace, const Section &section);

/// Every test of a section, in the order of their file: known before any of them runs.
/// @throws UserError if the section is not built yet.
std::vector<KnownTest> tests_of(const Workspace &workspace, const Section &section);

/// The names that a section had before; none if it has no list of them.
std::vector<Renamed> renamed(const Workspace &workspace, const Section &section);

/// @throws UserError if the section is not built yet.
SectionFacts facts_of(const Workspace &workspace, const Section &section);

/// Whether these words can only mean an exercise: "7.2".
bool is_number_of_exercise(std::string_view words);

/// The exercise meant by "7.2" or by a function's name.
/// @throws UserError offering the nearest one.
struct FoundExercise {
    Section section;
    Exercise exercise;
};
FoundExercise find_exercise(const Workspace &workspace, std::string_view words);

} // namespace course
