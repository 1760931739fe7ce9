// `course plot`: a section's figures, from the reference's traces or with the student's curve over them.

#include "base/lock.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "figures/own_figures.hpp"
#include "figures/section_figures.hpp"

#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char *about_plot = R"(
The figures lie in the build folder as SVG; any browser shows them. With --mine your program is
built and run, for at most 10 s, and its curves are drawn over ours; a figure that needs functions
which you have not started is left out. Without a section all figures are drawn.

Example: ./course plot 7 --mine)";

void print_drawn(const Workspace &workspace, const fs::path &svg, const Figure &figure) {
    std::cout << workspace.relative_name(svg) << "  " << figure_title(figure.script) << '\n';
}

/// @return whether each figure could be drawn, or one at least and the others need functions that are not started
bool plot_mine(const Workspace &workspace, const Section &section) {
    const auto [ran, figures] = draw_own_figures(workspace, section);
    bool all = ran.started, any = false;
    std::string left_out; // the names of figures that need functions which are not started
    for (const OwnFigure &own : figures) {
        const auto &[figure, not_started, why_not] = own;
        any = any || own.drawn();
        all = all && why_not.empty();
        if (not_started) left_out += (left_out.empty() ? "" : ", ") + figure.name();
        else if (own.drawn()) print_drawn(workspace, own_drawing(workspace, figure), figure);
        else std::cout << figure.name() << " is not drawn: " << why_not << '\n';
    }
    if (!left_out.empty()) {
        const char *why = contains(left_out, ",") ? "they need" : "it needs";
        std::cout << "left out: " << left_out << " (" << why << " functions that are not started)\n";
        all = all && any;
    }
    if (any && is_only_unfinished(ran.finished)) return all; // that is no trouble, and the line above tells it
    if (!ran.trouble.empty()) std::cout << "course: " << ran.trouble << '\n';
    else if (!all) std::cout << "course: `./course check " << section.short_number() << "` shows what is wrong\n";
    return all;
}

} // namespace

void add_plot(CLI::App &app, const Workspace &workspace) {
    const auto words = std::make_shared<std::string>();
    const auto mine = std::make_shared<bool>();
    CLI::App *command =
        app.add_subcommand("plot", "Draw a section's figures, and say where they are")->footer(about_plot);
    command->add_option("section", *words, "its number, name or file");
    command->add_flag("--mine", *mine, "with your curve over ours");
    command->callback([&workspace, words, mine] {
        const auto sections = words->empty() ? workspace.sections() : std::vector{workspace.section(*words)};
        const Lock lock{workspace};
        bool all = true;
        for (const Section &section : sections) {
            draw_figures(workspace, section);
            if (*mine) all = plot_mine(workspace, section) && all;
            else
                for (const Figure &figure : figures_of(workspace, section))
                    print_drawn(workspace, drawn(workspace, figure), figure);
        }
        if (!all) throw ExitRequest{something_to};
    });
}

} // namespace course
