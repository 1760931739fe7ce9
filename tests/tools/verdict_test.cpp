// The wire, and the session that owns the verdict, against processes that lie.

#include "base/lines.hpp"
#include "base/plain.hpp"
#include "check/advice.hpp"
#include "check/answer.hpp"
#include "check/diagnosis.hpp"
#include "check/junit.hpp"
#include "interface.hpp"
#include "judge/protocol/wire.hpp"
#include "judge/runner/describe.hpp"
#include "judge/runner/mismatch.hpp"
#include "judge/runner/refusals.hpp"
#include "judge/runner/session.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <pugixml.hpp>

#include <array>
#include <cmath>
#include <csignal>
#include <functional>
#include <limits>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sched.h>
#endif

using namespace course;
using Eigen::Vector2d;

namespace {

struct Inner {
    Vector2d place;
    int count = 0;
    COURSE_FIELDS("m, 1", place, count)
};
struct Outer {
    double time = 0;
    std::vector<Inner> inner;
    std::optional<bool> known;
    COURSE_FIELDS("s, , ", time, inner, known)
};

template <class T> std::string bytes_of(const T &value) {
    wire::Writer writer;
    writer.put(value);
    return writer.bytes;
}

const Outer outer{1.5, {{{1, -2}, 3}, {{0.1, 1e300}, -4}}, true};

} // namespace

TEST_CASE("what crosses the wire arrives as it was") {
    const std::string bytes = bytes_of(outer);
    wire::Reader reader{bytes};
    const auto arrived = reader.take<Outer>();
    CHECK(reader.finished());
    CHECK(bytes_of(arrived) == bytes);
    CHECK(arrived.inner.at(1).place == Vector2d{0.1, 1e300});
    CHECK(arrived.known == true);
}

TEST_CASE("every beginning of a message is refused, and every message with a byte too many") {
    const std::string bytes = bytes_of(outer);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        wire::Reader reader{std::string_view{bytes}.substr(0, size)};
        reader.take<Outer>();
        CHECK_FALSE(reader.finished());
    }
    const std::string longer = bytes + 'x';
    wire::Reader reader{longer};
    reader.take<Outer>();
    CHECK(reader.ok());
    CHECK_FALSE(reader.finished());
}

TEST_CASE("a bool is 0 or 1, and a length is no longer than what is there") {
    wire::Reader seven{std::string_view{"\x07", 1}};
    seven.take<bool>();
    CHECK_FALSE(seven.ok());

    const std::string long_list = bytes_of(std::uint32_t{0xFFFFFFFF}) + "12345678";
    wire::Reader list{long_list}, text{long_list};
    CHECK(list.take<std::vector<double>>().size() <= 2);
    CHECK_FALSE(list.ok());
    text.take<std::string>();
    CHECK_FALSE(text.ok());
}

TEST_CASE("lists that take far more memory than bytes are refused, each and all together") {
    const auto empty_places = [](std::uint32_t count) { return bytes_of(count) + std::string(count, '\0'); };
    using AllowedPaths = std::vector<std::optional<double>>; // 16 bytes each, instead of 1
    const std::string million = empty_places(1'000'000), more = empty_places(1'100'000);
    wire::Reader reader{million}, refused{more};
    CHECK(reader.take<AllowedPaths>().size() == 1'000'000);
    CHECK(reader.finished());
    CHECK(refused.take<AllowedPaths>().empty());
    CHECK((refused.too_large() && !refused.ok()));

    const std::string two = bytes_of(std::uint32_t{2}) + million + million;
    wire::Reader both{two};
    CHECK(both.take<std::vector<AllowedPaths>>().size() == 2);
    CHECK(both.too_large());
    wire::Reader short_of{std::string_view{two}.substr(0, 9)};
    short_of.take<std::vector<AllowedPaths>>();
    CHECK_FALSE(short_of.too_large());
}

TEST_CASE("values are described as a student reads them") {
    CHECK(describe(0.1) == "0.1");
    CHECK(describe(1.0 / 3, "m", 3) == "0.333 m");
    CHECK(describe(std::nan("")) == "not a number");
    CHECK(describe(std::nan(""), "s") == "not a number");
    CHECK(describe(std::optional{std::nan("")}, "s") == "not a number");
    CHECK(describe(-std::numeric_limits<double>::infinity()) == "-infinity");
    CHECK(describe(Vector2d{4, -2}, "m/s") == "(4, -2) m/s");
    CHECK(describe(std::optional<double>{}) == "nothing");
    CHECK(describe(outer)
          == "{time 1.5 s, inner [{place (1, -2) m, count 3}, {place (0.1, 1e+300) m, count -4}], known true}");
    CHECK(describe(std::vector<int>(20, 7)) == "[7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, … 20 in all]");
}

TEST_CASE("the first field that differs is named, with its unit") {
    Outer other = outer;
    other.inner[0].place.x() = 0.2;
    const auto found = mismatch::find<Outer>({}, other, outer, 1e-9);
    REQUIRE(found);
    CHECK(found->yours == "inner[0].place = (0.2, -2) m");
    CHECK(found->whole == describe(outer));
    CHECK(mismatch::find<std::vector<Inner>>({}, other.inner, outer.inner, 0)->whole
          == "[0] = {place (1, -2) m, count 3}");
    CHECK(mismatch::find<double>({}, 1, 2, 0)->whole.empty());
}

TEST_CASE("IsNear is absolute below 1, relative above it, and never true of NaN") {
    const auto near = [](double got, double want, double tolerance) {
        return !mismatch::find<double>({}, got, want, tolerance);
    };
    CHECK(near(1e-10, 0, 1e-9));
    CHECK_FALSE(near(2e-9, 0, 1e-9));
    CHECK(near(1e9 + 0.5, 1e9, 1e-9));
    CHECK_FALSE(near(1e9 + 2, 1e9, 1e-9));
    CHECK_FALSE(near(NAN, 0, 1e9));
    CHECK_FALSE(near(0, NAN, 1e9));
    CHECK_FALSE(near(INFINITY, 1, 1e9));
    CHECK(near(INFINITY, INFINITY, 0));
    for (const Vector2d &got : {Vector2d{0, NAN}, Vector2d{NAN, 1}, Vector2d{NAN, NAN}, Vector2d{0, INFINITY}})
        CHECK(mismatch::find<Vector2d>({}, got, {0, 1}, 1e9));
    CHECK(mismatch::find<double>({}, NAN, 1, 0)->not_a_number);
    CHECK_FALSE(mismatch::find<double>({}, 2, 1, 0)->not_a_number);
}

