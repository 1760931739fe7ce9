// A reader's own tests, run against answers of which we know what they are: our solution first, then the other right
// ones, which a test must accept, then the mistakes, of which it may catch some. It prints a line of JSON for each
//
//     test     {"test": its name, "line": of the file, "calls": ["2.1"], "verdict": on our solution, "sound": true}
//     refusal  {"right": "what is special about the answer", "verdict": of the test that refuses it}
//     mistake  {"mistake": "you swap the velocities", "exercise": "2.2", "caught": true}
//
// and {"exercise": "2.1", "right": 6} for each exercise that a test calls. A test is sound if no right answer fails it;
// no other one is asked about mistakes.

#include "ground/complaint.hpp"
#include "ground/lines.hpp"
#include "verdict/tests/harness.hpp"

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

/// What one test said of one answer.
struct Said {
    Verdict verdict;
    std::vector<std::string> calls = {}; ///< exercises: "2.1"
    Time took = {0, 0};

    bool is_red() const { return !verdict.passed() && verdict.kind != Kind::no_verdict; }
};
json as_json(const Verdict &verdict) { return json::parse(to_line(verdict)); }
void to_json(json &to, const Said &said) {
    to = {{"verdict", as_json(said.verdict)}, {"calls", said.calls}, {"took", said.took}};
}
void from_json(const json &from, Said &said) {
    said = {from_line(from.at("verdict").dump()).value(), from.at("calls"), from.at("took")};
}

