// The `course` program: finds the course, lets each command add itself, and reports every error in one sentence.

#include "base/files.hpp"
#include "base/kernel.hpp"
#include "base/nearest.hpp"
#include "base/plain.hpp"
#include "base/process.hpp"
#include "book/contents.hpp"
#include "commands/commands.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace course {
namespace {

/// What the `course` script does itself, before this program is there: listed here for help and for slips of the pen.
auto by_the_script(const std::string &name, const std::string &what) {
    return [=](CLI::App &app, const Workspace &) {
        app.add_subcommand(name, what)->footer("Example: ./course " + name)->callback([name] {
            throw UserError{"`" + name + "` is a command of the script: type ./course " + name};
        });
    };
}

/// What only authors of sections type.
void add_dev(CLI::App &app, const Workspace &workspace) {
    CLI::App *dev = app.add_subcommand("dev", "List what only authors of sections need, as ./course dev weave");
    dev->require_subcommand(0, 1)->footer("Example: ./course dev weave 7");
    for (const auto &add : {add_new, add_weave, add_publish, add_release, add_bench}) add(*dev, workspace);
    dev->callback([&app, dev] {
        if (dev->get_subcommands().empty()) std::cout << app.help(); // of the command that was typed
    });
}

struct Group {
    const char *title; ///< "" for commands that only the build types
    std::vector<std::function<void(CLI::App &, const Workspace &)>> commands;
};

const std::vector<Group> groups{
    {"For students",
     {add_check, add_list, add_hint, add_solution, add_reset, add_run, add_plot, add_play, add_sketch, add_debug,
      add_bug, add_mytests, add_feedback, add_site, add_open,
      by_the_script("setup", "Install what the course needs; asks first"), add_update, add_doctor}},
    {"For instructors", {add_grade, add_export, by_the_script("test", "Run the whole test suite")}},
    {"For authors", {add_dev}},
    {"", {add_make, add_draw}},
};

constexpr const char *description = R"(Frame by Frame, a course in game physics.
`./course` alone installs what is missing, builds everything, draws the figures and checks the book.)";

constexpr const char *footer =
    R"(A section is named by its number, a part of its name, or one of its files: 7, segment, exercises/07_segment_intersection.cpp.

Exit codes:
  0    all is well
  1    something is left to do: a test is not passed, a check found a difference
  2    the command or a file: the message says what to do
  3    the course itself is at fault: please report it
  4    the machine got in the way (a full disk, no memory, a program killed from outside): nothing was judged
  130  stopped by Ctrl-C

Example: ./course check 7 --watch)";

void add_commands(CLI::App &app, const Workspace &workspace) {
    for (const Group &group : groups)
        for (const auto &add : group.commands) {
            const auto before = app.get_subcommands({}).size();
            add(app, workspace);
            const auto all = app.get_subcommands({});
            for (std::size_t i = before; i < all.size(); ++i) all[i]->group(group.title);
        }
}

std::filesystem::path folder(const char *variable, const char *built_with) {
    const char *value = std::getenv(variable);
    const std::filesystem::path path = value && *value ? value : built_with;
    return path.empty() ? path : std::filesystem::absolute(path).lexically_normal();
}

Workspace find_workspace() {
    const Workspace workspace{.root = folder("COURSE_ROOT", COURSE_DEFAULT_ROOT),
                              .build = folder("COURSE_BUILD", COURSE_DEFAULT_BUILD)};
    if (std::filesystem::exists(workspace.root / "CMakeLists.txt")) return workspace;
    throw UserError{"the course is not in " + workspace.root.string()
                    + "; has it been moved? Run the script ./course in its new place"};
}

/// The command that was typed, as `dev weave` is one, or the whole program.
const CLI::App &typed(const CLI::App &app) {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? app : typed(*chosen.front());
}

/// How it's typed.
std::string full_name(const CLI::App &command) {
    const CLI::App *parent = command.get_parent();
    return parent ? full_name(*parent) + ' ' + command.get_name() : command.get_name();
}

std::vector<std::string> names(const CLI::App &app, bool options) {
    std::vector<std::string> result;
    if (options)
        for (const CLI::Option *option : app.get_options([](const CLI::Option *o) { return o->nonpositional(); }))
            for (const std::string &name : option->get_lnames()) result.push_back("--" + name);
    else
        for (const CLI::App *command : app.get_subcommands({})) result.push_back(command->get_name());
    return result;
}

bool is_command(const CLI::App &app, const std::string &word) {
    return std::ranges::count(names(app, false), word) > 0;
}

