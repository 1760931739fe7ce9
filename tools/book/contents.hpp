#pragma once
// Where a section is listed: a line in CMakeLists.txt, and a row in the contents of book.md.

#include "base/workspace.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A row of book.md's contents: `| 7 | [Walls](chapters/07_walls/README.md) | what it is about | 90 + 150 | 1 |`.
struct Entry {
    int line = 0; ///< from 1
    int number = 0;
    std::string title;
    std::string chapter; ///< what the title links to; "" for a section to come
    std::string about;   ///< "what it is about"; "" if there is no such column
    std::string minutes; ///< "" if there is no such column
    std::string needs;   ///< "1, 7 for 11.8", see prerequisites.hpp; "" if there is no such column
    std::size_t columns = 0;
};

/// The rows of the first table with a row that begins with a number.
std::vector<Entry> contents(std::string_view book);

/// "75 + 155": how many minutes a chapter takes by the table of exercises, to the nearest five, for the core exercises and for the others;
/// without a core exercise, for the reading and for the doing. "" without such a table.
std::string minutes_cell(std::string_view chapter);

/// The title under which book.md has a section of that number to come: "Collisions" in `| 8 | Collisions | *to come* |`;
/// "" if it has none.
std::string title_to_come(std::string_view book, int number);

/// book.md with a row for the section in the contents, in the place of one to come if that is there.
/// @throws UserError if there are no contents.
std::string with_entry(const std::string &book, const Section &section, const std::string &title);

/// CMakeLists.txt with the line section(NN_slug), in the order of the numbers.
/// @throws UserError if it has no such line yet, so that there is no place for it.
std::string with_section(const std::string &cmake_lists, const Section &section);

} // namespace course
