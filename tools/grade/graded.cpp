#include "grade/graded.hpp"

namespace course {

std::string_view name_of(Platform platform) {
    switch (platform) {
    case Platform::canvas: return "Canvas";
    case Platform::moodle: return "Moodle";
    case Platform::classroom: return "GitHub Classroom";
    default: return "a folder";
    }
}

std::string lateness(const Submission &submission) {
    if (!submission.late) return "";
    return submission.late_by.empty() ? "late" : submission.late_by + " late";
}

double Graded::earned() const { return overridden.value_or(judged()); }

double Graded::judged() const {
    double sum = 0;
    for (const GradedExercise &exercise : exercises) sum += exercise.earned;
    return sum - taken_off;
}

double Graded::possible() const {
    double sum = 0;
    for (const GradedExercise &exercise : exercises) sum += exercise.possible;
    return sum;
}

} // namespace course
