#include "section_test.hpp"

#include "table_hockey.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using particles::Particle;
using segment_intersection::Segment;
using table_hockey::arm;
using table_hockey::cushions;
using table_hockey::Disc;
using table_hockey::disc_mass;
using table_hockey::disc_radius;
using table_hockey::felt;
using table_hockey::follow_hand;
using table_hockey::half_length;
using table_hockey::half_width;
using table_hockey::Inputs;
using table_hockey::mallet_radius;
using table_hockey::most_sparks;
using table_hockey::next_sparks;
using table_hockey::opening;
using table_hockey::Player;
using table_hockey::seen_from;
using table_hockey::serve_velocity;
using table_hockey::shoulder;
using table_hockey::step_time;
using table_hockey::well_softening;
using table_hockey::well_strength;
using table_hockey::World;
using namespace table_hockey::subject; // step: the student's

namespace {

// Two games that keep the contract may differ: in how exactly they find an impact, or by a step where hands and disc meet.
// So a test of a single event has a tolerance that's small beside the event, and a test of long play asks for laws.
constexpr double digits = 1e-9;
constexpr double about = 0.01; // of places [m] and speeds [m/s], of which a step at 1 m/s is half

Player placed(Player player, const Vec2 &place) {
    player.mallet = place;
    player.pose = inverse_kinematics::poses(arm, seen_from(player.side, place) - Vec2{shoulder, 0}).front();
    return player;
}

/// A world with these mallets. Half a step is spare, so that rounding never decides how many steps are due.
World with(const Disc &disc, const Vec2 &left, const Vec2 &right) {
    World now = opening();
    now.disc = disc;
    now.left = placed(now.left, left);
    now.right = placed(now.right, right);
    now.spare = step_time / 2;
    return now;
}
const Vec2 left_corner{-0.9, -0.4}, right_corner{0.9, -0.4}; // where a mallet is in nobody's way
World with(const Disc &disc) { return with(disc, left_corner, right_corner); }

/// Hands that stay where the mallets are.
Inputs still(const World &now) { return {now.left.mallet, now.right.mallet, false}; }

/// The world so many steps later, in frames of 48 steps or fewer.
World after(World now, const Inputs &inputs, int steps) {
    for (; steps > 0; steps -= 48) now = step(now, inputs, std::min(steps, 48) * step_time);
    return now;
}
World after(const World &now, int steps) { return after(now, still(now), steps); }

double speed(const World &now) { return now.disc.velocity.norm(); }
int goals(const World &now) { return now.left.goals + now.right.goals; }
const char *const place_of_disc = "place of the disc [m]", *const velocity_of_disc = "velocity of the disc [m/s]",
                  *const speed_of_disc = "speed of the disc [m/s]";

} // namespace

// ------------------------------------------------------------------------------------------------------- one at a time

//> Nothing is due
TEST_CASE("moves nothing in a frame that's shorter than a step, but keeps its time", "[13.1]") {
    World now = opening();
    now.disc = {{0.3, 0.2}, {1, 0}};
    const World later = step(now, {{-0.2, 0}, {0.2, 0}, true}, 0.004);
    CHECK_THAT(later.disc, IsNear(now.disc).of("disc"));
    CHECK_THAT(later.left.mallet, IsNear(now.left.mallet).of("left mallet [m]"));
    CHECK_THAT(later.spare, IsNear(0.004, digits).of("spare time [s]"));
    CHECK_THAT(step(now, {}, 0).spare, IsNear(0.0, digits).of("spare time [s]"));
}

//> A step is due
TEST_CASE("takes one step when 3 ms were spare and 2 ms come to them, and keeps what's left", "[13.1]") {
    World now = with({{0.3, 0.2}, {2.4, 0}});
    now.spare = 0.003;
    const World later = step(now, still(now), 0.002);
    CHECK_THAT(later.disc.place.x(), IsNear(0.31, 1e-3).of("x of the disc [m]")); // 2.4 m/s * 1/240 s
    CHECK_THAT(later.spare, IsNear(0.005 - step_time, digits).of("spare time [s]"));
}

//> A disc that rests
TEST_CASE("leaves a disc alone that rests beside the centre line", "[13.1]") {
    const World now = after(with({{0.3, 0.2}, {0, 0}}), 300);
    CHECK_THAT(now.disc, IsNear(Disc{{0.3, 0.2}, {0, 0}}, digits).of("disc"));
}

//> A disc that moves
TEST_CASE("moves a disc by its velocity: 0.2 m in 48 steps at 1 m/s, less what the felt takes", "[13.1]") {
    const World now = after(with({{0, 0.1}, {0.6, 0.8}}), 48);
    CHECK_THAT(now.disc.place, IsNear(Vec2{0.1188, 0.2584}, 1e-3).of(place_of_disc)); // 0.2 - 0.1 * 0.2² / 2
}

//> Felt
TEST_CASE("slows every disc down by 0.1 m/s in a second, however fast it is", "[13.1]") {
    for (const double fast : {1.0, 0.5}) {
        const World now = after(with({{0.1, 0.1}, {0.6 * fast, 0.8 * fast}}), 48); // 0.2 s
        const double slower = fast - 0.02;
        CHECK_THAT(now.disc.velocity, IsNear(Vec2{0.6 * slower, 0.8 * slower}, 1e-3).of(velocity_of_disc));
    }
}

