#include "section_test.hpp"

#include "reflection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using reflection::Ball;
using reflection::Box;
using reflection::Surface;
using namespace reflection::subject; // bounce_in_box, reflect, ... bank_shot: the student's

constexpr double degree = std::numbers::pi / 180;

namespace {

// An answer is right to twelve digits of the largest number that goes in, or of 1 if that is larger; in 6.6, when the image
// is d metres away and d is less than 1, the error may be 1/d times as large. When an edge touches a side, up to rounding,
// it may count as past it or not, and a wall or a normal shorter than 1e-60 may count as one of length 0.

const Box screen{{0, 0}, {16, 9}};
const Box square{{-5, -5}, {5, 5}};

Vec2 at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
Vec2 quarter_turned(const Vec2 &v) { return {-v.y(), v.x()}; }

/// A ball after this time, moved from one side to the next.
Ball rolled(Ball ball, const Box &box, double time) {
    for (int bounces = 0; bounces < 1000; ++bounces) {
        double first = time;
        int axis = -1;
        for (const int each : {0, 1}) {
            const double v = ball.velocity[each];
            if (v == 0) continue;
            const double side = v > 0 ? box.high[each] - ball.radius : box.low[each] + ball.radius;
            const double there = std::max(0.0, (side - ball.position[each]) / v);
            if (there < first) {
                first = there;
                axis = each;
            }
        }
        ball.position += first * ball.velocity;
        if (axis < 0) return ball;
        ball.velocity[axis] = -ball.velocity[axis];
        time -= first;
    }
    return ball;
}

} // namespace

// --------------------------------------------------------------------------------------------------- 6.1 bounce_in_box

//> Worked example: the side on the right
TEST_CASE("a ball whose edge is past the right side, at (3, 2) m/s, leaves at (-3, 2) m/s", "[6.1]") {
    const Box box{{0, 0}, {16, 9}}; // the ball's edge is at 16.5
    CHECK_THAT(bounce_in_box({{15.5, 4}, {3, 2}, 1}, box), IsNear(Vec2{-3, 2}, rounding));
}

//> All four sides
TEST_CASE("each of the four sides turns the ball back", "[6.1]") {
    CHECK_THAT(bounce_in_box({{0.5, 4}, {-3, 2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 8.5}, {3, 2}, 1}, screen), IsNear(Vec2{3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 0.5}, {3, -2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{-11, 0}, {-3, 2}, 1}, {{-10, -4}, {-2, 3}}), IsNear(Vec2{3, 2}, rounding));
}

//> Within
TEST_CASE("a ball that has passed no side keeps its velocity", "[6.1]") {
    CHECK_THAT(bounce_in_box({{8, 4}, {3, 2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{14.9, 7.9}, {3, 2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{1.1, 1.1}, {-3, -2}, 1}, screen), IsNear(Vec2{-3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{-6, -1}, {-3, -2}, 1}, {{-10, -4}, {-2, 3}}), IsNear(Vec2{-3, -2}, rounding));
}

//> On its way back
TEST_CASE("a ball that is past the right side, but moves back already, keeps its velocity", "[6.1]") {
    CHECK_THAT(bounce_in_box({{15.5, 4}, {-4, 1}, 1}, screen), IsNear(Vec2{-4, 1}, rounding));
    CHECK_THAT(bounce_in_box({{0.5, 4}, {3, 2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 8.5}, {3, -2}, 1}, screen), IsNear(Vec2{3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 0.5}, {3, 2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
}

//> In a corner
TEST_CASE("in a corner both sides turn the ball back", "[6.1]") {
    CHECK_THAT(bounce_in_box({{15.5, 8.5}, {3, 2}, 1}, screen), IsNear(Vec2{-3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{0.5, 0.5}, {-3, -2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{15.5, 0.5}, {3, 2}, 1}, screen), IsNear(Vec2{-3, 2}, rounding)); // already on its way up
    CHECK_THAT(bounce_in_box({{0.5, 8.5}, {-3, -2}, 1}, screen), IsNear(Vec2{3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{18, 12}, {3, -2}, 1}, screen), IsNear(Vec2{-3, -2}, rounding)); // far outside
}

//> It comes back
TEST_CASE("a ball that one long frame has put far outside comes back in short frames", "[6.1]") {
    Ball ball{{20, 4}, {3, 2}, 1};
    for (int frame = 0; frame < 120; ++frame) { // two seconds, in which it moves by 6 m
        ball.velocity = bounce_in_box(ball, screen);
        ball.position += ball.velocity / 60;
    }
    CHECK_THAT(ball.position.x(), IsNear(14.0, 1e-9).of("x after 2 s [m]"));
    CHECK_THAT(ball.velocity, IsNear(Vec2{-3, 2}, rounding).of("velocity after 2 s [m/s]"));
}

//> Never farther outside than one frame
TEST_CASE("frame by frame a ball keeps its speed, and is outside by no more than one frame's motion", "[6.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(100); ++i) {
        Ball ball{{dice.real(1, 15), dice.real(1, 8)}, dice.point(-20, 20), dice.real(0, 1)};
        const double speed = ball.velocity.norm();
        for (int frame = 0; frame < 120; ++frame) {
            ball.velocity = bounce_in_box(ball, screen);
            ball.position += ball.velocity / 60;
            const Vec2 edge{ball.radius, ball.radius};
            const double past = std::max((screen.low - ball.position + edge).maxCoeff(),
                                         (ball.position + edge - screen.high).maxCoeff());
            CHECK_THAT(past, IsAtMost(20.0 / 60 + 1e-9).of("how far the ball's edge is past a side [m]"));
            CHECK_THAT(ball.velocity.norm(), IsNear(speed, rounding).of("speed [m/s]"));
        }
    }
}

//> Erratum E6.7
TEST_CASE("erratum E6.7: a ball at the edge, on its way back, is turned again by the printed test", "[6.1]") {
    const Box printed_screen{{0, 0}, {100, 80}};
    Ball ball{{100.5, 40}, {-4, 0}, 0};
    double printed_x = 100.5, printed_velocity = -4;
    for (int frame = 0; frame < 10; ++frame) {
        ball.velocity = bounce_in_box(ball, printed_screen);
        ball.position += ball.velocity;
        if (printed_x >= 100 || printed_x <= 0) printed_velocity = -printed_velocity;
        printed_x += printed_velocity;
    }
    CHECK_THAT(ball.position.x(), IsNear(60.5, rounding).of("x after 10 frames [px]"));
    CHECK_THAT(printed_x, IsNear(100.5, rounding).of("x after 10 frames, as printed [px]"));
}

//> Erratum E6.8
TEST_CASE("erratum E6.8: half of a ball is outside before the printed test sees that it is past the side", "[6.1]") {
    const double centre = 15.5;
    CHECK_THAT(bounce_in_box({{centre, 4}, {3, 2}, 1}, screen).x(),
               IsNear(-3.0, rounding).of("velocity to the right [m/s]"));
    CHECK_THAT(centre < 16, IsTrue("the centre, which the printed test asks for, has not reached the side"));
}

//>
TEST_CASE("a ball of no size, one that rests, one that only just fits, and one past a side by a hair, or by far",
          "[6.1]") {
    CHECK_THAT(bounce_in_box({{16.25, 4}, {3, 2}, 0}, screen), IsNear(Vec2{-3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{15.75, 4}, {3, 2}, 0}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{15.5, 4}, {0, 0}, 1}, screen), IsNear(Vec2{0, 0}, rounding));
    CHECK_THAT(bounce_in_box({{15.5, 4}, {0, 2}, 1}, screen), IsNear(Vec2{0, 2}, rounding));
    CHECK_THAT(bounce_in_box({{-0.25, -0.25}, {-3, -2}, 0}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 9.25}, {3, 2}, 0}, screen), IsNear(Vec2{3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 4.6}, {3, 2}, 4.49}, screen), IsNear(Vec2{3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{3, 1}, {3, 2}, 1}, {{0, 0}, {2 + 1e-10, 9}}), IsNear(Vec2{-3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{8, 4}, {3e-9, 5e-10}, 1e-9}, {{0, 0}, {7, 3}}), IsNear(Vec2{-3e-9, -5e-10}, rounding));
    CHECK_THAT(bounce_in_box({{-1, -1}, {-3e-9, -5e-10}, 1e-9}, {{0, 0}, {7, 3}}), IsNear(Vec2{3e-9, 5e-10}, rounding));
    const double hair = 1e-10; // [m]
    CHECK_THAT(bounce_in_box({{1 - hair, 1 - hair}, {-3, -2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{1 + hair, 1 + hair}, {-3, -2}, 1}, screen), IsNear(Vec2{-3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{15 + hair, 8 + hair}, {3, 2}, 1}, screen), IsNear(Vec2{-3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{15 - hair, 8 - hair}, {3, 2}, 1}, screen), IsNear(Vec2{3, 2}, rounding));
    const Box elsewhere{{-10, -4}, {-2, 3}};
    CHECK_THAT(bounce_in_box({{-3, 2}, {3, 2}, 1.5}, elsewhere), IsNear(Vec2{-3, -2}, rounding));
    CHECK_THAT(bounce_in_box({{-9, -3}, {-3, -2}, 1.5}, elsewhere), IsNear(Vec2{3, 2}, rounding));
    CHECK_THAT(bounce_in_box({{1e5, -1e5}, {1e5, -1e5}, 1}, screen), IsNear(Vec2{-1e5, 1e5}, rounding));
    CHECK_THAT(bounce_in_box({{-1e5, 1e5}, {-1e5, 1e5}, 1}, screen), IsNear(Vec2{1e5, -1e5}, rounding));
    CHECK_THAT(bounce_in_box({{5e4, 6e4}, {3, 2}, 5e4 - 1}, {{-1e5, -1e5}, {1e5, 1e5}}), IsNear(Vec2{3, -2}, rounding));
}

TEST_CASE("a negative radius, or a box that is too small, is refused by bounce_in_box", "[6.1]") {
    CHECK_REFUSED(bounce_in_box({{8, 4}, {3, 2}, -1}, screen));
    CHECK_REFUSED(bounce_in_box({{8, 4}, {3, 2}, -1e-9}, screen));
    CHECK_REFUSED(bounce_in_box({{8, 4}, {3, 2}, 5}, screen), "a ball of 10 m in a box of 16 by 9 m");
    CHECK_REFUSED(bounce_in_box({{8, 4}, {3, 2}, 1}, {{16, 0}, {0, 9}}), "a box whose low is on the right");
    CHECK_REFUSED(bounce_in_box({{8, 4}, {3, 2}, 1}, {{0, 9}, {16, 0}}), "a box whose low is above");
    CHECK_REFUSED(bounce_in_box({{8, 4}, {3, 2}, 0}, {{0, 0}, {16, 0}}));
    bounce_in_box({{8, 4}, {3, 2}, 1}, screen); // good input is still answered
}

// --------------------------------------------------------------------------------------------------------- 6.2 reflect

//> Worked example: the slanted wall
TEST_CASE("at (0, -5) m/s onto a wall with the normal (-0.6, 0.8), a ball leaves at (-4.8, 1.4) m/s", "[6.2]") {
    CHECK_THAT(reflect({0, -5}, {-0.6, 0.8}), IsNear(Vec2{-4.8, 1.4}, rounding)); // the normal part is (2.4, -3.2)
}

//> Worked example: a floor
TEST_CASE("at (4, -2) m/s onto a floor, a ball leaves at (4, 2) m/s", "[6.2]") {
    CHECK_THAT(reflect({4, -2}, {0, 1}), IsNear(Vec2{4, 2}, rounding));
    CHECK_THAT(reflect({4, -2}, {-1, 0}), IsNear(Vec2{-4, -2}, rounding));
}

//> Along the wall
TEST_CASE("along the wall nothing changes, straight onto it the ball turns back", "[6.2]") {
    CHECK_THAT(reflect({4, 3}, {-0.6, 0.8}), IsNear(Vec2{4, 3}, rounding));
    CHECK_THAT(reflect({3, -4}, {-0.6, 0.8}), IsNear(Vec2{-3, 4}, rounding));
    CHECK_THAT(reflect({0, 0}, {-0.6, 0.8}), IsNear(Vec2{0, 0}, rounding));
}

//> Either side
TEST_CASE("a normal to the other side gives the same answer", "[6.2]") {
    CHECK_THAT(reflect({0, -5}, {0.6, -0.8}), IsNear(Vec2{-4.8, 1.4}, rounding));
    CHECK_THAT(reflect({0, 5}, {-0.6, 0.8}), IsNear(Vec2{4.8, -1.4}, rounding)); // from behind
}

//> Any length
TEST_CASE("a normal of another length gives the same answer", "[6.2]") {
    CHECK_THAT(reflect({0, -5}, {-3, 4}), IsNear(Vec2{-4.8, 1.4}, rounding)); // five times as long
    CHECK_THAT(reflect({4, -2}, {0, 2}), IsNear(Vec2{4, 2}, rounding));
    CHECK_THAT(reflect({1, 0}, {-0.1, 0.1}), IsNear(Vec2{0, 1}, rounding)); // off a wall of 45°
}

//> Laws of reflection
TEST_CASE("the speed and the tangential part stay, the normal part is reversed, at every angle", "[6.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 velocity = dice.point(-10, 10), normal = dice.direction(), along = quarter_turned(normal);

        const Vec2 after = reflect(velocity, dice.real(0.1, 10) * dice.sign() * normal);

        CHECK_THAT(after.norm(), IsNear(velocity.norm(), 1e-11).of("speed [m/s]"));
        CHECK_THAT(after.dot(along), IsNear(velocity.dot(along), 1e-11).of("speed along the wall [m/s]"));
        CHECK_THAT(after.dot(normal), IsNear(-velocity.dot(normal), 1e-11).of("speed across the wall [m/s]"));
    }
}

//> By angles
TEST_CASE("the angle out is the angle in, on the other side of the normal", "[6.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const double to_ball = dice.real(-3, 3), between = dice.real(-1.5, 1.5), speed = dice.real(0.1, 10);

        const Vec2 after = reflect(-speed * at_angle(to_ball + between), at_angle(to_ball));

        CHECK_THAT(after, IsNear(Vec2{speed * at_angle(to_ball - between)}, 1e-11));
    }
}

