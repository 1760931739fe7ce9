#include "../demo.hpp"
#include "../chance.hpp"

#include "game.hpp"

#include <string>

//> The demo
namespace play {
using namespace nt_collisions;
using demo::Colour, demo::Input, demo::Material, demo::Shape;

enum Game { you_guess, contact, equal_balls, masses, break_shot, fast, crowd, thousand };

const std::vector<std::string_view> games{"you guess",          "contact that turns (8.1)", "equal balls (8.2)",
                                          "masses (8.3)",       "break shot (8.3)",         "between frames (8.4)",
                                          "pushed apart (8.5)", "a thousand (8.6)"};

std::vector<std::string_view> in_games(std::initializer_list<Game> which) {
    std::vector<std::string_view> names;
    for (const Game game : which) names.push_back(games[game]);
    return names;
}

const demo::About about{
    "Balls on a table that meet: two of them, fifteen, a crowd, and a thousand.",
    {-8.9, -5.75},
    {8.9, 5.75},
    {demo::choice("The game", games, you_guess),
     {"off centre", "m", -0.9, 0.9, 0.1, 0.6, {}, in_games({equal_balls, masses, fast})},
     {"velocity of B", "m/s", -4, 4, 1, 0, {}, in_games({equal_balls, masses})},
     {"mass of A", "kg", 0.5, 10, 0.5, 2, {}, in_games({masses})},
     {"mass of B", "kg", 0.5, 10, 0.5, 3, {}, in_games({masses})},
     {"restitution", "", 0, 1, 0.1, 0.9, {}, in_games({masses, break_shot, fast})},
     {"speed", "m/s", 10, 100, 5, 60, {}, in_games({fast})},
     {"contact", "", 0, 1, 1, 0, {"only in frames (8.3)", "between frames (8.4)"}, in_games({fast})},
     {"balls", "", 100, 1000, 100, 1000, {}, in_games({thousand})}},
    {{"f", "Roll", in_games({you_guess, break_shot})},
     {"o", "Overlap", in_games({equal_balls})},
     {"n", "Drop ten more", in_games({crowd})},
     {"s", "New", in_games({you_guess})},
     {"u", "Turn left", in_games({contact})},
     {"d", "Turn right", in_games({contact})}}};
const demo::Still still{1.6, "f", in_games({break_shot})};

const Box table{{-8, -4.5}, {8, 4.5}};

struct State {
    Game game = you_guess;
    Ball a, b;
    Vec2 from[2], meets[2];        ///< where a and b began, and met [m]
    Vec2 guess[2]{{2, 0}, {2, 0}}; ///< which way a and b will go
    Vec2 guessed_at{0.8, 0.6};     ///< from a to b where they meet
    int round = 0;                 ///< of the guess
    std::vector<Vec2> misses;      ///< of the last five guesses: of a and of b [rad]
    Vec2 to_b{0.8, 0.6};           ///< from a to b, which touch; its length is 1
    Vec2 velocity{5, 0};           ///< of a at the contact [m/s]
    Vec2 aim{2.5, 0.2};            ///< of the break shot: its velocity is five times that
    bool rolling = false, met = false;
    int frames{}; ///< since the beginning
    std::vector<Ball> balls;
    std::vector<Disc> discs;
    std::vector<Vec2> trail;
    double spare{}, chosen = -1, begun{}; ///< the sum of all controls; the kinetic energy at the beginning [J]
};

State begin() { return {}; }

/// The sum of all controls: if it changes, we begin again.
double choice_of(const Input &in) {
    double sum = 0, weight = 1;
    for (const demo::Control &each : in.controls) sum += (weight *= 1.618) * each.value;
    return sum;
}

double energy_of(const Ball &ball) { return ball.mass * ball.velocity.squaredNorm() / 2; }

/// a and b are where they will touch after so many frames: exactly then, so that no frame passes the contact.
void place(State &now, const Vec2 &n, double size, const Ball &a, const Ball &b, int frames) {
    now.a = a;
    now.b = b;
    now.a.radius = now.b.radius = size / 2;
    now.a.position = b.position - (size - 1e-9) * n - frames * frame_time * a.velocity;
    now.b.position -= frames * frame_time * b.velocity;
    now.from[0] = now.a.position;
    now.from[1] = now.b.position;
}

/// Fifteen balls in a triangle, and the cue ball in front of them.
void rack_up(State &now) {
    now.balls = rack({1.5, 0}, {0, 0});
    now.rolling = false;
}

/// From -1 to 1.
double either_way(course::Dice &dice) { return 2 * dice.one() - 1; }

void fill(State &now, int count) {
    course::Dice dice{8};
    const double radius = 0.1 * std::sqrt(1000.0 / count);
    const int columns = int(std::sqrt(count * 1.6));
    const Vec2 step = (table.high - table.low) / (columns + 1);
    const double up = 9.0 / (count / columns + 2);
    now.balls.clear();
    for (int i = 0; i < count; ++i) {
        const double x = -8 + step.x() * (1 + i % columns), y = -4.5 + up * (1 + i / columns);
        now.balls.push_back({{x, y}, {2 * either_way(dice), 2 * either_way(dice)}, radius, 1});
    }
}

void gather(State &now) {
    now.discs.clear();
    now.discs.push_back({{-6, 0}, 0.7, 0});
    for (int i = 0; i < 40; ++i) {
        const bool heavy = i % 9 == 4;
        now.discs.push_back(
            {{-3 + i / 5, 1.1 * (i % 5) - 2.3 + 0.03 * (i * 7 % 11)}, heavy ? 0.5 : 0.35, heavy ? 0.25 : 1.0});
    }
}

/// From one vector to the other, anticlockwise [rad].
double angle_from(const Vec2 &a, const Vec2 &b) { return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)); }

