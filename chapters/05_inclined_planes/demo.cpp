#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace inclined_planes;
using demo::Colour, demo::Input, demo::Shape;

enum Game { you_guess, slows, stops, presses, slides, critical, hockey, climbs, slips };

const std::vector<std::string_view> games{"you guess",          "it slows (5.1)",    "it stops (5.2)",
                                          "normal force (5.3)", "it slides (5.4)",   "critical angle (5.5)",
                                          "air hockey (5.6)",   "up and back (5.7)", "stick and slip (5.8)"};
const std::vector<std::string_view> on_a_board{games[0], games[3], games[4], games[5], games[7]};
const std::vector<std::string_view> with_pucks{games[1], games[2]};

const demo::About about{"A box on a board, a puck on a table, and a block on a spring.",
                        {-10, -1.5},
                        {10, 10},
                        {demo::choice("The game", games, you_guess),
                         {"mass", "kg", 5, 50, 5, 10, {}, {games[0], games[3], games[4]}},
                         {"velocity", "m/s", -6, 6, 0.5, 6, {}, with_pucks},
                         {"deceleration", "m/s²", 2, 6, 0.5, 2, {}, with_pucks},
                         {"speed", "m/s", 1, 6, 0.5, 6, {}, {games[6], games[7]}},
                         {"mu_s", "", 0.1, 2, 0.1, 0.5, {}, {games[5]}},
                         {"mu_k", "", 0.05, 0.5, 0.05, 0.1, {}, {games[6], games[7]}},
                         {"pulled at", "m/s", 0.1, 1, 0.1, 0.2, {}, {games[8]}}},
                        {{"u", "Raise", on_a_board},
                         {"d", "Lower", on_a_board},
                         {"b", "Put the box back", {games[0], games[4], games[5]}},
                         {"f", "Push", {games[1], games[2], games[6], games[7]}}}};
const demo::Still still{1.6, "f"};

constexpr double length = 9, top = 6.5, longest = 8; // of the board, and how far up the box lies at first [m]
constexpr int parts = 16;                            // of each frame, so that the last one is short
constexpr double wide = 8.5, high = 8, round = 0.4;  // half of the table, its depth, and a puck's radius [m]
const Vec2 foot{-5, 0};                              // of the board [m]

struct State {
    Game game = you_guess;
    int angle_deg = 10; ///< of the board
    Sliding box{};
    bool gone = false, moving = false, pushed = false; ///< the box is off the board; something moves; has been pushed
    motion::State puck{}, per_axis{};
    double way{}; ///< of the puck [m]
    std::vector<Vec2> trail{}, other_trail{};
    Vec2 aim{4, 6};
    Pulled pulled{0, 0, 0.3};
    double now_stuck{},
        stuck_last = -1; ///< for how long the block sticks now, and did the last time [s]; -1: before it has slipped
    double back{};       ///< the speed of the box when it came back [m/s]
    double spare{};
    double chosen = -1; ///< the sum of all controls: if it changes, we begin again
};

State begin() { return {}; }

double choice_of(const Input &in) {
    double sum = 0, weight = 1;
    for (const demo::Control &each : in.controls) sum += (weight *= 1.618) * each.value;
    return sum;
}

bool on_board(Game game) { return game == you_guess || (game >= presses && game <= critical) || game == climbs; }

Box box_of(const State &now, const Input &in) {
    if (now.game == critical) return {10, in["mu_s"], 0.6 * in["mu_s"]};
    if (now.game == climbs) return {10, 0.5, in["mu_k"]};
    return {in["mass"], 0.5, 0.3};
}

double angle_of(const State &now) { return now.angle_deg * degree; }
/// A unit vector up the board.
Vec2 along(const State &now) { return {std::cos(angle_of(now)), std::sin(angle_of(now))}; }
/// How much of its speed the puck loses each second [m/s²].
double loss_of(const State &now, const Input &in) { return now.game == hockey ? in["mu_k"] * g : in["deceleration"]; }

const Vec2 start{-6, 1.5}; // of the puck on the table [m]

void put_back(State &now) {
    now.box = {};
    now.gone = now.moving = now.pushed = false;
}

void push(State &now, const Input &in) {
    if (now.game == climbs) {
        if (up_and_back(box_of(now, in), in["speed"], angle_of(now), g).up > longest) return;
        put_back(now);
        now.box.speed = -in["speed"];
    } else {
        const Vec2 velocity =
            now.game == hockey ? Vec2{in["speed"] * (now.aim - start).normalized()} : Vec2{in["velocity"], 0};
        now.puck = now.per_axis = {now.game == hockey ? start : Vec2{0, 1}, velocity};
        now.trail = now.other_trail = {now.puck.position};
        now.way = 0;
    }
    now.moving = now.pushed = true;
}

