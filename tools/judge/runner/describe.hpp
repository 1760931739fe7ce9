#pragma once
// Values as a student reads them: (4, -2) m, {from (0, 0) m, to (4, 3) m}, nothing, [1, 2, 3].

#include "base/lines.hpp"
#include "judge/protocol/wire.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The shortest text that reads back as the same number, or `digits` significant ones.
inline std::string describe_number(double x, int digits = 0) {
    if (std::isnan(x)) return "not a number";
    if (std::isinf(x)) return x < 0 ? "-infinity" : "infinity";
    std::array<char, 64> text{};
    const auto end = digits == 0
                         ? std::to_chars(text.data(), text.data() + text.size(), x)
                         : std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

/// "a [m], b [m/s]" in parts, without blanks around them; `"1"` and `""` are no unit.
inline std::vector<std::string> split_list(std::string_view list) {
    std::vector<std::string> parts;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        parts.emplace_back(trim(list.substr(0, comma)));
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return parts;
}

inline std::string with_unit(std::string text, std::string_view unit) {
    return unit.empty() || unit == "1" ? text : text + ' ' + std::string{unit};
}

/// What a value is called, and the unit: "speed along x [m/s]" in two parts.
struct Label {
    std::string name, unit;
    std::string since = {}; ///< how what is expected is worked out: "1600 / 64 = 25 N"
};
inline Label split_label(std::string_view text) {
    const std::size_t bracket = text.find(" [");
    if (bracket == text.npos || text.back() != ']') return {std::string{text}, {}};
    return {std::string{text.substr(0, bracket)}, std::string{text.substr(bracket + 2, text.size() - bracket - 3)}};
}

/// @param digits  significant digits of a number; 0: as many as it has
template <class T> std::string describe(const T &value, std::string_view unit = {}, int digits = 0) {
    if constexpr (std::is_same_v<T, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_same_v<T, int>) {
        return with_unit(std::to_string(value), unit);
    } else if constexpr (std::is_same_v<T, double>) {
        return with_unit(describe_number(value, digits), std::isnan(value) ? "" : unit);
    } else if constexpr (std::is_same_v<T, Eigen::Vector2d>) {
        return with_unit('(' + describe_number(value.x(), digits) + ", " + describe_number(value.y(), digits) + ')',
                         unit);
    } else if constexpr (wire::is_optional<T>) {
        return value ? describe(*value, unit, digits) : "nothing";
    } else if constexpr (wire::is_vector<T>) {
        constexpr std::size_t most = 12;
        std::string text = "[";
        for (std::size_t i = 0; i < value.size() && i < most; ++i)
            text += (i == 0 ? "" : ", ") + describe<typename T::value_type>(value[i], {}, digits);
        if (value.size() > most) text += ", … " + std::to_string(value.size()) + " in all";
        return with_unit(text + ']', value.empty() ? "" : unit);
    } else {
        static_assert(wire::Fields<T>);
        const auto names = split_list(T::field_names), units = split_list(T::field_units);
        std::string text;
        std::size_t i = 0;
        const auto add = [&](const auto &field) {
            text += (i == 0 ? "" : ", ") + names[i] + ' ' + describe(field, i < units.size() ? units[i] : "", digits);
            ++i;
        };
        value.fields([&](const auto &...field) { (add(field), ...); });
        return '{' + text + '}';
    }
}

} // namespace course
