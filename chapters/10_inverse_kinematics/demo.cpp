#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace inverse_kinematics;
using demo::Colour, demo::Input, demo::Material, demo::Shape, demo::Stage;
using forward_kinematics::joints;

enum Game { you_find, looking, both, ring, catching, leading, following, racing, writing };

const std::vector<std::string_view> games{"you find it",         "eyes (10.1)",      "both elbows (10.2)",
                                          "out of reach (10.3)", "apples (10.4)",    "led around (10.5)",
                                          "tentacle (10.6)",     "stretched (10.7)", "your letter (10.8)"};

std::vector<std::string_view> in_games(std::initializer_list<Game> which) {
    std::vector<std::string_view> names;
    for (const Game game : which) names.push_back(games[game]);
    return names;
}

const demo::About about{
    "Arms that find their angles.",
    {-8.5, -5.2},
    {8.5, 5.2},
    {demo::choice("The game", games, you_find),
     {"upper arm", "m", 0.5, 3, 0.1, 3, {}, in_games({both, ring})},
     {"forearm", "m", 0.5, 3, 0.1, 2, {}, in_games({both, ring})},
     {"damping", "m", 0.01, 2, 0.01, 0.5, {}, in_games({racing})}},
    {{"f", "Show", in_games({you_find})}, {"n", "New", in_games({you_find, catching, racing, writing})}}};
const demo::Still still{3};

struct State {
    Game game = you_find;
    int round = 0;                       ///< how often *New* was pressed
    Arm arm{3, 2};                       ///< of this round
    Vec2 target{3, 2};                   ///< of this round [m]
    Pose pose{};                         ///< of the arm that answers, or that one drags
    Pose other{};                        ///< of the arm whose motors take the first answer of 10.2
    bool shown = false, dragged = false; ///< whether the answers are, whether a joint was in the frame before
    bool found[2]{};                     ///< a pose whose elbow bends left, and one whose elbow bends right
    std::vector<Vec2> guesses{};         ///< where the hand was let go, at most five [m]
    Vec2 fly{};                          ///< what everybody looks at, or reaches for [m]
    bool led = false;                    ///< by the pointer
    Orchard orchard{};                   ///< with an arm that catches apples
    unsigned apples = 0;                 ///< how many have come loose
    double until_next{};                 ///< apple [s]
    std::vector<Link> links{};           ///< of the tentacle
    Race race{};
    std::vector<Pose> poses{};           ///< that write a letter
    double time{}, spare{}, chosen = -1; ///< [s], [s], the sum of all controls
};

State begin() { return {}; }

std::vector<Vec2> joints_of(const Arm &arm, const Pose &pose, const Vec2 &base = {0, 0}) {
    return joints(base, {{arm.first, pose.first}, {arm.second, pose.second}});
}
Vec2 hand_of(const Arm &arm, const Pose &pose) { return joints_of(arm, pose).back(); }

// ------------------------------------------------------------------------------------------------------- the rounds

/// Another number from 0 to 1 for each seed.
double chance(unsigned seed) {
    seed = (seed + 11) * 2654435761u;
    return double((seed ^ seed >> 13) * 1103515245u >> 20) / 4096;
}

/// The first round is the chapter's; the next ones are other arms, and crosses that they can reach with either elbow.
void start_finding(State &now) {
    const unsigned seed = 3 * unsigned(now.round);
    now.arm = now.round == 0 ? Arm{3, 2} : Arm{1.6 + 1.4 * chance(seed), 1.4 + 0.8 * chance(seed + 1)};
    const double least = std::abs(now.arm.first - now.arm.second), most = now.arm.first + now.arm.second;
    const double far = least + (0.35 + 0.45 * chance(seed + 1)) * (most - least), way = 1.2 * chance(seed + 2);
    now.target = now.round == 0 ? Vec2{3, 2} : Vec2{far * std::cos(way), far * std::sin(way)};
    now.pose = {150 * degree, -70 * degree};
    now.shown = now.found[0] = now.found[1] = false;
    now.guesses.clear();
}

/// The base of the two that race, and what each of their joints can do.
const Vec2 track{0, 0.5};
const std::vector<Limits> limits{{-0.1, 3.2}, {-2.8, 2.8}};

