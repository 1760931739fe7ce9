#pragma once
#include <filesystem>
#include <string>
#include <tuple>

namespace course {

/// What has to be fixed at a place of the book or its code, and how: one sentence.
struct Finding {
    std::filesystem::path file;
    int line = 0; ///< from 1
    std::string message;

    friend bool operator<(const Finding &a, const Finding &b) {
        return std::tie(a.file, a.line, a.message) < std::tie(b.file, b.line, b.message);
    }
};

} // namespace course
