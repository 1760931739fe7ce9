#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace forward_kinematics;
using demo::Colour, demo::Input, demo::Shape;

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
                        {-9, -5.3},
                        {9, 5.3},
                        {demo::choice("The game", games, you_guess),
                         {"first motor", "rad/s", -6, 6, 1, 1, {}, in_games({drawing})},
                         {"second motor", "rad/s", -6, 6, 1, 4, {}, in_games({drawing})},
                         {"place", "m", -5, 5, 0.1, -3, {}, in_games({digging})},
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
                         {"n", "New", in_games({crossing})}}};
const demo::Still still{1.6};

struct State {
    Game game = you_guess;
    bool shown = false;                  ///< whether the truth is
    Vec2 guess{4, 2};                    ///< where the hand may be [m]
    Arm arm{};                           ///< that draws
    Vec2 base{0, 0};                     ///< of the links [m]
    std::vector<Link> links{};           ///< of the arm whose joints one turns
    Box box{};                           ///< that it picks up
    Site site{};                         ///< with a digger to be driven
    bool closed = false;                 ///< whether its bucket is
    int round = 0;                       ///< of the crane
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

/// A pose with all of the arm on one side of the wall, and another one in each round.
Pose pose_on(double side, int round) {
    for (unsigned seed = unsigned(round) * 2654435761u + (side > 0 ? 77u : 1u);; seed = seed * 1664525u + 1013904223u) {
        const Pose pose{(double(seed >> 20) / 4096 * 2 - 1) * 3.1, (double(seed >> 8 & 4095) / 4096 * 2 - 1) * 2.6};
        const std::vector<Vec2> all = joints_of(pose);
        const auto is_fine = [&](const Vec2 &at) { return side * at.x() > 0.5 && at.y() > 0.3; };
        if (is_fine(all[1]) && is_fine(all[2])) return pose;
    }
}

/// The choice of the game begins it anew; the other controls do not.
void start(State &now) {
    now.time = 0;
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

/// The arm above the ground is drawn this much lower [m].
constexpr double sunk = 3.5;

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
    Vec2 there = in.pointer;
    if (now.game == grounded) there.y() += sunk;
    const std::vector<Vec2> all = joints(now.base, now.links);
    const std::size_t i = std::size_t(in.handle);
    turn(now, in.handle, angle_from(all[i + 1] - all[i], there - all[i]));
}

void press(State &now, const Input &in) {
    if (in.key == "f") now.shown = true;
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

void add_list(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::vector<Vec2> &points,
              double strength = 1) {
    seen.shapes.push_back({kind, colour, size, strength, points});
}
void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::initializer_list<Vec2> &points,
         double strength = 1) {
    add_list(seen, kind, colour, size, points, strength);
}
void add_arrow(demo::Picture &seen, Colour colour, const Vec2 &from, const Vec2 &arrow) {
    add(seen, Shape::arrow, colour, 3, {from, from + arrow});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour = Colour::ink) {
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
/// An area whose corners are given as seen from a frame.
void add_part(demo::Picture &seen, const Frame &frame, Colour colour, std::initializer_list<Vec2> corners) {
    std::vector<Vec2> points;
    for (const Vec2 &corner : corners) points.push_back(in_world(frame, corner));
    add_list(seen, Shape::area, colour, 0, points, 1);
}
void add_arm(demo::Picture &seen, const std::vector<Vec2> &all, bool handles = true) {
    add_list(seen, Shape::line, Colour::blue, 6, all);
    add_list(seen, Shape::discs, Colour::ink, 0.12, all);
    for (std::size_t i = 1; handles && i < all.size(); ++i) add(seen, Shape::handle, Colour::orange, 0, {all[i]});
}

void draw_guess(demo::Picture &seen, const State &now) {
    for (int i = -1; i <= 5; ++i) {
        const double at = i;
        add(seen, Shape::line, Colour::line, 1, {{at, -1}, {at, 5}});
        add(seen, Shape::line, Colour::line, 1, {{-1, at}, {5, at}});
    }
    const auto [elbow, hand] = two_links({3, 30 * degree}, {2, 45 * degree});
    if (now.shown) add_arm(seen, {{0, 0}, elbow, hand}, false);
    add(seen, Shape::discs, Colour::ink, 0.15, {{0, 0}});
    add_words(seen, now.guess + Vec2{0.3, 0.3}, "hand?", Colour::orange);
    add(seen, Shape::handle, Colour::orange, 0, {now.guess});
    if (!now.shown) return;
    say_place(seen, hand);
    say(seen, "off by", "m", (now.guess - hand).norm());
}

void draw_drawing(demo::Picture &seen, const State &now) {
    const auto [elbow, hand] = two_links(now.arm.first, now.arm.second);
    if (now.arm.trail.size() > 1) add_list(seen, Shape::line, Colour::pink, 2, now.arm.trail);
    add_arm(seen, {{0, 0}, elbow, hand});
    say_place(seen, hand);
}

void draw_digger(demo::Picture &seen, const Input &in) {
    const double slope = in["slope"] * degree, c = std::cos(slope), s = std::sin(slope);
    const Vec2 along{c, s}, up{-s, c}, stone{3.5, -2.6};
    Digger it{{along, up, Vec2{0, -3} + in["place"] * along},
              {3.2, in["boom"] * degree},
              {2.4, in["stick"] * degree},
              {0.5, in["bucket"] * degree}};
    const Parts parts = parts_of(it);
    add(seen, Shape::line, Colour::dim, 2, {Vec2{0, -3} - 12 * along, Vec2{0, -3} + 12 * along});
    add(seen, Shape::discs, Colour::dim, 0.25, {stone});
    add_part(seen, parts.cab, Colour::ink, {{-1.6, 0}, {1.2, 0}, {1.4, 0.3}, {1.2, 0.55}, {-1.6, 0.55}, {-1.8, 0.3}});
    add_part(seen, parts.cab, Colour::amber,
             {{-1.5, 0.65}, {0.9, 0.65}, {0.9, 1.3}, {0.3, 2.3}, {-0.6, 2.3}, {-0.8, 1.4}, {-1.5, 1.4}});
    const Vec2 joint = in_world(parts.cab, {0.5, 1.2});
    add(seen, Shape::line, Colour::orange, 8, {joint, parts.boom.origin, parts.stick.origin});
    add_part(seen, parts.bucket, Colour::ink, {{-0.6, 0.1}, {0.1, 0.15}, {0.5, -0.45}, {0, -0.75}, {-0.55, -0.5}});
    add(seen, Shape::discs, Colour::ink, 0.1, {joint, parts.boom.origin, parts.stick.origin});
    const Vec2 teeth = in_world(parts.bucket, {0.5, -0.45});
    say(seen, "to the stone", "m", (teeth - stone).norm());
}

void draw_arrows(demo::Picture &seen, const State &now) {
    const std::vector<Vec2> all = joints(now.base, now.links), columns = jacobian(now.links);
    const Vec2 hand = all.back(), a = columns[0], b = columns[1];
    add(seen, Shape::area, Colour::amber, 0, {hand, hand + a, hand + a + b, hand + b}, 0.3);
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
    add_part(seen, now.box.place, now.box.held ? Colour::violet : Colour::dim,
             {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
    add_arm(seen, joints(now.base, now.links));
    add_arrow(seen, Colour::pink, hand.origin, hand.x_axis);
    add_arrow(seen, Colour::green, hand.origin, hand.y_axis);
    say(seen, "box, up", "m", now.box.place.origin.y());
    say(seen, "along the hand's x axis", "m", there.x());
    say(seen, "along its y axis", "m", there.y());
}

void draw_grounded(demo::Picture &seen, const State &now) {
    std::vector<Vec2> all = joints(now.base, now.links);
    double lowest = all[0].y();
    for (Vec2 &at : all) {
        lowest = std::min(lowest, at.y());
        at.y() -= sunk;
    }
    add(seen, Shape::line, Colour::dim, 4, {{-9, -sunk}, {9, -sunk}});
    add(seen, Shape::line, Colour::ink, 3, {{0, -sunk}, all[0]});
    add_arm(seen, all);
    say(seen, "lowest", "m", lowest);
    say(seen, "hand, up", "m", all.back().y() + sunk);
}

/// The ground of these two, drawn lower [m].
const Vec2 down{0, -4};
std::vector<Vec2> lowered(std::vector<Vec2> points) {
    for (Vec2 &each : points) each += down;
    return points;
}

void draw_driving(demo::Picture &seen, const State &now) {
    const Site &site = now.site;
    const std::vector<Vec2> all =
        lowered(joints({site.place, boom_height},
                       {{boom_length, site.boom}, {stick_length, site.stick}, {bucket_length, site.bucket}}));
    const Frame cab{{1, 0}, {0, 1}, Vec2{site.place - 0.5, 0} + down};
    add(seen, Shape::line, Colour::dim, 4, {Vec2{-9, 0} + down, Vec2{9, 0} + down});
    add_part(seen, cab, Colour::ink, {{-1.6, 0}, {1.2, 0}, {1.4, 0.3}, {1.2, 0.55}, {-1.6, 0.55}, {-1.8, 0.3}});
    add_part(seen, cab, Colour::amber,
             {{-1.5, 0.65}, {0.9, 0.65}, {0.9, 1.3}, {0.3, 2.3}, {-0.6, 2.3}, {-0.8, 1.4}, {-1.5, 1.4}});
    add(seen, Shape::line, Colour::orange, 8, {all[0], all[1], all[2]});
    add(seen, Shape::line, now.closed ? Colour::violet : Colour::ink, 10, {all[2], all[3]});
    add(seen, Shape::discs, Colour::ink, 0.1, {all[0], all[1], all[2]});
    add(seen, Shape::discs, site.held ? Colour::violet : Colour::dim, 0.2, {site.stone + down});
    say(seen, "to the stone", "m", (all[3] - down - site.stone).norm());
    say(seen, "stone, to the right", "m", site.stone.x());
    say(seen, "stone, up", "m", site.stone.y());
}

void draw_crossing(demo::Picture &seen, const State &now) {
    add(seen, Shape::line, Colour::dim, 4, {Vec2{-9, 0} + down, Vec2{9, 0} + down});
    add_part(seen, {{1, 0}, {0, 1}, down}, Colour::violet,
             {{-0.08, 0}, {0.08, 0}, {0.08, crane.wall}, {-0.08, crane.wall}});
    add(seen, Shape::line, Colour::ink, 3, {Vec2{0, crane.wall} + down, Vec2{0, crane.height} + down});
    for (const Pose &pose : {now.poses.front(), now.poses.back()})
        add_list(seen, Shape::line, Colour::dim, -2, lowered(joints_of(pose)));
    const int at = std::min(int(now.time * 30) % (int(now.poses.size()) + 30), int(now.poses.size()) - 1);
    const std::vector<Vec2> all = lowered(joints_of(now.poses[std::size_t(at)]));
    add_arm(seen, all, false);
    add(seen, Shape::discs, Colour::pink, 0.3, {all.back()});
    double lowest = 1e3;
    for (const Pose &pose : now.poses)
        for (const Vec2 &point : joints_of(pose)) lowest = std::min(lowest, point.y());
    say(seen, "poses", "", double(now.poses.size()), 0);
    say(seen, "lowest point of all", "m", lowest);
}

demo::Picture draw(const State &now, const Input &in) {
    demo::Picture seen;
    switch (now.game) {
    case you_guess: draw_guess(seen, now); break;
    case drawing: draw_drawing(seen, now); break;
    case digging: draw_digger(seen, in); break;
    case swinging:
        add_arm(seen, joints({0, -4}, tentacle(int(in["links"]), 8, in["swing"] * degree, in["lag"], now.time)), false);
        break;
    case arrows: draw_arrows(seen, now); break;
    case carrying: draw_carrying(seen, now); break;
    case grounded: draw_grounded(seen, now); break;
    case driving: draw_driving(seen, now); break;
    case crossing: draw_crossing(seen, now); break;
    }
    return seen;
}
} // namespace play
