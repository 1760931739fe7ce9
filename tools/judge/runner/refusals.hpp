#pragma once
// What every exercise has to refuse, asked of it in one go.

#include "judge/runner/remote.hpp"

#include <functional>
#include <stdexcept>

namespace course {

/// Whether this call accepts the input, which is noted for the verdict, by the arguments if it has no name; otherwise it throws std::invalid_argument.
inline bool accepts(const std::function<void()> &call, const std::string &input = {}, const std::string &value = {}) {
    try {
        call();
    } catch (const std::invalid_argument &) {
        return false;
    }
    note_accepted(input, value);
    return true;
}

/// Visits each double that a value holds, with a name: "motion.start.x".
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

} // namespace course