//> Felt, at the end
TEST_CASE("stops a disc at 0.05 m/s after half a second, and doesn't send it back", "[13.1]") {
    const World now = after(with({{0.3, 0.1}, {0.05, 0}}), 124);
    CHECK_THAT(speed(now), IsNear(0.0).of(speed_of_disc)); // exactly: otherwise it's never served
    CHECK_THAT(now.disc.place, IsNear(Vec2{0.3125, 0.1}, 1e-3).of(place_of_disc));
}

//> A mallet walks
TEST_CASE("walks a mallet to the hand at 2.5 m/s: 0.25 m in 24 steps, and the rest later", "[13.1]") {
    World now = with({{0.3, 0.2}, {0, 0}}, {-0.7, 0}, {0.6, 0.4});
    const Inputs hands{{-0.3, 0}, {0.6, 0}, false};
    now = after(now, hands, 24);
    CHECK_THAT(now.left.mallet, IsNear(Vec2{-0.45, 0}, digits).of("left mallet [m]"));
    CHECK_THAT(now.left.velocity, IsNear(Vec2{2.5, 0}, digits).of("velocity of the left mallet [m/s]"));
    CHECK_THAT(now.right.mallet, IsNear(Vec2{0.6, 0.15}, digits).of("right mallet [m]"));
    now = after(now, hands, 24);
    CHECK_THAT(now.left.mallet, IsNear(Vec2{-0.3, 0}, digits).of("left mallet [m]"));
    CHECK_THAT(now.right.velocity, IsNear(Vec2{0, 0}, digits).of("velocity of the right mallet [m/s]"));
}

//> As follow_hand says
TEST_CASE("has both players, arm and all, where follow_hand puts them, when no disc is near", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        World now = with({{0, 0.47}, {0, 0}}, {-0.5, -0.1}, {0.5, -0.2});
        for (int turn = 0; turn < 20; ++turn) {
            Inputs hands{{dice.real(-1.5, 1.5), dice.real(-1, 0.2)}, {dice.real(-1.5, 1.5), dice.real(-1, 0.2)}, false};
            const int steps = dice.whole(1, 40);
            Player left = now.left, right = now.right;
            for (int s = 0; s < steps; ++s) {
                left = follow_hand(left, hands.left);
                right = follow_hand(right, hands.right);
            }
            now.disc = {{0, 0.47}, {0, 0}}; // it may have been served
            now = after(now, hands, steps);
            CHECK_THAT(now.left, IsNear(left, digits).of("left"));
            CHECK_THAT(now.right, IsNear(right, digits).of("right"));
        }
    }
}

// ---------------------------------------------------------------------------------------------------------- it bounces

//> A cushion
TEST_CASE("sends a disc that hits a cushion at 2 m/s back at 1.8 m/s, at each of the six", "[13.1]") {
    struct Shot {
        Vec2 place, way;
    };
    for (const auto &[place, way] : {Shot{{0.2, 0.4}, {0, 1}},
                                     {{-0.3, -0.4}, {0, -1}},
                                     {{0.9, 0.3}, {1, 0}},
                                     {{-0.9, 0.3}, {-1, 0}},
                                     {{0.9, -0.25}, {1, 0}},
                                     {{-0.9, -0.25}, {-1, 0}}}) {
        const World now = after(with({place, 2 * way}, {-0.5, 0}, {0.5, 0}), 12); // 0.1 m in all
        CHECK_THAT(now.disc.velocity, IsNear(Vec2{-1.8 * way}, about).of(velocity_of_disc));
    }
}

//> A cushion, at a slant
TEST_CASE("loses 0.19 m/s along a cushion that it hits at 2 m/s: mu (1 + 0.9) 2", "[13.1]") {
    const World now = after(with({{0, 0.4}, {3, 2}}), 12);
    CHECK_THAT(now.disc.velocity, IsNear(Vec2{2.81, -1.8}, about).of(velocity_of_disc));
}

//> What's left of the step
TEST_CASE("flies on after a bounce, in what's left of the step: no place is lost at 12 m/s", "[13.1]") {
    const World now = after(with({{0, 0.45}, {0, 12}}), 1); // 0.02 m up, 0.03 m left, and 0.9 of it down
    CHECK_THAT(now.disc.place, IsNear(Vec2{0, 0.443}, 1e-3).of(place_of_disc));
    const World corner = after(with({{0.95, 0.43}, {12, 12}}), 1); // two cushions in one step
    CHECK_THAT(corner.disc.place, IsNear(Vec2{0.9437, 0.4636}, 2e-3).of(place_of_disc));
    CHECK_THAT(corner.disc.velocity, IsNear(Vec2{-9.77, -9.77}, 0.05).of(velocity_of_disc)); // 0.9 (12 - 0.095 * 12)
}

//> Away from it
TEST_CASE("lets a disc go that touches a cushion or a mallet, and moves away from it", "[13.1]") {
    const World at_cushion = after(with({{0, 0.47}, {0.5, -1}}), 24);
    CHECK_THAT(at_cushion.disc.place, IsNear(Vec2{0.05, 0.37}, about).of(place_of_disc));
    const World at_mallet = after(with({{-0.42, 0}, {1, 0.5}}, {-0.5, 0}, right_corner), 24);
    CHECK_THAT(at_mallet.disc.place, IsNear(Vec2{-0.32, 0.05}, about).of(place_of_disc));
}

