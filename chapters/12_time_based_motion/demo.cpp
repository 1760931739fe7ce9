#include "../demo.hpp"

#include "game.hpp"

#include <string>

//> The demo
namespace play {
using namespace time_based_motion;
using demo::Colour, demo::Input, demo::Material, demo::Shape, demo::Stage;

enum Mode { who_is_first, screens, sleeping, whole_steps, running, cameras, laps, busy, with_a_friend };

const std::vector<std::string_view> games{"who's first?",       "three screens (12.1)",  "a tab that sleeps (12.2)",
                                          "whole steps (12.3)", "run and jump (12.4)",   "two cameras (12.5)",
                                          "laps (12.6)",        "a busy machine (12.7)", "a friend (12.8)"};

std::vector<std::string_view> in_games(std::initializer_list<Mode> which) {
    std::vector<std::string_view> names;
    for (const Mode mode : which) names.push_back(games[mode]);
    return names;
}

const demo::About about{"The same game on screens that are fast and slow.",
                        {0, 0},
                        {640, 410},
                        {demo::choice("The game", games, who_is_first),
                         {"frame delay", "ms", 10, 700, 10, 100, {}, in_games({screens, laps})},
                         {"frames per second", "", 10, 144, 1, 60, {}, in_games({whole_steps, running})},
                         {"half-life", "s", 0.01, 0.5, 0.005, 0.1, {}, in_games({cameras})},
                         {"cost of a step", "ms", 0.5, 20, 0.5, 4, {}, in_games({busy})},
                         {"lost", "%", 0, 80, 5, 10, {}, in_games({with_a_friend})}},
                        {{"f", "Show", in_games({who_is_first})},
                         {"n", "New", in_games({who_is_first, running})},
                         {"s", "Sleep for 2 s", in_games({sleeping})},
                         {"b", "Clock back by an hour", in_games({sleeping})},
                         {"j", "Jump", in_games({whole_steps, running})}}};
const demo::Still still{3.3};

constexpr double frame_time = 1.0 / 60;       ///< of the page that this is seen on [s]
constexpr double finish = 800;                ///< [px]
constexpr double cruise = 120;                ///< [px/s]
constexpr double width = 640;                 ///< of a screen [px]
constexpr double rings[]{210, 280, 350, 430}; ///< [px]
constexpr double ring_reach = 16;             ///< a ship in a ring is so near to it [px]
constexpr double race_speed = 8;              ///< how many seconds of the race pass in a second

/// What the machine of 12.7 is busy with: a hunter runs after a ball.
struct Chase {
    Vec2 ball{1, 0.6}, speed{2.1, 1.5}, hunter{-1.5, -1}, heading{0, 0}; ///< [m], [m/s], [m], [m/s]
    int caught{};
};
const Vec2 field{2.1, 1.5}; ///< half as large as what they run about in [m]

struct State {
    Mode mode = who_is_first;
    int round = 0;                       ///< how often *New* was pressed
    double time{}, spare{}, chosen = -1; ///< [s], [s], which game the page asks for
    double shown[6]{};                   ///< when the screens showed their last frames [s]
    double guess = 600, flown = -1;      ///< [px]; how long the two ships have flown, -1: they wait [s]
    double misses[5]{};                  ///< of the last five guesses [px]
    int guesses = 0;
    std::array<Screen, 3> screens{};    ///< all of 12.1
    double pale[3]{};                   ///< where ships are that fly 2 px a frame [px]
    Tab tab{};                          ///< all of 12.2
    double machine = 20000, asleep = 0; ///< what the machine's clock shows [s]; how long the tab sleeps yet [s]
    bool through[2][4]{};               ///< which rings the two ships came through in this round
    Lane lanes[6]{};                    ///< all of 12.3: with one step a frame, and in whole steps
    bool down[6]{};                     ///< whether a runner is still to jump
    Run run{};                          ///< all of 12.4
    bool pressed = false;               ///< since the last frame
    double ouch = 0;                    ///< how long the cactus hurts yet [s]
    Vec2 fell{0, 0};                    ///< where [m]
    Cameras both[2]{};                  ///< all of 12.5
    Vec2 target{0, 0};                  ///< [m]
    bool led = false;                   ///< whether it's the reader who plays
    Racer racers[2]{};                  ///< all of 12.6
    Machine machines[2]{};              ///< all of 12.7
    Chase chases[2]{};
    double works[2][24]{};    ///< how long the last frames worked [s]
    int frames[2]{};          ///< how many there were
    std::vector<Sent> line{}; ///< all of 12.8: the last 24 packets that weren't lost
    unsigned packets = 0;     ///< how many the friend has sent
    double lost[8]{};         ///< when those were sent that never come [s]
    int losses = 0;
    Vec2 seen{0, 0}, news{0, 0}; ///< where the ship is, by `seen_at` and by the newest packet [m]
    double hops[2][120]{};       ///< how far these two moved in the last frames [m]
    double lap_times[2][3]{};    ///< of the last laps [s]
};

State begin() {
    State now;
    return now;
}

// ------------------------------------------------------------------------------------------------------- the rounds

/// Two screens, and a ship that flies so far in a frame [px].
struct Pair {
    double yours, other, speed;
};
Pair pair_of(int round) {
    if (round == 0) return {60, 144, 2};
    constexpr double slow[]{30, 50, 60, 75}, fast[]{90, 120, 144, 165, 240};
    const auto one_of = [round](const auto &all, unsigned which) {
        return all[int(course::chance(unsigned(round), which) * double(std::size(all)))];
    };
    return {one_of(slow, 1), one_of(fast, 2), course::chance(unsigned(round), 3) < 0.5 ? 2.0 : 3.0};
}
/// Where your ship is when the other one arrives [px].
double truth(const Pair &pair) { return finish * pair.yours / pair.other; }

/// Where the friend's ship really is [m].
Vec2 flight(double time) { return {4 * std::sin(1.1 * time), 2.2 * std::sin(2 * time + 0.5)}; }

/// The choice of the game begins it anew; the other controls do not.
void start(State &now) {
    State fresh = begin();
    fresh.mode = now.mode, fresh.round = now.round, fresh.chosen = now.chosen, fresh.guesses = now.guesses,
    fresh.led = now.led;
    std::copy(now.misses, now.misses + 5, fresh.misses);
    fresh.screens = {{{0.1, 0, {0, cruise}}, {1.0 / 30, 0, {0, cruise}}, {1.0 / 144, 0, {0, cruise}}}};
    fresh.tab = {{}, {0, cruise}, {0, cruise}};
    fresh.tab.clock.last = fresh.machine;
    fresh.run.seed = unsigned(now.round);
    for (Racer &racer : fresh.racers) racer.ship.speed = 50;
    for (Machine &machine : fresh.machines) machine.game.jobs = {{120, 0.004, 0}, {10, 0.005, 0}};
    fresh.line = std::vector<Sent>(24, {{0, flight(0)}, 0});
    fresh.seen = fresh.news = flight(0);
    now = std::move(fresh);
}

// -------------------------------------------------------------------------------------------------------- one frame

/// How many frames a screen shows until now, if each takes so long [s].
int frames_due(double &shown, double frame, double time) {
    int count = 0;
    for (; shown + frame <= time + 1e-9; shown += frame) ++count;
    return count;
}

void step_screens(State &now, const Input &in) {
    now.screens[0].frame = in["frame delay"] / 1000;
    const std::array<Screen, 3> before = now.screens;
    next_frames(now.screens, now.time);
    for (std::size_t i = 0; i < 3; ++i)
        now.pale[i] += 2 * std::round((now.screens[i].shown - before[i].shown) / before[i].frame);
    if (now.time > width / cruise) start(now);
}

void step_sleeping(State &now) {
    now.machine += frame_time;
    if (!now.led && now.asleep == 0 && now.tab.clock.skipped == 0 && now.tab.ship.x > 148) now.asleep = 2; // by itself
    if ((now.asleep = std::max(0.0, now.asleep - frame_time)) > 0) return;                                 // no frames
    now.tab = next_frame(now.tab, now.machine);
    for (int i = 0; i < 8; ++i) {
        const Ship &ship = i < 4 ? now.tab.ship : now.tab.raw;
        now.through[i / 4][i % 4] |= std::abs(ship.x - rings[i % 4]) <= ring_reach;
    }
    if (now.tab.ship.x > width + 40 || now.time > 9) start(now);
}

/// The first one's screen is the reader's.
double frame_of_lane(int i, const Input &in) { return 1 / (i == 0 ? in["frames per second"] : i == 1 ? 30 : 144); }

void jump_all(State &now) {
    for (bool &down : now.down) down = true;
    for (Lane &lane : now.lanes) lane.highest = 0;
}

void step_lanes(State &now, const Input &in) {
    if (int(now.time / 1.46) > int((now.time - frame_time) / 1.46)) jump_all(now); // by themselves
    for (int i = 0; i < 6; ++i) {
        Lane &lane = now.lanes[i];
        const double frame = frame_of_lane(i % 3, in);
        for (int due = frames_due(now.shown[i], frame, now.time); due > 0; --due) {
            lane.spare = std::min(lane.spare, 1.0); // if an answer never catches up
            if (i >= 3) lane = next_frame(lane, frame, now.down[i]);
            else lane.runner = step(lane.runner, now.down[i], frame);
            lane.highest = std::max(lane.highest, lane.runner.place.y());
            now.down[i] = now.down[i] && lane.runner.place.y() == 0;
        }
    }
}

void step_running(State &now, const Input &in) {
    if (now.ouch > 0 || !now.led) {
        now.ouch -= frame_time;
        now.shown[0] = now.time;
        now.pressed = false;
        return;
    }
    const double frame = 1 / in["frames per second"];
    for (; now.shown[0] + frame <= now.time + 1e-9 && now.ouch <= 0; now.pressed = false) {
        now.shown[0] += frame;
        const int falls = now.run.falls;
        now.fell = now.run.game.shown;
        next_frame(now.run, now.shown[0], now.pressed);
        if (now.run.falls > falls) now.ouch = 0.8;
    }
}

void step_cameras(State &now, const Input &in) {
    now.led = now.led || in.inside;
    const double t = now.time;
    if (in.inside) now.target = in.pointer;
    else if (!now.led) now.target = {4 * std::sin(1.6 * t), 2.1 * std::sin(2.5 * t + 0.6)};
    for (int i = 0; i < 2; ++i) {
        const double frame = i == 0 ? 1.0 / 30 : 1.0 / 144;
        for (int due = frames_due(now.shown[i], frame, t); due > 0; --due)
            now.both[i] = next_frame(now.both[i], now.target, in["half-life"], frame);
    }
}

void step_laps(State &now, const Input &in) {
    const double frame = in["frame delay"] / 1000;
    for (; now.shown[0] + frame <= race_speed * now.time + 1e-9;) {
        now.shown[0] += frame;
        next_frame(now.racers[0], finish, now.shown[0], frame);
        next_frame_without_rest(now.racers[1], finish, now.shown[0], frame);
        for (int i = 0; i < 2; ++i) now.lap_times[i][now.racers[i].laps % 3] = now.racers[i].lap;
    }
}

/// A job of the chase: 0 moves both, 1 lets the hunter think.
void run_job(Chase &now, int job) {
    constexpr double step = 1.0 / 120;
    const Vec2 way = now.ball - now.hunter;
    if (job == 1) now.heading = way.norm() > 0 ? Vec2{1.9 / way.norm() * way} : way;
    if (job != 0) return;
    now.ball += step * now.speed;
    now.hunter += step * now.heading;
    for (int axis = 0; axis < 2; ++axis)
        if (std::abs(now.ball[axis]) > field[axis] - 0.2)
            now.speed[axis] = now.ball[axis] > 0 ? -std::abs(now.speed[axis]) : std::abs(now.speed[axis]);
    if (way.norm() > 0.42) return;
    ++now.caught;
    now.ball = -now.ball; // it gets away
}

void step_busy(State &now, const Input &in) {
    for (int i = 0; i < 2; ++i) {
        Machine &machine = now.machines[i];
        machine.game.jobs[0].cost = in["cost of a step"] / 1000;
        while (now.shown[i] + machine.frame <= now.time + 1e-9) {
            now.shown[i] += machine.frame;
            next_frame(machine, i == 0 ? 1 : 1.0 / 60);
            for (const int job : machine.game.ran) run_job(now.chases[i], job);
            now.works[i][now.frames[i]++ % 24] = machine.work;
        }
    }
}

void step_friend(State &now, const Input &in) {
    while (0.05 * (now.packets + 1) <= now.time) {
        const double sent = 0.05 * ++now.packets, late = 0.01 + 0.04 * course::chance(5, 2 * now.packets + 1);
        if (100 * course::chance(5, 2 * now.packets) < in["lost"]) now.lost[now.losses++ % 8] = sent;
        else now.line[now.packets % 24] = {{sent, flight(sent)}, sent + late};
    }
    const Vec2 seen = next_frame(now.line, now.time), news = newest(now.line, now.time);
    const int at = int(std::round(now.time / frame_time)) % 120;
    now.hops[0][at] = (seen - now.seen).norm();
    now.hops[1][at] = (news - now.news).norm();
    now.seen = seen, now.news = news;
}

void step(State &now, const Input &in) {
    if (now.time > 3600 && now.mode >= laps) start(now); // nobody has watched it for an hour
    now.time += frame_time;
    switch (now.mode) {
    case who_is_first:
        if (now.flown >= 0) now.flown += frame_time;
        break;
    case screens: step_screens(now, in); break;
    case sleeping: step_sleeping(now); break;
    case whole_steps: step_lanes(now, in); break;
    case running: step_running(now, in); break;
    case cameras: step_cameras(now, in); break;
    case laps: step_laps(now, in); break;
    case busy: step_busy(now, in); break;
    case with_a_friend: step_friend(now, in); break;
    }
}

/// The two ships start, and how far off the guess is stays as a dot.
void show_flight(State &now) {
    if (now.flown < 0) now.misses[now.guesses++ % 5] = now.guess - truth(pair_of(now.round));
    now.flown = 0;
}

void press(State &now, const Input &in) {
    if (in.key == "f") show_flight(now);
    if (in.key == "n") {
        ++now.round;
        start(now);
    }
    if (in.key == "s") now.asleep = 2, now.led = true;
    if (in.key == "b") now.machine = std::max(0.0, now.machine - 3600), now.led = true;
    if (in.key != "j" && !in.pressed) return;
    now.pressed = now.led; // the first press starts the game
    now.led = true;
    if (now.mode == whole_steps) jump_all(now);
}

State next(State now, const Input &in) {
    if (const double chosen = in["The game"]; chosen != now.chosen) {
        now.chosen = chosen;
        now.mode = static_cast<Mode>(chosen);
        now.round = 0;
        now.guesses = 0, now.led = false;
        start(now);
    }
    if (now.mode == who_is_first && in.handle >= 0 && now.flown < 0)
        now.guess = std::clamp(in.pointer.x(), 0.0, finish);
    press(now, in);
    for (int due = demo::steps_due(now.spare, in, frame_time); due > 0; --due) step(now, in);
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
void add_solid(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, Points points) {
    add(seen, kind, colour, size, points, 1, Material::solid);
}
void add_glow(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, Points points, double strength = 1) {
    add(seen, kind, colour, size, points, strength, Material::glow);
}
void add_words(demo::Picture &seen, const Vec2 &at, std::string_view words, Colour colour = Colour::ink) {
    add(seen, Shape::words, colour, 0, {at});
    seen.shapes.back().text = words;
}
/// Without the last digits, which are rounding, and without a negative zero.
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, std::round(value * 1e6) / 1e6 + 0.0, decimals});
}
/// A number from 0, with up to 3 digits behind its point, and what's before and behind it: much smaller than std::format.
void add_number(demo::Picture &seen, const Vec2 &at, const char *before, double value, int decimals, const char *behind,
                Colour colour = Colour::ink) {
    add_words(seen, at, before, colour);
    int scale = 1;
    for (int i = 0; i < decimals; ++i) scale *= 10;
    const int all = int(std::round(std::min(std::abs(value), 1e6) * scale));
    std::string &words = seen.shapes.back().text, rest = std::to_string(all % scale + scale);
    rest[0] = '.';
    words += std::to_string(all / scale);
    if (decimals > 0) words += rest;
    words += behind;
}
void add_box(demo::Picture &seen, Colour colour, const Vec2 &low, const Vec2 &high, double strength = 1,
             Material material = Material::flat) {
    add(seen, Shape::area, colour, 0, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, strength, material);
}

