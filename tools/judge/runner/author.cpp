// The same tests for authors: what they make of our own answers, which one subject holds. In no handout.
//
//     07_segment_intersection SUBJECT --answers LIST          judges the mutants and variants of this list
//     07_segment_intersection SUBJECT --kills LIST            prints which tests stop each wrong answer in it
//     07_segment_intersection SUBJECT --mistakes LIST [FILE]  prints what these are known by; or compares it with FILE
//     07_segment_intersection SUBJECT --all-cases             judges our solution by every generated case

#include "judge/protocol/signature.hpp"
#include "judge/runner/answer_list.hpp"
#include "judge/runner/harness.hpp"
#include "judge/runner/job_queue.hpp"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <map>
#include <set>

namespace course {
namespace {

constexpr unsigned usual_seed = 2026;

/// Whether the first verdict that is red shows this answer, as `yours` or as what the call `returned`, whatever its unit.
bool first_shows(const std::string &answer) {
    const auto red = std::ranges::find_if_not(verdicts, &Verdict::passed);
    if (red == verdicts.end()) return false;
    const auto shows = [&](const std::string &text) { return (text + ' ').starts_with(answer + ' '); };
    return shows(red->yours) || (red->call && shows(red->call->answer));
}

/// Whether the verdicts are the ones that are expected of this answer: all passed, one that is red, or just so many
/// passed, and the first that is red shows some answer: "8 of 13, yours t = 0.5".
bool as_expected(std::string_view expected) {
    const auto says_nothing = [](const Verdict &v) { return v.kind == Outcome::no_verdict; };
    const auto untouched = [](const Verdict &v) { return v.kind == Outcome::not_started; };
    if (verdicts.empty() || std::ranges::any_of(verdicts, says_nothing)) return false;
    if (expected == "all") return all_passed();
    if (std::ranges::any_of(verdicts, untouched)) return false;
    if (const std::size_t at = expected.find("yours "); at != expected.npos)
        return first_shows(std::string{expected.substr(at + 6)})
               && (at == 0 || expected.substr(0, at) == passed_of_all() + ", ");
    return expected == "red" ? !all_passed() : passed_of_all() == expected;
}

/// A wrong answer may well hang, and is no less wrong after a minute. Where a count is expected, what a student sees as
/// too slow must be too slow.
TimeLimits limits_for(const std::string &expected) {
    if (expected == "all") return patient;
    return {.a_case = TimeLimits{}.a_case, .all = patient.all, .start = patient.start};
}

bool is_judged_as_expected(const std::string &subject, const Answer &answer) {
    const bool enough_is_red = answer.rest == "red" || answer.rest.starts_with("yours ");
    verdicts.clear();
    Session running{subject, enough_is_red ? TimeLimits{} : limits_for(answer.rest), answer.name};
    run_tests(running, usual_seed, {.exercise = answer.exercise, .until_red = enough_is_red});
    return as_expected(answer.rest);
}

std::vector<std::string> for_each_answer(const std::vector<Answer> &answers,
                                         const std::function<void(std::size_t, AnonymousFile &)> &job) {
    return JobQueue{.job = job, .prepare = prepare_for_subjects}.run(answers.size());
}

/// Names the answers that aren't judged as expected.
int judge_answers(const std::string &subject, const std::string &list) {
    const std::vector<Answer> answers = read_answer_list(list);
    if (answers.empty()) {
        std::cerr << list << " lists no answers\n";
        return bad_input;
    }
    const std::string good = "as expected";
    const auto lines = for_each_answer(answers, [&](std::size_t which, AnonymousFile &out) {
        const Answer &answer = answers[which];
        if (is_judged_as_expected(subject, answer)) return out.append(good + '\n');
        out.append("NOT as expected: " + answer.name + ' ' + answer.exercise + ' ' + answer.rest + ", but "
                   + passed_of_all() + '\n');
        for (const Verdict &verdict : verdicts)
            if (!verdict.passed()) out.append(in_words(verdict));
    });
    const auto right = static_cast<std::size_t>(std::ranges::count(lines, good));
    for (const std::string &line : lines)
        if (line != good) std::cout << line << '\n';
    std::cout << right << " of " << answers.size() << " answers are judged as expected (seed " << usual_seed << ")\n";
    return right == answers.size() ? all_well : something_to;
}

std::vector<Answer> wrong_answers_in(const std::string &list) {
    std::vector<Answer> answers = read_answer_list(list);
    std::erase_if(answers, [](const Answer &answer) { return !answer.is_wrong(); });
    return answers;
}

/// The verdicts of the answer's exercise, with each of these seeds, until one takes too long: others would, too.
const std::vector<Verdict> &verdicts_on(const std::string &subject, const Answer &answer,
                                        std::initializer_list<unsigned> seeds) {
    Session running{subject, {}, answer.name};
    verdicts.clear();
    for (const unsigned seed : seeds)
        for (unsigned place = 0; place < all_tests().size(); ++place) {
            if (exercise_of(*all_tests()[place]) != answer.exercise) continue;
            run_tests(running, seed, Part::only(place));
            if (verdicts.back().kind == Outcome::too_long) return verdicts;
        }
    return verdicts;
}

/// Prints which tests stop each wrong answer of a list, by their places in the file, from 1: "7.2 mutant_meet_never 3 4 9".
/// One that stops where others stop too, and that no reader would give, can go.
void print_kills(const std::string &subject, const std::string &list) {
    const std::vector<Answer> answers = wrong_answers_in(list);
    const auto place_of = [](const Verdict &verdict) {
        return std::ranges::find(all_tests(), verdict.test, &Catch::TestCaseInfo::name) - all_tests().begin();
    };
    auto lines = for_each_answer(answers, [&](std::size_t which, AnonymousFile &out) {
        std::string stopped_by = answers[which].exercise + ' ' + answers[which].name;
        for (const Verdict &verdict : verdicts_on(subject, answers[which], {usual_seed}))
            if (!verdict.passed()) stopped_by += ' ' + std::to_string(place_of(verdict) + 1);
        out.append(stopped_by + '\n');
    });
    std::ranges::sort(lines);
    for (const std::string &line : lines) std::cout << line << '\n';
}

/// The verdicts on one answer with two seeds, by tests.
using TwiceJudged = std::map<std::string, std::vector<Verdict>>;

std::vector<TwiceJudged> judge_twice(const std::string &subject, const std::vector<Answer> &answers) {
    std::vector<TwiceJudged> all(answers.size());
    for (const std::string &line : for_each_answer(answers, [&](std::size_t which, AnonymousFile &out) {
             const auto &both = verdicts_on(subject, answers[which], {usual_seed, 7});
             if (both.empty() || both.back().kind == Outcome::too_long)
                 return; // nobody knows what the other tests would have seen
             for (const Verdict &verdict : both) out.append(std::to_string(which) + ' ' + to_line(verdict));
         }))
        if (auto verdict = from_line(line.substr(line.find(' ')))) {
            auto &of_test = all[std::stoul(line)][verdict->test];
            of_test.push_back(std::move(*verdict));
        }
    return all;
}

bool is_generated(const Verdict &one, const Verdict &other) {
    const auto arguments = [](const Verdict &verdict) {
        return verdict.call ? verdict.call->arguments : std::vector<std::string>{};
    };
    return seen_by(one) != seen_by(other) || arguments(one) != arguments(other);
}

/// What `check` knows mistakes by: which tests generate their input, so that what they say proves nothing, and a line
/// for each mistake: exercise, the signature of what comes out in all others, and what the reader did.
std::set<std::string> known_mistakes(const std::string &subject, const std::string &list) {
    const std::vector<Answer> mistakes = wrong_answers_in(list);
    const std::vector<TwiceJudged> judged = judge_twice(subject, mistakes);
    std::set<std::pair<std::string, std::string>> generated;
    std::set<std::string> lines;
    for (const TwiceJudged &tests : judged)
        for (const auto &[test, both] : tests)
            if (is_generated(both.front(), both.back())) {
                generated.insert({both.front().exercise, test});
                lines.insert(both.front().exercise + "\tgenerated\t" + test);
            }
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        std::vector<Verdict> failed;
        for (const auto &[test, both] : judged[i])
            if (!both.front().passed() && !generated.contains({mistakes[i].exercise, test}))
                failed.push_back(both.front());
        if (!failed.empty()) lines.insert(mistakes[i].exercise + '\t' + signature(failed) + '\t' + mistakes[i].rest);
    }
    return lines;
}

void print_lines_not_in(const std::set<std::string> &others, const std::set<std::string> &lines, const char *sign) {
    for (const std::string &line : lines)
        if (!others.contains(line)) std::cout << sign << line << '\n';
}

/// Prints how the file differs from what is known.
int compare(const std::set<std::string> &known, const std::string &file) {
    std::ifstream in{file};
    std::set<std::string> kept;
    for (std::string line; std::getline(in, line);) kept.insert(line);
    if (kept == known) return all_well;
    std::cout << file << " isn't what comes out of the wrong answers; type: ./course dev publish --mistakes\n";
    print_lines_not_in(known, kept, "-");
    print_lines_not_in(kept, known, "+");
    return something_to;
}

int judge_all_cases(const std::string &subject) {
    all_cases = true;
    print_verdicts(subject, usual_seed);
    return all_passed() ? all_well : something_to;
}

} // namespace

int section_main(int argc, char **argv) {
    const std::vector<std::string> words{argv + 1, argv + argc};
    const std::string mode = words.size() > 1 ? words[1] : "";
    if (mode == "--all-cases") return judge_all_cases(words[0]);
    if (mode == "--answers" && words.size() == 3) return judge_answers(words[0], words[2]);
    if (mode == "--kills" && words.size() == 3) return print_kills(words[0], words[2]), all_well;
    if (mode == "--mistakes" && words.size() == 4) return compare(known_mistakes(words[0], words[2]), words[3]);
    if (mode == "--mistakes" && words.size() == 3)
        return print_lines_not_in({}, known_mistakes(words[0], words[2]), ""), all_well;
    std::cerr << "usage: SUBJECT --answers LIST | --kills LIST | --mistakes LIST [FILE] | --all-cases\n";
    return bad_input;
}

} // namespace course
