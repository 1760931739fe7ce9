#include "table_hockey.hpp"

namespace table_hockey {

//> Solution: a good world
static void require_world(const World &now) {
    for (const Player *player : {&now.left, &now.right})
        course::require(player->goals >= 0, "goals must not be negative", player->goals);
    for (const Particle &spark : now.sparks) particles::require_particle(spark);
    course::require(now.spare >= 0 && now.spare <= step_time, "spare time [s] must be from 0 to a step", now.spare);
    course::require(now.left.side == -1, "the left player's side must be -1", now.left.side);
    course::require(now.right.side == 1, "the right player's side must be 1", now.right.side);
    course::require(now.serve_to == -1 || now.serve_to == 1, "serve_to must be -1 or 1", now.serve_to);
    course::require(now.sparks.size() <= most_sparks, "there must be 64 sparks at most", double(now.sparks.size()));
}

//> Solution: a hit
/// Behind the mallet there's an arm, so nothing the disc does moves it.
static void hit(Disc &disc, const Player &player) {
    const double of_disc = nt_collisions::decompose(disc.velocity, disc.place, player.mallet).normal;
    const double of_mallet = nt_collisions::decompose(player.velocity, disc.place, player.mallet).normal;
    const double impulse = momentum::impulse({1 / disc_mass, of_disc}, {0, of_mallet}, mallet_restitution);
    disc.velocity -= impulse / disc_mass * (player.mallet - disc.place).normalized();
}

//> Solution: what's first in the way
struct Contact {
    segment_intersection::Impact impact;
    const Player *player; ///< whose mallet it is; none if it's a cushion
};
using MaybeContact = std::optional<Contact>;

/// What a disc that moves so far meets first, if anything. It looks at the mallets of these players.
static MaybeContact first_contact(const Segment &motion, const std::vector<const Player *> &players) {
    MaybeContact first;
    const auto look = [&](const Segment &wall, double distance, const Player *player) {
        const auto impact = segment_intersection::time_of_impact(motion, distance, wall);
        if (impact && (motion.end - motion.start).dot(impact->centre - impact->point) > -1e-15) return; // it glides
        if (impact && (!first || impact->t < first->impact.t)) first = {*impact, player};
    };
    for (const Segment &wall : cushions()) look(wall, disc_radius, nullptr);
    for (const Player *each : players) look({each->mallet, each->mallet}, touch, each);
    return first;
}

//> Solution: a mallet moves
static void move(Disc &disc, Player &player, const Vec2 &wanted) {
    const Player moved = follow_hand(player, wanted);
    if ((moved.mallet - disc.place).norm() < touch) {
        hit(disc, moved);
        const Vec2 to =
            nt_collisions::push_apart({moved.mallet, mallet_radius, 0}, {disc.place, disc_radius, 1 / disc_mass}).b;
        if (first_contact({disc.place, to}, {})) { // no room: the mallet stays
            player.velocity = {0, 0};
            return;
        }
        disc.place = to;
    }
    player = moved;
}

//> Solution: the disc moves
static void move_disc(World &now, bool well) {
    Disc &disc = now.disc;
    if (well) disc.velocity += step_time * gravity_wells::softened_gravity(disc.place, well_strength, well_softening);
    disc.velocity = inclined_planes::table_friction(disc.velocity, felt, step_time);
    double time = step_time;
    for (int contacts = 0; contacts < 20; ++contacts) { // squeezed, it would meet both sides forever
        const Segment motion{disc.place, motion::uniform_motion(disc.place, disc.velocity, time)};
        const MaybeContact contact = first_contact(motion, {&now.left, &now.right});
        disc.place = contact ? contact->impact.centre : motion.end;
        if (!contact) return;
        time *= 1 - contact->impact.t;
        if (contact->player) hit(disc, *contact->player);
        else disc.velocity = reflection::bounce(disc.velocity, disc.place - contact->impact.point, cushion);
    }
}

//> Solution: goals and serves
static void score(World &now) {
    if (std::abs(now.disc.place.x()) <= half_length) return;
    now.serve_to = now.disc.place.x() > 0 ? 1 : -1;
    ++(now.serve_to > 0 ? now.left : now.right).goals;
    now.disc = {};
}

static void serve(World &now) {
    const bool rests = now.disc.velocity.isZero(0) && std::abs(now.disc.place.x()) <= centre_line;
    now.wait = rests ? now.wait - step_time : serve_time;
    if (now.wait > 0) return;
    now.disc.velocity = serve_velocity(now);
    now.wait = serve_time;
}

//> Solution 13.1: step
World step(World now, const Inputs &inputs, double dt) {
    require_world(now);
    course::require(dt >= 0 && dt <= 0.25, "dt [s] must be from 0 to 0.25", dt);
    const time_based_motion::Due due = time_based_motion::due_steps(now.spare, dt, step_time);
    now.spare = due.spare;
    for (int i = 0; i < due.steps; ++i) {
        const Disc before = now.disc;
        move(now.disc, now.left, inputs.left);
        move(now.disc, now.right, inputs.right);
        move_disc(now, inputs.well);
        now.sparks = next_sparks(now.sparks, before, now.disc);
        score(now);
        serve(now);
    }
    return now;
}
//>

} // namespace table_hockey
