#pragma once
// As much of Catch2 as the sections' tests use, for a page, where Catch2 isn't: cases, GENERATE of values, and checks, which tell
// the session what they see. harness.cpp runs them.

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace Catch {

unsigned getSeed();

namespace Matchers {
struct MatcherGenericBase {
    virtual ~MatcherGenericBase() = default;
    virtual std::string describe() const = 0;
};
} // namespace Matchers

namespace Generators {
template <class T> std::vector<T> range(T from, T to) {
    std::vector<T> all;
    for (; from < to; ++from) all.push_back(from);
    return all;
}
template <class T> std::vector<T> values_of(std::vector<T> all) { return all; }
template <class First, class... Rest> auto values_of(First first, Rest... rest) {
    return std::vector<std::common_type_t<First, Rest...>>{std::move(first), std::move(rest)...};
}
} // namespace Generators

struct Case {
    const char *name, *tags, *file;
    int line;
    void (*run)();
};

/// In the order of the file.
inline std::vector<Case> &cases() {
    static std::vector<Case> all;
    return all;
}

struct NewCase {
    explicit NewCase(Case one) { cases().push_back(one); }
};

/// Ends the running case: a check in it has failed.
struct CaseFailed {};

void begin_check(const char *file, int line);
void end_check(bool passed);
[[noreturn]] void end_check_that_threw(); ///< to be called where what it threw is caught

/// Which of so many values the running case takes at a GENERATE; it is run again for the next.
std::size_t next_choice(std::size_t of);

template <class Value, class Matcher> void check_that(const Value &value, const Matcher &matcher) {
    const bool passed = matcher.match(value);
    end_check(passed);
    if (!passed) throw CaseFailed{};
}

} // namespace Catch

#define COURSE_JOINED_(a, b) a##b
#define COURSE_JOINED(a, b) COURSE_JOINED_(a, b)
#define COURSE_CASE(name, tags, function)                                                                              \
    static void function();                                                                                            \
    static const Catch::NewCase COURSE_JOINED(function, _case){{name, tags, __FILE__, __LINE__, &function}};           \
    static void function()
#define TEST_CASE(name, tags) COURSE_CASE(name, tags, COURSE_JOINED(case_, __COUNTER__))

#define REQUIRE_THAT(value, ...)                                                                                       \
    do {                                                                                                               \
        Catch::begin_check(__FILE__, __builtin_LINE());                                                                \
        try {                                                                                                          \
            Catch::check_that(value, __VA_ARGS__);                                                                     \
        } catch (const Catch::CaseFailed &) {                                                                          \
            throw;                                                                                                     \
        } catch (...) {                                                                                                \
            Catch::end_check_that_threw();                                                                             \
        }                                                                                                              \
    } while (false)
#define SUCCEED() (Catch::begin_check(__FILE__, __builtin_LINE()), Catch::end_check(true))
#define FAIL_CHECK(words) (Catch::begin_check(__FILE__, __builtin_LINE()), Catch::end_check(false))

#define GENERATE(...)                                                                                                  \
    ([&] {                                                                                                             \
        using namespace Catch::Generators;                                                                             \
        const auto all = values_of(__VA_ARGS__);                                                                       \
        return all[Catch::next_choice(all.size())];                                                                    \
    }())
#define GENERATE_COPY(...) GENERATE(__VA_ARGS__)

// What section_test.hpp takes away.
#define REQUIRE(...)
#define REQUIRE_FALSE(...)
#define CHECK(...)
#define CHECK_FALSE(...)
#define CHECK_THAT(...)
#define CHECK_THROWS_AS(...)
