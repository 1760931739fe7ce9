#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace trajectories;
using demo::Colour, demo::Input, demo::Shape;

enum Game { you_guess, flies, lands, ranges, apexes, dots, in_wind, terrace, aims, loops };

const std::vector<std::string_view> games{"you guess",     "it flies (4.1)",   "it lands (4.2)", "range (4.3)",
                                          "apex (4.4)",    "dotted arc (4.5)", "wind (4.6)",     "a terrace (4.7)",
                                          "it aims (4.8)", "frame loops (4.9)"};
/// All that fire where the dial points.
const std::vector<std::string_view> by_dial = [] {
    std::vector<std::string_view> all = games;
    all.erase(all.begin() + aims);
    return all;
}();

const demo::About about{"A cannon on the ground, or on a cliff.",
                        {-16, -7},
                        {92, 60.5},
                        {demo::choice("The game", games, you_guess),
                         {"angle", "°", -45, 90, 1, 20, {}, by_dial},
                         {"muzzle above the ground", "m", 0, 25, 5, 0},
                         {"speed", "m/s", 5, 25, 1, 25},
                         {"gravity", "m/s²", 5, 20, 1, 10},
                         {"wind", "m/s²", -2, 2, 0.5, -1, {}, {games[6]}},
                         {"height of the terrace", "m", 0, 30, 1, 15, {}, {games[7]}},
                         {"shot", "", 0, 1, 1, 0, {"the lower angle", "the higher angle"}, {games[8]}},
                         {"frames per second", "", 2, 30, 1, 2, {}, {games[9]}}},
                        {{"f", "Fire"}}};
const demo::Still still{1.7, "f"};

constexpr double terrace_begins = 30; // [m]
constexpr double dot_time = 0.2;      // from one dot to the next [s]

struct State {
    Game game = you_guess;
    motion::State shell{};     ///< the one that flies, or has landed
    motion::Integrators all{}; ///< the same by three frame loops
    bool flying = false, fired = false;
    double left{}; ///< until it lands [s]
    double time{}; ///< since it was fired [s]
    double spare{};
    std::vector<Vec2> trail{}, marks{}; ///< where it has been; where shells have landed
    Vec2 target{40, 15};
    Vec2 pointing{1, 0}; ///< where the cannon did, when the target was within reach
    double chosen = -1;  ///< the sum of all controls but the angle: if it changes, we begin again
};

State begin() { return {}; }

double choice_of(const Input &in) {
    double sum = 0, weight = 1;
    for (const demo::Control &each : in.controls)
        if (each.name != "angle" && each.name != "shot") sum += (weight *= 1.618) * each.value;
    return sum;
}

/// A shell at the muzzle, and what the dial shows.
struct Shot {
    motion::State muzzle;
    double angle_deg;
};

/// The shot as it is set now; a cannon that aims itself needs a target within its reach.
std::optional<Shot> shot_of(const State &now, const Input &in, bool other = false) {
    const Vec2 at{0, in["muzzle above the ground"]};
    double angle_deg = in["angle"];
    if (now.game == aims) {
        const std::vector<double> angles = launch_angles(in["speed"], now.target - at, in["gravity"]);
        if (angles.empty()) return {};
        angle_deg = (in["shot"] == 1) != other ? angles.back() : angles.front();
    }
    return Shot{{at, launch_velocity(in["speed"], angle_deg)}, angle_deg};
}

/// Whether the shell still rises at the end of its first frame, as 4.9 needs it.
bool loops_can_fly(const motion::State &muzzle, const Input &in) {
    return muzzle.velocity.y() > 1.01 * in["gravity"] / in["frames per second"];
}

Vec2 acceleration(const State &now, const Input &in) { return {now.game == in_wind ? in["wind"] : 0, -in["gravity"]}; }

void fire(State &now, const Input &in) {
    const std::optional<Shot> shot = shot_of(now, in);
    if (!shot || (now.game == loops && !loops_can_fly(shot->muzzle, in))) return;
    now.shell = shot->muzzle;
    now.all = {now.shell, now.shell, now.shell};
    now.left = now.game == flies ? 100 : time_of_flight(now.shell, in["gravity"]);
    now.flying = now.fired = true;
    now.time = now.spare = 0;
    now.trail = {now.shell.position};
}

void step_loops(State &now, const Input &in, double dt) {
    const motion::Integrators after = motion::step_all(now.all, acceleration(now, in), dt);
    now.flying = false;
    const auto move = [&](motion::State &shell, const motion::State &there) {
        if (shell.position.y() <= 0 && now.time > 0) return;
        shell = there;
        now.trail.push_back(shell.position);
        now.flying = now.flying || shell.position.y() > 0;
    };
    move(now.all.explicit_euler, after.explicit_euler);
    move(now.all.semi_implicit, after.semi_implicit);
    move(now.all.exact, after.exact);
    now.time += dt;
}

