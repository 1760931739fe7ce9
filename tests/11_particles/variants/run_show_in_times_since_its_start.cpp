// 11.10: each burst and each spark's end has its time since the start of the call, and nothing moves before the end
#include "particles.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace particles {

namespace {
struct Light {
    Particle born;
    double from, until; ///< since the start of the call [s]
};
struct Top {
    double time;
    std::size_t index;
    bool operator<(const Top &other) const { return std::tie(time, index) < std::tie(other.time, other.index); }
};

/// How long until it has fallen from so high to the street [s].
double to_the_street(double height, double up, double gravity) {
    return (up + std::sqrt(up * up + 2 * gravity * height)) / gravity;
}
Light light(const Particle &born, double from, double gravity) {
    const double street = to_the_street(born.position.y(), born.velocity.y(), gravity);
    return {born, from, from + std::min(born.life - born.age, std::nextafter(street, 1e9))};
}
} // namespace

Show run_show(Show now, const Rules &rules, double dt) {
    require_show(now, rules, dt);
    std::vector<Top> tops;
    for (std::size_t i = 0; i < now.rockets.size(); ++i)
        tops.push_back({now.rockets[i].wait + std::max(now.rockets[i].velocity.y(), 0.0) / rules.gravity, i});
    std::sort(tops.begin(), tops.end());

    std::vector<Light> lights;
    for (const Particle &spark : now.sparks) lights.push_back(light(spark, 0, rules.gravity));
    const auto glow = [&](double time) {
        return int(std::count_if(lights.begin(), lights.end(), [&](const Light &each) { return each.until > time; }));
    };
    std::vector<Rocket> left;
    for (const auto &[time, index] : tops) {
        if (time > dt) continue;
        const Rocket &rocket = now.rockets[index];
        const double flight = time - rocket.wait;
        const Vec2 top = rocket.position + flight * rocket.velocity - Vec2{0, rules.gravity * flight * flight / 2};
        const Vec2 velocity{rocket.velocity.x(), rocket.velocity.y() - rules.gravity * flight};
        int room = rules.places - glow(time);
        for (const Vec2 &each : disc_burst(rocket.random_numbers, rules.speed)) {
            if (room-- <= 0) {
                ++now.lost;
                continue;
            }
            ++now.shown;
            lights.push_back(light({top, velocity + each, 0, rules.life}, time, rules.gravity));
        }
        now.most = std::max(now.most, glow(time));
    }
    for (Rocket rocket : now.rockets) {
        if (rocket.wait + std::max(rocket.velocity.y(), 0.0) / rules.gravity <= dt) continue;
        const double flight = std::max(0.0, dt - rocket.wait);
        rocket.wait = std::max(0.0, rocket.wait - dt);
        rocket.position += flight * rocket.velocity - Vec2{0, rules.gravity * flight * flight / 2};
        rocket.velocity.y() -= rules.gravity * flight;
        left.push_back(rocket);
    }
    now.rockets = left;
    now.sparks.clear();
    for (const auto &[born, from, until] : lights) {
        if (until <= dt) continue;
        const double time = dt - from;
        now.sparks.push_back({born.position + time * born.velocity - Vec2{0, rules.gravity * time * time / 2},
                              born.velocity - Vec2{0, rules.gravity * time}, born.age + time, born.life});
    }
    return now;
}

} // namespace particles
