#include "../demo.hpp"
#include "../chance.hpp"

#include "game.hpp"

#include <string>

//> The demo
namespace play {
using namespace forward_kinematics;
using demo::Colour, demo::Input, demo::Material, demo::Shape, demo::Stage;

enum Game { you_guess, drawing, digging, swinging, arrows, carrying, grounded, driving, crossing };

const std::vector<std::string_view> games{
    "you guess",     "an arm that draws (9.1)", "a digger (9.2)",   "tentacle (9.3)",     "how the hand moves (9.5)",
    "pick up (9.6)", "above the ground (9.7)",  "in the cab (9.4)", "over the wall (9.8)"};

std::vector<std::string_view> in_games(std::initializer_list<Game> which) {
    std::vector<std::string_view> names;
    for (const Game game : which) names.push_back(games[game]);
    return names;
}

const demo::About about{"Arms, and where their hands are.",
                        {-8, -4},
                        {8, 7.4},
                        {demo::choice("The game", games, you_guess),
                         {"first motor", "rad/s", -6, 6, 1, 1, {}, in_games({drawing})},
                         {"second motor", "rad/s", -6, 6, 1, 4, {}, in_games({drawing})},
                         {"place", "m", -5, 3, 0.1, -3, {}, in_games({digging})},
                         {"slope", "°", -20, 20, 1, 0, {}, in_games({digging})},
                         {"boom", "°", 0, 90, 1, 50, {}, in_games({digging})},
                         {"stick", "°", -150, 0, 1, -70, {}, in_games({digging})},
                         {"bucket", "°", -120, 60, 1, -30, {}, in_games({digging})},
                         {"links", "", 1, 40, 1, 20, {}, in_games({swinging})},
                         {"swing", "°", 0, 30, 1, 8, {}, in_games({swinging})},
                         {"lag", "rad", 0, 1, 0.05, 0.25, {}, in_games({swinging})},
                         {"joint", "", 1, 3, 1, 1, {}, in_games({arrows, carrying, grounded})},
                         {"drive", "", -1, 1, 0.1, 0, {}, in_games({driving})},
                         {"lift the boom", "", -1, 1, 0.1, 0, {}, in_games({driving})},
                         {"lift the stick", "", -1, 1, 0.1, 0, {}, in_games({driving})},
                         {"curl the bucket", "", -1, 1, 0.1, 0, {}, in_games({driving})}},
                        {{"f", "Show", in_games({you_guess})},
                         {"t", "Take, or let go", in_games({carrying})},
                         {"u", "Turn left", in_games({arrows, carrying, grounded})},
                         {"d", "Turn right", in_games({arrows, carrying, grounded})},
                         {"c", "Close, or open", in_games({driving})},
                         {"n", "New", in_games({you_guess, crossing})}}};
const demo::Still still{1.6};

struct State {
    Game game = you_guess;
    bool shown = false;                  ///< whether the truth is
    Vec2 guess{4, 2};                    ///< where the hand may be [m]
    Link bolted[2]{};                    ///< the arm of the guess
    std::vector<Vec2> misses{};          ///< from the hand to the last five guesses [m]
    Arm arm{};                           ///< that draws
    Vec2 base{0, 0};                     ///< of the links [m]
    std::vector<Link> links{};           ///< of the arm whose joints one turns
    Box box{};                           ///< that it picks up
    Site site{};                         ///< with a digger to be driven
    bool closed = false;                 ///< whether its bucket is
    int round = 0;                       ///< of the guess, and of the crane
    std::vector<Pose> poses{};           ///< that carry its load over the wall
    double time{}, spare{}, chosen = -1; ///< [s], [s], the sum of all controls
};

State begin() { return {}; }

/// Not inline, which saves the page some bytes.
[[gnu::noinline]] Frame hand_frame(const State &now) { return hand_of(now.base, now.links); }

constexpr Crane crane{3.4, 2.6, 2.2, 2.7};
std::vector<Vec2> joints_of(const Pose &pose) {
    return joints({0, crane.height}, {{crane.first, pose.first}, {crane.second, pose.second}});
}

/// A pose with all of the arm on one side of the wall, and another one in each round. The first one's way is a long one.
Pose pose_on(double side, int round) {
    for (course::Dice dice{unsigned(round == 0 ? 10 : round) * 2654435761u + (side > 0 ? 77u : 1u)};; dice.roll()) {
        const auto part = [](unsigned bits) { return double(bits % 4096) / 4096 * 2 - 1; }; // -1 to 1
        const Pose pose{part(dice.seed >> 20) * 3.1, part(dice.seed >> 8) * 2.6};
        const std::vector<Vec2> all = joints_of(pose);
        const auto is_fine = [&](const Vec2 &at) { return side * at.x() > 0.5 && at.y() > 0.3; };
        if (is_fine(all[1]) && is_fine(all[2])) return pose;
    }
}

/// The arm of the guess: in the first round the chapter's own, and then others that stay above the table.
void bolt(State &now) {
    now.bolted[0] = {3, 30 * degree};
    now.bolted[1] = {2, 45 * degree};
    for (course::Dice dice{unsigned(now.round) * 2654435761u}; now.round > 0;) {
        const auto whole = [&](int count) { return std::floor(count * dice.one()); };
        now.bolted[0] = {1.5 + 0.5 * whole(5), 15 * degree * whole(7)};
        now.bolted[1] = {1 + 0.5 * whole(4), 15 * degree * (whole(13) - 6)};
        const Vec2 hand = two_links(now.bolted[0], now.bolted[1]).hand;
        if (now.bolted[1].angle != 0 && hand.x() > 0.3 && hand.x() < 4.8 && hand.y() > 0.2 && hand.y() < 3.7) return;
    }
}

/// The choice of the game begins it anew; the other controls do not.
void start(State &now) {
    now.time = 0;
    now.shown = false;
    now.guess = {4, 2};
    bolt(now);
    now.base = {-1, -2.5};
    now.arm = {{3, 0}, {2, 0}, {}};
    now.box = {{{1, 0}, {0, 1}, {2.5, 0.5}}, {}, false};
    now.links = {{2.2, 100 * degree}, {1.8, -60 * degree}, {1.2, -30 * degree}};
    if (now.game == grounded) now.base = {0, 2};
    if (now.game == arrows) now.links = {{3, 45 * degree}, {2, 90 * degree}};
    now.site = {-5, 55 * degree, -75 * degree, -40 * degree, {1.5, 0.2}, false};
    now.closed = false;
    if (now.game == crossing) now.poses = over_the_wall(crane, pose_on(-1, now.round), pose_on(1, now.round));
}

/// Turns one joint of the arm; above the ground, as far as that allows.
void turn(State &now, int joint, double by) {
    if (now.game == grounded) by = turn_above_ground(now.base, now.links, joint, by);
    now.links[std::size_t(joint)].angle += by;
}

/// From an arrow's direction to another's, the shorter way [rad].
double angle_from(const Vec2 &from, const Vec2 &to) {
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// A link follows the pointer as well as it can: it points there.
void drag(State &now, const Input &in) {
    if (now.game == you_guess) now.guess = in.pointer;
    if (now.game == drawing) {
        const auto [elbow, hand] = two_links(now.arm.first, now.arm.second);
        if (in.handle == 0) now.arm.first.angle += angle_from(elbow, in.pointer);
        else now.arm.second.angle += angle_from(hand - elbow, in.pointer - elbow);
    }
    if (now.game != arrows && now.game != carrying && now.game != grounded) return;
    const std::vector<Vec2> all = joints(now.base, now.links);
    const std::size_t i = std::size_t(in.handle);
    turn(now, in.handle, angle_from(all[i + 1] - all[i], in.pointer - all[i]));
}

/// The answer is shown, and how far off the guess is stays.
void reveal(State &now) {
    if (now.shown) return;
    now.shown = true;
    now.misses.push_back(now.guess - two_links(now.bolted[0], now.bolted[1]).hand);
    if (now.misses.size() > 5) now.misses.erase(now.misses.begin());
}

void press(State &now, const Input &in) {
    if (in.key == "f") reveal(now);
    if (in.key == "t" && now.box.held) now.box.held = false;
    else if (in.key == "t") take(now.box, hand_frame(now));
    const int joint = std::min(int(in["joint"]), int(now.links.size())) - 1;
    if (in.key == "c") now.closed = !now.closed;
    if (in.key == "n") {
        ++now.round;
        start(now);
    }
    if (in.key == "u") turn(now, joint, 5 * degree);
    if (in.key == "d") turn(now, joint, -5 * degree);
}

void step(State &now, const Input &in) {
    now.time += frame_time;
    if (now.game == drawing) {
        next_frame(now.arm, in["first motor"], in["second motor"], frame_time);
        if (now.arm.trail.size() > 900) now.arm.trail.clear();
        for (Link *link : {&now.arm.first, &now.arm.second}) // if the motors run for hours
            if (std::abs(link->angle) > 1e4) link->angle = std::remainder(link->angle, 360 * degree);
    }
    if (now.game == carrying) next_frame(now.box, hand_frame(now));
    if (now.game == driving)
        now.site = next_frame(
            now.site, {in["drive"], in["lift the boom"], in["lift the stick"], in["curl the bucket"], now.closed},
            frame_time);
}

State next(State now, const Input &in) {
    if (const double chosen = in["The game"]; chosen != now.chosen) {
        now.chosen = chosen;
        now.game = static_cast<Game>(chosen);
        start(now);
    }
    if (in.handle >= 0) drag(now, in);
    press(now, in);
    for (int due = demo::steps_due(now.spare, in, frame_time); due > 0; --due) step(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

/// What's seen of the world in each game [m]: what moves there fills at least a third of it.
const Vec2 windows[][2]{{{-0.9, -0.7}, {5.7, 4.5}}, {{-7.6, -5.2}, {7.6, 5.2}}, {{-6.9, -1.2}, {5.6, 6.8}},
                        {{-6.6, -1.2}, {6.6, 8.6}}, {{-6, -3.4}, {6, 5.4}},     {{-5.2, -3.5}, {4.6, 3.1}},
                        {{-5.6, -0.9}, {5.6, 6.7}}, {{-7.4, -1.1}, {4.2, 6.4}}, {{-6, -0.8}, {6, 8.7}}};

Shape &add_list(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::vector<Vec2> &points,
                double strength = 1) {
    seen.shapes.push_back({kind, colour, size, strength, points});
    return seen.shapes.back();
}
Shape &add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::initializer_list<Vec2> &points,
           double strength = 1) {
    return add_list(seen, kind, colour, size, points, strength);
}
void solid(Shape &shape) { shape.material = Material::solid; }
void glow(Shape &shape) { shape.material = Material::glow; }

void add_arrow(demo::Picture &seen, Colour colour, const Vec2 &from, const Vec2 &arrow) {
    add(seen, Shape::arrow, colour, 3, {from, from + arrow});
}
void add_words(demo::Picture &seen, const Vec2 &at, const std::string &words, Colour colour = Colour::ink) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
/// Without the last digits, which are rounding, and without a negative zero.
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, std::round(value * 1e6) / 1e6 + 0.0, decimals});
}
void say_place(demo::Picture &seen, const Vec2 &hand) {
    say(seen, "hand, to the right", "m", hand.x());
    say(seen, "hand, up", "m", hand.y());
}
/// With up to two digits behind the point: enough for a picture, and much smaller than std::format.
std::string rounded(double value) {
    const int hundredths = int(std::round(std::abs(value) * 100));
    std::string digits = std::to_string(hundredths % 100 + 100);
    digits[0] = '.';
    while (digits.back() == '0') digits.pop_back();
    return (value < 0 ? "−" : "") + std::to_string(hundredths / 100) + (digits == "." ? "" : digits);
}
/// A body whose corners are given as seen from a frame.
void add_part(demo::Picture &seen, const Frame &frame, Colour colour, std::initializer_list<Vec2> corners) {
    std::vector<Vec2> points;
    for (const Vec2 &corner : corners) points.push_back(in_world(frame, corner));
    solid(add_list(seen, Shape::area, colour, 0, points));
}
void add_body(demo::Picture &seen, Colour colour, std::initializer_list<Vec2> corners) {
    add_part(seen, {{1, 0}, {0, 1}, {0, 0}}, colour, corners);
}
/// Links of steel, bolted together.
void add_arm(demo::Picture &seen, const std::vector<Vec2> &all, bool handles = true, double width = 15) {
    solid(add_list(seen, Shape::line, Colour::dim, width, all));
    solid(add_list(seen, Shape::discs, Colour::ink, 0.13, all));
    for (std::size_t i = 1; handles && i < all.size(); ++i) add(seen, Shape::handle, Colour::orange, 0, {all[i]});
}
/// What an arm is bolted to.
void add_foot(demo::Picture &seen, const Vec2 &at, double down) {
    add_body(seen, Colour::dim,
             {at + Vec2{-0.2, 0.1}, at + Vec2{0.2, 0.1}, at + Vec2{0.45, -down}, at + Vec2{-0.45, -down}});
}

