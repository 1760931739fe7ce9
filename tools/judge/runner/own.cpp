// A reader's own tests, run against answers of which we know what they are: our solution first, then the other right
// ones, which a test must accept, then the mistakes, of which it may catch some. It prints a line of JSON for each
//
//     test     {"test": its name, "line": of the file, "calls": ["2.1"], "verdict": on our solution, "sound": true}
//     refusal  {"right": "what is special about the answer", "verdict": of the test that refuses it}
//     mistake  {"mistake": "you swap the velocities", "exercise": "2.2", "caught": true}
//
// and {"exercise": "2.1", "right": 6} for each exercise that a test calls. A test is sound if no right answer fails it;
// no other one is asked about mistakes.

#include "base/errors.hpp"
#include "base/lines.hpp"
#include "judge/runner/answer_list.hpp"
#include "judge/runner/harness.hpp"
#include "judge/runner/job_queue.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <map>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace course {
namespace {

using nlohmann::json;

std::string line_of(const json &value) { return value.dump(-1, ' ', false, json::error_handler_t::replace) + '\n'; }

/// [s] of computing: what an answer may take, and what the test itself may.
struct Time {
    double answer = 1, test = 2;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Time, answer, test)

/// What came out of one test against one answer.
struct Result {
    Verdict verdict;
    std::vector<std::string> calls = {}; ///< exercises: "2.1"
    Time took = {0, 0};