//> Along a cushion
TEST_CASE("glides along a cushion at 1 m/s, and isn't held there by a rounding", "[13.1]") {
    for (const double place : {0.47, std::nextafter(0.47, 1)}) // of two neighbours, one is inside by rounding
        for (const double x : {-0.1234567, 0.3, 0.8970785})
            for (const double up : {-5e-15, -1e-16, 0.0, 1e-16, 5e-15}) {
                const World now = after(with({{x, place}, {-1, up}}), 24);
                CHECK_THAT(now.disc.place, IsNear(Vec2{x - 0.0995, 0.47}, 1e-3).of(place_of_disc));
            }
}

//> A goal post
TEST_CASE("sends back a disc that hits a goal post head-on: 2 m/s becomes 1.8 m/s", "[13.1]") {
    for (const double side : {-1, 1})
        for (const double up : {-1, 1}) {
            const World now = after(with({{0.9 * side, 0.15 * up}, {2 * side, 0}}, {-0.5, -0.3}, {0.5, -0.3}), 16);
            CHECK_THAT(now.disc.velocity, IsNear(Vec2{-1.8 * side, 0}, about).of(velocity_of_disc));
        }
    const World aside = after(with({{0.9, 0.132}, {2, 0}}), 16); // 0.018 m of 0.03 off: a slope of 3, 4 and 5
    CHECK_THAT(aside.disc.place.x(), IsBelow(0.98).of("x of the disc [m]"));
    CHECK_THAT(aside.disc.velocity, IsNear(Vec2{-0.52, -1.7}, 0.05).of(velocity_of_disc));
}

//> A resting mallet
TEST_CASE("gives a disc at 2 m/s back 1.6 m/s at a mallet that rests", "[13.1]") {
    for (const double side : {-1, 1}) {
        const World now = after(with({{0.35 * side, 0}, {2 * side, 0}}, {-0.5, 0}, {0.5, 0}), 16);
        CHECK_THAT(now.disc.velocity, IsNear(Vec2{-1.6 * side, 0}, about).of(velocity_of_disc));
    }
}

//> A resting mallet, beside its middle
TEST_CASE("changes only a disc's speed towards a mallet's middle, and nothing along its rim", "[13.1]") {
    const double off = (disc_radius + mallet_radius) * std::sqrt(0.5); // it's hit at 45°
    const World now = after(with({{0.3, off}, {2, 0}}, left_corner, {0.5, 0}), 24);
    CHECK_THAT(now.disc.velocity,
               IsNear(Vec2{0.2, 1.8}, 0.05).of(velocity_of_disc)); // 2 - 1.8 * 2 / 2, and 1.8 * 2 / 2
}

//> A mallet hits
TEST_CASE("sends a resting disc off at 4.5 m/s when a mallet hits it at 2.5 m/s", "[13.1]") {
    World now = with({{-0.3, 0}, {0, 0}}, {-0.7, 0}, right_corner);
    now = after(now, {{-0.1, 0}, right_corner, false}, 40);
    CHECK_THAT(now.disc.velocity, IsNear(Vec2{4.5, 0}, 2 * about).of(velocity_of_disc));      // (1 + 0.8) * 2.5
    CHECK_THAT(now.left.mallet, IsNear(Vec2{-0.7 + 2.5 / 6, 0}, 1e-6).of("left mallet [m]")); // it isn't slowed down
    World other = with({{0.3, 0}, {0, 0}}, left_corner, {0.7, 0});
    other = after(other, {left_corner, {0.1, 0}, false}, 40);
    CHECK_THAT(other.disc.velocity, IsNear(Vec2{-4.5, 0}, 2 * about).of(velocity_of_disc));
}

//> A mallet gives way
TEST_CASE("lets a disc at 4 m/s follow at 1.3 m/s when it hits a mallet that backs away at 2.5 m/s", "[13.1]") {
    World now = with({{-0.05, 0}, {-4, 0}}, {-0.2, 0}, right_corner);
    now = after(now, {{-0.95, 0}, right_corner, false}, 24);
    CHECK_THAT(now.disc.velocity, IsNear(Vec2{-1.3, 0}, 2 * about).of(velocity_of_disc)); // -4 + 1.8 * (4 - 2.5)
}

// ------------------------------------------------------------------------------------------------------ goals and serves

//> A goal
TEST_CASE("gives a goal to the player at the other end, and puts the disc in the middle", "[13.1]") {
    for (const int side : {-1, 1}) {
        const World now = after(with({{0.9 * side, 0.05}, {6.0 * side, 0}}), 12);
        CHECK_THAT(now.left.goals, IsNear(side == 1 ? 1 : 0).of("goals of the left player"));
        CHECK_THAT(now.right.goals, IsNear(side == 1 ? 0 : 1).of("goals of the right player"));
        CHECK_THAT(now.disc, IsNear(Disc{}, digits).of("disc"));
        CHECK_THAT(now.serve_to, IsNear(side).of("side that gets the serve"));
    }
    const World close = after(with({{0.9, 0}, {2, 0}}), 10); // 0.083 m: its centre isn't there yet
    CHECK_THAT(goals(close), IsNear(0).of("goals"));
    CHECK_THAT(goals(after(close, 5)), IsNear(1).of("goals")); // 0.125 m
}

