#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace nt_collisions;
using demo::Colour, demo::Input, demo::Shape;

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
    {-8.5, -5},
    {8.5, 5},
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
     {"u", "Turn left", in_games({contact})},
     {"d", "Turn right", in_games({contact})}}};
const demo::Still still{1.6, "f"};

const Box table{{-8, -4.5}, {8, 4.5}};
constexpr double small = 0.3; // the radius of the balls of the break shot [m]

struct State {
    Game game = you_guess;
    Ball a, b;
    Vec2 from[2], meets[2];        ///< where a and b began, and met [m]
    Vec2 guess[2]{{2, 0}, {2, 0}}; ///< which way a and b will go
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
void rack(State &now) {
    now.balls.clear();
    now.balls.push_back({{-4.5, 0}, {0, 0}, small, 1});
    for (int row = 0; row < 5; ++row)
        for (int k = 0; k <= row; ++k)
            now.balls.push_back({{1.5 + 0.5215 * row, 0.602 * (k - 0.5 * row)}, {0, 0}, small, 1});
    now.rolling = false;
}

/// A random number from -1 to 1, the same ones in every run.
double random(unsigned &seed) {
    seed = seed * 1664525u + 1013904223u;
    return seed / 2147483648.0 - 1;
}

void fill(State &now, int count) {
    unsigned seed = 8;
    const double radius = 0.1 * std::sqrt(1000.0 / count);
    const int columns = int(std::sqrt(count * 1.6));
    const Vec2 step = (table.high - table.low) / (columns + 1);
    const double up = 9.0 / (count / columns + 2);
    now.balls.clear();
    for (int i = 0; i < count; ++i) {
        const double x = -8 + step.x() * (1 + i % columns), y = -4.5 + up * (1 + i / columns);
        now.balls.push_back({{x, y}, {2 * random(seed), 2 * random(seed)}, radius, 1});
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

/// The game begins once more.
void start(State &now, const Input &in) {
    now.met = false;
    now.frames = 0;
    now.trail.clear();
    const double off = in["off centre"], along = std::sqrt(1 - off * off);
    if (now.game == you_guess) place(now, {0.8, 0.6}, 1, {{0, 0}, {5, 0}, 0, 1}, {{0, 0}, {0, 0}, 0, 1}, 60);
    if (now.game == equal_balls || now.game == masses) {
        const bool equal = now.game == equal_balls;
        place(now, {along, off}, 1, {{0, 0}, {5, 0}, 0, equal ? 1 : in["mass of A"]},
              {{0, 0}, {in["velocity of B"], 0}, 0, equal ? 1 : in["mass of B"]}, 66);
    }
    if (now.game == fast) place(now, {along, off}, 1, {{0, 0}, {in["speed"], 0}, 0, 1}, {{1, 0}, {0, 0}, 0, 1}, 0);
    if (now.game == fast) now.a.position.x() = now.from[0].x() = -7.5;
    if (now.game == break_shot) rack(now);
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
        const Vec2 to = there - (in.handle == 0 ? Vec2{-0.8, -0.6} : Vec2{0, 0});
        if (to.norm() > 0.1) now.guess[in.handle] = 2 * to.normalized();
    }
    if (now.game == contact && in.handle == 0 && there.norm() > 0.1) now.to_b = there.normalized();
    if (now.game == contact && in.handle == 1) now.velocity = there / 0.7;
    if (now.game == break_shot) {
        rack(now);
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

void add(demo::Picture &seen, Shape::Kind kind, Colour colour, double size, std::initializer_list<Vec2> points,
         double strength = 1) {
    seen.shapes.push_back({kind, colour, size, strength, points});
}
void add_words(demo::Picture &seen, const Vec2 &at, const char *words, Colour colour = Colour::ink) {
    seen.shapes.push_back({Shape::words, colour, 0, 1, {at}, words});
}
/// Without the last digits, which are rounding, and without a negative zero.
void say(demo::Picture &seen, const char *name, const char *unit, double value, int decimals = 2) {
    seen.readouts.push_back({name, unit, std::round(value * 1e6) / 1e6 + 0.0, decimals});
}
/// From one vector to the other [°].
double angle_between(const Vec2 &a, const Vec2 &b) {
    return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b)) * 57.295779513082321;
}
void add_arrow(demo::Picture &seen, Colour colour, double width, const Vec2 &from, const Vec2 &arrow) {
    if (arrow.norm() > 0.02) add(seen, Shape::arrow, colour, width, {from, from + arrow});
}
void add_table(demo::Picture &seen) {
    const auto &[low, high] = table;
    add(seen, Shape::line, Colour::ink, 3, {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low});
}

void draw_contact(demo::Picture &seen, const State &now) {
    constexpr double scale = 0.7; // [s]
    const Vec2 n = now.to_b, t{-n.y(), n.x()}, a{0, 0}, b = 2 * n, tip = scale * now.velocity;
    add(seen, Shape::discs, Colour::orange, 1, {a}, 0.4);
    add(seen, Shape::discs, Colour::blue, 1, {b}, 0.4);
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

void draw_two(demo::Picture &seen, const State &now) {
    const Ball *balls[]{&now.a, &now.b};
    const Colour colours[]{Colour::orange, Colour::blue};
    if (now.game == you_guess) {
        const Vec2 at[]{{-0.8, -0.6}, {0, 0}};
        add(seen, Shape::discs, Colour::orange, 0.5, {at[0]}, 0.25);
        for (int i : {0, 1}) add_arrow(seen, colours[i], -2, at[i], now.guess[i]);
        add_words(seen, at[0] + now.guess[0] + Vec2{0.3, -0.4}, "A?", colours[0]);
        add_words(seen, now.guess[1] + Vec2{0.3, 0.1}, "B?", colours[1]);
        for (int i : {0, 1}) add(seen, Shape::handle, colours[i], 0, {at[i] + now.guess[i]});
    }
    for (const Vec2 &at : now.trail) add(seen, Shape::discs, Colour::orange, now.a.radius, {at}, 0.2);
    if (now.met) {
        const Vec2 n = now.meets[1] - now.meets[0];
        for (int i : {0, 1}) add(seen, Shape::discs, colours[i], now.a.radius, {now.meets[i]}, 0.2);
        add(seen, Shape::line, Colour::dim, -1.5, {now.meets[0] - n, now.meets[1] + n});
    }
    for (int i : {0, 1}) {
        const Ball &ball = *balls[i];
        const Vec2 turn = now.met ? now.meets[i] : ball.position;
        if (now.game != fast) add(seen, Shape::line, colours[i], 1.5, {now.from[i], turn, ball.position}, 0.6);
        add(seen, Shape::discs, colours[i], ball.radius, {ball.position});
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

void draw_balls(demo::Picture &seen, const State &now, Colour colour) {
    add_table(seen);
    const double radius = now.balls[0].radius;
    seen.shapes.push_back({Shape::discs, colour, radius, 1, centres_of(now.balls)});
    add(seen, Shape::discs, Colour::orange, radius, {now.balls[0].position});
}

void draw_grid(demo::Picture &seen, const State &now) {
    const std::vector<Vec2> centres = centres_of(now.balls);
    const double cell = 2 * now.balls[0].radius;
    for (double x = table.low.x(); x < table.high.x(); x += cell)
        add(seen, Shape::line, Colour::line, 1, {{x, table.low.y()}, {x, table.high.y()}});
    for (double y = table.low.y(); y < table.high.y(); y += cell)
        add(seen, Shape::line, Colour::line, 1, {{table.low.x(), y}, {table.high.x(), y}});
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
    draw_balls(seen, now, Colour::blue);
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
        add(seen, Shape::discs, colour, it.radius, {it.position}, 0.7);
        for (std::size_t k = 0; k < i; ++k)
            deepest = std::max(deepest, it.radius + now.discs[k].radius - (it.position - now.discs[k].position).norm());
    }
    add(seen, Shape::handle, Colour::orange, 0, {now.discs[0].position});
    say(seen, "balls", "", double(now.discs.size()) - 1, 0);
    say(seen, "deepest overlap", "m", deepest);
}

demo::Picture draw(const State &now, const Input &) {
    demo::Picture seen;
    if (now.game == contact) {
        draw_contact(seen, now);
    } else if (now.game == crowd) {
        draw_crowd(seen, now);
    } else if (now.game == thousand) {
        draw_grid(seen, now);
    } else if (now.game == break_shot) {
        draw_balls(seen, now, Colour::green);
        if (!now.rolling) {
            add_arrow(seen, Colour::orange, 3, now.balls[0].position, now.aim);
            add(seen, Shape::handle, Colour::orange, 0, {now.balls[0].position + now.aim});
        }
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
