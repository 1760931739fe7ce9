// The main of a section's tests: runs them against a subject, a program with a student's code in it, and says what it saw.
//
//     07_segment_intersection SUBJECT               what a student reads
//     07_segment_intersection SUBJECT --json        the same for the `course` program, a line of JSON for each verdict
//     07_segment_intersection SUBJECT --answers F   judges the answers of tests/wrong and tests/right that file F lists
//     07_segment_intersection SUBJECT --mistakes F  what is known of those of tests/wrong that file F lists, by what comes out
//     07_segment_intersection SUBJECT --own F       what a reader's own tests make of the answers that file F lists
//     07_segment_intersection --catalogue           the section's exercises and tests, as JSON
//
// Catch2 finds the tests and runs them. What it would print is never looked at: the session owns the verdict.

#include "verdict/tests/harness.hpp"
#include "ground/kernel.hpp"
#include "ground/lines.hpp"
#include "verdict/shared/signature.hpp"

#include <catch2/catch_session.hpp>
#include <catch2/catch_translate_exception.hpp>
#include <catch2/interfaces/catch_interfaces_registry_hub.hpp>
#include <catch2/interfaces/catch_interfaces_testcase.hpp>
#include <catch2/internal/catch_clara.hpp>
#include <catch2/internal/catch_sharding.hpp>
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace course;

bool all_cases = false;
std::function<void(const Verdict &)> tell = [](const Verdict &) {};

std::string exercise_of(const Catch::TestCaseInfo &test) {
    return test.tags.empty() ? "?" : std::string{test.tags.front().original};
}

std::string thrown(const std::string &what) {
    if (what == "bad optional access") return "Your code answered \"nothing\" where there's something.";
    return "Your code refused this input with std::invalid_argument (" + what + "), but the header accepts it."
           + (session()->is_computed(what) ? " That number isn't in the input: your code computed it. Did it then "
                                             "call a function that refuses it?"
                                           : "");
}

/// To a student whose code is judged.
std::string of_your_code(const Catch::AssertionResult &result) {
    switch (result.getResultType()) {
    case Catch::ResultWas::DidntThrowException:
        return "Your code accepted input that the header says it refuses with std::invalid_argument.";
    case Catch::ResultWas::ThrewException: return thrown(std::string{result.getMessage()});
    case Catch::ResultWas::ExpressionFailed:
        if (std::string{result.getTestMacroName()}.ends_with("_THAT")) return {}; // yours and expected say it
        return what_does_not_hold(result);
    default: return std::string{result.getMessage()};
    }
}

/// Hears what happens in the tests, and passes it to the session.
class Listener : public Catch::EventListenerBase {
  public:
    using EventListenerBase::EventListenerBase;
    static std::string getDescription() { return "verdicts for students"; }

    void testCaseStarting(const Catch::TestCaseInfo &test) override { session()->begin(exercise_of(test), test.name); }
    void assertionStarting(const Catch::AssertionInfo &) override { session()->note({}); }

    void assertionEnded(const Catch::AssertionStats &stats) override {
        const auto &result = stats.assertionResult;
        if (result.isOk()) return;
        const auto where = result.getSourceInfo();
        session()->fail(Kind::wrong, explain_failure(result), where.file, static_cast<int>(where.line));
    }

    void testCaseEnded(const Catch::TestCaseStats &stats) override {
        const auto &asserted = stats.totals.assertions;
        auto verdict = session()->end(asserted.total() > asserted.skipped && asserted.skipped == 0);
        tell(verdict);
        verdicts.push_back(std::move(verdict));
    }
};

nlohmann::json catalogue() {
    nlohmann::json list = nlohmann::json::array();
    for (const ExerciseLine *exercise : exercise_lines())
        list.push_back({{"number", exercise->number}, {"tier", exercise->tier}, {"function", exercise->function}});
    nlohmann::json tests = nlohmann::json::array();
    for (const Catch::TestCaseInfo *test : all_tests())
        tests.push_back({{"exercise", exercise_of(*test)}, {"claim", test->name}});
    return {{"exercises", list}, {"tests", tests}};
}