    bool is_red() const { return !verdict.passed() && verdict.kind != Outcome::no_verdict; }
};
json as_json(const Verdict &verdict) { return json::parse(to_line(verdict)); }
void to_json(json &to, const Result &result) {
    to = {{"verdict", as_json(result.verdict)}, {"calls", result.calls}, {"took", result.took}};
}
void from_json(const json &from, Result &result) {
    result = {from_line(from.at("verdict").dump()).value(), from.at("calls"), from.at("took")};
}

std::string explain_to_author_of_test(const Catch::AssertionResult &result) {
    const std::string what{result.getMessage()};
    switch (result.getResultType()) {
    case Catch::ResultWas::DidntThrowException:
        return "Your test wants this to be refused, but it's answered. The header says what is refused.";
    case Catch::ResultWas::ThrewException:
        return what == "bad optional access" ? "The answer is \"nothing\" here, and your test takes a value out of it."
                                             : "This threw, and your test wants an answer: " + what;
    case Catch::ResultWas::ExpressionFailed: return session()->has_noted() ? "" : what_does_not_hold(result);
    default: return what;
    }
}

double seconds(const rusage &used) {
    const auto of = [](const timeval &t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return of(used.ru_utime) + of(used.ru_stime);
}
Time used_by_now() {
    rusage here{}, below{};
    ::getrusage(RUSAGE_SELF, &here);
    ::getrusage(RUSAGE_CHILDREN, &below);
    return {seconds(below), seconds(here)};
}

/// After so much computing a signal ends this process.
void limit_computing(double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(seconds);
    timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(timer.it_value.tv_sec)));
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

/// In a forked process: runs tests against one answer, and writes a line for each result; for trouble, only words.
[[noreturn]] void be_the_tests(const std::string &subject, const std::string &answer,
                               const std::vector<unsigned> &tests, const Time &most, bool until_red,
                               AnonymousFile &lines) try {
    limit_computing(most.test);
    explain_failure = explain_to_author_of_test;
    Session running{subject, {.a_case = most.answer}, answer};
    running.run_own_tests();
    for (const unsigned test : tests) {
        const Time before = used_by_now();
        verdicts.clear();
        run_tests(running, 2026, Part::only(test));
        const Time now = used_by_now();
        const Result result{verdicts.back(),
                            {running.called().begin(), running.called().end()},
                            {now.answer - before.answer, now.test - before.test}};
        lines.append(line_of(result));
        std::fflush(stdout); // what the test printed
        if (until_red && result.is_red()) break;
    }
    ::_exit(all_well);
} catch (const EnvironmentError &trouble) {
    lines.append(line_of(trouble.what()));
    ::_exit(machine_trouble);
}

/// The test that was running when the process ended.
Verdict ended(int status, const Catch::TestCaseInfo &test, const std::string &printed) {
    Verdict verdict{.test = test.name, .kind = Outcome::crashed};
    verdict.file = test.lineInfo.file;
    verdict.line = static_cast<int>(test.lineInfo.line);
    const std::string meaning = meaning_of_assertion(printed);
    if (!WIFSIGNALED(status)) {
        verdict.kind = Outcome::left;
        verdict.sentence = "Your test ended the program: it mustn't call exit().";
    } else if (WTERMSIG(status) == SIGPROF) {
        verdict.kind = Outcome::too_long;
        verdict.sentence = "Your test doesn't come to an end: look for a loop that never stops.";
    } else if (meaning.empty()) verdict.sentence = "Your test " + meaning_of_signal(WTERMSIG(status)) + '.';
    else verdict.sentence = "Your test was stopped by a check of the library: " + meaning + '.';
    return verdict;
}

/// Runs tests against one answer, in a process apart: what ends that process, a test did.
std::vector<Result> run_apart(const std::string &subject, const std::string &answer, const std::vector<unsigned> &tests,
                              const Time &most, bool until_red) {
    AnonymousFile lines, printed;
    const pid_t process = ::fork();
    if (process == 0) {
        for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(printed.descriptor(), stream);
        be_the_tests(subject, answer, tests, most, until_red, lines);
    }
    int status = 0;
    if (process < 0 || ::waitpid(process, &status, 0) < 0) throw EnvironmentError{"a test can't be started"};
    std::vector<Result> all;
    const std::string text = lines.text(64u << 20), output = printed.text(1u << 20);
    for (const Line &line : split_lines(text)) {
        const json reported = json::parse(line.text);
        if (reported.is_string()) throw EnvironmentError{reported.get<std::string>()};
        all.push_back(reported);
    }
    const bool is_whole = all.size() == tests.size() || (until_red && !all.empty() && all.back().is_red());
    if (!is_whole) all.push_back({ended(status, *all_tests()[tests[all.size()]], output)});
    for (Result &result : all)
        if (!result.verdict.passed() && result.verdict.printed.empty())
            std::tie(result.verdict.printed, result.verdict.printed_more) = tidy(output, 8);
    return all;
}

/// The tests of a reader's file, and what is known of them by now.
class OwnTests {
  public:
    OwnTests(const std::string &subject_, const std::string &claims)
        : subject{subject_}, answers{read_answer_list(claims)} {}

    void judge() {
        if (report_unfit()) return;
        judge_our_solution();
        judge_right_answers();
        judge_mistakes();
        report_tests();
    }

  private:
    /// Tests against one answer.
    struct Run {
        std::vector<unsigned> tests;
        std::string name;
        Time most;
        bool until_red;
        const Answer *answer = nullptr;
        std::vector<Result> results = {};
    };

    /// Reports tests that keep Catch2 from running any, or from counting them as we do.
    /// @return whether there are some
    static bool report_unfit() {
        std::map<std::string, int> names;
        for (const Catch::TestCaseInfo *test : all_tests()) ++names[test->name];
        bool any = false;
        for (const Catch::TestCaseInfo *test : all_tests()) {
            const char *why = names[test->name] > 1 ? "Two of your tests have this name: give one of them another."
                              : test->isHidden()    ? "A tag hides this test, so it doesn't run: take out the tag."
                                                    : nullptr;
            if (why == nullptr) continue;
            any = true;
            report(*test,
                   {{.test = test->name,
                     .kind = Outcome::left,
                     .sentence = why,
                     .file = test->lineInfo.file,
                     .line = static_cast<int>(test->lineInfo.line)}},
                   false);
        }
        return any;
    }

