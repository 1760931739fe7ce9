#include "grade/gradescope.hpp"

#include "base/lines.hpp"
#include "grade/feedback.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

namespace course {
namespace {

/// Gradescope sums these up: two decimals each, as we show them.
double rounded(double points) { return std::round(points * 100) / 100; }

/// For a student from whom exercises are hidden: of code that doesn't compile, no lines, since these may be theirs.
Graded without_code(Graded student) {
    for (Verdict &why : student.taken_out) why.printed.clear();
    if (student.unbuilt) student.unbuilt->printed.clear();
    for (GradedExercise &each : student.exercises)
        if (each.unbuilt) each.unbuilt->printed.clear();
    return student;
}

bool has_word(std::string_view text, const std::string &word) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; ++at) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_part(text[at - 1])) && (end == text.size() || !is_part(text[end]))) return true;
    }
    return false;
}

/// Without the lines that name a hidden exercise, by its number or its function.
std::string without_hidden(const std::string &text, const Graded &student, const std::set<std::string> &hidden) {
    std::string kept;
    for (const Line &line : split_lines(text)) {
        const bool tells = std::ranges::any_of(student.exercises, [&](const GradedExercise &each) {
            return hidden.contains(each.exercise.number)
                   && (has_word(line.text, each.exercise.number) || has_word(line.text, each.exercise.function));
        });
        if (!tells) kept += std::string{line.text} + '\n';
    }
    return kept;
}

/// Without its first line, the sum: Gradescope shows that itself, unless it hides it since an exercise is hidden.
std::string without_sum(const std::string &head) { return head.substr(head.find('\n') + 1); }

} // namespace

std::string gradescope_results(const GradedClass &graded, const Graded &judged, const std::set<std::string> &hidden) {
    const Graded student = hidden.empty() ? judged : without_code(judged);
    const auto shown = [&](const std::string &text) { return without_hidden(text, student, hidden); };
    nlohmann::ordered_json tests;
    for (const GradedExercise &each : student.exercises) {
        const bool is_hidden = hidden.contains(each.exercise.number),
                   is_judged = !student.unbuilt && !each.verdicts.empty();
        const std::string text = is_judged ? feedback_of(graded, each, false) : "";
        tests.push_back({{"number", each.exercise.number},
                         {"name", each.exercise.function},
                         {"score", rounded(each.earned)},
                         {"max_score", rounded(each.possible)},
                         {"status", each.all_passed() ? "passed" : "failed"},
                         {"output", is_hidden ? text : shown(text)},
                         {"tags", {each.exercise.tier}},
                         {"visibility", is_hidden ? "hidden" : "visible"}});
    }
    const nlohmann::ordered_json all{
        {"output", shown(without_sum(feedback_head(graded, student)))},
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
