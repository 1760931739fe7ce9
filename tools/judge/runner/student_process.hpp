#pragma once
// A student's process: started for one test case, talked to over two descriptors, and never believed.

#include "base/unique_fd.hpp"
#include "judge/protocol/wire.hpp"
#include "judge/runner/sandbox.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace course {

using Clock = std::chrono::steady_clock;

constexpr std::size_t memory_limit =
    128u << 20; ///< [bytes] of a subject; an exercise needs a few. Filled well within TimeLimits::a_case
constexpr std::size_t print_limit = 4u << 20; ///< [bytes] that it may write

/// How long a student's process is waited for. None of it is what other programs leave of the machine.
struct Deadline {
    double spent;      ///< [s] see StudentProcess::spent
    double clock = 20; ///< [s] for one answer, by the clock: after that the process slept, or was never given a core
};

/// A file that no other process can find, as it has no name, and that goes with this object. A program that is started
/// does not inherit it.
class AnonymousFile {
  public:
    /// @throws EnvironmentError if the machine has no room for one
    AnonymousFile();

    int descriptor() const { return file; }
    void append(std::string_view text);       ///< @throws EnvironmentError if there is no room
    std::string text(std::size_t most) const; ///< the first `most` bytes

  private:
    UniqueFd file;
};

/// Above the numbers that a subject's own descriptors are moved to, and inherited by nothing that is started.
/// @throws EnvironmentError if the machine has no room for one
std::array<UniqueFd, 2> make_pipe();

class StudentProcess {
  public:
    /// Starts it, shut in and with everything it may use limited.
    /// @param answer  which one, of a program that holds many: see tests/answers
    /// @throws EnvironmentError if this machine cannot
    explicit StudentProcess(const std::filesystem::path &program, const std::string &answer = {},
                            Protection protection = {});
    ~StudentProcess(); ///< kills it and everything it started

    struct Received {
        wire::Header header;
        std::string payload;
    };
    enum class Silence { ended, late, starved, too_large, nonsense }; ///< too_large: an answer, by what it says itself

    /// Sends it a call, the first, second, ... of this subject.
    /// @return false if it reads no more, or not in time
    bool send(std::uint32_t number, std::uint32_t exercise, std::string_view arguments, const Deadline &deadline);

    /// The next frame, if one comes; otherwise `silence` says why not: it is late when it has spent what it may, and
    /// starved when the machine never gave it the chance to.
    std::optional<Received> receive(const Deadline &deadline);
    Silence silence = Silence::ended;

    /// Waits for the end.
    /// @return the wait status, or nothing if it had to be killed; then `silence` says why
    std::optional<int> finish(const Deadline &deadline);

    /// [s] What it has had by now: time in which it computed, and half of that in which it was seen asleep. However busy
    /// the machine is, waiting for a core costs it nothing.
    double spent() const;
    bool slept() const { return asleep / 2 > computed(); } ///< rather than computed

    bool said_more();            ///< after finish: it had sent an answer without a question
    bool left_processes();       ///< after finish: something that it started still runs; it is ended
    std::string printed() const; ///< what it wrote to stdout and stderr

  private:
    template <class Ready> bool wait(Ready ready, const Deadline &deadline);
    bool read_all(void *data, std::size_t size, const Deadline &deadline);
    double computed() const;
    std::optional<double> wanted() const;

    pid_t process = -1; ///< which also leads a group of that number; it's reaped last
    UniqueFd to, from;
    Clock::time_point started = Clock::now();
    Clock::time_point next_look = started; ///< at what the process does, while we wait
    double asleep = 0;                     ///< [s]
    double computed_in_all = 0;            ///< [s] known when it has ended
    wire::Arrived arrived;
    AnonymousFile output;
};

/// Once, in the process of the tests: a subject cannot look into it, orphans of a subject come to it, a pipe without a reader
/// does not kill it, and calls are quick because both sides share a core.
/// @param core  one of `cores()`; -1: any of them
void prepare_for_subjects(int core);

/// The cores that we may run on, beginning with the one that we are on; a single -1 where that cannot be known.
std::vector<int> cores();

} // namespace course
