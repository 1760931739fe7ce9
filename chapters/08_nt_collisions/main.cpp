#include "../chance.hpp"
#include "../program.hpp"

#include "game.hpp"

#include <map>

using namespace nt_collisions;
using course::row, course::text;

//> Six contacts
void print_contacts(std::ostream &out) {
    out << row({{"from A to B", 13}, {"normal [m/s]", 14}, {"tangential [m/s]", 0}});
    for (const Vec2 &to_b : {Vec2{1, 0}, Vec2{0.8, 0.6}, Vec2{0.6, 0.8}, Vec2{0, 1}, Vec2{-0.6, 0.8}, Vec2{3, 4}}) {
        const auto [normal, tangential] = decompose({5, 0}, {0, 0}, to_b);
        out << row({{text(to_b), 13}, {text(normal), 14}, {text(tangential), 0}});
    }
}

//> Five meetings
constexpr double degree = 0.017453292519943295; ///< [rad]

/// Two balls that touch: a moves to the right at 5 m/s, b rests, and its centre is so much higher than that of a.
Ball arriving() { return {{0, 0}, {5, 0}, 0.5, 1}; }
Ball resting(double higher) { return {{std::sqrt(1 - higher * higher), higher}, {0, 0}, 0.5, 1}; }

void print_meetings(std::ostream &out) {
    out << row({{"B higher by [m]", 17}, {"A after [m/s]", 18}, {"B after [m/s]", 18}, {"angle between [°]", 0}});
    for (const double higher : {0.0, 0.28, 0.6, 0.8, 0.96}) {
        const Velocities after = exchange(arriving(), resting(higher));
        const double cosine = after.a.dot(after.b) / (after.a.norm() * after.b.norm());
        out << row({{text(higher), 17},
                    {text(after.a), 18},
                    {text(after.b), 18},
                    {after.a.norm() > 0 ? text(std::acos(cosine) / degree) : "-", 0}});
    }
}

//> From rubber to clay
const Ball left{{0, 0}, {3, 1}, 0.5, 2}, right{{0.6, 0.8}, {-1, -1}, 0.5, 3}; // they touch

void print_materials(std::ostream &out) {
    out << row(
        {{"restitution", 13}, {"A after [m/s]", 18}, {"B after [m/s]", 18}, {"momentum [N s]", 16}, {"energy [J]", 0}});
    for (const double restitution : {1.0, 0.8, 0.5, 0.0}) {
        const auto [a, b] = resolve_collision(left, right, restitution);
        const Vec2 momentum = left.mass * a + right.mass * b;
        const double energy = (left.mass * a.squaredNorm() + right.mass * b.squaredNorm()) / 2;
        out << row({{text(restitution), 13}, {text(a), 18}, {text(b), 18}, {text(momentum), 16}, {text(energy), 0}});
    }
}

//> A break shot
const Box table{{0, 0}, {16, 9}};

std::vector<Ball> racked() { return rack({9.5, 4.5}, {12, 1}); }

void print_break(std::ostream &out) {
    out << row({{"t [s]", 7}, {"balls that move", 17}, {"kinetic energy [J]", 0}});
    std::vector<Ball> balls = racked();
    for (int frame = 0; frame <= 120; ++frame) {
        double energy = 0;
        int moving = 0;
        for (const Ball &ball : balls) {
            energy += ball.mass * ball.velocity.squaredNorm() / 2;
            moving += ball.velocity.norm() > 0;
        }
        if (frame % 30 == 0) out << row({{text(frame / 60.0), 7}, {text(moving), 17}, {text(energy), 0}});
        next_frame(balls, table, 0.95, frame_time);
    }
}

//> Two at once
/// How many contacts of a frame change a velocity, taken one after the other as the frame loop does.
int contacts_of(std::vector<Ball> balls) {
    int count = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t k = i + 1; k < balls.size(); ++k) {
            const Vec2 before = balls[i].velocity;
            if (touch(balls[i], balls[k])) collide(balls[i], balls[k], 0.95);
            count += balls[i].velocity != before;
        }
    return count;
}

void print_order(std::ostream &out) {
    const Vec2 up{std::cos(30 * degree), std::sin(30 * degree)}, down{up.x(), -up.y()};
    out << row({{"in the list", 19}, {"first one [m/s]", 17}, {"second one [m/s]", 0}});
    for (const auto &[words, first, second] :
         {std::tuple{"upper, then lower", up, down}, {"lower, then upper", down, up}}) {
        Ball cue = arriving(), a{first, {0, 0}, 0.5, 1}, b{second, {0, 0}, 0.5, 1};
        collide(cue, a, 1);
        collide(cue, b, 1);
        out << row({{words, 19}, {text(a.velocity.norm()), 17}, {text(b.velocity.norm()), 0}});
    }
    std::vector<Ball> balls = racked();
    std::map<int, int> frames; // with so many contacts
    for (int frame = 0; frame < 120; ++frame) {
        ++frames[contacts_of(balls)];
        next_frame(balls, table, 0.95, frame_time);
    }
    out << '\n' << row({{"contacts in a frame", 21}, {"frames of the break", 0}});
    for (const auto &[contacts, count] : frames) out << row({{text(contacts), 21}, {text(count), 0}});
}