/// What a body looks like from the side, or from above: in hundredths of its size, ahead is to the right.
using Outline = std::initializer_list<signed char>;
constexpr Outline hull{0, 0, -75, 36, -105, 50, -95, 16, -95, -16, -105, -50, -75, -36},
    dinosaur{-62, 66, -36, 38,  -14, 26,  10, 30, 22, 52, 20,  76, 44,  78,
             46,  98, 36,  104, 6,   104, 0,  96, -2, 70, -20, 58, -42, 56},
    drone{-50, -25, -35, -40, 35, -40, 50, -25, 50, 20, 35, 35, -35, 35, -50, 20},
    hill{-100, 0, -25, 58, 15, 68, 60, 40, 127, 0};

/// It's pale if its strength isn't 1.
void add_body(demo::Picture &seen, const Outline &outline, Colour colour, const Vec2 &at, double size,
              const Vec2 &ahead = {1, 0}, double strength = 1) {
    std::vector<Vec2> points;
    for (const signed char *each = outline.begin(); each != outline.end(); each += 2)
        points.push_back(at + 0.01 * size * (each[0] * ahead + each[1] * Vec2{-ahead.y(), ahead.x()}));
    add(seen, Shape::area, colour, 0, points, strength, strength < 1 ? Material::flat : Material::solid);
}

