#include "loop/toolbox.hpp"

#include "ground/build.hpp"
#include "ground/files.hpp"
#include "ground/lock.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace course {
namespace fs = std::filesystem;

std::vector<std::string> Compiler::command(const Tree &tree, const Section &section, const fs::path &file,
                                           const fs::path &object) const {
    std::vector<std::string> words{program};
    words.insert(words.end(), flags.begin(), flags.end());
    words.insert(words.end(), precompiled.begin(), precompiled.end());
    words.insert(words.end(), {"-I" + tree.header(section).parent_path().string(), "-fdiagnostics-color=never", "-x",
                               "c++", "-c", file.string(), "-o", object.string()});
    return words;
}

namespace {

/// How an object's name ends that's made of a student's file, as those of earlier sections are in a handout.
constexpr std::string_view yours = "_yours.o";

/// In a handout for many: what this student has written for earlier sections, also in the tests, which may call it.
void bring_up_earlier(const Tree &tree, const Section &section, const Toolbox &tools) {
    bool any = false;
    for (const fs::path object : tools.earlier) {
        const std::string name = object.filename().string();
        if (!name.ends_with(yours)) continue;
        tree.written_exercise({name.substr(0, name.size() - yours.size())}); // is there
        any = true;
    }
    if (!any) return;
    const Lock lock{tree};
    build_target(tree, tree.own_test_program(section).lexically_relative(tree.work()).string());
}

} // namespace

Toolbox toolbox(const Tree &tree, const Section &section) {
    const fs::path file = tree.build / "course.json";
    if (!fs::exists(file)) throw Complaint{"the course isn't built yet: type ./course, which builds all of it."};
    try {
        const auto json = nlohmann::json::parse(read_file(file));
        const auto compiler = [](const auto &its) {
            return Compiler{its.at("compiler"), its.at("flags"), its.at("precompiled")};
        };
        Toolbox w;
        w.compiler = compiler(json);
        if (const auto quick = json.find("quick"); quick != json.end()) {
            w.quick = compiler(*quick);
            w.quick_link = quick->at("link");
        }
        w.nm = json.at("nm");
        w.node = json.at("node");
        w.link = json.at("link");
        for (const auto &folder : json.at("includes")) w.includes.emplace_back(folder.get<std::string>());
        for (const auto &each : json.at("sections"))
            if (each.at("name") == section.name) {
                w.server = each.at("server").get<std::string>();
                w.missing = each.at("missing").get<std::string>();
                w.ours = each.value("ours", "");
                w.earlier = each.at("earlier");
                for (std::string &object : w.earlier)
                    if (tree.is_shared() && object.ends_with(yours))
                        object = tree.work() / fs::path{object}.lexically_relative(tree.build);
                w.plays_yours = each.value("plays_yours", false);
            }
        return w;
    } catch (const nlohmann::json::exception &) {
        throw Complaint{file.string() + " is broken: delete it, and type ./course, which makes a new one."};
    }
}

namespace {

/// What the build has made for these tools.
std::vector<fs::path> made_for(const Toolbox &tools) {
    std::vector<fs::path> files{tools.server, tools.missing};
    if (!tools.ours.empty()) files.push_back(tools.ours);
    files.insert(files.end(), tools.earlier.begin(), tools.earlier.end());
    auto quick = tools.quick_link;
    if (tools.quick) quick.insert(quick.end(), tools.quick->precompiled.begin(), tools.quick->precompiled.end());
    std::ranges::copy_if(quick, std::back_inserter(files),
                         [](const std::string &word) { return word.starts_with('/'); });
    return files;
}

/// The newest date of the course's own files that a verdict on this section rests on. A file dated in the future, by a
/// clock that was wrong, would be newer than all that is ever built from it: it is dated now.
fs::file_time_type newest(const Tree &tree, const Section &section) {
    const auto now = fs::file_time_type::clock::now();
    auto date = fs::file_time_type::min();
    const auto look = [&](const fs::path &file) {
        std::error_code ignored;
        auto its = fs::last_write_time(file, ignored);
        if (ignored) return;
        if (its > now) fs::last_write_time(file, its = now, ignored);
        date = std::max(date, its);
    };
    for (const char *folder :
         {"chapters", "tools/verdict/shared", "tools/verdict/student", "tools/verdict/tests", "cmake"})
        for (const fs::path &file : files_in(tree.root / folder)) look(file);
    for (const auto &file : {tree.root / "CMakeLists.txt", tree.root / "tests/section_test.hpp",
                             tree.root / "tests/matchers.hpp", tree.tests(section), tree.stub(section)})
        look(file);
    for (const Section &each : tree.sections()) { // this one may build on it
        look(tree.header(each));
        look(tree.has_solution(each) || each.number() >= section.number() ? tree.solution(each) : tree.exercise(each));
    }
    return date;
}

} // namespace

Places places_of(const Toolbox &tools, const fs::path &work) {
    Places places{places_of_system(), {work, "/dev/null"}};
    auto &readable = places.readable;
    readable.insert(readable.end(), tools.includes.begin(), tools.includes.end());
    std::vector<std::string> programs{tools.compiler.program, tools.nm};
    if (tools.quick) programs.push_back(tools.quick->program);
    for (const std::string &program : programs) {
        std::error_code missing; // run says so
        const fs::path home = fs::canonical(program, missing).parent_path().parent_path();
        if (missing) continue;
        readable.emplace_back(program);
        for (const char *part : {"bin", "include", "lib", "lib64", "libexec"}) readable.push_back(home / part);
    }
    for (const fs::path &file : made_for(tools)) readable.push_back(file);
    return places;
}

void bring_up_to_date(const Tree &tree, const Section &section, const Toolbox &tools) {
    const auto is_cut = [](const fs::path &file) { return fs::exists(file) && fs::is_empty(file); };
    const auto is_whole = [&](const fs::path &file) { return fs::exists(file) && !is_cut(file); };
    if (tree.is_shared()) bring_up_earlier(tree, section, tools);
    auto files = made_for(tools);
    files.insert(files.end(), {tree.test_program(section), tree.catalogue(section)});
    const bool all_there = std::ranges::all_of(files, is_whole);
    if (tree.is_shared()) {
        if (all_there) return;
        throw MachineTrouble{"this course isn't built as a whole: whoever it belongs to has to type ./course once"};
    }
    const fs::path stamp = tree.build / "loop" / (section.name + ".checked");
    std::error_code never;
    const auto checked = fs::last_write_time(stamp, never);
    if (all_there && !never && checked >= newest(tree, section)) return;
    const Lock lock{tree};
    for (const fs::path &file : files)
        if (is_cut(file)) fs::remove(file); // or it would be newer than what it is made from
    const auto built = build_target(tree, section.name + "_loop");
    if (built.code != 0)
        throw Complaint{"the course's own files don't build; `cmake --build " + tree.build.string() + "` shows why."};
    write_file(stamp, "");
    fs::last_write_time(stamp, fs::file_time_type::clock::now());
}

} // namespace course
