// `course dev publish`: what a maintainer does after looking at the figures, and the check that CI makes.

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/lock.hpp"
#include "base/process.hpp"
#include "check/build_config.hpp"
#include "check/diagnosis.hpp"
#include "commands/commands.hpp"
#include "figures/section_figures.hpp"
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
itself beside it; so are the sketches of docs/gallery.

--check compares the kept traces with what the programs write today. Header, rows and gaps must be
equal, and each number within one unit of its sixth digit (half of it is the rounding), or within
1e-12 of the largest in its column (a zero with its rounding errors). It also names a figure that is
not published, and a published one that has lost its script. The SVGs are not compared: another
gnuplot draws the same figure in other bytes. A kept demo must be, byte for byte, what its sources
give, and no more than 90,000 bytes, or 160,000 with PLAYS_YOURS; its picture may differ by a tenth of a pixel.

--mistakes keeps, for ./course check, what comes out of the mutants whose words begin
with "you". It takes minutes, so that ./course test --all tells when it's due, and not --check.

Example: ./course dev publish --check)";

// Demos

/// What a page loads for a demo, at most: the program, packed [bytes]; for one with the functions of many sections, too.
constexpr std::uintmax_t heaviest_demo = 90000, heaviest_of_many = 160000;

/// A chapter's demo, or a sketch of the gallery: demos/NAME.js, and its pictures.
struct Shown {
    std::string name;                ///< "07_segment_intersection", "sketch_nails"
    std::string page, program;       ///< targets of the build
    std::vector<std::string> starts; ///< of its pictures
    std::uintmax_t heaviest = heaviest_demo;

    std::string file() const { return "demos/" + name + ".js"; }
    fs::path packed(const Workspace &workspace) const { return workspace.build / "play" / (name + ".js"); }
};

std::vector<Shown> shown_of(const Workspace &workspace, const std::vector<Section> &sections) {
    std::vector<Shown> all;
    for (const Section &section : sections)
        if (fs::exists(workspace.chapter(section).parent_path() / "demo.cpp"))
            all.push_back({section.name, section.name + "_play", section.name + "_demo",
                           demo_starts(demo_marks(read_file(workspace.chapter(section)))),
                           build_config(workspace, section).plays_yours ? heaviest_of_many : heaviest_demo});
    if (sections.size() < workspace.sections().size()) return all;
    for (const GallerySketch &sketch : gallery(workspace))
        all.push_back({sketch.demo, sketch.demo + "_page", sketch.demo, {""}});
    return all;
}

void build_shown(const Workspace &workspace, const Shown &one, const std::string &target) {
    if (const Finished built = build_target(workspace, target); built.code != 0)
        throw UserError{one.name + " cannot be compiled: " + first_error(built.out + built.err)};
}

std::string node(const Workspace &workspace) { return build_config(workspace, workspace.sections().front()).node; }

/// Those whose compiled demo is not the one that is kept; none without a compiler for pages.
std::vector<Shown> changed_demos(const Workspace &workspace, const std::vector<Shown> &all) {
    std::vector<Shown> changed;
    if (!can_compile_demos(workspace)) return changed;
    for (const Shown &one : all) {
        build_shown(workspace, one, one.page);
        const fs::path kept = workspace.root / one.file();
        if (!fs::exists(kept)
            || run({node(workspace), (workspace.root / "tools/play/pack.cjs").string(), "--same",
                    one.packed(workspace).string(), kept.string()})
                       .code
                   != 0)
            changed.push_back(one);
    }
    return changed;
}

/// "" if the kept demo isn't too heavy.
std::string too_heavy(const Workspace &workspace, const Shown &one) {
    const fs::path kept = workspace.root / one.file();
    if (!fs::exists(kept) || fs::file_size(kept) <= one.heaviest) return "";
    return one.file() + " has " + std::to_string(fs::file_size(kept))
           + " bytes, and a page waits for each: " + std::to_string(one.heaviest) + " at most.";
}

