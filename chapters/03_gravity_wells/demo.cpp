#include "../demo.hpp"

#include "game.hpp"

#include <numbers>

//> The demo
namespace play {
using namespace gravity_wells;
using demo::Colour, demo::Input, demo::Shape;

enum Game { you_guess, ship_and_hole, falling, landing, circles, one_step, softened, integrators, comet };

const std::vector<std::string_view> with_engine{"ship and hole (3.1)", "four integrators (3.7)"};

const demo::About about{
    "Falling, and falling around.",
    {-16, -11},
    {16, 11},
    {demo::choice("The game",
                  {"you guess", "ship and hole (3.1)", "falling (3.2)", "landing (3.3)", "circles (3.4)", "steps (3.5)",
                   "softened (3.6)", "four integrators (3.7)", "Kepler (3.8)"},
                  you_guess),
     {"push", "m/s", 0, 20, 0.5, 5, {}, {"you guess", "steps (3.5)", "softened (3.6)", "four integrators (3.7)"}},
     {"height", "m", 0, 16, 0.5, 12, {}, {"falling (3.2)", "landing (3.3)"}},
     {"throw", "m/s", -4, 4, 0.5, 2, {}, {"falling (3.2)"}},
     {"frames per second", "", 1, 60, 1, 4, {}, {"landing (3.3)"}},
     {"distance", "m", 1.5, 10, 0.5, 8, {}, {"circles (3.4)"}},
     {"steps per second", "", 10, 120, 10, 60, {}, {"steps (3.5)", "four integrators (3.7)"}},
     {"softened by", "m", 0.5, 5, 0.5, 2, {}, {"softened (3.6)"}},
     {"integrator",
      "",
      0,
      3,
      1,
      0,
      {"explicit Euler", "semi-implicit Euler", "leapfrog", "Runge-Kutta"},
      {"four integrators (3.7)"}},
     {"eccentricity", "", 0, 0.95, 0.05, 0.5, {}, {"Kepler (3.8)"}}},
    {{"s", "Start again"},
     {"ArrowUp", "Engine: up", {"ship and hole (3.1)", "landing (3.3)", "four integrators (3.7)"}},
     {"ArrowLeft", "Engine: left", with_engine},
     {"ArrowDown", "Engine: down", with_engine},
     {"ArrowRight", "Engine: right", with_engine}}};
const demo::Still still{2.4};

constexpr double hole_radius = 0.6, ground = -9; // [m]
constexpr double burst = 2, engine = 16;         // one press of a key [m/s], and how fast it comes [m/s²]
constexpr double hold = 2;                       // so long the ship is held in place [s]
constexpr double semi_major = 8;                 // of the comet's ellipse [m]

struct State {
    Game game = you_guess;
    Ship ship;
    Fall lander;
    std::vector<Vec2> trail; ///< where it has been
    double nearest = 8, farthest = 8;
    Vec2 due{0, 0}; ///< what the engine has still to add to the velocity [m/s]
    double time{}, spare{};
    double around{}, since{}; ///< how long the last turn has taken, and when this one began [s]
    double chosen{};          ///< the sum of all controls at the start: if it changes, we begin again
    bool over{};              ///< swallowed, escaped, or landed
};

/// What a change of these begins anew: all controls but the integrator, which is switched in flight.
double choice_of(const Input &in) {
    double sum = 0, weight = 1;
    for (const demo::Control &each : in.controls)
        if (each.name != "integrator") sum += (weight *= 1.618) * each.value;
    return sum;
}

void start(State &now, const Input &in) {
    now = {};
    now.game = static_cast<Game>(in["The game"]);
    now.chosen = choice_of(in);
    double r = 8, push = in["push"];
    if (now.game == circles) {
        r = in["distance"];
        push = circular_orbit_speed(hole.mass, r, G);
    }
    if (now.game == ship_and_hole) push = 0;
    now.ship.state = {{r, 0}, {0, push}};
    now.nearest = now.farthest = r;
    now.lander = {in["height"], now.game == falling ? in["throw"] : 0, 0};
}

State begin() {
    State now;
    now.chosen = -1; // so that the first frame starts it
    return now;
}

/// How long a step of this game is [s].
double step_length(const State &now, const Input &in) {
    switch (now.game) {
    case landing: return 1 / in["frames per second"];
    case one_step:
    case integrators: return 1 / in["steps per second"];
    default: return frame_time;
    }
}

bool is_seen(const Vec2 &at) { return std::abs(at.x()) < about.high.x() && std::abs(at.y()) < about.high.y(); }

void fly(State &now, const Input &in, double dt) {
    motion::State &ship = now.ship.state;
    const double y = ship.position.y();
    switch (now.game) {
    case circles:
    case you_guess:
    case ship_and_hole:
        for (int part = 0; part < 4; ++part) next_frame(now.ship, dt / 4);
        break;
    case one_step: next_frame(ship, dt); break;
    case softened:
        ship.velocity += dt * softened_gravity(ship.position, mu, in["softened by"]);
        ship.position += dt * ship.velocity;
        break;
    case integrators: {
        const Integrators after = step_all({ship, ship, ship, ship}, mu, dt);
        const motion::State each[]{after.explicit_euler, after.semi_implicit, after.leapfrog, after.runge_kutta};
        ship = each[int(in["integrator"])];
        ship.velocity += dt * now.ship.thrust / now.ship.mass;
        break;
    }
    default: break;
    }
    const double r = ship.position.norm();
    now.nearest = std::min(now.nearest, r);
    now.farthest = std::max(now.farthest, r);
    const bool is_swallowed = r < hole_radius && now.game != softened;
    const bool has_escaped = (!is_seen(ship.position) && energy_of(ship) >= 0) || r > 1000;
    now.over = is_swallowed || has_escaped;
    if (y < 0 && ship.position.y() >= 0) {
        now.around = now.time - now.since;
        now.since = now.time;
    }
    now.trail.push_back(ship.position);
    if (now.trail.size() > 400) now.trail.erase(now.trail.begin());
}

double turn_of_comet() { return 2 * std::numbers::pi * std::sqrt(semi_major * semi_major * semi_major / mu); } // [s]

void one_step_of(State &now, const Input &in) {
    if (now.over && now.game == falling) return; // with the clock
    const double dt = step_length(now, in);
    now.time += dt;
    const Vec2 gain = now.due * std::min(1.0, engine * dt / std::max(now.due.norm(), 1e-9));
    now.due -= gain;
    now.ship.thrust = now.ship.mass / dt * gain;
    if (now.over) {
        if (now.game != landing && now.time > 2) start(now, in);
        return;
    }
    switch (now.game) {
    case falling: {
        const double predicted = time_to_fall(in["height"], in["throw"], moon_g);
        now.over = now.time >= predicted;
        now.time = std::min(now.time, predicted);
        now.lander.height = in["height"] + in["throw"] * now.time - moon_g * now.time * now.time / 2;
        break;
    }
    case landing:
        next_frame(now.lander, 0, dt);
        now.lander.height = std::max(now.lander.height, 0.0); // less is rounding
        now.over = now.lander.height == 0;
        now.trail.push_back({now.lander.time, now.lander.height});
        break;
    case comet: now.time = std::fmod(now.time, 1000 * turn_of_comet()); break;
    default:
        if (now.game == ship_and_hole && now.time <= hold) now.ship.state.velocity += gain;
        else fly(now, in, dt);
    }
    if (now.over && now.game != falling) now.time = 0;
}

State next(State now, const Input &in) {
    if (in.key == "s" || choice_of(in) != now.chosen) start(now, in);
    const Vec2 direction = in.key == "ArrowUp"     ? Vec2{0, 1}
                           : in.key == "ArrowDown" ? Vec2{0, -1}
                           : in.key == "ArrowLeft" ? Vec2{-1, 0}
                                                   : Vec2{1, 0};
    if (in.key.substr(0, 5) == "Arrow" && !now.over) {
        if (now.game == landing) now.lander.velocity += direction.y(); // a burn of 1 m/s
        now.due += burst * direction;
    }
    for (int due = demo::steps_due(now.spare, in, step_length(now, in)); due > 0; --due) one_step_of(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, std::vector<Vec2> points,
         double strength = 1) {
    seen.shapes.push_back({kind, colour, size, strength, std::move(points)});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words) {
    seen.shapes.push_back({Shape::words, Colour::dim, 0, 1, {at}, words});
}

void add_readout(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, value, decimals});
}

