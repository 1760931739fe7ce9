#pragma once
// What LLVM's C++ library lacks in version 19; before all else.
#include <charconv>
#include <cstdlib>
#include <string>

#if _LIBCPP_VERSION < 200000
namespace std {
inline from_chars_result from_chars(const char *first, const char *last, double &value) {
    const string text(first, last);
    char *end = nullptr;
    const double number = strtod(text.c_str(), &end);
    if (end == text.c_str()) return {first, errc::invalid_argument};
    value = number;
    return {first + (end - text.c_str()), errc{}};
}
} // namespace std
#endif