/// A ship's nose is where it is.
void add_ship(demo::Picture &seen, const Vec2 &nose, double size, Colour colour, double time,
              const Vec2 &ahead = {1, 0}) {
    const double flame = size * (1.3 + 0.22 * std::sin(41 * time));
    add_glow(seen, Shape::line, Colour::amber, 6, {nose - size * ahead, nose - flame * ahead});
    add_body(seen, hull, colour, nose, size, ahead);
    add_solid(seen, Shape::discs, Colour::ink, 0.13 * size, {nose - 0.5 * size * ahead});
}
/// What a screen is set in.
void add_screen(demo::Picture &seen, const Vec2 &low, const Vec2 &high, const char *words) {
    add_box(seen, Colour::line, low, high, 0.3);
    add_solid(seen, Shape::line, Colour::dim, 4, {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
    const double wide = high.x() - low.x();
    add_words(seen, {low.x() + 0.02 * wide, high.y() - 0.045 * wide}, words);
}
/// Two columns of a chequered line, so many fields high.
void add_chequers(demo::Picture &seen, const Vec2 &low, double side, int count) {
    for (int i = 0; i < count; ++i) {
        const Vec2 at = low + side * Vec2{i % 2, i};
        add_box(seen, Colour::ink, at, at + Vec2{side, side}, 0.8);
    }
}

void draw_guess(demo::Picture &seen, const State &now) {
    seen.low = {-125, -310}, seen.high = {860, 310};
    const Pair pair = pair_of(now.round);
    const double there = finish / pair.speed / pair.other, t = std::clamp(now.flown, 0.0, there);
    const double yours = pair.speed * pair.yours * t, others = pair.speed * pair.other * t;
    add_screen(seen, {-115, 20}, {850, 300}, "");
    add_screen(seen, {-115, -300}, {850, -20}, "");
    add_number(seen, {-95, 245}, "your friend: ", pair.other, 0, " frames a second");
    add_number(seen, {-95, -75}, "you: ", pair.yours, 0, " frames a second");
    add_number(seen, {-95, 42}, "", pair.speed, 0, " px in each frame", Colour::dim);
    add_chequers(seen, {finish, 25}, 15, 18);
    add_chequers(seen, {finish, -295}, 15, 18);
    for (int x = 0; x < 800; x += 100) {
        add(seen, Shape::line, Colour::dim, 1.5, {{double(x), -293}, {double(x), x % 200 == 0 ? -262.0 : -276.0}});
        if (x % 200 == 0) add_number(seen, {x + 6.0, -286}, "", x, 0, "", Colour::dim);
    }
    add_ship(seen, {others, 125}, 90, Colour::blue, now.time);
    add_ship(seen, {yours, -150}, 90, Colour::orange, now.time);
    add_body(seen, hull, Colour::pink, {now.guess, -150}, 90, {1, 0}, 0.6);
    const Vec2 beside{std::min(now.guess + 15, 600.0), -212};
    if (now.flown < 0) {
        add_words(seen, beside, "yours, then?", Colour::pink);
        add(seen, Shape::handle, Colour::pink, 0, {{now.guess, -150}});
        return;
    }
    say(seen, "your friend's ship", "px", others, 0);
    say(seen, "yours", "px", yours, 0);
    if (t < there) return;
    for (int i = 0; i < std::min(now.guesses, 5); ++i)
        add_glow(seen, Shape::discs, Colour::amber, 7, {{std::clamp(yours + now.misses[i], -110.0, 845.0), -246}});
    add(seen, Shape::line, Colour::pink, -2, {{yours, -150}, {now.guess, -150}});
    const double off = std::abs(now.guess - yours);
    add_number(seen, {yours + 12, -108}, "at ", yours, 0, " px", Colour::orange);
    add_number(seen, beside, "", off, 0, " px off", Colour::pink);
    say(seen, "off by", "px", off, 0);
}

void draw_screens(demo::Picture &seen, const State &now) {
    seen.low = {-30, 0}, seen.high = {width + 10, 430};
    double least = 1e9, most = -1e9;
    const char *names[]{"first ship", "second ship", "third ship"};
    const Colour colours[]{Colour::orange, Colour::green, Colour::blue};
    for (int i = 0; i < 3; ++i) {
        const Screen &screen = now.screens[std::size_t(i)];
        const double low = 290 - 142 * i, x = screen.ship.x;
        add_screen(seen, {-24, low}, {width + 4, low + 134}, "");
        add_number(seen, {-8, low + 106}, "", std::round(1 / screen.frame), 0, " frames a second");
        if (now.pale[i] < width) add_body(seen, hull, Colour::ink, {now.pale[i], low + 52}, 66, {1, 0}, 0.3);
        add_ship(seen, {std::clamp(x, -1e4, 1e4), low + 52}, 66, colours[i], screen.shown);
        least = std::min(least, x), most = std::max(most, x);
        say(seen, names[i], "px", x, 1);
    }
    say(seen, "apart", "px", most - least, 1);
}

/// One half of a ring, behind the ship or in front of it.
void add_half_ring(demo::Picture &seen, const Vec2 &centre, bool front, bool through) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 12; ++i) {
        const double turn = 0.2617993877991494 * i, across = std::sin(turn);
        points.push_back(centre + Vec2{front ? 12 * across : -12 * across, 62 * std::cos(turn)});
    }
    if (through) add_glow(seen, Shape::line, Colour::green, 4, points);
    else add_solid(seen, Shape::line, Colour::amber, 5, points);
}

