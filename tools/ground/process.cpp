#include "ground/process.hpp"

#include "ground/complaint.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace course {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
constexpr std::size_t most_kept = 16u << 20; // of each stream: enough for any compiler, little for any machine

// What the signal handler sees: lock-free numbers and nothing else.
std::atomic<pid_t> running{0}; // the program, or minus its group, as kill() takes it; 0: none
std::atomic<int> received{0};

extern "C" void on_signal(int signal) {
    const int error = errno;
    const pid_t target = running;
    if (target == 0) ::_exit(128 + signal);
    received = signal;
    ::kill(target, signal);
    errno = error;
}

sigset_t our_signals() {
    sigset_t set;
    ::sigemptyset(&set);
    for (int signal : signals) ::sigaddset(&set, signal);
    return set;
}

/// A descriptor, closed in the end.
struct Descriptor {
    int number = -1;
    Descriptor() = default;
    Descriptor(const Descriptor &) = delete;
    Descriptor &operator=(const Descriptor &) = delete;
    ~Descriptor() { close(); }
    void close() {
        if (number >= 0) ::close(number);
        number = -1;
    }
};

/// One stream of the program: where it writes, where we read, what came.
struct Captured {
    Descriptor read, write;
    std::string text;

    void open() {
        int ends[2];
        if (::pipe(ends) != 0)
            throw Complaint{"no pipe can be made (" + std::string{std::strerror(errno)} + "); close some programs"};
        read.number = ends[0], write.number = ends[1];
        for (int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
        ::fcntl(read.number, F_SETFL, O_NONBLOCK);
    }

    /// All that is there now; closes at the end of the stream.
    void take() {
        std::array<char, 65536> part;
        while (read.number >= 0) {
            const ssize_t count = ::read(read.number, part.data(), part.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0 && errno == EAGAIN) return;
            if (count <= 0) return read.close();
            text.append(part.data(),
                        std::min(static_cast<std::size_t>(count), most_kept - std::min(most_kept, text.size())));
        }
    }
};

/// Starts the program. Apart: in a process group of its own, so that its children can be ended with it.
pid_t start(const std::vector<std::string> &command, const RunOptions &options, bool apart, Captured &out,
            Captured &err) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    if (apart) ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (options.quiet) {
        ::posix_spawn_file_actions_adddup2(&actions, out.write.number, STDOUT_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions, err.write.number, STDERR_FILENO);
    }
    if (!options.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());

    sigset_t none, ours = our_signals();
    ::sigemptyset(&none);
    ::sigaddset(&ours, SIGXFSZ);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &ours);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    const int group = apart ? POSIX_SPAWN_SETPGROUP : 0;
    ::posix_spawnattr_setflags(&attributes, static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | group));

    std::vector<char *> arguments;
    for (const std::string &word : command) arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);

    pid_t child = 0;
    // Compilers and gnuplot speak to us, and the same on every machine: in English, with UTF-8.
    ::setenv("LC_ALL", "C.UTF-8", 1);
    ::unsetenv("LANGUAGE");
    const int error = ::posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == 0) return child;
    throw Complaint{"cannot start " + command.front() + " (" + std::strerror(error)
                    + "); `./course doctor` says what is missing"};
}

/// Waits a little, or until the program has printed or closed something.
void listen(Captured &out, Captured &err) {
    std::array<pollfd, 2> ends{{{out.read.number, POLLIN, 0}, {err.read.number, POLLIN, 0}}}; // poll skips a -1
    const bool silent = out.read.number < 0 && err.read.number < 0;
    ::poll(ends.data(), ends.size(), silent ? 2 : 20); // [ms] between two looks at whether it has ended
    out.take();
    err.take();
}

} // namespace

Undisturbed::Undisturbed() {
    const sigset_t ours = our_signals();
    ::sigprocmask(SIG_BLOCK, &ours, &before);
}

Undisturbed::~Undisturbed() { ::sigprocmask(SIG_SETMASK, &before, nullptr); }

void catch_signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    for (int signal : signals) ::sigaction(signal, &action, nullptr);
    ::signal(SIGXFSZ, SIG_IGN); // a file that grows too long is an error, which is said, and not the end
}

Finished run(const std::vector<std::string> &command, const RunOptions &options) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const bool apart = options.quiet || options.deadline > 0; // else it shares our terminal, and Ctrl-C with us
    Captured out, err;
    if (options.quiet) out.open(), err.open();

    pid_t child = 0, target = 0;
    {
        const Undisturbed until_known; // until then a signal could not be passed on to the child
        received = 0;
        child = start(command, options, apart, out, err);
        running = target = apart ? -child : child;
    }
    out.write.close();
    err.write.close();

    Finished finished;
    auto killed_at = Clock::time_point::max();
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        listen(out, err);
        const auto now = Clock::now();
        const std::chrono::duration<double> passed = now - begin;
        if (options.deadline > 0 && passed.count() > options.deadline && !finished.timed_out) {
            finished.timed_out = true;
            killed_at = now;
        }
        if (received != 0 && killed_at == Clock::time_point::max())
            killed_at = now + std::chrono::seconds{1}; // to tidy up
        if (now >= killed_at) ::kill(target, SIGKILL);
    }
    {
        const Undisturbed until_gone;
        running = 0;
    }
    out.take(); // a grandchild may hold the pipe for ever: what is there now is all
    err.take();
    if (apart && (finished.timed_out || received != 0)) ::kill(target, SIGKILL);
    if (received != 0) throw Interrupted{received};

    finished.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    finished.out = std::move(out.text);
    finished.err = std::move(err.text);
    return finished;
}

} // namespace course