std::string of_a_right_answer(const Catch::AssertionResult &result) {
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

/// In a process of its own: runs tests against one answer, and tells what each of them said.
[[noreturn]] void be_the_tests(const std::string &subject, const std::string &answer,
                               const std::vector<unsigned> &tests, const Time &most, bool until_red,
                               NamelessFile &lines) {
    limit_computing(most.test);
    explain_failure = of_a_right_answer;
    Session here{subject, {.a_case = most.answer}, answer};
    here.run_own_tests();
    for (const unsigned test : tests) {
        const Time before = used_by_now();
        verdicts.clear();
        run_tests(here, 2026, {test, static_cast<unsigned>(all_tests().size())});
        if (!here.trouble().empty()) {
            lines.append(line_of(here.trouble()));
            ::_exit(machine_trouble);
        }
        const Time now = used_by_now();
        const Said said{verdicts.back(),
                        {here.called().begin(), here.called().end()},
                        {now.answer - before.answer, now.test - before.test}};
        lines.append(line_of(said));
        std::fflush(stdout); // what the test printed
        if (until_red && said.is_red()) break;
    }
    ::_exit(all_well);
}

/// The test that was running when its process ended.
Verdict ended(int status, const Catch::TestCaseInfo &test, const std::string &printed) {
    Verdict verdict{.test = test.name, .kind = Kind::crashed};
    verdict.file = test.lineInfo.file;
    verdict.line = static_cast<int>(test.lineInfo.line);
    const std::string meaning = meaning_of_assertion(printed);
    if (!WIFSIGNALED(status)) {
        verdict.kind = Kind::left;
        verdict.sentence = "Your test ended the program: it mustn't call exit().";
    } else if (WTERMSIG(status) == SIGPROF) {
        verdict.kind = Kind::too_long;
        verdict.sentence = "Your test doesn't come to an end: look for a loop that never stops.";
    } else if (meaning.empty()) verdict.sentence = "Your test " + meaning_of_signal(WTERMSIG(status)) + '.';
    else verdict.sentence = "Your test was stopped by a check of the library: " + meaning + '.';
    return verdict;
}

/// Runs tests against one answer, in a process apart: what ends that process, a test did.
std::vector<Said> run_apart(const std::string &subject, const std::string &answer, const std::vector<unsigned> &tests,
                            const Time &most, bool until_red) {
    NamelessFile lines, printed;
    const pid_t process = ::fork();
    if (process == 0) {
        for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(printed.descriptor(), stream);
        be_the_tests(subject, answer, tests, most, until_red, lines);
    }
    int status = 0;
    if (process < 0 || ::waitpid(process, &status, 0) < 0) throw MachineTrouble{"a test can't be started"};
    std::vector<Said> all;
    const std::string text = lines.text(64u << 20), output = printed.text(1u << 20);
    for (const Line &line : lines_of(text)) {
        const json told = json::parse(line.text);
        if (told.is_string()) throw MachineTrouble{told.get<std::string>()};
        all.push_back(told);
    }
    const bool is_whole = all.size() == tests.size() || (until_red && !all.empty() && all.back().is_red());
    if (!is_whole) all.push_back({ended(status, *all_tests()[tests[all.size()]], output)});
    for (Said &said : all)
        if (!said.verdict.passed() && said.verdict.printed.empty())
            std::tie(said.verdict.printed, said.verdict.printed_more) = tidy(output, 8);
    return all;
}

/// The tests of a reader's file, and what is known of them by now.
class OwnTests {
  public:
    OwnTests(const std::string &subject_, const std::string &claims) : subject{subject_}, answers{read_list(claims)} {}

    int judge() {
        if (tell_of_unfit()) return all_well;
        for (const auto ask : {&OwnTests::ask_our_solution, &OwnTests::ask_right_answers, &OwnTests::ask_mistakes})
            if (const int code = (this->*ask)(); code != all_well) return code;
        tell_of_tests();
        return all_well;
    }

  private:
    /// Tests against one answer.
    struct Run {
        std::vector<unsigned> tests;
        std::string named;
        Time most;
        bool until_red;
        const Answer *answer = nullptr;
        std::vector<Said> said = {};
    };

    /// Tests that keep Catch2 from running any, or from counting them as we do.
    /// @return whether there are some
    static bool tell_of_unfit() {
        std::map<std::string, int> named;
        for (const Catch::TestCaseInfo *test : all_tests()) ++named[test->name];
        bool found = false;
        for (const Catch::TestCaseInfo *test : all_tests()) {
            const char *why = named[test->name] > 1 ? "Two of your tests have this name: give one of them another."
                              : test->isHidden()    ? "A tag hides this test, so it doesn't run: take out the tag."
                                                    : nullptr;
            if (why == nullptr) continue;
            found = true;
            tell_of(*test,
                    {{.test = test->name,
                      .kind = Kind::left,
                      .sentence = why,
                      .file = test->lineInfo.file,
                      .line = static_cast<int>(test->lineInfo.line)}},
                    false);
        }
        return found;
    }

    /// Each test apart, since here we learn what it calls.
    int ask_our_solution() {
        for (unsigned place = 0; place < all_tests().size(); ++place) ours.push_back({{place}, "+", Time{}, false});
        const int code = run_all(ours);
        for (const Run &run : ours) {
            if (code != all_well) break;
            sound.push_back(run.said.front().verdict.passed());
            for (const std::string &exercise : run.said.front().calls) callers[exercise].push_back(run.tests.front());
        }
        return code;
    }

    int ask_right_answers() {
        std::vector<Run> runs = runs_against(false);
        const int code = run_all(runs);
        for (const Run &run : runs)
            for (std::size_t i = 0; i < run.said.size(); ++i)
                if (run.said[i].is_red()) {
                    sound[run.tests[i]] = false;
                    tell({{"right", run.answer->rest}, {"verdict", as_json(run.said[i].verdict)}});
                }
        return code;
    }

    int ask_mistakes() {
        std::vector<Run> runs = runs_against(true);
        const int code = run_all(runs);
        for (const Run &run : runs)
            tell({{"mistake", run.answer->rest},
                  {"exercise", run.answer->exercise},
                  {"caught", std::ranges::any_of(run.said, &Said::is_red)}});
        return code;
    }

    int run_all(std::vector<Run> &runs) const {
        const Job run_one = [&](unsigned which, NamelessFile &lines) {
            const Run &run = runs[which];
            lines.append(line_of({which, run_apart(subject, run.named, run.tests, run.most, run.until_red)}));
        };
        std::vector<std::string> told;
        const int code = share_all(runs.size(), run_one, told);
        for (const std::string &line : told) {
            const json its = json::parse(line);
            runs[its.at(0)].said = its.at(1);
        }
        return code;
    }

    /// Each right answer but our solution, or each mistake, with the sound tests that call its exercise.
    std::vector<Run> runs_against(bool wrong) const {
        std::vector<Run> runs;
        for (const Answer &answer : answers) {
            if (answer.is_wrong() != wrong || answer.name.starts_with("right_solution_")) continue;
            Run run{{}, '+' + answer.name, wrong ? Time{0.2, 0.5} : Time{}, wrong, &answer};
            if (const auto its = callers.find(answer.exercise); its != callers.end())
                std::ranges::copy_if(its->second, std::back_inserter(run.tests), [&](unsigned i) { return sound[i]; });
            constexpr double slower = 4; // than our solution
            for (const unsigned test : run.tests) {
                const Time &took = ours[test].said.front().took;
                run.most.answer = std::max(run.most.answer, slower * took.answer);
                run.most.test += slower * took.test;
            }
            if (!run.tests.empty()) runs.push_back(std::move(run));
        }
        return runs;
    }

    void tell_of_tests() const {
        for (const Run &run : ours) {
            const unsigned test = run.tests.front();
            tell_of(*all_tests()[test], run.said.front(), sound[test]);
        }
        for (const auto &[exercise, tests] : callers) {
            const auto is_right = [&its = exercise](const Answer &answer) {
                return !answer.is_wrong() && answer.exercise == its;
            };
            tell({{"exercise", exercise}, {"right", std::ranges::count_if(answers, is_right)}});
        }
    }

    static void tell_of(const Catch::TestCaseInfo &test, const Said &said, bool is_sound) {
        tell({{"test", test.name},
              {"line", test.lineInfo.line},
              {"calls", said.calls},
              {"verdict", as_json(said.verdict)},
              {"sound", is_sound}});
    }

    static void tell(const json &line) { std::cout << line_of(line); }

    std::string subject;
    std::vector<Answer> answers;
    std::vector<Run> ours;                                ///< each test against our solution
    std::vector<bool> sound;                              ///< each test: no right answer has failed it
    std::map<std::string, std::vector<unsigned>> callers; ///< of each exercise
};

} // namespace

int judge_own_tests(const std::string &subject, const std::string &claims) { return OwnTests{subject, claims}.judge(); }

} // namespace course
