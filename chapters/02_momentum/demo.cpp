#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace momentum;
using demo::Colour, demo::Input, demo::Shape;

enum Game { you_decide, ropes, drag_the_point, rubber, rubber_to_clay, from_the_centre, between_walls, cradle };

const std::vector<std::string_view> with_masses{
    "ropes (2.1)",        "drag the point", "rubber (2.2)", "rubber to clay (2.3)", "from the centre of mass (2.4)",
    "between walls (2.5)"};

const demo::About about{
    "Carts on a straight rail, or balls on strings, which collide.",
    {0, 0},
    {12, 8},
    {demo::choice("The game",
                  {"you decide", "ropes (2.1)", "drag the point", "rubber (2.2)", "rubber to clay (2.3)",
                   "from the centre of mass (2.4)", "between walls (2.5)", "cradle (2.6)"},
                  you_decide),
     {"A after", "m/s", -6, 6, 0.1, 4, {}, {"you decide"}},
     {"B after", "m/s", -6, 6, 0.1, -2, {}, {"you decide"}},
     {"mass of A", "kg", 0.5, 10, 0.5, 2, {}, with_masses},
     {"mass of B", "kg", 0.5, 10, 0.5, 3, {}, with_masses},
     {"restitution",
      "",
      0,
      1,
      0.05,
      1,
      {},
      {"rubber to clay (2.3)", "from the centre of mass (2.4)", "between walls (2.5)"}}},
    {{"s", "Start again"},
     {"1", "Lift one ball", {"cradle (2.6)"}},
     {"2", "Lift two balls", {"cradle (2.6)"}},
     {"3", "Lift three balls", {"cradle (2.6)"}}}};
const demo::Still still{1.6};

constexpr double frame_time = 1.0 / 60; // [s]
constexpr double force_scale = 0.1;     // [m/N]
constexpr double height = 0.6;          // of a cart [m]
constexpr Velocities before{4, -2};     // of the two carts that meet
const double rest[]{4, 5, 6, 7, 8};     // where the balls of the cradle hang [m]
constexpr double top = 7.4, string = 5; // where their strings begin, and how long they are [m]

struct State {
    Game game = you_decide;
    RailCart a, b;
    bool met{};                                 // whether they have, where you decide
    Vec2 decided{-2, 4};                        // in the plane: the velocities of a and b after [m/s]
    std::vector<Vec2> ropes{{12, 6}, {-5, 10}}; // what pulls at a cart [N]
    std::vector<RailBody> walled;
    std::vector<RailCart> balls;
    double time{}, spare{};
};

void lift(State &now, int count) {
    now.balls.clear();
    for (const double x : rest) now.balls.push_back({x - (int(now.balls.size()) < count ? 3 : 0), {1, 0}});
}

/// The beginning of a game, with these masses. What the reader has decided stays.
void start(State &now, Game game, double mass_a, double mass_b) {
    now.game = game;
    now.a = {game == ropes ? 3 : 1.4, {mass_a, game == ropes ? 0 : before.a}};
    now.b = {game == ropes ? 3 : 8.5, {mass_b, game == ropes ? 0 : before.b}};
    now.met = false;
    now.time = 0;
    now.walled = {{-0.5, {0, 0}},
                  {now.a.x, {1 / mass_a, before.a}},
                  {now.b.x, {1 / mass_b, before.b}},
                  {about.high.x() + 0.5, {0, 0}}};
    lift(now, 1);
}

State begin() {
    State now;
    start(now, you_decide, 2, 3);
    return now;
}

/// What acts on a cart: two ropes, and what rail and weight together answer to them.
std::vector<Vec2> forces_on_cart(const State &now) {
    std::vector<Vec2> forces = now.ropes;
    forces.push_back({0, -(now.ropes[0].y() + now.ropes[1].y())});
    return forces;
}

/// They roll, and when they touch, they leave as the reader has decided.
void roll_as_decided(State &now, const Vec2 &after) {
    for (RailCart *cart : {&now.a, &now.b}) cart->x += frame_time * cart->cart.velocity;
    if (now.met || now.b.x - now.a.x > cart_length) return;
    now.met = true;
    now.a.cart.velocity = after.x();
    now.b.cart.velocity = after.y();
}

/// A ball on a string, for small swings: its place and velocity turn around each other, and no energy is lost.
void swing(RailCart &ball, double hangs_at) {
    const double w = std::sqrt(9.8 / string), half = w * frame_time / 2;
    const double c = (1 - half * half) / (1 + half * half), s = 2 * half / (1 + half * half); // c² + s² = 1
    const double aside = ball.x - hangs_at, velocity = ball.cart.velocity;
    ball.x = hangs_at + c * aside + s / w * velocity;
    ball.cart.velocity = c * velocity - s * w * aside;
}