void draw_bench(demo::Picture &seen) {
    for (int i = -1; i <= 6; ++i) {
        const double at = i;
        add(seen, Shape::line, Colour::dim, 1, {{at, -1}, {at, 5}}, 0.3);
        add(seen, Shape::line, Colour::dim, 1, {{-1, at}, {6, at}}, 0.3);
    }
    add_body(seen, Colour::wood, {{-1, -0.35}, {6, -0.35}, {6, -0.8}, {-1, -0.8}});
    add_foot(seen, {0, 0}, 0.35);
}

/// How far off, and the last five guesses around the hand, as holes around the middle of a target.
void draw_misses(demo::Picture &seen, const State &now, const Vec2 &hand) {
    for (std::size_t i = 0; i < now.misses.size(); ++i)
        glow(add(seen, Shape::discs, Colour::amber, 0.05, {hand + now.misses[i]},
                 0.4 + 0.6 * double(i + 1) / double(now.misses.size())));
    add(seen, Shape::line, Colour::orange, -2, {now.guess, hand});
    const double off = (now.guess - hand).norm();
    const double aside = now.guess.y() > hand.y() ? 0.2 : -0.35; // away from the hand
    add_words(seen, now.guess + Vec2{0.15, aside}, rounded(off) + " m off", Colour::orange);
    say_place(seen, hand);
    say(seen, "off by", "m", off);
}