/// Another contact to guess at: in the first round the chapter's own.
void new_guess(State &now) {
    course::Dice dice{40u * unsigned(++now.round)};
    dice.roll();
    const double angle = either_way(dice);
    now.guessed_at = {std::cos(angle), std::sin(angle)};
    now.guess[0] = now.guess[1] = {2, 0};
    now.rolling = false;
}

/// The balls have met, and how far off both guesses are stays.
void mark_guess(State &now) {
    now.misses.push_back({angle_from(now.a.velocity, now.guess[0]), angle_from(now.b.velocity, now.guess[1])});
    if (now.misses.size() > 5) now.misses.erase(now.misses.begin());
}

/// The game begins once more.
void start(State &now, const Input &in) {
    now.met = false;
    now.frames = 0;
    now.trail.clear();
    const double off = in["off centre"], along = std::sqrt(1 - off * off);
    if (now.game == you_guess) place(now, now.guessed_at, 1, {{0, 0}, {5, 0}, 0, 1}, {{0, 0}, {0, 0}, 0, 1}, 60);
    if (now.game == equal_balls || now.game == masses) {
        const bool equal = now.game == equal_balls;
        place(now, {along, off}, 1, {{0, 0}, {5, 0}, 0, equal ? 1 : in["mass of A"]},
              {{0, 0}, {in["velocity of B"], 0}, 0, equal ? 1 : in["mass of B"]}, 66);
    }
    if (now.game == fast) place(now, {along, off}, 1, {{0, 0}, {in["speed"], 0}, 0, 1}, {{1, 0}, {0, 0}, 0, 1}, 0);
    if (now.game == fast) now.a.position.x() = now.from[0].x() = -7.5;
    if (now.game == break_shot) rack_up(now);
    if (now.game == crowd) gather(now);
    if (now.game == thousand) fill(now, int(in["balls"]));
    now.begun = now.game == masses ? energy_of(now.a) + energy_of(now.b) : 0;
}

bool is_seen(const Ball &ball) { return std::abs(ball.position.x()) < 9 && std::abs(ball.position.y()) < 5.5; }