/// A test that ran but was not heard of, or the other way round, is our mistake, and no student's.
void add_missing_verdicts(const Part &part) {
    for (const Catch::TestCaseInfo *test : Catch::createShard(all_tests(), part.of, part.index)) {
        if (!part.exercise.empty() && exercise_of(*test) != part.exercise) continue;
        if (std::ranges::any_of(verdicts, [&](const Verdict &v) { return v.test == test->name; })) continue;
        verdicts.push_back({.exercise = exercise_of(*test),
                            .test = test->name,
                            .kind = Kind::no_verdict,
                            .sentence = "This test didn't run: our mistake, not yours."});
        tell(verdicts.back());
    }
}

/// Such a process. It has children of its own, and so finds what a student's code has left behind.
[[noreturn]] void work(const Job &job, int items, int core, NamelessFile &lines) {
    end_with_parent(SIGKILL);
    try {
        prepare_for_subjects(core);
        for (unsigned item = 0; ::read(items, &item, sizeof item) == sizeof item;) job(item, lines);
        ::_exit(all_well);
    } catch (const MachineTrouble &trouble) {
        std::cerr << trouble.what() << std::endl;
    }
    ::_exit(machine_trouble);
}

/// Does a job for each item, in as many processes as there are cores, but at most so many, and adds what they tell.
/// @return all_well, or machine_trouble if the machine kept one of them from its end
int share(std::size_t most, const std::vector<unsigned> &items, const Job &job, std::vector<std::string> &told) {
    const std::vector<int> all = cores();
    std::vector<NamelessFile> lines(std::min(all.size(), most));
    std::vector<pid_t> processes;
    auto [queue, filling] = make_pipe(); // of all items: what one process reads from it, no other one gets
    const auto size = static_cast<ssize_t>(items.size() * sizeof items[0]);
    if (::write(filling, items.data(), static_cast<std::size_t>(size)) != size)
        throw MachineTrouble{"there is no room for a list of the tests"};
    filling.close();
    for (std::size_t worker = 0; worker < lines.size(); ++worker) {
        processes.push_back(::fork());
        if (processes.back() == 0) work(job, queue, all[worker], lines[worker]);
    }
    int code = all_well;
    for (std::size_t worker = 0; worker < lines.size(); ++worker) {
        int status = 0;
        if (processes[worker] < 0 || ::waitpid(processes[worker], &status, 0) < 0) code = machine_trouble;
        else if (WIFEXITED(status) && WEXITSTATUS(status) == machine_trouble) code = machine_trouble; // it said why
        else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
            std::cerr << "a part of them was killed from outside; has the machine run out of memory?" << std::endl;
            code = machine_trouble;
        }
        const std::string text = lines[worker].text(64u << 20);
        for (const Line &line : lines_of(text)) told.emplace_back(line.text);
    }
    return code;
}

/// Runs tests in some processes, a part for each, and adds their verdicts.
int run_in(std::size_t workers, const std::vector<unsigned> &which, const std::string &subject, unsigned seed,
           std::vector<Verdict> &said) {
    std::optional<Session> here; // a process has one for all of its tests
    const Job run_one = [&](unsigned test, NamelessFile &lines) {
        tell = [&](const Verdict &verdict) { lines.append(to_line(verdict)); };
        if (!here) here.emplace(subject, Patience{});
        run_tests(*here, seed, {test, static_cast<unsigned>(all_tests().size())});
        if (!here->trouble().empty()) throw MachineTrouble{here->trouble()};
    };
    std::vector<std::string> lines;
    const int code = share(workers, which, run_one, lines);
    for (const std::string &line : lines)
        if (auto verdict = from_line(line)) said.push_back(std::move(*verdict));
    return code;
}