void draw_sleeping(demo::Picture &seen, const State &now) {
    seen.low = {-30, 0}, seen.high = {width + 10, 430};
    const char *names[]{"by your clock", "by the plain difference"};
    for (int i = 0; i < 2; ++i) {
        const double low = i == 0 ? 220 : 8, y = low + 88, x = (i == 0 ? now.tab.ship : now.tab.raw).x;
        add_screen(seen, {-24, low}, {width + 4, low + 202}, names[i]);
        for (int k = 0; k < 4; ++k) add_half_ring(seen, {rings[k], y}, false, now.through[i][k]);
        add_ship(seen, {std::clamp(x, -2000.0, 2000.0), y}, 76, i == 0 ? Colour::blue : Colour::orange,
                 now.asleep > 0 ? 0 : now.time);
        for (int k = 0; k < 4; ++k) add_half_ring(seen, {rings[k], y}, true, now.through[i][k]);
        add_number(seen, {490, low + 173}, "", double(std::count(now.through[i], now.through[i] + 4, true)), 0,
                   " of 4 rings");
        if (x < -30) add_number(seen, {-10, y}, "← it's at −", -x, 0, " px", Colour::orange);
        say(seen, names[i], "px", x, 0);
    }
    if (now.asleep > 0) {
        add_box(seen, Colour::line, seen.low, seen.high, 0.5);
        add_number(seen, {150, 245}, "z z z: the tab wakes up in ", now.asleep, 1, " s");
    }
    say(seen, "dt", "s", now.tab.clock.dt, 3);
    say(seen, "skipped", "s", now.tab.clock.skipped);
}

