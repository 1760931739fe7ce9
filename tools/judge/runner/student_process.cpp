#include "judge/runner/student_process.hpp"

#include "base/kernel.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#ifdef __linux__
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#endif

namespace course {
namespace {

[[noreturn]] void give_up(const char *what) {
    throw EnvironmentError{std::string{what} + " (" + std::strerror(errno) + ")"};
}

int make_nameless() {
#ifdef __linux__
    return ::memfd_create("printed", MFD_CLOEXEC);
#else
    std::FILE *temporary = std::tmpfile();
    const int file = temporary == nullptr ? -1 : ::fcntl(::fileno(temporary), F_DUPFD_CLOEXEC, 10);
    if (temporary != nullptr) std::fclose(temporary);
    return file;
#endif
}

void set_limits() {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, 120, 122); // [s] for whatever escapes everything else; SIGXCPU says why, SIGKILL would not
    limit(RLIMIT_FSIZE, print_limit);
    limit(RLIMIT_STACK, 8u << 20);
    if (!sanitized) limit(RLIMIT_AS, memory_limit);
    limit(RLIMIT_NOFILE, 64);
#ifdef RLIMIT_SIGPENDING
    limit(RLIMIT_SIGPENDING, 16); // so many timers, too, which take the kernel long to clear away
#endif
}

/// What kept a process from becoming a subject. The words are the same for both sides of the fork.
struct Trouble {
    const char *what;
    int error;
    bool is_programs; ///< the program itself is at fault: it names another loader, say
};

/// What a subject needs to become one, made ready before the fork.
struct Start {
    const char *program;
    char *answer; ///< a variable of the environment; null: none
    const Sandbox &sandbox;
    bool limited;
    int requests, replies, output, trouble; ///< descriptors
};

/// Between fork and exec: only what is safe there.
[[noreturn]] void become(const Start &start) {
    ::setsid(); // another group, so that one signal reaches all of it
    end_with_parent(SIGKILL);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, 0);
    ::dup2(start.output, 1);
    ::dup2(start.output, 2);
    ::dup2(start.requests, wire::request_fd);
    ::dup2(start.replies, wire::reply_fd);
    ::signal(SIGPIPE, SIG_DFL);
    if (start.limited) set_limits();
    char *arguments[] = {const_cast<char *>("subject"), nullptr};
    char perturbed[] = "GLIBC_TUNABLES=glibc.malloc.perturb=165"; // a number without a value is never right by luck
    char *environment[] = {const_cast<char *>("LC_ALL=C.UTF-8"), perturbed, start.answer, nullptr};
    const bool sandbox = start.sandbox.shut(wire::reply_fd);
    if (sandbox) ::execve(start.program, arguments, environment);
    const int error = errno;
    const bool is_machines = error == EAGAIN || error == ENOMEM || error == ENFILE || error == EMFILE || error == EIO;
    const Trouble trouble{sandbox ? "cannot start the student's process" : "cannot shut the student's process in",
                          error, sandbox && !is_machines && ::access(start.program, X_OK) == 0};
    if (::write(start.trouble, &trouble, sizeof trouble) < 0) ::_exit(126);
    ::_exit(127);
}

int milliseconds_until(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    return static_cast<int>(std::max<decltype(left)>(left, 0));
}

/// Waits until there is something to read or room to write, or the other side has gone.
bool ready_for(short event, int file, Clock::time_point deadline) {
    for (;;) {
        pollfd wait{file, event, 0};
        const int ready = ::poll(&wait, 1, milliseconds_until(deadline));
        if (ready > 0) return true;
        if (ready == 0 && Clock::now() >= deadline) return false;
        if (ready < 0 && errno != EINTR) return false;
    }
}

/// How a child ended, if it has, as waitpid says it. It isn't reaped: until that, no other process gets its number, nor a
/// group of that number, which could be anybody's.
std::optional<int> ended(pid_t child) {
    siginfo_t how{};
    if (::waitid(P_PID, static_cast<id_t>(child), &how, WEXITED | WNOHANG | WNOWAIT) != 0 || how.si_pid != child)
        return {};
    return how.si_code == CLD_EXITED ? how.si_status << 8 : how.si_status;
}

/// Our children that still run, but for this one; all others that have ended are reaped.
std::vector<pid_t> running_but(pid_t this_one) {
    std::vector<pid_t> running;
    for (bool reaped = true; std::exchange(reaped, false);) { // then orphans of these are ours now
        running.clear();
        for (const pid_t child : children_of(::getpid()))
            if (child == this_one) continue;
            else if (::waitpid(child, nullptr, WNOHANG) > 0) reaped = true;
            else running.push_back(child);
    }
    return running;
}

} // namespace

