#include "grade/gradescope.hpp"

#include "grade/feedback.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace course {
namespace {

/// Gradescope sums these up: two decimals each, as we show them.
double rounded(double points) { return std::round(points * 100) / 100; }

/// Without its first line, the sum: Gradescope shows that itself, unless it hides it since an exercise is hidden.
std::string without_sum(const std::string &head) { return head.substr(head.find('\n') + 1); }

} // namespace

std::string gradescope_results(const GradedClass &graded, const Graded &student, const std::set<std::string> &hidden) {
    nlohmann::ordered_json tests;
    for (const GradedExercise &each : student.exercises)
        tests.push_back({{"number", each.exercise.number},
                         {"name", each.exercise.function},
                         {"score", rounded(each.earned)},
                         {"max_score", rounded(each.possible)},
                         {"status", each.all_passed() ? "passed" : "failed"},
                         {"output", student.unbuilt || each.verdicts.empty() ? "" : feedback_of(graded, each, false)},
                         {"tags", {each.exercise.tier}},
                         {"visibility", hidden.contains(each.exercise.number) ? "hidden" : "visible"}});
    const nlohmann::ordered_json all{
        {"output", without_sum(feedback_head(graded, student))},
        {"output_format", "text"},
        {"test_output_format", "text"},
        {"test_name_format", "text"},
        {"stdout_visibility", "hidden"},
        {"tests", tests},
        {"extra_data",
         {{"file_sha256", student.file_hash}, {"tests_sha256", graded.tests_hash}, {"seed", graded.seed}}}};
    return all.dump(1) + '\n';
}

} // namespace course
