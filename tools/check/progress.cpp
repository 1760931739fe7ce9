#include "check/progress.hpp"

#include "check/progress_store.hpp"

namespace course {

const Standing *Progress::next() const {
    const auto open = std::ranges::find_if(standings, [](const Standing &s) { return s.state != "passed"; });
    if (open == standings.end()) return nullptr;
    const auto needed = std::ranges::find_if(standings, [&](const Standing &s) {
        return open->state == "needs " + s.exercise.number + ' ' + s.exercise.function;
    });
    return &*(needed == standings.end() ? open : needed);
}

Progress progress(const Workspace &workspace, const Section &section) {
    const auto memories = recall(workspace, section);
    const std::string file = fingerprint(workspace.exercise(section));
    const bool untouched = file == fingerprint(workspace.stub(section));

    Progress result;
    result.there = !file.empty();
    for (const Exercise &exercise : catalogue(workspace, section)) {
        const auto memory = memories.find(exercise.number);
        const bool known = memory != memories.end();
        if (known && !untouched) result.judged = std::max(result.judged, memory->second.when);
        result.standings.push_back({exercise, untouched ? "not started"
                                              : known   ? memory->second.state
                                                        : "not checked"});
    }
    const auto is_of_this_text = [&](const auto &memory) { return memory.second.file == file; };
    result.changed = result.there && !untouched && !memories.empty() && std::ranges::none_of(memories, is_of_this_text);
    return result;
}

std::optional<Section> section_to_go_on_with(const Workspace &workspace) {
    std::optional<Section> next;
    std::string latest;
    for (const Section &section : workspace.sections()) {
        const Progress known = is_built(workspace, section) ? progress(workspace, section) : Progress{};
        const bool done = is_built(workspace, section) && known.finished() && known.there && !known.changed;
        if (done || (next && known.judged <= latest)) continue;
        next = section;
        latest = known.judged;
    }
    return next;
}

} // namespace course