/// Out at the side; nearly straight, with the target a little way in; and just above the ground.
void start_race(State &now) {
    now.time = 0;
    const int round = now.round % 3;
    const std::vector<Link> links{{3, (round == 0 ? 150 : 60) * degree},
                                  {2, round == 0   ? -0.9
                                      : round == 1 ? 0.01
                                                   : 0.9}};
    now.race = {links, links};
    const Vec2 places[]{{4.2, 1.2}, track + 4.5 * Vec2{0.5, std::sqrt(0.75)}, {-3.3, 0.3}};
    now.target = places[round];
}

/// F, then the letters of some other words, each without lifting the pen; in a box that is 2 wide and 3 high.
const std::vector<Vec2> letters[]{{{0, 0}, {0, 3}, {2, 3}, {0, 3}, {0, 1.6}, {1.5, 1.6}},
                                  {{0, 0}, {1, 3}, {2, 0}, {1.6, 1.2}, {0.4, 1.2}},
                                  {{0, 0}, {0, 3}, {1, 1.2}, {2, 3}, {2, 0}},
                                  {{2, 3}, {0, 3}, {0, 1.6}, {1.5, 1.6}, {0, 1.6}, {0, 0}, {2, 0}},
                                  {{0, 3}, {0.5, 0}, {1, 1.8}, {1.5, 0}, {2, 3}}};

void start_writing(State &now) {
    now.time = 0;
    std::vector<Vec2> path = letters[now.round % 5];
    for (Vec2 &corner : path) corner = Vec2{1.4, -1.6} + 1.2 * corner;
    now.arm = {3, 2};
    now.poses = write(now.arm, poses(now.arm, path.front()).front(), path);
}

/// The choice of the game begins it anew; the other controls do not.
void start(State &now) {
    now.time = 0;
    now.arm = {3, 2};
    now.led = false;
    now.pose = now.other = {0.6, 0.9};
    now.fly = {3, 2};
    if (now.game == you_find) start_finding(now);
    if (now.game == catching) now.orchard = {{0.6, 0.9}, {}, 0, 0}, now.apples = 0, now.until_next = 0;
    if (now.game == following) now.links.assign(12, {0.5, 0.12}), now.links[0].angle = 60 * degree;
    if (now.game == racing) start_race(now);
    if (now.game == writing) start_writing(now);
}

// -------------------------------------------------------------------------------------------------------- one frame