/// The ground, a wall or a terrace below the shell stops it.
void stop_at_terrace(State &now, const Vec2 &before, double height) {
    Vec2 &at = now.shell.position;
    if (at.x() < terrace_begins || at.y() > height) return;
    const double part = (before.y() - height) / (before.y() - at.y()); // of the frame, until it is at that height
    const double there = before.x() + part * (at.x() - before.x());
    at = before.y() > height && there >= terrace_begins ? Vec2{there, height} : Vec2{terrace_begins, at.y()};
    now.left = 0;
}

void step(State &now, const Input &in, double dt) {
    const Vec2 before = now.shell.position;
    dt = std::min(dt, now.left);
    now.shell = motion::accelerated_motion(now.shell, acceleration(now, in), dt);
    now.left -= dt;
    now.time += dt;
    if (now.game == flies && now.shell.position.y() < 0) now.left = 0; // only after the frame does it see that
    if (now.game == terrace) stop_at_terrace(now, before, in["height of the terrace"]);
    now.trail.push_back(now.shell.position);
    if (now.left > 0) return;
    now.flying = false;
    if (now.game < in_wind) now.marks.push_back(now.shell.position);
}

State next(State now, const Input &in) {
    if (choice_of(in) != now.chosen) {
        now = {.game = static_cast<Game>(in["The game"]),
               .target = now.target,
               .pointing = now.pointing,
               .chosen = choice_of(in)};
    }
    if (in.handle == 0) now.target = {std::clamp(in.pointer.x(), 4.0, 90.0), std::clamp(in.pointer.y(), 0.0, 55.0)};
    if (const std::optional<Shot> shot = shot_of(now, in)) now.pointing = shot->muzzle.velocity / in["speed"];
    if (in.key == "f") fire(now, in);
    const double dt = now.game == loops ? 1 / in["frames per second"] : now.game == flies ? 0.1 : frame_time;
    for (int due = demo::steps_due(now.spare, in, dt); due > 0 && now.flying; --due)
        now.game == loops ? step_loops(now, in, dt) : step(now, in, dt);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, std::vector<Vec2> points) {
    seen.shapes.push_back({kind, colour, size, 1, std::move(points)});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour = Colour::dim) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
void say(demo::Picture &seen, const char *name, const char *unit, double value) {
    seen.readouts.push_back({name, unit, value, 2});
}
void add_ground(demo::Picture &seen, double left, double right, double height) {
    seen.shapes.push_back(
        {Shape::area, Colour::dim, 0, 0.4, {{left, -7}, {right, -7}, {right, height}, {left, height}}});
}
void add_flag(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour) {
    add(seen, Shape::line, colour, 2, {at, at + Vec2{0, 3}});
    add_words(seen, at + Vec2{1, 2.5}, words, colour);
}

/// The whole arc of a shell that is fired now.
std::vector<Vec2> arc_of(const motion::State &muzzle, const Vec2 &pull, double time) {
    std::vector<Vec2> arc;
    for (int i = 0; i <= 40; ++i) arc.push_back(motion::accelerated_motion(muzzle, pull, i / 40.0 * time).position);
    return arc;
}

