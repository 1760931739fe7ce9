#pragma once
// What this game needs around its step: somebody to move the hands. That's the keys, or a machine, or a beginner who
// never gets tired, so that we can try the machine in a hundred matches. Nothing in here looks at a clock.
#include "../chance.hpp"
#include "table_hockey.hpp"

#include <algorithm>
#include <cmath>

namespace table_hockey {

//> A hand that keys lead
/// Where the hand goes while keys are held: straight on, farther than the mallet gets in a frame. Without a key it's where
/// the mallet is, which stops.
inline Vec2 led(const Player &now, const Vec2 &direction) {
    const double ahead = mallet_speed * time_based_motion::longest_frame;
    return direction.isZero(0) ? now.mallet : Vec2{now.mallet + ahead * direction.normalized()};
}

//> A view
/// What a player sees: all as if it played on the left, with its own goal at x = -half_length.
struct View {
    Disc disc;
    Vec2 mallet, other; ///< its own, and the other player's [m]
};
inline View view_of(const World &now, int side) {
    const Player &own = side < 0 ? now.left : now.right, &other = side < 0 ? now.right : now.left;
    return {{seen_from(side, now.disc.place), seen_from(side, now.disc.velocity)},
            seen_from(side, own.mallet),
            seen_from(side, other.mallet)};
}

//> Foresight
/// How high the disc will be when it gets to this x [m], if it comes from the right. A cushion is a mirror: the disc flies
/// straight on, into an image of the table, which is then folded back.
inline double foreseen(const Disc &disc, double x) {
    const double time = std::max(0.0, (x - disc.place.x()) / disc.velocity.x()), high = half_width - disc_radius;
    const double y = motion::uniform_motion(disc.place, disc.velocity, time).y();
    return high - std::abs(std::remainder(y - high, 4 * high));
}

//> Guard
constexpr double guard_line = -0.85; ///< where a player waits: x [m]
/// The place on the guard line that the disc is going to cross, or where it will if it comes; not far beside the goal.
inline Vec2 guard(const Disc &disc, bool foresees) {
    const bool comes = disc.velocity.x() < -0.1;
    const double y = comes && foresees ? foreseen(disc, guard_line) : 0.4 * disc.place.y();
    return {guard_line, std::clamp(y, -half_goal, half_goal)};
}

//> A shot
/// The direction in which to hit the disc [1]: straight at the other goal, or by way of a cushion, whichever the other
/// mallet is farthest from.
inline Vec2 best_shot(const View &view) {
    const Vec2 corner{half_length, half_width}, inside = corner - Vec2{0.04, 0.04}, goal{inside.x(), 0};
    const Vec2 from = view.disc.place.cwiseMax(-inside).cwiseMin(inside);
    Vec2 best{1, 0};
    double most = -1;
    for (const int up : {0, 1, -1}) {
        const Vec2 shot = reflection::bank_shot({from, {0, 0}, disc_radius}, goal, {-corner, corner}, 0, up);
        const Vec2 other = seen_from(1, view.other); // who sees it come from the right
        const double free = std::abs(foreseen({seen_from(1, from), seen_from(1, shot)}, other.x()) - other.y());
        if (free > most + 0.05) best = shot, most = free;
    }
    return best;
}

//> A strike
/// Where the hand goes to hit the disc that way: behind it, and then through it. A mallet that's in front of it goes round.
/// A disc that lies in a corner gets a tap, and room to come out.
inline Vec2 strike(const Vec2 &mallet, const Disc &disc, const Vec2 &shot) {
    const Vec2 place = disc.place, way = place - mallet, behind = in_own_half(place - 2 * touch * shot);
    if (place.x() < guard_line) return disc.velocity.norm() < 0.1 ? place : guard(disc, false);
    if (way.normalized().dot((place - behind).normalized()) > 0.95) return place;
    if (way.x() > touch / 2) return behind;
    const double beside = place.y() + (mallet.y() > place.y() ? 1.5 : -1.5) * touch;
    return {std::abs(way.y()) < 1.2 * touch ? mallet.x() : behind.x(), beside};
}

//> The machine
enum class Level { easy, difficult };
/// Where the machine's hand goes, on either side. It guards its goal, and strikes when the disc is slow and within reach.
/// Easy, it looks at where the disc is, and hits it straight; hard, it looks at where the disc will be.
inline Vec2 machine_hand(const World &now, int side, Level level) {
    const View view = view_of(now, side);
    const bool foresees = level == Level::difficult;
    Disc disc = view.disc;
    if (disc.place.x() > 0 || disc.velocity.norm() > (foresees ? 1.2 : 0.8))
        return seen_from(side, guard(disc, foresees));
    if (!foresees) return seen_from(side, strike(view.mallet, disc, {1, 0}));
    const double time = (disc.place - view.mallet).norm() / mallet_speed;
    disc.place = motion::uniform_motion(disc.place, disc.velocity, time);
    return seen_from(side, strike(view.mallet, disc, best_shot(view)));
}

//> The beginner
constexpr double late = 0.045, clumsy = 0.03; ///< [s], [m]
/// Where the hand of a beginner on the left goes. It sees where the disc was a moment ago, points a little beside it, and
/// runs after it as soon as it's in its own half.
inline Vec2 beginner_hand(const World &now, unsigned seed, double time) {
    const auto number = 2 * unsigned(4 * time); // points elsewhere four times a second
    const Vec2 beside = clumsy * Vec2{2 * course::chance(seed, number) - 1, 2 * course::chance(seed, number + 1) - 1};
    Disc disc = now.disc;
    disc.place = motion::uniform_motion(disc.place, disc.velocity, -late) + beside;
    return disc.place.x() > 0 ? Vec2{guard(disc, false) + beside} : strike(now.left.mallet, disc, {1, 0});
}

//> A match
constexpr int goals_to_win = 5;
constexpr double match_time = 180, frame_time = 1.0 / 60; ///< [s]
inline bool is_won(const World &now) { return std::max(now.left.goals, now.right.goals) >= goals_to_win; }

struct Goals {
    int left{}, right{};
};

/// Rounds places to a millionth of a metre, and so on: a machine's sines may differ in their last digit, and after some
/// hits it would play another game.
inline void round_off(World &now) {
    for (Vec2 *each : {&now.disc.place, &now.disc.velocity, &now.left.mallet, &now.left.velocity, &now.right.mallet,
                       &now.right.velocity})
        *each = (*each * (1 << 20)).array().round() / (1 << 20);
}

/// A beginner on the left against the machine, until one of them has won or time is up.
inline Goals play_match(unsigned seed, Level level) {
    World now = opening();
    for (int frame = 0; frame * frame_time < match_time && !is_won(now); ++frame) {
        const Inputs inputs{beginner_hand(now, seed, frame * frame_time), machine_hand(now, 1, level)};
        now = step(now, inputs, frame_time);
        round_off(now);
    }
    return {now.left.goals, now.right.goals};
}
//>
} // namespace table_hockey
