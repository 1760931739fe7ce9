// course dev weave: brings the listings, outputs and glossary of the book up to date, or says where they are not.
#include "book/weaver.hpp"

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/lock.hpp"
#include "base/process.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "book/chapter.hpp"
#include "book/demo_places.hpp"
#include "book/front_door.hpp"
#include "book/glossary.hpp"
#include "book/links.hpp"
#include "book/prerequisites.hpp"
#include "check/programs.hpp"
#include "commands/commands.hpp"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <map>
#include <set>

namespace course {
namespace fs = std::filesystem;
namespace {

/// A program takes a tenth of a second of processor; the one that plays 200 matches takes 7, or 95 with sanitizers.
constexpr Limits program_limits{.processor_time = 300};
constexpr double longest_sleep = 1200; // [s] for one that waits: on a busy machine an honest one may take minutes

/// What the section's program, or one part of it, prints, if it is built from the code as it is now.
std::string output_of(const Workspace &workspace, const Section &section, const std::string &part) {
    const Lock no_build_meanwhile{workspace};
    const fs::path program = program_binary(workspace, section, Whose::reference);
    const std::string name = "the program of " + section.name;
    if (!fs::exists(program))
        throw UserError{name + " is not built, so its output cannot be woven; ./course builds it."};
    const fs::path game = workspace.program(section).parent_path() / "game.hpp"; // which the program may include
    for (const fs::path &code :
         {workspace.header(section), workspace.program(section), game, workspace.solution(section)})
        if (fs::exists(code) && fs::last_write_time(code) > fs::last_write_time(program))
            throw UserError{name + " is older than " + workspace.relative_name(code) + "; ./course rebuilds it."};

    const fs::path traces = workspace.build / "weave" / section.name;
    fs::create_directories(traces);
    const Finished finished = run(program_command(program, part, traces),
                                  {.deadline = longest_sleep, .folder = traces, .limits = program_limits});
    if (finished.timed_out || finished.code == 128 + SIGXCPU)
        throw UserError{name + " would not end, and was stopped; ./course run " + section.short_number()
                        + " runs it without weaving."};
    if (finished.code == unknown_part && !part.empty()) throw UserError{section.name + ": " + last_line(finished.err)};
    if (finished.code != 0)
        throw UserError{name + " stopped with exit code " + std::to_string(finished.code) + "; ./course run "
                        + section.short_number() + " shows what it says."};
    return finished.out;
}

/// The first line of a file that is not so in this text; nothing if there is none.
std::vector<Finding> difference(const fs::path &file, const std::string &before, const std::string &text) {
    const std::vector<Line> was = split_lines(before), is = split_lines(text);
    const auto [line, other] = std::ranges::mismatch(was, is, {}, &Line::text, &Line::text);
    if (line == was.end() && other == is.end()) return {};
    return {{file, static_cast<int>(line - was.begin()) + 1,
             "this line is not what the chapters' demos, bold terms and \"You need\", or the published book's address, "
             "make it; type ./course dev weave, or "
             "correct them."}};
}

class Command {
  public:
    Command(const Workspace &tree_, bool check_) : workspace{tree_}, check{check_} {}

    void section(const Section &section) {
        const fs::path file = workspace.chapter(section);
        const std::string text = read_file(file);
        const bool readable = page(page_of(workspace, section), text, weave_demo_places(workspace, section, text));
        if (check && readable) {
            add(missing_parts(workspace, section, text));
            measured.push_back(workspace.relative_name(file));
            add(misshapen_demos(text, file));
        }
        ++chapters;
    }

    /// The book's front page, with a glossary and contents that are woven from all chapters.
    void book() {
        const fs::path file = workspace.root / "book.md";
        if (!fs::exists(file)) return;
        const std::string text = read_file(file);
        if (broken) { // then terms cannot be read
            page(page_of_book(workspace), text, text);
            return;
        }
        const Glossary glossary = weave_glossary(text, file, terms_of(workspace));
        add(glossary.findings);
        const Needs needs = weave_needs(workspace, glossary.book);
        add(needs.findings);
        page(page_of_book(workspace), text, needs.book);
    }

