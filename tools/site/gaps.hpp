#pragma once
#include <map>
#include <string>

namespace course {

/// A template of docs/ with each {{gap}} filled in.
/// @param file  its name, for a complaint
/// @throws Complaint about a gap that nothing fills.
std::string filled(std::string text, const std::map<std::string, std::string> &gaps, const std::string &file);

} // namespace course