/// Keeps the still pictures of a demo; a line for each that was not what the demo shows today.
/// @param how  "--check": it only looks
std::vector<std::string> draw_demo(const Workspace &workspace, const Shown &one, const std::string &how) {
    build_shown(workspace, one, one.program);
    std::vector<std::string> command{node(workspace), (workspace.root / "tools/play/stills.cjs").string(), how,
                                     (workspace.build / "demo" / one.name).string(),
                                     (workspace.root / "demos" / one.name).string()};
    std::ranges::copy(one.starts, std::back_inserter(command));
    const Finished drawn = run(command);
    if (drawn.code != 0) throw UserError{one.name + " cannot be drawn: " + drawn.err};
    std::vector<std::string> changed;
    for (const Line &line : split_lines(drawn.out)) changed.emplace_back(line.text);
    return changed;
}

void publish_all(const Workspace &workspace, const std::vector<Section> &sections) {
    std::vector<std::string> changed;
    for (const Section &section : sections) draw_figures(workspace, section);
    for (const Section &section : sections)
        for (const auto &file : publish(workspace, section)) changed.push_back(workspace.relative_name(file));
    const std::vector<Shown> shown = shown_of(workspace, sections);
    for (const Shown &one : changed_demos(workspace, shown)) {
        write_file(workspace.root / one.file(), read_file(one.packed(workspace)));
        changed.push_back(one.file());
    }
    for (const Shown &one : shown) std::ranges::copy(draw_demo(workspace, one, ""), std::back_inserter(changed));
    for (const std::string &file : changed) std::cout << file << '\n';
    if (changed.empty()) std::cout << "What is published is up to date.\n";
}

// Mistakes

void publish_mistakes(const Workspace &workspace, const Section &section) {
    if (const Finished built = build_target(workspace, section.name + "_author"); built.code != 0)
        throw UserError{"the answers of section " + section.short_number()
                        + " cannot be compiled: " + first_error(built.out + built.err)};
    const Finished known = run({(workspace.build / "author" / section.name).string(),
                                (workspace.build / "subjects" / section.name / "answers").string(), "--mistakes",
                                (workspace.build / "answers" / (section.name + "_claims.txt")).string()});
    if (known.code != 0)
        throw UserError{"the answers of section " + section.short_number() + " cannot be judged: " + known.err};
    const fs::path file = workspace.mistakes(section);
    if (fs::exists(file) && read_file(file) == known.out) return;
    write_file(file, known.out);
    std::cout << workspace.relative_name(file) << '\n' << std::flush;
}

void require_published(const Workspace &workspace, const std::vector<Section> &sections) {
    for (const Section &section : sections) draw_figures(workspace, section);
    std::vector<std::string> differences = strays(workspace);
    for (const Section &section : sections)
        std::ranges::copy(outdated(workspace, section), std::back_inserter(differences));
    const std::vector<Shown> shown = shown_of(workspace, sections);
    for (const Shown &one : changed_demos(workspace, shown))
        differences.push_back(one.file() + " is not what its sources give today.");
    for (const Shown &one : shown)
        if (std::string heavy = too_heavy(workspace, one); !heavy.empty()) differences.push_back(std::move(heavy));
    for (const Shown &one : shown)
        std::ranges::copy(draw_demo(workspace, one, "--check"), std::back_inserter(differences));
    for (const std::string &text : differences) std::cout << text << '\n';
    if (differences.empty()) {
        std::cout << "The published figures agree with the programs.\n";
        return;
    }
    std::cout << "If that is as it should be, look at the figures (./course plot) and type ./course dev publish\n";
    throw ExitRequest{something_to};
}

} // namespace

void require_published(const Workspace &workspace) {
    const Lock lock{workspace};
    require_published(workspace, workspace.sections());
}

void add_publish(CLI::App &app, const Workspace &workspace) {
    const auto words = std::make_shared<std::string>();
    const auto check = std::make_shared<bool>(), mistakes = std::make_shared<bool>();
    CLI::App *command = app.add_subcommand("publish", "Keep the drawn figures in plots/, where the chapters show them");
    command->footer(about_publish);
    command->add_option("section", *words, "its number, name or file; all without it");
    command->add_flag("--check", *check, "only say what differs");
    command->add_flag("--mistakes", *mistakes, "keep what known mistakes are known by, and nothing else");
    command->callback([&workspace, words, check, mistakes] {
        const auto sections = words->empty() ? workspace.sections() : std::vector{workspace.section(*words)};
        const Lock lock{workspace};
        if (!*mistakes) return *check ? require_published(workspace, sections) : publish_all(workspace, sections);
        for (const Section &section : sections) publish_mistakes(workspace, section);
    });
}

} // namespace course
