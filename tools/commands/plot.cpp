// `course plot`: a section's figures, from the reference's traces or with the student's curve over them.

#include "commands/commands.hpp"
#include "figures/figure.hpp"
#include "figures/section_figures.hpp"
#include "figures/trace.hpp"
#include "ground/files.hpp"
#include "ground/lock.hpp"
#include "ground/text.hpp"
#include "loop/programs.hpp"

#include <iostream>
#include <memory>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char *about_plot = R"(
The figures lie in the build folder as SVG; any browser shows them. With --mine your program is
built and run, for at most 10 s, and its curves are drawn over ours; a figure that needs functions
which you have not started is left out. Without a section all figures are drawn.

Example: ./course plot 7 --mine)";

void say_drawn(const Tree &tree, const fs::path &svg, const Figure &figure) {
    std::cout << tree.shown(svg) << "  " << figure_title(figure.script) << '\n';
}

/// Why a student's trace cannot be drawn, for the student.
std::string in_student_words(const TraceFault &fault, const Ran &ran, const Figure &figure) {
    const std::string said = said_of(ran.finished, figure.trace.filename().string());
    if (said.starts_with("error: ")) return "one of your functions threw: " + said.substr(7);
    if (fault.kind == TraceFault::not_finite)
        return "your functions gave " + fault.value.substr(fault.value.find_first_not_of('-')) + " where "
               + fault.column + " should stand";
    if (!ran.trouble.empty()) return "your program did not get as far as this figure";
    if (fault.kind == TraceFault::malformed) return fault.what();
    return "your program ended before this figure was written; does one of your functions end the program?";
}

/// Draws one figure with the student's curve; returns why not, or "".
std::string draw_mine(const Tree &tree, const Figure &figure, const fs::path &svg, const Ran &ran) {
    try {
        read_trace(figure.student, "your trace " + figure.student.filename().string());
        write_file(svg, draw(figure));
        return "";
    } catch (const TraceFault &fault) {
        return in_student_words(fault, ran, figure);
    } catch (const FigureFault &) {
        return "your values lie outside the axes, or cannot be drawn; they are in " + tree.shown(figure.student);
    }
}

/// @return whether each figure could be drawn, or one at least and the others need functions that are not started
bool plot_mine(const Tree &tree, const Section &section) {
    const fs::path traces = student_traces(tree, section);
    const Ran ran = run_program(tree, section, Whose::student, traces);
    bool all = ran.started, any = false;
    std::string left_out; // the names of figures that need functions which are not started
    if (ran.started)
        for (Figure figure : figures_of(tree, section)) {
            if (figure.is_measured() || !draws_student(figure.script)) continue; // nothing in it is the student's
            const fs::path svg = tree.build / "plots" / "mine" / (figure.name() + ".svg");
            figure.student = traces / figure.trace.filename();
            fs::remove(svg); // an older one would be taken for today's
            if (said_of(ran.finished, figure.trace.filename().string()).starts_with("not started: ")) {
                left_out += (left_out.empty() ? "" : ", ") + figure.name();
                continue;
            }
            const std::string why_not = draw_mine(tree, figure, svg, ran);
            any = any || why_not.empty();
            if (why_not.empty()) say_drawn(tree, svg, figure);
            else std::cout << figure.name() << " is not drawn: " << why_not << '\n';
            all = all && why_not.empty();
        }
    if (!left_out.empty()) {
        const char *why = contains(left_out, ",") ? "they need" : "it needs";
        std::cout << "left out: " << left_out << " (" << why << " functions that are not started)\n";
        all = all && any;
    }
    if (any && is_only_unfinished(ran.finished)) return all; // that is no trouble: the line above has said it
    if (!ran.trouble.empty()) std::cout << "course: " << ran.trouble << '\n';
    else if (!all) std::cout << "course: `./course check " << section.short_number() << "` shows what is wrong\n";
    return all;
}

} // namespace

void add_plot(CLI::App &app, const Tree &tree) {
    struct Options {
        std::string section;
        bool mine = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *command =
        app.add_subcommand("plot", "Draw a section's figures, and say where they are")->footer(about_plot);
    command->add_option("section", options->section, "its number, name or file");
    command->add_flag("--mine", options->mine, "with your curve over ours");
    command->callback([&tree, options] {
        const auto sections = options->section.empty() ? tree.sections() : std::vector{tree.section(options->section)};
        const Lock lock{tree};
        bool all = true;
        for (const Section &section : sections) {
            draw_figures(tree, section);
            if (options->mine) all = plot_mine(tree, section) && all;
            else
                for (const Figure &figure : figures_of(tree, section)) say_drawn(tree, drawn(tree, figure), figure);
        }
        if (!all) throw Leave{something_to};
    });
}

} // namespace course
