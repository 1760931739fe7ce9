// `course play`: a chapter's demo in the browser, with our functions or with the student's.

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/lock.hpp"
#include "base/watch.hpp"
#include "check/bugs.hpp"
#include "check/catalogue.hpp"
#include "check/programs.hpp"
#include "check/progress_store.hpp"
#include "commands/commands.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"
#include "site/demos.hpp"
#include "site/own_site.hpp"
#include "site/share.hpp"
#include "site/spot_the_bug.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <functional>
#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char *about_play = R"(
Without --mine the demo runs on our functions; no compiler is needed for that. With --mine it runs on
yours, in a copy of the site in the build folder, and a switch in the page takes you to ours and back.
Where an exercise of yours is not started, ours stands in for it. With --bug it runs on the one function
that `./course bug` has left for you to mend.

Example: ./course play 7.4 --mine --watch
         ./course play 7.4 --mine --share ball.html)";

struct PlayOptions {
    std::string section;
    fs::path share;
    bool mine = false, bug = false, watch = false, yes = false;
};

// The student's demo

/// What an earlier section's file is compiled to for this section's demo, if that plays the student's of all.
fs::path earlier_object(const Workspace &workspace, const Section &section, const Section &earlier) {
    return workspace.build / "play" / (section.name + '_' + earlier.name + "_mine.o");
}

/// The other sections with files in this section's demo, once it's built.
std::vector<Section> sections_of_demo(const Workspace &workspace, const Section &section) {
    std::vector<Section> all = workspace.sections();
    std::erase_if(all, [&](const Section &each) { return !fs::exists(earlier_object(workspace, section, each)); });
    return all;
}

/// A line for each of them that doesn't compile: tools/play/earlier.cjs has left something in its place.
std::string about_broken(const Workspace &workspace, const Section &section) {
    std::string lines;
    for (const Section &each : sections_of_demo(workspace, section))
        if (read_file(earlier_object(workspace, section, each)).starts_with("broken"))
            lines += workspace.relative_name(workspace.exercise(each))
                     + " doesn't compile, so the demo has our functions of section " + each.short_number()
                     + ": ./course check " + each.short_number() + " says why.\n";
    return lines;
}

/// Compiles the student's file into the demo; a file that cannot be compiled becomes a sentence, there and here.
/// @return whether it could be compiled
bool build_own(const Workspace &workspace, const Section &section) {
    const Lock lock{workspace};
    const auto began = std::chrono::steady_clock::now();
    const std::string trouble = build_own_demo(workspace, section);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    if (trouble.empty())
        std::cout << fmt::format("Your code is in the demo ({:.1f} s).\n", took.count())
                  << about_broken(workspace, section) << std::flush;
    else std::cout << "Your code is not in the demo: " << trouble << '\n' << std::flush;
    return trouble.empty();
}

/// Builds again at each save.
void watch(const Workspace &workspace, const Section &section, const std::function<bool()> &build) {
    std::cout << "Save your file, and the page takes it up. Ctrl-C ends this.\n" << std::flush;
    std::vector<fs::path> files{workspace.exercise(section)};
    for (const Section &each : sections_of_demo(workspace, section)) files.push_back(workspace.exercise(each));
    for (FileWatch saves{files}; saves.wait();) build();
}

struct Place {
    DemoMark mark;
    std::string id; ///< within the page
};

/// See place_for.
Place place_of_demo(const Workspace &workspace, const Section &section, const std::string &exercise, bool mine) {
    const std::vector<DemoMark> marks = demo_marks(read_file(workspace.chapter(section)));
    const std::size_t place = place_for(marks, exercise, mine);
    return {marks[place], demo_id(marks[place], place)};
}

/// Writes the page that can be sent to a friend.
void share(const Workspace &workspace, const Demo &demo, const DemoMark &mark, const fs::path &file) {
    write_file(file, shared_page(workspace, demo, mark, !sections_of_demo(workspace, demo.section).empty()));
    std::cout << "Written: " << file.string() << ", " << fs::file_size(file) / 1000
              << " kB, with your code in it. Send it to a friend, who opens it with a double click.\n";
}

/// @throws UserError if the section has none
Demo demo_of(const Workspace &workspace, const Section &section) {
    for (Demo &demo : demos(workspace))
        if (demo.section.name == section.name) return std::move(demo);
    throw UserError{"section " + section.short_number() + " has no demo to play with yet"};
}