//> Once
TEST_CASE("counts a goal once, however long it's ago, and however many steps are in a frame", "[13.1]") {
    World now = after(with({{-0.9, 0.05}, {-6, 0}}), 12);
    for (int i = 0; i < 4; ++i) {
        CHECK_THAT(now.left.goals, IsNear(0).of("goals of the left player"));
        CHECK_THAT(now.right.goals, IsNear(1).of("goals of the right player"));
        now = after(now, 48);
    }
    World two = with({{-0.9, 0.05}, {-6, 0}});
    two.left.goals = 3;
    two.right.goals = 5;
    two = after(two, 60);
    CHECK_THAT(two.left.goals, IsNear(3).of("goals of the left player"));
    CHECK_THAT(two.right.goals, IsNear(6).of("goals of the right player"));
}

namespace {

/// Steps until a disc that rests moves, or 300. It leaves the world after the step.
int steps_until_served(World &now) {
    int steps = 0;
    while (speed(now) == 0 && steps < 300) {
        now = after(now, 1);
        ++steps;
    }
    return steps;
}
auto is_a_second(double steps) { return IsNear(steps, 3 / steps).of("steps until the serve"); } // three too many or few

} // namespace

//> Served
TEST_CASE("serves a disc after a second in the middle, to the player whose turn it is", "[13.1]") {
    for (const int side : {-1, 1})
        for (const int score : {0, 1, 2}) {
            World now = with({});
            now.serve_to = side;
            now.left.goals = score;
            now.right.goals = 1;
            CHECK_THAT(double(steps_until_served(now)), is_a_second(240));
            CHECK_THAT(now.disc.velocity.x() * side, IsAbove(0.4).of("velocity to the player who's served [m/s]"));
            CHECK_THAT(now.disc.velocity, IsNear(serve_velocity(now), 1e-3).of(velocity_of_disc));
        }
}

//> Where discs are served
TEST_CASE("serves no disc that rests 2 cm from the centre line, but one that's 9 mm off", "[13.1]") {
    for (const double x : {-0.02, 0.02}) {
        const World beside = after(with({{x, 0.3}, {0, 0}}), 480);
        CHECK_THAT(beside.disc, IsNear(Disc{{x, 0.3}, {0, 0}}, digits).of("disc"));
    }
    World on_it = with({{-0.009, 0.3}, {0, 0}});
    CHECK_THAT(double(steps_until_served(on_it)), is_a_second(240));
    CHECK_THAT(on_it.disc.place, IsNear(Vec2{-0.009, 0.3}, about).of(place_of_disc)); // from where it rests
}

//> Not yet
TEST_CASE("serves no disc that still moves along the centre line, until it has rested for a second", "[13.1]") {
    const World fast = after(with({{0, 0}, {0, 0.2}}), 264);
    CHECK_THAT(fast.disc.place.y(), IsNear(0.1595, about).of("y of the disc [m]"));
    World slow = after(with({{0, 0}, {0, 0.04}}), 108); // it stops after 96 steps
    CHECK_THAT(speed(slow), IsNear(0.0).of(speed_of_disc));
    CHECK_THAT(double(12 + steps_until_served(slow)), is_a_second(240));
}

//> Waiting again
TEST_CASE("waits a whole second after a goal, also when half of one had passed before", "[13.1]") {
    World now = after(with({}), 120);
    now.disc = {{0.9, 0}, {6, 0}}; // somebody hits it
    now = after(now, 12);
    CHECK_THAT(goals(now), IsNear(1).of("goals"));
    CHECK_THAT(double(8 + steps_until_served(now)), is_a_second(240)); // it's in the goal after 4 steps of 12
    now.disc = {{-0.9, 0}, {-6, 0}};
    now = after(now, 12);
    CHECK_THAT(goals(now), IsNear(2).of("goals"));
    CHECK_THAT(double(8 + steps_until_served(now)), is_a_second(240));
    CHECK_THAT(now.disc.velocity.x(), IsBelow(0).of("velocity of the disc along x [m/s]"));
}

// -------------------------------------------------------------------------------------------------- sparks and the well

//> Hard and soft
TEST_CASE("makes 8 sparks round the disc when it's hit hard, and none when it's hit softly", "[13.1]") {
    const World hard_one = after(with({{0, 0.46}, {0, 4}}), 1);
    CHECK_THAT(hard_one.sparks, HasSize(8).of("sparks"));
    for (const Particle &spark : hard_one.sparks)
        CHECK_THAT((spark.position - Vec2(half_length, half_width)).eval(),
                   IsNear(hard_one.disc.place, digits).of("place of a spark, from the middle [m]"));
    CHECK_THAT(after(with({{0, 0.4695}, {0, 0.25}}), 1).sparks, HasSize(0).of("sparks")); // 0.25 and 0.225 m/s
    World scored = with({{0.95, 0}, {20, 0}});
    scored.sparks = {{{1, 0.5}, {0, 0}, 0, 1}};
    CHECK_THAT(after(scored, 3).sparks, HasSize(1).of("sparks in a goal")); // the one that flew before
}

