#pragma once
// For the tests of the `course` program: a course of two small sections, made anew for each test and never built, and
// the program run in it.

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/workspace.hpp"
#include "own_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

namespace course {

/// The command `./course words` for this tree. `environment` is more of it, as {"NO_COLOR=1"}.
inline std::vector<std::string> course_command(const Workspace &workspace, const std::vector<std::string> &words,
                                               const std::vector<std::string> &environment = {}) {
    std::vector<std::string> line{"env",
                                  "-u",
                                  "COURSE_LOCKED",
                                  "-u",
                                  "NO_COLOR",
                                  "COURSE_ROOT=" + workspace.root.string(),
                                  "COURSE_BUILD=" + workspace.build.string()};
    line.insert(line.end(), environment.begin(), environment.end());
    line.push_back(COURSE_TOOL);
    line.insert(line.end(), words.begin(), words.end());
    return line;
}

/// For a child: goes on as this command.
[[noreturn]] inline void become(std::vector<std::string> command) {
    std::vector<char *> arguments;
    for (std::string &word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
}

/// PATH is this folder alone, for as long as it lives.
struct OnlyPath {
    explicit OnlyPath(const std::filesystem::path &folder) : before{std::getenv("PATH")} {
        ::setenv("PATH", folder.c_str(), 1);
    }
    ~OnlyPath() { ::setenv("PATH", before.c_str(), 1); }
    std::string before;
};

/// Links to all that's in a folder, but for these names.
inline void link_all_but(const std::set<std::string> &names, const std::filesystem::path &from,
                         const std::filesystem::path &to) {
    for (const auto &entry : std::filesystem::directory_iterator{from})
        if (const auto name = entry.path().filename(); !names.contains(name.string()))
            std::filesystem::create_symlink(entry.path(), to / name);
}

struct SmallCourse {
    explicit SmallCourse(const std::string &like = "a course XXXXXX") : folder{like} {
        workspace.root = folder.path;
        workspace.build = workspace.root / "build" / "default";
        write("CMakeLists.txt", "project(x)\nsection(06_reflection)\nsection(07_wall_meeting)\n");
        for (const Section &section : workspace.sections()) {
            write(workspace.stub(section), "// " + section.name + ", nothing done yet\n");
            write(workspace.exercise(section), "// " + section.name + ", nothing done yet\n");
            write(workspace.build / "catalogue" / (section.name + ".json"),
                  R"({"exercises": [)" + exercise(section, "1", "core", "first") + ", "
                      + exercise(section, "2", "stretch", "second") + "]}");
        }
        write("book.md", "| | section |\n|--:|:--|\n| 8 | n–t collisions | *to come* |\n");
        write("chapters/06_reflection/README.md", "# 6 Reflection\n");
        write("chapters/07_wall_meeting/README.md", chapter);
        write("solutions/07_wall_meeting.cpp",
              "//> Solution: a helper\nint two() { return 2; }\n\n//> Solution 7.1: one\nint first() { return 1; }\n\n"
              "//> Solution 7.2: two\nint second() { return two(); }\n//>\n");
    }

    /// `./course words`, without a terminal.
    Finished operator()(const std::vector<std::string> &words, const std::vector<std::string> &environment = {}) const {
        return run(command(words, environment));
    }

    std::vector<std::string> command(const std::vector<std::string> &words,
                                     const std::vector<std::string> &environment = {}) const {
        return course_command(workspace, words, environment);
    }

    void write(const std::filesystem::path &file, const std::string &text) const {
        write_file(workspace.root / file, text);
    }
    std::string read(const std::filesystem::path &file) const { return read_file(workspace.root / file); }
    bool has(const std::filesystem::path &file) const { return std::filesystem::exists(workspace.root / file); }

    /// Writes a program, which is a shell script.
    void write_program(const std::filesystem::path &file, const std::string &script) const {
        write(file, "#!/bin/sh\n" + script + '\n');
        std::filesystem::permissions(workspace.root / file, std::filesystem::perms::all);
    }

    /// Puts a shell script in the place of a program, and returns the environment in which it is found.
    std::string instead_of(const std::string &program, const std::string &script) const {
        write_program("bin/" + program, script);
        return "PATH=" + (workspace.root / "bin").string() + ":" + std::getenv("PATH");
    }

    /// Git in this course, which must not fail.
    void git(std::vector<std::string> words) const {
        words.insert(words.begin(), {"git", "-C", workspace.root.string(), "-c", "user.name=x", "-c", "user.email=x"});
        if (const Finished done = run(words); done.code != 0) throw std::runtime_error{"git failed: " + done.err};
    }
    void commit(const std::string &message = "all of it") const {
        git({"add", "--all"});
        git({"commit", "--quiet", "--message", message});
    }

    std::vector<std::filesystem::path> kept() const {
        std::vector<std::filesystem::path> copies;
        if (has(".course/kept"))
            for (const auto &entry : std::filesystem::directory_iterator{workspace.root / ".course" / "kept"})
                copies.push_back(entry.path());
        return copies;
    }

    Section seven() const { return workspace.section("7"); }

    OwnFolder folder;
    Workspace workspace;

  private:
    static std::string exercise(const Section &section, const std::string &n, const std::string &tier,
                                const char *name) {
        return R"({"number": ")" + section.short_number() + "." + n + R"(", "tier": ")" + tier + R"(", "function": ")"
               + (section.number() == 6 ? std::string{name} + "_bounce" : name) + R"("})";
    }

    static constexpr const char *chapter = R"(# 7 Walls that meet

<details>
<summary>7.1, a hint: where to begin</summary>

Under the *first* stone.
</details>

<details>
<summary>7.2, a hint: not for 7.1</summary>

Elsewhere.
</details>

<details>
<summary>7.1, a hint: the first line</summary>

`return 1;`
</details>
)";
};

} // namespace course