/// From an arrow's direction to another's, the shorter way [rad].
double angle_from(const Vec2 &from, const Vec2 &to) {
    return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// A link follows the pointer as well as it can: it points there.
void drag(State &now, const Input &in) {
    const std::vector<Vec2> all = joints_of(now.arm, now.pose);
    const std::size_t i = std::size_t(in.handle);
    (i == 0 ? now.pose.first : now.pose.second) += angle_from(all[i + 1] - all[i], in.pointer - all[i]);
}

/// Where the hand is let go, a dot stays.
void let_go(State &now) {
    const Vec2 hand = hand_of(now.arm, now.pose);
    now.guesses.push_back(hand);
    if (now.guesses.size() > 5) now.guesses.erase(now.guesses.begin());
    if ((hand - now.target).norm() < 0.15) now.found[std::sin(now.pose.second) < 0] = true;
}

/// Where the fly would be by itself.
Vec2 wandering(const State &now) {
    const double t = now.time, far = now.game == both || now.game == ring ? 3.4 + 2.4 * std::sin(1.1 * t) : 3.6;
    if (now.game == looking) return {3.4 * std::sin(1.6 * t), 1.9 * std::sin(2.7 * t)};
    if (now.game == following) return {3.8 * std::sin(1.2 * t), 0.5 + 2 * std::sin(1.9 * t)};
    if (now.game == catching) { // nobody plays: it waits below the lowest apple
        const std::vector<Apple> &apples = now.orchard.apples;
        return apples.empty() ? now.fly : Vec2{apples.front().place.x(), -1};
    }
    return {far * std::cos(1.6 * t + 0.6), far * std::sin(1.6 * t + 0.6)};
}

void fly(State &now, const Input &in) {
    now.led = now.led || in.inside;
    const Vec2 goal = in.inside ? in.pointer : now.led ? now.fly : wandering(now), way = goal - now.fly;
    const double most = (now.game == leading ? 8 : 40) * frame_time;
    now.fly += way.norm() > most ? Vec2{most / way.norm() * way} : way;
}

void step(State &now, const Input &in) {
    now.time += frame_time;
    fly(now, in);
    switch (now.game) {
    case ring: now.pose = reach_for(now.arm, now.pose, now.fly); break;
    case catching: next_frame(now.orchard, now.apples, now.until_next, now.fly, frame_time); break;
    case leading: {
        next_frame(now.pose, continued(now.arm, now.pose, now.fly), frame_time);
        next_frame(now.other, reach_for(now.arm, now.other, now.fly), frame_time);
        for (double *angle : {&now.pose.first, &now.pose.second, &now.other.first, &now.other.second})
            if (std::abs(*angle) > 1e4) *angle = std::remainder(*angle, 360 * degree); // it was led around for hours
        break;
    }
    case following: next_frame({0, -3}, now.links, now.fly); break;
    case racing:
        if (int(now.time * 8) > int((now.time - frame_time) * 8))
            next_step(now.race, track, limits, now.target, in["damping"]);
        if (now.time > 6) start_race(now); // once more
        break;
    case writing:
        if (now.time * 30 > double(now.poses.size()) + 30) now.time = 0;
        break;
    default: break;
    }
}

State next(State now, const Input &in) {
    if (const double chosen = in["The game"]; chosen != now.chosen) {
        now.chosen = chosen;
        now.game = static_cast<Game>(chosen);
        now.round = 0;
        start(now);
    }
    if (now.game == both || now.game == ring) now.arm = {in["upper arm"], in["forearm"]};
    if (now.game == you_find) {
        if (in.handle >= 0) drag(now, in);
        if (in.handle < 0 && now.dragged) let_go(now);
        now.dragged = in.handle >= 0;
    }
    if (in.key == "f") now.shown = true;
    if (in.key == "n") {
        ++now.round;
        start(now);
    }
    for (int due = demo::steps_due(now.spare, in, frame_time); due > 0; --due) step(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void add_list(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::vector<Vec2> &points,
              double strength = 1, Material material = Material::flat) {
    seen.shapes.push_back({kind, colour, size, strength, points, {}, material});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour = Colour::ink) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
/// Without the last digits, which are rounding, and without a negative zero.
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, std::round(value * 1e6) / 1e6 + 0.0, decimals});
}
void say_pose(demo::Picture &seen, const Pose &pose) {
    say(seen, "first angle", "°", pose.first / degree, 1);
    say(seen, "second angle", "°", pose.second / degree, 1);
}
/// Of steel, with bolts.
void add_arm(demo::Picture &seen, const std::vector<Vec2> &all, Colour colour = Colour::blue, double width = 11) {
    add_list(seen, Shape::line, colour, width, all, 1, Material::solid);
    add_list(seen, Shape::discs, Colour::ink, 0.14, all, 1, Material::solid);
}
/// An arm that isn't the one that counts.
void add_ghost(demo::Picture &seen, const std::vector<Vec2> &all, double strength = 0.4) {
    add_list(seen, Shape::line, Colour::dim, 6, all, strength);
    add_list(seen, Shape::discs, Colour::dim, 0.12, all, strength);
}
void add_circle(demo::Picture &seen, const Vec2 &centre, double radius, Colour colour = Colour::dim) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 72; ++i)
        points.push_back(centre + radius * Vec2{std::cos(5 * i * degree), std::sin(5 * i * degree)});
    add_list(seen, Shape::line, colour, -2, points);
}
void add_cross(demo::Picture &seen, const Vec2 &at) {
    for (const Vec2 &arm : {Vec2{0.2, 0.2}, Vec2{0.2, -0.2}})
        add_list(seen, Shape::line, Colour::pink, 3, {at - arm, at + arm});
}
void add_fly(demo::Picture &seen, const Vec2 &at) {
    add_list(seen, Shape::discs, Colour::pink, 0.13, {at}, 1, Material::glow);
}

