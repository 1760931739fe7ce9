// `course site` and `course open`; and, for the build alone, `course make-site`.

#include "commands/commands.hpp"
#include "ground/lock.hpp"
#include "loop/programs.hpp"
#include "site/addresses.hpp"
#include "site/build.hpp"

#include <iostream>
#include <memory>

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

fs::path page(const Tree &tree, const std::string &section) {
    const fs::path file = section.empty() ? tree.root / "book.md" : tree.chapter(tree.section(section));
    return site_folder(tree) / (page_name(tree, file) + ".html");
}

void open(const Tree &tree, const std::string &section) {
    const fs::path file = page(tree, section);
    bring_up_site(tree);
    std::cout << (show(file.string()) ? "Opening " : "Open this file in your browser: ") << file.string() << '\n';
}

void add_site_command(CLI::App &app, const Tree &tree) {
    CLI::App *command =
        app.add_subcommand("site", "Build the book as a site, to be read in a browser without a network");
    command->footer("Example: ./course site");
    command->callback([&tree] {
        bring_up_site(tree);
        std::cout << "The book is " << tree.shown(page(tree, ""))
                  << "\nType ./course open, or ./course open 7 for a section\n";
    });
}

void add_open_command(CLI::App &app, const Tree &tree) {
    const auto section = std::make_shared<std::string>();
    CLI::App *command = app.add_subcommand("open", "Open the book, or a chapter, in your browser");
    command->add_option("section", *section, "its number, name or file; the front page without it");
    command->footer("Example: ./course open 7");
    command->callback([&tree, section] { open(tree, *section); });
}

void add_make_command(CLI::App &app, const Tree &tree) {
    const auto tools = std::make_shared<SiteTools>();
    CLI::App *command = app.add_subcommand("make-site", "Make the site; the build knows with which tools")->group("");
    command->add_option("--doxygen", tools->doxygen)->required();
    command->add_option("--node", tools->node)->required();
    command->add_option("--katex", tools->katex)->required();
    command->add_option("--lunr", tools->lunr)->required();
    command->callback([&tree, tools] { build_site(tree, *tools); });
}

} // namespace

void add_site(CLI::App &app, const Tree &tree) {
    add_site_command(app, tree);
    add_open_command(app, tree);
    add_make_command(app, tree);
}

} // namespace course