void draw_guess(demo::Picture &seen, const State &now) {
    draw_bench(seen);
    const auto &[first, second] = now.bolted;
    const auto [elbow, hand] = two_links(first, second);
    if (now.shown) add_arm(seen, {{0, 0}, elbow, hand}, false, 18);
    else solid(add(seen, Shape::discs, Colour::ink, 0.15, {{0, 0}}));
    const auto set_up = [](const Link &link, const char *how) {
        return rounded(link.length) + " m" + how + rounded(link.angle / degree) + "°";
    };
    add_words(seen, {-0.7, 4.15}, set_up(first, " at ") + ", then " + set_up(second, ", bent by "));
    if (now.shown) draw_misses(seen, now, hand);
    else add_words(seen, now.guess + Vec2{0.2, 0.2}, "hand?", Colour::orange);
    glow(add(seen, Shape::discs, Colour::orange, 0.08, {now.guess}));
    add(seen, Shape::handle, Colour::orange, 0, {now.guess});
}

void draw_drawing(demo::Picture &seen, const State &now) {
    const auto [elbow, hand] = two_links(now.arm.first, now.arm.second);
    if (now.arm.trail.size() > 1) glow(add_list(seen, Shape::line, Colour::pink, 2.5, now.arm.trail));
    add_arm(seen, {{0, 0}, elbow, hand});
    glow(add(seen, Shape::discs, Colour::pink, 0.12, {hand}));
    say_place(seen, hand);
}