//> Twice
TEST_CASE("reflected twice by the same wall, a velocity is what it was", "[6.2]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 velocity = dice.point(-10, 10), normal = dice.real(0.1, 10) * dice.direction();
        CHECK_THAT(reflect(reflect(velocity, normal), normal), IsNear(velocity, 1e-11));
    }
}

//> Erratum E6.2
TEST_CASE("erratum E6.2: (-4, -2) onto a floor leaves as (-4, 2), not as the (4, 2) of the figure", "[6.2]") {
    CHECK_THAT(reflect({-4, -2}, {0, 1}), IsNear(Vec2{-4, 2}, rounding));
}

//> Erratum E6.4
TEST_CASE("erratum E6.4: N = (0, 2) in the place of N' = (0, 1) would make (4, 14) of (4, -2)", "[6.2]") {
    const Vec2 velocity{4, -2}, normal{0, 2}, printed = velocity - 2 * velocity.dot(normal) * normal;
    CHECK_THAT(printed, IsNear(Vec2{4, 14}, rounding).of("with N for N' [m/s]"));
    CHECK_THAT(reflect(velocity, normal), IsNear(Vec2{4, 2}, rounding));
}

//> Erratum E6.9
TEST_CASE("erratum E6.9: two bodies that bounce like walls do not conserve momentum: 4 kg m/s become -4", "[6.2]") {
    const Vec2 light = reflect({4, 0}, {1, 0}), heavy = reflect({0, 0}, {1, 0});
    CHECK_THAT(1 * light.x() + 10 * heavy.x(), IsNear(-4.0, rounding).of("momentum after, from 4 [kg m/s]"));
}

//>
TEST_CASE("velocities and normals up to 1e5 are allowed, and tiny ones", "[6.2]") {
    CHECK_THAT(reflect({0, -1e5}, {-6e4, 8e4}), IsNear(Vec2{-96000, 28000}, rounding));
    CHECK_THAT(reflect({1e5, 0}, {1e5, 1e5}), IsNear(Vec2{0, -1e5}, rounding));
    CHECK_THAT(reflect({1e5, 1e5}, at_angle(-67.5 * degree)), IsNear(Vec2{1e5 * std::sqrt(2), 0}, rounding));
    CHECK_THAT(reflect({0, -5}, {-6e-9, 8e-9}), IsNear(Vec2{-4.8, 1.4}, 1e-11));
    CHECK_THAT(reflect({0, -5}, {-1.2e-60, 1.6e-60}), IsNear(Vec2{-4.8, 1.4}, 1e-11));
    CHECK_THAT(reflect({0, -5e-10}, {-0.6, 0.8}), IsNear(Vec2{-4.8e-10, 1.4e-10}, rounding));
    CHECK_THAT(reflect({-5, 0}, {1 + 1e-10, 0}), IsNear(Vec2{5, 0}, rounding)); // a length of nearly 1
    CHECK_THAT(reflect({0, -5}, {1, 1e-10}), IsNear(Vec2{1e-9, -5}, rounding)); // nearly along the wall
    CHECK_THAT(reflect({5, 5e-10}, {1, 0}), IsNear(Vec2{-5, 5e-10}, rounding)); // nearly straight onto it
}

