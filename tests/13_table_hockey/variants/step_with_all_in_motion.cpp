// 13.1: mallets and disc move at the same time, from event to event; between a mallet and a wall, the mallet stops there
#include "table_hockey.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace table_hockey {

namespace {

struct Event {
    double time; // from now on [s]
    Vec2 normal; // towards the disc
    Player *player;
};

/// A player whose hand is on the way from one place to another.
Player on_the_way(Player player, const Vec2 &place) {
    const Vec2 base{shoulder, 0};
    player.pose = inverse_kinematics::continued(arm, player.pose, seen_from(player.side, place) - base);
    const Vec2 hand =
        forward_kinematics::two_links({arm.first, player.pose.first}, {arm.second, player.pose.second}).hand;
    player.mallet = seen_from(player.side, base + hand);
    return player;
}

std::optional<Event> next_event(const Disc &disc, const std::array<Player *, 2> &players, double time) {
    std::optional<Event> first;
    for (const Segment &wall : cushions()) {
        const Vec2 end = disc.place + time * disc.velocity;
        const auto impact = segment_intersection::time_of_impact({disc.place, end}, disc_radius, wall);
        if (!impact || disc.velocity.dot(impact->centre - impact->point) > -1e-13) continue; // it glides
        if (!first || impact->t * time < first->time)
            first = Event{impact->t * time, impact->centre - impact->point, nullptr};
    }
    for (Player *each : players) {
        const nt_collisions::Ball mallet{each->mallet, each->velocity, mallet_radius, 1},
            ball{disc.place, disc.velocity, disc_radius, 1};
        const auto t = nt_collisions::time_of_impact(mallet, ball);
        if (!t || *t > time || (first && *t >= first->time)) continue;
        const Vec2 gap = disc.place + *t * disc.velocity - each->mallet - *t * each->velocity;
        first = Event{*t, gap, each};
    }
    return first;
}

void one_step(World &now, const Inputs &inputs) {
    Disc &disc = now.disc;
    const std::array<Player *, 2> players{&now.left, &now.right};
    const std::array<Player, 2> from{now.left, now.right};
    std::array<Player, 2> there{follow_hand(now.left, inputs.left), follow_hand(now.right, inputs.right)};
    for (int i = 0; i < 2; ++i) players[i]->velocity = (there[i].mallet - from[i].mallet) / step_time;

    if (inputs.well) disc.velocity += step_time * gravity_wells::softened_gravity(disc.place, 0.1, 0.2);
    disc.velocity = inclined_planes::table_friction(disc.velocity, felt, step_time);
    double left = step_time;
    for (int events = 0; events < 40; ++events) {
        const auto event = next_event(disc, players, left);
        const double t = event ? event->time : left;
        disc.place += t * disc.velocity;
        for (Player *each : players) each->mallet += t * each->velocity;
        left -= t;
        if (!event) break;
        const Vec2 n = event->normal.normalized();
        if (event->player) {
            const double closing = (event->player->velocity - disc.velocity).dot(n);
            disc.velocity += (1 + mallet_restitution) * closing * n;
            if (events >= 20) event->player->velocity = {0, 0}; // it squeezes the disc, and stops where it is
        } else {
            disc.velocity = reflection::bounce(disc.velocity, n, cushion);
        }
    }
    for (int i = 0; i < 2; ++i) {
        const bool came = (players[i]->mallet - there[i].mallet).norm() < 1e-12;
        const int goals = players[i]->goals;
        *players[i] = came ? there[i] : on_the_way(*players[i], players[i]->mallet);
        players[i]->goals = goals;
        if (!came) players[i]->velocity = {0, 0};
    }
}

} // namespace

World step(World now, const Inputs &inputs, double dt) {
    for (const Player *each : {&now.left, &now.right})
        course::require_range(each->pose.first, each->pose.second, each->mallet, each->velocity);
    course::require_range(now.disc.place, now.disc.velocity, now.wait, now.spare, inputs.left, inputs.right, dt);
    course::require(std::min(now.left.goals, now.right.goals) >= 0, "goals must not be negative", -1);
    course::require(now.serve_to * now.serve_to == 1, "serve_to must be -1 or 1", now.serve_to);
    for (const Particle &spark : now.sparks) particles::require_particle(spark);
    const bool good = dt >= 0 && dt <= 0.25 && now.spare >= 0 && now.spare <= step_time && now.left.side == -1
                      && now.right.side == 1 && now.sparks.size() <= 64;
    if (!good) throw std::invalid_argument{"no such world, or no such time"};

    const int steps = int(std::floor((now.spare + dt) / step_time));
    now.spare = now.spare + dt - steps * step_time;
    for (int i = 0; i < steps; ++i) {
        const Disc before = now.disc;
        one_step(now, inputs);
        now.sparks = next_sparks(now.sparks, before, now.disc);
        const double x = now.disc.place.x();
        if (std::abs(x) > half_length) {
            Player &scorer = x > 0 ? now.left : now.right;
            scorer.goals += 1;
            now.serve_to = -scorer.side;
            now.disc = Disc{};
        }
        if (now.disc.velocity.norm() > 0 || std::abs(now.disc.place.x()) > centre_line) {
            now.wait = serve_time;
        } else if ((now.wait -= step_time) <= 0) {
            now.disc.velocity = serve_velocity(now);
            now.wait = serve_time;
        }
    }
    return now;
}

} // namespace table_hockey