//> Short lives
TEST_CASE("shows sparks for 0.4 s, flying apart at 0.6 m/s, and none after half a second", "[13.1]") {
    const World hit = after(with({{0.41, 0}, {3, 0}}, left_corner, {0.5, 0}), 1), later = after(hit, 48);
    CHECK_THAT(later.sparks, HasSize(8).of("sparks after 0.2 s"));
    double farthest = 0; // some fly over the mallet
    for (const Particle &spark : later.sparks)
        farthest = std::max(farthest, (spark.position - hit.disc.place - Vec2{half_length, half_width}).norm());
    CHECK_THAT(farthest, IsNear(0.12, about).of("how far a spark gets in 0.2 s [m]"));
    CHECK_THAT(after(later, 72).sparks, HasSize(0).of("sparks after 0.5 s"));
}

//> As next_sparks says
TEST_CASE("has the sparks that next_sparks makes of the disc before a step and after it", "[13.1]") {
    Dice dice;
    World now = with({});
    for (int i = 0; i < 300; ++i) {
        if (i % 20 == 0) now.disc = {{dice.real(-0.9, 0.9), dice.real(-0.3, 0.4)}, dice.real(0, 8) * dice.direction()};
        const World later = after(now, 1);
        if (goals(later) == goals(now) && !(speed(now) == 0 && speed(later) > 0)) // no goal, and no serve
            CHECK_THAT(later.sparks, IsNear(next_sparks(now.sparks, now.disc, later.disc), digits).of("sparks"));
        now = later;
    }
}

//> Most sparks
TEST_CASE("never has more than 64 sparks: a hard hit adds 4 to 60 that fly", "[13.1]") {
    World now = with({{0, 0.46}, {0, 4}});
    now.sparks.assign(60, Particle{{1, 0.5}, {0, 0}, 0, 1});
    CHECK_THAT(after(now, 1).sparks, HasSize(64).of("sparks"));
    now.sparks.assign(64, Particle{{1, 0.5}, {0, 0}, 0, 1});
    CHECK_THAT(after(now, 1).sparks, HasSize(64).of("sparks"));
}

//> The well
TEST_CASE("pulls a disc to the middle at 0.88 m/s², 0.2 m from it, while the well is on, and only then", "[13.1]") {
    for (const Vec2 &way : {Vec2{1, 0}, {-1, 0}, {0, 1}, {-0.6, -0.8}}) {
        const World now = with({0.2 * way, {0, 0}});
        Inputs hands = still(now);
        CHECK_THAT(after(now, hands, 24).disc.velocity, IsNear(Vec2{0, 0}, digits).of(velocity_of_disc));
        hands.well = true; // 0.1 * 0.2 / (0.2² + 0.2²)^1.5 = 0.884, and the felt takes 0.1
        CHECK_THAT(after(now, hands, 24).disc.velocity, IsNear(Vec2{-0.0784 * way}, 2e-3).of(velocity_of_disc));
    }
    for (const double far : {0.05, 0.14, 0.4, 0.8}) { // hardest at 0.14 m, and softer in the middle
        const World now = with({{far, 0}, {0, 0}});
        const Inputs hands{now.left.mallet, now.right.mallet, true};
        const double pull = -gravity_wells::softened_gravity({far, 0}, well_strength, well_softening).x();
        CHECK_THAT(-after(now, hands, 12).disc.velocity.x(), // after 1/20 s
                   IsNear((pull - felt) / 20, 1.5e-3).of("speed to the middle [m/s]"));
    }
}

// ------------------------------------------------------------------------------------------------------- laws of a game

namespace {

double distance(const Vec2 &point, const Segment &wall) {
    const Vec2 along = wall.end - wall.start;
    const double part = (point - wall.start).dot(along) / along.squaredNorm();
    return (point - wall.start - std::clamp(part, 0.0, 1.0) * along).norm();
}

/// What holds in every world that a step comes to.
void check_laws(const World &now, double fastest = 30) { // between two mallets at 2.5 m/s a disc comes to 22.5 m/s
    CHECK_THAT(std::abs(now.disc.place.x()), IsAtMost(half_length).of("|x| of the disc [m]"));
    CHECK_THAT(std::abs(now.disc.place.y()), IsAtMost(half_width - disc_radius + digits).of("|y| of the disc [m]"));
    CHECK_THAT(speed(now), IsAtMost(fastest).of(speed_of_disc));
    for (const Segment &wall : cushions())
        CHECK_THAT(distance(now.disc.place, wall), IsAtLeast(disc_radius - digits).of("from disc to cushion [m]"));
    for (const Player *player : {&now.left, &now.right}) {
        const Vec2 seen = seen_from(player->side, player->mallet);
        CHECK_THAT((now.disc.place - player->mallet).norm(),
                   IsAtLeast(disc_radius + mallet_radius - digits).of("from disc to mallet [m]"));
        CHECK_THAT(seen.x(), IsAtMost(-mallet_radius - disc_radius + digits).of("x of a mallet, for its player [m]"));
        CHECK_THAT(seen.x(), IsAtLeast(mallet_radius - half_length - digits).of("x of a mallet, for its player [m]"));
        CHECK_THAT(std::abs(seen.y()), IsAtMost(half_width - mallet_radius + digits).of("|y| of a mallet [m]"));
        const auto arm_of =
            forward_kinematics::two_links({arm.first, player->pose.first}, {arm.second, player->pose.second});
        CHECK_THAT((arm_of.hand + Vec2(shoulder, 0)).eval(),
                   IsNear(seen, digits).of("hand of an arm, for its player [m]"));
    }
    CHECK_THAT(now.sparks.size() <= most_sparks, IsTrue("there are 64 sparks at most"));
}

/// Hands of two who play: most of the time they want the mallet where the disc is, or somewhere on their half.
Inputs hands_of_players(const World &now, Dice &dice) {
    const auto wants = [&](int side) {
        if (dice.whole(0, 2) > 0) return Vec2{now.disc.place + dice.point(-0.05, 0.05)};
        return Vec2{side * dice.real(0, 1.1), dice.real(-0.6, 0.6)};
    };
    const Vec2 left = wants(-1), right = wants(1);
    return {left, right, dice.whole(0, 3) == 0};
}

World a_start(Dice &dice) {
    return with({{dice.real(-0.2, 0.2), dice.real(-0.4, 0.4)}, dice.real(0, 5) * dice.direction()},
                {dice.real(-0.9, -0.4), dice.real(-0.4, 0.4)}, {dice.real(0.4, 0.9), dice.real(-0.4, 0.4)});
}

} // namespace

