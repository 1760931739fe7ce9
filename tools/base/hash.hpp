#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// FNV-1a as 16 digits, the same on every machine: it keeps no secret, and only shows that something has changed.
inline std::string fnv1a(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    std::string digits(16, '0');
    for (std::size_t i = digits.size(); i-- > 0; hash >>= 4) digits[i] = "0123456789abcdef"[hash & 15];
    return digits;
}

/// SHA-256 of each file, 64 digits, by sha256sum.
/// @throws UserError if one can't be read
std::vector<std::string> sha256_of(const std::vector<std::filesystem::path> &files);

/// The same of a text.
std::string sha256(std::string_view text);

} // namespace course
