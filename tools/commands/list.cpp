// `course list`: what there is to do, and how far the student is. Remembered, not run again.

#include "commands/commands.hpp"
#include "ground/files.hpp"
#include "ground/terminal.hpp"
#include "loop/memory.hpp"
#include "loop/progress.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace course {
namespace {

/// The chapter's first line without its mark, "7 Nothing gets through:", or "9 Where's the hand?".
std::string title(const Tree &tree, const Section &section) {
    const std::string chapter = read_file(tree.chapter(section)),
                      line = chapter.substr(0, chapter.find_first_of("\r\n"));
    const std::string words = line.starts_with("# ") ? line.substr(2) : section.name;
    return words.ends_with('?') ? words : words + ':';
}

Colour colour(const std::string &state) {
    if (state == "passed") return Colour::green;
    return state == "not started" || state == "not checked" || state.starts_with("needs ") ? Colour::dim : Colour::red;
}

void print(const Tree &tree, const Section &section, const Progress &progress) {
    std::cout << painted(Colour::bold, title(tree, section)) << ' ' << progress.passed() << " of "
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
    if (const Hunt hunt = recall_hunt(tree, section); !hunt.begun.empty())
        std::cout << "  bugs found: " << hunt.found.size() << " (./course bug " << number << ")\n";
}

/// What to do about the first exercise that is open, or the one that it needs, which is not started.
std::string next_step(const Section &section, const Progress &progress) {
    const auto open = progress.first_open(), none = progress.standings.end();
    const std::string number = section.short_number();
    if (!progress.there) return "./course reset " + number;
    if (progress.changed || open == none) return "./course check " + number;
    const auto needed = std::ranges::find_if(progress.standings, [&](const Standing &s) {
        return open->state == "needs " + s.exercise.number + ' ' + s.exercise.function;
    });
    const auto &[exercise, state] = needed == none ? *open : *needed;
    if (state == "is empty" || state == "can't be read" || state == "does not compile" || state == "does not link")
        return "./course check " + number + " (it " + state + ')';
    if (state != "not started")
        return "./course check " + number + " (" + exercise.number + ": " + state + "; ./course hint " + exercise.number
               + " helps)";
    return exercise.number + ", `" + exercise.function + "`, in exercises/" + section.name
           + ".cpp; then ./course check " + number;
}

void list(const Tree &tree) {
    std::string next;
    for (const Section &section : tree.sections()) {
        if (!is_built(tree, section)) {
            std::cout << painted(Colour::bold, title(tree, section)) << " not built yet\n\n";
            if (next.empty()) next = "./course, which builds it";
            continue;
        }
        const Progress so_far = progress(tree, section);
        print(tree, section, so_far);
        std::cout << '\n';
        if (next.empty() && (!so_far.finished() || so_far.changed || !so_far.there)) next = next_step(section, so_far);
    }
    std::cout << (next.empty() ? "All exercises are passed.\n" : "Next: " + next + '\n');
}

} // namespace

void add_list(CLI::App &app, const Tree &tree) {
    app.add_subcommand("list", "Show all sections and exercises, how far you are, and the next step")
        ->footer("Nothing is run: the states are those of the last check.\n\nExample: ./course list")
        ->callback([&tree] { list(tree); });
}

} // namespace course
