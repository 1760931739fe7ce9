#include "check/own_tests.hpp"

#include "base/build.hpp"
#include "base/files.hpp"
#include "base/kernel.hpp"
#include "base/lines.hpp"
#include "base/lock.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"
#include "check/answer.hpp"
#include "check/answer_file.hpp"
#include "check/catalogue.hpp"
#include "check/diagnosis.hpp"
#include "judge/runner/sandbox.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;

std::string empty_own_tests(const Workspace &workspace, const Section &section) {
    const std::string number = section.short_number(), name = section.slug() + "::subject";
    return "// Your own tests of section " + number + ". Save, and see which mistakes they catch:  ./course mytests "
           + number + "\n// Call a function, " + catalogue(workspace, section).front().function
           + " or another one of this section, and say what must come out, up to rounding:\n"
             "//     CHECK_THAT(…, IsNear(2.5, 1e-9));   CHECK_THAT(…, IsNear(Vec2{3, 4}, 1e-9));   CHECK(… == "
             "Approx(2.5));\n"
             "\n#include \"own_test.hpp\"\n\n#include \""
           + section.slug() + ".hpp\"\n\nnamespace " + name
           + " {\n\nTEST_CASE(\"say here what must hold\") {\n}\n\n} // namespace " + name + '\n';
}