TEST_CASE("a normal of length 0 is refused by reflect", "[6.2]") {
    CHECK_REFUSED(reflect({0, -5}, {0, 0}));
    CHECK_REFUSED(reflect({0, 0}, {0, 0}));
    reflect({0, -5}, {-3, 4}); // good input is still answered
}

// ----------------------------------------------------------------------------------------------------- 6.3 unit_normal

//> Worked example: from one end to the other
TEST_CASE("the wall from (1, 1) to (5, 4) has the unit normal (-0.6, 0.8)", "[6.3]") {
    CHECK_THAT(unit_normal({1, 1}, {5, 4}), IsNear(Vec2{-0.6, 0.8}, rounding)); // the wall is (4, 3), and 5 m long
}

//> Upright and level
TEST_CASE("to the left of a wall that runs to the right is up, and of one that runs up is left", "[6.3]") {
    CHECK_THAT(unit_normal({2, 3}, {6, 3}), IsNear(Vec2{0, 1}, rounding));
    CHECK_THAT(unit_normal({2, 3}, {2, 9}), IsNear(Vec2{-1, 0}, rounding));
}

//> From the other end
TEST_CASE("from its other end, the wall's left is on the other side", "[6.3]") {
    CHECK_THAT(unit_normal({5, 4}, {1, 1}), IsNear(Vec2{0.6, -0.8}, rounding));
    CHECK_THAT(unit_normal({6, 3}, {2, 3}), IsNear(Vec2{0, -1}, rounding));
    CHECK_THAT(unit_normal({2, 9}, {2, 3}), IsNear(Vec2{1, 0}, rounding));
}

//> Half as long
TEST_CASE("a wall of half or twice the length has the same unit normal", "[6.3]") {
    CHECK_THAT(unit_normal({1, 1}, {3, 2.5}), IsNear(Vec2{-0.6, 0.8}, rounding));
    CHECK_THAT(unit_normal({1, 1}, {9, 7}), IsNear(Vec2{-0.6, 0.8}, rounding));
}

//> At every angle
TEST_CASE("it has length 1, a right angle to the wall, and is on its left, at every angle", "[6.3]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 start = dice.point(-10, 10), along = dice.direction();

        const Vec2 normal = unit_normal(start, start + dice.real(0.5, 20) * along);

        CHECK_THAT(normal.norm(), IsNear(1.0, rounding).of("length of the normal"));
        CHECK_THAT(normal.dot(along), IsNear(0.0, 1e-11).of("dot product with the wall's direction"));
        CHECK_THAT(normal.dot(quarter_turned(along)), IsNear(1.0, rounding).of("dot product with its left"));
    }
}

//> Erratum E6.3
TEST_CASE("erratum E6.3: at a right angle to (3, 4) is (-4, 3); the printed (4, 3) is not", "[6.3]") {
    const Vec2 wall{3, 4}, normal = unit_normal({0, 0}, wall), printed{4, 3};
    CHECK_THAT(wall.dot(normal), IsNear(0.0, rounding).of("dot product with the wall"));
    CHECK_THAT(wall.dot(printed), IsNear(24.0, rounding).of("dot product of the printed one with the wall"));
}

//> Erratum E6.3, on axes
TEST_CASE("erratum E6.3: along an axis the printed normal is right but for its sign, which a reflection forgets",
          "[6.3]") {
    const Vec2 wall{0, 2}, printed{wall.y(), wall.x()};
    CHECK_THAT(wall.dot(printed), IsNear(0.0, rounding).of("dot product of the printed one with the wall"));
    CHECK_THAT(unit_normal({0, 0}, wall), IsNear(Vec2{-printed / printed.norm()}, rounding));
}

//>
TEST_CASE("walls of any length, anywhere", "[6.3]") {
    CHECK_THAT(unit_normal({-1e5, -1e5}, {1e5, 1e5}), IsNear(Vec2{-std::sqrt(0.5), std::sqrt(0.5)}, 1e-7));
    CHECK_THAT(unit_normal({0, 0}, {4e-9, 3e-9}), IsNear(Vec2{-0.6, 0.8}, rounding));
    CHECK_THAT(unit_normal({0, 0}, {-1.6e-60, 1.2e-60}), IsNear(Vec2{-0.6, -0.8}, rounding));
    CHECK_THAT(unit_normal({0.5, 0.5}, {0.5, 0.5 + std::ldexp(1, -50)}), IsNear(Vec2{-1, 0}, rounding));
    CHECK_THAT(unit_normal({-1, 0}, {0, 5e-10}), IsNear(Vec2{-5e-10, 1}, rounding)); // nearly level
    CHECK_THAT(unit_normal({4, -3}, {0, 0}), IsNear(Vec2{-0.6, -0.8}, rounding));
    CHECK_THAT(unit_normal({-4, -3}, {0, 0}), IsNear(Vec2{-0.6, 0.8}, rounding));
    CHECK_THAT(unit_normal({99996, 3}, {1e5, 0}), IsNear(Vec2{0.6, 0.8}, 1e-7));
}

TEST_CASE("a wall of no length is refused by unit_normal", "[6.3]") {
    CHECK_REFUSED(unit_normal({1, 1}, {1, 1}));
    CHECK_REFUSED(unit_normal({0, 0}, {0, 0}));
    unit_normal({1, 1}, {5, 4}); // good input is still answered
}

// ---------------------------------------------------------------------------------------------------------- 6.4 bounce

//> Worked example: a rubber wall
TEST_CASE("with restitution 0.5, without friction, (0, -5) leaves at (-3.6, -0.2) m/s", "[6.4]") {
    CHECK_THAT(bounce({0, -5}, {-0.6, 0.8}, {0.5, 0}), IsNear(Vec2{-3.6, -0.2}, rounding));
}

//> Worked example: a rough wall
TEST_CASE("with restitution 0.5 and mu_k = 0.3, (0, -5) leaves at (-2.16, 0.88) m/s", "[6.4]") {
    CHECK_THAT(bounce({0, -5}, {-0.6, 0.8}, {0.5, 0.3}),
               IsNear(Vec2{-2.16, 0.88}, rounding).since("the tangential speed, 3 m/s, loses 0.3 · (4 + 2) = 1.8 m/s"));
}

//> No more than there is
TEST_CASE("with mu_k = 1, friction could take 6 m/s, but there are only 3: (0, -5) leaves straight out", "[6.4]") {
    CHECK_THAT(bounce({0, -5}, {-0.6, 0.8}, {0.5, 1}), IsNear(Vec2{-1.2, 1.6}, rounding));
    CHECK_THAT(bounce({0, -5}, {-0.6, 0.8}, {0, 1}), IsNear(Vec2{0, 0}, rounding)); // clay
}

//> Straight onto a rough wall
TEST_CASE("straight onto a rough wall there is no tangential part, and nothing to take", "[6.4]") {
    CHECK_THAT(bounce({0, -5}, {0, 1}, {0.5, 0.3}), IsNear(Vec2{0, 2.5}, rounding));
    CHECK_THAT(bounce({-5, 0}, {1, 0}, {1, 0}), IsNear(Vec2{5, 0}, rounding));
}

//> On its way out
TEST_CASE("a ball that moves away from the wall, or along it, keeps its velocity", "[6.4]") {
    CHECK_THAT(bounce({0, 5}, {-0.6, 0.8}, {0.5, 0.3}), IsNear(Vec2{0, 5}, rounding));
    CHECK_THAT(bounce({0, -5}, {0.6, -0.8}, {0.5, 0.3}), IsNear(Vec2{0, -5}, rounding)); // from the other side
    CHECK_THAT(bounce({3, 0}, {0, 1}, {0.5, 0.3}), IsNear(Vec2{3, 0}, rounding));
    CHECK_THAT(bounce({0, 0}, {0, 1}, {0.5, 0.3}), IsNear(Vec2{0, 0}, rounding));
}

//> A normal of any length
TEST_CASE("a normal of another length changes nothing", "[6.4]") {
    CHECK_THAT(bounce({0, -5}, {-3, 4}, {0.5, 0.3}), IsNear(Vec2{-2.16, 0.88}, rounding));
    CHECK_THAT(bounce({0, -5}, {-6e-9, 8e-9}, {0.5, 0.3}), IsNear(Vec2{-2.16, 0.88}, rounding));
    CHECK_THAT(bounce({0, -5}, {-1.2e-60, 1.6e-60}, {0.5, 0.3}), IsNear(Vec2{-2.16, 0.88}, rounding));
    CHECK_THAT(bounce({-5, 0}, {1 + 1e-10, 0}, {1, 0}), IsNear(Vec2{5, 0}, rounding)); // of nearly 1
    CHECK_THAT(bounce({-5, 0}, {1, 1e-10}, {1, 0}), IsNear(Vec2{5, 1e-9}, rounding));  // nearly level
}

