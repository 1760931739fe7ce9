#include "base/process.hpp"

#include "base/kernel.hpp"
#include "base/unique_fd.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace course {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
constexpr std::size_t most_kept = 16u << 20; // of each stream: enough for any compiler, little for any machine

// What the signal handler sees: lock-free numbers and nothing else.
std::atomic<pid_t> running{0}; // the program, or minus the process group, as kill() takes it; 0: none
std::atomic<int> received{0};

extern "C" void on_signal(int signal) {
    const int error = errno;
    const pid_t target = running;
    if (target == 0) ::_exit(128 + signal);
    received = signal;
    ::kill(target, signal);
    errno = error;
}

sigset_t caught_signals() {
    sigset_t set;
    ::sigemptyset(&set);
    for (int signal : signals) ::sigaddset(&set, signal);
    return set;
}

/// One stream of the program: where it writes, where we read, what came.
struct Captured {
    UniqueFd read, write;
    std::string text;

    /// @param reopens  whether the program may open it once more, by a name in /proc. It can do so with a pipe, and wait
    ///                 there, for itself, even when we're gone; no socket has a name.
    void open(bool reopens = true) {
        int ends[2];
        if ((reopens ? ::pipe(ends) : ::socketpair(AF_UNIX, SOCK_STREAM, 0, ends)) != 0)
            throw EnvironmentError{"no pipe can be made (" + std::string{std::strerror(errno)}
                                   + "); close some programs"};
        read = ends[0], write = ends[1];
        for (int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
        ::fcntl(read, F_SETFL, O_NONBLOCK);
    }

    /// All that is there now; closes at the end of the stream.
    void take() {
        std::array<char, 65536> part;
        while (read >= 0) {
            const ssize_t count = ::read(read, part.data(), part.size());
            if (count < 0 && errno == EINTR) continue;
            if (count < 0 && errno == EAGAIN) return;
            if (count <= 0) return read.close();
            text.append(part.data(),
                        std::min(static_cast<std::size_t>(count), most_kept - std::min(most_kept, text.size())));
        }
    }
};

/// Our environment, for programs that speak to us, and the same on every machine: in English, and with nothing that leads
/// a compiler to files of others.
std::vector<std::string> inherited_environment() {
    constexpr std::array<std::string_view, 8> left_out{
        "LC_ALL=", "LANGUAGE=",       "GCC_EXEC_PREFIX=",    "COMPILER_PATH=",
        "CPATH=",  "C_INCLUDE_PATH=", "CPLUS_INCLUDE_PATH=", "LIBRARY_PATH="};
    std::vector<std::string> all{"LC_ALL=C.UTF-8"};
    for (char **each = environ; *each != nullptr; ++each) {
        const std::string_view entry = *each;
        if (std::ranges::find(left_out, entry.substr(0, entry.find('=') + 1)) == left_out.end())
            all.emplace_back(entry);
    }
    if (std::getenv("PATH") == nullptr) all.emplace_back(usual_path);
    return all;
}

std::vector<char *> pointers_to(const std::vector<std::string> &words) {
    std::vector<char *> pointers;
    for (const std::string &word : words) pointers.push_back(const_cast<char *>(word.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

void impose(const Limits &limits) {
    if (limits.memory > 0) limit(RLIMIT_AS, limits.memory);
    if (limits.file_size > 0) limit(RLIMIT_FSIZE, limits.file_size);
    if (limits.processor_time > 0) // SIGXCPU says why; SIGKILL, a little later, would not
        limit(RLIMIT_CPU, limits.processor_time, limits.processor_time + 2);
}

/// Starts the program. Apart: in a new process group, so that children can be ended with it.
pid_t start(const std::vector<std::string> &command, const RunOptions &options, bool apart, Captured &out,
            Captured &err) {
    const auto environment = options.environment.empty() ? inherited_environment() : options.environment;
    const auto arguments = pointers_to(command), variables = pointers_to(environment);
    Captured trouble; // closed by the program's start; else the number of the error comes
    trouble.open();
    ::fcntl(trouble.read, F_SETFL, 0);

    const pid_t child = ::fork();
    if (child == 0) { // only what is safe between fork and exec
        if (apart) {
            ::setpgid(0, 0);
            const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
            ::dup2(nothing, STDIN_FILENO);
        }
        if (options.quiet) {
            ::dup2(out.write, STDOUT_FILENO);
            ::dup2(err.write, STDERR_FILENO);
        }
        if (options.quiet) limit(RLIMIT_CORE, 0); // nobody would look at it
        impose(options.limits);
        for (int signal : signals) ::signal(signal, SIG_DFL);
        ::signal(SIGXFSZ, SIG_DFL);
        sigset_t none;
        ::sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        environ = const_cast<char **>(variables.data());
        if ((options.folder.empty() || ::chdir(options.folder.c_str()) == 0)
            && (!options.in_child || options.in_child()))
            ::execvp(arguments[0], arguments.data());
        const int error = errno;
        if (::write(trouble.write, &error, sizeof error) != sizeof error) ::_exit(126);
        ::_exit(127);
    }
    int error = errno;
    trouble.write.close();
    if (child > 0) {
        if (apart) ::setpgid(child, child); // both processes do it, since either may come first
        ssize_t count = 0;
        while ((count = ::read(trouble.read, &error, sizeof error)) < 0 && errno == EINTR) {}
        if (count <= 0) return child;
        ::waitpid(child, nullptr, 0);
    }
    const std::string sentence = "cannot start " + command.front() + " (" + std::strerror(error) + ")";
    if (error == EAGAIN || error == ENOMEM || error == ENFILE || error == EMFILE)
        throw EnvironmentError{sentence + ": the machine has no room for another program; close some"};
    throw UserError{sentence + "; `./course doctor` says what is missing"};
}

/// Whether a program and all that it has started wait for something that none of them does.
bool all_asleep(pid_t program) {
    const auto children = children_of(program);
    return is_asleep(program) && std::ranges::all_of(children, all_asleep);
}

/// Waits a little, or until the program has printed or closed something.
void listen(Captured &out, Captured &err) {
    std::array<pollfd, 2> ends{{{out.read, POLLIN, 0}, {err.read, POLLIN, 0}}}; // poll skips a -1
    const bool silent = out.read < 0 && err.read < 0;
    ::poll(ends.data(), ends.size(), silent ? 2 : 20); // [ms] between two looks at whether it has ended
    out.take();
    err.take();
}

} // namespace

SignalBlocker::SignalBlocker() {
    const sigset_t caught = caught_signals();
    ::sigprocmask(SIG_BLOCK, &caught, &before);
}

SignalBlocker::~SignalBlocker() { ::sigprocmask(SIG_SETMASK, &before, nullptr); }

bool in_path(const std::string &program) {
    const char *path = std::getenv("PATH");
    std::istringstream folders{path ? path : ""};
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((std::filesystem::path{folder} / program).c_str(), X_OK) == 0) return true;
    return false;
}

void catch_signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    for (int signal : signals) ::sigaction(signal, &action, nullptr);
    ::signal(SIGXFSZ, SIG_IGN); // a file that grows too long is an error with a message, and not the end
}

Finished run(const std::vector<std::string> &command, const RunOptions &options) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const bool apart = options.quiet || options.deadline > 0; // else it shares our terminal, and Ctrl-C with us
    Captured out, err;
    if (options.quiet)
        for (Captured *each : {&out, &err}) each->open(!options.in_child);

    pid_t child = 0, target = 0;
    {
        const SignalBlocker until_known; // until then a signal could not be passed on to the child
        received = 0;
        child = start(command, options, apart, out, err);
        running = target = apart ? -child : child;
    }
    out.write.close();
    err.write.close();

    Finished finished;
    auto killed_at = Clock::time_point::max();
    auto awake = begin; // when it was last seen so, or not looked at
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        listen(out, err);
        const auto now = Clock::now();
        const std::chrono::duration<double> passed = now - begin;
        if (options.idle_limit <= 0 || passed.count() < 1 || !all_asleep(child)) awake = now;
        const std::chrono::duration<double> slept = now - awake;
        const bool late = (options.deadline > 0 && passed.count() > options.deadline)
                          || (options.idle_limit > 0 && slept.count() > options.idle_limit);
        if (late && !finished.timed_out) {
            finished.timed_out = true;
            killed_at = now;
        }
        if (received != 0 && killed_at == Clock::time_point::max())
            killed_at = now + std::chrono::seconds{1}; // to tidy up
        if (now >= killed_at) ::kill(target, SIGKILL);
    }
    {
        const SignalBlocker until_gone;
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
