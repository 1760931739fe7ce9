// needs GSL GSL::gsl libgsl-dev
// GSL differentiates, solves quadratic equations, and moves things with integrators of its own.
#include "../peers/peer.hpp"
#include "../peers/gsl.hpp"
#include "gravity_wells.hpp"

#include <gsl/gsl_deriv.h>
#include <gsl/gsl_poly.h>
#include <gsl/gsl_version.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

using course::Vec2, course::worse;
using motion::PointMass, motion::State;
using namespace gravity_wells;

namespace {

constexpr int cases = 20000; // in each comparison, or a hundredth of them where GSL takes thousands of small steps

/// The slope of a function along x or y, by differences.
template <class F> double slope(const F &f, double at, double step) {
    const gsl_function wrapped{[](double x, void *data) { return (*static_cast<const F *>(data))(x); },
                               const_cast<F *>(&f)};
    double result = 0, error = 0;
    gsl_deriv_central(&wrapped, at, step, &result, &error);
    return result;
}

/// Minus the gradient of a potential.
template <class F> Vec2 downhill(const F &potential, const Vec2 &at, double step) {
    return {-slope(
                [&](double x) {
                    return potential(Vec2{x, at.y()});
                },
                at.x(), step),
            -slope(
                [&](double y) {
                    return potential(Vec2{at.x(), y});
                },
                at.y(), step)};
}

double compare_gravity(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const PointMass body{dice.point(-50, 50), dice.real(0.1, 100)}, other{dice.point(-50, 50), dice.real(0.1, 100)};
        const double G = dice.real(0.1, 10), r = (body.position - other.position).norm();
        if (r < 1) continue;
        const auto potential = [&](const Vec2 &at) {
            return -G * body.mass * other.mass / std::hypot(at.x() - other.position.x(), at.y() - other.position.y());
        };
        const Vec2 got = gravity(body, other, G), want = downhill(potential, body.position, r / 1000);
        largest = worse((got - want).norm() / got.norm(), largest);
    }
    return largest;
}

double compare_softened(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double mu = dice.real(1, 1000), epsilon = dice.real(0.5, 5);
        const Vec2 at = dice.point(-10, 10);
        const auto potential = [&](const Vec2 &p) { return -mu / std::hypot(p.x(), p.y(), epsilon); };
        const Vec2 difference = softened_gravity(at, mu, epsilon) - downhill(potential, at, epsilon / 1000);
        largest = worse(difference.norm() / (mu / (epsilon * epsilon)), largest);
    }
    return largest;
}

double compare_falls(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double height = dice.real(0, 100), velocity = dice.real(-30, 30), g = dice.real(1, 20);
        double first = 0, second = 0; // in ascending order
        gsl_poly_solve_quadratic(-g / 2, velocity, height, &first, &second);
        largest = worse(std::abs(time_to_fall(height, velocity, g) - second), largest);
    }
    return largest;
}

/// A ship in a well at (0, 0), as GSL wants it: x, y and their velocities.
using Ship = std::array<double, 4>;

course::Slopes<4> slopes_of(double mu) {
    return [mu](const Ship &now) {
        const double r = std::hypot(now[0], now[1]), k = -mu / (r * r * r);
        return Ship{now[2], now[3], k * now[0], k * now[1]};
    };
}

/// Where the ship is after t seconds.
Ship flown(const Ship &ship, double mu, double t) { return course::moved(ship, slopes_of(mu), t, 1e-6); }

double compare_circles(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const double mass = dice.real(1, 1000), r = dice.real(1, 50), G = dice.real(0.1, 10);
        const double speed = circular_orbit_speed(mass, r, G);
        const Ship there = flown({r, 0, 0, speed}, G * mass, dice.real(0, 3) * 2 * std::numbers::pi * r / speed);
        largest = worse(std::abs(std::hypot(there[0], there[1]) / r - 1), largest);
    }
    return largest;
}

double compare_kepler(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const double a = dice.real(0.5, 20), e = dice.real(0, 0.9), mu = dice.real(1, 1000);
        const double t = dice.real(0, 2) * 2 * std::numbers::pi * std::sqrt(a * a * a / mu);
        const Ship there = flown({a * (1 - e), 0, 0, std::sqrt(mu / a * (1 + e) / (1 - e))}, mu, t);
        largest = worse((kepler_position(a, e, mu, t) - Vec2{there[0], there[1]}).norm() / a, largest);
    }
    return largest;
}

/// GSL takes its classical step twice, with half of the length.
double compare_runge_kutta(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double mu = dice.real(1, 1000);
        const double r = dice.real(1, 20), dt = dice.real(0, 0.1) * std::sqrt(r * r * r / mu);
        const State ship{r * dice.direction(), dice.real(0, 1.4) * std::sqrt(mu / r) * dice.direction()};
        Ship there{ship.position.x(), ship.position.y(), ship.velocity.x(), ship.velocity.y()};
        const course::Slopes<4> slopes = slopes_of(mu);
        const gsl_odeiv2_system system = course::system_of(slopes);
        const std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step{
            gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, 4), gsl_odeiv2_step_free};
        std::array<double, 4> error{};
        gsl_odeiv2_step_apply(step.get(), 0, 2 * dt, there.data(), error.data(), nullptr, nullptr, &system);
        Integrators now{ship, ship, ship, ship};
        for (int half = 0; half < 2; ++half) now = step_all(now, mu, dt);
        largest = worse((now.runge_kutta.position - Vec2{there[0], there[1]}).norm() / r, largest);
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv, "Compared with GSL " GSL_VERSION ", 20000 random cases each, or 200 with *",
        {{"gravity, with the slope of its potential: of itself", compare_gravity},
         {"time_to_fall: the larger solution of a quadratic equation [s]", compare_falls},
         {"circular_orbit_speed*: distance after up to three turns, of itself", compare_circles},
         {"softened_gravity, with the slope: of mu / epsilon²", compare_softened},
         {"step_all, Runge–Kutta: two steps, of the distance", compare_runge_kutta},
         {"kepler_position*: up to two turns, of semi_major", compare_kepler}});
}
