#include "check/judge.hpp"

#include "base/files.hpp"
#include "base/kernel.hpp"
#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "check/answer_file.hpp"
#include "check/build_config.hpp"
#include "check/catalogue.hpp"
#include "check/compiling.hpp"
#include "check/diagnosis.hpp"
#include "check/help.hpp"
#include "judge/runner/sandbox.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;

namespace {

/// [s] for all tests of a section. They end a student's endless loops themselves, after a few seconds of computing each.
constexpr double longest_test = 600;
/// [s] of processor for the quick compiler, which needs a fifth of a second.
constexpr unsigned quick_enough = 5;

/// Removes the folders of judgements that a kill has ended: no check takes an hour.
void sweep(const fs::path &loop) {
    std::error_code ignored;
    const auto an_hour_ago = fs::file_time_type::clock::now() - std::chrono::hours{1};
    for (const auto &entry : fs::directory_iterator{loop, ignored})
        if (entry.path().filename().string().starts_with("judge.") && entry.last_write_time(ignored) < an_hour_ago
            && !ignored)
            fs::remove_all(entry.path(), ignored);
}

JudgeResult not_built(Verdict why, std::vector<std::string> warnings = {}) {
    return {std::move(why), {}, std::move(warnings)};
}

/// Runs the tests against a subject.
/// @return what they printed: a line of JSON for each verdict
std::string run_tests(const Workspace &workspace, const Section &section, const std::string &subject,
                      const JudgeOptions &how) {
    std::vector<std::string> command{workspace.test_program(section).string(), subject, "--json", "--seed",
                                     std::to_string(how.seed)};
    if (!how.exercise.empty()) command.insert(command.end(), {"--exercise", how.exercise});
    const auto tested = run(command, {.deadline = longest_test});
    if (tested.timed_out)
        throw EnvironmentError{"the tests of section " + section.short_number() + " did not finish within "
                               + std::to_string(static_cast<int>(longest_test))
                               + " s, and were stopped: is the machine very busy? Nothing was judged"};
    if (tested.code == machine_trouble || tested.code == 128 + SIGKILL || tested.code == 128 + SIGTERM)
        throw EnvironmentError{"the tests of section " + section.short_number() + " could not be run: "
                               + (tested.err.empty() ? "they were killed from outside" : sanitize(tested.err))
                               + "Nothing was judged"};
    return tested.out;
}

/// A student's file becomes a subject, the program against which tests run. Compilers see a copy of it, with nothing
/// beside it and a name that none of them stumbles over.
struct SubjectBuild {
    const Workspace &workspace;
    const Section &section;
    const BuildConfig &config;
    const std::string &name, &text;
    const std::vector<std::string> lent;
    const Scratch scratch{workspace.build / "loop" / "judge"};
    const fs::path file = scratch.folder / "student.cpp";
    bool is_linked = false;
    Finished failed = {};    ///< the step that did, and wasn't about the code
    bool is_limited = false; ///< whether a limit may have stopped it

    void make_copy() const {
        if (scratch.folder.empty())
            throw EnvironmentError{"cannot write in " + workspace.build.string() + " (" + std::strerror(scratch.error)
                                   + "): make it writable, or its disk less full"};
        std::ofstream copy{file, std::ios::binary}; // write_file would wait for the disk
        if (!(copy << text).flush()) throw EnvironmentError{"the disk is full; make some room and try again"};
    }

    std::string object() const { return scratch.folder / "student.o"; }
    std::string subject() const { return scratch.folder / "subject"; }

    /// @return why it could not be compiled or linked, which is never the machine's fault
    std::optional<Verdict> build(std::vector<std::string> &warnings) {
        auto why = make(warnings);
        if (!why || failed.code == 0) return why;
        ask_the_machine();
        if (is_limited) return why;
        failed = {};
        return make(warnings); // it may have been killed once, by whatever was short of memory
    }

    /// Compiles and links, and asks no machine why it failed. What's quoted of a program that gave up doesn't say where
    /// we work.
    std::optional<Verdict> make(std::vector<std::string> &warnings) {
        auto why = compile(warnings);
        if (!why) why = link();
        if (!why) return {};
        replace_all(why->sentence, file.string(), name);
        replace_all(why->sentence, scratch.folder.string() + '/', "");
        return why;
    }

    /// Whether a file that's known to be good can be compiled and linked, beside this one and with the same limits, when
    /// nothing that this one has left takes room. @throws EnvironmentError if not
    void ask_the_machine() const {
        std::error_code ignored;
        for (const fs::directory_entry &each : fs::directory_iterator{scratch.folder, ignored})
            if (each.path() != file) fs::remove_all(each.path(), ignored);
        require_room(sanitize(failed.err), scratch.folder);
        BuildConfig slow = config;
        slow.quick.reset();
        const std::string stub = read_file(workspace.stub(section));
        SubjectBuild good{workspace, section, slow, name, stub, {}};
        good.make_copy();
        std::vector<std::string> warnings;
        if (good.make(warnings)) throw EnvironmentError{machine_trouble_in(good.failed, sanitize(good.failed.err))};
    }

