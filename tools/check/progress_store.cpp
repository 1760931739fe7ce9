#include "check/progress_store.hpp"

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/lock.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/chrono.h>
#include <iostream>
#include <nlohmann/json.hpp>

namespace course {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

fs::path progress_file(const Workspace &workspace) { return workspace.memory() / "progress.json"; }
fs::path hints_file(const Workspace &workspace) { return workspace.memory() / "hints.json"; }
fs::path attempts_file(const Workspace &workspace) { return workspace.memory() / "attempts.json"; }
fs::path hunts_file(const Workspace &workspace) { return workspace.memory() / "bugs.json"; }

/// The object in the file; an empty one if there is none, or it is broken.
json load(const fs::path &path) {
    json object;
    try {
        object = json::parse(read_file(path), nullptr, false);
    } catch (const UserError &) { // not there, or not ours to read
    }
    return object.is_object() ? object : json::object();
}

void store(const fs::path &path, const json &memory) {
    try {
        write_file(path, memory.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
    } catch (const UserError &complaint) {
        std::cerr << "course: this is not remembered: " << complaint.what() << '\n';
    }
}

/// Changes what a file remembers. One command at a time, so that of two at once neither loses what the other adds.
template <class Change> void change(const Workspace &workspace, const fs::path &path, Change what) {
    const UniqueFd alone = short_lock(workspace.memory() / "lock");
    json memory = load(path);
    what(memory);
    store(path, memory);
}

/// How many rungs this memory says.
int rungs_in(const json &hints, const std::string &number) {
    const auto rungs = hints.find(number);
    return rungs != hints.end() && rungs->is_number_unsigned() && *rungs < 1000 ? rungs->get<int>() : 0;
}

std::string word(const json &object, const char *key) {
    const auto value = object.find(key);
    return value != object.end() && value->is_string() ? value->get<std::string>() : "";
}

std::string now(const char *format, bool utc) {
    const std::time_t seconds = std::time(nullptr);
    return fmt::format(fmt::runtime(format), utc ? fmt::gmtime(seconds) : fmt::localtime(seconds));
}

} // namespace

void remember(const Workspace &workspace, const Section &section, std::string_view text,
              const std::vector<ExerciseState> &states) {
    const std::string file = fnv1a(text), when = now("{:%Y-%m-%dT%H:%M:%SZ}", true);
    change(workspace, progress_file(workspace), [&](json &progress) {
        json &memories = progress[section.name];
        if (!memories.is_object()) memories = json::object();
        for (const ExerciseState &s : states) memories[s.number] = {{"state", s.state}, {"file", file}, {"when", when}};
    });
}

std::map<std::string, Memory> recall(const Workspace &workspace, const Section &section) {
    const json progress = load(progress_file(workspace));
    std::map<std::string, Memory> result;
    const auto memories = progress.find(section.name);
    if (memories == progress.end() || !memories->is_object()) return result;
    for (const auto &[number, memory] : memories->items())
        if (!word(memory, "state").empty()) // a memory that is no object has no words
            result[number] = {word(memory, "state"), word(memory, "file"), word(memory, "when")};
    return result;
}

void remember_rungs(const Workspace &workspace, const std::string &number, int rungs) {
    change(workspace, hints_file(workspace),
           [&](json &hints) { hints[number] = static_cast<unsigned>(std::max(rungs, 0)); });
}

int take_rung(const Workspace &workspace, const std::string &number, int rungs) {
    int rung = 0;
    change(workspace, hints_file(workspace), [&](json &hints) {
        rung = std::min(rungs_in(hints, number), rungs);
        hints[number] = static_cast<unsigned>(std::min(rung + 1, rungs));
    });
    return rung;
}

std::map<std::string, int> open_rungs(const Workspace &workspace) {
    const json hints = load(hints_file(workspace));
    std::map<std::string, int> open;
    for (const auto &each : hints.items()) open[each.key()] = rungs_in(hints, each.key());
    return open;
}

void remember_attempts(const Workspace &workspace, const std::vector<Attempt> &attempts) {
    if (attempts.empty()) return;
    const std::string when = now("{:%Y-%m-%dT%H:%M:%SZ}", true);
    change(workspace, attempts_file(workspace), [&](json &all) {
        for (const auto &[number, state, mistake, unset] : attempts) {
            json &of_this = all[number];
            if (!of_this.is_array()) of_this = json::array();
            of_this.push_back({{"state", state}, {"mistake", mistake}, {"when", when}});
        }
    });
}

std::vector<Attempt> recall_attempts(const Workspace &workspace) {
    std::vector<Attempt> result;
    const json all = load(attempts_file(workspace));
    for (const auto &[number, of_this] : all.items()) {
        if (!of_this.is_array()) continue;
        for (const json &attempt : of_this)
            if (attempt.is_object())
                result.push_back({number, word(attempt, "state"), word(attempt, "mistake"), word(attempt, "when")});
    }
    return result;
}

void remember_hunt(const Workspace &workspace, const Section &section, const Hunt &hunt) {
    change(workspace, hunts_file(workspace), [&](json &hunts) {
        hunts[section.name] = {{"begun", hunt.begun}, {"written", hunt.written}, {"found", hunt.found}};
    });
}

Hunt recall_hunt(const Workspace &workspace, const Section &section) {
    const json all = load(hunts_file(workspace)), memory = all.value(section.name, json::object());
    Hunt hunt;
    if (!memory.is_object()) return hunt;
    hunt.begun = word(memory, "begun");
    hunt.written = word(memory, "written");
    if (const auto names = memory.find("found"); names != memory.end() && names->is_array())
        for (const json &name : *names)
            if (name.is_string()) hunt.found.insert(name.get<std::string>());
    return hunt;
}

std::string fingerprint(const fs::path &file) { return fs::is_regular_file(file) ? fnv1a(read_file(file)) : ""; }

fs::path keep_copy(const Workspace &workspace, const fs::path &file) {
    const fs::path folder = workspace.memory() / "kept";
    const std::string name = file.stem().string() + now("-{:%Y-%m-%d-%H%M%S}", false);
    fs::path copy = folder / (name + ".cpp");
    for (int more = 2; fs::exists(copy); ++more) copy = folder / (name + '-' + std::to_string(more) + ".cpp");
    write_file(copy, read_file(file));
    return copy;
}

fs::path keep_copy_of_bug(const Workspace &workspace, const Section &section) {
    const fs::path file = workspace.bug(section);
    if (!fs::exists(file) || fingerprint(file) == recall_hunt(workspace, section).written) return {};
    return keep_copy(workspace, file);
}

} // namespace course
