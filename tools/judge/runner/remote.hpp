#pragma once
// Gives COURSE_EXERCISE its meaning for tests: a function of the same name in `subject`, which calls the student's.
// Include it before the section's header. It takes types only, so the tests link without any implementation.

#include "judge/runner/channel.hpp"
#include "judge/runner/describe.hpp"

namespace course {

template <auto F> class Remote;

template <class Result, class... Arguments, Result (*F)(Arguments...)> class Remote<F> {
  public:
    using Given = std::tuple<std::decay_t<Arguments>...>; ///< what goes in

    Remote(std::string_view section, std::string_view number, std::string_view tier, std::string_view function,
           std::string_view arguments, std::string_view unit)
        : exercise{.section = section,
                   .number = number,
                   .tier = tier,
                   .function = function,
                   .arguments = arguments,
                   .unit = unit,
                   .describe_arguments = &describe_all,
                   .describe_result = &describe_one} {
        std::vector<const ExerciseLine *> &lines = exercise_lines();
        if (!lines.empty() && lines.front()->section != section) { // an earlier one's, included first
            earlier_exercise_lines().insert(earlier_exercise_lines().end(), lines.begin(), lines.end());
            lines.clear();
        }
        exercise.index = static_cast<std::uint32_t>(lines.size());
        lines.push_back(&exercise);
    }
    Remote(const Remote &) = delete;
    Remote &operator=(const Remote &) = delete;

    std::vector<std::string> argument_names() const {
        std::vector<std::string> names = split_list(exercise.arguments);
        for (std::string &name : names) name = split_label(name).name;
        return names;
    }

    Result operator()(const std::type_identity_t<std::decay_t<Arguments>> &...arguments) const {
        wire::Writer request;
        (request.put(arguments), ...);
        wire::Reader reader{call(exercise, std::move(request.bytes))};
        auto result = reader.take<Result>();
        if (!reader.finished()) answered_nonsense(reader.too_large());
        return result;
    }

  private:
    static std::vector<std::string> describe_all(const ExerciseLine &exercise, std::string_view bytes) {
        wire::Reader reader{bytes};
        std::vector<std::string> lines;
        const auto named = split_list(exercise.arguments);
        const auto add = [&](const auto &value) {
            const Label label = split_label(lines.size() < named.size() ? named[lines.size()] : "?");
            lines.push_back(label.name + " = " + describe(value, label.unit));
        };
        const std::tuple<std::decay_t<Arguments>...> values{reader.take<std::decay_t<Arguments>>()...};
        std::apply([&](const auto &...value) { (add(value), ...); }, values);
        return lines;
    }

    static std::string describe_one(const ExerciseLine &exercise, std::string_view bytes) {
        constexpr int digits = 9;
        wire::Reader reader{bytes};
        return describe(reader.take<Result>(), exercise.unit, digits);
    }

    ExerciseLine exercise;
};

} // namespace course

#undef COURSE_EXERCISE
#define COURSE_EXERCISE(number, tier, section, function, arguments, unit)                                              \
    static const course::Remote<&section::function> function{#section, number, #tier, #function, arguments, unit};
