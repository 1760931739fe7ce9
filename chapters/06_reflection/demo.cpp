#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace reflection;
using demo::Colour, demo::Input, demo::Shape;

enum Game { you_guess, on_screen, off_wall, two_ends, rough, turned_box, pool };

const std::vector<std::string_view> games{"you guess",        "a screen (6.1)",   "a wall (6.2)",   "two ends (6.3)",
                                          "rough wall (6.4)", "turned box (6.5)", "bank shot (6.6)"};
const std::vector<std::string_view> on_walls{games[2], games[3], games[4]};

const demo::About about{"A ball on a screen, a wall that one turns, and a pool table.",
                        {-8.5, -5},
                        {8.5, 5},
                        {demo::choice("The game", games, you_guess),
                         {"speed", "m/s", 1, 10, 0.5, 5, {}, {games[1], games[2], games[3], games[4], games[5]}},
                         {"radius", "m", 0, 2, 0.25, 0.5, {}, {games[1], games[5]}},
                         {"restitution", "", 0, 1, 0.1, 0.5, {}, {games[4]}},
                         {"mu_k", "", 0, 1, 0.1, 0.3, {}, {games[4]}},
                         {"across", "", -1, 1, 1, 0, {}, {games[6]}},
                         {"up", "", -1, 1, 1, 0, {}, {games[6]}}},
                        {{"f", "Roll", {games[0], games[6]}},
                         {"l", "One long frame", {games[1]}},
                         {"u", "Turn left", {games[2], games[4], games[5]}},
                         {"d", "Turn right", {games[2], games[4], games[5]}}}};
const demo::Still still{1.4, "f"};

const Box whole{{-8, -4.5}, {8, 4.5}}, turning{{-4, -2.5}, {4, 2.5}}, table{{-2.875, -1.725}, {2.875, 1.725}};
const Ball cue{{-1.955, -0.92}, {0, 0}, 0.23};
const Vec2 room{5.29, 2.99};          // of the cue ball's centre, between the mirrors [m]
const Vec2 in_the_way{0.575, 0.4255}; // a ball that must not be hit
constexpr double small = 0.3;         // the radius of a ball in front of a wall [m]

struct State {
    Game game = you_guess;
    Ball ball{{0, 4.3}, {0, -5}, small};
    int angle_deg = 37; ///< of the wall, or of the box
    Vec2 guess{-1.8, 2.4};
    Wall wall{{-4, -2}, {4, 1}};
    Vec2 target{1.725, 1.035};
    bool rolling = false;
    double way{}, all{}; ///< how far the ball has rolled, and will [m]
    Vec2 before{0, -5};  ///< its velocity before it met the wall [m/s]
    bool met = false;    ///< whether it has met the wall
    std::vector<Vec2> trail{};
    double spare{}, chosen = -1; ///< the sum of all controls: if it changes, we begin again
};

State begin() { return {}; }

double choice_of(const Input &in) {
    double sum = 0, weight = 1;
    for (const demo::Control &each : in.controls) sum += (weight *= 1.618) * each.value;
    return sum;
}

double angle_of(const State &now) { return now.angle_deg * degree; }
double angle_between(const Vec2 &a, const Vec2 &b) {
    return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}
/// Out of the wall that one turns, to the side from which the ball comes.
Vec2 normal_of(const State &now) {
    return now.game == you_guess ? Vec2{-0.6, 0.8} : at_angle(angle_of(now) + 90 * degree);
}
bool has_length(const Wall &wall) { return (wall.end - wall.start).norm() > 0.01; }
/// Whether the ball in the way would be hit.
bool is_blocked(const Vec2 &centre) { return (centre - in_the_way).norm() < 2 * cue.radius; }

/// Where the target is seen in the mirrors. The middle of the table is at (0, 0).
Vec2 image_of(const State &now, const Input &in) {
    const int across = int(in["across"]), up = int(in["up"]);
    return {across * room.x() + (across % 2 == 0 ? 1 : -1) * now.target.x(),
            up * room.y() + (up % 2 == 0 ? 1 : -1) * now.target.y()};
}