AnonymousFile::AnonymousFile() : file{make_nameless()} {
    if (file < 0) give_up("what is printed cannot be kept");
}

void AnonymousFile::append(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) give_up("what is printed cannot be kept");
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string AnonymousFile::text(std::size_t most) const {
    struct stat about {};
    if (::fstat(file, &about) != 0) give_up("what is printed cannot be kept");
    std::string text(std::min(most, static_cast<std::size_t>(about.st_size)), '\0'); // no more: each byte is a write
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t got = ::pread(file, text.data() + size, text.size() - size, static_cast<off_t>(size));
        if (got <= 0) break;
        size += static_cast<std::size_t>(got);
    }
    text.resize(size);
    return text;
}

std::array<UniqueFd, 2> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) give_up("cannot make a pipe");
    std::array<UniqueFd, 2> low{ends[0], ends[1]}, high;
    for (const std::size_t i : {0u, 1u}) {
        high[i] = ::fcntl(low[i], F_DUPFD_CLOEXEC, 10);
        if (high[i] < 0) give_up("cannot make a pipe");
    }
    return high;
}

std::vector<int> cores() {
    std::vector<int> all;
#ifdef __linux__
    cpu_set_t allowed;
    if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        for (int core = 0; core < CPU_SETSIZE; ++core)
            if (CPU_ISSET(static_cast<std::size_t>(core), &allowed)) all.push_back(core);
    std::rotate(all.begin(), std::ranges::find(all, ::sched_getcpu()), all.end());
#endif
    if (all.empty()) all.push_back(-1);
    return all;
}

void prepare_for_subjects([[maybe_unused]] int core) {
    std::signal(SIGPIPE, SIG_IGN);
    hide_from_other_processes();
#ifdef __linux__
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    if (core >= 0) {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<std::size_t>(core), &one);
        ::sched_setaffinity(0, sizeof one, &one);
    }
#endif
}

StudentProcess::StudentProcess(const std::filesystem::path &program, const std::string &answer, Protection protection) {
    const Sandbox sandbox{allowed_paths(program), protection};
    auto requests = make_pipe(), replies = make_pipe(), trouble = make_pipe();
    std::string chosen = "COURSE_ANSWER=" + answer;
    process = ::vfork(); // no copy of our memory is made; it is the child's, too, until it has become the subject
    if (process < 0) give_up("cannot start the student's process");
    if (process == 0)
        become({program.c_str(), answer.empty() ? nullptr : chosen.data(), sandbox, protection.limits, requests[0],
                replies[1], output.descriptor(), trouble[1]});
    for (UniqueFd *end : {&requests[0], &replies[1], &trouble[1]}) end->close(); // of the subject
    to = std::move(requests[1]);
    ::fcntl(to, F_SETFL, O_NONBLOCK); // a subject that does not read shall not stop us
    from = std::move(replies[0]);
    Trouble reported{};
    ssize_t got = 0; // the end, when the program has started
    while ((got = ::read(trouble[0], &reported, sizeof reported)) < 0 && errno == EINTR) {}
    if (got <= 0 || reported.is_programs) return; // the latter ends before it begins
    errno = reported.error;
    give_up(reported.what);
}

StudentProcess::~StudentProcess() { left_processes(); }

