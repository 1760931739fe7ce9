#include "verdict/tests/subject.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <stdexcept>
#include <sys/resource.h>
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
    throw std::runtime_error{std::string{what} + ": " + std::strerror(errno)};
}

std::array<int, 2> make_pipe() {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) give_up("cannot make a pipe");
    for (int &end : ends) { // above the numbers that the subject's own are moved to; and nothing else may inherit them
        const int high = ::fcntl(end, F_DUPFD_CLOEXEC, 10);
        if (high < 0) give_up("cannot make a pipe");
        ::close(end);
        end = high;
    }
    return ends;
}

/// A file without a name, which goes when nobody holds it.
int make_output() {
#ifdef __linux__
    const int file = ::memfd_create("printed", MFD_CLOEXEC);
#else
    std::FILE *temporary = std::tmpfile();
    const int file = temporary == nullptr ? -1 : ::fcntl(::fileno(temporary), F_DUPFD_CLOEXEC, 10);
    if (temporary != nullptr) std::fclose(temporary);
#endif
    if (file < 0) give_up("cannot keep what is printed");
    return file;
}

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
    const rlimit both{most, most};
    ::setrlimit(what, &both);
}

constexpr bool sanitized =
#ifdef __SANITIZE_ADDRESS__
    true; // reserves terabytes of addresses
#else
    false;
#endif

/// Between fork and exec: only what is safe there.
[[noreturn]] void become(const char *program, char *answer, int requests, int replies, int output) {
    ::setsid(); // a group of its own, so that one signal reaches all of it
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, 0);
    ::dup2(output, 1);
    ::dup2(output, 2);
    ::dup2(requests, wire::request_fd);
    ::dup2(replies, wire::reply_fd);
    for (int other = 5; other < 10; ++other) ::close(other);
    ::signal(SIGPIPE, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, 120); // [s] for whatever escapes everything else
    limit(RLIMIT_FSIZE, print_limit);
    limit(RLIMIT_STACK, 8u << 20);
    if (!sanitized) limit(RLIMIT_AS, memory_limit);
    char *arguments[] = {const_cast<char *>("subject"), nullptr};
    char *environment[] = {const_cast<char *>("LC_ALL=C.UTF-8"), answer, nullptr};
    ::execve(program, arguments, environment);
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

/// Processes whose parent we are by now.
std::string children() {
#ifdef __linux__
    std::ifstream list{"/proc/self/task/" + std::to_string(::getpid()) + "/children"};
    std::string text;
    std::getline(list, text);
    return text;
#else
    return {};
#endif
}

void reap() {
    while (::waitpid(-1, nullptr, WNOHANG) > 0) {}
}

} // namespace

std::vector<int> cores() {
    std::vector<int> all;
#ifdef __linux__
    cpu_set_t allowed;
    if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        for (int core = 0; core < CPU_SETSIZE; ++core)
            if (CPU_ISSET(static_cast<std::size_t>(core), &allowed)) all.push_back(core);
    std::rotate(all.begin(), std::find(all.begin(), all.end(), ::sched_getcpu()), all.end());
#endif
    if (all.empty()) all.push_back(-1);
    return all;
}

void prepare_for_subjects([[maybe_unused]] int core) {
    std::signal(SIGPIPE, SIG_IGN);
#ifdef __linux__
    if (!sanitized) ::prctl(PR_SET_DUMPABLE, 0); // the leak checker looks into us
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    if (core >= 0) {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<std::size_t>(core), &one);
        ::sched_setaffinity(0, sizeof one, &one);
    }
#endif
}

Subject::Subject(const std::filesystem::path &program, const std::string &answer) {
    const auto requests = make_pipe(), replies = make_pipe();
    output = make_output();
    std::string chosen = "COURSE_ANSWER=" + answer;
    process = ::fork();
    if (process < 0) give_up("cannot start the student's process");
    if (process == 0)
        become(program.c_str(), answer.empty() ? nullptr : chosen.data(), requests[0], replies[1], output);
    group = process;
    ::close(requests[0]);
    ::close(replies[1]);
    to = requests[1];
    ::fcntl(to, F_SETFL, O_NONBLOCK); // whoever does not read shall not stop us
    from = replies[0];
}

Subject::~Subject() {
    if (group > 0) ::kill(-group, SIGKILL);
    if (process > 0) ::kill(process, SIGKILL); // not yet a group of its own
    if (process > 0) ::waitpid(process, nullptr, 0);
    for (const int file : {to, from, output})
        if (file >= 0) ::close(file);
    reap();
}

bool Subject::send(std::uint32_t call, const std::string &payload, Clock::time_point deadline) {
    const wire::Header header{wire::Frame::call, call, static_cast<std::uint32_t>(payload.size())};
    std::string message(sizeof header, '\0');
    std::memcpy(message.data(), &header, sizeof header);
    message += payload;
    for (std::string_view rest = message; !rest.empty();) {
        const ssize_t written = ::write(to, rest.data(), rest.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0 && errno == EAGAIN && ready_for(POLLOUT, to, deadline)) continue;
        if (written <= 0) return false;
        rest.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

bool Subject::read_all(void *data, std::size_t size, Clock::time_point deadline) {
    char *into = static_cast<char *>(data);
    while (size > 0) {
        if (!ready_for(POLLIN, from, deadline)) {
            silence = Silence::late;
            return false;
        }
        const ssize_t got = ::read(from, into, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) {
            silence = Silence::ended;
            return false;
        }
        into += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

std::optional<Subject::Received> Subject::receive(Clock::time_point deadline) {
    Received received;
    if (!read_all(&received.header, sizeof received.header, deadline)) return {};
    if (received.header.size > wire::largest_frame) {
        silence = Silence::nonsense;
        return {};
    }
    received.payload.resize(received.header.size);
    if (!read_all(received.payload.data(), received.payload.size(), deadline)) return {};
    return received;
}

std::optional<int> Subject::finish(Clock::time_point deadline) {
    if (to >= 0) ::close(std::exchange(to, -1)); // the server reads the end, and leaves
    bool gone = false;                           // its end of the pipe is closed: a moment later the process is, too
    for (int status = 0; process > 0;) {
        if (::waitpid(process, &status, WNOHANG) == process) {
            process = -1;
            return status;
        }
        if (Clock::now() >= deadline) return {};
        if (pollfd wait{from, 0, 0}; !gone) gone = ::poll(&wait, 1, 1) > 0;
        else ::usleep(50);
    }
    return {};
}

bool Subject::said_more() {
    char byte = 0;
    return ready_for(POLLIN, from, Clock::now()) && ::read(from, &byte, 1) > 0;
}

bool Subject::left_processes() {
    reap();
    const bool any = ::kill(-group, 0) == 0 || !children().empty();
    if (!any) return false;
    ::kill(-group, SIGKILL);
    for (std::string list = children(); !list.empty();) {
        char *end = nullptr;
        const long child = std::strtol(list.c_str(), &end, 10);
        if (child <= 0) break;
        ::kill(static_cast<pid_t>(child), SIGKILL); // even one that made itself a group of its own
        list.erase(0, static_cast<std::size_t>(end - list.c_str()));
    }
    return true;
}

std::string Subject::printed() const {
    std::string text(print_limit, '\0'); // pages that are not read into are never made
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t got = ::pread(output, text.data() + size, text.size() - size, static_cast<off_t>(size));
        if (got <= 0) break;
        size += static_cast<std::size_t>(got);
    }
    text.resize(size);
    return text;
}

} // namespace course
