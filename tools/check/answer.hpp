#pragma once
// What the text of a file that is to be judged tells alone.

#include "base/section.hpp"
#include "check/reader.hpp"
#include "judge/protocol/verdict.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// `x.hpp` of the line `#include "../y/x.hpp"`, or with < and >; nothing of any other line.
std::string_view included(std::string_view line);

/// What to say of a file that includes another section's header, and not the one of this section.
/// @param all  sections that there are
std::optional<Verdict> diagnose_section(std::string_view text, const std::string &shown_name, const Section &section,
                                        const std::vector<Section> &all, Reader reader = Reader::terminal);

/// Says what is wrong with a file before any compiler sees it: it is empty, not text, or asks which files there are.
/// @param number  of the section, for the command that brings the stub back
std::optional<Verdict> diagnose_text(std::string_view text, const std::string &shown_name, const std::string &number,
                                     Reader reader = Reader::terminal);

/// Those of these warnings that concern one exercise: all but the ones inside the functions of the others.
/// @param text    of the student's file
/// @param others  functions of the other exercises
std::vector<std::string> warnings_about(const std::vector<std::string> &warnings, std::string_view text,
                                        const std::string &shown_name, const std::vector<std::string> &others);

/// Where code follows a `throw course::NotYet` or a `return` in the same braces, and is never reached: one line each, as
/// warnings are.
std::vector<std::string> find_unreached(std::string_view text, const std::string &shown_name);

/// Where a whole number is divided by one and something is lost, 1 / 2 but not 4 / 2: one line each.
std::vector<std::string> find_whole_divisions(std::string_view text, const std::string &shown_name);

/// What helps if bad input was accepted, to be added to that sentence: the first of the lines that refused it in the
/// stub, above the `throw` of this exercise, and that the student's file has no longer. Empty if all are there.
/// @param stub  the text of the file as it was when the student got it
std::string explain_accepted(std::string_view text, std::string_view stub, const std::string &exercise);

} // namespace course
