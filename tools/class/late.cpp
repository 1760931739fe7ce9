#include "class/late.hpp"

#include "ground/complaint.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <sstream>

namespace course {

double per_cent_per_day(const std::string &words) {
    std::istringstream in{words};
    double per_cent = 0;
    std::string rest;
    if (!(in >> per_cent) || !std::getline(in, rest) || rest != "%/day" || !(per_cent > 0 && per_cent <= 100))
        throw Complaint{"--late wants the part of all points that each day costs, as in 10%/day, not " + words};
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

} // namespace course