//> Smooth and elastic
TEST_CASE("smooth and with restitution 1, a wall reflects: the normal part is reversed, the other stays", "[6.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Vec2 normal = dice.direction(), along = quarter_turned(normal);
        const double towards = dice.real(0, 10), tangential = dice.real(-10, 10);

        const Vec2 after = bounce(tangential * along - towards * normal, normal, {1, 0});

        CHECK_THAT(after, IsNear(Vec2{tangential * along + towards * normal}, 1e-11));
    }
}

//> Energy
TEST_CASE("at every angle the parts are what they should be, and energy is never won", "[6.4]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const Vec2 normal = dice.direction(), along = quarter_turned(normal);
        const double towards = dice.real(0, 10), tangential = dice.real(0, 10), to = dice.sign();
        const Surface surface{dice.real(0, 1), dice.real(0, 1)};

        const Vec2 after = bounce(to * tangential * along - towards * normal, normal, surface);

        const double impulse = (1 + surface.restitution) * towards; // for each kg [m/s]
        const double left = std::max(0.0, tangential - surface.mu_k * impulse);
        CHECK_THAT(after.dot(normal), IsNear(impulse - towards, 1e-11).of("normal speed [m/s]"));
        CHECK_THAT(after.dot(along), IsNear(to * left, 1e-11).of("speed along the wall [m/s]"));
        CHECK_THAT(after.norm(), IsAtMost(std::hypot(towards, tangential) + 1e-9).of("speed [m/s]"));
    }
}

//>
TEST_CASE("fast and slow bounces, and very rough walls", "[6.4]") {
    CHECK_THAT(bounce({6e4, -8e4}, {0, 1e5}, {0.5, 0.25}), IsNear(Vec2{3e4, 4e4}, 1e-7));
    CHECK_THAT(bounce({6e4, -8e4}, {0, 1}, {0.5, 1e5}), IsNear(Vec2{0, 4e4}, 1e-7));
    CHECK_THAT(bounce({-1e5, 0}, {1e5, 1e5}, {1, 0}), IsNear(Vec2{0, 1e5}, rounding));
    CHECK_THAT(bounce({0, -1e5}, {1e5, 1e5}, {1, 0}), IsNear(Vec2{1e5, 0}, rounding));
    CHECK_THAT(bounce({-1e5, -1e5}, at_angle(22.5 * degree), {1, 0}), IsNear(Vec2{1e5 * std::sqrt(2), 0}, rounding));
    CHECK_THAT(bounce({100, -1}, {0, 1}, {0.5, 20}), IsNear(Vec2{70, 0.5}, rounding));
    CHECK_THAT(bounce({6, -8}, {0, 1}, {0.5, 5e-7}), IsNear(Vec2{6 - 6e-6, 4}, rounding)); // nearly smooth
    CHECK_THAT(bounce({0.6, -5e-10}, {0, 1}, {1, 0.3}), IsNear(Vec2{0.6 - 3e-10, 5e-10}, rounding));
    CHECK_THAT(bounce({3 + 5e-10, -8}, {0, 1}, {0.5, 0.25}), IsNear(Vec2{5e-10, 4}, rounding)); // 3 m/s are lost
    CHECK_THAT(bounce({5e-10, -8}, {0, 1}, {0.5, 0.25}), IsNear(Vec2{0, 4}, rounding));
}

//> Above 1
TEST_CASE("with restitution 1.5 the wall kicks: what comes at 4 m/s into it leaves at 6 m/s, and friction is more",
          "[6.4]") {
    CHECK_THAT(bounce({0, -5}, {-0.6, 0.8}, {1.5, 0}), IsNear(Vec2{-6, 3}, rounding));
    CHECK_THAT(bounce({0, -5}, {-0.6, 0.8}, {1.5, 0.2}),
               IsNear(Vec2{-4.4, 4.2}, rounding).since("the tangential speed, 3 m/s, loses 0.2 · (4 + 6) = 2 m/s"));
    CHECK_THAT(bounce({3, -4}, {0, 1}, {1e5, 0}), IsNear(Vec2{3, 4e5}, 1e-6));
}

//>
TEST_CASE("no normal, or a negative restitution or mu_k, is refused", "[6.4]") {
    CHECK_REFUSED(bounce({0, -5}, {0, 0}, {0.5, 0.3}));
    CHECK_REFUSED(bounce({0, -5}, {0, 1}, {-0.1, 0.3}));
    CHECK_REFUSED(bounce({0, -5}, {0, 1}, {-1e-10, 0.3}));
    CHECK_REFUSED(bounce({0, -5}, {0, 1}, {0, -0.1}));
    CHECK_REFUSED(bounce({0, -5}, {0, 1}, {0.5, -1e-10}));
    CHECK_REFUSED(bounce({0, 5}, {0, 1}, {-0.1, 0.3}), "a restitution of -0.1, as the ball moves away");
    CHECK_REFUSED(bounce({0, 0}, {0, 1}, {0.5, -0.1}), "a mu_k of -0.1, and the ball rests");
    bounce({0, -5}, {0, 1}, {0.5, 0.3}); // good input is still answered
}

// ------------------------------------------------------------------------------------------- 6.5 bounce_in_rotated_box

const double three_four = std::asin(0.6); // 36.87°, its cosine is 0.8

//> Worked example: a turned square
TEST_CASE("in a square that is turned by 36.87°, a ball at (4, 3) m with (5, 10) m/s leaves at (-11, -2) m/s",
          "[6.5]") {
    // from the square: at (5, 0), with (10, 5)
    CHECK_THAT(bounce_in_rotated_box({{4, 3}, {5, 10}, 0.5}, square, three_four), IsNear(Vec2{-11, -2}, 1e-11));
}

//> Not turned
TEST_CASE("in a box that is not turned, it is what 6.1 says", "[6.5]") {
    CHECK_THAT(bounce_in_rotated_box({{15.5, 4}, {3, 2}, 1}, screen, 0), IsNear(Vec2{-3, 2}, 1e-11));
    CHECK_THAT(bounce_in_rotated_box({{15.5, 8.5}, {3, 2}, 1}, screen, 0), IsNear(Vec2{-3, -2}, 1e-11));
    CHECK_THAT(bounce_in_rotated_box({{8, 4}, {3, 2}, 1}, screen, 0), IsNear(Vec2{3, 2}, 1e-11));
}

//> A quarter turn
TEST_CASE("turned by 90°, the screen stands on its side, on the left of the origin", "[6.5]") {
    CHECK_THAT(bounce_in_rotated_box({{-4, 15.5}, {2, 3}, 1}, screen, 90 * degree), IsNear(Vec2{2, -3}, 1e-11));
    CHECK_THAT(bounce_in_rotated_box({{-8.5, 8}, {-2, 3}, 1}, screen, 90 * degree), IsNear(Vec2{2, 3}, 1e-11));
    CHECK_THAT(bounce_in_rotated_box({{4, -15.5}, {2, -3}, 1}, screen, -90 * degree), IsNear(Vec2{2, 3}, 1e-11));
}

//> Already on its way back
TEST_CASE("in a turned box, too, a ball that moves back already keeps its velocity", "[6.5]") {
    CHECK_THAT(bounce_in_rotated_box({{4, 3}, {-11, -2}, 0.5}, square, three_four), IsNear(Vec2{-11, -2}, 1e-11));
    CHECK_THAT(bounce_in_rotated_box({{4, 3}, {5, 10}, 0.5}, square, three_four), IsNear(Vec2{-11, -2}, 1e-11));
}

//> Everything turned
TEST_CASE("ball and box turned together: the answer is turned as well, at every angle", "[6.5]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double angle = dice.real(-7, 7);
        const Vec2 right = at_angle(angle), up = quarter_turned(right);
        const auto turned = [&](const Vec2 &v) { return Vec2{v.x() * right + v.y() * up}; };
        const double past_right = dice.sign(), past_top = dice.sign(), x = dice.real(0.1, 5), y = dice.real(0.1, 5);
        const Vec2 low = dice.point(-10, 10), middle = low + Vec2{8, 4.5};
        const Box box{low, low + Vec2{16, 9}};
        // past a side on the right or left, and one above or below
        const Ball outside{turned(middle + Vec2{past_right * 7.5, past_top * 4}),
                           turned({past_right * x, past_top * y}), 1};

        const Vec2 after = bounce_in_rotated_box(outside, box, angle);

        CHECK_THAT(after, IsNear(turned({-past_right * x, -past_top * y}), 1e-11));
        const Ball inside{turned(middle + Vec2{past_right * 6.5, past_top * 3}), outside.velocity, 1};
        CHECK_THAT(bounce_in_rotated_box(inside, box, angle), IsNear(outside.velocity, 1e-11));
        CHECK_THAT(bounce_in_rotated_box({outside.position, after, 1}, box, angle), IsNear(after, 1e-11));
    }
}