/// A small dinosaur; where it runs says how its legs are.
void add_runner(demo::Picture &seen, const Vec2 &feet, double size, Colour colour, double ran) {
    const bool flies = feet.y() > 0;
    for (const double side : {1.0, -1.0}) {
        const double swing = flies ? 0.12 : 0.24 * std::sin(4.2 * ran);
        const double up = flies ? 0.06 : std::max(0.0, 0.1 * side * std::cos(4.2 * ran));
        const Vec2 foot = feet + size * Vec2{side * swing - 0.06, up}, hip = feet + size * Vec2{-0.04, 0.36};
        add_solid(seen, Shape::line, colour, 14 * size, {hip, foot, foot + size * Vec2{0.1, 0}});
    }
    add_body(seen, dinosaur, colour, feet, size);
    add_solid(seen, Shape::line, colour, 7 * size, {feet + size * Vec2{0.16, 0.56}, feet + size * Vec2{0.34, 0.5}});
    add(seen, Shape::discs, Colour::ink, 0.05 * size, {feet + size * Vec2{0.18, 0.92}});
}

void draw_lanes(demo::Picture &seen, const State &now, const Input &in) {
    seen.low = {0, -0.36}, seen.high = {3.2, 1.76};
    seen.stage = Stage::yard;
    const double rolled = std::fmod(run_speed * now.time, 0.4);
    for (int i = 0; i < 9; ++i)
        add(seen, Shape::line, Colour::dim, 2, {{0.4 * i - rolled, -0.04}, {0.4 * i - rolled + 0.14, -0.04}});
    add(seen, Shape::line, Colour::dim, 2, {{1.6, -0.36}, {1.6, 1.76}}, 0.6);
    add_words(seen, {0.06, 1.62}, "one step a frame");
    add_words(seen, {1.66, 1.62}, "whole steps");
    add_words(seen, {1.66, -0.3}, "frames a second");
    const char *names[]{"first, a step a frame", "second, a step a frame", "third, a step a frame",
                        "first, in whole steps", "second, in whole steps", "third, in whole steps"};
    for (int i = 0; i < 6; ++i) {
        const double x = 0.32 + 0.49 * (i % 3) + (i >= 3 ? 1.62 : 0);
        const Lane &lane = now.lanes[i];
        const double y = std::clamp(lane.runner.place.y(), 0.0, 5.0), top = std::clamp(lane.highest, 0.0, 5.0);
        add_solid(seen, Shape::line, Colour::ink, 4, {{x - 0.2, top}, {x + 0.2, top}});
        add_runner(seen, {x, y}, 0.4, i >= 3 ? Colour::blue : Colour::orange, lane.runner.place.x());
        if (top > 0) add_number(seen, {x - 0.14, y > 0.5 * top ? 0.08 : top - 0.14}, "", top, 2, "");
        add_number(seen, {x - 0.1, -0.17}, "", std::round(1 / frame_of_lane(i % 3, in)), 0, "");
        say(seen, names[i], "m", lane.highest, 3);
    }
}