void draw_finding(demo::Picture &seen, const State &now) {
    seen.low = {-4.4, -3.2}, seen.high = {6.4, 3.7};
    for (int i = -4; i <= 6; ++i) add_list(seen, Shape::line, Colour::line, 1, {{double(i), -3.2}, {double(i), 3.7}});
    for (int i = -3; i <= 3; ++i) add_list(seen, Shape::line, Colour::line, 1, {{-4.4, double(i)}, {6.4, double(i)}});
    if (now.shown)
        for (const Pose &pose : poses(now.arm, now.target)) add_ghost(seen, joints_of(now.arm, pose), 0.7);
    add_list(seen, Shape::discs, Colour::orange, 0.09, now.guesses);
    const std::vector<Vec2> all = joints_of(now.arm, now.pose);
    add_list(seen, Shape::discs, Colour::dim, 0.34, {all[0]}, 1, Material::solid); // what it's bolted to
    add_arm(seen, all);
    add_cross(seen, now.target);
    for (int i = 1; i <= 2; ++i) add_list(seen, Shape::handle, Colour::orange, 0, {all[std::size_t(i)]});
    say_pose(seen, {std::remainder(now.pose.first, 360 * degree), std::remainder(now.pose.second, 360 * degree)});
    say(seen, "off by", "m", (all[2] - now.target).norm());
    say(seen, "poses found", "", now.found[0] + now.found[1], 0);
}

const std::vector<Vec2> eyes{{-2.6, 0.9}, {-0.6, 0.9}, {2.4, -0.9}, {3.3, -0.9}, {-3.4, -1.9}, {-2.9, -1.9}};
const double sizes[]{0.95, 0.95, 0.42, 0.42, 0.24, 0.24};

void draw_looking(demo::Picture &seen, const State &now) {
    seen.low = {-4.6, -2.9}, seen.high = {4.6, 3};
    const std::vector<double> angles = look(eyes, now.fly);
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const Vec2 direction{std::cos(angles[i]), std::sin(angles[i])};
        add_list(seen, Shape::discs, Colour::ink, sizes[i], {eyes[i]}, 1, Material::solid); // it's white at night
        add_list(seen, Shape::discs, Colour::violet, 0.5 * sizes[i], {eyes[i] + 0.48 * sizes[i] * direction}, 1,
                 Material::solid);
    }
    add_fly(seen, now.fly);
    say(seen, "left eye", "°", angles[0] / degree, 1);
    say(seen, "right eye", "°", angles[1] / degree, 1);
}

void draw_both(demo::Picture &seen, const State &now) {
    seen.low = {-7.4, -5.2}, seen.high = {7.4, 5.2};
    const std::vector<Pose> all = poses(now.arm, now.fly);
    add_circle(seen, {0, 0}, now.arm.first);
    add_circle(seen, now.fly, now.arm.second);
    for (std::size_t i = all.size(); i-- > 0;)
        add_arm(seen, joints_of(now.arm, all[i]), i == 0 ? Colour::blue : Colour::orange);
    if (all.empty()) add_words(seen, now.fly + Vec2{0.3, 0.3}, "out of reach");
    add_list(seen, Shape::discs, Colour::ink, 0.14, {{0, 0}});
    add_fly(seen, now.fly);
    say(seen, "poses", "", double(all.size()), 0);
    for (const Pose &pose : all) say_pose(seen, pose);
}

void draw_ring(demo::Picture &seen, const State &now) {
    seen.low = {-7.4, -5.2}, seen.high = {7.4, 5.2};
    add_circle(seen, {0, 0}, now.arm.first + now.arm.second);
    if (now.arm.first != now.arm.second) add_circle(seen, {0, 0}, std::abs(now.arm.first - now.arm.second));
    const std::vector<Vec2> all = joints_of(now.arm, now.pose);
    add_list(seen, Shape::line, Colour::pink, -2, {all.back(), now.fly});
    add_arm(seen, all);
    add_fly(seen, now.fly);
    say(seen, "from the hand to the fly", "m", (all.back() - now.fly).norm());
}

/// So many apples in rows on the grass, from here on; what is higher than four rows isn't seen.
std::vector<Vec2> pile(double from, int count) {
    std::vector<Vec2> places;
    for (int i = 0; i < std::min(count, 40); ++i)
        places.push_back({from + 0.48 * (i % 10) + 0.1 * (i / 10 % 2), grass + 0.24 + 0.44 * (i / 10)});
    return places;
}

