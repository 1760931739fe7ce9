#pragma once
// What a compiler and a linker print, as one thing to mend.

#include "verdict/verdict.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// Says what is wrong with a file before any compiler sees it: nothing in it, or no text.
/// @param number  of the section, for the way back
std::optional<Verdict> diagnose_text(std::string_view text, const std::string &shown_name, const std::string &number);

/// The first error, with its line of code; how many more there are.
/// @param errors  what the compiler printed
/// @param file, shown_name  the student's file, and how to call it
Verdict diagnose_compiler(std::string_view errors, const std::filesystem::path &file, const std::string &shown_name);

/// Warnings, one line each, without those that only explain another.
std::vector<std::string> find_warnings(std::string_view printed, const std::filesystem::path &file,
                                       const std::string &shown_name);

/// An own `main`, a helper that is declared and never defined, something defined twice.
Verdict diagnose_linker(std::string_view errors, const std::string &shown_name, const std::string &number);

/// `Vec2` for what a compiler calls it: Eigen::Matrix<double, 2, 1, 0, 2, 1>.
std::string with_short_names(std::string text);

/// Functions of the wanted name that the object does have, with their parameters: "segment_intersection::meet(double)".
/// @param symbols  what `nm -C --defined-only` printed
std::vector<std::string> find_namesakes(std::string_view symbols, std::string_view function);

} // namespace course
