// `course publish`: what a maintainer does after looking at the figures, and the check that CI makes.

#include "commands/commands.hpp"
#include "figures/demo_picture.hpp"
#include "figures/section_figures.hpp"
#include "ground/build.hpp"
#include "ground/files.hpp"
#include "ground/lock.hpp"
#include "ground/process.hpp"
#include "loop/diagnosis.hpp"
#include "loop/toolbox.hpp"
#include "site/demos.hpp"
#include "site/own_site.hpp"

#include <iostream>
#include <map>
#include <memory>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char *about_publish = R"(
Copies each drawn figure to plots/*.svg, where the chapters show it, and the trace that it was drawn
from to plots/*.tsv, with six significant digits. Look at the figures first: ./course plot
A picture of each demo as it begins at its places is kept in demos/*.svg, and where there is a compiler for WebAssembly, the demo
itself beside it.

--check compares the kept traces with what the programs write today. Header, rows and gaps must be
equal, and each number within one unit of its sixth digit (half of it is the rounding), or within
1e-12 of the largest in its column (a zero with its rounding errors). It also names a figure that is
not published, and a published one that has lost its script. The SVGs are not compared: another
gnuplot draws the same figure in other bytes. A kept demo must be, byte for byte, what its sources
give; its picture may differ by a tenth of a pixel.

Example: ./course publish --check)";

// Demos

/// Builds a target of the section's demo. @return false if it has no demo
bool build_demo(const Tree &tree, const Section &section, const char *target) {
    if (!fs::exists(tree.chapter(section).parent_path() / "demo.cpp")) return false;
    if (const Finished built = build_target(tree, section.name + target); built.code != 0)
        throw Complaint{"the demo of section " + section.short_number()
                        + " cannot be compiled: " + first_error(built.out + built.err)};
    return true;
}

/// Sections whose demo is compiled and is not the one that is kept; none without a compiler for pages.
std::vector<Section> changed_demos(const Tree &tree, const std::vector<Section> &sections) {
    std::vector<Section> changed;
    if (!can_compile_demos(tree)) return changed;
    for (const Section &section : sections) {
        if (!build_demo(tree, section, "_play")) continue;
        const fs::path kept = tree.root / demo_file(section);
        if (!fs::exists(kept)
            || run({toolbox(tree, section).node, (tree.root / "tools/play/pack.cjs").string(), "--same",
                    compiled_demo(tree, section).string(), kept.string()})
                       .code
                   != 0)
            changed.push_back(section);
    }
    return changed;
}

/// The still pictures of the section's demo, as SVGs, by the files in which they are kept; none without a demo.
std::map<fs::path, std::string> draw_demo(const Tree &tree, const Section &section) {
    if (!build_demo(tree, section, "_demo")) return {};
    const std::string name = "the demo of section " + section.short_number();
    const Colours colours = read_colours(read_file(tree.root / "plots" / "style.gp"));
    const std::vector<std::string> starts = demo_starts(demo_marks(read_file(tree.chapter(section))));
    std::map<fs::path, std::string> pictures;
    for (std::size_t start = 0; start < starts.size(); ++start) {
        const Finished played =
            run({(tree.build / "demo" / section.name).string(), "--picture", starts[start]}, {.deadline = 60});
        if (played.code != 0) throw Complaint{name + " cannot be drawn: " + played.err};
        pictures[tree.root / demo_picture_file(section, start)] = demo_picture(played.out, colours, name);
    }
    return pictures;
}

/// The kept pictures that are not what the demos show today, with what they show; with nothing if no place has them.
std::map<fs::path, std::string> changed_pictures(const Tree &tree, const std::vector<Section> &sections) {
    std::map<fs::path, std::string> changed;
    for (const Section &section : sections) {
        const std::map<fs::path, std::string> now = draw_demo(tree, section);
        for (const auto &[file, picture] : now)
            if (!fs::exists(file) || !show_the_same(read_file(file), picture)) changed[file] = picture;
        for (std::size_t start = now.size(); fs::exists(tree.root / demo_picture_file(section, start)); ++start)
            changed[tree.root / demo_picture_file(section, start)];
    }
    return changed;
}

void publish_all(const Tree &tree, const std::vector<Section> &sections) {
    std::size_t count = 0;
    for (const Section &section : sections)
        for (const auto &file : publish(tree, section)) {
            std::cout << tree.shown(file) << '\n';
            ++count;
        }
    for (const Section &section : changed_demos(tree, sections)) {
        write_file(tree.root / demo_file(section), read_file(compiled_demo(tree, section)));
        std::cout << demo_file(section) << '\n';
        ++count;
    }
    for (const auto &[file, picture] : changed_pictures(tree, sections)) {
        if (picture.empty()) fs::remove(file);
        else write_file(file, picture);
        std::cout << tree.shown(file) << '\n';
        ++count;
    }
    if (count == 0) std::cout << "What is published is up to date.\n";
}

void check_all(const Tree &tree, const std::vector<Section> &sections) {
    std::vector<std::string> found = strays(tree);
    for (const Section &section : sections)
        for (const std::string &text : outdated(tree, section)) found.push_back(text);
    for (const Section &section : changed_demos(tree, sections))
        found.push_back(demo_file(section) + " is not what its sources give today.");
    for (const auto &[file, picture] : changed_pictures(tree, sections))
        found.push_back(tree.shown(file) + (picture.empty() ? " has no place." : " is not what its demo shows today."));
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