/// The cab of both diggers, with what turns on it: its boom's joint, and the joints of stick and bucket.
void add_cab(demo::Picture &seen, const Frame &cab, const std::vector<Vec2> &arm) {
    add_part(seen, cab, Colour::ink, {{-1.6, 0}, {1.2, 0}, {1.4, 0.3}, {1.2, 0.6}, {-1.6, 0.6}, {-1.8, 0.3}});
    for (int i = 0; i < 4; ++i)
        solid(add(seen, Shape::discs, Colour::dim, 0.2, {in_world(cab, {-1.4 + 0.8 * i, 0.3})}));
    add_part(seen, cab, Colour::amber,
             {{-1.6, 0.65}, {1, 0.65}, {1, 1.3}, {0.3, 2.3}, {-0.6, 2.3}, {-0.7, 1.5}, {-1.6, 1.4}});
    add_part(seen, cab, Colour::blue, {{-0.4, 1.4}, {0.65, 1.4}, {0.2, 2.1}, {-0.4, 2.1}});
    solid(add_list(seen, Shape::line, Colour::orange, 15, arm));
}
void add_bolts(demo::Picture &seen, const std::vector<Vec2> &all) {
    solid(add_list(seen, Shape::discs, Colour::ink, 0.13, all));
}

void draw_digger(demo::Picture &seen, const Input &in) {
    const double slope = in["slope"] * degree, c = std::cos(slope), s = std::sin(slope);
    const Vec2 along{c, s}, up{-s, c}, stone{3.5, 0.4};
    Digger it{{along, up, in["place"] * along},
              {3.2, in["boom"] * degree},
              {2.4, in["stick"] * degree},
              {0.5, in["bucket"] * degree}};
    const Parts parts = parts_of(it);
    add_body(seen, Colour::earth, {-14 * along, 14 * along, 14 * along - 20 * up, -14 * along - 20 * up});
    solid(add(seen, Shape::discs, Colour::dim, 0.4, {stone}));
    const std::vector<Vec2> arm{in_world(parts.cab, {0.5, 1.2}), parts.boom.origin, parts.stick.origin};
    add_cab(seen, parts.cab, arm);
    add_part(seen, parts.bucket, Colour::ink, {{-0.6, 0.1}, {0.1, 0.15}, {0.5, -0.45}, {0, -0.75}, {-0.55, -0.5}});
    add_bolts(seen, arm);
    say(seen, "to the stone", "m", (in_world(parts.bucket, {0.5, -0.45}) - stone).norm());
}