//>
TEST_CASE("after whole turns the box is where it was; it may be large, or hardly turned, and the ball fast or at rest",
          "[6.5]") {
    CHECK_THAT(bounce_in_rotated_box({{15.5, 4}, {3, 2}, 1}, screen, 2000 * std::numbers::pi),
               IsNear(Vec2{-3, 2}, 1e-9));
    CHECK_THAT(bounce_in_rotated_box({{6e4, 4.5e4}, {5e4, 0}, 10}, {{-5e4, -5e4}, {5e4, 5e4}}, three_four),
               IsNear(Vec2{-1.4e4, -4.8e4}, 1e-6));
    CHECK_THAT(bounce_in_rotated_box({5.5 * at_angle(1e5), 3 * at_angle(1e5), 0}, square, 1e5),
               IsNear(Vec2{-3 * at_angle(1e5)}, 1e-6));
    const Box large{{-1e5, -1e5}, {9e4, 1e5}};
    CHECK_THAT(bounce_in_rotated_box({{9e4, 9.8e4}, 1.3e5 * at_angle(45 * degree), 5e3}, large, 5 * degree),
               IsNear(Vec2{1.3e5 * at_angle(145 * degree)}, rounding)); // as seen from the box, it comes in at 40°
    CHECK_THAT(bounce_in_rotated_box({{1e5, 0}, {1e5, 0}, 0}, {{-9e4, -1e5}, {9e4, 1e5}}, 5 * degree),
               IsNear(Vec2{1e5 * at_angle(190 * degree)}, rounding));
    CHECK_THAT(bounce_in_rotated_box({{0, 1e5}, {0, 1e5}, 0}, {{-1e5, -9e4}, {1e5, 9e4}}, 5 * degree),
               IsNear(Vec2{1e5 * at_angle(-80 * degree)}, rounding));
    for (const double angle : {9e-4, 4e-11})
        CHECK_THAT(bounce_in_rotated_box({{5, 0}, {5, 0}, 0.5}, square, angle),
                   IsNear(Vec2{-5 * at_angle(2 * angle)}, rounding));
    CHECK_THAT(bounce_in_rotated_box({{0, 4}, {0, 0}, 1}, {{-1, 0}, {1 + 1e-10, 9}}, 0.5),
               IsNear(Vec2{0, 0}, rounding));
    CHECK_THAT(bounce_in_rotated_box({{5.5, 0}, {5, 0}, 1e-9}, square, 0), IsNear(Vec2{-5, 0}, rounding));
}

TEST_CASE("what bounce_in_box refuses is refused by bounce_in_rotated_box", "[6.5]") {
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, -1}, square, 0.5));
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, 5}, square, 0.5), "a ball as large as the box");
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, -1e-9}, square, 0.5));
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, 1}, {{-1, -5}, {1, 5}}, 0.5), "a ball as wide as the box");
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, 1}, {{-5, -1}, {5, 1}}, 0.5), "a ball as high as the box");
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, 1}, {{5, -5}, {-5, 5}}, 0.5),
                  "a box whose low is on the right");
    CHECK_REFUSED(bounce_in_rotated_box({{0, 0}, {3, 2}, 1}, {{-5, 5}, {5, -5}}, 0.5), "a box whose low is above");
    bounce_in_rotated_box({{0, 0}, {3, 2}, 1}, square, 0.5); // good input is still answered
}

// ------------------------------------------------------------------------------------------------------- 6.6 bank_shot

const Box table{{0, 0}, {10, 6}};
const Ball cue{{2, 2}, {0, 0}, 1}; // its centre has room from (1, 1) to (9, 5)

//> Worked example: one cushion
TEST_CASE("over the right cushion from (2, 2) to (3, 4): aim at the image (15, 4)", "[6.6]") {
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 1, 0), IsNear(Vec2{Vec2{13, 2}.normalized()}, rounding));
}

//> Straight at it
TEST_CASE("over no cushion at all it is aimed straight at the target", "[6.6]") {
    CHECK_THAT(bank_shot(cue, {5, 4}, table, 0, 0), IsNear(Vec2{Vec2{3, 2}.normalized()}, rounding));
}

//> One of the other cushions
TEST_CASE("over the left, the upper and the lower cushion", "[6.6]") {
    CHECK_THAT(bank_shot(cue, {3, 4}, table, -1, 0), IsNear(Vec2{Vec2{-3, 2}.normalized()}, rounding)); // to (-1, 4)
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 0, 1), IsNear(Vec2{Vec2{1, 4}.normalized()}, rounding));   // to (3, 6)
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 0, -1), IsNear(Vec2{Vec2{1, -4}.normalized()}, rounding)); // to (3, -2)
}

//> Two cushions
TEST_CASE("over two cushions: two that meet in a corner, or two that face each other", "[6.6]") {
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 1, 1), IsNear(Vec2{Vec2{13, 4}.normalized()}, rounding));  // to (15, 6)
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 2, 0), IsNear(Vec2{Vec2{17, 2}.normalized()}, rounding));  // to (19, 4)
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 0, -2), IsNear(Vec2{Vec2{1, -6}.normalized()}, rounding)); // to (3, -4)
}

//> A table elsewhere
TEST_CASE("it does not matter where the table is", "[6.6]") {
    const Vec2 by{-20, 7};
    const Ball moved{cue.position + by, {0, 0}, 1};
    CHECK_THAT(bank_shot(moved, Vec2{3, 4} + by, {table.low + by, table.high + by}, 1, 0),
               IsNear(Vec2{Vec2{13, 2}.normalized()}, rounding));
    CHECK_THAT(bank_shot(moved, Vec2{3, 4} + by, {table.low + by, table.high + by}, -3, 2),
               IsNear(bank_shot(cue, {3, 4}, table, -3, 2), 1e-11));
}

//> It gets there
TEST_CASE("a ball that rolls from cushion to cushion gets to the target, over up to five each way", "[6.6]") {
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        const Box box{{dice.real(-5, 0), dice.real(-5, 0)}, {dice.real(4, 9), dice.real(4, 9)}};
        const double radius = dice.real(0, 1);
        const auto somewhere = [&] {
            return Vec2{dice.real(box.low.x() + radius, box.high.x() - radius),
                        dice.real(box.low.y() + radius, box.high.y() - radius)};
        };
        const Ball ball{somewhere(), {0, 0}, radius};
        const Vec2 target = somewhere();
        const int across = dice.whole(-5, 5), up = dice.whole(-5, 5);
        const Vec2 room = box.high - box.low - Vec2{2 * radius, 2 * radius};

        const Vec2 to = bank_shot(ball, target, box, across, up);

        CHECK_THAT(to.norm(), IsNear(1.0, rounding).of("length of the direction"));
        const double x = across % 2 == 0 ? target.x() : box.low.x() + box.high.x() - target.x();
        const double y = up % 2 == 0 ? target.y() : box.low.y() + box.high.y() - target.y();
        const Vec2 way = Vec2{x + across * room.x(), y + up * room.y()} - ball.position;
        const double missed = (rolled({ball.position, to, radius}, box, way.norm()).position - target).norm();
        CHECK_THAT(missed, IsAtMost(1e-9).of("distance from the target [m]"));
    }
}