/// Runs the tests of one exercise, or all, in as many processes as there are cores, up to four, and prints their
/// verdicts. That something takes too long counts when it has been seen twice, the second time with nothing beside it:
/// once for each exercise, whose other tests need no further proof then.
/// @return as run_in
int run_side_by_side(const std::string &subject, unsigned seed, const std::string &exercise) {
    std::vector<unsigned> which;
    std::map<std::pair<std::string, std::string>, unsigned> places;
    for (unsigned place = 0; place < all_tests().size(); ++place) {
        const Catch::TestCaseInfo &test = *all_tests()[place];
        places[{exercise_of(test), test.name}] = place;
        if (exercise.empty() || exercise_of(test) == exercise) which.push_back(place);
    }
    const auto place_of = [&](const Verdict &verdict) { return places[{verdict.exercise, verdict.test}]; };
    constexpr std::size_t most = 4;
    std::vector<Verdict> said;
    int code = run_in(most, which, subject, seed, said);
    std::ranges::sort(said, {}, place_of);
    std::set<std::string> proved;
    for (Verdict &verdict : said) {
        const std::string of =
            verdict.call ? verdict.exercise : ""; // without a call: it never starts, for any exercise
        if (verdict.kind != Kind::too_long || proved.contains(of) || code != all_well) continue;
        std::vector<Verdict> again;
        code = run_in(1, {place_of(verdict)}, subject, seed, again);
        if (again.size() == 1) verdict = std::move(again.front());
        if (verdict.kind == Kind::too_long) proved.insert(of);
    }
    for (const Verdict &verdict : said) std::cout << to_line(verdict);
    return code;
}

bool untouched(const Verdict &verdict) { return verdict.kind == Kind::not_started; }

/// Each exercise has a test that says "not started". Others may pass: a stub may refuse bad input.
bool nothing_started() {
    std::map<std::string, bool> waits;
    for (const Verdict &verdict : verdicts) {
        if (!verdict.passed() && !untouched(verdict)) return false;
        waits[verdict.exercise] |= untouched(verdict);
    }
    return std::ranges::all_of(waits, [](const auto &exercise) { return exercise.second; });
}

/// How many have passed: "8 of 13".
std::string passed_of_all() {
    const auto passed = std::ranges::count_if(verdicts, &Verdict::passed);
    return std::to_string(passed) + " of " + std::to_string(verdicts.size());
}

/// Whether the first verdict that is red shows this answer, as `yours` or as what the call `returned`, whatever its unit.
bool first_shows(const std::string &answer) {
    const auto red = std::ranges::find_if_not(verdicts, &Verdict::passed);
    if (red == verdicts.end()) return false;
    const auto is_it = [&](const std::string &text) { return (text + ' ').starts_with(answer + ' '); };
    return is_it(red->yours) || (red->call && is_it(red->call->answer));
}

/// Whether the verdicts are the ones that CI wants of this subject: all passed, none started, one that is red, or just so
/// many passed, and the first that is red shows some answer: "8 of 13, yours t = 0.5".
bool as_expected(std::string_view expect) {
    const auto no_verdict = [](const Verdict &v) { return v.kind == Kind::no_verdict; };
    if (verdicts.empty() || std::ranges::any_of(verdicts, no_verdict)) return false;
    if (expect == "none") return nothing_started();
    if (expect == "all") return std::ranges::all_of(verdicts, &Verdict::passed);
    if (std::ranges::any_of(verdicts, untouched)) return false;
    if (const std::size_t at = expect.find("yours "); at != expect.npos)
        return first_shows(std::string{expect.substr(at + 6)})
               && (at == 0 || expect.substr(0, at) == passed_of_all() + ", ");
    if (expect != "red") return passed_of_all() == expect;
    return !std::ranges::all_of(verdicts, &Verdict::passed);
}

/// A verdict, for us.
std::string in_words(const Verdict &verdict) {
    const std::string test = verdict.exercise + "  " + verdict.test + '\n';
    if (verdict.passed()) return "passed  " + test;
    return "FAILED  " + test + "        " + std::string{name_of(verdict.kind)} + '\n' + explain(verdict, 8);
}

