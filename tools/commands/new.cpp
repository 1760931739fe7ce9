// `course dev new`: a section's files from tools/skeleton/, a line in CMakeLists.txt, a row and terms in book.md.

#include "base/files.hpp"
#include "base/lock.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "book/contents.hpp"
#include "book/glossary.hpp"
#include "commands/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <regex>

namespace course {
namespace fs = std::filesystem;
namespace {

/// What C++ or a library calls something else already; a section's name becomes a namespace.
constexpr std::string_view taken =
    " alignas alignof and asm auto bitand bitor bool break case catch char class compl concept const continue decltype"
    " default delete do double else enum explicit export extern false float for friend goto if inline int long mutable"
    " namespace new noexcept not nullptr operator or private protected public register requires return short signed"
    " sizeof static struct switch template this throw true try typedef typeid typename union unsigned using virtual"
    " void volatile while xor course std subject pull abs clock div drem exp fork gamma index link log pause pipe pow"
    " rand random read remainder remove rename round select signal sleep time wait write ";

/// "13_springs"; says the right form of anything else.
void require_well_formed(const std::string &name) {
    static const std::regex form{R"(\d\d_[a-z][a-z0-9]*(_[a-z0-9]+)*)"}, nearly{R"((\d{1,2})[ _.-]*([a-z].*))"};
    if (std::regex_match(name, form)) {
        const std::string slug = name.substr(3);
        if (contains(taken, ' ' + slug + ' '))
            throw UserError{
                "`" + slug
                + "` is a word of C++ or of a library already, and the name becomes a namespace; add a word to it, as "
                + name + "_chapter"};
        if (name.starts_with("00")) throw UserError{"sections are counted from 01, so there is no " + name};
        return;
    }
    std::string better;
    if (std::smatch match; better = lower(name), std::regex_match(better, match, nearly)) {
        better = std::string(2 - match[1].str().size(), '0') + match[1].str() + "_"
                 + std::regex_replace(match[2].str(), std::regex{"[^a-z0-9]+"}, "_");
    }
    const std::string offer = std::regex_match(better, form) ? better : "13_springs";
    throw UserError{"`" + name
                    + "` is not the name of a section: that is two digits, an underscore, and small letters, as in "
                    + offer};
}

void require_new(const Workspace &workspace, const Section &section) {
    int next = 1;
    for (const Section &other : workspace.sections()) next = std::max(next, other.number() + 1);
    const std::string free = next < 100 ? "; the next free number is " + std::to_string(next) : "";
    for (const Section &other : workspace.sections()) {
        if (other.number() == section.number())
            throw UserError{"section " + section.short_number() + " is there already: " + other.name + free};
        if (other.slug() == section.slug())
            throw UserError{"there is a section of that name already: " + other.name + "; choose another name"};
    }
}

/// The skeleton is written as section 99, "Skeleton": these become the new one's number, name and title.
std::string renamed(const std::string &text, const Section &section, const std::string &title) {
    static const std::regex own{R"(99_skeleton|\b99\b|skeleton|Skeleton)"};
    const std::map<std::string, std::string> becomes{{"99_skeleton", section.name},
                                                     {"99", section.short_number()},
                                                     {"skeleton", section.slug()},
                                                     {"Skeleton", title}};
    std::string result;
    auto rest = text.begin();
    for (std::sregex_iterator match{text.begin(), text.end(), own}, end; match != end; ++match) {
        result.append(rest, text.begin() + match->position()).append(becomes.at(match->str()));
        rest = text.begin() + match->position() + match->length();
    }
    return result.append(rest, text.end());
}

/// Every file of the new section, and what it holds.
std::map<fs::path, std::string> files_of(const Workspace &workspace, const Section &section, const std::string &title) {
    const fs::path skeleton = workspace.root / "tools" / "skeleton";
    std::map<fs::path, std::string> files;
    for (const auto &entry : fs::recursive_directory_iterator{skeleton}) {
        if (!entry.is_regular_file()) continue;
        const fs::path inside = entry.path().lexically_relative(skeleton);
        const bool published = inside.extension() == ".svg" || inside.extension() == ".tsv"; // numbers, 99 among them
        const std::string text = read_file(entry.path());
        files[workspace.root / renamed(inside.generic_string(), section, title)] =
            published ? text : renamed(text, section, title);
    }
    files[workspace.stub(section)] = files.at(workspace.exercise(section)); // the empty one, for `reset`
    return files;
}

std::string default_title(const Section &section) {
    std::string title = section.slug();
    std::ranges::replace(title, '_', ' ');
    return with_capital(title);
}

/// Writes every file, and lists the section; if one can't be written, what this call wrote goes again.
void write_all(const Workspace &workspace, const Section &section, const std::map<fs::path, std::string> &files,
               const std::string &contents) {
    const SignalBlocker all_or_none;
    const fs::path list = workspace.root / "CMakeLists.txt", book = workspace.root / "book.md",
                   chapter = workspace.chapter(section);
    const std::string old_list = read_file(list), old_book = read_file(book);
    std::vector<fs::path> written; // in order, each folder before what's in it
    const auto note_folders = [&](const fs::path &file) {
        std::vector<fs::path> missing;
        for (fs::path up = file.parent_path(); !fs::exists(up); up = up.parent_path()) missing.push_back(up);
        written.insert(written.end(), missing.rbegin(), missing.rend());
    };
    try {
        for (const auto &[file, text] : files) {
            note_folders(file);
            written.push_back(file);
            write_file(file, text);
        }
        std::vector<Term> terms = terms_of(workspace);
        for (Term &term : terms_of(files.at(chapter), section.number(), workspace.relative_name(chapter), chapter))
            terms.push_back(std::move(term));
        std::ranges::stable_sort(terms, {}, &Term::section);
        write_file(book, weave_glossary(contents, book, terms).book);
        write_file(list, with_section(old_list, section));
    } catch (...) {
        for (; !written.empty(); written.pop_back()) {
            std::error_code ignored;
            fs::remove(written.back(), ignored);
        }
        if (read_file(book) != old_book) write_file(book, old_book);
        throw;
    }
}

void make(const Workspace &workspace, const std::string &name, std::string title) {
    const UniqueFd alone = short_lock(workspace.memory() / "lock");
    require_well_formed(name);
    const Section section{name};
    require_new(workspace, section);
    const fs::path list = workspace.root / "CMakeLists.txt", book = workspace.root / "book.md";
    const std::string old_contents = read_file(book);
    if (title.empty()) title = title_to_come(old_contents, section.number());
    if (title.empty()) title = default_title(section);
    if (title.find_first_of("\r\n\\|[]") != std::string::npos)
        throw UserError{"a title is one line without any of \\ | [ ], as in --title \"" + default_title(section)
                        + "\""};

    std::map<fs::path, std::string> files = files_of(workspace, section, title);
    for (const auto &[file, text] : files)
        if (fs::exists(fs::symlink_status(file)))
            throw UserError{workspace.relative_name(file)
                            + " is there already, and nothing is overwritten: move it away, or choose another name"};
    with_section(read_file(list), section); // says so if there is no place for it
    const std::string contents = with_entry(old_contents, section, title);

    write_all(workspace, section, files, contents);
    for (const auto &[file, text] : files) std::cout << "  " << workspace.relative_name(file) << '\n';
    const std::string number = section.short_number();
    std::cout << "These files make a section that builds and is tested; write yours over them, test by test.\n"
              << "It has its line in CMakeLists.txt, and its row and its terms in book.md.\n\n"
              << "Next:\n";
    const std::pair<std::string, const char *> next[] = {
        {"./course", "builds it"},
        {"./course check " + number, "says \"not started\""},
        {"./course dev weave " + number, "brings its chapter up to date when you have changed its code"},
        {"./course dev publish " + number, "does so with its figures"}};
    for (const auto &[command, does] : next) std::cout << fmt::format("  {:<24} {}\n", command, does);
}

} // namespace

void add_new(CLI::App &app, const Workspace &workspace) {
    const auto name = std::make_shared<std::string>(), title = std::make_shared<std::string>();
    CLI::App *command = app.add_subcommand("new", "Write the skeleton of a new section");
    command->add_option("name", *name, "two digits and a name, which becomes a C++ namespace")->required();
    command->add_option(
        "--title", *title,
        "of the chapter; if it is not given, book.md's of a section to come, or one made from the name");
    command->footer("Nothing that exists is overwritten.\n\nExample: ./course dev new 13_springs --title \"Springs\"");
    command->callback([&workspace, name, title] { make(workspace, *name, *title); });
}

} // namespace course
