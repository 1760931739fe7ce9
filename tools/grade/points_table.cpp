#include "grade/points_table.hpp"

#include "base/plain.hpp"
#include "base/text.hpp"
#include "grade/csv.hpp"
#include "grade/points.hpp"

#include <algorithm>

namespace course {
namespace {

/// For a spreadsheet that takes commas for what's between cells, or semicolons.
std::string cell(const std::string &words) {
    std::string line = plain_line(words, 300);
    std::ranges::replace(line, ';', ',');
    return csv_cell(is_any_of(line.substr(0, 1), {"=", "+", "-", "@"}) ? "'" + line : line);
}

std::string trouble(const Graded &student) {
    if (!student.our_trouble.empty()) return student.our_trouble;
    if (student.overridden) return "set by hand: " + student.why;
    if (!student.submission.trouble.empty()) return student.submission.trouble;
    if (student.unbuilt) return std::string{name_of(student.unbuilt->kind)} + ": " + student.unbuilt->sentence;
    return student.taken_off > 0 ? points_text(student.taken_off) + " taken off for being late" : "";
}

} // namespace

std::string points_table(const GradedClass &graded, const std::map<std::string, std::string> &names) {
    std::string text = "id,name,total,possible";
    if (!graded.students.empty())
        for (const GradedExercise &each : graded.students.front().exercises) text += ',' + each.exercise.number;
    text += ",trouble\n";
    for (const Graded &student : graded.students) {
        const std::string &id = student.submission.id;
        const auto name = names.find(id);
        text += cell(id) + ',' + (name == names.end() ? "" : cell(name->second)) + ','
                + (has_grade(student) ? points_text(student.earned()) : "") + ',' + points_text(student.possible());
        for (const GradedExercise &each : student.exercises)
            text += ',' + (each.verdicts.empty() && !each.unbuilt ? "" : points_text(each.earned));
        text += ',' + cell(trouble(student)) + '\n';
    }
    return text;
}

} // namespace course
