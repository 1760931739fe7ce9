#include "loop/judge.hpp"

#include "ground/complaint.hpp"
#include "ground/files.hpp"
#include "ground/lock.hpp"
#include "ground/plain.hpp"
#include "ground/process.hpp"
#include "loop/answer.hpp"
#include "loop/diagnosis.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace course {
namespace fs = std::filesystem;

bool Judgement::judged() const {
    return std::none_of(verdicts.begin(), verdicts.end(), [](const Verdict &v) { return v.test.empty(); });
}
bool Judgement::all_passed() const {
    return std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict &v) { return v.passed(); });
}
bool Judgement::our_fault() const {
    return std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict &v) { return v.kind == Kind::no_verdict; });
}

namespace {

constexpr double longest_compilation = 8; // [s]; a finished solution takes under one

/// How CMake compiles and links: what it left in course.json.
struct Toolbox {
    std::string compiler, cmake, nm;
    std::vector<std::string> link, flags, precompiled; ///< the last: what puts the precompiled header before a file
    fs::path server, missing;
    std::vector<std::string> earlier; ///< objects: the solutions of the sections that this one builds on
};

Toolbox toolbox(const Tree &tree, const Section &section) {
    const fs::path file = tree.build / "course.json";
    if (!fs::exists(file)) throw Complaint{"the course is not built yet: type ./course, which builds all of it."};
    try {
        const auto json = nlohmann::json::parse(read_file(file));
        Toolbox w{json.at("compiler"),
                  json.at("cmake"),
                  json.at("nm"),
                  json.at("link"),
                  json.at("flags"),
                  json.at("precompiled"),
                  {},
                  {},
                  {}};
        for (const auto &each : json.at("sections"))
            if (each.at("name") == section.name) {
                w.server = each.at("server").get<std::string>();
                w.missing = each.at("missing").get<std::string>();
                w.earlier = each.at("earlier");
            }
        return w;
    } catch (const nlohmann::json::exception &) {
        throw Complaint{file.string() + " is broken: delete it, and type ./course, which makes it anew."};
    }
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
        for (const auto &entry : fs::directory_iterator{tree.root / folder})
            if (entry.is_regular_file()) look(entry.path());
    for (const auto &file :
         {tree.root / "CMakeLists.txt", tree.root / "tests/section_test.hpp", tree.tests(section), tree.stub(section)})
        look(file);
    for (const Section &each : tree.sections()) { // this one may build on it
        look(tree.header(each));
        look(tree.solution(each));
    }
    return date;
}

/// Builds what is older than the course's files: ninja is asked only then, for it takes longer to say "no work".
void bring_up_to_date(const Tree &tree, const Section &section, const Toolbox &w) {
    const fs::path stamp = tree.build / "loop" / (section.name + ".checked");
    std::error_code never;
    const auto checked = fs::last_write_time(stamp, never);
    if (!never && checked >= newest(tree, section)) return;
    const Lock lock{tree};
    const auto built = run({w.cmake, "--build", tree.build.string(), "--target", section.name + "_loop"});
    if (built.code != 0)
        throw Complaint{"the course's own files do not build; `cmake --build " + tree.build.string() + "` shows why."};
    write_file(stamp, "");
    fs::last_write_time(stamp, fs::file_time_type::clock::now());
}

/// A folder for one judgement, gone when it is over.
class Scratch {
  public:
    explicit Scratch(const fs::path &build) {
        std::string name = (build / "loop" / "judge.XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw Complaint{"cannot write in " + build.string() + ": make it writable, or its disk less full."};
        folder = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    fs::path operator/(const char *name) const { return folder / name; }

  private:
    fs::path folder;
};

Judgement single(Verdict verdict, std::vector<std::string> warnings = {}) {
    Judgement judgement;
    judgement.verdicts.push_back(std::move(verdict));
    judgement.warnings = std::move(warnings);
    return judgement;
}

/// For a function that is missing: how the header declares it, and what stands there instead.
void help_the_missing(std::vector<Verdict> &verdicts, const Tree &tree, const Section &section, const Toolbox &w,
                      const fs::path &object) {
    std::string defined, header; // read once, and only for somebody who lacks a function
    for (auto &verdict : verdicts) {
        if (verdict.kind != Kind::missing || !verdict.call) continue;
        if (defined.empty()) {
            defined = plain_output(run({w.nm, "-C", "--defined-only", object.string()}).out);
            header = read_file(tree.header(section));
        }
        verdict.sentence += explain_missing(defined, header, verdict.call->function);
    }
}

std::vector<Verdict> read_verdicts(const fs::path &file) {
    std::vector<Verdict> verdicts;
    std::istringstream lines{read_file(file)};
    for (std::string line; std::getline(lines, line);) verdicts.push_back(nlohmann::json::parse(line).get<Verdict>());
    return verdicts;
}

std::vector<std::string> compile_command(const Toolbox &w, const Tree &tree, const Section &section,
                                         const fs::path &file, const fs::path &object, bool bare) {
    std::vector<std::string> command{w.compiler};
    command.insert(command.end(), w.flags.begin(), w.flags.end());
    if (!bare) command.insert(command.end(), w.precompiled.begin(), w.precompiled.end());
    command.insert(command.end(), {"-I" + tree.header(section).parent_path().string(), "-fdiagnostics-color=never",
                                   "-fmax-errors=20", "-x", "c++", "-c", file.string(), "-o", object.string()});
    return command;
}

} // namespace

std::vector<std::string> compile_command(const Tree &tree, const Section &section, const fs::path &file,
                                         const fs::path &object, bool bare) {
    return compile_command(toolbox(tree, section), tree, section, file, object, bare);
}

Judgement judge(const Tree &tree, const Section &section, const fs::path &given, unsigned seed) {
    const fs::path file = fs::absolute(given).lexically_normal();
    const std::string name = tree.shown(file);
    const std::string text = read_answer(file);
    if (auto trouble = diagnose_text(text, name, section.short_number())) return single(*trouble);
    if (auto trouble = diagnose_section(text, name, tree, section)) return single(*trouble);

    const Toolbox w = toolbox(tree, section);
    bring_up_to_date(tree, section, w);
    const Scratch scratch{tree.build};
    const std::string object = scratch / "student.o", subject = scratch / "subject";

    const auto compiled =
        run(compile_command(w, tree, section, file, object, false), {.deadline = longest_compilation});
    if (compiled.timed_out) {
        Verdict slow;
        slow.kind = Kind::does_not_compile;
        slow.sentence = "The compiler was stopped after " + std::to_string(static_cast<int>(longest_compilation))
                        + " s: does a template or a constexpr function never end?";
        return single(slow);
    }
    const std::string said = plain_output(compiled.err);
    auto warnings = find_warnings(said, file, name);
    for (const std::string &unreached : find_unreached(text, name)) warnings.push_back(unreached);
    if (compiled.code != 0) return single(diagnose_compiler(said, file, name));

    std::vector<std::string> link{w.compiler, object, w.server.string(), w.missing.string(), "-o", subject};
    link.insert(link.end(), w.earlier.begin(), w.earlier.end());
    link.insert(link.end(), w.link.begin(), w.link.end());
    if (const auto linked = run(link, {.deadline = longest_compilation}); linked.code != 0)
        return single(diagnose_linker(plain_output(linked.err), name, section.short_number()), warnings);

    const fs::path verdicts = scratch / "verdicts";
    const auto tested = run({(tree.build / "tests" / section.name).string(), subject, "--json", verdicts.string(),
                             "--seed", std::to_string(seed)});
    Judgement judgement{read_verdicts(verdicts), std::move(warnings)};
    if (tested.code > 1 || judgement.verdicts.empty())
        throw std::runtime_error{"the tests of section " + section.short_number() + " broke off ("
                                 + std::to_string(tested.code) + "): " + tested.err};
    help_the_missing(judgement.verdicts, tree, section, w, object);
    return judgement;
}

} // namespace course