//> A long game
TEST_CASE("keeps a disc on the table and out of all that's solid, in 10,000 steps of frames of all lengths", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(300); ++i) {
        World now = a_start(dice);
        for (double time = 0; time < 14;) { // 3360 steps
            const Inputs hands = hands_of_players(now, dice);
            for (int frame = dice.whole(1, 8); frame > 0; --frame) {
                const double dt = dice.whole(0, 1) == 0 ? 1 / 60.0 : dice.real(1 / 240.0, 1 / 20.0);
                now = step(now, hands, dt);
                check_laws(now);
                time += dt;
            }
        }
    }
}

//> Hands far away
TEST_CASE("keeps a mallet in its half, and turns no joint by more than 0.1 rad a step, wherever a hand is", "[13.1]") {
    Dice dice;
    World now = with({});
    for (int i = 0; i < 40; ++i) {
        const double far = i % 2 == 0 ? 2 : 1e5;
        const Inputs hands{dice.point(-far, far), dice.point(-far, far), false};
        for (int s = 0; s < 20; ++s) {
            const World later = after(now, hands, 1);
            check_laws(later);
            for (const auto &[from, to] :
                 {std::pair{now.left.pose, later.left.pose}, {now.right.pose, later.right.pose}}) {
                CHECK_THAT(std::abs(to.first - from.first), IsAtMost(0.1).of("turn of a shoulder [rad]"));
                CHECK_THAT(std::abs(to.second - from.second), IsAtMost(0.1).of("turn of an elbow [rad]"));
            }
            now = later;
        }
    }
}

//> Shot at a mallet
TEST_CASE("lets no disc through a mallet at any speed up to 60 m/s", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(10000); ++i) {
        const double side = dice.sign(), fast = dice.real(1, 60);
        const Vec2 mallet{side * dice.real(0.45, 0.55), dice.real(-0.05, 0.05)}, way = dice.direction();
        const Vec2 across{-way.y(), way.x()};
        const double off = dice.real(-0.05, 0.05), far = dice.real(0.09, 0.15);
        const Vec2 place = mallet - far * way + off * across;
        World now = with({place, fast * way}, side < 0 ? mallet : left_corner, side < 0 ? right_corner : mallet);
        now = after(now, int(std::ceil(0.1 / (fast * step_time)))); // by now it has come to the mallet
        const double deep = std::sqrt(0.08 * 0.08 - off * off);     // and met it here, as seen from its middle:
        const Vec2 normal = (off * across - deep * way) / 0.08;
        const Vec2 bounced = fast * (way - 1.8 * way.dot(normal) * normal); // e = 0.8
        CHECK_THAT((now.disc.place - mallet).dot(normal), IsAtLeast(0.08 - 1e-3).of("how far it is on its side [m]"));
        CHECK_THAT(now.disc.velocity, IsNear(bounced, 0.05).of(velocity_of_disc));
    }
}

//> Shot at a cushion
TEST_CASE("lets no disc through a cushion or a post at any speed up to 60 m/s", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(20000); ++i) {
        const double side = dice.sign(), fast = dice.real(1, 60);
        const Vec2 aim =
            dice.whole(0, 1) == 0 ? Vec2{dice.real(-1, 1), 0.5 * side} : Vec2{side, dice.sign() * dice.real(0.19, 0.5)};
        const Vec2 place{dice.real(-0.9, 0.9), dice.real(-0.4, 0.4)};
        if ((place - left_corner).norm() < 0.1 || (place - right_corner).norm() < 0.1) continue;
        const World now = after(with({place, fast * (aim - place).normalized()}), 1);
        CHECK_THAT(goals(now), IsNear(0).of("goals"));
        check_laws(now, 60);
    }
    for (int i = 0; i < course::cases(5000); ++i) { // at a post, straight along the table
        const double side = dice.sign(), y = dice.sign() * dice.real(0.135, 0.2);
        const World now = after(with({{dice.real(0.75, 0.95) * side, y}, {60 * side, 0}}), 1);
        CHECK_THAT(goals(now), IsNear(0).of("goals"));
        CHECK_THAT(side * now.disc.velocity.x(), IsBelow(0).of("velocity towards the post [m/s]"));
    }
}

