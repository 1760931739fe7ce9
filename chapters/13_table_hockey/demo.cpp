#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace table_hockey;
using demo::Colour, demo::Input, demo::Material, demo::Shape;

enum Mode { against_the_machine, two_players, two_machines };

const std::vector<std::string_view> games{"against the machine", "two players", "machine against machine"};
const std::vector<std::string_view> with_blue{games[0], games[1]}, with_orange{games[1]},
    with_machine{games[0], games[2]};

demo::Control machine_level() {
    demo::Control level = demo::choice("The machine", {"easy", "hard"}, 0);
    level.only_with = with_machine;
    return level;
}
const demo::About about{
    "A table with a disc, and two arms with mallets that play for goals.",
    {-1.28, -0.78},
    {1.28, 0.84},
    {demo::choice("The game", games, against_the_machine), machine_level(), demo::choice("The well", {"off", "on"}, 0),
     demo::held("blue up", "w", with_blue), demo::held("blue left", "a", with_blue),
     demo::held("blue down", "s", with_blue), demo::held("blue right", "d", with_blue),
     demo::held("orange up", "ArrowUp", with_orange), demo::held("orange left", "ArrowLeft", with_orange),
     demo::held("orange down", "ArrowDown", with_orange), demo::held("orange right", "ArrowRight", with_orange)},
    {{"n", "New game"}}};
const demo::Still still{3};

constexpr double patience = 10;  ///< so long it waits for a player who went away [s]
constexpr double break_time = 4; ///< after a match [s]
constexpr double lit = 1;        ///< how long the lamps of a goal are on [s]

/// A hand goes where a pointer has shown it last, or as keys say.
struct Lead {
    bool by_pointer = false;
    Vec2 to{0, 0}; ///< [m]
};

struct State {
    Mode mode = against_the_machine;
    World world = opening();
    unsigned matches = 0;     ///< how many were begun before this one
    double time{};            ///< since this one began [s]
    double idle = patience;   ///< since the last key, or the pointer's last move [s]
    Lead leads[2]{};          ///< of the left hand, and of the right one
    Vec2 pointer{0, 0};       ///< where it was in the frame before [m]
    double goal_ago[2]{9, 9}; ///< since the disc was in the left goal, and in the right one [s]
    double over{};            ///< for how long the match has been over [s]
    double chosen = -1;       ///< which game the page asks for
};

State begin() {
    State now;
    return now;
}

void start(State &now) {
    State fresh = begin();
    fresh.mode = now.mode, fresh.matches = now.matches + 1, fresh.chosen = now.chosen;
    fresh.idle = now.idle, fresh.pointer = now.pointer;
    std::copy(now.leads, now.leads + 2, fresh.leads);
    now = fresh;
}

// -------------------------------------------------------------------------------------------------------- one frame

/// Which way the keys of a player point.
Vec2 direction_of(const Input &in, bool blue) {
    const auto key = [&](const char *blue_one, const char *orange_one) { return in[blue ? blue_one : orange_one]; };
    return {key("blue right", "orange right") - key("blue left", "orange left"),
            key("blue up", "orange up") - key("blue down", "orange down")};
}
bool is_played(const State &now) { return now.idle < patience && now.mode != two_machines; }

/// Whoever comes begins a match, and whoever leaves goes on with it for a while.
void look_who_plays(State &now, const Input &in) {
    const bool points = in.handle >= 0 || (in.inside && now.mode == against_the_machine), was_played = is_played(now);
    if (points && (in.handle >= 0 || in.pressed || in.pointer != now.pointer))
        now.leads[in.handle > 0] = {true, in.pointer}, now.idle = 0;
    now.pointer = in.pointer;
    now.idle = points && was_played ? 0 : now.idle + in.dt;
    for (const bool blue : {true, false})
        if (!direction_of(in, blue).isZero(0)) now.leads[!blue].by_pointer = false, now.idle = 0;
    if (is_played(now) && !was_played) start(now);
}

Vec2 hand_of(const Lead &lead, const Player &player, const Vec2 &direction) {
    return lead.by_pointer ? lead.to : led(player, direction);
}
/// Of two machines, the left one is always the better one.
Vec2 left_hand(const State &now, const Input &in) {
    if (now.mode == two_machines) return machine_hand(now.world, -1, Level::difficult);
    if (!is_played(now)) return beginner_hand(now.world, now.matches, now.time);
    return hand_of(now.leads[0], now.world.left, direction_of(in, true));
}
Vec2 right_hand(const State &now, const Input &in, Level level) {
    if (now.mode != two_players || !is_played(now)) return machine_hand(now.world, 1, level);
    return hand_of(now.leads[1], now.world.right, direction_of(in, false));
}

