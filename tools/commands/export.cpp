// `course export`: the edition without solutions, for students of an instructor who keeps those; and what GitHub Classroom
// and Gradescope take.

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "grade/classroom.hpp"
#include "grade/handout.hpp"
#include "grade/points.hpp"

#include <fmt/format.h>
#include <functional>
#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr const char *repository_name = "frame-by-frame";

constexpr const char *about_export = R"(
It writes DIR/frame-by-frame, a git repository that students can clone, and the same as DIR/frame-by-frame-VERSION-handout.zip,
of what is committed. Export into the same folder again, and students type ./course update.
The last line of each exercise says which tests it was handed out with; `check -v` and feedback name theirs.
In a handout are no solutions, no wrong or right answers, and no bars of solutions in chapters. Nothing is written
if a line of ours is still in it. After a build in the handout, --check looks through its site, too.

With --online it writes DIR/frame-by-frame-online instead, a folder for any web server: students write their answers in
its pages, and install nothing. Ours are in it compiled, for later sections and demos.

Example: ./course export handout dist
         ./course export handout dist --online
         ./course export handout --check dist/frame-by-frame/build/default/site)";

constexpr const char *about_classroom = R"(
It writes DIR/frame-by-frame, a handout with a workflow for GitHub: at each push, students see which exercises are right,
and Classroom their points, all or none for an exercise. Push it to the public repository that you name with --template,
make that a template, and choose it for the assignment. Tests and tools come from there at each push, so nobody changes them
in their own repository; but the workflow is in theirs, so what counts is what you grade yourself, with parts of points:

         ./course grade 5 CLONES --gradebook classroom_grades.csv --out g5

Example: ./course export classroom 5 dist --template our-school/section-5)";

constexpr const char *about_gradescope = R"(
It writes DIR/05_inclined_planes-gradescope.zip, to be uploaded as an assignment's autograder. Each exercise is a test with
its points there. The image must be a Debian 12 or later, or an Ubuntu as new; our own solution is graded while it's
built, and must earn all points. The zip has our solutions: it's for you alone.

Example: ./course export gradescope 5 dist --hide 5.7)";

/// In an editor's words, as compilers have them.
void require_no_leaks(const Workspace &workspace, const fs::path &folder) {
    std::string all;
    for (const Finding &leak : leaks(workspace, folder))
        all += '\n' + leak.file.lexically_relative(folder).generic_string()
               + (leak.line == 0 ? "" : ':' + std::to_string(leak.line)) + ": " + leak.message;
    if (!all.empty()) throw UserError{"a handout mustn't have this in it:" + all};
}

/// What is committed, in a folder.
void take_committed(const Workspace &workspace, const fs::path &folder) {
    const std::string archive = folder.string() + ".tar";
    fs::create_directories(folder);
    git_in(workspace.root, {"archive", "--output=" + archive, "HEAD"});
    printed_by({"cmake", "-E", "tar", "xf", archive}, folder);
    fs::remove(archive);
}

/// An earlier handout gives way to this one, but for its history; nothing else does.
void require_handout_or_nothing(const fs::path &repository) {
    if (!fs::exists(repository)) return;
    if (!fs::exists(repository / handout_mark) || !fs::exists(repository / ".git"))
        throw UserError{repository.string() + " is there already, and is no handout: name another folder"};
    if (!git_in(repository, {"status", "--porcelain"}).empty())
        throw UserError{"somebody has changed " + repository.string() + ": commit that there, or name another folder"};
}

void put_into_repository(const fs::path &made, const fs::path &repository, const std::string &version) {
    require_handout_or_nothing(repository);
    fs::create_directories(repository);
    for (const fs::directory_entry &each : fs::directory_iterator{repository})
        if (!is_any_of(each.path().filename().string(), {".git", ".course", "build"})) fs::remove_all(each.path());
    fs::copy(made, repository, fs::copy_options::recursive);
    if (!fs::exists(repository / ".git")) git_in(repository, {"init", "--quiet"});
    git_in(repository, {"add", "--all"});
    if (!git_in(repository, {"status", "--porcelain"}).empty())
        git_in(repository, {"commit", "--quiet", "--message", "Frame by Frame " + version});
}

/// What is committed, without our solutions.
void make_handout_of(const Workspace &workspace, const fs::path &folder) {
    take_committed(workspace, folder);
    make_handout(folder);
    require_no_leaks(workspace, folder);
}

void export_online(const Workspace &workspace, const fs::path &folder) {
    require_committed(workspace, "a handout");
    const fs::path to = folder / (std::string{repository_name} + "-online"), made = online_handout(workspace);
    if (fs::exists(to) && !fs::exists(to / "service_worker.js"))
        throw UserError{to.string() + " is there already, and is no handout to write in: name another folder"};
    fs::remove_all(made);
    make_handout_of(workspace, made);
    const fs::path site = bring_up_online_handout(workspace);
    require_no_leaks(workspace, site);
    fs::remove_all(to);
    fs::create_directories(folder);
    fs::copy(site, to, fs::copy_options::recursive);
    std::cout << to.string() << ", a folder for any web server\n";
}

/// For what's made before it's put in its place, on the same disk.
struct ScratchIn : Scratch {
    explicit ScratchIn(const fs::path &place)
        : Scratch{(fs::create_directories(place), fs::absolute(place) / ".export")} {
        if (folder.empty()) throw UserError{"cannot write in " + place.string() + "; is it yours?"};
    }
};