/// A beast with a long arm of so many links, and two that are shorter.
void draw_beast(demo::Picture &seen, const Input &in, double time) {
    const int count = int(in["links"]);
    const auto arm = [&](double x, int links, double length, double later) {
        return joints({x, 0}, tentacle(links, length, in["swing"] * degree, in["lag"], time + later));
    };
    for (const double side : {-2.2, 2.2})
        solid(add_list(seen, Shape::line, Colour::blue, 18, arm(side, (count + 1) / 2, 5, side)));
    const std::vector<Vec2> all = arm(0, count, 8, 0);
    solid(add_list(seen, Shape::line, Colour::green, 26, all));
    solid(add_list(seen, Shape::discs, Colour::amber, 0.1, all));
    solid(add(seen, Shape::area, Colour::violet, 0,
              {{-4, -1.3}, {-3.4, -0.2}, {-1.8, 0.5}, {1.8, 0.5}, {3.4, -0.2}, {4, -1.3}}));
    for (const double x : {-0.7, 0.7}) {
        solid(add(seen, Shape::discs, Colour::ink, 0.42, {{x, -0.3}}));
        add(seen, Shape::discs, Colour::violet, 0.2, {{x + 0.12 * std::sin(time), -0.22}});
    }
}

void draw_arrows(demo::Picture &seen, const State &now) {
    const std::vector<Vec2> all = joints(now.base, now.links), columns = jacobian(now.links);
    const Vec2 hand = all.back(), a = columns[0], b = columns[1];
    add(seen, Shape::area, Colour::amber, 0, {hand, hand + a, hand + a + b, hand + b}, 0.3);
    add_foot(seen, now.base, 0.9);
    add_arm(seen, all);
    add_arrow(seen, Colour::pink, hand, a);
    add_arrow(seen, Colour::green, hand, b);
    add_words(seen, hand + a + Vec2{0, 0.4}, "by the first joint", Colour::pink);
    add_words(seen, hand + b - Vec2{0, 0.4}, "by the elbow", Colour::green);
    say(seen, "area", "m²", a.x() * b.y() - a.y() * b.x());
}

