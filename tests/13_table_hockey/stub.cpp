// Section 13, Table hockey. Replace the `throw` by your own code, save, and see:  ./course check 13
// The lines that refuse bad input are written for you.

#include "table_hockey.hpp"

namespace table_hockey {

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

// 13.1 challenge
World step(World now, const Inputs &inputs, double dt) {
    require_world(now);
    course::require(dt >= 0 && dt <= 0.25, "dt [s] must be from 0 to 0.25", dt);
    throw course::NotYet{"how many steps are due? And in one of them, what moves first?"};
}

} // namespace table_hockey