/// Off the borders of the table, if the puck moves towards them.
void bounce(motion::State &puck) {
    auto &[at, velocity] = puck;
    const double side = wide - round;
    if (std::abs(at.x()) > side && at.x() * velocity.x() > 0) velocity.x() = -velocity.x();
    if ((at.y() < round && velocity.y() < 0) || (at.y() > high - round && velocity.y() > 0))
        velocity.y() = -velocity.y();
}

void step_puck(State &now, const Input &in, double dt) {
    const double loss = loss_of(now, in);
    const Vec2 before = now.puck.position;
    if (now.game == slows) {
        now.puck = motion::accelerated_motion(now.puck, {in["velocity"] < 0 ? loss : -loss, 0}, dt);
    } else if (now.game == stops) {
        const double velocity = now.puck.velocity.x(), after = apply_friction(velocity, loss, dt);
        now.puck = {before + Vec2{(velocity + after) / 2 * dt, 0}, {after, 0}};
    } else {
        next_frame(now.puck, loss, dt);
        const Vec2 old = now.per_axis.velocity; // in print, as if each axis had a friction of its own
        const auto slower = [&](double v) { return std::copysign(std::max(0.0, std::abs(v) - loss * dt), v); };
        now.per_axis.velocity = {slower(old.x()), slower(old.y())};
        now.per_axis.position += (old + now.per_axis.velocity) / 2 * dt;
        bounce(now.puck);
        bounce(now.per_axis);
    }
    now.way += (now.puck.position - before).norm();
    if (std::abs(now.puck.position.x()) > 10) now.moving = false;
}

void step_box(State &now, const Input &in, double dt) {
    const auto [way, speed] = now.box;
    next_frame_up(now.box, box_of(now, in), angle_of(now), dt);
    now.gone = now.box.way >= (now.game == climbs ? 0 : top);
    if (!now.gone) return;
    now.moving = false;
    now.back = speed + way / (way - now.box.way) * (now.box.speed - speed); // if it came back, just at the foot
    if (now.game == climbs) now.box = {};
}

void step_block(State &now, const Input &in, double dt) {
    now.pulled = stick_slip_step(now.pulled, block, {spring.stiffness, in["pulled at"]}, g, dt);
    if (now.pulled.velocity == 0) now.now_stuck += dt;
    else if (now.now_stuck > 0) now.stuck_last = now.stuck_last < 0 ? 0 : now.now_stuck, now.now_stuck = 0;
}

void step(State &now, const Input &in) {
    const double dt = frame_time / parts;
    for (int i = 0; i < parts; ++i) {
        if (now.game == slips) step_block(now, in, dt);
        else if (on_board(now.game) && now.game != presses && !now.gone && (now.game != climbs || now.moving))
            step_box(now, in, dt);
        else if (!on_board(now.game) && now.moving) step_puck(now, in, dt);
    }
    if (now.game == hockey && now.moving) {
        now.trail.push_back(now.puck.position);
        now.other_trail.push_back(now.per_axis.position);
    }
    if (now.game == slips) {
        now.trail.push_back({now.pulled.stretch, now.pulled.velocity});
        if (now.trail.size() > 600) now.trail.erase(now.trail.begin());
    }
}

State next(State now, const Input &in) {
    if (choice_of(in) != now.chosen) {
        const bool same = static_cast<Game>(in["The game"]) == now.game;
        now = {.game = static_cast<Game>(in["The game"]),
               .angle_deg = same ? now.angle_deg : 10,
               .aim = now.aim,
               .chosen = choice_of(in)};
    }
    int angle_deg = now.angle_deg + (in.key == "u") - (in.key == "d");
    if (in.handle == 0 && on_board(now.game)) {
        const Vec2 there = in.pointer - foot;
        angle_deg = there.x() <= 0 ? 90 : int(std::atan(std::max(0.0, there.y() / there.x())) / degree + 0.5);
    } else if (in.handle == 0) {
        now.aim = {std::clamp(in.pointer.x(), -wide, wide), std::clamp(in.pointer.y(), 0.0, high)};
    }
    angle_deg = std::clamp(angle_deg, 0, 90);
    if (now.game == climbs && angle_deg != now.angle_deg) put_back(now);
    now.angle_deg = angle_deg;
    if (in.key == "b") put_back(now);
    if (in.key == "f" && (now.game == climbs || !on_board(now.game)) && now.game != slips) push(now, in);
    for (int due = demo::steps_due(now.spare, in, frame_time); due > 0; --due) step(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, std::vector<Vec2> points) {
    seen.shapes.push_back({kind, colour, size, 1, std::move(points)});
}
/// A line or an arrow from one point to another.
void join(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const Vec2 &from, const Vec2 &to) {
    add(seen, kind, colour, size, {from, to});
}
void add_disc(demo::Picture &seen, Colour colour, double radius, const Vec2 &at) {
    add(seen, Shape::discs, colour, radius, {at});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour = Colour::dim) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, value, decimals});
}
void add_ground(demo::Picture &seen) {
    seen.shapes.push_back({Shape::area, Colour::dim, 0, 0.4, {{-10, -1.5}, {10, -1.5}, {10, 0}, {-10, 0}}});
}
void add_flag(demo::Picture &seen, const Vec2 &at, const char *words) {
    join(seen, Shape::line, Colour::violet, 2, at, at + Vec2{0, 1.6});
    add_words(seen, at + Vec2{-1, 1.6}, words, Colour::violet);
}

