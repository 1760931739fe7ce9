#pragma once
// The figures of a section, and what is published of them in plots/.

#include "base/workspace.hpp"
#include "figures/figure.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace course {

/// Every plots/NN_slug_<figure>.gp of the section with the reference's trace, by name. The trace of a
/// plots/NN_slug_measured_<figure>.gp is the kept one beside it.
std::vector<Figure> figures_of(const Workspace &workspace, const Section &section);

/// Where the build draws a figure.
std::filesystem::path drawn(const Workspace &workspace, const Figure &figure);

/// Brings the section's figures up to date: program, traces, SVGs.
/// @throws UserError with the first thing that went wrong
void draw_figures(const Workspace &workspace, const Section &section);

/// Copies the drawn figures to plots/*.svg and the rounded traces to plots/*.tsv. A kept trace that is still true
/// within the tolerance is left as it is, so that another machine's last digits change nothing.
/// @return the files that changed
std::vector<std::filesystem::path> publish(const Workspace &workspace, const Section &section);

/// What of the section's published figures is missing, or no longer true, one sentence each.
std::vector<std::string> outdated(const Workspace &workspace, const Section &section);

/// Files in plots/ that belong to no section or to no script, one sentence each.
std::vector<std::string> strays(const Workspace &workspace);

} // namespace course
