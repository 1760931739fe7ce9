#pragma once
// A still picture of a demo, for forges, paper and browsers without JavaScript.

#include "figures/recolour.hpp"

#include <string>
#include <string_view>

namespace course {

/// An SVG of what a demo shows, 640 px wide and in the colours of figures, without its handles: nothing can be dragged.
/// @param printed  what the demo's own program writes with --picture: two rows, what it is about and what is seen
/// @param name     of the demo, for a complaint
/// @throws FigureFault if `printed` is something else, or draws in a colour that no figure has.
std::string demo_picture(const std::string &printed, const Colours &colours, const std::string &name);

/// Whether two such pictures show the same. On another machine a sine may differ in its last bit, and so a number here
/// by the last of its digits.
bool show_the_same(std::string_view one, std::string_view other);

} // namespace course
