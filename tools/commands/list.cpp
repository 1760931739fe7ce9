// `course list`: what there is to do, and how far the student is. Remembered, not run again.

#include "base/files.hpp"
#include "base/terminal.hpp"
#include "check/progress.hpp"
#include "check/progress_store.hpp"
#include "commands/commands.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace course {
namespace {

/// The chapter's first line without the mark, "7 Nothing gets through:", or "9 Where's the hand?".
std::string title(const Workspace &workspace, const Section &section) {
    const std::string chapter = read_file(workspace.chapter(section)),
                      line = chapter.substr(0, chapter.find_first_of("\r\n"));
    const std::string words = line.starts_with("# ") ? line.substr(2) : section.name;
    return words.ends_with('?') ? words : words + ':';
}

Colour colour(const std::string &state) {
    if (state == "passed") return Colour::green;
    return state == "not started" || state == "not checked" || state.starts_with("needs ") ? Colour::dim : Colour::red;
}

void print(const Workspace &workspace, const Section &section, const Progress &progress) {
    std::cout << painted(Colour::bold, title(workspace, section)) << ' ' << progress.passed() << " of "
              << progress.standings.size() << " passed\n";
    std::size_t longest = 0;
    for (const Standing &s : progress.standings) longest = std::max(longest, s.exercise.function.size());
    for (const auto &[exercise, state] : progress.standings)
        std::cout << "  " << std::left << std::setw(6) << exercise.number << std::setw(11) << exercise.tier
                  << std::setw(static_cast<int>(longest) + 2) << exercise.function << painted(colour(state), state)
                  << '\n';

    const std::string file = "exercises/" + section.name + ".cpp", number = section.short_number();
    if (!progress.there)
        std::cout << "  " << file << " is not there; `./course reset " << number << "` brings the empty one back.\n";
    if (progress.changed) std::cout << "  " << file << " has changed since the last check.\n";
    if (const Hunt hunt = recall_hunt(workspace, section); !hunt.begun.empty())
        std::cout << "  bugs found: " << hunt.found.size() << " (./course bug " << number << ")\n";
}

/// What to do about the exercise to go on with.
std::string next_step(const Workspace &workspace, const Section &section) {
    if (!is_built(workspace, section)) return "./course, which builds it";
    const Progress known = progress(workspace, section);
    const Standing *next = known.next();
    const std::string number = section.short_number();
    if (!known.there) return "./course reset " + number;
    if (known.changed || next == nullptr) return "./course check " + number;
    const auto &[exercise, state] = *next;
    if (state == "is empty" || state == "can't be read" || state == "does not compile" || state == "does not link")
        return "./course check " + number + " (it " + state + ')';
    if (state != "not started")
        return "./course check " + number + " (" + exercise.number + ": " + state + "; ./course hint " + exercise.number
               + " helps)";
    return exercise.number + ", `" + exercise.function + "`, in exercises/" + section.name
           + ".cpp; then ./course check " + number;
}

void list(const Workspace &workspace) {
    for (const Section &section : workspace.sections()) {
        if (!is_built(workspace, section)) {
            std::cout << painted(Colour::bold, title(workspace, section)) << " not built yet\n\n";
            continue;
        }
        print(workspace, section, progress(workspace, section));
        std::cout << '\n';
    }
    if (print_sketches(workspace)) std::cout << '\n';
    const auto section = section_to_go_on_with(workspace);
    std::cout << (section ? "Next: " + next_step(workspace, *section) : "All exercises are passed.") << '\n';
}

} // namespace

void add_list(CLI::App &app, const Workspace &workspace) {
    app.add_subcommand("list", "Show all sections and exercises, how far you are, and the next step")
        ->footer("Nothing is run: the states are those of the last check.\n\nExample: ./course list")
        ->callback([&workspace] { list(workspace); });
}

} // namespace course
