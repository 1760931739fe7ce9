#include "loop/judge.hpp"

#include "ground/complaint.hpp"
#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/lock.hpp"
#include "ground/plain.hpp"
#include "ground/process.hpp"
#include "loop/answer.hpp"
#include "loop/diagnosis.hpp"
#include "loop/includes.hpp"
#include "loop/stopped.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <functional>

namespace course {
namespace fs = std::filesystem;

bool Judgement::all_passed() const {
    return !unbuilt && !verdicts.empty()
           && std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict &v) { return v.passed(); });
}
bool Judgement::our_fault() const {
    return std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict &v) { return v.kind == Kind::no_verdict; });
}

namespace {

/// [s] for all tests of a section. They end a student's endless loops themselves, after a few seconds each.
constexpr double longest_test = 180;

/// How CMake compiles and links: what it left in course.json.
struct Toolbox {
    std::string compiler, cmake, nm;
    std::vector<std::string> link, flags, precompiled; ///< the last: what puts the precompiled header before a file
    std::vector<std::string> assembler; ///< before the file where it lists what it reads; empty if it cannot
    fs::path server, missing;
    std::vector<fs::path> includes;   ///< folders with what a student's file may include
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
                  json.at("assembler"),
                  {},
                  {},
                  {},
                  {}};
        for (const auto &folder : json.at("includes")) w.includes.emplace_back(folder.get<std::string>());
        for (const auto &each : json.at("sections"))
            if (each.at("name") == section.name) {
                w.server = each.at("server").get<std::string>();
                w.missing = each.at("missing").get<std::string>();
                w.earlier = each.at("earlier");
            }
        return w;
    } catch (const nlohmann::json::exception &) {
        throw Complaint{file.string() + " is broken: delete it, and type ./course, which makes a new one."};
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
            throw MachineTrouble{"cannot write in " + build.string() + " (" + std::strerror(errno)
                                 + "): make it writable, or its disk less full"};
        folder = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    Scratch(const Scratch &) = delete;
    Scratch &operator=(const Scratch &) = delete;

    fs::path operator/(const char *name) const { return folder / name; }

    fs::path folder;
};

Judgement not_built(Verdict why, std::vector<std::string> warnings = {}) {
    return {std::move(why), {}, std::move(warnings)};
}

Verdict stopped(Kind kind, std::string sentence) {
    Verdict verdict;
    verdict.kind = kind;
    verdict.sentence = std::move(sentence);
    return verdict;
}

/// For a function that is missing: how the header declares it, and what is there instead.
void help_the_missing(std::vector<Verdict> &verdicts, const Tree &tree, const Section &section, const Toolbox &w,
                      const fs::path &object) {
    std::string defined, header; // read once, and only if a function is missing
    for (auto &verdict : verdicts) {
        if (verdict.kind != Kind::missing || !verdict.call) continue;
        if (defined.empty()) {
            defined = plain_output(run({w.nm, "-C", "--defined-only", object.string()}).out);
            header = read_file(tree.header(section));
        }
        verdict.sentence += explain_missing(defined, header, verdict.call->function, renamed(tree, section));
    }
}

/// For input that was accepted, although lines that came with the function refused it.
void help_the_accepting(std::vector<Verdict> &verdicts, const Tree &tree, const Section &section,
                        std::string_view text) {
    for (auto &verdict : verdicts)
        if (!verdict.accepted.empty())
            if (const auto more = explain_accepted(text, read_file(tree.stub(section)), verdict.exercise);
                !more.empty()) {
                verdict.sentence.back() = '.'; // instead of the colon before the list
                verdict.sentence += more;
            }
}