/// The ball comes once more.
void throw_ball(State &now, const Input &in) {
    const double speed = now.game == you_guess ? 5 : in["speed"];
    now.trail.clear();
    now.met = false;
    if (now.game == on_screen) now.ball = {{0.12, 0.07}, speed * Vec2{0.8, 0.6}, in["radius"]};
    else if (now.game == turned_box) now.ball = {{0, 0}, speed * Vec2{0.6, 0.8}, in["radius"]};
    else now.ball = {{0, 4.3}, {0, -speed}, small};
    now.before = now.ball.velocity;
}

void step_at_wall(State &now, const Input &in, double dt) {
    const Vec2 before = now.ball.velocity;
    if (now.game == rough) next_frame(now.ball, {0, 0}, normal_of(now), {in["restitution"], in["mu_k"]}, dt);
    else if (now.game != two_ends) next_frame(now.ball, {0, 0}, normal_of(now), dt);
    else if (has_length(now.wall)) next_frame(now.ball, now.wall, dt);
    else now.ball.position += dt * before;
    if ((now.ball.velocity - before).norm() > 1e-9) now.met = true;
    const Vec2 &at = now.ball.position;
    if (std::abs(at.x()) < 9 && std::abs(at.y()) < 5.5 && (!now.met || now.trail.size() < 300)) return;
    now.rolling = false; // it has left the picture
    if (now.game != you_guess) throw_ball(now, in);
}

void step(State &now, const Input &in) {
    const double dt = frame_time;
    if (now.game == pool) {
        if (!now.rolling) return;
        const Vec2 to = bank_shot(cue, now.target, table, int(in["across"]), int(in["up"]));
        now.way = std::min(now.way + 3 * dt, now.all);
        now.ball.position = rolled(cue, table, to, now.way);
        now.rolling = now.way < now.all && !is_blocked(now.ball.position);
    } else if (now.game == on_screen) {
        next_frame(now.ball, whole, dt);
    } else if (now.game == turned_box) {
        next_frame(now.ball, turning, angle_of(now), dt);
    } else if (now.game != you_guess || now.rolling) {
        step_at_wall(now, in, dt);
    } else {
        return;
    }
    now.trail.push_back(now.ball.position);
    if (now.game != pool && now.trail.size() > 300) now.trail.erase(now.trail.begin());
}

void roll(State &now, const Input &in) {
    if (now.game == you_guess) throw_ball(now, in);
    if (now.game == pool) {
        now.ball = cue;
        now.trail = {cue.position};
        now.way = 0;
        now.all = (image_of(now, in) - cue.position).norm();
    }
    now.rolling = true;
}

/// A handle holds the tip of the guess, an end of the wall, a corner of the box, or the target.
void drag(State &now, const Input &in) {
    const Vec2 there{std::clamp(in.pointer.x(), -8.0, 8.0), std::clamp(in.pointer.y(), -4.5, 4.5)};
    if (now.game == you_guess && there.norm() > 0.1) now.guess = 3 * there.normalized();
    if (now.game == two_ends) (in.handle == 0 ? now.wall.start : now.wall.end) = there;
    if (now.game == off_wall || now.game == rough || now.game == turned_box)
        now.angle_deg = int(std::floor(std::atan2(there.y(), there.x()) / degree + 0.5));
    if (now.game == pool) {
        const Vec2 edge{cue.radius, cue.radius};
        const Vec2 inside = there.cwiseMax(table.low + edge).cwiseMin(table.high - edge);
        if ((inside - cue.position).norm() > 0.5) now.target = inside;
        now.rolling = false;
        now.ball = cue;
        now.trail.clear();
    }
}