void add_cactus(demo::Picture &seen, const Vec2 &foot, double height) {
    add_solid(seen, Shape::line, Colour::green, 15, {foot + Vec2{0, 0.06}, foot + Vec2{0, height - 0.08}});
    for (const double side : {half_width, -half_width}) {
        const double low = side > 0 ? 0.4 : 0.3;
        add_solid(
            seen, Shape::line, Colour::green, 8,
            {foot + Vec2{0, low * height}, foot + Vec2{side, low * height}, foot + Vec2{side, (low + 0.35) * height}});
    }
}

/// Where something is that's seen every so many metres, and moves slower by a factor than what's near.
double passing(double ran, double every, double part, int i) { return every * i - std::fmod(part * ran, every); }

void draw_running(demo::Picture &seen, const State &now) {
    seen.low = {-1.5, -0.85}, seen.high = {6.5, 4.2};
    seen.stage = Stage::yard;
    const Vec2 at = now.ouch > 0 ? now.fell : now.run.game.shown;
    const double x = at.x();
    add_glow(seen, Shape::discs, Colour::amber, 0.36, {{5.3, 3.45}});
    for (int i = -1; i < 4; ++i) {
        const Vec2 cloud{passing(x, 3.7, 0.06, i), 3.1};
        add(seen, Shape::discs, Colour::ink, 0.24, {cloud, cloud + Vec2{0.28, 0.1}, cloud + Vec2{0.56, 0}}, 0.12);
        add_body(seen, hill, Colour::violet, {passing(x, 4, 0.2, i), 0}, 2.2, {1, 0}, 0.3);
    }
    for (int i = -1; i < 9; ++i) {
        const double stone = passing(x, 1.1, 1, i);
        add(seen, Shape::line, Colour::dim, 3, {{stone, -0.42}, {stone + 0.25, -0.42}}, 0.7);
    }
    add(seen, Shape::line, Colour::dim, 3, {{-1.5, 0}, {6.5, 0}});
    for (int number = std::max(0, int((x - 15) / 9.75)); cactus(now.run.seed, number).x < x + 7; ++number) {
        const Cactus each = cactus(now.run.seed, number);
        if (each.x > x - 2) add_cactus(seen, {each.x - x, 0}, each.height);
    }
    add_runner(seen, {0, std::clamp(at.y(), 0.0, 5.0)}, 0.9, now.ouch > 0 ? Colour::pink : Colour::orange, x);
    add_number(seen, {-1.3, 3.75}, "", x, 0, " m");
    add_number(seen, {-1.3, 3.3}, "best ", std::max(now.run.best, x), 0, " m");
    if (now.ouch > 0 || !now.led) add_words(seen, {0.6, 1.15}, now.led ? "ouch" : "jump to start");
    say(seen, "score", "m", x, 1);
    say(seen, "best", "m", now.run.best, 1);
    say(seen, "falls", "", now.run.falls, 0);
}

