// The tests with the student's code in one process, for a debugger: no pipe, no limits, and Catch2's own main.
// It takes the place of session.cpp. Compiled for each section, whose header COURSE_SECTION names.

#include "judge/runner/channel.hpp"
#include "judge/server/serve.hpp"

#include <stdexcept>

namespace course {

std::string_view call(const ExerciseLine &exercise, std::string arguments) {
    static std::string result;
    wire::Reader in{arguments};
    wire::Writer out;
    served[exercise.index](in, out); // exceptions are the test's to see
    return result = std::move(out.bytes);
}

void answered_nonsense(bool) { throw std::logic_error{"a value of this type did not cross whole: COURSE_FIELDS?"}; }
void note_mismatch(const Mismatch &) {}
void refuse_nameless() {}
void note_accepted(const std::string &, const std::string &) {}
std::optional<std::string_view> unit_of_answer(std::string_view) { return {}; }
void allow(double) {}
int cases(int full) { return full / 100; }

} // namespace course