void draw_carrying(demo::Picture &seen, const State &now) {
    const Frame hand = hand_frame(now);
    const Vec2 there = to_local(hand, now.box.place.origin);
    add_part(seen, now.box.place, now.box.held ? Colour::violet : Colour::wood,
             {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
    add_foot(seen, now.base, 1.7);
    add_arm(seen, joints(now.base, now.links));
    add_arrow(seen, Colour::pink, hand.origin, hand.x_axis);
    add_arrow(seen, Colour::green, hand.origin, hand.y_axis);
    add_words(seen, hand.origin + 1.25 * hand.x_axis, "x", Colour::pink);
    add_words(seen, hand.origin + 1.25 * hand.y_axis, "y", Colour::green);
    say(seen, "box, up", "m", now.box.place.origin.y());
    say(seen, "along the hand's x axis", "m", there.x());
    say(seen, "along its y axis", "m", there.y());
}

void draw_grounded(demo::Picture &seen, const State &now) {
    const std::vector<Vec2> all = joints(now.base, now.links);
    double lowest = all[0].y();
    for (const Vec2 &at : all) lowest = std::min(lowest, at.y());
    add_foot(seen, now.base, 2);
    add_arm(seen, all);
    say(seen, "lowest", "m", lowest);
    say(seen, "hand, up", "m", all.back().y());
}

void draw_driving(demo::Picture &seen, const State &now) {
    const Site &site = now.site;
    const std::vector<Link> links{{boom_length, site.boom}, {stick_length, site.stick}, {bucket_length, site.bucket}};
    const std::vector<Vec2> all = joints({site.place, boom_height}, links);
    add_cab(seen, {{1, 0}, {0, 1}, {site.place - 0.5, 0}}, {all[0], all[1], all[2]});
    Frame scoop = hand_of(all[0], links); // its teeth are its origin
    const double open = now.closed ? 0.25 : 0.6;
    add_part(seen, scoop, now.closed ? Colour::violet : Colour::ink,
             {{-0.75, 0.2}, {0, 0}, {-0.05, -0.2}, {-0.4, -open}, {-0.8, -0.3}});
    add_bolts(seen, {all[0], all[1], all[2]});
    solid(add(seen, Shape::discs, site.held ? Colour::violet : Colour::dim, 0.2, {site.stone}));
    say(seen, "to the stone", "m", (all[3] - site.stone).norm());
    say(seen, "stone, to the right", "m", site.stone.x());
    say(seen, "stone, up", "m", site.stone.y());
}

void draw_crossing(demo::Picture &seen, const State &now) {
    add_body(seen, Colour::orange, {{-0.14, 0}, {0.14, 0}, {0.14, crane.wall}, {-0.14, crane.wall}});
    add_body(seen, Colour::ink, {{-0.07, crane.wall}, {0.07, crane.wall}, {0.07, crane.height}, {-0.07, crane.height}});
    for (const Pose &pose : {now.poses.front(), now.poses.back()})
        add_list(seen, Shape::line, Colour::dim, 6, joints_of(pose), 0.4);
    const int at = std::min(int(now.time * 30) % (int(now.poses.size()) + 30), int(now.poses.size()) - 1);
    const std::vector<Vec2> all = joints_of(now.poses[std::size_t(at)]);
    add_arm(seen, all, false);
    solid(add(seen, Shape::discs, Colour::pink, 0.35, {all.back()}));
    double lowest = 1e3;
    for (const Pose &pose : now.poses)
        for (const Vec2 &point : joints_of(pose)) lowest = std::min(lowest, point.y());
    say(seen, "poses", "", double(now.poses.size()), 0);
    say(seen, "lowest point of all", "m", lowest);
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    const bool outside = now.game == digging || now.game == grounded || now.game == driving || now.game == crossing;
    seen.stage = outside ? Stage::yard : Stage::night;
    seen.low = windows[now.game][0], seen.high = windows[now.game][1];
    switch (now.game) {
    case you_guess: draw_guess(seen, now); break;
    case drawing: draw_drawing(seen, now); break;
    case digging: draw_digger(seen, in); break;
    case swinging: draw_beast(seen, in, now.time); break;
    case arrows: draw_arrows(seen, now); break;
    case carrying: draw_carrying(seen, now); break;
    case grounded: draw_grounded(seen, now); break;
    case driving: draw_driving(seen, now); break;
    case crossing: draw_crossing(seen, now); break;
    }
    return seen;
}
} // namespace play
