// Runs a section's tests in a page, case by case, and tells each verdict: what harness.cpp and main.cpp of judge/runner do with
// Catch2 and processes.

#include "catch2/small.hpp"
#include "judge/runner/session.hpp"

#define FROM_PAGE(name) __attribute__((import_module("page"), import_name(name)))
#define TO_PAGE(name) __attribute__((export_name(name)))

extern "C" FROM_PAGE("verdict") void tell_verdict(const char *line, std::size_t size); // a line of JSON

namespace {

using namespace course;

const char *check_file = "";
int check_line = 0, checks = 0;
unsigned seed = 0;

/// What GENERATE has chosen in the running case, one after the other: which value, of how many.
struct Choice {
    std::size_t value, of;
};
std::vector<Choice> choices;
std::size_t choices_made = 0;

/// The next combination, as an odometer counts; false after the last.
bool has_another_choice() {
    choices.resize(choices_made);
    choices_made = 0;
    while (!choices.empty() && ++choices.back().value == choices.back().of) choices.pop_back();
    return !choices.empty();
}

/// What came out of a case, beside its checks or in one.
void note_exception() {
    try {
        throw;
    } catch (const NotYet &hint) {
        session()->note_not_started(hint.what(), hint.function);
    } catch (const std::bad_alloc &) {
        session()->note_no_memory();
    } catch (const std::exception &error) {
        session()->fail(Outcome::wrong, explain_exception(error.what()), check_file, check_line);
    }
}

void run_once(const Catch::Case &test) {
    try {
        test.run();
    } catch (const Catch::CaseFailed &) {
    } catch (const CaseOver &) {
        session()->fail(Outcome::wrong, {}, check_file, check_line); // says where it was
    } catch (...) {
        note_exception();
    }
}

Verdict run(const Catch::Case &test, const std::string &exercise) {
    session()->begin(exercise, test.name);
    check_file = test.file;
    check_line = test.line;
    checks = 0;
    choices.clear();
    do run_once(test);
    while (has_another_choice());
    return session()->end(checks > 0);
}

std::string exercise_of(const Catch::Case &test) {
    const std::string_view tags = test.tags; // "[7.2][more]"
    return std::string{tags.substr(1, tags.find(']') - 1)};
}

} // namespace

namespace course {
int cases(int full) { return full / 100; } // as in a student's check
} // namespace course

namespace Catch {

unsigned getSeed() { return seed; }

std::size_t next_choice(std::size_t of) {
    if (choices_made == choices.size()) choices.push_back({0, of});
    return choices[choices_made++].value;
}

void begin_check(const char *file, int line) {
    session()->note({});
    check_file = file;
    check_line = line;
}

void end_check(bool passed) {
    ++checks;
    if (!passed) session()->fail(Outcome::wrong, {}, check_file, check_line);
}

void end_check_that_threw() {
    try {
        throw;
    } catch (const CaseOver &) {
        throw;
    } catch (...) {
        ++checks;
        note_exception();
    }
    throw CaseFailed{};
}

} // namespace Catch

extern "C" {

/// Room for a text that the page writes.
TO_PAGE("room") char *room(std::size_t size) { return static_cast<char *>(std::malloc(size)); }

/// Judges all cases of an exercise, "8.1", or of all of them: "".
TO_PAGE("judge") void judge(const char *exercise, unsigned with_seed) {
    seed = with_seed;
    Session running{"", TimeLimits{}};
    session() = &running;
    for (const Catch::Case &test : Catch::cases()) {
        const std::string number = exercise_of(test);
        if (*exercise != '\0' && number != exercise) continue;
        const std::string line = to_line(run(test, number));
        tell_verdict(line.data(), line.size());
    }
}
}