bool StudentProcess::send(std::uint32_t number, std::uint32_t exercise, std::string_view arguments,
                          const Deadline &deadline) {
    const std::string message = wire::call_frame(number, exercise, arguments);
    for (std::string_view rest = message; !rest.empty();) {
        const ssize_t written = ::write(to, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0 && errno == EAGAIN
            && wait([this](Clock::time_point until) { return ready_for(POLLOUT, to, until); }, deadline))
            continue;
        if (written <= 0) return false;
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// [s] Time of the processor that it has had.
double StudentProcess::computed() const {
#ifdef __linux__
    clockid_t clock{};
    timespec had{};
    if (process > 0 && ::clock_getcpuclockid(process, &clock) == 0 && ::clock_gettime(clock, &had) == 0)
        return static_cast<double>(had.tv_sec) + 1e-9 * static_cast<double>(had.tv_nsec);
    return computed_in_all;
#else // nobody tells: all of the clock's
    return std::chrono::duration<double>(Clock::now() - started).count();
#endif
}

/// [s] Time in which it has wanted the processor, and had it or not; nothing if the kernel doesn't tell.
std::optional<double> StudentProcess::wanted() const {
    double had = 0, waited = 0; // [ns], see sched-stats in the kernel's documentation
    if (process <= 0 || !(std::ifstream{"/proc/" + std::to_string(process) + "/schedstat"} >> had >> waited)) return {};
    return 1e-9 * (had + waited);
}

double StudentProcess::spent() const { return computed() + asleep / 2; }

/// Waits for something, and looks at the process now and then meanwhile.
/// @param ready  waits for it until some time, and says whether it has come
/// @return false if the process is not to be waited for any longer; `silence` says why
template <class Ready> bool StudentProcess::wait(Ready ready, const Deadline &deadline) {
    constexpr double between = 0.05; // [s] so it is not seen at all while it answers as quickly as it should
    const auto began = Clock::now();
    auto first_look = began;
    std::optional<double> wanted_before; // then: most calls are answered before that, and cost nothing
    for (int looks = 0, sleeping = 0; !ready(next_look);) {
        if (looks == 0) wanted_before = wanted(), first_look = Clock::now();
        const bool sleeps = is_asleep(process);
        next_look = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{between});
        if (ready(Clock::time_point{})) return true; // it was only about to answer
        ++looks;
        if (sleeps) ++sleeping, asleep += between;
        const bool timed_out = Clock::now() - began > std::chrono::duration<double>{deadline.clock};
        if (spent() >= deadline.spent || timed_out) {
            const double looked = std::chrono::duration<double>(Clock::now() - first_look).count();
            const auto wanted_now = wanted(); // when we look can be guessed, and what the kernel counts can't be hidden
            const bool wanted_it =
                wanted_now && wanted_before ? 2 * (*wanted_now - *wanted_before) > looked : 2 * sleeping < looks;
            silence = timed_out && wanted_it && spent() < deadline.spent ? Silence::starved : Silence::late;
            return false;
        }
    }
    return true;
}

bool StudentProcess::read_all(void *data, std::size_t size, const Deadline &deadline) {
    char *into = static_cast<char *>(data);
    while (!arrived.take(into, size)) {
        if (!wait([this](Clock::time_point until) { return ready_for(POLLIN, from, until); }, deadline)) return false;
        const ssize_t got = ::read(from, arrived.room.data(), arrived.room.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) {
            silence = Silence::ended;
            return false;
        }
        arrived.came(static_cast<std::size_t>(got));
    }
    return true;
}

std::optional<StudentProcess::Received> StudentProcess::receive(const Deadline &deadline) {
    Received received;
    if (!read_all(&received.header, sizeof received.header, deadline)) return {};
    if (received.header.size > wire::largest_frame) {
        silence = received.header.frame == wire::Frame::result ? Silence::too_large : Silence::nonsense;
        return {};
    }
    received.payload.resize(received.header.size);
    if (!read_all(received.payload.data(), received.payload.size(), deadline)) return {};
    return received;
}

std::optional<int> StudentProcess::finish(const Deadline &deadline) {
    to.close(); // the server reads the end, and leaves
    std::optional<int> status;
    bool gone = false; // the other end of the pipe is closed: a moment later the process is, too
    const auto has_ended = [&](Clock::time_point until) {
        while (!(status = ended(process))) {
            if (Clock::now() >= until) return false;
            if (pollfd end{from, 0, 0}; !gone) gone = ::poll(&end, 1, 1) > 0;
            else ::usleep(50);
        }
        return true;
    };
    if (process < 0 || !wait(has_ended, deadline)) return {};
    return status;
}

bool StudentProcess::said_more() {
    char byte = 0;
    return !arrived.empty() || (ready_for(POLLIN, from, Clock::now()) && ::read(from, &byte, 1) > 0);
}

bool StudentProcess::left_processes() {
    if (process < 0) return false;
    const auto give_up_at = Clock::now() + std::chrono::seconds{2};
    const auto may_wait = [&] { return Clock::now() < give_up_at && ::usleep(100) == 0; };
    computed_in_all = computed();
    ::kill(process, SIGKILL);
    while (!ended(process) && may_wait()) {} // then its children are ours
    bool any = false;
    for (std::vector<pid_t> left = running_but(process); !left.empty(); left = running_but(process)) {
        any = true;
        for (const pid_t child : left) ::kill(child, SIGKILL); // even one that has left the group
        ::kill(-process, SIGKILL);
        if (!may_wait()) break;
    }
    ::waitpid(process, nullptr, WNOHANG);
#ifndef __linux__ // where nobody lists our children
    any = ::kill(-process, SIGKILL) == 0;
#endif
    process = -1;
    return any;
}

std::string StudentProcess::printed() const { return output.text(print_limit); }

} // namespace course
