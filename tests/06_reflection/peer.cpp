// needs box2d box2d::box2d libbox2d-dev
// Eigen reflects a vector as linear algebra does, by Householder's matrix, and turns it by rotations as matrices.
// Box2D is an engine: it bounces balls off walls in floats, with restitution and friction.
#include "../peers/peer.hpp"
#include "../peers/box2d.hpp"
#include "reflection.hpp"

#include <Eigen/Geometry>
#include <Eigen/Householder>

#include <cmath>
#include <numbers>

using course::Vec2, course::worse;
using namespace reflection;

namespace {

constexpr double pi = std::numbers::pi;
constexpr int cases = 20000; // in each comparison, or a hundredth of them with an engine

/// By the matrix 1 - tau w w^T whose w is (1, essential): Householder's reflection, which sends `normal` to an axis.
double compare_reflections(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Vec2 velocity = dice.point(-10, 10), normal = dice.real(0.1, 10) * dice.direction();
        if (std::abs(normal.x()) < 1e-3) continue; // its essential part would be large
        const Eigen::Matrix<double, 1, 1> essential{normal.y() / normal.x()};
        const double tau = 2 / (1 + essential[0] * essential[0]);
        Vec2 want = velocity;
        double workspace = 0;
        want.applyHouseholderOnTheLeft(essential, tau, &workspace);
        largest = worse((reflect(velocity, normal) - want).norm(), largest);
    }
    return largest;
}

/// A quarter turn by Eigen's rotations.
double compare_normals(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const Vec2 start = dice.point(-10, 10), end = dice.point(-10, 10);
        largest =
            worse((unit_normal(start, end) - Eigen::Rotation2Dd{pi / 2} * (end - start).normalized()).norm(), largest);
    }
    return largest;
}

/// A disc that does not spin, and a long edge below it.
Vec2 engine_bounce(const Vec2 &velocity, const Surface &surface) {
    b2World world{{0, 0}};
    b2BodyDef at_rest;
    b2EdgeShape wall;
    wall.SetTwoSided({-1000, 0}, {1000, 0});
    b2FixtureDef below;
    below.shape = &wall;
    below.friction = float(surface.mu_k);
    below.restitution = float(surface.restitution);
    below.restitutionThreshold = 0;
    world.CreateBody(&at_rest)->CreateFixture(&below);

    b2BodyDef movable;
    movable.type = b2_dynamicBody;
    movable.position = {0, 1};
    movable.fixedRotation = true;
    movable.linearVelocity = {float(velocity.x()), float(velocity.y())};
    b2CircleShape disc;
    disc.m_radius = 0.5f;
    b2FixtureDef fixture;
    fixture.shape = &disc;
    fixture.density = 1;
    fixture.friction = float(surface.mu_k);
    fixture.restitution = float(surface.restitution);
    fixture.restitutionThreshold = 0;
    b2Body *ball = world.CreateBody(&movable);
    ball->CreateFixture(&fixture);
    for (int frame = 0; frame < 120 && ball->GetLinearVelocity().y < 0; ++frame) world.Step(1 / 60.0f, 50, 3);
    return {ball->GetLinearVelocity().x, ball->GetLinearVelocity().y};
}

double compare_bounces(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const Vec2 velocity{dice.real(-10, 10), dice.real(-10, -2)};
        const Surface surface{dice.real(0.1, 1), dice.real(0, 1)};
        largest = worse((bounce(velocity, {0, 1}, surface) - engine_bounce(velocity, surface)).norm(), largest);
    }
    return largest;
}

/// Each of the four sides by itself, as a line that Eigen turns, measures the distance from, and mirrors at.
double compare_turned(Dice &dice) {
    using Line = Eigen::Hyperplane<double, 2>;
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double angle = dice.real(-4, 4);
        const Box box{dice.point(-6, -2), dice.point(2, 6)};
        const Ball ball{dice.point(-8, 8), dice.point(-10, 10), dice.real(0, 1)};
        const Eigen::Rotation2Dd to{angle};
        Vec2 want = ball.velocity;
        for (Line side :
             {Line{{1, 0}, box.low}, Line{{0, 1}, box.low}, Line{{-1, 0}, box.high}, Line{{0, -1}, box.high}}) {
            side.transform(to.toRotationMatrix(), Eigen::Isometry);
            const Line through_origin{side.normal(), 0.0};
            if (side.signedDistance(ball.position) < ball.radius && side.normal().dot(want) < 0)
                want = 2 * through_origin.projection(want) - want;
        }
        largest = worse((bounce_in_rotated_box(ball, box, angle) - want).norm(), largest);
    }
    return largest;
}

/// The image by Eigen's mirrors, one after the other.
double compare_shots(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double width = dice.real(5, 12), height = dice.real(3, 7);
        const Ball ball{{dice.real(1, width - 1), dice.real(1, height - 1)}, {0, 0}, 1};
        const Vec2 target{dice.real(1, width - 1), dice.real(1, height - 1)};
        const int across = dice.whole(1, 5), up = dice.whole(1, 5);
        Vec2 image = target;
        const auto mirror = [&](const Vec2 &normal, double at) {
            const Eigen::Hyperplane<double, 2> line{normal, Vec2{at * normal}};
            image = 2 * line.projection(image) - image;
        };
        for (int n = 0; n < across; ++n) mirror({1, 0}, (n + 1) * (width - 2) + 1);
        for (int n = 0; n < up; ++n) mirror({0, 1}, (n + 1) * (height - 2) + 1);
        const Vec2 want = (image - ball.position).normalized();
        largest = worse((bank_shot(ball, target, {{0, 0}, {width, height}}, across, up) - want).norm(), largest);
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv,
        "Compared with Eigen " + std::to_string(EIGEN_WORLD_VERSION) + '.' + std::to_string(EIGEN_MAJOR_VERSION) + '.'
            + std::to_string(EIGEN_MINOR_VERSION) + " and " + course::box2d_name()
            + ", 20000 random cases each, or 200 with *",
        {{"reflect: by a Householder matrix [m/s]", compare_reflections},
         {"unit_normal: a quarter turn by a rotation [1]", compare_normals},
         {"bounce*: a ball in Box2D, in floats [m/s]", compare_bounces},
         {"bounce_in_rotated_box: side by side, mirrored at turned lines [m/s]", compare_turned},
         {"bank_shot: mirror by mirror, by projection onto each [1]", compare_shots}});
}
