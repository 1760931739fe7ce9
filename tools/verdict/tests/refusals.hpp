#pragma once
// What every exercise has to refuse, asked of it in one go.

#include "verdict/tests/remote.hpp"

#include <array>
#include <functional>
#include <limits>
#include <stdexcept>

namespace course {

/// Whether this call accepts its input, which is noted for the verdict, by its arguments if it has no name; otherwise it throws std::invalid_argument.
inline bool accepts(const std::function<void()> &call, const std::string &input = {}, const std::string &value = {}) {
    try {
        call();
    } catch (const std::invalid_argument &) {
        return false;
    }
    note_accepted(input, value);
    return true;
}

/// Visits each double that a value holds, with its name: "motion.start.x".
template <class T, class Visit> void for_each_number(T &value, const std::string &name, const Visit &visit) {
    if constexpr (std::is_same_v<T, double>) {
        visit(value, name);
    } else if constexpr (std::is_same_v<T, Eigen::Vector2d>) {
        visit(value.x(), name + ".x");
        visit(value.y(), name + ".y");
    } else if constexpr (wire::is_optional<T>) {
        if (value) for_each_number(*value, name, visit);
    } else if constexpr (wire::is_vector<T>) {
        for (std::size_t i = 0; i < value.size(); ++i)
            for_each_number(value[i], name + '[' + std::to_string(i) + ']', visit);
    } else if constexpr (wire::Fields<T>) {
        const auto names = split_list(T::field_names);
        std::size_t i = 0;
        value.fields([&](auto &...field) { (for_each_number(field, name + '.' + names[i++], visit), ...); });
    } else {
        static_assert(std::is_same_v<T, int> || std::is_same_v<T, bool>,
                      "which numbers does a value of this type hold?");
    }
}

/// Calls an exercise with good arguments, which it must accept; then again and again, each time with one of their
/// numbers out of the range of ±1e5, or not a number.
/// @return whether it accepted any of these; they are noted for the verdict
template <auto F> bool accepts_out_of_range(const Remote<F> &exercise, typename Remote<F>::Given arguments) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::array<double, 6> bad{infinity, -infinity, std::nan(""), 100001, -100001, -3e200};
    const auto ask = [&] { std::apply(exercise, arguments); };
    const auto names = exercise.argument_names();
    bool any = false;
    const auto spoil = [&](double &number, const std::string &name) {
        const double good = number;
        for (const double value : bad) {
            number = value;
            any = accepts(ask, name, describe(value)) || any;
        }
        number = good;
    };
    ask();
    std::size_t i = 0;
    std::apply([&](auto &...argument) { (for_each_number(argument, names[i++], spoil), ...); }, arguments);
    return any;
}

} // namespace course
