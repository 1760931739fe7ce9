// What `course doctor` cannot find out as a script: the script asks here, once this program is built.

#include "check/build_config.hpp"
#include "commands/commands.hpp"
#include "judge/runner/student_process.hpp"

#include <iostream>

namespace course {
namespace {

/// What keeps code that's judged from what, layer by layer.
void tell_layers() {
    const int version = landlock_version();
    const bool filters = protection_of_this_kernel().calls;
    std::cout << "Landlock        ";
    if (version == 0) std::cout << "not in this kernel: code that you judge can read, change and delete your files\n";
    else
        std::cout << "version " << version << ": code that you judge opens no file but its own"
                  << (version >= 6   ? ", and signals no other process"
                      : version >= 3 ? "; signals are left to seccomp"
                                     : "; signals and emptying files are left to seccomp")
                  << '\n';
    std::cout << "seccomp         "
              << (filters ? "code that you judge starts no process or thread, and doesn't reach the network\n"
                          : "not in this kernel: code that you judge can start processes, change the modes of your "
                            "files, and use the network\n")
              << "limits          " << (memory_limit >> 20) << " MB of memory and " << (print_limit >> 20)
              << " MB of output for code that you judge, and its own processor time\n";
}

void tell(const Workspace &workspace) {
    tell_layers();
    std::cout << "check           "
              << (build_config(workspace, workspace.sections().front()).quick
                      ? "Clang compiles your answers; GCC those with a mistake, for its messages\n"
                      : "one compiler compiles your answers; on Linux, Clang beside GCC would halve the time\n");
}

} // namespace

void add_doctor(CLI::App &app, const Workspace &workspace) {
    app.add_subcommand("doctor", "Say which tools are installed, and how to get the others")
        ->callback([&workspace] { tell(workspace); })
        ->footer("Example: ./course doctor");
}

} // namespace course
