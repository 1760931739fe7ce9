#include "grade/points.hpp"

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"
#include "grade/csv.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace course {

Worth::Worth(const std::filesystem::path &file, const std::vector<Exercise> &exercises) {
    const auto section = [](const std::string &number) { return number.substr(0, number.find('.')); };
    const std::string text = read_file(file);
    int number = 0;
    for (const Line &line : split_lines(text)) {
        ++number;
        std::istringstream words{std::string{line.text.substr(0, line.text.find('#'))}};
        std::string what, more;
        double worth = 0;
        if (!(words >> what)) continue;
        const bool known = is_number_of_exercise(what) || what == "core" || what == "stretch" || what == "challenge";
        if (!known || !(words >> worth) || worth < 0 || !std::isfinite(worth) || words >> more)
            throw UserError{file.string() + ':' + std::to_string(number) + ": `" + std::string{line.text}
                            + "` should be a tier or an exercise and its points, as in `core 2` or `5.4 3`"};
        if (is_number_of_exercise(what) && !exercises.empty() && section(what) == section(exercises.front().number)
            && std::ranges::count(exercises, what, &Exercise::number) == 0)
            throw UserError{file.string() + ':' + std::to_string(number) + ": there's no exercise " + what
                            + ": take the line out, or name one of " + exercises.front().number + " to "
                            + exercises.back().number};
        points[what] = worth;
    }
}

double Worth::of(const Exercise &exercise) const {
    for (const std::string &key : {exercise.number, exercise.tier})
        if (const auto worth = points.find(key); worth != points.end()) return worth->second;
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

Overrides read_overrides(const std::filesystem::path &file) {
    Overrides all;
    if (!std::filesystem::exists(file)) return all;
    const std::string text = read_file(file);
    bool head = true;
    for (const std::vector<CsvCell> &row : read_csv(text, file.string()).rows) {
        const bool is_head = std::exchange(head, false) && row.front().text == "id";
        if (is_head || row.front().text.empty()) continue;
        std::string points = row.size() < 2 ? "" : row[1].text;
        std::ranges::replace(points, ',', '.');
        std::size_t end = 0;
        double worth = -1;
        try {
            worth = std::stod(points, &end);
        } catch (const std::exception &) {}
        if (row.size() != 3 || end != points.size() || !std::isfinite(worth) || worth < 0)
            throw UserError{file.string() + ": the line of " + row.front().text
                            + " should be an id, points, and why: 1003,7.5,\"was ill\""};
        if (!all.insert({row.front().text, {worth, row[2].text}}).second)
            throw UserError{file.string() + " has two lines for " + row.front().text + ": leave the one that counts"};
    }
    return all;
}

double per_cent_per_day(const std::string &words) {
    std::istringstream in{words};
    double per_cent = 0;
    std::string rest;
    if (!(in >> per_cent) || !std::getline(in, rest) || rest != "%/day" || !(per_cent > 0 && per_cent <= 100))
        throw UserError{"--late wants the part of all points that each day costs, as in 10%/day, not " + words};
    return per_cent;
}

std::optional<int> started_days(std::string_view late) {
    if (late == "now") return 1; // less than a second
    std::istringstream words{std::string{late}};
    int days = 0, number = 0;
    bool started = false, any = false;
    for (std::string unit; words >> number; any = true) {
        constexpr int year = 365, most = 100;
        if (!(words >> unit) || number < 0 || number > most * year) return {};
        if (unit.ends_with('s')) unit.pop_back();
        if (unit == "year") days += year * std::min(number, most);
        else if (unit == "day") days += number;
        else if (is_any_of(unit, {"hour", "min", "sec"})) started = started || number > 0;
        else return {};
    }
    if (!any || !words.eof()) return {};
    return days + (started ? 1 : 0);
}

void take_off_for_lateness(Graded &student, double per_cent) {
    if (per_cent <= 0 || student.submission.late_by.empty() || student.overridden) return;
    if (const auto days = started_days(student.submission.late_by)) {
        student.days_late = *days;
        student.taken_off = std::min(student.earned(), student.possible() * per_cent * *days / 100);
    } else if (student.our_trouble.empty())
        student.our_trouble =
            "Moodle's Status says `" + plain_line(student.submission.late_by, 100)
            + " late`, and we can't tell how many days that is: write their points into overrides.csv";
}

std::string points_text(double points) { return fmt::format("{:g}", std::round(points * 100) / 100); }

} // namespace course