void one_frame(State &now, const Input &in) {
    now.time += frame_time;
    switch (now.game) {
    case you_decide: roll_as_decided(now, {in["A after"], in["B after"]}); break;
    case drag_the_point: roll_as_decided(now, now.decided); break;
    case rubber: next_frame(now.a, now.b, frame_time); break;
    case rubber_to_clay:
    case from_the_centre: next_frame(now.a, now.b, in["restitution"], frame_time); break;
    case between_walls: next_frame(now.walled, in["restitution"], frame_time); return;
    case ropes:
        for (RailCart *cart : {&now.a, &now.b}) {
            next_frame(*cart, forces_on_cart(now), frame_time);
            cart->x -= about.high.x() * std::floor(cart->x / about.high.x()); // out on one side, in on the other
            cart->cart.velocity = std::clamp(cart->cart.velocity, -1e4, 1e4); // if it's pulled for hours
        }
        return;
    case cradle:
        for (std::size_t i = 0; i < now.balls.size(); ++i) swing(now.balls[i], rest[i]);
        next_frame(now.balls, 0); // they have moved; what touches collides
        return;
    }
    if (now.time > 3) start(now, now.game, now.a.cart.mass, now.b.cart.mass); // once more
}

// ------------------------------------------------------------------------------------------------------- the plane

constexpr double plane_x = 6, plane_y = 4.7, plane_size = 2.9; // its middle, and half of its width [m]

/// Where the carts' velocities are seen from: the rail, or their centre of mass.
double seen_from(const State &now) {
    return now.game == from_the_centre ? centre_of_mass_frame(now.a.cart, now.b.cart).velocity : 0;
}

struct Plane {
    double m_a, m_b;
    Velocities start; ///< when they were still to meet
    double momentum = m_a * start.a + m_b * start.b;
    double energy = (m_a * start.a * start.a + m_b * start.b * start.b) / 2;
    double wide_a = std::sqrt(2 * energy / m_a), wide_b = std::sqrt(2 * energy / m_b); ///< of the ellipse
    double scale = plane_size / std::max({6.0, wide_a, wide_b});
    Vec2 at(double v_a, double v_b) const { return {plane_x + scale * v_a, plane_y + scale * v_b}; }
    Vec2 back(const Vec2 &place) const { return (place - Vec2{plane_x, plane_y}) / scale; }
};

Plane plane_of(const State &now) {
    const double u = seen_from(now);
    return {now.a.cart.mass, now.b.cart.mass, {before.a - u, before.b - u}};
}

State next(State now, const Input &in) {
    const Game game = static_cast<Game>(in["The game"]);
    const double m_a = in["mass of A"], m_b = in["mass of B"];
    if (game != now.game || m_a != now.a.cart.mass || m_b != now.b.cart.mass || in.key == "s")
        start(now, game, m_a, m_b);
    if (in.key >= "1" && in.key <= "3") lift(now, in.key[0] - '0');
    if (in.handle >= 0 && game == ropes) { // while somebody aims, time stands still
        const Vec2 rope = (in.pointer - Vec2{now.a.x, 2}) / force_scale;
        now.ropes[std::size_t(in.handle)] = rope / std::max(1.0, rope.norm() / 40);
        return now;
    }
    if (in.handle >= 0) {
        const Vec2 v = plane_of(now).back(in.pointer);
        now.decided = v.cwiseMax(-6.0).cwiseMin(6.0);
        start(now, game, m_a, m_b);
    }
    for (int due = demo::steps_due(now.spare, in, frame_time); due > 0; --due) one_frame(now, in);
    return now;
}

// ------------------------------------------------------------------------------------------------------ the picture

void draw_rail(demo::Picture &seen, double y) {
    seen.shapes.push_back({Shape::line, Colour::dim, 2, 1, {{0, y}, {about.high.x(), y}}});
}

void draw_cart(demo::Picture &seen, Colour colour, double x, double y, const char *name) {
    const double l = x - cart_length / 2, r = x + cart_length / 2;
    seen.shapes.push_back(
        {Shape::area, colour, 0, 0.8, {{l, y + 0.15}, {r, y + 0.15}, {r, y + height}, {l, y + height}}});
    seen.shapes.push_back({Shape::discs, Colour::ink, 0.13, 1, {{l + 0.22, y + 0.13}, {r - 0.22, y + 0.13}}});
    seen.shapes.push_back({Shape::words, Colour::ink, 0, 1, {{x - 0.13, y + 0.75}}, name});
}

/// An arrow at the bumper of a cart, as long as the way of 0.3 s.
void draw_velocity(demo::Picture &seen, Colour colour, double x, double y, double velocity) {
    if (velocity == 0) return;
    const Vec2 bumper{x + (velocity > 0 ? 0.5 : -0.5) * cart_length, y + height / 2};
    seen.shapes.push_back({Shape::arrow, colour, 2, 1, {bumper, bumper + Vec2{0.3 * velocity, 0}}});
}

