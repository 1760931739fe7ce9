// needs GSL GSL::gsl libgsl-dev
// GSL solves quadratic equations, finds roots and minima, and moves things with integrators of its own.
#include "../peers/peer.hpp"
#include "../peers/gsl.hpp"
#include "trajectories.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_poly.h>
#include <gsl/gsl_version.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

using course::Vec2, course::worse;
using motion::State;
using namespace trajectories;

namespace {

constexpr int cases = 20000; // in each comparison, or a hundredth of them where GSL takes many steps
constexpr double degree = std::numbers::pi / 180;

State random_shot(Dice &dice) {
    const Vec2 at{dice.real(-50, 50), dice.real(0, 100)};
    return {at, dice.point(-30, 30)};
}

double compare_components(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double speed = dice.real(0, 100), angle = dice.real(-360, 360);
        const gsl_complex want = gsl_complex_polar(speed, angle * degree);
        largest = worse((launch_velocity(speed, angle) - Vec2{GSL_REAL(want), GSL_IMAG(want)}).norm(), largest);
    }
    return largest;
}

/// The larger solution for the time at which a shell is at this height; not a number if there is none.
double landing(const State &muzzle, double g, double height) {
    double first = 0, second = 0; // in ascending order
    const int found =
        gsl_poly_solve_quadratic(-g / 2, muzzle.velocity.y(), muzzle.position.y() - height, &first, &second);
    return found == 2 ? second : std::nan("");
}

double compare_times(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const State muzzle = random_shot(dice);
        const double g = dice.real(1, 20);
        largest = worse(std::abs(time_of_flight(muzzle, g) - landing(muzzle, g, 0)), largest);
    }
    return largest;
}

/// The far end of the arc as a curve y(x), which knows nothing of time.
double compare_ranges(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        State muzzle = random_shot(dice);
        muzzle.velocity.x() = dice.real(1, 30);
        const double g = dice.real(1, 20), slope = muzzle.velocity.y() / muzzle.velocity.x();
        double first = 0, second = 0;
        gsl_poly_solve_quadratic(-g / (2 * muzzle.velocity.x() * muzzle.velocity.x()), slope, muzzle.position.y(),
                                 &first, &second);
        largest = worse(course::difference(range(muzzle, g), second), largest);
    }
    return largest;
}

/// The highest point is the lowest one of the arc turned upside down.
double compare_apexes(Dice &dice) {
    double largest = 0;
    const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> search{
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free};
    for (int i = 0; i < cases; ++i) {
        State muzzle = random_shot(dice);
        muzzle.velocity.y() = dice.real(1, 30);
        std::array<double, 3> all{muzzle.position.y(), muzzle.velocity.y(), dice.real(1, 20)};
        gsl_function depth{[](double t, void *data) {
                               const auto &[y, up, g] = *static_cast<std::array<double, 3> *>(data);
                               return g * t * t / 2 - up * t - y;
                           },
                           &all};
        const double end = 2 * all[1] / all[2];
        gsl_min_fminimizer_set(search.get(), &depth, 0.4 * end, 0, end);
        for (int round = 0; round < 50; ++round) gsl_min_fminimizer_iterate(search.get());
        const double highest = -gsl_min_fminimizer_f_minimum(search.get());
        largest = worse(course::difference(apex(muzzle, all[2]).y(), highest), largest);
    }
    return largest;
}

/// A shell in wind, as GSL wants it: x, y and their velocities.
using Shell = std::array<double, 4>;

Shell flown(const State &muzzle, std::array<double, 2> pull, double t) {
    const course::Slopes<4> slopes = [&](const Shell &now) { return Shell{now[2], now[3], pull[0], -pull[1]}; };
    return course::moved({muzzle.position.x(), muzzle.position.y(), muzzle.velocity.x(), muzzle.velocity.y()}, slopes,
                         t);
}

double compare_arcs(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const State muzzle = random_shot(dice);
        const double g = dice.real(1, 20), dt = landing(muzzle, g, 0) / 9.5;
        const std::vector<Vec2> arc = dotted_arc(muzzle, g, dt);
        for (std::size_t k = 1; k < arc.size(); ++k) {
            const Shell there = flown(muzzle, {0, g}, k + 1 < arc.size() ? double(k) * dt : landing(muzzle, g, 0));
            largest = worse((arc[k] - Vec2{there[0], there[1]}).norm(), largest);
        }
    }
    return largest;
}

double compare_winds(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases / 100; ++i) {
        const State muzzle = random_shot(dice);
        const double g = dice.real(1, 20), wind = dice.real(-5, 5);
        const Shell there = flown(muzzle, {wind, g}, landing(muzzle, g, 0));
        const double want = there[0] - muzzle.position.x();
        largest = worse(course::difference(range_in_wind(muzzle, g, wind), want), largest);
    }
    return largest;
}

double compare_heights(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const State muzzle = random_shot(dice);
        const double g = dice.real(1, 20), height = muzzle.position.y() + dice.real(-30, 20);
        const double t = landing(muzzle, g, height);
        const std::optional<double> got = range_at_height(muzzle, g, height);
        if (got.has_value() != (t >= 0)) return std::nan("");
        if (got) largest = worse(course::difference(*got, muzzle.velocity.x() * t), largest);
    }
    return largest;
}

/// The two angles on both sides of the one that reaches farthest in this direction, by a search for a root.
double compare_angles(Dice &dice) {
    double largest = 0;
    for (int i = 0; i < cases; ++i) {
        const double x = dice.real(5, 40), y = dice.real(-30, 5), fall = 9.8 / (2 * 900); // g / 2v² at 30 m/s
        const auto above = [&](double angle) { // times cos², or it would be infinite straight up
            return (x * std::sin(angle) - y * std::cos(angle)) * std::cos(angle) - fall * x * x;
        };
        const double seen = std::atan2(y, x), middle = std::numbers::pi / 4 + seen / 2;
        const std::vector<double> got = launch_angles(30, {x, y}, 9.8);
        if (got.size() != 2) return std::nan("");
        for (const bool high : {false, true}) {
            const double want = course::root_of(above, high ? middle : seen, high ? std::numbers::pi / 2 : middle);
            largest = worse(std::abs(got[high] - want / degree), largest);
        }
    }
    return largest;
}

} // namespace

int main(int argc, char **argv) {
    return course::compare_with_peer(
        argc, argv, "Compared with GSL " GSL_VERSION ", 20000 random cases each, or 200 with *",
        {{"launch_velocity: a complex number by its angle [m/s]", compare_components},
         {"time_of_flight: the larger solution of a quadratic equation [s]", compare_times},
         {"range: the same for the curve y(x), of itself", compare_ranges},
         {"apex: the minimum of the arc upside down, of its height", compare_apexes},
         {"dotted_arc*: flown by an integrator [m]", compare_arcs},
         {"range_in_wind*: flown by an integrator, of itself", compare_winds},
         {"range_at_height: the larger solution, of itself", compare_heights},
         {"launch_angles: both by a search for a root [°]", compare_angles}});
}