//>
TEST_CASE(
    "over a hundred tables, from the edge, on tables of any size, to images close by, whatever the ball's velocity",
    "[6.6]") {
    CHECK_THAT(bank_shot(cue, {3, 4}, table, 100, 0), IsNear(Vec2{Vec2{801, 2}.normalized()}, rounding));
    CHECK_THAT(bank_shot(cue, {3, 4}, table, -100, -100), IsNear(Vec2{Vec2{-799, -398}.normalized()}, rounding));
    CHECK_THAT(bank_shot(cue, {2, 2}, table, 1, 0), IsNear(Vec2{1, 0}, rounding)); // back to where it was
    CHECK_THAT(bank_shot(cue, {3, 4}, table, -99, 100), IsNear(Vec2{Vec2{-787, 402}.normalized()}, rounding));
    CHECK_THAT(bank_shot({{1, 1}, {7, -3}, 1}, {9, 5}, table, 1, 0), IsNear(Vec2{Vec2{8, 4}.normalized()}, rounding));
    CHECK_THAT(bank_shot({{2, 2}, {0, 0}, 0}, {3, 4}, table, 1, 0), IsNear(Vec2{Vec2{15, 2}.normalized()}, rounding));
    const Box large{{-1e5, -1e5}, {1e5, 1e5}};
    CHECK_THAT(bank_shot({{0, 0}, {0, 0}, 0}, {5e4, 5e4}, large, 1, 0), IsNear(Vec2{Vec2{3, 1}.normalized()}, 1e-7));
    CHECK_THAT(bank_shot({{0, 0}, {0, 0}, 0}, {5e4, 5e4}, large, 100, 0),
               IsNear(Vec2{Vec2{401, 1}.normalized()}, 1e-7));
    CHECK_THAT(bank_shot({{1e5, -1e5}, {1e5, -1e5}, 0}, {-1e5, 1e5}, large, 0, 0),
               IsNear(Vec2{Vec2{-1, 1}.normalized()}, 1e-7));
    CHECK_THAT(bank_shot({{1, 2}, {0, 0}, 1}, {1, 4}, {{0, 0}, {2 + 1e-10, 6}}, 0, 1), IsNear(Vec2{0, 1}, 1e-11));
    CHECK_THAT(bank_shot({{1, 2}, {0, 0}, 1e-9}, {1, 4}, table, 0, 0), IsNear(Vec2{0, 1}, 1e-11));
    CHECK_THAT(bank_shot(cue, {2 + 1e-9, 4}, table, 0, 0), IsNear(Vec2{5e-10, 1}, 1e-11));
    for (const double distance : {0.5, 1e-2, 1e-6, 1e-10})
        CHECK_THAT(bank_shot(cue, cue.position + distance * at_angle(0.9), table, 0, 0),
                   IsNear(at_angle(0.9), 1e-11 / distance));
}

TEST_CASE("a place too close to a side, the image itself, more than 100 tables, or a bad ball or box, is refused",
          "[6.6]") {
    const double close = 1 - 1e-8; // to a side, for a ball of radius 1 m
    for (const Vec2 &place : {Vec2{close, 2}, Vec2{10 - close, 2}, Vec2{2, close}, Vec2{2, 6 - close}}) {
        CHECK_REFUSED(bank_shot({place, {0, 0}, 1}, {3, 4}, table, 1, 0));
        CHECK_REFUSED(bank_shot(cue, place, table, 1, 0));
    }
    CHECK_REFUSED(bank_shot(cue, {2, 2}, table, 0, 0), "a target where the ball is");
    CHECK_REFUSED(bank_shot({{9, 2}, {0, 0}, 1}, {9, 2}, table, 1, 0), "an image where the ball is");
    for (const int far : {std::numeric_limits<int>::min(), -101, 101, std::numeric_limits<int>::max()}) {
        CHECK_REFUSED(bank_shot(cue, {3, 4}, table, far, 0));
        CHECK_REFUSED(bank_shot(cue, {3, 4}, table, 0, far));
    }
    CHECK_REFUSED(bank_shot({{2, 2}, {0, 0}, -1}, {3, 4}, table, 1, 0));
    CHECK_REFUSED(bank_shot({{2, 2}, {0, 0}, -1e-9}, {3, 4}, table, 1, 0));
    CHECK_REFUSED(bank_shot({{3, 3}, {0, 0}, 3}, {3, 3}, table, 1, 0), "a ball as large as the table");
    CHECK_REFUSED(bank_shot({{3, 3}, {0, 0}, 3}, {3, 5}, {{0, 0}, {6, 10}}, 0, 1), "a ball as wide as the table");
    bank_shot(cue, {3, 4}, table, 1, 0); // good input is still answered
}

// ---------------------------------------------------------------------------------------------------- 6.7 play_pinball

namespace {

using reflection::Bumper, reflection::Pinball;

constexpr Surface ice{1, 0}; // smooth and elastic
const Vec2 level{0, 0};

/// A strip of rubber, or a round bumper.
Bumper strip(const Vec2 &start, const Vec2 &end, double radius, const Surface &surface) {
    return {start, end, radius, surface, 0, 10, false};
}
Bumper round(const Vec2 &centre, double radius, const Surface &surface, int points = 100) {
    return {centre, centre, radius, surface, 0, points, false};
}
Bumper flipper(const Vec2 &pivot, const Vec2 &tip, double turning, const Surface &surface) {
    return {pivot, tip, 0.25, surface, turning, 0, false};
}

/// What comes out for the ball.
Ball ball_after(const Ball &ball, const Bumper &bumper, double dt) {
    return play_pinball({ball, {bumper}, 0, false}, level, dt).ball;
}

/// Moved and turned, or in a mirror.
template <class Map> Pinball mapped(Pinball game, const Map &place, double mirror) {
    const Vec2 origin = place({0, 0});
    game.ball.position = place(game.ball.position);
    game.ball.velocity = place(game.ball.velocity) - origin;
    for (Bumper &bumper : game.bumpers) {
        bumper.start = place(bumper.start);
        bumper.end = place(bumper.end);
        bumper.turning *= mirror;
    }
    return game;
}

/// A hit at a point of a bumper's middle line that's known: the ball comes from outside, along any velocity.
struct Hit {
    Bumper bumper;
    Vec2 middle, normal;
    double depth; ///< between their edges [m]
    Ball before;  ///< a frame before it overlaps
};
Hit random_hit(Dice &dice, double dt) {
    Hit hit;
    hit.middle = dice.point(20, 30);
    const Vec2 along = dice.direction();
    const double length = dice.real(1, 5), share = dice.real(0, 1), radius = dice.real(0.3, 1);
    hit.bumper = strip(hit.middle - share * length * along, hit.middle + (1 - share) * length * along, radius,
                       {dice.real(0, 1.5), dice.real(0, 0.5)});
    hit.normal = dice.sign() * quarter_turned(along);
    const int where = dice.whole(0, 3); // along it, at one of its ends, or round
    if (where == 1) hit.bumper.start = hit.middle;
    if (where == 2) hit.bumper.end = hit.middle;
    if (where == 3) hit.bumper.start = hit.bumper.end = hit.middle;
    if (where == 3) hit.normal = dice.direction();
    if (where == 1 || where == 2) {
        const Vec2 away = where == 1 ? along : Vec2{-along}; // the way the strip goes from there
        const double aside = dice.real(0.1, 1);
        hit.normal = (hit.normal * aside - away).normalized();
    }
    hit.depth = dice.real(0.01, 0.25);
    hit.before.radius = dice.real(0.1, 0.5);
    const double apart = hit.before.radius + radius - hit.depth;
    hit.before.velocity = dice.point(-9, 9);
    hit.before.position = hit.middle + apart * hit.normal - dt * hit.before.velocity;
    return hit;
}

/// A table 10 m wide and 16 m high, closed, with round bumpers on it.
Pinball closed_table(Dice &dice, const Surface &surface) {
    Pinball game{{dice.point(2, 4), dice.point(-9, 9), 0.3}, {}, 0, false};
    const Vec2 corners[]{{0, 1}, {10, 1}, {10, 17}, {0, 17}};
    for (int i = 0; i < 4; ++i) game.bumpers.push_back(strip(corners[i], corners[(i + 1) % 4], 0.2, surface));
    for (const Vec2 &centre : {Vec2{3, 8}, Vec2{7, 8}, Vec2{5, 12}}) game.bumpers.push_back(round(centre, 1, surface));
    return game;
}

} // namespace

//> Worked example: nothing in the way
TEST_CASE("rolls on where nothing is: first faster by the pull, and then along at its new velocity", "[6.7]") {
    const Pinball now{{{4, 5}, {3, 0}, 0.5}, {round({4, 2}, 1, ice)}, 300, false};
    const Pinball after = play_pinball(now, {0, -2}, 0.5);
    CHECK_THAT(after, IsNear(Pinball{{{5.5, 4.5}, {3, -1}, 0.5}, now.bumpers, 300, false}, rounding)
                          .since("its velocity changes by 0.5 · (0, -2), and 0.5 · (3, -1) is its way"));
}

//> Worked example: a round bumper
TEST_CASE("hits a round bumper at 4 m/s with restitution 1.5: leaves at 6 m/s from its edge, and scores 100", "[6.7]") {
    Pinball now{{{4, 4}, {0, -4}, 0.5}, {round({4, 2}, 1, {1.5, 0})}, 0, false};
    const Pinball after = play_pinball(now, level, 0.25);
    now.bumpers[0].touched = true;
    CHECK_THAT(after, IsNear(Pinball{{{4, 3.5}, {0, 6}, 0.5}, now.bumpers, 100, false}, rounding)
                          .since("it would be at (4, 3), 0.5 m too close: its centre belongs 1.5 m above (4, 2)"));
}

