#pragma once
// One file to send to a friend: a demo on the student's functions, in a page that needs nothing else.

#include "book/demo_places.hpp"
#include "ground/tree.hpp"

#include <string>

namespace course {

/// The page: the section's demo as it starts at this place, ours and the student's, both compiled before.
/// The site must be there.
std::string shared_page(const Tree &tree, const Section &section, const DemoMark &mark);

} // namespace course
