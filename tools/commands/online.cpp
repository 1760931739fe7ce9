// The edition of the site in which one writes C++ in the page: `course site --online`, and `course export handout --online`.

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/lock.hpp"
#include "base/process.hpp"
#include "commands/commands.hpp"

#include <iostream>

namespace course {
namespace fs = std::filesystem;
namespace {

/// What a page compiles with and the editor, as package-lock.json names them by version and checksum.
void install_packages(const Workspace &workspace) {
    const fs::path folder = workspace.root / "tools" / "online", wanted = folder / "package-lock.json",
                   installed = folder / "node_modules" / "package-lock.json";
    if (fs::exists(installed) && read_file(installed) == read_file(wanted)) return;
    if (!in_path("npm"))
        throw UserError{
            "the compiler for pages and the editor come from npm, which isn't here: on Debian, apt-get install "
            "npm"};
    std::cout << "npm fetches the compiler that runs in a page, and the editor: some 35 MB, this once" << std::endl;
    const Finished npm = run({"npm", "ci", "--prefix", folder.string(), "--no-audit", "--no-fund"});
    if (npm.code != 0) throw UserError{"npm can't fetch them; it says:\n" + npm.err};
    fs::copy_file(wanted, installed, fs::copy_options::overwrite_existing);
}

/// Brings one of the two editions up to date.
void build_online(const Workspace &workspace, const std::string &target) {
    need_page_compiler(workspace, false);
    const Lock lock{workspace};
    install_packages(workspace);
    std::cout << "What the page needs is compiled; the first time this takes some minutes" << std::endl;
    const Finished built = build_target(workspace, target);
    if (built.code != 0) throw UserError{"the online edition can't be built:\n" + built.out + built.err};
}

} // namespace

fs::path bring_up_online_site(const Workspace &workspace) {
    if (fs::exists(workspace.root / handout_mark))
        throw UserError{
            "a handout has no solutions, which the edition to write in is made with: your instructor can make "
            "one for you: ./course export handout dist --online"};
    build_online(workspace, "online");
    return workspace.build / "online" / "site";
}

fs::path online_handout(const Workspace &workspace) { return workspace.build / "online" / "handout"; }

fs::path bring_up_online_handout(const Workspace &workspace) {
    build_online(workspace, "online-handout");
    return workspace.build / "online" / "handout_site";
}

} // namespace course