namespace {

using nlohmann::json;

fs::path answers_of(const Workspace &workspace, const Section &section) {
    return workspace.build / "subjects" / section.name / "answers";
}

/// What is compiled: the reader's text, under the name of the reader's file.
void make_copy(const Workspace &workspace, const Section &section, const std::string &text) {
    write_file(workspace.build / "own" / (section.name + ".cpp"),
               "#line 1 \"" + workspace.own_tests(section).string() + "\"\n" + text);
}

/// What helps with slips that only tests have; empty if nothing is known.
std::string advice_on_tests(std::string_view words) {
    if (contains(words, "no match for 'operator=='"))
        return "Structs are compared field by field in CHECK_THAT(…, IsNear(Name{…}, 1e-9)), with the struct's name.";
    if (contains(words, "class template argument deduction failed")
        || contains(words, "expected primary-expression before '{'"))
        return "Write the type before the braces: CHECK_THAT(…, IsNear(Vec2{3, 4}, 1e-9)).";
    return "";
}

/// Why the tests can't be linked.
Verdict why_unlinked(const std::string &printed, const std::string &name, const Section &section) {
    const std::string prefix = section.slug() + "::";
    if (contains(printed, "undefined reference to `" + prefix)
        || contains(printed, "undefined reference to '" + prefix))
        return {.kind = Outcome::does_not_link,
                .sentence = "A test calls a function from outside of the braces of `namespace " + prefix
                            + "subject`: put all tests inside."};
    Verdict verdict = diagnose_linker(printed, name, section.short_number());
    verdict.sentence.resize(std::min(verdict.sentence.find(" `./course run"), verdict.sentence.size()));
    return verdict;
}

/// Why the tests can't be built, by what the build printed.
/// @param text  of the file that they're in
Verdict why_unbuilt(const Workspace &workspace, const Section &section, const std::string &text,
                    const std::string &printed) {
    const fs::path file = workspace.own_tests(section);
    const std::string name = workspace.relative_name(file);
    Verdict verdict = diagnose_compiler(printed, file, name, text, renamed(workspace, section));
    if (verdict.line != 0 && verdict.file == name) {
        if (const std::string advice = advice_on_tests(verdict.sentence); !advice.empty())
            verdict.sentence += (verdict.sentence.ends_with(':') ? " " : ". ") + advice;
        return verdict;
    }
    if (contains(printed, "In file included from " + file.string()))
        return {.kind = Outcome::does_not_compile,
                .sentence = "What your file includes doesn't compile there: is an #include inside of braces? Put it "
                            "at the top."};
    if (contains(printed, "undefined reference to") || contains(printed, "multiple definition of"))
        return why_unlinked(printed, name, section);
    throw UserError{"the course's own files don't build (" + first_error(printed) + "); `cmake --build "
                    + workspace.build.string() + " --target " + section.name + "_own` shows why"};
}

/// Runs the tests, which judge themselves.
/// @return what they printed, in lines of JSON
std::string run_own_tests(const Workspace &workspace, const Section &section) {
    constexpr double deadline = 120, idle_limit = 5; // [s]
    const fs::path program = workspace.build / "own" / section.name, answers = answers_of(workspace, section),
                   claims = workspace.build / "answers" / (section.name + "_claims.txt");
    AllowedPaths places{system_paths(), {"/dev/null"}};
    places.readable.insert(places.readable.end(), {program, answers, claims, "/proc"});
    const Sandbox sandbox{places,
                          {.calls = false, .privileges = false}}; // it starts the answers, which are shut in more
    const Finished done = run({program.string(), answers.string(), claims.string()},
                              {.deadline = deadline,
                               .idle_limit = idle_limit,
                               .limits = {.memory = sanitized ? 0 : std::size_t{4} << 30},
                               .environment = {usual_path, "LC_ALL=C.UTF-8"},
                               .in_child = [&sandbox] { return sandbox.shut(STDERR_FILENO); }});
    if (done.timed_out)
        throw UserError{"your tests took too long and were stopped: does one of them wait for something, or call a "
                        "function a great many times?"};
    if (done.code != all_well)
        throw EnvironmentError{"your tests could not be run: "
                               + (done.err.empty() ? "they were killed from outside" : sanitize(done.err))};
    return done.out;
}

/// @param name  of the reader's file, which stands in the place of whatever the build called it
Verdict verdict_from(const json &line, const std::string &name) {
    Verdict verdict = from_line(line.at("verdict").dump()).value_or(Verdict{});
    if (!verdict.file.empty()) verdict.file = name;
    return verdict;
}

/// Some mistakes go by one name, as they are one, made in several ways: it's caught when all of them are.
void add(const KnownMistake &mistake, std::vector<KnownMistake> &all) {
    const auto same = std::ranges::find(all, mistake.what, &KnownMistake::what);
    if (same == all.end()) all.push_back(mistake);
    else same->caught = same->caught && mistake.caught;
}

void read(const std::string &output, const std::string &name, OwnJudgement &judgement) {
    for (const Line &each : split_lines(output)) {
        const json line = json::parse(each.text);
        if (line.contains("test"))
            judgement.tests.push_back(
                {line.at("test"), line.at("line"), line.at("calls"), verdict_from(line, name), line.at("sound")});
        else if (line.contains("mistake"))
            add({line.at("mistake"), line.at("caught")}, judgement.mistakes[line.at("exercise")]);
        else if (line.contains("verdict")) judgement.refusals.push_back({line.at("right"), verdict_from(line, name)});
        else judgement.right[line.at("exercise")] = line.at("right");
    }
}

} // namespace

void require_answers(const Workspace &workspace, const Section &section) {
    if (!workspace.has_answers(section))
        throw UserError{"this edition of the course has no answers to section " + section.short_number()
                        + " in it, right or wrong, so there's nothing that your tests could be run against"};
}

bool are_answers_built(const Workspace &workspace, const Section &section) {
    return fs::exists(answers_of(workspace, section));
}

OwnJudgement judge_own_tests(const Workspace &workspace, const Section &section) {
    const std::string text = read_answer(workspace.own_tests(section)),
                      name = workspace.relative_name(workspace.own_tests(section));
    OwnJudgement judgement;
    judgement.unbuilt = diagnose_text(text, name, section.short_number() + " --tests");
    if (judgement.unbuilt) return judgement;
    const Lock lock{workspace};
    make_copy(workspace, section, text);
    const Finished built = build_target(workspace, section.name + "_own");
    const std::string printed = built.out + '\n' + built.err;
    if (built.code != 0) judgement.unbuilt = why_unbuilt(workspace, section, text, printed);
    else {
        judgement.warnings = find_warnings(printed, workspace.own_tests(section), name);
        read(run_own_tests(workspace, section), name, judgement);
    }
    return judgement;
}

} // namespace course