    /// README's way to the book that's published, and the links of the pages beside it.
    void root() {
        if (const fs::path readme = workspace.root / "README.md"; fs::exists(readme)) {
            const std::string before = read_file(readme), text = with_front_door(before, address_of(workspace));
            if (check) add(difference(readme, before, text));
            else if (write_file(readme, text)) {
                changed = true;
                std::cout << "woven: README.md\n";
            }
        }
        if (!check) return;
        for (const fs::path &file : files_in(workspace.root, ".md"))
            if (file.filename() != "book.md") add(dead_links(file, read_file(file), workspace.root));
    }

    void finish() {
        std::ranges::sort(findings);
        for (const Finding &finding : findings)
            std::cout << workspace.relative_name(finding.file) << ':' << finding.line << ": " << finding.message
                      << '\n';
        const bool measured_well = measure();
        if (differs) tell_both_ways();
        if (!findings.empty() || !measured_well) throw ExitRequest{something_to};
        if (!changed)
            std::cout << pluralize(chapters, "chapter") << ", " << pluralize(listings, "listing") << ", "
                      << pluralize(outputs, "output") << ": as the code says\n";
    }

  private:
    /// Whether the chapters keep the voice and their budgets, as a script counts them.
    bool measure() const {
        const std::string script = "docs/voice.cjs";
        if (measured.empty() || !fs::exists(workspace.root / script)) return true;
        std::vector<std::string> command{"node", script};
        command.insert(command.end(), measured.begin(), measured.end());
        const Finished finished = run(command, {.folder = workspace.root});
        std::cout << finished.out << finished.err;
        return finished.code == 0;
    }

    /// The code may be right, or a student has only tried something in it.
    void tell_both_ways() const {
        std::string otherwise = changed_code.empty() ? "if the book is right, correct the code."
                                                     : "to bring back how it was, type git restore";
        for (const fs::path &file : changed_code) otherwise += ' ' + workspace.relative_name(file);
        std::cout << "To keep the code as it is now, type ./course dev weave, which writes it into the book; "
                  << otherwise << '\n';
    }

    void add(const std::vector<Finding> &more) { findings.insert(findings.end(), more.begin(), more.end()); }

    /// Whether the page could be read, with all fences.
    /// @param before  the page's file
    /// @param text    the same with demos, glossary and contents as they are now
    bool page(const Page &page, const std::string &before, const std::string &text) {
        const std::vector<Finding> others = difference(page.file, before, text);
        const Woven woven = weave(workspace, page, text, [this](const Section &section, const std::string &part) {
            const auto [known, is_new] = printed.try_emplace({section.name, part});
            if (is_new) known->second = output_of(workspace, section, part);
            return known->second;
        });
        add(woven.findings);
        broken = broken || woven.broken;
        if (woven.broken) return false;
        if (check) {
            add(others);
            add(woven.differences);
            changed_code.insert(woven.code.begin(), woven.code.end());
            differs = differs || !woven.differences.empty();
            add(dead_links(page.file, text, workspace.root));
        } else if (write_file(page.file, woven.text)) {
            changed = true;
            std::cout << "woven: " << workspace.relative_name(page.file) << ", "
                      << pluralize(others.size() + woven.differences.size(), "block") << " changed\n";
        }
        listings += woven.listings;
        outputs += woven.outputs;
        return true;
    }

    const Workspace &workspace;
    const bool check;
    std::map<std::pair<std::string, std::string>, std::string> printed; ///< by section and part: each runs once
    std::vector<Finding> findings;
    std::vector<std::string> measured; ///< chapters to measure
    std::set<fs::path> changed_code;   ///< whose listings are not so in the book
    int chapters = 0, listings = 0, outputs = 0;
    bool changed = false, broken = false, differs = false;
};

} // namespace

void add_weave(CLI::App &app, const Workspace &workspace) {
    const auto named = std::make_shared<std::vector<std::string>>();
    const auto check = std::make_shared<bool>();
    CLI::App *command = app.add_subcommand("weave", "Bring the book's listings, outputs and glossary up to date");
    command->add_option("section", *named, "Their chapters and the glossary only; without any, the whole book");
    command->add_flag("--check", *check, "Change nothing: say what is out of date, is missing, or leads nowhere");
    command->footer("Example: ./course dev weave 7\n         ./course dev weave --check");
    command->callback([&workspace, named, check] {
        std::vector<Section> sections;
        for (const std::string &words : *named) sections.push_back(workspace.section(words));
        Command weave{workspace, *check};
        for (const Section &section : sections.empty() ? workspace.sections() : sections) weave.section(section);
        weave.book();
        if (sections.empty()) weave.root();
        weave.finish();
    });
}

} // namespace course
