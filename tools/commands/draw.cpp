#include "base/files.hpp"
#include "commands/commands.hpp"
#include "figures/figure.hpp"

namespace course {
namespace {

constexpr const char *about_draw = R"(
For the build: it draws each figure of the course with this.
The trace is checked first. A curve without a point inside the axes, a column that isn't there,
and any word of gnuplot's are errors. The SVG follows its reader's colour scheme, and is the same
on every run of the same gnuplot.

Example: ./course draw --script plots/07_segment_intersection_room.gp \
    --trace build/default/traces/07_segment_intersection/07_segment_intersection_room.tsv --out room.svg)";

} // namespace

void add_draw(CLI::App &app, const Workspace &) {
    const auto figure = std::make_shared<Figure>();
    const auto out = std::make_shared<std::filesystem::path>();
    CLI::App *command = app.add_subcommand("draw", "Draw one figure from its trace")->group("")->footer(about_draw);
    command->add_option("--script", figure->script, "gnuplot script in plots/")->required();
    command->add_option("--trace", figure->trace, "the reference's trace")->required();
    command->add_option("--mine", figure->student, "the student's trace, drawn over it");
    command->add_option("--out", *out, "the SVG to write")->required();
    command->callback([figure, out] { write_file(*out, draw(*figure)); });
}

} // namespace course
