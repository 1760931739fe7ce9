#include "class/graded.hpp"

namespace course {

std::string_view name_of(Platform platform) {
    switch (platform) {
    case Platform::canvas: return "Canvas";
    case Platform::moodle: return "Moodle";
    default: return "a folder";
    }
}

double Graded::earned() const {
    if (overridden) return *overridden;
    double sum = 0;
    for (const GradedExercise &exercise : exercises) sum += exercise.earned;
    return sum;
}

double Graded::possible() const {
    double sum = 0;
    for (const GradedExercise &exercise : exercises) sum += exercise.possible;
    return sum;
}

} // namespace course
