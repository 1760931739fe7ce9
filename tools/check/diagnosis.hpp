#pragma once
// What a compiler and a linker print, as one thing to fix.

#include "base/renamed.hpp"
#include "check/reader.hpp"
#include "judge/protocol/verdict.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The first error, with its line of code; how many more there are. If it is about an old name, the new names of all the
/// old ones that errors are about.
/// @param errors  what the compiler printed
/// @param file, shown_name  the student's file, as the compiler was given it, and how to call it
/// @param text     of the file, for a line that the compiler speaks of and does not show
/// @param renamed  old names of the section
Verdict diagnose_compiler(std::string_view errors, const std::string &file, const std::string &shown_name,
                          std::string_view text = {}, const std::vector<Renamed> &renamed = {});

/// A line of code with the number before it, as GCC shows it.
std::string numbered(int line, std::string_view code);

/// The sentence about a file that a compiler could not open. Whether it isn't there or is closed to a check, nobody is
/// told; nor the name, of which the compiler's words depend on that.
std::string explain_unopened();

/// Warnings, one line each, without those that only explain another.
std::vector<std::string> find_warnings(std::string_view printed, const std::string &file,
                                       const std::string &shown_name);

/// An own `main`, a helper that is declared and never defined, something defined twice.
Verdict diagnose_linker(std::string_view errors, const std::string &shown_name, const std::string &number,
                        Reader reader = Reader::terminal);

/// The first error of a compiler or linker in what a build printed, shortened to one line; "" if there is none.
std::string first_error(const std::string &printed);

/// What helps if a file lacks a function, to be added to that sentence: how the header declares it, and what
/// the file has instead: a function of that name with other parameters or in another namespace, one by an old name, or
/// one misspelt.
/// @param symbols  what `nm -C --defined-only` printed of the student's object
/// @param header   the text of the section's header
/// @param renamed  old names of the section
std::string explain_missing(std::string_view symbols, const std::string &header, const std::string &function,
                            const std::vector<Renamed> &renamed = {});

} // namespace course
