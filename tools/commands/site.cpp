// `course site` and `course open`; and, for the build alone, `course make-site`.

#include "base/build.hpp"
#include "base/lock.hpp"
#include "commands/commands.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"
#include "site/demos.hpp"
#include "site/own_site.hpp"
#include "site/progress_script.hpp"

#include <iostream>

namespace course {
namespace fs = std::filesystem;

void bring_up_site(const Workspace &workspace) {
    const Lock lock{workspace};
    const Finished built = build_target(workspace, "site");
    if (built.code == 0) return;
    const std::string printed = built.out + built.err;
    const auto start = printed.find("course: ");
    throw UserError{start == printed.npos
                        ? "the site cannot be built; see cmake --build " + workspace.build.string() + " --target site"
                        : printed.substr(start + 8, printed.find("\nninja: ", start) - start - 8)};
}

bool show(const std::string &address) {
    static constexpr const char *script = R"sh(
if command -v open && [ "$(uname)" = Darwin ]; then opener=open
elif command -v xdg-open && [ "${DISPLAY-}${WAYLAND_DISPLAY-}" ]; then opener=xdg-open
elif command -v wslview; then opener=wslview
else exit 1
fi
"$opener" "$1" </dev/null >/dev/null 2>&1 &)sh";
    return run({"sh", "-c", script, "sh", address}).code == 0;
}

namespace {

constexpr const char *about_online = R"(
With --online it is a folder for a web server. Whoever reads it there needs nothing else: each exercise has an editor, and
the same tests answer in the page.
)";

constexpr const char *about_mine = R"(
With --mine it is your own copy: in each section that you have begun, figures show your curve over ours, and demos
begin with your code. What cannot be built stays ours, and one sentence says why. The copy lies in the build folder
beside the plain site; nothing publishes it.

Example: )";

/// Brings the student's own copy up to date, and says what is theirs in it.
void bring_up_own_site(const Workspace &workspace) {
    {
        const Lock lock{workspace};
        for (const Section &section : workspace.sections())
            std::cout << "Section " << section.short_number() << ": " << renew_own_section(workspace, section)
                      << std::endl;
    }
    if (!can_compile_demos(workspace) && !demos(workspace).empty())
        std::cout << "The demos run on our code, since this machine has no compiler for pages; ./course play "
                  << demos(workspace).front().section.short_number() << " --mine offers to install one\n";
    copy_own_site(workspace);
}

/// Makes the site, or the student's own copy of it; returns its folder.
fs::path bring_up(const Workspace &workspace, bool mine) {
    bring_up_site(workspace);
    if (mine) bring_up_own_site(workspace);
    write_progress_script(workspace);
    return mine ? own_site_folder(workspace) : site_folder(workspace);
}

void open_file(const fs::path &file) {
    std::cout << (show(file) ? "Opening " : "Open this file in your browser: ") << file.string() << '\n';
}

void open(const Workspace &workspace, const std::string &section, bool mine) {
    if (const fs::path report = fs::path{section} / "report.html"; !section.empty() && fs::exists(report))
        return open_file(fs::absolute(report));
    const fs::path chapter =
        section.empty() ? workspace.root / "book.md" : workspace.chapter(workspace.section(section));
    open_file(bring_up(workspace, mine) / (page_name(workspace, chapter) + ".html"));
}

} // namespace

void add_site(CLI::App &app, const Workspace &workspace) {
    const auto mine = std::make_shared<bool>(false), online = std::make_shared<bool>(false);
    CLI::App *command =
        app.add_subcommand("site", "Build the book as a site, to be read in a browser without a network");
    CLI::Option *own = command->add_flag("--mine", *mine, "your own copy: your figures, your code in the demos");
    command->add_flag("--online", *online, "for a web server: a site in which one can write and check answers")
        ->excludes(own);
    command->footer(std::string{about_online} + about_mine + "./course site");
    command->callback([&workspace, mine, online] {
        if (*online) {
            const std::string folder = workspace.relative_name(bring_up_online_site(workspace));
            std::cout << "The book to write in is " << folder
                      << ": any web server can show it. Here:\n  python3 -m http.server --directory " << folder
                      << "\nand then http://localhost:8000\n";
            return;
        }
        const std::string option = *mine ? " --mine" : "";
        const fs::path folder = bring_up(workspace, *mine); // which says something, too
        std::cout << (*mine ? "Your copy of the book is " : "The book is ")
                  << workspace.relative_name(folder / "index.html") << "\nType ./course open" << option
                  << ", or ./course open 7" << option << " for a section\n";
    });
}

void add_open(CLI::App &app, const Workspace &workspace) {
    const auto section = std::make_shared<std::string>();
    const auto mine = std::make_shared<bool>(false);
    CLI::App *command = app.add_subcommand("open", "Open the book, or a chapter, in your browser");
    command->add_option("section", *section,
                        "its number, name or file, or a folder of `grade`; the front page without it");
    command->add_flag("--mine", *mine, "your own copy: your figures, your code in the demos");
    command->footer(std::string{about_mine} + "./course open 7");
    command->callback([&workspace, section, mine] { open(workspace, *section, *mine); });
}

void add_make(CLI::App &app, const Workspace &workspace) {
    const auto tools = std::make_shared<SiteTools>();
    CLI::App *command = app.add_subcommand("make-site", "Make the site; the build knows with which tools")->group("");
    command->add_option("--doxygen", tools->doxygen)->required();
    command->add_option("--node", tools->node)->required();
    command->add_option("--katex", tools->katex)->required();
    command->add_option("--lunr", tools->lunr)->required();
    command->callback([&workspace, tools] { build_site(workspace, *tools); });
}

} // namespace course
