#include "class/points.hpp"

#include "ground/files.hpp"
#include "ground/lines.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace course {

Worth::Worth(const std::filesystem::path &file) {
    const std::string text = read_file(file);
    int number = 0;
    for (const Line &line : lines_of(text)) {
        ++number;
        std::istringstream words{std::string{line.text.substr(0, line.text.find('#'))}};
        std::string what, more;
        double worth = 0;
        if (!(words >> what)) continue;
        const bool known = is_number_of_exercise(what) || what == "core" || what == "stretch" || what == "challenge";
        if (!known || !(words >> worth) || worth < 0 || !std::isfinite(worth) || words >> more)
            throw Complaint{file.string() + ':' + std::to_string(number) + ": `" + std::string{line.text}
                            + "` should be a tier or an exercise and its points, as in `core 2` or `5.4 3`"};
        points[what] = worth;
    }
}

double Worth::of(const Exercise &exercise) const {
    for (const std::string &key : {exercise.number, exercise.tier})
        if (const auto its = points.find(key); its != points.end()) return its->second;
    return 1;
}

void count(GradedExercise &exercise, const std::vector<std::string> &void_tests,
           const std::set<std::vector<std::size_t>> &trivial) {
    const auto counts = [&](std::size_t place) {
        return place <= exercise.verdicts.size()
               && std::ranges::count(void_tests, exercise.verdicts[place - 1].test) == 0;
    };
    for (std::size_t place = 1; place <= exercise.verdicts.size(); ++place)
        if (counts(place)) {
            ++exercise.counted;
            if (exercise.verdicts[place - 1].passed()) ++exercise.passed;
        }
    for (const auto &places : trivial)
        exercise.baseline =
            std::max(exercise.baseline, static_cast<std::size_t>(std::ranges::count_if(places, counts)));
    if (exercise.all_passed()) exercise.earned = exercise.possible;
    else if (!exercise.unbuilt && exercise.passed > exercise.baseline)
        exercise.earned = exercise.possible * double(exercise.passed - exercise.baseline)
                          / double(exercise.counted - exercise.baseline);
}

std::string points_text(double points) { return fmt::format("{:g}", std::round(points * 100) / 100); }

} // namespace course