/// Where the bug is seen, as far as is remembered which one it is.
DemoMark mark_of_bug(const Workspace &workspace, const Section &section) {
    const std::string begun = recall_hunt(workspace, section).begun;
    const std::vector<Bug> bugs = bugs_of(workspace, section);
    const auto bug = std::ranges::find(bugs, begun, &Bug::name);
    return bug == bugs.end() ? place_of_demo(workspace, section, "", true).mark
                             : place_of_bug(workspace, section, *bug);
}

/// Opens a page with the demo alone: the site and the student's copy of it know nothing of bugs.
void play_bug(const Workspace &workspace, const PlayOptions &options) {
    if (options.section.empty()) throw UserError{"--bug needs a section, as in: ./course play 8 --bug"};
    const Section section = workspace.section(options.section);
    const fs::path file = workspace.bug(section), page = workspace.build / "play" / (section.name + "_bug.html");
    if (!fs::exists(file))
        throw UserError{workspace.relative_name(file) + " isn't there yet: ./course bug " + section.short_number()
                        + " puts a bug into it"};
    const Demo demo = demo_of(workspace, section);
    const DemoMark mark = mark_of_bug(workspace, section);
    need_page_compiler(workspace, options.yes);
    bring_up_site(workspace);
    const Lock lock{workspace};
    const Finished built = build_target(workspace, section.name + "_play_bug");
    if (built.code != 0) {
        std::cout << "There's no demo of it: " << student_error(workspace, section, file, built.out + '\n' + built.err)
                  << '\n';
        throw ExitRequest{something_to};
    }
    write_file(page, page_with_bug(workspace, demo, mark));
    open_page(page);
}

void play(const Workspace &workspace, const PlayOptions &options) {
    if (options.bug) return play_bug(workspace, options);
    if (options.mine && options.section.empty())
        throw UserError{"--mine needs a section, as in: ./course play 7 --mine"};
    if (!options.share.empty() && !options.mine)
        throw UserError{"--share is for your own code: ./course play 7 --mine --share ball.html"};
    if (!options.share.empty() && options.share.extension() != ".html")
        throw UserError{options.share.string() + " would be a web page: give it a name that ends in .html"};
    if (options.watch && !options.mine) throw UserError{"--watch is for your own code: ./course play 7 --mine --watch"};
    std::optional<Demo> demo;
    std::string page = "play.html", exercise;
    std::optional<Section> section;
    Place place;
    if (!options.section.empty()) {
        section = workspace.section(options.section);
        if (is_number_of_exercise(options.section))
            exercise = find_exercise(workspace, options.section).exercise.number;
        demo = demo_of(workspace, *section);
        place = place_of_demo(workspace, *section, exercise, options.mine);
        page = page_name(workspace, workspace.chapter(*section)) + ".html#" + place.id;
    }
    if (!options.share.empty() && fingerprint(workspace.exercise(*section)) == fingerprint(workspace.stub(*section)))
        throw UserError{workspace.relative_name(workspace.exercise(*section))
                        + " is not started, so there is nothing of yours to share yet"};
    if (options.mine) need_page_compiler(workspace, options.yes);
    bring_up_site(workspace);
    const auto build = [&] { return build_own(workspace, *section); };
    if (options.mine) copy_own_site(workspace);
    const bool fine = !options.mine || build();
    if (fine && !options.share.empty()) return share(workspace, *demo, place.mark, options.share);
    open_page((options.mine ? own_site_folder(workspace) : site_folder(workspace)) / page);
    if (options.watch) watch(workspace, *section, build);
    if (!fine) throw ExitRequest{something_to};
}

} // namespace

void add_play(CLI::App &app, const Workspace &workspace) {
    const auto options = std::make_shared<PlayOptions>();
    CLI::App *command = app.add_subcommand("play", "Open a chapter's demo in your browser, with our code or yours");
    command->add_option("section", options->section,
                        "its number, name or file, or the number of an exercise; without it, the page with all demos");
    CLI::Option *mine =
        command->add_flag("--mine", options->mine, "with your functions; the page lets you switch to ours");
    command->add_flag("--bug", options->bug, "with the function of exercises/08_bug.cpp, which ./course bug 8 writes")
        ->excludes(mine);
    command->add_flag("-w,--watch", options->watch, "with --mine: again whenever you save; the open page takes it up");
    command
        ->add_option("--share", options->share,
                     "with --mine: write one page with the demo and your functions, to send to a friend")
        ->type_name("FILE");
    command->add_flag("--yes", options->yes,
                      "with --mine: install a compiler for pages without asking, if there is none");
    command->footer(about_play);
    command->callback([&workspace, options] { play(workspace, *options); });
}

} // namespace course
