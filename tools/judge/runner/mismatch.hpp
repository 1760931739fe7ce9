#pragma once
// Compares a value with the expected one, and keeps where they part: field, yours, expected, tolerance.

#include "judge/runner/channel.hpp"
#include "judge/runner/describe.hpp"

#include <cmath>
#include <string>

namespace course {

namespace mismatch {

/// Where in a value we are: a path ("point", "[2].x"), and the unit there. Both are made only where something differs.
class Place {
  public:
    Place(std::string_view whole_unit = {}) : units{whole_unit} {}

    Place element(std::size_t i) const { return {this, {}, {}, i}; }
    template <wire::Fields T> Place field(std::size_t i) const { return {this, T::field_names, T::field_units, i}; }

    std::string unit() const {
        if (outer == nullptr) return std::string{units};
        if (names.empty()) return outer->unit();
        const auto all = split_list(units);
        return which < all.size() ? all[which] : "";
    }
    std::string says(const std::string &value) const { return outer == nullptr ? value : path() + " = " + value; }

  private:
    Place(const Place *of, std::string_view of_all, std::string_view all_units, std::size_t i)
        : outer{of}, names{of_all}, units{all_units}, which{i} {}

    std::string path() const {
        if (outer == nullptr) return "";
        const std::string before = outer->path();
        if (names.empty()) return before + '[' + std::to_string(which) + ']';
        return (before.empty() ? "" : before + '.') + split_list(names)[which];
    }

    const Place *outer = nullptr;  ///< has this as a field or an element
    std::string_view names, units; ///< of all fields of it; without names, this is an element
    std::size_t which = 0;
};

/// Both at nine digits; at all digits where nine look the same.
template <class T> Mismatch differ(const Place &at, const T &got, const T &want, double tolerance) {
    const int nine = describe(got, {}, 9) == describe(want, {}, 9) ? 0 : 9;
    return {{},
            at.says(describe(got, at.unit(), nine)),
            at.says(describe(want, at.unit(), nine)),
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

/// The relative error. What should be 0, or would be but for rounding, has the size 1.
template <class T> double relative_error(const T &got, const T &want) {
    const double part = distance(got, want) / (size(want) < 1e-9 ? 1 : size(want));
    return part < 1 ? part : 1; // infinite, or no number, too
}

/// The first difference, or nothing.
template <class T> std::optional<Mismatch> find(const Place &at, const T &got, const T &want, double tolerance) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>) {
        if (got == want) return {};
        return differ(at, got, want, 0);
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Eigen::Vector2d>) {
        if (got == want || distance(got, want) <= tolerance * std::max(1.0, size(want))) return {};
        auto mismatch = differ(at, got, want, tolerance * std::max(1.0, size(want)));
        mismatch.not_a_number = is_nan(got) && !is_nan(want);
        mismatch.off = relative_error(got, want);
        return mismatch;
    } else if constexpr (wire::is_optional<T>) {
        if (got && want) return find(at, *got, *want, tolerance);
        if (!got && !want) return {};
        auto mismatch = differ(at, got, want, 0);
        mismatch.not_a_number = is_nan(got);
        return mismatch;
    } else if constexpr (wire::is_vector<T>) {
        if (got.size() != want.size())
            return Mismatch{{}, at.says(describe(got, at.unit(), 9)), at.says(describe(want, at.unit(), 9)), "", false};
        for (std::size_t i = 0; i < got.size(); ++i)
            if (auto mismatch = find<typename T::value_type>(at.element(i), got[i], want[i], tolerance))
                return mismatch;
        return {};
    } else {
        static_assert(
            wire::Fields<T>,
            "IsNear compares bool, int, double, Vec2, std::optional, std::vector, and structs with COURSE_FIELDS");
        std::optional<Mismatch> first;
        std::size_t i = 0;
        const auto compare = [&]<class Field>(const Field &a, const Field &b) {
            if (!first) first = find<Field>(at.field<T>(i), a, b, tolerance);
            ++i;
        };
        got.fields([&](const auto &...a) { want.fields([&](const auto &...b) { (compare(a, b), ...); }); });
        if (first) first->whole = at.says(describe(want, at.unit(), 9));
        return first;
    }
}

} // namespace mismatch

/// The unit of a value: the label's, or that of the last call's result, which it has to be if it has no label.
template <class T> std::string unit_of(const T &value, const Label &label) {
    if (!label.name.empty()) return label.unit;
    wire::Writer bytes;
    bytes.put(value);
    if (const auto unit = unit_of_answer(bytes.bytes)) return std::string{*unit};
    refuse_nameless();
    return {};
}

/// Notes what differs for the verdict, with what the matcher tells of it.
inline void note(Mismatch mismatch, const Label &label) {
    mismatch.label = label.name;
    mismatch.since = label.since;
    note_mismatch(mismatch);
}

/// Whether `got` is as near to `want` as IsNear promises; what differs is noted for the verdict.
template <class T> bool is_near(const T &got, const T &want, double tolerance, const Label &label) {
    const std::string unit = unit_of(got, label);
    auto difference = mismatch::find<T>(std::string_view{unit}, got, want, tolerance);
    if (!difference) return true;
    note(std::move(*difference), label);
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
    auto difference = mismatch::differ<double>(std::string_view{unit}, got, bound, 0);
    difference.expected = std::string{order.words} + ' ' + difference.expected;
    difference.not_a_number = std::isnan(double(got));
    difference.off = mismatch::relative_error<double>(got, bound);
    note(std::move(difference), label);
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