/// Runs the tests against a subject.
/// @return what they printed: a line of JSON for each verdict
std::string run_tests(const Tree &tree, const Section &section, const std::string &subject, unsigned seed) {
    const auto tested =
        run({(tree.build / "tests" / section.name).string(), subject, "--json", "--seed", std::to_string(seed)},
            {.deadline = longest_test});
    if (tested.timed_out)
        throw MachineTrouble{"the tests of section " + section.short_number() + " did not finish within "
                             + std::to_string(static_cast<int>(longest_test))
                             + " s, and were stopped: is the machine very busy? Nothing was judged"};
    if (tested.code == machine_trouble || tested.code == 128 + SIGKILL || tested.code == 128 + SIGTERM)
        throw MachineTrouble{"the tests of section " + section.short_number() + " could not be run: "
                             + (tested.err.empty() ? "they were killed from outside" : plain_output(tested.err))
                             + "Nothing was judged"};
    return tested.out;
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

std::vector<Verdict> one_for_each(const std::vector<KnownTest> &tests, const std::string &said) {
    std::vector<Verdict> told, verdicts;
    for (const Line &line : lines_of(said)) {
        const auto json = nlohmann::json::parse(line.text, nullptr, false);
        try {
            told.push_back(json.get<Verdict>());
        } catch (const nlohmann::json::exception &) { // half a line: its test has no verdict
        }
    }
    const auto none = [](const KnownTest &test, const char *sentence) {
        Verdict verdict = stopped(Kind::no_verdict, sentence);
        verdict.exercise = test.exercise;
        verdict.test = test.claim;
        return verdict;
    };
    for (const KnownTest &test : tests) {
        const auto is_its = [&](const Verdict &v) { return v.exercise == test.exercise && v.test == test.claim; };
        const auto its = std::stable_partition(told.begin(), told.end(), std::not_fn(is_its));
        const auto count = told.end() - its;
        verdicts.push_back(count == 1 ? *its
                                      : none(test, count == 0 ? "This test did not say what it found."
                                                              : "This test said more than once what it found."));
        told.erase(its, told.end());
    }
    for (const Verdict &other : told)
        verdicts.push_back(none({other.exercise, other.test}, "This test is not in the section's list of tests."));
    return verdicts;
}

Judgement judge(const Tree &tree, const Section &section, const fs::path &given, unsigned seed) {
    const fs::path file = fs::absolute(given).lexically_normal();
    const std::string name = tree.shown(file);
    const std::string text = read_answer(file);
    if (auto trouble = diagnose_text(text, name, section.short_number())) return not_built(*trouble);
    if (auto trouble = diagnose_section(text, name, tree, section)) return not_built(*trouble);

    const Toolbox w = toolbox(tree, section);
    bring_up_to_date(tree, section, w);
    const Scratch scratch{tree.build};
    const std::string object = scratch / "student.o", subject = scratch / "subject";
    const RunOptions limited{.deadline = longest_wait,
                             .folder = scratch.folder,
                             .limits = compiler_limits,
                             .environment = {"TMPDIR=" + (scratch / "").string()}};

    const std::string includes = scratch / "includes", assembled = scratch / "assembled";
    auto compile = compile_command(w, tree, section, file, object, false);
    compile.insert(compile.end(), {"-MD", "-MF", includes});
    compile.insert(compile.end(), w.assembler.begin(), w.assembler.end());
    if (!w.assembler.empty()) compile.push_back(assembled);
    const auto compiled = run(compile, limited);
    const std::string said = plain_output(compiled.err);
    if (auto why = stopped_by_a_limit(compiled, said); !why.empty())
        return not_built(stopped(Kind::does_not_compile, std::move(why)));
    if (compiled.code != 0) return not_built(diagnose_compiler(said, file, name, renamed(tree, section)));
    auto elsewhere = included_from_elsewhere(read_file(includes), file, scratch.folder, w.includes);
    if (!elsewhere && !w.assembler.empty()) // it is in the scratch folder, as is what the compiler hands to it
        elsewhere = included_from_elsewhere(read_file(assembled), file, scratch.folder, {scratch.folder});
    if (elsewhere)
        return not_built(stopped(Kind::does_not_compile,
                                 "Your file includes " + tree.shown(*elsewhere)
                                     + ", which a check does not allow: it may include headers of the system, of Eigen "
                                       "and of chapters/. Write what you need into the file itself."));
    auto warnings = find_warnings(said, file, name);
    for (const std::string &unreached : find_unreached(text, name)) warnings.push_back(unreached);

    std::vector<std::string> link{w.compiler, object, w.server.string(), w.missing.string(), "-o", subject};
    link.insert(link.end(), w.earlier.begin(), w.earlier.end());
    link.insert(link.end(), w.link.begin(), w.link.end());
    if (const auto linked = run(link, limited); linked.code != 0) {
        const std::string linker = plain_output(linked.err);
        auto why = stopped_by_a_limit(linked, linker);
        return not_built(why.empty() ? diagnose_linker(linker, name, section.short_number())
                                     : stopped(Kind::does_not_link, std::move(why)),
                         std::move(warnings));
    }

    Judgement judgement{{}, one_for_each(tests_of(tree, section), run_tests(tree, section, subject, seed)), warnings};
    help_the_missing(judgement.verdicts, tree, section, w, object);
    help_the_accepting(judgement.verdicts, tree, section, text);
    return judgement;
}

} // namespace course