void step(State &now, const Input &in, double dt) {
    const Level level = in["The machine"] == 0 ? Level::easy : Level::difficult;
    const int left = now.world.left.goals, right = now.world.right.goals;
    now.world =
        table_hockey::step(now.world, {left_hand(now, in), right_hand(now, in, level), in["The well"] == 1}, dt);
    round_off(now.world);
    now.time += dt;
    now.goal_ago[0] = now.world.right.goals != right ? 0 : now.goal_ago[0] + dt;
    now.goal_ago[1] = now.world.left.goals != left ? 0 : now.goal_ago[1] + dt;
}

State next(State now, const Input &in) {
    if (const double chosen = in["The game"]; chosen != now.chosen) {
        now.chosen = chosen;
        now.mode = static_cast<Mode>(chosen);
        now.leads[0] = now.leads[1] = {};
        now.idle = patience;
        start(now);
    }
    if (in.key == "n") start(now);
    look_who_plays(now, in);
    const double dt = in.one_step ? frame_time : in.dt;
    if (!is_won(now.world)) step(now, in, dt);
    else if ((now.over += dt) > break_time && !is_played(now)) start(now);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

/// Points that stand in the code, or are in a vector: small when it's compiled.
struct Points {
    const Vec2 *first;
    std::size_t count;
    Points(std::initializer_list<Vec2> list) : first{list.begin()}, count{list.size()} {}
    Points(const std::vector<Vec2> &list) : first{list.data()}, count{list.size()} {}
};
void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, Points points, double strength = 1,
         Material material = Material::flat) {
    seen.shapes.push_back({kind, colour, size, strength, {points.first, points.first + points.count}, {}, material});
}
void add_solid(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, Points points, double strength = 1) {
    add(seen, kind, colour, size, points, strength, Material::solid);
}
void add_glow(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, Points points, double strength = 1) {
    add(seen, kind, colour, size, points, strength, Material::glow);
}
void add_words(demo::Picture &seen, const Vec2 &at, std::string_view words, Colour colour = Colour::ink) {
    add(seen, Shape::words, colour, 0, {at});
    seen.shapes.back().text = words;
}
/// Without the last digits, which are rounding, and without a negative zero.
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals) {
    seen.readouts.push_back({name, unit, std::round(value * 1e6) / 1e6 + 0.0, decimals});
}
void add_circle(demo::Picture &seen, Colour colour, double radius, double strength) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 48; ++i) points.push_back(radius * Vec2{std::cos(0.1309 * i), std::sin(0.1309 * i)});
    points.back() = points.front();
    add(seen, Shape::line, colour, 2, points, strength);
}

/// A digit as an old scoreboard shows it: seven bars, of which some are on.
void add_digit(demo::Picture &seen, const Vec2 &middle, int digit, Colour colour) {
    constexpr unsigned char on[]{0x77, 0x24, 0x5d, 0x6d, 0x2e, 0x6b, 0x7b, 0x25, 0x7f, 0x6f};
    const Vec2 ends[][2]{{{-1, 2}, {1, 2}},   {{-1, 2}, {-1, 0}}, {{1, 2}, {1, 0}},   {{-1, 0}, {1, 0}},
                         {{-1, 0}, {-1, -2}}, {{1, 0}, {1, -2}},  {{-1, -2}, {1, -2}}};
    for (int bar = 0; bar < 7; ++bar) {
        const Vec2 from = middle + 0.034 * ends[bar][0], to = middle + 0.034 * ends[bar][1], gap = 0.15 * (to - from);
        if (on[digit] >> bar & 1) add_glow(seen, Shape::line, colour, 5, {from + gap, to - gap});
        else add(seen, Shape::line, colour, 2, {from + gap, to - gap}, 0.15);
    }
}
void add_score(demo::Picture &seen, double x, int goals, Colour colour) {
    const int shown = std::clamp(goals, 0, 99);
    if (shown > 9) add_digit(seen, {x - 0.13, 0.735}, shown / 10, colour);
    add_digit(seen, {x, 0.735}, shown % 10, colour);
}