/// @param add  to the handout, before it's committed and packed
void export_handout(const Workspace &workspace, const fs::path &folder,
                    const std::function<void(const fs::path &)> &add) {
    require_committed(workspace, "a handout");
    const std::string version = version_of(workspace);
    const ScratchIn scratch{folder};
    const fs::path made = scratch.folder / repository_name,
                   zip = folder / fmt::format("frame-by-frame-{}-handout.zip", version);
    make_handout_of(workspace, made);
    add(made);
    put_into_repository(made, folder / repository_name, version);
    pack(zip, scratch.folder, {repository_name});
    std::cout << (folder / repository_name).string() << ", a repository for students to clone\n"
              << with_size(zip.string(), zip);
}

struct PlatformOptions {
    std::string section = {}, folder = {}, points = {}, handed_out = {};
    std::vector<std::string> hide = {};

    fs::path worth(const Workspace &workspace) const {
        return points.empty() ? workspace.root / "tests" / "points.txt" : fs::path{points};
    }
};

void export_classroom(const Workspace &workspace, const PlatformOptions &options) {
    const Section section = workspace.section(options.section);
    const std::vector<Exercise> exercises = catalogue(workspace, section);
    const std::string workflow =
        classroom_workflow(section, exercises, Worth{options.worth(workspace), exercises}, options.handed_out);
    export_handout(workspace, options.folder, [&](const fs::path &made) {
        write_file(made / ".github" / "workflows" / "classroom.yml", workflow);
        write_file(made / handout_mark, read_file(made / handout_mark) + classroom_notes(section));
    });
}

std::string hidden_exercises(const Workspace &workspace, const Section &section, const PlatformOptions &options) {
    std::string lines;
    for (const std::string &words : options.hide) {
        const FoundExercise hidden = find_exercise(workspace, words);
        if (hidden.section.name != section.name)
            throw UserError{hidden.exercise.number + " is no exercise of section " + section.short_number()
                            + ": hide one of its own"};
        lines += hidden.exercise.number + '\n';
    }
    return lines;
}

void export_gradescope(const Workspace &workspace, const PlatformOptions &options) {
    const Section section = workspace.section(options.section);
    workspace.require_solution(section, "Grade with the whole course, which has them");
    require_committed(workspace, "an autograder");
    const std::string hidden = hidden_exercises(workspace, section, options);
    const Worth understood{options.worth(workspace), catalogue(workspace, section)};
    const ScratchIn scratch{options.folder};
    take_committed(workspace, scratch.folder / "course");
    std::vector<std::string> names{"course", "hidden", "run_autograder", "section", "setup.sh"};
    for (const char *script : {"run_autograder", "setup.sh"})
        fs::copy(scratch.folder / "course/tools/grade/gradescope" / script, scratch.folder);
    write_file(scratch.folder / "section", section.name + '\n');
    write_file(scratch.folder / "hidden", hidden);
    if (!options.points.empty()) {
        write_file(scratch.folder / "points.txt", read_file(options.points));
        names.emplace_back("points.txt");
    }
    const fs::path zip = fs::path{options.folder} / (section.name + "-gradescope.zip");
    pack(zip, scratch.folder, names);
    std::cout << with_size(zip.string(), zip);
}

CLI::App *add_platform(CLI::App *command, PlatformOptions &options, const char *name, const char *what) {
    CLI::App *platform = command->add_subcommand(name, what);
    platform->add_option("section", options.section, "its number, name or file")->required();
    platform->add_option("folder", options.folder, "where to write it")->required();
    platform->add_option("--points", options.points, "what exercises are worth, in the form of tests/points.txt");
    return platform;
}

void add_platforms(CLI::App *command, const Workspace &workspace) {
    const auto options = std::make_shared<PlatformOptions>();
    CLI::App *classroom = add_platform(command, *options, "classroom", "a handout for GitHub Classroom");
    classroom->add_option("--template", options->handed_out, "where you'll push it: OWNER/NAME on GitHub")->required();
    classroom->footer(about_classroom)->callback([&workspace, options] { export_classroom(workspace, *options); });
    CLI::App *gradescope = add_platform(command, *options, "gradescope", "an autograder for Gradescope");
    gradescope->add_option("--hide", options->hide, "an exercise of which students see nothing, as 5.7");
    gradescope->footer(about_gradescope)->callback([&workspace, options] { export_gradescope(workspace, *options); });
}

} // namespace

void add_export(CLI::App &app, const Workspace &workspace) {
    CLI::App *command = app.add_subcommand("export", "Write an edition of the course for others");
    CLI::App *handout =
        command->add_subcommand("handout", "without solutions, for your students")->footer(about_export);
    command->require_subcommand(1);
    const auto folder = std::make_shared<std::string>(), looked_at = std::make_shared<std::string>();
    auto *where = handout->add_option("folder", *folder, "where to write it");
    handout->add_option("--check", *looked_at, "write nothing: look for our solutions in this folder")->excludes(where);
    const auto online = std::make_shared<bool>(false);
    handout->add_flag("--online", *online, "for a web server: students write and check their answers in its pages");
    handout->callback([&workspace, folder, looked_at, online] {
        if (!looked_at->empty()) return require_no_leaks(workspace, *looked_at);
        if (folder->empty()) throw UserError{"name a folder to write to: ./course export handout dist"};
        if (*online) export_online(workspace, *folder);
        else export_handout(workspace, *folder, [](const fs::path &) {});
    });
    add_platforms(command, workspace);
}

} // namespace course