void draw_catching(demo::Picture &seen, const State &now) {
    seen.low = {-6.2, -3.6}, seen.high = {6.2, 5};
    seen.stage = Stage::yard;
    seen.ground = grass;
    const Orchard &orchard = now.orchard;
    add_list(seen, Shape::line, Colour::green, 6, {{-6.2, grass}, {6.2, grass}});
    add_list(seen, Shape::line, Colour::amber, 12, {{0, grass}, {0, 0}}, 1, Material::solid);
    for (const double x : {-7.0, -4.2, -1.4, 1.4, 4.2, 7.0})
        add_list(seen, Shape::discs, Colour::green, 0.9, {{x - 0.8, 4.9}, {x + 0.8, 4.9}, {x, 4.6}});
    const std::vector<Vec2> all = joints_of(picker, orchard.pose);
    add_arm(seen, all);
    add_list(seen, Shape::discs, Colour::amber, catch_radius, {all.back()}, 1, Material::solid);
    std::vector<Vec2> places;
    for (const Apple &apple : orchard.apples) places.push_back(apple.place);
    add_list(seen, Shape::discs, Colour::pink, 0.22, places, 1, Material::solid);
    add_list(seen, Shape::discs, Colour::pink, 0.22, pile(-5.8, orchard.caught), 1, Material::solid);
    add_list(seen, Shape::discs, Colour::orange, 0.22, pile(1.2, orchard.missed), 0.6, Material::solid);
    say(seen, "caught", "", orchard.caught, 0);
    say(seen, "missed", "", orchard.missed, 0);
}

void draw_leading(demo::Picture &seen, const State &now) {
    seen.low = {-6, -3.9}, seen.high = {6, 3.9};
    add_circle(seen, {0, 0}, 3.6, Colour::line);
    add_ghost(seen, joints_of(now.arm, now.other));
    add_arm(seen, joints_of(now.arm, now.pose));
    add_fly(seen, now.fly);
    say_pose(seen, now.pose);
    say(seen, "first angle of the pale arm", "°", now.other.first / degree, 1);
}

void draw_following(demo::Picture &seen, const State &now) {
    seen.low = {-5.4, -3.5}, seen.high = {5.4, 3.5};
    const std::vector<Vec2> all = joints({0, -3}, now.links);
    add_list(seen, Shape::line, Colour::green, 12, all, 1, Material::solid);
    for (std::size_t i = 0; i < all.size(); ++i)
        add_list(seen, Shape::discs, Colour::green, 0.26 - 0.013 * double(i), {all[i]}, 1, Material::solid);
    add_fly(seen, now.fly);
    say(seen, "from the hand to the fly", "m", (all.back() - now.fly).norm());
}

void draw_racing(demo::Picture &seen, const State &now) {
    seen.low = {-4, -0.35}, seen.high = {4.9, 5.25};
    seen.stage = Stage::yard;
    add_list(seen, Shape::line, Colour::dim, 4, {{-4, 0}, {4.9, 0}});
    const std::vector<Vec2> damped = joints(track, now.race.damped), sweeping = joints(track, now.race.sweeping);
    add_ghost(seen, sweeping, 0.6);
    add_arm(seen, damped);
    add_words(seen, damped.back() + Vec2{0.2, 0.35}, "DLS", Colour::blue);
    add_words(seen, sweeping.back() + Vec2{0.2, -0.35}, "CCD", Colour::dim);
    add_cross(seen, now.target);
    say(seen, "DLS: steps", "", now.race.steps, 0);
    say(seen, "off by", "m", (damped.back() - now.target).norm());
    say(seen, "CCD: steps", "", now.race.sweeps, 0);
    say(seen, "off by ", "m", (sweeping.back() - now.target).norm());
}

void draw_writing(demo::Picture &seen, const State &now) {
    seen.low = {-1.4, -3.1}, seen.high = {5.2, 2.3};
    const std::size_t count = std::min(std::size_t(now.time * 30) + 1, now.poses.size());
    std::vector<Vec2> trail;
    for (std::size_t i = 0; i < count; ++i) trail.push_back(hand_of(now.arm, now.poses[i]));
    add_list(seen, Shape::line, Colour::amber, 4, trail, 1, Material::glow);
    add_arm(seen, joints_of(now.arm, pen_at(now.poses, now.time)));
    say(seen, "poses", "", double(now.poses.size()), 0);
}

demo::Picture draw(const State &now, const Input &) {
    demo::Picture seen;
    seen.stage = Stage::night; // but for what's outdoors
    switch (now.game) {
    case you_find: draw_finding(seen, now); break;
    case looking: draw_looking(seen, now); break;
    case both: draw_both(seen, now); break;
    case ring: draw_ring(seen, now); break;
    case catching: draw_catching(seen, now); break;
    case leading: draw_leading(seen, now); break;
    case following: draw_following(seen, now); break;
    case racing: draw_racing(seen, now); break;
    case writing: draw_writing(seen, now); break;
    }
    return seen;
}
} // namespace play
