#pragma once
// The commands of `course`, one file each. Every one adds itself: name, help with an example, options, what it does.
// A command ends with an exit code by throwing `ExitRequest`; if it returns, all is well.

#include "base/errors.hpp"
#include "base/workspace.hpp"

#include <CLI/CLI.hpp>

namespace course {

/// Ends the program with this exit code, when all is printed.
struct ExitRequest {
    int code;
};

/// Brings the site up to date by the build; site.cpp has it.
void bring_up_site(const Workspace &workspace);
/// The same for the edition to write in, with what that needs from npm; online.cpp has it.
/// @return its folder
std::filesystem::path bring_up_online_site(const Workspace &workspace);

/// And for the handout in that folder, which is made before; online.cpp, too. Returns the site's folder.
std::filesystem::path bring_up_online_handout(const Workspace &workspace);
std::filesystem::path online_handout(const Workspace &workspace);

/// Draws the figures of all sections, and throws `ExitRequest` unless what's published agrees; publish.cpp has it.
void require_published(const Workspace &workspace);

/// Makes the archives of a release in the build folder, of what is committed; release.cpp has it.
void release(const Workspace &workspace, bool online); ///< `online`: with the site to write in

/// What `check --file` says of one exercise in a file, but not which mistake gives the same; check.cpp has it.
/// @return the exit code
int check_file(const Workspace &workspace, const std::string &exercise, const std::filesystem::path &file);

/// How each of the reader's sketches is shown, a line for each. @return whether there are any
bool print_sketches(const Workspace &workspace);
/// What a sketch of this name begins with; sketch.cpp has both.
std::string first_sketch(const std::string &name);

/// For a seed of generated values, as `check` and `grade` take one; check.cpp has it.
CLI::Validator is_seed();

/// Hands a file, or a place in one ("page.html#here"), to whatever program is meant for it.
/// @return whether there is one, and a screen to show it on
bool show(const std::string &address);
/// The same for a page, and says so; page.cpp has both.
void open_page(const std::filesystem::path &address);
/// Installs a compiler for pages if there's none; `yes`: without asking.
/// @throws UserError that says what to do, unless there is one in the end
void need_page_compiler(const Workspace &workspace, bool yes);

void add_check(CLI::App &app, const Workspace &workspace);
void add_feedback(CLI::App &app, const Workspace &workspace);
void add_weave(CLI::App &app, const Workspace &workspace);
void add_bug(CLI::App &app, const Workspace &workspace);
void add_list(CLI::App &app, const Workspace &workspace);
void add_mytests(CLI::App &app, const Workspace &workspace);
void add_grade(CLI::App &app, const Workspace &workspace);
void add_update(CLI::App &app, const Workspace &workspace);
void add_hint(CLI::App &app, const Workspace &workspace);
void add_solution(CLI::App &app, const Workspace &workspace);
void add_reset(CLI::App &app, const Workspace &workspace);
void add_run(CLI::App &app, const Workspace &workspace);
void add_plot(CLI::App &app, const Workspace &workspace);
void add_debug(CLI::App &app, const Workspace &workspace);
void add_new(CLI::App &app, const Workspace &workspace);
void add_doctor(CLI::App &app, const Workspace &workspace);
void add_export(CLI::App &app, const Workspace &workspace);
void add_draw(CLI::App &app, const Workspace &workspace);
void add_publish(CLI::App &app, const Workspace &workspace);
void add_release(CLI::App &app, const Workspace &workspace);
void add_bench(CLI::App &app, const Workspace &workspace);
void add_site(CLI::App &app, const Workspace &workspace);
void add_open(CLI::App &app, const Workspace &workspace);
void add_make(CLI::App &app, const Workspace &workspace);
void add_play(CLI::App &app, const Workspace &workspace);
void add_sketch(CLI::App &app, const Workspace &workspace);

} // namespace course