/// The carts' velocities as a point, and all points with the momentum, and with the energy, that they began with.
void draw_plane(demo::Picture &seen, const State &now, const Vec2 &velocities) {
    const Plane plane = plane_of(now);
    const double end = plane_size / plane.scale;
    const auto line = [&](Colour colour, double width, const Vec2 &from, const Vec2 &to) {
        seen.shapes.push_back(
            {Shape::line, colour, width, 1, {plane.at(from.x(), from.y()), plane.at(to.x(), to.y())}});
    };
    line(Colour::dim, 1, {-end, 0}, {end, 0});
    line(Colour::dim, 1, {0, -end}, {0, end});
    seen.shapes.push_back({Shape::words, Colour::dim, 0, 1, {plane.at(end, 0) + Vec2{0.1, 0}}, "v of A"});
    seen.shapes.push_back({Shape::words, Colour::dim, 0, 1, {plane.at(0, end) + Vec2{0.1, -0.1}}, "v of B"});

    const double common = plane.momentum / (plane.m_a + plane.m_b);
    const Vec2 along{plane.m_b, -plane.m_a}, middle{common, common};
    const auto reach = [&](double sign) { // to the border of the plane
        const double to_x = (end - sign * common) / along.x(), to_y = (end + sign * common) / -along.y();
        return middle + sign * std::min(to_x, to_y) * along;
    };
    line(Colour::blue, 2, reach(-1), reach(1));
    std::vector<Vec2> ellipse;
    Vec2 on_circle{1, 0};
    for (int k = 0; k <= 72; ++k) {
        ellipse.push_back(plane.at(plane.wide_a * on_circle.x(), plane.wide_b * on_circle.y()));
        const double c = 0.99619469809174555, s = 0.087155742747658174; // 5°
        on_circle = {c * on_circle.x() - s * on_circle.y(), s * on_circle.x() + c * on_circle.y()};
    }
    seen.shapes.push_back({Shape::line, Colour::green, -3, 1, ellipse});
    seen.shapes.push_back(
        {Shape::words, Colour::blue, 0, 1, {plane.at(reach(1).x(), reach(1).y()) + Vec2{0.2, 0.1}}, "momentum"});
    seen.shapes.push_back(
        {Shape::words, Colour::green, 0, 1, {plane.at(0, -plane.wide_b) + Vec2{-0.9, -0.4}}, "kinetic energy"});
    seen.shapes.push_back({Shape::discs, Colour::dim, 0.1, 1, {plane.at(plane.start.a, plane.start.b)}});
    seen.shapes.push_back({Shape::discs, Colour::orange, 0.16, 1, {plane.at(velocities.x(), velocities.y())}});
    if (now.game == drag_the_point)
        seen.shapes.push_back({Shape::handle, Colour::orange, 0, 1, {plane.at(now.decided.x(), now.decided.y())}});
}

/// Without the last digits, which are rounding, and without a negative zero.
double shown(double x) { return std::round(x * 1e6) / 1e6 + 0.0; }

/// How much momentum and energy there is now, and how much energy has been lost.
void read_out(demo::Picture &seen, double momentum, double energy, double lost) {
    seen.readouts.push_back({"momentum", "N s", shown(momentum), 2});
    seen.readouts.push_back({"kinetic energy", "J", shown(energy), 2});
    seen.readouts.push_back({"lost", "J", shown(lost), 2});
}

demo::Picture two_carts(const State &now) {
    demo::Picture seen;
    const double u = seen_from(now);
    const double shift =
        now.game == from_the_centre
            ? 6 - (now.a.cart.mass * now.a.x + now.b.cart.mass * now.b.x) / (now.a.cart.mass + now.b.cart.mass)
            : 0;
    const Vec2 velocities{now.a.cart.velocity - u, now.b.cart.velocity - u};
    const double y = now.game == you_decide ? 3.5 : 0.3;
    draw_rail(seen, y);
    for (double x = std::fmod(shift + 12, 1.0); x < 12; x += 1) // sleepers, which show how the rail moves
        seen.shapes.push_back({Shape::line, Colour::dim, 1, 1, {{x, y}, {x - 0.15, y - 0.2}}});
    draw_cart(seen, Colour::blue, now.a.x + shift, y, "A");
    draw_cart(seen, Colour::green, now.b.x + shift, y, "B");
    draw_velocity(seen, Colour::blue, now.a.x + shift, y, velocities.x());
    draw_velocity(seen, Colour::green, now.b.x + shift, y, velocities.y());
    if (now.game == from_the_centre) seen.shapes.push_back({Shape::discs, Colour::ink, 0.1, 1, {{6, y}}});
    if (now.game != you_decide) draw_plane(seen, now, velocities);
    seen.readouts = {{"velocity of A", "m/s", velocities.x(), 2}, {"velocity of B", "m/s", velocities.y(), 2}};
    if (now.game == you_decide) return seen;
    const Plane plane = plane_of(now);
    const double energy =
        (plane.m_a * velocities.x() * velocities.x() + plane.m_b * velocities.y() * velocities.y()) / 2;
    read_out(seen, plane.m_a * velocities.x() + plane.m_b * velocities.y(), energy, plane.energy - energy);
    if (now.game == from_the_centre)
        seen.readouts.push_back(
            {"energy around the centre", "J", centre_of_mass_frame(now.a.cart, now.b.cart).energy, 2});
    return seen;
}

