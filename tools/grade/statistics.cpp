#include "grade/statistics.hpp"

#include "base/text.hpp"
#include "check/junit.hpp"
#include "judge/protocol/signature.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace course {
namespace {

MostCommon most_common(const std::vector<std::string> &all) {
    std::map<std::string, std::size_t> times;
    for (const std::string &words : all) ++times[words];
    MostCommon most;
    for (const auto &[words, count] : times)
        if (count > most.times) most = {words, count};
    return most;
}

const GradedExercise *exercise_of(const Graded &student, const std::string &number) {
    for (const GradedExercise &exercise : student.exercises)
        if (exercise.exercise.number == number) return &exercise;
    return nullptr;
}

/// Nothing if it has none: the function doesn't compile.
const Verdict *verdict_on(const GradedExercise &exercise, const std::string &claim) {
    const auto verdict = std::ranges::find(exercise.verdicts, claim, &Verdict::test);
    return verdict == exercise.verdicts.end() ? nullptr : &*verdict;
}

bool says_something(const std::string &value) {
    return value.find_first_of("123456789") != value.npos
           || contains_any(value, {"not a number", "nan", "inf", "true"});
}

bool says_something(const Verdict &verdict) {
    return says_something(verdict.yours) || (verdict.call && says_something(verdict.call->answer));
}

std::vector<Verdict> red_ones(const GradedClass &graded, const GradedExercise &exercise) {
    std::vector<Verdict> red;
    std::ranges::copy_if(exercise.verdicts, std::back_inserter(red),
                         [&](const Verdict &verdict) { return !verdict.passed() && !is_void(graded, verdict.test); });
    return red;
}

} // namespace

std::optional<Quartiles> quartiles(std::vector<double> points) {
    if (points.empty()) return {};
    std::ranges::sort(points);
    const auto at = [&](double part) {
        const double place = part * static_cast<double>(points.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const double above = points[std::min(below + 1, points.size() - 1)];
        return std::lerp(points[below], above, place - std::floor(place));
    };
    return Quartiles{at(0.25), at(0.5), at(0.75)};
}

bool is_void(const GradedClass &graded, const std::string &claim) {
    return std::ranges::find(graded.void_tests, claim) != graded.void_tests.end();
}

const Verdict *telling_verdict(const GradedClass &graded, const GradedExercise &exercise) {
    const Verdict *first = nullptr;
    for (const Verdict &verdict : exercise.verdicts) {
        if (verdict.passed() || is_void(graded, verdict.test)) continue;
        if (verdict.kind != Outcome::not_started) return &verdict;
        if (first == nullptr) first = &verdict;
    }
    return first;
}

std::vector<TestOfClass> how_tests_went(const GradedClass &graded) {
    std::vector<TestOfClass> all;
    for (const KnownTest &test : graded.tests) {
        TestOfClass &result = all.emplace_back();
        result.test = test;
        result.is_void = is_void(graded, test.claim);
        std::vector<std::string> failures;
        for (const Graded &student : graded.students) {
            const GradedExercise *exercise = exercise_of(student, test.exercise);
            if (exercise == nullptr) continue;
            ++result.judged;
            const Verdict *verdict = verdict_on(*exercise, test.claim);
            if (exercise->unbuilt || verdict == nullptr || verdict->kind == Outcome::not_started) continue;
            ++result.answered;
            if (verdict->passed()) ++result.passed;
            else failures.push_back(in_one_line(*verdict));
        }
        result.failure = most_common(failures);
    }
    return all;
}

MostCommon commonest_mistake(const GradedClass &graded, const std::string &number) {
    std::vector<std::string> mistakes;
    for (const Graded &student : graded.students)
        if (const GradedExercise *exercise = exercise_of(student, number); exercise && !exercise->mistake.empty())
            mistakes.push_back(exercise->mistake);
    return most_common(mistakes);
}

std::vector<Alike> equal_wrong_answers(const GradedClass &graded) {
    std::map<std::string, Alike> groups;
    std::map<std::string, std::string> files; // of the first in each group
    for (const Graded &student : graded.students)
        for (const GradedExercise &exercise : student.exercises) {
            const std::vector<Verdict> red = red_ones(graded, exercise);
            const auto telling =
                std::ranges::find_if(red, [](const Verdict &verdict) { return says_something(verdict); });
            if (telling == red.end() || !exercise.consequence_of.empty()) continue;
            const std::string key = exercise.exercise.number + ' ' + signature(red);
            Alike &group = groups[key];
            if (group.ids.empty()) {
                group = {exercise.exercise, {}, red.size(), *telling, exercise.mistake, !student.file_hash.empty()};
                files[key] = student.file_hash;
            }
            group.is_same_file = group.is_same_file && student.file_hash == files[key];
            group.ids.push_back(student.submission.id);
        }
    std::vector<Alike> all;
    for (auto &[key, group] : groups)
        if (group.ids.size() > 1) all.push_back(std::move(group));
    std::ranges::stable_sort(all, std::greater{}, [](const Alike &group) { return group.ids.size(); });
    return all;
}

} // namespace course