TEST_CASE("yours and expected are told apart at as many digits as that takes") {
    const auto found = mismatch::find<double>({}, 1 + 1e-14, 1, 1e-15);
    REQUIRE(found);
    CHECK(found->yours == "1.00000000000001");
    CHECK(found->expected == "1");
}

namespace {

std::vector<std::string> describe_one(const ExerciseLine &, std::string_view bytes) {
    wire::Reader reader{bytes};
    return {"x = " + describe(reader.take<double>())};
}
std::string describe_half(const ExerciseLine &, std::string_view bytes) {
    wire::Reader reader{bytes};
    return describe(reader.take<double>(), "m");
}
const ExerciseLine half{"numbers", "1.1", "core", "half", "x [m]", "m", describe_one, describe_half, 0};

/// A session that the matchers speak to while it lives. Its subject behaves like `mode`: see hostile_subject.cpp.
struct OwnSession : Session {
    explicit OwnSession(const std::string &mode, TimeLimits time_limits = {}, const char *path = HOSTILE)
        : Session{path, time_limits, mode} {
        static const bool once = (exercise_lines().push_back(&half), prepare_for_subjects(cores().front()), true);
        static_cast<void>(once);
        session() = this;
    }
    ~OwnSession() { session() = nullptr; }
    OwnSession(const OwnSession &) = delete;
    OwnSession &operator=(const OwnSession &) = delete;

    /// The verdict on a case that asks for the half of five, and looks at the answer in this way.
    Verdict half_of_five(
        const std::function<void(double)> &look = [](double) {}, const char *exercise = "1.1") {
        begin(exercise, "half of five");
        try {
            wire::Reader reader{call(half, bytes_of(5.0))};
            const auto x = reader.take<double>();
            if (!reader.finished()) answered_nonsense();
            look(x);
        } catch (const CaseOver &) {}
        return end(true);
    }
};

/// What a student reads where a check of a test fails like this.
template <class Check> std::string shown_for(Check check) {
    OwnSession own{"answers"};
    own.begin("1.1", "a claim");
    CHECK_FALSE(check());
    own.fail(Outcome::wrong, "", "", 0);
    return explain(own.end(true), 0);
}

} // namespace

TEST_CASE("what a test has computed is named in the verdict, with its unit") {
    CHECK(shown_for([] {
              return is_near(Vector2d{0.2, 0}, Vector2d{0, 0}, 1e-12, split_label("sum of all velocities [m/s]"));
          })
          == "sum of all velocities:\nyours     (0.2, 0) m/s\nexpected  (0, 0) m/s ± 1e-12\n");
    CHECK(shown_for([] { return is_near(false, true, 0, split_label("both ends lie on one side")); })
          == "both ends lie on one side:\nyours     false\nexpected  true\n");
    CHECK(shown_for([] { return is_near(outer, Outer{}, 0, split_label("the last one")); })
          == "the last one:\nexpected  {time 0 s, inner [], known nothing}\nyours     time = 1.5 s\nexpected  time = 0 "
             "s\n");
    CHECK(shown_for([] {
              return has_size(std::vector{1, 2, 3}, 1, split_label("slots that changed"));
          })
          == "slots that changed:\nyours     3 elements: [1, 2, 3]\nexpected  1 element\n");
}

TEST_CASE("how what is expected is worked out is said below it, of a value, a bound and a list") {
    const Label speed{"speed", "m/s", "8 m / 4 s"}, slots{"slots", "", "1 + 0"};
    CHECK(shown_for([&] { return is_near(3.0, 2.0, 0, speed); })
          == "speed:\nyours     3 m/s\nexpected  2 m/s\nsince     8 m / 4 s\n");
    CHECK(shown_for([&] {
              return is_ordered(3.0, 2, {"at most", [](double x, double y) { return x <= y; }}, speed);
          }).ends_with("expected  at most 2 m/s\nsince     8 m / 4 s\n"));
    CHECK(shown_for([&] { return has_size(std::vector{1, 2}, 1, slots); }).ends_with("1 element\nsince     1 + 0\n"));
}

TEST_CASE("an answer that is infinite is said to be divided by zero, unless that is what was wanted") {
    const auto time = [](double got, double want) {
        return shown_for([&] { return is_near(got, want, 0, split_label("time [s]")); });
    };
    CHECK(time(INFINITY, 2).starts_with("Your answer is infinite. Was something divided by zero?"));
    CHECK(time(-INFINITY, 2).starts_with("Your answer is infinite"));
    CHECK(time(INFINITY, -INFINITY) == "time:\nyours     infinity s\nexpected  -infinity s\n");
    CHECK(time(3, 2) == "time:\nyours     3 s\nexpected  2 s\n");
}

TEST_CASE("a refusal of a number that the call was not given is known from one of its input") {
    OwnSession own{"answers"};
    own.half_of_five([&](double) {
        CHECK_FALSE(own.is_computed("x must be large, but is 5"));
        CHECK(own.is_computed("x must be large, but is -5"));
        CHECK(own.is_computed("x must be large, but is 0"));
        CHECK(own.is_computed("x must be large, but isn't a number"));
        CHECK_FALSE(own.is_computed("x must be large"));
    });
    const auto of = [&](const std::vector<std::string> &arguments) {
        static std::vector<std::string> given;
        given = arguments;
        ExerciseLine line = half;
        line.describe_arguments = [](const ExerciseLine &, std::string_view) { return given; };
        own.last_exercise = &line;
        const bool computed = own.is_computed("a, but is 0.10000000000000001");
        own.last_exercise = nullptr;
        return computed;
    };
    CHECK(of({"x = 1 m", "walls = [{from (0.2, -0.1) m, to (4, 1.1) m}]"}));
    CHECK_FALSE(of({"x = 1 m", "walls = [{from (0.2, 0.1) m, to (4, 3) m}]"}));
    CHECK_FALSE(of({"x = 1 m", "state = {position 2 m, time 0.1 s}"}));
    CHECK_FALSE(of({"list = [1, 2, … 20 in all]"}));
}

