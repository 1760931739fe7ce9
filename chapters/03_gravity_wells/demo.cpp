#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace gravity_wells;
using demo::Colour, demo::Input, demo::Shape;

enum Game { you_guess, ship_and_hole, falling, landing, circles, one_step, softened, integrators, comet };

const std::vector<std::string_view> with_engine{"ship and hole (3.1)", "four integrators (3.7)"};

const demo::About about{
    "A ship near a black hole.",
    {-16, -11},
    {16, 11},
    {demo::choice("The game",
                  {"you guess", "ship and hole (3.1)", "falling (3.2)", "landing (3.3)", "circles (3.4)", "steps (3.5)",
                   "softened (3.6)", "four integrators (3.7)", "Kepler (3.8)"},
                  you_guess),
     {"push", "m/s", 0, 16, 0.5, 5, {}, {"you guess", "steps (3.5)", "softened (3.6)", "four integrators (3.7)"}},
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
constexpr double burn_time = 0.25;               // for one press of a key [s]
constexpr double burn_force = 16;                // 2 kg get 2 m/s faster with each burn [N]
constexpr double hold = 2;                       // so long the ship hangs still, if nobody fires [s]
constexpr double semi_major = 8;                 // of the comet's ellipse [m]

struct State {
    Game game = you_guess;
    Ship ship;
    Fall lander;
    std::vector<Vec2> trail; ///< where it has been
    double nearest = 8, farthest = 8;
    double burning{}; ///< for how much longer [s]
    double time{}, spare{};
    double chosen{}; ///< the sum of all controls at the start: if it changes, we begin again
    bool over{};     ///< swallowed, or landed
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

void fly(State &now, const Input &in, double dt) {
    motion::State &ship = now.ship.state;
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
    if (r < hole_radius && now.game != softened) now.over = true;
    if (ship.position.cwiseAbs().maxCoeff() > 1000) now.over = true; // it has escaped
    now.trail.push_back(ship.position);
    if (now.trail.size() > 400) now.trail.erase(now.trail.begin());
}

void one_step_of(State &now, const Input &in) {
    const double dt = step_length(now, in);
    now.time += dt;
    now.burning -= dt;
    if (now.burning <= 0) now.ship.thrust = {0, 0};
    if (now.over) {
        if (now.game != landing && now.game != falling && now.time > 2) start(now, in);
        return;
    }
    switch (now.game) {
    case falling:
        if (now.time >= time_to_fall(in["height"], in["throw"], moon_g)) {
            now.time = time_to_fall(in["height"], in["throw"], moon_g);
            now.over = true;
        }
        now.lander.height = in["height"] + in["throw"] * now.time - moon_g * now.time * now.time / 2;
        break;
    case landing:
        next_frame(now.lander, 0, dt);
        now.lander.height = std::max(now.lander.height, 0.0); // less is rounding
        now.over = now.lander.height == 0;
        now.trail.push_back({now.lander.time, now.lander.height});
        break;
    case comet: break;
    default:
        if (now.game != ship_and_hole || now.time > hold) fly(now, in, dt);
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
        const Vec2 thrust = burn_force * direction;
        now.burning = (thrust == now.ship.thrust ? now.burning : 0) + burn_time;
        now.ship.thrust = thrust;
        now.time = std::max(now.time, hold);
    }
    for (int due = demo::steps_due(now.spare, in, step_length(now, in)); due > 0; --due) one_step_of(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, std::vector<Vec2> points) {
    seen.shapes.push_back({kind, colour, size, 1, std::move(points)});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words) {
    seen.shapes.push_back({Shape::words, Colour::dim, 0, 1, {at}, words});
}

void draw_hole(demo::Picture &seen, double size) {
    seen.shapes.push_back({Shape::discs, Colour::violet, size + 0.35, 0.35, {{0, 0}}});
    add(seen, Shape::discs, Colour::violet, size, {{0, 0}});
    add_words(seen, {-1.1, -2.1}, "hole");
}

double energy_of(const motion::State &ship) { return ship.velocity.squaredNorm() / 2 - mu / ship.position.norm(); }

demo::Picture ship_near_hole(const State &now, const Input &in) {
    demo::Picture seen;
    const auto &[position, velocity] = now.ship.state;
    const double epsilon = in["softened by"];
    if (now.game == softened) seen.shapes.push_back({Shape::discs, Colour::violet, epsilon, 0.2, {{0, 0}}});
    else draw_hole(seen, hole_radius);
    if (now.trail.size() > 1) add(seen, Shape::line, Colour::blue, 1.5, now.trail);
    const Vec2 pull = now.over               ? Vec2{0, 0}
                      : now.game == softened ? softened_gravity(position, mu, epsilon)
                                             : gravity({position, 1}, hole, G);
    if (!now.over) {
        add(seen, Shape::discs, Colour::orange, 0.35, {position});
        add(seen, Shape::arrow, Colour::blue, 2, {position, position + 0.3 * velocity});
        if (pull.norm() > 0)
            add(seen, Shape::arrow, Colour::green, 2,
                {position, position + 0.15 * pull / std::max(1.0, pull.norm() / 40)});
        if (now.burning > 0) add(seen, Shape::line, Colour::amber, 6, {position, position - 0.15 * now.ship.thrust});
    } else {
        add_words(seen, {-3, 2}, position.norm() < 9 ? "swallowed" : "escaped");
    }
    const double r = position.norm();
    seen.readouts = {{"distance", "m", r, 2}, {"speed", "m/s", velocity.norm(), 2}};
    switch (now.game) {
    case circles:
    case you_guess:
    case ship_and_hole:
        seen.readouts.push_back({"nearest", "m", now.nearest, 2});
        seen.readouts.push_back({"farthest", "m", now.farthest, 2});
        seen.readouts.push_back({"acceleration", "m/s²", pull.norm(), 1});
        break;
    case softened: seen.readouts.push_back({"acceleration", "m/s²", pull.norm(), 1}); break;
    default:
        seen.readouts.push_back({"circular speed here", "m/s", circular_orbit_speed(hole.mass, r, G), 2});
        seen.readouts.push_back({"energy of each kg", "J", energy_of(now.ship.state), 2});
        seen.readouts.push_back(
            {"angular momentum", "m²/s", position.x() * velocity.y() - position.y() * velocity.x(), 6});
    }
    return seen;
}

demo::Picture above_the_moon(const State &now, const Input &in) {
    demo::Picture seen;
    const double height = now.lander.height;
    seen.shapes.push_back({Shape::area, Colour::dim, 0, 0.4, {{-16, -11}, {16, -11}, {16, ground}, {-16, ground}}});
    add_words(seen, {-15, ground - 1.4}, "the Moon");
    const Vec2 feet{0, ground + height};
    if (now.game == falling) {
        add(seen, Shape::discs, Colour::orange, 0.5, {feet + Vec2{0, 0.5}});
        seen.readouts = {{"clock", "s", now.time, 2},
                         {"predicted", "s", time_to_fall(in["height"], in["throw"], moon_g), 2},
                         {"height", "m", height, 2}};
        return seen;
    }
    for (const Vec2 &before : now.trail) // one for each frame
        seen.shapes.push_back({Shape::discs, Colour::dim, 0.12, 1, {{4 + 1.2 * before.x(), ground + before.y()}}});
    add(seen, Shape::line, Colour::ink, 3,
        {feet + Vec2{-1, 0}, feet + Vec2{-0.5, 0.8}, feet + Vec2{0.5, 0.8}, feet + Vec2{1, 0}});
    seen.shapes.push_back({Shape::area,
                           Colour::blue,
                           0,
                           0.9,
                           {feet + Vec2{-0.7, 0.8}, feet + Vec2{0.7, 0.8}, feet + Vec2{0.4, 2}, feet + Vec2{-0.4, 2}}});
    if (now.burning > 0) add(seen, Shape::line, Colour::amber, 6, {feet + Vec2{0, 0.7}, feet + Vec2{0, -0.6}});
    if (now.over) add_words(seen, {-6, ground + 3}, now.lander.velocity > -2 ? "landed" : "too fast");
    seen.readouts = {
        {"height", "m", height, 3}, {"velocity", "m/s", now.lander.velocity, 3}, {"time", "s", now.lander.time, 3}};
    return seen;
}

demo::Picture comet_and_sun(const State &now, const Input &in) {
    demo::Picture seen;
    const double e = in["eccentricity"],
                 turn = 2 * 3.141592653589793 * std::sqrt(semi_major * semi_major * semi_major / mu);
    const auto at = [&](double part) -> Vec2 { return kepler_position(semi_major, e, mu, part * turn) + Vec2{2, 0}; };
    std::vector<Vec2> orbit, marks;
    for (int k = 0; k <= 96; ++k) orbit.push_back(at(k / 96.0));
    for (int k = 0; k < 12; ++k) marks.push_back(at(k / 12.0));
    for (const int k : {0, 6}) { // the same time, and the same area
        std::vector<Vec2> swept{{2, 0}};
        for (int i = 0; i <= 8; ++i) swept.push_back(at((k + i / 8.0) / 12));
        seen.shapes.push_back({Shape::area, Colour::green, 0, 0.3, swept});
    }
    add(seen, Shape::line, Colour::blue, 1.5, orbit);
    add(seen, Shape::discs, Colour::dim, 0.18, marks);
    seen.shapes.push_back({Shape::discs, Colour::amber, 0.6, 1, {{2, 0}}});
    const Vec2 comet_at = at(now.time / turn);
    add(seen, Shape::discs, Colour::orange, 0.35, {comet_at});
    seen.readouts = {{"time", "turns", now.time / turn, 2}, {"distance", "m", (comet_at - Vec2{2, 0}).norm(), 2}};
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
