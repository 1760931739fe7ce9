// 11.10: up to the first burst, the burst, and then itself for the time that is left
#include "particles.hpp"

#include <algorithm>

namespace particles {

static Show shown_for(const Show &now, const Rules &rules, double dt) {
    const Vec2 down{0, -rules.gravity};
    std::size_t next = now.rockets.size();
    double soonest = dt;
    for (std::size_t i = now.rockets.size(); i-- > 0;) { // from behind, so that of two at once the first one is left
        const Rocket &rocket = now.rockets[i];
        const double rise = rocket.velocity.y() > 0 ? rocket.velocity.y() / rules.gravity : 0;
        if (rocket.wait + rise <= soonest) soonest = rocket.wait + rise, next = i;
    }
    Show then{{}, {}, now.shown, now.lost, now.most};
    for (Particle spark : now.sparks) {
        spark.position += soonest * (spark.velocity + soonest / 2 * down);
        spark.velocity += soonest * down;
        spark.age += soonest;
        if (spark.age < spark.life && spark.position.y() >= 0) then.sparks.push_back(spark);
    }
    for (std::size_t i = 0; i < now.rockets.size(); ++i) {
        Rocket rocket = now.rockets[i];
        if (rocket.wait > soonest) {
            rocket.wait -= soonest;
        } else {
            const double flight = soonest - rocket.wait;
            rocket.wait = 0;
            rocket.position += flight * (rocket.velocity + flight / 2 * down);
            rocket.velocity += flight * down;
        }
        if (i != next) {
            then.rockets.push_back(rocket);
            continue;
        }
        for (const Vec2 &each : disc_burst(rocket.random_numbers, rules.speed))
            if (int(then.sparks.size()) < rules.places) {
                then.sparks.push_back({rocket.position, each + rocket.velocity, 0, rules.life});
                then.shown += 1;
            } else then.lost += 1;
        then.most = std::max(then.most, int(then.sparks.size()));
    }
    return next < now.rockets.size() ? shown_for(then, rules, dt - soonest) : then;
}

Show run_show(Show now, const Rules &rules, double dt) {
    require_show(now, rules, dt);
    return shown_for(now, rules, dt);
}

} // namespace particles