void draw_hole(demo::Picture &seen, double size) {
    add(seen, Shape::discs, Colour::violet, size + 0.35, {{0, 0}}, 0.35);
    add(seen, Shape::discs, Colour::violet, size, {{0, 0}});
    add_words(seen, {-1.1, -2.1}, "hole");
}

demo::Picture ship_near_hole(const State &now, const Input &in) {
    demo::Picture seen;
    const auto &[position, velocity] = now.ship.state;
    const double epsilon = in["softened by"];
    if (now.game == softened) add(seen, Shape::discs, Colour::violet, epsilon, {{0, 0}}, 0.2);
    else draw_hole(seen, hole_radius);
    if (now.trail.size() > 1) add(seen, Shape::line, Colour::blue, 1.5, now.trail);
    const Vec2 pull = now.over               ? Vec2{0, 0}
                      : now.game == softened ? softened_gravity(position, mu, epsilon)
                                             : gravity({position, 1}, hole, G);
    if (!now.over) {
        add(seen, Shape::discs, Colour::orange, 0.35, {position});
        if (velocity.norm() > 0) add(seen, Shape::arrow, Colour::blue, 2, {position, position + 0.3 * velocity});
        if (pull.norm() > 0)
            add(seen, Shape::arrow, Colour::green, 2,
                {position, position + 0.15 * pull / std::max(1.0, pull.norm() / 40)});
        if (now.due.norm() > 0) add(seen, Shape::line, Colour::amber, 6, {position, position - now.due});
        if (now.game == ship_and_hole && now.time <= hold) add_words(seen, {7, -2}, "held");
    }
    if (now.over || !is_seen(position))
        add_words(seen, {-3, 2}, is_seen(position) ? "swallowed" : now.over ? "escaped" : "out of the picture");
    const double r = position.norm();
    add_readout(seen, "distance", "m", r);
    add_readout(seen, "speed", "m/s", velocity.norm());
    switch (now.game) {
    case circles: add_readout(seen, "once around", "s", now.around); break;
    case you_guess:
    case ship_and_hole:
        add_readout(seen, "nearest", "m", now.nearest);
        add_readout(seen, "farthest", "m", now.farthest);
        add_readout(seen, "acceleration", "m/s²", pull.norm(), 1);
        break;
    case softened: add_readout(seen, "acceleration", "m/s²", pull.norm(), 1); break;
    default:
        add_readout(seen, "circular speed here", "m/s", circular_orbit_speed(hole.mass, r, G));
        add_readout(seen, "energy of each kg", "J", energy_of(now.ship.state));
        add_readout(seen, "angular momentum", "m²/s", position.x() * velocity.y() - position.y() * velocity.x(), 6);
    }
    return seen;
}

