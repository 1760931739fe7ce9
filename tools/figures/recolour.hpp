#pragma once
// From gnuplot's SVG to a published one: two colour schemes, a title, and nothing that differs from run to run.

#include "ground/complaint.hpp"

#include <map>
#include <string>
#include <string_view>

namespace course {

/// A figure that cannot be drawn although its traces are sound.
struct FigureFault : Complaint {
    using Complaint::Complaint;
};

/// The colours of plots/style.gp, as "#rrggbb".
struct Colours {
    std::string ink;                         ///< what gnuplot draws in black if a script names no colour
    std::map<std::string, std::string> dark; ///< for each colour its twin for dark pages
};

/// Reads the lines of style.gp that name a colour and, behind "dark:", its twin.
/// @throws Complaint naming the line of a colour that has none, or if INK is missing
Colours read_colours(std::string_view style);

/// The figure with `title` for those who cannot see it, and with a style sheet inside that follows the reader's colour
/// scheme. The colours of a light page stay in the elements, so a viewer without style sheets shows a light figure.
/// @throws FigureFault naming a colour that the style doesn't know: on a dark page it might be invisible
std::string recoloured(std::string_view svg, const std::string &title, const Colours &colours, const std::string &name);

} // namespace course
