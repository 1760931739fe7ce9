#include "loop/memory.hpp"

#include "ground/files.hpp"
#include "ground/lock.hpp"

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <fmt/chrono.h>
#include <iostream>
#include <nlohmann/json.hpp>

namespace course {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

fs::path progress_file(const Tree &tree) { return tree.memory() / "progress.json"; }
fs::path hints_file(const Tree &tree) { return tree.memory() / "hints.json"; }
fs::path hunts_file(const Tree &tree) { return tree.memory() / "bugs.json"; }

/// The object in the file; an empty one if there is none, or it is broken.
json load(const fs::path &path) {
    json found;
    try {
        found = json::parse(read_file(path), nullptr, false);
    } catch (const Complaint &) { // not there, or not ours to read
    }
    return found.is_object() ? found : json::object();
}

void store(const fs::path &path, const json &memory) {
    try {
        write_file(path, memory.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
    } catch (const Complaint &complaint) {
        std::cerr << "course: this is not remembered: " << complaint.what() << '\n';
    }
}

/// Changes what a file remembers. One command at a time, so that of two at once neither loses what the other adds.
template <class Change> void change(const Tree &tree, const fs::path &path, Change what) {
    const Descriptor alone = short_lock(tree.memory() / "lock");
    json memory = load(path);
    what(memory);
    store(path, memory);
}

/// How many rungs this memory says.
int rungs_in(const json &hints, const std::string &number) {
    const auto found = hints.find(number);
    return found != hints.end() && found->is_number_unsigned() && *found < 1000 ? found->get<int>() : 0;
}

std::string word(const json &object, const char *key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::string now(const char *format, bool utc) {
    const std::time_t seconds = std::time(nullptr);
    return fmt::format(fmt::runtime(format), utc ? fmt::gmtime(seconds) : fmt::localtime(seconds));
}

} // namespace

void remember(const Tree &tree, const Section &section, const std::vector<ExerciseState> &states) {
    const std::string file = fingerprint(tree.exercise(section)), when = now("{:%Y-%m-%dT%H:%M:%SZ}", true);
    change(tree, progress_file(tree), [&](json &progress) {
        json &memories = progress[section.name];
        if (!memories.is_object()) memories = json::object();
        for (const ExerciseState &s : states) memories[s.number] = {{"state", s.state}, {"file", file}, {"when", when}};
    });
}

std::map<std::string, Memory> recall(const Tree &tree, const Section &section) {
    const json progress = load(progress_file(tree));
    std::map<std::string, Memory> result;
    const auto memories = progress.find(section.name);
    if (memories == progress.end() || !memories->is_object()) return result;
    for (const auto &[number, memory] : memories->items())
        if (!word(memory, "state").empty()) // a memory that is no object has no words
            result[number] = {word(memory, "state"), word(memory, "file"), word(memory, "when")};
    return result;
}

void remember_rungs(const Tree &tree, const std::string &number, int shown) {
    change(tree, hints_file(tree), [&](json &hints) { hints[number] = static_cast<unsigned>(std::max(shown, 0)); });
}

int take_rung(const Tree &tree, const std::string &number, int rungs) {
    int rung = 0;
    change(tree, hints_file(tree), [&](json &hints) {
        rung = std::min(rungs_in(hints, number), rungs);
        hints[number] = static_cast<unsigned>(std::min(rung + 1, rungs));
    });
    return rung;
}

void remember_hunt(const Tree &tree, const Section &section, const Hunt &hunt) {
    change(tree, hunts_file(tree), [&](json &hunts) {
        hunts[section.name] = {{"begun", hunt.begun}, {"written", hunt.written}, {"found", hunt.found}};
    });
}

Hunt recall_hunt(const Tree &tree, const Section &section) {
    const json all = load(hunts_file(tree)), its = all.value(section.name, json::object());
    Hunt hunt;
    if (!its.is_object()) return hunt;
    hunt.begun = word(its, "begun");
    hunt.written = word(its, "written");
    if (const auto found = its.find("found"); found != its.end() && found->is_array())
        for (const json &name : *found)
            if (name.is_string()) hunt.found.insert(name.get<std::string>());
    return hunt;
}

std::string fingerprint(const fs::path &file) {
    if (!fs::is_regular_file(file)) return "";
    std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a: no secret, only a change
    for (char c : read_file(file)) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

fs::path keep_copy(const Tree &tree, const fs::path &file) {
    const fs::path folder = tree.memory() / "kept";
    const std::string name = file.stem().string() + now("-{:%Y-%m-%d-%H%M%S}", false);
    fs::path copy = folder / (name + ".cpp");
    for (int more = 2; fs::exists(copy); ++more) copy = folder / (name + '-' + std::to_string(more) + ".cpp");
    write_file(copy, read_file(file));
    return copy;
}

fs::path keep_copy_of_bug(const Tree &tree, const Section &section) {
    const fs::path file = tree.bug(section);
    if (!fs::exists(file) || fingerprint(file) == recall_hunt(tree, section).written) return {};
    return keep_copy(tree, file);
}

} // namespace course