demo::Picture above_the_moon(const State &now, const Input &in) {
    demo::Picture seen;
    const double height = now.lander.height;
    add(seen, Shape::area, Colour::dim, 0, {{-16, -11}, {16, -11}, {16, ground}, {-16, ground}}, 0.4);
    add_words(seen, {-15, ground - 1.4}, "the Moon");
    const Vec2 feet{0, ground + height};
    if (now.game == falling) {
        add(seen, Shape::discs, Colour::orange, 0.5, {feet + Vec2{0, 0.5}});
        add_readout(seen, "clock", "s", now.time);
        add_readout(seen, "predicted", "s", time_to_fall(in["height"], in["throw"], moon_g));
        add_readout(seen, "height", "m", height);
        return seen;
    }
    for (const Vec2 &before : now.trail) // one for each frame
        add(seen, Shape::discs, Colour::dim, 0.12, {{4 + 1.2 * before.x(), ground + before.y()}});
    add(seen, Shape::line, Colour::ink, 3,
        {feet + Vec2{-1, 0}, feet + Vec2{-0.5, 0.8}, feet + Vec2{0.5, 0.8}, feet + Vec2{1, 0}});
    add(seen, Shape::area, Colour::blue, 0,
        {feet + Vec2{-0.7, 0.8}, feet + Vec2{0.7, 0.8}, feet + Vec2{0.4, 2}, feet + Vec2{-0.4, 2}}, 0.9);
    if (now.due.norm() > 0) add(seen, Shape::line, Colour::amber, 6, {feet + Vec2{0, 0.7}, feet + Vec2{0, -0.6}});
    if (now.over) add_words(seen, {-6, ground + 3}, now.lander.velocity > -2 ? "landed" : "too fast");
    add_readout(seen, "height", "m", height, 3);
    add_readout(seen, "velocity", "m/s", now.lander.velocity, 3);
    add_readout(seen, "time", "s", now.lander.time, 3);
    return seen;
}

demo::Picture comet_and_sun(const State &now, const Input &in) {
    demo::Picture seen;
    const double e = in["eccentricity"], turn = turn_of_comet();
    const auto at = [&](double part) -> Vec2 { return kepler_position(semi_major, e, mu, part * turn) + Vec2{2, 0}; };
    std::vector<Vec2> orbit, marks;
    for (int k = 0; k <= 96; ++k) orbit.push_back(at(k / 96.0));
    for (int k = 0; k < 12; ++k) marks.push_back(at(k / 12.0));
    for (const int k : {0, 6}) { // the same time, and the same area
        std::vector<Vec2> swept{{2, 0}};
        for (int i = 0; i <= 8; ++i) swept.push_back(at((k + i / 8.0) / 12));
        add(seen, Shape::area, Colour::green, 0, swept, 0.3);
    }
    add(seen, Shape::line, Colour::blue, 1.5, orbit);
    add(seen, Shape::discs, Colour::dim, 0.18, marks);
    add(seen, Shape::discs, Colour::amber, 0.6, {{2, 0}});
    const Vec2 comet_at = at(now.time / turn);
    add(seen, Shape::discs, Colour::orange, 0.35, {comet_at});
    add_readout(seen, "time", "turns", now.time / turn);
    add_readout(seen, "distance", "m", (comet_at - Vec2{2, 0}).norm());
    return seen;
}

demo::Picture draw(const State &now, const Input &in) {
    switch (now.game) {
    case falling:
    case landing: return above_the_moon(now, in);
    case comet: return comet_and_sun(now, in);
    default: return ship_near_hole(now, in);
    }
}
} // namespace play
