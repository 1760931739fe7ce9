#include "loop/judge.hpp"

#include "ground/complaint.hpp"
#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/plain.hpp"
#include "ground/process.hpp"
#include "loop/answer.hpp"
#include "loop/diagnosis.hpp"
#include "loop/includes.hpp"
#include "loop/stopped.hpp"
#include "loop/toolbox.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
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

/// [s] for all tests of a section. They end a student's endless loops themselves, after a few seconds of computing each.
constexpr double longest_test = 600;
/// [s] of processor for the quick compiler, which needs a fifth of a second.
constexpr unsigned quick_enough = 5;

/// A folder for one judgement, gone when it is over.
class Scratch {
  public:
    explicit Scratch(const fs::path &build) {
        sweep(build / "loop");
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

  private:
    /// Those that a kill has left: no check takes an hour.
    static void sweep(const fs::path &loop) {
        std::error_code ignored;
        const auto an_hour_ago = fs::file_time_type::clock::now() - std::chrono::hours{1};
        for (const auto &entry : fs::directory_iterator{loop, ignored})
            if (entry.path().filename().string().starts_with("judge.") && entry.last_write_time(ignored) < an_hour_ago
                && !ignored)
                fs::remove_all(entry.path(), ignored);
    }
};

Judgement not_built(Verdict why, std::vector<std::string> warnings = {}) {
    return {std::move(why), {}, std::move(warnings)};
}

/// For a function that is missing: how the header declares it, and what is there instead.
void help_the_missing(std::vector<Verdict> &verdicts, const Tree &tree, const Section &section, const Toolbox &tools,
                      const fs::path &object) {
    std::string defined, header; // read once, and only if a function is missing
    for (auto &verdict : verdicts) {
        if (verdict.kind != Kind::missing || !verdict.call) continue;
        if (defined.empty()) {
            defined = plain_output(run({tools.nm, "-C", "--defined-only", object.string()}).out);
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
std::string run_tests(const Tree &tree, const Section &section, const std::string &subject, unsigned seed,
                      const std::string &exercise) {
    std::vector<std::string> command{tree.test_program(section).string(), subject, "--json", "--seed",
                                     std::to_string(seed)};
    if (!exercise.empty()) command.insert(command.end(), {"--exercise", exercise});
    const auto tested = run(command, {.deadline = longest_test});
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

/// A student's file becomes a subject, the program against which tests run.
struct SubjectBuild {
    const Tree &tree;
    const Section &section;
    const Toolbox &tools;
    const fs::path &file;
    const Scratch &scratch;

    std::string object() const { return scratch / "student.o"; }
    std::string subject() const { return scratch / "subject"; }

    /// By the quick compiler. Whatever it has to complain of is left to the other one, whose words students read, and
    /// so is a `switch`: if it has all values of an enum, only GCC wants a return behind it.
    /// @return whether the subject is built
    bool quickly(std::string_view text) const {
        if (!tools.quick || text.find("switch") != std::string_view::npos) return false;
        Limits limits = compiler_limits;
        limits.processor_time = quick_enough;
        const auto compiled = run(compile_command(*tools.quick), within(limits));
        return compiled.code == 0 && compiled.err.empty() && !foreign_header() && link_with(tools.quick_link).code == 0;
    }

    /// By the course's own compiler.
    /// @return why it could not be compiled
    std::optional<Verdict> compile(std::vector<std::string> &warnings) const {
        const std::string name = tree.shown(file);
        auto command = compile_command(tools.compiler);
        command.insert(command.end(), tools.assembler.begin(), tools.assembler.end());
        if (!tools.assembler.empty()) command.push_back(assembled());
        fs::remove(includes()); // the quick compiler has left its own, and may have read other files
        const auto compiled = run(command, within(compiler_limits));
        const std::string said = plain_output(compiled.err);
        if (auto why = stopped_by_a_limit(compiled, said); !why.empty())
            return Verdict{.kind = Kind::does_not_compile, .sentence = std::move(why)};
        // before a word of the compiler's is passed on: it may quote what a foreign file says
        if (!fs::exists(includes()) && !list_includes())
            return Verdict{.kind = Kind::does_not_compile,
                           .sentence = "The compiler can't tell what your file includes: include only headers that a "
                                       "check allows, and each once."};
        auto elsewhere = foreign_header();
        if (!elsewhere && fs::exists(assembled())) // it is in the scratch folder, as is what the compiler hands to it
            elsewhere = included_from_elsewhere(read_file(assembled()), file, scratch.folder, {scratch.folder});
        if (elsewhere)
            return Verdict{.kind = Kind::does_not_compile,
                           .sentence =
                               "Your file includes " + tree.shown(*elsewhere)
                               + ", which a check does not allow: it may include headers of the system, of Eigen and "
                                 "of chapters/. Write what you need into the file itself."};
        if (compiled.code != 0) return diagnose_compiler(said, file, name, renamed(tree, section));
        warnings = find_warnings(said, file, name);
        return {};
    }

    /// What that has compiled.
    /// @return why it could not be linked
    std::optional<Verdict> link() const {
        const auto linked = link_with({});
        if (linked.code == 0) return {};
        const std::string linker = plain_output(linked.err);
        auto why = stopped_by_a_limit(linked, linker);
        return why.empty() ? diagnose_linker(linker, tree.shown(file), section.short_number())
                           : Verdict{.kind = Kind::does_not_link, .sentence = std::move(why)};
    }

    std::string includes() const { return scratch / "includes"; }
    std::string assembled() const { return scratch / "assembled"; }

    RunOptions within(const Limits &limits) const {
        return {.deadline = longest_wait,
                .folder = scratch.folder,
                .limits = limits,
                .environment = {"TMPDIR=" + scratch.folder.string() + '/'}};
    }
    std::vector<std::string> compile_command(const Compiler &compiler) const {
        auto command = compiler.command(tree, section, file, object());
        command.insert(command.end(), {"-MD", "-MF", includes()});
        return command;
    }
    /// Where the compiler gave up before it had listed what it reads: the preprocessor alone does, and passes over
    /// headers that aren't there.
    bool list_includes() const {
        auto command = compile_command(tools.compiler);
        std::replace(command.begin(), command.end(), std::string{"-MD"}, std::string{"-M"});
        command.insert(command.end(), {"-MG", "-fmax-errors=0"});
        run(command, within(compiler_limits));
        return fs::exists(includes());
    }
    std::optional<fs::path> foreign_header() const {
        return included_from_elsewhere(read_file(includes()), file, scratch.folder, tools.includes);
    }
    Finished link_with(const std::vector<std::string> &also) const {
        std::vector<std::string> command{tools.compiler.program, object(), tools.server.string(),
                                         tools.missing.string(), "-o",     subject()};
        command.insert(command.end(), also.begin(), also.end());
        command.insert(command.end(), tools.earlier.begin(), tools.earlier.end());
        command.insert(command.end(), tools.link.begin(), tools.link.end());
        return run(command, within(compiler_limits));
    }
};

} // namespace

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
        return Verdict{.exercise = test.exercise, .test = test.claim, .kind = Kind::no_verdict, .sentence = sentence};
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

Judgement judge(const Tree &tree, const Section &section, const fs::path &given, unsigned seed,
                const std::string &exercise) {
    const fs::path file = fs::absolute(given).lexically_normal();
    const std::string name = tree.shown(file);
    const std::string text = read_answer(file);
    if (auto trouble = diagnose_text(text, name, section.short_number())) return not_built(*trouble);
    if (auto trouble = diagnose_section(text, name, tree, section)) return not_built(*trouble);

    const Toolbox tools = toolbox(tree, section);
    bring_up_to_date(tree, section, tools);
    const Scratch scratch{tree.build};
    const SubjectBuild build{tree, section, tools, file, scratch};
    std::vector<std::string> warnings;
    const bool is_built = build.quickly(text);
    if (!is_built)
        if (auto trouble = build.compile(warnings)) return not_built(*trouble);
    for (const auto &find : {find_unreached, find_whole_divisions})
        for (const std::string &found : find(text, name)) warnings.push_back(found);
    if (!is_built)
        if (auto trouble = build.link()) return not_built(*trouble, warnings);

    auto tests = tests_of(tree, section);
    if (!exercise.empty()) std::erase_if(tests, [&](const KnownTest &test) { return test.exercise != exercise; });
    Judgement judgement{{}, one_for_each(tests, run_tests(tree, section, build.subject(), seed, exercise)), warnings};
    help_the_missing(judgement.verdicts, tree, section, tools, build.object());
    help_the_accepting(judgement.verdicts, tree, section, text);
    return judgement;
}

} // namespace course