    /// @return why it could not be compiled
    std::optional<Verdict> compile(std::vector<std::string> &warnings) {
        if (!protection_of_this_kernel().files)
            if (auto why = look_elsewhere()) return why;
        if (auto why = quickly(); why || is_linked) return why;
        const auto compiled = run_compiler(compile_command(config.compiler), compiler_limits);
        const std::string output = sanitize(compiled.err);
        if (auto why = stopped(compiled, output); !why.empty())
            return Verdict{.kind = Outcome::does_not_compile, .sentence = std::move(why)};
        if (compiled.code != 0) return why_not_compiled(output, file, name, text, facts_of(workspace, section));
        warnings = find_warnings(output, file, name);
        return {};
    }

    /// Links what `compile` has made.
    /// @return why it could not be linked
    std::optional<Verdict> link() {
        if (is_linked) return {};
        const auto linked = link_with({});
        if (linked.code == 0) return {};
        const std::string linker = sanitize(linked.err);
        auto why = stopped(linked, linker);
        return why.empty() ? diagnose_linker(linker, name, section.short_number())
                           : Verdict{.kind = Outcome::does_not_link, .sentence = std::move(why)};
    }

    /// The functions of the object, as nm lists them.
    std::string symbols() const {
        const std::vector<std::string> command{config.nm, "-C", "--defined-only", object()};
        return sanitize(run_tool(command, allowed_paths(command), compiler_limits).out);
    }

  private:
    /// What a limit may have done to a step that failed, in a sentence; it's noted if the machine is to be asked.
    std::string stopped(const Finished &finished, const std::string &output) {
        std::string why = stopped_by_a_limit(finished, output);
        is_limited = !why.empty();
        if (finished.code != 0 && !is_about_the_code(finished, output)) failed = finished;
        return why;
    }

    /// By the quick compiler. Whatever it has to complain of is left to the other one, whose words students read, but for
    /// a reference to what's gone; and so is a `switch`: if it has all values of an enum, only GCC wants a return behind it.
    /// @return why no compiler need try again
    std::optional<Verdict> quickly() {
        if (!config.quick || text.find("switch") != text.npos) return {};
        Limits limits = compiler_limits;
        limits.processor_time = quick_enough;
        const auto compiled = run_compiler(compile_command(*config.quick), limits);
        if (compiled.timed_out) return Verdict{.kind = Outcome::does_not_compile, .sentence = stopped(compiled, "")};
        if (contains(compiled.err, ",-Wdangling-gsl]")) // GCC 12 takes it without a word
            return diagnose_compiler(sanitize(compiled.err), file, name, text, renamed(workspace, section));
        is_linked = compiled.code == 0 && compiled.err.empty() && link_with(config.quick_link).code == 0;
        return {};
    }

    /// Where the kernel can't keep the compiler from other files: whether the preprocessor would read any, before a word
    /// is passed on of one that might quote them. It passes over headers that aren't there.
    std::optional<Verdict> look_elsewhere() {
        auto command = compile_command(config.compiler);
        const std::string list = scratch.folder / "includes";
        command.insert(command.end(), {"-M", "-MG", "-MF", list, "-fmax-errors=0"});
        const auto scanned = run_compiler(command, compiler_limits);
        std::string why = stopped(scanned, sanitize(scanned.err));
        if (why.empty()
            && (!fs::exists(list) || included_from_elsewhere(read_file(list), file, scratch.folder, config.includes)))
            why = explain_unopened();
        if (why.empty()) return {};
        return Verdict{.kind = Outcome::does_not_compile, .sentence = std::move(why)};
    }

    /// A compiler reads headers besides, and what it writes, it assembles.
    Finished run_compiler(const std::vector<std::string> &command, const Limits &limits) const {
        AllowedPaths places = allowed_paths(command);
        places.readable.insert(places.readable.end(), config.includes.begin(), config.includes.end());
        places.writable = {scratch.folder, "/dev/null"};
        return run_tool(command, places, limits);
    }