/// A camera that flies.
void add_drone(demo::Picture &seen, const Vec2 &at, double size, Colour colour) {
    add_solid(seen, Shape::line, Colour::dim, 4, {at + size * Vec2{-0.75, 0.42}, at + size * Vec2{0.75, 0.42}});
    add_body(seen, drone, colour, at, size);
    add_solid(seen, Shape::discs, Colour::ink, 0.24 * size, {at});
}

void draw_cameras(demo::Picture &seen, const State &now) {
    seen.low = {-5.2, -3.3}, seen.high = {5.2, 3.3};
    const auto &[slow, quick] = now.both;
    add(seen, Shape::line, Colour::orange, -2, {slow.tenth, quick.tenth, now.target});
    add(seen, Shape::line, Colour::blue, -2, {slow.ours, now.target});
    add_drone(seen, slow.tenth, 0.9, Colour::orange);
    add_drone(seen, slow.ours, 0.9, Colour::blue);
    add_drone(seen, quick.tenth, 0.55, Colour::orange);
    add_drone(seen, quick.ours, 0.55, Colour::blue);
    add_glow(seen, Shape::discs, Colour::pink, 0.13, {now.target});
    add_words(seen, {-5, 2.85}, "orange: a tenth a frame", Colour::orange);
    add_words(seen, {-5, -3.1}, "blue: by half-life", Colour::blue);
    add_words(seen, {1, -3.1}, "large 30, small 144", Colour::dim);
    say(seen, "a tenth: apart", "m", (slow.tenth - quick.tenth).norm());
    say(seen, "by half-life: apart", "m", (slow.ours - quick.ours).norm());
    say(seen, "a tenth at 144: behind", "m", (quick.tenth - now.target).norm());
    say(seen, "by half-life at 144: behind", "m", (quick.ours - now.target).norm());
}

/// Where a ship is on the track, and where it points: two straights and two bends, 800 px in all.
struct Place {
    Vec2 at, ahead;
};
Place on_track(double x, double aside) {
    constexpr double radius = 78, half_turn = 245.04422698000387, straight = finish / 2 - half_turn;
    const bool back = x >= finish / 2;
    const double way = back ? x - finish / 2 : x, turn = std::max(0.0, way - straight) / radius;
    const double along = std::min(way, straight) - straight / 2, r = radius + aside;
    const Vec2 at{along + r * std::sin(turn), -r * std::cos(turn)}, ahead{std::cos(turn), std::sin(turn)};
    return back ? Place{-at, -ahead} : Place{at, ahead};
}

void draw_laps(demo::Picture &seen, const State &now) {
    seen.low = {-196, -126}, seen.high = {196, 126};
    seen.stage = Stage::felt;
    std::vector<Vec2> rims[2];
    for (int i = 0; i <= 80; ++i)
        for (int k = 0; k < 2; ++k) rims[k].push_back(on_track(10 * i % 800, k == 0 ? 31 : -31).at);
    std::vector<Vec2> ring = rims[0];
    ring.insert(ring.end(), rims[1].rbegin(), rims[1].rend());
    add(seen, Shape::area, Colour::earth, 0, ring);
    for (const auto &rim : rims) add(seen, Shape::line, Colour::ink, 2, rim);
    add_chequers(seen, on_track(0, 31).at, 5.2, 12);
    for (int i = 0; i < 2; ++i) {
        const Racer &racer = now.racers[i];
        const Place place = on_track(std::clamp(racer.ship.x, 0.0, finish), i == 0 ? 14 : -14);
        const Colour colour = i == 0 ? Colour::blue : Colour::orange;
        add_ship(seen, place.at, 30, colour, now.time, place.ahead);
        const double column = i == 0 ? -105 : 10;
        add_words(seen, {column, 26}, i == 0 ? "kept" : "thrown away", colour);
        for (int k = 0; k < std::min(3, racer.laps); ++k)
            add_number(seen, {column, 6 - 18.0 * k}, "", now.lap_times[i][(racer.laps - k) % 3], 3, " s");
        say(seen, i == 0 ? "last lap, kept" : "last lap, thrown away", "s", racer.lap, 3);
    }
    say(seen, "laps", "", now.racers[0].laps, 0);
}

