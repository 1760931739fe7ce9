#pragma once
// Compares a value with the one wanted, and keeps where they part: field, yours, expected, tolerance.

#include "verdict/tests/channel.hpp"
#include "verdict/tests/describe.hpp"

#include <cmath>
#include <string>

namespace course {

namespace mismatch {

/// Where in a value we are: its path ("point", "[2].x"), and the unit there.
struct Place {
    std::string path, unit;

    Place field(const std::string &name, const std::string &its_unit) const {
        return {path.empty() || name.starts_with('[') ? path + name : path + '.' + name, its_unit};
    }
    std::string says(const std::string &value) const { return path.empty() ? value : path + " = " + value; }
};

/// Both at nine digits; at all of theirs where nine look the same.
template <class T> Mismatch differ(const Place &at, const T &got, const T &want, double tolerance) {
    const int nine = describe(got, {}, 9) == describe(want, {}, 9) ? 0 : 9;
    return {{},
            at.says(describe(got, at.unit, nine)),
            at.says(describe(want, at.unit, nine)),
            tolerance > 0 ? describe_number(tolerance, 3) : "",
            false};
}

inline bool is_nan(double x) { return std::isnan(x); }
inline bool is_nan(const Eigen::Vector2d &v) { return v.hasNaN(); }
template <class T> bool is_nan(const std::optional<T> &x) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Eigen::Vector2d>) return x && is_nan(*x);
    return false;
}
inline double distance(double a, double b) { return std::abs(a - b); }
inline double distance(const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y()); // Eigen's stableNorm() of (0, NaN) is 0
}
inline double size(double x) { return std::abs(x); }
inline double size(const Eigen::Vector2d &v) { return std::hypot(v.x(), v.y()); }

/// The first difference, or nothing.
template <class T> std::optional<Mismatch> find(const Place &at, const T &got, const T &want, double tolerance) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>) {
        if (got == want) return {};
        return differ(at, got, want, 0);
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Eigen::Vector2d>) {
        if (got == want || distance(got, want) <= tolerance * std::max(1.0, size(want))) return {};
        auto found = differ(at, got, want, tolerance * std::max(1.0, size(want)));
        found.not_a_number = is_nan(got) && !is_nan(want);
        return found;
    } else if constexpr (wire::is_optional<T>) {
        if (got && want) return find(at, *got, *want, tolerance);
        if (!got && !want) return {};
        auto found = differ(at, got, want, 0);
        found.not_a_number = is_nan(got);
        return found;
    } else if constexpr (wire::is_vector<T>) {
        if (got.size() != want.size())
            return Mismatch{{}, at.says(describe(got, at.unit, 9)), at.says(describe(want, at.unit, 9)), "", false};
        for (std::size_t i = 0; i < got.size(); ++i)
            if (auto found = find<typename T::value_type>(at.field('[' + std::to_string(i) + ']', at.unit), got[i],
                                                          want[i], tolerance))
                return found;
        return {};
    } else {
        static_assert(
            wire::Fields<T>,
            "IsNear compares bool, int, double, Vec2, std::optional, std::vector, and structs with COURSE_FIELDS");
        const auto names = split_list(T::field_names), units = split_list(T::field_units);
        std::optional<Mismatch> found;
        std::size_t i = 0;
        const auto compare = [&]<class Field>(const Field &mine, const Field &theirs) {
            if (!found)
                found = find<Field>(at.field(names[i], i < units.size() ? units[i] : ""), mine, theirs, tolerance);
            ++i;
        };
        got.fields(
            [&](const auto &...mine) { want.fields([&](const auto &...theirs) { (compare(mine, theirs), ...); }); });
        if (found) found->whole = at.says(describe(want, at.unit, 9));
        return found;
    }
}

} // namespace mismatch

/// The unit of a value: its label's, or that of the last call's result, which it has to be if it has no label.
template <class T> std::string unit_of(const T &value, const Label &label) {
    if (!label.name.empty()) return label.unit;
    wire::Writer bytes;
    bytes.put(value);
    if (const auto unit = unit_of_answer(bytes.bytes)) return std::string{*unit};
    refuse_nameless();
    return {};
}

/// Notes what differs for the verdict, with what its matcher says of it.
inline void note(Mismatch found, const Label &label) {
    found.label = label.name;
    found.since = label.since;
    note_mismatch(found);
}

/// Whether `got` is as near to `want` as IsNear promises; what differs is noted for the verdict.
template <class T> bool is_near(const T &got, const T &want, double tolerance, const Label &label) {
    auto found = mismatch::find<T>({{}, unit_of(got, label)}, got, want, tolerance);
    if (!found) return true;
    note(std::move(*found), label);
    return false;
}

/// How a number must lie to a bound: "at most", with what that means.
struct Order {
    const char *words;
    bool (*holds)(double got, double bound);
};

template <class T> bool is_ordered(const T &got, double bound, const Order &order, const Label &label) {
    const std::string unit = unit_of(got, label);
    if (order.holds(got, bound)) return true;
    auto found = mismatch::differ<double>({{}, unit}, got, bound, 0);
    found.expected = std::string{order.words} + ' ' + found.expected;
    found.not_a_number = std::isnan(double(got));
    note(std::move(found), label);
    return false;
}

template <class T> bool has_size(const std::vector<T> &got, std::size_t want, const Label &label) {
    const std::string unit = unit_of(got, label);
    if (got.size() == want) return true;
    const auto counted = [](std::size_t size) { return std::to_string(size) + (size == 1 ? " element" : " elements"); };
    note({{}, counted(got.size()) + ": " + describe(got, unit, 9), counted(want), "", false}, label);
    return false;
}

} // namespace course