TEST_CASE("all input that should have been refused is listed in one verdict, whatever fails after it") {
    OwnSession own{"answers"};
    own.begin("1.1", "a claim");
    const auto throws_it = [] { throw std::invalid_argument{"no"}; };
    const auto takes = [] {};
    CHECK_FALSE(accepts(throws_it, "radius is negative"));
    CHECK(accepts(takes, "dt is negative"));
    own.fail(Outcome::wrong, "bad input was accepted", "a.cpp", 3);
    CHECK(accepts(takes, "start.x", "infinity"));
    CHECK(accepts(takes, "start.x", "not a number"));
    CHECK(accepts(takes, "dt is negative")); // asked once more, with other arguments: said once
    CHECK(accepts(takes, "start.x", "infinity"));
    CHECK(accepts(takes, "start.x", "-infinity"));
    own.fail(Outcome::too_long, "an answer that never came", "a.cpp", 4);
    const Verdict verdict = own.end(true);
    CHECK(verdict.kind == Outcome::wrong);
    CHECK(explain(from_line(to_line(verdict)).value(), 0)
          == "Your code accepted input that it must refuse with std::invalid_argument:\n  dt is negative\n"
             "  start.x = infinity, not a number, -infinity\nsee       a.cpp:3\n");
}

TEST_CASE("each number of a call's arguments has its turn, with its name") {
    std::vector<std::string> names;
    Outer changed = outer;
    for_each_number(changed, "first", [&](double &number, const std::string &name) {
        names.push_back(name);
        number = 7;
    });
    CHECK(names
          == std::vector<std::string>{"first.time", "first.inner[0].place.x", "first.inner[0].place.y",
                                      "first.inner[1].place.x", "first.inner[1].place.y"});
    CHECK(changed.time == 7);
    CHECK(changed.inner[1].place == Vector2d{7, 7});
}

TEST_CASE("an order that does not hold is said with its bound, and told apart at as many digits as that takes") {
    const Order at_most{"at most", [](double x, double y) { return x <= y; }};
    const auto speed = [&](double got) {
        return shown_for([&] { return is_ordered(got, 3, at_most, split_label("speed along x [m/s]")); });
    };
    CHECK(speed(3.2) == "speed along x:\nyours     3.2 m/s\nexpected  at most 3 m/s\n");
    CHECK(speed(3 + 1e-14).find("yours     3.00000000000001 m/s\n") != std::string::npos);
    CHECK(speed(NAN).find("\"not a number\"") != std::string::npos);
    CHECK(is_ordered(3.0, 3, at_most, split_label("speed")));
}

TEST_CASE("an answer that is not a number is said to be none, also where nothing was wanted") {
    const auto time = [](std::optional<double> got, std::optional<double> want) {
        return shown_for([&] { return is_near(got, want, 0, split_label("time of impact [s]")); });
    };
    const std::string reason = "it comes from 0/0, ";
    CHECK(time(NAN, {}).find(reason) != std::string::npos);
    CHECK(time(NAN, {}).ends_with("\nyours     not a number\nexpected  nothing\n"));
    CHECK(time(NAN, 2).find(reason) != std::string::npos);
    CHECK(time({}, 2).find(reason) == std::string::npos);
    CHECK(time(2, {}) == "time of impact:\nyours     2 s\nexpected  nothing\n");
    const auto point = [](const Vector2d &got) {
        return shown_for(
            [&] { return is_near(std::optional{got}, std::optional<Vector2d>{}, 0, split_label("centre [m]")); });
    };
    CHECK(point({NAN, NAN}).find(reason) != std::string::npos);
    CHECK(point({1, 2}).find(reason) == std::string::npos);
}

TEST_CASE("printed text is shown without control characters") {
    const auto [lines, more] = tidy("red \x1b[31m\ttab\r\n\xff\xfe broken\n\xc2\x9b"
                                    "31m c1\nzwölf\n",
                                    3);
    CHECK(lines == std::vector<std::string>{"red ?[31m tab?", "?? broken", "?31m c1"});
    CHECK(more == 1);
    CHECK(tidy(std::string(1000, 'x')).first.front().size() == 160 + std::string{"…"}.size());
    CHECK(tidy("no line end").first == std::vector<std::string>{"no line end"});
}

