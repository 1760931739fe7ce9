#pragma once
// What all tests compare with: those of the course (section_test.hpp), and a reader's own (own_test.hpp). Kept small: it
// is precompiled once, and read with each of them.

#include <catch2/catch_get_random_seed.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_templated.hpp>

#include "course.hpp"
#include "dice.hpp"
#include "judge/runner/mismatch.hpp"
#include "judge/runner/refusals.hpp"
#include "judge/runner/remote.hpp"

#include <cmath>
#include <limits>
#include <vector>

using course::Vec2;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline const double not_a_number = std::nan("");
inline const double too_large = std::nextafter(course::largest, infinity); ///< the first number that is refused

inline constexpr double rounding = 1e-12; ///< of some dozen operations, and what the headers promise

/// A matcher whose value may have a name.
template <class Matcher> class Named : public Catch::Matchers::MatcherGenericBase {
  public:
    /// The same matcher for a value with this name, and its unit if it has one: "speed along x [m/s]".
    Matcher of(std::string_view name) const {
        Matcher named = static_cast<const Matcher &>(*this);
        named.label = course::split_label(name);
        return named;
    }
    /// The same matcher with the arithmetic behind what is expected, which a verdict tells: "1600 / 64 = 25 N".
    Matcher since(std::string_view arithmetic) const {
        Matcher explained = static_cast<const Matcher &>(*this);
        explained.label.since = arithmetic;
        return explained;
    }

  protected:
    course::Label label;
};

/// Matches a value as near to `want` as `tolerance` allows: absolute for what is smaller than 1, relative for what is
/// larger. A vector counts by its distance, a struct field by field, an optional or a list by what is in it.
/// "Not a number" is near to nothing. What differs is kept for the verdict.
template <class T> class IsNear : public Named<IsNear<T>> {
  public:
    explicit IsNear(T want_, double tolerance_ = 0) : want{std::move(want_)}, tolerance{tolerance_} {}

    template <class Got> bool match(const Got &got) const {
        if constexpr (wraps<Got>) return course::is_near<Got>(got, Got{want}, tolerance, this->label);
        else if constexpr (std::is_same_v<Got, double>)
            return course::is_near<double>(got, want, tolerance, this->label);
        else
            return course::is_near<T>(T(got), want, tolerance,
                                      this->label); // Eigen's unfinished sums become vectors here
    }
    std::string describe() const override { return "is near " + course::describe(want); }

  private:
    template <class Got> static constexpr bool wraps =
        std::is_same_v<Got, std::optional<T>>; // want 3, got std::optional{3}
    T want;
    double tolerance;
};

inline auto IsTrue(std::string_view claim) { return IsNear{true}.of(claim); }

/// Matches a number on the right side of a bound. "Not a number" is on neither.
class IsOrdered : public Named<IsOrdered> {
  public:
    IsOrdered(double bound_, course::Order order_) : bound{bound_}, order{order_} {}

    bool match(double got) const { return course::is_ordered(got, bound, order, label); }
    template <std::integral Count> bool match(Count got) const {
        return course::is_ordered(static_cast<int>(got), bound, order, label);
    }
    std::string describe() const override { return std::string{"is "} + order.words; }

  private:
    double bound;
    course::Order order;
};

inline auto IsAtMost(double bound) {
    return IsOrdered{bound, {"at most", [](double x, double y) { return x <= y; }}};
}
inline auto IsAtLeast(double bound) {
    return IsOrdered{bound, {"at least", [](double x, double y) { return x >= y; }}};
}
inline auto IsBelow(double bound) {
    return IsOrdered{bound, {"below", [](double x, double y) { return x < y; }}};
}
inline auto IsAbove(double bound) {
    return IsOrdered{bound, {"above", [](double x, double y) { return x > y; }}};
}

/// Matches a list of so many elements.
class HasSize : public Named<HasSize> {
  public:
    explicit HasSize(std::size_t want_) : want{want_} {}

    template <class T> bool match(const std::vector<T> &got) const { return course::has_size(got, want, label); }
    std::string describe() const override { return "has " + std::to_string(want) + " elements"; }

  private:
    std::size_t want;
};

inline Dice::Dice() : Dice{Catch::getSeed()} {}
