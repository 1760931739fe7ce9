#include "../demo.hpp"

#include "game.hpp"

//> The demo
namespace play {
using namespace motion;
using demo::Colour, demo::Input, demo::Shape;

enum Sky { helicopter_and_missile, printed_table, three_integrators, plate, sightings };

const demo::About about{
    "A helicopter crosses the screen at a constant velocity. A missile behind it gets faster.",
    {0, 0},
    {640, 200},
    {demo::choice("In the sky",
                  {"helicopter and missile", "the printed table (1.3)", "three integrators (1.5)", "a plate (1.6)",
                   "three sightings (1.7)"},
                  helicopter_and_missile),
     {"step", "s", 0.05, 1, 0.05, 0.5, {}, {"three integrators (1.5)"}}},
    {{"s", "Start the helicopter", {"helicopter and missile"}},
     {"f", "Fire the missile", {"helicopter and missile", "the printed table (1.3)", "three integrators (1.5)"}},
     {"ArrowUp", "More thrust", {"helicopter and missile", "three integrators (1.5)"}},
     {"ArrowDown", "Less thrust", {"helicopter and missile", "three integrators (1.5)"}},
     {"e", "Engine on or off", {"helicopter and missile"}},
     {"b", "Break the missile", {"helicopter and missile"}}}};
const demo::Still still{2.2, "f"};

/// Something that flies leaves a mark every fifth of a second.
constexpr double between_marks = 0.2;

/// The missile of the printed table: it starts at 50 m with 4 m/s and accelerates at 2 m/s². These are its places [m]
/// after 0, 1, 2, 3, 4 and 5 seconds, as the table has them.
constexpr double table[]{50, 55, 62, 71, 82, 95};
const motion::State table_start{{table[0], 0}, {4, 0}};

/// A metre of the plate is 50 px long. In the other picture, time runs to the right and the position upwards.
const Vec2 plate_origin{420, 25}, sightings_origin{20, 36}, sightings_scale{100, 5}; // [px], [px/s] and [px/m]

struct State {
    Helicopter helicopter;
    std::vector<Missile> pieces; // of the missile: none, one, or nose and hull
    Missile unbroken;            // how it would have flown on in one piece
    bool engine = true;
    double thrust = 100; // [px/s²]
    Integrators three;
    int steps{}; // of the three
    std::vector<Vec2> helicopter_marks, missile_marks, path, three_marks[3];
    std::vector<Vec2> corners, seen_at; // of the plate, and of the three sightings [px]
    double time{}, spare{}, next_mark{}, fired{};
};

void fire(State &now) {
    const motion::State start{{20, 120}, now.helicopter.velocity};
    now.unbroken = {start, {0, 0}, 4};
    now.pieces = {now.unbroken};
    now.engine = true;
    now.fired = now.time;
    now.missile_marks = now.path = {};
    now.three = {start, start, start};
    now.steps = 0;
    for (std::vector<Vec2> &marks : now.three_marks) marks = {start.position};
}

State begin() {
    State now;
    fire(now);
    now.pieces.clear(); // not yet
    for (const Vec2 &corner : {Vec2{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})
        now.corners.push_back(plate_origin + 50 * corner);
    for (const Vec2 &sighting : {Vec2{1, 6}, {2, 11}, {4, 27}})
        now.seen_at.push_back(sightings_origin + sighting.cwiseProduct(sightings_scale));
    return now;
}

/// Nose and hull push each other apart. The hull is three times as heavy: it gets a third of the velocity.
void break_in_two(State &now) {
    if (now.pieces.size() != 1) return;
    const Missile whole = now.pieces[0];
    Missile nose = whole, hull = whole;
    nose.mass = 1, hull.mass = 3;
    nose.state.velocity += Vec2{30, 60};
    hull.state.velocity -= Vec2{30, 60} / 3;
    now.pieces = {nose, hull};
}

void one_frame(State &now, double dt) {
    next_frame(now.helicopter, dt);
    if (now.helicopter.position.x() >= about.high.x()) // it comes back on the left
        now.helicopter.position.x() -= about.high.x(), now.helicopter_marks.clear();

    const Vec2 thrust{now.engine ? now.thrust : 0, 0};
    now.unbroken.acceleration = thrust;
    if (!now.pieces.empty()) next_frame(now.unbroken, dt);
    for (Missile &piece : now.pieces) {
        piece.acceleration = thrust;
        next_frame(piece, dt);
    }
    std::erase_if(now.pieces, [](const Missile &piece) { return piece.state.position.x() > 2 * about.high.x(); });

    now.time += dt;
    if (!now.pieces.empty()) now.path.push_back(now.unbroken.state.position);
    if (now.time < now.next_mark) return;
    now.next_mark += between_marks;
    now.helicopter_marks.push_back(now.helicopter.position);
    for (const Missile &piece : now.pieces) now.missile_marks.push_back(piece.state.position);
}

void one_step(State &now, double dt) {
    const Integrators after = step_all(now.three, {now.thrust, 0}, dt);
    if (after.semi_implicit.position.x() > about.high.x()) return fire(now); // the one that is ahead
    now.three = after;
    ++now.steps;
    now.three_marks[0].push_back(now.three.explicit_euler.position);
    now.three_marks[1].push_back(now.three.semi_implicit.position);
    now.three_marks[2].push_back(now.three.exact.position);
}

/// A corner of the plate goes anywhere; sightings stay in their order, a tenth of a second apart.
void drag(State &now, Sky sky, const Input &in) {
    std::vector<Vec2> &handles = sky == plate ? now.corners : now.seen_at;
    const auto which = std::size_t(in.handle);
    if (sky < plate || which >= handles.size()) return;
    Vec2 to = in.pointer.cwiseMax(about.low).cwiseMin(about.high);
    if (sky == sightings && which > 0) to.x() = std::max(to.x(), handles[which - 1].x() + 10);
    if (sky == sightings && which < 2) to.x() = std::min(to.x(), handles[which + 1].x() - 10);
    handles[which] = to;
}

State next(State now, const Input &in) {
    const auto sky = static_cast<Sky>(in["In the sky"]);
    if (in.handle >= 0) drag(now, sky, in);
    if (in.key == "s") now.helicopter = {}, now.helicopter_marks.clear();
    if (in.key == "f" || (in.pressed && sky < plate)) fire(now);
    if (in.key == "e") now.engine = !now.engine;
    if (in.key == "b") break_in_two(now);
    if (in.key == "ArrowUp") now.thrust = std::min(now.thrust + 20, 600.0);
    if (in.key == "ArrowDown") now.thrust = std::max(now.thrust - 20, 0.0);

    const bool steps = sky == three_integrators;
    const double dt = steps ? in["step"] : 1.0 / 60;
    for (int due = demo::steps_due(now.spare, in, dt); due > 0; --due) steps ? one_step(now, dt) : one_frame(now, dt);
    return now;
}

/// What flies, and its marks.
void add(demo::Picture &seen, Colour colour, const Vec2 &at, double size, const std::vector<Vec2> &marks) {
    seen.shapes.push_back({Shape::discs, colour, 0.35 * size, 0.5, marks});
    seen.shapes.push_back({Shape::discs, colour, size, 1, {at}});
}

/// The missile of the printed table, and a spot wherever the table says that it is after a whole second.
demo::Picture table_and_missile(double time) {
    const auto on_screen = [](double x) { return Vec2{(x - 45) * 11, 100}; }; // 11 px/m
    demo::Picture seen;
    for (const double x : table) {
        seen.shapes.push_back({Shape::discs, Colour::dim, 15, 0.35, {on_screen(x)}});
        seen.shapes.push_back(
            {Shape::words, Colour::dim, 0, 1, {on_screen(x) + Vec2{-10, -50}}, std::to_string(int(x))});
    }
    std::vector<Vec2> marks;
    for (int second = 0; second <= time && second <= 5; ++second)
        marks.push_back(on_screen(accelerated_motion(table_start, {2, 0}, second).position.x()));
    const double x = accelerated_motion(table_start, {2, 0}, time).position.x();
    add(seen, Colour::orange, on_screen(x), 7, marks);
    seen.readouts = {{"time", "s", time, 1}, {"missile", "m", x, 1}};
    return seen;
}

demo::Picture three_missiles(const State &now) {
    const Vec2 rows[]{{0, 40}, {0, 0}, {0, -40}};
    const char *const names[]{"explicit Euler", "semi-implicit Euler", "exact"};
    const Colour colours[]{Colour::pink, Colour::green, Colour::blue};
    demo::Picture seen;
    for (int k : {0, 1, 2}) {
        std::vector<Vec2> marks = now.three_marks[k];
        for (Vec2 &mark : marks) mark += rows[k];
        if (!marks.empty()) add(seen, colours[k], marks.back(), 7, marks);
        seen.shapes.push_back({Shape::words, colours[k], 0, 1, {rows[k] + Vec2{12, 134}}, names[k]});
    }
    seen.readouts = {{"explicit Euler", "px", now.three.explicit_euler.position.x(), 1},
                     {"semi-implicit Euler", "px", now.three.semi_implicit.position.x(), 1},
                     {"exact", "px", now.three.exact.position.x(), 1},
                     {"steps", "", double(now.steps), 0}};
    return seen;
}

void add_cross(demo::Picture &seen, Colour colour, const Vec2 &at) {
    for (const Vec2 &arm : {Vec2{10, 0}, {0, 10}})
        seen.shapes.push_back({Shape::line, colour, 1.5, 1, {at - arm, at + arm}});
}

/// With its sign [px²].
double area_of(const std::vector<Vec2> &corners) {
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &p = corners[i], &q = corners[(i + 1) % corners.size()];
        area += (p.x() * q.y() - p.y() * q.x()) / 2;
    }
    return area;
}

void add_balance(demo::Picture &seen, const Vec2 &balance) {
    seen.shapes.push_back({Shape::discs, Colour::blue, 5, 1, {balance}});
    seen.shapes.push_back({Shape::words, Colour::blue, 0, 1, {{20, 150}}, "disc: centroid"});
    const Vec2 of_disc = (balance - plate_origin) / 50;
    seen.readouts = {{"centroid, x", "m", of_disc.x(), 2}, {"centroid, y", "m", of_disc.y(), 2}};
}

/// The plate, the point on which it balances, and the mean of its corners, on which it does not.
demo::Picture plate_and_points(std::vector<Vec2> corners) {
    const bool has_area = std::abs(area_of(corners)) > 1; // all corners may be on one line
    const Vec2 balance = has_area ? centroid(corners) : Vec2{0, 0};
    Vec2 mean{0, 0};
    for (const Vec2 &corner : corners) mean += corner / double(corners.size());
    demo::Picture seen{{{Shape::area, Colour::line, 0, 0.4, corners}}};
    seen.shapes.push_back({Shape::handle, Colour::dim, 0, 1, corners});
    corners.push_back(corners[0]);
    seen.shapes.insert(seen.shapes.begin() + 1, {Shape::line, Colour::dim, 2, 1, corners});
    if (has_area) add_balance(seen, balance);
    else seen.shapes.push_back({Shape::words, Colour::blue, 0, 1, {{20, 150}}, "no area, no centroid"});
    seen.shapes.push_back({Shape::words, Colour::pink, 0, 1, {{20, 120}}, "cross: mean of the corners"});
    add_cross(seen, Colour::pink, mean);
    const Vec2 of_cross = (mean - plate_origin) / 50;
    seen.readouts.push_back({"mean, x", "m", of_cross.x(), 2});
    seen.readouts.push_back({"mean, y", "m", of_cross.y(), 2});
    return seen;
}

/// Position against time: three sightings, and the motion that passes through them.
demo::Picture motion_through(const std::vector<Vec2> &seen_at) {
    const auto sample = [&](std::size_t i) {
        const Vec2 at = (seen_at[i] - sightings_origin).cwiseQuotient(sightings_scale);
        return Sample{at.x(), at.y()};
    };
    const Motion found = fit_motion(sample(0), sample(1), sample(2));
    std::vector<Vec2> curve;
    for (int tenth = -2; tenth <= 62; ++tenth) {
        const double t = 0.1 * tenth, x = found.x_0 + t * (found.v_0 + t * found.a / 2);
        curve.push_back(sightings_origin + Vec2{t, x}.cwiseProduct(sightings_scale));
    }
    demo::Picture seen{{{Shape::line, Colour::line, 1.5, 1, {{0, 36}, {640, 36}}},
                        {Shape::line, Colour::line, 1.5, 1, {{20, 0}, {20, 200}}}}};
    for (int second = 1; second <= 5; ++second)
        seen.shapes.push_back(
            {Shape::words, Colour::dim, 0, 1, {{10 + 100.0 * second, 8}}, std::to_string(second) + " s"});
    seen.shapes.push_back({Shape::line, Colour::blue, 2, 1, curve});
    seen.shapes.push_back({Shape::discs, Colour::ink, 4, 1, seen_at});
    seen.shapes.push_back({Shape::handle, Colour::ink, 0, 1, seen_at});
    seen.readouts = {{"position at 0 s", "m", found.x_0, 1},
                     {"velocity at 0 s", "m/s", found.v_0, 1},
                     {"acceleration", "m/s²", found.a, 1}};
    return seen;
}

demo::Picture draw(const State &now, const Input &in) {
    const auto sky = static_cast<Sky>(in["In the sky"]);
    if (sky == three_integrators) return three_missiles(now);
    if (sky == plate) return plate_and_points(now.corners);
    if (sky == sightings) return motion_through(now.seen_at);
    if (sky == printed_table) return table_and_missile(std::fmod(now.time - now.fired, 6.0));
    demo::Picture seen;
    const Vec2 rotor{16, 0}, mast{0, 12};
    const Vec2 &at = now.helicopter.position;
    seen.shapes.push_back({Shape::line, Colour::blue, 2, 1, {at, at + mast, at + mast - rotor, at + mast + rotor}});
    add(seen, Colour::blue, at, 8, now.helicopter_marks);
    seen.shapes.push_back({Shape::line, Colour::dim, -1.5, 1, now.path});
    for (const Missile &piece : now.pieces) add(seen, Colour::orange, piece.state.position, 3 + piece.mass, {});
    seen.shapes.push_back({Shape::discs, Colour::orange, 2.5, 0.6, now.missile_marks});
    if (const auto camera = camera_target(now.pieces)) add_cross(seen, Colour::ink, *camera);
    seen.readouts = {{"helicopter", "px", at.x(), 0},
                     {"its speed", "px/s", now.helicopter.velocity.norm(), 0},
                     {"thrust", "px/s²", now.thrust, 0}};
    if (!now.pieces.empty()) {
        seen.readouts.push_back({"missile", "px", now.pieces[0].state.position.x(), 0});
        seen.readouts.push_back({"its speed", "px/s", now.pieces[0].state.velocity.norm(), 0});
    }
    return seen;
}
} // namespace play