demo::Picture pulled_carts(const State &now) {
    demo::Picture seen;
    const std::vector<Vec2> forces = forces_on_cart(now);
    const Vec2 net = forces[0] + forces[1] + forces[2];
    for (const auto &[cart, y, colour, name] :
         {std::tuple{now.a, 1.7, Colour::blue, "A"}, {now.b, 5.2, Colour::green, "B"}}) {
        const Vec2 middle{cart.x, y + 0.3};
        draw_rail(seen, y);
        draw_cart(seen, colour, cart.x, y, name);
        for (const Vec2 &rope : now.ropes)
            seen.shapes.push_back({Shape::arrow, Colour::amber, 2, 1, {middle, middle + force_scale * rope}});
        if (forces[2].norm() > 0)
            seen.shapes.push_back({Shape::arrow, Colour::dim, 2, 1, {middle, middle + force_scale * forces[2]}});
        if (net.norm() > 0)
            seen.shapes.push_back({Shape::arrow, Colour::ink, 4, 1, {middle, middle + force_scale * net}});
    }
    const Vec2 middle{now.a.x, 2};
    seen.shapes.push_back({Shape::handle,
                           Colour::amber,
                           0,
                           1,
                           {middle + force_scale * now.ropes[0], middle + force_scale * now.ropes[1]}});
    seen.readouts = {{"net force", "N", net.x(), 1},
                     {"acceleration of A", "m/s²", acceleration_due_to(forces, now.a.cart.mass).x(), 2},
                     {"acceleration of B", "m/s²", acceleration_due_to(forces, now.b.cart.mass).x(), 2}};
    return seen;
}

demo::Picture walled_carts(const State &now) {
    demo::Picture seen;
    draw_rail(seen, 3.5);
    for (const double x : {0.05, about.high.x() - 0.05})
        seen.shapes.push_back({Shape::line, Colour::ink, 8, 1, {{x, 2.8}, {x, 5}}});
    const RailBody &a = now.walled[1], &b = now.walled[2];
    draw_cart(seen, Colour::blue, a.x, 3.5, "A");
    draw_cart(seen, Colour::green, b.x, 3.5, "B");
    draw_velocity(seen, Colour::blue, a.x, 3.5, a.body.velocity);
    draw_velocity(seen, Colour::green, b.x, 3.5, b.body.velocity);
    const double m_a = now.a.cart.mass, m_b = now.b.cart.mass, v_a = a.body.velocity, v_b = b.body.velocity;
    const double energy = (m_a * v_a * v_a + m_b * v_b * v_b) / 2;
    read_out(seen, m_a * v_a + m_b * v_b, energy, (m_a * before.a * before.a + m_b * before.b * before.b) / 2 - energy);
    return seen;
}

demo::Picture hanging_balls(const State &now) {
    demo::Picture seen;
    const Colour colours[]{Colour::blue, Colour::orange, Colour::green, Colour::amber, Colour::violet};
    seen.shapes.push_back({Shape::line, Colour::dim, 3, 1, {{3, top}, {9, top}}});
    double momentum = 0, energy = 0;
    for (std::size_t i = 0; i < now.balls.size(); ++i) {
        const auto &[x, ball] = now.balls[i];
        const double aside = std::clamp(x - rest[i], -string, string);
        const Vec2 at{x, top - std::sqrt(string * string - aside * aside)};
        seen.shapes.push_back({Shape::line, Colour::dim, 1, 1, {{rest[i], top}, at}});
        seen.shapes.push_back({Shape::discs, colours[i], 0.5, 0.9, {at}});
        momentum += ball.mass * ball.velocity;
        energy += ball.mass * ball.velocity * ball.velocity / 2;
    }
    seen.readouts = {{"momentum", "N s", shown(momentum), 2}, {"kinetic energy", "J", shown(energy), 2}};
    return seen;
}

demo::Picture draw(const State &now, const Input &) {
    switch (now.game) {
    case ropes: return pulled_carts(now);
    case between_walls: return walled_carts(now);
    case cradle: return hanging_balls(now);
    default: return two_carts(now);
    }
}
} // namespace play
