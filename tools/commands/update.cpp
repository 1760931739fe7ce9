// `course update`: a newer version of the course, around what the student has written.

#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/process.hpp"
#include "base/repository.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/functions.hpp"
#include "check/which_tests.hpp"
#include "commands/commands.hpp"
#include "grade/archive.hpp"

#include <algorithm>
#include <iostream>
#include <set>

namespace course {
namespace {

namespace fs = std::filesystem;

bool is_clone(const Workspace &workspace) { return fs::exists(workspace.root / ".git"); }

/// The folder with the course in it: this one, or the only one inside.
fs::path course_in(const fs::path &folder) {
    std::vector<fs::path> places{folder};
    for (const auto &each : fs::directory_iterator{folder}) places.push_back(each.path());
    for (const fs::path &place : places)
        if (fs::exists(place / "CMakeLists.txt") && fs::exists(place / "course") && fs::exists(place / "exercises"))
            return place;
    throw UserError{
        "there's no course in it: an update is a release's archive, a folder with the course, or a repository"};
}

/// Nothing in an archive may lead out of the folder it is unpacked in: only files and folders, by names that stay below it.
void require_harmless(const std::string &archive, const std::string &from) {
    const auto list = [&](const char *how) { return run({"cmake", "-E", "tar", how, archive}); };
    const Finished names = list("tf"), entries = list("tvf");
    if (names.code != 0) throw UserError{from + " is no archive that can be unpacked; download it again?"};
    for (const Line &line : split_lines(names.out))
        if (const std::string why = unsafe_name(line.text); !why.empty())
            throw UserError{from + " isn't a release of this course: in it, " + plain_line(line.text, 100) + ' ' + why
                            + ". Nothing was unpacked"};
    for (const Line &line : split_lines(entries.out))
        if (!line.text.starts_with('-') && !line.text.starts_with('d'))
            throw UserError{from + " isn't a release of this course: it has a link in it, " + plain_line(line.text, 100)
                            + ". Nothing was unpacked"};
}

/// Where the newer version's files are.
/// @param from  an archive, a folder, or what git calls a remote
fs::path newer_files(const Workspace &workspace, const std::string &from, const fs::path &scratch) {
    if (fs::is_directory(from) && !fs::exists(fs::path{from} / ".git")) return course_in(from);
    std::string archive = fs::absolute(from).string();
    if (!fs::is_regular_file(from)) {
        if (!is_clone(workspace))
            throw UserError{"there's no file " + from
                            + ", and this course isn't a clone that could fetch: name a release's archive"};
        git_in(workspace.root, {"fetch", "--quiet", from, "HEAD"});
        archive = (scratch / "newer.tar").string();
        git_in(workspace.root, {"archive", "--output=" + archive, "FETCH_HEAD"});
    }
    require_harmless(archive, from);
    fs::create_directories(scratch / "newer");
    if (const Finished done = run({"cmake", "-E", "tar", "xf", archive}, {.folder = scratch / "newer"}); done.code != 0)
        throw UserError{from + " is no archive that can be unpacked; download it again?"};
    return course_in(scratch / "newer");
}

std::set<std::string> files_below(const fs::path &folder) {
    std::set<std::string> all;
    for (fs::recursive_directory_iterator each{folder}, end; each != end; ++each) {
        if (each->path().filename() == ".git") each.disable_recursion_pending();
        else if (each->is_regular_file()) all.insert(each->path().lexically_relative(folder).generic_string());
    }
    return all;
}

/// What an update leaves alone.
bool is_the_students(const std::string &file) { return file.starts_with("exercises/") || file.starts_with(".course/"); }

/// Files that came with the version that's here, so that those that are gone from the newer one can go: as git knows
/// them, or as the last update has noted them.
std::set<std::string> known_files(const Workspace &workspace, const fs::path &list) {
    std::string text;
    if (is_clone(workspace)) text = git_in(workspace.root, {"ls-files"});
    else if (fs::exists(list)) text = read_file(list);
    std::set<std::string> all;
    for (const Line &line : split_lines(text)) all.emplace(line.text);
    return all;
}

/// Which functions of a stub aren't what they were: "5.4 incline_acceleration, 5.9 tip_over".
std::string changed_functions(const std::string &before, const std::string &now) {
    const auto text_of = [](const std::string &text, const std::string &function) {
        const Functions all = functions_of(Source{text}, {});
        const Function *match = find_function(all, function);
        return match == nullptr ? "" : text.substr(match->begin, match->end - match->begin);
    };
    std::string names;
    for (const Function &each : functions_of(Source{now}, {})) {
        if (text_of(now, each.name) == text_of(before, each.name)) continue;
        const std::string above = now.substr(0, each.begin), line = above.substr(above.rfind("\n// ") + 1);
        const std::string number{between(line, "// ", " ").value_or("")}; // "// 5.4 core" stands above it
        names += (names.empty() ? "" : ", ") + (is_number_of_exercise(number) ? number + ' ' : "") + each.name;
    }
    return names.empty() ? "what stands around the functions" : names;
}

/// The stub that an exercise's file began as.
fs::path stub_of(const Workspace &workspace, const std::string &section) {
    const fs::path stub = workspace.stub(Section{section});
    return fs::exists(stub) ? stub : workspace.root / "tests/stubs" / (section + ".cpp"); // where it was until 2026
}

/// An exercise's file: replaced where nothing was written into it; else a stub that has changed is put beside it.
void renew_exercise(const Workspace &workspace, const fs::path &newer, const std::string &file) {
    const fs::path student_file = workspace.root / file, old_stub = stub_of(workspace, fs::path{file}.stem().string());
    const std::string fresh = read_file(newer / file);
    if (!fs::exists(student_file)) {
        write_file(student_file, fresh);
        return;
    }
    const std::string stub = without_stamp(fresh),
                      before = without_stamp(fs::exists(old_stub) ? read_file(old_stub) : ""),
                      text = without_stamp(read_file(student_file));
    if (text == before || text == stub) {
        write_file(student_file, fresh);
        return;
    }
    if (stub == before) return;
    const fs::path beside = fs::path{file}.replace_extension("new.txt");
    write_file(workspace.root / beside, fresh);
    std::cout << file << " is yours, and stays. Its stub has changed (" << changed_functions(before, fresh)
              << "): take that over from " << beside.string() << '\n';
}

/// Whether a file is as the newer version has it, or in neither.
bool is_as_in(const fs::path &newer, const fs::path &root, const std::string &file) {
    const bool here = fs::exists(root / file);
    return here == fs::exists(newer / file) && (!here || read_file(root / file) == read_file(newer / file));
}

/// An update writes over all that isn't in exercises/: what somebody has changed there is merged by git, or not at all.
/// What is as in the newer version isn't a change: an earlier update was stopped half-way, and this one goes on.
void require_unchanged(const Workspace &workspace, const fs::path &newer, bool by_git) {
    if (!is_clone(workspace)) return;
    std::string changed = git_in(workspace.root, {"diff", "--name-only", "HEAD", "--", ".", ":!exercises"});
    if (by_git)
        changed += git_in(workspace.root, {"diff", "--name-only", "FETCH_HEAD...HEAD", "--", ".", ":!exercises"});
    for (const Line &line : split_lines(changed))
        if (const std::string file{line.text}; !is_as_in(newer, workspace.root, file))
            throw UserError{"you have changed " + file
                            + ", which an update would write over: commit it, and type git pull, which merges"};
}

/// Lets git know which version is here now. What the student has committed stays in the history.
void tell_git(const Workspace &workspace) {
    if (git_in(workspace.root, {"rev-list", "--count", "FETCH_HEAD..HEAD"}) == "0\n") { // nothing of the student's own
        git_in(workspace.root, {"reset", "--quiet", "FETCH_HEAD"});                     // files stay as they are
        return;
    }
    git_in(workspace.root, {"merge", "--quiet", "--no-commit", "-s", "ours", "FETCH_HEAD"});
    git_in(workspace.root, {"add", "--all", "--", ".", ":!exercises"});
    git_in(workspace.root, {"commit", "--quiet", "--message", "update of the course"});
}

void update(const Workspace &workspace, const std::string &from) {
    const Scratch scratch{temporary_files() / "course-update"};
    if (scratch.folder.empty()) throw EnvironmentError{"no folder can be made for what comes; is the disk full?"};
    const bool by_git = !fs::exists(from) || fs::exists(fs::path{from} / ".git");
    const fs::path newer = newer_files(workspace, from, scratch.folder), list = workspace.memory() / "files.txt";
    const std::set<std::string> files = files_below(newer), before = known_files(workspace, list);
    require_unchanged(workspace, newer, by_git);
    std::size_t changed = 0, gone = 0;
    for (const std::string &file : files) // which compares with the stubs of the version that's here
        if (file.starts_with("exercises/")) renew_exercise(workspace, newer, file);
    std::string names;
    for (const std::string &file : files) {
        names += file + '\n';
        if (is_the_students(file)) continue;
        if (write_file(workspace.root / file, read_file(newer / file))) ++changed;
        fs::permissions(workspace.root / file, fs::status(newer / file).permissions());
    }
    for (const std::string &file : before)
        if (!files.contains(file) && !is_the_students(file) && fs::remove(workspace.root / file)) ++gone;
    if (by_git) tell_git(workspace);
    if (!is_clone(workspace)) write_file(list, names);
    if (changed + gone == 0) std::cout << "This is the newest version already.\n";
    else
        std::cout << pluralize(changed, "file") << " renewed, " << gone
                  << " gone; what's in exercises/ is as you left it. Type ./course, which builds what's new.\n";
}

} // namespace

void add_update(CLI::App &app, const Workspace &workspace) {
    const auto from = std::make_shared<std::string>("origin");
    CLI::App *command = app.add_subcommand("update", "Take a newer version of the course; what you wrote stays");
    command->add_option("from", *from, "a release's archive, a folder, or a repository's address")
        ->capture_default_str();
    command->footer("A stub that has changed is put beside your file, with a line on what to take over.\n\n"
                    "Example: ./course update frame-by-frame-0.2.0.tar.gz");
    command->callback([&workspace, from] { update(workspace, *from); });
}

} // namespace course
