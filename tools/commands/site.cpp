// `course site` and `course open`; and, for the build alone, `course make-site`.

#include "commands/commands.hpp"
#include "ground/build.hpp"
#include "ground/lab.hpp"
#include "ground/lock.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"
#include "site/demos.hpp"
#include "site/own_site.hpp"
#include "site/progress_script.hpp"

#include <iostream>

namespace course {
namespace fs = std::filesystem;

void bring_up_site(const Tree &tree) {
    const Lock lock{tree};
    const Finished built = build_target(tree, "site");
    if (built.code == 0) return;
    const std::string printed = built.out + built.err;
    const auto said = printed.find("course: ");
    throw Complaint{said == printed.npos
                        ? "the site cannot be built; see cmake --build " + tree.build.string() + " --target site"
                        : printed.substr(said + 8, printed.find("\nninja: ", said) - said - 8)};
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

constexpr const char *about_mine = R"(
With --mine it is your own copy: in each section that you have begun, figures show your curve over ours, and demos
begin with your code. What cannot be built stays ours, and one sentence says why. The copy lies in the build folder
beside the plain site; nothing publishes it.

Example: )";

/// Brings the student's own copy up to date, and says what is theirs in it.
void bring_up_own_site(const Tree &tree) {
    {
        const Lock lock{tree};
        for (const Section &section : tree.sections())
            std::cout << "Section " << section.short_number() << ": " << renew_own_section(tree, section) << std::endl;
    }
    if (!can_compile_demos(tree) && !demos(tree).empty())
        std::cout << "The demos run on our code, since this machine has no compiler for pages; ./course play "
                  << demos(tree).front().section.short_number() << " --mine offers to install one\n";
    copy_own_site(tree);
}

/// Makes the site, or the student's own copy of it; returns its folder.
fs::path bring_up(const Tree &tree, bool mine) {
    if (mine) require_own_course(tree);
    bring_up_site(tree);
    if (mine) bring_up_own_site(tree);
    tell_pages(tree);
    return mine ? own_site_folder(tree) : site_folder(tree);
}

void open_file(const fs::path &file) {
    std::cout << (show(file) ? "Opening " : "Open this file in your browser: ") << file.string() << '\n';
}

void open(const Tree &tree, const std::string &section, bool mine) {
    if (const fs::path report = fs::path{section} / "report.html"; !section.empty() && fs::exists(report))
        return open_file(fs::absolute(report));
    const fs::path chapter = section.empty() ? tree.root / "book.md" : tree.chapter(tree.section(section));
    open_file(bring_up(tree, mine) / (page_name(tree, chapter) + ".html"));
}

} // namespace

void add_site(CLI::App &app, const Tree &tree) {
    const auto mine = std::make_shared<bool>(false);
    CLI::App *command =
        app.add_subcommand("site", "Build the book as a site, to be read in a browser without a network");
    command->add_flag("--mine", *mine, "your own copy: your figures, your code in the demos");
    command->footer(std::string{about_mine} + "./course site");
    command->callback([&tree, mine] {
        const std::string option = *mine ? " --mine" : "";
        const fs::path folder = bring_up(tree, *mine); // which says something, too
        std::cout << (*mine ? "Your copy of the book is " : "The book is ") << tree.shown(folder / "index.html")
                  << "\nType ./course open" << option << ", or ./course open 7" << option << " for a section\n";
    });
}

void add_open(CLI::App &app, const Tree &tree) {
    const auto section = std::make_shared<std::string>();
    const auto mine = std::make_shared<bool>(false);
    CLI::App *command = app.add_subcommand("open", "Open the book, or a chapter, in your browser");
    command->add_option("section", *section,
                        "its number, name or file, or a folder of `grade`; the front page without it");
    command->add_flag("--mine", *mine, "your own copy: your figures, your code in the demos");
    command->footer(std::string{about_mine} + "./course open 7");
    command->callback([&tree, section, mine] { open(tree, *section, *mine); });
}

void add_make(CLI::App &app, const Tree &tree) {
    const auto tools = std::make_shared<SiteTools>();
    CLI::App *command = app.add_subcommand("make-site", "Make the site; the build knows with which tools")->group("");
    command->add_option("--doxygen", tools->doxygen)->required();
    command->add_option("--node", tools->node)->required();
    command->add_option("--katex", tools->katex)->required();
    command->add_option("--lunr", tools->lunr)->required();
    command->callback([&tree, tools] { build_site(tree, *tools); });
}

} // namespace course
