#pragma once
// Where a section is listed: its line in CMakeLists.txt, and its entry in the contents of book.md.

#include "ground/tree.hpp"

#include <string>

namespace course {

/// CMakeLists.txt with the line section(NN_slug), in the order of the numbers.
/// @throws Complaint if it has no such line yet, so that nobody knows where to put it.
std::string with_section(const std::string &cmake_lists, const Section &section);

/// The title under which book.md has a section of that number to come: "Collisions" in `| 8 | Collisions | *to come* |`;
/// "" if it has none.
std::string title_to_come(const std::string &book, int number);

/// book.md with the section's entry in its contents; one "to come" of that number gives way to it.
/// @throws Complaint if no contents are found.
std::string with_entry(const std::string &book, const Section &section, const std::string &title);

} // namespace course