//> Five pairs on their way
void print_impacts(std::ostream &out) {
    out << row({{"from A to B [m]", 17}, {"velocity of A", 15}, {"velocity of B", 15}, {"time of impact [s]", 0}});
    for (const auto &[to_b, v_a, v_b] : {std::tuple{Vec2{4, 0.6}, Vec2{5, 0}, Vec2{0, 0}},
                                         {Vec2{3, 2}, Vec2{3, 1}, Vec2{-1, -1}},
                                         {Vec2{4, 1.2}, Vec2{5, 0}, Vec2{0, 0}},
                                         {Vec2{4, 0.6}, Vec2{-5, 0}, Vec2{0, 0}},
                                         {Vec2{0.4, 0.3}, Vec2{5, 0}, Vec2{0, 0}}}) {
        const auto time = time_of_impact({{0, 0}, v_a, 0.5, 1}, {to_b, v_b, 0.5, 1});
        out << row({{text(to_b), 17}, {text(v_a), 15}, {text(v_b), 15}, {time ? text(*time) : "never", 0}});
    }
}

//> Three pairs that overlap
void print_pushes(std::ostream &out) {
    out << row({{"inverse masses [1/kg]", 23}, {"A moves to", 20}, {"B moves to", 0}});
    for (const auto &[a, b] : {std::pair{1.0, 1.0}, {0.5, 1.0}, {0.0, 1.0}}) {
        const Positions apart = push_apart({{0, 0}, 0.5, a}, {{0.48, 0.64}, 0.5, b});
        out << row({{text(a) + " and " + text(b), 23}, {text(apart.a), 20}, {text(apart.b), 0}});
    }
}

//> How many pairs are close
/// So many points at random on a table that grows with their number: 16 m by 9 m for a thousand.
std::vector<Vec2> strewn(int count) {
    std::vector<Vec2> points;
    course::Dice dice{8};
    const double size = std::sqrt(count / 1000.0);
    for (int i = 0; i < count; ++i) {
        const double x = dice.one(), y = dice.one();
        points.push_back({16 * size * x, 9 * size * y});
    }
    return points;
}

void print_pairs(std::ostream &out) {
    out << row({{"balls", 8}, {"pairs in all", 14}, {"close pairs", 0}});
    for (const int count : {100, 1000, 10000})
        out << row({{text(count), 8},
                    {text(count * (count - 1.0) / 2), 14},
                    {text(double(close_pairs(strewn(count), 0.2).size())), 0}});
}

//> The components of a velocity, traced
void trace_arrow(std::ostream &out, const Vec2 &from, const Vec2 &to) {
    out << from.x() << '\t' << from.y() << '\t' << to.x() << '\t' << to.y() << '\n';
}

void trace_parts(std::ostream &out) {
    out << "# from: x[m]\ty[m]\tarrow: x[m/s]\ty[m/s]\n";
    const auto [normal, tangential] = arrows({5, 0}, {0, 0}, {0.8, 0.6});
    trace_arrow(out, {0, 0}, {5, 0});
    trace_arrow(out, {0, 0}, normal);
    trace_arrow(out, {0, 0}, tangential);
}

//> Before and after, traced
void trace_exchange(std::ostream &out) {
    out << "# from: x[m]\ty[m]\tarrow: x[m/s]\ty[m/s]\n";
    const Ball a = arriving(), b = resting(0.6);
    const Velocities after = exchange(a, b);
    trace_arrow(out, a.position - a.velocity, a.velocity);
    trace_arrow(out, a.position, after.a);
    trace_arrow(out, b.position, after.b);
}

//> Two balls that overlap, traced
void trace_overlap(std::ostream &out) {
    out << "# frame[1]\tdistance[m]\tas printed: distance[m]\n";
    Ball a{{0, 0}, {-0.6, 0}, 0.5, 1}, b{{0.8, 0}, {0.6, 0}, 0.5, 1}; // one frame was too long; now they part
    double printed = 0.8, parting = 1.2;                              // [m], [m/s]
    for (int frame = 0; frame <= 20; ++frame) {
        out << frame << '\t' << (b.position - a.position).norm() << '\t' << printed << '\n';
        next_frame(a, b, frame_time);
        if (printed <= 1) parting = -parting; // whatever overlaps
        printed += frame_time * parting;
    }
}

