#include "loop/own_tests.hpp"

#include "ground/build.hpp"
#include "ground/files.hpp"
#include "ground/kernel.hpp"
#include "ground/lines.hpp"
#include "ground/lock.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"
#include "loop/answer.hpp"
#include "loop/catalogue.hpp"
#include "loop/diagnosis.hpp"
#include "verdict/tests/shut_in.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>

namespace course {
namespace fs = std::filesystem;

std::string empty_own_tests(const Tree &tree, const Section &section) {
    const std::string number = section.short_number(), name = section.slug() + "::subject";
    return "// Your own tests of section " + number + ". Save, and see which mistakes they catch:  ./course mytests "
           + number + "\n// Call a function, " + catalogue(tree, section).front().function
           + " or another one of this section, and say what must come out, up to rounding:\n"
             "//     CHECK_THAT(…, IsNear(2.5, 1e-9));   CHECK_THAT(…, IsNear(Vec2{3, 4}, 1e-9));   CHECK(… == "
             "Approx(2.5));\n"
             "\n#include \"own_test.hpp\"\n\n#include \""
           + section.slug() + ".hpp\"\n\nnamespace " + name
           + " {\n\nTEST_CASE(\"say here what must hold\") {\n}\n\n} // namespace " + name + '\n';
}

namespace {

using nlohmann::json;

fs::path answers_of(const Tree &tree, const Section &section) {
    return tree.build / "subjects" / section.name / "answers";
}

/// What is compiled: the reader's text, under the name of the reader's file.
void make_copy(const Tree &tree, const Section &section, const std::string &text) {
    write_file(tree.build / "own" / (section.name + ".cpp"),
               "#line 1 \"" + tree.own_tests(section).string() + "\"\n" + text);
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
    const std::string ours = section.slug() + "::";
    if (contains(printed, "undefined reference to `" + ours) || contains(printed, "undefined reference to '" + ours))
        return {.kind = Kind::does_not_link,
                .sentence = "A test calls a function from outside of the braces of `namespace " + ours
                            + "subject`: put all tests inside."};
    Verdict verdict = diagnose_linker(printed, name, section.short_number());
    verdict.sentence.resize(std::min(verdict.sentence.find(" `./course run"), verdict.sentence.size()));
    return verdict;
}

/// Why the tests can't be built, by what the build printed.
Verdict why_unbuilt(const Tree &tree, const Section &section, const std::string &printed) {
    const fs::path file = tree.own_tests(section);
    const std::string name = tree.shown(file);
    Verdict verdict = diagnose_compiler(printed, file, name, renamed(tree, section));
    if (verdict.line != 0 && verdict.file == name) {
        if (const std::string advice = advice_on_tests(verdict.sentence); !advice.empty())
            verdict.sentence += (verdict.sentence.ends_with(':') ? " " : ". ") + advice;
        return verdict;
    }
    if (contains(printed, "In file included from " + file.string()))
        return {.kind = Kind::does_not_compile,
                .sentence = "What your file includes doesn't compile there: is an #include inside of braces? Put it "
                            "at the top."};
    if (contains(printed, "undefined reference to") || contains(printed, "multiple definition of"))
        return why_unlinked(printed, name, section);
    throw Complaint{"the course's own files don't build (" + first_error(printed) + "); `cmake --build "
                    + tree.build.string() + " --target " + section.name + "_own` shows why"};
}

/// Runs the tests, which judge themselves.
/// @return what they printed, in lines of JSON
std::string run_own_tests(const Tree &tree, const Section &section) {
    constexpr double deadline = 120, patience = 5; // [s]
    const fs::path program = tree.build / "own" / section.name, answers = answers_of(tree, section),
                   claims = tree.build / "answers" / (section.name + "_claims.txt");
    Places places{places_of_system(), {"/dev/null"}};
    places.readable.insert(places.readable.end(), {program, answers, claims, "/proc"});
    const ShutIn shut_in{places,
                         {.calls = false, .privileges = false}}; // it starts the answers, which are shut in more
    const Finished done = run({program.string(), answers.string(), "--own", claims.string()},
                              {.deadline = deadline,
                               .patience = patience,
                               .limits = {.memory = sanitized ? 0 : std::size_t{4} << 30},
                               .environment = {usual_path, "LC_ALL=C.UTF-8"},
                               .shut_in = &shut_in});
    if (done.timed_out)
        throw Complaint{"your tests took too long and were stopped: does one of them wait for something, or call a "
                        "function a great many times?"};
    if (done.code != all_well)
        throw MachineTrouble{"your tests could not be run: "
                             + (done.err.empty() ? "they were killed from outside" : plain_output(done.err))};
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

void read(const std::string &said, const std::string &name, OwnJudgement &judgement) {
    for (const Line &each : lines_of(said)) {
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

void require_answers(const Tree &tree, const Section &section) {
    if (!tree.has_answers(section))
        throw Complaint{"this edition of the course has no answers to section " + section.short_number()
                        + " in it, right or wrong, so there's nothing that your tests could be run against"};
}

bool are_answers_built(const Tree &tree, const Section &section) { return fs::exists(answers_of(tree, section)); }

OwnJudgement judge_own_tests(const Tree &tree, const Section &section) {
    const std::string text = read_answer(tree.own_tests(section)), name = tree.shown(tree.own_tests(section));
    OwnJudgement judgement;
    judgement.unbuilt = diagnose_text(text, name, section.short_number() + " --tests");
    if (judgement.unbuilt) return judgement;
    const Lock lock{tree};
    make_copy(tree, section, text);
    const Finished built = build_target(tree, section.name + "_own");
    const std::string printed = built.out + '\n' + built.err;
    if (built.code != 0) judgement.unbuilt = why_unbuilt(tree, section, printed);
    else {
        judgement.warnings = find_warnings(printed, tree.own_tests(section), name);
        read(run_own_tests(tree, section), name, judgement);
    }
    return judgement;
}

} // namespace course
