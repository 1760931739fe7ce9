// needs box2d box2d::box2d libbox2d-dev
// needs Boost Boost::headers libboost-dev
// Eigen turns a velocity as linear algebra does. Box2D is an engine: it lets discs collide in floats, with restitution.
// Boost finds when a gap closes by a search for a root, and who is near by a tree of rectangles.
#include "../peers/peer.hpp"
#include "../peers/box2d.hpp"
#include "nt_collisions.hpp"

#define BOOST_ALLOW_DEPRECATED_HEADERS // which Boost includes itself
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/math/tools/roots.hpp>
#include <boost/version.hpp>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

using course::Vec2, course::worse;
using namespace nt_collisions;

namespace {

constexpr int cases = 20000; // in each comparison, or a hundredth of them with an engine or a crowd

/// By a rotation that makes the line of centres level.
double compare_components(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Vec2 velocity = dice.point(-10, 10), a = dice.point(-5, 5), b = dice.point(-5, 5);
        const Eigen::Rotation2Dd line{std::atan2(b.y() - a.y(), b.x() - a.x())};
        const Vec2 want = line.inverse() * velocity;
        const Components got = decompose(velocity, a, b);
        largest = worse((Vec2{got.normal, got.tangential} - want).norm(), largest);
    }
    return largest;
}

Vec2 ours(const b2Vec2 &v) { return {v.x, v.y}; }
b2Vec2 theirs(const Vec2 &v) { return {float(v.x()), float(v.y())}; }

b2Body *add_disc(b2World &world, const Ball &ball, double restitution) {
    b2BodyDef movable;
    movable.type = b2_dynamicBody;
    movable.position = theirs(ball.position);
    movable.linearVelocity = theirs(ball.velocity);
    b2CircleShape disc;
    disc.m_radius = float(ball.radius);
    b2FixtureDef fixture;
    fixture.shape = &disc;
    fixture.friction = 0;
    fixture.restitution = float(restitution);
    fixture.restitutionThreshold = 0;
    fixture.density = float(ball.mass / (b2_pi * ball.radius * ball.radius));
    b2Body *body = world.CreateBody(&movable);
    body->CreateFixture(&fixture);
    return body;
}

/// Both discs touch; a step that takes next to no time only resolves the collision.
Velocities engine_collision(const Ball &a, const Ball &b, double restitution) {
    b2World world{{0, 0}};
    const b2Body *first = add_disc(world, a, restitution), *second = add_disc(world, b, restitution);
    world.Step(1e-6f, 50, 0);
    return {ours(first->GetLinearVelocity()), ours(second->GetLinearVelocity())};
}

/// Two discs that overlap by a hair, anywhere around each other; half of them approach.
std::pair<Ball, Ball> touching(Dice &dice, bool equal) {
    const Ball a{{0, 0}, dice.point(-10, 10), dice.real(0.3, 1), equal ? 1 : dice.real(0.5, 5)};
    const double radius = dice.real(0.3, 1);
    const Vec2 position = 0.99 * (a.radius + radius) * dice.direction();
    return {a, Ball{position, dice.point(-10, 10), radius, equal ? 1 : dice.real(0.5, 5)}};
}

double distance(const Velocities &x, const Velocities &y) { return worse((x.a - y.a).norm(), (x.b - y.b).norm()); }

double compare_exchanges(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const auto [a, b] = touching(dice, true);
        largest = worse(distance(exchange(a, b), engine_collision(a, b, 1)), largest);
    }
    return largest;
}

double compare_collisions(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const auto [a, b] = touching(dice, false);
        const double restitution = dice.real(0, 1);
        largest = worse(distance(resolve_collision(a, b, restitution), engine_collision(a, b, restitution)), largest);
    }
    return largest;
}

