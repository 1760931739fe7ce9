#pragma once
#include <string>

namespace course {

/// One section: `07_segment_intersection`.
struct Section {
    std::string name; ///< "07_segment_intersection"

    int number() const { return std::stoi(name.substr(0, 2)); }
    std::string slug() const { return name.substr(3); }                   ///< "segment_intersection"
    std::string short_number() const { return std::to_string(number()); } ///< "7"
};

} // namespace course