TEST_CASE("a compiler's output is cut and cleaned before it is parsed") {
    CHECK(sanitize("a\x1b[2Jb\r\nc\xff\n") == "a?[2Jb\nc?\n");
    CHECK(sanitize("") == "");
    CHECK(sanitize(std::string(300'000, 'x')) == std::string(5000, 'x') + "…\n");
    // Too long for what they say, half of a pair, beyond the last character, and one that XML does not have.
    CHECK(plain_line("\xe0\x80\xaf", 9) == "???");
    CHECK(plain_line("\xed\xa0\x80", 9) == "???");
    CHECK(plain_line("\xf4\x90\x80\x80", 9) == "????");
    CHECK(plain_line("\xef\xbf\xbf", 9) == "?");
    CHECK(plain_line("€𝄞", 9) == "€𝄞");
    for (const char *mark : {"\u061C", "\u200E", "\u200F", "\u202A", "\u202E", "\u2066", "\u2069"})
        CHECK(plain_line(std::string{"a"} + mark + "b", 9) == "a?b");
    CHECK(plain_line("\u2014\u2065\u206A", 9) == "\u2014\u2065\u206A"); // their neighbours stay
}

TEST_CASE("a failed check of a library is said in words, and on one line") {
    const std::string vector = "/usr/include/c++/12/bits/stl_vector.h:1123: std::vector<_Tp>::reference "
                               "std::vector<_Tp>::operator[](size_type) "
                               "[with _Tp = double]: Assertion '__n < this->size()' failed.\n";
    const std::string eigen = "subject: /usr/include/eigen3/Eigen/src/Core/DenseCoeffsBase.h:408: Scalar "
                              "&operator[](Index): Assertion `index >= 0 && index < size()' failed.\n";
    CHECK(meaning_of_assertion(vector) == "an index beyond the end");
    CHECK(meaning_of_assertion(eigen) == "an index beyond the end");
    CHECK(meaning_of_assertion("nothing of the kind\n").empty());
    CHECK(tidy(vector).first == std::vector<std::string>{"stl_vector.h:1123: Assertion '__n < this->size()' failed."});
    CHECK(tidy(eigen).first
          == std::vector<std::string>{"DenseCoeffsBase.h:408: Assertion `index >= 0 && index < size()' failed."});
}

TEST_CASE("a value that is not the answer of the last call has to be named") {
    OwnSession own{"answers"};
    const auto kind_for = [&](const std::function<void(double)> &check) { return own.half_of_five(check).kind; };
    CHECK(kind_for([](double answer) { is_near(answer, answer, 0, {}); }) == Outcome::passed);
    CHECK(kind_for([](double answer) { is_near(answer + 1, answer + 1, 0, {}); }) == Outcome::no_verdict);
    CHECK(kind_for([](double answer) { is_near(answer + 1, answer + 1, 0, {"one more", "m"}); }) == Outcome::passed);
    CHECK(kind_for([](double) { has_size(std::vector{1}, 1, {}); }) == Outcome::no_verdict);
    own.begin("1.1", "before any call");
    CHECK(is_near(1.0, 1.0, 0, {}));
}

TEST_CASE("a function of an earlier section that isn't started is told from one of the same name") {
    const ExerciseLine earlier{"motion", "0.7", "core", "half", "x [m]", "m", describe_one, describe_half, 0};
    earlier_exercise_lines() = {&earlier};
    OwnSession own{"answers"};
    const auto needed_by = [&](const char *function) {
        own.begin("1.1", "half of five");
        own.note_not_started("how much is it?", function);
        return own.end(true);
    };
    CHECK(needed_by("motion::half").needs == "0.7 half");
    CHECK(needed_by("motion::half").sentence
          == "It calls 0.7 half, which isn't started. Where to begin: how much is it?");
    CHECK(needed_by("momentum::half").needs.empty());
    earlier_exercise_lines().clear();
}

TEST_CASE("a process that answers properly passes") { CHECK(OwnSession{"answers"}.half_of_five().passed()); }

TEST_CASE("a process that breaks the protocol fails that call, and no other") {
    const auto [mode, kind] = GENERATE(table<std::string, Outcome>({
        {"answers_another_call", Outcome::out_of_turn},
        {"claims_four_gigabytes", Outcome::wrong},
        {"sends_half_a_frame", Outcome::too_long},
        {"sends_too_much", Outcome::out_of_turn},
        {"sends_too_little", Outcome::out_of_turn},
        {"sends_no_frame", Outcome::out_of_turn},
        {"answers_twice", Outcome::out_of_turn},
        {"drips", Outcome::too_long},
        {"dies", Outcome::crashed},
        {"is_mute", Outcome::too_long},
        {"greets_wrongly", Outcome::out_of_turn},
    }));
    CAPTURE(mode);
    CHECK(name_of(OwnSession{mode, {0.2, 5, 0.2}}.half_of_five().kind) == name_of(kind));
}

TEST_CASE("a refusal of what is not a number says so in words") {
    const auto refusal_of = [](const std::string &words) -> std::string {
        OwnSession own{"refuses: " + words};
        try {
            own.half_of_five();
        } catch (const std::invalid_argument &refusal) {
            return refusal.what();
        }
        return "";
    };
    for (const char *nan : {"nan", "-nan"})
        CHECK(refusal_of("each number must lie within ±1e5, but is " + std::string{nan})
              == "each number must lie within ±1e5, but isn't a number");
    CHECK(refusal_of("dt must be positive, but is -1") == "dt must be positive, but is -1");
    CHECK(refusal_of("no nan") == "no nan");
}

TEST_CASE("an answer that is too large to be taken is called so, and other nonsense is not") {
    const auto sentence_of = [](const char *mode) { return OwnSession{mode, {1, 5, 1}}.half_of_five().sentence; };
    CHECK(sentence_of("claims_four_gigabytes")
          == "Your answer is larger than 16 MB: does a loop add to the list too often?");
    for (const char *other : {"greets_with_four_gigabytes", "sends_too_much", "sends_no_frame"})
        CHECK(sentence_of(other).starts_with("Something other than your function's result came back."));
}

#ifdef __linux__
namespace {

/// Programs that compute without an end, all on the one core that we are on ourselves while they live.
class BusyMachine {
  public:
    BusyMachine() {
        ::sched_getaffinity(0, sizeof before, &before);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<std::size_t>(::sched_getcpu()), &one);
        ::sched_setaffinity(0, sizeof one, &one);
        for (pid_t &other : others)
            if ((other = ::fork()) == 0)
                for (;;) ::getppid();
    }
    ~BusyMachine() {
        for (const pid_t other : others) ::kill(other, SIGKILL), ::waitpid(other, nullptr, 0);
        ::sched_setaffinity(0, sizeof before, &before);
    }
    BusyMachine(const BusyMachine &) = delete;
    BusyMachine &operator=(const BusyMachine &) = delete;

  private:
    cpu_set_t before;
    std::array<pid_t, 6> others;
};

} // namespace

TEST_CASE("on a busy machine a verdict waits until the code has had its time of the processor") {
    const BusyMachine busy;
    OwnSession quick{"computes", {0.25, 5}}; // for 0.2 s, of which it gets a seventh
    quick.begin("1.1", "half of five");
    const auto start = Clock::now();
    CHECK(quick.call(half, bytes_of(5.0)) == bytes_of(2.5));
    CHECK(std::chrono::duration<double>(Clock::now() - start).count() > 0.25);

    OwnSession endless{"computes_for_long", {0.25, 5}};
    CHECK(endless.half_of_five().kind == Outcome::too_long);
    CHECK(endless.trouble().empty());
}

TEST_CASE("code that gets hardly any of the processor is the machine's trouble, and code that sleeps is not") {
    const BusyMachine busy; // half a core at most is left, and half a second of computing to do
    for (const auto &[mode, silence] : {std::pair{"computes_for_long", StudentProcess::Silence::starved},
                                        std::pair{"sends_half_a_frame", StudentProcess::Silence::late}}) {
        CAPTURE(mode);
        StudentProcess subject{HOSTILE, mode};
        REQUIRE(subject.receive({5}));
        REQUIRE(subject.send(1, 0, bytes_of(5.0), {5}));
        CHECK_FALSE(subject.receive({.spent = 5, .clock = 0.5}));
        CHECK((subject.silence == silence));
    }
}

TEST_CASE("code that sleeps is late, though it's awake whenever it is looked at") {
    StudentProcess subject{HOSTILE, "dodges_looks"};
    REQUIRE(subject.receive({5}));
    REQUIRE(subject.send(1, 0, bytes_of(5.0), {5}));
    CHECK_FALSE(subject.receive({.spent = 5, .clock = 0.7}));
    CHECK((subject.silence == StudentProcess::Silence::late));
}
#endif

TEST_CASE("an exercise that has hung once gets little time for its other cases, and another exercise gets all") {
    OwnSession own{"computes_for_long", {0.4, 5}}; // for 0.5 s
    const auto passes_in_twice_the_time = [&](const char *exercise) {
        own.begin(exercise, "half of five");
        own.allow(2);
        try {
            own.call(half, bytes_of(5.0));
        } catch (const CaseOver &) {}
        return own.end(true).passed();
    };
    CHECK(passes_in_twice_the_time("1.1"));
    CHECK(own.half_of_five().kind == Outcome::too_long);
    CHECK_FALSE(passes_in_twice_the_time("1.1"));
    CHECK(passes_in_twice_the_time("1.2"));
}

TEST_CASE("a case of large input may be given more time, and its verdict says that the input is large") {
    const auto judged = [](double seconds) {
        OwnSession own{"computes_for_long", {0.25, 5}};
        own.begin("1.1", "half of many");
        own.allow(seconds);
        try {
            own.call(half, bytes_of(5.0));
        } catch (const CaseOver &) {}
        return own.end(true);
    };
    CHECK(judged(4).passed());
    CHECK(
        judged(1.2).sentence
        == "Your code takes far too long. This test's input is large: do you do more work than you must? Or is there a "
           "loop that never stops?");
    OwnSession usual{"computes_for_long", {0.25, 5}};
    CHECK(usual.half_of_five().sentence == "Your code gave no answer: look for a loop that never stops.");
}

TEST_CASE("a case of several large inputs has its time for each of them") {
    OwnSession own{"computes_each_time", {0.5, 5}}; // for 0.3 s
    const auto passes_twice = [&](bool renewed) {
        own.begin("1.1", "two halves");
        own.allow(1);
        try {
            own.call(half, bytes_of(5.0));
            if (renewed) own.allow(1);
            own.call(half, bytes_of(5.0));
        } catch (const CaseOver &) {}
        return own.end(true).passed();
    };
    CHECK(passes_twice(true));
    CHECK_FALSE(passes_twice(false));
}

TEST_CASE("code that waits instead of computing is stopped after twice the time, and told so") {
    CHECK(OwnSession{"drips", {0.2, 5}}.half_of_five().sentence
          == "Your code waits for something that never comes. An exercise computes its answer, and never sleeps.");
    CHECK(OwnSession{"starts_slowly", {1, 5, 1}}.half_of_five().passed()); // 0.3 s count as 0.15
}

TEST_CASE("starting a subject has an allowance of its own, and all starts together one more") {
    const std::string slow = "starts_slowly"; // sleeps for 0.3 s, which count half
    OwnSession patient{slow, {0.2, 5}}, hasty{slow, {1, 5, 0.05}}, tired{slow, {1, 0.2}};
    CHECK(patient.half_of_five().passed());
    CHECK(patient.trouble().empty());
    CHECK(hasty.half_of_five().kind == Outcome::too_long);
    Verdict verdict = tired.half_of_five();
    CHECK(verdict.passed());
    for (int starts = 1; verdict.passed() && starts < 10; ++starts) verdict = tired.half_of_five();
    CHECK(verdict.sentence.starts_with("Your code is started again for each test"));
}

TEST_CASE("a program that this machine cannot start is the machine's trouble") {
    OwnSession own{"", {}, "/nowhere"};
    CHECK(own.half_of_five().kind == Outcome::no_verdict);
    CHECK_FALSE(own.trouble().empty());
}

TEST_CASE("a session notes the first failure of a case, and a case without assertions is one") {
    OwnSession own{"answers"};
    own.begin("1.1", "two failures");
    own.fail(Outcome::wrong, "first", "a.cpp", 1);
    own.fail(Outcome::crashed, "second", "b.cpp", 2);
    const Verdict verdict = own.end(true);
    CHECK(verdict.kind == Outcome::wrong);
    CHECK(verdict.sentence == "first");
    CHECK(verdict.file == "a.cpp");

    own.begin("1.1", "nothing asserted");
    CHECK(own.end(false).kind == Outcome::no_verdict);
}

TEST_CASE("a verdict survives its way through JSON") {
    Verdict verdict{.exercise = "7.2",
                    .test = "a \"claim\"",
                    .kind = Outcome::left_process,
                    .sentence = "what happened",
                    .call = Call{"meet", {"first = 1"}, 3, "{g, h}"},
                    .yours = "g",
                    .expected = "w",
                    .tolerance = "1e-9",
                    .whole = "{w, x}",
                    .since = "1 + 1",
                    .file = "t.cpp",
                    .line = 12,
                    .printed = {"printed"},
                    .printed_more = 4,
                    .needs = "7.1 crossing"};
    const auto back = from_line(to_line(verdict)).value();
    CHECK(explain(back, 2) == explain(verdict, 2));
    CHECK(back.kind == verdict.kind);
    CHECK(back.needs == verdict.needs);
    CHECK(explain(verdict, 2).find("meet() with   (call 4 of this test)") != std::string::npos);
    CHECK(explain(verdict, 2).find("returned  {g, h}\n") != std::string::npos);
    CHECK(explain(back, 2).find("since     1 + 1\n") != std::string::npos);
    verdict.yours = verdict.call->answer; // then it need not be said twice
    CHECK(explain(verdict, 2).find("returned") == std::string::npos);
    verdict.label = "speed"; // of something that only looks like the answer
    const auto named = from_line(to_line(verdict)).value();
    CHECK(explain(named, 2).find("returned  {g, h}\n  speed:\n  expected  {w, x}\n  yours     {g, h}\n")
          != std::string::npos);
}

TEST_CASE("a struct of structs that is wider than a screen has a line for each part, and nothing else is broken") {
    const auto part = [](const std::string &name) { return name + " {position (8, 0) m, velocity (0, 10) m/s}"; };
    const std::string wide = '{' + part("first") + ", " + part("second") + ", " + part("third") + '}';
    const std::string list = "walls = [" + wide + ", " + wide + ']', numbers = "{" + std::string(120, '1') + ", 2}";
    Verdict verdict;
    verdict.call = Call{"step_all", {"before = " + wide, list, "all = " + numbers, "dt = 2 s"}, 0, wide};
    CHECK(explain(verdict, 2)
          == "  call      step_all() with\n              before = {" + part("first") + ",\n                        "
                 + part("second") + ",\n                        " + part("third") + "}\n              " + list
                 + "\n              all = " + numbers + "\n              dt = 2 s\n  returned  {" + part("first")
                 + ",\n             " + part("second") + ",\n             " + part("third") + "}\n");
    verdict.call->arguments = {"now = {" + part("a") + ", b {1}}"}; // short enough
    CHECK(explain(verdict, 2).find("now = {" + part("a") + ", b {1}}\n") != std::string::npos);
}

TEST_CASE("JUnit files are XML whatever a student prints, and count what failed") {
    const Verdict passed{.exercise = "7.1", .test = "fine"}, wrong{.exercise = "7.1",
                                                                   .test = "<b> & \"quotes\"",
                                                                   .kind = Outcome::wrong,
                                                                   .sentence = "]]> </failure>",
                                                                   .yours = "1",
                                                                   .expected = "2",
                                                                   .file = "t.cpp",
                                                                   .line = 3,
                                                                   .printed = {"\u00e4"}};
    Verdict ours = wrong;
    ours.test = "ours";
    ours.kind = Outcome::no_verdict;
    Verdict later = wrong;
    later.test = "later";
    later.kind = Outcome::not_started;
    Verdict computed = wrong;
    computed.test = "computed";
    computed.sentence.clear();
    computed.label = "speed";
    Verdict accepts = wrong;
    accepts.test = "accepts";
    accepts.sentence = "It accepted:";
    accepts.accepted = {"dt < 0", "x = \x01\xff"};
    Report report{Section{"07_x"},
                  "a \x1b\n\xff<file>.cpp",
                  12,
                  {{"7.1", "core", "f"}},
                  {},
                  {},
                  {wrong, ours, passed, later, computed, accepts}};
    for (const Verdict &verdict : report.verdicts) report.tests.push_back({"7.1", verdict.test});
    report.tests.push_back({"7.1", "forgotten"});

    const auto read_back = [&] {
        const std::string xml = junit({report});
        for (const Line &line : split_lines(xml))
            CHECK(plain_line(line.text, 100'000) == line.text); // XML's characters
        pugi::xml_document read;
        REQUIRE(read.load_string(xml.c_str()));
        return read;
    };
    const auto read = read_back();
    const auto suite = read.child("testsuites").child("testsuite");
    CHECK(suite.attribute("tests").as_int() == 7);
    CHECK(suite.attribute("failures").as_int() == 3);
    CHECK(suite.attribute("errors").as_int() == 2);
    CHECK(suite.attribute("skipped").as_int() == 1);
    const auto property = [](const pugi::xml_node &node, const char *name) {
        return std::string{
            node.child("properties").find_child_by_attribute("name", name).attribute("value").as_string()};
    };
    CHECK(property(suite, "seed") == "12");
    CHECK(property(suite, "file") == "a ? ?<file>.cpp");
    CHECK(property(suite, "course version").find('.') != std::string::npos);
    const auto message = [&](const char *test, const char *element) {
        const auto node = suite.find_child_by_attribute("name", test);
        CHECK(property(node, "tier") == "core");
        return std::string{node.child(element).attribute("message").as_string()};
    };
    CHECK(message("<b> & \"quotes\"", "failure") == "]]> </failure>");
    CHECK(message("ours", "error") == "]]> </failure>");
    CHECK(message("later", "skipped") == "]]> </failure>");
    CHECK(message("computed", "failure") == "speed: 1 instead of 2");
    CHECK(message("accepts", "failure") == "It accepted: dt < 0; x = ??");
    CHECK(message("forgotten", "error").starts_with("This test has no verdict"));

    report.unbuilt = Verdict{.kind = Outcome::does_not_compile, .sentence = "expected ';'", .file = "a.cpp", .line = 3};
    const auto without = read_back();
    CHECK(without.child("testsuites").child("testsuite").attribute("failures").as_int() == 7);
    for (const auto &test : without.child("testsuites").child("testsuite").children("testcase"))
        CHECK(test.child("failure").attribute("message").as_string() == std::string{"a.cpp:3: expected ';'"});
}

TEST_CASE("of all that a compiler says, the first error is shown, with how many there are") {
    const auto verdict = diagnose_compiler(
        "In file included from a.hpp:1:\n/x/07.cpp:3:5: error: ‘y’ was not declared\n    3 |  y\n      |  ^\n"
        "/x/07.cpp:9:1: error: expected ‘;’\n",
        "/x/07.cpp", "exercises/07.cpp");
    CHECK(verdict.sentence == "'y' was not declared");
    CHECK(verdict.file == "exercises/07.cpp");
    CHECK(verdict.line == 3);
    CHECK(verdict.printed.size() == 2);
    CHECK(verdict.printed_more == 1);
}

TEST_CASE("a forgotten header is named, if the first error is about it") {
    const std::string first = "/x/07.cpp:3:5: error: ‘cout’ is not a member of ‘std’\n    3 |  std::cout\n      |  ^\n",
                      second = "/x/07.cpp:9:1: error: expected ‘;’\n",
                      note = "/x/07.cpp:1:1: note: ‘std::cout’ is defined in header ‘<iostream>’; did you forget to "
                             "‘#include <iostream>’?\n";
    const auto said = [](const std::string &printed) {
        return diagnose_compiler(printed, "/x/07.cpp", "exercises/07.cpp").sentence;
    };
    CHECK(said(first + note + second)
          == "'cout' is not a member of 'std'. Write #include <iostream> at the top of your file.");
    CHECK(said(second + first + note) == "expected ';'");
}

TEST_CASE("for the slips that are made most, a compiler's words are explained") {
    const auto said = [](const std::string &error) {
        return diagnose_compiler("/x/07.cpp:3:5: error: " + error + "\n", "/x/07.cpp", "07.cpp").sentence;
    };
    CHECK(said("control reaches end of non-void function [-Werror=return-type]")
          == "control reaches end of non-void function. Some path through this function has no `return`.");
    CHECK(said("could not convert ‘a * b’ from ‘Eigen::Product<Eigen::Matrix<double, 2, 1>, Eigen::Matrix<double, 2, "
               "1>, 0>’")
              .ends_with("write a.dot(b)."));
    CHECK(said("expected ‘;’ before ‘}’ token") == "expected ';' before '}' token");
    CHECK(said("expected ‘;’ before ‘}’ token\n   12 | }\n      | ^")
              .ends_with("token. Look at the end of the line above: is its ; there?"));
}

TEST_CASE("no line is so long, and no byte so strange, that what a compiler or linker says of it does harm") {
    const std::string long_word =
        GENERATE(std::string(300'000, 'x'), std::string(300'000, '<'), std::string(300'000, '\''),
                 std::string(300'000, ':'), std::string(300'000, '1'), std::string(100'000, '\xff'));
    const auto said = [&](const std::string &words) {
        const std::string error = "/x/07.cpp:3:5: error: " + words + "\n    3 |  " + words + "\n      |  ^\n";
        const std::string more = "/x/07.cpp:4:1: warning: " + words + " [-Wx]\n" + "required from " + words + '\n';
        static_cast<void>(find_warnings(error + more, "/x/07.cpp", "07.cpp"));
        static_cast<void>(explain_missing("0000000000000000 T " + words + "(int)\n", words, "meet"));
        static_cast<void>(diagnose_linker(words + '\n', "07.cpp", "7"));
        return diagnose_compiler(error + more, "/x/07.cpp", "07.cpp");
    };
    CHECK(said("#error " + long_word).line == 3);
    CHECK(said("no matching function for call to 'f(" + long_word + ")'").line == 3);
    CHECK(said("Eigen::Product<" + long_word + "> {aka " + long_word + " [with T = " + long_word).line == 3);
    CHECK(said("multiple definition of `" + long_word).line == 3);
    CHECK(diagnose_compiler(long_word + ":" + long_word + ": error: " + long_word, "/x/07.cpp", "07.cpp").line >= 0);
    CHECK(diagnose_linker("s.o: undefined reference to `" + long_word + "'\n", "07.cpp", "7").kind
          == Outcome::does_not_link);
}

TEST_CASE("an escape code of a compiler's colours is shown as a question mark") {
    const auto verdict = diagnose_compiler(sanitize("/x/07.cpp:3:5: error: \x1b[31mred\xff\n"), "/x/07.cpp", "07.cpp");
    CHECK(verdict.sentence == "?[31mred?");
    CHECK(verdict.line == 3);
}

TEST_CASE("linkers of two families are understood") {
    const std::string linker =
        GENERATE("s.o: in function `f':\n07.cpp:(.text+0x5): undefined reference to `ns::helper(double)'\n",
                 "07.cpp:function f: error: undefined reference to 'ns::helper(double)'\n");
    CHECK(diagnose_linker(linker, "07.cpp", "7").sentence.find("`ns::helper(double)` is declared in 07.cpp") == 0);
    const std::string twice =
        GENERATE("/usr/bin/ld: a.o: in function `main':\nmultiple definition of `main'; b.o: first defined here\n",
                 "/usr/bin/ld.gold: error: b.o: multiple definition of 'main'\n");
    CHECK(diagnose_linker(twice, "07.cpp", "7").sentence.find("Your file has a `main` of its own.") == 0);
}

TEST_CASE("the first error is a compiler's before a linker's, and a linker's says which function is missing") {
    CHECK(first_error("/usr/bin/ld: main.o: in function `trace()':\n"
                      "main.cpp:(.text+0x1): undefined reference to `lines::rise(double)'\n"
                      "collect2: error: ld returned 1 exit status\n")
          == "lines::rise(double) isn't defined; did its name or its signature change?");
    CHECK(first_error("[1/2] x\na.cpp:1:2: warning: w\na.cpp:2:2: error: e\n") == "a.cpp:2:2: error: e");
    CHECK(first_error("[1/2] x\na.cpp:2:2: Fehler: e\n") == "a.cpp:2:2: Fehler: e");
    CHECK(first_error("ninja: nothing to do\n") == "");
}

TEST_CASE("a missing function is reported with the header's line and what the file has instead") {
    const std::string symbols =
        "0000000000000000 T ns::meet(double)\n0000000000000010 T meeting(int)\n0000000000000020 T ns::remeet(int)\n"
        "0000000000000030 W std::vector<ns::meet(int)>\n0000000000000040 D ns::meet(int)\n"
        "0000000000000050 T ns::Croses(int)\n";
    const std::string header =
        "/// A meet(ing).\nbool meet(const Segment &first,\n          int second);\nbool remeet(int i);\n";
    CHECK(explain_missing(symbols, header, "meet")
          == " The header says `bool meet(const Segment &first, int second);`; yours is `ns::meet(double)`, which is "
             "another function to the compiler: copy name, parameters and namespace.");
    CHECK(explain_missing(symbols, "/// It crosses(int);", "crosses") == " Yours has `Croses`: is that it, misspelt?");
    CHECK(explain_missing(symbols, "\nint total();\n", "total") == " The header says `int total();`.");
    // another exercise is no misspelling
    CHECK(explain_missing("0000000000000000 T ns::remeet(int)\n", header, "meet").ends_with("int second);`."));
}

TEST_CASE("an older file is told the new names of what it calls by old ones, and only of these") {
    const std::vector<Renamed> renamed{
        {"Crossing", "LineIntersection", 1}, {"meet", "segments_intersect", 2}, {"half", "", 3}};
    const auto said = [&](const std::string &first, const std::string &second = "") {
        const std::string end = "\n    3 |  y\n      |  ^\n", place = "/x/07.cpp:3:5: error: ";
        return diagnose_compiler(place + first + end + (second.empty() ? "" : place + second + end), "/x/07.cpp",
                                 "07.cpp", {}, renamed)
            .sentence;
    };
    const std::string alone = "`Crossing` is called `LineIntersection` now: rename it in your file.";
    for (const char *unknown :
         {"‘Crossing’ was not declared in this scope; did you mean ‘meet’?", "‘Crossing’ has not been declared",
          "‘Crossing’ does not name a type", "‘Crossing’ is not a member of ‘wall’",
          "‘struct Wall’ has no member named ‘Crossing’", "use of undeclared identifier 'Crossing'",
          "unknown type name 'Crossing'", "no type named 'Crossing' in namespace 'wall'",
          "no member named 'Crossing' in namespace 'wall'"})
        CHECK(said(unknown) == alone);
    CHECK(said("‘Crossing’ was not declared", "‘Crossing’ was not declared") == alone);
    CHECK(said("‘meet’ was not declared", "‘Crossing’ was not declared")
          == "`meet` is called `segments_intersect` now, `Crossing` is called `LineIntersection`: rename them in your "
             "file.");
    // Something else is wrong first, or an old name stands beside what is wrong.
    CHECK(said("‘x’ was not declared", "‘Crossing’ was not declared") == "'x' was not declared");
    CHECK(said("‘x’ was not declared in this scope; did you mean ‘meet’?").starts_with("'x' was not declared"));
    CHECK(said("‘meet’ cannot be used as a function").starts_with("'meet' cannot be used"));
    CHECK(said("‘half’ was not declared").starts_with("'half' was not declared"));

    const std::string header = "\nbool segments_intersect(int);\nbool common_points(int);\n",
                      symbols = "0000000000000000 T ns::meet(int)\n";
    CHECK(explain_missing(symbols, header, "segments_intersect", renamed)
          == " `meet` is called `segments_intersect` now: rename it in your file.");
    CHECK(explain_missing(symbols, header, "common_points", renamed) == " The header says `bool common_points(int);`.");
    CHECK(explain_missing("0000000000000000 T ns::meeting(int)\n", header, "segments_intersect", renamed)
              .find("is called")
          == std::string::npos);
}

TEST_CASE("an error in a file that a student only uses is told where the student has caused it, and what it means") {
    const auto verdict = diagnose_compiler(
        "/x/course.hpp: In instantiation of 'void f()':\n/x/07.cpp:26:5:   required from here\n"
        "/x/course.hpp:48:3: error: no matching function for call to ‘require_number(const State&)’\n   48 | f();\n"
        "/x/course.hpp:40:3: note: candidate: ‘void course::require_number(double)’\n",
        "/x/07.cpp", "exercises/07.cpp");
    CHECK(verdict.file == "exercises/07.cpp");
    CHECK(verdict.line == 26);
    CHECK(verdict.printed.empty()); // the line of code is not the student's
    CHECK(find_warnings("In function 'f',\n    inlined from 'g' at /x/07.cpp:43:18:\n"
                        "/usr/include/m.h:75:3: warning: ‘total’ may be used uninitialized [-Wmaybe-uninitialized]\n"
                        "/usr/include/m.h:76:3: warning: another [-Wx]\n",
                        "/x/07.cpp", "07.cpp")
          == std::vector<std::string>{"07.cpp:43: 'total' may be used uninitialized"});
}

TEST_CASE("the slips that are made most are named beside the compiler's words") {
    CHECK(advice({"no match for 'operator^' (operand types are 'double' and 'int')", "", "", ""})
          == "^ isn't a power: write (t * t), with the brackets.");
    CHECK(advice({"suggest parentheses around assignment used as truth value", "", "", ""})
          == "= gives a value; to compare, write ==.");
    CHECK(advice({"something else", "", "", ""}).empty());
    CHECK(with_short_names(
              "'const Eigen::CwiseBinaryOp<sum<double, double>, const Eigen::Matrix<double, 2, 1> >' and 'int'")
          == "'expression of Vec2s' and 'int'");
    CHECK(with_short_names("'std::vector<Eigen::Matrix<double, 2, 1> >::size_type' {aka 'long'} to 'double'")
          == "'std::vector<Vec2>::size_type' to 'double'");
}

TEST_CASE("asked for one exercise, check hides the warnings in the functions of the others") {
    const std::string text = "int helper() {\n}\n\nint meet(int a,\n         int b) {\n    a = b;\n}\n"
                             "bool turn(int);\nint turn(int a) { return a; }\nint last() {\r\n}\n";
    std::vector<std::string> all;
    for (int line = 1; line <= 11; ++line) all.push_back("07.cpp:" + std::to_string(line) + ": a word");
    const auto left = [&](const std::vector<std::string> &others) {
        return warnings_about(all, text, "07.cpp", others);
    };
    CHECK(left({}) == all);
    CHECK(left({"meet"}) == std::vector{all[0], all[1], all[2], all[7], all[8], all[9], all[10]});
    CHECK(left({"turn"})
          == std::vector{all[0], all[1], all[2], all[3], all[4], all[5], all[6], all[7], all[9], all[10]});
}

TEST_CASE("code below a throw that should have gone is never reached, and told") {
    const std::string stub = "int f() {\n    throw course::NotYet{\"begin\"};\n}\n";
    CHECK(find_unreached(stub, "07.cpp").empty());
    CHECK(find_unreached(stub + "int g() {\n    throw course::NotYet{\"a\"\n        \"b\"};\n    // my way\n}\n",
                         "07.cpp")
              .empty());
    CHECK(find_unreached("int f() {\n\n    throw course::NotYet{\"begin\"};\n\n    return 3;\n}\n", "07.cpp")
          == std::vector<std::string>{
              "07.cpp:3: this `throw` is still above your code, which is therefore never reached: "
              "delete this line"});
}

TEST_CASE("a division of whole numbers that loses something is told, and no other") {
    const auto of = [](const std::string &text) { return find_whole_divisions(text, "03.cpp"); };
    CHECK(of("f();\nreturn 1 / 2 * g;\n")
          == std::vector<std::string>{"03.cpp:2: `1 / 2` is 0, because both are whole numbers: write `1.0 / 2`"});
    CHECK(of("std::pow(r, 3/2)").front().ends_with("`3 / 2` is 1, because both are whole numbers: write `3.0 / 2`"));
    for (const char *lost : {"1 / 2", "a - 1 / 2", "e-3 / 2", "x = (7 / 2) * t;", "/* a */ 1 / 2", "\"a\", 1 / 2",
                             "// a\n1 / 2", "/* a\n */ 1 / 3", "f(\"\\\"\", 1 / 3)", "1 / 2 + 1.5 / 2"}) {
        INFO(lost);
        CHECK(of(lost).size() == 1);
    }
    CHECK(of("1 / 2 + 1 / 3\n5 / 3").size() == 3);
    for (const char *fine : {"1.0 / 2",
                             "1. / 2",
                             "1 / 2.0",
                             "1 / 2.",
                             "0.1 / 2",
                             "1e3 / 2",
                             "1e-3 / 2",
                             "1 / 2e3",
                             "x1 / 2",
                             "1 / x",
                             "4 / 2",
                             "0 / 2",
                             "t * 1 / 2",
                             "t / 3 / 2",
                             "1 / 0",
                             "int a[7 / 2]",
                             "1'000 / 3",
                             "// 1 / 2",
                             "// a\n// 1 / 2",
                             "/* 1 / 2\n 1 / 2 */",
                             "\"1 / 2\"",
                             "\"\\\" 1 / 2\"",
                             "x; // say 1 / 2",
                             "99999999999 / 2",
                             "1",
                             "/"}) {
        INFO(fine);
        CHECK(of(fine).empty());
    }
}

TEST_CASE("code below a return is never reached, and told, unless the return is conditional") {
    const auto body = [](const std::string &lines) { return "int f(int x) {\n" + lines + "}\n"; };
    const auto unreached = [&](const std::string &lines) { return find_unreached(body(lines), "01.cpp"); };
    const std::vector<std::string> third{
        "01.cpp:3: this line comes after a `return`, and is never reached: move it up"};
    CHECK(unreached("    return x;\n    require(x > 0);\n") == third);
    CHECK(unreached("    return {x}; // done\n    ++x;\n") == third);
    CHECK(unreached("    return x;\n    // require(x > 0);\n\n").empty());
    CHECK(unreached("    if (x > 0)\n        return x;\n    return -x;\n").empty());
    CHECK(unreached("    if (x > 0) return x;\n    else\n        return 0;\n    ++x;\n").empty());
    CHECK(unreached("    if (x > 0) {\n        return x;\n    }\n    return -x;\n").empty());
    CHECK(unreached("    if (x > 0) {\n        return x; }\n    return -x;\n").empty());
    CHECK(unreached("    switch (x) {\n    case 1:\n        return x;\n    default:\n        return 2;\n    }\n")
              .empty());
    CHECK(unreached("    return x\n           + 1;\n").empty());
}
