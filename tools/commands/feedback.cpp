// `course feedback`: how it went, as a file that a reader may send.

#include "check/feedback.hpp"
#include "base/files.hpp"
#include "check/junit.hpp"
#include "commands/commands.hpp"

#include <iostream>

namespace course {
namespace {

namespace fs = std::filesystem;

void write_feedback(const Workspace &workspace, const fs::path &file) {
    const std::vector<Attempt> attempts = recall_attempts(workspace);
    if (attempts.empty()) throw UserError{"there's nothing to tell yet: ./course check comes first"};
    const std::string text = feedback(attempts, open_rungs(workspace), course_version());
    write_file(file, text);
    std::cout
        << text << "\nWritten: " << file.string()
        << ". It's yours: nothing is sent. If you like, attach it to an issue, with what you'd have wished for.\n";
}

} // namespace

void add_feedback(CLI::App &app, const Workspace &workspace) {
    const auto file = std::make_shared<std::string>("feedback.txt");
    CLI::App *command =
        app.add_subcommand("feedback", "Write down how it went: checks, minutes and mistakes; no code, and no name");
    command->add_option("-o,--out", *file, "where to; otherwise feedback.txt")->type_name("FILE");
    command->footer(
        "Example: ./course feedback\nThe file is plain text, for you to read before you send it to anybody.");
    command->callback([&workspace, file] { write_feedback(workspace, *file); });
}

} // namespace course