/// The time until a's edge is at b's, between now and when their centres are nearest: a search in long double.
std::optional<double> searched_impact(const Ball &a, const Ball &b) {
    const Vec2 gap = b.position - a.position, velocity = b.velocity - a.velocity;
    const auto between = [&](long double t) -> long double {
        return std::hypot(gap.x() + t * velocity.x(), gap.y() + t * velocity.y()) - (a.radius + b.radius);
    };
    const long double nearest = -gap.dot(velocity) / velocity.squaredNorm();
    if (nearest <= 0 || between(nearest) > 0) return {};
    if (between(0) <= 0) return 0;
    std::uintmax_t steps = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        between, 0.0L, nearest, boost::math::tools::eps_tolerance<long double>(60), steps);
    return double((low + high) / 2);
}

Ball somewhere(Dice &dice) { return {dice.point(-5, 5), dice.point(-5, 5), dice.real(0.2, 1), 1}; }

/// The largest difference of two times, or how many are a time for one and never for the other.
double compare_impacts(Dice &dice, bool count) {
    double largest = 0;
    int others = 0;
    for (int i = 0; i < cases; ++i) {
        const Ball a = somewhere(dice), b = somewhere(dice);
        const auto got = time_of_impact(a, b), want = searched_impact(a, b);
        if (got && want) largest = worse(course::difference(*got, *want), largest);
        else if (got.has_value() != want.has_value()) ++others;
    }
    return count ? others : largest;
}

/// Boost's tree of rectangles, asked for a square around each point, and its own distances.
std::set<std::pair<int, int>> pairs_by_tree(const std::vector<Vec2> &centres, double within) {
    namespace bg = boost::geometry;
    using Point = bg::model::d2::point_xy<double>;
    using Entry = std::pair<Point, int>;
    std::vector<Entry> entries;
    for (const Vec2 &centre : centres) entries.emplace_back(Point{centre.x(), centre.y()}, int(entries.size()));
    const bg::index::rtree<Entry, bg::index::quadratic<16>> tree{entries};
    std::set<std::pair<int, int>> found;
    for (const auto &[point, index] : entries) {
        const bg::model::box<Point> square{{point.x() - within, point.y() - within},
                                           {point.x() + within, point.y() + within}};
        std::vector<Entry> near;
        tree.query(bg::index::intersects(square), std::back_inserter(near));
        for (const auto &[other, its_index] : near)
            if (index < its_index && bg::distance(point, other) <= within) found.emplace(index, its_index);
    }
    return found;
}

double compare_crowds(Dice &dice) {
    int others = 0;
    for (int i = 0; i < cases / 100; ++i) {
        std::vector<Vec2> centres;
        for (int count = 0; count < 500; ++count) centres.push_back(dice.point(-20, 20));
        const double within = dice.real(0.5, 3);
        const auto want = pairs_by_tree(centres, within);
        const auto got = close_pairs(centres, within);
        others += std::abs(int(got.size()) - int(want.size()));
        for (const auto &[first, second] : got) others += want.contains({first, second}) ? 0 : 1;
    }
    return others;
}

std::string boost_name() {
    return "Boost " + std::to_string(BOOST_VERSION / 100000) + '.' + std::to_string(BOOST_VERSION / 100 % 1000);
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv,
        "Compared with Eigen " + std::to_string(EIGEN_WORLD_VERSION) + '.' + std::to_string(EIGEN_MAJOR_VERSION) + '.'
            + std::to_string(EIGEN_MINOR_VERSION) + ", " + course::box2d_name() + " and " + boost_name()
            + ", 20000 random cases each, or 200 with *",
        {{"decompose: by a rotation [m/s]", compare_components},
         {"exchange*: two discs in Box2D, in floats [m/s]", compare_exchanges},
         {"resolve_collision*: two discs in Box2D, in floats [m/s]", compare_collisions},
         {"time_of_impact: by Boost's search for a root [s]", [](Dice &dice) { return compare_impacts(dice, false); }},
         {"time_of_impact: a time for one, never for the other",
          [](Dice &dice) { return compare_impacts(dice, true); }},
         {"close_pairs*: other pairs than those of Boost's R-tree", compare_crowds}});
}
