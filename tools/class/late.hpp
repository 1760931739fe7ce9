#pragma once
// What it costs to hand in late, where the platform says by how much: Moodle's grading worksheet does.

#include "class/graded.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace course {

/// The per cent in "10%/day". @throws Complaint if it's of another form
double per_cent_per_day(const std::string &words);

/// Started days in Moodle's words for a length of time: 2 in "1 day 2 hours", 1 in "3 mins 20 secs". They come from
/// Moodle's own clock, so no time zone is in them; they have two units, so up to an hour beyond whole days is forgiven.
/// Nothing if these aren't such words.
std::optional<int> started_days(std::string_view late);

/// Takes so much per cent of what's possible for each started day, down to 0, as Canvas' late policy and Moodle's own
/// penalties do; 0 takes nothing. If it can't be read by how much somebody was late, that's our trouble. Points that
/// the instructor has set stay.
void take_off_for_lateness(Graded &student, double per_cent_per_day);

} // namespace course
