// `course publish --release`: what somebody can take who has no use for a repository.

#include "commands/commands.hpp"
#include "ground/files.hpp"
#include "ground/process.hpp"
#include "ground/text.hpp"
#include "site/addresses.hpp"

#include <fmt/format.h>
#include <iostream>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// As `course --version` says it.
std::string version_of(const Tree &tree) {
    static const std::regex version{R"(project\(\w+ VERSION ([\d.]+))"};
    std::smatch found;
    const std::string text = read_file(tree.root / "CMakeLists.txt");
    if (!std::regex_search(text, found, version)) throw Complaint{"CMakeLists.txt has no project(… VERSION 1.2.3)"};
    return found[1];
}

std::string printed_by(const std::vector<std::string> &command, const fs::path &folder) {
    const Finished done = run(command, {.folder = folder});
    if (done.code != 0) throw Complaint{command[0] + ' ' + command[1] + " failed: " + done.err};
    return done.out;
}

/// Whoever takes it must be able to say what they have, and to read what's new in it.
void require_ready(const Tree &tree, const std::string &version) {
    if (!contains(read_file(tree.root / "CHANGELOG.md"), "\n## " + version + '\n'))
        throw Complaint{"CHANGELOG.md has no heading \"## " + version
                        + "\": say what a reader gets, or change the version in CMakeLists.txt"};
    if (const std::string changed = printed_by({"git", "status", "--porcelain"}, tree.root); !changed.empty())
        throw Complaint{"commit first, since a release is made of what is committed:\n" + changed};
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
    printed_by({"git", "archive", "--prefix=" + name + '/', "--output=" + file(".tar.gz"), "HEAD"}, tree.root);
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