/// Wood around the cloth, with a gap for each goal.
void add_frame(demo::Picture &seen) {
    constexpr double x = half_length, y = half_width, near = 0.035, far = 0.12, goal = half_goal;
    for (const double side : {-1, 1}) {
        add_solid(seen, Shape::area, Colour::wood, 0,
                  {{-x - far, side * (y + far)},
                   {x + far, side * (y + far)},
                   {x + near, side * (y + near)},
                   {-x - near, side * (y + near)}});
        for (const double up : {-1, 1})
            add_solid(seen, Shape::area, Colour::wood, 0,
                      {{side * (x + far), up * (y + far)},
                       {side * (x + near), up * (y + near)},
                       {side * (x + near), up * goal},
                       {side * (x + far), up * goal}});
    }
}
/// Each as thick as it's drawn outside of the line that the disc bounces off.
void add_cushions(demo::Picture &seen) {
    constexpr double half = 0.016;
    for (const Segment &each : cushions()) {
        const bool along = each.start.y() == each.end.y();
        const auto moved = [&](const Vec2 &at) {
            const Vec2 out{at.x() > 0 ? half : -half, at.y() > 0 ? half : -half};
            return Vec2{at + (along ? Vec2{0, out.y()} : out)};
        };
        add_solid(seen, Shape::line, Colour::green, 8, {moved(each.start), moved(each.end)});
    }
}
void add_goals(demo::Picture &seen, const State &now) {
    for (const int side : {-1, 1}) {
        const double x = side * half_length, deep = side * (half_length + 0.12), y = half_goal;
        add(seen, Shape::area, Colour::line, 0, {{x, -y}, {deep, -y}, {deep, y}, {x, y}}, 0.35);
        const double ago = now.goal_ago[side > 0], light = std::max(0.0, 1 - ago / lit);
        add_glow(seen, Shape::line, side < 0 ? Colour::blue : Colour::orange, 3 + 7 * light,
                 {{deep, 0.02 - y}, {deep, y - 0.02}}, 0.6 + 0.4 * light);
    }
}
void add_table(demo::Picture &seen, const State &now, bool well) {
    add(seen, Shape::line, Colour::ink, 2, {{0, -half_width}, {0, half_width}}, 0.3);
    add_circle(seen, Colour::ink, 0.17, 0.3);
    add(seen, Shape::discs, Colour::ink, 0.012, {{0, 0}}, 0.4);
    add_frame(seen);
    add_cushions(seen);
    add_goals(seen, now);
    if (!well) return;
    for (const double radius : {0.06, 0.26, 0.42}) add_circle(seen, Colour::violet, radius, 0.9 - 1.2 * radius);
}

void add_mallet(demo::Picture &seen, const Player &player, Colour colour) {
    add_solid(seen, Shape::discs, colour, mallet_radius, {player.mallet});
    add(seen, Shape::discs, Colour::ink, 0.4 * mallet_radius, {player.mallet}, 0.5);
}
/// Above all that's on the table, which is seen through it.
void add_arm(demo::Picture &seen, const Player &player, Colour colour) {
    std::vector<Vec2> joints =
        forward_kinematics::joints({shoulder, 0}, {{arm.first, player.pose.first}, {arm.second, player.pose.second}});
    for (Vec2 &joint : joints) joint = seen_from(player.side, Vec2{joint});
    add_solid(seen, Shape::line, colour, 7, joints, 0.55);
    add_solid(seen, Shape::discs, Colour::dim, 0.05, {joints[0]});
    add_solid(seen, Shape::discs, Colour::ink, 0.026, {joints[1]}, 0.8);
}

/// The disc, with a streak behind it that says how fast it is.
void add_disc(demo::Picture &seen, const Disc &disc) {
    const Vec2 high{half_length, half_width}, tail = disc.place - 0.05 * disc.velocity;
    add(seen, Shape::line, Colour::amber, 4, {disc.place, tail.cwiseMax(-high).cwiseMin(high)}, 0.3);
    add_solid(seen, Shape::discs, Colour::amber, disc_radius, {disc.place});
}
void add_sparks(demo::Picture &seen, const std::vector<Particle> &sparks) {
    for (const Particle &each : sparks)
        add_glow(seen, Shape::discs, Colour::amber, 0.012 * std::max(0.2, 1 - each.age / each.life),
                 {each.position - Vec2{half_length, half_width}});
}

std::string_view words_for(const State &now) {
    if (is_won(now.world)) return now.world.left.goals > now.world.right.goals ? "blue wins" : "orange wins";
    return now.mode == two_machines || is_played(now) ? "" : "press a key to take over";
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    seen.stage = demo::Stage::felt;
    const auto &[disc, left, right, sparks, serve_to, wait, spare] = now.world;
    add_table(seen, now, in["The well"] == 1);
    if (now.mode != two_machines) add(seen, Shape::handle, Colour::blue, 0, {left.mallet});
    if (now.mode == two_players) add(seen, Shape::handle, Colour::orange, 0, {right.mallet});
    add_mallet(seen, left, Colour::blue);
    add_mallet(seen, right, Colour::orange);
    add_disc(seen, disc);
    add_sparks(seen, sparks);
    add_arm(seen, left, Colour::blue);
    add_arm(seen, right, Colour::orange);
    add_score(seen, -0.16, left.goals, Colour::blue);
    add_score(seen, 0.16, right.goals, Colour::orange);
    add_words(seen, {-0.6, -0.73}, words_for(now));
    say(seen, "goals left", "", left.goals, 0);
    say(seen, "goals right", "", right.goals, 0);
    say(seen, "speed of the disc", "m/s", disc.velocity.norm(), 2);
    return seen;
}
} // namespace play
