#pragma once
// What several peers ask of the GNU Scientific Library.

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

namespace course {

/// How fast each of these numbers changes.
template <std::size_t size> using Slopes = std::function<std::array<double, size>(const std::array<double, size> &)>;

/// The same, as GSL wants it. The slopes must outlive it.
template <std::size_t size> gsl_odeiv2_system system_of(const Slopes<size> &slopes) {
    const auto called = [](double, const double now[], double changes[], void *data) {
        std::array<double, size> all{};
        std::copy_n(now, size, all.begin());
        std::ranges::copy((*static_cast<const Slopes<size> *>(data))(all), changes);
        return int(GSL_SUCCESS);
    };
    return {called, nullptr, size, const_cast<Slopes<size> *>(&slopes)};
}

/// What they are after t, in as many steps as their error needs.
template <std::size_t size> std::array<double, size> moved(std::array<double, size> now, const Slopes<size> &slopes,
                                                           double t, double first_step = 1e-3) {
    const gsl_odeiv2_system system = system_of(slopes);
    const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver{
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, first_step, 1e-13, 1e-13),
        gsl_odeiv2_driver_free};
    double time = 0;
    gsl_odeiv2_driver_apply(driver.get(), &time, t, now.data());
    return now;
}

/// Where the function changes its sign between these two.
inline double root_of(std::function<double(double)> f, double low, double high) {
    gsl_function called{[](double x, void *data) { return (*static_cast<std::function<double(double)> *>(data))(x); },
                        &f};
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> search{
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free};
    gsl_root_fsolver_set(search.get(), &called, low, high);
    for (int round = 0; round < 60; ++round) gsl_root_fsolver_iterate(search.get());
    return gsl_root_fsolver_root(search.get());
}

} // namespace course