/// The corners of a box of 1.4 m by 1 m whose middle of the base is here.
std::vector<Vec2> corners(const Vec2 &at, const Vec2 &to) {
    const Vec2 up{-to.y(), to.x()};
    return {at - 0.7 * to, at + 0.7 * to, at + 0.7 * to + up, at - 0.7 * to + up};
}

void draw_forces(demo::Picture &seen, const State &now, const Input &in, const Vec2 &middle) {
    const double weight = in["mass"] * g, normal = normal_force(in["mass"], angle_of(now), g);
    const Vec2 up = along(now), out{-up.y(), up.x()};
    join(seen, Shape::arrow, Colour::ink, 3, middle, middle - Vec2{0, 3});
    add_words(seen, middle + Vec2{0.2, -2.8}, "weight", Colour::ink);
    join(seen, Shape::arrow, Colour::blue, 3, middle, middle + 3 * normal / weight * out);
    add_words(seen, middle + (3 * normal / weight + 0.5) * out, "normal force", Colour::blue);
    join(seen, Shape::arrow, Colour::pink, 3, middle, middle - 3 * up.y() * up);
    if (now.angle_deg > 8) add_words(seen, middle - (3 * up.y() + 1.6) * up + Vec2{-0.6, 0.4}, "pull", Colour::pink);
    say(seen, "weight", "N", weight, 1);
    say(seen, "normal force", "N", normal, 1);
    say(seen, "pull", "N", weight * up.y(), 1);
}

void draw_climb(demo::Picture &seen, const State &now, const Input &in) {
    const UpAndBack there = up_and_back(box_of(now, in), in["speed"], angle_of(now), g);
    if (there.up > longest) {
        add_words(seen, {-2, 9}, "It would slide off this board.");
        return;
    }
    add_flag(seen, foot + (there.up + 0.7) * along(now), "5.7"); // where the middle of the box will be
    say(seen, "up (5.7)", "m", there.up);
    say(seen, "back (5.7)", "m/s", there.back);
    if (now.pushed && now.gone) say(seen, "came back at", "m/s", now.back);
    else if (now.pushed) say(seen, "box is at", "m", -now.box.way);
}

void draw_board(demo::Picture &seen, const State &now, const Input &in) {
    add_ground(seen);
    const Vec2 up = along(now), end = foot + length * up;
    if (now.game == critical) {
        const double angle = critical_angle(in["mu_s"]);
        join(seen, Shape::line, Colour::violet, -2, foot, foot + length * Vec2{std::cos(angle), std::sin(angle)});
        say(seen, "critical angle (5.5)", "°", angle / degree);
    }
    join(seen, Shape::line, Colour::ink, 4, foot, end);
    say(seen, "angle", "°", now.angle_deg, 0);
    if (now.game == climbs) draw_climb(seen, now, in);
    const Box box = box_of(now, in);
    const double from_foot = now.game == climbs ? 0.7 - now.box.way : top + 0.7 - now.box.way;
    if (!now.gone || now.game == climbs) {
        const Vec2 at = foot + from_foot * up;
        add(seen, Shape::area, Colour::orange, 0, corners(at, up));
        if (now.game == presses) draw_forces(seen, now, in, at + 0.5 * Vec2{-up.y(), up.x()});
    } else {
        add(seen, Shape::area, Colour::orange, 0, corners(foot - Vec2{1.2, 0}, {1, 0}));
    }
    if (now.game == slides || now.game == critical) {
        say(seen, "if put down (5.4)", "m/s²", incline_acceleration(box, angle_of(now), g));
        if (!now.gone) say(seen, "speed", "m/s", now.box.speed);
    }
    if (now.game != presses && now.game != climbs)
        add_words(seen, {-9.5, 9.3}, now.gone ? "It is down." : now.box.speed > 0 ? "It slides." : "It stays.");
    seen.shapes.push_back({Shape::handle, Colour::blue, 0, 1, {end}});
}