void step_two(State &now, const Input &in) {
    Ball &a = now.a, &b = now.b;
    const bool between = now.game == fast && in["contact"] > 0;
    const Vec2 before = a.velocity;
    const double until = between ? time_of_impact(a, b).value_or(0) : 0; // from now on [s]
    const Vec2 meets[]{a.position + until * a.velocity, b.position + until * b.velocity};
    if (now.game == fast) now.trail.push_back(a.position);
    if (between) {
        next_frame_with_contact(a, b, in["restitution"], frame_time);
    } else if (now.game == masses || now.game == fast) {
        if (touch(a, b)) collide(a, b, in["restitution"]);
        a.position += frame_time * a.velocity;
        b.position += frame_time * b.velocity;
    } else {
        next_frame(a, b, frame_time);
    }
    if (!now.met && (a.velocity - before).norm() > 1e-9) {
        now.met = true;
        now.meets[0] = meets[0];
        now.meets[1] = meets[1];
        if (now.game == you_guess) mark_guess(now);
    }
    ++now.frames;
    const bool gone = !is_seen(a) && (now.game == you_guess || !is_seen(b) || now.frames > 150);
    if (now.game == you_guess && gone) now.rolling = false;
    else if (gone || now.frames > 400) start(now, in);
}

void step(State &now, const Input &in) {
    switch (now.game) {
    case contact: return;
    case break_shot:
        if (now.rolling) next_frame(now.balls, table, in["restitution"], frame_time);
        return;
    case crowd:
        next_frame(now.discs);
        for (Disc &disc : now.discs) {
            const Vec2 edge{disc.radius, disc.radius};
            disc.position = disc.position.cwiseMax(table.low + edge).cwiseMin(table.high - edge);
        }
        return;
    case thousand: return next_frame_with_pairs(now.balls, table, 1, frame_time);
    default:
        if (now.game != you_guess || now.rolling) step_two(now, in);
    }
}

/// A handle holds the tip of a guess, ball b, a velocity, the aim or the post.
void drag(State &now, const Input &in) {
    const Vec2 there = in.pointer.cwiseMax(table.low).cwiseMin(table.high);
    if (now.game == you_guess) {
        const Vec2 to = there - (in.handle == 0 ? Vec2{-now.guessed_at} : Vec2{0, 0});
        if (to.norm() > 0.1) now.guess[in.handle] = 2 * to.normalized();
    }
    if (now.game == contact && in.handle == 0 && there.norm() > 0.1) now.to_b = there.normalized();
    if (now.game == contact && in.handle == 1) now.velocity = there / 0.7;
    if (now.game == break_shot) {
        rack_up(now);
        const Vec2 aim = there - now.balls[0].position;
        now.aim = aim / std::max(1.0, aim.norm() / 2.5);
    }
    if (now.game == crowd) now.discs[0].position = there;
}

void press(State &now, const Input &in) {
    if (in.key == "f") {
        start(now, in);
        now.rolling = true;
        if (now.game == break_shot) now.balls[0].velocity = 5 * now.aim;
        if (now.game == break_shot) now.begun = energy_of(now.balls[0]);
    }
    if (in.key == "s") {
        new_guess(now);
        start(now, in);
    }
    if (in.key == "o") { // two balls that have got into each other, and part
        start(now, in);
        place(now, {0.8, 0.6}, 1, {{0, 0}, {-0.48, -0.36}, 0, 1}, {{0, 0}, {0.48, 0.36}, 0, 1}, 20);
    }
    if (in.key == "n" && now.discs.size() < 80)
        for (int i = 0; i < 10; ++i) now.discs.push_back({{2 + 0.1 * (i % 4), 0.1 * (i / 4) + 0.01 * i}, 0.35, 1});
    if (in.key == "u" || in.key == "d") { // by 5°
        const Vec2 left{-now.to_b.y(), now.to_b.x()};
        now.to_b = (now.to_b + (in.key == "u" ? 0.08749 : -0.08749) * left).normalized();
    }
}

