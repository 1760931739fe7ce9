// `course publish`: what a maintainer does after looking at the figures, and the check that CI makes.

#include "commands/commands.hpp"
#include "figures/section_figures.hpp"
#include "ground/lock.hpp"

#include <iostream>
#include <memory>

namespace course {
namespace {

constexpr const char *about_publish = R"(
Copies each drawn figure to plots/*.svg, where the chapters show it, and the trace that it was drawn
from to plots/*.tsv, with six significant digits. Look at the figures first: ./course plot

--check compares the kept traces with what the programs write today. Header, rows and gaps must be
equal, and each number within one unit of its sixth digit (half of it is the rounding), or within
1e-12 of the largest in its column (a zero with its rounding errors). It also names a figure that is
not published, and a published one that has lost its script. The SVGs are not compared: another
gnuplot draws the same figure in other bytes.

Example: ./course publish --check)";

void publish_all(const Tree &tree, const std::vector<Section> &sections) {
    std::size_t count = 0;
    for (const Section &section : sections)
        for (const auto &file : publish(tree, section)) {
            std::cout << tree.shown(file) << '\n';
            ++count;
        }
    if (count == 0) std::cout << "The published figures are up to date.\n";
}

void check_all(const Tree &tree, const std::vector<Section> &sections) {
    std::vector<std::string> found = strays(tree);
    for (const Section &section : sections)
        for (const std::string &text : outdated(tree, section)) found.push_back(text);
    for (const std::string &text : found) std::cout << text << '\n';
    if (found.empty()) {
        std::cout << "The published figures agree with the programs.\n";
        return;
    }
    std::cout << "If that is as it should be, look at the figures (./course plot) and type ./course publish\n";
    throw Leave{something_to};
}

} // namespace

void add_publish(CLI::App &app, const Tree &tree) {
    struct Options {
        std::string section;
        bool check = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App *command = app.add_subcommand("publish", "Keep the drawn figures in plots/, where the chapters show them");
    command->footer(about_publish);
    command->add_option("section", options->section, "its number, name or file; all without it");
    command->add_flag("--check", options->check, "only say what differs");
    command->callback([&tree, options] {
        const auto sections = options->section.empty() ? tree.sections() : std::vector{tree.section(options->section)};
        const Lock lock{tree};
        for (const Section &section : sections) draw_figures(tree, section);
        options->check ? check_all(tree, sections) : publish_all(tree, sections);
    });
}

} // namespace course
