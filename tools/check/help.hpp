#pragma once
// From what a compiler, a linker and tests have said of a student's file to what the student reads: from texts alone, so
// that a terminal and a page say the same.

#include "check/reader.hpp"
#include "check/section_facts.hpp"
#include "judge/protocol/verdict.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// What keeps a file from being given to a compiler at all.
/// @param all  sections that there are
std::optional<Verdict> trouble_in(std::string_view text, const std::string &shown_name, const Section &section,
                                  const std::vector<Section> &all, Reader reader);

/// Why a file doesn't compile.
/// @param printed  by the compiler, made plain
/// @param file     as the compiler was given it
Verdict why_not_compiled(std::string_view printed, const std::string &file, const std::string &shown_name,
                         std::string_view text, const SectionFacts &facts);

/// What no compiler warns of in a file that compiles.
std::vector<std::string> warnings_in(std::string_view text, const std::string &shown_name);

/// For functions that are missing: how the header declares them, and what is there instead.
/// @param symbols  what `nm -C --defined-only` printed of the student's object
void help_the_missing(std::vector<Verdict> &verdicts, std::string_view symbols, const SectionFacts &facts);

/// For input that was accepted, although lines that came with the function refused it.
void help_the_accepting(std::vector<Verdict> &verdicts, std::string_view text, std::string_view stub);

} // namespace course
