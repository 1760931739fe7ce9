#pragma once
#include "ground/tree.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A row of the contents in book.md.
struct Entry {
    std::string number;  ///< "7"
    std::string title;   ///< "Segment intersection"
    std::string minutes; ///< "90 + 150"
    std::string page;    ///< "chapter_07_segment_intersection"; "" if it is to come
};

/// The rows of the contents, in their order: those that begin with a number.
std::vector<Entry> entries(const Tree &tree, std::string_view book);

} // namespace course
