#include "site/progress_script.hpp"

#include "ground/files.hpp"
#include "loop/memory.hpp"
#include "loop/progress.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

using OrderedJson = nlohmann::ordered_json;

bool is_done(const Standing &standing) { return standing.state == "passed"; }

OrderedJson exercises_of(const Progress &so_far) {
    OrderedJson exercises = OrderedJson::array();
    for (const Standing &standing : so_far.standings)
        exercises.push_back({{"number", standing.exercise.number},
                             {"function", standing.exercise.function},
                             {"done", is_done(standing)}});
    return exercises;
}

/// When one of the section's exercises was last judged; "" if never.
std::string last_judged(const Tree &tree, const Section &section) {
    std::string last;
    for (const auto &[number, memory] : recall(tree, section)) last = std::max(last, memory.when);
    return last;
}

} // namespace

std::string progress_script(const Tree &tree) {
    OrderedJson known{{"sections", OrderedJson::array()}};
    std::string latest; // of the sections with something left to do: the student works on the last one judged
    bool begun = false;
    OrderedJson next;
    for (const Section &section : tree.sections()) {
        if (!is_built(tree, section)) continue;
        const Progress so_far = progress(tree, section);
        const std::string page = page_name(tree, tree.chapter(section)) + ".html", when = last_judged(tree, section);
        known["sections"].push_back(
            {{"number", section.short_number()}, {"page", page}, {"exercises", exercises_of(so_far)}});
        begun = begun || !when.empty();
        const auto open = std::ranges::find_if_not(so_far.standings, is_done);
        if (open == so_far.standings.end() || (!next.is_null() && when <= latest)) continue;
        latest = when;
        next = {{"number", open->exercise.number},
                {"function", open->exercise.function},
                {"address", page + "#exercise-" + open->exercise.number}};
    }
    if (begun && !next.is_null()) known["next"] = next;
    return "// How far the reader is; `./course check` writes it.\nself.progress = " + known.dump() + ";\n";
}

void tell_pages(const Tree &tree) {
    if (tree.is_shared()) return; // they're for many
    try {
        for (const fs::path &folder : {site_folder(tree), own_site_folder(tree)})
            if (fs::exists(folder)) write_file(folder / "progress.js", progress_script(tree));
    } catch (const Complaint &complaint) {
        std::cerr << "course: the pages of the site do not know of this: " << complaint.what() << '\n';
    }
}

} // namespace course
