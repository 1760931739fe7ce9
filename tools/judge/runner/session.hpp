#pragma once
// The owner of the verdict: follows one test case after the other, and what the student's process does meanwhile.

#include "judge/protocol/verdict.hpp"
#include "judge/runner/channel.hpp"
#include "judge/runner/student_process.hpp"

#include <memory>
#include <set>

namespace course {

/// What tests may take: StudentProcess::spent, not the clock's time. A hang costs a case a share, and all hangs together
/// hardly more than `all`.
struct TimeLimits {
    double a_case = 1; ///< [s] some hundred times what working code takes
    double all = 10;   ///< [s]
    double start = 2;  ///< [s] for a subject to start; all starts together: `all`
};

class Session {
  public:
    Session(std::filesystem::path subject, TimeLimits limits, std::string answer = {});

    void begin(std::string exercise, std::string test);

    /// The running case's input is large: it may take so long [s], from now on.
    void allow(double seconds);

    /// From now on the tests are a reader's, and the code is the reference: what they compare needs no name, and what fails
    /// isn't explained as a slip of the code.
    void run_own_tests() { own = true; }

    /// The numbers of the exercises that the running case has called.
    const std::set<std::string> &called() const { return called_exercises; }

    /// Whether one of our matchers has noted what differs in the check that is running.
    bool has_noted() const { return noted.has_value(); }

    /// A check of the running case failed, and this is why; the first one counts.
    void fail(Outcome kind, std::string sentence, const std::string &file, int line);

    /// What the test itself has called isn't started: a function of an earlier section, where that is the student's own.
    void note_not_started(const std::string &hint, std::string_view function);

    /// The case is over: the verdict.
    Verdict end(bool asserted_something);

    /// What on this machine kept a case from being judged; empty if nothing did. Then no verdict counts.
    const std::string &trouble() const { return machine_trouble; }

    /// The running case got no memory. Not the student's code: that runs in another process.
    void note_no_memory();

    std::string_view call(const ExerciseLine &exercise, std::string arguments);
    [[noreturn]] void answered_nonsense(bool too_large = false);
    void note(std::optional<Mismatch> mismatch) { noted = std::move(mismatch); }

    /// What failed has no name that a student could read: ours to mend, and no verdict on them.
    void refuse_nameless();

    /// See note_accepted. What fails after it in the same case is not looked at.
    void accept(const std::string &input, const std::string &value);

    /// Whether a refusal, "t [s] must not be negative, but is -1", is of a number that the last call was not given.
    bool is_computed(std::string_view refusal) const;

    std::string last_result; ///< bytes
    const ExerciseLine *last_exercise = nullptr;

  private:
    [[noreturn]] void end_case(Outcome kind, std::string sentence);
    [[noreturn]] void end_case_in_silence();
    void start();
    Deadline deadline() const;
    void renew_allowance();
    void judge_end(int status, bool before_main);
    void note_verdict(Outcome kind, std::string sentence);
    std::optional<std::string> ask_alone() const;
    void look_for_memory();

    std::filesystem::path program;
    std::string answer;
    TimeLimits limits;
    double allowance = 0;      ///< [s] for the running case
    bool large = false;        ///< whether that is more than usual
    double spent_before = 0;   ///< [s] what the running case's subject had spent when the allowance began
    double spent_starting = 0; ///< [s] what all subjects had spent when they greeted
    double spent_hanging = 0;  ///< [s] in hangs
    double spent_in_all = 0;   ///< [s] in all cases
    std::string hung_exercise; ///< the exercise that has used up a case's time: other cases of it get less

    std::unique_ptr<StudentProcess> subject;
    std::optional<Verdict> never_starts; ///< seen once, true for every case
    std::string machine_trouble;
    bool greeted = false;
    bool own = false;
    std::set<std::string> called_exercises;
    std::uint32_t calls = 0;
    std::string last_arguments;
    std::optional<Mismatch> noted;
    std::vector<std::pair<std::string, std::vector<std::string>>> accepted; ///< inputs, and the values of a number
    Verdict verdict;
};

/// The one that `call` and the matchers speak to.
Session *&session();

/// To a student whose code threw where a test compares: `what` came out of it, through the session.
std::string explain_exception(const std::string &what);

} // namespace course