    /// Each test apart, since here we learn what it calls.
    void judge_our_solution() {
        for (unsigned place = 0; place < all_tests().size(); ++place)
            reference.push_back({{place}, "+", Time{}, false});
        run_all(reference);
        for (const Run &run : reference) {
            sound.push_back(run.results.front().verdict.passed());
            for (const std::string &exercise : run.results.front().calls)
                callers[exercise].push_back(run.tests.front());
        }
    }

    void judge_right_answers() {
        std::vector<Run> runs = runs_against(false);
        run_all(runs);
        for (const Run &run : runs)
            for (std::size_t i = 0; i < run.results.size(); ++i)
                if (run.results[i].is_red()) {
                    sound[run.tests[i]] = false;
                    print({{"right", run.answer->rest}, {"verdict", as_json(run.results[i].verdict)}});
                }
    }

    void judge_mistakes() {
        std::vector<Run> runs = runs_against(true);
        run_all(runs);
        for (const Run &run : runs)
            print({{"mistake", run.answer->rest},
                   {"exercise", run.answer->exercise},
                   {"caught", std::ranges::any_of(run.results, &Result::is_red)}});
    }

    void run_all(std::vector<Run> &runs) const {
        const Job run_one = [&](unsigned which, AnonymousFile &lines) {
            const Run &run = runs[which];
            lines.append(line_of({which, run_apart(subject, run.name, run.tests, run.most, run.until_red)}));
        };
        for (const std::string &line : JobQueue{.job = run_one, .prepare = prepare_for_subjects}.run(runs.size())) {
            const json numbered = json::parse(line);
            runs[numbered.at(0)].results = numbered.at(1);
        }
    }

    /// Each right answer but our solution, or each mistake, with the sound tests that call the exercise.
    std::vector<Run> runs_against(bool wrong) const {
        std::vector<Run> runs;
        for (const Answer &answer : answers) {
            if (answer.is_wrong() != wrong || answer.name.starts_with("variant_solution_")) continue;
            Run run{{}, '+' + answer.name, wrong ? Time{0.2, 0.5} : Time{}, wrong, &answer};
            if (const auto tests = callers.find(answer.exercise); tests != callers.end())
                std::ranges::copy_if(tests->second, std::back_inserter(run.tests),
                                     [&](unsigned test) { return sound[test]; });
            constexpr double slower = 4; // than our solution
            for (const unsigned test : run.tests) {
                const Time &took = reference[test].results.front().took;
                run.most.answer = std::max(run.most.answer, slower * took.answer);
                run.most.test += slower * took.test;
            }
            if (!run.tests.empty()) runs.push_back(std::move(run));
        }
        return runs;
    }

    void report_tests() const {
        for (const Run &run : reference) {
            const unsigned test = run.tests.front();
            report(*all_tests()[test], run.results.front(), sound[test]);
        }
        for (const auto &each : callers) {
            const auto is_right = [&](const Answer &answer) {
                return !answer.is_wrong() && answer.exercise == each.first;
            };
            print({{"exercise", each.first}, {"right", std::ranges::count_if(answers, is_right)}});
        }
    }

    static void report(const Catch::TestCaseInfo &test, const Result &result, bool is_sound) {
        print({{"test", test.name},
               {"line", test.lineInfo.line},
               {"calls", result.calls},
               {"verdict", as_json(result.verdict)},
               {"sound", is_sound}});
    }

    static void print(const json &line) { std::cout << line_of(line); }

    std::string subject;
    std::vector<Answer> answers;
    std::vector<Run> reference;                           ///< each test against our solution
    std::vector<bool> sound;                              ///< each test: no right answer has failed it
    std::map<std::string, std::vector<unsigned>> callers; ///< of each exercise
};

} // namespace

int section_main(int argc, char **argv) {
    if (argc != 3) return bad_input;
    OwnTests{argv[1], argv[2]}.judge();
    return all_well;
}

} // namespace course
