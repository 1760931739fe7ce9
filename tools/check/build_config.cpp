#include "check/build_config.hpp"

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/lock.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace course {
namespace fs = std::filesystem;

std::vector<std::string> Compiler::command(const Workspace &workspace, const Section &section, const fs::path &file,
                                           const fs::path &object) const {
    std::vector<std::string> words{program};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), precompiled.begin(), precompiled.end());
    words.insert(words.end(), {"-I" + workspace.header(section).parent_path().string(), "-fdiagnostics-color=never",
                               "-x", "c++", "-c", file.string(), "-o", object.string()});
    return words;
}

BuildConfig build_config(const Workspace &workspace, const Section &section) {
    const fs::path file = workspace.build / "course.json";
    if (!fs::exists(file)) throw UserError{"the course isn't built yet: type ./course, which builds all of it."};
    try {
        const auto json = nlohmann::json::parse(read_file(file));
        const auto compiler = [](const auto &entry) {
            return Compiler{entry.at("compiler"), entry.at("flags"), entry.at("precompiled")};
        };
        BuildConfig config;
        config.compiler = compiler(json);
        if (const auto quick = json.find("quick"); quick != json.end()) {
            config.quick = compiler(*quick);
            config.quick_link = quick->at("link");
        }
        config.nm = json.at("nm");
        config.objcopy = json.at("objcopy");
        config.node = json.at("node");
        config.link = json.at("link");
        for (const fs::path place : json.at("includes"))
            if (place != workspace.root / "chapters") config.includes.push_back(place);
            else // whose pages print solutions
                for (const fs::directory_entry &each : fs::recursive_directory_iterator{place})
                    if (each.path().extension() == ".hpp") config.includes.push_back(each.path());
        for (const auto &each : json.at("sections"))
            if (each.at("name") == section.name) {
                config.server = each.at("server").get<std::string>();
                config.missing = each.at("missing").get<std::string>();
                config.ours = each.value("ours", "");
                config.earlier = each.at("earlier");
                config.plays_yours = each.value("plays_yours", false);
            }
        return config;
    } catch (const nlohmann::json::exception &) {
        throw UserError{file.string() + " is broken: delete it, and type ./course, which makes a new one."};
    }
}

namespace {

/// What the build has made for a check of this section.
std::vector<fs::path> made_for(const BuildConfig &config) {
    std::vector<fs::path> files{config.server, config.missing};
    if (!config.ours.empty()) files.push_back(config.ours);
    files.insert(files.end(), config.earlier.begin(), config.earlier.end());
    auto quick = config.quick_link;
    if (config.quick) quick.insert(quick.end(), config.quick->precompiled.begin(), config.quick->precompiled.end());
    std::ranges::copy_if(quick, std::back_inserter(files),
                         [](const std::string &word) { return word.starts_with('/'); });
    return files;
}

/// The course's own files that a verdict on this section rests on.
std::vector<fs::path> sources_of(const Workspace &workspace, const Section &section) {
    std::vector<fs::path> all = files_in(workspace.root / "tests", ".hpp");
    all.insert(all.end(), {workspace.root / "CMakeLists.txt", workspace.tests(section), workspace.stub(section)});
    for (const char *folder :
         {"chapters", "tools/base", "tools/judge/protocol", "tools/judge/server", "tools/judge/runner", "cmake"})
        for (const fs::path &file : files_in(workspace.root / folder)) all.push_back(file);
    for (const Section &each : workspace.sections()) { // this one may build on it
        all.push_back(workspace.header(each));
        const bool ours = workspace.has_solution(each) || each.number() >= section.number();
        all.push_back(ours ? workspace.solution(each) : workspace.exercise(each));
    }
    std::erase_if(all, [](const fs::path &file) { return !fs::exists(file); });
    return all;
}

/// The newest date of those, which ninja goes by, and what's in them. A file gets today's date if the own one, by a clock
/// that was wrong, would be newer than all that's ever built from it; or if it's older than the last build, which knew
/// other content of it.
/// @param checked  when that was
/// @param known    the lines of that time: a hash and a file's place in the course, wherever that lies
/// @param lines    the lines of today
fs::file_time_type newest(const Workspace &workspace, const Section &section, fs::file_time_type checked,
                          const std::string &known, std::string &lines) {
    const auto now = fs::file_time_type::clock::now();
    auto date = fs::file_time_type::min();
    for (const fs::path &file : sources_of(workspace, section)) {
        const std::string place = ' ' + file.lexically_relative(workspace.root).string() + '\n';
        const std::string line = std::to_string(std::hash<std::string>{}(read_file(file))) + place;
        const bool is_known = contains(known, line) || !contains(known, place); // or it wasn't looked at then
        lines += line;
        auto changed = fs::last_write_time(file);
        std::error_code ignored;
        if (changed > now || (changed <= checked && !is_known)) fs::last_write_time(file, changed = now, ignored);
        date = std::max(date, changed);
    }
    return date;
}

/// Whether a file is dated so far ahead that the clock was wrong, and not only that of a server.
bool is_ahead(const fs::path &file) {
    return fs::exists(file) && fs::last_write_time(file) > fs::file_time_type::clock::now() + std::chrono::minutes{1};
}

} // namespace

AllowedPaths allowed_paths(const std::vector<std::string> &command) {
    AllowedPaths places{system_paths(), {}};
    std::error_code missing; // run says so
    const fs::path home = fs::canonical(command.front(), missing).parent_path().parent_path();
    if (!missing)
        for (const char *part : {"bin", "include", "lib", "lib64", "libexec"}) places.readable.push_back(home / part);
    std::ranges::copy_if(command, std::back_inserter(places.readable),
                         [](const std::string &word) { return word.starts_with('/'); });
    return places;
}

void bring_up_to_date(const Workspace &workspace, const Section &section, const BuildConfig &config) {
    const auto is_cut = [](const fs::path &file) { return fs::exists(file) && fs::is_empty(file); };
    const auto is_whole = [&](const fs::path &file) { return fs::exists(file) && !is_cut(file); };
    auto files = made_for(config);
    files.insert(files.end(), {workspace.test_program(section), workspace.catalogue(section)});
    const bool all_there = std::ranges::all_of(files, is_whole);
    const fs::path stamp = workspace.build / "loop" / (section.name + ".checked");
    const bool is_new = !fs::exists(stamp);
    const auto checked = is_new ? fs::file_time_type::min() : fs::last_write_time(stamp);
    std::string lines;
    const auto date = newest(workspace, section, checked, is_new ? "" : read_file(stamp), lines);
    const bool ahead = is_ahead(stamp) || std::ranges::any_of(files, is_ahead);
    if (all_there && !ahead && checked >= date) return;
    const Lock lock{workspace};
    for (const fs::path &file : files)
        if (is_cut(file)) fs::remove(file); // or it would be newer than what it is made from
    if (ahead) run({"cmake", "--build", workspace.build.string(), "--", "-t", "clean", section.name + "_loop"});
    const auto built = build_target(workspace, section.name + "_loop");
    if (built.code != 0)
        throw UserError{"the course's own files don't build; `cmake --build " + workspace.build.string()
                        + "` shows why."};
    write_file(stamp, lines);
    fs::last_write_time(stamp, fs::file_time_type::clock::now());
}

void build_if_missing(const Workspace &workspace, const Section &section) {
    if (is_built(workspace, section)) return;
    std::cerr << "Section " << section.short_number() << " isn't built yet, which takes a minute, this once\n";
    bring_up_to_date(workspace, section, build_config(workspace, section));
}

} // namespace course
