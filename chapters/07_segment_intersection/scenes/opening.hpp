#pragma once
// What many games ask, once a frame: does the ball touch a wall now, wherever it was a moment ago?
#include "shared.hpp"

namespace play {

struct Opening : RoomScene {
    static constexpr std::string_view name = "asks once a frame";
    bool escaped = false;

    Opening() { still_time = 2.5; }

    double size() const override { return 0.25; }
    bool touches(const Vec2 &centre, const Segment &wall) const {
        const Vec2 along = wall.end - wall.start;
        const double s = std::clamp(along.dot(centre - wall.start) / along.squaredNorm(), 0.0, 1.0);
        return (wall.start + s * along - centre).norm() <= size();
    }
    void move(double dt) override {
        const Segment motion{ball.position, ball.position + dt * ball.velocity};
        ball.position = motion.end;
        if (escaped) return;
        for (std::size_t i = 0; i < walls.size(); ++i) {
            if (!leads_out(ball.velocity, walls[i])) continue;
            if (touches(motion.end, walls[i])) {
                ball.velocity = reflected(ball.velocity, walls[i]);
                return; // it's been noticed
            }
            if (touches(motion.start, walls[i]) || !segments_intersect(motion, walls[i])) continue;
            const auto hit = intersect_lines(motion, walls[i]);
            marks.push_back({hit ? hit->point : motion.end, "missed"});
            escaped = true;
        }
    }
    bool is_lit_by(const Segment &motion, const Segment &wall) const override {
        return !escaped && !touches(motion.start, wall) && touches(motion.end, wall);
    }
    void gone() override { escaped = false; }

    void draw(Canvas &canvas) const override {
        draw_room(canvas);
        draw_prints(canvas);
        draw_ball(canvas);
        draw_marks(canvas);
    }
};
} // namespace play
