// What runs a section's tests against a subject, a program with a student's code in it.
//
//     07_segment_intersection SUBJECT               prints each verdict, for us
//     07_segment_intersection SUBJECT --json        the same for the `course` program, a line of JSON for each verdict
//     07_segment_intersection --catalogue           the section's exercises and tests, as JSON

#include "base/kernel.hpp"
#include "judge/runner/harness.hpp"
#include "judge/runner/job_queue.hpp"

#include <catch2/internal/catch_clara.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <set>

namespace course {
namespace {

nlohmann::json catalogue() {
    nlohmann::json exercises = nlohmann::json::array(), tests = nlohmann::json::array();
    for (const ExerciseLine *exercise : exercise_lines())
        exercises.push_back({{"number", exercise->number}, {"tier", exercise->tier}, {"function", exercise->function}});
    for (const Catch::TestCaseInfo *test : all_tests())
        tests.push_back({{"exercise", exercise_of(*test)}, {"claim", test->name}});
    return {{"exercises", exercises}, {"tests", tests}};
}

/// Tests of the course itself wait only a part of the time for what hangs. No limit ever becomes longer, and a student's
/// process has another environment.
TimeLimits limits_from_environment() {
    const char *const part = std::getenv("COURSE_PART_OF_LIMITS");
    const double factor = part == nullptr ? 1 : std::clamp(std::strtod(part, nullptr), 0.05, 1.0);
    TimeLimits limits;
    limits.a_case *= factor;
    limits.start *= factor;
    return limits;
}

/// Runs these tests, by their places, in some processes.
std::vector<Verdict> run_in(std::size_t processes, const std::vector<unsigned> &places, const std::string &subject,
                            unsigned seed) {
    std::optional<Session> running; // a process has one for all tests
    const JobQueue queue{.job =
                             [&](unsigned place, AnonymousFile &lines) {
                                 on_verdict = [&](const Verdict &verdict) { lines.append(to_line(verdict)); };
                                 if (!running) running.emplace(subject, limits_from_environment());
                                 run_tests(*running, seed, Part::only(place));
                             },
                         .prepare = prepare_for_subjects,
                         .most_processes = processes};
    std::vector<Verdict> all;
    for (const std::string &line : queue.run(places))
        if (auto verdict = from_line(line)) all.push_back(std::move(*verdict));
    return all;
}

/// Runs the tests of one exercise, or all, in as many processes as there are cores, up to four, and prints their
/// verdicts. That something takes too long counts when it has been seen twice, the second time with nothing beside it:
/// once for each exercise; other tests of it need no further proof then.
void run_side_by_side(const std::string &subject, unsigned seed, const std::string &exercise) {
    constexpr std::size_t most_processes = 4;
    std::vector<unsigned> places;
    std::map<std::pair<std::string, std::string>, unsigned> place_by_name;
    for (unsigned place = 0; place < all_tests().size(); ++place) {
        const Catch::TestCaseInfo &test = *all_tests()[place];
        place_by_name[{exercise_of(test), test.name}] = place;
        if (exercise.empty() || exercise_of(test) == exercise) places.push_back(place);
    }
    std::ranges::reverse(places); // the last exercises take longest: none of them is begun when all else is done
    const auto place_of = [&](const Verdict &verdict) { return place_by_name[{verdict.exercise, verdict.test}]; };
    std::vector<Verdict> all = run_in(most_processes, places, subject, seed);
    std::ranges::sort(all, {}, place_of);
    std::set<std::string> proved;
    for (Verdict &verdict : all) {
        // without a call: it never starts, for any exercise
        const std::string hanging = verdict.call ? verdict.exercise : "";
        if (verdict.kind == Outcome::too_long && !proved.contains(hanging)) {
            auto again = run_in(1, {place_of(verdict)}, subject, seed);
            if (again.size() == 1) verdict = std::move(again.front());
            if (verdict.kind == Outcome::too_long) proved.insert(hanging);
        }
        std::cout << to_line(verdict);
    }
}

/// Each exercise has a test that says "not started". Others may pass: a stub may refuse bad input.
bool nothing_started() {
    std::map<std::string, bool> waits;
    for (const Verdict &verdict : verdicts) {
        const bool untouched = verdict.kind == Outcome::not_started;
        if (!verdict.passed() && !untouched) return false;
        waits[verdict.exercise] |= untouched;
    }
    return !waits.empty() && std::ranges::all_of(waits, [](const auto &exercise) { return exercise.second; });
}

} // namespace

int section_main(int argc, char **argv) {
    std::string subject, exercise;
    bool json = false, list = false, is_stub = false;
    unsigned seed = 2026;
    using Catch::Clara::Opt;
    const auto line = Catch::Clara::Arg(subject, "subject")("the program with the code to judge")
                      | Opt(json)["--json"]("print each verdict as a line of JSON")
                      | Opt(seed, "number")["--seed"]("for generated values")
                      | Opt(exercise, "7.2")["--exercise"]("only the tests of this one")
                      | Opt(is_stub)["--stub"]("exit with 0 if nothing is started, not if all passed")
                      | Opt(list)["--catalogue"]("list the exercises as JSON, and leave");
    if (const auto parsed = line.parse({argc, argv}); !parsed) {
        std::cerr << parsed.errorMessage() << '\n' << line;
        return bad_input;
    }
    if (list) std::cout << catalogue().dump(1) << '\n';
    else if (json) run_side_by_side(subject, seed, exercise);
    else {
        print_verdicts(subject, seed, {.exercise = exercise});
        return (is_stub ? nothing_started() : all_passed()) ? all_well : something_to;
    }
    return all_well;
}

} // namespace course
