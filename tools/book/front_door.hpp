#pragma once
// The way from README to the book that's published.

#include <string>

namespace course {

/// README whose first line and first picture lead to this address; to none if it's empty.
std::string with_front_door(std::string readme, const std::string &address);

} // namespace course
