#include "base/lab.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace course {
namespace fs = std::filesystem;
namespace {

/// So that paths in messages and chapters lead somewhere from the student's folder, too, and `./course` is there.
void link_to_course(const Workspace &workspace) {
    for (const auto &each : fs::directory_iterator{workspace.root}) {
        const fs::path name = each.path().filename(), here = workspace.home / name;
        if (!name.string().starts_with('.') && name != "exercises" && name != "build" && !fs::exists(here))
            fs::create_symlink(each.path(), here);
    }
}

constexpr const char *notes = "CMakeFiles/d/"; ///< where CMake notes what was included

/// A command of the build, and what it makes.
struct Step {
    std::string command, output;
};

std::string ask_ninja(const Workspace &workspace, std::vector<std::string> words) {
    words.insert(words.begin(), {"ninja", "-C", workspace.build.string(), "-t"});
    const Finished done = run(words);
    if (done.code != 0)
        throw EnvironmentError{"this course's build folder can't be read; whoever it belongs to has to type ./course"};
    return done.out;
}

/// All that leads to a target, in an order that it can be done in.
std::vector<Step> steps_to(const Workspace &workspace, const std::string &target) {
    std::map<std::string, std::string> outputs;
    for (const auto &each : nlohmann::json::parse(ask_ninja(workspace, {"compdb"})))
        outputs[each.at("command")] = each.at("output");
    std::vector<Step> steps;
    const std::string commands = ask_ninja(workspace, {"commands", target});
    for (const Line &line : split_lines(commands))
        if (const auto output = outputs.find(std::string{line.text}); output != outputs.end())
            steps.push_back({output->first, output->second});
    return steps;
}

/// Paths of the build in a command, and what stands in their places for this student.
using Swaps = std::vector<std::pair<std::string, std::string>>;

/// Commands name what's in the build folder by the whole path, or from there.
/// @param place  empty: it stays
void add(Swaps &swaps, const Workspace &workspace, const fs::path &output, const fs::path &place = {}) {
    for (const std::string &name : {(workspace.build / output).string(), ' ' + output.string()})
        swaps.emplace_back(name, place.empty() ? name : name.starts_with(' ') ? ' ' + place.string() : place.string());
}

/// Of two that begin alike, the longer one is meant.
std::string with(const Swaps &swaps, const std::string &command) {
    std::string result;
    for (std::size_t at = 0; at < command.size();) {
        const std::pair<std::string, std::string> *best = nullptr;
        for (const auto &each : swaps)
            if (command.compare(at, each.first.size(), each.first) == 0
                && (!best || best->first.size() < each.first.size()))
                best = &each;
        if (best) result += best->second, at += best->first.size();
        else result += command[at++];
    }
    return result;
}

/// Notes of what was included, and what scripts were packed from.
void remove_unread_files(const Workspace &workspace) {
    fs::remove_all(workspace.work() / notes);
    for (const char *kind : {".d", ".wasm"})
        for (const fs::path &file : files_in(workspace.work() / "play", kind)) fs::remove(file);
}

/// There's room for what's made of one section at a time: another's is made anew when it's asked for.
void make_room(const Workspace &workspace, const std::string &target) {
    const std::string name = fs::path{target}.filename().string(), number = name.substr(0, name.find('_'));
    if (!is_all_digits(number)) return; // of the whole course, as the site is
    for (const char *folder : {"play", "mine", "tests", "CMakeFiles"}) {
        std::error_code not_there;
        for (const auto &each : fs::directory_iterator{workspace.work() / folder, not_there}) {
            const std::string other = each.path().filename().string();
            if (is_digit(other[0]) && !other.starts_with(number)) fs::remove_all(each.path());
        }
    }
}

/// Goes through the steps to a target, and takes for the student those that read the student's files, or what has been
/// made of them.
class Apart {
  public:
    explicit Apart(const Workspace &tree_) : workspace{tree_} {}

    /// @return how it ended; well, if there was nothing to do
    Finished take(const Step &step) {
        if (with(swaps, step.command) == step.command) return pass(step);
        if (!missing.empty())
            throw EnvironmentError{"this course isn't built as a whole: " + missing
                                   + " isn't there. Let whoever it belongs to type cmake --build "
                                   + workspace.build.string() + " --target lab"};
        const fs::path output{step.output}; // of a script, also what it's packed from
        const fs::path made = output.extension() == ".js" ? fs::path{output}.replace_extension() : output;
        add(swaps, workspace, made, work / made);
        const bool is_old = older(workspace.work() / output, newest_input(step));
        made_before.push_back(output);
        return is_old ? run_apart(step.command, made.parent_path()) : Finished{};
    }

  private:
    Finished pass(const Step &step) {
        add(swaps, workspace, step.output); // a name that may begin with that of a student's
        if (!fs::exists(workspace.build / step.output)) missing = step.output;
        return {};
    }

    /// In a shell that splits no words, so that the path of the student's folder may have blanks in it.
    Finished run_apart(const std::string &command, const fs::path &folder) const {
        for (const fs::path &each : {folder, fs::path{notes}}) fs::create_directories(workspace.work() / each);
        Swaps all = swaps;
        add(all, workspace, notes, work / notes);
        return run({"sh", "-c", "set -f; IFS=; export COURSE_HOME=\"$1\"; " + with(all, command), "sh",
                    workspace.home.string()},
                   {.folder = workspace.build});
    }

    /// When what a step reads of the student's has last changed, or the course.
    fs::file_time_type newest_input(const Step &step) const {
        auto date = fs::last_write_time(workspace.build / ".ninja_log");
        const auto look = [&](const fs::path &name, const fs::path &file) {
            if (contains(step.command, name.string())) date = std::max(date, fs::last_write_time(file));
        };
        for (const fs::path &file : files_in(workspace.home / "exercises"))
            look(fs::path{"exercises"} / file.filename(), file);
        for (const fs::path &output : made_before) look(output, workspace.work() / output);
        return date;
    }

    static bool older(const fs::path &file, fs::file_time_type date) {
        std::error_code not_there;
        const auto file_date = fs::last_write_time(file, not_there);
        return not_there || file_date <= date;
    }

    const Workspace &workspace;
    const fs::path home{"$COURSE_HOME"}, work = home / workspace.work().lexically_relative(workspace.home);
    Swaps swaps{{(workspace.root / "exercises" / "").string(), (home / "exercises" / "").string()}};
    std::vector<fs::path> made_before;
    std::string missing; ///< what the course should have made
};

} // namespace

bool create_student_folder(const Workspace &workspace) {
    fs::create_directories(workspace.work() / "loop");
    if (fs::exists(workspace.home / "exercises")) return false;
    link_to_course(workspace);
    for (const Section &section : workspace.sections())
        write_file(workspace.exercise(section), read_file(workspace.stub(section)));
    return true;
}

Finished build_apart(const Workspace &workspace, const std::string &target) {
    make_room(workspace, target);
    Apart apart{workspace};
    Finished done;
    for (const Step &step : steps_to(workspace, target))
        if (done = apart.take(step); done.code != 0) break;
    remove_unread_files(workspace);
    return done;
}

void require_own_course(const Workspace &workspace) {
    if (workspace.is_shared())
        throw UserError{"this course is for many, and what this command makes takes too much room for that: it needs a "
                        "course of your own. `check`, `hint`, `run`, `plot`, `play` and `bug` work here, too"};
}

} // namespace course