//> Straight on
TEST_CASE("flies straight on only where nothing is in its way", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(3000); ++i) {
        World now = a_start(dice);
        const std::vector<Vec2> aims{now.left.mallet, now.right.mallet, {dice.sign(), 0.15 * dice.sign()}};
        const Vec2 aim = aims[dice.whole(0, 2)] + dice.point(-0.05, 0.05);
        now.disc.velocity = dice.real(1, 60) * (aim - now.disc.place).normalized();
        for (int s = 0; s < 20; ++s) {
            const World later = after(now, 1);
            const Vec2 from = now.disc.velocity, to = later.disc.velocity;
            const bool moved = goals(later) == goals(now) && (later.disc.place - now.disc.place).norm() > 1e-6;
            if (moved && from.dot(to) >= (1 - 1e-9) * from.norm() * to.norm()) { // and it isn't turned
                const Segment path{now.disc.place, later.disc.place};
                for (const Vec2 &mallet : {now.left.mallet, now.right.mallet})
                    CHECK_THAT(distance(mallet, path), IsAtLeast(0.08 - 1e-3).of("from its path to a mallet [m]"));
                for (const Vec2 &post : {Vec2{-1, -0.15}, {-1, 0.15}, {1, -0.15}, {1, 0.15}})
                    CHECK_THAT(distance(post, path), IsAtLeast(0.03 - 1e-3).of("from its path to a post [m]"));
            }
            now = later;
        }
    }
}

//> Energy
TEST_CASE("never gives a disc energy, while both mallets rest and the well is off", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        World now = a_start(dice);
        for (int frame = 0; frame < 60; ++frame) {
            const World later = after(now, 10);
            if (goals(later) == goals(now) && speed(now) > 0 && now.wait > 0.9)
                CHECK_THAT(disc_mass / 2 * std::pow(speed(later), 2),
                           IsAtMost(disc_mass / 2 * std::pow(speed(now), 2) + digits).of("energy of the disc [J]"));
            check_laws(later);
            now = later;
        }
    }
}

//> Squeezed
TEST_CASE("keeps a disc on the table, and out of the mallet, when it's squeezed against a cushion", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(2000); ++i) {
        const double side = dice.sign(), up = dice.sign();
        const Vec2 rests{side * dice.real(0.15, 0.96), up * dice.real(0.45, 0.47)};
        const Vec2 mallet{side * dice.real(0.3, 0.8), up * dice.real(0.1, 0.3)};
        World now = with({rests, {0, 0}}, side < 0 ? mallet : left_corner, side < 0 ? right_corner : mallet);
        for (int s = 0; s < 60; ++s) {
            Inputs hands = still(now);
            (side < 0 ? hands.left : hands.right) = now.disc.place;
            now = after(now, hands, 1);
            check_laws(now);
        }
        now = after(now, {}, 240); // and the game goes on
        CHECK_THAT(now.left.mallet, IsNear(Inputs{}.left, 1e-6).of("left mallet, when it has gone [m]"));
        CHECK_THAT(now.right.mallet, IsNear(Inputs{}.right, 1e-6).of("right mallet, when it has gone [m]"));
    }
}

//> Into a corner, and between mallets
TEST_CASE("keeps a disc on the table when two mallets squeeze it, or one pushes it into a corner", "[13.1]") {
    World now = with({{-0.96, 0.46}, {0, 0}}, {-0.7, 0.2}, right_corner);
    for (int s = 0; s < 60; ++s) check_laws(now = after(now, {{-1.2, 0.7}, right_corner, false}, 1));
    Dice dice;
    for (int i = 0; i < course::cases(1000); ++i) {
        now = with({dice.point(-0.05, 0.05), {0, 0}}, {-0.25, dice.real(-0.1, 0.1)}, {0.25, dice.real(-0.1, 0.1)});
        for (int part = 0; part < 8; ++part) {
            const Inputs hands{{0.5, now.disc.place.y() + dice.real(-0.2, 0.2)},
                               {-0.5, now.disc.place.y() + dice.real(-0.2, 0.2)},
                               true}; // it brings the disc back
            for (int s = 0; s < 15; ++s) check_laws(now = after(now, hands, 1));
        }
        now = after(now, {}, 240);
        CHECK_THAT(now.left.mallet, IsNear(Inputs{}.left, 1e-6).of("left mallet, when they've gone [m]"));
        CHECK_THAT(now.right.mallet, IsNear(Inputs{}.right, 1e-6).of("right mallet, when they've gone [m]"));
    }
}

namespace {

Player mirrored(Player player) {
    player.side = -player.side;
    player.mallet.x() = -player.mallet.x();
    player.velocity.x() = -player.velocity.x();
    return player;
}
World mirrored(const World &now) {
    World seen = now;
    for (Vec2 *each : {&seen.disc.place, &seen.disc.velocity}) each->x() = -each->x();
    seen.left = mirrored(now.right);
    seen.right = mirrored(now.left);
    seen.serve_to = -now.serve_to;
    return seen;
}
Inputs mirrored(const Inputs &hands) { return {seen_from(1, hands.right), seen_from(1, hands.left), hands.well}; }

} // namespace

