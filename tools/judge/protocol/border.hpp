#pragma once
// The border of C++: a caller beyond it may hand over any number, so each is checked here, once, and functions needn't.

#include "course.hpp"
#include "judge/protocol/wire.hpp"

/// What goes into an exercise, in whatever unit, is within ± this. A section whose exercises take larger numbers has a
/// function of this name in its own namespace, which is found before this one.
constexpr double largest_number(std::string_view /*exercise*/) { return course::largest; }

namespace course {

/// Refuses values that hold a number beyond a limit, or one that isn't a number, however deep inside.
/// @throws std::invalid_argument naming the first such number
template <class... Values> void require_within(double limit, const Values &...values);

template <class T> void require_each_within(double limit, const T &value) {
    const auto all_of = [limit](const auto &...parts) { require_within(limit, parts...); };
    if constexpr (std::is_same_v<T, double>) {
        const bool usual = limit == largest;
        require(std::abs(value) <= limit,
                usual ? "each number must lie within ±1e5" : "each number must lie within ±1e10", value);
    } else if constexpr (std::is_same_v<T, Vec2>) {
        all_of(value.x(), value.y());
    } else if constexpr (wire::is_optional<T>) {
        if (value) all_of(*value);
    } else if constexpr (wire::is_vector<T>) {
        for (const typename T::value_type &element : value) all_of(element);
    } else if constexpr (wire::Fields<T>) {
        value.fields(all_of);
    } else {
        static_assert(std::is_integral_v<T> || std::is_same_v<T, std::string>, "which numbers does this type hold?");
    }
}

template <class... Values> void require_within(double limit, const Values &...values) {
    (require_each_within(limit, values), ...);
}

} // namespace course