/// Before a --help behind a wrong word is obeyed.
/// @param words  reversed
void require_known_commands(const CLI::App &app, std::vector<std::string> words) {
    if (words.empty() || words.back().starts_with('-')) return;
    const std::string word = words.back();
    if (is_command(app, word)) {
        words.pop_back();
        if (word == "dev") require_known_commands(*app.get_subcommand(word), words);
        return;
    }
    if (app.get_name() != "dev" && is_command(*app.get_subcommand("dev"), word))
        throw UserError{"`" + word + "` is a command for authors: type ./course dev " + word};
    throw UserError{"there is no command `" + word + "`." + did_you_mean(word, names(app, false)) + " See "
                    + full_name(app) + " --help"};
}

/// One sentence about a command line that cannot be understood.
std::string misunderstood(const CLI::App &app, const CLI::ParseError &error) {
    const CLI::App &command = typed(app);
    const bool whole = &command == &app;
    const std::string help = full_name(command) + " --help";
    const std::vector<std::string> unknown = app.remaining(true);
    if (!dynamic_cast<const CLI::ExtrasError *>(&error) || unknown.empty())
        return std::string{error.what()} + "; see " + help;

    const std::string &word = unknown.front();
    if (word.starts_with("-")) {
        const std::string of = whole ? "`course`" : "`" + command.get_name() + "`";
        return of + " has no option `" + word + "`."
               + did_you_mean(word.substr(0, word.find('=')), names(command, true)) + " See " + help;
    }
    return "`" + command.get_name() + "` does not know what to do with `" + word + "`; see " + help;
}

/// `./course -v check 7` means `./course check 7 -v`. Reversed, as CLI11 wants them.
std::vector<std::string> options_behind_the_command(std::vector<std::string> words) {
    const auto command = std::ranges::find_if(words, [](const std::string &word) { return !word.starts_with('-'); });
    if (command != words.end()) std::rotate(words.begin(), command, words.end());
    std::ranges::reverse(words);
    return words;
}

int run_cli(int argc, char **argv) {
    const Workspace workspace = find_workspace();
    CLI::App app{description, "./course"};
    app.require_subcommand(0, 1)->failure_message(nullptr);
    app.set_help_flag("-h,--help", "Print this help");
    app.set_version_flag("--version", "Frame by Frame " COURSE_VERSION, "Print which version of the course this is");
    add_commands(app, workspace);
    app.footer(footer); // last: a command would inherit it
    std::vector<std::string> words = options_behind_the_command({argv + 1, argv + argc}); // the command is last
    try {
        require_known_commands(app, words);
        app.parse(words);
        if (app.get_subcommands().empty()) std::cout << app.help();
    } catch (const CLI::Success &help) {
        app.exit(help);
    } catch (const CLI::ParseError &error) {
        throw UserError{misunderstood(app, error)};
    }
    if (!std::cout.flush()) throw EnvironmentError{"cannot write the output; is the disk full?"};
    return all_well;
}

/// A section that is not there may be one that book.md has to come.
std::string explained(const UnknownSection &unknown) {
    const std::filesystem::path book = find_workspace().root / "book.md";
    const std::string title = std::filesystem::exists(book) ? title_to_come(read_file(book), unknown.number) : "";
    if (title.empty()) return unknown.what();
    return "section " + std::to_string(unknown.number) + ", " + title
           + ", is still to come; `./course list` shows those that are here";
}

int complain(const std::string &sentence, int code) {
    std::cout.flush();
    std::cerr << sanitize("course: " + sentence); // a file's name or a word that was typed may hold escape codes
    return code;
}

} // namespace
} // namespace course

int main(int argc, char **argv) {
    using namespace course;
    hide_from_other_processes();
    catch_signals();
    try {
        return run_cli(argc, argv);
    } catch (const ExitRequest &leave) {
        std::cout.flush();
        return leave.code;
    } catch (const Interrupted &stop) {
        return 128 + stop.signal;
    } catch (const UnknownSection &unknown) {
        return complain(explained(unknown), bad_input);
    } catch (const EnvironmentError &trouble) {
        return complain(trouble.what(), machine_trouble);
    } catch (const UserError &complaint) {
        return complain(complaint.what(), bad_input);
    } catch (const std::filesystem::filesystem_error &error) {
        if (error.code() == std::errc::no_space_on_device)
            return complain("the disk is full; make some room and try again", machine_trouble);
        const std::string where = error.path1().empty() ? "a file" : error.path1().string();
        return complain(where + ": " + error.code().message() + "; is it there, and yours to read and write?",
                        bad_input);
    } catch (const std::exception &error) {
        return complain(std::string{"the course itself is at fault ("} + error.what()
                            + "); please report it, with the command that you typed",
                        our_fault);
    } catch (...) {
        return complain("the course itself is at fault; please report it, with the command that you typed", our_fault);
    }
}