//> From the side
TEST_CASE("a round bumper's normal points from its centre to the ball's", "[6.7]") {
    CHECK_THAT(ball_after({{7.2, 7.85}, {0, -5}, 0.5}, round({6, 5}, 2, {0.5, 0}), 0.25),
               IsNear(Ball{{7.5, 7}, {3.6, -0.2}, 0.5}, rounding)
                   .of("ball")
                   .since("the normal is (0.6, 0.8): 4 m/s into it become 2 m/s out of it"));
    CHECK_THAT(ball_after({{4.8, 2.15}, {0, 5}, 0.5}, round({6, 5}, 2, {0.5, 0.3}), 0.25),
               IsNear(Ball{{4.5, 3}, {-2.16, -0.88}, 0.5}, rounding).of("ball")); // from below, and rough
}

//> A strip
TEST_CASE("hits a slanted strip on either side of it, in its middle", "[6.7]") {
    const Bumper slope = strip({2, 1}, {6, 4}, 0.25, ice);
    CHECK_THAT(ball_after({{3.7, 3.9}, {0, -5}, 0.5}, slope, 0.2),
               IsNear(Ball{{3.55, 3.1}, {-4.8, 1.4}, 0.5}, rounding).of("ball").since("the nearest point is (4, 2.5)"));
    CHECK_THAT(ball_after({{4.3, 1.1}, {0, 5}, 0.5}, slope, 0.2),
               IsNear(Ball{{4.45, 1.9}, {4.8, -1.4}, 0.5}, rounding).of("ball").since("the nearest point is (4, 2.5)"));
}

//> Its ends
TEST_CASE("a strip's ends are round, and beyond them it isn't there", "[6.7]") {
    const Bumper shelf = strip({2, 4}, {6, 4}, 0.25, ice);
    CHECK_THAT(
        ball_after({{6.3, 5.4}, {0, -5}, 0.5}, shelf, 0.2),
        IsNear(Ball{{6.45, 4.6}, {4.8, 1.4}, 0.5}, rounding).of("ball").since("the nearest point is its end, (6, 4)"));
    CHECK_THAT(ball_after({{1.7, 5.4}, {0, -5}, 0.5}, shelf, 0.2),
               IsNear(Ball{{1.55, 4.6}, {-4.8, 1.4}, 0.5}, rounding)
                   .of("ball")
                   .since("the nearest point is its start, (2, 4)"));
    CHECK_THAT(ball_after({{7, 5}, {0, -5}, 0.5}, shelf, 0.2), IsNear(Ball{{7, 4}, {0, -5}, 0.5}, rounding).of("ball"));
    CHECK_THAT(ball_after({{1, 5}, {0, -5}, 0.5}, shelf, 0.2), IsNear(Ball{{1, 4}, {0, -5}, 0.5}, rounding).of("ball"));
}

//> Once
TEST_CASE("a ball that lies on a bumper for a second scores once", "[6.7]") {
    Pinball game{{{4, 3.6}, {0, 0}, 0.5}, {round({4, 2}, 1, {0, 0})}, 0, false};
    for (int frame = 0; frame < 60; ++frame) game = play_pinball(game, {0, -6}, 1.0 / 60);
    CHECK_THAT(double(game.score), IsNear(100.0).of("score after a second"));
    CHECK_THAT(game.ball.position, IsNear(Vec2{4, 3.5}, rounding).of("place of the ball after a second [m]"));
}

TEST_CASE("each new touch scores: two falls onto the same bumper are worth 200", "[6.7]") {
    Pinball game{{{4, 4}, {0, -4}, 0.5}, {round({4, 2}, 1, ice)}, 0, false};
    game = play_pinball(game, level, 0.25); // it touches
    game = play_pinball(game, level, 0.25); // it's 1 m away
    CHECK_THAT(game.bumpers.at(0).touched, IsNear(false).of("touched, once it's gone"));
    CHECK_THAT(double(game.score), IsNear(100.0).of("score, once it's gone"));
    game.ball.velocity = {0, -4};
    game = play_pinball(play_pinball(game, level, 0.25), level, 0.125);
    CHECK_THAT(double(game.score), IsNear(200.0).of("score after the second fall"));
}

TEST_CASE("a ball that moves away scores, too, and is set back, but keeps its velocity", "[6.7]") {
    const Pinball after = play_pinball({{{4, 2.5}, {0, 2}, 0.5}, {round({4, 2}, 1, ice)}, 0, false}, level, 0.25);
    CHECK_THAT(after.ball, IsNear(Ball{{4, 3.5}, {0, 2}, 0.5}, rounding).of("ball"));
    CHECK_THAT(double(after.score), IsNear(100.0).of("score"));
}

//> A flipper
TEST_CASE("a flipper that turns at 5 rad/s throws a ball that lies there, 1 m from its pivot, at 7.5 m/s", "[6.7]") {
    const Ball lies{{3, 2.4}, {0, 0}, 0.25};
    CHECK_THAT(ball_after(lies, flipper({2, 2}, {4, 2}, 5, {0.5, 0}), 0.1),
               IsNear(Ball{{3, 2.5}, {0, 7.5}, 0.25}, rounding)
                   .of("ball")
                   .since("its edge at (3, 2.25) moves at (-1.25, 5) m/s; from there, the ball comes at (1.25, -5)"));
    CHECK_THAT(ball_after(lies, flipper({2, 2}, {4, 2}, 5, {0.5, 0.2}), 0.1),
               IsNear(Ball{{3, 2.5}, {-1.25, 7.5}, 0.25}, rounding).of("ball")); // rough: it drags the ball along
    CHECK_THAT(ball_after(lies, flipper({2, 2}, {4, 2}, -5, {0.5, 0.2}), 0.1),
               IsNear(Ball{{3, 2.5}, {0, 0}, 0.25}, rounding).of("ball")); // on its way down, its edge moves away
}

TEST_CASE("the farther from its pivot, the faster a flipper throws; it turns about its start", "[6.7]") {
    for (const double arm : {0.5, 1.0, 1.5})
        CHECK_THAT(ball_after({{2 + arm, 2.4}, {0, 0}, 0.25}, flipper({2, 2}, {4, 2}, 4, {0, 0}), 0.1).velocity,
                   IsNear(Vec2{0, 4 * arm}, rounding).of("velocity " + std::to_string(arm) + " m from the pivot"));
    CHECK_THAT(ball_after({{3, 2.4}, {0, 0}, 0.25}, flipper({4, 2}, {2, 2}, -4, {0, 0}), 0.1).velocity,
               IsNear(Vec2{0, 4}, rounding).of("velocity at a flipper on the right"));
}

TEST_CASE("a rough round bumper that spins drags the ball along", "[6.7]") {
    Bumper spinner = round({6, 5}, 1, {0.5, 0.5});
    spinner.turning = 4;
    CHECK_THAT(ball_after({{6, 6.4}, {0, -2}, 0.5}, spinner, 0.1),
               IsNear(Ball{{6, 6.5}, {-1.5, 1}, 0.5}, rounding)
                   .of("ball")
                   .since("its edge moves at (-4, 0) m/s; seen from there, 4 m/s along it lose 0.5 · (2 + 1)"));
}

//> One after the other
TEST_CASE("bumpers have their turns in the order of the list, and each sees what the one before has done", "[6.7]") {
    const Bumper floor = strip({0, 2}, {8, 2}, 0.25, {0, 0}), low = round({4.65, 2.2}, 0.25, ice);
    const Ball ball{{4, 2.3}, {0, 0}, 0.5};
    const Pinball first = play_pinball({ball, {floor, low}, 0, false}, level, 0);
    CHECK_THAT(first.bumpers.at(1).touched, IsNear(false).of("touched, after the floor has set the ball back"));
    CHECK_THAT(double(first.score), IsNear(10.0).of("score with the floor first"));
    const Pinball last = play_pinball({ball, {low, floor}, 0, false}, level, 0);
    CHECK_THAT(double(last.score), IsNear(110.0).of("score with the floor last"));
}

TEST_CASE("in a corner it bounces off both walls in the same frame", "[6.7]") {
    const Pinball now{{{1.5, 1.5}, {-4, -3}, 0.5},
                      {strip({0, 0.5}, {8, 0.5}, 0.25, ice), strip({0.5, 0}, {0.5, 8}, 0.25, ice)},
                      0,
                      false};
    const Pinball after = play_pinball(now, level, 0.2);
    CHECK_THAT(after.ball, IsNear(Ball{{1.25, 1.25}, {4, 3}, 0.5}, rounding).of("ball"));
    CHECK_THAT(double(after.score), IsNear(20.0).of("score"));
}

