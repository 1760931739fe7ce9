// `course update`: a newer version of the course, around what the student has written.

#include "commands/commands.hpp"
#include "ground/files.hpp"
#include "ground/lab.hpp"
#include "ground/lines.hpp"
#include "ground/process.hpp"
#include "ground/repository.hpp"
#include "ground/text.hpp"
#include "loop/which_tests.hpp"

#include <algorithm>
#include <iostream>
#include <set>

namespace course {
namespace {

namespace fs = std::filesystem;

bool is_clone(const Tree &tree) { return fs::exists(tree.root / ".git"); }

/// The folder with the course in it: this one, or the only one inside.
fs::path course_in(const fs::path &folder) {
    std::vector<fs::path> places{folder};
    for (const auto &each : fs::directory_iterator{folder}) places.push_back(each.path());
    for (const fs::path &place : places)
        if (fs::exists(place / "CMakeLists.txt") && fs::exists(place / "course") && fs::exists(place / "exercises"))
            return place;
    throw Complaint{
        "there's no course in it: an update is a release's archive, a folder with the course, or a repository"};
}

/// Where the newer version's files are.
/// @param from  an archive, a folder, or what git calls a remote
fs::path newer_files(const Tree &tree, const std::string &from, const fs::path &scratch) {
    if (fs::is_directory(from) && !fs::exists(fs::path{from} / ".git")) return course_in(from);
    std::string archive = fs::absolute(from).string();
    if (!fs::is_regular_file(from)) {
        if (!is_clone(tree))
            throw Complaint{"there's no file " + from
                            + ", and this course isn't a clone that could fetch: name a release's archive"};
        git_in(tree.root, {"fetch", "--quiet", from, "HEAD"});
        archive = (scratch / "newer.tar").string();
        git_in(tree.root, {"archive", "--output=" + archive, "FETCH_HEAD"});
    }
    fs::create_directories(scratch / "newer");
    if (const Finished done = run({"cmake", "-E", "tar", "xf", archive}, {.folder = scratch / "newer"}); done.code != 0)
        throw Complaint{from + " is no archive that can be unpacked; download it again?"};
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
std::set<std::string> known_files(const Tree &tree, const fs::path &list) {
    std::string text;
    if (is_clone(tree)) text = git_in(tree.root, {"ls-files"});
    else if (fs::exists(list)) text = read_file(list);
    std::set<std::string> all;
    for (const Line &line : lines_of(text)) all.emplace(line.text);
    return all;
}

/// Which functions of a stub aren't what they were: "5.4 incline_acceleration, 5.9 tip_over".
std::string changed_functions(const std::string &before, const std::string &now) {
    std::string names;
    for (const Line &line : lines_of(now)) { // "// 5.4 core" stands above each
        const std::string_view number = line.text.substr(0, line.text.find(' ', 3));
        if (!number.starts_with("// ") || !is_digit(number.back()) || !contains(number, ".")) continue;
        const auto part = [&](const std::string &text) {
            return between(text, std::string{number} + ' ', "\n}").value_or("");
        };
        const std::string_view its = part(now), heading = its.substr(0, its.find('('));
        if (its != part(before))
            names += (names.empty() ? "" : ", ") + std::string{number.substr(3)} + ' '
                     + std::string{heading.substr(heading.find_last_of(" \n") + 1)};
    }
    return names.empty() ? "what stands around the functions" : names;
}

/// An exercise's file: replaced where nothing was written into it; else a stub that has changed is put beside it.
void renew_exercise(const Tree &tree, const fs::path &newer, const std::string &file) {
    const fs::path theirs = tree.root / file, old_stub = tree.root / "tests/stubs" / fs::path{file}.filename();
    const std::string fresh = read_file(newer / file);
    if (!fs::exists(theirs)) {
        write_file(theirs, fresh);
        return;
    }
    const std::string stub = without_stamp(fresh),
                      before = without_stamp(fs::exists(old_stub) ? read_file(old_stub) : ""),
                      text = without_stamp(read_file(theirs));
    if (text == before || text == stub) {
        write_file(theirs, fresh);
        return;
    }
    if (stub == before) return;
    const fs::path beside = fs::path{file}.replace_extension("new.txt");
    write_file(tree.root / beside, fresh);
    std::cout << file << " is yours, and stays. Its stub has changed (" << changed_functions(before, fresh)
              << "): take that over from " << beside.string() << '\n';
}

/// An update writes over all that isn't in exercises/: what somebody has changed there is merged by git, or not at all.
void require_unchanged(const Tree &tree, bool by_git) {
    if (!is_clone(tree)) return;
    std::string changed = git_in(tree.root, {"diff", "--name-only", "HEAD", "--", ".", ":!exercises"});
    if (by_git) changed += git_in(tree.root, {"diff", "--name-only", "FETCH_HEAD...HEAD", "--", ".", ":!exercises"});
    if (!changed.empty())
        throw Complaint{"you have changed " + changed.substr(0, changed.find('\n'))
                        + ", which an update would write over: commit it, and type git pull, which merges"};
}

/// Lets git know which version is here now. What the student has committed stays in the history.
void tell_git(const Tree &tree) {
    if (git_in(tree.root, {"rev-list", "--count", "FETCH_HEAD..HEAD"}) == "0\n") { // nothing of the student's own
        git_in(tree.root, {"reset", "--quiet", "FETCH_HEAD"});                     // files stay as they are
        return;
    }
    git_in(tree.root, {"merge", "--quiet", "--no-commit", "-s", "ours", "FETCH_HEAD"});
    git_in(tree.root, {"add", "--all", "--", ".", ":!exercises"});
    git_in(tree.root, {"commit", "--quiet", "--message", "update of the course"});
}

void update(const Tree &tree, const std::string &from) {
    require_own_course(tree);
    const Scratch scratch{fs::temp_directory_path() / "course-update"};
    if (scratch.folder.empty()) throw MachineTrouble{"no folder can be made for what comes; is the disk full?"};
    const bool by_git = !fs::exists(from) || fs::exists(fs::path{from} / ".git");
    const fs::path newer = newer_files(tree, from, scratch.folder), list = tree.memory() / "files.txt";
    const std::set<std::string> files = files_below(newer), before = known_files(tree, list);
    require_unchanged(tree, by_git);
    std::size_t changed = 0, gone = 0;
    for (const std::string &file : files) // which compares with the stubs of the version that's here
        if (file.starts_with("exercises/")) renew_exercise(tree, newer, file);
    std::string names;
    for (const std::string &file : files) {
        names += file + '\n';
        if (is_the_students(file)) continue;
        if (write_file(tree.root / file, read_file(newer / file))) ++changed;
        fs::permissions(tree.root / file, fs::status(newer / file).permissions());
    }
    for (const std::string &file : before)
        if (!files.contains(file) && !is_the_students(file) && fs::remove(tree.root / file)) ++gone;
    if (by_git) tell_git(tree);
    if (!is_clone(tree)) write_file(list, names);
    if (changed + gone == 0) std::cout << "This is the newest version already.\n";
    else
        std::cout << counted(changed, "file") << " renewed, " << gone
                  << " gone; what's in exercises/ is as you left it. Type ./course, which builds what's new.\n";
}

} // namespace

void add_update(CLI::App &app, const Tree &tree) {
    const auto from = std::make_shared<std::string>("origin");
    CLI::App *command = app.add_subcommand("update", "Take a newer version of the course; what you wrote stays");
    command->add_option("from", *from, "a release's archive, a folder, or a repository's address")
        ->capture_default_str();
    command->footer("A stub that has changed is put beside your file, with a line on what to take over.\n\n"
                    "Example: ./course update frame-by-frame-0.2.0.tar.gz");
    command->callback([&tree, from] { update(tree, *from); });
}

} // namespace course