void draw_busy(demo::Picture &seen, const State &now) {
    seen.low = {-5, -2.95}, seen.high = {5, 3.45};
    for (int i = 0; i < 2; ++i) {
        const Machine &machine = now.machines[i];
        const Chase &chase = now.chases[i];
        const Vec2 middle{i == 0 ? -2.5 : 2.5, 1.5}, ball = middle + chase.ball, hunter = middle + chase.hunter;
        add_screen(seen, middle - Vec2{2.3, 1.65}, middle + Vec2{2.3, 1.75}, "");
        add_words(seen, middle + Vec2{-2.15, 1.35}, i == 0 ? "all that's due" : "with a budget");
        add_solid(seen, Shape::discs, Colour::amber, 0.22, {ball});
        add_solid(seen, Shape::discs, i == 0 ? Colour::orange : Colour::blue, 0.36, {hunter});
        add(seen, Shape::discs, Colour::ink, 0.12, {hunter + 0.1 * chase.heading});
        for (int k = 0; k < std::min(24, now.frames[i]); ++k) { // 100 ms are as high as there's room
            const double work = now.works[i][(now.frames[i] + k) % 24 % now.frames[i]];
            const Vec2 foot{middle.x() - 2.25 + 0.19 * k, -2.3};
            add_box(seen, work > 1.0 / 60 + 1e-9 ? Colour::pink : Colour::green, foot,
                    foot + Vec2{0.14, std::max(0.03, 14 * std::min(work, 0.1))}, 1, Material::solid);
        }
        const double line = 14.0 / 60 - 2.3;
        add(seen, Shape::line, Colour::ink, -2, {{middle.x() - 2.3, line}, {middle.x() + 2.3, line}});
        add_number(seen, {middle.x() - 2.25, -0.65}, "", 1000 * machine.work, 0, " ms of work");
        add_number(seen, {middle.x() - 2.25, -2.75}, "game time ", machine.game.time, 1, " s");
    }
    say(seen, "real time", "s", now.time, 1);
    say(seen, "game time, all that's due", "s", now.machines[0].game.time, 1);
    say(seen, "game time, with a budget", "s", now.machines[1].game.time, 1);
    say(seen, "a frame takes, all that's due", "ms", 1000 * now.machines[0].frame, 1);
    say(seen, "a frame takes, with a budget", "ms", 1000 * now.machines[1].frame, 1);
}

void draw_friend(demo::Picture &seen, const State &now) {
    seen.low = {-5, -3.15}, seen.high = {5, 3.15};
    for (const Sent &each : now.line)
        if (each.arrives <= now.time) add(seen, Shape::discs, Colour::amber, 0.06, {each.packet.place});
    for (int i = 0; i < std::min(8, now.losses); ++i)
        add_words(seen, flight(now.lost[i]) - Vec2{0.08, 0.08}, "×", Colour::pink);
    const Vec2 there = flight(now.time), way = there - flight(now.time - 0.1), ahead = way / way.norm();
    add_body(seen, hull, Colour::ink, there, 0.85, ahead, 0.28);
    add_ship(seen, now.seen, 0.85, Colour::blue, now.time, ahead);
    add_body(seen, hull, Colour::orange, now.news, 0.85, ahead, 0.75);
    add_words(seen, {-4.8, 2.7}, "blue: yours", Colour::blue);
    add_words(seen, {-4.8, -2.95}, "orange: newest packet", Colour::orange);
    add_words(seen, {1.55, -2.95}, "pale: where it is", Colour::dim);
    say(seen, "longest hop, newest packet", "m", *std::max_element(now.hops[1], now.hops[1] + 120));
    say(seen, "longest hop, yours", "m", *std::max_element(now.hops[0], now.hops[0] + 120));
    say(seen, "yours, behind", "m", (there - now.seen).norm());
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    seen.stage = Stage::night; // but for what's outdoors
    switch (now.mode) {
    case who_is_first: draw_guess(seen, now); break;
    case screens: draw_screens(seen, now); break;
    case sleeping: draw_sleeping(seen, now); break;
    case whole_steps: draw_lanes(seen, now, in); break;
    case running: draw_running(seen, now); break;
    case cameras: draw_cameras(seen, now); break;
    case laps: draw_laps(seen, now); break;
    case busy: draw_busy(seen, now); break;
    case with_a_friend: draw_friend(seen, now); break;
    }
    return seen;
}
} // namespace play
