// The server of a program that holds many answers to a section's exercises. The one that COURSE_ANSWER in its environment
// names serves its exercise; nothing else is started. With a + before its name, all others are our solution's: a test of
// a reader's may call several. A + alone is our solution.
#include "judge/server/server.cpp"

#include <cstdlib>

namespace {

const char *const chosen = std::getenv("COURSE_ANSWER");
const bool among_ours = chosen != nullptr && *chosen == '+';

void not_started(double, Reader &, Writer &) { throw course::NotYet{"this answer is one to another exercise"}; }
const bool nothing_is_started = [] {
    if (among_ours) return false;
    for (std::uint32_t i = 0; i < exercises; ++i) served[i].serve = &not_started;
    return true;
}();

/// Serves a function that is known when the program runs.
template <class Result, class... Arguments> struct Chosen {
    static inline Result (*function)(Arguments...) = nullptr;
    static void serve(double limit, Reader &in, Writer &out) { ::serve(function, limit, in, out); }
};

struct Answer {
    /// @param declared  the function of the section's header: an answer of another type does not compile
    template <class Result, class... Arguments>
    Answer(std::string_view name, std::size_t exercise, Result (*declared)(Arguments...), decltype(declared) answer) {
        if (chosen == nullptr || name != chosen + among_ours) return;
        Chosen<Result, Arguments...>::function = answer;
        served[exercise].serve = &Chosen<Result, Arguments...>::serve;
    }
};

} // namespace
