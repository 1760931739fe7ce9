// What `course play` and `course sketch` need to show a reader's code in a page: a compiler, and a browser.

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/terminal.hpp"
#include "commands/commands.hpp"
#include "site/own_site.hpp"

#include <fmt/ranges.h> // join
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;
namespace {

/// "need to get 3,391 kB, 17.3 MB on the disk", as apt-get counts it; "" if it does not say.
std::string sizes(const std::string &printed) {
    static const std::regex get{R"(Need to get (?:[^/\n]*/)?([0-9.,]+ [kMG]?B) of)"},
        use{R"(operation, ([0-9.,]+ [kMG]?B) of additional)"};
    std::smatch download, disk;
    if (!std::regex_search(printed, download, get) || !std::regex_search(printed, disk, use)) return "";
    return " (" + download[1].str() + " to download, " + disk[1].str() + " on the disk)";
}

} // namespace

void need_page_compiler(const Workspace &workspace, bool yes) {
    if (can_compile_demos(workspace)) return;
    run({"cmake", workspace.build.string()}); // it may have been installed since
    if (can_compile_demos(workspace)) return;
    std::ifstream list{workspace.root / "tools" / "setup" / "needs_of_pages"};
    const std::vector<std::string> packages{std::istream_iterator<std::string>{list}, {}};
    std::vector<std::string> command{"apt-get", "install", "--no-install-recommends"};
    command.insert(command.end(), packages.begin(), packages.end());
    const std::string why = "a browser runs your functions as WebAssembly, and this machine has no compiler for that";
    std::vector<std::string> trial = command;
    trial.push_back("--assume-no");
    const std::string printed = in_path("apt-get") ? run(trial).out : "";
    if (sizes(printed).empty())
        throw UserError{why
                        + "; it is Clang 19 with the packages wasi-libc and libc++-19-dev-wasm32 of Debian 12, "
                          "which are not to be had here. Without --mine the demo runs on ours"};
    if (::geteuid() != 0) command.insert(command.begin(), "sudo");
    std::cout << "To play with your code: " << why << ".\nDebian has one" << sizes(printed) << ":\n  "
              << fmt::format("{}", fmt::join(command, " ")) << '\n'
              << std::flush;
    if (!yes && !(can_ask() && ask("Install it now?")))
        throw UserError{"nothing was installed; type the line above, then ./course play again. Without --mine the demo "
                        "runs on ours"};
    command.push_back("--yes");
    if (run(command, {.quiet = false}).code != 0) throw UserError{"apt-get could not install it; it says why above"};
    run({"cmake", workspace.build.string()});
    if (!can_compile_demos(workspace))
        throw UserError{"the compiler for WebAssembly is installed, but does not work; please report what "
                        "clang++-19 --target=wasm32-wasi --version prints"};
}

void open_page(const fs::path &address) {
    std::cout << (show(address.string()) ? "Opening " : "Open this address in your browser: ") << "file://"
              << address.string() << '\n';
}

} // namespace course
