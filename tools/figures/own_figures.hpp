#pragma once
// A section's figures with the student's curve over ours.

#include "base/workspace.hpp"
#include "check/programs.hpp"
#include "figures/figure.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// One figure that has a place for the student's curve.
struct OwnFigure {
    Figure figure;
    bool not_started = false; ///< it needs functions that are not started, and is left out
    std::string why_not;      ///< why else it could not be drawn, for the student; "" if it was, or is left out

    bool drawn() const { return !not_started && why_not.empty(); }
};

struct OwnFigures {
    Ran ran;                        ///< the student's program
    std::vector<OwnFigure> figures; ///< none if it was not started
};

/// Where a figure is drawn with the student's curve.
std::filesystem::path own_drawing(const Workspace &workspace, const Figure &figure);

/// Runs the student's program and draws what it can; older drawings are gone. The reference's traces must be there, and
/// the caller holds the Lock.
/// @throws UserError if the student's file is not there
OwnFigures draw_own_figures(const Workspace &workspace, const Section &section);

} // namespace course
