// `course dev release`: what somebody can take who has no use for a repository.

#include "base/files.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"

#include <fmt/format.h>
#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

/// Whoever takes it must be able to say what they have, and to read what's new in it.
void require_ready(const Workspace &workspace, const std::string &version) {
    if (!contains(read_file(workspace.root / "CHANGELOG.md"), "\n## " + version + '\n'))
        throw UserError{"CHANGELOG.md has no heading \"## " + version
                        + "\": say what a reader gets, or change the version in CMakeLists.txt"};
    require_committed(workspace, "a release");
}

} // namespace

void release(const Workspace &workspace) {
    const std::string version = version_of(workspace), name = "frame-by-frame-" + version;
    require_ready(workspace, version);
    bring_up_site(workspace);

    const fs::path folder = workspace.build / "release";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const auto file = [&](const char *rest) { return (folder / (name + rest)).string(); };
    git_in(workspace.root, {"archive", "--prefix=" + name + '/', "--output=" + file(".tar.gz"), "HEAD"});
    printed_by(
        {"cmake", "-E", "tar", "cf", file("-site.zip"), "--format=zip", site_folder(workspace).filename().string()},
        site_folder(workspace).parent_path());
    std::vector<std::string> stills{"cmake", "-E", "tar", "cf", file("-stills.zip"), "--format=zip"};
    for (const fs::directory_entry &each : fs::directory_iterator{workspace.root / "demos"})
        if (each.path().extension() == ".svg") stills.push_back("demos/" + each.path().filename().string());
    printed_by(stills, workspace.root);
    for (const char *rest : {".tar.gz", "-site.zip", "-stills.zip"})
        std::cout << fmt::format("{}, {:.1f} MB\n", workspace.relative_name(file(rest)),
                                 double(fs::file_size(file(rest))) / 1e6);
}

void add_release(CLI::App &app, const Workspace &workspace) {
    CLI::App *command =
        app.add_subcommand("release", "Make a release's archives, if all that's published is up to date");
    command->footer("In build/default/release there will be the sources, the site, and the stills of the demos. Their "
                    "names have the version\nthat ./course --version shows.\n\nExample: ./course dev release");
    command->callback([&workspace] {
        require_published(workspace);
        release(workspace);
    });
}

} // namespace course