/// Whether it is enough that one verdict is red.
bool wants_red(std::string_view expect) { return expect == "red" || expect.starts_with("yours "); }

/// How long a subject is waited for whose verdicts are known. The machine may be slow; but a wrong one may well hang, and
/// will be no less wrong after a minute. Where a count is expected, what a student sees as too slow must be too slow.
Patience patience_for(const std::string &expect) {
    if (wants_red(expect)) return {};
    const bool all = expect == "all" || expect == "none";
    return {.a_case = all ? 60 : Patience{}.a_case, .all = 600, .start = 60};
}

/// Judges a subject of which it is known what comes out, exercise by exercise or as a whole.
/// @return whether that is what came out
bool judge_known(const std::string &subject, const std::string &answer, const std::string &exercise,
                 const std::string &expect, unsigned seed) {
    verdicts.clear();
    Session here{subject, patience_for(expect), answer};
    run_tests(here, seed, {.exercise = exercise, .until_red = wants_red(expect)});
    if (!here.trouble().empty()) throw MachineTrouble{here.trouble()};
    return as_expected(expect);
}

/// Judges many answers, which are in one subject, and tells of those that are not judged as expected.
/// @return the exit code
int judge_answers(const std::string &subject, const std::string &list, unsigned seed) {
    const std::vector<Answer> answers = read_list(list);
    if (answers.empty()) {
        std::cerr << list << " lists no answers\n";
        return 2;
    }
    const std::string good = "as expected";
    const Job judge_one = [&](unsigned which, NamelessFile &lines) {
        const auto &[name, exercise, expect] = answers[which];
        if (judge_known(subject, name, exercise, expect, seed)) return lines.append(good + '\n');
        lines.append("NOT as expected: " + name + ' ' + exercise + ' ' + expect + ", but " + passed_of_all() + '\n');
        for (const Verdict &verdict : verdicts)
            if (!verdict.passed()) lines.append(in_words(verdict));
    };
    std::vector<std::string> told;
    const int code = share_all(answers.size(), judge_one, told);
    const auto right = static_cast<std::size_t>(std::ranges::count(told, good));
    for (const std::string &line : told)
        if (line != good) std::cout << line << '\n';
    std::cout << right << " of " << answers.size() << " answers are judged as expected (seed " << seed << ")\n";
    return code != all_well ? code : right == answers.size() ? 0 : 1;
}

/// What the tests of its exercise say of an answer, with each of these seeds, until one takes too long: others would, too.
const std::vector<Verdict> &verdicts_on(const std::string &subject, const Answer &answer,
                                        std::initializer_list<unsigned> seeds) {
    Session here{subject, {}, answer.name};
    verdicts.clear();
    for (const unsigned seed : seeds)
        for (unsigned place = 0; place < all_tests().size(); ++place) {
            if (exercise_of(*all_tests()[place]) != answer.exercise) continue;
            run_tests(here, seed, {place, static_cast<unsigned>(all_tests().size())});
            if (!here.trouble().empty()) throw MachineTrouble{here.trouble()};
            if (verdicts.back().kind == Kind::too_long) return verdicts;
        }
    return verdicts;
}

/// Prints which tests stop each wrong answer of a list, by their places in the file, from 1: "7.2 wrong_meet_never 3 4 9".
/// One that stops where others stop too, and that no reader would give, can go.
/// @return the exit code
int print_kills(const std::string &subject, const std::string &list) {
    std::vector<Answer> answers = read_list(list);
    std::erase_if(answers, [](const Answer &answer) { return !answer.is_wrong(); });
    const auto place_of = [](const Verdict &verdict) {
        return std::ranges::find(all_tests(), verdict.test, &Catch::TestCaseInfo::name) - all_tests().begin();
    };
    const Job judge_one = [&](unsigned which, NamelessFile &lines) {
        std::string stopped_by = answers[which].exercise + ' ' + answers[which].name;
        for (const Verdict &verdict : verdicts_on(subject, answers[which], {2026}))
            if (!verdict.passed()) stopped_by += ' ' + std::to_string(place_of(verdict) + 1);
        lines.append(stopped_by + '\n');
    };
    std::vector<std::string> told;
    const int code = share_all(answers.size(), judge_one, told);
    std::ranges::sort(told);
    for (const std::string &line : told) std::cout << line << '\n';
    return code;
}