State next(State now, const Input &in) {
    if (choice_of(in) != now.chosen) {
        const bool same = static_cast<Game>(in["The game"]) == now.game;
        State fresh{.game = static_cast<Game>(in["The game"]), .guess = now.guess, .wall = now.wall};
        if (same) fresh.angle_deg = now.angle_deg;
        fresh.target = now.target;
        fresh.chosen = choice_of(in);
        now = std::move(fresh);
        throw_ball(now, in);
        if (now.game == pool) now.ball = cue;
    }
    const int angle_deg = now.angle_deg;
    const Wall wall = now.wall;
    if (in.handle >= 0) drag(now, in);
    now.angle_deg += (in.key == "u") - (in.key == "d");
    if (now.game == off_wall || now.game == rough) now.angle_deg = std::clamp(now.angle_deg, -80, 80);
    const bool same_wall = now.angle_deg == angle_deg && now.wall.start == wall.start && now.wall.end == wall.end;
    if (now.met && !same_wall) throw_ball(now, in); // it has not met this wall
    if (in.key == "f") roll(now, in);
    if (in.key == "l") { // two seconds in which nobody looks
        now.ball.position += 2 * now.ball.velocity;
        now.trail.clear();
    }
    for (int due = demo::steps_due(now.spare, in, frame_time); due > 0; --due) step(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, std::vector<Vec2> points) {
    seen.shapes.push_back({kind, colour, size, 1, std::move(points)});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour = Colour::dim) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
void add_handle(demo::Picture &seen, const Vec2 &at) {
    seen.shapes.push_back({Shape::handle, Colour::blue, 0, 1, {at}});
}
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, value, decimals});
}
void add_box(demo::Picture &seen, const Box &box, double angle, Colour colour, double width) {
    const Vec2 right = at_angle(angle), up{-right.y(), right.x()};
    const auto at = [&](double x, double y) { return Vec2{x * right + y * up}; };
    const auto &[low, high] = box;
    add(seen, Shape::line, colour, width,
        {at(low.x(), low.y()), at(high.x(), low.y()), at(high.x(), high.y()), at(low.x(), high.y()),
         at(low.x(), low.y())});
}

/// The velocity before, its two parts, and the velocity after, with their feet where the ball meets the wall.
void draw_parts(demo::Picture &seen, const State &now, const Vec2 &normal) {
    constexpr double scale = 0.4; // [s]
    const Vec2 before = scale * now.before, across = before.dot(normal) * normal, along = before - across;
    const Vec2 meets = normal.y() > 0 ? Vec2{0, small / normal.y()} : Vec2{0, 0}; // the ball's centre
    add(seen, Shape::arrow, Colour::pink, 2.5, {meets - before, meets - before + across});
    add(seen, Shape::arrow, Colour::green, 2.5, {meets - along, meets});
    add_words(seen, {0.3, std::min(meets.y() - before.y() + 1.5, 4.5)}, "normal part", Colour::pink);
    add_words(seen, meets - 0.5 * along + Vec2{0.4, -0.7}, "tangential part", Colour::green);
    if (!now.met) return;
    add(seen, Shape::arrow, Colour::blue, 3, {meets, meets + scale * now.ball.velocity});
    add_words(seen, meets + 1.1 * scale * now.ball.velocity, "after", Colour::blue);
    const auto out = [&](const Vec2 &v) { return angle_between(v, normal); };
    say(seen, "angle in", "°", out(-now.before) / degree, 1);
    if (now.ball.velocity.norm() > 0) say(seen, "angle out", "°", out(now.ball.velocity) / degree, 1);
}

/// The wall whose ends one drags, and its normal by 6.3.
void draw_ends(demo::Picture &seen, const Wall &wall) {
    add(seen, Shape::line, Colour::ink, 4, {wall.start, wall.end});
    add_words(seen, wall.start + Vec2{0.2, -0.5}, "start", Colour::ink);
    add_words(seen, wall.end + Vec2{0.2, -0.5}, "end", Colour::ink);
    add_handle(seen, wall.start);
    add_handle(seen, wall.end);
    if (!has_length(wall)) return add_words(seen, {-3, 3}, "A point has no normal.");
    const Vec2 middle = (wall.start + wall.end) / 2, n = unit_normal(wall.start, wall.end);
    const Vec2 far = 20 * Vec2{n.y(), -n.x()};
    add(seen, Shape::line, Colour::dim, -1.5, {middle - far, middle + far});
    add(seen, Shape::arrow, Colour::violet, 3, {middle, middle + n});
    add_words(seen, middle + 1.4 * n, "normal", Colour::violet);
    say(seen, "normal, to the right", "", n.x());
    say(seen, "normal, up", "", n.y());
}

