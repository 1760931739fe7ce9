// `course publish --release`: what somebody can take who has no use for a repository.

#include "commands/commands.hpp"
#include "ground/files.hpp"
#include "ground/repository.hpp"
#include "ground/text.hpp"
#include "site/addresses.hpp"

#include <fmt/format.h>
#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

/// Whoever takes it must be able to say what they have, and to read what's new in it.
void require_ready(const Tree &tree, const std::string &version) {
    if (!contains(read_file(tree.root / "CHANGELOG.md"), "\n## " + version + '\n'))
        throw Complaint{"CHANGELOG.md has no heading \"## " + version
                        + "\": say what a reader gets, or change the version in CMakeLists.txt"};
    require_committed(tree, "a release");
}

} // namespace

void release(const Tree &tree) {
    const std::string version = version_of(tree), name = "frame-by-frame-" + version;
    require_ready(tree, version);
    bring_up_site(tree);

    const fs::path folder = tree.build / "release";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const auto file = [&](const char *rest) { return (folder / (name + rest)).string(); };
    git_in(tree.root, {"archive", "--prefix=" + name + '/', "--output=" + file(".tar.gz"), "HEAD"});
    printed_by({"cmake", "-E", "tar", "cf", file("-site.zip"), "--format=zip", site_folder(tree).filename().string()},
               site_folder(tree).parent_path());
    std::vector<std::string> stills{"cmake", "-E", "tar", "cf", file("-stills.zip"), "--format=zip"};
    for (const fs::directory_entry &each : fs::directory_iterator{tree.root / "demos"})
        if (each.path().extension() == ".svg") stills.push_back("demos/" + each.path().filename().string());
    printed_by(stills, tree.root);
    for (const char *rest : {".tar.gz", "-site.zip", "-stills.zip"})
        std::cout << fmt::format("{}, {:.1f} MB\n", tree.shown(file(rest)), double(fs::file_size(file(rest))) / 1e6);
}

} // namespace course
