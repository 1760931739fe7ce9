#pragma once
// A figure: a gnuplot script, the trace that it draws, and perhaps a student's trace over it. And from gnuplot's SVG to a
// published one: two colour schemes, a title, and nothing that differs from run to run.

#include "base/errors.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace course {

struct Figure {
    std::filesystem::path script;  ///< plots/NN_slug_<figure>.gp
    std::filesystem::path trace;   ///< the reference's
    std::filesystem::path student; ///< the student's; empty: none

    std::string name() const { return script.stem().string(); }
    bool is_measured() const { return name().find("_measured_") != std::string::npos; } ///< no program writes its trace
};

/// What a figure shows, as the script says in the line "#> Figure: ...".
/// @throws UserError if there is no such line
std::string figure_title(const std::filesystem::path &script);

/// Whether the script draws a student's trace, ARG3, when it is given one.
bool draws_student(const std::filesystem::path &script);

/// Draws with gnuplot. The SVG is the same on every run, and follows the reader's colour scheme.
/// @throws TraceFault for a trace; FigureFault for a blank curve, a column that isn't there, or any word from gnuplot;
///         UserError if gnuplot is missing
std::string draw(const Figure &figure);

/// A figure that cannot be drawn although the traces are sound.
struct FigureFault : UserError {
    using UserError::UserError;
};

/// The colours of plots/style.gp, as "#rrggbb".
struct Colours {
    std::string ink;                         ///< what gnuplot draws in black if a script names no colour
    std::map<std::string, std::string> dark; ///< for each colour the twin for dark pages
};

/// Reads the lines of style.gp that name a colour and, behind "dark:", the twin.
/// @throws UserError naming the line of a colour that has none, or if INK is missing
Colours read_colours(std::string_view style);

/// The figure with `title` for those who cannot see it, and with a style sheet inside that follows the reader's colour
/// scheme. The colours of a light page stay in the elements, so a viewer without style sheets shows a light figure.
/// @throws FigureFault naming a colour that the style doesn't know: on a dark page it might be invisible
std::string recoloured(std::string_view svg, const std::string &title, const Colours &colours, const std::string &name);

} // namespace course