//> Lost
TEST_CASE("the ball is lost once its centre is below y = 0, and then nothing changes any more", "[6.7]") {
    const Pinball now{{{4, 1}, {0, -1}, 0.5}, {round({4, 9}, 1, ice)}, 700, false};
    CHECK_THAT(play_pinball(now, level, 0.9).over, IsNear(false).of("over at y = 0.1 m"));
    CHECK_THAT(play_pinball(now, level, 1).over, IsNear(false).of("over at y = 0"));
    const Pinball lost = play_pinball(now, level, 1.5);
    CHECK_THAT(lost, IsNear(Pinball{{{4, -0.5}, {0, -1}, 0.5}, now.bumpers, 700, true}, rounding));
    CHECK_THAT(play_pinball(lost, {0, -6}, 0.5), IsNear(lost));
    Pinball on_it{{{4, 9.5}, {0, -1}, 0.5}, {round({4, 9}, 1, ice)}, 700, true};
    CHECK_THAT(play_pinball(on_it, {0, -6}, 0.5), IsNear(on_it));
}

TEST_CASE("a bumper that sets the ball back above y = 0 saves it", "[6.7]") {
    const Pinball after =
        play_pinball({{{4, 0.5}, {0, -3}, 0.5}, {round({4, -1}, 1, {0.5, 0})}, 0, false}, level, 0.25);
    CHECK_THAT(after.over, IsNear(false).of("over"));
    CHECK_THAT(after.ball, IsNear(Ball{{4, 0.5}, {0, 1.5}, 0.5}, rounding).of("ball"));
}

//> Every hit
TEST_CASE("at every point of a bumper, the parts of the velocity are what 6.4 says, and the edges only just touch",
          "[6.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        const double dt = dice.real(0, 0.1);
        const Hit hit = random_hit(dice, dt);

        const Ball after = ball_after(hit.before, hit.bumper, dt);

        const Vec2 along = quarter_turned(hit.normal), before = hit.before.velocity;
        const double towards = -before.dot(hit.normal), slides = before.dot(along);
        const double impulse = towards > 0 ? (1 + hit.bumper.surface.restitution) * towards : 0; // for each kg [m/s]
        const double left = std::max(0.0, std::abs(slides) - hit.bumper.surface.mu_k * impulse);
        CHECK_THAT(after.velocity.dot(hit.normal), IsNear(impulse - towards, 1e-9).of("normal speed [m/s]"));
        CHECK_THAT(after.velocity.dot(along), IsNear(std::copysign(left, slides), 1e-9).of("speed along it [m/s]"));
        CHECK_THAT(after.position - hit.middle,
                   IsNear(Vec2{(after.radius + hit.bumper.radius) * hit.normal}, 1e-9).of("from the middle line [m]"));
    }
}

//> No touch
TEST_CASE("a bumper that the ball's edge doesn't get to does nothing, however long it is", "[6.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        Hit hit = random_hit(dice, 0);
        hit.before.position += (hit.depth + dice.real(1e-6, 0.3)) * hit.normal;

        const Pinball after = play_pinball({hit.before, {hit.bumper}, 5, false}, level, 0);

        CHECK_THAT(after, IsNear(Pinball{hit.before, {hit.bumper}, 5, false}, rounding));
    }
}

//> Flippers at every angle
TEST_CASE("seen from the edge of a bumper that turns, the ball leaves as 6.4 says, at every angle", "[6.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(5000); ++i) {
        Hit hit = random_hit(dice, 0);
        hit.bumper.turning = dice.real(-6, 6);

        const Ball after = ball_after(hit.before, hit.bumper, 0);

        const Vec2 arm = hit.middle + hit.bumper.radius * hit.normal - hit.bumper.start;
        const Vec2 edge = hit.bumper.turning * quarter_turned(arm); // its velocity [m/s]
        const double towards = -(hit.before.velocity - edge).dot(hit.normal);
        const double out = towards > 0 ? hit.bumper.surface.restitution * towards : -towards;
        CHECK_THAT((after.velocity - edge).dot(hit.normal), IsNear(out, 1e-9).of("normal speed from the edge [m/s]"));
    }
}

//> The sum of all touches
TEST_CASE("in five seconds of play the score is what all new touches are worth, and nothing is entered", "[6.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(200); ++i) {
        Pinball game = closed_table(dice, {dice.real(0.3, 1), dice.real(0, 0.3)});
        int worth = 0;
        for (int frame = 0; frame < 600; ++frame) {
            const Pinball before = game;
            game = play_pinball(game, {0, -4}, 1.0 / 120);
            for (std::size_t each = 0; each < before.bumpers.size(); ++each)
                if (game.bumpers.at(each).touched && !before.bumpers[each].touched)
                    worth += before.bumpers[each].points;
            const Vec2 &at = game.ball.position;
            CHECK_THAT(at.x(), IsAtLeast(0.4).of("x of the ball [m]"));
            CHECK_THAT(at.x(), IsAtMost(9.6).of("x of the ball [m]"));
            CHECK_THAT(at.y(), IsAtLeast(1.4).of("y of the ball [m]"));
        }
        CHECK_THAT(double(game.score), IsNear(double(worth)).of("score after 5 s"));
    }
}

//> Speed
TEST_CASE("on a level table of smooth, elastic bumpers the ball's speed stays for five seconds", "[6.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(200); ++i) {
        Pinball game = closed_table(dice, ice);
        const double speed = game.ball.velocity.norm();
        for (int frame = 0; frame < 600; ++frame) game = play_pinball(game, level, 1.0 / 120);
        CHECK_THAT(game.ball.velocity.norm(), IsNear(speed, 1e-9).of("speed after 5 s [m/s]"));
        CHECK_THAT(game.over, IsNear(false).of("over"));
    }
}

//> Moved, turned, mirrored
TEST_CASE("moved, turned or in a mirror, it's the same game", "[6.7]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double dt = dice.real(0, 0.1), turn = dice.real(-3, 3);
        const Hit hit = random_hit(dice, dt);
        Pinball game{hit.before, {hit.bumper, round({200, 200}, 1, ice)}, 0, false};
        game.bumpers[0].turning = dice.real(-3, 3);
        const Vec2 pull = dice.point(-1, 1), by = dice.point(100, 150);
        const double c = std::cos(turn), s = std::sin(turn);
        const auto moved = [&](const Vec2 &v) { return Vec2{by + Vec2{c * v.x() - s * v.y(), s * v.x() + c * v.y()}}; };
        const auto mirrored = [](const Vec2 &v) { return Vec2{-v.x(), v.y()}; };

        const Pinball after = play_pinball(game, pull, dt);

        CHECK_THAT(play_pinball(mapped(game, moved, 1), moved(pull) - by, dt), IsNear(mapped(after, moved, 1), 1e-8));
        CHECK_THAT(play_pinball(mapped(game, mirrored, -1), mirrored(pull), dt),
                   IsNear(mapped(after, mirrored, -1), 1e-9));
    }
}

//>
TEST_CASE("play_pinball allows no bumpers, places and speeds up to 1e5, and a ball of no size", "[6.7]") {
    CHECK_THAT(play_pinball({{{1, 2}, {3, 4}, 0.5}, {}, 9, false}, {1, -1}, 1),
               IsNear(Pinball{{{5, 5}, {4, 3}, 0.5}, {}, 9, false}, rounding));
    CHECK_THAT(ball_after({{4, 4}, {0, -4}, 0}, round({4, 2}, 1, ice), 0.375),
               IsNear(Ball{{4, 3}, {0, 4}, 0}, rounding).of("ball"));
    CHECK_THAT(ball_after({{4, 3.25}, {0, -4}, 0.5}, round({4, 2}, 0, ice), 0.25),
               IsNear(Ball{{4, 2.5}, {0, 4}, 0.5}, rounding).of("ball")); // a nail
    CHECK_THAT(ball_after({{0, 1e5}, {0, -1e5}, 1e4}, strip({-1e5, 0}, {1e5, 0}, 1e4, ice), 0.875),
               IsNear(Ball{{0, 2e4}, {0, 1e5}, 1e4}, 1e-7).of("ball"));
}

TEST_CASE("a negative radius or time, or a surface that bounce refuses, is refused by play_pinball", "[6.7]") {
    const Ball ball{{4, 9}, {0, -1}, 0.5};
    const auto play = [&](const Bumper &bumper) { return play_pinball({ball, {bumper}, 0, false}, level, 0.1); };
    CHECK_REFUSED(play_pinball({{{4, 9}, {0, -1}, -0.5}, {}, 0, false}, level, 0.1), "a ball of -0.5 m");
    CHECK_REFUSED(play_pinball({ball, {}, 0, false}, level, -0.1), "dt = -0.1 s");
    CHECK_REFUSED(play_pinball({ball, {}, 0, true}, level, -0.1), "dt = -0.1 s, when the ball is lost");
    CHECK_REFUSED(play(round({4, 2}, -1, ice)), "a bumper of -1 m");
    CHECK_REFUSED(play(round({4, 2}, 1, {-0.5, 0})), "a restitution of -0.5, far away");
    CHECK_REFUSED(play(round({4, 2}, 1, {0.5, -1})), "a mu_k of -1, far away");
    play(round({4, 2}, 1, ice)); // good input is still answered
}
