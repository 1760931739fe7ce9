#pragma once
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace course {

/// What each process of a command may use at most; 0: as much as there is.
struct Limits {
    std::size_t memory = 0;      ///< [bytes] of addresses
    std::size_t file_size = 0;   ///< [bytes] of any file that it writes
    unsigned processor_time = 0; ///< [s] of processor, however long that takes on a busy machine
};

struct RunOptions {
    bool quiet = true;                 ///< keep what it prints, instead of letting it through to the terminal
    double deadline = 0;               ///< [s], 0: as long as it takes; afterwards it and all children are killed
    double idle_limit = 0;             ///< [s], the same, for how long all of them only sleep
    std::filesystem::path folder = {}; ///< where it runs; empty: here
    Limits limits = {};
    std::vector<std::string> environment = {}; ///< all of it: "TMPDIR=/some/folder"; empty: our own, in English
    /// Shuts the new process in, before the program starts; false: it doesn't start, for `errno`. Must be safe between
    /// fork and exec. What's shut in prints into sockets instead of pipes.
    std::function<bool()> in_child = {};
};

struct Finished {
    int code = 0;           ///< exit code; 128 + signal if it was killed
    bool timed_out = false; ///< by the deadline, or the idle limit
    std::string out, err;   ///< what it printed, if kept: the first 16 MB of each
};

/// Ctrl-C, or another request to stop: unwinds to main, which leaves with 128 + signal.
struct Interrupted {
    int signal;
};

/// Runs a program (looked up in PATH) with these arguments; no shell in between.
/// A quiet one reads nothing; neither it nor a child outlives a deadline or Ctrl-C. One runs at a time.
/// @throws UserError if it is not there, EnvironmentError if the machine cannot start it; Interrupted after Ctrl-C, once
///         the program has ended.
Finished run(const std::vector<std::string> &command, const RunOptions &options = {});

/// Where programs are on any machine, as an entry of an environment.
inline constexpr const char *usual_path = "PATH=/usr/local/bin:/usr/bin:/bin";

/// Whether there is a program of this name in PATH.
bool in_path(const std::string &program);

/// Called once, by main: from here on Ctrl-C ends a running program and then us, with 130.
void catch_signals();

/// While one lives, a signal waits: for the few steps that must not stop half-way.
class SignalBlocker {
  public:
    SignalBlocker();
    ~SignalBlocker();
    SignalBlocker(const SignalBlocker &) = delete;
    SignalBlocker &operator=(const SignalBlocker &) = delete;

  private:
    sigset_t before;
};

} // namespace course
