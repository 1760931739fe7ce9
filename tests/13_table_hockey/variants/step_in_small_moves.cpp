// 13.1: moves of a millimetre at most, its own arithmetic for all that happens, and goals that are looked for at once
#include "table_hockey.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace table_hockey {

namespace {

struct Near {
    Vec2 from{0, 0}; // the nearest point of what's near
    double room = 1; // from the disc's rim to it, negative inside [m]
};

Near to_mallet(const Vec2 &disc, const Vec2 &mallet) {
    const Vec2 away = disc - mallet;
    const double far = std::hypot(away.x(), away.y());
    return {mallet + 0.05 / far * away, far - 0.08};
}

Near to_cushion(const Vec2 &disc) {
    const double x = std::copysign(1, disc.x()), y = std::copysign(1, disc.y()), up = std::abs(disc.y());
    Near end{{x, disc.y()}, 0};
    if (up < 0.15) end.from.y() = 0.15 * y; // in front of a goal the post is nearest
    end.room = std::hypot(disc.x() - end.from.x(), disc.y() - end.from.y()) - 0.03;
    const Near side{{disc.x(), 0.5 * y}, 0.47 - up};
    return side.room < end.room ? side : end;
}

void turn(Disc &disc, const Vec2 &from, const Vec2 &velocity, double restitution, double mu) {
    const double dx = disc.place.x() - from.x(), dy = disc.place.y() - from.y(), far = std::hypot(dx, dy);
    const double nx = dx / far, ny = dy / far;
    const double vx = disc.velocity.x() - velocity.x(), vy = disc.velocity.y() - velocity.y();
    const double away = vx * nx + vy * ny, along = vy * nx - vx * ny;
    if (away >= 0) return;
    const double loss = std::min(std::abs(along), -mu * (1 + restitution) * away);
    const double slower = along - std::copysign(loss, along);
    disc.velocity = {velocity.x() - restitution * away * nx - slower * ny,
                     velocity.y() - restitution * away * ny + slower * nx};
}

bool fits(const World &now, const Vec2 &place) {
    for (const Near &near : {to_mallet(place, now.left.mallet), to_mallet(place, now.right.mallet), to_cushion(place)})
        if (near.room < -1e-12) return false; // a hair is rounding
    return true;
}

void walk(World &now, Player &player, const Vec2 &hand) {
    const Player before = player;
    player = follow_hand(player, hand);
    const Near near = to_mallet(now.disc.place, player.mallet);
    if (near.room >= 0) return;
    turn(now.disc, player.mallet, player.velocity, 0.8, 0);
    const Vec2 way = (now.disc.place - player.mallet) / (near.room + 0.08);
    const Vec2 place = player.mallet + 0.0800000001 * way;
    if (fits(now, place)) {
        now.disc.place = place;
    } else { // back to where it was
        player = before;
        player.velocity = {0, 0};
    }
}

void fly(World &now, double time) {
    Disc &disc = now.disc;
    const int moves = 1 + int(disc.velocity.norm() * time / 0.001);
    for (int i = 0; i < moves; ++i) {
        const Vec2 next = disc.place + time / moves * disc.velocity;
        if (std::abs(next.x()) > 1) { // all of its centre is in the goal
            disc.place = next;
            return;
        }
        if (fits(now, next)) {
            disc.place = next;
            continue;
        }
        if (to_cushion(next).room < 0) turn(disc, to_cushion(disc.place).from, {0, 0}, 0.9, 0.05);
        for (const Player *each : {&now.left, &now.right})
            if (to_mallet(next, each->mallet).room < 0) turn(disc, each->mallet, each->velocity, 0.8, 0);
        const Vec2 turned = disc.place + time / moves * disc.velocity;
        if (fits(now, turned)) disc.place = turned;
    }
}

} // namespace

World step(World now, const Inputs &inputs, double dt) {
    for (const Player *each : {&now.left, &now.right})
        course::require_range(each->mallet, each->velocity, each->pose.first, each->pose.second);
    course::require_range(now.disc.place, now.disc.velocity, now.wait, inputs.left, inputs.right);
    course::require(std::min(now.left.goals, now.right.goals) >= 0, "goals must not be negative", -1);
    course::require(now.serve_to * now.serve_to == 1, "serve_to must be -1 or 1", now.serve_to);
    for (const Particle &spark : now.sparks) particles::require_particle(spark);
    if (!(dt >= 0 && dt <= 0.25) || !(now.spare >= 0 && now.spare <= step_time) || now.left.side != -1
        || now.right.side != 1 || now.sparks.size() > 64)
        throw std::invalid_argument{"no such game"};
    double time = now.spare + dt;
    while (time >= step_time) {
        time -= step_time;
        const Disc before = now.disc;
        walk(now, now.left, inputs.left);
        walk(now, now.right, inputs.right);
        Vec2 &v = now.disc.velocity;
        if (inputs.well) {
            const double far = std::hypot(std::hypot(now.disc.place.x(), now.disc.place.y()), 0.2);
            v -= step_time * 0.1 / (far * far * far) * now.disc.place;
        }
        const double speed = v.norm();
        v *= speed > 0.1 / 240 ? 1 - 0.1 / 240 / speed : 0;
        fly(now, step_time);
        now.sparks = next_sparks(now.sparks, before, now.disc);
        if (std::abs(now.disc.place.x()) > 1) {
            const bool right = now.disc.place.x() > 0;
            if (right) now.left.goals++;
            else now.right.goals++;
            now.serve_to = right ? 1 : -1;
            now.disc = {{0, 0}, {0, 0}};
            now.wait = 1;
        }
        if (now.disc.velocity != Vec2{0, 0} || std::abs(now.disc.place.x()) > 0.01) now.wait = 1 + step_time;
        now.wait -= step_time;
        if (now.wait <= 0) {
            now.disc.velocity = serve_velocity(now);
            now.wait = 1;
        }
    }
    now.spare = time;
    return now;
}

} // namespace table_hockey
