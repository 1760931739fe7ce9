#pragma once
// A student's process: started for one test case, talked to over two descriptors of its own, and never believed.

#include "verdict/shared/wire.hpp"
#include "verdict/tests/nameless_file.hpp"
#include "verdict/tests/shut_in.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace course {

using Clock = std::chrono::steady_clock;

constexpr std::size_t memory_limit = 256u << 20; ///< [bytes] of a subject; an exercise needs a few
constexpr std::size_t print_limit = 4u << 20;    ///< [bytes] that it may write

class Subject {
  public:
    /// Starts it, shut in and with everything it may use limited.
    /// @param answer  which one, of a program that holds many: see tests/answers
    /// @throws MachineTrouble if this machine cannot
    explicit Subject(const std::filesystem::path &program, const std::string &answer = {}, Protection protection = {});
    ~Subject(); ///< kills it and everything it started
    Subject(const Subject &) = delete;
    Subject &operator=(const Subject &) = delete;

    struct Received {
        wire::Header header;
        std::string payload;
    };
    enum class Silence { ended, late, too_large, nonsense }; ///< too_large: an answer, by what it says itself

    /// Sends it a call, the first, second, ... of this subject.
    /// @return false if it reads no more
    bool send(std::uint32_t number, std::uint32_t exercise, std::string_view arguments, Clock::time_point deadline);

    /// The next frame, if one comes before the deadline; otherwise `silence` says why not. Where it wants to compute and
    /// other programs have kept the processor, it is waited for until it has had this much of it.
    /// @param processor_time  [s]
    std::optional<Received> receive(Clock::time_point deadline, double processor_time = 0);
    Silence silence = Silence::ended;

    /// Waits for its end until the deadline, or until it has had this much of the processor [s], as above.
    /// @return its wait status, or nothing if it had to be killed
    std::optional<int> finish(Clock::time_point deadline, double processor_time = 0);

    bool said_more();            ///< after finish: it had sent an answer without a question
    bool left_processes();       ///< after finish: something that it started still runs; it is ended
    std::string printed() const; ///< what it wrote to stdout and stderr

  private:
    bool read_all(void *data, std::size_t size, Clock::time_point deadline, double processor_time);
    bool is_starved(double processor_time) const;

    pid_t process = -1;
    pid_t group = -1;
    int to = -1, from = -1;
    wire::Arrived arrived;
    NamelessFile output;
};

/// Once, in the process of the tests: a subject cannot look into it, its orphans come to it, a pipe without a reader
/// does not kill it, and calls are quick because both sides share a core.
/// @param core  one of `cores()`; -1: any of them
void prepare_for_subjects(int core);

/// The cores that we may run on, beginning with the one that we are on; a single -1 where that cannot be known.
std::vector<int> cores();

} // namespace course
