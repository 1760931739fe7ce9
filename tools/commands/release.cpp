// `course dev release`: what somebody can take who has no use for a repository.

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"

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
    const auto pack_site = [&](const fs::path &site, const char *rest) {
        pack(file(rest), site.parent_path(), {site.filename().string()});
    };
    std::vector<std::string> stills;
    for (const fs::directory_entry &each : fs::directory_iterator{workspace.root / "demos"})
        if (each.path().extension() == ".svg") stills.push_back("demos/" + each.path().filename().string());
    pack_site(site_folder(workspace), "-site.zip");
    pack(file("-stills.zip"), workspace.root, stills);
    std::vector<fs::path> archives{file(".tar.gz"), file("-site.zip"), file("-stills.zip")};
    if (online) {
        pack_site(bring_up_online_site(workspace), "-online.zip");
        archives.emplace_back(file("-online.zip"));
    }
    std::string sums;
    const std::vector<std::string> hashes = sha256_of(archives);
    for (std::size_t i = 0; i < archives.size(); ++i) {
        sums += hashes[i] + "  " + archives[i].filename().string() + '\n';
        std::cout << with_size(workspace.relative_name(archives[i]), archives[i]);
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