    /// A compiler, a linker or nm, which can open these places and nothing else.
    Finished run_tool(const std::vector<std::string> &command, const AllowedPaths &places, const Limits &limits) const {
        const Sandbox sandbox{places, {.calls = false, .privileges = false}};
        return run(command,
                   {.deadline = longest_compilation,
                    .idle_limit = longest_wait,
                    .folder = scratch.folder,
                    .limits = limits,
                    .environment = {usual_path, "LC_ALL=C.UTF-8", "HOME=" + scratch.folder.string(), // for ccache
                                    "TMPDIR=" + scratch.folder.string() + '/'},
                    .in_child = [&sandbox] { return sandbox.shut(STDERR_FILENO); }});
    }
    std::vector<std::string> compile_command(const Compiler &compiler) const {
        auto command = compiler.command(workspace, section, file, object());
        command.push_back("-fmacro-prefix-map=" + (scratch.folder / "").string() + "="); // for __FILE__ of an assert
        return command;
    }
    /// What stands in for missing functions, all but the lent ones: before ours, of which it leaves no others.
    std::string missing_but_lent() const {
        const std::string but_lent = scratch.folder / "missing.o";
        std::vector<std::string> command{config.objcopy, "--wildcard"};
        for (const std::string &function : lent)
            command.push_back("--localize-symbol=_ZN*" + std::to_string(function.size()) + function + "E*");
        command.insert(command.end(), {config.missing.string(), but_lent});
        const Finished done = run(command);
        if (done.code != 0) throw EnvironmentError{"objcopy stopped: " + sanitize(done.err) + "Nothing was judged"};
        return but_lent;
    }
    Finished link_with(const std::vector<std::string> &also) const {
        std::vector<std::string> command{config.compiler.program, object(), config.server.string()};
        if (!lent.empty()) // without those that aren't called by name: at a known distance from one that is, they could be
            command.insert(command.end(), {missing_but_lent(), config.ours.string(), "-Wl,--gc-sections"});
        command.insert(command.end(), {config.missing.string(), "-o", subject()});
        command.insert(command.end(), also.begin(), also.end());
        command.insert(command.end(), config.earlier.begin(), config.earlier.end());
        command.insert(command.end(), config.link.begin(), config.link.end());
        AllowedPaths places = allowed_paths(command);
        places.writable = {scratch.folder, "/dev/null"};
        return run_tool(command, places, compiler_limits);
    }
};

} // namespace

std::vector<Verdict> one_for_each(const std::vector<KnownTest> &tests, const std::string &output) {
    std::vector<Verdict> reported, verdicts;
    for (const Line &line : split_lines(output))
        if (auto verdict = from_line(line.text)) reported.push_back(std::move(*verdict)); // else its test has none
    const auto none = [](const KnownTest &test, const char *sentence) {
        return Verdict{
            .exercise = test.exercise, .test = test.claim, .kind = Outcome::no_verdict, .sentence = sentence};
    };
    for (const KnownTest &test : tests) {
        const auto is_of_test = [&](const Verdict &v) { return v.exercise == test.exercise && v.test == test.claim; };
        const auto first_match = std::stable_partition(reported.begin(), reported.end(), std::not_fn(is_of_test));
        const auto count = reported.end() - first_match;
        verdicts.push_back(count == 1 ? *first_match
                                      : none(test, count == 0 ? "This test didn't say what it found."
                                                              : "This test said more than once what it found."));
        reported.erase(first_match, reported.end());
    }
    for (const Verdict &other : reported)
        verdicts.push_back(none({other.exercise, other.test}, "This test isn't in the section's list of tests."));
    return verdicts;
}

JudgeResult judge(const Workspace &workspace, const Section &section, const fs::path &given, const JudgeOptions &how) {
    return judge(workspace, section, workspace.relative_name(given), read_answer(given), how);
}

JudgeResult judge(const Workspace &workspace, const Section &section, const std::string &name, const std::string &text,
                  const JudgeOptions &how) {
    if (auto trouble = trouble_in(text, name, section, workspace.sections(), Reader::terminal))
        return not_built(*trouble);

    if (!how.lent.empty()) workspace.require_solution(section, "Grade with the whole course, which has them");
    require_room_in_files();
    const BuildConfig config = build_config(workspace, section);
    bring_up_to_date(workspace, section, config);
    sweep(workspace.build / "loop");
    SubjectBuild build{workspace, section, config, name, text, how.lent};
    build.make_copy();
    std::vector<std::string> warnings;
    const auto trouble = build.build(warnings);
    if (!trouble || trouble->kind == Outcome::does_not_link)
        for (const std::string &warning : warnings_in(text, name)) warnings.push_back(warning);
    if (trouble) return not_built(*trouble, warnings);

    auto tests = tests_of(workspace, section);
    if (!how.exercise.empty())
        std::erase_if(tests, [&](const KnownTest &test) { return test.exercise != how.exercise; });
    JudgeResult judgement{{}, one_for_each(tests, run_tests(workspace, section, build.subject(), how)), warnings};
    std::vector<Verdict> &verdicts = judgement.verdicts;
    if (std::ranges::count(verdicts, Outcome::missing, &Verdict::kind) > 0)
        help_the_missing(verdicts, build.symbols(), facts_of(workspace, section));
    help_the_accepting(verdicts, text, read_file(workspace.stub(section)));
    return judgement;
}

} // namespace course