/// Prints what `check` knows mistakes by: which tests generate their input, so that what they say proves nothing, and a
/// line for each mistake: its exercise, the signature of what comes out in all others, and what the reader did.
/// @return the exit code
/// @param kept  a file that must be the same; "": nothing need be
int print_mistakes(const std::string &subject, const std::string &list, const std::string &kept) {
    std::vector<Answer> mistakes = read_list(list);
    std::erase_if(mistakes, [](const Answer &answer) { return !answer.is_wrong(); });
    const Job judge_one = [&](unsigned which, NamelessFile &lines) {
        const auto &said = verdicts_on(subject, mistakes[which], {2026, 7});
        if (said.empty() || said.back().kind == Kind::too_long)
            return; // nobody knows what the other tests would have seen
        for (const Verdict &verdict : said) lines.append(std::to_string(which) + ' ' + to_line(verdict));
    };
    std::vector<std::string> told;
    if (const int code = share_all(mistakes.size(), judge_one, told); code != all_well) return code;

    std::vector<std::map<std::string, std::vector<Verdict>>> seen(mistakes.size()); // of each mistake, by tests
    for (const std::string &line : told)
        if (auto verdict = from_line(line.substr(line.find(' ')))) {
            auto &of = seen[std::stoul(line)][verdict->test];
            of.push_back(std::move(*verdict));
        }
    const auto call_of = [](const Verdict &verdict) {
        return verdict.call ? verdict.call->arguments : std::vector<std::string>{};
    };
    std::set<std::pair<std::string, std::string>> generated;
    for (const auto &of : seen)
        for (const auto &[test, both] : of)
            if (seen_by(both.front()) != seen_by(both.back()) || call_of(both.front()) != call_of(both.back()))
                generated.insert({both.front().exercise, test});
    std::set<std::string> lines;
    for (const auto &[exercise, test] : generated) lines.insert(exercise + "\tgenerated\t" + test);
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        std::vector<Verdict> failed;
        for (const auto &[test, both] : seen[i])
            if (!both.front().passed() && !generated.contains({mistakes[i].exercise, test}))
                failed.push_back(both.front());
        if (!failed.empty()) lines.insert(mistakes[i].exercise + '\t' + signature(failed) + '\t' + mistakes[i].rest);
    }
    if (kept.empty()) {
        for (const std::string &line : lines) std::cout << line << '\n';
        return all_well;
    }
    std::ifstream file{kept};
    std::set<std::string> before;
    for (std::string line; std::getline(file, line);) before.insert(line);
    if (before == lines) return all_well;
    std::cout << kept << " isn't what comes out of the wrong answers; type: ./course publish --mistakes\n";
    const auto print = [](const char *sign, const auto &these, const auto &others) {
        for (const std::string &line : these)
            if (!others.contains(line)) std::cout << sign << line << '\n';
    };
    print("-", before, lines);
    print("+", lines, before);
    return 1;
}

} // namespace

CATCH_REGISTER_LISTENER(Listener)

// What a test calls by itself is ours, and so is done; in a handout, an earlier section's functions are the student's.
CATCH_TRANSLATE_EXCEPTION(const course::NotYet &hint) {
    session()->note_not_started(hint.what(), hint.function);
    return hint.what();
}

