#pragma once
// A figure: a gnuplot script, the trace that it draws, and perhaps a student's trace over it.

#include "figures/recolour.hpp"

#include <filesystem>
#include <string>

namespace course {

struct Figure {
    std::filesystem::path script;  ///< plots/NN_slug_<figure>.gp
    std::filesystem::path trace;   ///< the reference's
    std::filesystem::path student; ///< the student's; empty: none

    std::string name() const { return script.stem().string(); }
    bool is_measured() const { return trace.parent_path() == script.parent_path(); } ///< no program writes its trace
};

/// What a figure shows, as its script says it in the line "#> Figure: ...".
/// @throws Complaint if there is no such line
std::string figure_title(const std::filesystem::path &script);

/// Whether the script draws a student's trace, ARG3, when it is given one.
bool draws_student(const std::filesystem::path &script);

/// Draws with gnuplot. The SVG is the same on every run, and follows the reader's colour scheme.
/// @throws TraceFault for a trace; FigureFault for a blank curve, a column that isn't there, or any word from gnuplot;
///         Complaint if gnuplot is missing
std::string draw(const Figure &figure);

} // namespace course