void draw_line(demo::Picture &seen, const State &now, const Input &in) {
    add_ground(seen);
    const double stop = stopping_distance(in["velocity"], in["deceleration"]);
    add_flag(seen, {stop, 0}, "5.1");
    add_disc(seen, Colour::orange, 0.5, {now.pushed ? now.puck.position.x() : 0, 0.5});
    say(seen, "stops at (5.1)", "m", stop);
    if (!now.pushed) return;
    say(seen, "puck is at", "m", now.puck.position.x());
    say(seen, "velocity", "m/s", now.puck.velocity.x());
    if (std::abs(now.puck.position.x()) > 10) add_words(seen, {-3, 6}, "out of the picture");
}

void draw_table(demo::Picture &seen, const State &now, const Input &in) {
    add(seen, Shape::line, Colour::ink, 3, {{-wide, 0}, {wide, 0}, {wide, high}, {-wide, high}, {-wide, 0}});
    if (now.pushed) {
        add(seen, Shape::line, Colour::dim, -1.5, now.other_trail);
        add(seen, Shape::line, Colour::orange, 1.5, now.trail);
        add_disc(seen, Colour::dim, round, now.per_axis.position);
        add_words(seen, now.per_axis.position + Vec2{-0.7, -0.9}, "per axis");
    }
    add_disc(seen, Colour::orange, round, now.pushed ? now.puck.position : start);
    say(seen, "deceleration", "m/s²", loss_of(now, in));
    say(seen, "stops after (5.1)", "m", stopping_distance(in["speed"], loss_of(now, in)));
    if (now.pushed) {
        say(seen, "puck has slid", "m", now.way);
        say(seen, "its speed", "m/s", now.puck.velocity.norm());
    }
    add_words(seen, now.aim + Vec2{0.4, 0.4}, "aim");
    seen.shapes.push_back({Shape::handle, Colour::blue, 0, 1, {now.aim}});
}

void draw_block(demo::Picture &seen, const State &now) {
    add_ground(seen);
    const double hand = now.pulled.position + now.pulled.stretch; // stays where it is in the picture: we go with it
    for (int i = -3; i <= 3; ++i) {
        const double mark = (std::floor(hand) + i - hand) * 4 + 6;
        if (std::abs(mark) < 10) join(seen, Shape::line, Colour::ink, 1, {mark, -0.4}, {mark, 0});
    }
    const Vec2 at{1 - 4 * now.pulled.stretch, 0};
    add(seen, Shape::area, Colour::orange, 0, corners(at, {1, 0}));
    std::vector<Vec2> coil{at + Vec2{0.7, 0.5}};
    for (int i = 0; i <= 20; ++i) coil.push_back({at.x() + 0.9 + (4.9 - at.x()) * i / 20.0, i % 2 == 0 ? 0.3 : 0.7});
    coil.push_back({6, 0.5});
    add(seen, Shape::line, Colour::ink, 1.5, coil);
    join(seen, Shape::arrow, Colour::blue, 3, {6, 0.5}, {7.5, 0.5});
    const auto seen_at = [](const Vec2 &point) { return Vec2{-8 + 12 * point.x(), 3 + 3 * point.y()}; };
    join(seen, Shape::line, Colour::dim, 1, seen_at({0, 0}), seen_at({0, 2}));
    join(seen, Shape::line, Colour::dim, 1, seen_at({0, 0}), seen_at({1.2, 0}));
    add_words(seen, seen_at({0, 2}) + Vec2{0.2, 0.2}, "velocity");
    add_words(seen, seen_at({1, 0}) + Vec2{0, 0.3}, "stretch");
    std::vector<Vec2> loop;
    for (const Vec2 &point : now.trail) loop.push_back(seen_at(point));
    if (loop.size() > 1) add(seen, Shape::line, Colour::orange, 1.5, loop);
    add_disc(seen, Colour::orange, 0.15, seen_at({now.pulled.stretch, now.pulled.velocity}));
    add_words(seen, {3, 9}, now.pulled.velocity == 0 ? "It sticks." : "It slips.");
    say(seen, "stretch", "m", now.pulled.stretch);
    say(seen, "spring pulls with", "N", spring.stiffness * now.pulled.stretch);
    say(seen, "velocity", "m/s", now.pulled.velocity);
    if (now.stuck_last > 0) say(seen, "stuck last time for", "s", now.stuck_last);
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    if (on_board(now.game)) draw_board(seen, now, in);
    else if (now.game == hockey) draw_table(seen, now, in);
    else if (now.game == slips) draw_block(seen, now);
    else draw_line(seen, now, in);
    return seen;
}
} // namespace play