/// The wall of the guess, or the one that one turns.
void draw_slant(demo::Picture &seen, const State &now) {
    const Vec2 n = normal_of(now), along{n.y(), -n.x()};
    add(seen, Shape::line, Colour::ink, 4, {-6 * along, 6 * along});
    if (now.game == you_guess) {
        add(seen, Shape::arrow, Colour::violet, -2, {Vec2{0, 0}, now.guess});
        add_words(seen, now.guess + Vec2{0.3, 0.1}, "your guess", Colour::violet);
        add_handle(seen, now.guess);
    } else {
        draw_parts(seen, now, n);
        say(seen, "wall", "°", now.angle_deg, 0);
        add_handle(seen, 4 * along);
    }
}

void draw_wall(demo::Picture &seen, const State &now) {
    if (now.game == two_ends) draw_ends(seen, now.wall);
    else draw_slant(seen, now);
    if (!now.met) return;
    if (now.game == you_guess) say(seen, "guess off by", "°", angle_between(now.guess, now.ball.velocity) / degree, 0);
    say(seen, "after, to the right", "m/s", now.ball.velocity.x());
    say(seen, "after, up", "m/s", now.ball.velocity.y());
}

void draw_screen(demo::Picture &seen, const State &now) {
    add_box(seen, whole, 0, Colour::ink, 3);
    const Vec2 edge{now.ball.radius, now.ball.radius};
    const double past =
        std::max((whole.low - now.ball.position + edge).maxCoeff(), (now.ball.position + edge - whole.high).maxCoeff());
    say(seen, "past a side by", "m", std::max(0.0, past));
    say(seen, "speed", "m/s", now.ball.velocity.norm());
    const Vec2 &at = now.ball.position;
    if (std::abs(at.x()) > 8.5 || std::abs(at.y()) > 5) add_words(seen, {-2, 0}, "out of the picture");
}

void draw_pool(demo::Picture &seen, const State &now, const Input &in) {
    const int across = int(in["across"]), up = int(in["up"]);
    const Vec2 by{across * room.x(), up * room.y()};
    if (across != 0 || up != 0) add_box(seen, {table.low + by, table.high + by}, 0, Colour::dim, -1.5);
    add_box(seen, table, 0, Colour::ink, 3);
    const Vec2 to = bank_shot(cue, now.target, table, across, up);
    const Vec2 image = cue.position + (image_of(now, in) - cue.position).norm() * to;
    add(seen, Shape::line, Colour::violet, -1.5, {cue.position, image});
    if (across != 0 || up != 0) add_words(seen, image + Vec2{0.3, 0.2}, "image (6.6)", Colour::violet);
    add(seen, Shape::discs, Colour::dim, cue.radius, {in_the_way});
    add_words(seen, now.target + Vec2{-0.7, 1}, "target");
    say(seen, "has rolled", "m", now.way);
    say(seen, "target is away by", "m", (now.ball.position - now.target).norm());
    if (!now.rolling && is_blocked(now.ball.position)) add_words(seen, {-4, 3.5}, "It has hit the ball in the way.");
    else if (!now.rolling && now.way > 0 && now.way == now.all) add_words(seen, {-4, 3.5}, "It is there.");
    add_handle(seen, now.target);
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    if (now.trail.size() > 1) add(seen, Shape::line, Colour::orange, 1.5, now.trail);
    if (now.game == on_screen) {
        draw_screen(seen, now);
    } else if (now.game == turned_box) {
        add_box(seen, turning, angle_of(now), Colour::ink, 3);
        add_handle(seen, 4 * at_angle(angle_of(now)));
        say(seen, "box", "°", now.angle_deg, 0);
        say(seen, "speed", "m/s", now.ball.velocity.norm());
    } else if (now.game == pool) {
        draw_pool(seen, now, in);
    } else {
        draw_wall(seen, now);
    }
    add(seen, Shape::discs, Colour::orange, std::max(0.08, now.ball.radius), {now.ball.position});
    return seen;
}
} // namespace play
