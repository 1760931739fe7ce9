// `course export handout`: the edition without solutions, for students of an instructor who keeps those.

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "grade/handout.hpp"

#include <fmt/format.h>
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

void export_handout(const Workspace &workspace, const fs::path &folder) {
    require_committed(workspace, "a handout");
    const std::string version = version_of(workspace);
    fs::create_directories(folder);
    const Scratch scratch{fs::absolute(folder) / ".handout"};
    if (scratch.folder.empty()) throw UserError{"cannot write in " + folder.string() + "; is it yours?"};
    const fs::path made = scratch.folder / repository_name,
                   zip = folder / fmt::format("frame-by-frame-{}-handout.zip", version);
    make_handout_of(workspace, made);
    put_into_repository(made, folder / repository_name, version);
    printed_by({"cmake", "-E", "tar", "cf", fs::absolute(zip).string(), "--format=zip", repository_name},
               scratch.folder);
    std::cout << fmt::format("{}, a repository for students to clone\n{}, {:.1f} MB\n",
                             (folder / repository_name).string(), zip.string(), double(fs::file_size(zip)) / 1e6);
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
        else export_handout(workspace, *folder);
    });
}

} // namespace course