State next(State now, const Input &in) {
    if (const double chosen = choice_of(in); chosen != now.chosen) {
        now.chosen = chosen;
        now.game = static_cast<Game>(in["The game"]);
        now.rolling = false;
        start(now, in);
    }
    if (in.handle >= 0) drag(now, in);
    press(now, in);
    const double length = now.game == fast ? 0.12 : frame_time; // the fast ball is seen in slow motion [s]
    for (int due = demo::steps_due(now.spare, in, length); due > 0; --due) step(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

/// What's seen of the world in each game [m].
const Vec2 windows[][2]{{{-6.7, -3.9}, {5.3, 3.9}},   {{-6, -3.9}, {6, 3.9}},       {{-7.4, -4.8}, {7.4, 4.8}},
                        {{-7.4, -4.8}, {7.4, 4.8}},   {{-8.9, -5.75}, {8.9, 5.75}}, {{-8.2, -5.3}, {8.2, 5.3}},
                        {{-8.9, -5.75}, {8.9, 5.75}}, {{-8.9, -5.75}, {8.9, 5.75}}};

Shape &add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::vector<Vec2> &points,
           double strength = 1) {
    seen.shapes.push_back({kind, colour, size, strength, points});
    return seen.shapes.back();
}
void add_solid(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, const std::vector<Vec2> &points,
               double strength = 1) {
    add(seen, kind, colour, size, points, strength).material = Material::solid;
}
void add_words(demo::Picture &seen, const Vec2 &at, const std::string &words, Colour colour = Colour::ink) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
/// Without the last digits, which are rounding, and without a negative zero.
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, std::round(value * 1e6) / 1e6 + 0.0, decimals});
}
/// From one vector to the other [°].
double angle_between(const Vec2 &a, const Vec2 &b) { return std::abs(angle_from(a, b)) * 57.295779513082321; }
void add_arrow(demo::Picture &seen, Colour colour, double width, const Vec2 &from, const Vec2 &arrow) {
    if (arrow.norm() > 0.02) add(seen, Shape::arrow, colour, width, {from, from + arrow});
}
/// Four sides of the table, so far from its cloth and so wide, with corners that are cut at 45°.
void add_rails(demo::Picture &seen, Colour colour, double away, double width, double strength) {
    const Vec2 signs[]{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < 4; ++i) {
        std::vector<Vec2> corners;
        for (const double out : {away, away + width})
            for (const int k : {i, (i + 1) % 4}) corners.push_back(signs[k].cwiseProduct(table.high + Vec2{out, out}));
        std::swap(corners[2], corners[3]);
        add_solid(seen, Shape::area, colour, 0, corners, strength);
    }
}
/// Rails of wood, with inlays, and cushions in front of them.
void add_table(demo::Picture &seen) {
    add_rails(seen, Colour::green, 0, 0.3, 0.5);
    add_rails(seen, Colour::wood, 0.3, 1, 1);
    for (const double x : {-6, -4, -2, 2, 4, 6})
        for (const double y : {-5.25, 5.25}) add(seen, Shape::discs, Colour::amber, 0.07, {{x, y}}, 0.8);
}

void draw_contact(demo::Picture &seen, const State &now) {
    constexpr double scale = 0.7; // [s]
    const Vec2 n = now.to_b, t{-n.y(), n.x()}, a{0, 0}, b = 2 * n, tip = scale * now.velocity;
    add_solid(seen, Shape::discs, Colour::orange, 1, {a}, 0.75);
    add_solid(seen, Shape::discs, Colour::blue, 1, {b}, 0.75);
    add(seen, Shape::line, Colour::dim, -1.5, {-9 * n, 9 * n});
    add(seen, Shape::line, Colour::dim, -1.5, {-9 * t, 9 * t});
    add_words(seen, 4.2 * n + 0.45 * t, "n", Colour::dim);
    add_words(seen, 4.2 * t + 0.2 * n, "t", Colour::dim);
    const auto [normal, tangential] = arrows(now.velocity, a, b);
    add_arrow(seen, Colour::pink, 3, a, scale * normal);
    add_arrow(seen, Colour::green, 3, a, scale * tangential);
    add_arrow(seen, Colour::ink, 3, a, tip);
    add(seen, Shape::line, Colour::dim, -1, {scale * normal, tip, scale * tangential});
    add(seen, Shape::handle, Colour::blue, 0, {b, tip});
    const Components parts = decompose(now.velocity, a, b);
    say(seen, "normal", "m/s", parts.normal);
    say(seen, "tangential", "m/s", parts.tangential);
    say(seen, "speed", "m/s", now.velocity.norm());
}

/// Where words about a guess stand: at its tip, on the side that the other ball isn't on.
Vec2 beside(const State &now, int i) {
    const bool above = (i == 1) == (now.guessed_at.y() > 0);
    return (i == 0 ? Vec2{-now.guessed_at} : Vec2{0, 0}) + now.guess[i] + Vec2{0.3, above ? 0.25 : -0.45};
}

