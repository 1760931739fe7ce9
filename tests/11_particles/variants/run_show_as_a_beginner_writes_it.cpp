// 11.10: as a beginner writes it, with flags and numbers, x and y on their own
#include "particles.hpp"

namespace particles {

Show run_show(Show now, const Rules &rules, double dt) {
    require_show(now, rules, dt);
    bool done = false;
    while (!done) {
        int which = -1;
        double when = 0;
        for (int i = 0; i < int(now.rockets.size()); i++) {
            const Rocket &r = now.rockets[std::size_t(i)];
            double t = r.wait;
            if (r.velocity.y() > 0) t = t + r.velocity.y() / rules.gravity;
            if (which == -1 || t < when) {
                which = i;
                when = t;
            }
        }
        if (which == -1 || when > dt) {
            done = true;
            when = dt;
        }
        for (Rocket &r : now.rockets) {
            double t = when;
            if (r.wait >= t) {
                r.wait = r.wait - t;
                continue;
            }
            t = t - r.wait;
            r.wait = 0;
            r.position.x() += r.velocity.x() * t;
            r.position.y() += r.velocity.y() * t - 0.5 * rules.gravity * t * t;
            r.velocity.y() -= rules.gravity * t;
        }
        for (Particle &s : now.sparks) {
            s.position.x() += s.velocity.x() * when;
            s.position.y() += s.velocity.y() * when - 0.5 * rules.gravity * when * when;
            s.velocity.y() -= rules.gravity * when;
            s.age = s.age + when;
        }
        for (int i = int(now.sparks.size()) - 1; i >= 0; i--) {
            const Particle &s = now.sparks[std::size_t(i)];
            if (s.age >= s.life || s.position.y() < 0) now.sparks.erase(now.sparks.begin() + i);
        }
        dt = dt - when;
        if (done) break;
        const Rocket r = now.rockets[std::size_t(which)];
        now.rockets.erase(now.rockets.begin() + which);
        const std::vector<Vec2> v = disc_burst(r.random_numbers, rules.speed);
        for (std::size_t i = 0; i < v.size(); i++) {
            if (int(now.sparks.size()) == rules.places) {
                now.lost++;
            } else {
                Particle s;
                s.position = r.position;
                s.velocity = r.velocity + v[i];
                s.age = 0;
                s.life = rules.life;
                now.sparks.push_back(s);
                now.shown++;
            }
            if (int(now.sparks.size()) > now.most) now.most = int(now.sparks.size());
        }
    }
    return now;
}

} // namespace particles
