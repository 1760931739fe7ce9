#pragma once
// A file that is to be judged, before a compiler sees it.

#include "ground/tree.hpp"
#include "verdict/shared/verdict.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace course {

/// All of a file with answers: a regular file of at most 1 MB, whatever its name.
/// @throws Complaint saying what it is, if it is anything else: nothing waits for a pipe, or reads a device to its end.
std::string read_answer(const std::filesystem::path &file);

/// What to say of a file that includes another section's header, and not the one of this section.
std::optional<Verdict> diagnose_section(std::string_view text, const std::string &shown_name, const Tree &tree,
                                        const Section &section);

} // namespace course
