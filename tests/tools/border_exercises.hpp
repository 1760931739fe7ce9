#pragma once
// A section for border_test.cpp: its exercises take a number in each way that there is.

namespace border_exercises {

struct Ball {
    course::Vec2 position{0, 0};
    double radius{};
    COURSE_FIELDS("m, m", position, radius)
};

struct Everything {
    course::Vec2 place{0, 0};
    std::vector<double> numbers{};
    std::vector<course::Vec2> points{};
    std::vector<Ball> balls{};
    std::vector<std::optional<double>> pool{};
    std::optional<double> maybe{};
    std::optional<Ball> ball{};
    COURSE_FIELDS("m, 1, m, 1, 1, 1, 1", place, numbers, points, balls, pool, maybe, ball)
};

struct Clock {
    double time{};
    COURSE_FIELDS("s", time)
};

double halved(double x);
int takes_all(const Everything &all, const std::vector<Ball> &balls, bool flag, int count);
double seconds(const Clock &clock);

constexpr double largest_number(std::string_view exercise) { return exercise == "3" ? 1e10 : course::largest; }

namespace subject {
COURSE_EXERCISE("1", core, border_exercises, halved, "x", "")
COURSE_EXERCISE("2", core, border_exercises, takes_all, "all, balls, flag, count", "")
COURSE_EXERCISE("3", core, border_exercises, seconds, "clock", "s")
} // namespace subject
} // namespace border_exercises
