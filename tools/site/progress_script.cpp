#include "site/progress_script.hpp"

#include "base/files.hpp"
#include "check/progress.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson exercises_of(const Progress &so_far) {
    OrderedJson exercises = OrderedJson::array();
    for (const Standing &standing : so_far.standings)
        exercises.push_back({{"number", standing.exercise.number},
                             {"function", standing.exercise.function},
                             {"done", standing.state == "passed"}});
    return exercises;
}

/// Where to go on: at an exercise, or in a section that has to be checked again.
OrderedJson place_to_go_on(const Section &section, const Standing *next, const std::string &page) {
    if (next == nullptr) return {{"number", section.short_number()}, {"address", page}};
    return {{"number", next->exercise.number},
            {"function", next->exercise.function},
            {"address", page + "#exercise-" + next->exercise.number}};
}

} // namespace

std::string progress_script(const Workspace &workspace) {
    OrderedJson known{{"sections", OrderedJson::array()}};
    const auto current = section_to_go_on_with(workspace);
    bool begun = false;
    OrderedJson next;
    for (const Section &section : workspace.sections()) {
        if (!is_built(workspace, section)) continue;
        const Progress so_far = progress(workspace, section);
        const std::string page = page_name(workspace, workspace.chapter(section)) + ".html";
        known["sections"].push_back(
            {{"number", section.short_number()}, {"page", page}, {"exercises", exercises_of(so_far)}});
        begun = begun || !so_far.judged.empty();
        if (current && current->name == section.name) next = place_to_go_on(section, so_far.next(), page);
    }
    if (begun && !next.is_null()) known["next"] = next;
    return "// How far the reader is; `./course check` writes it.\nself.progress = " + known.dump() + ";\n";
}

void write_progress_script(const Workspace &workspace) {
    try {
        for (const fs::path &folder : {site_folder(workspace), own_site_folder(workspace)})
            if (fs::exists(folder)) write_file(folder / "progress.js", progress_script(workspace));
    } catch (const UserError &complaint) {
        std::cerr << "course: the pages of the site do not know of this: " << complaint.what() << '\n';
    }
}

} // namespace course
