#include "figures/section_figures.hpp"

#include "base/build.hpp"
#include "base/files.hpp"
#include "check/diagnosis.hpp"
#include "check/programs.hpp"
#include "figures/trace.hpp"

#include <algorithm>
#include <sstream>

namespace course {
namespace fs = std::filesystem;
namespace {

fs::path published(const Figure &figure, const char *kind) { return fs::path{figure.script}.replace_extension(kind); }

std::string in_plots(const fs::path &file) { return "plots/" + file.filename().string(); }

/// What is wrong with the kept trace: it is not there, broken, or no longer what the program writes; "" if nothing is.
std::string trouble_with_trace(const Figure &figure) try {
    const fs::path kept = published(figure, ".tsv");
    if (!fs::exists(kept)) return in_plots(kept) + " is not there";
    const Trace now = read_trace(figure.trace, figure.trace.filename().string());
    return difference(read_trace(kept, in_plots(kept)), now, in_plots(kept));
} catch (const TraceFault &fault) {
    return fault.what();
}

/// A measurement is never the same twice, so the trace is kept, and no program writes it.
fs::path trace_of(const Workspace &workspace, const Section &section, const fs::path &script) {
    if (script.filename().string().starts_with(section.name + "_measured_"))
        return fs::path{script}.replace_extension(".tsv");
    return reference_traces(workspace, section) / (script.stem().string() + ".tsv");
}

} // namespace

std::vector<Figure> figures_of(const Workspace &workspace, const Section &section) {
    std::vector<Figure> figures;
    for (const fs::path &file : files_in(workspace.root / "plots", ".gp", section.name + "_"))
        figures.push_back({file, trace_of(workspace, section, file), {}});
    return figures;
}

fs::path drawn(const Workspace &workspace, const Figure &figure) {
    if (!workspace.has_solution(workspace.section(figure.name()))) return published(figure, ".svg");
    return workspace.build / "plots" / (figure.name() + ".svg");
}

void draw_figures(const Workspace &workspace, const Section &section) {
    if (!workspace.has_solution(section)) return; // the published ones are all that there is
    const Finished built = build_target(workspace, section.name + "_figures");
    if (built.code == 0) return;
    const std::string printed = built.out + '\n' + built.err;
    std::istringstream lines{printed};
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("course: ")) throw UserError{line.substr(8)}; // the message of `course draw`
    const std::string error = first_error(printed);
    throw UserError{"the figures of " + section.name
                    + " cannot be drawn: " + (error.empty() ? "see cmake --build " + workspace.build.string() : error)};
}

std::vector<fs::path> publish(const Workspace &workspace, const Section &section) {
    std::vector<fs::path> changed;
    const auto put = [&](const fs::path &file, const std::string &text) {
        if (write_file(file, text)) changed.push_back(file);
    };
    for (const Figure &figure : figures_of(workspace, section)) {
        put(published(figure, ".svg"), read_file(drawn(workspace, figure)));
        if (!trouble_with_trace(figure).empty())
            put(published(figure, ".tsv"), rounded(read_trace(figure.trace, figure.trace.filename().string())));
    }
    return changed;
}

std::vector<std::string> outdated(const Workspace &workspace, const Section &section) {
    std::vector<std::string> messages;
    for (const Figure &figure : figures_of(workspace, section)) {
        if (const fs::path svg = published(figure, ".svg"); !fs::exists(svg))
            messages.push_back(in_plots(svg) + " is not there");
        if (const std::string trouble = trouble_with_trace(figure); !trouble.empty()) messages.push_back(trouble);
    }
    return messages;
}

std::vector<std::string> strays(const Workspace &workspace) {
    const std::vector<Section> sections = workspace.sections();
    std::vector<std::string> messages;
    for (const fs::path &file : files_in(workspace.root / "plots")) {
        const std::string name = file.filename().string();
        if (name == "style.gp" || !(name.ends_with(".gp") || name.ends_with(".svg") || name.ends_with(".tsv")))
            continue;
        const bool known =
            std::ranges::any_of(sections, [&](const Section &section) { return name.starts_with(section.name + "_"); });
        if (!known)
            messages.push_back("plots/" + name + " belongs to no section: name it NN_slug_<figure>, or remove it");
        else if (!fs::exists(fs::path{file}.replace_extension(".gp")))
            messages.push_back("plots/" + name + " has no script: write plots/" + file.stem().string()
                               + ".gp, or remove it");
    }
    return messages;
}

} // namespace course
