#pragma once
// Points of exercises: what each is worth, how much of that an answer earns, what an instructor sets instead, and what it
// costs to hand in late, where the platform says by how much: Moodle's grading worksheet does.

#include "grade/baseline_answers.hpp"
#include "grade/graded.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace course {

/// What exercises are worth: a line of the file gives points to a tier, or to one exercise ("core 2", "5.4 3").
class Worth {
  public:
    /// @param exercises  of the section that's graded
    /// @throws UserError naming the line that can't be understood, or means none of them
    Worth(const std::filesystem::path &file, const std::vector<Exercise> &exercises);
    double of(const Exercise &exercise) const;

  private:
    std::map<std::string, double> points;
};

/// Counts the exercise's tests without those that are void, and sets what it earns of what's possible: all if every test
/// passes; else what it passes beyond the best that an answer does which computes nothing.
/// @param void_tests  by name
/// @param trivial     what such answers pass
void count(GradedExercise &exercise, const std::vector<std::string> &void_tests,
           const std::set<std::vector<std::size_t>> &trivial);

/// What the instructor has set by hand: points and why, by id.
using Overrides = std::map<std::string, std::pair<double, std::string>>;
Overrides read_overrides(const std::filesystem::path &file);

/// The per cent in "10%/day". @throws UserError if it's of another form
double per_cent_per_day(const std::string &words);

/// Started days in Moodle's words for a length of time: 2 in "1 day 2 hours", 1 in "3 mins 20 secs". They come from
/// Moodle's own clock, so no time zone is in them; they have two units, so up to an hour beyond whole days is forgiven.
/// Nothing if these aren't such words.
std::optional<int> started_days(std::string_view late);

/// Takes so much per cent of what's possible for each started day, down to 0, as Canvas' late policy and Moodle's own
/// penalties do; 0 takes nothing. If it can't be read by how much somebody was late, that's our trouble. Points that
/// the instructor has set stay.
void take_off_for_lateness(Graded &student, double per_cent_per_day);

/// "7.5", "10", "0.67": at most two decimals.
std::string points_text(double points);

} // namespace course
