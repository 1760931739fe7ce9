#pragma once
// What compilers print, taken apart.

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// An error or a warning: "/long/path/07_x.cpp:12:5: error: 'a' was not declared", and the lines that belong to it.
struct Diagnostic {
    std::string words; ///< with plain quotes and short names
    std::string code;  ///< the line that it is about; empty if that is in another file than the student's
    std::string caret; ///< the line below, whose ^ is where the compiler stood
    std::string notes; ///< what follows, to the next error or warning, with plain quotes
    bool is_error = false;
    std::string file = {}; ///< where it was printed to be, and its line
    int line = 0;
    int column = 0; ///< [bytes] from 1; 0 where none was printed, or it is one of another file
};

/// All errors and warnings, in order. One that is made in a file which the student only uses is moved to where the
/// student's file causes it.
std::vector<Diagnostic> diagnostics_in(std::string_view printed, const std::string &file);

/// `Vec2` for what a compiler calls it, Eigen::Matrix<double, 2, 1, 0, 2, 1>, and "expression of Vec2s" for the types that the
/// library computes with; without what they are "also known as".
std::string with_short_names(std::string text);

} // namespace course
