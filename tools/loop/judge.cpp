#include "loop/judge.hpp"

#include "ground/files.hpp"
#include "ground/kernel.hpp"
#include "ground/lines.hpp"
#include "ground/plain.hpp"
#include "ground/process.hpp"
#include "loop/answer.hpp"
#include "loop/compiling.hpp"
#include "loop/diagnosis.hpp"
#include "loop/toolbox.hpp"
#include "verdict/tests/shut_in.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>

namespace course {
namespace fs = std::filesystem;

bool Judgement::all_passed() const {
    return !unbuilt && !verdicts.empty() && std::ranges::all_of(verdicts, &Verdict::passed);
}
bool Judgement::our_fault() const {
    return std::ranges::any_of(verdicts, [](const Verdict &v) { return v.kind == Kind::no_verdict; });
}

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

Judgement not_built(Verdict why, std::vector<std::string> warnings = {}) {
    return {std::move(why), {}, std::move(warnings)};
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
std::string run_tests(const Tree &tree, const Section &section, const std::string &subject, const Judging &how) {
    std::vector<std::string> command{tree.test_program(section).string(), subject, "--json", "--seed",
                                     std::to_string(how.seed)};
    if (!how.exercise.empty()) command.insert(command.end(), {"--exercise", how.exercise});
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

/// A student's file becomes a subject, the program against which tests run. Compilers see a copy of it, with nothing
/// beside it and a name that none of them stumbles over.
struct SubjectBuild {
    const Tree &tree;
    const Section &section;
    const Toolbox &tools;
    const std::string &name, &text;
    const bool with_ours;
    const Scratch scratch{tree.work() / "loop" / "judge"};
    const fs::path file = scratch.folder / "student.cpp";
    const ShutIn shut_in{places_of(tools, scratch.folder), {.calls = false, .privileges = false}};
    bool is_linked = false;

    void make_copy() const {
        if (scratch.folder.empty())
            throw MachineTrouble{"cannot write in " + tree.work().string() + " (" + std::strerror(scratch.error)
                                 + "): make it writable, or its disk less full"};
        std::ofstream copy{file, std::ios::binary}; // write_file would wait for the disk
        if (!(copy << text).flush()) throw MachineTrouble{"the disk is full; make some room and try again"};
    }

    std::string object() const { return scratch.folder / "student.o"; }
    std::string subject() const { return scratch.folder / "subject"; }

    /// @return why it could not be compiled
    std::optional<Verdict> compile(std::vector<std::string> &warnings) {
        if (!protection_of_this_kernel().files)
            if (auto why = look_elsewhere()) return why;
        if (auto why = quickly(); why || is_linked) return why;
        const auto compiled = run_tool(compile_command(tools.compiler), compiler_limits);
        const std::string said = plain_output(compiled.err);
        if (auto why = stopped_by_a_limit(compiled, said); !why.empty())
            return Verdict{.kind = Kind::does_not_compile, .sentence = std::move(why)};
        if (compiled.code != 0) return diagnose_compiler(said, file, name, renamed(tree, section));
        warnings = find_warnings(said, file, name);
        return {};
    }

    /// What that has compiled.
    /// @return why it could not be linked
    std::optional<Verdict> link() const {
        if (is_linked) return {};
        const auto linked = link_with({});
        if (linked.code == 0) return {};
        const std::string linker = plain_output(linked.err);
        auto why = stopped_by_a_limit(linked, linker);
        return why.empty() ? diagnose_linker(linker, name, section.short_number())
                           : Verdict{.kind = Kind::does_not_link, .sentence = std::move(why)};
    }

    /// The functions of the object, as nm lists them.
    std::string symbols() const {
        return plain_output(run_tool({tools.nm, "-C", "--defined-only", object()}, compiler_limits).out);
    }

  private:
    /// By the quick compiler. Whatever it has to complain of is left to the other one, whose words students read, and
    /// so is a `switch`: if it has all values of an enum, only GCC wants a return behind it.
    /// @return why no compiler need try again
    std::optional<Verdict> quickly() {
        if (!tools.quick || text.find("switch") != text.npos) return {};
        Limits limits = compiler_limits;
        limits.processor_time = quick_enough;
        const auto compiled = run_tool(compile_command(*tools.quick), limits);
        if (compiled.timed_out)
            return Verdict{.kind = Kind::does_not_compile, .sentence = stopped_by_a_limit(compiled, "")};
        is_linked = compiled.code == 0 && compiled.err.empty() && link_with(tools.quick_link).code == 0;
        return {};
    }

    /// Where the kernel can't keep the compiler from other files: whether the preprocessor would read any, before a word
    /// is passed on of one that might quote them. It passes over headers that aren't there.
    std::optional<Verdict> look_elsewhere() const {
        auto command = compile_command(tools.compiler);
        const std::string list = scratch.folder / "includes";
        command.insert(command.end(), {"-M", "-MG", "-MF", list, "-fmax-errors=0"});
        const auto listed = run_tool(command, compiler_limits);
        std::string why = stopped_by_a_limit(listed, plain_output(listed.err));
        if (why.empty()
            && (!fs::exists(list) || included_from_elsewhere(read_file(list), file, scratch.folder, tools.includes)))
            why = explain_unopened();
        if (why.empty()) return {};
        return Verdict{.kind = Kind::does_not_compile, .sentence = std::move(why)};
    }

    /// A compiler, a linker or nm, which can open what it needs and nothing else.
    Finished run_tool(const std::vector<std::string> &command, const Limits &limits) const {
        return run(command,
                   {.deadline = longest_compilation,
                    .patience = longest_wait,
                    .folder = scratch.folder,
                    .limits = limits,
                    .environment = {usual_path, "LC_ALL=C.UTF-8", "HOME=" + scratch.folder.string(), // for ccache
                                    "TMPDIR=" + scratch.folder.string() + '/'},
                    .shut_in = &shut_in});
    }
    std::vector<std::string> compile_command(const Compiler &compiler) const {
        auto command = compiler.command(tree, section, file, object());
        command.push_back("-fmacro-prefix-map=" + (scratch.folder / "").string() + "="); // for __FILE__ of an assert
        return command;
    }
    Finished link_with(const std::vector<std::string> &also) const {
        std::vector<std::string> command{tools.compiler.program, object(), tools.server.string()};
        if (with_ours) // without those that aren't called by name: at a known distance from one that is, they could be, too
            command.insert(command.end(), {tools.ours.string(), "-Wl,--gc-sections"});
        command.insert(command.end(), {tools.missing.string(), "-o", subject()});
        command.insert(command.end(), also.begin(), also.end());
        command.insert(command.end(), tools.earlier.begin(), tools.earlier.end());
        command.insert(command.end(), tools.link.begin(), tools.link.end());
        return run_tool(command, compiler_limits);
    }
};

/// For a function that is missing: how the header declares it, and what is there instead.
void help_the_missing(std::vector<Verdict> &verdicts, const Tree &tree, const Section &section,
                      const SubjectBuild &build) {
    std::string defined, header; // read once, and only if a function is missing
    for (auto &verdict : verdicts) {
        if (verdict.kind != Kind::missing || !verdict.call) continue;
        if (defined.empty()) {
            defined = build.symbols();
            header = read_file(tree.header(section));
        }
        verdict.sentence += explain_missing(defined, header, verdict.call->function, renamed(tree, section));
    }
}

} // namespace

std::vector<Verdict> one_for_each(const std::vector<KnownTest> &tests, const std::string &said) {
    std::vector<Verdict> told, verdicts;
    for (const Line &line : lines_of(said))
        if (auto verdict = from_line(line.text)) told.push_back(std::move(*verdict)); // else its test has none
    const auto none = [](const KnownTest &test, const char *sentence) {
        return Verdict{.exercise = test.exercise, .test = test.claim, .kind = Kind::no_verdict, .sentence = sentence};
    };
    for (const KnownTest &test : tests) {
        const auto is_its = [&](const Verdict &v) { return v.exercise == test.exercise && v.test == test.claim; };
        const auto its = std::stable_partition(told.begin(), told.end(), std::not_fn(is_its));
        const auto count = told.end() - its;
        verdicts.push_back(count == 1 ? *its
                                      : none(test, count == 0 ? "This test didn't say what it found."
                                                              : "This test said more than once what it found."));
        told.erase(its, told.end());
    }
    for (const Verdict &other : told)
        verdicts.push_back(none({other.exercise, other.test}, "This test isn't in the section's list of tests."));
    return verdicts;
}

Judgement judge(const Tree &tree, const Section &section, const fs::path &given, const Judging &how) {
    return judge(tree, section, tree.shown(given), read_answer(given), how);
}

Judgement judge(const Tree &tree, const Section &section, const std::string &name, const std::string &text,
                const Judging &how) {
    if (auto trouble = diagnose_text(text, name, section.short_number())) return not_built(*trouble);
    if (auto trouble = diagnose_section(text, name, tree, section)) return not_built(*trouble);

    if (how.with_ours) tree.require_solution(section, "Grade with the whole course, which has them");
    require_room_in_files();
    const Toolbox tools = toolbox(tree, section);
    bring_up_to_date(tree, section, tools);
    sweep(tree.work() / "loop");
    SubjectBuild build{tree, section, tools, name, text, how.with_ours};
    build.make_copy();
    std::vector<std::string> warnings;
    if (auto trouble = build.compile(warnings)) return not_built(*trouble);
    for (const auto &find : {find_unreached, find_whole_divisions})
        for (const std::string &found : find(text, name)) warnings.push_back(found);
    if (auto trouble = build.link()) return not_built(*trouble, warnings);

    auto tests = tests_of(tree, section);
    if (!how.exercise.empty())
        std::erase_if(tests, [&](const KnownTest &test) { return test.exercise != how.exercise; });
    Judgement judgement{{}, one_for_each(tests, run_tests(tree, section, build.subject(), how)), warnings};
    help_the_missing(judgement.verdicts, tree, section, build);
    help_the_accepting(judgement.verdicts, tree, section, text);
    return judgement;
}

} // namespace course
