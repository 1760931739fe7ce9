#pragma once
// Two balls that meet where B's centre is at the origin.
#include "shared.hpp"

namespace play {

struct Meeting : Scene {
    Ball a, b;
    Vec2 touched[2]{{0, 0}, {0, 0}}; ///< where their centres were as they met [m]
    bool met = false;
    double since = 0; ///< they began, and from then on since they met [s]
    std::vector<Vec2> paths[2];
    Knock knock;

    /// A frame for both.
    virtual void move(double dt) = 0;

    View view() const override { return {{-6.4, -3.6}, {6.4, 3.6}, Stage::felt}; }
    /// They begin so that they touch after so many frames, at the end of one; n is from A's centre to B's then.
    void place(const Vec2 &n, const Ball &first, const Ball &second, int frames) {
        a = first, b = second;
        b.position = -frames * frame_time * b.velocity;
        a.position = -(a.radius + b.radius - 1e-9) * n - frames * frame_time * a.velocity;
        met = false;
        since = 0;
        for (std::vector<Vec2> &path : paths) path.clear();
    }
    /// The frame of 8.3: they collide if they touch, and roll on.
    void collide_and_roll(double restitution, double dt) {
        if (touch(a, b)) collide(a, b, restitution);
        a.position += dt * a.velocity;
        b.position += dt * b.velocity;
    }
    void roll(double dt) {
        const Vec2 before = a.velocity, at[]{a.position, b.position};
        move(dt);
        since += dt;
        paths[0].push_back(a.position);
        paths[1].push_back(b.position);
        knock.age += dt;
        if (met || (a.velocity - before).norm() <= 1e-9) return;
        met = true;
        since = 0;
        touched[0] = at[0], touched[1] = at[1];
        const Vec2 n = (b.position - a.position).normalized();
        knock = {a.position + a.radius * n, turned(n), 0};
    }
    bool is_seen(const Ball &ball) const {
        const Vec2 far = view().high + Vec2{ball.radius, ball.radius};
        return std::abs(ball.position.x()) < far.x() && std::abs(ball.position.y()) < far.y();
    }
    bool is_over() const { return (!is_seen(a) && !is_seen(b)) || since > 3; }

    void draw_both(Canvas &canvas) const {
        const Ball *balls[]{&a, &b};
        for (int i : {0, 1}) canvas.trail(paths[i], colours[i], 6);
        for (int i : {0, 1})
            if (met) draw_outline(canvas, touched[i], balls[i]->radius, colours[i]);
        for (int i : {0, 1}) draw_lettered(canvas, balls[i]->position, balls[i]->radius, i);
        knock.draw(canvas);
    }
};
} // namespace play