void draw_prediction(demo::Picture &seen, const State &now, const Input &in, const Shot &shot) {
    const motion::State &muzzle = shot.muzzle;
    const double pull = in["gravity"];
    switch (now.game) {
    case dots: add(seen, Shape::discs, Colour::blue, 0.5, dotted_arc(muzzle, pull, dot_time)); [[fallthrough]];
    case apexes: {
        const Vec2 top = apex(muzzle, pull);
        add(seen, Shape::discs, Colour::green, 0.9, {top});
        add_words(seen, top + Vec2{0, 2}, "apex", Colour::green);
        say(seen, "height of the apex", "m", top.y());
        [[fallthrough]];
    }
    case ranges: {
        const double there = range(muzzle, pull);
        add_flag(seen, {there, 0}, "range", Colour::violet);
        say(seen, "range", "m", there);
        break;
    }
    case in_wind: {
        const double there = range_in_wind(muzzle, pull, in["wind"]);
        add(seen, Shape::line, Colour::blue, -2, arc_of(muzzle, acceleration(now, in), time_of_flight(muzzle, pull)));
        add_flag(seen, {there, 0}, "range", Colour::violet);
        if (in["wind"] != 0) {
            add(seen, Shape::arrow, Colour::amber, 3, {{40, 55}, {40 + 8 * in["wind"], 55}});
            add_words(seen, {38, 57}, "wind", Colour::amber);
        }
        say(seen, "range", "m", there);
        say(seen, "time of flight", "s", time_of_flight(muzzle, pull));
        break;
    }
    case terrace: {
        const double height = in["height of the terrace"];
        const std::optional<double> there = range_at_height(muzzle, pull, height);
        if (there && *there >= terrace_begins) add_flag(seen, {*there, height}, "it comes down here", Colour::violet);
        else add_words(seen, {34, height + 4}, there ? "too short" : "too low");
        if (there) say(seen, "comes down at", "m", *there);
        break;
    }
    case aims:
        say(seen, "angle", "°", shot.angle_deg);
        for (const bool other : {true, false})
            if (const auto aimed = shot_of(now, in, other); aimed && aimed->muzzle.velocity.x() > 0)
                add(seen, Shape::line, other ? Colour::dim : Colour::blue, -2,
                    arc_of(aimed->muzzle, acceleration(now, in), now.target.x() / aimed->muzzle.velocity.x()));
        break;
    case loops:
        if (!loops_can_fly(muzzle, in)) {
            add_words(seen, {10, 50}, "Aim higher, or take more frames.");
        } else {
            const double right = range(muzzle, pull);
            const LoopRanges there = frame_loop_ranges(muzzle, pull, 1 / in["frames per second"]);
            add_flag(seen, {right, 0}, "range", Colour::ink);
            say(seen, "explicit Euler", "m", there.explicit_euler);
            say(seen, "semi-implicit Euler", "m", there.semi_implicit);
            say(seen, "exact steps", "m", there.exact);
            say(seen, "range", "m", right);
        }
        break;
    default: break;
    }
}

void draw_cannon(demo::Picture &seen, const State &now, const Input &in) {
    const Vec2 at{0, in["muzzle above the ground"]};
    add(seen, Shape::line, Colour::ink, 7, {at - 5 * now.pointing, at});
    if (const std::optional<Shot> shot = shot_of(now, in)) draw_prediction(seen, now, in, *shot);
    else add_words(seen, now.target + Vec2{-8, 4}, "out of reach");
    if (now.game == aims) {
        add_words(seen, now.target + Vec2{2, 1}, "target");
        say(seen, "target x", "m", now.target.x());
        say(seen, "target y", "m", now.target.y());
        seen.shapes.push_back({Shape::handle, Colour::orange, 0, 1, {now.target}});
    }
}

void draw_shell(demo::Picture &seen, const State &now) {
    const auto &[at, velocity] = now.shell;
    if (now.trail.size() > 1) add(seen, Shape::line, Colour::orange, 1.5, now.trail);
    add(seen, Shape::discs, Colour::orange, 1, {at});
    if (now.game == flies) {
        add(seen, Shape::arrow, Colour::blue, 2, {at, at + 0.5 * velocity});
        say(seen, "to the right", "m/s", velocity.x());
        say(seen, "upwards", "m/s", velocity.y());
    }
    if (at.x() > 92 || at.x() < -16) add_words(seen, {30, 40}, "out of the picture");
    if (now.game == lands) {
        say(seen, "clock", "s", now.time);
        say(seen, "left", "s", now.left);
    }
    if (now.game != aims) say(seen, now.flying ? "shell is at" : "shell landed at", "m", at.x());
}

void add_loop(demo::Picture &seen, const Vec2 &shell, const char *words, Colour colour, double height) {
    add(seen, Shape::discs, colour, 1, {shell});
    add_words(seen, {-13, height}, words, colour);
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    const double height = in["muzzle above the ground"];
    const double far = now.game == terrace ? in["height of the terrace"] : 0;
    add_ground(seen, -16, 0, std::max(0.0, height - 1));
    add_ground(seen, 0, terrace_begins, 0);
    add_ground(seen, terrace_begins, 92, far);
    if (now.game == terrace) add_words(seen, {60, far - 5}, "terrace");
    else add_words(seen, {8, -5}, "ground");
    if (height > 0) add_words(seen, {-13, height - 5}, "cliff");
    if (!now.marks.empty()) add(seen, Shape::discs, Colour::dim, 0.8, now.marks);
    draw_cannon(seen, now, in);
    if (!now.fired) return seen;
    if (now.game == loops) {
        add(seen, Shape::discs, Colour::dim, 0.4, now.trail);
        const auto &[euler, semi, exact] = now.all;
        add_loop(seen, euler.position, "explicit Euler", Colour::orange, 57);
        add_loop(seen, semi.position, "semi-implicit Euler", Colour::violet, 53);
        add_loop(seen, exact.position, "exact steps", Colour::blue, 49);
    } else {
        draw_shell(seen, now);
    }
    return seen;
}
} // namespace play
