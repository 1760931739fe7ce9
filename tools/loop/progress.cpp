#include "loop/progress.hpp"

#include "loop/memory.hpp"

namespace course {

Progress progress(const Tree &tree, const Section &section) {
    const auto memories = recall(tree, section);
    const std::string file = fingerprint(tree.exercise(section));
    const bool untouched = file == fingerprint(tree.stub(section));

    Progress result;
    result.there = !file.empty();
    for (const Exercise &exercise : catalogue(tree, section)) {
        const auto memory = memories.find(exercise.number);
        const bool known = memory != memories.end();
        const bool newer = known && result.there && memory->second.file != file;
        result.changed = result.changed || (newer && !untouched);
        result.standings.push_back({exercise, untouched ? "not started"
                                              : known   ? memory->second.state
                                                        : "not checked"});
    }
    return result;
}

std::optional<Section> first_unfinished(const Tree &tree) {
    for (const Section &section : tree.sections())
        if (!is_built(tree, section) || !progress(tree, section).finished()) return section;
    return std::nullopt;
}

} // namespace course