/// How far off, and the last five guesses: around where each ball went, as holes around the middle of a target.
void draw_misses(demo::Picture &seen, const State &now, int i, const Vec2 &at, Colour colour) {
    const Vec2 went = 2 * (i == 0 ? now.a : now.b).velocity.normalized();
    for (const Vec2 &each : now.misses) {
        const double c = std::cos(each[i]), s = std::sin(each[i]);
        add(seen, Shape::discs, colour, 0.1, {at + Vec2{c * went.x() - s * went.y(), s * went.x() + c * went.y()}},
            0.7);
    }
    const int off = int(std::round(angle_between(now.guess[i], went)));
    add_words(seen, beside(now, i), std::to_string(off) + "° off", colour);
}

void draw_guesses(demo::Picture &seen, const State &now, const Colour colours[]) {
    const Vec2 at[]{-now.guessed_at, {0, 0}};
    add_solid(seen, Shape::discs, Colour::orange, 0.5, {at[0]}, 0.35);
    for (int i : {0, 1}) {
        add_arrow(seen, colours[i], -2, at[i], now.guess[i]);
        if (now.met) draw_misses(seen, now, i, at[i], colours[i]);
        else add_words(seen, beside(now, i), i == 0 ? "A?" : "B?", colours[i]);
        add(seen, Shape::handle, colours[i], 0, {at[i] + now.guess[i]});
    }
}

void draw_two(demo::Picture &seen, const State &now) {
    const Ball *balls[]{&now.a, &now.b};
    const Colour colours[]{Colour::orange, Colour::blue};
    if (now.game == you_guess) draw_guesses(seen, now, colours);
    for (const Vec2 &at : now.trail) add_solid(seen, Shape::discs, Colour::orange, now.a.radius, {at}, 0.3);
    if (now.met) {
        const Vec2 n = now.meets[1] - now.meets[0];
        for (int i : {0, 1}) add_solid(seen, Shape::discs, colours[i], now.a.radius, {now.meets[i]}, 0.3);
        add(seen, Shape::line, Colour::dim, -1.5, {now.meets[0] - n, now.meets[1] + n});
    }
    for (int i : {0, 1}) {
        const Ball &ball = *balls[i];
        const Vec2 turn = now.met ? now.meets[i] : ball.position;
        if (now.game != fast) add(seen, Shape::line, colours[i], 1.5, {now.from[i], turn, ball.position}, 0.6);
        add_solid(seen, Shape::discs, colours[i], ball.radius, {ball.position});
        if (now.game != fast) add_arrow(seen, Colour::ink, 2, ball.position, 0.3 * ball.velocity);
        add_words(seen, ball.position + Vec2{-0.15, ball.radius + 0.25}, i == 0 ? "A" : "B");
    }
    if (now.game == you_guess) {
        if (!now.met) return;
        say(seen, "A off by", "°", angle_between(now.guess[0], now.a.velocity), 0);
        say(seen, "B off by", "°", angle_between(now.guess[1], now.b.velocity), 0);
    }
    say(seen, "A, to the right", "m/s", now.a.velocity.x());
    say(seen, "A, up", "m/s", now.a.velocity.y());
    say(seen, "B, to the right", "m/s", now.b.velocity.x());
    say(seen, "B, up", "m/s", now.b.velocity.y());
    if (now.game == equal_balls) say(seen, "distance", "m", (now.b.position - now.a.position).norm());
    if (now.met && now.game != fast && now.a.velocity.norm() > 1e-9 && now.b.velocity.norm() > 1e-9)
        say(seen, "angle between", "°", angle_between(now.a.velocity, now.b.velocity), 1);
}

/// The first one, and all others in these colours.
void draw_balls(demo::Picture &seen, const State &now, Colour first, std::initializer_list<Colour> others) {
    const double radius = now.balls[0].radius;
    const std::vector<Vec2> centres = centres_of(now.balls);
    std::size_t which = 0;
    for (const Colour colour : others) {
        std::vector<Vec2> here;
        for (std::size_t i = 1 + which++; i < centres.size(); i += others.size()) here.push_back(centres[i]);
        add_solid(seen, Shape::discs, colour, radius, here);
    }
    add_solid(seen, Shape::discs, first, radius, {centres[0]});
}