//> Momentum against restitution, traced
void trace_momentum(std::ostream &out) {
    out << "# restitution[1]\tmomentum[N s]\tas printed: momentum[N s]\n";
    const Ball a{{0, 0}, {4, 0}, 0.5, 2}, b{{1, 0}, {-2, 0}, 0.5, 3};
    for (int tenths = 0; tenths <= 10; ++tenths) {
        const double e = tenths / 10.0;
        const Velocities after = resolve_collision(a, b, e);
        const double printed_a = ((e + 1) * 3 * -2 + 4 * (2 - e * 3)) / 5;
        const double printed_b = ((e + 1) * 2 * 4 - -2 * (2 - e * 3)) / 5;
        out << e << '\t' << 2 * after.a.x() + 3 * after.b.x() << '\t' << 2 * printed_a + 3 * printed_b << '\n';
    }
}

//> The break shot, traced
void trace_break(std::ostream &out) {
    out << "# t[s]";
    std::vector<Ball> balls = racked();
    for (std::size_t i = 0; i < balls.size(); ++i) out << "\tx" << i << "[m]\ty" << i << "[m]";
    out << '\n';
    for (int frame = 0; frame <= 100; ++frame) {
        if (frame % 2 == 0) {
            out << frame / 60.0;
            for (const Ball &ball : balls) out << '\t' << ball.position.x() << '\t' << ball.position.y();
            out << '\n';
        }
        next_frame(balls, table, 0.95, frame_time);
    }
}

//> A fast ball, traced
void trace_fast(std::ostream &out) {
    out << "# A: x[m]\ty[m]\tB: x[m]\ty[m]\n";
    Ball a{{-1.1, 0}, {120, 0}, 0.5, 1}, b{{4, 0.6}, {0, 0}, 0.5, 1}; // 2 m in each frame
    for (int frame = 0; frame <= 4; ++frame) {
        out << a.position.x() << '\t' << a.position.y() << '\t' << b.position.x() << '\t' << b.position.y() << '\n';
        next_frame_with_contact(a, b, 1, frame_time);
    }
}

//> The distance of two centres, traced
void trace_distance(std::ostream &out) {
    out << "# t[s]\tdistance[m]\ttime of impact[s]\tdistance then[m]\n";
    const Ball a{{0, 0}, {5, 0}, 0.5, 1}, b{{4, 0.6}, {0, 0}, 0.5, 1};
    const double impact = time_of_impact(a, b).value_or(0);
    const auto distance = [&](double t) { return (b.position - a.position - t * a.velocity).norm(); };
    for (int i = 0; i <= 70; ++i)
        out << i / 50.0 << '\t' << distance(i / 50.0) << '\t' << impact << '\t' << distance(impact) << '\n';
}

//> Pushed apart, traced
void trace_pushed(std::ostream &out) {
    out << "# before: x[m]\ty[m]\tradius[m]\tafter: x[m]\ty[m]\n";
    for (int i = 0; i < 3; ++i) {
        const double inverse_masses[]{1, 0.25, 0};
        const Disc a{{2.6 * i, 0}, 0.5, inverse_masses[i]}, b{{2.6 * i + 0.36, 0.48}, 0.5, 1};
        const Positions after = push_apart(a, b);
        out << a.position.x() << '\t' << a.position.y() << "\t0.5\t" << after.a.x() << '\t' << after.a.y() << '\n';
        out << b.position.x() << '\t' << b.position.y() << "\t0.5\t" << after.b.x() << '\t' << after.b.y() << '\n';
    }
}

//> A grid, traced
void trace_grid(std::ostream &out) {
    out << "# x[m]\ty[m]\tkind[1]\n";
    std::vector<Vec2> points = strewn(40);
    for (Vec2 &point : points) point *= 1.7;
    points.insert(points.begin(), {2.7, 1.4});
    std::vector<int> kinds(points.size(), 3); // 0: the first one, 1: close to it, 2: in its nine cells, 3: elsewhere
    for (std::size_t i = 0; i < points.size(); ++i) // cells of 1 m; the first point is in column 2, row 1
        if (std::abs(std::floor(points[i].x()) - 2) <= 1 && std::abs(std::floor(points[i].y()) - 1) <= 1) kinds[i] = 2;
    for (const Pair &pair : close_pairs(points, 1))
        if (pair.first == 0) kinds[std::size_t(pair.second)] = 1;
    kinds[0] = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        out << points[i].x() << '\t' << points[i].y() << '\t' << kinds[i] << '\n';
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"contacts", print_contacts},
                        {"meetings", print_meetings},
                        {"materials", print_materials},
                        {"break", print_break},
                        {"order", print_order},
                        {"impacts", print_impacts},
                        {"pushes", print_pushes},
                        {"pairs", print_pairs},
                        {"08_nt_collisions_parts.tsv", trace_parts},
                        {"08_nt_collisions_exchange.tsv", trace_exchange},
                        {"08_nt_collisions_overlap.tsv", trace_overlap},
                        {"08_nt_collisions_momentum.tsv", trace_momentum},
                        {"08_nt_collisions_break.tsv", trace_break},
                        {"08_nt_collisions_fast.tsv", trace_fast},
                        {"08_nt_collisions_distance.tsv", trace_distance},
                        {"08_nt_collisions_pushed.tsv", trace_pushed},
                        {"08_nt_collisions_grid.tsv", trace_grid}});
}
