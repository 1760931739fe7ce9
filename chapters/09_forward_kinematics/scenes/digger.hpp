#pragma once
// A digger on a slope: whatever is dragged takes along what rides on it.
#include "shared.hpp"

namespace play {

struct DiggerScene : HoldScene {
    static constexpr std::string_view name = "a digger (9.2)";
    const Vec2 stone{3.5, 0.4}, teeth{0.5, -0.45};
    double spot = -3, slope = 0;                 ///< along the slope [m]; [rad]
    double boom = 50, stick = -70, shovel = -30; ///< as in a Link, but in degrees [°]
    double time = 0;                             ///< [s]

    DiggerScene() : HoldScene{{-7.4, -1.3}, {6, 6.3}, 5} { still_time = 1; }

    View view() const override { return {low, high, Stage::hills, -1}; }
    Vec2 along() const { return {std::cos(slope), std::sin(slope)}; }
    Parts parts() const {
        return parts_of({{along(), turned(along()), spot * along()},
                         {3.2, boom * degree},
                         {2.4, stick * degree},
                         {0.5, shovel * degree}});
    }
    Vec2 hinge() const { return in_world(parts().cab, {0.5, 1.2}); }
    /// Cab, slope, and the ends of boom, stick and bucket.
    void place_all() {
        const Parts now = parts();
        place({in_world(now.cab, {-1, 1}), 5.6 * along(), now.boom.origin, now.stick.origin,
               in_world(now.bucket, teeth)});
    }
    void begin() override { place_all(); }
    void take_over() override { spot = -3, boom = 50, stick = -70, shovel = -30; }

    void drag() override {
        HoldScene::drag();
        const Parts now = parts();
        const auto turned_by = [&](const Vec2 &joint, const Vec2 &end) {
            return turn(end - joint, holds[std::size_t(held)].at() - joint) / degree;
        };
        switch (held) {
        case 0: spot = std::clamp(holds[0].at().dot(along()) + 1, -5.0, 3.0); break;
        case 1:
            slope =
                std::clamp(std::atan2(holds[1].at().y(), std::max(holds[1].at().x(), 0.1)), -20 * degree, 20 * degree);
            break;
        case 2: boom = std::clamp(boom + turned_by(hinge(), now.boom.origin), 0.0, 90.0); break;
        case 3: stick = std::clamp(stick + turned_by(now.boom.origin, now.stick.origin), -150.0, 0.0); break;
        case 4:
            shovel = std::clamp(shovel + turned_by(now.stick.origin, in_world(now.bucket, teeth)), -120.0, 60.0);
            break;
        default: break;
        }
        place_all();
    }
    void step(double dt) override {
        if (!untouched) return;
        time += dt; // it stays away from the stone
        const double swing = std::sin(1.6 * time);
        spot = -3.2 + 1.7 * std::sin(0.8 * time), boom = 55 + 25 * swing, stick = -70 - 50 * swing;
        shovel = -30 + 50 * std::sin(2.3 * time);
        place_all();
    }

    void draw(Canvas &canvas) const override {
        const Parts now = parts();
        const Vec2 x = along(), y = turned(x), tip = in_world(now.bucket, teeth);
        canvas.body({-14 * x, 14 * x, 14 * x - 20 * y, -14 * x - 20 * y}, Colour::earth);
        canvas.ball(stone, 0.4, Colour::dim);
        const std::vector<Vec2> arm{hinge(), now.boom.origin, now.stick.origin};
        draw_cab(canvas, now.cab, arm);
        draw_part(canvas, now.bucket, Colour::ink, {{-0.6, 0.1}, {0.1, 0.15}, teeth, {0, -0.75}, {-0.55, -0.5}});
        canvas.balls(arm, 0.14, Colour::ink);
        const double off = (tip - stone).norm();
        canvas.dotted({tip, stone}, Colour::pink, 3);
        canvas.plate(stone + Vec2{1.15, 0.75}, number(off, 2, "m"), off < 0.1 ? Colour::green : Colour::pink, 24);
    }
};
} // namespace play