void draw_shot(demo::Picture &seen, const State &now) {
    draw_balls(seen, now, Colour::ink, {Colour::amber, Colour::orange, Colour::blue, Colour::violet, Colour::pink});
    if (now.rolling) return;
    const Vec2 at = now.balls[0].position, back = now.aim.normalized() * -1;
    add_solid(seen, Shape::line, Colour::wood, 7, {at + (0.5 + 0.4 * now.aim.norm()) * back, at + 6 * back});
    add_arrow(seen, Colour::orange, 3, at, now.aim);
    add(seen, Shape::handle, Colour::orange, 0, {at + now.aim});
}

void draw_grid(demo::Picture &seen, const State &now) {
    const std::vector<Vec2> centres = centres_of(now.balls);
    add_table(seen);
    const double cell = 2 * now.balls[0].radius;
    for (double x = table.low.x(); x < table.high.x(); x += cell)
        add(seen, Shape::line, Colour::dim, 1, {{x, table.low.y()}, {x, table.high.y()}}, 0.25);
    for (double y = table.low.y(); y < table.high.y(); y += cell)
        add(seen, Shape::line, Colour::dim, 1, {{table.low.x(), y}, {table.high.x(), y}}, 0.25);
    const auto cell_of = [&](const Vec2 &at) {
        return Vec2{std::floor((at.x() - table.low.x()) / cell), std::floor((at.y() - table.low.y()) / cell)};
    };
    const Vec2 mine = cell_of(centres[0]), low = table.low + cell * (mine - Vec2{1, 1}),
               high = low + Vec2{3 * cell, 3 * cell};
    add(seen, Shape::area, Colour::amber, 0, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}, 0.4);
    int around = 0;
    for (const Vec2 &at : centres) {
        const Vec2 away = cell_of(at) - mine;
        around += std::abs(away.x()) < 1.5 && std::abs(away.y()) < 1.5;
    }
    draw_balls(seen, now, Colour::orange, {Colour::blue});
    const double count = double(centres.size());
    say(seen, "pairs in all", "", count * (count - 1) / 2, 0);
    say(seen, "close pairs", "", double(close_pairs(centres, cell).size()), 0);
    say(seen, "others in the nine cells", "", around - 1, 0);
}

void draw_crowd(demo::Picture &seen, const State &now) {
    add_table(seen);
    double deepest = 0;
    for (std::size_t i = 0; i < now.discs.size(); ++i) {
        const Disc &it = now.discs[i];
        const Colour colour = i == 0 ? Colour::ink : it.inverse_mass < 1 ? Colour::violet : Colour::blue;
        add_solid(seen, Shape::discs, colour, it.radius, {it.position}, 0.9);
        for (std::size_t k = 0; k < i; ++k)
            deepest = std::max(deepest, it.radius + now.discs[k].radius - (it.position - now.discs[k].position).norm());
    }
    add(seen, Shape::handle, Colour::orange, 0, {now.discs[0].position});
    say(seen, "balls", "", double(now.discs.size()) - 1, 0);
    say(seen, "deepest overlap", "m", deepest);
}

demo::Picture draw(const State &now, const Input &) {
    demo::Picture seen;
    seen.stage = demo::Stage::felt;
    seen.low = windows[now.game][0], seen.high = windows[now.game][1];
    if (now.game == contact) {
        draw_contact(seen, now);
    } else if (now.game == crowd) {
        draw_crowd(seen, now);
    } else if (now.game == thousand) {
        draw_grid(seen, now);
    } else if (now.game == break_shot) {
        add_table(seen);
        draw_shot(seen, now);
    } else {
        draw_two(seen, now);
    }
    const bool many = now.game == break_shot || now.game == thousand;
    if (now.game != masses && !many) return seen;
    double energy = 0;
    if (now.game == masses) {
        const Vec2 momentum = now.a.mass * now.a.velocity + now.b.mass * now.b.velocity;
        energy = energy_of(now.a) + energy_of(now.b);
        say(seen, "momentum, to the right", "N s", momentum.x());
        say(seen, "momentum, up", "N s", momentum.y());
    } else {
        for (const Ball &ball : now.balls) energy += energy_of(ball);
    }
    if (now.game != thousand) say(seen, "lost", "J", now.begun - energy);
    say(seen, "kinetic energy", "J", energy);
    return seen;
}
} // namespace play
