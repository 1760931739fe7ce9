#pragma once
// Points of exercises: what each is worth, and how much of that an answer earns.

#include "class/graded.hpp"
#include "class/trivial.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace course {

/// What exercises are worth: a line of the file gives points to a tier, or to one exercise ("core 2", "5.4 3").
class Worth {
  public:
    /// @throws Complaint naming the line that can't be understood
    explicit Worth(const std::filesystem::path &file);
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

/// "7.5", "10", "0.67": at most two decimals.
std::string points_text(double points);

} // namespace course
