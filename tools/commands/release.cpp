// `course dev release`: what somebody can take who has no use for a repository.

#include "base/files.hpp"
#include "base/hash.hpp"
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

void release(const Workspace &workspace, bool online) {
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
    std::vector<fs::path> archives{file(".tar.gz"), file("-site.zip"), file("-stills.zip")};
    if (online) {
        const fs::path site = bring_up_online_site(workspace);
        archives.emplace_back(file("-online.zip"));
        printed_by({"cmake", "-E", "tar", "cf", archives.back().string(), "--format=zip", site.filename().string()},
                   site.parent_path());
    }
    std::string sums;
    const std::vector<std::string> hashes = sha256_of(archives);
    for (std::size_t i = 0; i < archives.size(); ++i) {
        sums += hashes[i] + "  " + archives[i].filename().string() + '\n';
        std::cout << fmt::format("{}, {:.1f} MB\n", workspace.relative_name(archives[i]),
                                 double(fs::file_size(archives[i])) / 1e6);
    }
    write_file(folder / "SHA256SUMS", sums);
    std::cout << "Checksums are in " << workspace.relative_name(folder / "SHA256SUMS") << ". Now tag it: git tag v"
              << version << '\n';
}

void add_release(CLI::App &app, const Workspace &workspace) {
    CLI::App *command =
        app.add_subcommand("release", "Make a release's archives, if all that's published is up to date");
    const auto online = std::make_shared<bool>();
    command->add_flag("--online", *online, "the site to write in, too");
    command->footer(
        "In build/default/release there will be the sources, the site, the stills of the demos, and checksums. "
        "Their names have the\nversion that ./course --version shows.\n\nExample: ./course dev release --online");
    command->callback([&workspace, online] {
        require_published(workspace);
        release(workspace, *online);
    });
}

} // namespace course
