// `course publish`: what a maintainer does after looking at the figures, and the check that CI makes.

#include "commands/commands.hpp"
#include "figures/section_figures.hpp"
#include "ground/build.hpp"
#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/lock.hpp"
#include "ground/process.hpp"
#include "loop/diagnosis.hpp"
#include "loop/mistakes.hpp"
#include "loop/toolbox.hpp"
#include "site/demos.hpp"
#include "site/own_site.hpp"

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <iterator>

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
give, and no more than 64,000 bytes, or 120,000 with PLAYS_YOURS; its picture may differ by a tenth of a pixel.

--mistakes keeps, for ./course check, what comes out of the wrong answers in tests/wrong whose words begin
with "you". It takes minutes, so that ./course test --all tells when it's due, and not --check.

--release checks the same, and then makes three archives in build/default/release: the sources, the site, and
the stills of the demos. Their names have the version that ./course --version shows.

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

/// What a page loads for a demo, at most: its program, packed [bytes]; for one with the functions of many sections, too.
constexpr std::uintmax_t heaviest_demo = 64000, heaviest_of_many = 120000;

/// "" if the kept demo isn't too heavy.
std::string too_heavy(const Tree &tree, const Section &section) {
    const fs::path kept = tree.root / demo_file(section);
    const std::uintmax_t most = toolbox(tree, section).plays_yours ? heaviest_of_many : heaviest_demo;
    if (!fs::exists(kept) || fs::file_size(kept) <= most) return "";
    return demo_file(section) + " has " + std::to_string(fs::file_size(kept))
           + " bytes, and a page waits for each: " + std::to_string(most) + " at most.";
}

/// Keeps the still pictures of the section's demo; a line for each that was not what the demo shows today.
/// @param how  "--check": it only looks
std::vector<std::string> draw_demo(const Tree &tree, const Section &section, const std::string &how) {
    if (!build_demo(tree, section, "_demo")) return {};
    std::vector<std::string> command{toolbox(tree, section).node, (tree.root / "tools/play/stills.cjs").string(), how,
                                     (tree.build / "demo" / section.name).string(),
                                     (tree.root / "demos" / section.name).string()};
    for (const std::string &start : demo_starts(demo_marks(read_file(tree.chapter(section))))) command.push_back(start);
    const Finished drawn = run(command);
    if (drawn.code != 0)
        throw Complaint{"the demo of section " + section.short_number() + " cannot be drawn: " + drawn.err};
    std::vector<std::string> changed;
    for (const Line &line : lines_of(drawn.out)) changed.emplace_back(line.text);
    return changed;
}

void publish_all(const Tree &tree, const std::vector<Section> &sections) {
    std::vector<std::string> changed;
    for (const Section &section : sections)
        for (const auto &file : publish(tree, section)) changed.push_back(tree.shown(file));
    for (const Section &section : changed_demos(tree, sections)) {
        write_file(tree.root / demo_file(section), read_file(compiled_demo(tree, section)));
        changed.push_back(demo_file(section));
    }
    for (const Section &section : sections)
        std::ranges::copy(draw_demo(tree, section, ""), std::back_inserter(changed));
    for (const std::string &file : changed) std::cout << file << '\n';
    if (changed.empty()) std::cout << "What is published is up to date.\n";
}

// Mistakes

void publish_mistakes(const Tree &tree, const Section &section) {
    if (const Finished built = build_target(tree, section.name + "_answers"); built.code != 0)
        throw Complaint{"the answers of section " + section.short_number()
                        + " cannot be compiled: " + first_error(built.out + built.err)};
    const Finished known =
        run({tree.test_program(section).string(), (tree.build / "subjects" / section.name / "answers").string(),
             "--mistakes", (tree.build / "answers" / (section.name + "_claims.txt")).string()});
    if (known.code != 0)
        throw Complaint{"the answers of section " + section.short_number() + " cannot be judged: " + known.err};
    const fs::path file = file_of_mistakes(tree, section);
    if (fs::exists(file) && read_file(file) == known.out) return;
    write_file(file, known.out);
    std::cout << tree.shown(file) << '\n' << std::flush;
}

void check_all(const Tree &tree, const std::vector<Section> &sections) {
    std::vector<std::string> found = strays(tree);
    for (const Section &section : sections) std::ranges::copy(outdated(tree, section), std::back_inserter(found));
    for (const Section &section : changed_demos(tree, sections))
        found.push_back(demo_file(section) + " is not what its sources give today.");
    for (const Section &section : sections)
        if (std::string heavy = too_heavy(tree, section); !heavy.empty()) found.push_back(std::move(heavy));
    for (const Section &section : sections)
        std::ranges::copy(draw_demo(tree, section, "--check"), std::back_inserter(found));
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
    const auto words = std::make_shared<std::string>();
    const auto check = std::make_shared<bool>(), releases = std::make_shared<bool>(),
               mistakes = std::make_shared<bool>();
    CLI::App *command = app.add_subcommand("publish", "Keep the drawn figures in plots/, where the chapters show them");
    command->footer(about_publish);
    command->add_option("section", *words, "its number, name or file; all without it");
    command->add_flag("--check", *check, "only say what differs");
    command->add_flag("--mistakes", *mistakes, "keep what known mistakes are known by, and nothing else");
    command->add_flag("--release", *releases, "make the archives of a release")->excludes("section");
    command->callback([&tree, words, check, releases, mistakes] {
        const auto sections = words->empty() ? tree.sections() : std::vector{tree.section(*words)};
        {
            const Lock lock{tree};
            if (*mistakes) {
                for (const Section &section : sections) publish_mistakes(tree, section);
                return;
            }
            for (const Section &section : sections) draw_figures(tree, section);
            *check || *releases ? check_all(tree, sections) : publish_all(tree, sections);
        }
        if (*releases) release(tree);
    });
}

} // namespace course
