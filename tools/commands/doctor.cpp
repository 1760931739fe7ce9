// What `course doctor` cannot find out as a script: the script asks here, once this program is built.

#include "commands/commands.hpp"
#include "loop/toolbox.hpp"
#include "verdict/tests/shut_in.hpp"

#include <iostream>

namespace course {
namespace {

void tell(const Tree &tree) {
    const Protection here = protection_of_this_kernel();
    std::cout << "protection      ";
    if (here.files && here.calls)
        std::cout << "Landlock and seccomp keep code that is judged from your files, other programs and the network\n";
    else
        std::cout << "this kernel lacks " << (here.files ? "" : "Landlock") << (here.files || here.calls ? "" : " and ")
                  << (here.calls ? "" : "seccomp") << ": judge only code that you trust\n";
    std::cout << "check           "
              << (toolbox(tree, tree.sections().front()).quick
                      ? "Clang compiles your answers; GCC those with a mistake, for its messages\n"
                      : "one compiler compiles your answers; on Linux, Clang beside GCC would halve the time\n");
}

} // namespace

void add_doctor(CLI::App &app, const Tree &tree) {
    app.add_subcommand("doctor", "Say which tools are installed, and how to get the others")
        ->callback([&tree] { tell(tree); })
        ->footer("Example: ./course doctor");
}

} // namespace course
