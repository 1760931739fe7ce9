// Pictures of red verdicts: where what a verdict says in words is drawn.

#include "check/described.hpp"
#include "check/marks.hpp"
#include "check/picture.hpp"
#include "interface.hpp"
#include "judge/runner/describe.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace course;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

struct Ball {
    Vec2 position, velocity;
    double radius = 0;
    COURSE_FIELDS("m, m/s, m", position, velocity, radius)
};
struct Shot {
    std::optional<double> time;
    std::vector<Vec2> path;
    Ball ball;
    bool hit = false;
    COURSE_FIELDS("s, m, , ", time, path, ball, hit)
};

Verdict wrong(std::string function, std::vector<std::string> arguments, const std::string &answer,
              std::string expected) {
    return {.kind = Outcome::wrong,
            .call = Call{std::move(function), std::move(arguments), 0, answer},
            .yours = answer,
            .expected = std::move(expected)};
}

std::vector<Mark> with_role(const std::vector<Mark> &marks, Mark::Role role) {
    std::vector<Mark> some;
    std::ranges::copy_if(marks, std::back_inserter(some), [&](const Mark &mark) { return mark.role == role; });
    return some;
}

/// The ends of the drawn arrows of a role, from where they begin, y up.
std::vector<Vec2> arrows_in(const std::string &svg, const std::string &role) {
    pugi::xml_document document;
    REQUIRE(document.load_string(svg.c_str()));
    std::vector<Vec2> all;
    for (const auto &path : document.select_nodes(("//path[@class='" + role + "']").c_str())) {
        double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
        if (std::sscanf(path.node().attribute("d").value(), "M%lf %lfL%lf %lf", &x1, &y1, &x2, &y2) == 4)
            all.push_back({x2 - x1, y1 - y2});
    }
    return all;
}
double angle_deg(const Vec2 &v) { return std::atan2(v.y(), v.x()) * 180 / std::numbers::pi; }

} // namespace

TEST_CASE("the words for a value are read back as that value, units and all") {
    const Shot shot{2.5, {{1, 2}, {-3e-7, 1e20}}, {{4, -1}, {0.1, 0}, 0.5}, true};
    const auto value = read_described(describe(shot), "shot");
    REQUIRE(value);
    REQUIRE(value->parts.size() == 4);
    const auto &[time, path, ball, hit] = std::tie(value->parts[0], value->parts[1], value->parts[2], value->parts[3]);
    CHECK(time.x == 2.5);
    CHECK(time.unit == "s");
    REQUIRE(path.parts.size() == 2);
    CHECK(path.parts[1].x == -3e-7);
    CHECK(path.parts[1].y == 1e20);
    CHECK(path.parts[1].unit == "m");
    CHECK(ball.parts[1].name == "velocity");
    CHECK(ball.parts[1].unit == "m/s");
    CHECK(hit.kind == Described::Kind::other);
    CHECK(read_described(describe(std::vector<double>{1, NAN}, "N m²/kg²"))->parts[1].unit == "N m²/kg²");
    CHECK(read_described(describe(std::vector<double>(40, 1.0), "m"))->parts.empty()); // not all were written out
    CHECK(read_described(describe(std::optional<Ball>{}))->kind == Described::Kind::other);
    for (const char *none : {"", "(1, 2", "(1; 2) m", "3 elements: [1]", "{x 1", "(a, b)"})
        CHECK_FALSE(read_described(none));
}

TEST_CASE("degrees taken for radians: your arrow and the expected one point where their numbers say") {
    const Verdict verdict = wrong("launch_velocity", {"speed = 20 m/s", "angle_deg = 60 °"},
                                  "(-19.0482596, -6.09621242) m/s", "(10, 17.3205081) m/s");
    const auto svg = picture_of(verdict);
    REQUIRE(svg);
    const auto given = arrows_in(*svg, "given"), yours = arrows_in(*svg, "yours"),
               expected = arrows_in(*svg, "expected");
    REQUIRE(given.size() == 1);
    REQUIRE(yours.size() == 1);
    REQUIRE(expected.size() == 1);
    CHECK_THAT(angle_deg(given[0]), WithinAbs(60, 0.2));
    CHECK_THAT(angle_deg(expected[0]), WithinAbs(60, 0.2));
    CHECK_THAT(angle_deg(yours[0]), WithinAbs(-162.25, 0.2));
    CHECK_THAT(yours[0].norm(), WithinAbs(expected[0].norm(), 0.2)); // both 20 m/s
}

TEST_CASE(
    "an answer's velocities begin at the balls that they're called after, and what is right isn't expected, too") {
    Verdict verdict = wrong("resolve_collision",
                            {"a = {position (0, 0) m, velocity (3, 1) m/s, radius 0.5 m}",
                             "b = {position (0.6, 0.8) m, velocity (-1, -1) m/s, radius 0.5 m}", "restitution = 0.8"},
                            "{a (0.84, -1.88) m/s, b (0.728, 1.304) m/s}", "a = (0.408, -2.456) m/s");
    verdict.yours = "a = (0.84, -1.88) m/s";
    verdict.whole = "{a (0.408, -2.456) m/s, b (0.728, 1.304) m/s}";
    const auto marks = marks_of(verdict);
    const auto yours = with_role(marks, Mark::Role::yours), right = with_role(marks, Mark::Role::right),
               expected = with_role(marks, Mark::Role::expected);
    REQUIRE(yours.size() == 1);
    CHECK(yours[0].at[0] == Vec2{0, 0});
    CHECK(yours[0].at[1] == Vec2{0.84, -1.88});
    REQUIRE(right.size() == 1);
    CHECK(right[0].at[0] == Vec2{0.6, 0.8});
    REQUIRE(expected.size() == 1);
    CHECK(expected[0].label == "a");
    CHECK(std::ranges::count(marks, Mark::Kind::circle, &Mark::kind) == 2);
}

