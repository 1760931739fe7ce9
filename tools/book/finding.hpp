#pragma once
#include <compare>
#include <filesystem>
#include <string>

namespace course {

/// What has to be fixed at a place of the book or its code, and how: one sentence.
struct Finding {
    std::filesystem::path file;
    int line = 0; ///< from 1
    std::string message;

    friend auto operator<=>(const Finding &, const Finding &) = default;
};

} // namespace course