//> In a mirror
TEST_CASE("plays the same game in a mirror, where left and right have changed places", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        World now = a_start(dice);
        now.serve_to = dice.whole(0, 1) == 0 ? -1 : 1;
        for (int part = 0; part < 20; ++part) { // each from the same world: in a second, hits make rounding too large
            Inputs hands = hands_of_players(now, dice);
            for (Vec2 *hand : {&hands.left, &hands.right}) { // where it squeezes no disc
                hand->x() = std::copysign(std::clamp(std::abs(hand->x()), 0.2, 0.7), hand == &hands.left ? -1 : 1);
                hand->y() = std::clamp(hand->y(), -0.3, 0.3);
            }
            const World back = mirrored(after(mirrored(now), mirrored(hands), 20));
            now = after(now, hands, 20);
            CHECK_THAT(back.disc, IsNear(now.disc, 1e-6).of("disc, seen in a mirror"));
            CHECK_THAT(back.left, IsNear(now.left, 1e-6).of("left player, seen in a mirror"));
            CHECK_THAT(back.right, IsNear(now.right, 1e-6).of("right player, seen in a mirror"));
            CHECK_THAT(back.serve_to, IsNear(now.serve_to).of("side that gets the serve, seen in a mirror"));
        }
        now = with({{0.9, 0.05}, {6, 0}});
        now.serve_to = -1;
        const World back = mirrored(after(mirrored(now), 300)); // a goal and a serve
        now = after(now, 300);
        CHECK_THAT(back.disc, IsNear(now.disc, 1e-6).of("disc, seen in a mirror"));
        CHECK_THAT(back.left, IsNear(now.left, 1e-6).of("left player, seen in a mirror"));
    }
}

//> On any screen
TEST_CASE("plays the same game at 30 and at 144 frames a second", "[13.1]") {
    Dice dice;
    for (int i = 0; i < course::cases(500); ++i) {
        World slow = a_start(dice), fast = slow;
        for (int sixth = 0; sixth < 18; ++sixth) { // 3 s, of 40 steps each, with half a step to spare
            const Inputs hands = hands_of_players(slow, dice);
            for (int frame = 0; frame < 5; ++frame) slow = step(slow, hands, 1 / 30.0);
            for (int frame = 0; frame < 24; ++frame) fast = step(fast, hands, 1 / 144.0);
            CHECK_THAT(fast.disc, IsNear(slow.disc, digits).of("disc at 144 frames a second"));
            CHECK_THAT(fast.left, IsNear(slow.left, digits).of("left player at 144 frames a second"));
            CHECK_THAT(fast.right, IsNear(slow.right, digits).of("right player at 144 frames a second"));
        }
    }
}

//> Nothing is remembered
TEST_CASE("comes to the same world when it's asked twice, with another game in between", "[13.1]") {
    Dice dice;
    World now = a_start(dice);
    for (int i = 0; i < 60; ++i) {
        const Inputs hands = hands_of_players(now, dice);
        const World once = step(now, hands, 0.03);
        step(a_start(dice), hands, 0.1);
        const World twice = step(now, hands, 0.03);
        CHECK_THAT(twice.disc, IsNear(once.disc).of("disc, asked again"));
        CHECK_THAT(twice.left, IsNear(once.left).of("left player, asked again"));
        CHECK_THAT(twice.wait, IsNear(once.wait).of("time until the serve, asked again [s]"));
        CHECK_THAT(twice.sparks, HasSize(once.sparks.size()).of("sparks, asked again"));
        now = once;
    }
}

//>
TEST_CASE("rejects bad times, sides, goals and sparks, also when no step is due", "[13.1]") {
    World now = opening();
    now.sparks = {{{1, 0.5}, {0.1, 0}, 0.1, 0.4}};
    for (const double bad : {-1e-9, -0.1, 0.2501, 1.0}) CHECK_REFUSED(step(now, {}, bad), "dt isn't from 0 to 0.25 s");
    const auto refused_with = [&](const auto &spoil, const std::string &words) {
        World bad = now;
        spoil(bad);
        CHECK_REFUSED(step(bad, {}, 0.1), words);
        CHECK_REFUSED(step(bad, {}, 0), words + ", when no step is due");
    };
    refused_with([](World &bad) { bad.spare = -1e-9; }, "spare < 0");
    refused_with([](World &bad) { bad.spare = step_time + 1e-9; }, "spare is more than a step");
    refused_with([](World &bad) { bad.left.side = 1; }, "the left player is on the right");
    refused_with([](World &bad) { bad.right.side = -1; }, "the right player is on the left");
    refused_with([](World &bad) { bad.right.side = 2; }, "a side of 2");
    refused_with([](World &bad) { bad.serve_to = 0; }, "a serve to nobody");
    refused_with([](World &bad) { bad.right.goals = -1; }, "-1 goals");
    refused_with([](World &bad) { bad.sparks.assign(65, bad.sparks.front()); }, "65 sparks");
    refused_with([](World &bad) { bad.sparks.front().life = 0; }, "a life of 0 s");
    CHECK_THAT(step(now, {}, 0.25).spare, IsNear(0.0, step_time).of("spare time [s]")); // good input is still answered
}