TEST_CASE("of a list, only the element that differs is expected elsewhere") {
    Verdict verdict = wrong("dotted_arc", {"muzzle = {position (0, 0) m, velocity (15, 20) m/s}"},
                            "[(0, 0), (1, 2), (9, 9)] m", "[2] = (2, 3) m");
    verdict.yours = "[2] = (9, 9) m";
    const auto marks = marks_of(verdict);
    const auto is_point = [](const Mark &mark) { return mark.kind == Mark::Kind::point; };
    CHECK(std::ranges::count_if(with_role(marks, Mark::Role::unjudged), is_point) == 2);
    CHECK(with_role(marks, Mark::Role::right).empty());
    const auto expected = with_role(marks, Mark::Role::expected);
    const auto point = std::ranges::find_if(expected, is_point);
    REQUIRE(point != expected.end());
    CHECK(point->at[0] == Vec2{2, 3});
    CHECK(std::ranges::count_if(expected, is_point) == 1);
}

TEST_CASE("an arm's links turn from one another, and a pose has the lengths of its arm") {
    const double half = std::numbers::pi / 2;
    const auto marks = marks_of(
        wrong("joints",
              {"base = (1, 0) m",
               "links = [{length 2 m, angle 1.5707963267948966 rad}, {length 3 m, angle -1.5707963267948966 rad}]"},
              "[(1, 0)] m", "[(1, 1)] m"));
    const auto arm = std::ranges::find(marks, Mark::Kind::line, &Mark::kind);
    REQUIRE(arm != marks.end());
    CHECK((arm->at.back() - Vec2{4, 2}).norm() < 1e-12);

    const auto poses = marks_of(wrong("continued", {"arm = {first 3 m, second 2 m}", "target = (3, 2) m"},
                                      "{first 0 rad, second " + describe_number(half) + " rad}", ""));
    const auto pose = with_role(poses, Mark::Role::yours);
    REQUIRE(pose.size() == 1);
    CHECK((pose[0].at.back() - Vec2{3, 2}).norm() < 1e-12);
}

TEST_CASE("numbers that an argument has the unit of are bars, and others no picture") {
    const auto svg =
        picture_of(wrong("collide", {"a = {mass 2 kg, velocity 3 m/s}", "b = {mass 1 kg, velocity -1 m/s}"},
                         "{a 4 m/s, b -2 m/s}", "{a 1 m/s, b 3 m/s}"));
    REQUIRE(svg);
    pugi::xml_document document;
    REQUIRE(document.load_string(svg->c_str()));
    std::vector<double> widths;
    for (const auto &bar : document.select_nodes("//rect")) widths.push_back(bar.node().attribute("width").as_double());
    REQUIRE(widths.size() == 6); // two velocities, and four answers; no masses
    CHECK_THAT(widths[0] / widths[1], WithinAbs(3, 0.1));
    CHECK_FALSE(picture_of(wrong("time_of_flight", {"g = 10 m/s²"}, "4 s", "5 s")));
    CHECK_FALSE(picture_of(wrong("is_even", {"x = 3"}, "true", "false")));
    Verdict untouched = wrong("reflect", {"velocity = (0, -5) m/s", "normal = (0, 1)"}, "", "(0, 5) m/s");
    untouched.kind = Outcome::not_started;
    CHECK_FALSE(picture_of(untouched));
}

TEST_CASE("an answer that is far out, or isn't a number, leaves room for the rest") {
    const auto svg = picture_of(wrong("centre", {"corners = [(0, 0), (4, 0), (0, 3)] m"}, "(1e9, -1e9) m", "(1, 1) m"));
    REQUIRE(svg);
    CHECK_THAT(*svg, ContainsSubstring("yours is far out"));
    pugi::xml_document document;
    REQUIRE(document.load_string(svg->c_str()));
    const auto corners = document.select_nodes("//circle[@class='given dot']");
    REQUIRE(corners.size() == 3);
    CHECK(corners[1].node().attribute("cx").as_double() - corners[0].node().attribute("cx").as_double() > 50);
    const auto nan = picture_of(wrong("centre", {"corners = [(0, 0), (4, 0)] m"}, "(not a number, 1) m", "(1, 1) m"));
    REQUIRE(nan);
    CHECK(nan->find("nan") == std::string::npos);
    CHECK_THAT(*nan, ContainsSubstring("yours has no place here"));
    REQUIRE(document.load_string(nan->c_str()));
    CHECK(document.select_nodes("//*[starts-with(@class, 'yours')]").size() == 1); // these words
}