namespace course {

std::vector<Verdict> verdicts;
InWords explain_failure = of_your_code;

std::string what_does_not_hold(const Catch::AssertionResult &result) {
    const std::string written{result.getExpression()};
    std::string found = result.getExpandedExpression(); // in three lines, where it's long
    std::ranges::replace(found, '\n', ' ');
    return "This doesn't hold: " + written + (found == written ? "" : ", that is " + found);
}

const std::vector<Catch::TestCaseInfo *> &all_tests() {
    return Catch::getRegistryHub().getTestCaseRegistry().getAllInfos();
}

void run_tests(Session &here, unsigned seed, const Part &part) {
    static Catch::Session catch2; // there may be only one
    session() = &here;
    Catch::ConfigData config;
    config.rngSeed = seed;
    config.shardIndex = part.index;
    config.shardCount = part.of;
    config.defaultOutputFilename = "/dev/null"; // nobody reads what Catch2 says
    config.allowZeroTests = true;
    if (!part.exercise.empty()) config.testsOrTags = {"[" + part.exercise + "]"};
    if (part.until_red) config.abortAfter = 1;
    catch2.useConfigData(config);
    catch2.run();
    if (!part.until_red) add_missing_verdicts(part);
}

int share_all(std::size_t count, const Job &job, std::vector<std::string> &told) {
    std::vector<unsigned> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return count == 0 ? +all_well : share(count, all, job, told);
}

std::vector<Answer> read_list(const std::string &file) {
    std::vector<Answer> answers;
    std::ifstream in{file};
    for (Answer next; in >> next.name >> next.exercise && std::getline(in >> std::ws, next.rest);)
        answers.push_back(next);
    return answers;
}

int cases(int full) { return all_cases ? full : full / 100; }

} // namespace course

int main(int argc, char **argv) try {
    std::string subject, answers, kills, mistakes, own, kept, exercise, expect;
    bool json = false, list = false;
    unsigned seed = 2026;
    using Catch::Clara::Opt;
    const auto line =
        Catch::Clara::Arg(subject, "subject")("the program with the code to judge")
        | Opt(json)["--json"]("print each verdict as a line of JSON")
        | Opt(seed, "number")["--seed"]("for generated values")
        | Opt(exercise, "7.2")["--exercise"]("only the tests of this one")
        | Opt(expect, "verdicts")["--expect"](
            "exit with 0 if these come out: all (passed), none (started), red, or so many: \"8 of 13\", "
            "\"8 of 13, yours 0.5\"")
        | Opt(all_cases)["--all-cases"]("every generated case, instead of a hundredth")
        | Opt(answers, "list")["--answers"]("judge the answers that this file lists, which `subject` holds")
        | Opt(kills, "list")["--kills"]("print which tests stop each of the wrong answers that this file lists")
        | Opt(mistakes, "list")["--mistakes"]("print what the mistakes that this file lists are known by")
        | Opt(own, "list")["--own"]("run a reader's tests against the answers that this file lists")
        | Opt(kept, "file")["--kept"]("which must be what --mistakes would print")
        | Opt(list)["--catalogue"]("list the exercises as JSON, and leave");
    if (const auto parsed = line.parse({argc, argv}); !parsed) {
        std::cerr << parsed.errorMessage() << '\n' << line;
        return 2;
    }
    if (list) {
        std::cout << catalogue().dump(1) << '\n';
        return 0;
    }
    hide_from_other_processes();
    if (json) return run_side_by_side(subject, seed, exercise);
    if (!answers.empty()) return judge_answers(subject, answers, seed);
    if (!kills.empty()) return print_kills(subject, kills);
    if (!mistakes.empty()) return print_mistakes(subject, mistakes, kept);
    if (!own.empty()) return judge_own_tests(subject, own);
    tell = [](const Verdict &verdict) { std::cout << in_words(verdict); };
    prepare_for_subjects(cores().front());
    const bool good = judge_known(subject, {}, exercise, expect.empty() ? "all" : expect, seed);
    std::cout << passed_of_all() << " passed (seed " << seed << ")\n";
    return good ? 0 : 1;
} catch (const MachineTrouble &trouble) {
    std::cerr << trouble.what() << std::endl;
    return machine_trouble;
}
